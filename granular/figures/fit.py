"""Chi-square of a fit over D33 and Dr33: the valley of what the stiffness sees, the best fit, the intervals."""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.errors import FigureNotKnown
from granular.figures.files import STATIC_SUFFIXES, static_bytes, target, write
from granular.figures.look import BLUE, INK, SKY, SOFT_INK, VERMILION, blank, house_style

if TYPE_CHECKING:
    import os
    from pathlib import Path

    import numpy as np
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from granular.fitting import Fit

    Array = NDArray[np.float64]

FABRIC = ("D33", "Dr33")
ALONG, ACROSS = 61, 41
"""Points of the map along the valley and across it."""

HALF_WIDTH = 5.0
"""Standard errors on either side of the valley that the map covers [-]; the 95 % region ends at 2.4 of them."""


@house_style
def fit_map(result: Fit) -> Figure:
    """Draw the map of a fit of D33 and Dr33.

    Parameters
    ----------
    result : Fit
        A fit whose unknowns are D33 and Dr33, in this order.

    Returns
    -------
    matplotlib.figure.Figure
        One panel: joint 68 % and 95 % regions, the valley where the combination seen at first order keeps its value,
        the best fit and the intervals of either unknown.

    Raises
    ------
    FigureNotKnown
        Other unknowns.

    Notes
    -----
    Source: chi-square of the fit, its factors fitted anew at each point.
    """
    figure = blank(height=3.7)
    draw_map(figure.add_subplot(), result)
    return figure


def draw_map(axes: Axes, result: Fit, *, label: bool = True) -> None:
    """Draw the map of a fit into axes.

    Parameters
    ----------
    axes : matplotlib.axes.Axes
        Where.
    result : Fit
        A fit whose unknowns are D33 and Dr33, in this order.
    label : bool
        Whether regions and valley are named.

    Raises
    ------
    FigureNotKnown
        Other unknowns.

    Notes
    -----
    Source: as :func:`fit_map`.
    """
    import numpy as np
    from scipy.stats import chi2

    if result.problem.unknowns != FABRIC:
        raise FigureNotKnown(f"a map of {', '.join(result.problem.unknowns)}",
                             allowed="allowed for the unknowns D33 and Dr33, in this order",
                             remedy='Write unknowns = ["D33", "Dr33"], or leave the figure out.')
    (left, right), (bottom, top) = (_window(result, place) for place in range(2))
    d, dr = _mesh(result, left, right)
    _, heights = result.problem.best_factors(np.stack([d, dr], axis=-1))
    rise = heights - result.chi_square
    inner, outer = (float(chi2.ppf(level, 2)) for level in (0.6827, 0.95))
    axes.contourf(d, dr, rise, levels=[-np.inf, inner, outer], colors=[SKY, SKY], alpha=0.3)
    axes.contourf(d, dr, rise, levels=[-np.inf, inner], colors=[SKY], alpha=0.45)
    axes.contour(d, dr, rise, levels=[inner, outer], colors=[BLUE], linewidths=[1.6, 1.0])
    best = [one.value for one in result.estimates]
    weights = result.combinations[0].coefficients
    if weights[1]:
        line = np.array([left, right])
        axes.plot(line, best[1] - weights[0] / weights[1] * (line - best[0]), color=SOFT_INK, linewidth=0.9,
                  linestyle=(0, (4, 2)), scalex=False, scaley=False)
    for place, one in enumerate(result.estimates):
        interval = one.intervals[0]
        ends = [[interval.low, interval.high], [best[1 - place]] * 2]
        axes.plot(*(ends if place == 0 else ends[::-1]), color=VERMILION, linewidth=1.4, zorder=4)
    axes.plot(*best, "o", color=VERMILION, markersize=5, zorder=5)
    axes.plot(0, 0, marker="+", color=INK, markersize=7, zorder=3)
    axes.set(xlim=(left, right), ylim=(bottom, top), xlabel="$D_{33}$ [–]", ylabel="$D^r_{33}$ [–]")
    if label:
        axes.text(0.97, 0.96, "68 % and 95 % regions\n" + _valley(weights), transform=axes.transAxes, ha="right",
                  va="top", color=SOFT_INK, fontsize=9)


def _mesh(result: Fit, left: float, right: float) -> tuple[Array, Array]:
    """Points that follow the valley, (across, along): a straight grid would need a hundred times as many."""
    import numpy as np

    valley = result.profiles[0]
    low, high = result.problem.bounds
    first = result.combinations[0]
    width = first.standard_error / abs(first.coefficients[1]) if first.coefficients[1] else 0.2
    d = np.linspace(max(left, low[0]), min(right, high[0]), ALONG)
    center = np.interp(d, valley.values, valley.others[:, 1])
    across = HALF_WIDTH * width * np.linspace(-1, 1, ACROSS)
    return np.broadcast_to(d, (ACROSS, ALONG)), np.clip(center + across[:, None], low[1], high[1])


def _valley(weights: tuple[float, ...]) -> str:
    """Name of the dashed line."""
    over = weights[1] / weights[0] if weights[0] else float("inf")
    return f"dashed: $D_{{33}} {over:+.2f}\\,D^r_{{33}}$ = const"


def _window(result: Fit, place: int) -> tuple[float, float]:
    """What is shown of an unknown: its wider interval, the isotropic state, a margin; inside the bounds."""
    interval = result.estimates[place].intervals[-1]
    low, high = min(interval.low, 0.0), max(interval.high, 0.0)
    margin = 0.35 * (high - low)
    bounds = tuple(float(end[place]) for end in result.problem.bounds)
    return max(low - margin, bounds[0]), min(high + margin, bounds[1])


def save_fit(result: Fit, out: str | os.PathLike[str]) -> Path:
    """Write the map of a fit.

    Parameters
    ----------
    result : Fit
        A fit whose unknowns are D33 and Dr33.
    out : str or path-like
        File name, ending in .svg, .png or .pdf.

    Returns
    -------
    Path
        The file.

    Raises
    ------
    FigureNotKnown
        Another format, or other unknowns.
    FigureNotWritten
        The file cannot be written.

    Notes
    -----
    Source: :func:`fit_map`.
    """
    path = target(out)
    if path.suffix.lower() not in STATIC_SUFFIXES:
        raise FigureNotKnown(f"plot = {str(path)!r}", allowed=f"allowed suffixes: {', '.join(STATIC_SUFFIXES)}",
                             remedy="End the file name with one of them.")
    figure = fit_map(result)
    write(path, lambda: static_bytes(figure, path.suffix.lower()[1:]))
    return path
