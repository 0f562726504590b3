"""Functions for very many elements: economised polynomials, cube roots, and the two forms of the emitted text."""

from __future__ import annotations

import ast
from fractions import Fraction

import pytest
import sympy as sp
from mpmath import mp, mpf

from derivations import batch_constant, batch_kinetic
from derivations.catalogue import derivation
from derivations.economised import economise
from derivations.emit.batch import block_module, loop_module
from derivations.symbols import a, v

NAMES = ("kinematic_constant", "static_constant", "kinetic")


def value(coefficients: tuple[Fraction, ...] | list[Fraction], point: Fraction) -> Fraction:
    """Evaluate a polynomial without rounding."""
    total = Fraction(0)
    for coefficient in reversed(coefficients):
        total = total * point + coefficient
    return total


def test_economised_polynomials_stay_within_their_bound() -> None:
    """A wrong recurrence changes the polynomial; a bound that is too small is exceeded at some point."""
    taylor = [Fraction((-1) ** n, n + 1) for n in range(24)]
    low, high = Fraction(-1, 3), Fraction(1, 2)
    shorter, bound = economise(taylor, low, high, Fraction(1, 10**6))
    assert len(shorter) < 14
    assert bound < Fraction(1, 10**6)
    points = [low + (high - low) * Fraction(k, 40) for k in range(41)]
    worst = max(abs(value(shorter, point) - value(taylor, point)) for point in points)
    assert bound / 100 < worst <= bound
    assert economise(taylor, low, high, Fraction(0))[0] == tuple(taylor)


@pytest.mark.parametrize("m", range(6))
def test_integrals_keep_their_integer_and_their_accuracy(m: int) -> None:
    """The polynomial against 40 digits of the integral at both ends: too few terms show there."""
    table = batch_kinetic.series(m)
    assert table.coefficients[0] == batch_constant.integer_moment(m)
    assert 0 < table.left_out <= sp.Rational(1, 2**52)
    kept = [Fraction(int(c.p), int(c.q)) for c in table.coefficients]
    for end in (batch_kinetic.LOW, batch_kinetic.HIGH):
        with mp.workdps(40):
            at = mpf(end.numerator) / end.denominator
            exactly = batch_constant.DENOMINATOR * mp.quad(
                lambda x, at=at: (1 - x**2) ** (5 - m) * x ** (2 * m) * mp.cbrt(
                    (1 - at) ** 3 * (1 - x**2) + (1 + at) ** 3 * x**2), [0, 1])
            found = value(kept, end)
            error = abs(mpf(found.numerator) / found.denominator / exactly - 1)
        assert error < mpf(2) ** -53  # half of what may be left out: its bound adds up what never meets


def test_cube_roots_converge_on_their_whole_range() -> None:
    """A start, a series or a step that does not fit the others leaves an error above 2^-55 somewhere."""
    third, root = sp.Rational(1, 3), sp.Symbol("root")
    tables = {series.name: series for series in batch_kinetic.root_series()}
    low, high = batch_kinetic.ROOT_RANGE
    for k in range(41):
        known: dict[sp.Symbol, sp.Expr] = {a: sp.N(low * (high / low) ** sp.Rational(k, 40), 40),
                                           batch_kinetic.third: third}
        exactly = sp.cbrt(known[a])
        for symbol, expression in batch_kinetic.root_assignments(a, root):
            if expression.func.__name__ == "polynomial":
                at = known[expression.args[1]]
                coefficients = tables[expression.args[0].name].coefficients
                known[symbol] = sum(c * at**n for n, c in enumerate(coefficients))
            else:
                known[symbol] = expression.xreplace(known)
        assert abs(known[root] / exactly - 1) < sp.Rational(1, 2**55)


@pytest.mark.parametrize("name", NAMES)
def test_both_forms_hold_the_same_operations(name: str) -> None:
    """An operation printed in one form alone, or two forms with other coefficients, would give other bits."""
    record = derivation(name)
    loop, block = (ast.parse(module(record)) for module in (loop_module, block_module))

    def steps(tree: ast.Module) -> set[tuple[str, str]]:
        """Sums and products that are assigned to a name; polynomials and the gate differ in form on purpose."""
        return {(ast.unparse(node.targets[0]), ast.unparse(node.value)) for node in ast.walk(tree)
                if isinstance(node, ast.Assign) and isinstance(node.value, ast.BinOp)
                and isinstance(node.targets[0], ast.Name)}

    def numbers(tree: ast.Module) -> set[float]:
        return {float(node.value) for node in ast.walk(tree)
                if isinstance(node, ast.Constant) and isinstance(node.value, float)}

    shared = steps(block)
    assert len(shared) > 10
    assert shared <= steps(loop)
    assert numbers(loop) - numbers(block) <= {0.0}
    assert numbers(block) - numbers(loop) <= {0.0}


def test_the_contrast_is_kept_between_passes() -> None:
    """A value that a later pass needs and that is not kept would be one of another element."""
    text = loop_module(derivation("kinetic"))
    for name in (a.name, v.name, "level", "f0", "f5"):
        assert f"keep_{name}[i] = {name}\n" in text
        assert f"{name} = keep_{name}[i]\n" in text
    assert "keep_third" not in text
