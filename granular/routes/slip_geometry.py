"""Which contacts stick and which slide: decided exactly, and the few numbers that the rules need, rounded once."""

from __future__ import annotations

from dataclasses import dataclass
from decimal import Decimal, localcontext
from fractions import Fraction

from granular.routes.decimals import DIGITS, decimal

NEGLIGIBLE = Decimal(2) ** -160
"""Directions whose tangent, or its inverse, is smaller carry less than 2^-160 of any moment of the contacts."""

FARTHEST = Decimal(2) ** 500
"""An edge of the sliding range farther out is moved here; no contact that matters comes near it either way."""


@dataclass(frozen=True, slots=True)
class Sticking:
    """Every contact sticks.

    Attributes
    ----------
    center : float
        tan(beta) where contacts are nearest to sliding, sqrt(c/a) [-].
    kappa, delta : float
        Share of the friction that they use up there, and what is left, 1 - kappa [-].
    """

    center: float
    kappa: float
    delta: float


@dataclass(frozen=True, slots=True)
class Sliding:
    """Contacts slide where tan(beta) lies between two values.

    Attributes
    ----------
    pole, equator : float or None
        tan(beta) at the ends of the sliding range [-]; None where no contact beyond that end matters.
    rho : float
        sinh of a quarter of the width of the range in log(tan(beta)) [-].
    """

    pole: float | None
    equator: float | None
    rho: float


def slip_geometry(a: Fraction, c: Fraction, friction: float) -> Sticking | Sliding:
    """Find where contacts stick and slide.

    Parameters
    ----------
    a, c : Fraction
        Normal force at the equator and at the pole up to a common factor [-], >= 0 and not equal.
    friction : float
        mu [-], > 0.

    Returns
    -------
    Sticking or Sliding
        Decided in exact arithmetic, exact tangency counted as sticking; numbers rounded once.

    Notes
    -----
    Source: roots of a t^2 - (\\|c - a\\|/mu) t + c = 0 in t = tan(beta), from eqs (21) and (23).

    Examples
    --------
    >>> slip_geometry(Fraction(1), Fraction(4), 0.75)
    Sticking(center=2.0, kappa=1.0, delta=0.0)
    """
    with localcontext(DIGITS):
        half_sum = decimal(abs(c - a) / (2 * Fraction(friction)))  # (t1 + t2) a/2
        if a == 0:
            return Sliding(_pole(decimal(c) / (2 * half_sum)), None, float("inf"))
        if c == 0:
            return Sliding(None, _equator(2 * half_sum / decimal(a)), float("inf"))
        ratio = (c - a) ** 2 / (4 * a * c * Fraction(friction) ** 2)  # kappa^2
        kappa, center = decimal(ratio).sqrt(), decimal(c / a).sqrt()
        left = decimal(1 - ratio) / (1 + kappa)
        if ratio <= 1:
            return Sticking(float(center), float(kappa), float(left))
        spread = kappa + decimal(ratio - 1).sqrt()
        rho = min((-left / 2).sqrt(), Decimal(2) ** 500)
        return Sliding(_pole(center / spread), _equator(center * spread), float(rho))


def _pole(edge: Decimal) -> float | None:
    return float(min(edge, FARTHEST)) if edge >= NEGLIGIBLE else None


def _equator(edge: Decimal) -> float | None:
    return float(max(edge, 1 / FARTHEST)) if edge <= 1 / NEGLIGIBLE else None
