"""Hertz contact of two elastic spheres: stiffness ratio, and the unit that stiffnesses are measured in."""

from __future__ import annotations

import sys
from decimal import Context, Decimal

from granular.errors import ResultOutOfRange

_PI = Decimal("3.14159265358979323846264338327950288419716939937510582097494")
_DIGITS = Context(prec=50)
"""Working precision: the result is rounded to double once, and no intermediate can overflow."""


def stiffness_ratio(poisson_ratio: float) -> float:
    """Shear over normal stiffness of a contact that carries no shear force yet, lambda_0.

    Parameters
    ----------
    poisson_ratio : float
        Poisson ratio of the grain's solid, nu [-], 0 to 0.5.

    Returns
    -------
    float
        lambda_0 = 2 (1 - nu) / (2 - nu) [-], from 1 down to 2/3.

    Notes
    -----
    Accuracy: 3 units of the last place. Source: eq. (21) without shear force (Hertz-Mindlin).

    Examples
    --------
    >>> stiffness_ratio(0.0), stiffness_ratio(0.5)
    (1.0, 0.6666666666666666)
    """
    return 2.0 * (1.0 - poisson_ratio) / (2.0 - poisson_ratio)


def one_minus_stiffness_ratio(poisson_ratio: float) -> float:
    """1 - lambda_0 without the subtraction, which would lose its digits for a small Poisson ratio.

    Parameters
    ----------
    poisson_ratio : float
        Poisson ratio of the grain's solid, nu [-], 0 to 0.5.

    Returns
    -------
    float
        1 - lambda_0 = nu / (2 - nu) [-], from 0 up to 1/3.

    Notes
    -----
    Accuracy: 2 units of the last place. Source: eq. (21) without shear force.

    Examples
    --------
    >>> one_minus_stiffness_ratio(1e-20)
    5e-21
    """
    return poisson_ratio / (2.0 - poisson_ratio)


def normal_stiffness(shear_modulus: float, poisson_ratio: float, *, mean_stress: float,
                     contacts_per_volume: float) -> float:
    """Normal stiffness of every contact of the ideal assembly under a mean stress, k_n,ref.

    In an isotropic assembly under the isotropic stress p every contact carries ``f_n = 3 p / ((M/V) l)``.
    With the relative radius ``R_e = l/4`` the branch length l drops out of the Hertz law.

    Parameters
    ----------
    shear_modulus : float
        Shear modulus of the grain's solid, G_s [Pa], > 0.
    poisson_ratio : float
        Poisson ratio of the grain's solid, nu [-], 0 to 0.5.
    mean_stress : float
        Mean stress p [Pa], compression positive, > 0.
    contacts_per_volume : float
        M/V [1/m^3], > 0.

    Returns
    -------
    float
        k_n,ref = 3^(1/3) (G_s/(1 - nu))^(2/3) (3 p / (2 M/V))^(1/3) [N/m].

    Raises
    ------
    ResultOutOfRange
        The result does not fit into double precision.

    Notes
    -----
    Accuracy: rounded once, half a unit of the last place. Source: eqs (20) and (23).

    Examples
    --------
    >>> round(normal_stiffness(31e9, 0.21, mean_stress=28e3, contacts_per_volume=5.2677e9))
    332715
    """
    cube = _hertz_cube(shear_modulus, poisson_ratio, mean_stress)
    return _rounded(_cube_root(_DIGITS.divide(cube, _exact(contacts_per_volume))), "k_n,ref", "N/m")


def reference_stiffness(shear_modulus: float, poisson_ratio: float, *, mean_stress: float, void_ratio: float,
                        coordination_number: float, length_ratio: float = 1.0) -> float:
    """Stiffness unit of the model, (M/V) l_e^2 k_n,ref; it does not depend on the grain size.

    Parameters
    ----------
    shear_modulus : float
        Shear modulus of the grain's solid, G_s [Pa], > 0.
    poisson_ratio : float
        Poisson ratio of the grain's solid, nu [-], 0 to 0.5.
    mean_stress : float
        Mean stress p [Pa], compression positive, > 0.
    void_ratio, coordination_number : float
        e and N of the assembly [-], > 0.
    length_ratio : float
        Equivalent branch length l_e over the grain diameter 2 r_e [-], > 0.

    Returns
    -------
    float
        ``(l_e/(2 r_e))^2 (m^2 (G_s/(1 - nu))^2 9 p/2)^(1/3)`` with ``m = (M/V) (2 r_e)^3`` [Pa].

    Raises
    ------
    ResultOutOfRange
        The result does not fit into double precision.

    Notes
    -----
    Accuracy: rounded once, half a unit of the last place, for every double that may be given.
    Source: eqs (4), (8), (9), (20) and (23).

    Examples
    --------
    >>> round(reference_stiffness(31e9, 0.21, mean_stress=28e3, void_ratio=0.5744,
    ...                           coordination_number=8.6848))
    1752631710
    """
    exact, multiply = _exact, _DIGITS.multiply
    per_diameter_cubed = _DIGITS.divide(
        multiply(Decimal(3), exact(coordination_number)),
        multiply(_PI, _DIGITS.add(Decimal(1), exact(void_ratio))))
    cube = multiply(_hertz_cube(shear_modulus, poisson_ratio, mean_stress),
                    multiply(per_diameter_cubed, per_diameter_cubed))
    length = exact(length_ratio)
    return _rounded(multiply(multiply(length, length), _cube_root(cube)), "(M/V) l_e^2 k_n,ref", "Pa")


def _exact(value: float) -> Decimal:
    return Decimal(value)


def _hertz_cube(shear_modulus: float, poisson_ratio: float, mean_stress: float) -> Decimal:
    """The cube of k_n,ref times M/V: 3 (G_s/(1 - nu))^2 (3 p/2)."""
    modulus = _DIGITS.divide(_exact(shear_modulus), _DIGITS.subtract(Decimal(1), _exact(poisson_ratio)))
    return _DIGITS.multiply(_DIGITS.multiply(modulus, modulus),
                            _DIGITS.multiply(Decimal("4.5"), _exact(mean_stress)))


def _cube_root(value: Decimal) -> Decimal:
    return _DIGITS.power(value, _DIGITS.divide(Decimal(1), Decimal(3)))


def _rounded(value: Decimal, name: str, unit: str) -> float:
    """Round to double, or refuse: a result is never infinite, zero or short of digits."""
    number = float(value)
    if not sys.float_info.min <= number <= sys.float_info.max:
        raise ResultOutOfRange(f"{name} = {value:.3e} {unit}",
                               allowed=f"allowed {sys.float_info.min:.3g} to {sys.float_info.max:.3g}",
                               remedy="Check the units of shear_modulus and mean stress.")
    return number
