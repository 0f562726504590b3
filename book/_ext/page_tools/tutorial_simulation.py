"""The tutorial for simulated packings: a real contact list read, checked, summed, and set beside its probe."""

from __future__ import annotations

from pathlib import Path

from granular.contacts import fitted_fabric, summarise
from granular.contacts.comparison import FROM_LIST, FROM_SCENE, KINEMATIC, ComparedPacking
from granular.contacts.example import NAME, example_facts, example_path
from granular.hypothesis import Hypothesis
from page_tools.contact_lists import packing
from page_tools.dem import AFFINE, RELAXED, packings
from page_tools.markup import Markup, table
from page_tools.tutorial_shell import folder, shell

LIST = "contacts.csv.gz"

SCENE, ALIKE = FROM_SCENE[Hypothesis.KINEMATIC], FROM_LIST[Hypothesis.KINEMATIC]
COLUMNS = {SCENE: "scene", ALIKE: "mean $k_n$", KINEMATIC: "eq. (1)", AFFINE: "affine", RELAXED: "relaxed"}
"""Ways to the stiffness in the record, and the heads of their columns."""

PERIOD = 0.0236
"""Edge of the cell along axis 3 that a branch is made to lack [m]."""


def volume() -> str:
    """Volume of the packing as it is typed [m^3]."""
    return f"{example_facts()['V']:.9g}"


def asked(*parts: str, file: str = LIST, options: str = "", status: int = 0) -> Markup:
    """Run ``granular contacts`` on a list and show parts of its answer."""
    return shell(f"granular contacts {file} --volume {volume()}{options and ' ' + options}", *parts, status=status)


def renamed() -> Markup:
    """The list with other names in its first line, and the command that knows them."""
    return shell(f"""zcat {LIST} | sed '1s/fn/normal_force/; 1s/kn,ks/stiff_n,stiff_t/' \\
    > other.csv
granular contacts other.csv --volume {volume()} --column fn=normal_force --column kn=stiff_n --column ks=stiff_t""",
                 "Contacts")


def doubled() -> Markup:
    """The stress that a volume twice as large would give."""
    return shell(f"granular contacts {LIST} --volume {2 * float(volume()):.9g}", "Stress and forces")


def with_a_gap() -> Markup:
    """The list with a value taken out."""
    return shell(f"""zcat {LIST} | sed '2s/^852,1967,[^,]*/852,1967,/' > gap.csv
granular contacts gap.csv --volume {volume()}""", status=2)


def without_a_period() -> Markup:
    """The list with a branch that lacks the period of the cell."""
    return shell(f"""zcat {LIST} | awk -F, -v OFS=, 'NR == 2 {{ $5 += {PERIOD} }} 1' > open.csv
granular contacts open.csv --volume {volume()}""", status=2)


def checks_table() -> Markup:
    """What the list says beside what the simulation says of itself."""
    found, known = packing(), example_facts()
    stress, reported = found.stress, known["stress_love"]
    assert stress is not None, "the example has forces"
    ratio = [2 * one[2][2] / (one[0][0] + one[1][1]) for one in (stress.tolist(), reported)]
    rows = [["contacts $M$", str(found.contacts), str(known["M"])],
            ["coordination $2M/N$", f"{found.coordination_number:.3f}", f"{known['Z']:.3f}"],
            ["mean stress [kPa]", f"{stress.trace() / 3e3:.2f}", f"{sum(reported[i][i] for i in range(3)) / 3e3:.2f}"],
            ["$\\sigma_{33}/\\sigma_{11}$", f"{ratio[0]:.4f}", f"{ratio[1]:.4f}"]]
    return table(["", "from the list", "by the simulation"], rows, label="tab-simulation-checks", align="lrr",
                 caption="Four numbers that both the list and the simulation know. Where they differ, the list is not "
                         "the packing.")


def fabric_words() -> Markup:
    """Say what the fabric part of the answer comes to."""
    found, fitted = packing(), fitted_fabric(packing())
    error = found.doubt_of("normals")
    return Markup(f"$D_{{33}} = {fitted.D33:.3f} \\pm {error:.3f}$: {fitted.D33 / error:.1f} standard errors from "
                  f"isotropy. The error is that of {found.contacts} independent contacts; for half of it you need four "
                  "times as many, or four packings prepared alike.\n")


def example() -> ComparedPacking:
    """The record of the packing."""
    return next(one for one in packings() if one.name == NAME)


