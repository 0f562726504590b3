"""Why a result is what it is, as text: the table of effects, where the error comes from, what was counted."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from granular.effects.selection import rounded_up
from granular.report_tensors import OF_LARGEST
from granular.turning import NOT_TURNED

if TYPE_CHECKING:
    from rich.console import Console, ConsoleOptions, RenderResult

    from granular.evaluation import Evaluation
    from granular.planning import Plan
    from granular.routes.work import Work
    from granular.turning import Turning

HEADINGS = ("effect", "simulated", "relative change\nwithout it, up to", "evaluations\nwith/without", "why")
"""Columns of the table of effects; the reasons stand below it where a terminal is not wide."""

NOTHING = "nothing"
"""What an effect changes that the scene does not call for."""

NARROW, WIDE = 52, 104
"""Width of a terminal below which there is no table, and from which reasons stand in the table [characters]."""


@dataclass(frozen=True, slots=True)
class EffectLine:
    """What there is to say about one effect of a scene.

    Attributes
    ----------
    name : str
        Name in the scene file.
    simulated : str
        "yes" or "no".
    bound : str
        Relative change of the worst component without it, at the most.
    cost : str
        Evaluations with it and without it.
    why : str
        Why it is simulated or not, and why there is no bound.
    """

    name: str
    simulated: str
    bound: str
    cost: str
    why: str


def effect_lines(decided: Plan) -> tuple[EffectLine, ...]:
    """Say of every effect whether it is simulated, why, how much it may matter and what it costs.

    Parameters
    ----------
    decided : Plan
        A plan.

    Returns
    -------
    tuple of EffectLine
        In the order of the catalogue. An effect that the scene does not call for changes nothing and costs nothing.

    Notes
    -----
    Source: the plan.
    """
    from granular.effects import CATALOGUE

    bounds, costs = decided.selection.reasoned_bounds, decided.costs

    def line(name: str) -> EffectLine:
        why = decided.called_for.get(name) or decided.effects_not_called_for[name]
        bound = bounds.get(name)
        if bound is None:
            return EffectLine(name, "no", NOTHING, "-", why)
        unknown = math.isinf(bound.value)
        counted = costs[name]
        return EffectLine(
            name, "yes" if name in decided.called_for else "no", "no bound" if unknown else rounded_up(bound.value),
            "no stiffness" if counted is None else f"{counted[0]}/{counted[1]}",
            f"{why} (no bound: {bound.reason})" if unknown else why)

    return tuple(line(effect.name) for effect in CATALOGUE)


@dataclass(frozen=True, slots=True)
class EffectTable:
    """The table of effects for a console of any width.

    Attributes
    ----------
    lines : tuple of EffectLine
        One for each effect.
    """

    lines: tuple[EffectLine, ...]

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
        """Draw columns, or where they would be too narrow to read, one block for each effect."""
        from rich.padding import Padding
        from rich.table import Table
        from rich.text import Text

        del console  # the width is all that matters
        if options.max_width < NARROW:
            for line in self.lines:
                yield Text(f"{line.name}: {'' if line.simulated == 'yes' else 'not '}simulated", style="bold")
                yield from (Padding(Text(text), (0, 0, 0, 2)) for text in _block(line))
            return
        wide = options.max_width >= WIDE
        table = Table(box=None, padding=(0, 2, 0, 0), header_style="bold", pad_edge=False)
        for heading in HEADINGS if wide else HEADINGS[:-1]:
            table.add_column(heading, no_wrap=heading != HEADINGS[-1])
        for line in self.lines:
            reason = [Text(line.why)] if wide else []
            table.add_row(line.name, line.simulated, line.bound, line.cost, *reason,
                          style="" if line.simulated == "yes" else "dim")
        yield Padding(table, (0, 0, 0, 2))
        if wide:
            return
        reasons = Table.grid(padding=(0, 2, 0, 0))
        for line in self.lines:
            reasons.add_row(line.name, Text(line.why))
        yield ""
        yield Padding(reasons, (0, 0, 0, 2))


def _block(line: EffectLine) -> Iterator[str]:
    yield line.why
    if line.bound != NOTHING:
        yield f"relative change without it, up to: {line.bound}"
        yield f"evaluations with/without: {line.cost}"


def error_budget(route: float, scaling: float, left_out: float) -> str:
    """Say where an error bound comes from.

    Parameters
    ----------
    route, scaling, left_out : float
        Bounds of the route, of the step to pascals, and of what was left out [-].

    Returns
    -------
    str
        The three of them, none where a route promises nothing.

    Notes
    -----
    Source: ``granular.error_budget``.

    Examples
    --------
    >>> error_budget(1.8e-15, 2.3e-16, 0.0)
    'effects left out 0, route 1.8e-15, scaling to pascals 2.3e-16'
    """
    of_route = "unknown" if math.isinf(route) else rounded_up(route)
    return f"effects left out {rounded_up(left_out)}, route {of_route}, scaling to pascals {rounded_up(scaling)}"


def explained(result: Evaluation) -> dict[str, str]:
    """What ``run --explain`` adds to a result, as facts with a name.

    Parameters
    ----------
    result : Evaluation
        An evaluated scene.

    Returns
    -------
    dict
        Name -> text.

    Notes
    -----
    Source: the plan of the result, and what the route counted.
    """
    decided = result.plan
    return {
        "route": f"{decided.route}: {decided.route_reason}",
        "rule": "" if result.rule == decided.route else result.rule,
        "error budget": error_budget(result.route_error, decided.scaling_error, decided.left_out_error)
                        + turned(decided.turning),
        "wanted": "" if decided.rtol is None else f"{decided.rtol:.2g} of {relative_to(decided)}",
        "evaluations": f"{result.evaluations} counted, {predicted(decided)} predicted",
        "arithmetic": "" if decided.axis is None else
                      f"{arithmetic(result.work)}, {arithmetic(decided.work)} predicted",
    }


def relative_to(decided: Plan) -> str:
    """Say what errors are relative to.

    Parameters
    ----------
    decided : Plan
        A plan.

    Returns
    -------
    str
        Each component about axis 3, the largest entry of the Mandel matrix in any other frame.

    Notes
    -----
    Source: ``granular.turning``, ``granular.effects.forms``.
    """
    return "each component" if decided.of_each_component else OF_LARGEST


def predicted(decided: Plan) -> str:
    """Say how many evaluations a plan expects.

    Parameters
    ----------
    decided : Plan
        A plan.

    Returns
    -------
    str
        Exactly, or about where the rule is halved until it agrees with itself.

    Notes
    -----
    Source: the plan.
    """
    return f"{'about ' if decided.error_is == 'estimate' else ''}{decided.evaluations}"


def turned(turning: Turning) -> str:
    """Say what turning makes of the errors before it.

    Parameters
    ----------
    turning : Turning
        To axis 3 and back.

    Returns
    -------
    str
        Nothing for a scene that is not turned.

    Notes
    -----
    Source: ``granular.turning``.
    """
    if turning == NOT_TURNED:
        return ""
    return f"; {turning.spread:g} times their sum and {rounded_up(turning.added)} after turning"


def arithmetic(work: Work | None) -> str:
    """Say what an evaluation takes.

    Parameters
    ----------
    work : Work or None
        Operations and functions; None where they are not counted.

    Returns
    -------
    str
        Both of them.

    Notes
    -----
    Source: ``granular.routes.work``.

    Examples
    --------
    >>> from granular.routes.work import Work
    >>> arithmetic(Work(operations=15436, functions=1071)), arithmetic(None)
    ('15,436 operations and 1,071 roots and the like', 'not counted')
    """
    if work is None:
        return "not counted"
    return f"{work.operations:,} operations and {work.functions:,} roots and the like"
