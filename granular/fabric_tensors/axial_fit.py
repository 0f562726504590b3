"""The axially symmetric fabric that is nearest to fabric tensors, and how much of the anisotropy it leaves out."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from granular.errors import FabricOutOfRange, UnknownChoice
from granular.fabric import AxialFabric
from granular.fabric_tensors.reading import read_axis

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from granular.fabric_tensors.tensors import FabricTensors

    Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class AxialFit:
    """An axial fabric with its axis and what it misses.

    Attributes
    ----------
    fabric : AxialFabric
        Contact normals about the axis, which is axis 3 of the fabric.
    axis : (3,) array
        Unit vector in the axes of the directions [-].
    misfit : float
        Share of the mean square of 4 pi E - 1, up to the fitted rank, that is not axial about the axis, 0 to 1 [-].
    residual : float
        Root mean square of that part [-].
    """

    fabric: AxialFabric
    axis: Array
    misfit: float
    residual: float


def symmetry_axis(tensors: FabricTensors) -> Array:
    """Axis about which the part of rank two is most nearly axial.

    Parameters
    ----------
    tensors : FabricTensors
        Of a list of directions.

    Returns
    -------
    (3,) array
        Unit vector [-], its largest component positive.

    Notes
    -----
    Accuracy: to rounding over the distance of the principal values. Source: D_ij a_i a_j is largest in amount for the
    principal value farthest from zero, which is also the one farthest from the middle one.

    Examples
    --------
    >>> from granular.fabric_tensors import fabric_of
    >>> symmetry_axis(fabric_of([[0.0, 1.0, 0.0]])).tolist()
    [0.0, 1.0, 0.0]
    """
    axis: Array = axes_of(tensors.D2)
    return axis


def axes_of(D2: Array) -> Array:
    """Axis of each of many tensors of rank two.

    Parameters
    ----------
    D2 : (..., 3, 3) array
        Symmetric and traceless [-].

    Returns
    -------
    (..., 3) array
        Unit vectors [-], their largest component positive.

    Notes
    -----
    Accuracy: to rounding over the distance of the principal values. Source: :func:`symmetry_axis`.
    """
    import numpy as np

    values, vectors = np.linalg.eigh(D2)
    farthest = np.argmax(np.abs(values), axis=-1)
    axis = np.take_along_axis(vectors, farthest[..., None, None], axis=-1)[..., 0]
    largest = np.take_along_axis(axis, np.argmax(np.abs(axis), axis=-1)[..., None], axis=-1)
    signed: Array = axis * np.sign(largest)
    return signed


def along(D2: Array, D4: Array, axis: Array) -> tuple[Array, Array]:
    """D33 and D3333 about an axis.

    Parameters
    ----------
    D2 : (..., 3, 3) array
        Third kind of rank two [-].
    D4 : (..., 3, 3, 3, 3) array
        Third kind of rank four [-].
    axis : (..., 3) array
        Unit vectors [-].

    Returns
    -------
    D33, D3333 : (...) array
        Coefficients of P2 and P4 of the mean density around the axis [-].

    Notes
    -----
    Accuracy: to rounding. Source: the addition theorem of Legendre polynomials.
    """
    import numpy as np

    second = np.einsum("...ij,...i,...j->...", D2, axis, axis)
    fourth = np.einsum("...ijkl,...i,...j,...k,...l->...", D4, axis, axis, axis, axis)
    return second, fourth


def axial_fabric(tensors: FabricTensors, axis: ArrayLike | None = (0.0, 0.0, 1.0), *, rank: int = 4) -> AxialFit:
    """Axially symmetric fabric nearest to fabric tensors in the mean square.

    Parameters
    ----------
    tensors : FabricTensors
        Of a list of directions.
    axis : (3,) array or None
        The axis [-], axis 3 unless another is given; None fits it.
    rank : 2 or 4
        Highest rank that is kept.

    Returns
    -------
    AxialFit
        Fabric, axis and misfit.

    Raises
    ------
    FabricOutOfRange
        The axial density would be negative somewhere.
    ArrayNotUsable, NotFinite, DirectionNotUnit
        No axis.
    UnknownChoice
        Another rank.

    Notes
    -----
    Accuracy: to rounding. Source: the mean of the density around the axis, and ``derivations.fabric_kinds`` for mean
    squares.

    Examples
    --------
    >>> from granular.fabric_tensors.sampling import axial_tensors
    >>> fit = axial_fabric(axial_tensors(0.3, 0.1, axis=[1.0, 0.0, 0.0]), axis=None)
    >>> round(fit.fabric.D33, 12), round(fit.fabric.D3333, 12), round(fit.misfit, 12), fit.axis.round(12).tolist()
    (0.3, 0.1, 0.0, [1.0, 0.0, 0.0])
    """
    import numpy as np

    if rank not in (2, 4):
        raise UnknownChoice(f"rank = {rank!r}", allowed="allowed 2, 4", remedy="Give one of these ranks.")
    about = symmetry_axis(tensors) if axis is None else read_axis(axis)
    D33, D3333 = (float(part) for part in along(tensors.D2, tensors.D4, about))
    whole = 2 / 15 * float(np.sum(tensors.D2**2))
    axial = D33**2 / 5
    if rank == 4:
        whole += 8 / 315 * float(np.sum(tensors.D4**2))
        axial += D3333**2 / 9
    left = max(whole - axial, 0.0)
    try:
        fabric = AxialFabric(D33=D33, D3333=D3333 if rank == 4 else 0.0)
    except FabricOutOfRange as refusal:
        raise FabricOutOfRange(
            refusal.found, allowed=refusal.allowed,
            remedy=f"No density of rank {'four' if rank == 4 else 'two'} has these directions: they are too few, or "
            f"aligned too strongly.{' Rank two has: give rank=2.' if rank == 4 and -1 <= D33 <= 2 else ''}") from None
    return AxialFit(fabric, about, left / whole if whole > 0 else 0.0, float(np.sqrt(left)))
