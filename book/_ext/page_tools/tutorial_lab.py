"""The tutorial for the laboratory: measured speeds beside the model, what they say of the fabric, what to report."""

from __future__ import annotations

import math
import tomllib
from functools import lru_cache
from typing import Any

from granular import Evaluation, Hypothesis, Scene, evaluate, fit
from granular.figures.measured_stiffness import Compared, measured_stiffness
from granular.figures.page import Static
from granular.fitting import Fit
from granular.fitting.data import Data, Measurement
from granular.fitting.problem import Problem
from granular.fitting.result import combinations_at
from granular.fitting.solver import minima
from page_tools.fit import fitted
from page_tools.markup import Markup, boxed, table
from page_tools.tutorial_measured import VOID_RATIO
from page_tools.tutorial_shell import DATA

SPEEDS, RATIO = "lab_speeds.toml", "lab_ratio.toml"
SCENE = "lab_sand.toml"

KINDS = {"C3333": ("compression", "Vp_vertical"), "C2323": ("shear", "Vs_vh", "Vs_hv")}
"""Component along the axis -> what it is called, and the speeds that measure it."""

FROM_IMAGES = 0.2
"""D33 that a study of thin sections is supposed to have given [-]."""

Belief = dict[str, dict[str, Any]]

BELIEFS: dict[str, tuple[Belief, str]] = {
    "nothing more": ({}, "both are unknown"),
    "all branches are equally long": ({"fit": {"unknowns": ["D33"], "scale": "modes"}}, "only the normals are unknown"),
    f"thin sections gave $D_{{33}} = {FROM_IMAGES}$": (
        {"fit": {"unknowns": ["Dr33"], "scale": "modes"},
         "packing": {"void_ratio": VOID_RATIO, "contact_normals": {"D33": FROM_IMAGES}}},
        "only the branches are unknown"),
}
"""What else is believed -> the tables of the data file that it changes, and what is left to be found."""


@lru_cache(maxsize=4)
def tables(name: str) -> dict[str, Any]:
    """Read a file of the book's data."""
    return tomllib.loads((DATA / name).read_text(encoding="utf-8"))


def modelled(pressure: float, *, sizes: bool = False, hypothesis: str = "kinematic") -> Evaluation:
    """The sand of the scene under one equal pressure [Pa]."""
    scene = tables(SCENE) | {"stress": {"mean": pressure}, "model": {"hypothesis": hypothesis}}
    scene["gradation"] = {**scene["gradation"], "file": str(DATA / scene["gradation"]["file"])}
    if not sizes:
        del scene["gradation"]
    if hypothesis == Hypothesis.STATIC:
        scene["grains"] = {key: value for key, value in scene["grains"].items() if key != "friction_angle"}
    return evaluate(Scene.model_validate(scene))


def readings(component: str, state: int) -> tuple[float, float]:
    """Stiffness from the mean of the speeds that measure it in one state, with its standard error [Pa]."""
    found = Data.from_toml(DATA / SPEEDS)
    chosen = [one for one in found.measurements if one.state == state and one.kind.name in KINDS[component][1:]]
    weights = [one.uncertainty**-2 for one in chosen]
    speed = sum(weight * one.value for weight, one in zip(weights, chosen, strict=True)) / sum(weights)
    density = modelled(100e3).density
    assert density is not None, "the scene gives the density of the mineral"
    return density * speed**2, 2 * density * speed / math.sqrt(sum(weights))


def pressures() -> tuple[float, ...]:
    """Mean stresses of the equal states [Pa]."""
    return tuple(scene.stress.mean_stress for scene in Data.from_toml(DATA / SPEEDS).scenes)


def speeds_table() -> Markup:
    """The measured speeds of one specimen."""
    found = Data.from_toml(DATA / RATIO)
    names = list(dict.fromkeys(one.kind.name for one in found.measurements))
    by_place = {(one.state, one.kind.name): one for one in found.measurements}
    rows = [[label, *(_reading(by_place[state, name]) for name in names)] for state, label in enumerate(found.labels)]
    heads = ["$V_{P,v}$", "$V_{P,h}$", "$V_{vh}$", "$V_{hv}$", "$V_{hh}$"]
    return table(["state", *heads], rows, label="tab-lab-speeds", align="lrrrrr", take_away="lab_speeds.csv",
                 caption="Measured wave speeds [m/s] with their standard errors. The first index is the direction in "
                         "which the wave travels, the second the one in which grains move; the last row is a stress "
                         "ratio of 2.")


def _reading(one: Measurement) -> str:
    return f"{one.value:.0f} ± {one.uncertainty:.1f}"


