"""Power series with exact coefficients: products, the Gegenbauer forms, and a cut with a bound on what is left out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

import sympy as sp

Coefficients = Sequence[sp.Rational]
TWO = sp.Integer(2)


@dataclass(frozen=True)
class TruncatedSeries:
    """A power series cut after its last coefficient.

    Attributes
    ----------
    name : str
        Name of the coefficient table in emitted code.
    coefficients : tuple of sympy.Rational
        Exact coefficients of 1, v, v^2, ...
    limit : sympy.Rational
        Largest |v| that it serves.
    left_out : sympy.Rational
        Bound of the computed terms that were cut, relative to the sum, anywhere in |v| <= limit.
    variable : str
        Name of the variable, for the comment beside the table.
    """

    name: str
    coefficients: tuple[sp.Rational, ...]
    limit: sp.Rational
    left_out: sp.Rational
    variable: str = "v"


def product(left: Coefficients, right: Coefficients) -> list[sp.Rational]:
    """Multiply two series and keep as many terms as the first has."""
    return [sum((left[i] * right[n - i] for i in range(n + 1)), sp.Integer(0)) for n in range(len(left))]


def power_of_one_plus(exponent: int, sign: int, length: int) -> list[sp.Rational]:
    """Coefficients of (1 + sign v)^exponent."""
    return [sp.binomial(exponent, n) * sp.Integer(sign) ** n for n in range(length)]


@cache
def gegenbauer_forms(length: int, order: sp.Rational = TWO) -> list[list[sp.Rational]]:
    """Gegenbauer polynomials C_n^(order)(s - y) as forms of degree n in s and y, by their recurrence, with s + y = 1.

    Their generating function is ((1 - v)^2 s + (1 + v)^2 y)^(-order).
    """
    forms: list[list[sp.Rational]] = [[sp.Integer(1)], [2 * order, -2 * order]]
    for n in range(2, length):
        ahead = _times([sp.Integer(1), sp.Integer(-1)], forms[-1])
        behind = _times([sp.Integer(1), sp.Integer(2), sp.Integer(1)], forms[-2])
        forms.append([(2 * (n + order - 1) * a - (n + 2 * order - 2) * b) / n
                      for a, b in zip(ahead, behind, strict=True)])
    return forms[:length]


def _times(left: Coefficients, right: Coefficients) -> list[sp.Rational]:
    result = [sp.Integer(0)] * (len(left) + len(right) - 1)
    for i, a in enumerate(left):
        for j, b in enumerate(right):
            result[i + j] += a * b
    return result


def truncate(name: str, coefficients: tuple[sp.Rational, ...], limit: sp.Rational,
             precision: sp.Rational) -> TruncatedSeries:
    """Cut a series as early as the terms left out stay below ``precision`` of its smallest value on [-limit, limit].

    Raises
    ------
    ValueError
        The coefficients at hand do not reach the precision.
    """
    ends = [sum((c * (sign * limit) ** n for n, c in enumerate(coefficients)), sp.Integer(0)) for sign in (-1, 1)]
    smallest = min(coefficients[0], *ends)
    rest = sp.Integer(0)
    keep = len(coefficients)
    while keep > 1 and (rest + abs(coefficients[keep - 1]) * limit ** (keep - 1)) / smallest < precision:
        keep -= 1
        rest += abs(coefficients[keep]) * limit**keep
    if keep > len(coefficients) - 8:
        raise ValueError(f"{name}: {len(coefficients)} coefficients do not reach {precision}; compute more")
    return TruncatedSeries(name, coefficients[:keep], limit, rest / smallest)
