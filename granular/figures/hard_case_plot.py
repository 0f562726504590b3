"""Hard cases at a glance: how many digits a formula as first written loses, and what is left of them here."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Sequence
from typing import TYPE_CHECKING, Protocol

from granular.figures.look import BLUE, GREEN, GRID, INK, SOFT_INK, VERMILION, blank, house_style, readable

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

LEAST, WHOLE, EDGE = 1e-17, 1.0, 30.0
"""Left end of the axis, an error as large as the value, and where results that are no number stand [-]."""

DOUBLE = 1e-15
"""Right end of the band of double precision: four or five roundings [-]."""

LINE, BETWEEN = 0.165, 0.13
"""Height of a line of words, and what is left between two rows [in]."""

LETTERS = 31
"""Letters in a line."""


class Compared(Protocol):
    """What the figure needs to know of a hard case.

    Attributes
    ----------
    name : str
        A few words.
    naive_label : str
        How the naive result was computed.
    naive_error, stable_error : float
        Relative errors [-]; inf or nan for a result that is no number.
    """

    @property
    def name(self) -> str:
        """A few words."""

    @property
    def naive_label(self) -> str:
        """How the naive result was computed."""

    @property
    def naive_error(self) -> float:
        """Relative error [-], or inf or nan."""

    @property
    def stable_error(self) -> float:
        """Relative error [-], or inf or nan."""


@house_style
def hard_cases(cases: Sequence[Compared]) -> Figure:
    """Draw the two errors of each case on one row, the worst naive one on top.

    Parameters
    ----------
    cases : sequence of Compared
        At least one.

    Returns
    -------
    matplotlib.figure.Figure
        As high as the cases need.

    Notes
    -----
    Under the name of each case stands how the naive result was computed. An error of zero stands at the left end of
    the axis, one above 1 at the right edge. Source: the corpus of hard cases.
    """
    rows = sorted(cases, key=lambda case: -place(case.naive_error))
    words = [(textwrap.wrap(case.name, LETTERS), textwrap.wrap(case.naive_label, LETTERS)) for case in rows]
    heights = [BETWEEN + LINE * (len(name) + len(label)) for name, label in words]
    total = sum(heights)
    figure = blank(height=1.35 + total)
    axes = figure.add_subplot()
    axes.axvspan(LEAST, DOUBLE, facecolor=GREEN, alpha=0.16, edgecolor="none", zorder=0)
    axes.axvline(WHOLE, color=SOFT_INK, linewidth=0.7, zorder=1)
    axes.set(xscale="log", xlim=(LEAST, 3 * EDGE), ylim=(total, 0), yticks=[],
             xticks=[10.0 ** -k for k in range(16, -1, -4)], xlabel="relative error [–]")
    axes.minorticks_off()
    top = 0.0
    for case, (name, label), height in zip(rows, words, heights, strict=True):
        _name(axes, top + BETWEEN / 2, name, INK)
        _name(axes, top + BETWEEN / 2 + LINE * len(name), label, SOFT_INK)
        _row(axes, top + height / 2, case)
        top += height
        axes.axhline(top, color=GRID, linewidth=0.5, zorder=0.5)
    axes.text(math.sqrt(LEAST * DOUBLE), 1.0, "double\nprecision", transform=axes.get_xaxis_transform(), ha="center",
              va="bottom", color=readable(GREEN), linespacing=1.0)
    figure.legend(*axes.get_legend_handles_labels(), loc="outside upper right", ncols=2, frameon=False,
                  handletextpad=0.3, columnspacing=1.5)
    return figure


def _name(axes: Axes, top: float, lines: list[str], colour: str) -> None:
    """Words at the left of a row, the lines as far apart as the row counts them."""
    for number, line in enumerate(lines):
        axes.annotate(line, (0, top + LINE * (number + 0.5)), xycoords=axes.get_yaxis_transform(), xytext=(-8, 0),
                      textcoords="offset points", ha="right", va="center", color=colour, annotation_clip=False)


def _row(axes: Axes, height: float, case: Compared) -> None:
    """Two marks and the line between them; names of the marks are given once, with the first row."""
    ends = place(case.stable_error), place(case.naive_error)
    first = not axes.get_legend_handles_labels()[0]
    axes.plot(ends, (height, height), color=SOFT_INK, linewidth=0.9, zorder=2)
    axes.plot(ends[1], height, marker="X", markersize=7.5, color=VERMILION, markeredgewidth=0, zorder=3,
              linestyle="none", label="naive formula" if first else None)
    axes.plot(ends[0], height, marker="o", markersize=6.5, color=BLUE, zorder=4, linestyle="none", clip_on=False,
              label="this library" if first else None)
    for error, end, colour in zip((case.stable_error, case.naive_error), ends, (BLUE, VERMILION), strict=True):
        if end == EDGE:
            axes.annotate(_without_value(error), (end, height), xytext=(7, 0), textcoords="offset points",
                          va="center", ha="left", color=readable(colour), annotation_clip=False)


def place(error: float) -> float:
    """Where on the axis an error is drawn.

    Parameters
    ----------
    error : float
        Relative error [-], or inf or nan.

    Returns
    -------
    float
        Between the left end and the right edge [-]; everything above 1 and every result that is no number stands there.

    Notes
    -----
    Source: the axis of this figure.
    """
    return EDGE if not abs(error) <= WHOLE else max(abs(error), LEAST)


def _without_value(error: float) -> str:
    """Why a result stands at the right edge."""
    if math.isnan(error):
        return "no number"
    if math.isinf(error):
        return "no bound"
    return f"{error:.3g} times" if error < 1000 else f"$10^{{{math.floor(math.log10(error))}}}$ times"
