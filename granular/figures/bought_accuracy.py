"""What a wanted accuracy buys by the rule along the meridian: directions, and errors below the promised ones."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from granular.checks.bought_accuracy import ACCURACIES, bought
from granular.figures.look import BLUE, GREEN, ORANGE, PURPLE, SOFT_INK, VERMILION, blank, house_style
from granular.hypothesis import Hypothesis

if TYPE_CHECKING:
    from matplotlib.figure import Figure

DRAWN = (("kinetic", Hypothesis.KINEMATIC, "forces, no slip", BLUE, "o"),
         ("unequal-branches", Hypothesis.STATIC, "branches 8 to 1, static", GREEN, "s"),
         ("sticking", Hypothesis.KINEMATIC, "partial slip", ORANGE, "v"),
         ("opened", Hypothesis.KINEMATIC, "opened contacts", PURPLE, "D"),
         ("sliding", Hypothesis.KINEMATIC, "sliding contacts", VERMILION, "^"))
"""Scenes of the cost study, from smooth integrands to those with edges, with name, colour and marker."""

DASHES: tuple[Any, ...] = ("-", (0, (5, 1.5)), (0, (1.2, 1.2)), (0, (5, 1.5, 1, 1.5)), (0, (9, 2)))
"""Of their lines."""

LEAST = 1e-17
"""Errors below this are drawn at the lower edge."""


@house_style
def bought_accuracy() -> Figure:
    """Draw directions, and promised and true error, against the wanted accuracy.

    Returns
    -------
    matplotlib.figure.Figure
        Two panels with a common horizontal axis that runs from loose to tight.

    Notes
    -----
    Source: :mod:`granular.checks.bought_accuracy`.
    """
    figure = blank(height=6.2)
    above, below = figure.subplots(2, 1, sharex=True, height_ratios=(1, 1.15))
    for (name, hypothesis, label, colour, marker), line in zip(DRAWN, DASHES, strict=True):
        found = bought(name, hypothesis)
        wanted = [one.rtol for one in found]
        above.loglog(wanted, [one.evaluations for one in found], linestyle=line, marker=marker, markersize=4.5,
                     linewidth=1.0, color=colour, label=label)
        below.loglog(wanted, [one.promised for one in found], color=colour, linestyle=line, linewidth=1.0)
        below.loglog(wanted, [max(one.error, LEAST) for one in found], marker, markersize=4.5, color=colour)
    below.loglog(ACCURACIES, ACCURACIES, color=SOFT_INK, linestyle=":", linewidth=1.2)
    below.annotate("wanted", (ACCURACIES[4], ACCURACIES[4]), xytext=(4, 4), textcoords="offset points",
                   color=SOFT_INK, ha="left", va="bottom")
    above.set(ylabel="directions [–]", ylim=(4, 700))
    above.set_yticks([5, 10, 50, 100, 500], ["5", "10", "50", "100", "500"])
    above.minorticks_off()
    below.set(xlabel="wanted relative accuracy of every component, rtol [–]",
              ylabel="relative error of the worst component [–]", ylim=(LEAST, 1e-2),
              yticks=[1e-16, 1e-13, 1e-10, 1e-7, 1e-4])
    below.minorticks_off()
    below.invert_xaxis()
    figure.legend(*above.get_legend_handles_labels(), loc="outside upper center", ncols=3, frameon=False,
                  handletextpad=0.4, columnspacing=1.2)
    return figure
