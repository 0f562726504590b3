"""Stiffness with three contact stiffnesses, kinematic hypothesis: functions of arrays.

Emitted by ``derivations write`` from the derivation ``kinematic_three``; do not edit.
Source: (2), (4), (7) of Pan & Dong (1999).
Domain: p0, p1, p2 from kinematic_constant.positive_moments; kn, ks, kt > 0.
Operations: 55 (60 in the outputs as derived).
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

Array: TypeAlias = npt.NDArray[np.float64]


def stiffness_from_moments(
    p0: Array, p1: Array, p2: Array, kn: Array, ks: Array, kt: Array,
) -> tuple[Array, Array, Array, Array, Array, Array]:
    """Six components over (M/V) l_e^2 from the positive moments; k_s along the meridian.

    Parameters
    ----------
    p0 : (...) array [-]
        Moment of the weight with the fourth power of the sine.
    p1 : (...) array [-]
        Moment of the weight with squared sine and squared cosine.
    p2 : (...) array [-]
        Moment of the weight with the fourth power of the cosine.
    kn : (...) array [N/m]
        Normal contact stiffness.
    ks : (...) array [N/m]
        Tangential contact stiffness along the meridian.
    kt : (...) array [N/m]
        Tangential contact stiffness along the parallel.

    Returns
    -------
    C1111 : (...) array [N/m]
        Stiffness component 1111.
    C3333 : (...) array [N/m]
        Stiffness component 3333.
    C1122 : (...) array [N/m]
        Stiffness component 1122.
    C1133 : (...) array [N/m]
        Stiffness component 1133.
    C2323 : (...) array [N/m]
        Stiffness component 2323.
    C1212 : (...) array [N/m]
        Stiffness component 1212.

    Operations: 55.
    """
    C1111 = 3*kn*p0/8 + 3*ks*p1/8 + kt*(p0/8 + p1/8)
    C3333 = kn*p2 + ks*p1
    C1122 = kn*p0/8 + ks*p1/8 + kt*(-p0/8 - p1/8)
    C1133 = kn*p1/2 - ks*p1/2
    C2323 = kn*p1/2 + ks*(p0/8 - p1/4 + p2/8) + kt*(p1/8 + p2/8)
    C1212 = kn*p0/8 + ks*p1/8 + kt*(p0/8 + p1/8)
    return C1111, C3333, C1122, C1133, C2323, C1212
