"""Wave speeds of a transversely isotropic assembly: scalar functions.

Emitted by ``derivations write`` from the derivation ``waves``; do not edit.
Source: text below Table II of Pan & Dong (1999).
Domain: positive definite stiffness; C3333 > C2323 for delta; 0 <= cos^2 <= 1.
Operations: 72 (83 in the outputs as derived).
"""

from __future__ import annotations

from math import sqrt


def phase_velocities(
    C1111: float, C3333: float, C1133: float, C2323: float, C1212: float, density: float, sin_squared: float, cos_squared: float,
) -> tuple[float, float, float]:
    """Phase speeds of the P, SV and SH waves in m/s.

    v_P is the faster of the two waves polarised in the plane of axis 3, v_SV the slower. Sine and cosine are
    both asked for, so that no digit is lost near either axis.

    Parameters
    ----------
    C1111 : float [Pa]
        Stiffness component 1111.
    C3333 : float [Pa]
        Stiffness component 3333.
    C1133 : float [Pa]
        Stiffness component 1133.
    C2323 : float [Pa]
        Stiffness component 2323.
    C1212 : float [Pa]
        Stiffness component 1212.
    density : float [kg/m^3]
        Bulk density of the assembly.
    sin_squared : float [-]
        Squared sine of the angle of propagation from axis 3.
    cos_squared : float [-]
        Squared cosine of the angle of propagation from axis 3.

    Returns
    -------
    v_P : float [m/s]
        Phase speed of the faster wave polarised in the plane of axis 3.
    v_SV : float [m/s]
        Phase speed of the slower wave polarised in the plane of axis 3.
    v_SH : float [m/s]
        Phase speed of the wave polarised across axis 3.

    Operations: 57.
    """
    half_sum = C1111*sin_squared/2 + C2323/2 + C3333*cos_squared/2
    half_difference = -cos_squared*(-C2323 + C3333)/2 + sin_squared*(C1111 - C2323)/2
    coupling = cos_squared*sin_squared*(C1133 + C2323)**2
    root = sqrt(coupling + half_difference*half_difference)
    fast = half_sum + root
    bracket = C2323*(C1111*sin_squared*sin_squared + C3333*cos_squared*cos_squared) + cos_squared*sin_squared*(C1111*C3333 - C1133*C1133 - 2*C1133*C2323)
    slow = bracket/fast
    v_P = sqrt(fast)/sqrt(density)
    v_SV = sqrt(slow)/sqrt(density)
    v_SH = sqrt(C1212*sin_squared + C2323*cos_squared)/sqrt(density)
    return v_P, v_SV, v_SH


def thomsen(
    C1111: float, C3333: float, C1133: float, C2323: float, C1212: float,
) -> tuple[float, float, float]:
    """Thomsen's epsilon, gamma and delta.

    Parameters
    ----------
    C1111 : float [Pa]
        Stiffness component 1111.
    C3333 : float [Pa]
        Stiffness component 3333.
    C1133 : float [Pa]
        Stiffness component 1133.
    C2323 : float [Pa]
        Stiffness component 2323.
    C1212 : float [Pa]
        Stiffness component 1212.

    Returns
    -------
    epsilon : float [-]
        Thomsen's parameter of compression across and along axis 3.
    gamma : float [-]
        Thomsen's parameter of shear across and along axis 3.
    delta : float [-]
        Thomsen's parameter of compression near axis 3.

    Operations: 15.
    """
    epsilon = (C1111 - C3333)/(2*C3333)
    gamma = (C1212 - C2323)/(2*C2323)
    delta = (C1133 + C3333)*(C1133 + 2*C2323 - C3333)/(2*C3333*(-C2323 + C3333))
    return epsilon, gamma, delta
