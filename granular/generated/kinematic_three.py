"""Stiffness with three contact stiffnesses, kinematic hypothesis: scalar functions.

Emitted by ``derivations write`` from the derivation ``kinematic_three``; do not edit.
Source: (2), (4), (7) of Pan & Dong (1999).
Domain: p0, p1, p2 from kinematic_constant.positive_moments; kn, ks, kt > 0.
Operations: 55 (60 in the outputs as derived).
"""

from __future__ import annotations


def stiffness_from_moments(
    p0: float, p1: float, p2: float, kn: float, ks: float, kt: float,
) -> tuple[float, float, float, float, float, float]:
    """Six components over (M/V) l_e^2 from the positive moments; k_s along the meridian.

    Parameters
    ----------
    p0 : float [-]
        Moment of the weight with the fourth power of the sine.
    p1 : float [-]
        Moment of the weight with squared sine and squared cosine.
    p2 : float [-]
        Moment of the weight with the fourth power of the cosine.
    kn : float [N/m]
        Normal contact stiffness.
    ks : float [N/m]
        Tangential contact stiffness along the meridian.
    kt : float [N/m]
        Tangential contact stiffness along the parallel.

    Returns
    -------
    C1111 : float [N/m]
        Stiffness component 1111.
    C3333 : float [N/m]
        Stiffness component 3333.
    C1122 : float [N/m]
        Stiffness component 1122.
    C1133 : float [N/m]
        Stiffness component 1133.
    C2323 : float [N/m]
        Stiffness component 2323.
    C1212 : float [N/m]
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
