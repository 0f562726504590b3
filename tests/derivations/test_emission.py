"""Emitted text: the same bytes every time, nothing but math, and a check that notices every change."""

from __future__ import annotations

import ast
import json
import os
import re
import shutil
import subprocess
import sys
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
import sympy as sp
from typer.testing import CliRunner

from derivations import kinematic
from derivations.__main__ import app
from derivations.catalogue import derivation, names
from derivations.emit import files
from derivations.emit.module import called_functions
from derivations.emit.printer import python_source
from derivations.emit.scalar import scalar_module

INDEX = json.loads((files.ROOT / files.GENERATED / "index.json").read_text(encoding="utf-8"))
WITH_FUNCTIONS = sorted(name for name, entry in INDEX.items() if entry["operations_after"])
"""Read from the emitted index, which is current by a test below: nothing is derived while tests are collected."""


@pytest.fixture(scope="module")
def emitted() -> dict[str, str]:
    """All emitted files."""
    return files.emitted_files()


def copy_of_project(folder: Path) -> Path:
    """Copy the emitted folders to a place where they may be spoiled."""
    for name in (files.GENERATED, files.FORMULAS):
        shutil.copytree(files.ROOT / name, folder / name, ignore=shutil.ignore_patterns("__pycache__"))
    return folder


def test_files_on_disk_are_current(emitted: dict[str, str]) -> None:
    """A derivation changed without ``derivations write`` breaks this."""
    assert files.differences(wanted=emitted) == []


def test_deleted_files_come_back_byte_for_byte(tmp_path: Path, emitted: dict[str, str]) -> None:
    """Delete, write, compare: nothing may depend on what was there before."""
    root = copy_of_project(tmp_path)
    before = {p.relative_to(root): p.read_bytes() for p in root.rglob("*") if p.is_file()}
    shutil.rmtree(root / files.GENERATED)
    files.write(root, emitted)
    after = {p.relative_to(root): p.read_bytes() for p in root.rglob("*") if p.is_file()}
    assert after == before
    assert files.write(root, emitted) == []


def test_a_changed_coefficient_is_shown(tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
                                        emitted: dict[str, str]) -> None:
    """Change 3/8 into 1/4 in one derivation: the diff must show the line with both."""
    root = copy_of_project(tmp_path)
    good = kinematic.positive_components

    def spoiled() -> tuple[sp.Expr, ...]:
        first, *others = good()
        return first.subs(sp.Rational(3, 8), sp.Rational(1, 4)), *others

    monkeypatch.setattr(kinematic, "positive_components", spoiled)
    kinematic.kinematic_constant.cache_clear()  # records are built once a process
    try:
        texts, _, _ = files.emitted_of("kinematic_constant")  # the others are as they were
        report = "".join(files.differences(root, emitted | texts))
    finally:
        kinematic.kinematic_constant.cache_clear()
    assert "-    C1111 = lam*(p0/8 + p1/2) + 3*p0/8\n" in report
    assert "+    C1111 = lam*(p0/8 + p1/2) + p0/4\n" in report


def test_edited_and_stale_files_are_found(tmp_path: Path, emitted: dict[str, str]) -> None:
    """A digit edited by hand, or a file that nothing emits any more, must not pass."""
    root = copy_of_project(tmp_path)
    module = root / files.GENERATED / "kinematic_constant.py"
    module.write_text(module.read_text().replace("45045", "45046"))
    (root / files.GENERATED / "forgotten.py").write_text("")
    reports = "".join(files.differences(root, emitted))
    assert "-    p0 = sum0/45046" in reports
    assert f"{files.GENERATED}/forgotten.py: stale" in reports
    changed = files.write(root, emitted)
    assert sorted(changed) == [f"{files.GENERATED}/{name}.py" for name in ("forgotten", "kinematic_constant")]
    assert files.differences(root, emitted) == []


@pytest.mark.parametrize("name", WITH_FUNCTIONS)
def test_scalar_modules_import_nothing_but_math(name: str) -> None:
    """A library imported by an emitted scalar module would slow every start."""
    tree = ast.parse(scalar_module(derivation(name)))
    imported = {node.module for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)}
    assert not any(isinstance(node, ast.Import) for node in ast.walk(tree))
    assert imported <= {"__future__", "math"}


