"""The number by which gradation enters the stiffness: by spread for each reading, and by the cut of sizes."""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.figures.look import (
    BLUE,
    GREEN,
    INK,
    ORANGE,
    PURPLE,
    SKY,
    SOFT_INK,
    VERMILION,
    blank,
    house_style,
    readable,
    spread,
)
from granular.gradation.cut_sizes import cut
from granular.gradation.readings import READINGS, literal

if TYPE_CHECKING:
    from matplotlib.axis import Axis
    from matplotlib.figure import Figure

COLOURS = (BLUE, VERMILION, PURPLE, ORANGE, GREEN, INK, SKY)
SHORT = ("eq. (17)", "eq. (19)", "(17), 0.1 to 99.9 %\nby volume", "(17), four devia-\ntions by number",
         "square root of $g^{\\mathrm{total}}$", "one length", "$g^{\\mathrm{total}}$ itself")
"""Names at the curves, in the order of the readings."""

WIDEST = 2.5
"""Largest spread of the first figure [-]."""

CUTS = ((1.2, GREEN), (1.5, BLUE), (2.0, VERMILION))
"""Spreads of the second figure."""

HANDED_DOWN = 6.0
"""Cut that explains 4.355, 6.50 and 29.0, in geometric standard deviations about r_50 [-]."""


@house_style
def number_by_reading() -> Figure:
    """Draw <l^2>/<r^3>^(2/3) against the spread of grain sizes, for every reading.

    Returns
    -------
    matplotlib.figure.Figure
        One panel with a logarithmic vertical axis.

    Notes
    -----
    Source: eqs (11), (12), (16), (17), (19).
    """
    import numpy as np

    spreads = np.linspace(1.0, WIDEST, 31)
    figure = blank(height=3.8)
    axes = figure.add_subplot()
    ends = []
    for reading, colour in zip(READINGS, COLOURS, strict=True):
        numbers = [4.0, *(reading.numbers(float(one)).kinematic for one in spreads[1:])]  # equal spheres to begin with
        ends.append(float(np.log10(numbers[-1])))
        axes.semilogy(spreads, numbers, color=colour, linestyle=":" if colour == INK else "-")
    _plain_logarithm(axes.yaxis)
    axes.set(xlim=(1.0, WIDEST), ylim=(0.9, 600), xlabel="geometric standard deviation of sizes, $s_r$ [–]",
             ylabel="$\\langle\\ell^2\\rangle / \\langle r^3\\rangle^{2/3}$ [–]")
    order = sorted(range(len(ends)), key=lambda k: ends[k])
    for k, place in zip(order, spread([ends[k] for k in order], 0.24), strict=True):
        axes.text(WIDEST + 0.03, 10.0**place, SHORT[k], color=readable(COLOURS[k]), va="center", ha="left",
                  linespacing=1.0)
    axes.annotate("4", (1.0, 4.0), xytext=(-6, 0), textcoords="offset points", ha="right", va="center")
    return figure


@house_style
def number_by_cut() -> Figure:
    """Draw how the literal number builds up with the range of sizes.

    Returns
    -------
    matplotlib.figure.Figure
        The number over its value for the whole range, against the cut; three spreads, and the values at six deviations.

    Notes
    -----
    Source: eqs (11), (12), (16), (17) with r_m and r_M on either side of the printed r_50.
    """
    import numpy as np

    deviations = np.linspace(0.5, 12.0, 47)
    figure = blank(height=3.4)
    axes = figure.add_subplot()
    for place, (one, colour) in enumerate(CUTS):
        whole = literal(one).kinematic
        share = [cut(one, float(k), about="printed").kinematic / whole for k in deviations]
        axes.plot(deviations, share, color=colour)
        first = float(np.interp(0.62, share, deviations)) if share[0] < 0.62 else 0.8
        height = float(np.interp(first, deviations, share))
        beside = (6, -2) if share[0] < 0.62 else (0, -14)
        axes.annotate(f"$s_r = {one}$", (first, height), xytext=beside, textcoords="offset points", va="center",
                      color=readable(colour))
        there = cut(one, HANDED_DOWN, about="printed").kinematic
        axes.plot(HANDED_DOWN, there / whole, "o", color=colour, markersize=5)
        axes.text(7.0, 0.4 - 0.09 * place, f"{there:#.4g} of {whole:#.4g}", color=readable(colour))
    axes.text(7.0, 0.49, "the number at six", color=INK)
    axes.axvline(HANDED_DOWN, color=SOFT_INK, linestyle=":", linewidth=1.2, zorder=1)
    axes.set(xlim=(0, 12), ylim=(0, 1.05),
             xlabel="cut on either side of $r_{50}$, in geometric standard deviations [–]",
             ylabel="number over that of all sizes [–]")
    return figure


def _plain_logarithm(axis: Axis) -> None:
    """Plain numbers on a logarithmic axis."""
    from matplotlib.ticker import FuncFormatter, NullFormatter

    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axis.set_minor_formatter(NullFormatter())
