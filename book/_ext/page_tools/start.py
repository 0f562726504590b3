"""The first pages: the six questions of a reader, each answered in a sentence that is made of records."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from granular import Evaluation, Hypothesis, Scene, evaluate
from granular.contacts.comparison import FROM_SCENE, KINEMATIC, ComparedPacking
from granular.figures.cost_selection import promised_for, time_of
from granular.figures.from_contacts import from_contacts
from granular.figures.page import Static
from granular.figures.stiffness import stiffness_figure
from granular.number_of_contacts import DEFAULT_RELATION
from page_tools.contents import records
from page_tools.cost import measured
from page_tools.cost_words import decade, short
from page_tools.dem import RELAXED, bulk_modulus, packings
from page_tools.ledger_record import ENTRIES, Verdict
from page_tools.markup import Markup, boxed, table
from page_tools.paper import PANELS
from page_tools.provenance import DATA_FILES
from page_tools.tutorial_lab import factor

SOIL = Path("_data/soil.toml")
SCENE = FROM_SCENE[Hypothesis.KINEMATIC]
DEAREST = "sliding"
"""Name of the measured scene whose accuracy is dearest to readers: contacts that slide."""


def soil() -> Evaluation:
    """The soil of the first five minutes."""
    return evaluate(Scene.from_toml(SOIL))


def soil_drawn() -> Static:
    """Draw its stiffness by direction, as ``granular plot`` does."""
    return Static(stiffness_figure(soil().stiffness))


def overrated(*components: str) -> tuple[float, float]:
    """Least and largest ratio of eq. (1) to the relaxed stiffness over all packings [-]."""
    ratios = [packing.bound[name] for packing in packings() for name in components]
    known = [ratio for ratio in ratios if ratio is not None]
    return min(known), max(known)


def bulk_overrated() -> tuple[float, float]:
    """The same of the bulk modulus [-]."""
    ratios = [bulk_modulus(packing, KINEMATIC) / bulk_modulus(packing, RELAXED) for packing in packings()]
    return min(ratios), max(ratios)


def guessed(*ways: Callable[[ComparedPacking, str], float]) -> tuple[float, float]:
    """Least and largest ratio of the model to the relaxed stiffness, where the void ratio alone says how many contacts.

    Stiffness goes with the number of contacts to the power 2/3: more of them, each under a smaller force.
    """
    ratios = [way(packing, SCENE) / way(packing, RELAXED) * (DEFAULT_RELATION.coordination_number(packing.void_ratio)
                                                             / packing.coordination_number) ** (2 / 3)
              for packing in packings() if packing.collinear for way in ways]
    return min(ratios), max(ratios)


def bulk_guessed() -> tuple[float, float]:
    """The same of the bulk modulus, for the packings of spheres [-]."""
    return guessed(bulk_modulus)


def shear_guessed() -> tuple[float, float]:
    """The same of the two shear moduli [-]."""
    return guessed(*(lambda packing, way, name=name: packing.stiffness[way][name] or 0.0
                     for name in ("C2323", "C1212")))


def trusted() -> Markup:
    """What to trust in a result, with the evidence for it."""
    found, bulk, shear = soil(), bulk_overrated(), overrated("C2323", "C1212")
    less, more = bulk_guessed(), shear_guessed()
    return boxed("Two kinds of error", Markup(
        f"- **Of the computation**: at most {found.relative_error:.1g} of each component here. Nothing you do with "
        f"the number will ever see it.\n- **Of the model**: large. In {len(packings())} simulated packings whose "
        f"contacts are known it overrates the bulk modulus {bulk[0]:.2f} to {bulk[1]:.2f} times and the shear moduli "
        f"{shear[0]:.1f} to {shear[1]:.1f} times, more the fewer contacts a grain has ([](dem.md)). From the void "
        f"ratio alone, as here, it counts too many contacts: for the spheres among them {less[0]:.1f} to {less[1]:.1f} "
        f"times in bulk and {more[0]:.1f} to {more[1]:.1f} times in shear.\n- So give the number of contacts where "
        "you know it, and trust the bulk modulus then. Trust ratios of components for comparing fabrics of round "
        "grains under an equal stress; [the laboratory](from_the_lab.md) and [clumps](dem.md) show where they fail. "
        "Do not trust the level that follows from a void ratio, nor any shear modulus of a loose soil: **they are "
        "upper values.** Measure one wave speed and scale by it.\n"))


def picture() -> Static:
    """Draw the way from contacts to stiffness for the soil of the first five minutes."""
    return Static(from_contacts(Scene.from_toml(SOIL), soil()))


def answer() -> Markup:
    """The answer of the book in a box, with the soil of the first five minutes."""
    six, bulk, shear = soil().stiffness, bulk_overrated(), overrated("C2323", "C1212")
    less, more, scene = bulk_guessed(), shear_guessed(), Scene.from_toml(SOIL)
    sigma11, sigma33 = scene.stress.principal
    return boxed("The answer", Markup(
        "Which way contacts point, how far apart the centres of touching grains are in each direction, and what "
        "the stress puts on each contact: these three fix the stiffness. This book turns them into closed forms, "
        "and into numbers whose errors are stated.\n\nFor the sand of the picture, with a void ratio of "
        f"{scene.packing.void_ratio:g} under {scene.stress.mean_stress / 1e3:.0f} kPa at a stress ratio of "
        f"{float(sigma33 / sigma11):g}, $C_{{3333}} = {six.C3333 / 1e6:.1f}$ and $C_{{2323}} = {six.C2323 / 1e6:.1f}$ "
        "MPa. **They are upper values**: all contacts are taken to follow the mean strain. In simulated packings whose "
        f"contacts are known that gives {bulk[0]:.2f} to {bulk[1]:.2f} times the true bulk modulus and {shear[0]:.1f} "
        f"to {shear[1]:.1f} times the true shear moduli; where the void ratio alone says how many contacts there are, "
        f"as for this sand, {less[0]:.1f} to {less[1]:.1f} and {more[0]:.1f} to {more[1]:.1f} times.\n"))


def questions() -> Markup:
    """The six questions of a reader with a sentence each."""
    rows = [["What is this for?", _purpose()], ["What is the stiffness of my soil?", _my_soil()],
            ["How sure is that?", _how_sure()], ["Where was the paper wrong?", _errata()],
            ["What does accuracy cost?", _price()], ["How do I rebuild it?", _rebuild()]]
    return table(["question", "in short"], [[f"**{question}**", text] for question, text in rows],
                 label="tab-questions", caption="Six questions, and where the whole answer is.", look="questions")


def _purpose() -> str:
    steps = sum(len(entry["steps"]) for entry in records().values())
    return ("To know how stiff a sand, a powder or a bed of beads is at small strain, and in which direction, from its "
            f"contacts. {len(records())} derivations of {steps} steps, each checked by machine, lead there: "
            "[equal contacts](kinematic.md), [contacts with their forces](kinetic.md).")


def _my_soil() -> str:
    return ("Write down what you know of it, and run one command: [five minutes](first_use.md). You have [a sieve "
            "curve and wave speeds](from_the_lab.md), or [contacts from a simulation](from_simulations.md).")


def _how_sure() -> str:
    shear = overrated("C2323", "C1212")
    return (f"As a number of the model, to {short(soil().relative_error)} of each component ([checks](checks.md)). As "
            f"a property of soil: shear comes out {shear[0]:.1f} to {shear[1]:.1f} times too stiff [where contacts are "
            f"known](dem.md), and {factor('C2323'):.1f} times beside [an empirical rule for sands](from_the_lab.md), "
            "where their number is guessed from the void ratio.")


def _errata() -> str:
    given = [verdict for entry in ENTRIES for verdict, _ in entry.rulings]
    return (f"Of {len(ENTRIES)} places of the paper {given.count(Verdict.MISPRINT)} are misprints and "
            f"{given.count(Verdict.REFUTED)} claim what its equations do not bear out; {given.count(Verdict.RULE)} "
            f"tables carry the error of a rule with {PANELS} panels. The model stands: [errata](errata.md), "
            "[ledger](ledger.md).")


def _price() -> str:
    """The cheapest routes that state three and twelve digits where contacts slide; with count and machine."""
    data = measured()
    scene = data.of_name(DEAREST)[0]
    parts = []
    for wanted in (1e-3, 1e-12):
        cost = promised_for(scene, wanted)
        assert cost is not None, "a route states this accuracy"
        time = 1e3 * data.unit_seconds * time_of(cost)
        parts.append(f"{decade(wanted)} takes {time:.1f} ms and {cost.evaluations} directions")
    return (f"Where contacts slide, the hardest case of the paper, a stated {' and '.join(parts)} (median of "
            f"{data.rounds} rounds, {data.machine['processor']}). Contacts that are all alike have a closed form, with "
            "every digit at once: [cost](cost.md), [speed](speed.md).")


def _rebuild() -> str:
    return (f"`make book`, with Python and make and nothing else. Versions are pinned, {len(DATA_FILES)} data "
            "files have their digests, and two clean builds are the same bytes: [how](rerun.md).")
