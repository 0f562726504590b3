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
        Young's modulus across axis 3.
    E3 : float [Pa]
        Young's modulus along axis 3.
    nu12 : float [-]
        Poisson's ratio between two directions across axis 3.
    nu13 : float [-]
        Contraction along axis 3 under a pull across it.
    nu31 : float [-]
        Contraction across axis 3 under a pull along it.
    G23 : float [Pa]
        Shear modulus of planes through axis 3.
    G12 : float [Pa]
        Shear modulus of the plane across axis 3.
    K : float [Pa]
        Bulk modulus under equal pressure from all sides.

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
