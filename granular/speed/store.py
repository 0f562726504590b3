"""The data file of the speed study, and its words."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from granular.cost.machine import machine
from granular.output import write_text
from granular.speed.interleaved import Measured

DIGITS_SHOWN = 4
"""Significant digits in the file [-]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Row:
    """One comparison at one number of elements.

    Attributes
    ----------
    name, title, goal : str
        Of the comparison.
    size : int
        Number of elements that the fast ways do in one call [-].
    ways : tuple of Measured
        In order; the first is what the others are compared with.
    failure : str or None
        Why there are none, in words.
    """

    name: str
    title: str
    goal: str
    size: int
    ways: tuple[Measured, ...]
    failure: str | None


def described() -> dict[str, str]:
    """Describe the machine and the versions that matter here, without naming the machine.

    Returns
    -------
    dict
        Processor, cores, system, versions.
    """
    return machine(("granular", "numpy", "numba", "scipy", "python-flint", "rockphypy", "elasticipy"))


def write(path: Path, rows: list[Row], *, command: str, rounds: int) -> None:
    """Replace the file by what has been measured.

    Parameters
    ----------
    path : Path
        JSON file.
    rows : list of Row
        All comparisons.
    command : str
        What measures them again.
    rounds : int
        How often everything was timed [-].

    Raises
    ------
    OutputUnwritable
        It cannot be written; what was there stays.
    """
    lines = ",\n  ".join(json.dumps(_plain(row), allow_nan=False) for row in rows)
    head = {"command": command, "rounds": rounds, "machine": described()}
    text = "".join(f'"{key}": {json.dumps(value)},\n ' for key, value in head.items())
    write_text(path, "{" + text + f'"rows": [\n  {lines}]' + "}\n")


def _plain(row: Row) -> dict[str, Any]:
    content = asdict(row)
    for way in content["ways"]:
        for name, value in way.items():
            if isinstance(value, float):
                way[name] = float(f"{value:.{DIGITS_SHOWN}g}")
    return content
