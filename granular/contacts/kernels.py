"""Sums over contacts into tensors: the stiffness of eq. (1), the compliance of eq. (5), with and without symmetry.

Both are sums of products of two vectors with a contact tensor that has two values, so that 36 + 6 numbers hold every
component: eq. (1) has the branch products l_i l_k, eq. (5) the normal products n_k n_m over l^2, which the fabric then
turns into forces. Neither needs to know the fabric before the list has been read.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from granular.contacts.compiled import compiled_sums

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

BLOCK = 4096
"""Contacts whose products are in cache at a time."""

COMPILE_FROM = 1 << 20
"""Contacts from which a compiled sum is worth its start."""

_FIRST, _SECOND = (0, 1, 2, 1, 0, 0), (0, 1, 2, 2, 2, 1)
_TO_MANDEL = (1.0, 1.0, 1.0, math.sqrt(0.5), math.sqrt(0.5), math.sqrt(0.5))
_PLACE = ((0, 5, 4), (5, 1, 3), (4, 3, 2))


def products(vectors: Array) -> Array:
    """The six different products of a vector with itself.

    Parameters
    ----------
    vectors : (3, n) array
        One a column [any unit].

    Returns
    -------
    (6, n) array
        11 22 33 23 13 12 [its square].

    Notes
    -----
    Source: symmetry.
    """
    import numpy as np

    found: Array = np.empty((6, vectors.shape[1]))
    for row, (i, k) in enumerate(zip(_FIRST, _SECOND, strict=True)):
        np.multiply(vectors[i], vectors[k], out=found[row])
    return found


def symmetric(six: Array) -> Array:
    """Write six numbers as a symmetric matrix.

    Parameters
    ----------
    six : (6,) array
        11 22 33 23 13 12 [any unit].

    Returns
    -------
    (3, 3) array
        The matrix [same unit].

    Notes
    -----
    Source: symmetry.
    """
    import numpy as np

    found: Array = np.asarray(six)[np.array(_PLACE)]
    return found


class PairSums:
    """Sums of a_ik c_jl over contacts, with c = apart n n + shear I.

    Attributes
    ----------
    apart : (6, 6) array
        Sum of apart a_ik n_j n_l, pairs in the order 11 22 33 23 13 12.
    shear : (6,) array
        Sum of shear a_ik.
    """

    def __init__(self) -> None:
        """Begin at zero."""
        import numpy as np

        self.apart, self.shear = np.zeros((6, 6)), np.zeros(6)

    def add(self, vectors: Array, normal: Array, apart: Array, shear: Array) -> None:
        """Add some contacts.

        Parameters
        ----------
        vectors : (3, n) array
            What a_ik is the product of [any unit].
        normal : (3, n) array
            Unit vectors [-].
        apart, shear : (n,) array
            What a contact has along its normal beyond the rest, and in all directions [any one unit].

        Notes
        -----
        Accuracy: about 1e-15 of the sum of magnitudes. Source: eqs (1) and (2).
        """
        for start in range(0, apart.size, BLOCK):
            here = slice(start, start + BLOCK)
            both = products(vectors[:, here])
            self.apart += (both * apart[here]) @ products(normal[:, here]).T
            self.shear += both @ shear[here]

    def tensor(self) -> Array:
        """All components, without any symmetrisation.

        Returns
        -------
        (3, 3, 3, 3) array
            T_ijkl = sum a_ik c_jl.

        Notes
        -----
        Source: eq. (1).
        """
        import numpy as np

        place = np.array(_PLACE)
        found: Array = (self.apart[place[:, None, :, None], place[None, :, None, :]]
                        + symmetric(self.shear)[:, None, :, None] * np.eye(3)[None, :, None, :])
        return found


def stiffness_sum(branch: Array, normal: Array, kn: Array, ks: Array, *, compiled: bool | None = None) -> Array:
    """Sum l_i k_jl l_k over contacts that are in memory, minor-symmetrised.

    Parameters
    ----------
    branch : (3, n) array
        l [m].
    normal : (3, n) array
        n [-].
    kn, ks : (n,) array
        Normal and shear stiffness [N/m].
    compiled : bool, optional
        Whether the loop is compiled; by default where numba is installed and there are 2^20 contacts or more.

    Returns
    -------
    (6, 6) array
        V C in Mandel notation, order 11 22 33 23 13 12 [N m].

    Notes
    -----
    Accuracy: about 1e-14 of the largest component; both ways agree to 1e-13. Memory beside the arrays: some hundred
    kilobytes. Source: eqs (1) and (2).

    Examples
    --------
    >>> import numpy as np
    >>> stiffness_sum(2 * np.eye(3), np.eye(3), np.ones(3), np.zeros(3))[2, 2].item()
    4.0
    """
    import numpy as np

    from granular.routes.direction_sums import mandel_matrix, symmetrised

    loop = compiled_sums() if (kn.size >= COMPILE_FROM if compiled is None else compiled) else None
    if loop is None:
        sums = PairSums()
        for start in range(0, kn.size, BLOCK):
            here = slice(start, start + BLOCK)
            sums.add(branch[:, here], normal[:, here], kn[here] - ks[here], ks[here])
        return mandel_matrix(symmetrised(sums.tensor()))
    total = np.zeros(27)
    loop(*branch, *normal, kn, ks, total)
    matrix = np.zeros((6, 6))
    matrix[np.triu_indices(6)] = total[:21]
    matrix += np.triu(matrix, 1).T
    matrix *= np.outer(_TO_MANDEL, _TO_MANDEL)
    rest = PairSums()
    rest.shear += total[21:]
    return matrix + mandel_matrix(symmetrised(rest.tensor()))
