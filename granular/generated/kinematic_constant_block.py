"""Stiffness with constant contact stiffness, kinematic hypothesis: blocks of elements at once.

Emitted by ``derivations write`` from the derivation ``kinematic_constant``; do not edit.
Source: (2), (4), (7) of Pan & Dong (1999).
Domain: kinematic_constant: D33 >= -1.0, D33 <= 2.0, Dr33 > -1.0, Dr33 < 2.0, nu >= 0.0, nu <= 0.5.
Operations: 73 (339 in the outputs as derived).
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

    Operations: 73.
    """
    rows = out.reshape(-1, 6)
    with np.errstate(all="ignore"):  # what is not served may be anything
        e0 = 2 - D33
        e1 = 2*D33 + 2
        w0 = 2 - Dr33
        w1 = 2*Dr33 + 2
        mixed = e0*w1
        mixed_too = e1*w0
        omega0 = e0*w0*w0
        omega1 = w0*(2*mixed + mixed_too)
        omega2 = w1*(mixed + 2*mixed_too)
        omega3 = e1*w1*w1
        sum0 = 1280*omega0 + 128*omega1 + 48*omega2 + 40*omega3
        sum1 = 128*omega0 + 48*omega1 + 40*omega2 + 70*omega3
        sum2 = 48*omega0 + 40*omega1 + 70*omega2 + 315*omega3
        complement = 2 - nu
        share = 2 - 2*nu
        served = (D33 >= -1.0) & (D33 <= 2.0) & (Dr33 > -1.0) & (Dr33 < 2.0) & (nu >= 0.0) & (nu <= 0.5)
        factor = np.where(served, 1/(221760*complement), np.nan)
        shear0 = nu*sum0
        shear1 = 4*nu*sum1
        both = sum0 + sum1
        rows[:, 0] = factor*(3*complement*sum0 + share*(sum0 + 4*sum1))
        rows[:, 1] = 8*factor*(complement*sum2 + share*sum1)
        rows[:, 2] = factor*shear0
        rows[:, 3] = factor*shear1
        rows[:, 4] = factor*(share*(both + 2*sum1 + 2*sum2) + shear1)
        rows[:, 5] = factor*(2*both*share + shear0)
    return int(served.size - np.count_nonzero(served))
