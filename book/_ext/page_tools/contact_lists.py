"""From a contact list to its stiffness, on a page: the report on the packing that ships, and what is refused."""

from __future__ import annotations

import gzip
import tempfile
from collections.abc import Callable
from contextlib import chdir
from functools import lru_cache
from pathlib import Path

from granular.contacts import (
    ContactList,
    ContactSummary,
    Material,
    estimated_forces,
    fitted_fabric,
    predictions,
    summarise,
)
from granular.contacts.as_text import SHOWN
from granular.contacts.columns import GROUPS
from granular.contacts.example import NAME, example_facts, example_folder, example_path
from granular.contacts.prediction import EQUAL_CONTACTS, ESTIMATED_FORCES
from granular.contacts.tables import ROWS
from granular.errors import GranularError
from granular.figures.contact_list import contact_list_figure
from granular.figures.page import Static
from granular.hypothesis import Hypothesis
from page_tools.commands import answer, wrapped
from page_tools.markup import Markup, plain, table
from page_tools.refusals import command_line

MEANINGS = {
    "spheres": "numbers of the two bodies, to find pairs that stand twice",
    "grains": "numbers of the two clumps, where bodies are parts of clumps",
    "branch": "branch vector, from the centre of grain 1 to that of grain 2 [m]",
    "centres": "both centres, in place of the branch vector [m]",
    "normal": "contact normal, a unit vector that points from grain 1 to grain 2",
    "radii": "radii at the contact [m]; else a quarter of the branch length stands for $R_e$",
    "normal_force": "normal force, compression positive [N]",
    "shear_force": "shear force on grain 2 by grain 1 [N]",
    "force": "whole force on grain 2 by grain 1, in place of the two above [N]",
    "kn": "normal stiffness [N/m]", "ks": "shear stiffness [N/m]",
    "overlap": "how far the grains overlap [m]; only checked, must not be negative",
}

LAMMPS = {"id1": "c_ids[2]", "id2": "c_ids[1]", "l1": "c_pair[1]", "l2": "c_pair[2]", "l3": "c_pair[3]",
          "fn": "c_pair[4]", "fs1": "c_pair[5]", "fs2": "c_pair[6]", "fs3": "c_pair[7]"}
"""Native name -> column of the dump that the page has LAMMPS write: differences and forces are those of atom i, which
is therefore grain 2."""

LIGGGHTS = {**dict(zip(("x2", "y2", "z2", "x1", "y1", "z1", "id2", "id1"), (f"c_fc[{k}]" for k in range(1, 9)),
                       strict=True)), "f1": "c_fc[10]", "f2": "c_fc[11]", "f3": "c_fc[12]"}
"""The same for pos, id and force of LIGGGHTS; its ninth column says whether the contact crosses a periodic boundary."""

_HEAD, _ROW = "id1,id2,l1,l2,l3,n1,n2,n3,fn", "1,2,0.002,0,0,1,0,0,0.3"


@lru_cache(maxsize=1)
def packing() -> ContactSummary:
    """What the list of the packing that ships tells, read as the page's command reads it."""
    known = example_facts()
    return summarise(example_path(), volume=known["V"], grains=known["N_grains"], material=Material(
        shear_modulus=known["Gs"], poisson_ratio=known["nu"], friction=known["mu"]))


def report() -> Markup:
    """The command on the packing that ships, and its answer."""
    known = example_facts()
    with chdir(example_folder()):
        shown = answer("contacts", example_path().name, "--volume", f"{known['V']:.9g}", "--grains",
                       str(known["N_grains"]), "--shear-modulus", f"{known['Gs'] / 1e9:g}e9", "--poisson-ratio",
                       f"{known['nu']:g}", "--friction", f"{known['mu']:g}").text
    opening, line, *lines = shown.splitlines()
    return Markup("\n".join([opening, wrapped(line), *lines]) + "\n")


