"""Aligned spheroids at the ends of their range: first order about the sphere, leading orders of plates and needles."""

from __future__ import annotations

from decimal import Context, Decimal, localcontext
from fractions import Fraction

from granular.checks.limits import stiffness_ratio
from granular.fabric import AxialFabric

DIGITS = Context(prec=40)
PI = Fraction("3.141592653589793238462643383279502884197")

Table = tuple[tuple[int | Fraction, ...], ...]

VALUES: Table = ((168, 112, -48, -8, 8, -8), (168, 112, 96, 16, Fraction(64, 3), -Fraction(64, 3)),
          (56, -56, -16, 16, Fraction(8, 3), -Fraction(8, 3)), (56, -56, 8, -8, -Fraction(32, 3), Fraction(32, 3)),
          (56, 84, 8, 6, -Fraction(32, 3), Fraction(32, 3)), (56, 84, -16, -12, Fraction(8, 3), -Fraction(8, 3)))
"""840 times the six components at the sphere, in 1, lam, D33, lam D33, D3333 and lam D3333."""

SLOPES: Table = ((-990, -858, 198, -66, 30, 102), (1980, 1716, 990, 132, 80, -344), (-330, 330, 66, -66, 10, -10),
          (165, -165, -33, 33, -40, 40), (165, 297, -33, Fraction(693, 2), -40, 7), (-330, -594, 66, 0, 10, 56))
"""10395 times their derivatives with respect to e = r^2 - 1 there, at the volume of the grains."""


def near_the_sphere(fabric: AxialFabric, poisson_ratio: float) -> tuple[Fraction, ...]:
    """Six kinematic components to first order in e = r^2 - 1.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals, an aspect ratio r next to 1, and spin [-].
    poisson_ratio : float
        Poisson's ratio of the grain material [-].

    Returns
    -------
    tuple of Fraction, (6,)
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n [-].

    Notes
    -----
    Accuracy: what is left out is of the order of e^2. Source: ``derivations.spheroid_limits``, with (b/a)^(-2/3) for
    the size of the grains.

    Examples
    --------
    >>> c1111, c3333, *_ = near_the_sphere(AxialFabric(), 0.0)
    >>> c1111 == c3333 == Fraction(1, 3)
    True
    """
    lam, d, q = stiffness_ratio(poisson_ratio), Fraction(fabric.D33), Fraction(fabric.D3333)
    excess, terms = Fraction(fabric.aspect_ratio) ** 2 - 1, (Fraction(1), lam, d, lam * d, q, lam * q)
    six = [sum((term * (Fraction(value) / 840 + excess * Fraction(slope) / 10395)
                for term, value, slope in zip(terms, values, slopes, strict=True)), Fraction(0))
           for values, slopes in zip(VALUES, SLOPES, strict=True)]
    if fabric.free_spin:
        six[4] = _relaxed_value(lam, d, q) + excess * _relaxed_slope(lam, d, q)
    return tuple(six)


def _relaxed_value(lam: Fraction, d: Fraction, q: Fraction) -> Fraction:
    """C2323 of spheres that are free to spin."""
    return (210 + 315 * lam + (51 + 54 * lam) * d + (3 - 45 * lam) * d**2
            - (1 - lam) * (40 + 4 * d) * q) / (315 * (10 + d))


def _relaxed_slope(lam: Fraction, d: Fraction, q: Fraction) -> Fraction:
    """Its derivative with respect to e."""
    without = (8250 + 14850 * lam - (10395 + 10890 * lam) * d - (2772 + 3366 * lam) * d**2
               - (165 - 990 * lam) * d**3)
    return 2 * (without + (350 * lam - 2000 + (1060 * lam + 1580) * d + (178 - 46 * lam) * d**2) * q) / (
        10395 * (10 + d) ** 2)


