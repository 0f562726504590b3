"""Stiffness with three contact stiffnesses, static hypothesis: scalar functions.

Emitted by ``derivations write`` from the derivation ``static_three``; do not edit.
Source: (2), (23), (24), Figure 1(b) of Pan & Dong (1999).
Domain: p0, p1, p2 from static_constant.static_moments; -1 <= D33 <= 2; kn, ks, kt > 0.
Operations: 139 (208 in the outputs as derived).
"""

from __future__ import annotations


def compliance_from_moments(
    p0: float, p1: float, p2: float, D33: float, kn: float, ks: float, kt: float,
) -> tuple[float, float, float, float, float, float]:
    """Six compliance components times (M/V) l_e^2 from the positive moments of E/W^2.

    Parameters
    ----------
    p0 : float [-]
        Moment of the weight with the fourth power of the sine.
    p1 : float [-]
        Moment of the weight with squared sine and squared cosine.
    p2 : float [-]
        Moment of the weight with the fourth power of the cosine.
    D33 : float [-]
        P2 coefficient of the contact-normal density.
    kn : float [N/m]
        Normal contact stiffness.
    ks : float [N/m]
        Tangential contact stiffness along the meridian.
    kt : float [N/m]
        Tangential contact stiffness along the parallel.

    Returns
    -------
    S1111 : float [m/N]
        Compliance component 1111.
    S3333 : float [m/N]
        Compliance component 3333.
    S1122 : float [m/N]
        Compliance component 1122.
    S1133 : float [m/N]
        Compliance component 1133.
    S2323 : float [m/N]
        Compliance component 2323.
    S1212 : float [m/N]
        Compliance component 1212.

    Operations: 112.
    """
    fifteen_N11 = 5 - D33
    fifteen_N33 = 2*D33 + 5
    A11 = 15/fifteen_N11
    A33 = 15/fifteen_N33
    S1111 = 3*A11*A11*p1/(8*ks) + 3*A11*A11*p0/(8*kn) + (A11*A11*p0/8 + A11*A11*p1/8)/kt
    S3333 = A33*A33*p1/ks + A33*A33*p2/kn
    S1122 = A11*A11*p1/(8*ks) + A11*A11*p0/(8*kn) + (-A11*A11*p0/8 - A11*A11*p1/8)/kt
    S1133 = -A11*A33*p1/(2*ks) + A11*A33*p1/(2*kn)
    S2323 = (A33*A33*p1/8 + A33*A33*p2/8)/kt + (A11*A11*p0/8 - A11*A33*p1/4 + A33*A33*p2/8)/ks + (A11*A11*p1/8 + A11*A33*p1/4 + A33*A33*p1/8)/kn
    S1212 = A11*A11*p1/(8*ks) + A11*A11*p0/(8*kn) + (A11*A11*p0/8 + A11*A11*p1/8)/kt
    return S1111, S3333, S1122, S1133, S2323, S1212


def stiffness_from_compliance(
    S1111: float, S3333: float, S1122: float, S1133: float, S2323: float, S1212: float,
) -> tuple[float, float, float, float, float, float]:
    """Six stiffness components, the inverse of a transversely isotropic compliance.

    Parameters
    ----------
    S1111 : float [1/Pa]
        Compliance component 1111.
    S3333 : float [1/Pa]
        Compliance component 3333.
    S1122 : float [1/Pa]
        Compliance component 1122.
    S1133 : float [1/Pa]
        Compliance component 1133.
    S2323 : float [1/Pa]
        Compliance component 2323.
    S1212 : float [1/Pa]
        Compliance component 1212.

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

    Operations: 27.
    """
    determinant = -2*S1133*S1133 + S3333*(S1111 + S1122)
    C1212 = 1/(4*S1212)
    C2323 = 1/(4*S2323)
    C3333 = (S1111 + S1122)/determinant
    C1133 = -S1133/determinant
    C1111 = S3333/(2*determinant) + 1/(2*S1111 - 2*S1122)
    C1122 = S3333/(2*determinant) - 1/((2*S1111 - 2*S1122))
    return C1111, C3333, C1122, C1133, C2323, C1212


def static_three(
    p0: float, p1: float, p2: float, D33: float, kn: float, ks: float, kt: float,
) -> tuple[float, float, float, float, float, float]:
    """Stiffness with three contact stiffnesses, static hypothesis, from the fabric to the components.

    Parameters
    ----------
    p0 : float [-]
        Moment of the weight with the fourth power of the sine.
    p1 : float [-]
        Moment of the weight with squared sine and squared cosine.
    p2 : float [-]
        Moment of the weight with the fourth power of the cosine.
    D33 : float [-]
        P2 coefficient of the contact-normal density.
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

    Operations: 139.
    """
    S1111, S3333, S1122, S1133, S2323, S1212 = compliance_from_moments(p0, p1, p2, D33, kn, ks, kt)
    return stiffness_from_compliance(S1111, S3333, S1122, S1133, S2323, S1212)