def columns_table() -> Markup:
    """Every column that a list may have."""
    needed = {"branch": "yes", "centres": "or these", "normal": "yes"}
    rows = [[" ".join(f"`{name}`" for name in names), plain_but_maths(MEANINGS[group]), needed.get(group, "–")]
            for group, names in GROUPS.items()]
    return table(["columns", "what they hold", "needed"], rows, label="tab-contact-columns", align="lll",
                 caption="Columns of a contact list. Those of a row belong together.")


def counted() -> Markup:
    """Number of contacts and coordination in words."""
    found = packing()
    assert found.rattlers is not None, "the example numbers its grains"
    return Markup(f"The packing has {found.contacts} contacts between {found.grains} grains. Each contact has two "
                  f"sides, so that $2M/N = {found.coordination_number:.3f}$. Of the grains {found.rattlers} have no "
                  "contact or one and carry nothing; without them the coordination number is "
                  f"{found.coordination_without_rattlers:.3f}.\n")


def fabric_words() -> Markup:
    """Fabric with its scatter in words."""
    found, fitted = packing(), fitted_fabric(packing())
    error = found.doubt_of("normals")
    return Markup(f"Here $D_{{33}} = {fitted.D33:.3f} \\pm {error:.3f}$, which is {fitted.D33 / error:.1f} standard "
                  f"errors from isotropy, and $D^r_{{33}} = {_signed(fitted.Dr33, 5)}$: spheres of one size have "
                  "branches of one length.\n")


def force_table() -> Markup:
    """Contact forces by angle beside eq. (23)."""
    wide = packing().by_angle.merged(2)
    mean, scatter, up = (wide.mean("normal_force"), wide.scatter("normal_force"), wide.mean("meridian_force"))
    estimate = estimated_forces(packing(), wide)
    assert mean is not None, "the example has normal forces"
    assert scatter is not None, "and their scatter"
    assert up is not None, "the example has shear forces"
    assert estimate is not None, "and a stress"
    rows = [[f"{wide.degrees[k]:.0f}–{wide.degrees[k + 1]:.0f}°", f"{wide.contacts[k]:.0f}", f"{mean[k]:.3f}",
             f"{scatter[k]:.3f}", f"{estimate[0][k]:.3f}", f"{mean[k] / estimate[0][k]:.2f}", f"{up[k]:.3f}",
             f"{estimate[1][k]:.3f}"] for k in range(wide.contacts.size)]
    return table(["angle", "$M$", "$f_n$ [N]", "scatter", "eq. (23)", "ratio", "$f_s$ up [N]", "eq. (23)"], rows,
                 label="tab-contact-forces", align="lrrrrrrr", take_away="contact_forces.csv",
                 caption="Mean contact forces of the packing by the angle of the normal from axis 3, and the estimate "
                         "that knows the stress and the fabric only.")


def force_words() -> Markup:
    """How far the estimate of forces goes."""
    found, wide = packing(), packing().by_angle.merged(2)
    mean, scatter, up = (wide.mean("normal_force"), wide.scatter("normal_force"), wide.mean("meridian_force"))
    estimate = estimated_forces(found, wide)
    assert mean is not None, "the example has normal forces"
    assert scatter is not None, "and their scatter"
    assert up is not None, "the example has shear forces"
    assert estimate is not None, "and a stress"
    spread = scatter / mean
    shear = float(wide.contacts @ up) / float(wide.contacts @ estimate[1])
    first, last = mean[0] / estimate[0][0] - 1, mean[-1] / estimate[0][-1] - 1
    assert found.sliding is not None, "the friction is given"
    return Markup(f"Near axis 3 the mean normal force is {_apart(first)} the estimate, near the horizontal "
                  f"{_apart(last)} it: the packing leans more on its vertical contacts than eq. (23) has it. Shear "
                  f"does less of the work than estimated, {100 * shear:.0f} % of what eq. (23) asks for along the "
                  f"meridian, and {100 * found.sliding:.0f} % of the contacts are at the limit of friction. Within a "
                  f"class single forces scatter by {100 * spread.min():.0f} to {100 * spread.max():.0f} % of their "
                  "mean, which no estimate by direction can know.\n")


