"""Measured stiffness beside that of the model, against the mean stress on logarithmic axes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from granular.figures.look import BLUE, VERMILION, blank, house_style, readable

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.figure import Figure


@dataclass(frozen=True, slots=True)
class Compared:
    """One kind of stiffness under several mean stresses.

    Attributes
    ----------
    name : str
        What stands at its curves.
    stress : tuple of float
        Mean stresses [Pa], rising.
    measured, doubt, model : tuple of float
        Stiffness of the sample, its standard error, and the stiffness of the model [Pa], one for each stress.
    """

    name: str
    stress: tuple[float, ...]
    measured: tuple[float, ...]
    doubt: tuple[float, ...]
    model: tuple[float, ...]


@house_style
def measured_stiffness(kinds: Sequence[Compared]) -> Figure:
    """Draw measured stiffness as points with error bars and the model as lines.

    Parameters
    ----------
    kinds : sequence of Compared
        Two at most: circles and full lines, squares and dashed lines.

    Returns
    -------
    matplotlib.figure.Figure
        One panel, both axes logarithmic.

    Notes
    -----
    Source: the numbers given.
    """
    figure = blank(height=3.3)
    axes = figure.add_subplot()
    for one, colour, mark, line in zip(kinds, (BLUE, VERMILION), ("o", "s"), ("-", "--"), strict=False):
        stress = [value / 1e3 for value in one.stress]
        axes.plot(stress, [value / 1e6 for value in one.model], color=colour, linestyle=line)
        axes.errorbar(stress, [value / 1e6 for value in one.measured], [value / 1e6 for value in one.doubt],
                      color=colour, marker=mark, linestyle="none", capsize=3, markersize=6)
        for values, what in ((one.model, "model"), (one.measured, "measured")):
            axes.annotate(f"{one.name}, {what}", (stress[-1], values[-1] / 1e6), xytext=(8, 0), va="center",
                          textcoords="offset points", color=readable(colour), annotation_clip=False)
    axes.set_xscale("log")
    axes.set_yscale("log")
    ticks = [value / 1e3 for value in kinds[0].stress]
    axes.set_xticks(ticks, [f"{value:.3g}" for value in ticks])
    axes.set_yticks(_rungs(kinds), [f"{value:g}" for value in _rungs(kinds)])
    axes.minorticks_off()
    axes.set_xlabel("mean stress [kPa]")
    axes.set_ylabel("stiffness [MPa]")
    return figure


def _rungs(kinds: Sequence[Compared]) -> list[float]:
    """1, 2 and 5 times powers of ten within the range of the stiffness [MPa]."""
    every = [value / 1e6 for one in kinds for value in (*one.measured, *one.model)]
    candidates = [base * 10.0**power for power in range(-3, 7) for base in (1, 2, 5)]
    return [value for value in candidates if min(every) / 1.6 <= value <= max(every) * 1.6]
