"""Comparisons folded to one row a group and route, short enough to read."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from granular.checks.comparison import Comparison
from granular.hypothesis import Hypothesis


@dataclass(frozen=True, slots=True, kw_only=True)
class Row:
    """What one route did in one group of cases.

    Attributes
    ----------
    group : str
        Family of cases, or the limit.
    cases : int
        How many cases the group has, by any route.
    route : str
        Which way of computing.
    worst : dict
        Hypothesis -> the comparison that is nearest to its bound, or beyond it.
    misses : int
        How many comparisons of the row do not agree.
    """

    group: str
    cases: int
    route: str
    worst: dict[Hypothesis, Comparison]
    misses: int


def rows(comparisons: Iterable[Comparison]) -> list[Row]:
    """Fold comparisons, in the order in which groups and routes first occur.

    Parameters
    ----------
    comparisons : iterable of Comparison
        As :func:`granular.checks.table` returns them.

    Returns
    -------
    list of Row
        One for each group and route; the routes of a group stand together.

    Notes
    -----
    Accuracy and source: those of the comparisons.

    Examples
    --------
    >>> from granular.checks.limit_comparisons import limit_comparisons
    >>> len(rows(limit_comparisons())) < 40
    True
    """
    groups: dict[str, dict[str, list[Comparison]]] = {}
    for comparison in comparisons:
        groups.setdefault(comparison.group, {}).setdefault(comparison.route, []).append(comparison)
    return [
        Row(group=group, cases=len({comparison.case for found in by_route.values() for comparison in found}),
            route=route, misses=sum(not comparison.agrees for comparison in found),
            worst={hypothesis: max(those, key=_closeness) for hypothesis in Hypothesis
                   if (those := [comparison for comparison in found if comparison.hypothesis is hypothesis])})
        for group, by_route in groups.items() for route, found in by_route.items()]


def _closeness(comparison: Comparison) -> tuple[bool, float]:
    """Misses first, then by the share of what is allowed."""
    return not comparison.agrees, comparison.error / comparison.allowed if comparison.allowed else comparison.error
