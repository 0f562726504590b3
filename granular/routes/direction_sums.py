"""Sums over directions into tensors: contacts, fourth-rank sums, symmetry, spin, and the Mandel matrix."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from granular.routes.result import Six

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]


def contact_tensor(n: Array, along: Array, isotropic: Array) -> Array:
    """Evaluate along n_j n_l + isotropic delta_jl in every direction.

    Parameters
    ----------
    n : (3, q) array
        Unit vectors [-].
    along, isotropic : (q,) array
        What each contact has along its normal beyond the rest, and in all directions [any one unit].

    Returns
    -------
    (3, 3, q) array
        Contact tensors [same unit].

    Source
    ------
    Eq. (2) with k_s = k_t.
    """
    import numpy as np

    tensor: Array = along * n[:, None] * n[None, :] + isotropic * np.eye(3)[:, :, None]
    return tensor


def fourth_rank(products: Array, contact: Array) -> Array:
    """Sum a_ik c_jl over the directions into T_ijkl.

    Parameters
    ----------
    products : (3, 3, q) array
        a_ik in every direction, weighted: products of two vectors, such as l_i l_k [-].
    contact : (3, 3, q) array
        c_jl in every direction [any one unit].

    Returns
    -------
    (3, 3, 3, 3) array
        The sum [same unit], without any symmetrisation.

    Source
    ------
    Eq. (1).
    """
    raw: Array = (products.reshape(9, -1) @ contact.reshape(9, -1).T).reshape(3, 3, 3, 3).transpose(0, 2, 1, 3)
    return raw


def axially_clean(tensor: Array) -> Array:
    """Drop what rounding makes of components with an index an odd number of times.

    Mirrors through the three coordinate planes leave an axial fabric as it is, so that such components vanish.

    Parameters
    ----------
    tensor : (3, 3, 3, 3) array
        A sum over the directions of an axial fabric [any one unit].

    Returns
    -------
    (3, 3, 3, 3) array
        The same without them [same unit].
    """
    import numpy as np

    index = np.indices((3, 3, 3, 3))
    even = np.all([(index == axis).sum(axis=0) % 2 == 0 for axis in range(3)], axis=0)
    clean: Array = np.where(even, tensor, 0.0)
    return clean


def symmetrised(tensor: Array) -> Array:
    """Symmetrise a fourth-rank tensor in its first and in its last two indices.

    Parameters
    ----------
    tensor : (3, 3, 3, 3) array
        Sum l_i k_jl l_k over the contacts [any one unit].

    Returns
    -------
    (3, 3, 3, 3) array
        What a strain meets whose grains turn with it [same unit].

    Source
    ------
    Eq. (1) with a symmetric strain.
    """
    half = (tensor + tensor.transpose(1, 0, 2, 3)) / 2
    symmetric: Array = (half + half.transpose(0, 1, 3, 2)) / 2
    return symmetric


def spin_relaxed(tensor: Array) -> Array:
    """Let every grain spin until it carries no net couple.

    The three antisymmetric parts of the displacement gradient are free, and the energy is least over them.

    Parameters
    ----------
    tensor : (3, 3, 3, 3) array
        Sum l_i k_jl l_k over the contacts [any one unit]; not symmetrised.

    Returns
    -------
    (3, 3, 3, 3) array
        What a strain then meets, symmetrised [same unit].

    Source
    ------
    Energy of eq. (1) for a displacement gradient, minimised over its antisymmetric part.
    """
    import numpy as np

    spins = np.zeros((3, 3, 3))
    for axis, (i, j) in enumerate(((1, 2), (2, 0), (0, 1))):
        spins[axis, i, j], spins[axis, j, i] = 1, -1
    couple = np.einsum("aij,ijkl->akl", spins, tensor)
    resistance = np.einsum("akl,bkl->ab", couple, spins)
    relaxed: Array = tensor - np.einsum("aij,ab,bkl->ijkl", couple, np.linalg.inv(resistance), couple)
    return symmetrised(relaxed)


def mandel_matrix(tensor: Array) -> Array:
    """Write the Mandel matrix of a symmetrised fourth-rank tensor, order 11, 22, 33, 23, 13, 12.

    Parameters
    ----------
    tensor : (3, 3, 3, 3) array
        Of a tensor [any one unit].

    Returns
    -------
    (6, 6) array
        The matrix [same unit].
    """
    import numpy as np

    first, second = np.array([0, 1, 2, 1, 0, 0]), np.array([0, 1, 2, 2, 2, 1])
    scale = np.array([1.0, 1.0, 1.0] + 3 * [math.sqrt(2)])
    matrix: Array = tensor[first[:, None], second[:, None], first[None, :], second[None, :]]
    return matrix * np.outer(scale, scale)


def axial_components(mandel: Array) -> Six:
    """Read the six components of a transversely isotropic tensor from its Mandel matrix.

    Parameters
    ----------
    mandel : (6, 6) array
        Of a tensor [any one unit].

    Returns
    -------
    tuple of 6 float
        C1111, C3333, C1122, C1133, C2323, C1212 [same unit].
    """
    return (float(mandel[0, 0]), float(mandel[2, 2]), float(mandel[0, 1]), float(mandel[0, 2]),
            float(mandel[3, 3] / 2), float(mandel[5, 5] / 2))
