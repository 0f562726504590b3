"""Maps of anisotropy over the fabric: lines of equal value over D33 and Dr33, for one stress ratio or several."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from granular.figures.contour_names import on_path
from granular.figures.look import (
    INK,
    MAP,
    blank,
    house_style,
)
from granular.figures.mohr_circle import onset_ratio
from granular.measures import MEASURES, measure

if TYPE_CHECKING:
    import numpy as np
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

POISSON_RATIO = 0.21
FRICTION_ANGLE = 12.0
"""Grains of the paper [-], [degrees]."""

FRICTION, ONSET = math.tan(math.radians(FRICTION_ANGLE)), onset_ratio(FRICTION_ANGLE)
"""Friction coefficient, and the ratio of sigma33/N33 and sigma11/N11 at which contacts begin to slide [-]."""

D33_RANGE, DR33_RANGE = (-0.8, 1.2), (-0.6, 0.6)
"""What is shown [-]: both ends of the line of nearly isotropic stiffness lie in corners."""

POINTS = (61, 37)
"""Values of D33 and of Dr33 on a map: lines are smooth to the eye."""

RATIO_LEVELS = (0.2, 0.25, 0.33, 0.4, 0.5, 0.65, 0.8, 1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0)
"""Lines of ratios, about evenly spaced by factors, the same on every map."""

LEVELS: dict[str, tuple[float, ...]] = {
    "C1111/C3333": RATIO_LEVELS, "C2323/C1212": RATIO_LEVELS, "E1/E3": RATIO_LEVELS,
    "delta": (-0.4, -0.3, -0.2, -0.1, 0.0, 0.1, 0.2, 0.5, 1.0, 2.0),
    "nu31": tuple(step / 200 for step in range(1, 14)), "nu12": tuple(step / 1000 for step in range(16, 30)),
}
"""Lines of each measure."""

ALONG = ((-0.72, -0.54), (0.75, -0.3), (0.98, 0.5))
"""Where the names of lines stand: across the lines, beside the marks."""

APART = 0.05
"""Share of that path that two names need [-]."""

CONSTANT = ("C1111/C3333", "C2323/C1212", "E1/E3", "delta", "nu31", "nu12")
"""Measures of the map of equal contacts; the others follow from the first two."""

FIRST_ORDER = "$D_{33} + 2D^r_{33} = 0$"

RATIOS = (0.5, 1.0, 2.0)
"""Stress ratios of the maps with contact forces."""


@dataclass(frozen=True, slots=True)
class Place:
    """An assembly that is marked on a map.

    Attributes
    ----------
    text : str
        What the mark stands for; places with one text share a mark.
    D33, Dr33 : float
        Where it lies [-].
    marker : str
        Marker of matplotlib.
    """

    text: str
    D33: float
    Dr33: float
    marker: str = "o"


def grid() -> tuple[Array, Array]:
    """Values of both coefficients on a map.

    Returns
    -------
    D33, Dr33 : (n,) array, (m,) array
        In rising order [-].

    Notes
    -----
    Source: ``D33_RANGE``, ``DR33_RANGE``, ``POINTS``.
    """
    import numpy as np

    return np.linspace(*D33_RANGE, POINTS[0]), np.linspace(*DR33_RANGE, POINTS[1])


@lru_cache(maxsize=16)
def stiffness_over(ratio: float | None) -> Array:
    """Stiffness over the whole map by the kinematic hypothesis.

    Parameters
    ----------
    ratio : float or None
        sigma33/sigma11 [-], with contact forces, partial slip and sliding; None for contacts of one stiffness.

    Returns
    -------
    (m, n, 6) array
        Over (M/V) l_e^2 k_n,ref [-]; not to be written to.

    Notes
    -----
    Accuracy: as ``granular.axial_stiffness`` states. Source: eqs (4), (7), (20) to (23).
    """
    from granular.array_stiffness import axial_stiffness

    D33, Dr33 = grid()
    if ratio is None:
        found = axial_stiffness(D33, Dr33[:, None], poisson_ratio=POISSON_RATIO, kinetic=False)
    else:
        found = axial_stiffness(D33, Dr33[:, None], ratio, FRICTION, POISSON_RATIO, rtol=1e-12)
    found.flags.writeable = False
    return found


@house_style
def constant_maps(places: Sequence[Place] = ()) -> Figure:
    """Draw six measures of assemblies whose contacts are equally stiff.

    Parameters
    ----------
    places : sequence of Place
        Assemblies to mark.

    Returns
    -------
    matplotlib.figure.Figure
        Six panels; dotted, D33 + 2 Dr33 = 0; thick, where the measure has its isotropic value.

    Notes
    -----
    Source: eq. (4) with contacts of one stiffness.
    """
    figure = blank(height=7.6)
    panels = figure.subplots(3, 2, sharex=True, sharey=True)
    for number, (axes, name) in enumerate(zip(panels.flat, CONSTANT, strict=True)):
        draw_map(axes, measure(stiffness_over(None), name), name)
        axes.set_title(f"({'abcdef'[number]})  ${MEASURES[name].symbol}$ [–]", loc="left")
        mark_places(axes, places)
    name_axes(panels)
    _legend(figure, places)
    return figure


@house_style
def stress_maps(places: Sequence[Place] = ()) -> Figure:
    """Draw both ratios of the paper under three stress ratios, with contact forces, partial slip and sliding.

    Parameters
    ----------
    places : sequence of Place
        Assemblies to mark.

    Returns
    -------
    matplotlib.figure.Figure
        Two rows of three panels; lines and colours have the same values in all; dash-dotted, where sliding begins.

    Notes
    -----
    Source: eqs (4) and (20) to (23).
    """
    figure = blank(height=5.1)
    panels = figure.subplots(2, len(RATIOS), sharex=True, sharey=True)
    for row, name in zip(panels, CONSTANT[:2], strict=True):
        for axes, ratio in zip(row, RATIOS, strict=True):
            draw_map(axes, measure(stiffness_over(ratio), name), name)
            _mark_sliding(axes, ratio)
            axes.set_title(f"${MEASURES[name].symbol}$ [–]\n" rf"at $\sigma_{{33}}/\sigma_{{11}} = {ratio:g}$")
            mark_places(axes, places)
    name_axes(panels)
    _legend(figure, places, sliding=True)
    return figure


def draw_map(axes: Axes, values: Array, name: str) -> None:
    """Draw lines of equal value, named, over shades, with the line of nearly isotropic stiffness.

    Parameters
    ----------
    axes : matplotlib.axes.Axes
        Where.
    values : (m, n) array
        One value for each point of ``grid`` [-].
    name : str
        The measure, a key of ``LEVELS``.

    Notes
    -----
    Source: the look of this package.
    """
    import matplotlib as mpl
    from matplotlib.colors import BoundaryNorm

    D33, Dr33 = grid()
    levels, isotropic = LEVELS[name], MEASURES[name].isotropic
    colours = mpl.colormaps[MAP]
    axes.grid(False)
    axes.contourf(D33, Dr33, values, levels=levels, cmap=colours, norm=BoundaryNorm(levels, colours.N, extend="both"),
                  extend="both", alpha=0.6)
    lines = axes.contour(D33, Dr33, values, levels=levels, colors=INK, negative_linestyles="solid",
                         linewidths=[2.0 if level == isotropic else 0.7 for level in levels])
    axes.clabel(lines, fontsize=9, inline_spacing=2, manual=on_path(D33, Dr33, values, levels, ALONG, APART),
                fmt=_minus)
    first_order(axes)


def _minus(value: float) -> str:
    """A number with a minus sign that no dash of a line is taken for."""
    return f"{value:g}".replace("-", "−")


def _mark_sliding(axes: Axes, ratio: float) -> None:
    """Where the first contacts slide, with an arrow to the side where they do; branch lengths have no part in it."""
    for onset, side in ((ONSET, "right"), (1 / ONSET, "left")):
        D33 = 5 * (ratio - onset) / (ratio + 2 * onset)  # ratio N11/N33 = onset
        if D33_RANGE[0] < D33 < D33_RANGE[1]:
            axes.axvline(D33, color=INK, linestyle="-.", linewidth=0.9)
            axes.annotate("←" if side == "right" else "→", (D33, DR33_RANGE[1]), (-1 if side == "right" else 1, -3),
                          textcoords="offset points", ha=side, va="top")


def first_order(axes: Axes) -> None:
    """Draw the line along which equal contacts are isotropic to first order.

    Parameters
    ----------
    axes : matplotlib.axes.Axes
        Where; its limits stay.

    Notes
    -----
    Source: (1 + D33 P2)(1 + Dr33 P2)^2 to first order in both.
    """
    axes.plot(D33_RANGE, [-end / 2 for end in D33_RANGE], color=INK, linestyle=":", linewidth=1.1, scalex=False,
              scaley=False)


def mark_places(axes: Axes, places: Sequence[Place]) -> None:
    """Mark assemblies.

    Parameters
    ----------
    axes : matplotlib.axes.Axes
        Where.
    places : sequence of Place
        The assemblies.

    Notes
    -----
    Source: the look of this package.
    """
    for place in places:
        axes.plot(place.D33, place.Dr33, **_mark(place))


def _mark(place: Place) -> dict[str, Any]:
    """Settings of a mark: white with an edge, so that it is seen on every shade."""
    return {"marker": place.marker, "color": "white", "markeredgecolor": INK, "markeredgewidth": 0.9,
            "markersize": 5.5, "linestyle": "none", "zorder": 5}


def _legend(figure: Figure, places: Sequence[Place], *, sliding: bool = False) -> None:
    """What the marks and lines mean, above the panels."""
    from matplotlib.lines import Line2D

    named = {place.text: place for place in places}
    handles = [Line2D([], [], **_mark(place), label=text) for text, place in named.items()]
    handles.append(Line2D([], [], color=INK, linestyle=":", linewidth=1.1, label=FIRST_ORDER))
    if sliding:
        handles.append(Line2D([], [], color=INK, linestyle="-.", linewidth=0.9, label="sliding begins, towards →"))
    figure.legend(handles=handles, loc="outside upper center", ncols=3 if sliding else len(handles), frameon=False,
                  fontsize=9, columnspacing=1.2, handletextpad=0.4)


def name_axes(panels: NDArray[np.object_]) -> None:
    """Name the axes of panels that share them, at the left and at the bottom.

    Parameters
    ----------
    panels : grid of matplotlib.axes.Axes
        Maps.

    Notes
    -----
    Source: the look of this package.
    """
    for axes in panels[-1]:
        axes.set_xlabel("contact normals, $D_{33}$ [–]")
    for axes in panels[:, 0]:
        axes.set_ylabel("branches, $D^r_{33}$ [–]")
    panels[0, 0].set(xlim=D33_RANGE, ylim=DR33_RANGE, xticks=(-0.5, 0, 0.5, 1), yticks=(-0.5, 0, 0.5))


