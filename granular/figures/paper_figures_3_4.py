"""Table I, Figures 3 and 4 of the paper: six lognormal gradations and the densities that follow from them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

from granular.figures.look import BLUE, GREEN, ORANGE, PURPLE, SKY, SOFT_INK, VERMILION, blank, house_style, readable

if TYPE_CHECKING:
    import numpy as np
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from granular.gradation import Lognormal

    Array = NDArray[np.float64]

PRINTED = ((10.0, 1.5, 1.9), (2.0, 1.5, 1.9), (1.0, 1.5, 1.9), (5.0, 2.0, 2.9), (5.0, 1.5, 1.9), (5.0, 1.2, 1.3))
"""Table I: r_50 [mm], s_r [-] and the C_u [-] beside it, of curves 1 to 6."""

COLOURS = (BLUE, PURPLE, GREEN, VERMILION, SKY, ORANGE)
GROUPS = ((0, 1, 2), (3, 4, 5))
"""Curves of one spread, and curves of one mean size."""

NUMBERS_AT = (0.30, 0.50, 0.50, 0.60, 0.80, 0.70)
"""Fraction finer at which each curve of Figure 3 carries its number, where no other curve is near [-]."""


@dataclass(frozen=True, slots=True)
class Assembly:
    """One column of Table I with what follows from it. All sizes D are diameters.

    Attributes
    ----------
    curve : int
        Number in Figures 3 and 4.
    r_50 : float
        Radius r_50 of eq. (18) [m].
    spread : float
        s_r [-].
    printed_uniformity : float
        C_u as printed [-].
    uniformity, curvature : float
        C_u = D60/D10 and C_c = D30^2/(D10 D60) [-].
    D10, D50, D60 : float
        Diameters than which 10, 50 and 60 % of the volume are finer [m].
    """

    curve: int
    r_50: float
    spread: float
    printed_uniformity: float
    uniformity: float
    curvature: float
    D10: float
    D50: float
    D60: float

    @property
    def sizes(self) -> Lognormal:
        """Grain sizes by eq. (18)."""
        from granular.gradation import Lognormal

        return Lognormal(2.0 * self.r_50, self.spread)


def table_i() -> tuple[Assembly, ...]:
    """Evaluate the six assemblies of Table I.

    Returns
    -------
    tuple of Assembly
        Curves 1 to 6.

    Notes
    -----
    Accuracy: 1e-15. Source: Table I with eqs (13) and (18); r_50 is a radius in millimetres.

    Examples
    --------
    >>> [(row.curve, round(row.uniformity, 2), row.printed_uniformity) for row in table_i()[2:]]
    [(3, 1.86, 1.9), (4, 2.9, 2.9), (5, 1.86, 1.9), (6, 1.32, 1.3)]
    """
    from granular.gradation import Lognormal

    rows = []
    for curve, (millimetres, spread, printed) in enumerate(PRINTED, start=1):
        sizes = Lognormal(2e-3 * millimetres, spread)
        rows.append(Assembly(
            curve=curve, r_50=1e-3 * millimetres, spread=spread, printed_uniformity=printed,
            uniformity=sizes.uniformity, curvature=sizes.curvature, D10=sizes.D10, D50=sizes.D50, D60=sizes.D60))
    return tuple(rows)


@house_style
def figure_3() -> Figure:
    """Draw the six gradation curves.

    Returns
    -------
    matplotlib.figure.Figure
        Per cent finer by volume against the grain diameter, with the number of each curve on it.

    Notes
    -----
    Source: Figure 3, eqs (13) and (18).
    """
    import numpy as np

    figure = blank(height=3.3)
    axes = figure.add_subplot()
    diameter = np.geomspace(0.5, 200.0, 401)
    for row, colour, place in zip(table_i(), COLOURS, NUMBERS_AT, strict=True):
        axes.plot(diameter, 100.0 * row.sizes.fraction_finer(1e-3 * diameter), color=colour)
        axes.text(1e3 * row.sizes.size_at(place), 100.0 * place, str(row.curve), color=readable(colour), ha="center",
                  va="center", fontweight="bold", bbox={"facecolor": "white", "edgecolor": "none", "pad": 1.2})
    _sizes_along(axes, (0.5, 200.0))
    axes.set(ylim=(0, 100), yticks=range(0, 101, 10), xlabel="grain diameter [mm]", ylabel="finer by volume, $F$ [%]")
    axes.grid(which="minor", axis="x", alpha=0.6)
    return figure


@house_style
def figure_4() -> Figure:
    """Draw the densities of radii, of all branches, and of branches along a direction.

    Returns
    -------
    matplotlib.figure.Figure
        Three rows, one a density; curves of one spread on the left, of one mean size on the right. Densities are those
        over the logarithm of size, so that a curve keeps its area on the logarithmic axis.

    Notes
    -----
    Source: Figure 4, eqs (12), (16), (17).
    """
    import numpy as np

    from granular.gradation import branch_lengths

    rows = table_i()
    radius = np.geomspace(0.1, 500.0, 241)
    lengths = [branch_lengths(row.sizes) for row in rows]
    panels: tuple[tuple[str, str, list[Callable[[Array], Array]]], ...] = (
        ("$r f^p$", "grain radius $r$ [mm]", [partial(_by_number, row.sizes) for row in rows]),
        ("$\\ell\\, g^{\\mathrm{total}}$", "branch length $\\ell$ [mm]", [one.total_density for one in lengths]),
        ("$\\ell\\, g$", "branch length $\\ell$ [mm]", [one.density for one in lengths]))
    figure = blank(height=5.6)
    for line, (name, along, densities) in enumerate(panels):
        curves = [1e-3 * radius * density(1e-3 * radius) for density in densities]
        top = 1.08 * max(float(curve.max()) for curve in curves)
        for side, group in enumerate(GROUPS):
            axes = figure.add_subplot(3, 2, 2 * line + side + 1)
            for place in group:
                curve = curves[place]
                axes.plot(radius, curve, color=COLOURS[place])
                # on top of curves side by side; on the left flank of nested ones, where the others are lower
                at = int(np.argmax(curve) if side == 0 else np.argmax(curve > 0.7 * curve.max()))
                axes.annotate(str(place + 1), (radius[at], float(curve[at])), xytext=((0, 3), (-3, 0))[side],
                              textcoords="offset points", ha=("center", "right")[side],
                              va=("bottom", "center")[side], color=readable(COLOURS[place]), fontweight="bold")
            _sizes_along(axes, (0.1, 500.0))
            axes.set(ylim=(0, top), xlabel=along, ylabel=f"{name} [–]" if side == 0 else "")
            axes.tick_params(axis="y", labelleft=side == 0)
            if line == 0:
                axes.set_title(("$s_r = 1.5$", "$r_{50} = 5$ mm")[side], color=SOFT_INK)
    return figure


def _by_number(sizes: Lognormal, radius: Array) -> Array:
    """Density of radii, which is twice that of diameters."""
    density: Array = 2.0 * sizes.density_by_number(2.0 * radius)
    return density


def _sizes_along(axes: Axes, reach: tuple[float, float]) -> None:
    """A logarithmic axis of sizes with plain numbers."""
    from matplotlib.ticker import FuncFormatter, NullFormatter

    axes.set_xscale("log")
    axes.set_xlim(reach)
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axes.xaxis.set_minor_formatter(NullFormatter())
