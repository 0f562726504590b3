"""Code on the formula sheet runs by itself and gives what the library's functions and the derived expressions give."""

from __future__ import annotations

import ast
import inspect
import re
from collections.abc import Callable
from importlib import import_module
from typing import Any

import pytest
import sympy as sp

from derivations.catalogue import derivation, names
from derivations.emit.formulas import formula_fragment
from derivations.emit.snippets import HYPERGEOMETRIC, Snippet, output_functions, snippets

BLOCK = re.compile(r"^```(python|latex)\n(.*?)^```$", flags=re.MULTILINE | re.DOTALL)
TYPESET = re.compile(r"^\$\$\n(.*?)\n\$\$$", flags=re.MULTILINE | re.DOTALL)


def run(code: str) -> dict[str, Any]:
    """Run a piece of code in a fresh place, as a reader would who has copied nothing else."""
    place: dict[str, Any] = {}
    exec(compile(code, "snippet", "exec"), place)
    return place


STIFFNESS = {"C1111": 1.3, "C3333": 1.1, "C1133": 0.2, "C2323": 0.4, "C1212": 0.5}
"""A stiffness that is positive definite, with C3333 above C2323: waves have no speed in another one."""


def arguments(function: Callable[..., object]) -> list[float]:
    """Numbers at which every function is real: small, positive and all different."""
    asked = list(inspect.signature(function).parameters)
    return [STIFFNESS.get(name, 0.31 + 0.17 * k / len(asked)) for k, name in enumerate(asked)]


@pytest.mark.parametrize("name", names())
def test_copied_code_is_the_library(name: str) -> None:
    """Breaks when copied code lacks an import or a table, or computes another number than the emitted function."""
    record = derivation(name)
    derived = {function.name for function in output_functions(record)}
    emitted = import_module(f"granular.generated.{name}") if record.functions else None
    copied = [text for kind, text in BLOCK.findall(formula_fragment(record)) if kind == "python"]
    assert len(copied) == len(snippets(record))
    for one, text in zip(snippets(record), copied, strict=True):
        assert text.strip() == one.code.strip()
        if one.name not in derived:
            function = run(text)[one.name]
            values = arguments(function)
            assert function(*values) == getattr(emitted, one.name)(*values), one.name  # the same arithmetic


@pytest.mark.parametrize("name", names())
def test_copied_outputs_are_the_derived_ones(name: str) -> None:
    """Breaks when a derived expression is printed as other code: a lost bracket, a root taken for a power."""
    record = derivation(name)
    codes = {one.name: one for one in snippets(record)}
    for function in output_functions(record):
        code: Snippet = codes[function.name]
        called = run(code.code)[function.name]
        values = arguments(called)
        at = {symbol: sp.Float(value, 30) for symbol, value in zip(function.arguments, values, strict=True)}
        expected = [float(sp.N(expression.subs(at), 20)) for _, expression in function.assignments]
        assert called(*values) == pytest.approx(expected, rel=1e-13), function.name  # some dozens of roundings


def test_every_output_has_code() -> None:
    """Breaks when a derivation gains an output that nobody can copy."""
    for name in names():
        record = derivation(name)
        given = {symbol.name for function in (*record.functions, *output_functions(record))
                 for symbol in function.returns}
        assert {output.name for output in record.outputs} <= given, name


@pytest.mark.parametrize("name", names())
def test_copied_code_needs_nothing_but_mathematics(name: str) -> None:
    """Breaks when a piece of code imports this library, or anything that a reader would have to install."""
    for one in snippets(derivation(name)):
        tree = ast.parse(one.code)
        imported = {node.module for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)}
        assert imported <= {"math"}
        assert not any(isinstance(node, ast.Import) for node in ast.walk(tree))


@pytest.mark.parametrize("name", names())
def test_copied_latex_is_what_is_typeset(name: str) -> None:
    """Breaks when the LaTeX that a reader copies is not the formula beside it."""
    text = formula_fragment(derivation(name))
    copied = "\n".join(block for kind, block in BLOCK.findall(text) if kind == "latex")
    typeset = TYPESET.findall(text)
    assert typeset
    for formula in typeset:
        assert formula in copied


def test_the_series_on_the_sheet_is_gauss_s() -> None:
    """Breaks when the helper for hypergeometric functions is off beside z = 1 or for negative z."""
    hyper = run(HYPERGEOMETRIC)["hyper"]
    for z in (0.0, 0.3, 0.99, -0.5, -40.0):
        expected = float(sp.N(sp.hyper((sp.Rational(-1, 3), sp.Rational(5, 2)), (sp.Rational(7, 2),), sp.Float(z, 30))))
        assert hyper((-1 / 3, 2.5), (3.5,), z) == pytest.approx(expected, rel=1e-12)  # up to 1e4 terms are added
