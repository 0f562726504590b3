"""Commands of a tutorial, run one after another in a folder of their own, each shown with what it answers."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
import textwrap
from functools import lru_cache
from pathlib import Path

from page_tools.commands import COLOURED, WIDTH, wrapped
from page_tools.markup import Markup

DATA = Path(__file__).resolve().parents[2] / "_data"

FILES = ("soil.toml", "lab_sieve.csv", "lab_sand.toml", "lab_equal.toml", "lab_speeds.toml", "lab_ratio.toml",
         "many_lists.py")
"""What the tutorials start from, all of it offered for download on their pages."""

CUT = "  ..."
"""Stands for what an answer has and a page does not show."""


@lru_cache(maxsize=1)
def folder() -> tempfile.TemporaryDirectory[str]:
    """The folder in which the commands of one page run, with the files to start from; gone when the page is done."""
    made = tempfile.TemporaryDirectory()
    fill(Path(made.name))
    return made


def fill(place: Path) -> None:
    """Put the files to start from into a folder."""
    for name in FILES:
        shutil.copy(DATA / name, place)


def shell(line: str, *parts: str, status: int = 0) -> Markup:
    """Run a line as a shell does and show it with its answer.

    Parameters
    ----------
    line : str
        What a reader types.
    parts : str
        With what the parts of the answer begin that are shown, parts being set off by empty lines; all when absent.
    status : int
        The exit code that is expected; any other one stops the build.
    """
    text = answered(line, status)
    shown = text.rstrip("\n").split("\n\n")
    if parts:
        chosen = [part for part in shown if part.startswith(parts)]
        if len(chosen) < len(parts):
            raise AssertionError(f"{line}: the answer has not all of {parts}")
        text = _with_cuts(shown, chosen)
    typed = _typed(line)
    text = "\n".join(folded for one in text.splitlines() for folded in _folded(one))
    return Markup(f"```console\n{typed}\n{text.rstrip()}\n```\n".replace("\n\n```", "\n```"))


@lru_cache(maxsize=64)
def answered(line: str, status: int) -> str:
    """What a line answers in the folder of the page; the same line is run once."""
    return run(line, Path(folder().name), status)


def run(line: str, place: Path, status: int = 0) -> str:
    """Run a line in a folder and return what it writes, what it says of faults included.

    Raises
    ------
    AssertionError
        Another exit code than the expected one; with what was written.
    """
    about = {name: value for name, value in os.environ.items() if name not in COLOURED}
    about |= {"COLUMNS": str(WIDTH), "PYTHONUTF8": "1", "PYTHONUNBUFFERED": "1",
              "PATH": os.pathsep.join([str(Path(sys.executable).parent), os.environ.get("PATH", "")])}
    done = subprocess.run(["bash", "-c", line], check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          encoding="utf-8", env=about, cwd=place)
    if done.returncode != status:
        raise AssertionError(f"{line}: exit code {done.returncode}, not {status}\n{done.stdout}")
    return done.stdout


def _typed(line: str) -> str:
    """Commands as a reader sees them typed; what goes on from the line before has no prompt."""
    shown, goes_on = [], False
    for one in line.splitlines():
        shown.append(one if goes_on else wrapped(f"$ {one}"))
        goes_on = one.endswith("\\")
    return "\n".join(shown)


def _folded(line: str) -> list[str]:
    """A line that is too wide for the page, over several, as a narrow window shows it."""
    return textwrap.wrap(line, WIDTH, break_on_hyphens=False) if len(line) > WIDTH else [line]


def _with_cuts(every: list[str], chosen: list[str]) -> str:
    """The chosen parts in their order, with a mark where something between them is left out."""
    lines: list[str] = []
    cut = False
    for part in every:
        if part in chosen:
            lines += [CUT] if cut else []
            lines += [part]
        cut = part not in chosen
    return "\n\n".join([*lines, CUT] if cut else lines)
