"""Stiffness with constant contact stiffness, kinematic hypothesis: blocks of elements at once.

Emitted by ``derivations write`` from the derivation ``kinematic_constant``; do not edit.
Source: (2), (4), (7) of Pan & Dong (1999).
Domain: kinematic_constant: D33 >= -1.0, D33 <= 2.0, Dr33 > -1.0, Dr33 < 2.0, nu >= 0.0, nu <= 0.5.
Operations: 57 (339 in the outputs as derived).
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

Array: TypeAlias = npt.NDArray[np.float64]


def kinematic_constant(D33: Array, Dr33: Array, nu: Array, out: Array) -> int:
    """Six components over (M/V) l_e^2 k_n for contacts that are all equally stiff.

    Parameters
    ----------
    D33 : (n,) array [-]
        P2 coefficient of the contact-normal density.
    Dr33 : (n,) array [-]
        P2 coefficient of the branch-length weight.
    nu : (n,) array [-]
        Poisson's ratio of the grain material.
    out : (6 n,) array [-]
        C1111, C3333, C1122, C1133, C2323, C1212 of each element in turn, NaN for those that are not served.

    Returns
    -------
    unserved : int
        How many elements are not served.

    Operations: 57.
    """
    rows = out.reshape(-1, 6)
    with np.errstate(all="ignore"):  # what is not served may be anything
        level = 1/221760
        e0 = 2 - D33
        half_e1 = D33 + 1
        density0 = 1024*e0 + 768
        density1 = 32*e0 + 288
        density2 = 32*half_e1 + 144
        density3 = 100*half_e1 + 120
        density4 = 560*half_e1 + 210
        w0 = 2 - Dr33
        half_w1 = Dr33 + 1
        twice_w1 = 4*half_w1
        level_w0 = level*w0
        level_half_w1 = half_w1*level
        square0 = level_w0*w0
        square1 = level_w0*twice_w1
        square2 = level_half_w1*twice_w1
        sum0 = density0*square0 + density1*square1 + density2*square2
        sum1 = density1*square0 + density2*square1 + density3*square2
        sum2 = density2*square0 + density3*square1 + density4*square2
        complement = 2 - nu
        served = (e0*half_e1 >= 0.0) & (square1 > 0.0) & (nu >= 0.0) & (nu <= 0.5)
        one_minus_lam = np.where(served, nu/complement, np.nan)
        lam = 1 - one_minus_lam
        four_r1 = 4*sum1
        both = sum0 + sum1
        later = sum1 + sum2
        along = lam*sum1 + sum2
        rows[:, 0] = lam*(four_r1 + sum0) + 3*sum0
        rows[:, 1] = 8*along
        rows[:, 2] = one_minus_lam*sum0
        C1122 = rows[:, 2]
        rows[:, 3] = four_r1*one_minus_lam
        C1133 = rows[:, 3]
        rows[:, 4] = C1133 + lam*(both + 2*later)
        rows[:, 5] = C1122 + 2*both*lam
    return int(served.size - np.count_nonzero(served))
