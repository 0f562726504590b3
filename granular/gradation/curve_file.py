"""Reading a measured gradation curve: a text file of sizes and fractions finer, one row a sieve."""

from __future__ import annotations

import os
import re
from pathlib import Path

from granular.errors import CurveInPercent, CurveMalformed, QuantityUnreadable, WrongType, found_at
from granular.gradation.measured_curve import MeasuredCurve, sound_points
from granular.gradation.size_distribution import SIZE
from granular.reading import bytes_of
from granular.units import LENGTH, finite_number, in_si, shown, shown_path

_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")
_HEADER_UNIT = re.compile(r"[\[(]\s*([^\])]+?)\s*[\])]")


def read_curve(path: str | os.PathLike[str]) -> MeasuredCurve:
    """Read a gradation curve from a text file of two columns, size and fraction finer.

    The first row may name the columns; the unit of the sizes then stands there in brackets, parentheses or after an
    underscore (``size [mm]``, ``size (mm)``, ``size_mm``). A size may also carry its own unit (``2 mm``); a bare
    number without a unit in the header is in metres. Columns are parted by commas, semicolons or tabs, rows stand in
    either order, and lines that begin with ``#`` are comments.

    Parameters
    ----------
    path : str or path-like
        The file, at most 1 MiB of text in UTF-8.

    Returns
    -------
    MeasuredCurve
        The distribution of sizes.

    Raises
    ------
    FileUnreadable, FileTooLarge
        The file cannot be read.
    CurveMalformed, CurveInPercent, CurveNotMonotone, CurveIncomplete
        It holds no gradation curve.
    UnitUnknown, UnitOfOtherDimension, ValueOutOfRange, NotFinite
        A size or fraction in it means nothing; the message names the line.

    Notes
    -----
    Accuracy: sizes are rounded once. Source: the file format is one of this package.

    Examples
    --------
    >>> import tempfile
    >>> with tempfile.NamedTemporaryFile("w", suffix=".csv") as file:
    ...     _ = file.write("size [mm]; fraction finer\\n2; 1\\n1; 0.4\\n0.5; 0\\n")
    ...     file.flush()
    ...     read_curve(file.name).sizes
    (0.0005, 0.001, 0.002)
    """
    name = shown_path(os.fspath(path))
    content = bytes_of(Path(path), name, kind="a gradation curve")
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise CurveMalformed(f"{name} has a byte at position {error.start} that is not UTF-8",
                             allowed="allowed text in UTF-8", remedy="Save the file as UTF-8.") from None
    rows = [(number, _cells(line, f"{name}, line {number}"))
            for number, line in enumerate(text.splitlines(), start=1)
            if line.strip() and not line.lstrip().startswith("#")]
    unit = _unit_of_header(rows, name)
    points, places = [], []
    for number, (size, fraction) in rows:
        where = f"line {number}"
        with found_at(f"{name}, {where}: "):
            points.append((_size(size, unit), _fraction(fraction)))
        places.append(where)
    with found_at(f"{name}: "):
        points = sound_points(points, places)
    return MeasuredCurve([size for size, _ in points], [fraction for _, fraction in points])


def _cells(line: str, where: str) -> tuple[str, str]:
    separator = next((mark for mark in (";", "\t", ",") if mark in line), ",")
    cells = [cell.strip().strip('"').strip() for cell in line.split(separator)]
    while len(cells) > 2 and not cells[-1]:
        cells.pop()  # spreadsheets end rows with empty cells
    if len(cells) != 2:
        raise CurveMalformed(f"{where} has {len(cells)} column{'' if len(cells) == 1 else 's'}",
                             allowed="allowed two, size and fraction finer",
                             remedy="Write them with a comma, semicolon or tab between.")
    return cells[0], cells[1]


def _unit_of_header(rows: list[tuple[int, tuple[str, str]]], name: str) -> str | None:
    """The unit that a header names; a header is a first row whose first cell does not begin like a number."""
    if not rows or re.match(r"[+-]?[.\d]", rows[0][1][0]) or _is_number(rows[0][1][1]):
        return None
    number, (head, _) = rows.pop(0)
    bracketed = _HEADER_UNIT.search(head)
    unit = bracketed[1] if bracketed else head.rpartition("_")[2] if "_" in head else None
    if unit is not None:
        in_si(f"1 {unit}", LENGTH, name=f"{name}, line {number}: unit of the header")
    return unit


def _is_number(cell: str) -> bool:
    return _NUMBER.fullmatch(cell) is not None


def _size(cell: str, unit: str | None) -> float:
    if _is_number(cell):
        return SIZE.read(f"{cell} {unit or 'm'}", "size")
    try:
        return SIZE.read(cell, "size")
    except (QuantityUnreadable, WrongType):
        raise CurveMalformed(f"size is {shown(cell)}", allowed="allowed a number, or a number with a unit of length",
                             remedy="Correct that cell.") from None


def _fraction(cell: str) -> float:
    if cell.endswith("%") and _is_number(cell[:-1].strip()):
        raise CurveInPercent(f"fraction is {shown(cell)}", allowed="allowed fractions from 0 to 1",
                             remedy="Divide the second column by 100.")
    if not _is_number(cell):
        raise CurveMalformed(f"fraction is {shown(cell)}", allowed="allowed a number from 0 to 1",
                             remedy="Correct that cell.")
    return finite_number(float(cell), name="fraction")
