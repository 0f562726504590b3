"""Rose diagrams of a list of directions with the density that its fabric tensors imply."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from granular.figures.look import BLUE, INK, SKY, SOFT_INK, VERMILION, blank, house_style, key_of
from granular.figures.surfaces import frame_section

if TYPE_CHECKING:
    import numpy as np
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import ArrayLike, NDArray

    from granular.fabric_tensors.rose import Bins

    Array = NDArray[np.float64]

ERRORS = 1.96
"""Half-length of the bars, in standard errors: intervals of 95 %."""

COUNTED: dict[str, Any] = {"facecolor": SKY, "edgecolor": "white", "linewidth": 0.6, "alpha": 0.55}
ISOTROPIC: dict[str, Any] = {"color": SOFT_INK, "linestyle": ":", "linewidth": 1.0}
IMPLIED: dict[int, dict[str, Any]] = {2: {"color": BLUE, "linestyle": (0, (3, 1.6)), "linewidth": 1.4},
                                      4: {"color": VERMILION, "linestyle": "-", "linewidth": 1.4}}
"""Looks of bins, of an isotropic fabric, and of the implied density by its rank."""


@house_style
def rose(directions: ArrayLike, weights: ArrayLike | None = None, *, axis: ArrayLike = (0.0, 0.0, 1.0)) -> Figure:
    """Draw how many directions lie at each angle from an axis and at each azimuth about it.

    Parameters
    ----------
    directions : (n, 3) array
        Unit vectors [-].
    weights : (n,) array, optional
        Not negative [any unit].
    axis : (3,) array
        The axis [-].

    Returns
    -------
    matplotlib.figure.Figure
        Two panels: shares in bins over those of an isotropic fabric, with a bar for 95 % in each bin of one quadrant
        or half; the implied density up to rank four full and up to rank two dashed; a dotted circle for an isotropic
        fabric.

    Raises
    ------
    ArrayNotUsable, NotFinite, DirectionNotUnit, ValueOutOfRange, TooFewDirections
        As for ``fabric_of``; no axis.

    Notes
    -----
    Source: ``granular.fabric_tensors.rose``.
    """
    import numpy as np

    from granular.fabric_tensors.rose import by_angle, by_azimuth, mean_by_angle, mean_by_azimuth
    from granular.fabric_tensors.tensors import fabric_of

    tensors = fabric_of(directions, weights)
    turn = np.linspace(0, 2 * np.pi, 361)
    figure = blank(height=3.25, layout=None)
    vertical = tuple(np.ravel(axis)) == (0.0, 0.0, 1.0)
    names = ("axis 3", "axis 1", "axis 2") if vertical else ("the axis", "one axis across", "the other")

    def angle_curve(rank: int) -> Array:
        return mean_by_angle(tensors, np.cos(turn), axis=axis, rank=rank)

    def azimuth_curve(rank: int) -> Array:
        return mean_by_azimuth(tensors, turn, axis=axis, rank=rank)

    panels = (
        (by_angle(directions, weights, axis=axis), True, f"by angle from {names[0]}",
         angle_curve, ("across", f"along {names[0]}")),
        (by_azimuth(directions, weights, axis=axis), False, f"by azimuth about {names[0]}",
         azimuth_curve, (f"along {names[1]}", f"along {names[2]}")),
    )
    for place, (bins, from_top, title, curve, (across, upward)) in enumerate(panels):
        axes = figure.add_axes((0.085 + 0.505 * place, 0.135, 0.4, 0.72))
        _wedges(axes, bins, from_top=from_top)
        axes.plot(np.cos(turn), np.sin(turn), **ISOTROPIC)
        for rank, line in IMPLIED.items():
            x, y = (np.sin(turn), np.cos(turn)) if from_top else (np.cos(turn), np.sin(turn))
            axes.plot(curve(rank) * x, curve(rank) * y, **line)
        reach = max(float((bins.density + ERRORS * bins.error).max()), float(curve(4).max()), float(curve(2).max()))
        frame_section(axes, 1.06 * reach, across=f"{across} [–]", upward=f"{upward} [–]", ticks=5)
        axes.set_title(title, pad=4)
    key_of(figure, (("counted", COUNTED), ("isotropic", ISOTROPIC), ("implied, rank two", IMPLIED[2]),
                    ("implied, rank four", IMPLIED[4])), height=0.945)
    return figure


def _wedges(axes: Axes, bins: Bins, *, from_top: bool) -> None:
    """Bins, repeated so as to go all around: n and -n, and both sides of an axis. Bars of their errors stand once."""
    import numpy as np
    from matplotlib.collections import PolyCollection

    polygons, bars = [], []
    for low, high, height, error in zip(bins.edges, bins.edges[1:], bins.density, bins.error, strict=False):
        arc = np.linspace(low, high, 12)
        middle, ends = (low + high) / 2, np.array([height - ERRORS * error, height + ERRORS * error])
        for mirror, half in ((1, 0.0), (1, np.pi), *(((-1, 0.0), (-1, np.pi)) if from_top else ())):
            polygons.append(_points(mirror * arc + half, height, from_top=from_top, centre=True))
        bars.append(_points(np.full(2, middle), np.maximum(ends, 0), from_top=from_top))
    axes.add_collection(PolyCollection(polygons, **COUNTED))
    for bar in bars:
        axes.plot(*bar.T, color=INK, linewidth=0.8, alpha=0.7)


def _points(angle: Array, radius: float | Array, *, from_top: bool, centre: bool = False) -> Array:
    import numpy as np

    x, y = radius * np.cos(angle), radius * np.sin(angle)
    points = np.stack([y, x] if from_top else [x, y], axis=1)
    return np.concatenate([[[0.0, 0.0]], points]) if centre else points
