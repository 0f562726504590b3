"""What partial slip takes from six integrals of the contact stiffness, by the rule that serves every state.

Forces are scaled here so that the mean of their cube roots at pole and equator is 1. Contacts then differ in two
numbers: the contrast v of these roots and the share kappa of its friction that a contact uses up at the most.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from granular.batch.slip_layout import INTEGRALS, STRENGTHS, ZONE
from granular.routes.log_tangent import TANGENT
from granular.routes.log_tangent_array import Arc, beside, between, directions, sticking
from granular.routes.slip_geometry_array import Geometry
from granular.routes.windows import EQUATOR_SLIP, POLE_SLIP

if TYPE_CHECKING:
    from collections.abc import Iterator

    from numpy.typing import NDArray

    Array = NDArray[np.float64]


def lost_integrals(margin: Array, contrast: Array) -> Array:
    """Integrals of what partial slip takes from the cube root of the normal force.

    Parameters
    ----------
    margin : (n,) array
        1 - kappa [-], < 1.
    contrast : (n,) array
        v [-], -1 < v < 1.

    Returns
    -------
    (6, n) array
        L_k, the integral of s^(5-k) x^(2k) [f_n^(1/3) - max(f_n - f_r/mu, 0)^(1/3)] over 0 <= x <= 1 [-].

    Notes
    -----
    Accuracy: two to three units in the last place. Source: ``granular.routes.log_tangent``.

    Examples
    --------
    >>> lost_integrals(np.array([0.5]), np.array([0.1])).shape
    (6, 1)
    """
    a, c = (1 - contrast) ** 3, (1 + contrast) ** 3
    kappa, center = 1 - margin, np.sqrt(c / a)
    spread = kappa + np.sqrt(np.maximum(-margin * (1 + kappa), 0.0))
    geometry = Geometry(a, c, kappa, margin, center, center / spread, center * spread)
    result = np.zeros((INTEGRALS, margin.size))
    for arc in _arcs(geometry):
        for index, t, measure, _, gamma in arc.blocks():
            s, y, weight = directions(t, measure)
            density = weight * gamma * np.cbrt(a[index, None] * s + c[index, None] * y)
            of_s, of_y = _powers(s), _powers(y)
            for k in range(INTEGRALS):
                result[k, index] += (density * (of_s[INTEGRALS - 1 - k] * of_y[k])).sum(axis=-1)
    return result


def _powers(base: Array) -> list[Array]:
    """Powers 0 to 5, by products: a general power takes many times as long."""
    found = [np.ones_like(base), base]
    while len(found) < INTEGRALS:
        found.append(found[-1] * base)
    return found


def _arcs(geometry: Geometry) -> Iterator[Arc]:
    rho = np.sqrt(np.maximum(-geometry.left / 2, 0.0))
    wide = rho >= TANGENT
    places = np.array([np.zeros_like(rho), np.log(geometry.center)])
    low, high = np.full_like(rho, POLE_SLIP), np.full_like(rho, EQUATOR_SLIP)
    for outward in (False, True):
        yield sticking(geometry, ~wide, low, high, TANGENT, places, outward=outward)
        yield beside(geometry, wide, low, high, rho, places, outward=outward)
        yield between(geometry, wide, low, high, places, outward=outward)


def smooth_values(margin: Array, contrast: Array) -> Array:
    """What a table holds: lost integrals over kappa, with the part that is not smooth taken out near the onset.

    Parameters
    ----------
    margin, contrast : (n,) array
        As for :func:`lost_integrals` [-].

    Returns
    -------
    (6, n) array
        (L_k + W_k)/kappa where abs(margin) < ZONE, L_k/kappa elsewhere [-], W_k the emitted onset part.

    Notes
    -----
    Accuracy: three to five units in the last place. Source: the derivation ``slip_table``.

    Examples
    --------
    >>> smooth_values(np.array([0.5]), np.array([0.1])).shape
    (6, 1)
    """
    from granular.generated.slip_table_array import onset_part

    lost = lost_integrals(margin, contrast)
    near = np.abs(margin) < ZONE
    lost[:, near] += onset_part(margin[near], contrast[near], STRENGTHS[np.where(margin[near] >= 0, 0, 1)])
    result: Array = lost / (1 - margin)
    return result
