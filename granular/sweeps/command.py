"""``granular sweep``: what the options mean, progress on standard error, and what became of it in a few lines."""

from __future__ import annotations

import sys
import textwrap
from collections import Counter
from pathlib import Path
from typing import TYPE_CHECKING

from granular.errors import BadOption
from granular.units import shown

if TYPE_CHECKING:
    from granular.sweeps.run import Ran

DONE, INTERRUPTED = 0, 130
"""Exit codes."""

COLUMNS = 74
"""Width of what is printed: what a page of the book shows side by side."""


def run_sweep_command(file: str, *, out: Path, invalid: str, workers: str | None, scheduler: str | None,
                      large: bool) -> tuple[str, int]:
    """Run a sweep as the command line asks for it.

    Parameters
    ----------
    file : str
        The sweep file.
    out : Path
        Folder of the store.
    invalid : str
        "error" or "nan".
    workers : str or None
        Number of processes.
    scheduler : str or None
        Address of a dask scheduler.
    large : bool
        Whether more than a million points are meant.

    Returns
    -------
    str
        What to print.
    int
        Exit code: 0 done, 130 stopped by Ctrl-C, with the finished chunks kept.

    Raises
    ------
    GranularError
        As ``granular.sweep``.

    Notes
    -----
    Source: the command line's interface.
    """
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TaskID, TextColumn, TimeRemainingColumn

    from granular.sweeps.definition import Sweep
    from granular.sweeps.run import run_sweep

    number = _workers(workers)
    sweep = Sweep.from_toml(file)
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TextColumn("points"),
               TimeRemainingColumn())
    with Progress(*columns, console=Console(stderr=True), transient=True) as progress:
        bars: dict[str, TaskID] = {}

        def advanced(what: str, more: int, of: int) -> None:
            if what not in bars:
                bars[what] = progress.add_task(what, total=of)
            progress.advance(bars[what], more)

        try:
            ran = run_sweep(sweep, out=out, invalid=invalid, workers=number, scheduler=scheduler, large=large,
                            advanced=advanced)
        except KeyboardInterrupt:
            ran = None
    if ran is None:
        print(f"Stopped; what is finished is kept in {out}. The same command goes on from there.", file=sys.stderr)
        return "", INTERRUPTED
    return _summary(ran, out), DONE


def _summary(ran: Ran, out: Path) -> str:
    """What was computed, and what was refused."""
    dataset = ran.dataset
    sizes = " x ".join(f"{dataset.sizes[name]} {name}" for name in dataset.refusal.dims)
    found = f", {ran.found} of them finished before" if ran.found else ""
    codes = Counter(code for code in dataset.refusal.values.ravel().tolist() if code)
    refused = [f"  {count} points refused with {code}; their values are empty" for code, count in sorted(codes.items())]
    return "\n".join([
        f"Wrote {out}: {dataset.refusal.size} points in {ran.chunks} {'chunk' if ran.chunks == 1 else 'chunks'}{found}",
        f"  {sizes}",
        textwrap.fill(", ".join(map(str, dataset.data_vars)), COLUMNS, initial_indent="  ", subsequent_indent="  "),
        *refused,
        f'Open it with granular.open_sweep("{out}")', ""])


def _workers(text: str | None) -> int | None:
    if text is None:
        return None
    if not (text.isascii() and text.isdigit() and 1 <= int(text[:6]) and len(text) <= 6):
        raise BadOption(f"--workers = {shown(text)}", allowed="allowed whole numbers from 1 to 999999",
                        remedy="Leave it out for as many as there are cores.")
    return int(text)
