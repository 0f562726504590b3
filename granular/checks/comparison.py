"""One comparison of a computed stiffness with what is known, and how an error is counted."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from granular.hypothesis import Hypothesis
from granular.routes.result import COMPONENTS

ULP, STANDARD_ERRORS = "units", "standard errors"
"""Units in the last place, and the unit of what was sampled."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Comparison:
    """One route in one case: the worst of six components, or an identity between them.

    Attributes
    ----------
    group : str
        Family of cases, or the limit, e.g. ``"D-edge"``.
    case : str
        Which member of the group.
    hypothesis : Hypothesis
        Kinematic or static.
    route : str
        Which way of computing.
    component : str
        The component that is worst, or about which the identity is.
    error : float
        How far off it is [in ``unit``].
    allowed : float
        Largest error that counts as agreement [in ``unit``].
    unit : str
        Units in the last place of the known value, or standard errors of a sample.
    """

    group: str
    case: str
    hypothesis: Hypothesis
    route: str
    component: str
    error: float
    allowed: float
    unit: str = ULP

    @property
    def agrees(self) -> bool:
        """Whether the error is within what is allowed; an error that is not a number is a miss."""
        return self.error <= self.allowed


def error_in_ulp(value: float, known: Fraction) -> float:
    """Count an error in units in the last place of the known value.

    Parameters
    ----------
    value : float
        What was computed [-].
    known : Fraction
        The exact or certified value [-].

    Returns
    -------
    float
        ``|value - known| / ulp(|known|)`` [ulp]; infinite for a wrong zero and for what is not finite.

    Notes
    -----
    Accuracy: the quotient is formed in fractions and rounded once. One unit in the last place is the distance of
    neighbouring binary64 numbers at the known value, so that correct rounding costs at most half a unit. Source:
    the usual definition.

    Examples
    --------
    >>> error_in_ulp(1 + 2**-52, Fraction(1)), error_in_ulp(0.1, Fraction(1, 10)) < 0.5
    (1.0, True)
    """
    if not math.isfinite(value):
        return math.inf
    if known == 0:
        return 0.0 if value == 0 else math.inf
    return float(abs(Fraction(value) - known) / Fraction(math.ulp(float(abs(known)))))


def worst_component(computed: Sequence[float], known: Sequence[Fraction]) -> tuple[str, float]:
    """Find the component that is furthest off.

    Parameters
    ----------
    computed : sequence of 6 float
        C1111, C3333, C1122, C1133, C2323, C1212 as a route gave them [-].
    known : sequence of 6 Fraction
        The same, exact or certified [-].

    Returns
    -------
    name : str
        Which component.
    error : float
        Its error [ulp].

    Notes
    -----
    Accuracy and source: :func:`error_in_ulp`.

    Examples
    --------
    >>> worst_component([1.0, 1.0, 1.0, 1.0, 1.0, 1 + 2**-51], [Fraction(1)] * 6)
    ('C1212', 2.0)
    """
    error, name = max((error_in_ulp(value, exact), name)
                      for value, exact, name in zip(computed, known, COMPONENTS, strict=True))
    return name, error


def worst_relative(computed: Sequence[float], known: Sequence[Fraction]) -> tuple[str, float, float]:
    """Find the component whose error is largest relative to itself.

    Parameters
    ----------
    computed : sequence of 6 float
        C1111, C3333, C1122, C1133, C2323, C1212 as a route gave them [-].
    known : sequence of 6 Fraction
        The same, exact or certified [-].

    Returns
    -------
    name : str
        Which component.
    error : float
        ``|value - known| / |known|`` [-]; infinite for a wrong zero and for what is not finite.
    units : float
        Units in the last place of the known value for a relative error of 1 [ulp], 2**52 to 2**53.

    Notes
    -----
    Accuracy: the quotients are formed in fractions and rounded once. Source: the definition.

    Examples
    --------
    >>> worst_relative([1.0, 1.0, 1.0, 1.0, 1.0, 1 + 2**-51], [Fraction(1)] * 6)
    ('C1212', 4.440892098500626e-16, 4503599627370496.0)
    """
    error, name, units = max((_relative(value, exact), name, _units(exact))
                             for value, exact, name in zip(computed, known, COMPONENTS, strict=True))
    return name, error, units


def _relative(value: float, known: Fraction) -> float:
    if not math.isfinite(value):
        return math.inf
    if known == 0:
        return 0.0 if value == 0 else math.inf
    return float(abs(Fraction(value) - known) / abs(known))


def _units(known: Fraction) -> float:
    return float(abs(known) / Fraction(math.ulp(float(abs(known))))) if known else 2.0**52


def gap_in_ulp(terms: Sequence[tuple[int, float]], known_sum: Fraction = Fraction(0)) -> float:
    """Count how far an identity between rounded numbers is from being met.

    Parameters
    ----------
    terms : sequence of (int, float)
        Factors and rounded numbers of a sum [-].
    known_sum : Fraction
        What the sum would be without rounding [-].

    Returns
    -------
    float
        Distance of the sum from what it should be, over the units in the last place of its terms [ulp]: the number
        of units that every term would have to be off.

    Notes
    -----
    Accuracy: the sum is formed in fractions. Source: the triangle inequality.

    Examples
    --------
    >>> gap_in_ulp([(1, 0.1), (1, 0.2), (-1, 0.3)]) < 0.5
    True
    """
    total = sum((factor * Fraction(value) for factor, value in terms), Fraction(0))
    units = sum((abs(factor) * Fraction(math.ulp(value)) for factor, value in terms), Fraction(0))
    return float(abs(total - known_sum) / units)
