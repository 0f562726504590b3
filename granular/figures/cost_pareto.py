"""Error against time for one scene: routes of this package as lines, others paler, the front and the printed rule."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

from granular.cost.records import OUTSIDE, PRODUCT
from granular.figures.cost_data import series
from granular.figures.cost_selection import error_of, front, time_of
from granular.figures.look import (
    BLUE,
    GREEN,
    INK,
    ORANGE,
    PURPLE,
    SKY,
    VERMILION,
    blank,
    house_style,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from granular.cost.records import Cost
    from granular.figures.cost_data import MeasuredScene

LOOKS = {"closed_form": ("D", BLUE), "axial": ("o", VERMILION), "sphere": ("s", GREEN), "exact": ("P", SKY),
         "certified": ("^", PURPLE), "midpoint": ("v", ORANGE)}
"""Marker and colour of each route of this package."""

OTHER_LOOK = ("X", INK)
"""Of a route that this table does not know yet."""

FAMILIES = {
    "Gauss": ("x", ("gauss_x", "gauss_beta")), "tanh-sinh": ("+", ("tanh_sinh",)),
    "Lebedev": ("s", ("lebedev_scipy", "lebedev_quadpy")),
    "adaptive": ("^", ("quad", "quad_points", "quad_vec", "cubature", "nquad")),
    "SymPy": ("D", ("sympy_evalf", "sympy_lambdify")), "many digits": ("o", ("mpmath_quad", "ball_integral")),
}
"""Marker and routes of each family from outside; one that is not listed makes a family of its own."""

PALE = "#8f8f8f"
"""Markers of outside routes: they stand back behind those of the package, and still print."""

LEAST = 1e-17
"""Errors below this are drawn at the lower edge [-]: they are far below a unit of the last place."""

HEADROOM = 2e3
"""Room above the largest error for the name of the printed rule [-]."""


@house_style
def pareto(scenes: Sequence[MeasuredScene]) -> Figure:
    """Draw error against time, a panel for each hypothesis.

    Parameters
    ----------
    scenes : sequence of MeasuredScene
        One scene under one or two hypotheses.

    Returns
    -------
    matplotlib.figure.Figure
        Both axes logarithmic; the legend stands above.

    Notes
    -----
    The thin steps are the front: what lies above and to the right of them is beaten in time and in error. Source: the
    data of ``granular cost``.
    """
    figure = blank(height=4.6)
    panels = figure.subplots(1, len(scenes), sharex=True, sharey=True, squeeze=False)[0]
    for axes, scene in zip(panels, scenes, strict=True):
        _panel(axes, scene)
    axes = panels[0]
    worst = max((error_of(cost) for scene in scenes for cost in scene.results), default=1.0)
    axes.set(xscale="log", yscale="log", ylim=(LEAST / 2, HEADROOM * max(worst, 1.0)),
             yticks=[10.0 ** -k for k in range(16, -1, -4)])
    axes.minorticks_off()
    axes.set_ylabel("relative error of the worst component [–]")
    figure.supxlabel("time over that of the unit [–]", fontsize=9.5)
    named = {name: handle for axes in panels
             for handle, name in zip(*axes.get_legend_handles_labels(), strict=True)}
    figure.legend(handles=list(named.values()), labels=list(named), loc="outside upper center", ncols=4, frameon=False,
                  handletextpad=0.4, columnspacing=1.2, handlelength=1.6)
    return figure


def _panel(axes: Axes, scene: MeasuredScene) -> None:
    for name, costs in scene.routes(PRODUCT):
        marker, colour = LOOKS.get(name, OTHER_LOOK)
        for number, members in enumerate(series(costs)):
            axes.plot(*places(members), marker=marker, color=colour, markersize=5, linewidth=1.1, zorder=4,
                      markeredgewidth=0, clip_on=False, label=name if number == 0 else None)
    for family, (marker, costs) in by_family(scene).items():
        axes.plot(*places(costs), marker=marker, color=PALE, markersize=4.5, linestyle="none", zorder=3,
                  markerfacecolor="none", markeredgewidth=0.9, clip_on=False, label=family)
    axes.step(*places(front(scene)), where="post", color=INK, linewidth=0.8, zorder=3.5, label="front")
    paper = scene.paper
    if paper is not None:
        (time,), (error,) = places([paper])
        axes.plot(time, error, marker="o", markersize=11, markerfacecolor="none", color=INK, markeredgewidth=1.3,
                  linestyle="none", zorder=5, label="the paper's rule")
        axes.annotate(f"the paper's\n{paper.setting}", (time, error), xytext=(time, 0.99),
                      textcoords=axes.get_xaxis_transform(), fontsize=9, va="top", ha="left", linespacing=1.05,
                      zorder=6, arrowprops={"arrowstyle": "-", "color": INK, "linewidth": 0.7, "shrinkB": 5.5,
                                            "relpos": (0, 0), "shrinkA": 0})
    axes.set_title(str(scene.hypothesis))


def places(costs: Sequence[Cost]) -> tuple[list[float], list[float]]:
    """Where measurements stand in the picture.

    Parameters
    ----------
    costs : sequence of Cost
        Measurements with a result.

    Returns
    -------
    tuple of list of float
        Times over the unit [-], and errors [-], none of them below the lower edge.

    Notes
    -----
    Source: the axes of this figure.
    """
    return [time_of(cost) for cost in costs], [max(error_of(cost), LEAST) for cost in costs]


def by_family(scene: MeasuredScene) -> dict[str, tuple[str, list[Cost]]]:
    """Results of the outside routes, by families of the same idea.

    Parameters
    ----------
    scene : MeasuredScene
        A scene.

    Returns
    -------
    dict
        Name of the family -> marker and measurements.

    Notes
    -----
    Source: the table of families.
    """
    family_of = {route: (family, marker) for family, (marker, routes) in FAMILIES.items() for route in routes}
    found: dict[str, tuple[str, list[Cost]]] = {}
    for name, costs in scene.routes(OUTSIDE):
        if costs:
            family, marker = family_of.get(name, (name, "*"))
            found.setdefault(family, (marker, []))[1].extend(costs)
    return found


def size(value: float, digits: int = 3) -> str:
    """Write a number of any size as print does.

    Parameters
    ----------
    value : float
        A time or a factor [-], > 0.
    digits : int
        Digits that count [-].

    Returns
    -------
    str
        No exponent below a million; thousands apart by a space at which no line ends.

    Notes
    -----
    Source: the numbers of this figure.

    Examples
    --------
    >>> size(2.977), size(4007000.0), size(0.5312, 2), size(0.9996)
    ('2.98', '4.01e+06', '0.53', '1.00')
    >>> size(36730.0).split()
    ['36', '700']
    """
    rounded = float(f"{value:.{digits - 1}e}")
    if not 0.001 <= rounded < 1e6:
        return f"{value:.{digits}g}"
    places = max(0, digits - 1 - math.floor(math.log10(rounded)))
    return f"{rounded:,.{places}f}".replace(",", "\N{NARROW NO-BREAK SPACE}")
