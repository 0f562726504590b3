"""Six components and their slopes as rows of 36 numbers, for arrays of assemblies that are known to be admissible."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from granular.derivatives.integrals import force_integrals, short_integrals, soft_integrals
from granular.derivatives.slip import sticking_sums
from granular.generated import gradients_array as emitted
from granular.generated.kinetic_components_array import stiffness_from_flexibilities, stiffness_from_weights
from granular.hypothesis import Hypothesis
from granular.routes.axial_kinetic_array import Elements, moments
from granular.routes.slip_geometry_array import force_difference, forces, slip_geometry

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

BLOCK = 4096
"""Elements evaluated at a time."""

COLUMNS = 36
"""Six components, then six slopes each by D33, Dr33, SR, mu and nu."""

VALUE, D33_, DR33, SR, MU, NU = range(6)
"""Places of the six in a row, in units of six columns."""


def constant_rows(D33: Array, Dr33: Array, nu: Array, hypothesis: Hypothesis) -> Array:
    """Every contact equally stiff: slopes by stress ratio and friction are zero.

    Parameters
    ----------
    D33, Dr33, nu : (n,) array
        Coefficients of the fabric, and Poisson's ratio [-].
    hypothesis : Hypothesis
        Kinematic or static.

    Returns
    -------
    (n, 36) array
        As :data:`COLUMNS` says [-].

    Notes
    -----
    Source: ``derivations.gradients``.
    """
    if hypothesis is Hypothesis.KINEMATIC:
        parts = emitted.kinematic_constant_gradient(D33, Dr33, nu)
    else:
        parts = emitted.static_constant_gradient(D33, Dr33, nu, *short_integrals(1 - Dr33 / 2, 1 + Dr33))
    result = np.zeros((D33.size, COLUMNS))
    _place(result, parts, (VALUE, D33_, DR33, NU))
    return result


def kinetic_rows(D33: Array, Dr33: Array, stress_ratio: Array, nu: Array, hypothesis: Hypothesis) -> Array:
    """Contacts as stiff as their normal force makes them, none slipping.

    Parameters
    ----------
    D33, Dr33, stress_ratio, nu : (n,) array
        Coefficients of the fabric, sigma33/sigma11, and Poisson's ratio [-].
    hypothesis : Hypothesis
        Kinematic or static.

    Returns
    -------
    (n, 36) array
        As :data:`COLUMNS` says [-].

    Notes
    -----
    Source: ``derivations.gradients``.
    """
    if hypothesis is Hypothesis.KINEMATIC:
        parts = emitted.kinematic_kinetic_gradient(D33, Dr33, stress_ratio, nu, *_forces(D33, stress_ratio))
    else:
        parts = emitted.static_kinetic_gradient(D33, Dr33, stress_ratio, nu, *_soft(D33, Dr33, stress_ratio))
    result = np.zeros((D33.size, COLUMNS))
    _place(result, parts, (VALUE, D33_, DR33, SR, NU))
    return result


def slip_rows(D33: Array, Dr33: Array, stress_ratio: Array, friction: Array, nu: Array,
              hypothesis: Hypothesis) -> Array:
    """Contacts that slip against friction and carry shear forces.

    Parameters
    ----------
    D33, Dr33, stress_ratio, friction, nu : (n,) array
        Coefficients of the fabric, sigma33/sigma11, mu > 0, and Poisson's ratio [-]; c and a differ, and no element
        is exactly at the onset of sliding.
    hypothesis : Hypothesis
        Kinematic, or static where no contact slides.

    Returns
    -------
    (n, 36) array
        As :data:`COLUMNS` says [-].

    Notes
    -----
    Source: ``derivations.gradients``.
    """
    a, c = forces(D33, stress_ratio)
    d = force_difference(D33, stress_ratio)
    elements = Elements(1 - D33 / 2, 1 + D33, 1 - Dr33 / 2, 1 + Dr33, a, c)
    sums = sticking_sums(elements, slip_geometry(D33, stress_ratio, friction), hypothesis)
    by_forces = np.array(emitted.shear_slopes(D33, stress_ratio, friction, a, c, d, np.sign(d), *sums[:7]))
    shear_slopes = {D33_: sums[7:10] + by_forces[0::3], DR33: sums[10:13], SR: by_forces[1::3],
                    MU: by_forces[2::3]}
    values = moments(D33, Dr33, stress_ratio, friction, hypothesis=hypothesis)
    if hypothesis is Hypothesis.KINEMATIC:
        return _stiff_rows(D33, Dr33, stress_ratio, nu, values, shear_slopes)
    return _soft_rows(D33, Dr33, stress_ratio, nu, values, shear_slopes)


def _stiff_rows(D33: Array, Dr33: Array, stress_ratio: Array, nu: Array, values: Array,
                shear_slopes: dict[int, Array]) -> Array:
    """Kinematic components and slopes from moments of normal and shear stiffness and their slopes: all linear."""
    lam, by_nu, rest = 2 * (1 - nu) / (2 - nu), -2 / (2 - nu) ** 2, nu / (2 - nu)
    normal, shear, lost = values
    result = np.zeros((D33.size, COLUMNS))
    gap = rest * normal + lam * lost
    _fill(result, VALUE, stiffness_from_weights(*normal, *(lam * shear), *gap[:2]))
    found = emitted.normal_moments(D33, Dr33, stress_ratio, *_forces(D33, stress_ratio))
    normal_slopes = dict(zip((D33_, DR33, SR), np.array(found[3:]).reshape(3, 3, -1), strict=True))
    still = np.zeros_like(normal)
    for place, change in shear_slopes.items():
        pushed = normal_slopes.get(place, still)
        _fill(result, place, stiffness_from_weights(*pushed, *(lam * change), *(pushed - lam * change)[:2]))
    _fill(result, NU, stiffness_from_weights(*still, *(by_nu * shear), *(-by_nu * shear)[:2]))
    return result


def _soft_rows(D33: Array, Dr33: Array, stress_ratio: Array, nu: Array, values: Array,
               shear_slopes: dict[int, Array]) -> Array:
    """Static components and slopes from moments of the flexibilities and their slopes, through the inverse."""
    lam, by_nu, rest = 2 * (1 - nu) / (2 - nu), -2 / (2 - nu) ** 2, nu / (2 - nu)
    normal, shear, lost = values
    gap = (rest * normal + lost) / lam
    state: list[Array] = [*normal, *(shear / lam), *gap[:2], D33]
    result = np.zeros((D33.size, COLUMNS))
    _fill(result, VALUE, stiffness_from_flexibilities(*state))
    found = emitted.soft_moments(D33, Dr33, stress_ratio, *_soft(D33, Dr33, stress_ratio))
    normal_slopes = dict(zip((D33_, DR33, SR), np.array(found[3:]).reshape(3, 3, -1), strict=True))
    still = np.zeros_like(normal)
    shear_slopes = {**shear_slopes, NU: -by_nu / lam * shear}
    for place, change in shear_slopes.items():
        pushed = normal_slopes.get(place, still)
        turned = np.ones_like(D33) if place == D33_ else still[0]
        moved: list[Array] = [*state, *pushed, *(change / lam), *(change / lam - pushed)[:2], turned]
        _fill(result, place, emitted.static_slope(*moved))
    return result


def _forces(D33: Array, stress_ratio: Array) -> Array:
    return force_integrals(*forces(D33, stress_ratio), force_difference(D33, stress_ratio))


def _soft(D33: Array, Dr33: Array, stress_ratio: Array) -> Array:
    return soft_integrals(1 - Dr33 / 2, 1 + Dr33, *forces(D33, stress_ratio))


def _place(result: Array, parts: tuple[Array, ...], places: tuple[int, ...]) -> None:
    for number, place in enumerate(places):
        _fill(result, place, parts[6 * number:6 * number + 6])


def _fill(result: Array, place: int, parts: tuple[Array, ...]) -> None:
    for column, values in enumerate(parts, start=6 * place):
        result[:, column] = values
