"""Limits that are known symbolically: rational components, identities between components, exact zeros."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from granular.fabric import AxialFabric

Known = Callable[[AxialFabric, float], tuple[Fraction, ...]]
"""Six exact components over (M/V) l_e^2 k_n from a fabric and Poisson's ratio."""


def stiffness_ratio(poisson_ratio: float) -> Fraction:
    """Ratio k_r/k_n of a contact without tangential force.

    Parameters
    ----------
    poisson_ratio : float
        Poisson's ratio of the grain material [-], taken as exact.

    Returns
    -------
    Fraction
        lam = 2 (1 - nu)/(2 - nu) [-].

    Notes
    -----
    Accuracy: exact. Source: eq. (21).

    Examples
    --------
    >>> stiffness_ratio(0.5)
    Fraction(2, 3)
    """
    nu = Fraction(poisson_ratio)
    return 2 * (1 - nu) / (2 - nu)


def kinematic_polynomial(fabric: AxialFabric, poisson_ratio: float) -> tuple[Fraction, ...]:
    """Six kinematic components as polynomials in D33 and Dr33, for a density of rank two.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branch lengths [-], with D3333 = 0.
    poisson_ratio : float
        Poisson's ratio of the grain material [-].

    Returns
    -------
    tuple of Fraction, (6,)
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n [-].

    Notes
    -----
    C = c0 + (D + 2 Dr) c1 + (2 D Dr + Dr^2) c2 + D Dr^2 c3, so that to first order the anisotropies of normals and
    of branches cannot be told apart. Accuracy: exact. Source: eq. (7), integrated over the sphere.

    Examples
    --------
    >>> c1111, c3333, *_ = kinematic_polynomial(AxialFabric(), 0.0)
    >>> c1111 == c3333 == Fraction(1, 3)
    True
    """
    lam, d, dr = stiffness_ratio(poisson_ratio), Fraction(fabric.D33), Fraction(fabric.Dr33)
    powers = (Fraction(1), d + 2 * dr, 2 * d * dr + dr**2, d * dr**2)
    rows = (
        ((2 * lam + 3) / 15, -(lam + 6) / 105, (2 * lam + 3) / 105, (lam - 12) / 1155),
        ((2 * lam + 3) / 15, 2 * (lam + 6) / 105, (2 * lam + 9) / 105, 2 * (5 * lam + 39) / 1155),
        ((1 - lam) / 15, -2 * (1 - lam) / 105, (1 - lam) / 105, -4 * (1 - lam) / 1155),
        ((1 - lam) / 15, (1 - lam) / 105, (1 - lam) / 105, (1 - lam) / 231),
        ((3 * lam + 2) / 30, (3 * lam + 4) / 420, (3 * lam + 1) / 105, (57 * lam + 20) / 4620),
        ((3 * lam + 2) / 30, -(3 * lam + 4) / 210, (3 * lam + 2) / 210, -(3 * lam + 8) / 2310))
    return tuple(sum((c * power for c, power in zip(row, powers, strict=True)), Fraction(0)) for row in rows)


def isotropic_kinematic(_fabric: AxialFabric, poisson_ratio: float) -> tuple[Fraction, ...]:
    """Six kinematic components of the isotropic assembly: K = 1/9, G = (2 + 3 lam)/30.

    Parameters
    ----------
    poisson_ratio : float
        Poisson's ratio of the grain material [-].

    Returns
    -------
    tuple of Fraction, (6,)
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n [-].

    Notes
    -----
    Accuracy: exact. Source: eq. (4) with E and W constant.

    Examples
    --------
    >>> isotropic_kinematic(AxialFabric(), 0.0)[4]
    Fraction(1, 6)
    """
    return _isotropic((2 + 3 * stiffness_ratio(poisson_ratio)) / 30)


def isotropic_static(_fabric: AxialFabric, poisson_ratio: float) -> tuple[Fraction, ...]:
    """Six static components of the isotropic assembly: K = 1/9, G = 5 lam/(6 (3 + 2 lam)).

    Parameters
    ----------
    poisson_ratio : float
        Poisson's ratio of the grain material [-].

    Returns
    -------
    tuple of Fraction, (6,)
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n [-].

    Notes
    -----
    Accuracy: exact. Source: Figure 1(b) with eq. (23), E and W constant.

    Examples
    --------
    >>> isotropic_static(AxialFabric(), 0.0)[4]
    Fraction(1, 6)
    """
    lam = stiffness_ratio(poisson_ratio)
    return _isotropic(5 * lam / (6 * (3 + 2 * lam)))


def _isotropic(shear: Fraction) -> tuple[Fraction, ...]:
    bulk = Fraction(1, 9)
    longitudinal, lateral = bulk + 4 * shear / 3, bulk - 2 * shear / 3
    return longitudinal, longitudinal, lateral, lateral, shear, shear


def kinematic_trace(fabric: AxialFabric) -> Fraction:
    """C3333 + 2 C1111 + 2 C1122 + 4 C1133 = <E W^2>, whatever the tangential stiffness.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branch lengths [-].

    Returns
    -------
    Fraction
        The sum over (M/V) l_e^2 k_n [-].

    Notes
    -----
    Nine times the stiffness against a change of volume alone, in which contacts do not slide sideways. Accuracy:
    exact. Source: eq. (7) contracted in i = j and in k = l.

    Examples
    --------
    >>> kinematic_trace(AxialFabric())
    Fraction(1, 1)
    """
    d, q, dr = Fraction(fabric.D33), Fraction(fabric.D3333), Fraction(fabric.Dr33)
    return 1 + (2 * d * dr + dr**2) / 5 + 2 * (d + q) * dr**2 / 35