def stress_words() -> Markup:
    """The stress from the forces beside the one that the simulation reports."""
    stress, reported = packing().stress, example_facts()["stress_love"]
    assert stress is not None, "the example has forces"
    largest = max(abs(stress[i, j] - reported[i][j]) for i in range(3) for j in range(3))
    ratio = 2 * stress[2, 2] / (stress[0, 0] + stress[1, 1])
    return Markup(f"Here $p = {stress.trace() / 3e3:.2f}$ kPa and $\\sigma_{{33}}/\\sigma_{{11}} = {ratio:.3f}$, "
                  f"within {largest:.1g} Pa of what the simulation itself reports.\n")


def stiffness_table() -> Markup:
    """Both sums and what the model makes of them."""
    found = packing()
    columns = []
    for hypothesis, name, whole in ((Hypothesis.KINEMATIC, "eq. (1)", found.kinematic),
                                    (Hypothesis.STATIC, "eq. (5)", found.static)):
        assert whole is not None, "the example has stiffnesses"
        columns.append((name, whole, "0"))
        columns += [(_SHORT[one.source], one.stiffness, f"{100 * one.distance:.1f} %") for one in predictions(found)
                    if one.hypothesis is hypothesis and one.stiffness is not None and one.distance is not None]
    rows = [[f"$C_{{{name[1:]}}}$", *(f"{stiffness.component(name) / 1e6:.1f}" for _, stiffness, _ in columns)]
            for name in SHOWN]
    rows.append(["distance", *(away for _, _, away in columns)])
    return table(["MPa", *(name for name, _, _ in columns)], rows, label="tab-contact-stiffness",
                 align="l" + "r" * len(columns), take_away="contact_stiffness.csv",
                 caption="The packing's stiffness under the kinematic hypothesis (three columns) and under the static "
                         "one (three more): the sum over its contacts, the model with their mean stiffness, and the "
                         "model with forces estimated from the stress. Below, how far each is from its sum.")


_SHORT = {EQUAL_CONTACTS: "mean $k_n$", ESTIMATED_FORCES: "forces"}


def soft_words() -> Markup:
    """Why the static sum is lower although the static model is not."""
    found, alike = packing(), _all_alike()
    drops = []
    for one in (found, alike):
        assert one.kinematic is not None, "the example has both sums"
        assert one.static is not None, "the example has both sums"
        drops.append(100 * (1 - one.static.component("C2323") / one.kinematic.component("C2323")))
    return Markup(f"In $C_{{2323}}$ the static sum is {drops[0]:.0f} % below the kinematic one, while the two "
                  "predictions of the model hardly differ. What separates the sums is the scatter of the contact "
                  f"stiffness: give every contact of the list the mean $k_n$ and $k_s$, and they are {drops[1]:.1f} % "
                  "apart. Springs side by side add their stiffnesses, springs in a row their compliances, in which the "
                  "soft ones count most. A model whose contacts of one direction are all alike cannot know that.\n")


def _all_alike() -> ContactSummary:
    """The same packing with the mean stiffness in every contact."""
    import numpy as np

    block = next(ContactList(example_path()).blocks())
    assert block.size == packing().contacts, "the example is one block"
    assert block.kn is not None, "the example has stiffnesses"
    assert block.ks is not None, "the example has stiffnesses"
    means = np.array([[block.kn.mean()], [block.ks.mean()]]) * np.ones(block.size)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "alike.csv"
        np.savetxt(path, np.concatenate([block.branch, block.normal, means]).T, delimiter=",", comments="",
                   header="l1,l2,l3,n1,n2,n3,kn,ks")
        return summarise(path, volume=packing().volume)


def list_figure() -> Static:
    """The figure that ``--plot`` writes."""
    return Static(contact_list_figure(packing()))