def compared_table() -> Markup:
    """Measured stiffness beside three predictions."""
    rows = []
    for state, pressure in enumerate(pressures()):
        ways = (modelled(pressure), modelled(pressure, hypothesis="static"), modelled(pressure, sizes=True))
        for component, (what, *_) in KINDS.items():
            measured, doubt = readings(component, state)
            values = [way.stiffness.components[component] for way in ways]
            rows.append([f"{pressure / 1e3:.0f}", f"{what} ${_typeset(component)}$",
                         f"{measured / 1e6:.0f} ± {doubt / 1e6:.0f}", *(f"{value / 1e6:.0f}" for value in values),
                         f"{measured / values[0]:.2f}"])
    return table(["$p$ [kPa]", "", "measured", "kinematic", "static", "with sizes", "ratio"], rows,
                 label="tab-lab-compared", align="rlrrrrr", take_away="lab_compared.csv",
                 caption="Stiffness $\\rho V^2$ of the specimen beside the model, in MPa. The kinematic and the static "
                         "column leave the grain sizes out; the next has them by eq. (17). The ratio is measured over "
                         "kinematic.")


def compared_drawn() -> Static:
    """Draw the same against the mean stress."""
    return Static(measured_stiffness(_compared()))


def _compared() -> list[Compared]:
    kinds = []
    for component, (what, *_) in KINDS.items():
        found = [readings(component, state) for state in range(len(pressures()))]
        model = [modelled(pressure).stiffness.components[component] for pressure in pressures()]
        kinds.append(Compared(what, pressures(), tuple(value for value, _ in found), tuple(doubt for _, doubt in found),
                              tuple(model)))
    return kinds


def factor(component: str) -> float:
    """Model over sample under the middle pressure [-]."""
    return modelled(pressures()[1]).stiffness.components[component] / readings(component, 1)[0]


def too_stiff() -> Markup:
    """Say how far the model is from the sample, and how either grows with the stress."""
    growth = {one.name: _slope(one.stress, one.measured) for one in _compared()}
    model = _slope(pressures(), tuple(modelled(pressure).stiffness.C2323 for pressure in pressures()))
    graded, equal = (modelled(pressures()[1], sizes=sizes).stiffness.C2323 for sizes in (True, False))
    return Markup(
        f"**The model is too stiff: {factor('C3333'):.1f} times in compression and {factor('C2323'):.1f} times in "
        f"shear** under {pressures()[1] / 1e3:.0f} kPa. Shear is the worse one, as in every packing of [](dem.md). The "
        f"stiffness of the model grows with the power {model:.3f} of the mean stress, that of the specimen with the "
        f"power {growth['shear']:.2f} in shear and {growth['compression']:.2f} in compression. Loading a real sand "
        "also makes contacts {cite:p}`makse1999`; the model holds their number fixed. Simulating the grain sizes would "
        f"add another {100 * (graded / equal - 1):.0f} %, in the wrong direction ([](claims.md)).\n")


def _slope(x: tuple[float, ...], y: tuple[float, ...]) -> float:
    """Exponent between the first and the last point [-]."""
    return math.log(y[-1] / y[0]) / math.log(x[-1] / x[0])


def combination(found: Fit) -> str:
    """The combination that the data see best, with its standard error."""
    best = found.combinations[0]
    return (f"$D_{{33}} {_signed(best.coefficients[1])}\\,D^r_{{33}} = {_signed(best.value, plus=False)} \\pm "
            f"{best.standard_error:.3f}$")


def known_words() -> Markup:
    """Say what the speeds tell of the fabric."""
    found = fitted(f"_data/{SPEEDS}")
    low, high = found["D33"].intervals[1].low, found["D33"].intervals[1].high
    return Markup(f"Chi-square is {found.chi_square:.1f} with {found.degrees_of_freedom} degrees of freedom: the model "
                  f"describes the anisotropy within the scatter. Known is {combination(found)}. Neither number is "
                  f"known alone: 95 % of $D_{{33}}$ reach from {_signed(low or -1.0)} to {_signed(high or 2.0)}.\n")


def believed(name: str) -> Fit:
    """Fit the speeds with what else is believed."""
    changed = BELIEFS[name][0]
    return fit(tables(SPEEDS) | changed) if changed else fitted(f"_data/{SPEEDS}")


def beliefs_table() -> Markup:
    """What the same speeds say of the fabric when more is believed."""
    rows = []
    for name, (_, left) in BELIEFS.items():
        found = believed(name)
        about = {one.name: one for one in found.estimates}
        rows.append([name, left, *(_interval(about, unknown) for unknown in ("D33", "Dr33")),
                     f"{found.chi_square:.1f}"])
    return table(["what else is believed", "then", "$D_{33}$, 68 %", "$D^r_{33}$, 68 %", "chi-square"], rows,
                 label="tab-lab-beliefs", align="llrrr", take_away="lab_beliefs.csv",
                 caption="The same speeds with more and more that is taken for known. Chi-square hardly changes: the "
                         "data do not choose.")


