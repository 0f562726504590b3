"""Stiffness with contact stiffnesses that vary over the directions: scalar functions.

Emitted by ``derivations write`` from the derivation ``kinetic_components``; do not edit.
Source: (2), (7), (23), (24), Figure 1(b) of Pan & Dong (1999).
Domain: k_n > 0 and k_r >= 0; flexibilities: k_r > 0 in every direction; -1 <= D33 <= 2.
Operations: 122 (98 in the outputs as derived).
"""

from __future__ import annotations


def stiffness_from_weights(
    p0: float, p1: float, p2: float, q0: float, q1: float, q2: float, d0: float, d1: float,
) -> tuple[float, float, float, float, float, float]:
    """Six components over (M/V) l_e^2 k_n,ref from moments of E W^2 k_n, E W^2 k_r and E W^2 (k_n - k_r).

    All contact stiffnesses over k_n,ref.

    Parameters
    ----------
    p0 : float [-]
        Moment of the weight with the fourth power of the sine.
    p1 : float [-]
        Moment of the weight with squared sine and squared cosine.
    p2 : float [-]
        Moment of the weight with the fourth power of the cosine.
    q0 : float [-]
        Moment of the tangential stiffness with the fourth power of the sine.
    q1 : float [-]
        Moment of the tangential stiffness with squared sine and squared cosine.
    q2 : float [-]
        Moment of the tangential stiffness with the fourth power of the cosine.
    d0 : float [-]
        Normal less tangential stiffness, moment with the fourth power of the sine.
    d1 : float [-]
        Normal less tangential stiffness, moment with squared sine and squared cosine.

    Returns
    -------
    C1111 : float [-]
        Stiffness component 1111.
    C3333 : float [-]
        Stiffness component 3333.
    C1122 : float [-]
        Stiffness component 1122.
    C1133 : float [-]
        Stiffness component 1133.
    C2323 : float [-]
        Stiffness component 2323.
    C1212 : float [-]
        Stiffness component 1212.

    Operations: 22.
    """
    C1111 = 3*p0/8 + q0/8 + q1/2
    C3333 = p2 + q1
    C1122 = d0/8
    C1133 = d1/2
    C2323 = d1/2 + q0/8 + 3*q1/8 + q2/4
    C1212 = d0/8 + q0/4 + q1/4
    return C1111, C3333, C1122, C1133, C2323, C1212


def compliance_from_weights(
    u0: float, u1: float, u2: float, v0: float, v1: float, v2: float, g0: float, g1: float, D33: float,
) -> tuple[float, float, float, float, float, float]:
    """Six compliances times (M/V) l_e^2 k_n,ref from moments of E W^-2/k_n, E W^-2/k_r and their difference.

    All contact flexibilities times k_n,ref.

    Parameters
    ----------
    u0 : float [-]
        Moment of the normal flexibility with the fourth power of the sine.
    u1 : float [-]
        Moment of the normal flexibility with squared sine and squared cosine.
    u2 : float [-]
        Moment of the normal flexibility with the fourth power of the cosine.
    v0 : float [-]
        Moment of the tangential flexibility with the fourth power of the sine.
    v1 : float [-]
        Moment of the tangential flexibility with squared sine and squared cosine.
    v2 : float [-]
        Moment of the tangential flexibility with the fourth power of the cosine.
    g0 : float [-]
        Tangential less normal flexibility, moment with the fourth power of the sine.
    g1 : float [-]
        Tangential less normal flexibility, moment with squared sine and cosine.
    D33 : float [-]
        P2 coefficient of the contact-normal density.

    Returns
    -------
    S1111 : float [-]
        Compliance component 1111.
    S3333 : float [-]
        Compliance component 3333.
    S1122 : float [-]
        Compliance component 1122.
    S1133 : float [-]
        Compliance component 1133.
    S2323 : float [-]
        Compliance component 2323.
    S1212 : float [-]
        Compliance component 1212.

    Operations: 47.
    """
    fifteen_N11 = 5 - D33
    fifteen_N33 = 2*D33 + 5
    A11 = 15/fifteen_N11
    A33 = 15/fifteen_N33
    S1111 = A11*A11*(3*u0/8 + v0/8 + v1/2)
    S3333 = A33*A33*(u2 + v1)
    S1122 = -A11*A11*g0/8
    S1133 = -A11*A33*g1/2
    S2323 = A11*A11*(u1 + v0)/8 - A11*A33*g1/4 + A33*A33*(u1 + v1 + 2*v2)/8
    S1212 = A11*A11*(u0/4 + v0/4 + v1/2)/2
    return S1111, S3333, S1122, S1133, S2323, S1212


def stiffness_from_flexibilities(
    u0: float, u1: float, u2: float, v0: float, v1: float, v2: float, g0: float, g1: float, D33: float,
) -> tuple[float, float, float, float, float, float]:
    """Six components over (M/V) l_e^2 k_n,ref from moments of E W^-2/k_n, E W^-2/k_r and their difference.

    All contact flexibilities times k_n,ref.

    Parameters
    ----------
    u0 : float [-]
        Moment of the normal flexibility with the fourth power of the sine.
    u1 : float [-]
        Moment of the normal flexibility with squared sine and squared cosine.
    u2 : float [-]
        Moment of the normal flexibility with the fourth power of the cosine.
    v0 : float [-]
        Moment of the tangential flexibility with the fourth power of the sine.
    v1 : float [-]
        Moment of the tangential flexibility with squared sine and squared cosine.
    v2 : float [-]
        Moment of the tangential flexibility with the fourth power of the cosine.
    g0 : float [-]
        Tangential less normal flexibility, moment with the fourth power of the sine.
    g1 : float [-]
        Tangential less normal flexibility, moment with squared sine and cosine.
    D33 : float [-]
        P2 coefficient of the contact-normal density.

    Returns
    -------
    C1111 : float [-]
        Stiffness component 1111.
    C3333 : float [-]
        Stiffness component 3333.
    C1122 : float [-]
        Stiffness component 1122.
    C1133 : float [-]
        Stiffness component 1133.
    C2323 : float [-]
        Stiffness component 2323.
    C1212 : float [-]
        Stiffness component 1212.

    Operations: 53.
    """
    fifteen_N11 = 5 - D33
    fifteen_N33 = 2*D33 + 5
    delta = g1*u1 + u0*u2 + v1*(u0 + u1 + u2)
    shear_sum = u0 + v0 + 2*v1
    eight_S2323 = (u1 + v1 + 2*v2)/(fifteen_N33*fifteen_N33) - 2*g1/(fifteen_N11*fifteen_N33) + (u1 + v0)/(fifteen_N11*fifteen_N11)
    C1212 = 2*fifteen_N11*fifteen_N11/(225*shear_sum)
    C1122 = fifteen_N11*fifteen_N11*(g0*(u2 + v1) + 2*g1*g1)/(225*delta*shear_sum)
    C1111 = C1122 + 2*C1212
    C3333 = fifteen_N33*fifteen_N33*(u0 + v1)/(225*delta)
    C1133 = fifteen_N11*fifteen_N33*g1/(225*delta)
    C2323 = 2/(225*eight_S2323)
    return C1111, C3333, C1122, C1133, C2323, C1212
