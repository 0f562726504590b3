"""Engineering constants of a transversely isotropic solid: scalar functions.

Emitted by ``derivations write`` from the derivation ``engineering``; do not edit.
Domain: positive definite stiffness.
Operations: 31 (47 in the outputs as derived).
"""

from __future__ import annotations


def engineering_constants(
    C1111: float, C3333: float, C1122: float, C1133: float, C2323: float, C1212: float,
) -> tuple[float, float, float, float, float, float, float, float]:
    """Young's moduli, Poisson's ratios, shear moduli and bulk modulus.

    nu13 is the contraction along axis 3 under a pull along axis 1; nu31 the other way round.

    Parameters
    ----------
    C1111 : float [Pa]
        Stiffness component 1111.
    C3333 : float [Pa]
        Stiffness component 3333.
    C1122 : float [Pa]
        Stiffness component 1122.
    C1133 : float [Pa]
        Stiffness component 1133.
    C2323 : float [Pa]
        Stiffness component 2323.
    C1212 : float [Pa]
        Stiffness component 1212.

    Returns
    -------
    E1 : float [Pa]
    E3 : float [Pa]
    nu12 : float [-]
    nu13 : float [-]
    nu31 : float [-]
    G23 : float [Pa]
    G12 : float [Pa]
    K : float [Pa]

    Operations: 31.
    """
    sum_of_in_plane = C1111 + C1122
    block = -2*C1133*C1133 + C3333*sum_of_in_plane
    E3 = block/sum_of_in_plane
    E1 = block*(C1111 - C1122)/((C1111*C3333 - C1133*C1133))
    nu12 = (C1122*C3333 - C1133*C1133)/((C1111*C3333 - C1133*C1133))
    nu13 = C1133*(C1111 - C1122)/((C1111*C3333 - C1133*C1133))
    nu31 = C1133/sum_of_in_plane
    G23 = C2323
    G12 = C1212
    K = block/((-4*C1133 + 2*C3333 + sum_of_in_plane))
    return E1, E3, nu12, nu13, nu31, G23, G12, K
