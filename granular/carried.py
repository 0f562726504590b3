"""The stress that contact forces carry when those of sliding contacts are cut down to their friction."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from granular.contact_distribution import normal_force, shear_force
from granular.directions import branch_weight, relative_density

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from granular.fabric import AxialFabric
    from granular.loading import Loading

    Array = NDArray[np.float64]

POINTS, PIECES = 24, 60
"""Gauss points in each of so many equal pieces of the quarter circle."""


def carried_stress(fabric: AxialFabric, loading: Loading) -> tuple[float, float]:
    """Mean stress of the estimated forces with every shear force cut down to what friction allows.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branch lengths about axis 3 [-].
    loading : Loading
        Stress and friction; without friction nothing is cut.

    Returns
    -------
    tuple of float
        sigma11 and sigma33 over the mean stress [-]. Contacts that would have opened carry nothing.

    Notes
    -----
    Accuracy: about 1e-6 where contacts slide, because the integrand has a kink at the edges of sliding; 1e-14 where
    none does. Source: sigma_ij = (M/V) <l_i f_j> with the forces of eq. (23).

    Examples
    --------
    >>> from granular.fabric import AxialFabric
    >>> from granular.loading import Loading
    >>> [round(value, 12) for value in carried_stress(AxialFabric(), Loading.of_ratio(2.0))]
    [0.75, 1.5]
    """
    import numpy as np

    beta, weight = _nodes()
    x, sine = np.cos(beta), np.sin(beta)
    normal = normal_force(fabric, loading, x)
    shear = shear_force(fabric, loading, x)
    if loading.friction is not None:
        shear = np.minimum(shear, loading.friction * np.maximum(normal, 0.0))
    normal = np.maximum(normal, 0.0)
    a, c = loading.coefficients(fabric.D33)
    towards_pole = 1.0 if c >= a else -1.0
    share = weight * sine * relative_density(fabric, x) * branch_weight(fabric, x)
    vertical = normal * x + towards_pole * shear * sine
    horizontal = normal * sine - towards_pole * shear * x
    # f is in units of 3 p V/(M l_e): an isotropic assembly carries 3 <x^2> = 1 along every axis.
    return float(1.5 * np.sum(share * horizontal * sine)), float(3.0 * np.sum(share * vertical * x))


def _nodes() -> tuple[Array, Array]:
    """Angles from the axis and weights of a composite Gauss rule over the quarter circle."""
    import numpy as np

    node, weight = np.polynomial.legendre.leggauss(POINTS)
    width = math.pi / 2 / PIECES
    middles = width * (np.arange(PIECES) + 0.5)
    return (middles[:, None] + width / 2 * node).ravel(), np.tile(width / 2 * weight, PIECES)
