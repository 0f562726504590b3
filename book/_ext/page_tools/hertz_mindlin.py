"""A second opinion on the isotropic assembly: the rock-physics formula for Hertz-Mindlin contacts without slip.

Written from the published formula alone and kept outside the library on purpose: it shares no line with what it is
compared with.
"""

from __future__ import annotations

import math


def moduli(
    shear_modulus: float, poisson_ratio: float, *, mean_stress: float, void_ratio: float, coordination_number: float,
) -> tuple[float, float]:
    """Bulk and shear modulus of a random isotropic packing of equal rough spheres [Pa].

    Parameters
    ----------
    shear_modulus : float
        Of the grains [Pa].
    poisson_ratio : float
        Of the grains [-].
    mean_stress : float
        On the packing [Pa], compression positive.
    void_ratio : float
        Volume of voids over volume of solids [-].
    coordination_number : float
        Mean number of contacts per grain [-].

    Notes
    -----
    Source: Walton (1987), infinitely rough spheres; Mindlin (1949) for the tangential stiffness.
    """
    solid_fraction = 1 / (1 + void_ratio)
    common = (coordination_number * solid_fraction * shear_modulus / (math.pi * (1 - poisson_ratio))) ** 2 * mean_stress
    bulk = math.cbrt(common / 18)
    shear = (5 - 4 * poisson_ratio) / (5 * (2 - poisson_ratio)) * math.cbrt(3 * common / 2)
    return bulk, shear
