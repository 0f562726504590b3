"""The density that fabric tensors imply: its value in a direction, and where it is least."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING

from granular.errors import UnknownChoice
from granular.fabric_tensors.components import QUADRUPLE_TIMES, different_4, quadruple_products
from granular.fabric_tensors.reading import read_directions

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from granular.fabric_tensors.tensors import FabricTensors

    Array = NDArray[np.float64]

RANKS = (0, 2, 4)
"""Ranks up to which a density is taken."""

GRID = 2000
"""Directions over half the sphere, 3 degrees apart, from which the search for the least value starts."""

STARTS, STEPS = 24, 40
"""Lowest of them that are followed, and Newton steps at most; about six are taken."""


@dataclass(frozen=True, slots=True, eq=False)
class LeastDensity:
    """The least value of a density over all directions.

    Attributes
    ----------
    value : float
        4 pi E [-]; below 0 no contacts can have this density.
    direction : (3,) array
        Where it is [-]; one of them where several are as low.
    """

    value: float
    direction: Array

    @property
    def words(self) -> str:
        """One sentence for the reader."""
        where = ", ".join(f"{part:.3f}" for part in self.direction)
        if self.value < 0:
            return f"the density would be negative, 4 pi E = {self.value:.4g} along ({where})"
        return f"the density is nowhere below 4 pi E = {self.value:.4g}, which it has along ({where})"


def density(tensors: FabricTensors, directions: ArrayLike, *, rank: int = 4, normalise: bool = False) -> Array:
    """Density of contact normals over that of an isotropic packing, 4 pi E, as the tensors imply it.

    Parameters
    ----------
    tensors : FabricTensors
        Of any list of directions.
    directions : (n, 3) array
        Unit vectors [-].
    rank : 0, 2 or 4
        Highest rank that is taken.
    normalise : bool
        Whether lengths may be other than 1.

    Returns
    -------
    (n,) array
        4 pi E [-]; negative where the tensors of this rank are those of no density.

    Raises
    ------
    UnknownChoice
        Another rank.
    ArrayNotUsable, NotFinite, DirectionNotUnit
        As for :func:`granular.fabric_tensors.fabric_of`.

    Notes
    -----
    Accuracy: a few units in the last place of the largest component.
    Source: F_ijkl n_i n_j n_k n_l, the second kind.

    Examples
    --------
    >>> from granular.fabric_tensors import fabric_of
    >>> density(fabric_of([[0.0, 0.0, 1.0]]), [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0]], rank=2).tolist()
    [6.0, -1.5]
    """
    return values(homogeneous(tensors, rank), read_directions(directions, normalise=normalise))


def values(form: Array, unit: Array) -> Array:
    """Values of a homogeneous form of rank four.

    Parameters
    ----------
    form : (..., 15) array
        Different components of its tensor [any unit].
    unit : (n, 3) array
        Unit vectors [-].

    Returns
    -------
    (..., n) array
        Values [same unit].

    Notes
    -----
    Accuracy: to rounding. Source: definition.
    """
    import numpy as np

    result: Array = (form * np.array(QUADRUPLE_TIMES)) @ quadruple_products(unit).T
    return result


def homogeneous(tensors: FabricTensors, rank: int) -> Array:
    """Second kind of rank four of the density cut off at a rank.

    Parameters
    ----------
    tensors : FabricTensors
        Of any list of directions.
    rank : 0, 2 or 4
        Highest rank that is taken.

    Returns
    -------
    (15,) array
        Different components [-].

    Raises
    ------
    UnknownChoice
        Another rank.

    Notes
    -----
    Accuracy: to rounding. Source: the sum of the third kind, made homogeneous with n_k n_k = 1.
    """
    import numpy as np

    if rank not in RANKS:
        raise UnknownChoice(f"rank = {rank!r}", allowed=f"allowed {', '.join(map(str, RANKS))}",
                            remedy="Give one of these ranks.")
    if rank == 4:
        return different_4(tensors.F4)
    lower = np.eye(3) + (tensors.D2 if rank == 2 else 0.0)
    orders = ("ij,kl->ijkl", "ik,jl->ijkl", "il,jk->ijkl")
    product = sum(np.einsum(order, a, b) for order in orders for a, b in ((np.eye(3), lower), (lower, np.eye(3)))) / 6
    return different_4(np.asarray(product))


def least_density(tensors: FabricTensors, *, rank: int = 4) -> LeastDensity:
    """Least value of the implied density over the sphere, and where it is.

    Parameters
    ----------
    tensors : FabricTensors
        Of any list of directions.
    rank : 0, 2 or 4
        Highest rank that is taken.

    Returns
    -------
    LeastDensity
        Value and direction.

    Raises
    ------
    UnknownChoice
        Another rank.

    Notes
    -----
    Accuracy: value to rounding; the basin of a minimum of a form of rank four is wider than the 3 degrees between the
    directions from which Newton's method starts. Source: stationary points on the sphere.

    Examples
    --------
    >>> from granular.fabric_tensors import fabric_of
    >>> round(least_density(fabric_of([[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]]), rank=2).value, 12)
    -1.5
    """
    import numpy as np

    form = homogeneous(tensors, rank)
    start = half_sphere(GRID)
    points = start[np.argsort(values(form, start))[:STARTS]]
    for _ in range(STEPS):
        moved = _newton(form, points)
        better = values(form, moved) < values(form, points)
        if not better.any():
            break
        points = np.where(better[:, None], moved, points)
    heights = values(form, points)
    lowest = int(np.argmin(heights))
    direction = points[lowest]
    sign = np.sign(direction[np.argmax(np.abs(direction))])
    return LeastDensity(float(heights[lowest]), sign * direction)


@lru_cache(maxsize=4)
def half_sphere(count: int) -> Array:
    """Directions spread evenly over the upper half of the sphere.

    Parameters
    ----------
    count : int
        How many [-].

    Returns
    -------
    (count, 3) array
        Unit vectors [-].

    Notes
    -----
    Source: the spiral of the golden angle.
    """
    import numpy as np

    height = (np.arange(count) + 0.5) / count
    around = np.pi * (3 - np.sqrt(5)) * np.arange(count)
    across = np.sqrt(1 - height**2)
    points = np.stack([across * np.cos(around), across * np.sin(around), height], axis=1)
    points.setflags(write=False)
    return points


def _newton(form: Array, points: Array) -> Array:
    """One step towards a minimum on the sphere; along flat or falling directions a step down the slope."""
    import numpy as np

    from granular.fabric_tensors.components import full_4

    tensor = full_4(form)
    second = 12 * np.einsum("ijkl,mk,ml->mij", tensor, points, points, optimize=True)
    slope = np.einsum("mij,mj->mi", second, points) / 3
    outward = np.einsum("mi,mi->m", slope, points)
    tangent = np.eye(3) - points[:, :, None] * points[:, None, :]
    along = np.einsum("mij,mj->mi", tangent, slope)
    curvature, frame = np.linalg.eigh(tangent @ second @ tangent - outward[:, None, None] * tangent)
    scale = max(float(np.abs(tensor).max()), 1e-300)
    step = np.einsum("mji,mj->mi", frame, along) / np.maximum(np.abs(curvature), 1e-3 * scale)
    moved = points - np.einsum("mij,mj->mi", frame, step)
    result: Array = moved / np.linalg.norm(moved, axis=1, keepdims=True)
    return result
