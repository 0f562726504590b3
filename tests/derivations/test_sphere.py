"""Averages over directions against integrals done the long way."""

from __future__ import annotations

import itertools

import pytest
import sympy as sp

from derivations.sphere import (
    axial_moment,
    azimuth_mean,
    circle_mean,
    homogeneous,
    meridian_form,
    monomial_mean,
    sphere_mean,
)
from derivations.symbols import cos_alpha, s, sin_alpha, sin_beta, x, y

ANGLE = sp.Symbol("angle", real=True)


@pytest.mark.parametrize(("i", "j"), list(itertools.product(range(5), range(5))))
def test_axial_moment_is_the_integral(i: int, j: int) -> None:
    """A wrong factor in the product formula breaks this: the integral is expanded and done term by term."""
    assert axial_moment(i, j) == sp.integrate(sp.expand((1 - x**2) ** i * x ** (2 * j)), (x, 0, 1))


@pytest.mark.parametrize(("a", "b"), [(0, 0), (2, 0), (2, 2), (4, 0), (4, 2), (1, 2), (3, 1)])
def test_circle_mean_is_the_integral(a: int, b: int) -> None:
    """A wrong double factorial breaks this."""
    integral = sp.integrate(sp.cos(ANGLE) ** a * sp.sin(ANGLE) ** b, (ANGLE, 0, 2 * sp.pi))
    assert circle_mean(a, b) == sp.simplify(integral / (2 * sp.pi))


@pytest.mark.parametrize("powers", list(itertools.product(range(0, 7, 2), repeat=3)))
def test_sphere_mean_from_circle_and_axis(powers: tuple[int, int, int]) -> None:
    """Averaging about the axis and then along it must give the average over the sphere."""
    a, b, c = powers
    assert monomial_mean(a, b, c) == circle_mean(a, b) * axial_moment((a + b) // 2, c // 2)


def test_mean_of_the_square_is_one() -> None:
    """N is a unit vector: the average of (n.n)^3 is one."""
    n = sp.symbols("n1:4", real=True)
    assert sphere_mean(sp.expand(sum(c**2 for c in n) ** 3), n) == 1


def test_filling_up_the_degree_keeps_the_value() -> None:
    """Powers of s + y = 1 may be added at will; a wrong binomial changes the value."""
    form = 3 + 2 * s * y - y**2
    filled = sum(c * s ** (4 - k) * y**k for k, c in enumerate(homogeneous(form, 4)))
    assert sp.expand((filled - form).subs(s, 1 - y)) == 0


def test_odd_powers_are_refused() -> None:
    """An odd power means that the azimuth was not averaged; silently dropping it would be wrong."""
    with pytest.raises(ValueError, match="odd power"):
        meridian_form(sin_beta * x)
    assert azimuth_mean(sin_alpha * cos_alpha**2 * x) == 0
