"""Text that a page shows: boxes and tables, as MyST, with the same rows as a CSV file to take away."""

from __future__ import annotations

import base64
import csv
import io
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from html import escape
from typing import Protocol


class Shown(Protocol):
    """Anything that a notebook can show as Markdown."""

    def _repr_markdown_(self) -> str: ...


@dataclass(frozen=True, slots=True)
class Markup:
    """MyST text that a cell shows as if it stood in the page."""

    text: str

    def _repr_markdown_(self) -> str:
        return self.text


class ShownAsHtml(Protocol):
    """Anything that a notebook can show as HTML."""

    def _repr_html_(self) -> str: ...


@dataclass(frozen=True, slots=True)
class Described:
    """An interactive figure with words for readers who cannot see it."""

    figure: ShownAsHtml
    words: str

    def _repr_html_(self) -> str:
        return f'<div role="figure" aria-label="{escape(self.words)}">{self.figure._repr_html_()}</div>'


def boxed(title: str, *parts: Shown) -> Markup:
    """Put parts into the box in which a page states its result."""
    body = "\n\n".join(part._repr_markdown_() for part in parts)
    return Markup(f"::::::{{admonition}} {title}\n:class: result\n\n{body}\n\n::::::\n")


def table(
    header: Sequence[str], rows: Iterable[Sequence[str]], *, label: str, caption: str,
    align: str = "", take_away: str = "", taken: Sequence[Sequence[str]] = (), look: str = "",
) -> Markup:
    """Number a table so that pages can refer to it.

    Parameters
    ----------
    header : sequence of str
        Column heads.
    rows : iterable of sequence of str
        Cells as they shall appear.
    label, caption : str
        Name to refer to, and what the table shows.
    align : str
        One letter a column, ``l`` or ``r``; left when absent.
    take_away : str
        Name of a CSV file with the same rows, offered below the table. When empty, it is named by the label, and
        there is none if no cell starts with a number: an index of words.
    taken : sequence of sequence of str
        Header and rows of that file where a cell of the table holds more than one value.
    look : str
        Class of the table in the style sheet.
    """
    kept = [list(row) for row in rows]
    rule = [":---" if side == "l" else "---:" for side in align or "l" * len(header)]
    lines = [header, rule, *kept]
    grid = "\n".join("| " + " | ".join(line) + " |" for line in lines)
    first, *others = taken or ([bare(cell) for cell in line] for line in (header, *kept))
    numeric = any(_NUMBER.match(bare(cell)) for row in kept for cell in row)
    name = take_away or (f"{label.removeprefix('tab-').replace('-', '_')}.csv" if numeric else "")
    link = _csv_link(name, first, others) if name else ""
    options = f":name: {label}\n" + (f":class: {look}\n" if look else "")
    return Markup(f":::{{table}} {caption}\n{options}\n{grid}\n\n:::\n{link}")


def _csv_link(name: str, header: Sequence[str], rows: Iterable[Sequence[str]], what: str = "these rows") -> str:
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(header)
    writer.writerows(rows)
    return f'\n<p class="take-away">{file_link(name, text.getvalue(), f"{what} as {name}")}</p>\n'


def file_link(name: str, content: str, words: str, *, kind: str = "text/csv") -> str:
    """Link to a file that the page itself holds."""
    data = base64.b64encode(content.encode()).decode()
    return f'<a download="{name}" href="data:{kind};base64,{data}">{words}</a>'


_NUMBER = re.compile(r"[+-]?\d")
_ROLE = re.compile(r"\{[a-z:]+\}`([^`<]*?)(?:\s*<([^`>]*)>)?`")
_LINK = re.compile(r"\[([^\]]*)\]\(([^)]*)\)")
_POWER = re.compile(r"(?:\\times|\\cdot|·|×)\s*10\^\{?([-+−]?\d+)\}?")
_RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
_FRACTION = re.compile(r"\\[td]?frac\{([^{}]*)\}\{([^{}]*)\}")
_BARE = {"<br>": "; ", "−": "-", "–": "-", "\u202f": "", "\N{NO-BREAK SPACE}": " ", "\\%": "%"}


def bare(cell: str) -> str:
    """Write a cell of a table without markup, so that another program can read its numbers."""
    cell = _LINK.sub(lambda found: found[1] or found[2], _ROLE.sub(r"\1", cell))
    for shown, written in _BARE.items():
        cell = cell.replace(shown, written)
    cell = re.sub(r"(?:·|×)\s*10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)", lambda found: "e" + found[1].translate(_RAISED), cell)
    cell = _FRACTION.sub(r"\1/\2", _POWER.sub(lambda found: f"e{found[1]}".replace("−", "-"), cell))
    cell = re.sub(r"\\(?:mathrm|mathbf|text|tfrac|dfrac|bar|left|right|langle|rangle|[,;!: ])", "", cell)
    cell = re.sub(r"(\d)\s+e(?=[-+]?\d)", r"\1e", cell)
    cell = re.sub(r"\*\*|[$`{}\\]", "", cell).strip()
    return re.sub(r"^10\^(-?\d+)$", r"1e\1", cell)


_TYPOGRAPHY = {"<=": "≤", ">=": "≥", "^2": "²", "^3": "³", "^4": "⁴", " - ": " − "}
_SPECIAL = str.maketrans({character: f"\\{character}" for character in "\\`*_{}[]<>|$"})


def plain(text: str) -> str:
    """Set plain text of a record in a page: signs as in print, nothing taken for markup."""
    for typed, printed in _TYPOGRAPHY.items():
        text = text.replace(typed, printed)
    return text.translate(_SPECIAL)


def numbers_to_take_away(name: str, columns: Mapping[str, Iterable[float]], *, digits: int = 8) -> Markup:
    """Offer the numbers behind a figure as a CSV file, one column each."""
    rows = ([f"{value:.{digits}g}" for value in row] for row in zip(*columns.values(), strict=True))
    return Markup(_csv_link(name, list(columns), rows, what="the numbers behind the figure"))
