"""Aligned spheroids in ball arithmetic: contacts of equal stiffness, under both hypotheses.

The moments of E/Q, of E Q/(s + r^4 x^2) and of E/sqrt(s + r^4 x^2), with Q = s + r^2 x^2, are hypergeometric functions.
The components are written directly in them, before any symmetrisation, and the spin is eliminated from the energy.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from granular.fabric import AxialFabric
from granular.routes.balls import ball, exact_weights, inverse_moment, stiffness_from_compliance

Three = tuple[Any, Any, Any]
"""Moments with s^2, s x^2 and x^4."""

ONE, HALF = Fraction(1), Fraction(1, 2)


def kinematic(flint: Any, fabric: AxialFabric, poisson: Fraction) -> tuple[Any, ...]:
    """Six kinematic components.

    Parameters
    ----------
    flint : module
        python-flint, its working precision set.
    fabric : AxialFabric
        Contact normals, aspect ratio and spin [-].
    poisson : Fraction
        Poisson's ratio of the grain material [-].

    Returns
    -------
    tuple of arb, (6,)
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n,ref [-].

    Notes
    -----
    Accuracy: enclosures. Source: eq. (6) with l = 2 M^2 n/\\|M n\\|.
    """
    squared = Fraction(fabric.aspect_ratio) ** 2
    in_plane, mixed, axial = _three(flint, fabric, (ONE, squared), ONE)  # <E s^2/Q>, <E s x^2/Q>, <E x^4/Q>
    lam = (2 - 2 * poisson) / (2 - poisson)
    kr, apart, r2 = ball(flint, lam), ball(flint, 1 - lam), ball(flint, squared)
    across, along = in_plane + mixed, mixed + axial  # <E s/Q> and <E x^2/Q>
    c_2323 = apart * mixed / 2 + kr * across / 2  # l_2 k_33 l_2
    c_3232 = r2**2 * (apart * mixed / 2 + kr * along)  # l_3 k_22 l_3
    c_2332 = r2 * apart * mixed / 2  # l_2 k_32 l_3
    shear = (c_2323 + 2 * c_2332 + c_3232) / 4
    if fabric.free_spin:
        shear = (c_2323 * c_3232 - c_2332**2) / (c_2323 + c_3232 - 2 * c_2332)
    size = _size(flint, fabric)
    return tuple(size * component for component in (
        apart * 3 * in_plane / 8 + kr * across / 2, r2**2 * (apart * axial + kr * along), apart * in_plane / 8,
        r2 * apart * mixed / 2, shear, apart * in_plane / 8 + kr * across / 4))


def static(flint: Any, fabric: AxialFabric, poisson: Fraction) -> tuple[Any, ...]:
    """Six static components, from forces that balance the stress on spheroids.

    Parameters
    ----------
    flint : module
        python-flint, its working precision set.
    fabric : AxialFabric
        Contact normals and aspect ratio [-].
    poisson : Fraction
        Poisson's ratio of the grain material [-].

    Returns
    -------
    tuple of arb, (6,)
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n,ref [-].

    Notes
    -----
    Accuracy: enclosures. Source: Figure 1(b) with the mean of n^l_i n_k over the contacts in place of N_ik.
    """
    squared = Fraction(fabric.aspect_ratio) ** 2
    length = (ONE, squared**2)
    density, _, _ = exact_weights(fabric)
    weights = [Fraction(0)] * 4  # of E Q in s^3, s^2 x^2, s x^4, x^6
    for i, e in enumerate(density):
        weights[i] += e
        weights[i + 1] += e * squared
    three = [sum((ball(flint, w) * inverse_moment(flint, length, ONE, 5 - i - k, i + k)
                  for i, w in enumerate(weights)), flint.arb(0)) for k in range(3)]
    across, along = (sum((ball(flint, e) * inverse_moment(flint, length, HALF, 2 - i + 1 - k, i + k)
                          for i, e in enumerate(density)), flint.arb(0)) for k in range(2))
    lam = (2 - 2 * poisson) / (2 - poisson)
    apart, shear = ([ball(flint, factor) * moment for moment in three] for factor in (1 - 1 / lam, 1 / lam))
    tensor = across / 2, ball(flint, squared) * along
    size = _size(flint, fabric)
    return tuple(size * component for component in stiffness_from_compliance(flint, tensor, apart, shear))


def _three(flint: Any, fabric: AxialFabric, form: tuple[Fraction, Fraction], power: Fraction) -> Three:
    """<E s^2 f^-p>, <E s x^2 f^-p> and <E x^4 f^-p> for a form f in s and x^2."""
    density, _, _ = exact_weights(fabric)
    by_power = [inverse_moment(flint, form, power, 4 - m, m) for m in range(5)]
    first, second, third = (sum((ball(flint, e) * by_power[j + k] for j, e in enumerate(density)), flint.arb(0))
                            for k in range(3))
    return first, second, third


def _size(flint: Any, fabric: AxialFabric) -> Any:
    """(a/r_e)^2 = r^(-2/3)."""
    return ball(flint, Fraction(fabric.aspect_ratio)) ** ball(flint, Fraction(-2, 3))
