"""The model against packings of known stiffness, on a page: what the record says, in tables and in words."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import chdir
from functools import lru_cache
from pathlib import Path

from granular import Hypothesis, Stiffness
from granular.contacts.comparison import (
    AGREEMENT,
    FROM_LIST,
    FROM_SCENE,
    KINEMATIC,
    STATIC,
    ComparedPacking,
    Components,
    compare_folder,
    read_comparison,
)
from granular.contacts.example import NAME, example_facts, example_folder
from granular.engineering import engineering_constants
from granular.figures.packings import packings_figure
from granular.figures.page import Static
from granular.routes.result import COMPONENTS
from page_tools.commands import answer
from page_tools.contact_lists import packing as packing_that_ships
from page_tools.formats import at_most, ends, number, signed
from page_tools.markup import Markup, boxed, table

RECORD = Path("_data/dem.json")
RELAXED, AFFINE, SPINS, SLIDING = "relaxed", "affine", "rotations only", "relaxed, friction active"
DIAGONAL = ("C1111", "C3333", "C2323", "C1212")
"""Components that a bound of the energy bounds one by one."""

LIST, SCENE = FROM_LIST[Hypothesis.KINEMATIC], FROM_SCENE[Hypothesis.KINEMATIC]
EVEN = 0.01
"""How far sigma33/sigma11 may be from 1 for stresses that are called equal [-]."""

SAME = 1e-9
"""How far the packing that ships may be from its record [-]: sums in another order, and no more."""


@lru_cache(maxsize=1)
def packings() -> tuple[ComparedPacking, ...]:
    """The recorded comparison."""
    return tuple(read_comparison(RECORD))


def headline() -> Markup:
    """The result of the page in a box."""
    press, shear = ends(_bounds("C1111", "C3333")), ends(_bounds("C2323", "C1212"))
    bulk = ends([bulk_modulus(packing, KINEMATIC) / bulk_modulus(packing, RELAXED) for packing in packings()])
    back, miss = _shares(DIAGONAL, spheres=True), max(packing.affine_miss for packing in packings())
    return boxed("Against packings of known stiffness", Markup(
        f"- Eq. (1) summed over the contacts is the stiffness of a packing whose grains follow the mean strain: within "
        f"{at_most(100 * miss, 2)} % of $C_{{3333}}$ in each of 36 components.\n"
        f"- Real grains do not follow it. Eq. (1) is {press} times the relaxed stiffness in compression and {shear} "
        f"times in shear. The bulk modulus alone is close: {bulk} times.\n"
        f"- The static sum, eq. (5), takes back {ends(back, 100, '.0f')} % of that distance for spheres. It takes it "
        "from the scatter of the contact stiffness ([](contact_lists.md)), which the continuum model does not have: "
        f"the static prediction of the model takes back {ends(_model_shares(), 100, '.1f')} %.\n"
        "- The model that knows fabric, branch length, void ratio, coordination and stress only is "
        f"{ends(_alone_over_sum(), 1, '.2f')} times eq. (1) for spheres.\n"))


def packings_table() -> Markup:
    """What the packings are."""
    rows = [[packing.name, _kind(packing), str(packing.contacts), f"{packing.void_ratio:.3f}",
             f"{packing.coordination_number:.2f}", f"{packing.mean_stress / 1e3:.0f}", f"{packing.stress_ratio:.2f}",
             f"{signed(packing.D33)} ± {packing.D33_error:.3f}"] for packing in packings()]
    return table(["packing", "grains", "$M$", "$e$", "$2M/N$", "$p$ [kPa]", "$\\sigma_{33}/\\sigma_{11}$", "$D_{33}$"],
                 rows, label="tab-dem-packings", align="llrrrrrr", take_away="dem_packings.csv",
                 caption="The packings. The error of $D_{33}$ is that of so many independent contacts.")


def affine_table() -> Markup:
    """Eq. (1) against the affine probe."""
    rows = [[packing.name, _mpa(packing, KINEMATIC, "C3333", ".2f"), _mpa(packing, AFFINE, "C3333", ".2f"),
             _mpa(packing, KINEMATIC, "C2323", ".2f"), _mpa(packing, AFFINE, "C2323", ".2f"),
             f"{100 * packing.affine_miss:.3f} %", f"{100 * _stress_over_stiffness(packing):.3f} %"]
            for packing in packings()]
    worst = max(packing.affine_miss for packing in packings())
    heads = ["$C_{3333}$, (1)", "probe", "$C_{2323}$, (1)", "probe", "difference", "$p/C_{3333}$"]
    return table(["packing", *heads], rows, label="tab-dem-affine", align="lrrrrrr", take_away="dem_affine.csv",
                 caption=f"Eq. (1) and the affine probe agree within {at_most(100 * worst, 3)} % of $C_{{3333}}$; "
                         f"{100 * AGREEMENT:g} % is allowed [MPa]. The difference is the largest of 36 components.")


def stiffness_table() -> Markup:
    """Compression and shear in every way; all six components in the file."""
    ways = {SCENE: "model", LIST: "mean $k_n$", KINEMATIC: "(1)", AFFINE: "affine", STATIC: "(5)", SPINS: "spins",
            RELAXED: "relaxed"}
    rows = [[packing.name, f"$C_{{{component[1:]}}}$", *(_mpa(packing, way, component) for way in ways)]
            for packing in packings() for component in ("C3333", "C2323")]
    taken = [["packing", "way", *(f"{name} [MPa]" for name in COMPONENTS)]]
    taken += [[packing.name, way, *(number(six[name], ".3f", 1e-6).replace("–", "") for name in COMPONENTS)]
              for packing in packings() for way, six in packing.stiffness.items()]
    return table(["packing", "MPa", *ways.values()], rows, label="tab-dem-stiffness", align="ll" + "r" * len(ways),
                 take_away="dem_stiffness.csv", taken=taken,
                 caption="Stiffness in compression and in shear along axis 3: the model alone, the model with the mean "
                         "contact stiffness of the list, eq. (1), the affine probe, eq. (5), spins relaxed, and all "
                         "relaxed. Every estimate lies above the relaxed stiffness, and the model that has nothing but "
                         "fabric and stress lies highest. The file has all components, the static predictions and the "
                         "probe with active friction.")


def bound_table() -> Markup:
    """How far eq. (1) lies above the relaxed stiffness."""
    rows = [[packing.name, f"{packing.coordination_number:.2f}", *(number(packing.bound[name]) for name in DIAGONAL)]
            for packing in packings()]
    worst = max(packings(), key=lambda packing: packing.bound["C1212"] or 0.0)
    if worst.coordination_number != min(packing.coordination_number for packing in packings()):
        raise AssertionError("the caption says that the bound is worst where contacts are fewest")
    return table(["packing", "$2M/N$", *_heads()], rows, label="tab-dem-bound", align="lrrrrr",
                 take_away="dem_bound.csv",
                 caption="Eq. (1) over the relaxed stiffness. The bound is worst where contacts are fewest: "
                         f"{number(worst.bound['C1212'])} times too stiff in shear in {worst.name}.")


def recovered_table() -> Markup:
    """What eq. (5) takes back."""
    rows = [[packing.name, f"{packing.coordination_number:.2f}",
             *(number(packing.recovered[name], ".0f", 100, " %") for name in DIAGONAL)] for packing in packings()]
    return table(["packing", "$2M/N$", *_heads()], rows, label="tab-dem-recovered", align="lrrrrr",
                 take_away="dem_recovered.csv",
                 caption="Share of the distance from eq. (1) to the relaxed stiffness that eq. (5) takes back: less "
                         "than half of it in shear between spheres.")


def off_diagonal() -> Markup:
    """What a bound of the energy does not bound."""
    low = ends(_bounds("C1122", "C1133"))
    return Markup("A bound holds for the energy of every strain, so it holds for the diagonal components and for the "
                  f"bulk modulus, not for $C_{{1122}}$ and $C_{{1133}}$: there eq. (1) gives only {low} times the "
                  "relaxed value. A packing that relaxes gets softer in shear and keeps its resistance to a change of "
                  "volume, so that its Poisson's ratio rises.\n")


def bulk_table() -> Markup:
    """Bulk modulus by eq. (1) and relaxed."""
    rows = [[packing.name, *(f"{bulk_modulus(packing, way) / 1e6:.1f}" for way in (KINEMATIC, STATIC, RELAXED)),
             f"{bulk_modulus(packing, KINEMATIC) / bulk_modulus(packing, RELAXED):.3f}",
             *(f"{engineering_constants(_of(packing, way)).nu31:.3f}" for way in (KINEMATIC, RELAXED))]
            for packing in packings()]
    return table(["packing", "$K$, eq. (1)", "eq. (5)", "relaxed", "(1)/relaxed", "$\\nu_{31}$, eq. (1)", "relaxed"],
                 rows, label="tab-dem-bulk", align="lrrrrrr", take_away="dem_bulk.csv",
                 caption="Bulk modulus [MPa], which the two sums bracket in every packing, and Poisson's ratio under "
                         "compression along axis 3, which they miss.")


def recovered_words() -> Markup:
    """What eq. (5) takes back, and that it is no bound."""
    spheres, clumps = _shares(DIAGONAL, spheres=True), _shares(DIAGONAL, spheres=False)
    below = [f"$C_{{{name[1:]}}}$ of {packing.name}" for packing in packings() for name in DIAGONAL
             if (packing.recovered[name] or 0.0) > 1]
    said = f" It is no lower bound: it falls below the relaxed stiffness in {', '.join(below)}." if below else ""
    return Markup(f"For packings of spheres eq. (5) takes back {ends(spheres, 100, '.0f')} % of the distance, least "
                  "where contacts are few and the distance is largest, and it stays above the relaxed stiffness. For "
                  f"clumps it takes back {ends(clumps, 100, '.0f')} %.{said}\n")


def model_static_words() -> Markup:
    """That the continuum model under the static hypothesis recovers next to nothing."""
    return Markup(f"The continuum model under the static hypothesis, with the mean stiffness of the list, lies only "
                  f"{ends(_model_drops(), 100, '.1f')} % below the same model under the kinematic one, for spheres. "
                  "Its contacts of one direction are all alike; nothing is left to bring the two hypotheses apart but "
                  "the ratio of shear to normal stiffness.\n")


def spins_table() -> Markup:
    """How much of the drop comes from spins alone."""
    rows = [[packing.name, *(number(_spin_share(packing, name), ".0f", 100, " %") for name in DIAGONAL)]
            for packing in packings()]
    shares = [share for packing in packings() for name in DIAGONAL if (share := _spin_share(packing, name)) is not None]
    return table(["packing", *_heads()], rows, label="tab-dem-spins", align="lrrrr",
                 take_away="dem_spins.csv",
                 caption="Share of the way from the affine to the relaxed stiffness that is gone once grains may spin "
                         f"while their centres still follow the strain: {ends(shares, 100, '.0f')} %.")


def model_table() -> Markup:
    """The continuum beside the sum."""
    rows = []
    for packing in packings():
        for way, name in ((LIST, "mean $k_n$"), (SCENE, "alone")):
            for fabric in _fabrics(packing, way):
                six = packing.stiffness[way + fabric]
                rows.append([packing.name, name + fabric, *(number(_over(six, packing.stiffness[KINEMATIC], component))
                                                            for component in DIAGONAL)])
    return table(["packing", "model", *_heads()], rows, label="tab-dem-model",
                 align="llrrrr", take_away="dem_model.csv",
                 caption="Stiffness of the continuum model over eq. (1). “Alone” takes nothing from the list but "
                         "$D_{33}$, $D^r_{33}$ and the branch length; void ratio, coordination number and stress are "
                         "those of the packing.")


def model_words() -> Markup:
    """Why the model alone lies above its sum."""
    even, uneven = (_listed_over_sum(equal_stresses=equal) for equal in (True, False))
    return Markup(f"With the mean contact stiffness of the list the model is {ends(even)} times eq. (1) for spheres "
                  f"under equal stresses, and {ends(uneven)} times under unequal ones, where contacts near axis 3 are "
                  f"stiffer than the mean. Left alone it is {ends(_alone_over_sum())} times eq. (1), since it gives "
                  "every contact of a direction the mean force there. Stiffness grows with the cube root of the force, "
                  "and the mean of cube roots is less than the cube root of the mean.\n")


def size_words() -> Markup:
    """What gradation would add, of which these packings have none."""
    away = max(abs(packing.stiffer_where_longer - 1) for packing in packings() if packing.collinear)
    return Markup(f"Here the ratio is {ends([packing.length_ratio for packing in packings()], 1, '.3f')}, and for the "
                  f"spheres, which are of one size, the factor is 1 within {at_most(100 * away, 3)} %.\n")


def clump_words() -> Markup:
    """What the collinear assumption does to clumps."""
    for packing in packings():
        if packing.collinear:
            continue
        ways = {"eq. (1)": KINEMATIC, "relaxed": RELAXED,
                "normals": f"{LIST}, fabric of normals", "branches": f"{LIST}, fabric of branches"}
        found = {name: _ratio(packing.stiffness[way], "C1111", "C3333") for name, way in ways.items()}
        return Markup(f"Branches of clumps do not follow the normals: $D_{{33}} = {signed(packing.D33)}$ of the "
                      f"normals and {signed(packing.D33_of_branches)} of the branches. $C_{{1111}}/C_{{3333}}$ is "
                      f"{found['eq. (1)']:.3f} by eq. (1) and {found['relaxed']:.3f} relaxed. The model with the "
                      f"fabric of the normals says {found['normals']:.3f}, stiffer on the wrong axis; with the fabric "
                      f"of the branches it says {found['branches']:.3f}. [](shape.md) measures the same for "
                      "spheroids.\n")
    raise AssertionError("the record has clumps")


def anisotropy_table() -> Markup:
    """Ratios of components, which survive better."""
    ways = {KINEMATIC: "(1)", SCENE: "model", RELAXED: "relaxed"}
    rows = [[packing.name, *(number(_ratio(packing.stiffness[way], *pair)) for pair in
                             (("C1111", "C3333"), ("C2323", "C1212")) for way in ways)] for packing in packings()]
    return table(["packing", *(f"{ratio}, {name}" if first else name for ratio in
                               ("$C_{1111}/C_{3333}$", "$C_{2323}/C_{1212}$")
                               for name, first in zip(ways.values(), (True, False, False), strict=True))], rows,
                 label="tab-dem-ratios", align="lrrrrrr", take_away="dem_ratios.csv",
                 caption=f"Anisotropy. Eq. (1) is within {at_most(_ratio_miss(KINEMATIC), 1)} % of the relaxed "
                         "ratios, although each of the components is far from its own.")


def sliding_words() -> Markup:
    """What active friction takes off in addition."""
    drops = {packing.name: 1 - ratio for packing in packings()
             if (ratio := _over(packing.stiffness.get(SLIDING, {}), packing.stiffness[RELAXED], "C3333")) is not None}
    least, most = min(drops, key=drops.__getitem__), max(drops, key=drops.__getitem__)
    at_limit = packing_that_ships().sliding
    assert at_limit is not None, "its friction is known"
    return Markup("“Relaxed” is elastic: no contact slides while the packing is probed. With friction active, and the "
                  f"probe averaged over both signs, $C_{{3333}}$ falls by another {100 * drops[least]:.1f} % ({least}) "
                  f"to {100 * drops[most]:.0f} % ({most}); in {NAME} {100 * at_limit:.0f} % of the contacts are at the "
                  "limit of friction before anything is probed. That number is no elastic modulus: loading on and "
                  "reversing differ.\n")


def packings_drawn() -> Static:
    """The picture of the record."""
    return Static(packings_figure(packings()))


def source() -> Markup:
    """Which program made the packings."""
    return Markup("The packings were made, and the affine probe was run, with "
                  f"{example_facts()['code'].split(',')[0]}, a discrete-element program that shares no line with this "
                  "library. Free spins and the relaxed stiffness are those of its contacts as a network of linear "
                  "springs, solved for all displacements and spins.\n")


def live() -> Markup:
    """Compare the packing that ships while the page is built, hold it against the record, and show the answer."""
    found, recorded = compare_folder(example_folder())[0], {packing.name: packing for packing in packings()}[NAME]
    for way, six in recorded.stiffness.items():
        for name, value in six.items():
            again = found.stiffness[way][name]
            if (value is None) != (again is None) or abs((value or 0.0) - (again or 0.0)) > SAME * abs(value or 1.0):
                raise AssertionError(f"{NAME}, {way}, {name}: recorded {value}, found {again}")
    with chdir(example_folder().parent):
        return answer("contacts", f"--compare={example_folder().name}")


def _stress_over_stiffness(packing: ComparedPacking) -> float:
    six = packing.stiffness[AFFINE]["C3333"]
    assert six is not None, "the affine probe is complete"
    return packing.mean_stress / six


def _heads() -> list[str]:
    return [f"$C_{{{name[1:]}}}$" for name in DIAGONAL]


def _kind(packing: ComparedPacking) -> str:
    return "spheres" if packing.collinear else "clumps"


def _of(packing: ComparedPacking, way: str) -> Stiffness:
    """The transversely isotropic part; bulk modulus and Poisson's ratio do not ask for C1212."""
    c1111, c3333, c1122, c1133, c2323 = (packing.stiffness[way][name] or 0.0 for name in COMPONENTS[:-1])
    return Stiffness.transversely_isotropic(c1111, c3333, c1122, c1133, c2323, (c1111 - c1122) / 2)


