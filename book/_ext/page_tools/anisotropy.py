"""Maps of anisotropy on a page: assemblies that are marked, what their stiffness says, and how far a line holds."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING

from granular import axial_stiffness
from granular.fabric_tensors import fabric_of
from granular.figures import anisotropy_maps
from granular.figures import isotropic_lines as lines
from granular.figures.anisotropy_interactive import anisotropy_interactive
from granular.figures.anisotropy_maps import FRICTION, POISSON_RATIO, Place
from granular.figures.page import Interactive, Static
from granular.figures.ternary import Fabric3, anisotropy_of, fabric_triangle
from granular.measures import measure
from page_tools.dem import packings
from page_tools.fabric_tensors import drawn_directions
from page_tools.markup import Described, Markup, boxed, table

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

PAPER = (("1", 0.0, -0.3), ("2", 0.3, 0.0), ("3", 0.3, -0.3))
"""Cases of Table II: number, D33, Dr33 [-]."""

TABLE_IV = (0.3, 0.5)
"""D33 of Table IV [-]."""

SAND = (0.35, -0.1)
"""D33 and Dr33 from which the sand of the fit page was made up [-]."""

ON_THE_LINE = (-0.6, -0.3, -0.1, 0.1, 0.3, 0.6)
"""D33 of assemblies with D33 + 2 Dr33 = 0 [-]."""

WEAK = 0.3
"""Fabrics that are called weak in the box, by |D33| [-]."""

UNDER, OTHER_RATIOS, OTHER_ANGLES = 1.5, (0.1, 0.35), (10.0, 35.0)
"""Stress ratio, Poisson's ratios [-] and angles of friction [degrees] of what other grains would change."""

RATIOS = (0.5, 0.65, 0.8, 0.9, 1.0, 1.1, 1.25, 1.5, 2.0)
"""Ratios of the table of conversions [-]."""

HEADS = ("$D_{33}$", "$D^r_{33}$", "$C_{1111}/C_{3333}$", "$C_{2323}/C_{1212}$", "with forces", "with forces")
TAKEN = ("D33", "Dr33", "C1111/C3333", "C2323/C1212", "C1111/C3333 with forces", "C2323/C1212 with forces")
"""Columns of both tables, on the page and in the file."""


@lru_cache(maxsize=1)
def places() -> tuple[Place, ...]:
    """Assemblies that are marked on the maps."""
    return (*(Place("Table II", D33, Dr33) for _, D33, Dr33 in PAPER),
            *(Place("DEM packings", packing.D33, packing.Dr33, "^") for packing in packings()),
            Place("deposited sand", *SAND, "s"))


def constant_maps() -> Static:
    """Six measures for contacts of one stiffness."""
    return Static(anisotropy_maps.constant_maps(places()))


def stress_maps() -> Static:
    """Both ratios under three stress ratios."""
    return Static(anisotropy_maps.stress_maps(places()))


def isotropic_lines() -> Static:
    """Where both ratios are one."""
    return Static(lines.isotropic_lines())


def map_to_read() -> Described:
    """The map with values under the pointer."""
    figure = Interactive(anisotropy_interactive(places()), "anisotropy")
    return Described(figure, "Map of anisotropy over D33 and Dr33. Buttons choose the measure, "
                     "the slider chooses the stress ratio, the pointer reads all five measures.")


def triangle() -> Static:
    """The triangle of fabrics with the paper's assemblies, the packings, the sand and a list without an axis."""
    axial = [("Tables II and IV", D33, "o") for D33 in TABLE_IV]
    axial += [("DEM packings", packing.D33, "^") for packing in packings()]
    axial += [("deposited sand", SAND[0], "s")]
    return Static(fabric_triangle([*(Fabric3(text, (-D33 / 2, -D33 / 2, D33), marker) for text, D33, marker in axial),
                                   Fabric3("drawn list", _drawn_list(), "D")]))


def headline() -> Markup:
    """How nearly isotropic the assemblies on the line are."""
    import numpy as np

    D33 = np.linspace(-WEAK, WEAK, 61)
    off = {kinetic: _percent(max(_off(measure(_stiffness(D33, -D33 / 2, kinetic=kinetic), name))
                                 for name in ("C1111/C3333", "C2323/C1212"))) for kinetic in (False, True)}
    return boxed("What the stiffness sees", Markup(
        "The weight of a direction is $(1+D_{33}P_2)(1+D^r_{33}P_2)^2 = 1 + (D_{33} + 2D^r_{33})P_2 + \\dots$ To first "
        "order the stiffness of equal contacts depends on the fabric through $D_{33} + 2D^r_{33}$ alone. Where this "
        f"sum vanishes and $|D_{{33}}| \\le {WEAK:g}$, both ratios of the paper are within {off[False]} % of one for "
        f"contacts of one stiffness, and within {off[True]} % with contact forces and slip under isotropic stress.\n"))


def along_the_line() -> Markup:
    """Both ratios along D33 + 2 Dr33 = 0, with equal contacts and under isotropic stress with forces."""
    import numpy as np

    D33 = np.array(ON_THE_LINE)
    columns = [measure(_stiffness(D33, -D33 / 2, kinetic=kinetic), name)
               for kinetic in (False, True) for name in ("C1111/C3333", "C2323/C1212")]
    rows = [[_signed(one), _signed(-one / 2), *(f"{column[place]:.4f}" for column in columns)]
            for place, one in enumerate(ON_THE_LINE)]
    return table([*HEADS], rows, align="rrrrrr", label="tab-anisotropy-line", take_away="anisotropy_line.csv", taken=[
        TAKEN, *rows], caption="Assemblies on the dotted line: contacts of one stiffness, and the same ratios with "
                 "forces and slip under isotropic stress, 12°.")


