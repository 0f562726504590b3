"""The three Legendre forms: proved step by step, and held against quadrature and the complete integrals."""

from __future__ import annotations

import mpmath
import pytest
import sympy as sp

from derivations.legendre import complete, elliptic_identity_steps, first_kind

SIGN = {1: 1, 2: -1, 3: -1}


@pytest.mark.parametrize("number", [0, 1, 2])
def test_identity_is_proved(number: int) -> None:
    """A wrong modulus, amplitude or scale leaves a residual in the squared slope."""
    step = elliptic_identity_steps()[number]
    assert step.claims and step.holds()


@pytest.mark.parametrize(("kind", "start", "limit"), [
    (1, 1, sp.Rational(11, 10)), (1, 1, sp.Integer(20)), (2, 1, sp.Rational(9, 10)), (2, 1, sp.Integer(-3)),
    (3, -1, sp.Rational(-9, 10)), (3, -1, sp.Integer(8)),
])
def test_against_quadrature(kind: int, start: int, limit: sp.Rational) -> None:
    """The amplitude taken on the wrong branch would pass every derivative and fail here.

    With y = start +- u^2 the radicand is u^2 (3 +- 3 u^2 + u^4), so no root is left; 25 digits come without effort.
    """
    with mpmath.workdps(40):
        end = mpmath.sqrt(abs(mpmath.mpf(limit.p) / limit.q - start))
        expected = mpmath.quad(lambda u: 2 / mpmath.sqrt(3 + SIGN[kind] * 3 * u**2 + u**4), [0, 1, end])
        assert abs(mpmath.mpf(sp.N(first_kind(kind, limit), 40)) - expected) < mpmath.mpf(10) ** -25


@pytest.mark.parametrize("kind", [2, 3])
def test_complete_integral(kind: int) -> None:
    """A scale that is off, or an amplitude that misses its end, breaks this: F at zero is a beta function."""
    assert abs(sp.N(first_kind(kind, sp.Integer(0)) - complete(kind), 40)) < sp.Float("1e-38", 40)


def test_complete_integral_to_infinity() -> None:
    """F(pi) with k = sin 15 deg is 2 K, which must equal the beta function of the first kind."""
    cosine = sp.limit((sp.sqrt(3) + 1 - sp.Symbol("Y")) / (sp.sqrt(3) - 1 + sp.Symbol("Y")), sp.Symbol("Y"), sp.oo)
    whole = sp.Integer(3) ** sp.Rational(-1, 4) * sp.elliptic_f(sp.acos(cosine), (2 - sp.sqrt(3)) / 4)
    assert abs(sp.N(whole - complete(1), 40)) < sp.Float("1e-38", 40)
