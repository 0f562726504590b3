"""Axes and angles: a direction in the frame of the assembly, and the frame of one contact."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

from granular.figures.look import BLUE, GRID, INK, PURPLE, SKY, SOFT_INK, VERMILION, blank, house_style, readable

if TYPE_CHECKING:
    import numpy as np
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

ALPHA, BETA = 58.0, 38.0
"""Azimuth about axis 3 and angle from it of the direction that is shown [degrees]."""

SEEN_FROM, SEEN_ABOVE = 28.0, 18.0
"""Where the eye is: azimuth and height over the horizontal plane [degrees]."""

REACH = 1.28
"""Length of the axes over the radius of the sphere [-]."""


@house_style
def coordinates() -> Figure:
    """Draw axes, angles and the local frame of a contact, in which t points away from the reader.

    Returns
    -------
    matplotlib.figure.Figure
        Two panels: the frame of the assembly in space, and a contact in the vertical plane of its normal.

    Notes
    -----
    Source: Figure 2; n = (sin(beta) cos(alpha), sin(beta) sin(alpha), cos(beta)).
    """
    figure = blank(height=2.9, layout=None)
    _in_space(figure.add_axes((0.0, 0.0, 0.53, 1.0)))
    _at_the_contact(figure.add_axes((0.55, 0.0, 0.45, 1.0)))
    return figure


def direction(alpha: float, beta: float) -> Array:
    """Unit vector of a direction.

    Parameters
    ----------
    alpha, beta : float
        Azimuth about axis 3, and angle from it [degrees].

    Returns
    -------
    (3,) array
        Its components [-].

    Notes
    -----
    Source: Figure 2.

    Examples
    --------
    >>> direction(0.0, 90.0).round(12).tolist(), direction(77.0, 0.0).round(12).tolist()
    ([1.0, 0.0, 0.0], [0.0, 0.0, 1.0])
    """
    import numpy as np

    a, b = math.radians(alpha), math.radians(beta)
    return np.array([math.sin(b) * math.cos(a), math.sin(b) * math.sin(a), math.cos(b)])


def _seen(points: Array) -> Array:
    """Points as they appear to an eye far away, (2, ...)."""
    import numpy as np

    a, e = math.radians(SEEN_FROM), math.radians(SEEN_ABOVE)
    return np.array([[-math.sin(a), math.cos(a), 0.0],
                     [-math.cos(a) * math.sin(e), -math.sin(a) * math.sin(e), math.cos(e)]]) @ points


def _in_space(axes: Axes) -> None:
    import numpy as np
    from matplotlib.patches import Circle

    axes.add_patch(Circle((0, 0), 1.0, facecolor=SKY, alpha=0.12, edgecolor="none"))
    axes.add_patch(Circle((0, 0), 1.0, facecolor="none", edgecolor=GRID, linewidth=1.0))
    around = np.linspace(0.0, 360.0, 181)
    _line(axes, _seen(np.array([direction(a, 90.0) for a in around]).T), SOFT_INK, dotted=True)
    _line(axes, _seen(np.array([direction(ALPHA, b) for b in np.linspace(0.0, 90.0, 61)]).T), SOFT_INK, dotted=True)
    for k, (ha, va, shift) in enumerate((("right", "center", (-0.05, -0.02)), ("left", "center", (0.05, -0.02)),
                                         ("center", "bottom", (0.0, 0.03)))):
        end = _seen(REACH * np.eye(3)[k])
        _arrow(axes, (0.0, 0.0), end, INK)
        axes.text(end[0] + shift[0], end[1] + shift[1], str(k + 1), ha=ha, va=va)
    n = direction(ALPHA, BETA)
    foot = np.array([n[0], n[1], 0.0])
    _line(axes, _seen(np.array([n, foot, np.zeros(3)]).T), SOFT_INK, dotted=True)
    _arrow(axes, (0.0, 0.0), _seen(n), VERMILION)
    beside = _seen(1.07 * n)
    axes.text(beside[0], beside[1], "$\\mathbf{n}$", color=readable(VERMILION), ha="left", va="bottom")
    _line(axes, _seen(np.array([0.5 * direction(ALPHA, b) for b in np.linspace(0.0, BETA, 31)]).T), BLUE)
    _line(axes, _seen(np.array([0.42 * direction(a, 90.0) for a in np.linspace(0.0, ALPHA, 31)]).T), PURPLE)
    for place, text, colour in ((0.68 * direction(ALPHA, BETA / 2), "$\\beta$", BLUE),
                                (0.72 * direction(ALPHA / 2, 90.0), "$\\alpha$", PURPLE)):
        at = _seen(place)
        axes.text(at[0], at[1], text, color=readable(colour), ha="center", va="center")
    axes.set(aspect="equal", xlim=(-1.3, 1.5), ylim=(-1.12, 1.42))
    axes.set_axis_off()


def _at_the_contact(axes: Axes) -> None:
    import numpy as np
    from matplotlib.patches import Arc, Circle

    beta = math.radians(BETA)
    n, s = np.array([math.sin(beta), math.cos(beta)]), np.array([math.cos(beta), -math.sin(beta)])
    for centre in (np.zeros(2), 2 * n):
        axes.add_patch(Circle(_pair(centre), 1.0, facecolor=SKY, alpha=0.18, edgecolor="none"))
        axes.add_patch(Circle(_pair(centre), 1.0, facecolor="none", edgecolor=SOFT_INK, linewidth=1.1))
        axes.add_patch(Circle(_pair(centre), 0.045, facecolor=INK, edgecolor="none"))
    _line(axes, np.array([[0.0, 0.0], [0.0, 1.45]]), SOFT_INK, dotted=True)
    _line(axes, np.array([[0.0, 2 * n[0]], [0.0, 2 * n[1]]]), SOFT_INK)
    _line(axes, np.array([n - 1.25 * s, n + 1.25 * s]).T, SOFT_INK, dotted=True)
    axes.add_patch(Arc((0.0, 0.0), 1.3, 1.3, theta1=90.0 - BETA, theta2=90.0, color=BLUE, linewidth=1.4))
    _arrow(axes, n, n + 0.85 * n, VERMILION)
    _arrow(axes, n, n + 0.85 * s, VERMILION)
    axes.add_patch(Circle(_pair(n), 0.105, facecolor="white", edgecolor=VERMILION, linewidth=1.4))
    for turn in (45.0, 135.0):  # t points away from the reader, as the feathers of an arrow
        feather = 0.105 * np.array([math.cos(math.radians(turn)), math.sin(math.radians(turn))])
        _line(axes, np.array([n - feather, n + feather]).T, VERMILION)
    middle = math.radians(90.0 - BETA / 2)
    for place, text, colour, ha, va in (
            (n + 0.86 * n + np.array([-0.14, 0.0]), "$\\mathbf{n}$", VERMILION, "right", "center"),
            (n + 0.82 * s + np.array([0.06, 0.06]), "$\\mathbf{s}$", VERMILION, "left", "bottom"),
            (n + np.array([0.24, 0.03]), "$\\mathbf{t}$", VERMILION, "left", "center"),
            (0.8 * np.array([math.cos(middle), math.sin(middle)]), "$\\beta$", BLUE, "center", "center"),
            (np.array([0.0, 1.5]), "3", INK, "center", "bottom"),
            (0.45 * n + np.array([0.1, -0.08]), "$\\boldsymbol{\\ell}$", SOFT_INK, "left", "top")):
        axes.text(*_pair(place), text, color=readable(colour), ha=ha, va=va)
    axes.set(aspect="equal", xlim=(-1.1, 2.35), ylim=(-1.1, 2.72))
    axes.set_axis_off()


def _line(axes: Axes, points: Array, colour: str, *, dotted: bool = False) -> None:
    """A line that is part of the drawing and no data."""
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path

    axes.add_patch(PathPatch(Path(points.T), facecolor="none", edgecolor=colour, linewidth=1.1 if dotted else 1.4,
                             linestyle=":" if dotted else "-"))


def _arrow(axes: Axes, start: Sequence[float] | Array, end: Array, colour: str) -> None:
    axes.annotate("", _pair(end), (float(start[0]), float(start[1])), arrowprops={
        "arrowstyle": "-|>", "color": colour, "linewidth": 1.5, "shrinkA": 0, "shrinkB": 0, "mutation_scale": 11})


def _pair(point: Array) -> tuple[float, float]:
    return float(point[0]), float(point[1])
