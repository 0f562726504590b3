"""Moments of the shear stiffness of slipping contacts in closed form: elementary terms and Legendre F, never E.

Turned to the direction nearest to sliding, what is left of the normal force is h0 + 2R sin^2(omega). Even powers of
sin(omega) are integrated in y = sin(omega), odd ones in z = cos(omega).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

import sympy as sp

from derivations import legendre
from derivations.kinetic import power_integrals
from derivations.sphere import axial_moment

THIRD = sp.Rational(1, 3)

DEGREE = 5
"""Degree in s and y of what is averaged with the cube root when the density is of rank two: six moments."""

sine_star, cosine_star = sp.symbols("sin_star cos_star", positive=True)
sine, cosine = sp.symbols("sin_omega cos_omega", real=True)

Moments = Sequence[sp.Expr]


@dataclass(frozen=True)
class Arc:
    """Sticking contacts on one side of the direction nearest to sliding.

    Attributes
    ----------
    side : int
        +1 towards the equator, -1 towards the pole.
    even, odd : sequence of sympy.Expr
        Integrals of y^(2i) in y = sin(omega) and of z^(2i) in z = cos(omega) with the cube root, i = 0, 1, ...
    """

    side: int
    even: Moments
    odd: Moments


@cache
def rotated_form(index: int, side: int, degree: int = DEGREE) -> tuple[sp.Expr, ...]:
    """Coefficients of sin^j cos^(n-j) of omega in sin(beta)^(n-2m) cos(beta)^(2m), n = 2 degree + 1.

    ``side`` is the sign of omega, so that sin(omega) is positive on both sides.
    """
    _, sin_w, cos_w, at_equator, at_pole = sp.ring("sin_w cos_w at_equator at_pole", sp.QQ)
    power = 2 * degree + 1
    form = ((at_equator * cos_w + side * at_pole * sin_w) ** (power - 2 * index)
            * (at_pole * cos_w - side * at_equator * sin_w) ** (2 * index))
    found: list[sp.Expr] = [sp.Integer(0)] * (power + 1)
    for (of_sine, _, of_equator, of_pole), coefficient in form.terms():
        found[of_sine] += sp.Rational(int(coefficient)) * sine_star**of_equator * cosine_star**of_pole
    return tuple(found)


def moment(index: int, arcs: Sequence[Arc], degree: int = DEGREE,
           at: dict[sp.Symbol, sp.Expr] | None = None) -> sp.Expr:
    """Put one moment together from the integrals over the arcs.

    Parameters
    ----------
    index : int
        m of s^(degree-m) x^(2m).
    arcs : sequence of Arc
        One or two.
    degree : int
        Degree in s and x^2.
    at : dict, optional
        Values of ``sine_star`` and ``cosine_star``; they stay symbols by default.
    """
    total: sp.Expr = sp.Integer(0)
    for arc in arcs:
        for j, coefficient in enumerate(rotated_form(index, arc.side, degree)):
            rest = (2 * degree - j) // 2 if j % 2 == 0 else (j - 1) // 2
            integrals, first = (arc.even, j // 2) if j % 2 == 0 else (arc.odd, (2 * degree + 1 - j) // 2)
            weight = coefficient.subs(at) if at else coefficient
            total += weight * sum(((-1) ** q * sp.binomial(rest, q) * integrals[first + q] for q in range(rest + 1)),
                                  sp.Integer(0))
    return total


def integrals_from_start(end: sp.Expr, constant: sp.Expr, slope: sp.Expr, count: int) -> tuple[sp.Expr, ...]:
    """Integrals of y^(2i) (constant + slope y^2)^(1/3) over y from 0 to ``end``, constant > 0, by one F."""
    scaled = power_integrals(slope * end**2 / constant, count)
    return tuple(constant**THIRD * end ** (2 * i + 1) * integral for i, integral in enumerate(scaled))


def integrals_from_root(end: sp.Expr, root: sp.Expr, slope: sp.Expr, count: int) -> tuple[sp.Expr, ...]:
    """Integrals of y^(2i) (slope (y^2 - root^2))^(1/3) over y from ``root`` to ``end``, by two F of the third kind."""
    ratio = end / root
    margin = (ratio**2 - 1) ** THIRD
    left = sp.Rational(3, 2) * (legendre.first_kind(3, margin) - legendre.first_kind(3, sp.Integer(0)))
    found = [sp.Rational(3, 5) * ratio * margin - sp.Rational(2, 5) * left]
    for i in range(1, count):
        found.append((ratio ** (2 * i - 1) * margin**4 + (2 * i - 1) * found[-1]) / (2 * i + sp.Rational(5, 3)))
    return tuple(slope**THIRD * root ** (2 * i + sp.Rational(5, 3)) * value for i, value in enumerate(found))


def integrals_to_root(constant: sp.Expr, slope: sp.Expr, count: int) -> tuple[sp.Expr, ...]:
    """Integrals of z^(2i) (constant - slope z^2)^(1/3) over z from 0 to the root of the bracket: beta functions."""
    root = sp.sqrt(constant / slope)
    four_thirds = sp.Rational(4, 3)
    return tuple(constant**THIRD * root ** (2 * i + 1) * sp.beta(i + sp.Rational(1, 2), four_thirds) / 2
                 for i in range(count))


def integrals_at_tangency(end: sp.Expr, slope: sp.Expr, count: int) -> tuple[sp.Expr, ...]:
    """Integrals of y^(2i) (slope y^2)^(1/3) over y from 0 to ``end``: elementary."""
    powers = (2 * i + sp.Rational(5, 3) for i in range(count))
    return tuple(slope**THIRD * end**power / power for power in powers)


def slip_moments(equator: sp.Expr, pole: sp.Expr, friction: sp.Expr, degree: int = DEGREE,
                 digits: int | None = None) -> tuple[sp.Expr, ...]:
    """Integrals of s^(degree-m) x^(2m) max(f_n - f_r/mu, 0)^(1/3) over x from 0 to 1, m = 0 to ``degree``.

    Parameters
    ----------
    equator, pole, friction : sympy.Expr
        Rational a, c (not both negative) and mu > 0; f_n = a s + c x^2, f_r = |c - a| x sqrt(s).
    degree : int
        5 for a density of rank two, 6 for one of rank four.
    digits : int, optional
        Working precision; exact expressions by default. Sticking or sliding is decided exactly either way.

    Returns
    -------
    tuple of sympy.Expr
        Closed forms, or numbers that carry ``digits`` less what the binomial sums cancel.
    """
    equator, pole, friction = (sp.Rational(value) for value in (equator, pole, friction))
    if equator == pole:
        return tuple(_number(equator, digits) ** THIRD * axial_moment(degree - k, k) for k in range(degree + 1))
    slides = sp.sign((pole - equator) ** 2 - 4 * equator * pole * friction**2)
    sign = 1 if pole > equator else -1
    a, c, mu = (_number(value, digits) for value in (equator, pole, friction))
    sine_phi = mu / sp.sqrt(1 + mu**2)
    to_equator, to_pole = sp.sqrt((1 + sign * sine_phi) / 2), sp.sqrt((1 - sign * sine_phi) / 2)
    middle, amplitude = (a + c) / 2, abs(c - a) / 2 * sp.sqrt(1 + 1 / mu**2)
    most = middle + amplitude
    least = _number(4 * equator * pole * friction**2 - (pole - equator) ** 2, digits) / (4 * mu**2 * most)
    arcs, count = [], degree + 1
    for side, end, other, force in ((1, to_pole, to_equator, equator), (-1, to_equator, to_pole, pole)):
        if slides > 0 and force <= 0:
            continue  # no contact sticks on this side
        before = integrals_from_start(other, most, -2 * amplitude, count)
        if slides < 0:
            even = integrals_from_start(end, least, 2 * amplitude, count)
            whole = integrals_from_start(_number(sp.Integer(1), digits), most, -2 * amplitude, count)
        else:
            even = (integrals_from_root(end, sp.sqrt(-least / (2 * amplitude)), 2 * amplitude, count) if slides > 0
                    else integrals_at_tangency(end, 2 * amplitude, count))
            whole = integrals_to_root(most, 2 * amplitude, count)
        odd = tuple(w - b for w, b in zip(whole, before, strict=True))
        arcs.append(Arc(side, _numbers(even, digits), _numbers(odd, digits)))
    at = {sine_star: to_equator, cosine_star: to_pole}
    return tuple(moment(index, arcs, degree, at) for index in range(degree + 1))


def evaluate_slip_moments(equator: sp.Expr, pole: sp.Expr, friction: sp.Expr, degree: int = DEGREE,
                          digits: int = 30) -> tuple[sp.Float, ...]:
    """Evaluate the closed forms until two working precisions agree to ``digits``.

    Raises
    ------
    ArithmeticError
        Near equal forces or near the onset of sliding the cancellation exceeds two thousand digits.
    """
    precision = digits + 30
    before = slip_moments(equator, pole, friction, degree, precision)
    while precision < 2000:
        precision *= 2
        now = slip_moments(equator, pole, friction, degree, precision)
        if all(abs(n - b) <= abs(n) * sp.Float(10, precision) ** (-digits - 1)
               for n, b in zip(now, before, strict=True)):
            return tuple(sp.Float(n, digits) for n in now)
        before = now
    raise ArithmeticError(f"the closed form does not settle to {digits} digits")


def _number(value: sp.Rational, digits: int | None) -> sp.Expr:
    return value if digits is None else sp.Float(value, digits)


def _numbers(values: Moments, digits: int | None) -> Moments:
    if digits is None:
        return values
    integrals = set().union(*(value.atoms(sp.elliptic_f) for value in values))
    known = {integral: sp.N(integral, digits) for integral in integrals}
    return tuple(sp.N(value.xreplace(known), digits) for value in values)
