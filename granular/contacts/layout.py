"""Text that fits a console of any width: rows of numbers that fold between columns, words that break between pieces."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.console import Console, ConsoleOptions, RenderableType, RenderResult
    from rich.measure import Measurement

GAP = "  "
"""Between two columns, and between two pieces."""

INDENT = (0, 0, 0, 2)


@dataclass(frozen=True, slots=True)
class Pieces:
    """Short texts that stay whole; a line ends between two of them.

    Attributes
    ----------
    pieces : tuple of str
        What is to be said.
    """

    pieces: tuple[str, ...]

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
        """As many to a line as there is room for."""
        from rich.text import Text

        del console  # the width is all that matters
        line = ""
        for piece in self.pieces:
            longer = f"{line}{GAP}{piece}" if line else piece
            if line and len(longer) > options.max_width:
                yield Text(line)
                longer = piece
            line = longer
        yield Text(line)

    def __rich_measure__(self, console: Console, options: ConsoleOptions) -> Measurement:
        """The longest piece at least, all of them in one line at most."""
        from rich.measure import Measurement

        del console, options  # known without them
        return Measurement(max(map(len, self.pieces)), len(GAP.join(self.pieces)))


@dataclass(frozen=True, slots=True)
class Columns:
    """Rows of cells below each other, the first column to the left and all others to the right.

    Where they do not fit beside each other, groups of columns go below each other, each with the first column.

    Attributes
    ----------
    rows : tuple of tuple of str
        Cells, headings included.
    groups : tuple of int
        How many columns stay together, beginning with the second.
    """

    rows: tuple[tuple[str, ...], ...]
    groups: tuple[int, ...]

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
        """One table, or several where the console is narrow."""
        from rich.text import Text

        del console  # the width is all that matters
        for place, columns in enumerate(self._folded(options.max_width)):
            if place:
                yield ""
            yield Text("\n".join(self._lines(columns)), no_wrap=True, overflow="fold")

    def _folded(self, width: int) -> Iterator[list[int]]:
        """Numbers of the columns that stand beside each other."""
        together, room, first = [0], width - self._width(0), 1
        for size in self.groups:
            group = list(range(first, first + size))
            first += size
            wanted = sum(len(GAP) + self._width(column) for column in group)
            if len(together) > 1 and wanted > room:
                yield together
                together, room = [0], width - self._width(0)
            together, room = together + group, room - wanted
        yield together

    def _width(self, column: int) -> int:
        return max(len(row[column]) for row in self.rows)

    def _lines(self, columns: Sequence[int]) -> Iterator[str]:
        for row in self.rows:
            first, *others = ((row[column], self._width(column)) for column in columns)
            yield GAP.join([first[0].ljust(first[1]), *(cell.rjust(width) for cell, width in others)]).rstrip()


def title(text: str) -> RenderableType:
    """A heading.

    Parameters
    ----------
    text : str
        What it says.

    Returns
    -------
    renderable
        Bold where the console can.

    Notes
    -----
    Source: the look of the command line.
    """
    from rich.text import Text

    return Text(text, style="bold")


def facts(told: Mapping[str, str | Sequence[str]]) -> RenderableType:
    """Names and what they are, below each other.

    Parameters
    ----------
    told : mapping
        Name -> text, or pieces that stay whole; empty ones are left out.

    Returns
    -------
    renderable
        Two columns, of which the second wraps.

    Notes
    -----
    Source: the look of the command line.
    """
    from rich.padding import Padding
    from rich.table import Table
    from rich.text import Text

    grid = Table.grid(padding=(0, 2, 0, 0))
    for name, text in told.items():
        if text:
            grid.add_row(Text(name), Text(text, overflow="fold") if isinstance(text, str) else Pieces(tuple(text)))
    return Padding(grid, INDENT)


def columns(rows: Sequence[Sequence[str]], groups: Sequence[int] | None = None) -> RenderableType:
    """Rows of cells that fold between groups of columns.

    Parameters
    ----------
    rows : sequence of sequence of str
        Cells, headings included.
    groups : sequence of int, optional
        How many columns stay together, beginning with the second; each for itself by default.

    Returns
    -------
    renderable
        Indented.

    Notes
    -----
    Source: the look of the command line.
    """
    from rich.padding import Padding

    return Padding(Columns(tuple(map(tuple, rows)), tuple(groups or (1,) * (len(rows[0]) - 1))), INDENT)
