"""Printed tables as pictures: ratios case by case, how far they are from the exact ones, and which rule gives them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.figures.look import BLUE, INK, ORANGE, SKY, SOFT_INK, VERMILION, blank, house_style, named, readable

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from matplotlib.figure import Figure

DECIMALS = 1e-3
"""The unit of the last printed decimal [-]."""

COLOURS = {"C1111/C3333": BLUE, "C2323/C1212": ORANGE}
OVER = {"C1111/C3333": "horizontal over vertical", "C2323/C1212": "vertical over horizontal shear"}
"""What each ratio divides."""


@house_style
def ratios(cases: Sequence[str], exact: Mapping[str, Sequence[float]],
           printed: Mapping[str, Sequence[float]]) -> Figure:
    """Draw both ratios of each case of a table as a distance from 1, the value of an isotropic assembly.

    Parameters
    ----------
    cases : sequence of str
        Names of the cases, from the top.
    exact, printed : mapping of str to sequence of float
        C1111/C3333 and C2323/C1212 of each case [-].

    Returns
    -------
    matplotlib.figure.Figure
        One panel a ratio; a bar and a dot for the exact value, a ring for the printed one.

    Notes
    -----
    Source: Tables II to V.
    """
    figure = blank(height=1.15 + 0.33 * len(cases))
    panels = figure.subplots(1, len(exact), sharey=True)
    places = range(len(cases))
    for axes, (name, values) in zip(panels, exact.items(), strict=True):
        every = [*values, *printed[name], 1.0]
        room = 0.12 * (max(every) - min(every))
        axes.axvline(1.0, color=SOFT_INK, linewidth=1.0)
        axes.barh(places, [value - 1.0 for value in values], left=1.0, height=0.34, color=COLOURS[name], alpha=0.35)
        axes.plot(values, places, "o", color=COLOURS[name], markersize=5.5, label="exact")
        axes.plot(printed[name], places, "o", markerfacecolor="none", markeredgecolor=INK, markersize=10,
                  label="printed")
        axes.set(xlim=(min(every) - room, max(every) + room), ylim=(len(cases) - 0.5, -0.5), yticks=list(places),
                 yticklabels=cases, xlabel=f"{_named(name)} [–]")
        axes.set_title(OVER[name], loc="left")
        axes.grid(axis="y", visible=False)
    panels[0].set_ylabel("case [name]")
    figure.legend(*panels[0].get_legend_handles_labels(), loc="outside lower right", ncols=2, frameon=False)
    return figure


@house_style
def differences(cases: Sequence[str], names: Sequence[str], printed: Sequence[float], rule: Sequence[float]) -> Figure:
    """Draw how far printed ratios, and ratios by a rule, are from the exact ones.

    Parameters
    ----------
    cases, names : sequence of str
        Case and name of each ratio.
    printed, rule : sequence of float
        Printed value, and value by the rule, each minus the exact one [-].

    Returns
    -------
    matplotlib.figure.Figure
        Rings for what is printed, dots for the rule; tinted, where a rounded exact value would lie.

    Notes
    -----
    Source: Tables II to V.
    """
    figure = blank(height=3.5)
    axes = figure.add_subplot()
    places = range(len(cases))
    axes.axhspan(-0.5, 0.5, facecolor=SKY, alpha=0.3, edgecolor="none")
    axes.axhline(0.0, color=SOFT_INK, linewidth=1.0)
    axes.plot(places, [value / DECIMALS for value in printed], "o", markerfacecolor="none", markeredgecolor=INK,
              markersize=10, label="printed")
    for name, colour in COLOURS.items():
        kept = [place for place in places if names[place] == name]
        axes.plot(kept, [rule[place] / DECIMALS for place in kept], "o", color=colour, markersize=5,
                  label=f"by the rule, {_named(name)}")
    low, high = (edge(*printed, *rule) / DECIMALS for edge in (min, max))
    axes.set(xlim=(-0.7, len(cases) - 0.3), ylim=(low - 2.0, high + 2.0), xticks=list(places),
             xlabel="printed ratio [table, case]", ylabel="minus the exact ratio\n[units of the third decimal]")
    axes.set_xticklabels(cases, rotation=90)
    axes.grid(axis="x", visible=False)
    axes.text(len(cases) - 0.4, -0.75, "exact, rounded", color=readable(SKY), va="top", ha="right")
    figure.legend(*axes.get_legend_handles_labels(), loc="outside upper center", ncols=3, frameon=False)
    return figure


@house_style
def matches(given: Mapping[int, int], *, of: int, marked: int) -> Figure:
    """Draw how many printed ratios a rule gives against its number of panels.

    Parameters
    ----------
    given : mapping of int to int
        Number of panels, and how many ratios it gives [-].
    of : int
        How many ratios there are [-].
    marked : int
        The number of panels that gives all [-].

    Returns
    -------
    matplotlib.figure.Figure
        One bar a number of panels; a line where all ratios are given.

    Notes
    -----
    Source: Tables II to V.
    """
    figure = blank(height=2.9)
    axes = figure.add_subplot()
    axes.axhline(of, color=SOFT_INK, linewidth=1.0, linestyle=":")
    axes.bar(list(given), list(given.values()), width=0.72,
             color=[VERMILION if panels == marked else BLUE for panels in given])
    axes.annotate(f"{marked} panels: all {given[marked]}", (marked, given[marked]), xytext=(8, -2),
                  textcoords="offset points", ha="left", va="top", color=readable(VERMILION))
    axes.set(xlim=(min(given) - 1, max(given) + 1), ylim=(0, of + 1), yticks=range(0, of + 1, 3),
             xlabel="panels of the midpoint rule over $0 \\leq \\beta \\leq \\pi$ [–]",
             ylabel="printed ratios given [–]")
    axes.grid(axis="x", visible=False)
    return figure


def _named(ratio: str) -> str:
    """Typeset C1111/C3333."""
    return "/".join(named(component) for component in ratio.split("/"))
