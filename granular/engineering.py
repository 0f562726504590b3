"""Young's moduli, Poisson's ratios and shear moduli of a transversely isotropic stiffness."""

from __future__ import annotations

import math
from dataclasses import dataclass

from granular.elasticity import Stiffness
from granular.errors import DirectionNotValid, TensorNotPositive
from granular.generated import engineering as closed_forms
from granular.mandel import size_of


@dataclass(frozen=True, slots=True)
class EngineeringConstants:
    """What tests on a specimen cut along the axes would measure; axis 3 is the axis of symmetry.

    Attributes
    ----------
    E1, E3 : float
        Young's modulus along a horizontal direction and along axis 3 [Pa].
    nu12 : float
        Poisson's ratio of direction 2 under stress along 1, both horizontal [-].
    nu13 : float
        Poisson's ratio of axis 3 under stress along 1 [-].
    nu31 : float
        Poisson's ratio of direction 1 under stress along 3 [-]; nu31/E3 = nu13/E1.
    G23, G12 : float
        Shear modulus in a vertical and in the horizontal plane [Pa].
    K : float
        Bulk modulus, mean stress over volume change under equal stress on all sides [Pa].
    """

    E1: float
    E3: float
    nu12: float
    nu13: float
    nu31: float
    G23: float
    G12: float
    K: float


def engineering_constants(stiffness: Stiffness) -> EngineeringConstants:
    """Young's moduli, Poisson's ratios, shear moduli and the bulk modulus.

    Parameters
    ----------
    stiffness : Stiffness
        Transversely isotropic about axis 3 and positive definite [Pa].

    Returns
    -------
    EngineeringConstants
        Moduli [Pa] and ratios [-].

    Raises
    ------
    TensorNotElastic
        The stiffness is not transversely isotropic.
    TensorNotPositive
        It stores no energy in some strain.

    Notes
    -----
    Accuracy: a few units in the last place, less the digits that (C1111 + C1122) C3333 - 2 C1133^2 and
    C1111 - C1122 cancel in a nearly singular solid.
    Source: the compliance of a transversely isotropic solid, derived in ``derivations.engineering``.

    Examples
    --------
    >>> sand = Stiffness.transversely_isotropic(3.0, 3.0, 1.0, 1.0, 1.0, 1.0)
    >>> engineering_constants(sand).nu31, engineering_constants(sand).E3
    (0.25, 2.5)
    """
    six = require_positive(stiffness).components
    size = size_of(six.values())
    unitless = {name: value / size for name, value in six.items()}
    e1, e3, nu12, nu13, nu31, g23, g12, bulk = closed_forms.engineering_constants(**unitless)
    return EngineeringConstants(E1=e1 * size, E3=e3 * size, nu12=nu12, nu13=nu13, nu31=nu31,
                                G23=g23 * size, G12=g12 * size, K=bulk * size)


def young_modulus(stiffness: Stiffness, *, degrees: float) -> float:
    """Young's modulus of a specimen cut along one direction.

    Parameters
    ----------
    stiffness : Stiffness
        Transversely isotropic about axis 3 and positive definite [Pa].
    degrees : float
        Angle of the direction n from axis 3 [deg].

    Returns
    -------
    float
        1/(S_ijkl n_i n_j n_k n_l) [Pa].

    Raises
    ------
    TensorNotElastic
        The stiffness is not transversely isotropic.
    TensorNotPositive
        It stores no energy in some strain.
    DirectionNotValid
        The angle is not a finite number.

    Notes
    -----
    Source: strain along n under stress along n.

    Examples
    --------
    >>> sand = Stiffness.transversely_isotropic(3.0, 3.0, 1.0, 1.0, 1.0, 1.0)
    >>> round(young_modulus(sand, degrees=30.0), 12)
    2.5
    """
    soft = require_positive(stiffness).compliance()
    return 1 / _along(soft.S1111, 2 * soft.S1133 + 4 * soft.S2323, soft.S3333, degrees)


def normal_stiffness(stiffness: Stiffness, *, degrees: float) -> float:
    """Stress along one direction per strain along it when every other strain is held at zero.

    Parameters
    ----------
    stiffness : Stiffness
        Transversely isotropic about axis 3 [Pa].
    degrees : float
        Angle of the direction n from axis 3 [deg].

    Returns
    -------
    float
        C_ijkl n_i n_j n_k n_l [Pa].

    Raises
    ------
    TensorNotElastic
        The stiffness is not transversely isotropic.
    DirectionNotValid
        The angle is not a finite number.

    Notes
    -----
    Source: the definition of the stiffness.

    Examples
    --------
    >>> sand = Stiffness.transversely_isotropic(9.0, 7.0, 3.0, 2.0, 2.5, 3.0)
    >>> normal_stiffness(sand, degrees=0.0)
    7.0
    """
    six = stiffness.components
    return _along(six["C1111"], 2 * six["C1133"] + 4 * six["C2323"], six["C3333"], degrees)


def _along(horizontal: float, between: float, vertical: float, degrees: float) -> float:
    """Fourth-order form of a direction: horizontal s^2 + between s x^2 + vertical x^4."""
    if not math.isfinite(degrees):
        raise DirectionNotValid(f"angle of {degrees!r} degrees", allowed="needed: a finite number",
                                remedy="Give the angle from axis 3 in degrees.")
    x2 = math.cos(math.radians(degrees)) ** 2
    s = math.sin(math.radians(degrees)) ** 2
    return horizontal * s**2 + between * s * x2 + vertical * x2**2


def require_positive(stiffness: Stiffness) -> Stiffness:
    """Refuse a stiffness that is not positive definite.

    Parameters
    ----------
    stiffness : Stiffness
        Of any symmetry [Pa].

    Returns
    -------
    Stiffness
        The same one [Pa].

    Raises
    ------
    TensorNotPositive
        It stores no energy in some strain.

    Notes
    -----
    Source: stability of an elastic solid.
    """
    if not stiffness.is_positive_definite():
        raise TensorNotPositive(f"{stiffness!r}", allowed="needed: positive definite",
                                remedy="Check the components: some strain would cost no energy.")
    return stiffness
