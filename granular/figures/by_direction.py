"""What contacts carry in each direction, and the directions in which they slide or have opened."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING

from granular.contact_distribution import normal_force, normal_stiffness, shear_force, shear_stiffness

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from granular.fabric import AxialFabric
    from granular.loading import Loading

    Array = NDArray[np.float64]

Range = tuple[float, float]

EVEN = 181
"""Angles at even distance from 0 to 90 degrees."""

NEAR = tuple(10.0 ** -(k / 4) for k in range(29))
"""Distances of further angles from the edges of sliding [degrees], where the shear stiffness ends like a cube root."""


@dataclass(frozen=True, slots=True)
class Limits:
    """Directions from 0 to 90 degrees in which contacts slide or have opened.

    Attributes
    ----------
    sliding, opened : tuple of 2 float, or None
        Angles from axis 3 between which they do [degrees]; None where no contact does.
    """

    sliding: Range | None
    opened: Range | None


@dataclass(frozen=True, slots=True)
class ByDirection:
    """Forces and stiffnesses of the contacts against the angle from axis 3.

    Attributes
    ----------
    degrees : (n,) array
        Angles from 0 to 90, the edges of sliding among them [degrees].
    normal, shear : (n,) array
        Forces over that of the isotropic assembly under the same mean stress [-].
    limit : (n,) array or None
        The shear force at which contacts slide, same unit; None without friction data.
    k_normal, k_shear : (n,) array
        Stiffnesses over k_n,ref [-].
    limits : Limits
        Where contacts slide or have opened.
    """

    degrees: Array
    normal: Array
    shear: Array
    limit: Array | None
    k_normal: Array
    k_shear: Array
    limits: Limits


def limits(D33: float | Fraction, loading: Loading) -> Limits:
    """Find the directions in which contacts slide or have opened.

    Parameters
    ----------
    D33 : float or Fraction
        P2 coefficient of the contact-normal density [-].
    loading : Loading
        Stress and friction.

    Returns
    -------
    Limits
        A range of no width, as at exact tangency, counts as none.

    Notes
    -----
    Accuracy: whether there is a range is decided in exact arithmetic; its ends hold to a few units in the last place.
    Source: roots of a t^2 - (\\|c - a\\|/mu) t + c in t = tan(beta), from eqs (21) and (23); opened is a t^2 + c <= 0.

    Examples
    --------
    >>> from granular.loading import Loading
    >>> limits(0.0, Loading.of_ratio(4.0, friction=0.75))
    Limits(sliding=None, opened=None)
    """
    a, c = loading.coefficients(D33)
    crossing = math.degrees(math.atan(math.sqrt(-c / a))) if a * c < 0 else None  # where the normal force vanishes
    opened = None if crossing is None else (0.0, crossing) if c < 0 else (crossing, 90.0)
    low, high = (opened[1] if c < 0 else 0.0, opened[0] if a < 0 else 90.0) if opened else (0.0, 90.0)
    return Limits(_sliding(a, c, loading.friction, low, high), opened)


def _sliding(a: Fraction, c: Fraction, friction: float | None, low: float, high: float) -> Range | None:
    """Part of the compressed directions, from low to high, in which the shear force reaches the friction."""
    if friction is None:
        return None
    if friction == 0:
        return low, high
    across = abs(c - a) / Fraction(friction)
    left = across * across - 4 * a * c
    if left <= 0:
        return None
    root = float(across) + math.sqrt(left)
    near = 2 * float(c) / root if c > 0 else None
    far = root / (2 * float(a)) if a > 0 else None
    return (low if near is None else math.degrees(math.atan(near)),
            high if far is None else math.degrees(math.atan(far)))


def by_direction(fabric: AxialFabric, loading: Loading, *, poisson_ratio: float,
                 degrees: Array | None = None) -> ByDirection:
    """Evaluate the contacts over a quarter circle, densely where the shear stiffness falls to zero.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branch lengths about axis 3.
    loading : Loading
        Stress and friction.
    poisson_ratio : float
        Of the grain material [-].
    degrees : (n,) array or None
        Angles from axis 3, 0 to 90 [degrees]; by default those of :func:`angles`.

    Returns
    -------
    ByDirection
        At these angles.

    Notes
    -----
    Accuracy: that of ``granular.contact_distribution``. Source: eqs (20), (21) and (23).
    """
    import numpy as np

    found = limits(fabric.D33, loading)
    degrees = angles(found) if degrees is None else degrees
    cosine = np.sin(np.radians(90.0 - degrees))
    normal = normal_force(fabric, loading, cosine)
    return ByDirection(
        degrees=degrees, normal=normal, shear=shear_force(fabric, loading, cosine),
        limit=None if loading.friction is None else loading.friction * np.maximum(normal, 0.0),
        k_normal=normal_stiffness(fabric, loading, cosine),
        k_shear=shear_stiffness(fabric, loading, cosine, poisson_ratio=poisson_ratio), limits=found)


def angles(found: Limits) -> Array:
    """Angles at which a curve is drawn: evenly over the quarter circle, and closer towards every edge.

    Parameters
    ----------
    found : Limits
        Where contacts slide or have opened.

    Returns
    -------
    (n,) array
        From 0 to 90 [degrees], rising.

    Notes
    -----
    Source: the stiffness ends like a cube root at an edge, which evenly spaced points would cut off.
    """
    import numpy as np

    edges = [edge for pair in (found.sliding, found.opened) if pair for edge in pair]
    close = [edge + side * step for edge in edges for step in (0.0, *NEAR) for side in (-1, 1)]
    every = np.unique(np.concatenate([np.linspace(0.0, 90.0, EVEN), np.array(close, dtype=float)]))
    kept: Array = every[(every >= 0.0) & (every <= 90.0)]
    return kept
