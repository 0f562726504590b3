"""Reading a scene file: every way in which a file can fail gets its own sentence."""

from __future__ import annotations

import os
import re
import tomllib
from pathlib import Path
from typing import Any

from granular.errors import NotToml
from granular.reading import bytes_of
from granular.units import shown_path

MOST_DOTS = 100
"""Most dots in one line that is no comment. Dotted keys cost the parser the square of their length, and the longest
line of a scene, a fabric of nine and 81 numbers, has ninety dots."""


def read_toml(path: str | os.PathLike[str]) -> dict[str, Any]:
    """Read a TOML file of at most 1 MiB.

    Parameters
    ----------
    path : str or path-like
        The file.

    Returns
    -------
    dict
        Its tables.

    Raises
    ------
    FileUnreadable, FileTooLarge, NotToml
        The file is missing, a folder, forbidden, too large, not UTF-8, or not TOML.

    Notes
    -----
    Source: TOML 1.0.
    """
    name = shown_path(os.fspath(path))
    try:
        text = bytes_of(Path(path), name).decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise NotToml(f"{name} has a byte at position {error.start} that is not UTF-8",
                      allowed="allowed TOML text in UTF-8", remedy="Save the file as UTF-8.") from None
    _refuse_long_keys(text, name)
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise NotToml(f"{name} is not TOML: {_reason(str(error), text)}",
                      allowed="allowed TOML 1.0", remedy="Correct that place.") from None
    except RecursionError:
        raise NotToml(f"{name} has lists or tables nested too deeply",
                      allowed="allowed a scene, two tables deep", remedy="Remove the nesting.") from None
    except ValueError:
        # the one thing that tomllib leaves to int(): Python refuses to read integers of more than 4300 digits
        raise NotToml(f"{name} has an integer of too many digits", allowed="allowed numbers up to 1.8e+308",
                      remedy="Write a shorter number.") from None


def read_scene(path: str | os.PathLike[str]) -> dict[str, Any]:
    """Read a scene file; a gradation curve that it names is looked for in the folder of the scene.

    Parameters
    ----------
    path : str or path-like
        The scene file.

    Returns
    -------
    dict
        Its tables; the name of a curve leads there from the working directory.

    Raises
    ------
    FileUnreadable, FileTooLarge, NotToml
        The file cannot be read, or is not TOML.

    Notes
    -----
    Source: the scene file's interface.
    """
    tables = read_toml(path)
    gradation = tables.get("gradation")
    if isinstance(gradation, dict) and isinstance(file := gradation.get("file"), str) and file.strip():
        gradation["file"] = str(Path(path).parent / file)
    return tables


def _refuse_long_keys(text: str, name: str) -> None:
    for number, line in enumerate(text.split("\n"), start=1):
        if line.count(".") > MOST_DOTS and not line.lstrip().startswith("#"):
            raise NotToml(f"{name} has {line.count('.')} dots in line {number}",
                          allowed=f"allowed up to {MOST_DOTS}, far more than any line of a scene has",
                          remedy="Write a scene, its keys two tables deep.")


def _reason(message: str, text: str) -> str:
    """The parser's reason on one line; the end of the document gets its line and column too."""
    message = "".join(c if c.isprintable() else repr(c)[1:-1] for c in message)
    if "at end of document" in message:
        lines = text.split("\n")
        message = message.replace("at end of document", f"at line {len(lines)}, column {len(lines[-1]) + 1}, "
                                  "the end of the file")
    return re.sub(r"[\s.]+$", "", message)
