"""Directions counted in bins: by their angle from an axis, and by their azimuth about it, with the fitted density."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from granular.fabric_tensors.axial_fit import along
from granular.fabric_tensors.density import homogeneous, values
from granular.fabric_tensors.frames import frame_about
from granular.fabric_tensors.reading import read_axis, read_directions, read_weights

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from granular.fabric_tensors.tensors import FabricTensors

    Array = NDArray[np.float64]

NODES = 6
"""Gauss nodes from pole to pole; terms odd in the cosine average to zero and the others are of degree four."""


@dataclass(frozen=True, slots=True, eq=False)
class Bins:
    """Density of directions in bins.

    Attributes
    ----------
    edges : (bins + 1,) array
        Of the angle [rad].
    density : (bins,) array
        Over that of an isotropic fabric [-].
    error : (bins,) array
        Standard error of it, for independent directions [-].
    """

    edges: Array
    density: Array
    error: Array


def by_angle(directions: ArrayLike, weights: ArrayLike | None = None, *, axis: ArrayLike = (0.0, 0.0, 1.0),
             bins: int = 9) -> Bins:
    """Density of directions by their angle from an axis.

    Parameters
    ----------
    directions : (n, 3) array
        Unit vectors [-].
    weights : (n,) array, optional
        Not negative [any unit].
    axis : (3,) array
        The axis [-].
    bins : int
        Number of equal angles from 0 to 90 degrees [-].

    Returns
    -------
    Bins
        Edges from 0 to pi/2; the bin at the axis holds few directions and has the largest error.

    Raises
    ------
    ArrayNotUsable, NotFinite, DirectionNotUnit, ValueOutOfRange
        As for ``fabric_of``; no axis.

    Notes
    -----
    Accuracy: counts. Source: an isotropic fabric has the share cos(a) - cos(b) between the angles a and b.

    Examples
    --------
    >>> by_angle([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0]], bins=2).density.round(3).tolist()
    [1.707, 0.707]
    """
    import numpy as np

    unit, about = read_directions(directions), read_axis(axis)
    edges = np.linspace(0.0, np.pi / 2, bins + 1)
    angle = np.arccos(np.minimum(np.abs(unit @ about), 1.0))
    return _binned(angle, read_weights(weights, len(unit)), edges, -np.diff(np.cos(edges)))


def by_azimuth(directions: ArrayLike, weights: ArrayLike | None = None, *, axis: ArrayLike = (0.0, 0.0, 1.0),
               bins: int = 12) -> Bins:
    """Density of directions by their azimuth about an axis.

    Parameters
    ----------
    directions : (n, 3) array
        Unit vectors [-].
    weights : (n,) array, optional
        Not negative [any unit].
    axis : (3,) array
        The axis [-].
    bins : int
        Number of equal angles in half a turn [-].

    Returns
    -------
    Bins
        Edges from 0 to pi, counted from the first axis of ``frames.frame_about``; from axis 1 about axis 3.

    Raises
    ------
    ArrayNotUsable, NotFinite, DirectionNotUnit, ValueOutOfRange
        As for ``fabric_of``; no axis.

    Notes
    -----
    Accuracy: counts. Source: an isotropic fabric has the same share in equal azimuths; n and -n are half a turn apart.

    Examples
    --------
    >>> by_azimuth([[0.8, 0.6, 0.0], [-0.8, -0.6, 0.0], [-0.8, 0.6, 0.0], [0.6, 0.0, 0.8]], bins=2).density.tolist()
    [1.5, 0.5]
    """
    import numpy as np

    unit, frame = read_directions(directions), frame_about(read_axis(axis))
    edges = np.linspace(0.0, np.pi, bins + 1)
    azimuth = np.mod(np.arctan2(unit @ frame[1], unit @ frame[0]), np.pi)
    return _binned(azimuth, read_weights(weights, len(unit)), edges, np.diff(edges) / np.pi)


def mean_by_azimuth(tensors: FabricTensors, azimuth: Array, *, axis: ArrayLike = (0.0, 0.0, 1.0),
                    rank: int = 4) -> Array:
    """Implied density averaged from pole to equator at each azimuth.

    Parameters
    ----------
    tensors : FabricTensors
        Of a list of directions.
    azimuth : (n,) array
        Counted as in :func:`by_azimuth` [rad].
    axis : (3,) array
        The axis [-].
    rank : 0, 2 or 4
        Highest rank that is taken.

    Returns
    -------
    (n,) array
        4 pi E, averaged over the cosine of the angle from the axis [-].

    Raises
    ------
    UnknownChoice
        Another rank.
    ArrayNotUsable, NotFinite, DirectionNotUnit
        No axis.

    Notes
    -----
    Accuracy: to rounding: what is even in the cosine is a polynomial of degree four in it, and the rest cancels.
    Source: Gauss-Legendre quadrature.
    """
    import numpy as np

    nodes, shares = np.polynomial.legendre.leggauss(NODES)
    frame = frame_about(read_axis(axis))
    across = np.sqrt(1 - nodes**2)[None, :, None]
    turn = np.stack([np.cos(azimuth), np.sin(azimuth), 0 * azimuth], axis=1) @ frame
    directions = across * turn[:, None, :] + nodes[None, :, None] * frame[2]
    heights = values(homogeneous(tensors, rank), directions.reshape(-1, 3)).reshape(len(azimuth), NODES)
    mean: Array = heights @ shares / 2
    return mean


def mean_by_angle(tensors: FabricTensors, cosine: Array, *, axis: ArrayLike = (0.0, 0.0, 1.0),
                  rank: int = 4) -> Array:
    """Implied density averaged around an axis at each angle from it.

    Parameters
    ----------
    tensors : FabricTensors
        Of a list of directions.
    cosine : (n,) array
        Of the angle [-].
    axis : (3,) array
        The axis [-].
    rank : 0, 2 or 4
        Highest rank that is taken.

    Returns
    -------
    (n,) array
        4 pi E, averaged over the azimuth [-].

    Raises
    ------
    ArrayNotUsable, NotFinite, DirectionNotUnit
        No axis.

    Notes
    -----
    Accuracy: to rounding. Source: 1 + D33 P2 + D3333 P4 about the axis.
    """
    D33, D3333 = (float(part) for part in along(tensors.D2, tensors.D4, read_axis(axis)))
    square = cosine**2
    density: Array = (1 + (rank >= 2) * D33 * (3 * square - 1) / 2
                      + (rank >= 4) * D3333 * ((35 * square - 30) * square + 3) / 8)
    return density


def _binned(angle: Array, weight: Array, edges: Array, expected: Array) -> Bins:
    import numpy as np

    counted, _ = np.histogram(angle, edges, weights=weight)
    squares, _ = np.histogram(angle, edges, weights=weight**2)
    share, scatter = counted / weight.sum(), squares / weight.sum() ** 2
    rest = scatter * (1 - 2 * share) + share**2 * float(weight @ weight) / weight.sum() ** 2
    return Bins(edges, share / expected, np.sqrt(np.maximum(rest, 0.0)) / expected)
