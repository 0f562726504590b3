"""Aligned spheroids: their size against the sphere of equal volume, and their branch vectors."""

from __future__ import annotations

from decimal import Context, Decimal, localcontext
from fractions import Fraction
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

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
