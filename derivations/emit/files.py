"""All emitted files, as text by path: writing them, and holding those on disk against them."""

from __future__ import annotations

import difflib
import hashlib
import json
import os
from pathlib import Path

import sympy as sp

from derivations.catalogue import CATALOGUE
from derivations.emit.arrays import array_module
from derivations.emit.formulas import formula_fragment
from derivations.emit.gauss import gauss_module
from derivations.emit.module import operations_before
from derivations.emit.scalar import scalar_module
from derivations.record import Derivation

ROOT = Path(__file__).resolve().parents[2]
GENERATED = "granular/generated"
FORMULAS = "book/_formulas"

PACKAGE = '''\
"""Functions emitted by ``derivations write``; do not edit, change the derivation instead."""
'''


def fingerprint(derivation: Derivation) -> str:
    """Hash of what a derivation states: its outputs and the arithmetic of its functions, whatever their layout."""
    parts = [sp.srepr(output.expression) for output in derivation.outputs]
    for function in derivation.functions:
        parts += [f"{symbol.name}={sp.srepr(expression)}" for symbol, expression in function.assignments]
        parts += [str(series.coefficients) for series in function.series]
    return hashlib.sha256("\n".join(parts).encode()).hexdigest()


def emitted_files() -> dict[str, str]:
    """Text of every emitted file by its path from the top of the project."""
    files = {f"{GENERATED}/__init__.py": PACKAGE, f"{GENERATED}/gauss_legendre.py": gauss_module()}
    index: dict[str, object] = {}
    for build in CATALOGUE:
        derivation = build()
        paths = {}
        if derivation.functions:
            paths[f"{GENERATED}/{derivation.name}.py"] = scalar_module(derivation)
            paths[f"{GENERATED}/{derivation.name}_array.py"] = array_module(derivation)
        fragment = formula_fragment(derivation)
        paths[f"{FORMULAS}/{derivation.name}.md"] = fragment
        files.update(paths)
        index[derivation.name] = {
            "title": derivation.title,
            "sources": list(derivation.sources),
            "sha256": fingerprint(derivation),
            "operations_before": operations_before(derivation),
            "operations_after": sum(f.operations() for f in derivation.functions),
            "files": sorted(paths),
        }
    files[f"{GENERATED}/index.json"] = json.dumps(index, indent=1, ensure_ascii=False, sort_keys=True) + "\n"
    return dict(sorted(files.items()))


def write(root: Path = ROOT, wanted: dict[str, str] | None = None) -> list[str]:
    """Write every emitted file that differs, remove stale ones, and return what changed.

    ``wanted`` spares deriving everything again when the texts are at hand. Each file is written under a temporary
    name and then renamed, so that none is ever half-written.
    """
    wanted = emitted_files() if wanted is None else wanted
    changed = []
    for path, text in wanted.items():
        target = root / path
        if target.is_file() and target.read_text(encoding="utf-8") == text:
            continue
        target.parent.mkdir(parents=True, exist_ok=True)
        temporary = target.with_name(f".{target.name}.{os.getpid()}")
        temporary.write_text(text, encoding="utf-8", newline="\n")
        temporary.replace(target)
        changed.append(path)
    for path in stale(root, wanted):
        (root / path).unlink()
        changed.append(path)
    return changed


def stale(root: Path, wanted: dict[str, str]) -> list[str]:
    """Files in the emitted folders that nothing emits."""
    found = [p.relative_to(root).as_posix() for folder in (GENERATED, FORMULAS) for p in (root / folder).glob("*")
             if p.is_file()]
    return sorted(path for path in found if path not in wanted)


def differences(root: Path = ROOT, wanted: dict[str, str] | None = None) -> list[str]:
    """Unified diffs of the files on disk against what would be emitted; empty when they agree."""
    wanted = emitted_files() if wanted is None else wanted
    reports = []
    for path, text in wanted.items():
        target = root / path
        on_disk = target.read_text(encoding="utf-8") if target.is_file() else ""
        if on_disk != text:
            reports.append("".join(difflib.unified_diff(
                on_disk.splitlines(keepends=True), text.splitlines(keepends=True),
                f"{path} (on disk)", f"{path} (as derived)")))
    reports += [f"{path}: stale, no derivation emits it\n" for path in stale(root, wanted)]
    return reports