def bulk_modulus(packing: ComparedPacking, way: str) -> float:
    """Bulk modulus of a packing, found in one way [Pa]."""
    return engineering_constants(_of(packing, way)).K


def _row(packing: ComparedPacking, way: str) -> Components:
    return packing.stiffness[way + _fabrics(packing, way)[0]]


def _fabrics(packing: ComparedPacking, way: str) -> tuple[str, ...]:
    """What is behind the name of a way where branches have a fabric of their own."""
    return ("",) if way in packing.stiffness else (", fabric of normals", ", fabric of branches")


def _over(one: Components, other: Components, name: str) -> float | None:
    above, below = one.get(name), other.get(name)
    return None if above is None or below is None else above / below


def _ratio(six: Components, above: str, below: str) -> float:
    first, second = six[above], six[below]
    assert first is not None, f"{above} was probed"
    assert second is not None, f"{below} was probed"
    return first / second


def _bounds(*names: str) -> list[float]:
    return [value for packing in packings() for name in names if (value := packing.bound[name]) is not None]


def _shares(names: Sequence[str], *, spheres: bool) -> list[float]:
    return [value for packing in packings() if packing.collinear == spheres for name in names
            if (value := packing.recovered[name]) is not None]


def _drops(of: Callable[[float, float, float], float]) -> list[float]:
    """Something of both predictions and the relaxed value, for every diagonal component of packings of spheres."""
    found = []
    for packing in packings():
        for name in DIAGONAL if packing.collinear else ():
            values = [packing.stiffness[way][name] for way in (LIST, FROM_LIST[Hypothesis.STATIC], RELAXED)]
            kinematic, static, relaxed = (value for value in values if value is not None)
            found.append(of(kinematic, static, relaxed))
    return found


