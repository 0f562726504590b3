"""Each limit of the stiffness with contact forces, held against the integral itself close to the limit."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import mpmath
import pytest
import sympy as sp

from derivations.kinetic_limits import (
    DEGREE,
    ONSET_SLIP,
    ONSET_STICK,
    at_equator_only,
    at_pole_only,
    kinetic_limits,
    little_slip,
    sticking_at_equator,
    sticking_at_pole,
    t,
    weak_components,
)
from derivations.kinetic_limits import size as difference
from derivations.symbols import a, c, lam, mu

mp = mpmath.mp.clone()
mp.dps = 40
THIRD = mp.mpf(1) / 3


def number(expression: sp.Expr) -> Any:
    """A SymPy number in 40 digits."""
    return mp.mpf(str(sp.N(expression, 45)))


def moment(index: int, stiffness: Callable[[Any], Any], points: tuple[Any, ...] = ()) -> Any:
    """Integral of s^(6-k) x^(2k) times a stiffness that depends on beta."""
    def integrand(beta: Any) -> Any:
        return mp.sin(beta) ** (13 - 2 * index) * mp.cos(beta) ** (2 * index) * stiffness(beta)

    return mp.quad(integrand, sorted({mp.mpf(0), mp.pi / 2, *points}))


def force(first: Any, last: Any) -> Callable[[Any], Any]:
    """Normal force."""
    return lambda beta: first * mp.sin(beta) ** 2 + last * mp.cos(beta) ** 2


@pytest.mark.parametrize("exact_lam", [sp.Rational(158, 179), sp.Rational(2, 3), sp.Integer(1)], ids=str)
def test_nearly_equal_forces(exact_lam: sp.Rational) -> None:
    """At tau = 1e-6 the components from quadrature must leave nothing above the third order, 1e-18."""
    tau = mp.mpf(10) ** -6

    def weighted(of_s: int, of_y: int) -> Any:
        return mp.quad(lambda x: (1 - x * x) ** of_s * x ** (2 * of_y) * mp.cbrt(1 + tau * x * x), [0, 1])

    p = [weighted(2 - k, k) for k in range(3)]
    ratio = number(exact_lam)
    direct = (3 * p[0] / 8 + ratio * (p[0] / 8 + p[1] / 2), p[2] + ratio * p[1], (1 - ratio) * p[0] / 8,
              (1 - ratio) * p[1] / 2, (1 - ratio) * p[1] / 2 + ratio * (p[0] / 8 + 3 * p[1] / 8 + p[2] / 4),
              (1 - ratio) * p[0] / 8 + ratio * (p[0] + p[1]) / 4)
    for found, expected in zip(weak_components(), direct, strict=True):
        value = number(found.subs({lam: exact_lam, t: sp.Rational(1, 10**6)}))
        assert abs(value - expected) < tau**3 / 50


@pytest.mark.parametrize("index", range(DEGREE + 1))
def test_overwhelming_stress(index: int) -> None:
    """At c/a = 1e30 and 1e-30 the limit holds to a power of the ratio; a shifted beta argument would be far off."""
    ratio = mp.mpf(10) ** -30
    points = tuple(mp.mpf(10) ** -j for j in (15, 12, 9, 6, 3))
    far = tuple(mp.pi / 2 - point for point in points)
    along = moment(index, lambda beta: mp.cbrt(force(ratio, 1)(beta)), points=far)
    across = moment(index, lambda beta: mp.cbrt(force(1, ratio)(beta)), points=points)
    assert abs(along / number(at_pole_only(index)) - 1) < 1e-20
    assert abs(across / number(at_equator_only(index)) - 1) < 1e-20


@pytest.mark.parametrize("index", range(DEGREE + 1))
def test_large_friction(index: int) -> None:
    """At mu = 1e15 what slip takes away must agree to 1/mu."""
    first, last, friction = mp.mpf(1), mp.mpf(4), mp.mpf(10) ** 15

    def lost(beta: Any) -> Any:
        full = force(first, last)(beta)
        shear = (last - first) * mp.sin(beta) * mp.cos(beta) / friction
        rest = mp.cbrt(full - shear)
        return shear / (mp.cbrt(full) ** 2 + mp.cbrt(full) * rest + rest**2)

    expected = (last - first) / friction * number(little_slip(index).subs({a: 1, c: 4}))
    assert abs(moment(index, lost) / expected - 1) < 1e-14


def margin(first: Any, last: Any, friction: Any, beta: Any) -> Any:
    """Normal force less shear force over friction."""
    return force(first, last)(beta) - abs(last - first) * mp.sin(beta) * mp.cos(beta) / friction


@pytest.mark.parametrize("index", [0, 1, 5, 6])
def test_small_friction(index: int) -> None:
    """At mu = 1e-12 the two sticking caps must hold all of H_k; the power of mu decides which cap is left."""
    first, last, friction = mp.mpf(2), mp.mpf(3), mp.mpf(10) ** -12

    def share(beta: Any) -> Any:
        return mp.cbrt(max(margin(first, last, friction, beta), mp.mpf(0)))

    # tan(beta) at the two edges are the roots of a t^2 - |d| t/mu + c
    gap = (last - first) / friction
    large = (gap + mp.sqrt(gap**2 - 4 * first * last)) / 2
    inner, outer = mp.atan(last / large), mp.atan(large / first)
    at = {a: 2, c: 3, mu: sp.Rational(1, 10**12), difference: 1}
    expected = sum(number(cap(index).subs(at).rewrite(sp.gamma)) for cap in (sticking_at_equator, sticking_at_pole))

    # the edge is a cube root: with z^3 as the distance from it the integrand is smooth
    def cap(start: Any, sign: int, width: Any) -> Any:
        def integrand(z: Any) -> Any:
            beta = start + sign * width * z**3
            weight = mp.sin(beta) ** (13 - 2 * index) * mp.cos(beta) ** (2 * index)
            return weight * share(beta) * 3 * z**2 * width / expected

        return mp.quad(integrand, [0, 1])

    assert abs(cap(inner, -1, inner) + cap(outer, 1, mp.pi / 2 - outer) - 1) < 1e-11


def test_no_slip_between_equal_forces() -> None:
    """With a = c the margin is the normal force itself, whatever the friction."""
    assert margin(mp.mpf(2), mp.mpf(2), mp.mpf(10) ** -30, mp.mpf(1)) == pytest.approx(2)


@pytest.mark.parametrize(("constant", "sign"), [(ONSET_STICK, 1), (ONSET_SLIP, -1)], ids=["stick", "slip"])
def test_constants_of_the_onset(constant: sp.Expr, sign: int) -> None:
    """The continued integrals against the convergent difference that defines them; w = z^3 from the edge on."""
    def difference_from_power(w: Any) -> Any:
        return mp.cbrt(max(w * w + sign, mp.mpf(0))) - mp.cbrt(w * w)

    inside = mp.quad(lambda w: difference_from_power(w**3) * 3 * w * w, [0, 1])
    middle = mp.quad(lambda z: difference_from_power(1 + z**3) * 3 * z * z, [0, 1])

    # beyond w = 2: w = z^-3, and the difference of the roots without cancellation
    def tail(z: Any) -> Any:
        w = z**-3
        larger, smaller = mp.cbrt(w * w + sign), mp.cbrt(w * w)
        return sign / (larger**2 + larger * smaller + smaller**2) * 3 * z**-4

    outside = mp.quad(tail, [0, mp.cbrt(mp.mpf(1) / 2)])
    assert abs(2 * (inside + middle + outside) / number(constant) - 1) < 1e-15


@pytest.mark.parametrize("slides", [False, True], ids=["stick", "slip"])
def test_onset_of_sliding(slides: bool) -> None:
    """H_2 near mu = 3/4, a = 1, c = 4: the change must follow |delta|^(5/6) with K; any other exponent is far off."""
    first, last, index = mp.mpf(1), mp.mpf(4), 2
    friction = mp.mpf(3) / 4 * (1 - mp.mpf(10) ** -21 if slides else 1 + mp.mpf(10) ** -21)

    def mohr(coefficient: Any) -> tuple[Any, Any, Any]:
        radius = (last - first) / 2 * mp.sqrt(1 + 1 / coefficient**2)
        square = 4 * first * last * coefficient**2 - (last - first) ** 2
        least = square / (4 * coefficient**2 * ((first + last) / 2 + radius))
        return least, radius, mp.pi / 2 - mp.atan(1 / coefficient) / 2

    def sharing(coefficient: Any) -> Callable[[Any], Any]:
        least, radius, center = mohr(coefficient)
        return lambda beta: mp.cbrt(max(least + 2 * radius * mp.sin(beta - center) ** 2, mp.mpf(0)))

    least, radius, center = mohr(friction)
    edge = mp.sqrt(abs(least) / (2 * radius))
    offsets = [edge, *(mp.mpf(10) ** -j for j in range(1, 11))]
    points = tuple(center + side * offset for side in (-1, 1) for offset in offsets
                   if 0 < center + side * offset < mp.pi / 2)
    change = moment(index, sharing(friction), points=(*points, center)) - moment(
        index, sharing(mp.mpf(3) / 4), points=(*points, center))
    predicted = (number(ONSET_SLIP if slides else ONSET_STICK) * abs(least) ** (mp.mpf(5) / 6) / mp.sqrt(2 * radius)
                 * mp.sin(center) ** (13 - 2 * index) * mp.cos(center) ** (2 * index))
    assert abs(change / predicted - 1) < 0.01


def test_every_limit_is_claimed() -> None:
    """A limit without a claim would be an assertion."""
    assert all(step.claims for step in kinetic_limits().steps)
