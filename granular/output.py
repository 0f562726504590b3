"""Writing a text file so that a reader never sees half of it."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path

from granular.errors import OutputUnwritable


def write_text(path: Path, text: str) -> None:
    """Write a file under a temporary name beside it, and rename it once it is complete.

    Parameters
    ----------
    path : Path
        File to write or to replace.
    text : str
        Its content, written as UTF-8.

    Returns
    -------
    None

    Raises
    ------
    OutputUnwritable
        The folder does not exist or may not be written, or the disk is full; nothing is left behind.
    """
    try:
        handle, temporary = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
    except OSError as error:
        raise _refusal(path, error) from None
    try:
        with os.fdopen(handle, "w", encoding="utf-8", newline="\n") as file:
            file.write(text)
        Path(temporary).chmod(0o644)
        Path(temporary).replace(path)
    except OSError as error:
        raise _refusal(path, error) from None
    finally:
        Path(temporary).unlink(missing_ok=True)


def _refusal(path: Path, error: OSError) -> OutputUnwritable:
    return OutputUnwritable(f"{path} ({(error.strerror or str(error)).lower()})", allowed="it must be a writable file",
                            remedy="Name another file, or free some space.")
