"""All emitted files, as text by path: writing them, and holding those on disk against them."""

from __future__ import annotations

import difflib
import hashlib
import json
import os
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path

import sympy as sp

from derivations.catalogue import derivation, names
from derivations.emit.arrays import array_module
from derivations.emit.batch import block_module, loop_module
from derivations.emit.formulas import formula_fragment
from derivations.emit.gauss import gauss_module
from derivations.emit.module import operations_before
from derivations.emit.panels import panel_module
from derivations.emit.rows import rows_module
from derivations.emit.scalar import scalar_module
from derivations.emit.steps import steps_entry
from derivations.record import Derivation

ROOT = Path(__file__).resolve().parents[2]
GENERATED = "granular/generated"
FORMULAS = "book/_formulas"

PACKAGE = '''\
"""Functions emitted by ``derivations write``; do not edit, change the derivation instead."""
'''


def fingerprint(record: Derivation) -> str:
    """Hash of what a derivation states: its outputs and the arithmetic of its functions, whatever their layout."""
    parts = [sp.srepr(output.expression) for output in record.outputs]
    for function in (*record.functions, *(one.function for one in record.batch)):
        parts += [f"{symbol.name}={sp.srepr(expression)}" for symbol, expression in function.assignments]
        parts += [str(series.coefficients) for series in function.series]
    return hashlib.sha256("\n".join(parts).encode()).hexdigest()


def emitted_of(name: str) -> tuple[dict[str, str], dict[str, object], dict[str, object]]:
    """Texts that one derivation emits, by path, and its entries in the index and in the list of steps."""
    record = derivation(name)
    files = {}
    if record.functions:
        files[f"{GENERATED}/{name}.py"] = scalar_module(record)
        files[f"{GENERATED}/{name}_array.py"] = array_module(record)
    if record.batch:
        files[f"{GENERATED}/{name}_loop.py"] = loop_module(record)
        files[f"{GENERATED}/{name}_block.py"] = block_module(record)
    files[f"{FORMULAS}/{name}.md"] = formula_fragment(record)
    return files, {
        "title": record.title,
        "sources": list(record.sources),
        "sha256": fingerprint(record),
        "operations_before": operations_before(record),
        "operations_after": sum(f.operations() for f in record.functions),
        "files": sorted(files),
    }, steps_entry(record)


def emitted_files(processes: int = 1) -> dict[str, str]:
    """Text of every emitted file by its path from the top of the project, derived in one or several processes.

    Derivations are independent of one another; what two of them share is derived once in each process.
    """
    if processes == 1:
        emitted = [emitted_of(name) for name in names()]
        gauss = gauss_module()
    else:
        with ProcessPoolExecutor(processes, get_context("spawn")) as pool:
            nodes = pool.submit(gauss_module)
            emitted = list(pool.map(emitted_of, names()))
            gauss = nodes.result()
    files = {f"{GENERATED}/__init__.py": PACKAGE, f"{GENERATED}/gauss_legendre.py": gauss,
             f"{GENERATED}/panel_rows.py": panel_module(), f"{GENERATED}/rows.py": rows_module()}
    index, steps = {}, {}
    for name, (texts, entry, about_steps) in zip(names(), emitted, strict=True):
        files.update(texts)
        index[name], steps[name] = entry, about_steps
    files[f"{GENERATED}/index.json"] = json.dumps(index, indent=1, ensure_ascii=False, sort_keys=True) + "\n"
    files[f"{FORMULAS}/steps.json"] = json.dumps(steps, indent=1, ensure_ascii=False) + "\n"
    return dict(sorted(files.items()))


def all_cores() -> int:
    """How many processes to derive in: the cores of this machine."""
    return os.cpu_count() or 1


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
