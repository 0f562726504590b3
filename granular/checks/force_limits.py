"""Limits with contact forces that are known without integration, to far more digits than a double holds."""

from __future__ import annotations

from collections.abc import Sequence
from decimal import Context, Decimal
from fractions import Fraction

from granular.checks.limits import stiffness_ratio
from granular.fabric import AxialFabric
from granular.routes.certified_kinetic import squared_weights
from granular.routes.result import COMPONENTS

_DIGITS = Context(prec=50)

_PEAK = Fraction("0.841309263195272556705011447430176481277813323254391657709196")
"""Int_0^1 (1 - x^2)^(1/3) dx = sqrt(pi) Gamma(4/3)/(2 Gamma(11/6)) [-]."""


def cube_root(value: Fraction) -> Fraction:
    """Cube root of a positive fraction, to 45 digits.

    Examples
    --------
    >>> abs(cube_root(Fraction(8)) - 2) < Fraction(1, 10**45)
    True
    """
    quotient = _DIGITS.divide(Decimal(value.numerator), Decimal(value.denominator))
    return Fraction(_DIGITS.power(quotient, _DIGITS.divide(Decimal(1), Decimal(3))))


def weak_stress(stress_ratio: Fraction, poisson_ratio: float) -> tuple[Fraction, ...]:
    """Six components of the isotropic fabric under nearly isotropic stress, to second order in sigma33/sigma11 - 1.

    Parameters
    ----------
    stress_ratio : Fraction
        sigma33/sigma11 [-], within 1e-6 of 1, where the third order is below 1e-18.
    poisson_ratio : float
        Poisson's ratio of the grain material [-].

    Returns
    -------
    tuple of Fraction, (6,)
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n,ref [-]; contacts do not slip.

    Notes
    -----
    Source: eq. (7) with k_n = (a (1 + t x^2))^(1/3), t = sigma33/sigma11 - 1, expanded in t.

    Examples
    --------
    >>> weak_stress(Fraction(1), 0.0)[0]
    Fraction(1, 3)
    """
    lam, t = stiffness_ratio(poisson_ratio), stress_ratio - 1
    rest = 1 - lam
    orders = {
        "C1111": ((3 + 2 * lam) / 15, Fraction(1, 105) + 4 * lam / 315, -(1 + 2 * lam) / 945),
        "C3333": ((3 + 2 * lam) / 15, Fraction(1, 21) + 2 * lam / 105, -(Fraction(1, 81) + 2 * lam / 567)),
        "C1122": (rest / 15, rest / 315, -rest / 2835),
        "C1133": (rest / 15, rest / 105, -rest / 567),
        "C2323": (Fraction(1, 15) + lam / 10, Fraction(1, 105) + 4 * lam / 315,
                  -(Fraction(1, 567) + 17 * lam / 5670)),
        "C1212": (Fraction(1, 15) + lam / 10, Fraction(1, 315) + lam / 126, -(Fraction(1, 2835) + lam / 810))}
    scale = cube_root(3 / (2 + stress_ratio))
    return tuple(scale * (zeroth + first * t + second * t**2)
                 for zeroth, first, second in (orders[name] for name in COMPONENTS))


def one_stress_vanishes(fabric: AxialFabric, poisson_ratio: float, *, along: bool) -> tuple[Fraction, ...]:
    """Six kinematic components when one principal stress is zero and contacts do not slip.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branch lengths [-].
    poisson_ratio : float
        Poisson's ratio of the grain material [-].
    along : bool
        True when the stress acts along axis 3 only, False when it acts across it only.

    Returns
    -------
    tuple of Fraction, (6,)
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n,ref [-].

    Notes
    -----
    k_n is (c x^2)^(1/3) or (a s)^(1/3), whose moments are Beta functions: rational, or a rational multiple of one of
    them. Accuracy: 1e-40. Source: eqs (7), (20) and (23).

    Examples
    --------
    >>> one_stress_vanishes(AxialFabric(), 0.0, along=True)[2]
    Fraction(0, 1)
    """
    d33 = Fraction(fabric.D33)
    largest = 15 / (5 + 2 * d33) if along else Fraction(15, 2) / (5 - d33)
    moment = _along if along else _across
    weights = squared_weights(fabric)
    scale = cube_root(largest)
    moments = [scale * sum((weight * moment(k + i) for k, weight in enumerate(weights)), Fraction(0))
               for i in range(3)]
    return without_slip(moments, poisson_ratio)


def without_slip(moments: Sequence[Fraction], poisson_ratio: float) -> tuple[Fraction, ...]:
    """Six components of eq. (7) from <E W^2 k_n> with s^2, s x^2 and x^4, where k_r = lambda_0 k_n.

    Examples
    --------
    >>> without_slip([Fraction(8, 15), Fraction(2, 15), Fraction(1, 5)], 0.0)[1]
    Fraction(1, 3)
    """
    lam = stiffness_ratio(poisson_ratio)
    m0, m1, m2 = moments
    return ((1 - lam) * 3 * m0 / 8 + lam * (m0 + m1) / 2,
            (1 - lam) * m2 + lam * (m1 + m2),
            (1 - lam) * m0 / 8,
            (1 - lam) * m1 / 2,
            (1 - lam) * m1 / 2 + lam * (m1 + m2 + (m0 + m1) / 2) / 4,
            (1 - lam) * m0 / 8 + lam * (m0 + m1) / 4)


def _along(power: int) -> Fraction:
    """Int_0^1 s^(6-k) x^(2k) x^(2/3) dx = B(k + 5/6, 7 - k)/2."""
    value = 1 / (2 * (power + Fraction(5, 6)))
    for j in range(1, 7 - power):
        value *= j / (power + Fraction(5, 6) + j)
    return value


def _across(power: int) -> Fraction:
    """Int_0^1 s^(6-k) x^(2k) s^(1/3) dx = B(k + 1/2, 22/3 - k)/2, stepped from B(1/2, 4/3)/2."""
    value = _PEAK
    for j in range(power):
        value *= (Fraction(1, 2) + j) / (Fraction(11, 6) + j)
    for j in range(6 - power):
        value *= (Fraction(4, 3) + j) / (Fraction(11, 6) + power + j)
    return value