def plates(fabric: AxialFabric, poisson_ratio: float) -> tuple[Fraction, ...]:
    """Six kinematic components as the aspect ratio r tends to zero.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals, an aspect ratio r that is a power of 8, and spin [-].
    poisson_ratio : float
        Poisson's ratio of the grain material [-].

    Returns
    -------
    tuple of Fraction, (6,)
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n [-].

    Notes
    -----
    Accuracy: what is left out is r^2 ln r of each. Source: ``derivations.spheroid_limits``.

    Examples
    --------
    >>> plates(AxialFabric(aspect_ratio=2.0**-39), 0.0)[3]
    Fraction(0, 1)
    """
    lam, chi = stiffness_ratio(poisson_ratio), Fraction(fabric.aspect_ratio)
    n11, n33 = _fabric_tensor(fabric)
    e0, e1, e2 = fabric.density_coefficients()
    with localcontext(DIGITS):
        logarithm = Fraction((2 / Decimal(fabric.aspect_ratio)).ln())
    p2 = e2 * logarithm + 2 * e0 / 35 + e1 / 7 - 176 * e2 / 105
    shear = (n33 + 2 * lam * n11) / 8
    if fabric.free_spin:
        shear = chi**4 * lam * (p2 + n33 + (1 - lam) * n33 / (2 * ((1 - lam) * n33 + lam)))
    return _of_equal_volume(chi, (
        3 * n11 / 4 + lam * (n11 / 4 + n33 / 2), chi**4 * (p2 + lam * n33), (1 - lam) * n11 / 4,
        chi**2 * (1 - lam) * n33 / 2, shear, ((1 - lam) * n11 + lam) / 4))


def needles(fabric: AxialFabric, poisson_ratio: float) -> tuple[Fraction, ...]:
    """Six kinematic components as the aspect ratio r tends to infinity, with the first correction in 1/r.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals, an aspect ratio r that is a power of 8, and spin [-].
    poisson_ratio : float
        Poisson's ratio of the grain material [-].

    Returns
    -------
    tuple of Fraction, (6,)
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n [-].

    Notes
    -----
    What the equator holds up is p0 = <E s^2/Q> = pi e0/(2 r) - (128 e0/35 - 16 e1/35 - 8 e2/105)/r^2; every other
    moment follows from r^2 x^2/Q = 1 - s/Q. Accuracy: what is left out is of the order of r^-2 of each, where there are
    contacts at the equator. Source: the leading orders of ``derivations.spheroid_limits``.

    Examples
    --------
    >>> needles(AxialFabric(aspect_ratio=2.0**39), 0.0)[3]
    Fraction(0, 1)
    """
    lam, chi = stiffness_ratio(poisson_ratio), Fraction(fabric.aspect_ratio)
    n11, n33 = _fabric_tensor(fabric)
    e0, e1, e2 = fabric.density_coefficients()
    p0 = PI * e0 / (2 * chi) - (128 * e0 / 35 - 16 * e1 / 35 - 8 * e2 / 105) / chi**2
    coupling = (1 - lam) * (n11 - p0 / 2)
    shear = chi**2 * (coupling + lam * (1 - p0)) / 4
    if fabric.free_spin:
        shear = lam * p0 / 2 + (n11 - (1 - lam) ** 2 * n11**2 / ((1 - lam) * n11 + lam)) / chi**2
    return _of_equal_volume(chi, (
        (3 + lam) * p0 / 8 + lam * n11 / chi**2, chi**2 * ((1 - lam) * n33 + lam * (1 - p0)), (1 - lam) * p0 / 8,
        coupling, shear, (1 + lam) * p0 / 8 + lam * n11 / (2 * chi**2)))


def _fabric_tensor(fabric: AxialFabric) -> tuple[Fraction, Fraction]:
    d = Fraction(fabric.D33)
    return Fraction(1, 3) - d / 15, Fraction(1, 3) + 2 * d / 15


def _of_equal_volume(chi: Fraction, components: tuple[Fraction, ...]) -> tuple[Fraction, ...]:
    """From components over (M/V) (2a)^2 k_n; the cube root of a power of 8 is a power of 2."""
    power = chi.numerator.bit_length() - chi.denominator.bit_length()
    size = Fraction(2) ** (-2 * power // 3)
    return tuple(size * component for component in components)