@pytest.mark.parametrize("name", WITH_FUNCTIONS)
def test_emitted_code_computes_the_derived_expression(name: str) -> None:
    """Run the emitted text on exact fractions and compare with SymPy: a lost bracket breaks this."""
    record = derivation(name)
    namespace: dict[str, Any] = {}
    exec(compile(scalar_module(record), name, "exec"), namespace)
    for function in record.functions:
        if function.series or any(_irrational(e) for _, e in function.assignments):
            continue
        values = [Fraction(k + 2, 2 * k + 5) for k in range(len(function.arguments))]
        exact = {a: sp.Rational(q.numerator, q.denominator) for a, q in zip(function.arguments, values, strict=True)}
        expected = [e.subs(exact) for e in function.substituted().values()]
        found = namespace[function.name](*values)
        assert [sp.Rational(f.numerator, f.denominator) for f in found] == expected


def _irrational(expression: sp.Expr) -> bool:
    """Whether roots, symbols as exponents or functions such as exp leave the rational numbers."""
    return (any(not power.exp.is_Integer for power in expression.atoms(sp.Pow))
            or any(not isinstance(function, sp.Abs) for function in expression.atoms(sp.Function)))


def test_imports_are_what_the_code_calls() -> None:
    """A function only spoken of in a docstring must not be imported; one that is called must be."""
    body = 'def f(x: float) -> float:\n    """Half of log1p(x), near cbrt(x)."""\n    return exp(x)/expm1(x)\n'
    assert called_functions([body]) == "exp, expm1"


def test_printer_keeps_brackets() -> None:
    """A product of squares in a denominator needs brackets; without them a/(b*b) becomes a/b*b."""
    a, b, c = sp.symbols("a b c", positive=True)
    assert python_source(a / b**2) == "a/(b*b)"
    assert python_source(a / (b * c)) == "a/(b*c)"
    assert python_source(sp.Rational(-3, 8) * a) == "-3*a/8"
    assert python_source(a / (b + c)) == "a/(b + c)"
    assert python_source((a + b) * c) == "c*(a + b)"
    assert python_source(sp.sqrt(a + b)) == "sqrt(a + b)"
    assert python_source(sp.Rational(1, 2) / sp.sqrt(a)) == "1/(2*sqrt(a))"
    assert python_source(a ** sp.Rational(2, 3)) == "a**(2/3)"
    assert python_source(a ** (2 * b)) == "a**(2*b)"


def test_emitted_files_name_no_place_and_no_time(emitted: dict[str, str]) -> None:
    """A path or a date in emitted text would differ from machine to machine."""
    for text in emitted.values():
        assert str(files.ROOT) not in text
        assert not re.search(r"(?<![\d.])20" + r"26(?!\d)", text)  # a year, not digits of a coefficient


def run(*arguments: str, seed: str = "random") -> subprocess.CompletedProcess[str]:
    """Run the command line of the derivations, with a seed for the order of sets."""
    command = [sys.executable, "-m", "derivations", *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=False,
                          env={**os.environ, "PYTHONHASHSEED": seed})


def test_hash_seed_changes_nothing() -> None:
    """An order taken from a set or a dict of symbols breaks this; tests of this process have another seed."""
    checked = run("check", seed="4242")
    assert (checked.returncode, checked.stdout) == (0, "Emitted files agree with the derivations.\n")


def test_command_line_lists() -> None:
    """A derivation that is missing in the list breaks this."""
    listed = CliRunner().invoke(app, ["list"])
    assert listed.exit_code == 0
    assert all(name in listed.stdout for name in names())


def test_command_line_shows() -> None:
    """Show knows three formats; an unknown name is one sentence and exit code 2."""
    for form, expected in (("text", "checked, 5 equalities"), ("latex", r"\frac{k_n}{9}"), ("python", "kn/9")):
        shown = run("show", "isotropic", "--format", form)
        assert shown.returncode == 0
        assert expected in shown.stdout
    unknown = run("show", "isotropy")
    assert (unknown.returncode, unknown.stdout) == (2, "")
    assert unknown.stderr.startswith("There is no derivation 'isotropy'.")
