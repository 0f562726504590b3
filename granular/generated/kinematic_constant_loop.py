"""Stiffness with constant contact stiffness, kinematic hypothesis: a loop over elements, to be compiled.

Emitted by ``derivations write`` from the derivation ``kinematic_constant``; do not edit.
Source: (2), (4), (7) of Pan & Dong (1999).
Domain: kinematic_constant: D33 >= -1.0, D33 <= 2.0, Dr33 > -1.0, Dr33 < 2.0, nu >= 0.0, nu <= 0.5.
Operations: 57 (339 in the outputs as derived).
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from granular.generated.rows import scratch_of, write_rows

Array: TypeAlias = npt.NDArray[np.float64]


def kinematic_constant(all_D33: Array, all_Dr33: Array, all_nu: Array, out: Array, streamed: bool) -> int:
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
    streamed : bool
        Whether results go past the caches, where a compiler knows how.

    Returns
    -------
    unserved : int
        How many elements are not served.

    Operations: 57.
    """
    level = 1/221760
    scratch = scratch_of(816)
    column_C1111 = scratch[0:128]
    column_C3333 = scratch[136:264]
    column_C1122 = scratch[272:400]
    column_C1133 = scratch[408:536]
    column_C2323 = scratch[544:672]
    column_C1212 = scratch[680:808]
    columns = scratch[0:816]
    unserved = 0
    for start in range(0, all_D33.size, 128):
        stop = min(start + 128, all_D33.size)
        some_D33 = all_D33[start:stop]
        some_Dr33 = all_Dr33[start:stop]
        some_nu = all_nu[start:stop]
        for i in range(stop - start):
            D33 = some_D33[i]
            Dr33 = some_Dr33[i]
            nu = some_nu[i]
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
            unserved += not served
            one_minus_lam = nu/complement if served else np.nan
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
            column_C1111[i] = C1111
            column_C3333[i] = C3333
            column_C1122[i] = C1122
            column_C1133[i] = C1133
            column_C2323[i] = C2323
            column_C1212[i] = C1212
        write_rows(columns, 6, 136, out[6*start:6*stop], streamed)
    return unserved
