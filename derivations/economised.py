"""Polynomials that serve an interval: an exact Taylor polynomial, economised in Chebyshev polynomials of the interval.

All arithmetic is done in fractions; nothing is rounded before a coefficient is printed.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import accumulate

import sympy as sp


def economise(taylor: Sequence[Fraction], low: Fraction, high: Fraction,
              allowed: Fraction) -> tuple[tuple[Fraction, ...], Fraction]:
    """Shorten a polynomial on an interval by as many terms as an error permits.

    Parameters
    ----------
    taylor : sequence of Fraction
        Coefficients of 1, v, v^2, ...
    low, high : Fraction
        Ends of the interval.
    allowed : Fraction
        Largest change of the value anywhere on the interval.

    Returns
    -------
    tuple
        The coefficients in v of the shorter polynomial, and a bound of its difference from the longer one.
    """
    middle, half = (low + high) / 2, (high - low) / 2
    chebyshev = _in_chebyshev(taylor, middle, half)
    tails = list(accumulate(abs(value) for value in reversed(chebyshev)))
    cut = sum(1 for tail in tails if tail < allowed)
    rest = tails[cut - 1] if cut else Fraction(0)
    return _in_powers(chebyshev[:len(chebyshev) - cut], middle, half), rest


def _in_chebyshev(powers: Sequence[Fraction], middle: Fraction, half: Fraction) -> list[Fraction]:
    """Horner's rule with v = middle + half t in Chebyshev polynomials of t, where t T_k = (T_(k+1) + T_|k-1|)/2."""
    total = [Fraction(0)]
    for coefficient in reversed(powers):
        shifted = [middle * value for value in total] + [Fraction(0)]
        for k, value in enumerate(total):
            for neighbour in (k + 1, abs(k - 1)):
                shifted[neighbour] += half * value / 2
        shifted[0] += coefficient
        total = shifted
    return total[:len(powers)]


def _in_powers(chebyshev: Sequence[Fraction], middle: Fraction, half: Fraction) -> tuple[Fraction, ...]:
    """Powers of v again: T_(k+1) = 2 t T_k - T_(k-1) with t = (v - middle)/half."""
    size = len(chebyshev)
    before, here = [Fraction(0)] * size, [Fraction(1)] + [Fraction(0)] * (size - 1)
    total = [Fraction(0)] * size
    for k, coefficient in enumerate(chebyshev):
        total = [sum_ + coefficient * value for sum_, value in zip(total, here, strict=True)]
        raised = [(low - middle * value) / half for low, value in zip([Fraction(0), *here[:-1]], here, strict=True)]
        factor = 1 if k == 0 else 2
        before, here = here, [factor * new - old for new, old in zip(raised, before, strict=True)]
    return tuple(total)


def rationals(numbers: Sequence[Fraction]) -> tuple[sp.Rational, ...]:
    """The same numbers for SymPy."""
    return tuple(sp.Rational(number.numerator, number.denominator) for number in numbers)
