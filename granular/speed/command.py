"""The command ``granular speed``: measure comparison after comparison, keep what is finished, print a table."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path

from granular.fields import chosen
from granular.speed.comparisons import SIZES, Comparison, catalogue
from granular.speed.interleaved import Way, measure
from granular.speed.peers.agreement import agreements
from granular.speed.shown import show
from granular.speed.store import Row, Study, described, write

DONE, INTERRUPTED = 0, 130
"""Exit codes."""

ROUNDS = 9
"""How often everything is timed at most, unless told otherwise [-]."""

LARGEST = max(SIZES)
"""Most elements in one call unless told otherwise [-]."""

def run_speed(*, out: Path | None = None, rounds: int = ROUNDS, only: Sequence[str] = (), largest: int = LARGEST,
              advanced: Callable[[str], None] | None = None) -> int:
    """Measure, print a table, and write the data after every comparison.

    Parameters
    ----------
    out : Path or None
        JSON file for the data; it is replaced as a whole each time. None writes none.
    rounds : int
        How often everything is timed at most [-], >= 2.
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
    study = Study(command=_command(only, rounds, largest), rounds=rounds, machine=described() | _load(), rows=[],
                  agreements=[])
    jobs = [job for job in _jobs(largest) if job[0].name in wanted]

    def keep() -> None:
        if out is not None:
            write(out, study)

    keep()  # a file that cannot be written is told before minutes pass
    if not only:
        study = replace(study, agreements=agreements())
    try:
        for row in _measured(jobs, rounds, advanced):
            study = replace(study, rows=[*study.rows, row])
            keep()
    except KeyboardInterrupt:
        kept = "" if out is None else f"; {out} holds them"
        print(f"Stopped: {len(study.rows)} of {len(jobs)} comparisons are made{kept}.", file=sys.stderr)
        return INTERRUPTED
    show(study)
    return DONE


def _command(only: Sequence[str], rounds: int, largest: int) -> str:
    return " ".join(["granular speed", *(f"--only {name}" for name in only),
                     *([f"--rounds {rounds}"] if rounds != ROUNDS else []),
                     *([f"--largest {largest}"] if largest != LARGEST else [])])


def _load() -> dict[str, str]:
    """What else the machine does before anything is measured."""
    return {"load": f"{os.getloadavg()[0]:.1f}"} if hasattr(os, "getloadavg") else {}


def _jobs(largest: int) -> Iterator[tuple[Comparison, int]]:
    for comparison in catalogue():
        yield from ((comparison, size) for size in dict.fromkeys(min(size, largest) for size in comparison.sizes))


def _measured(jobs: Sequence[tuple[Comparison, int]], rounds: int,
              advanced: Callable[[str], None] | None) -> Iterator[Row]:
    from rich.console import Console
    from rich.progress import Progress

    with Progress(console=Console(stderr=True), transient=True, disable=advanced is not None) as progress:
        task = progress.add_task("", total=len(jobs))
        for comparison, size in jobs:
            label = f"{comparison.name}, {size:,}"
            progress.update(task, description=label)
            if advanced is not None:
                advanced(label)
            most = rounds if comparison.rounds is None else min(rounds, comparison.rounds)
            try:
                ways, failure = tuple(measure(_asked(comparison, size), rounds=most)), None
            except ModuleNotFoundError as error:
                ways, failure = (), f"{error.name} is not installed"
            progress.update(task, advance=1)
            yield Row(name=comparison.name, title=comparison.title, each=comparison.each, errors=comparison.errors,
                      size=size, ways=ways, failure=failure)


def _asked(comparison: Comparison, size: int) -> list[Way]:
    """The ways of a comparison; bounds hold for its own numbers of elements alone."""
    ways = comparison.ways(size)
    return ways if size in comparison.sizes else [replace(way, wanted=None, memory_wanted=None) for way in ways]