def _faults() -> dict[str, Callable[[], object]]:
    """What a list may have wrong, and a list that has it."""
    def text(*rows: str, name: str = "list.csv", grains: int | None = None) -> Callable[[], object]:
        return _of_file(name, "\n".join(rows).encode() + b"\n", grains)

    whole = gzip.compress("\n".join([_HEAD, _ROW]).encode(), mtime=0)
    return {
        "no volume": command_line("contacts", "list.csv"),
        "a column is missing": text(_HEAD.replace("n1,n2,n3", "nx1,ny1,nz1"), _ROW),
        "a value is missing": text(_HEAD, _ROW, "1,3,,0.002,0,0,1,0,0.3"),
        "a branch without length": text(_HEAD, "1,2,0,0,0,1,0,0,0.3"),
        "a normal that is no unit vector": text(_HEAD, "1,2,0.002,0,0,0.9,0,0,0.3"),
        "a branch against its normal": text(_HEAD, "1,2,0.002,0,0,-1,0,0,0.3"),
        "a tensile force": text(_HEAD, "1,2,0.002,0,0,1,0,0,-0.3"),
        "a branch that lacks its period": text(_HEAD + ",R1,R2", "1,2,0.018,0,0,1,0,0,0.3,0.001,0.001"),
        "a volume that cannot hold the grains": text(_HEAD + ",R1,R2", "1,2,2,0,0,1,0,0,0.3,1,1", grains=2),
        "a negative overlap": text(_HEAD + ",overlap", _ROW + ",-1e-6"),
        "a contact listed from both sides": text(_HEAD, _ROW, "2,1,-0.002,0,0,-1,0,0,0.3"),
        "a row that is cut off": text(_HEAD, _ROW, "1,3,0,0.002"),
        "a compressed file that is cut off": _of_file("list.csv.gz", whole[:-6]),
        "a file that is not what its name says": text(_HEAD, _ROW, name="list.parquet"),
    }


def refusals_table() -> Markup:
    """Provoke every refusal of a contact list and quote it."""
    rows = []
    for fault, attempt in _faults().items():
        try:
            attempt()
        except GranularError as refusal:
            rows.append([fault, f"{{ref}}`{refusal.code} <error-{refusal.code.lower()}>`", _as_found(refusal)])
        else:
            raise AssertionError(f"{fault} was not refused")
    return table(["fault", "code", "what the message says is found"], rows, label="tab-contact-refusals", align="lll",
                 look="words-first", caption="Contact lists that are refused. Each message goes on with what is "
                                             "allowed and what to do.")


def block_words() -> Markup:
    """How much is in memory at a time."""
    return Markup(f"Of any file {ROWS:,} contacts are in memory at a time.\n".replace(",", "\u2009", 1))


def _as_found(refusal: GranularError) -> str:
    """What a message says is found, without the name of the made-up file; two hyphens stay two hyphens."""
    found = refusal.found.removeprefix('"list.csv"').removeprefix(": ").removeprefix(", ").strip()
    return plain(found).replace("--", "\\-\\-")


def mapped(columns: dict[str, str], file: str) -> Markup:
    """A command with the names of a dump's columns."""
    line = " ".join(["$ granular contacts", file, "--volume V --spheres",
                     *(f"--column {name}={column}" for name, column in columns.items())])
    return Markup(f"```console\n{wrapped(line)}\n```\n")


def plain_but_maths(text: str) -> str:
    """Plain text in which formulas between dollars stay formulas."""
    return "$".join(part if place % 2 else plain(part) for place, part in enumerate(text.split("$")))


def _of_file(name: str, content: bytes, grains: int | None = None) -> Callable[[], object]:
    def tried() -> object:
        with tempfile.TemporaryDirectory() as folder, chdir(folder):
            Path(name).write_bytes(content)
            return summarise(name, volume=1e-6, grains=grains)
    return tried


def _signed(value: float, digits: int) -> str:
    return f"{value:+.{digits}f}".replace("-", "−")


def _apart(share: float) -> str:
    return f"{100 * abs(share):.0f} % {'above' if share > 0 else 'below'}"


assert set(MEANINGS) == set(GROUPS), "every column has its meaning"
assert NAME in example_path().name, "the example is the one that the page describes"
