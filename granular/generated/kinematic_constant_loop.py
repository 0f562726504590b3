"""Stiffness with constant contact stiffness, kinematic hypothesis: a loop over elements, to be compiled.

Emitted by ``derivations write`` from the derivation ``kinematic_constant``; do not edit.
Source: (2), (4), (7) of Pan & Dong (1999).
Domain: kinematic_constant: D33 >= -1.0, D33 <= 2.0, Dr33 > -1.0, Dr33 < 2.0, nu >= 0.0, nu <= 0.5.
Operations: 64 (339 in the outputs as derived).
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

Array: TypeAlias = npt.NDArray[np.float64]


def kinematic_constant(all_D33: Array, all_Dr33: Array, all_nu: Array, out: Array) -> int:
    """Six components over (M/V) l_e^2 k_n for contacts that are all equally stiff.

    Parameters
    ----------
    all_D33 : (n,) array [-]
        P2 coefficient of the contact-normal density.
    all_Dr33 : (n,) array [-]
        P2 coefficient of the branch-length weight.
    all_nu : (n,) array [-]
        Poisson's ratio of the grain material.
    out : (6 n,) array [-]
        C1111, C3333, C1122, C1133, C2323, C1212 of each element in turn, NaN for those that are not served.

    Returns
    -------
    unserved : int
        How many elements are not served.

    Operations: 64.
    """
    level = 1/221760
    unserved = 0
    for i in range(all_D33.size):
        D33 = all_D33[i]
        Dr33 = all_Dr33[i]
        nu = all_nu[i]
        e0 = 2 - D33
        e1 = 2*D33 + 2
        density0 = 1280*e0 + 128*e1
        density1 = 128*e0 + 48*e1
        density2 = 48*e0 + 40*e1
        density3 = 40*e0 + 70*e1
        density4 = 70*e0 + 315*e1
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
        over_complement = 1/complement
        served = (D33 >= -1.0) & (D33 <= 2.0) & (Dr33 > -1.0) & (Dr33 < 2.0) & (nu >= 0.0) & (nu <= 0.5)
        unserved += not served
        one_minus_lam = nu*over_complement if served else np.nan
        lam = 1 - one_minus_lam
        four_r1 = 4*sum1
        both = sum0 + sum1
        later = sum1 + sum2
        along = lam*sum1 + sum2
        C1111 = lam*(four_r1 + sum0) + 3*sum0
        C3333 = 8*along
        C1122 = one_minus_lam*sum0
        C1133 = four_r1*one_minus_lam
        C2323 = C1133 + lam*(both + 2*later)
        C1212 = C1122 + 2*both*lam
        place = 6*i
        out[place + 0] = C1111
        out[place + 1] = C3333
        out[place + 2] = C1122
        out[place + 3] = C1133
        out[place + 4] = C2323
        out[place + 5] = C1212
    return unserved
