"""Symmetric tensors of rank two and four by their different components: 6 and 15 numbers in a fixed order."""

from __future__ import annotations

import math
from itertools import combinations_with_replacement, product
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

PAIRS = tuple(combinations_with_replacement((0, 1, 2), 2))
QUADRUPLES = tuple(combinations_with_replacement((0, 1, 2), 4))
"""Indices of the different components, the order of the emitted functions: 11, 12, 13, 22, 23, 33; 1111, 1112, ..."""


def _times(index: tuple[int, ...]) -> int:
    return math.factorial(len(index)) // math.prod(math.factorial(index.count(axis)) for axis in (0, 1, 2))


PAIR_TIMES = tuple(float(_times(pair)) for pair in PAIRS)
QUADRUPLE_TIMES = tuple(float(_times(four)) for four in QUADRUPLES)
"""How often each component stands in the full tensor [-]."""

_FIRST_PAIR = tuple(PAIRS.index(four[:2]) for four in QUADRUPLES)
_SECOND_PAIR = tuple(PAIRS.index(four[2:]) for four in QUADRUPLES)
_PLACE_2 = tuple(PAIRS.index((min(i, j), max(i, j))) for i, j in product(range(3), repeat=2))
_PLACE_4 = tuple(QUADRUPLES.index((a, b, c, d))
                 for a, b, c, d in (sorted(index) for index in product(range(3), repeat=4)))


def pair_products(directions: Array) -> Array:
    """Products n_i n_j of each direction.

    Parameters
    ----------
    directions : (..., 3) array
        Unit vectors [-].

    Returns
    -------
    (..., 6) array
        In the order of ``PAIRS`` [-].

    Notes
    -----
    Source: definition.
    """
    first, second = ([pair[k] for pair in PAIRS] for k in (0, 1))
    products: Array = directions[..., first] * directions[..., second]
    return products


def quadruple_products(directions: Array) -> Array:
    """Products n_i n_j n_k n_l of each direction.

    Parameters
    ----------
    directions : (..., 3) array
        Unit vectors [-].

    Returns
    -------
    (..., 15) array
        In the order of ``QUADRUPLES`` [-].

    Notes
    -----
    Source: definition.
    """
    pairs = pair_products(directions)
    products: Array = pairs[..., _FIRST_PAIR] * pairs[..., _SECOND_PAIR]
    return products


def full_2(components: Array) -> Array:
    """Full tensor of rank two of its different components.

    Parameters
    ----------
    components : (..., 6) array
        In the order of ``PAIRS`` [any unit].

    Returns
    -------
    (..., 3, 3) array
        Symmetric [same unit].

    Notes
    -----
    Source: definition.
    """
    tensor: Array = components[..., _PLACE_2].reshape(*components.shape[:-1], 3, 3)
    return tensor


def full_4(components: Array) -> Array:
    """Full tensor of rank four of its different components.

    Parameters
    ----------
    components : (..., 15) array
        In the order of ``QUADRUPLES`` [any unit].

    Returns
    -------
    (..., 3, 3, 3, 3) array
        Symmetric in all indices [same unit].

    Notes
    -----
    Source: definition.
    """
    tensor: Array = components[..., _PLACE_4].reshape(*components.shape[:-1], 3, 3, 3, 3)
    return tensor


def different_4(tensor: Array) -> Array:
    """Different components of a symmetric tensor of rank four.

    Parameters
    ----------
    tensor : (..., 3, 3, 3, 3) array
        Symmetric in all indices [any unit].

    Returns
    -------
    (..., 15) array
        In the order of ``QUADRUPLES`` [same unit].

    Notes
    -----
    Source: definition.
    """
    a, b, c, d = ([four[k] for four in QUADRUPLES] for k in range(4))
    components: Array = tensor[..., a, b, c, d]
    return components


def third_kind(moments: Array) -> tuple[Array, Array]:
    """Components of D_ij and D_ijkl of moments of rank four.

    Parameters
    ----------
    moments : (..., 15) array
        N_ijkl [-].

    Returns
    -------
    D2 : (..., 6) array
        In the order of ``PAIRS`` [-].
    D4 : (..., 15) array
        In the order of ``QUADRUPLES`` [-].

    Notes
    -----
    Accuracy: a few units in the last place of 315/8 times a moment.
    Source: the emitted functions of the derivation ``fabric_kinds``.
    """
    import numpy as np

    from granular.generated.fabric_kinds_array import third_kind as emitted

    parts = np.stack(emitted(*np.moveaxis(moments, -1, 0)), axis=-1)
    return parts[..., :6], parts[..., 6:]


def second_kind(moments: Array) -> tuple[Array, Array]:
    """Components of F_ij and F_ijkl of moments of rank four.

    Parameters
    ----------
    moments : (..., 15) array
        N_ijkl [-].

    Returns
    -------
    F2 : (..., 6) array
        In the order of ``PAIRS`` [-].
    F4 : (..., 15) array
        In the order of ``QUADRUPLES`` [-].

    Notes
    -----
    Accuracy: a few units in the last place of 315/8 times a moment.
    Source: the emitted functions of the derivation ``fabric_kinds``.
    """
    import numpy as np

    from granular.generated.fabric_kinds_array import second_kind as emitted

    parts = np.stack(emitted(*np.moveaxis(moments, -1, 0)), axis=-1)
    return parts[..., :6], parts[..., 6:]


def lower_rank(moments: Array) -> Array:
    """N_ij of N_ijkl, by contraction.

    Parameters
    ----------
    moments : (..., 15) array
        N_ijkl [-].

    Returns
    -------
    (..., 6) array
        N_ij in the order of ``PAIRS`` [-].

    Notes
    -----
    Accuracy: to rounding. Source: n_k n_k = 1.
    """
    import numpy as np

    columns = [[QUADRUPLES.index((a, b, c, d)) for a, b, c, d in (sorted((*pair, k, k)) for k in range(3))]
               for pair in PAIRS]
    lower: Array = np.sum(moments[..., columns], axis=-1)
    return lower


def moments_of(D2: Array, D4: Array) -> Array:
    """N_ijkl of D_ij and D_ijkl: the way back.

    Parameters
    ----------
    D2 : (..., 6) array
        Traceless, in the order of ``PAIRS`` [-].
    D4 : (..., 15) array
        Traceless, in the order of ``QUADRUPLES`` [-].

    Returns
    -------
    (..., 15) array
        N_ijkl of the density 1 + D_ij n_i n_j + D_ijkl n_i n_j n_k n_l [-].

    Notes
    -----
    Accuracy: to rounding. Source: the emitted functions of the derivation ``fabric_kinds``.
    """
    import numpy as np

    from granular.generated.fabric_kinds_array import first_kind as emitted

    without_33 = np.moveaxis(D2, -1, 0)[:5]
    return np.stack(emitted(*without_33, *np.moveaxis(D4, -1, 0)), axis=-1)


def rotation_matrix(rotation: Array) -> Array:
    """Matrix that turns the 15 components of a symmetric tensor of rank four.

    Parameters
    ----------
    rotation : (3, 3) array
        Row i is the new axis i in the old ones [-].

    Returns
    -------
    (15, 15) array
        New components = matrix @ old components [-].

    Notes
    -----
    Accuracy: to rounding. Source: the law of transformation.
    """
    import numpy as np

    full = full_4(np.eye(15))  # one full tensor for each component
    turned = np.einsum("ai,bj,ck,dl,mijkl->mabcd", *[rotation] * 4, full, optimize=True)
    return np.ascontiguousarray(different_4(turned).T)
