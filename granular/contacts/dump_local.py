"""``dump local`` files of LAMMPS and LIGGGHTS: time steps one after the other, each with a header of its own."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING

from granular.contacts.open_text import open_text
from granular.contacts.tables import ROWS, line_of, parsed
from granular.errors import BadOption, ContactFileUnusable
from granular.units import shown

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

ITEM = "ITEM:"
"""How each header line begins."""


@dataclass(frozen=True, slots=True)
class _Step:
    """Where the entries of one time step stand."""

    timestep: int
    first_line: int
    entries: int
    columns: tuple[str, ...]


class DumpLocal:
    """A dump of local quantities.

    Parameters
    ----------
    path : Path
        The file, gzip-compressed or not.
    name : str
        Its name for messages.
    step : int, optional
        The time step that is wanted; the last one by default.

    Raises
    ------
    ContactFileUnusable
        The file ends within a time step, or a header is not what these files have.
    BadOption
        There is no such time step.
    """

    def __init__(self, path: Path, name: str, step: int | None = None) -> None:
        """Find the time steps; nothing but headers is kept."""
        self._path, self._name = path, name
        with open_text(path, name) as lines:
            steps = list(_steps(lines, name))
        if not steps:
            raise ContactFileUnusable(f"{name} has no time step", allowed="needed: ITEM: TIMESTEP and what follows it",
                                      remedy="Name a file that dump local has written.")
        self.timesteps: tuple[int, ...] = tuple(found.timestep for found in steps)
        chosen = [found for found in steps if step is None or found.timestep == step]
        if not chosen:
            raise BadOption(f"--step = {step}", allowed=f"{name} has {_listed(self.timesteps)}",
                            remedy="Name one of these, or leave --step out for the last one.")
        self._chosen = chosen[-1]
        self.columns: tuple[str, ...] = self._chosen.columns

    def chunks(self, wanted: Sequence[str]) -> Iterator[Array]:
        """Read the columns some rows at a time; see ``ContactTable``."""
        places, step = [self.columns.index(name) for name in wanted], self._chosen
        with open_text(self._path, self._name) as lines:
            for _ in islice(lines, step.first_line - 1):
                pass
            for start in range(0, step.entries, ROWS):
                rows = list(islice(lines, min(ROWS, step.entries - start)))
                yield parsed(rows, places, self.columns, separator=None, file=self._name,
                             first_line=step.first_line + start)

    def place_of(self, contact: int) -> str:
        """Tell its line; see ``ContactTable``."""
        with open_text(self._path, self._name) as lines:
            return line_of(lines, contact, first_line=self._chosen.first_line)


def _steps(lines: Iterator[str], name: str) -> Iterator[_Step]:
    """Go through a file from header to header."""
    number, timestep, entries = 0, None, None

    def following() -> str:
        nonlocal number
        number += 1
        return next(lines, "")

    while line := following():
        item = line.strip()
        if not item:
            continue
        if item == "ITEM: TIMESTEP":
            timestep = _whole(following(), name, number)
        elif item.startswith("ITEM: NUMBER OF"):
            entries = _whole(following(), name, number)
        elif item.startswith("ITEM: ENTRIES"):
            if timestep is None or entries is None:
                raise _unusual(item, name, number, "TIMESTEP and NUMBER OF ENTRIES before ENTRIES")
            yield _Step(timestep, number + 1, entries, tuple(item.split()[2:]))
            found = sum(1 for _ in islice(lines, entries))
            number += found
            if found < entries:
                raise ContactFileUnusable(
                    f"{name} ends after {found} of {entries} entries of time step {timestep}",
                    allowed="needed: a whole file", remedy="Copy it again, or let the simulation finish writing.")
            timestep = entries = None
        elif item.startswith("ITEM: BOX BOUNDS"):
            for _ in range(3):
                following()
        elif item.startswith(ITEM):
            following()  # such as UNITS and TIME
        else:
            raise _unusual(item, name, number, "a line that begins with ITEM:")


def _whole(line: str, name: str, number: int) -> int:
    try:
        return int(line)
    except ValueError:
        raise _unusual(line.strip(), name, number, "a whole number") from None


def _unusual(text: str, name: str, number: int, wanted: str) -> ContactFileUnusable:
    return ContactFileUnusable(f"{name}, line {number} is {shown(text)}", allowed=f"needed there: {wanted}",
                               remedy="Name a file that dump local has written, whole.")


def _listed(steps: Sequence[int]) -> str:
    few = ", ".join(map(str, steps[:10]))
    return f"the time step{'' if len(steps) == 1 else 's'} {few}" + (f" and more up to {steps[-1]}"
                                                                    if len(steps) > 10 else "")
