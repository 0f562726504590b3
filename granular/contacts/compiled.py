"""The sum of eq. (1) as one loop over contacts, compiled where numba is installed: it reads each array once.

The loop is plain Python that also runs uncompiled, which a test does; nothing but speed depends on numba.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import TYPE_CHECKING

from granular.generated.rows import aligned_frame

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

BLOCK = 32768
"""Contacts that are summed before the result joins the total, so that rounding does not grow with their number."""


def stiffness_sums(l1: Array, l2: Array, l3: Array, n1: Array, n2: Array, n3: Array, kn: Array, ks: Array,
                   total: Array) -> None:
    """Add the 27 sums of the minor-symmetrised eq. (1) to a total.

    Parameters
    ----------
    l1, l2, l3, n1, n2, n3, kn, ks : (n,) array
        Branch [m], normal [-], stiffnesses [N/m].
    total : (27,) array
        The upper triangle of sum (kn - ks) v_p v_q, row by row, with v = (l1 n1, l2 n2, l3 n3, l2 n3 + l3 n2, l1 n3 +
        l3 n1, l1 n2 + l2 n1); then sum ks l_i l_k for 11 22 33 23 13 12 [N m]. Changed in place.

    Notes
    -----
    Accuracy: about 1e-15 of the sum of magnitudes. Source: eqs (1) and (2).
    """
    aligned_frame()  # there are more sums than registers: they stand on the stack
    size = kn.size
    for start in range(0, size, BLOCK):
        s0 = s1 = s2 = s3 = s4 = s5 = s6 = s7 = s8 = s9 = s10 = s11 = s12 = s13 = 0.0
        s14 = s15 = s16 = s17 = s18 = s19 = s20 = s21 = s22 = s23 = s24 = s25 = s26 = 0.0
        end = start + BLOCK
        x, y, z = l1[start:end], l2[start:end], l3[start:end]  # slices, so that no index can be negative: it is faster
        u, v, w = n1[start:end], n2[start:end], n3[start:end]
        along, across = kn[start:end], ks[start:end]
        for c in range(along.size):
            a, b, d, p, q, r, shear = x[c], y[c], z[c], u[c], v[c], w[c], across[c]
            apart = along[c] - shear
            v1, v2, v3 = a * p, b * q, d * r
            v4, v5, v6 = b * r + d * q, a * r + d * p, a * q + b * p
            w1, w2, w3, w4, w5 = apart * v1, apart * v2, apart * v3, apart * v4, apart * v5
            s0 += w1 * v1
            s1 += w1 * v2
            s2 += w1 * v3
            s3 += w1 * v4
            s4 += w1 * v5
            s5 += w1 * v6
            s6 += w2 * v2
            s7 += w2 * v3
            s8 += w2 * v4
            s9 += w2 * v5
            s10 += w2 * v6
            s11 += w3 * v3
            s12 += w3 * v4
            s13 += w3 * v5
            s14 += w3 * v6
            s15 += w4 * v4
            s16 += w4 * v5
            s17 += w4 * v6
            s18 += w5 * v5
            s19 += w5 * v6
            s20 += apart * v6 * v6
            x1, x2, x3 = shear * a, shear * b, shear * d
            s21 += x1 * a
            s22 += x2 * b
            s23 += x3 * d
            s24 += x2 * d
            s25 += x1 * d
            s26 += x1 * b
        for place, part in enumerate((s0, s1, s2, s3, s4, s5, s6, s7, s8, s9, s10, s11, s12, s13, s14, s15, s16, s17,
                                      s18, s19, s20, s21, s22, s23, s24, s25, s26)):
            total[place] += part


@lru_cache(maxsize=1)
def compiled_sums() -> Callable[..., None] | None:
    """The same, compiled for this machine.

    Returns
    -------
    callable or None
        As ``stiffness_sums``; None where numba is not installed.

    Notes
    -----
    Sums may be rearranged, and nothing is assumed about numbers that are not finite. What was compiled is kept beside
    the module where that may be written to. Source: numba.
    """
    try:
        import numba
    except ImportError:
        return None
    from granular.batch.compiled_rows import row_functions
    from granular.batch.engines import copy_knowing

    njit: Callable[..., Callable[..., None]] = numba.njit
    freely = {"reassoc", "contract", "nsz"}
    loop = copy_knowing(stiffness_sums, "stiffness_sums", row_functions())
    try:
        return njit(loop, cache=True, nogil=True, fastmath=freely)
    except RuntimeError:  # there is no place to keep what was compiled
        return njit(loop, nogil=True, fastmath=freely)
