"""Which kind of contact file it is, by its content, and whether that is what its name says."""

from __future__ import annotations

import os
from pathlib import Path

from granular.contacts.dump_local import ITEM, DumpLocal
from granular.contacts.open_text import GZIP, open_text
from granular.contacts.parquet_table import MAGIC, ParquetTable
from granular.contacts.tables import ContactTable
from granular.contacts.text_table import TextTable
from granular.errors import BadOption, ContactFileUnusable, FileUnreadable
from granular.units import shown_path

PARQUET, DUMP, TEXT = "a Parquet file", "a dump of LAMMPS or LIGGGHTS", "a table of text"

NAMES = {".parquet": PARQUET, ".pq": PARQUET, ".dump": DUMP, ".local": DUMP, ".csv": TEXT}
"""What a suffix promises; under any other, a file is what it holds."""


def open_table(path: str | os.PathLike[str], *, step: int | None = None) -> ContactTable:
    """Open a file of contacts: CSV or white-space text, Parquet, or a dump of LAMMPS or LIGGGHTS.

    Parameters
    ----------
    path : str or path-like
        The file. Text may be compressed with gzip, and then its name ends in ``.gz``.
    step : int, optional
        Time step of a dump [-]; the last one by default.

    Returns
    -------
    ContactTable
        Its columns, and their numbers some rows at a time.

    Raises
    ------
    FileUnreadable
        The file is missing, is a folder, or may not be read.
    ContactFileUnusable
        The file is empty, damaged, cut off, or not what its name says; or Parquet, and pyarrow is not installed.
    BadOption
        A time step that is not there, or of a file that has none.

    Notes
    -----
    Source: the first bytes of each format.
    """
    path = Path(path)
    name = shown_path(str(path))
    kind, compressed = _content(path, name)
    bare = Path(path.stem) if path.suffix.lower() == ".gz" else path
    promised = NAMES.get(bare.suffix.lower())
    if path.suffix.lower() == ".gz" and not compressed:
        raise _not_as_named(name, "is not compressed", "a name in .gz is for gzip-compressed text")
    if compressed and path.suffix.lower() != ".gz":
        raise _not_as_named(name, "is compressed with gzip", "the name of a compressed file ends in .gz")
    if promised is not None and kind != promised:
        raise _not_as_named(name, f"is {kind}", f"the name says {promised}")
    if step is not None and kind != DUMP:
        raise BadOption(f"--step = {step}", allowed=f"allowed for dumps only, and {name} is {kind}",
                        remedy="Leave --step out.")
    if kind == PARQUET:
        return ParquetTable(path, name)
    return DumpLocal(path, name, step) if kind == DUMP else TextTable(path, name)


def _content(path: Path, name: str) -> tuple[str, bool]:
    """What a file holds, and whether it is compressed."""
    if path.is_dir():
        raise FileUnreadable(f"{name} is a folder", allowed="a contact list is needed",
                             remedy="Name a file in it, or compare a folder of packings with --compare.")
    try:
        with path.open("rb") as file:
            start = file.read(4096)
    except OSError as error:
        reason = "does not exist" if isinstance(error, FileNotFoundError) else (
            f"cannot be read ({(error.strerror or str(error)).lower()})")
        raise FileUnreadable(f"{name} {reason}", allowed="a contact list is needed",
                             remedy="Check the path.") from None
    except ValueError:
        raise FileUnreadable(f"{name} is no path", allowed="a contact list is needed",
                             remedy="Check the path.") from None
    if not start:
        raise ContactFileUnusable(f"{name} is empty", allowed="needed: a header and one row a contact",
                                  remedy="Export the contacts again.")
    if start.startswith(MAGIC):
        return PARQUET, False
    compressed = start.startswith(GZIP)
    if not compressed and b"\0" in start:
        raise ContactFileUnusable(f"{name} is no text", allowed=f"allowed {TEXT}, {PARQUET} or {DUMP}",
                                  remedy="Export the contacts in one of these.")
    with open_text(path, name) as lines:
        first = next((line for line in lines if line.strip()), "")
    if "\0" in first:
        raise ContactFileUnusable(f"{name} holds no text", allowed=f"allowed {TEXT} or {DUMP} inside gzip",
                                  remedy="Export the contacts in one of these.")
    return (DUMP if first.startswith(ITEM) else TEXT), compressed


def _not_as_named(name: str, what: str, wanted: str) -> ContactFileUnusable:
    return ContactFileUnusable(f"{name} {what}", allowed=wanted,
                               remedy="Give the file the name of what it holds, or name another one.")
