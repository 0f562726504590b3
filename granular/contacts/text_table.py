"""Text files of contacts: one header line with the names of the columns, then one row a contact.

Columns are parted by commas, semicolons or tabs (CSV), or by white space, as scripts of YADE write them; a header line
may begin with ``#``, and so may comments before and below it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING

from granular.contacts.open_text import open_text
from granular.contacts.tables import ROWS, cells_of, is_row, line_of, parsed
from granular.errors import ContactColumnsMissing

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

_SEPARATORS = (";", "\t", ",")


class TextTable:
    """A text file with a header.

    Parameters
    ----------
    path : Path
        The file, gzip-compressed or not.
    name : str
        Its name for messages.

    Raises
    ------
    ContactColumnsMissing
        No line names the columns.
    ContactFileUnusable
        The file is damaged or no text.
    """

    def __init__(self, path: Path, name: str) -> None:
        """Read the header."""
        self._path, self._name = path, name
        with open_text(path, name) as lines:
            self._header_lines, header = _header(lines)
        self._separator = next((mark for mark in _SEPARATORS if mark in header), None)
        cells = cells_of(header, self._separator)
        self.columns: tuple[str, ...] = tuple(cells)
        if not header or all(_is_number(cell) for cell in cells):
            raise ContactColumnsMissing(
                f"{name} has no line that names its columns", allowed="needed: a first line such as "
                "id1,id2,l1,l2,l3,n1,n2,n3,kn,ks", remedy="Put the names of the columns in the first line.")

    def chunks(self, wanted: Sequence[str]) -> Iterator[Array]:
        """Read the columns some rows at a time; see ``ContactTable``."""
        places = [self.columns.index(name) for name in wanted]
        with open_text(self._path, self._name) as lines:
            line = self._header_lines
            for _ in islice(lines, line):
                pass
            while chunk := list(islice(lines, ROWS)):
                rows = [text if is_row(text) else "" for text in chunk] if "#" in "".join(chunk) else chunk
                yield parsed(rows, places, self.columns, separator=self._separator, file=self._name,
                             first_line=line + 1)
                line += len(chunk)

    def place_of(self, contact: int) -> str:
        """Tell its line; see ``ContactTable``."""
        with open_text(self._path, self._name) as lines:
            return line_of(lines, contact, first_line=self._header_lines + 1)


def _header(lines: Iterator[str]) -> tuple[int, str]:
    """How many lines there are up to the header, and the header itself.

    Of several lines that begin with ``#`` the last one before the numbers is the header, unless a plain line of names
    follows.
    """
    commented, last = "", 0
    for number, line in enumerate(lines, start=1):
        text = line.strip()
        if text.startswith("#"):
            commented, last = text.lstrip("#").strip(), number
        elif text:
            first = text.replace(";", " ").replace(",", " ").split()[:1]
            return (last, commented) if commented and first and _is_number(first[0]) else (number, text)
    return last, commented


def _is_number(cell: str) -> bool:
    try:
        float(cell)
    except ValueError:
        return False
    return True
