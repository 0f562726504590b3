"""Young's moduli, Poisson's ratios, shear and bulk moduli of a stiffness without an axis, and how anisotropic it is."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from granular.elastic_tensor import ElasticTensor
from granular.elasticity import Stiffness
from granular.engineering import require_positive
from granular.general.extremes import Extreme, greatest
from granular.mandel import size_of
from granular.notation import MANDEL_PAIRS, NORMAL_PAIRS

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class GeneralEngineering:
    """What tests on specimens cut along the coordinate axes would measure, and extremes over all directions.

    Attributes
    ----------
    E1, E2, E3 : float
        Young's modulus along each axis [Pa].
    nu12, nu21, nu13, nu31, nu23, nu32 : float
        Poisson's ratio nu_ij of direction j under stress along i [-]; nu_ij/E_i = nu_ji/E_j.
    G23, G13, G12 : float
        Shear modulus under shear stress in each coordinate plane [Pa], 1/(4 S2323) and so on; other strains are free.
    K : float
        Bulk modulus under equal stress on all sides [Pa], 1/S_iijj: Reuss's mean.
    K_voigt : float
        Mean stress over volume change when all sides shorten alike [Pa], C_iijj/9: Voigt's mean.
    G, G_voigt : float
        Shear modulus of an isotropic mixture of such solids, Reuss's and Voigt's mean [Pa].
    universal_anisotropy : float
        5 G_voigt/G + K_voigt/K - 6 [-]; zero for an isotropic solid alone.
    stiffest, softest : Extreme
        Greatest and least Young's modulus over all directions [Pa], and where.
    """

    E1: float
    E2: float
    E3: float
    nu12: float
    nu21: float
    nu13: float
    nu31: float
    nu23: float
    nu32: float
    G23: float
    G13: float
    G12: float
    K: float
    K_voigt: float
    G: float
    G_voigt: float
    universal_anisotropy: float
    stiffest: Extreme
    softest: Extreme


def general_engineering(stiffness: Stiffness) -> GeneralEngineering:
    """Young's moduli, Poisson's ratios, shear and bulk moduli, extremes and anisotropy of a solid of any symmetry.

    Parameters
    ----------
    stiffness : Stiffness
        Positive definite, of any symmetry [Pa].

    Returns
    -------
    GeneralEngineering
        Moduli [Pa], ratios [-], and directions.

    Raises
    ------
    TensorNotPositive
        The stiffness stores no energy in some strain.

    Notes
    -----
    Accuracy: the condition number of the stiffness times 1e-16, for directions of extremes about 1e-7; see
    ``granular.general.extremes``. Source: the compliance; bounds of Voigt and Reuss on the moduli of an isotropic
    mixture; the index of Ranganathan and Ostoja-Starzewski (2008).

    Examples
    --------
    >>> sand = Stiffness.transversely_isotropic(9.0, 7.0, 3.0, 2.0, 2.5, 3.0)
    >>> found = general_engineering(sand)
    >>> found.G23, found.G12, found.stiffest.direction
    (2.5, 3.0, (1.0, 0.0, 0.0))
    """
    size = size_of(value for row in require_positive(stiffness).rows for value in row)
    hard = stiffness.scaled(1 / size)
    soft = hard.compliance()
    s, (bulk_soft, shear_soft), (bulk_hard, shear_hard) = soft.rows, _means(soft), _means(hard)
    bulk, bulk_voigt = 1 / (3 * bulk_soft), bulk_hard / 3
    shear, shear_voigt = 1 / (2 * shear_soft), shear_hard / 2

    def nu(under: int, of: int) -> float:
        return 0.0 - s[under][of] / s[under][under]  # never -0.0

    stiffest = greatest(lambda n: 1 / along(soft, n))
    softest = greatest(lambda n: along(soft, n))
    return GeneralEngineering(
        E1=size / s[0][0], E2=size / s[1][1], E3=size / s[2][2],
        nu12=nu(0, 1), nu21=nu(1, 0), nu13=nu(0, 2), nu31=nu(2, 0), nu23=nu(1, 2), nu32=nu(2, 1),
        G23=size / (2 * s[3][3]), G13=size / (2 * s[4][4]), G12=size / (2 * s[5][5]),
        K=bulk * size, K_voigt=bulk_voigt * size, G=shear * size, G_voigt=shear_voigt * size,
        universal_anisotropy=max(5 * (shear_voigt - shear) / shear + (bulk_voigt - bulk) / bulk, 0.0),
        stiffest=replace(stiffest, value=stiffest.value * size), softest=replace(softest, value=size / softest.value))


def along(tensor: ElasticTensor, directions: Array) -> Array:
    """The form X_ijkl n_i n_j n_k n_l: of a compliance 1/E(n), of a stiffness that with all other strains held at zero.

    Parameters
    ----------
    tensor : Stiffness or Compliance
        Of any symmetry [Pa] or [1/Pa].
    directions : (3, q) array
        Unit vectors [-].

    Returns
    -------
    (q,) array
        The form [Pa] or [1/Pa].

    Notes
    -----
    Accuracy: a few units in the last place of the largest component. Source: Mandel's notation keeps the product of two
    tensors.

    Examples
    --------
    >>> import numpy as np
    >>> along(Stiffness.transversely_isotropic(9.0, 7.0, 3.0, 2.0, 2.5, 3.0), np.eye(3)).tolist()
    [9.0, 9.0, 7.0]
    """
    import numpy as np

    n = directions
    strain = np.stack([n[i - 1] * n[j - 1] * (1.0 if place < NORMAL_PAIRS else math.sqrt(2.0))
                       for place, (i, j) in enumerate(MANDEL_PAIRS)])
    values: Array = (strain * (tensor.mandel() @ strain)).sum(axis=0)
    return values


def _means(tensor: ElasticTensor) -> tuple[float, float]:
    """Eigenvalues of the nearest isotropic tensor: 3 K and 2 G of a stiffness, 1/(3 K) and 1/(2 G) of a compliance."""
    rows = tensor.rows
    bulk = math.fsum(rows[p][q] for p in range(NORMAL_PAIRS) for q in range(NORMAL_PAIRS)) / 3
    return bulk, (math.fsum(rows[p][p] for p in range(6)) - bulk) / 5
