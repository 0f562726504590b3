"""Ranges of positive ratios, kept as logarithms: a ratio next to one loses no digits, and products are sums."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction

LEAST = 1e-290
"""A ratio that is not one is taken for no closer to it than this, so that powers of it do not underflow to one [-]."""

ROUNDING = 1e-12
"""Share of a bound that covers the rounding of the few operations that make it [-]."""


@dataclass(frozen=True, slots=True)
class Range:
    """Where a positive ratio lies.

    Attributes
    ----------
    low, high : float
        Logarithms of the smallest and the largest ratio [-]; -inf where the ratio may vanish, inf where it has no
        bound.

    Examples
    --------
    >>> round((Range.of(0.5, 2.0) * Range.of(2.0)).change, 9)
    3.0
    """

    low: float
    high: float

    @classmethod
    def of(cls, *ratios: Fraction | float) -> Range:
        """Span some ratios [-], >= 0."""
        logs = [log(ratio) for ratio in ratios]
        return cls(min(logs), max(logs))

    def __mul__(self, other: Range) -> Range:
        """Ratio of a product whose factors change independently."""
        low, high = self.low + other.low, self.high + other.high
        return Range(-math.inf if math.isnan(low) else low, math.inf if math.isnan(high) else high)  # 0 times inf

    def __truediv__(self, other: Range) -> Range:
        """Ratio of a quotient whose parts change independently."""
        return self * other ** -1.0

    def __pow__(self, power: float) -> Range:
        """Ratio of a power [-]."""
        if power == 0.0:
            return UNCHANGED
        ends = power * self.low, power * self.high
        return Range(min(ends), max(ends))

    def __or__(self, other: Range) -> Range:
        """Span two ranges: a ratio that lies in one of them."""
        return Range(min(self.low, other.low), max(self.high, other.high))

    def __and__(self, other: Range) -> Range:
        """A ratio that lies in both ranges."""
        return Range(max(self.low, other.low), min(self.high, other.high))

    @property
    def change(self) -> float:
        """Largest relative change [-]: how far the ratio may be from one, rounding covered; 0 for the ratio one."""
        return max(expm1(self.high), -math.expm1(self.low)) * (1 + ROUNDING)


UNCHANGED = Range(0.0, 0.0)
"""The ratio one."""

UNKNOWN = Range(-math.inf, math.inf)
"""A ratio of which nothing is known."""


def log(ratio: Fraction | float) -> float:
    """Logarithm of a ratio, with full relative accuracy next to one.

    Parameters
    ----------
    ratio : Fraction or float
        The ratio [-], >= 0.

    Returns
    -------
    float
        Its logarithm [-]; -inf for 0.

    Notes
    -----
    Accuracy: 1e-15 of the value, and never less than ``LEAST`` but for a ratio of one. Source: log(1 + d) where
    d = ratio - 1 is small and known exactly.

    Examples
    --------
    >>> log(1 + Fraction(1, 10**30)), log(0)
    (1e-30, -inf)
    """
    numerator, denominator = ratio.as_integer_ratio()
    apart = numerator - denominator
    if 2 * abs(apart) < denominator:  # the quotient of two integers is rounded once
        near = math.log1p(apart / denominator)
        return near if abs(near) > LEAST else LEAST * ((apart > 0) - (apart < 0))
    if numerator == 0:
        return -math.inf
    try:
        return math.log(numerator / denominator)
    except (OverflowError, ValueError):
        return math.log(numerator) - math.log(denominator)


def expm1(power: float) -> float:
    """exp(power) - 1, infinite where it overflows.

    Parameters
    ----------
    power : float
        Exponent [-].

    Returns
    -------
    float
        exp(power) - 1 [-].

    Notes
    -----
    Accuracy: one unit in the last place. Source: ``math.expm1``.

    Examples
    --------
    >>> expm1(1e4)
    inf
    """
    return math.expm1(power) if power < 700.0 else math.inf
