"""A command with what it answers, as a reader would see both in a shell."""

from __future__ import annotations

import os
import subprocess
import sys
import textwrap
from pathlib import Path

from page_tools.markup import Markup

WIDTH = 74
"""Columns of the shell: as many as a page shows side by side."""

COLOURED = ("CLICOLOR", "CLICOLOR_FORCE", "FORCE_COLOR")
"""What a notebook sets to get colours, which would stand as signs in the text."""


def answer(command: str, file: str, *options: str) -> Markup:
    """Run a command on a file of the book's data, in a process of its own, and show it with its answer.

    Parameters
    ----------
    command : str
        Such as ``run``.
    file : str
        Path from the folder of the book; its name alone is shown.
    options : str
        What stands behind it.

    Raises
    ------
    subprocess.CalledProcessError
        The command did not end well; the page must not be built.
    """
    shell = {name: value for name, value in os.environ.items() if name not in COLOURED}
    done = subprocess.run([sys.executable, "-m", "granular", command, file, *options], check=True, capture_output=True,
                          encoding="utf-8", env={**shell, "COLUMNS": str(WIDTH), "PYTHONUTF8": "1"})
    line = " ".join(["granular", command, Path(file).name, *options])
    return Markup(f"```console\n$ {line}\n{done.stdout}```\n")


def wrapped(line: str) -> str:
    """Break a command into several lines, as a shell takes it; options stay beside their values."""
    glued = textwrap.wrap(line.replace(" --", "\0--").replace(" ", "\1").replace("\0", " "), WIDTH - 2,
                          subsequent_indent="    ", break_long_words=False, break_on_hyphens=False)
    return " \\\n".join(glued).replace("\1", " ")
