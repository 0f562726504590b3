"""Provoke a refusal and show its message, so that the page of errors can never quote an old one."""

from __future__ import annotations

import errno
import io
import os
import sys
import tempfile
from collections.abc import Callable
from contextlib import chdir, redirect_stdout
from copy import deepcopy
from pathlib import Path
from typing import Any
from unittest.mock import patch

from granular import Scene, evaluate
from granular.__main__ import run_command
from granular.errors import CATALOGUE, GranularError
from granular.gradation import read_curve
from page_tools.markup import Markup, plain, table

SOUND_SCENE: dict[str, dict[str, Any]] = {
    "grains": {"shear_modulus": "31 GPa", "poisson_ratio": 0.21},
    "packing": {"void_ratio": 0.5744},
    "stress": {"mean": "28 kPa"},
}


def catalogue() -> Markup:
    """List every refusal with a link to its section."""
    rows = [[f"{{ref}}`{kind.code} <error-{kind.code.lower()}>`", plain(kind.title), f"`{kind.__name__}`"]
            for kind in CATALOGUE]
    return table(["code", "what it means", "class"], rows, label="tab-refusals", caption="All refusals.")


def refused(code: str, attempt: Callable[[], object]) -> Markup:
    """Show the message of a refusal, which must carry the code that the section is about."""
    try:
        attempt()
    except GranularError as refusal:
        if refusal.code != code:
            raise AssertionError(f"expected {code}, got {refusal}") from refusal
        return Markup(f"```text\n{refusal}\n```\n")
    raise AssertionError(f"nothing was refused where {code} was expected")


def scene_with(**changes: Any) -> Callable[[], object]:
    """Prepare the evaluation of a sound scene after some changes, ``table__key=value``; None deletes the key."""
    scene = deepcopy(SOUND_SCENE)
    for path, value in changes.items():
        table, _, key = path.partition("__")
        if not key:
            scene[table] = value
        elif value is None:
            del scene[table][key]
        else:
            scene.setdefault(table, {})[key] = value
    return lambda: evaluate(Scene.model_validate(scene))


def command_line(*arguments: str) -> Callable[[], object]:
    """Prepare a call of the command line."""
    return lambda: run_command(arguments)


class _FullDisk(io.StringIO):
    """A text stream that takes nothing, as on a full disk."""

    def write(self, _text: str, /) -> int:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    def fileno(self) -> int:
        return os.open(os.devnull, os.O_WRONLY)


def on_a_full_disk(attempt: Callable[[], object]) -> Callable[[], object]:
    """Prepare an attempt whose standard output cannot be written."""
    def tried() -> object:
        with redirect_stdout(_FullDisk()):
            return attempt()
    return tried


def branches_twice_as_long() -> object:
    """Give a deviation tensor that doubles lengths, which it must not."""
    import numpy as np

    from granular.branch_products import deviating

    return deviating(4 * np.einsum("pi,qk->pqik", np.eye(3), np.eye(3)))(np.eye(3))


def curve_with(*rows: str) -> Callable[[], object]:
    """Prepare the reading of a gradation curve of some rows; its name is the same on every machine."""
    def tried() -> object:
        with tempfile.TemporaryDirectory() as folder, chdir(folder):
            Path("curve.csv").write_text("\n".join(rows) + "\n", encoding="utf-8")
            return read_curve("curve.csv")
    return tried


def contacts_with(*rows: str) -> Callable[[], object]:
    """Prepare the reading of a contact list of some rows; its name is the same on every machine."""
    def tried() -> object:
        from granular.contacts.summary import summarise

        with tempfile.TemporaryDirectory() as folder, chdir(folder):
            Path("contacts.csv").write_text("\n".join(rows) + "\n", encoding="utf-8")
            return summarise("contacts.csv", volume=1e-6)
    return tried


def parquet_without_its_library() -> object:
    """Open what begins as a Parquet file where pyarrow is not installed."""
    from granular.contacts.files import open_table

    with tempfile.TemporaryDirectory() as folder, chdir(folder), patch.dict(sys.modules, {"pyarrow": None}):
        Path("contacts.parquet").write_bytes(b"PAR1")
        return open_table("contacts.parquet")


def without(module: str, attempt: Callable[[], object]) -> Callable[[], object]:
    """Prepare an attempt on a machine where a module is not installed."""
    def tried() -> object:
        with patch.dict(sys.modules, {module: None}):
            return attempt()
    return tried
