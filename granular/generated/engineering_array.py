"""Engineering constants of a transversely isotropic solid: functions of arrays.

Emitted by ``derivations write`` from the derivation ``engineering``; do not edit.
Domain: positive definite stiffness.
Operations: 31 (47 in the outputs as derived).
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

Array: TypeAlias = npt.NDArray[np.float64]


def engineering_constants(
    C1111: Array, C3333: Array, C1122: Array, C1133: Array, C2323: Array, C1212: Array,
) -> tuple[Array, Array, Array, Array, Array, Array, Array, Array]:
    """Young's moduli, Poisson's ratios, shear moduli and bulk modulus.

    nu13 is the contraction along axis 3 under a pull along axis 1; nu31 the other way round.

    Parameters
    ----------
    C1111 : (...) array [Pa]
        Stiffness component 1111.
    C3333 : (...) array [Pa]
        Stiffness component 3333.
    C1122 : (...) array [Pa]
        Stiffness component 1122.
    C1133 : (...) array [Pa]
        Stiffness component 1133.
    C2323 : (...) array [Pa]
        Stiffness component 2323.
    C1212 : (...) array [Pa]
        Stiffness component 1212.

    Returns
    -------
    E1 : (...) array [Pa]
        Young's modulus across axis 3.
    E3 : (...) array [Pa]
        Young's modulus along axis 3.
    nu12 : (...) array [-]
        Poisson's ratio between two directions across axis 3.
    nu13 : (...) array [-]
        Contraction along axis 3 under a pull across it.
    nu31 : (...) array [-]
        Contraction across axis 3 under a pull along it.
    G23 : (...) array [Pa]
        Shear modulus of planes through axis 3.
    G12 : (...) array [Pa]
        Shear modulus of the plane across axis 3.
    K : (...) array [Pa]
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