def conversions() -> Markup:
    """What a ratio says in the words of wave speeds and of Thomsen's parameters."""
    import numpy as np

    press = np.array([[one, 1, 0, 0, 0.5, 0.5] for one in RATIOS])
    shear = np.array([[3, 3, 0, 0, one, 1] for one in RATIOS])
    rows = [[f"{one:g}", _signed(epsilon), f"{_signed(100 * faster, '.1f')} %", _signed(gamma), f"{speed:.3f}"]
            for one, epsilon, faster, gamma, speed in zip(
                RATIOS, measure(press, "epsilon"), measure(press, "P anisotropy"), measure(shear, "gamma"),
                np.sqrt(RATIOS), strict=True)]
    return table(["ratio", "as $C_{1111}/C_{3333}$: $\\epsilon$", "$V_{Ph}/V_{Pv} - 1$",
                  "as $C_{2323}/C_{1212}$: $\\gamma$", "$V_{hv}/V_{hh}$"], rows, label="tab-anisotropy-words",
                 align="rrrrr", take_away="anisotropy_words.csv",
                 caption="One ratio in other words. Each row holds for any transversely isotropic solid.")


def marked() -> Markup:
    """Measures of the marked assemblies."""
    import numpy as np

    named = [(f"Table II, case {number}", D33, Dr33) for number, D33, Dr33 in PAPER]
    named += [(f"`{packing.name}`", packing.D33, packing.Dr33) for packing in packings()]
    named += [("deposited sand", *SAND)]
    D33, Dr33 = (np.array([one[part] for one in named], dtype=float) for part in (1, 2))
    kinds = [_stiffness(D33, Dr33, kinetic=kinetic) for kinetic in (False, True)]
    rows = [[name, _signed(d + 0.0, ".2f"), _signed(round(dr, 2) + 0.0, ".2f"), *(
        f"{measure(kind[place], measured):.3f}" for kind in kinds for measured in ("C1111/C3333", "C2323/C1212"))]
            for place, (name, d, dr) in enumerate(named)]
    return table(["assembly", *HEADS], rows, align="lrrrrrr", label="tab-anisotropy-marked", taken=[
        ["assembly", *TAKEN], *rows], take_away="anisotropy_marked.csv", caption="The marked assemblies: contacts of "
                 "one stiffness, and the same ratios with forces and slip under isotropic stress, 12°.")


def strongest() -> Markup:
    """Anisotropy at the ends of the triangle and of the list without an axis."""
    import numpy as np

    corner, side = anisotropy_of(np.array([[-1.0, -1, 2], [0.5, 0.5, -1]]))
    found = float(anisotropy_of(np.array(_drawn_list())))
    return Markup(f"The ratio is {corner:.2f} at a corner and {side:.2f} in the middle of a side. The list that was "
                  f"drawn from a fabric without an axis of symmetry has {found:.2f}.\n")


def limits() -> Markup:
    """What other grains and the other hypothesis would change in both ratios of the marked assemblies."""
    import numpy as np

    D33, Dr33 = (np.array([getattr(place, name) for place in places()]) for name in ("D33", "Dr33"))
    plain_contacts = _stiffness(D33, Dr33, kinetic=False)
    static = axial_stiffness(D33, Dr33, poisson_ratio=POISSON_RATIO, kinetic=False, hypothesis="static")
    at_rest = axial_stiffness(D33, Dr33, UNDER, FRICTION, POISSON_RATIO)
    other_grains = axial_stiffness(D33, Dr33, UNDER, FRICTION, np.array(OTHER_RATIOS)[:, None])
    rough = axial_stiffness(D33, Dr33, UNDER, np.tan(np.radians(OTHER_ANGLES))[:, None], POISSON_RATIO)
    return Markup(
        f"- The maps are those of one kind of grains. Under $\\sigma_{{33}}/\\sigma_{{11}} = {UNDER:g}$, Poisson's "
        f"ratios from {OTHER_RATIOS[0]:g} to {OTHER_RATIOS[1]:g} move both ratios of the marked assemblies by at most "
        f"{_moved(other_grains, at_rest)} %, angles of friction from {OTHER_ANGLES[0]:g}° to {OTHER_ANGLES[1]:g}° "
        f"by at most {_moved(rough, at_rest)} %.\n"
        f"- They show the kinematic hypothesis. The static one moves the same ratios by at most "
        f"{_moved(static, plain_contacts)} % for equal contacts ([](static.md)).\n")


def _moved(there: Array, here: Array) -> str:
    """Largest change of the two ratios of the paper, in per cent."""
    return _percent(max(_off(measure(there, name) / measure(here, name)) for name in ("C1111/C3333", "C2323/C1212")))


def _drawn_list() -> tuple[float, float, float]:
    """Diagonal of D_ij of the third drawn list: its principal axes are nearly the axes."""
    found = fabric_of(drawn_directions(2)).D2
    return float(found[0, 0]), float(found[1, 1]), float(found[2, 2])


def _stiffness(D33: Array, Dr33: Array, *, kinetic: bool) -> Array:
    if not kinetic:
        return axial_stiffness(D33, Dr33, poisson_ratio=POISSON_RATIO, kinetic=False)
    return axial_stiffness(D33, Dr33, 1.0, FRICTION, POISSON_RATIO)


def _off(values: Array) -> float:
    return float(abs(values - 1).max())


def _percent(value: float) -> str:
    """Rounded upwards, for a bound."""
    return f"{value * 100 + 0.05:.1f}"


def _signed(value: float, form: str = ".3g") -> str:
    return f"{value:{form}}".replace("-", "−")