def _interval(about: dict[str, Any], name: str) -> str:
    if name not in about:
        return "given"
    first = about[name].intervals[0]
    return f"{_signed(first.low)} to {_signed(first.high)}"


def ratio_table() -> Markup:
    """Predict the anisotropy under an unequal stress with the fabric of the equal states."""
    found = fitted(f"_data/{SPEEDS}")
    state = tables(RATIO)["measured"][-1]
    data = Data.of_tables(tables(RATIO) | {"measured": [state]})
    speed = {one.kind.name: one.value for one in data.measurements}
    predicted = evaluate(Scene.model_validate({
        "grains": tables(SPEEDS)["grains"], "stress": state["stress"],
        "packing": {"void_ratio": VOID_RATIO, "contact_normals": {"D33": found["D33"].value}},
        "branches": {"anisotropy": {"D33": found["Dr33"].value}}})).stiffness.components
    vertical = (speed["Vs_vh"] + speed["Vs_hv"]) / 2
    rows = [["$C_{1111}/C_{3333}$", (speed["Vp_horizontal"] / speed["Vp_vertical"]) ** 2,
             predicted["C1111"] / predicted["C3333"]],
            ["$C_{1212}/C_{2323}$", (speed["Vs_hh"] / vertical) ** 2, predicted["C1212"] / predicted["C2323"]]]
    return table(["ratio", "measured", "predicted"], [[name, f"{one:.2f}", f"{two:.2f}"] for name, one, two in rows],
                 label="tab-lab-ratio", align="lrr", take_away="lab_ratio.csv",
                 caption="Horizontal over vertical stiffness under the stress ratio of 2, measured, and predicted with "
                         "the fabric that was fitted to the equal stresses.")


def ratio_words() -> Markup:
    """Say what a fit makes of the unequal state; the minimum alone, for profiles around it would mean nothing."""
    problem = Problem.of(Data.from_toml(DATA / RATIO))
    least = minima(problem)[0]
    _, worst = combinations_at(problem, least.unknowns)
    free = len(Data.from_toml(DATA / RATIO).measurements) - least.unknowns.size
    narrower = fitted(f"_data/{SPEEDS}").combinations[1].standard_error / worst.standard_error
    return Markup(f"Fitted together, all four states give a chi-square of {least.chi_square:.0f} with {free} "
                  f"degrees of freedom. The standard errors become small all the same, that of the worse combination "
                  f"{narrower:.0f} times smaller than before, and mean nothing: **look at chi-square before you "
                  "look at the estimates.**\n")


def report() -> Markup:
    """What to write down, with the numbers of the page."""
    found, middle = fitted(f"_data/{SPEEDS}"), pressures()[1]
    density = modelled(middle).density
    assert density is not None, "the scene gives the density of the mineral"
    press, shear = (readings(component, 1) for component in KINDS)
    across = next(one for one in Data.from_toml(DATA / SPEEDS).measurements
                  if one.state == 1 and one.kind.name == "Vs_hh")
    level = density * across.value**2
    return boxed("What to report", Markup(
        f"- **Measured** (on an invented specimen) at $e = {VOID_RATIO}$ under {middle / 1e3:.0f} kPa: $C_{{3333}} = "
        f"{press[0] / 1e6:.0f} \\pm "
        f"{press[1] / 1e6:.0f}$, $C_{{2323}} = {shear[0] / 1e6:.0f} \\pm {shear[1] / 1e6:.0f}$, $C_{{1212}} = "
        f"{level / 1e6:.0f} \\pm {2 * level * across.uncertainty / across.value / 1e6:.0f}$ MPa.\n"
        f"- **Fabric** by the model of Pan and Dong (1999), kinematic hypothesis, sizes left out, one factor of "
        f"compression and one of shear in each state: {combination(found)}, chi-square {found.chi_square:.1f} with "
        f"{found.degrees_of_freedom} degrees of freedom. $D_{{33}}$ and $D^r_{{33}}$ are not known apart.\n"
        f"- **Level**: the model overrates compression {factor('C3333'):.1f} times and shear {factor('C2323'):.1f} "
        "times. Do not report its moduli as those of the sand.\n"
        "- **With it**: both files, and the version on [](rerun.md).\n"))


def _typeset(component: str) -> str:
    return f"C_{{{component[1:]}}}"


def _signed(value: float, *, plus: bool = True) -> str:
    return (f"{value:+.2f}" if plus else f"{value:.3f}").replace("-", "−")
