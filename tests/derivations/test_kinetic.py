"""Moments of the kinetic fabric: four closed forms of one integral against quadrature, and the emitted arithmetic."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from fractions import Fraction
from functools import cache
from typing import Any

import mpmath
import pytest
import sympy as sp

from derivations.emit.scalar import scalar_module
from derivations.kinematic import closed_moments as constant_moments
from derivations.kinematic import weight_form
from derivations.kinetic import elliptic_moment, kinetic, kinetic_moment, kinetic_moment_from_pole, power_integrals
from derivations.kinetic_series import DEGREE, PRECISION, SOFT, STIFF, condition, series
from derivations.symbols import D33, D3333, Dr33, a, c, e0, e1, e2, w0, w1

FORCES = [(sp.Rational(3, 2), sp.Rational(3, 10)), (sp.Rational(9, 10), sp.Rational(13, 10)), (sp.Integer(1), 40)]

mp = mpmath.mp.clone()
mp.dps = 30
THIRD = mp.mpf(1) / 3


def number(value: Any) -> Any:
    """A rational in 30 digits."""
    exact = sp.Rational(value)
    return mp.mpf(int(exact.p)) / int(exact.q)


@cache
def by_quadrature(index: int, at_equator: sp.Rational, at_pole: sp.Rational, power: int, degree: int) -> Any:
    """The integral itself, in 30 digits."""
    first, last = number(at_equator), number(at_pole)
    return mp.quad(lambda x: (1 - x * x) ** (degree - index) * x ** (2 * index)
                   * (first * (1 - x * x) + last * x * x) ** (power * THIRD), [0, 0.5, 1])


def close(value: sp.Expr, expected: Any, digits: int = 25) -> bool:
    """Agreement of a SymPy number with an integral."""
    return bool(abs(mp.mpf(str(sp.N(value, 30))) / expected - 1) < mp.mpf(10) ** -digits)


def test_sympy_finds_the_hypergeometric_function() -> None:
    """SymPy's own integration of one power must give the function that the ratio of the terms identifies."""
    x, t = sp.symbols("x t", positive=True)
    found = sp.integrate(x**2 * (1 + t * x**2) ** sp.Rational(1, 3), (x, 0, 1))
    upper, lower = (-sp.Rational(1, 3), sp.Rational(3, 2)), (sp.Rational(5, 2),)
    assert sp.simplify(found - sp.hyper(upper, lower, t * sp.exp_polar(sp.I * sp.pi)) / 3) == 0


@pytest.mark.parametrize("forces", FORCES, ids=str)
def test_closed_forms_against_quadrature(forces: tuple[sp.Rational, sp.Rational]) -> None:
    """A wrong parameter, outer factor, sign in the recurrence or branch of F shows in some m."""
    at = dict(zip((a, c), forces, strict=True))
    for index in range(7):
        expected = by_quadrature(index, *forces, 1, 6)
        assert close(kinetic_moment(index).subs(at), expected)
        assert close(kinetic_moment_from_pole(index).subs(at), expected)
        assert close(sp.N(elliptic_moment(index, *forces), 45), expected, 20)
    for index in range(5):
        assert close(kinetic_moment(index, SOFT, 4).subs(at), by_quadrature(index, *forces, -1, 4))
        assert close(kinetic_moment_from_pole(index, SOFT, 4).subs(at), by_quadrature(index, *forces, -1, 4))


def test_one_legendre_integral_is_enough() -> None:
    """Any power integral must lead back to the same single F; an E or a second modulus would be a different claim."""
    for difference, parameter in ((sp.Integer(3), (2 - sp.sqrt(3)) / 4), (-sp.Rational(1, 2), (2 + sp.sqrt(3)) / 4)):
        found = set().union(*(value.atoms(sp.elliptic_f) for value in power_integrals(difference, 7)))
        assert len(found) == 1
        assert sp.simplify(found.pop().args[1] - parameter) == 0


