"""Aligned spheroids: their size against the sphere of equal volume, and their branch vectors."""

from __future__ import annotations

from dataclasses import replace
from decimal import Context, Decimal, localcontext
from fractions import Fraction
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from granular.fabric import AxialFabric

DIGITS = Context(prec=40)
"""Working precision of the cube root: what is rounded is the result of a route alone."""


def squared_equator(aspect_ratio: float) -> Fraction:
    """Square of the equatorial radius over that of the sphere of equal volume, (a/r_e)^2.

    Parameters
    ----------
    aspect_ratio : float
        b/a [-], > 0.

    Returns
    -------
    Fraction
        (b/a)^(-2/3) [-], because a^2 b = r_e^3; exactly 1 for a sphere.

    Notes
    -----
    Accuracy: 1e-38 of the value. Source: volume of a spheroid.

    Examples
    --------
    >>> float(squared_equator(8.0))
    0.25
    """
    if aspect_ratio == 1.0:
        return Fraction(1)
    with localcontext(DIGITS):
        return Fraction(Decimal(aspect_ratio) ** (Decimal(-2) / 3))


def branch_vectors(aspect_ratio: float, directions: ArrayLike) -> NDArray[np.float64]:
    """Branch vector between two aligned spheroids that touch with a given contact normal.

    Parameters
    ----------
    aspect_ratio : float
        b/a, with b along axis 3 [-], > 0.
    directions : (3, ...) array
        Contact normals, unit vectors [-].

    Returns
    -------
    (3, ...) array
        l/(2 r_e) = 2 M^2 n/\\|M n\\|/(2 r_e) [-], with M = diag(a, a, b) and a^2 b = r_e^3; equal to n for spheres.

    Notes
    -----
    Accuracy: a few units in the last place. Source: ``derivations.spheroid``: M^2 n/\\|M n\\| is the point of the
    surface whose outward normal is n.

    Examples
    --------
    >>> branch_vectors(8.0, [[1.0, 0.0], [0.0, 0.0], [0.0, 1.0]]).tolist()
    [[0.5, 0.0], [0.0, 0.0], [0.0, 4.0]]
    """
    import numpy as np

    n = np.asarray(directions, dtype=float)
    scale = np.array([1.0, 1.0, aspect_ratio]).reshape(3, *([1] * (n.ndim - 1)))
    height = np.sqrt(np.sum((scale * n) ** 2, axis=0))
    branch: NDArray[np.float64] = scale**2 * n / height * float(squared_equator(aspect_ratio)) ** 0.5
    return branch


def branch_length(aspect_ratio: float, cosine: ArrayLike) -> NDArray[np.float64]:
    """Length of the branch between aligned spheroids, by the direction of the contact normal.

    Parameters
    ----------
    aspect_ratio : float
        b/a with b along axis 3 [-], > 0.
    cosine : float or (...) array
        Cosine of the angle between the normal and axis 3 [-], -1 to 1.

    Returns
    -------
    (...) array
        \\|l\\|/(2 r_e) [-].

    Notes
    -----
    Accuracy: a few units in the last place. Source: :func:`branch_vectors`.

    Examples
    --------
    >>> branch_length(8.0, [0.0, 1.0]).tolist()
    [0.5, 4.0]
    """
    import numpy as np

    x = np.asarray(cosine, dtype=float)
    branch = branch_vectors(aspect_ratio, np.stack([np.sqrt((1 - x) * (1 + x)), np.zeros_like(x), x]))
    length: NDArray[np.float64] = np.sqrt(np.sum(branch * branch, axis=0))
    return length


def stress_carried(fabric: AxialFabric) -> tuple[float, float]:
    """Mean stress that the estimated contact forces make on spheroids, over the stress that they were estimated from.

    The estimate of eq. (22) neglects the angle between branch and normal, so that its forces balance the stress on
    spheres only.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and aspect ratio [-].

    Returns
    -------
    tuple of 2 float
        Across and along axis 3: <n^l_i n_k>/N_ik with n^l along the branch [-]; both 1 for spheres.

    Notes
    -----
    Accuracy: 1e-15. Source: eqs (24) and (25) with the forces of eq. (23).

    Examples
    --------
    >>> from granular.fabric import AxialFabric
    >>> [round(share, 3) for share in stress_carried(AxialFabric(aspect_ratio=0.8))]
    [1.075, 0.814]
    """
    from math import fsum

    from granular.hypothesis import Hypothesis
    from granular.routes.contact_rule import suitable_contacts

    nodes = suitable_contacts(replace(fabric, Dr33=0.0), None, Hypothesis.STATIC).directions
    weight = nodes.balance(fabric)
    across = fsum(map(float.__mul__, weight, nodes.sine_squared)) / 2
    along = fsum(map(float.__mul__, weight, nodes.cosine_squared)) * fabric.aspect_ratio**2
    return across / (1 / 3 - fabric.D33 / 15), along / (1 / 3 + 2 * fabric.D33 / 15)
