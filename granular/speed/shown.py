"""The tables of the speed study on a terminal."""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.speed.comparisons import MET
from granular.speed.store import Row, Study

if TYPE_CHECKING:
    from rich.console import Console
    from rich.table import Table

    from granular.speed.interleaved import Measured

NARROW = 34
"""Characters of the name of a way that are never broken."""


def show(study: Study) -> None:
    """Print every comparison, what other packages give, and where it was measured.

    Parameters
    ----------
    study : Study
        What was measured.

    Notes
    -----
    Times are shown beside the bounds that are aimed at; whoever runs it on a machine with other work judges.
    """
    from rich.console import Console

    console = Console(highlight=False, markup=False, emoji=False)
    console.print("Time of one element over that of the first way, median of the rounds, and least over least. Errors "
                  f"are relative, the {MET} unless something else is said.\n")
    for row in study.rows:
        plural = "" if row.size == 1 else ("ies" if row.each.endswith("y") else "s")
        each = row.each[:-1] if plural == "ies" else row.each
        console.print(f"{row.title}, {row.size:,} {each}{plural}", style="bold")
        if row.errors not in ("", MET) and row.ways:
            console.print(f"  error: {row.errors}")
        console.print(f"  {row.failure}\n" if row.failure else _table(row))
    _others(study, console)
    judged = [met for row in study.rows for way in row.ways for met in way.verdicts]
    if judged:
        console.print(f"{sum(judged)} of {len(judged)} bounds that are aimed at are met in this run.")
    about = dict(study.machine)
    console.print(f"Measured in {study.rounds} rounds or fewer on {about.pop('processor')}: "
                  + ", ".join(f"{name} {value}" for name, value in about.items()), soft_wrap=True)


def _table(row: Row) -> Table:
    from rich.table import Table

    table = Table(box=None, pad_edge=False, padding=(0, 1), collapse_padding=True)
    table.add_column("  way", min_width=NARROW)
    judged = any(way.wanted for way in row.ways)
    remembered = any(way.memory is not None for way in row.ways)
    headings = ["ratio", "least", *(["at most"] if judged else []), "ns each", "error",
                *(["memory", "at most"] if remembered else [])]
    for heading in headings:
        table.add_column(heading, justify="right", no_wrap=True)
    for way in row.ways:
        table.add_row(f"  {way.name}", f"{way.ratio:.3g}", f"{way.least:.3g}",
                      *([_bound(way.wanted)] if judged else []), f"{way.nanoseconds:.4g}",
                      "" if way.error is None else f"{way.error:.1e}", *(_memory(way) if remembered else []))
    table.add_row("")
    return table


def _bound(value: float | None) -> str:
    return "" if value is None else f"{value:g}"


def _memory(way: Measured) -> list[str]:
    return ["" if way.memory is None else f"{way.memory:.2g}",
            "" if way.memory_wanted is None else f"{way.memory_wanted:g}"]


def _others(study: Study, console: Console) -> None:
    from rich.table import Table

    if not study.agreements:
        return
    table = Table(box=None, pad_edge=False, padding=(0, 1), title="Numbers of other packages", title_justify="left")
    table.add_column("  what")
    for heading in ("gives", "is meant to give", "apart"):
        table.add_column(heading, justify="right", no_wrap=True)
    for one in study.agreements:
        table.add_row(f"  {one.package}: {one.quantity}", f"{one.theirs:.6g}", f"{one.meant:.6g} {one.unit}",
                      f"{one.distance:.1e}")
    console.print(table)