def scene_file() -> Markup:
    """Write the scene that says of the packing what a scene can say, and show it."""
    found, known = example(), example_facts()
    text = f"""\
# What a scene can say of the packing {NAME}
[grains]
shear_modulus = {known["Gs"]:.3g}
poisson_ratio = {known["nu"]:g}

[packing]
void_ratio = {known["e"]:.6f}
coordination_number = {found.coordination_number:.6g}
contact_normals = {{ D33 = {found.D33:.4f} }}

[stress]
mean = {found.mean_stress:.6g}
ratio = {found.stress_ratio:.5f}
"""
    Path(folder().name, "packing.toml").write_text(text, encoding="utf-8")
    return Markup(f"```toml\n{text}```\n")


def beside_probe() -> Markup:
    """Six components in five ways."""
    found = example()
    rows = []
    for name in ("C1111", "C3333", "C1122", "C1133", "C2323", "C1212"):
        values = [found.stiffness[way][name] for way in COLUMNS]
        known = [value for value in values if value is not None]
        assert len(known) == len(COLUMNS), "every component was probed"
        rows.append([f"$C_{{{name[1:]}}}$", *(f"{value / 1e6:.1f}" for value in known), f"{known[2] / known[4]:.2f}"])
    return table(["MPa", *COLUMNS.values(), "(1)/relaxed"], rows, label="tab-simulation-probe", align="lrrrrrr",
                 take_away="simulation_probe.csv",
                 caption="The packing's stiffness: by the scene alone, by the fitted fabric with the mean $k_n$ of the "
                         "list, by the sum over the list, and by two probes of the packing itself, with grains that "
                         "follow the strain and with grains that find their equilibrium.")


def probe_words() -> Markup:
    """Say what the differences mean."""
    found = example()
    six = {way: found.stiffness[way] for way in COLUMNS}

    def ratio(way: str, over: str, name: str) -> float:
        above, below = six[way][name], six[over][name]
        assert above is not None, "every component was probed"
        assert below is not None, "every component was probed"
        return above / below

    return Markup(
        f"- *Scene over eq. (1)*, {ratio(SCENE, KINEMATIC, 'C3333'):.2f} in $C_{{3333}}$: what two numbers of "
        "fabric and an estimate of the forces get wrong.\n- *Mean $k_n$ over eq. (1)*, "
        f"{ratio(ALIKE, KINEMATIC, 'C3333'):.2f}: what is lost when contacts along the load are not told to be "
        f"stiffer than others.\n- *Eq. (1) over affine*, {ratio(KINEMATIC, AFFINE, 'C3333'):.4f}: nothing. The sum "
        "is the stiffness of a packing whose grains follow the mean strain. If yours differs here, the list, the "
        f"volume or a sign is wrong.\n- *Eq. (1) over relaxed*, {ratio(KINEMATIC, RELAXED, 'C3333'):.2f} in "
        f"compression and {ratio(KINEMATIC, RELAXED, 'C2323'):.2f} in shear: the price of the hypothesis, and by "
        "far the largest. It is no fault of the list and no list can tell it.\n")


def placed() -> Markup:
    """Bring the list that comes with the package into the folder, and look at its beginning."""
    return shell(f"""cp $(python -c "from granular.contacts.example import *; \\
    print(example_path())") {LIST}
zcat {LIST} | head -2""")


def as_parquet() -> Markup:
    """Write the list as Parquet."""
    return shell(f"""python -c "from pyarrow import csv, parquet; \\
    parquet.write_table(csv.read_csv('{LIST}'), 'contacts.parquet')\"""")


def of_the_grains() -> str:
    """What the simulation knows of the grains, as options."""
    known = example_facts()
    return f"--shear-modulus {known['Gs'] / 1e9:g}e9 --poisson-ratio {known['nu']:g} --friction {known['mu']:g}"


def same_numbers() -> Markup:
    """Read the list as text and as Parquet and say how far apart the sums are."""
    known = example_facts()
    found = [summarise(path, volume=known["V"]) for path in (example_path(), Path(folder().name, "contacts.parquet"))]
    sums = [one.kinematic.component("C3333") for one in found if one.kinematic is not None]
    apart = abs(sums[1] / sums[0] - 1)
    return Markup("Text and Parquet give " + (f"$C_{{3333}}$ within {apart:.1g} of itself.\n" if apart else
                                              "the same $C_{3333}$ to the last digit.\n"))
