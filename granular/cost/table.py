"""The cost study as a table in a terminal: what each wanted accuracy costs by each route."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby
from typing import TYPE_CHECKING

from granular.cost.records import Cost

if TYPE_CHECKING:
    from rich.console import RenderableType
    from rich.table import Table

WANTED = (1e-3, 1e-6, 1e-9, 1e-12)
"""Accuracies for which the least time is shown [-]."""


def tables(costs: Sequence[Cost]) -> Iterator[RenderableType]:
    """Show the least time that reaches each accuracy, a table for each scene.

    Parameters
    ----------
    costs : sequence of Cost
        In the order of scenes and routes.

    Returns
    -------
    iterator of rich renderables
        A table, and under it why routes gave nothing.
    """
    for (scene, hypothesis), group in groupby(costs, key=lambda cost: (cost.scene, cost.hypothesis)):
        of_scene = list(group)
        yield _table(f"{scene}, {hypothesis}", of_scene)
        for route, rows in _by_route(of_scene):
            if all(cost.error is None for cost in rows):
                yield f"  {route}: {rows[0].failure}"
        yield ""


def _by_route(costs: Sequence[Cost]) -> Iterator[tuple[str, list[Cost]]]:
    for route in dict.fromkeys(cost.route for cost in costs):
        yield route, [cost for cost in costs if cost.route == route]


def _table(title: str, costs: Sequence[Cost]) -> Table:
    from rich.table import Table

    table = Table(title=title, title_justify="left", box=None, pad_edge=False, padding=(0, 1), collapse_padding=True,
                  header_style="bold")
    table.add_column("route", no_wrap=True)
    for wanted in WANTED:
        table.add_column(f"{wanted:.0e}", justify="right", no_wrap=True)
    for heading in ("best error", "settings", "failed"):
        table.add_column(heading, justify="right", no_wrap=True)
    for route, rows in _by_route(costs):
        errors = [cost.error for cost in rows if cost.error is not None]
        if errors:
            table.add_row(route, *(_least(rows, wanted) for wanted in WANTED), f"{min(errors):.1e}", str(len(rows)),
                          str(sum(cost.failure is not None for cost in rows) or ""))
    return table


def _least(costs: Sequence[Cost], wanted: float) -> str:
    """Least time of a setting without a failure that is as accurate as that."""
    times = [cost.time_ratio for cost in costs if cost.failure is None and cost.error is not None
             and cost.error <= wanted and cost.time_ratio is not None]
    return f"{min(times):.3g}" if times else "-"