def _model_drops() -> list[float]:
    return _drops(lambda kinematic, static, _: 1 - static / kinematic)


def _model_shares() -> list[float]:
    return _drops(lambda kinematic, static, relaxed: (kinematic - static) / (kinematic - relaxed))


def _listed_over_sum(*, equal_stresses: bool) -> list[float]:
    return [value for packing in packings() if packing.collinear for name in DIAGONAL
            if (abs(packing.stress_ratio - 1) < EVEN) == equal_stresses
            and (value := _over(_row(packing, LIST), packing.stiffness[KINEMATIC], name)) is not None]


def _alone_over_sum() -> list[float]:
    return [value for packing in packings() if packing.collinear for name in DIAGONAL
            if (value := _over(packing.stiffness[SCENE], packing.stiffness[KINEMATIC], name)) is not None]


def _spin_share(packing: ComparedPacking, name: str) -> float | None:
    affine, spins, relaxed = (packing.stiffness.get(way, {}).get(name) for way in (AFFINE, SPINS, RELAXED))
    if affine is None or spins is None or relaxed is None:
        return None
    return (affine - spins) / (affine - relaxed)


def _ratio_miss(way: str) -> float:
    """Largest relative error of both ratios, in percent."""
    return 100 * max(abs(_ratio(packing.stiffness[way], *pair) / _ratio(packing.stiffness[RELAXED], *pair) - 1)
                     for packing in packings() for pair in (("C1111", "C3333"), ("C2323", "C1212")))


def _mpa(packing: ComparedPacking, way: str, name: str, form: str = ".1f") -> str:
    return number(_row(packing, way)[name], form, 1e-6)
