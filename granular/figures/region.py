"""Pairs of coefficients for which the density of contact normals is nowhere negative."""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.directions import admissible_boundary
from granular.figures.look import BLUE, INK, SKY, SOFT_INK, blank, house_style

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@house_style
def admissible_region() -> Figure:
    """Draw the region of D33 and D3333, its boundary, and the interval that is left for D3333 = 0.

    Returns
    -------
    matplotlib.figure.Figure
        One panel with equal scales.

    Notes
    -----
    Source: E >= 0 for the density of the parametric study with its rank-4 term.
    """
    import numpy as np

    D33, D3333 = admissible_boundary(np.linspace(0.0, 2 * np.pi, 2161))
    figure = blank(height=3.6)
    axes = figure.add_subplot()
    axes.fill(D33, D3333, facecolor=SKY, alpha=0.3, edgecolor="none")
    axes.plot(D33, D3333, color=BLUE)
    axes.plot([-1, 2], [0, 0], color=INK, linewidth=1.2, marker="o", markersize=4.5)
    axes.annotate("$D_{3333} = 0$:  $-1 \\leq D_{33} \\leq 2$", (0.5, 0), xytext=(0, 4), textcoords="offset points",
                  ha="center", va="bottom")
    axes.plot(0, 0, marker="+", color=INK, markersize=7)
    for text, place, side in (("no contacts\nat the pole", (-0.75, -0.7), "right"),
                              ("no contacts\nat the equator", (1.75, -0.7), "left"),
                              ("no contacts at some angle in between", (0.6, 2.72), "center")):
        axes.text(*place, text, ha=side, va="center", color=SOFT_INK)
    axes.set(aspect="equal", xlim=(-3.0, 4.2), ylim=(-2.0, 3.0), xlabel="$D_{33}$ [–]", ylabel="$D_{3333}$ [–]")
    return figure