@pytest.mark.parametrize("power", [STIFF, SOFT], ids=str)
def test_series_bound_and_condition(power: sp.Rational) -> None:
    """A table cut too early, or an outer factor that makes the terms cancel, breaks this."""
    for index in range(DEGREE[power] + 1):
        assert series(power, index).left_out < PRECISION
        assert max(condition(power, index, sp.Rational(k, 4)) for k in range(-2, 3)) < 1.83


@cache
def emitted() -> dict[str, Callable[..., tuple[float, ...]]]:
    """The emitted scalar functions."""
    namespace: dict[str, Any] = {}
    exec(compile(scalar_module(kinetic()), "kinetic", "exec"), namespace)
    return namespace


FABRICS = [(Fraction(-1), Fraction(-1)), (Fraction(-1), Fraction(2)), (Fraction(2), Fraction(-1)),
           (Fraction(2), Fraction(2)), (Fraction(0), Fraction(0)), (Fraction(3, 10), Fraction(-3, 10))]
CONTRASTS = (-0.5, -0.2, 0.0, 2.0**-30, 0.3, 0.5)


@pytest.mark.parametrize(("fabric", "contrast"), list(itertools.product(FABRICS, CONTRASTS)), ids=str)
def test_emitted_moments(fabric: tuple[Fraction, Fraction], contrast: float) -> None:
    """Exact fabric and forces in: rounding stays below 4.5 units of 2^-53, which 12,000 fabrics never exceeded."""
    forces = Fraction((1 - contrast) ** 2), Fraction((1 + contrast) ** 2)
    exact = tuple(sp.Rational(f.numerator, f.denominator) for f in forces)
    values = {D33: sp.Rational(*fabric[0].as_integer_ratio()), Dr33: sp.Rational(*fabric[1].as_integer_ratio()),
              D3333: 0}
    end = {e0: (2 - values[D33]) / 2, e1: (4 + values[D33]) / 2, e2: 1 + values[D33],
           w0: (2 - values[Dr33]) / 2, w1: 1 + values[Dr33]}
    weights = [number(weight.subs(end)) for weight in weight_form()]
    density = [number(end[e]) for e in (e0, e1, e2)]
    found = emitted()["kinetic_moments"](fabric[0], Fraction(0), fabric[1], *forces, forces[1] - forces[0])
    soft = emitted()["kinetic_static_moments"](fabric[0], Fraction(0), *forces, forces[1] - forces[0])
    for row in range(3):
        expected = sum(o * by_quadrature(j + row, *exact, 1, 6) for j, o in enumerate(weights))
        assert abs(found[row] - expected) <= 4.5 * 2.0**-53 * expected
        expected = sum(e * by_quadrature(j + row, *exact, -1, 4) for j, e in enumerate(density))
        assert abs(soft[row] - expected) <= 4.5 * 2.0**-53 * expected


def test_equal_forces_give_constant_stiffness() -> None:
    """With a = c = 1 the emitted moments are those for constant stiffness, rounded once."""
    fabric = Fraction(3, 10), Fraction(1, 20), Fraction(-3, 10)
    found = emitted()["kinetic_moments"](*fabric, Fraction(1), Fraction(1), Fraction(0))
    at = {symbol: sp.Rational(*f.as_integer_ratio()) for symbol, f in zip((D33, D3333, Dr33), fabric, strict=True)}
    exact = [m.subs(at) for m in constant_moments()]
    assert list(found) == [float(Fraction(int(m.p), int(m.q))) for m in exact]


def test_the_difference_of_the_forces_enters_by_itself() -> None:
    """Taken as c - a it would vanish here; as an argument it gives the slope, <s^2 (x^2 - s)>/6 = -4/63."""
    run, step = emitted()["kinetic_moments"], 2.0**-20
    rise = run(0.0, 0.0, 0.0, 1.0, 1.0, step)[0] - run(0.0, 0.0, 0.0, 1.0, 1.0, -step)[0]
    assert abs(rise / (2 * step) + 4 / 63) < 2.0**-53 / step
