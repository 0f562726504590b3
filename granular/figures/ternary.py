"""The triangle of fabrics: the three principal values of the fabric tensor of contact normals, which add up to one."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from granular.figures.look import INK, MAP, SOFT_INK, blank, house_style

if TYPE_CHECKING:
    import numpy as np
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

POISSON_RATIO = 0.21

LEVELS = (1.1, 1.25, 1.5, 2.0, 2.5, 3.0)
"""Largest over smallest stiffness on the lines."""

TICKS = (0.3, 0.4, 0.5)
"""Principal values on the lines across the triangle; 0.6 at a corner, where D_i = 2, and 0.2 at the side across."""

FINE = 61
"""Points along a side."""

AT_LEFT, BELOW, AT_RIGHT = ("right", "center", (-5, 2)), ("center", "top", (0, -5)), ("left", "center", (5, 2))
"""How the numbers stand at each side: alignment, and distance [points]."""

UP = 3**0.5 / 2
"""Height of a triangle whose sides are one."""


@dataclass(frozen=True, slots=True)
class Fabric3:
    """A fabric that is marked in the triangle.

    Attributes
    ----------
    text : str
        What the mark stands for; fabrics with one text share a mark.
    D : tuple of 3 float
        Principal values of D_ij for the axes nearest to 1, 2, 3 [-]; they add up to zero.
    marker : str
        Marker of matplotlib.
    """

    text: str
    D: tuple[float, float, float]
    marker: str = "o"


def in_triangle(D: Array) -> tuple[Array, Array]:
    """Place principal values in the triangle.

    Parameters
    ----------
    D : (..., 3) array
        Principal values of D_ij along axes 1, 2, 3 [-], each >= -1, their sum zero.

    Returns
    -------
    x, y : (...) array
        From the corner of axis 1 at (0, 0) to that of axis 2 at (1, 0); axis 3 is above [-].

    Notes
    -----
    Source: N_i = 1/3 + (2/15) D_i; the shares (1 + D_i)/3 add up to one, and are not negative where the density is not.

    Examples
    --------
    >>> import numpy as np
    >>> x, y = in_triangle(np.array([-1.0, -1.0, 2.0]))
    >>> float(x), round(float(y), 4)
    (0.5, 0.866)
    """
    _, second, third = ((1 + D[..., axis]) / 3 for axis in range(3))
    return second + third / 2, third * UP


def anisotropy_of(D: Array) -> Array:
    """Largest over smallest of C1111, C2222 and C3333 for branches of one length and contacts of one stiffness.

    Parameters
    ----------
    D : (..., 3) array
        Principal values of D_ij along axes 1, 2, 3 [-], from -1 to 2.

    Returns
    -------
    (...) array
        The ratio [-], 1 for the isotropic fabric alone.

    Notes
    -----
    Accuracy: as ``granular.axial_stiffness`` states. The stiffness is linear in D_ij, so that C1111 depends on D_11
    alone, and as C3333 of an axial assembly depends on D_33. Source: eq. (4).

    Examples
    --------
    >>> import numpy as np
    >>> round(float(anisotropy_of(np.array([-0.15, -0.15, 0.3]))), 3)
    1.198
    """
    from granular.array_stiffness import axial_stiffness

    along = axial_stiffness(D, 0.0, poisson_ratio=POISSON_RATIO, kinetic=False)[..., 1]
    ratio: Array = along.max(axis=-1) / along.min(axis=-1)
    return ratio


@house_style
def fabric_triangle(marked: Sequence[Fabric3] = ()) -> Figure:
    """Draw every fabric of rank two whose density is nowhere negative, with lines of equal anisotropy.

    Parameters
    ----------
    marked : sequence of Fabric3
        Fabrics to mark.

    Returns
    -------
    matplotlib.figure.Figure
        A triangle; its centre is the isotropic fabric, dashed are fabrics with an axis of symmetry.

    Notes
    -----
    Source: eq. (4) with contacts of one stiffness.
    """
    from matplotlib.lines import Line2D

    figure = blank(height=5.0)
    axes = figure.add_subplot()
    axes.set(aspect="equal", xlim=(-0.14, 1.14), ylim=(-0.16, UP + 0.13))
    axes.set_axis_off()
    _shade(axes)
    _scales(axes)
    for fabric in marked:
        axes.plot(*_place(fabric.D), **_mark(fabric))
    named = {fabric.text: fabric for fabric in marked}
    handles = [Line2D([], [], **_mark(fabric), label=text) for text, fabric in named.items()]
    handles.append(Line2D([], [], color=INK, linestyle="--", linewidth=1.0, label="axis of symmetry"))
    figure.legend(handles=handles, loc="outside upper center", ncols=3, frameon=False, fontsize=9,
                  columnspacing=1.2, handletextpad=0.4)
    return figure


def _shade(axes: Axes) -> None:
    """Lines of equal anisotropy over shades, and the three lines of axial symmetry."""
    import matplotlib as mpl
    import numpy as np
    from matplotlib.colors import BoundaryNorm

    steps = np.linspace(0, 1, FINE)
    shares = np.array([(first, second, 1 - first - second) for first in steps for second in steps
                       if first + second < 1 + 1e-9])
    D = np.clip(3 * shares - 1, -1, 2)
    values, (x, y) = anisotropy_of(D), in_triangle(D)
    colours = mpl.colormaps[MAP]
    levels = (1.0, *LEVELS)
    axes.tricontourf(x, y, values, levels=levels, cmap=colours, norm=BoundaryNorm(levels, colours.N, extend="max"),
                     extend="max", alpha=0.6)
    lines = axes.tricontour(x, y, values, levels=LEVELS, colors=INK, linewidths=0.7)
    axes.clabel(lines, fontsize=9, fmt="%g", manual=_names(values, x, y))
    for axis in range(3):
        corner, foot = np.roll([2.0, -1.0, -1.0], axis), np.roll([-1.0, 0.5, 0.5], axis)
        axes.plot(*in_triangle(np.stack([corner, foot])), color=INK, linestyle="--", linewidth=1.0)
    axes.plot(*in_triangle(np.array([[2, -1, -1], [-1, 2, -1], [-1, -1, 2], [2, -1, -1]])), color=INK, linewidth=1.2)


def _names(values: Array, x: Array, y: Array) -> list[tuple[float, float]]:
    """Where the lines are named: on the way from the centre to a point of the right side, off other lines."""
    import numpy as np

    way = np.linspace(0.0, 1.0, 401)[:, None] * np.array([-0.7, 1.0, -0.3])
    reached = anisotropy_of(way)
    across, up = in_triangle(way)
    places = [int(np.argmax(reached > level)) for level in LEVELS if reached[-1] > level]
    return [(float(across[place]), float(up[place])) for place in places]


def _scales(axes: Axes) -> None:
    """Lines of equal principal value with their numbers at one side each, and what the corners mean."""
    import numpy as np

    for axis, (ha, va, away, turn) in enumerate(((*AT_LEFT, 60), (*BELOW, 0), (*AT_RIGHT, -60))):
        for tick in TICKS:
            D = (tick - 1 / 3) * 7.5
            ends = np.array([np.roll([D, 1 - D, -1], axis), np.roll([D, -1, 1 - D], axis)])
            x, y = in_triangle(ends)
            axes.plot(x, y, color="white", linewidth=0.7)
            axes.annotate(f"{tick:g}", (x[1], y[1]), away, textcoords="offset points", ha=ha, va=va, fontsize=9)
        middle = np.roll([0.5, -1, 0.5], axis)
        far = 8 * away[0], (4 if axis == 1 else 8) * away[1]
        axes.annotate(f"$N_{{{axis + 1}{axis + 1}}}$ [–]", _place(tuple(middle)), far,
                      textcoords="offset points", ha="center", va="center", rotation=turn)
        corner = np.roll([2.0, -1.0, -1.0], axis)
        axes.annotate(f"most contacts\nnear axis {axis + 1}", _place(tuple(corner)), (0, 5 if axis == 2 else -16),
                      textcoords="offset points", ha="center", va="bottom" if axis == 2 else "top", color=SOFT_INK,
                      fontsize=9)


def _place(D: tuple[float, float, float]) -> tuple[float, float]:
    import numpy as np

    x, y = in_triangle(np.array(D))
    return float(x), float(y)


def _mark(fabric: Fabric3) -> dict[str, Any]:
    """Settings of a mark: white with an edge, so that it is seen on every shade."""
    return {"marker": fabric.marker, "color": "white", "markeredgecolor": INK, "markeredgewidth": 0.9,
            "markersize": 6, "linestyle": "none", "zorder": 5}
