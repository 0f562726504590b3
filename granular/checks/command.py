"""The command ``granular check``: run all comparisons, print one table, fail on any miss."""

from __future__ import annotations

import json
import math
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING

from granular.checks.comparison import Comparison
from granular.checks.grouping import Row, rows
from granular.checks.run import table
from granular.hypothesis import Hypothesis
from granular.output import write_text
from granular.routes import axial, certified, closed_form

if TYPE_CHECKING:
    from rich.table import Table

AGREED, MISSED = 0, 1
"""Exit codes."""


def run_checks(*, json_out: Path | None = None) -> int:
    """Compare all numerics, print the outcome, and say whether everything agrees.

    Parameters
    ----------
    json_out : Path or None
        File for all comparisons as JSON; it is replaced only once it is complete.

    Returns
    -------
    int
        Exit code: 0 when everything agrees, 1 on any miss.

    Raises
    ------
    OutputUnwritable
        ``json_out`` cannot be written.

    Notes
    -----
    Accuracy: errors are counted in units in the last place of the certified value. Source: the stored certified
    cases, the symbolic limits, and ball arithmetic where it is installed.
    """
    from rich.console import Console

    with Console(stderr=True).status("Comparing") as status:
        comparisons = table(started=lambda part: status.update(f"Comparing: {part}"))
    if json_out is not None:
        write_text(json_out, json.dumps([_plain(comparison) for comparison in comparisons], indent=1) + "\n")
    misses = [comparison for comparison in comparisons if not comparison.agrees]
    console = Console(highlight=False, markup=False, emoji=False)
    console.print(_rendered(rows(comparisons)))
    for miss in misses:
        console.print(f"MISS: {miss.group}, {miss.case}, {miss.hypothesis}, {miss.route}: {miss.component} is off by "
                      f"{miss.error:.3g} {miss.unit}, allowed {miss.allowed:.3g}")
    if not certified.available():
        console.print("The certified voice is missing, and with it the random fabrics: "
                      "pip install 'granular[certified]'")
    console.print(_summary(comparisons, len(misses)), soft_wrap=True)
    return MISSED if misses else AGREED


def _plain(comparison: Comparison) -> dict[str, object]:
    """A comparison as JSON takes it; an infinite error becomes null."""
    content = asdict(comparison) | {"agrees": comparison.agrees}
    return {key: None if value == math.inf else value for key, value in content.items()}


def _rendered(content: list[Row]) -> Table:
    from rich.table import Table

    table_ = Table(title="Error/allowed in units in the last place (sampled: in standard errors)",
                   title_justify="left",
                   box=None, pad_edge=False, padding=(0, 1), collapse_padding=True, header_style="bold")
    for heading in ("case (members)", "route", "kinematic", "static", "verdict"):
        table_.add_column(heading, no_wrap=True)
    shown = ""
    for row in content:
        table_.add_row("" if row.group == shown else f"{row.group} ({row.cases})", row.route,
                       *(_cell(row.worst.get(hypothesis)) for hypothesis in Hypothesis),
                       f"{row.misses} MISSED" if row.misses else "agrees", style="bold red" if row.misses else None)
        shown = row.group
    return table_


def _cell(comparison: Comparison | None) -> str:
    if comparison is None:
        return "-"
    return f"{_short(comparison.error)}/{_short(comparison.allowed)} {comparison.component}"


def _short(units: float) -> str:
    """A number of units in at most five characters."""
    return f"{units:.2g}" if units < 100 or units >= 1e5 else f"{units:.0f}"


def _summary(comparisons: list[Comparison], misses: int) -> str:
    chosen = [comparison for comparison in comparisons if comparison.route in (closed_form.NAME, axial.NAME)]
    worst = max(chosen, key=lambda comparison: comparison.error)
    return (f"{len(comparisons)} comparisons, {misses} {'miss' if misses == 1 else 'misses'}, worst "
            f"{worst.error:.2f} units in the last place by closed_form and axial "
            f"({worst.component}, {worst.route}, {worst.group})")
