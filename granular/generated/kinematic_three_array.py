"""Stiffness with three contact stiffnesses, kinematic hypothesis: functions of arrays.

Emitted by ``derivations write`` from the derivation ``kinematic_three``; do not edit.
Source: (2), (4), (7) of Pan & Dong (1999).
Domain: E nowhere negative; -1 < Dr33 < 2; k_n, k_s, k_t > 0.
Operations: 122 (764 in the outputs as derived).
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

Array: TypeAlias = npt.NDArray[np.float64]


def positive_moments(D33: Array, D3333: Array, Dr33: Array) -> tuple[Array, Array, Array]:
    """Moments <E W^2 s^2>, <E W^2 s x^2>, <E W^2 x^4> of the kinematic weight.

    Parameters
    ----------
    D33 : (...) array [-]
        P2 coefficient of the contact-normal density.
    D3333 : (...) array [-]
        P4 coefficient of the contact-normal density.
    Dr33 : (...) array [-]
        P2 coefficient of the branch-length weight.

    Returns
    -------
    p0 : (...) array [-]
        Moment of the weight with the fourth power of the sine.
    p1 : (...) array [-]
        Moment of the weight with squared sine and squared cosine.
    p2 : (...) array [-]
        Moment of the weight with the fourth power of the cosine.

    Operations: 67.
    """
    e0 = (-4*D33 + 3*D3333 + 8)/8
    e1 = (D33 - 6*D3333 + 4)/2
    e2 = D33 + D3333 + 1
    w0 = (2 - Dr33)/2
    w1 = Dr33 + 1
    omega0 = e0*w0*w0
    omega1 = w0*(2*e0*w1 + e1*w0)
    omega2 = e0*w1*w1 + 2*e1*w0*w1 + e2*w0*w0
    omega3 = w1*(e1*w1 + 2*e2*w0)
    omega4 = e2*w1*w1
    sum0 = 15360*omega0 + 1280*omega1 + 384*omega2 + 240*omega3 + 280*omega4
    sum1 = 1280*omega0 + 384*omega1 + 240*omega2 + 280*omega3 + 630*omega4
    sum2 = 384*omega0 + 240*omega1 + 280*omega2 + 630*omega3 + 3465*omega4
    p0 = sum0/45045
    p1 = sum1/45045
    p2 = sum2/45045
    return p0, p1, p2


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


def kinematic_three(
    D33: Array, D3333: Array, Dr33: Array, kn: Array, ks: Array, kt: Array,
) -> tuple[Array, Array, Array, Array, Array, Array]:
    """Stiffness with three contact stiffnesses, kinematic hypothesis, from the fabric to the components.

    Parameters
    ----------
    D33 : (...) array [-]
        P2 coefficient of the contact-normal density.
    D3333 : (...) array [-]
        P4 coefficient of the contact-normal density.
    Dr33 : (...) array [-]
        P2 coefficient of the branch-length weight.
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

    Operations: 122.
    """
    p0, p1, p2 = positive_moments(D33, D3333, Dr33)
    return stiffness_from_moments(p0, p1, p2, kn, ks, kt)
