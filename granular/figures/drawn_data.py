"""The numbers behind a figure, taken out of the figure itself, as rows of a CSV file."""

from __future__ import annotations

import csv
import io
import math
import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

LIMIT = 300_000
"""Most bytes of a file; beyond it the longest series lose points evenly, and the file's link says so."""

DIGITS = 8
"""Significant digits of a number."""

Cell = float | str | None


@dataclass(frozen=True, slots=True)
class Series:
    """What one mark, line or surface of a figure shows.

    Attributes
    ----------
    panel, name : str
        Where it stands and what it is called there.
    columns : dict of str to sequence of float, str or None
        Numbers by the title of their axis, all of one length; a word where the axis has words, None at a gap.
    """

    panel: str
    name: str
    columns: dict[str, Sequence[Cell]]

    def __len__(self) -> int:
        """How many points there are."""
        return len(next(iter(self.columns.values()), ()))


@dataclass(frozen=True, slots=True)
class DrawnData:
    """The rows of a figure, few enough for a file.

    Attributes
    ----------
    header : tuple of str
        ``panel``, ``series``, then the axes.
    rows : tuple of tuple of str
        One a point; empty cells where a series has no such axis.
    most : int
        Series with more points than this were thinned evenly to so many [-]; 0 where none was.
    """

    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    most: int = 0

    def __bool__(self) -> bool:
        """Whether anything was drawn that has numbers."""
        return bool(self.rows)

    @property
    def csv(self) -> str:
        """The file."""
        text = io.StringIO()
        writer = csv.writer(text, lineterminator="\n")
        writer.writerows([self.header, *self.rows])
        return text.getvalue()


def drawn_data(figure: Any, *, limit: int = LIMIT) -> DrawnData:
    """Take the numbers out of a figure.

    Parameters
    ----------
    figure : matplotlib.figure.Figure or plotly.graph_objects.Figure
        What is drawn.
    limit : int
        Most bytes of the file.

    Returns
    -------
    DrawnData
        Rows in the order in which the figure was drawn; the same figure gives the same rows.

    Notes
    -----
    Source: lines, points, areas, bars, maps, level curves and surfaces that stand in the units of their axes; numbers
    with 8 digits. Words, arrows and what is placed by the page rather than by its value are left out.
    """
    from granular.figures.drawn_matplotlib import matplotlib_series
    from granular.figures.drawn_plotly import plotly_series

    read = plotly_series if hasattr(figure, "to_plotly_json") else matplotlib_series
    return as_rows(list(read(figure)), limit=limit)


def as_rows(found: Sequence[Series], *, limit: int = LIMIT) -> DrawnData:
    """Put series below one another.

    Parameters
    ----------
    found : sequence of Series
        In the order of the file.
    limit : int
        Most bytes of the file; the longest series lose points evenly until it holds.

    Returns
    -------
    DrawnData
        Of all series.

    Notes
    -----
    Source: a header of all titles in the order of their first use.

    Examples
    --------
    >>> print(as_rows([Series("1", "fn", {"beta [deg]": (0.0, 90.0), "fn [-]": (1 / 3, "none")})]).csv)
    panel,series,beta [deg],fn [-]
    1,fn,0,0.33333333
    1,fn,90,none
    <BLANKLINE>
    """
    titles = tuple(dict.fromkeys(title for series in found for title in series.columns))
    header = ("panel", "series", *titles)
    longest = max(map(len, found), default=0)
    most = longest
    data = DrawnData(header, tuple(_rows(found, titles, most)))
    while (size := len(data.csv.encode())) > limit and most > 2:
        most = max(2, min(most - 1, int(0.98 * most * limit / size)))
        data = DrawnData(header, tuple(_rows(found, titles, most)), most)
    return data


def _rows(found: Iterable[Series], titles: Sequence[str], most: int) -> Iterator[tuple[str, ...]]:
    for series in found:
        columns = [series.columns.get(title) for title in titles]
        for place in _kept(len(series), most):
            yield (series.panel, series.name, *("" if column is None else _written(column[place])
                                                for column in columns))


def _kept(length: int, most: int) -> Iterable[int]:
    """Places of the points that are kept, both ends among them."""
    return range(length) if length <= most else (round(k * (length - 1) / (most - 1)) for k in range(most))


def _written(value: Cell) -> str:
    if isinstance(value, str):
        return value
    number = math.nan if value is None else float(value)
    return f"{number + 0.0:.{DIGITS}g}" if math.isfinite(number) else ""


_DROPPED = re.compile(r"\\(?:mathrm|mathbf|mathit|text|boldsymbol|left|right|bigl|bigr|[!])|</?(?:b|i|sub|sup)>|[${}]")
_SIGNS = {r"\langle": "<", r"\rangle": ">", r"\times": "x", r"\cdot": " ", r"\ge": ">=", r"\le": "<=",
          r"\,": " ", r"\;": " ", r"\:": " ", r"\ ": " ", r"\circ": "deg",
          r"\degree": " deg", "−": "-", "–": "-", "<br>": " "}


def plain_title(text: str) -> str:
    r"""Write the title of an axis or a series without markup.

    Parameters
    ----------
    text : str
        As matplotlib or plotly takes it.

    Returns
    -------
    str
        Letters, digits and signs of the keyboard, Greek letters by name or as themselves.

    Notes
    -----
    Source: the few marks that this package's figures use.

    Examples
    --------
    >>> plain_title(r"$C_{1111}/C_{3333}$ [–]"), plain_title(r"angle $\beta$"), plain_title("force f<sub>n</sub>")
    ('C_1111/C_3333 [-]', 'angle beta', 'force fn')
    """
    for sign, written in _SIGNS.items():
        text = re.sub(re.escape(sign) + r"(?![a-z])" * sign[-1].isalpha(), written.replace("\\", r"\\"), text)
    text = re.sub(r"\\frac\{([^{}]*)\}\{([^{}]*)\}", r"\1/\2", text)
    return " ".join(_DROPPED.sub("", text).replace("\\", "").split())
