"""Fabrics for which the stiffness looks isotropic: the lines on the map where a ratio of two components is one."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

from granular.figures.anisotropy_maps import CONSTANT, FIRST_ORDER, first_order, grid, name_axes, stiffness_over
from granular.figures.look import BLUE, GREEN, INK, SOFT_INK, VERMILION, blank, house_style
from granular.measures import MEASURES, measure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    Dashes = Literal["-"] | tuple[float, tuple[float, ...]]

CASES: tuple[tuple[float | None, str, Dashes, str], ...] = (
    (None, SOFT_INK, "-", "equal contacts"), (0.5, BLUE, (0, (1.5, 1.2)), r"$\sigma_{33}/\sigma_{11} = 0.5$"),
    (1.0, GREEN, (0, (5, 1.5)), "1"), (2.0, VERMILION, (0, (5, 1.5, 1, 1.5)), "2"))
"""Stress ratio (None: contacts of one stiffness), colour, dashes and name of each line."""


@house_style
def isotropic_lines() -> Figure:
    """Draw where each of the two ratios is one, with equal contacts and under three stress ratios.

    Returns
    -------
    matplotlib.figure.Figure
        Two panels; dotted, D33 + 2 Dr33 = 0.

    Notes
    -----
    Source: eqs (4) and (20) to (23).
    """
    from matplotlib.lines import Line2D

    figure = blank(height=3.5)
    panels = figure.subplots(1, 2, sharex=True, sharey=True)
    D33, Dr33 = grid()
    for axes, name in zip(panels, CONSTANT[:2], strict=True):
        for ratio, colour, line, _ in CASES:
            values = measure(stiffness_over(ratio), name)
            axes.contour(D33, Dr33, values, levels=[1.0], colors=[colour], linestyles=[line], linewidths=1.8)
        first_order(axes)
        axes.set_title(f"${MEASURES[name].symbol} = 1$")
    handles = [Line2D([], [], color=colour, linestyle=line, linewidth=1.8, label=text)
               for _, colour, line, text in CASES]
    handles.append(Line2D([], [], color=INK, linestyle=":", linewidth=1.1, label=FIRST_ORDER))
    figure.legend(handles=handles, loc="outside upper center", ncols=len(handles), frameon=False, fontsize=9,
                  handlelength=2.2, columnspacing=0.8, handletextpad=0.5)
    name_axes(panels[None, :])
    return figure
