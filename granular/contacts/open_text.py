"""Opening a text file, compressed or not, so that whatever is wrong with it on the way is a refusal."""

from __future__ import annotations

import gzip
import io
import zlib
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from granular.errors import ContactFileUnusable, FileUnreadable

GZIP = b"\x1f\x8b"
"""How a gzip-compressed file begins."""


@contextmanager
def open_text(path: Path, name: str) -> Iterator[Iterator[str]]:
    """Open a file of text for reading line by line.

    Parameters
    ----------
    path : Path
        The file; it is taken as compressed when it begins as gzip does.
    name : str
        Its name for messages.

    Returns
    -------
    context manager
        Gives the lines; reading them, inside the block too, raises refusals only.

    Raises
    ------
    FileUnreadable
        The file is missing, is a folder, or may not be read.
    ContactFileUnusable
        Compressed data are cut off or damaged, or a byte is not UTF-8.

    Notes
    -----
    Source: the checks of gzip (length and checksum), which fail for what is cut off.
    """
    try:
        with path.open("rb") as raw:
            compressed = raw.read(2) == GZIP
            raw.seek(0)
            source = gzip.GzipFile(fileobj=raw) if compressed else raw
            with io.TextIOWrapper(source, encoding="utf-8-sig", newline=None) as text:
                yield text
    except EOFError:
        raise _damaged(name, "ends before its compressed data do") from None
    except (gzip.BadGzipFile, zlib.error) as error:
        raise _damaged(name, f"has damaged compressed data ({str(error).lower()})") from None
    except UnicodeDecodeError:
        raise ContactFileUnusable(f"{name} has bytes that are not text", allowed="allowed text in UTF-8",
                                  remedy="Name a table of contacts, or save it as UTF-8.") from None
    except OSError as error:
        raise FileUnreadable(f"{name} cannot be read ({(error.strerror or str(error)).lower()})",
                             allowed="a contact list is needed", remedy="Check the path.") from None


def _damaged(name: str, how: str) -> ContactFileUnusable:
    return ContactFileUnusable(f"{name} {how}", allowed="needed: a whole file",
                               remedy="Copy or export it again; the original may be sound.")
