"""Moments of branch length of lognormal sizes from eqs (16) and (17) as they stand, in multiple precision.

The density of branch lengths is the self-convolution of the density of radii, in the variable w, the logarithm of the
ratio of both radii; eq. (17) takes its cube root. Both integrals are taken by equal steps, which converge exponentially
there. Nothing of the library's own rules is used: no scaled variables, no terms left out by their size beforehand, and
twice the digits of a double.
"""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from typing import Any

from granular.checks.gradation_comparisons import stored_gradations
from granular.hypothesis import Hypothesis
from granular.routes.balls import arithmetic, ball, fraction

DIGITS = 20
"""Significant digits of a moment."""

OUTER_STEP = Fraction(8, DIGITS + 18)
"""Step in ln l over ln s_r [-]; half of it serves the inner integral."""

NEGLIGIBLE = 80
"""Terms below 2**-80 of the largest end a sum: 1e-24."""


def length_factor(spread: float, hypothesis: Hypothesis) -> Fraction:
    """What a lognormal gradation multiplies the stiffness of equal grains by.

    Parameters
    ----------
    spread : float
        Geometric standard deviation s_r [-], > 1, taken as exact.
    hypothesis : Hypothesis
        Kinematic, <l^2>/(4 <r^3>^(2/3)), or static, the inverse of 4 <r^3>^(2/3) <l^-2>.

    Returns
    -------
    Fraction
        The factor [-]; neither the median nor the form of the density enters.

    Raises
    ------
    CertifiedArithmeticMissing
        python-flint is not installed.

    Notes
    -----
    Accuracy: 1e-20 of itself, which is tested against the stored moments and against other steps; those of the stored
    file, certified to 1e-30, are taken from there. Source: eqs (7), (11), (16), (17).

    Examples
    --------
    >>> round(float(length_factor(1.2, Hypothesis.KINEMATIC)), 9)
    1.088899326
    """
    for case in stored_gradations():
        if case.spread == spread:
            known = case.known[hypothesis]
            return known if hypothesis is Hypothesis.KINEMATIC else 1 / known
    second, inverse = computed(spread)
    return second if hypothesis is Hypothesis.KINEMATIC else 1 / inverse


@lru_cache(maxsize=256)
def computed(spread: float, *, step: Fraction = OUTER_STEP) -> tuple[Fraction, Fraction]:
    """Both moments by equal steps.

    Parameters
    ----------
    spread : float
        Geometric standard deviation s_r [-], > 1, taken as exact.
    step : Fraction
        Step in ln l over ln s_r [-].

    Returns
    -------
    second, inverse : Fraction
        <l^2>/(4 <r^3>^(2/3)) and 4 <r^3>^(2/3) <l^-2> [-].

    Raises
    ------
    CertifiedArithmeticMissing
        python-flint is not installed.

    Notes
    -----
    Accuracy: 1e-20 of themselves at the step given by default. Source: eqs (16) and (17).
    """
    flint = arithmetic()
    beyond = Fraction(spread) - 1
    narrow = max(0, beyond.denominator.bit_length() - beyond.numerator.bit_length())
    with flint.ctx.workprec(160 + 2 * narrow):
        width = ball(flint, Fraction(spread)).log()
        total_density = _TotalDensity(flint, width, ball(flint, step))
        whole, above, below = (total_density.moment(power) for power in (0, 2, -2))
        equal = (3 * width * width).exp()  # <r^3>^(2/3) in squares of the median radius by number
        return fraction((above / whole / equal).mid()), fraction((below / whole * equal).mid())


class _TotalDensity:
    """Logarithmic density of all branch lengths at equal steps of ln l, kept for several moments."""

    def __init__(self, flint: Any, width: Any, step: Any) -> None:
        self._flint, self._width, self._step = flint, width, step
        self._two = flint.arb(2).log()
        self._tiny = flint.arb(2) ** -NEGLIGIBLE
        self._shifts: list[tuple[Any, Any]] = []
        self._root: dict[int, Any] = {}

    def moment(self, power: int) -> Any:
        """Int (l times density)^(1/3) (l/2)^(2/3 + power) d(ln l), up to one factor for all powers."""
        slope = (self._flint.arb(2) / 3 + power) * self._width
        start = round(float(3 * slope / 2 / self._step))
        total = largest = self._flint.arb(0)
        for direction in (1, -1):
            place = start if direction == 1 else start - 1
            while True:
                term = self._cube_root(place) * (slope * self._step * place).exp()
                total += term
                if term < largest * self._tiny:
                    break
                largest = largest.max(term)
                place += direction
        return total

    def _cube_root(self, place: int) -> Any:
        """Cube root of l times the density, at l = 2 exp(width step place) median radii."""
        if place not in self._root:
            log_length = self._two + self._width * self._step * place
            total = largest = self._flint.arb(0)
            number = 0
            while True:
                w, first = self._shift(number)
                one = (log_length - first) / self._width  # logarithms of both radii over the width
                other = one - w
                term = (-(one * one + other * other) / 2).exp()
                total += term if number == 0 else 2 * term
                if term < largest * self._tiny:
                    break
                largest = largest.max(term)
                number += 1
            self._root[place] = total.root(3)
        return self._root[place]

    def _shift(self, number: int) -> tuple[Any, Any]:
        """Logarithm of the ratio of both radii over the width, and that of the length over the larger radius."""
        while number >= len(self._shifts):
            w = self._step / 2 * len(self._shifts)
            self._shifts.append((w, (-(w * self._width)).exp().log1p()))
        return self._shifts[number]
