"""The data file of the speed study, and its records."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from granular.cost.machine import machine
from granular.output import write_text
from granular.speed.interleaved import Measured
from granular.speed.peers.agreement import Agreement

DIGITS_SHOWN = 4
"""Significant digits of a time in the file [-]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Row:
    """One comparison at one number of elements.

    Attributes
    ----------
    name, title, each, errors : str
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
    each: str
    errors: str
    size: int
    ways: tuple[Measured, ...]
    failure: str | None


@dataclass(frozen=True, slots=True, kw_only=True)
class Study:
    """One run of ``granular speed``.

    Attributes
    ----------
    command : str
        What measures it again.
    rounds : int
        How often everything was timed at most [-].
    machine : mapping
        Processor, cores, system, versions, load.
    rows : sequence of Row
        What was measured.
    agreements : sequence of Agreement
        Numbers of other packages beside what they are meant to be.
    """

    command: str
    rounds: int
    machine: Mapping[str, str]
    rows: Sequence[Row]
    agreements: Sequence[Agreement]

    def of(self, name: str) -> list[Row]:
        """Rows of one comparison that gave times, by the number of elements.

        Parameters
        ----------
        name : str
            The comparison.

        Returns
        -------
        list of Row
            Fewest elements first.
        """
        return sorted((row for row in self.rows if row.name == name and row.ways), key=lambda row: row.size)


def described() -> dict[str, str]:
    """Describe the machine and the versions that matter here, without naming the machine.

    Returns
    -------
    dict
        Processor, cores, system, versions.
    """
    return machine(("granular", "numpy", "numba", "scipy", "pyarrow", "python-flint", "rockphypy", "elasticipy"))


def write(path: Path, study: Study) -> None:
    """Replace the file by what has been measured.

    Parameters
    ----------
    path : Path
        JSON file.
    study : Study
        All of it.

    Raises
    ------
    OutputUnwritable
        It cannot be written; what was there stays.
    """
    lines = ",\n  ".join(json.dumps(_plain(row), allow_nan=False) for row in study.rows)
    others = ",\n  ".join(json.dumps(asdict(one), allow_nan=False) for one in study.agreements)
    head = {"command": study.command, "rounds": study.rounds, "machine": dict(study.machine)}
    text = "".join(f'"{key}": {json.dumps(value)},\n ' for key, value in head.items())
    write_text(path, "{" + text + f'"rows": [\n  {lines}],\n "agreements": [\n  {others}]' + "}\n")


def read(path: str | Path) -> Study:
    """Read the file that ``granular speed`` wrote.

    Parameters
    ----------
    path : str or path-like
        The file.

    Returns
    -------
    Study
        Its content as records.

    Notes
    -----
    Accuracy: four digits of times, as written. Source: the file; one of another format is refused by the records.
    """
    content = json.loads(Path(path).read_text(encoding="utf-8"))
    rows = [Row(**row | {"ways": tuple(Measured(**way) for way in row["ways"])}) for row in content.pop("rows")]
    agreements = [Agreement(**one) for one in content.pop("agreements")]
    return Study(**content, rows=rows, agreements=agreements)


def _plain(row: Row) -> dict[str, Any]:
    content = asdict(row)
    for way in content["ways"]:
        for name, value in way.items():
            if isinstance(value, float):
                way[name] = float(f"{value:.{DIGITS_SHOWN}g}")
    return content
