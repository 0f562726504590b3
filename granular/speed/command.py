"""The command ``granular speed``: measure comparison after comparison, keep what is finished, print a table."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from granular.fields import chosen
from granular.speed.comparisons import Comparison, catalogue
from granular.speed.interleaved import measure
from granular.speed.store import Row, described, write

if TYPE_CHECKING:
    from rich.table import Table

DONE, INTERRUPTED = 0, 130
"""Exit codes."""

ROUNDS = 9
"""How often everything is timed unless told otherwise [-]."""

LARGE = 10**6
"""Elements of a comparison [-]."""

SIZES = (1, 10, 100, 1000, 10**4, 10**5, 10**6, 10**7)
"""Elements for the picture of time against number [-]."""

SCALED = ("constant", "kinetic", "slip")
"""Comparisons that are made for every one of these sizes."""

SLOW = 10**5
"""Elements of a comparison with a way that takes long for each [-]."""

TAKES_LONG = ("slopes-kinetic", "slopes-slip")
"""Such comparisons."""


def run_speed(*, out: Path | None = None, rounds: int = ROUNDS, only: Sequence[str] = (), largest: int = SIZES[-1],
              advanced: Callable[[str], None] | None = None) -> int:
    """Measure, print a table, and write the data after every comparison.

    Parameters
    ----------
    out : Path or None
        JSON file for the data; it is replaced as a whole each time. None writes none.
    rounds : int
        How often everything is timed [-], >= 2.
    only : sequence of str
        Names of what is compared; none means all.
    largest : int
        Most elements in one call [-], >= 1.
    advanced : callable or None
        Told what is measured, in place of the progress bar on standard error.

    Returns
    -------
    int
        Exit code: 0 done, 130 stopped by Ctrl-C, with the finished comparisons kept. Times are shown, never judged.

    Raises
    ------
    UnknownChoice
        There is no such comparison.
    OutputUnwritable
        ``out`` cannot be written.

    Notes
    -----
    Accuracy and source: :func:`granular.speed.interleaved.measure`.
    """
    names = [comparison.name for comparison in catalogue()]
    wanted = [chosen(name, names, name="--only") for name in only] or names
    command = " ".join(["granular speed", *(f"--only {name}" for name in only)]
                       + ([f"--rounds {rounds}"] if rounds != ROUNDS else [])
                       + ([f"--largest {largest}"] if largest != SIZES[-1] else []))
    rows: list[Row] = []
    jobs = [job for job in _jobs(largest) if job[0].name in wanted]
    if out is not None:
        write(out, rows, command=command, rounds=rounds)  # a file that cannot be written is told before minutes pass
    try:
        for row in _measured(jobs, rounds, advanced):
            rows.append(row)
            if out is not None:
                write(out, rows, command=command, rounds=rounds)
    except KeyboardInterrupt:
        kept = "" if out is None else f"; {out} holds them"
        print(f"Stopped: {len(rows)} of {len(jobs)} comparisons are made{kept}.", file=sys.stderr)
        return INTERRUPTED
    _show(rows, rounds)
    return DONE


def _jobs(largest: int) -> Iterator[tuple[Comparison, int]]:
    for comparison in catalogue():
        sizes = SIZES if comparison.name in SCALED else (SLOW if comparison.name in TAKES_LONG else LARGE,)
        yield from ((comparison, size) for size in dict.fromkeys(min(size, largest) for size in sizes))


def _measured(jobs: Sequence[tuple[Comparison, int]], rounds: int,
              advanced: Callable[[str], None] | None) -> Iterator[Row]:
    from rich.console import Console
    from rich.progress import Progress

    with Progress(console=Console(stderr=True), transient=True, disable=advanced is not None) as progress:
        task = progress.add_task("", total=len(jobs) * (rounds + 1))
        for comparison, size in jobs:
            label = f"{comparison.name}, {size:,}"

            def step(label: str = label) -> None:
                progress.update(task, advance=1, description=label)
                if advanced is not None:
                    advanced(label)

            step()
            try:
                ways, failure = tuple(measure(comparison.ways(size), rounds=rounds, advanced=step)), None
            except ModuleNotFoundError as error:
                ways, failure = (), f"{error.name} is not installed"
            yield Row(name=comparison.name, title=comparison.title, goal=comparison.goal, size=size, ways=ways,
                      failure=failure)


def _show(rows: Sequence[Row], rounds: int) -> None:
    from rich.console import Console

    console = Console(highlight=False, markup=False, emoji=False)
    console.print("Time of one element over that of the first way, median of the rounds, and least over least.\n")
    for row in rows:
        console.print(f"{row.title}, {row.size:,} element{'' if row.size == 1 else 's'}", style="bold")
        if row.goal:
            console.print(f"  wanted: {row.goal}")
        console.print(f"  {row.failure}\n" if row.failure else _table(row))
    about = described()
    console.print(f"Measured in {rounds} rounds on {about.pop('processor')}: "
                  + ", ".join(f"{name} {value}" for name, value in about.items()), soft_wrap=True)


def _table(row: Row) -> Table:
    from rich.table import Table

    table = Table(box=None, pad_edge=False, padding=(0, 1), collapse_padding=True)
    table.add_column("  way", min_width=34)
    for heading in ("ratio", "least", "ns each", "error"):
        table.add_column(heading, justify="right", no_wrap=True)
    for way in row.ways:
        table.add_row(f"  {way.name}", f"{way.ratio:.3g}", f"{way.least:.3g}", f"{way.nanoseconds:.4g}",
                      "" if way.error is None else f"{way.error:.1e}")
    table.add_section()
    table.add_row("")
    return table
