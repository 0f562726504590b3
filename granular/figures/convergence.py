"""The error of the rule for slip against the density of its nodes, below, at and beyond the onset of sliding."""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.checks.convergence import NODES, STATES, errors, predicted
from granular.figures.look import BLUE, GREEN, SOFT_INK, VERMILION, blank, house_style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

LEAST = 1e-17
"""Errors below this are drawn at the lower edge."""


@house_style
def convergence_of_the_rule() -> Figure:
    """Draw the error for three stresses with the predicted slope.

    Returns
    -------
    matplotlib.figure.Figure
        Three curves with marks, and the prediction dashed.

    Notes
    -----
    Source: ``granular.checks.convergence``.
    """
    figure = blank(height=3.4)
    axes = figure.add_subplot()
    for name, marker, colour in zip(STATES, "osD", (BLUE, GREEN, VERMILION), strict=True):
        axes.semilogy(NODES, [max(error, LEAST) for error in errors(name)], marker=marker, markersize=5,
                      linewidth=1.0, color=colour, label=name)
    shown = [nodes for nodes in NODES if predicted(nodes) > LEAST]
    axes.semilogy(shown, [predicted(nodes) for nodes in shown], color=SOFT_INK, linestyle="--", linewidth=1.0,
                  label=r"$\exp(-\pi^2/(2\,\mathrm{step}))$")
    axes.set(xlabel="nodes for each unit of the mapped variable, 1/step [–]", ylabel="relative error [–]",
             ylim=(LEAST, 1), xticks=NODES)
    axes.legend(frameon=False, loc="upper right")
    return figure
