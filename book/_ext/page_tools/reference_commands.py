"""The command line, from the commands themselves: what each takes, its exit codes, and a short run with its answer."""

from __future__ import annotations

import inspect
import os
import re
import shutil
import subprocess
import sys
import tempfile
from enum import Enum
from functools import cache
from pathlib import Path
from typing import Any, cast

import granular.__main__
from granular.commands import app
from page_tools.commands import COLOURED, WIDTH
from page_tools.contents import BOOK
from page_tools.markup import Markup, plain, table
from page_tools.reference_text import items, prose, sections

PROGRAMS = ("granular", "derivations")
OPTION = re.compile(r"(?<![\w`-])--[a-z][a-z-]*")
EXIT_CODE = re.compile(r"(\d+) ([^,.]+)")


@cache
def commands(program: str = "granular") -> dict[str, Any]:
    """The commands of a program by their names, in the order of its help text."""
    import typer

    from derivations.__main__ import app as of_derivations

    group = cast("Any", typer.main.get_command(app if program == "granular" else of_derivations))
    return dict(group.commands)


def overview() -> Markup:
    """Every command of both programs, with what it does."""
    rows = [[f"{{ref}}`{program} {name} <{label_of(program, name)}>`", quick(command.help)]
            for program in PROGRAMS for name, command in commands(program).items()]
    return table(["command", "what it does"], rows, label="tab-commands", look="reference", caption="All commands.")


def label_of(program: str, name: str) -> str:
    """Label of the section about a command."""
    return f"command-{name}" if program == "granular" else f"command-{program}-{name}"


def quick(text: str | None) -> str:
    """A help text on one line."""
    return prose(OPTION.sub(r"``\g<0>``", " ".join((text or "").split())))


def exit_codes() -> Markup:
    """What a command leaves with, from the docstring of the command line."""
    raised = sections(inspect.getdoc(granular.__main__.main) or "")["Raises"]
    ((_, told),) = items(raised)
    rows = [[code, plain(meaning)] for code, meaning in EXIT_CODE.findall(told)]
    return table(["exit code", "what it says"], rows, label="tab-exit-codes", caption="Exit codes.")


def usage(name: str, program: str = "granular") -> Markup:
    """What a command does, how it is called, and each of its arguments and options."""
    command = commands(program)[name]
    shown = [one for one in command.params if one.name != "help"]
    words = [program, name, *(_word(one) for one in shown)]
    text = f"{quick(command.help)}\n\n```text\n{_folded(words)}\n```\n"
    if not shown:
        return Markup(text)
    rows = [[f"`{called(one)}`", quick(one.help) + _default(one)] for one in shown]
    return Markup(text + "\n" + table(
        ["option", "what it says"], rows, label=f"tab-{label_of(program, name)}", look="reference",
        caption=f"Arguments and options of `{program} {name}`.").text)


def _is_argument(one: Any) -> bool:
    return not one.opts[0].startswith("-")


def called(one: Any) -> str:
    """An argument or option as it is typed, with the name of its value."""
    value = str(one.metavar or one.name.upper())
    if _is_argument(one):
        return value
    return one.opts[0] if one.is_flag else f"{one.opts[0]} {value}"


def _word(one: Any) -> str:
    return called(one) if one.required else f"[{called(one)}]"


def _folded(words: list[str]) -> str:
    """A call on as many lines as it takes, later ones indented."""
    lines = [words[0]]
    for word in words[1:]:
        if len(lines[-1]) + 1 + len(word) > WIDTH:
            lines.append(f"    {word}")
        else:
            lines[-1] += f" {word}"
    return "\n".join(lines)


def _default(one: Any) -> str:
    given = one.default
    if one.required or given is None or given is False:
        return " Needed." if one.required else ""
    if isinstance(given, Enum):
        return f" One of {', '.join(f'`{choice.value}`' for choice in type(given))}; by default `{given.value}`."
    return f" By default `{given}`."


@cache
def _folder() -> tempfile.TemporaryDirectory[str]:
    """A folder with the files of the examples, as long as the page is computed."""
    kept = tempfile.TemporaryDirectory()
    for name in ("table_ii_case_3.toml", "fit_sand.toml", "sweep.toml"):
        shutil.copy(BOOK / "_data" / name, kept.name)
    shutil.copy(BOOK.parent / "granular" / "data" / "contacts" / "C_A1_SR15_contacts.csv.gz",
                Path(kept.name) / "packing.csv.gz")
    return kept


def run(line: str, *, first: int = 60, last: int = 0, code: int = 0) -> Markup:
    """Run a command line where the files of the examples are, and show its answer.

    Parameters
    ----------
    line : str
        As typed in a shell.
    first, last : int
        So many lines are shown of its beginning and of its end [-].
    code : int
        The exit code that it must leave with [-].

    Raises
    ------
    AssertionError
        It left with another one; the page must not be built.
    """
    program, *words = line.split()
    shell = {name: value for name, value in os.environ.items() if name not in COLOURED}
    done = subprocess.run([sys.executable, "-m", program, *words], capture_output=True, encoding="utf-8", check=False,
                          cwd=_folder().name, env={**shell, "COLUMNS": str(WIDTH), "PYTHONUTF8": "1"})
    assert done.returncode == code, f"{line} left with {done.returncode}: {done.stderr}"
    lines = (done.stdout + (done.stderr if code else "")).rstrip("\n").splitlines()
    if len(lines) > first + last:
        lines = [*lines[:first], *(["..."] if first else []), *(lines[-last:] if last else [])]
    told = "\n".join(lines)
    wrapped = "text" if code or "--json" in words else "console"
    return Markup(f"```{wrapped}\n$ {line}\n{told}\n```\n")
