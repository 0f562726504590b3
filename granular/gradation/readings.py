"""The number by which gradation enters the stiffness, under every reading of what the paper leaves open.

Gradation multiplies the kinematic stiffness by <l^2>/<r^3>^(2/3), which is 4 for equal spheres, and the static
compliance by 4 <r^3>^(2/3) <l^-2>, which is 1 for them. Taken by the letter, eq. (17) gives branches the cube root of
the density of all branches, up to the largest grain there is. Other readings are another power of that density, the
lognormal density of eq. (19), one length for all branches, and sizes that end somewhere.

In units of the median size by number, with L = ln s_r, a length l and the ratio exp(w) of its two radii have the
density exp(-[(ln l - c(w))^2 + w^2/4]/L^2) with c(w) = ln(2 cosh(w/2)).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

from granular.fields import Number
from granular.gradation.cut_sizes import cut, cut_by_volume
from granular.gradation.lognormal import SPREAD, Lognormal
from granular.gradation.stiffness_numbers import ONE_LENGTH, Numbers, argument_that_gives, numbers_of

STEP = 0.15
"""Step of both trapezoidal rules over the whole range, in spreads [-]."""

ENOUGH = 9.0
"""Distance from the peak, in widths of the integrand, beyond which less than 1e-17 is left [-]."""

_POWER = Number(at_least=0.25, at_most=2.0, why="a density to a smaller power has no end that matters",
                remedy="Give a power inside the interval; eq. (17) has 1/3.")
_WANTED = Number(above=0.0)


def literal(spread: float) -> Numbers:
    """Eq. (17) by the letter: the cube root of the density of all branches, over the whole range of sizes.

    Parameters
    ----------
    spread : float
        Geometric standard deviation of grain sizes s_r [-], 1 < spread <= 10.

    Returns
    -------
    Numbers
        Both numbers [-]; neither depends on the median, nor on the form of the lognormal density.

    Raises
    ------
    ValueOutOfRange
        The spread is outside its interval.

    Notes
    -----
    Accuracy: 1e-13. Source: eqs (11), (12), (16), (17).

    Examples
    --------
    >>> [round(literal(spread).kinematic, 4) for spread in (1.2, 1.5, 2.0)]
    [4.3556, 6.5509, 33.1552]
    """
    from granular.gradation.length_moments import length_moments

    moments = length_moments(Lognormal(1.0, spread))
    return Numbers(4.0 * moments.second, moments.inverse_second)


def of_power(spread: float, power: float) -> Numbers:
    """Another power of the density of all branches in place of the cube root of eq. (17).

    Parameters
    ----------
    spread : float
        Geometric standard deviation of grain sizes s_r [-], 1 < spread <= 10.
    power : float
        g ~ g_total^power [-], 0.25 to 2; 1/3 is eq. (17).

    Returns
    -------
    Numbers
        Both numbers [-].

    Raises
    ------
    ValueOutOfRange
        An argument is outside its interval.

    Notes
    -----
    Accuracy: 1e-12. Source: eq. (16), by trapezoidal rules along ln l and along w.

    Examples
    --------
    >>> [round(of_power(2.0, power).kinematic, 3) for power in (1/3, 1/2, 1.0)]
    [33.155, 6.96, 2.002]
    """
    import numpy as np

    L, p = math.log(SPREAD.read(spread, "spread")), _POWER.read(power, "power")
    # z counts ln l from ln 2 in spreads; a moment of order k is the integral of h^p exp((1 - p + k) L z)
    farthest = (3.0 - p) * L / p + ENOUGH / math.sqrt(p) + 1.0
    z = np.arange(-farthest, farthest, STEP)
    t = np.arange(0.0, 2.0 * farthest, STEP)
    stretch = np.log1p(2.0 * np.sinh(0.25 * L * t) ** 2) / L
    exponents = -((z[:, None] - stretch) ** 2) - 0.25 * t * t
    ends = np.where(t == 0.0, 0.5, 1.0)  # even in t
    log_h = exponents.max(axis=1) + np.log(np.exp(exponents - exponents.max(axis=1)[:, None]) @ ends)
    return numbers_of(p * log_h + (1.0 - p) * L * z, L * z + math.log(2.0), np.ones_like(z), 4.5 * L * L)


def all_branches(spread: float) -> Numbers:
    """The density of all branches itself along every direction, without the cube root.

    Parameters
    ----------
    spread : float
        Geometric standard deviation of grain sizes s_r [-], 1 < spread <= 10.

    Returns
    -------
    Numbers
        Both numbers [-]; the kinematic one is 2 (exp(-L^2) + exp(-2 L^2)), and falls.

    Raises
    ------
    ValueOutOfRange
        The spread is outside its interval.

    Notes
    -----
    Accuracy: 1e-15 (kinematic), 1e-12 (static). Source: eq. (16); <l^2> = 2 <r^2> + 2 <r>^2.

    Examples
    --------
    >>> [round(all_branches(spread).kinematic, 4) for spread in (1.2, 1.5, 2.0)]
    [3.806, 3.1364, 2.0021]
    """
    square = math.log(SPREAD.read(spread, "spread")) ** 2
    return Numbers(2.0 * (math.exp(-square) + math.exp(-2.0 * square)), of_power(spread, 1.0).static)


def lognormal_lengths(spread: float) -> Numbers:
    """Eq. (19): a lognormal density of lengths, with the first two moments of all branches before the cube root.

    Parameters
    ----------
    spread : float
        Geometric standard deviation of grain sizes s_r [-], 1 < spread <= 10.

    Returns
    -------
    Numbers
        Both numbers [-]: 4 exp(-2 L^2) ((1 + exp(L^2))/2)^9, and exp(2 L^2) ((1 + exp(L^2))/2)^3.

    Raises
    ------
    ValueOutOfRange
        The spread is outside its interval.

    Notes
    -----
    Accuracy: 1e-15 times 1 + 9 L^2. Source: eq. (19), derived in ``derivations.gradation``.

    Examples
    --------
    >>> [round(lognormal_lengths(spread).kinematic, 4) for spread in (1.2, 1.5, 2.0)]
    [4.352, 6.2194, 17.1956]
    """
    from granular.generated.gradation import gradation_factor

    kinematic, static = gradation_factor(math.log(SPREAD.read(spread, "spread")) ** 2)
    return Numbers(4.0 * kinematic, 1.0 / static)


def lognormal_of_power(spread: float, power: float) -> float:
    """Eq. (19) with another power than 1/3 of the density of all branches in eq. (17): the kinematic number.

    Parameters
    ----------
    spread : float
        Geometric standard deviation of grain sizes s_r [-], 1 < spread <= 10.
    power : float
        Power p of the density [-], 0.25 to 2.

    Returns
    -------
    float
        4 exp(-2 L^2) ((1 + exp(L^2))/2)^(4/p - 3) [-]; 4 cosh(L^2/2)^4 for p = 4/7, which does not change to first
        order. The static number does not depend on the power.

    Raises
    ------
    ValueOutOfRange
        An argument is outside its interval.

    Notes
    -----
    Accuracy: 1e-15 times 1 + (2 + 4/p) L^2. Source: eq. (19), derived in ``derivations.gradation``.

    Examples
    --------
    >>> round(lognormal_of_power(1.5, 4 / 7), 4), round(lognormal_of_power(1.5, 1 / 3), 4)
    (4.0544, 6.2194)
    """
    log_variance = math.log(SPREAD.read(spread, "spread")) ** 2
    exponent = 4.0 / _POWER.read(power, "power") - 3.0
    return 4.0 * math.exp(exponent * math.log1p(math.expm1(log_variance) / 2.0) - 2.0 * log_variance)


def power_that_gives(spread: float, kinematic: float = 4.0) -> float:
    """Power of the density of all branches at which the kinematic number has a given value.

    Parameters
    ----------
    spread : float
        Geometric standard deviation of grain sizes s_r [-], 1 < spread <= 10.
    kinematic : float
        <l^2>/<r^3>^(2/3) [-]; 4 is what a stiffness that does not depend on uniformity needs.

    Returns
    -------
    float
        The power [-], 1/3 to 1; nan where none of them gives the value.

    Raises
    ------
    ValueOutOfRange
        An argument is outside its interval.

    Notes
    -----
    Accuracy: 1e-10. Source: bisection of :func:`of_power`, which falls with the power.

    Examples
    --------
    >>> [round(power_that_gives(spread), 4) for spread in (1.2, 1.5, 2.0)]
    [0.5753, 0.5921, 0.6315]
    """
    wanted = _WANTED.read(kinematic, "kinematic")
    return argument_that_gives(wanted, lambda power: of_power(spread, power).kinematic, 1.0, 1.0 / 3.0)


@dataclass(frozen=True, slots=True)
class Reading:
    """One reading of the paper.

    Attributes
    ----------
    name : str
        What is taken for the density of lengths, one line.
    numbers : callable
        From the spread s_r [-] to both numbers.
    relative_error : float
        Bound of the relative error of either number for spreads up to 3 [-].
    """

    name: str
    numbers: Callable[[float], Numbers]
    relative_error: float


READINGS: tuple[Reading, ...] = (
    Reading("cube root of g_total, eq. (17)", literal, 1e-13),
    Reading("lognormal density, eq. (19)", lognormal_lengths, 1e-14),
    Reading("eq. (17), sizes from 0.1 % to 99.9 % by volume", lambda spread: cut_by_volume(spread, 1e-3), 1e-12),
    Reading("eq. (17), sizes cut at 4 deviations by number", lambda spread: cut(spread, 4.0), 1e-12),
    Reading("square root of g_total", lambda spread: of_power(spread, 0.5), 1e-12),
    Reading("one length, that of grains of mean volume", lambda _: ONE_LENGTH, 0.0),
    Reading("g_total itself", all_branches, 1e-12),
)
"""Every reading, from the largest kinematic number for wide gradations to the smallest."""
