"""What leaving an effect out may change and what it does change, along the effect's own parameter."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from granular.checks.effect_sweeps import SWEEPS, WEAKEST, Sweep, points
from granular.effects.selection import SHARE
from granular.figures.look import BLUE, SOFT_INK, VERMILION, blank, house_style
from granular.hypothesis import Hypothesis

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

RTOL = 1e-3
"""Wanted accuracy whose share for effects is marked [-]."""

LOOKS: dict[Hypothesis, tuple[str, dict[str, Any]]] = {
    Hypothesis.STATIC: (VERMILION, {"marker": "s", "markersize": 6.5, "markerfacecolor": "none"}),
    Hypothesis.KINEMATIC: (BLUE, {"marker": "o", "markersize": 3})}
"""Colour and mark of each hypothesis; changes are nearly the same by both, so that one mark stands inside the other."""

LEAST, MOST = 1e-10, 1e3
"""Ends of the vertical axes [-]; bounds above say no more than that the effect stays."""


@house_style
def effect_bounds() -> Figure:
    """Draw bounds as lines and true changes as marks, one panel for each effect that can be weak.

    Returns
    -------
    matplotlib.figure.Figure
        Six panels on logarithmic axes; the share of an accuracy of 1e-3 as a dotted line.

    Notes
    -----
    Source: :mod:`granular.checks.effect_sweeps`.
    """
    figure = blank(height=7.4)
    axes = figure.subplots(3, 2, sharey=True)
    for panel, sweep in zip(axes.flat, SWEEPS, strict=True):
        _panel(panel, sweep)
    for panel in axes[:, 0]:
        panel.set_ylabel("relative change [–]")
    axes[1, 0].text(WEAKEST, SHARE * RTOL * 1.6, "share of $10^{-3}$", ha="left", va="bottom", color=SOFT_INK)
    figure.legend(*axes[0, 0].get_legend_handles_labels(), loc="outside upper center", ncols=2, frameon=False,
                  handletextpad=0.6, columnspacing=2.0)
    return figure


def _panel(panel: Axes, sweep: Sweep) -> None:
    for hypothesis, (colour, mark) in LOOKS.items():
        found = points(sweep, hypothesis)
        bounded = [point for point in found if math.isfinite(point.bound)]
        panel.loglog([point.strength for point in bounded], [point.bound for point in bounded], color=colour,
                     linestyle="--" if hypothesis is Hypothesis.STATIC else "-", label=f"bound, {hypothesis}")
        panel.loglog([point.strength for point in found], [point.change for point in found], color=colour,
                     linestyle="none", label=f"change, {hypothesis}", **mark)
    panel.axhline(SHARE * RTOL, color=SOFT_INK, linestyle=":", linewidth=1.2, zorder=1)
    panel.set(title=sweep.name, xlabel=f"{sweep.parameter} [–]", xlim=(WEAKEST / 2, 2 * max(1.0, sweep.strongest)),
              ylim=(LEAST, MOST), xticks=[1e-4, 1e-2, 1.0], yticks=[1e-9, 1e-6, 1e-3, 1.0, 1e3])
    panel.minorticks_off()
