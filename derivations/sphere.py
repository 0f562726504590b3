"""Exact averages over directions by monomial moments; no angle is ever integrated symbolically."""

from __future__ import annotations

from functools import cache

import sympy as sp

from derivations.symbols import cos_alpha, s, sin_alpha, sin_beta, x, y


def odd_factorial(n: int) -> sp.Integer:
    """Return n!! for odd or non-positive n, with (-1)!! = 1."""
    return sp.factorial2(n)


def monomial_mean(a: int, b: int, c: int) -> sp.Rational:
    """Average of n1^a n2^b n3^c over the unit sphere.

    It is (a-1)!! (b-1)!! (c-1)!! / (a+b+c+1)!! when all three exponents are even, and zero otherwise.
    """
    if a % 2 or b % 2 or c % 2:
        return sp.Integer(0)
    numerator = odd_factorial(a - 1) * odd_factorial(b - 1) * odd_factorial(c - 1)
    return sp.Rational(numerator, odd_factorial(a + b + c + 1))


def sphere_mean(polynomial: sp.Expr, directions: tuple[sp.Symbol, sp.Symbol, sp.Symbol]) -> sp.Expr:
    """Average of a polynomial in the three components of a unit vector over the sphere."""
    terms = sp.Poly(polynomial, *directions).terms()
    return sp.expand(sum(coefficient * monomial_mean(*powers) for powers, coefficient in terms))


def circle_mean(a: int, b: int) -> sp.Rational:
    """Average of cos^a sin^b over the azimuth: (a-1)!! (b-1)!! / (a+b)!! for even exponents, else zero."""
    if a % 2 or b % 2:
        return sp.Integer(0)
    return sp.Rational(odd_factorial(a - 1) * odd_factorial(b - 1), sp.factorial2(a + b))


def azimuth_mean(polynomial: sp.Expr) -> sp.Expr:
    """Average about axis 3 of a polynomial in cos(alpha), sin(alpha); the rest is carried along."""
    terms = sp.Poly(sp.expand(polynomial), cos_alpha, sin_alpha).terms()
    return sp.expand(sum(coefficient * circle_mean(*powers) for powers, coefficient in terms))


def meridian_form(expression: sp.Expr) -> sp.Expr:
    """Write an even polynomial in x and sin(beta) as a polynomial in y = x^2 and s = 1 - x^2.

    Raises
    ------
    ValueError
        An odd power is left; such a term averages to zero over the azimuth and should be gone.
    """
    total = sp.Integer(0)
    for (of_sine, of_cosine), coefficient in sp.Poly(sp.expand(expression), sin_beta, x).terms():
        if of_sine % 2 or of_cosine % 2:
            raise ValueError(f"odd power in {expression}")
        total += coefficient * s ** (of_sine // 2) * y ** (of_cosine // 2)
    return sp.expand(total)


def homogeneous(form: sp.Expr, degree: int) -> tuple[sp.Expr, ...]:
    """Coefficients of s^degree, s^(degree-1) y, ..., y^degree, after filling up with powers of s + y = 1."""
    coefficients: list[sp.Expr] = [sp.Integer(0)] * (degree + 1)
    for (of_s, of_y), coefficient in sp.Poly(sp.expand(form), s, y).terms():
        gap = degree - of_s - of_y
        for extra in range(gap + 1):
            coefficients[of_y + extra] += sp.binomial(gap, extra) * coefficient
    return tuple(sp.expand(coefficient) for coefficient in coefficients)


@cache
def axial_moment(of_s: int, of_y: int) -> sp.Rational:
    """Integral of s^of_s y^of_y over x from 0 to 1: half a beta function, always rational.

    It equals of_s! / (2 (of_y + 1/2)(of_y + 3/2) ... (of_y + 1/2 + of_s)).
    """
    result = sp.Rational(sp.factorial(of_s), 2)
    for step in range(of_s + 1):
        result /= sp.Rational(2 * (of_y + step) + 1, 2)
    return result


def axial_mean(form: sp.Expr) -> sp.Expr:
    """Integral over x from 0 to 1 of a polynomial in s and y."""
    terms = sp.Poly(sp.expand(form), s, y).terms()
    return sp.expand(sum(coefficient * axial_moment(*powers) for powers, coefficient in terms))
