"""Pieces of a text report: titles, grids, aligned numbers, and units that are easy to read."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.console import RenderableType

_PREFIXES = ((1e10, 1e9, "GPa"), (1e6, 1e6, "MPa"), (1e3, 1e3, "kPa"))
_INDENT = (0, 0, 0, 2)


def title(text: str) -> RenderableType:
    """Heading of a block.

    Parameters
    ----------
    text : str
        The heading.

    Returns
    -------
    renderable
        For a console.

    Notes
    -----
    Source: the look of the reports.
    """
    from rich.text import Text

    return Text(text, style="bold")


def lines(*texts: str) -> RenderableType:
    """Lines below each other, indented.

    Parameters
    ----------
    *texts : str
        The lines.

    Returns
    -------
    renderable
        For a console.

    Notes
    -----
    Source: the look of the reports.
    """
    from rich.padding import Padding
    from rich.text import Text

    return Padding(Text("\n".join(texts)), _INDENT)


def grid(rows: Iterable[tuple[str, ...]]) -> RenderableType:
    """Columns without rules, indented.

    Parameters
    ----------
    rows : iterable of tuple of str
        The cells.

    Returns
    -------
    renderable
        For a console.

    Notes
    -----
    Source: the look of the reports.
    """
    from rich.padding import Padding
    from rich.table import Table
    from rich.text import Text

    table = Table.grid(padding=(0, 2, 0, 0))
    for row in rows:
        table.add_row(*(Text(cell) for cell in row))
    return Padding(table, _INDENT)


def facts(texts: Mapping[str, str]) -> RenderableType:
    """Names and what there is to say about each; those without a text are left out.

    Parameters
    ----------
    texts : mapping
        Name -> text.

    Returns
    -------
    renderable
        For a console.

    Notes
    -----
    Source: the look of the reports.
    """
    return grid((name, text) for name, text in texts.items() if text)


def aligned(numbers: Iterable[str]) -> list[str]:
    """Pad so that decimal points stand below each other.

    Parameters
    ----------
    numbers : iterable of str
        Written numbers.

    Returns
    -------
    list of str
        All of one length.

    Notes
    -----
    Source: the look of the reports.

    Examples
    --------
    >>> aligned(["1.5", "10.25"])
    [' 1.5 ', '10.25']
    """
    parts = [number.partition(".") for number in numbers]
    left = max(len(whole) for whole, _, _ in parts)
    right = max(len(rest) for _, _, rest in parts)
    return [f"{whole:>{left}}{point or ' '}{rest:<{right}}" for whole, point, rest in parts]


def pressure(value: float) -> str:
    """Write a pressure with seven digits.

    Parameters
    ----------
    value : float
        The pressure [Pa].

    Returns
    -------
    str
        Number and unit.

    Notes
    -----
    Source: the look of the reports.

    Examples
    --------
    >>> pressure(5.568e8)
    '556.8 MPa'
    """
    size, unit = unit_for(value)
    return f"{value / size:.7g} {unit}"


def unit_for(largest: float) -> tuple[float, str]:
    """A unit in which the largest value is easy to read.

    Parameters
    ----------
    largest : float
        The value [Pa].

    Returns
    -------
    tuple of float and str
        The unit [Pa], and its name.

    Notes
    -----
    Source: the look of the reports.

    Examples
    --------
    >>> unit_for(2e6)
    (1000000.0, 'MPa')
    """
    for least, size, unit in _PREFIXES:
        if least <= largest < 1e16:
            return size, unit
    return 1.0, "Pa"
