"""What a reader of contact files gives: the names of its columns, and their numbers some rows at a time."""

from __future__ import annotations

import csv
import math
from collections.abc import Iterator, Sequence
from itertools import islice
from operator import methodcaller
from typing import TYPE_CHECKING, Protocol

from granular.errors import ContactFileUnusable
from granular.units import shown

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

ROWS = 1 << 15
"""Rows read at a time."""

_MISSING = {"", "na", "n/a", "nan", "-nan", "null", "none", "-nan(ind)"}
"""What programs write where they have no number."""


class ContactTable(Protocol):
    """A file of contacts, opened.

    Attributes
    ----------
    columns : tuple of str
        Names in the file.
    """

    columns: tuple[str, ...]

    def chunks(self, wanted: Sequence[str]) -> Iterator[Array]:
        """Read the columns some rows at a time.

        Parameters
        ----------
        wanted : sequence of str
            Names in the file.

        Returns
        -------
        iterator of (k, n) array
            One column a row, as the file has them [its own units]; NaN where a number is missing.
        """
        ...

    def place_of(self, contact: int) -> str:
        """Where a contact stands, for messages.

        Parameters
        ----------
        contact : int
            Its number in the list, from 1.

        Returns
        -------
        str
            Such as "line 7" of a text, "row 6" of a table without lines.
        """
        ...


def line_of(lines: Iterator[str], contact: int, *, first_line: int) -> str:
    """Count lines up to a contact; only a refusal needs it.

    Parameters
    ----------
    lines : iterator of str
        The file from its beginning.
    contact : int
        Number of the contact, from 1.
    first_line : int
        Where its rows begin, from 1.

    Returns
    -------
    str
        "line" and its number.

    Notes
    -----
    Source: what ``parsed`` passes over.

    Examples
    --------
    >>> line_of(iter(["a,b", "1,2", "", "3,4"]), 2, first_line=2)
    'line 4'
    """
    rows = (number for number, line in enumerate(islice(lines, first_line - 1, None), start=first_line) if is_row(line))
    return f"line {next(islice(rows, contact - 1, None))}"


def is_row(line: str) -> bool:
    """Whether a line below the header holds a contact: it is neither empty nor a comment.

    Parameters
    ----------
    line : str
        A line of text.

    Returns
    -------
    bool
        As said.

    Notes
    -----
    Source: the format of text tables.

    Examples
    --------
    >>> is_row("1,2"), is_row("# a remark"), is_row("  ")
    (True, False, False)
    """
    return bool(line.strip()) and not line.startswith("#")


def cells_of(line: str, separator: str | None) -> list[str]:
    """Part a line into its cells, without the quotes around them.

    Parameters
    ----------
    line : str
        A line of text.
    separator : str or None
        What parts the columns; None for white space.

    Returns
    -------
    list of str
        Its cells.

    Notes
    -----
    Source: CSV, in which a quoted cell may hold the separator.

    Examples
    --------
    >>> cells_of('"n1", 2,"glass, new"', ",")
    ['n1', '2', 'glass, new']
    """
    if separator is None or '"' not in line:
        return [cell.strip().strip('"') for cell in line.split(separator)]
    try:
        return [cell.strip() for cell in next(csv.reader([line], delimiter=separator, skipinitialspace=True))]
    except (csv.Error, StopIteration):  # a cell beyond all measure
        return line.split(separator)


def parsed(lines: Sequence[str], places: Sequence[int], columns: Sequence[str], *, separator: str | None, file: str,
           first_line: int) -> Array:
    """Turn lines of text into numbers.

    Parameters
    ----------
    lines : sequence of str
        Some rows; empty ones are passed over.
    places : sequence of int
        Which columns are wanted, from 0.
    columns : sequence of str
        Names of all columns.
    separator : str or None
        What parts the columns; None for white space.
    file : str
        Name of the file, for messages.
    first_line : int
        Number of the first of these lines in the file, from 1.

    Returns
    -------
    (k, n) array
        The wanted columns [their own units].

    Raises
    ------
    ContactFileUnusable
        A row has another number of columns than the header, or a cell is no number.

    Notes
    -----
    Accuracy: numbers are rounded once. Source: a format of rows and columns.

    Examples
    --------
    >>> parsed(["1,2,3", "4,,6"], [0, 1], ["a", "b", "c"], separator=",", file="x.csv", first_line=2).tolist()
    [[1.0, 4.0], [2.0, nan]]
    """
    import numpy as np

    if separator is not None and '"' in "".join(lines):
        lines = [separator.join(cell.replace(separator, " ") for cell in cells_of(line, separator)) for line in lines]
    _refuse_uneven(lines, len(columns), separator, file, first_line)
    if not any(line.strip() for line in lines):
        return np.empty((len(places), 0))
    try:
        rows = np.loadtxt(lines, delimiter=separator, usecols=list(places), ndmin=2, comments=None)
    except ValueError:
        rows = np.array([[_number(line, place, columns, separator, f"{file}, line {number}") for place in places]
                         for number, line in enumerate(lines, start=first_line) if line.strip()])
    return np.ascontiguousarray(rows.T)


def _refuse_uneven(lines: Sequence[str], columns: int, separator: str | None, file: str, first_line: int) -> None:
    """Refuse rows of another length than the header; most often all are alike, which is seen at a glance."""
    if separator is not None and set(map(methodcaller("count", separator), lines)) == {columns - 1}:
        return
    for number, line in enumerate(lines, start=first_line):
        cells = line.count(separator) + 1 if separator is not None else len(line.split())
        if cells != columns and line.strip():
            raise ContactFileUnusable(
                f"{file}, line {number} has {cells} column{'' if cells == 1 else 's'}",
                allowed=f"the header names {columns}",
                remedy="The file may have been cut off while it was written: copy or export it again.")


def _number(line: str, place: int, columns: Sequence[str], separator: str | None, where: str) -> float:
    cell = line.split(separator)[place].strip()
    try:
        if "_" not in cell:  # 1_0 is a number to Python, and to no other program
            return float(cell)
    except ValueError:
        if cell.lower() in _MISSING:
            return math.nan
    raise ContactFileUnusable(f"{where}: {columns[place]} is {shown(cell)}", allowed="allowed a number",
                              remedy="Correct that cell, or say which column is which with --column.")
