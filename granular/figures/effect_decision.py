"""How effects are chosen: a row for each, in the order in which they are asked, with the answers of one scene."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from granular.checks.effect_decisions import Decision, Outcome, decisions
from granular.effects.selection import SHARE
from granular.figures.look import BLUE, GRID, INK, ORANGE, SOFT_INK, WIDTH, blank, house_style

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from granular.scene import Scene

ROW, HEAD, FOOT = 0.42, 1.0, 0.5
"""Heights of a row, of the heads above them, and of what stands below [in]."""

NAME, CALLED, NEEDED, BOUND, END = 0.08, 1.28, 2.33, 3.66, 5.34
"""Where columns stand [in]: names begin at the first, the others are centred."""

WORD, BOUNDS, BOX = 0.22, 0.74, 0.43
"""Half the width of a word, of two bounds, and of what follows, with some air [in]."""

HEADS = ((CALLED, "does the scene\ncall for it?"), (NEEDED, "does one that\nstays need it?"),
         (BOUND, "does its bound fit\nwhat is left of\nthe share?"), (END, "so it is"))
FILLS = {Outcome.ABSENT: "#ffffff", Outcome.LEFT_OUT: "#fbe6bf", Outcome.SIMULATED: "#cfe3f1"}
EDGES = {Outcome.ABSENT: SOFT_INK, Outcome.LEFT_OUT: ORANGE, Outcome.SIMULATED: BLUE}


@house_style
def effect_decision(scene: Scene, rtol: float) -> Figure:
    """Draw what is asked of each effect, what a scene answers, and what follows.

    Parameters
    ----------
    scene : Scene
        Its ``model.effects`` is "auto".
    rtol : float
        Wanted relative accuracy of every component [-].

    Returns
    -------
    matplotlib.figure.Figure
        Seven rows from left to right, and the rest of the accuracy below them.

    Notes
    -----
    Source: :func:`granular.checks.effect_decisions.decisions`.
    """
    made = decisions(scene, rtol)
    height = HEAD + ROW * len(made) + FOOT
    figure = blank(height=height, layout=None)
    axes = figure.add_axes((0, 0, 1, 1))
    axes.set(xlim=(0, WIDTH), ylim=(0, height))
    axes.set_axis_off()
    first = height - HEAD
    axes.text(NAME, height - 0.22, f"wanted: {_power(rtol)} of every component; effects may spend {SHARE:g} of it, "
              f"{_power(SHARE * rtol)}", va="center")
    for place, text in HEADS:
        axes.text(place, first + 0.05, text, ha="center", va="bottom", color=SOFT_INK, linespacing=1.05)
    for k, decision in enumerate(made):
        _row(axes, first - ROW * (k + 0.6), decision)
    _down(axes, first, first - ROW * len(made))
    spent = math.prod(1 + (one.bound or 0.0) for one in made if one.outcome is Outcome.LEFT_OUT) - 1
    axes.text(NAME, FOOT / 2, f"spent {_power(spent, 2)}, which is part of the error of the result; the rest goes to "
              "the route" if spent else "nothing is spent; the whole of it goes to the route", va="center")
    return figure


def _row(axes: Axes, y: float, decision: Decision) -> None:
    """Questions from left to right as far as they are asked, and what follows."""
    absent = decision.outcome is Outcome.ABSENT
    axes.text(NAME + 0.16, y, decision.name, va="center", color=SOFT_INK if absent else INK)
    answers = [(CALLED, "yes" if decision.called_for else "no", WORD)]
    if decision.called_for:
        answers.append((NEEDED, ", ".join(decision.needed_by) or "no", WORD))
    if decision.bound is not None:
        fits = decision.outcome is Outcome.LEFT_OUT
        against = "<" if fits else ">"
        answers.append((BOUND, f"{_power(decision.bound, 2)} {against} {_power(decision.rest, 2)}", BOUNDS))
    for place, text, _ in answers:
        axes.text(place, y, text, ha="center", va="center", color=SOFT_INK if absent else INK)
    stops = [place - half for place, _, half in [*answers[1:], (END, "", BOX)]]
    for (place, _, half), stop in zip(answers, stops, strict=True):
        axes.annotate("", (stop, y), (place + half, y),
                      arrowprops={"arrowstyle": "-|>", "color": SOFT_INK, "linewidth": 0.8, "mutation_scale": 8,
                                  "shrinkA": 0, "shrinkB": 0})
    axes.text(END, y, str(decision.outcome), ha="center", va="center",
              bbox={"boxstyle": "round,pad=0.3", "facecolor": FILLS[decision.outcome],
                    "edgecolor": EDGES[decision.outcome], "linewidth": 0.9})


def _down(axes: Axes, top: float, bottom: float) -> None:
    """The order of the rows, and lines between them."""
    axes.annotate("", (NAME, bottom), (NAME, top),
                  arrowprops={"arrowstyle": "-|>", "color": SOFT_INK, "linewidth": 0.8, "mutation_scale": 9,
                              "shrinkA": 0, "shrinkB": 0})
    y = top
    while y > bottom - ROW / 2:
        axes.plot([NAME + 0.14, WIDTH - 0.06], [y, y], color=GRID, linewidth=0.5, zorder=0)
        y -= ROW


def _power(number: float, digits: int = 1) -> str:
    """A number as digits times a power of ten, for matplotlib."""
    if math.isinf(number):
        return "no bound"
    mantissa, _, power = f"{number:.{digits - 1}e}".partition("e")
    return f"${'' if mantissa == '1' else mantissa + chr(92) + 'cdot'}10^{{{int(power)}}}$"
