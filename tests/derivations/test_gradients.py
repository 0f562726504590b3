"""Slopes carried through assignments against SymPy's derivatives; series against the integrals that they stand for."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import pytest
import sympy as sp
from mpmath import mp

from derivations import gradients_batch, gradients_series
from derivations.emit.scalar import scalar_module
from derivations.forward import slope_of, slope_symbol, with_slopes
from derivations.gradients import closed_components, gradients
from derivations.symbols import D33, STIFFNESS, Dr33, nu, p0, p1

u, w = sp.symbols("u w", real=True)


@pytest.fixture(scope="module")
def emitted() -> dict[str, Callable[..., Any]]:
    """The emitted scalar functions."""
    namespace: dict[str, Any] = {}
    exec(compile(scalar_module(gradients()), "gradients", "exec"), namespace)
    return namespace


def test_forward_slopes_are_derivatives() -> None:
    """A product, a quotient and a chain of three; a slope that is zero has no assignment."""
    calculation = ((p0, u**2 / (1 + w)), (p1, p0 * u + w), (sp.Symbol("end"), p1 / p0))
    carried = dict(with_slopes(calculation, (u, w)))
    whole: dict[sp.Symbol, sp.Expr] = {}
    for symbol, expression in carried.items():
        whole[symbol] = expression.xreplace(whole)
    for symbol, _ in calculation:
        for variable in (u, w):
            name = slope_symbol(symbol, variable)
            assert sp.simplify(whole[name] - sp.diff(whole[symbol], variable)) == 0
    alone = with_slopes(((p0, u**2),), (u, w))
    with pytest.raises(KeyError, match="no slope by w"):
        slope_of(alone, p0, w)


@pytest.mark.parametrize("state", [
    (0, 0, Fraction(1, 5)), (-1, Fraction(3, 2), 0), (2, Fraction(-9, 10), Fraction(1, 2))])
def test_emitted_slopes_of_the_closed_form_are_exact(emitted: dict[str, Callable[..., Any]],
                                                     state: tuple[Fraction, ...]) -> None:
    """Fractions in, fractions out, at the ends of the domain too."""
    exact = dict(zip((D33, Dr33, nu), map(sp.Rational, state), strict=True))
    found = emitted["kinematic_constant_gradient"](*map(Fraction, state))
    closed = closed_components()
    wanted = [sp.Rational(form.subs(exact)) for form in closed]
    wanted += [sp.diff(form, variable).subs(exact) for variable in (D33, Dr33, nu) for form in closed]
    assert [sp.Rational(value.numerator, value.denominator) for value in found] == wanted


def test_static_slope_is_that_of_the_inverse(emitted: dict[str, Callable[..., Any]]) -> None:
    """Differences of the emitted inverse in fractions, the step so small that only its square is left."""
    from derivations.kinetic_components import kinetic_components

    namespace: dict[str, Any] = {}
    exec(compile(scalar_module(kinetic_components()), "kinetic_components", "exec"), namespace)
    inverse = namespace["stiffness_from_flexibilities"]
    state = [Fraction(k + 3, 7) for k in range(8)] + [Fraction(1, 3)]
    change = [Fraction((-1) ** k, k + 2) for k in range(9)]
    h = Fraction(1, 10**9)
    ahead, behind = (inverse(*(value + sign * h * step for value, step in zip(state, change, strict=True)))
                     for sign in (1, -1))
    found = emitted["static_slope"](*state, *change)
    for a, b, slope in zip(ahead, behind, found, strict=True):
        assert abs((a - b) / (2 * h) - slope) < Fraction(1, 10**15)


@pytest.mark.parametrize(("series", "limits"), [
    (gradients_series.economised, (-0.5, 0.5)), (gradients_batch.series, (-0.351, 0.291))])
def test_series_are_their_integrals(series: Callable[[int], Any], limits: tuple[float, float]) -> None:
    """A coefficient of the wrong degree, or a cut that leaves out too much, at both ends of the range."""
    power = 2 if series is gradients_series.economised else 3
    scale = 1 if power == 2 else gradients_batch.DENOMINATOR
    with mp.workdps(30):
        for end in limits:
            contrast = mp.mpf(end)
            a, c = (1 - contrast) ** power, (1 + contrast) ** power
            for m in (0, 3, 6):
                exact = mp.quad(lambda x, m=m, a=a, c=c: (1 - x * x) ** (6 - m) * x ** (2 * m)
                                * (a * (1 - x * x) + c * x * x) ** (-mp.mpf(2) / 3), [0, 0.5, 1])
                found = sum(mp.mpf(int(k.p)) / int(k.q) * contrast**n for n, k in enumerate(series(m).coefficients))
                # the two cuts are at 2^-57 and at 2^-55 of the least value
                assert abs(found / (int(scale) * exact) - 1) < 2.0**-54


def test_slopes_come_in_the_order_of_their_names() -> None:
    """The numeric side takes results by place: components first, then six slopes by each parameter."""
    for one in gradients_batch.batch():
        names = [symbol.name for symbol in one.function.returns]
        assert names == [*(symbol.name for symbol in STIFFNESS),
                         *(f"{symbol.name}_{variable}" for variable in ("D33", "Dr33", "SR", "mu", "nu")
                           for symbol in STIFFNESS)]
