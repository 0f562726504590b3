"""Stiffness with constant contact stiffness, kinematic hypothesis: functions of arrays.

Emitted by ``derivations write`` from the derivation ``kinematic_constant``; do not edit.
Source: (2), (4), (7) of Pan & Dong (1999).
Domain: E nowhere negative; -1 < Dr33 < 2; 0 <= nu <= 1/2.
Operations: 103 (339 in the outputs as derived).
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
    p0: Array, p1: Array, p2: Array, nu: Array,
) -> tuple[Array, Array, Array, Array, Array, Array]:
    """Six components over (M/V) l_e^2 k_n from the positive moments.

    Parameters
    ----------
    p0 : (...) array [-]
        Moment of the weight with the fourth power of the sine.
    p1 : (...) array [-]
        Moment of the weight with squared sine and squared cosine.
    p2 : (...) array [-]
        Moment of the weight with the fourth power of the cosine.
    nu : (...) array [-]
        Poisson's ratio of the grain material.

    Returns
    -------
    C1111 : (...) array [-]
        Stiffness component 1111.
    C3333 : (...) array [-]
        Stiffness component 3333.
    C1122 : (...) array [-]
        Stiffness component 1122.
    C1133 : (...) array [-]
        Stiffness component 1133.
    C2323 : (...) array [-]
        Stiffness component 2323.
    C1212 : (...) array [-]
        Stiffness component 1212.

    Operations: 36.
    """
    lam = 2*(1 - nu)/(2 - nu)
    one_minus_lam = nu/(2 - nu)
    C1111 = lam*(p0/8 + p1/2) + 3*p0/8
    C3333 = lam*p1 + p2
    C1122 = one_minus_lam*p0/8
    C1133 = one_minus_lam*p1/2
    C2323 = lam*(p0/8 + 3*p1/8 + p2/4) + one_minus_lam*p1/2
    C1212 = lam*(p0/4 + p1/4) + one_minus_lam*p0/8
    return C1111, C3333, C1122, C1133, C2323, C1212


def kinematic_constant(
    D33: Array, D3333: Array, Dr33: Array, nu: Array,
) -> tuple[Array, Array, Array, Array, Array, Array]:
    """Stiffness with constant contact stiffness, kinematic hypothesis, from the fabric to the components.

    Parameters
    ----------
    D33 : (...) array [-]
        P2 coefficient of the contact-normal density.
    D3333 : (...) array [-]
        P4 coefficient of the contact-normal density.
    Dr33 : (...) array [-]
        P2 coefficient of the branch-length weight.
    nu : (...) array [-]
        Poisson's ratio of the grain material.

    Returns
    -------
    C1111 : (...) array [-]
        Stiffness component 1111.
    C3333 : (...) array [-]
        Stiffness component 3333.
    C1122 : (...) array [-]
        Stiffness component 1122.
    C1133 : (...) array [-]
        Stiffness component 1133.
    C2323 : (...) array [-]
        Stiffness component 2323.
    C1212 : (...) array [-]
        Stiffness component 1212.

    Operations: 103.
    """
    p0, p1, p2 = positive_moments(D33, D3333, Dr33)
    return stiffness_from_moments(p0, p1, p2, nu)
