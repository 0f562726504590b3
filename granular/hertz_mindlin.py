"""A second opinion on the isotropic assembly: the rock-physics formula for Hertz-Mindlin contacts without slip.

Written from the published formula alone: it shares no line with the chain from contacts to stiffness that it is
compared with.
"""

from __future__ import annotations

import math


def moduli(
    shear_modulus: float, poisson_ratio: float, *, mean_stress: float, void_ratio: float, coordination_number: float,
) -> tuple[float, float]:
    """Bulk and shear modulus of a random isotropic packing of equal rough spheres.

    Parameters
    ----------
    shear_modulus : float
        Of the grains [Pa], > 0.
    poisson_ratio : float
        Of the grains [-], 0 to 0.5.
    mean_stress : float
        On the packing [Pa], compression positive, > 0.
    void_ratio : float
        Volume of voids over volume of solids [-], > 0.
    coordination_number : float
        Mean number of contacts per grain [-], > 0.

    Returns
    -------
    tuple of 2 float
        Bulk and shear modulus [Pa], to about twenty roundings.

    Notes
    -----
    Source: Walton (1987), infinitely rough spheres; Mindlin (1949) for the tangential stiffness.

    Examples
    --------
    >>> bulk, shear = moduli(31e9, 0.21, mean_stress=28e3, void_ratio=0.5744, coordination_number=8.6848)
    >>> round(bulk / 1e6, 2), round(shear / 1e6, 2)
    (194.74, 271.54)
    """
    solid_fraction = 1 / (1 + void_ratio)
    common = (coordination_number * solid_fraction * shear_modulus / (math.pi * (1 - poisson_ratio))) ** 2 * mean_stress
    bulk = math.cbrt(common / 18)
    shear = (5 - 4 * poisson_ratio) / (5 * (2 - poisson_ratio)) * math.cbrt(3 * common / 2)
    return bulk, shear
