"""Writing to standard output: text, blocks of rich, one JSON object."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import typer

from granular.commands.options import DONE
from granular.errors import OutputUnwritable

if TYPE_CHECKING:
    from rich.console import RenderableType


def print_json(content: dict[str, Any]) -> None:
    """Write one JSON object, a line for each of its keys.

    Parameters
    ----------
    content : dict
        What JSON can hold; no infinities.

    Raises
    ------
    OutputUnwritable
        As :func:`print_text`.

    Notes
    -----
    Source: the command line's interface.
    """
    import json

    lines = (f"{json.dumps(key)}: {json.dumps(value, allow_nan=False)}" for key, value in content.items())
    print_text("{" + ",\n ".join(lines) + "}\n")


def print_blocks(blocks: Iterable[RenderableType]) -> None:
    """Write blocks one below the other, as wide as the terminal and without spaces at the ends of lines.

    Parameters
    ----------
    blocks : iterable of renderable
        Texts and tables.

    Raises
    ------
    OutputUnwritable
        As :func:`print_text`.

    Notes
    -----
    Source: the command line's interface.
    """
    import io

    from rich.console import Console

    buffer = io.StringIO()
    console = Console(file=buffer, force_terminal=_is_terminal(), highlight=False, markup=False,
                      emoji=False)
    for block in blocks:
        console.print(block)
    print_text("".join(f"{line.rstrip()}\n" for line in buffer.getvalue().splitlines()))


def _is_terminal() -> bool | None:
    """True on a terminal; None leaves the choice to the environment."""
    return True if sys.stdout is not None and sys.stdout.isatty() else None


def print_text(text: str) -> None:
    """Write to standard output at once. A reader that went away is no error; a full disk is.

    Parameters
    ----------
    text : str
        What is written, line ends included.

    Raises
    ------
    OutputUnwritable
        Standard output is closed, or its disk is full.

    Notes
    -----
    Source: the command line's interface.
    """
    if sys.stdout is None:
        raise OutputUnwritable("standard output (closed)", allowed="it must take the result",
                               remedy="Leave it open, or send it to a file.")
    try:
        sys.stdout.write(text)
        sys.stdout.flush()
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        raise typer.Exit(DONE) from None
    except OSError as error:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        raise OutputUnwritable(f"standard output ({(error.strerror or str(error)).lower()})",
                               allowed="it must take the result", remedy="Free some space or name another file."
                               ) from None
