"""A sieve curve by volume, as a sieve weighs it, and by number, as the model counts it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.figures.look import BLUE, INK, VERMILION, blank, house_style, readable

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from granular.gradation import MeasuredCurve


@house_style
def sizes_by_number(curve: MeasuredCurve) -> Figure:
    """Draw the fraction finer by volume and by number of grains, with the points of the sieves.

    Parameters
    ----------
    curve : MeasuredCurve
        Sizes by volume.

    Returns
    -------
    matplotlib.figure.Figure
        One panel, sizes on a logarithmic axis.

    Notes
    -----
    Source: eq. (12).
    """
    import numpy as np

    sizes = np.geomspace(min(curve.sizes), max(curve.sizes), 801)
    middle = np.sqrt(sizes[1:] * sizes[:-1])
    counted = np.concatenate([[0.0], np.cumsum(curve.density_by_number(middle) * np.diff(sizes))])
    counted /= counted[-1]
    millimetres = 1e3 * sizes
    figure = blank(height=3.2)
    axes = figure.add_subplot()
    weighed = 100 * curve.fraction_finer(sizes)
    axes.semilogx(millimetres, weighed, color=BLUE)
    axes.semilogx(1e3 * np.array(curve.sizes), 100 * np.array(curve.fractions), color=INK, marker="o", markersize=4.5,
                  linestyle="none", clip_on=False)
    axes.semilogx(millimetres, 100 * counted, color=VERMILION, linestyle="--")
    axes.set(xlim=(millimetres[0], millimetres[-1]), ylim=(0, 100), xlabel="grain diameter [mm]",
             ylabel="finer [%]")
    ticks = [tick for tick in (0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10) if millimetres[0] <= tick <= millimetres[-1]]
    axes.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
    axes.minorticks_off()
    for fractions, text, colour in ((weighed, "by volume", BLUE), (100 * counted, "by number", VERMILION)):
        beside = float(np.exp(np.interp(45.0, fractions, np.log(millimetres))))
        axes.text(1.06 * beside, 42.0, text, color=readable(colour), ha="left", va="top")
    return figure
