"""Speeds of plane waves in the assembly, from its stiffness and bulk density.

The solid is transversely isotropic about axis 3 and dry, so the speeds depend on one angle. In a direction at
that angle from axis 3 travel three waves: SH, polarised horizontally, and two polarised in the plane of the
direction and axis 3. Of these two the faster is called P and the slower SV. That is the usual reading while
C2323 < C1111 and C2323 < C3333; a fabric so flat that its vertical shear is stiffer than its vertical
compression has a longitudinal wave that is the slower one along axis 3.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

from granular.elasticity import Stiffness
from granular.errors import DensityOutOfRange, DirectionNotValid, TensorNotPositive
from granular.generated import waves as closed_forms
from granular.mandel import ROUNDING, size_of

Polarisation = Literal["SH", "SV"]


@dataclass(frozen=True, slots=True)
class PhaseVelocities:
    """Speeds of the three plane waves in one direction.

    Attributes
    ----------
    P, SV, SH : float
        Phase velocities [m/s].
    """

    P: float
    SV: float
    SH: float


@dataclass(frozen=True, slots=True)
class Thomsen:
    """Three dimensionless measures of anisotropy, all zero in an isotropic solid.

    Attributes
    ----------
    epsilon : float
        (C1111 - C3333)/(2 C3333) [-], of P between horizontal and vertical.
    gamma : float
        (C1212 - C2323)/(2 C2323) [-], of SH between horizontal and vertical.
    delta : float or None
        ((C1133 + C2323)^2 - (C3333 - C2323)^2)/(2 C3333 (C3333 - C2323)) [-], of P near the vertical; None
        where C3333 = C2323, where it has no value.
    """

    epsilon: float
    gamma: float
    delta: float | None


@dataclass(frozen=True, slots=True)
class FastestShear:
    """The fastest shear wave over all directions and both polarisations.

    Attributes
    ----------
    speed : float
        Its phase velocity [m/s].
    polarisation : "SH" or "SV"
        SV at 0 degrees stands for the wave along axis 3, where both polarisations and SV along the horizontal
        travel at the same speed.
    degrees : float
        Angle of propagation from axis 3 [deg], 0 to 90.
    is_horizontal_SH : bool
        Whether no shear wave is faster than the horizontally polarised one that travels horizontally, ties
        included: what the paper claims of its assemblies.
    """

    speed: float
    polarisation: Polarisation
    degrees: float
    is_horizontal_SH: bool


@dataclass(frozen=True, slots=True)
class Waves:
    """Plane waves in a transversely isotropic solid.

    Attributes
    ----------
    stiffness : Stiffness
        The solid [Pa].
    density : float
        Bulk density [kg/m^3].
    vertical, oblique, horizontal : PhaseVelocities
        Speeds along axis 3, at 45 degrees from it and at right angles to it [m/s].
    thomsen : Thomsen
        Measures of anisotropy [-].
    fastest_shear : FastestShear
        The fastest shear wave of all.
    """

    stiffness: Stiffness
    density: float
    vertical: PhaseVelocities
    oblique: PhaseVelocities
    horizontal: PhaseVelocities
    thomsen: Thomsen
    fastest_shear: FastestShear

    def at(self, degrees: float) -> PhaseVelocities:
        """Speeds in one more direction.

        Parameters
        ----------
        degrees : float
            Angle of propagation from axis 3 [deg].

        Returns
        -------
        PhaseVelocities
            Speeds of P, SV and SH [m/s].

        Raises
        ------
        DirectionNotValid
            The angle is not a finite number.

        Notes
        -----
        Source: ``phase_velocities``.
        """
        return phase_velocities(self.stiffness, density=self.density, degrees=degrees)


def bulk_density(grain_density: float, void_ratio: float) -> float:
    """Density of the dry assembly, grains and empty voids together.

    Parameters
    ----------
    grain_density : float
        Density of the grains [kg/m^3], > 0.
    void_ratio : float
        Volume of voids over volume of grains [-], >= 0.

    Returns
    -------
    float
        grain_density / (1 + void_ratio) [kg/m^3].

    Raises
    ------
    DensityOutOfRange
        A density that is not positive, a void ratio that is negative, or either not finite.

    Notes
    -----
    A saturated assembly is heavier and, in compression, stiffer: neither is modelled here.
    Source: definition of the void ratio, eq. (9).

    Examples
    --------
    >>> bulk_density(2650.0, 0.6)
    1656.25
    """
    require_density("grain density", grain_density)
    if not 0 <= void_ratio < math.inf:
        raise DensityOutOfRange(f"void_ratio = {void_ratio!r}", allowed="allowed 0 <= void_ratio < inf",
                                remedy="Give the volume of voids over the volume of grains.")
    return grain_density / (1 + void_ratio)


def phase_velocities(stiffness: Stiffness, *, density: float, degrees: float) -> PhaseVelocities:
    """Speeds of the three plane waves in one direction.

    Parameters
    ----------
    stiffness : Stiffness
        Transversely isotropic about axis 3 and positive definite [Pa].
    density : float
        Bulk density [kg/m^3], > 0.
    degrees : float
        Angle of propagation from axis 3 [deg].

    Returns
    -------
    PhaseVelocities
        Speeds of P, SV and SH [m/s].

    Raises
    ------
    TensorNotElastic
        The stiffness is not transversely isotropic.
    TensorNotPositive
        It stores no energy in some strain, so that a wave would have no speed.
    DensityOutOfRange
        The density is not positive and finite.
    DirectionNotValid
        The angle is not a finite number.

    Notes
    -----
    Accuracy: density times speed squared to a few units in the last place of the largest component.
    Source: the Christoffel equation of a transversely isotropic solid, derived in ``derivations.waves``.

    Examples
    --------
    >>> sand = Stiffness.transversely_isotropic(9e8, 4e8, 3e8, 2e8, 1e8, 3e8)
    >>> phase_velocities(sand, density=1600.0, degrees=0.0)
    PhaseVelocities(P=500.0, SV=250.0, SH=250.0)
    """
    c1111, c3333, c1133, c2323, c1212, size = _wave_components(stiffness)
    require_density("density", density)
    p, sv, sh = closed_forms.phase_velocities(c1111, c3333, c1133, c2323, c1212, 1.0, *_squares(degrees))
    unit = math.sqrt(size) / math.sqrt(density)
    return PhaseVelocities(p * unit, sv * unit, sh * unit)


def waves(stiffness: Stiffness, *, density: float) -> Waves:
    """Wave speeds, anisotropy parameters and the fastest shear wave of a solid.

    Parameters
    ----------
    stiffness : Stiffness
        Transversely isotropic about axis 3 and positive definite [Pa].
    density : float
        Bulk density [kg/m^3], > 0; see ``bulk_density``.

    Returns
    -------
    Waves
        Speeds at 0, 45 and 90 degrees, Thomsen's parameters and the fastest shear wave.

    Raises
    ------
    TensorNotElastic
        The stiffness is not transversely isotropic.
    TensorNotPositive
        It stores no energy in some strain, so that a wave would have no speed.
    DensityOutOfRange
        The density is not positive and finite.

    Notes
    -----
    Source: the Christoffel equation; Thomsen's definitions; ``fastest_shear``.

    Examples
    --------
    >>> sand = Stiffness.transversely_isotropic(9e8, 4e8, 3e8, 1e8, 1e8, 3e8)
    >>> result = waves(sand, density=1600.0)
    >>> result.horizontal.P, result.vertical.P, result.thomsen.epsilon
    (750.0, 500.0, 0.625)
    """
    vertical, oblique, horizontal = (phase_velocities(stiffness, density=density, degrees=angle)
                                     for angle in (0.0, 45.0, 90.0))
    return Waves(stiffness=stiffness, density=density, vertical=vertical, oblique=oblique,
                 horizontal=horizontal, thomsen=thomsen(stiffness),
                 fastest_shear=fastest_shear(stiffness, density=density))


def thomsen(stiffness: Stiffness) -> Thomsen:
    """Thomsen's measures of anisotropy.

    Parameters
    ----------
    stiffness : Stiffness
        Transversely isotropic about axis 3 and positive definite [Pa].

    Returns
    -------
    Thomsen
        epsilon, gamma and delta [-].

    Raises
    ------
    TensorNotElastic
        The stiffness is not transversely isotropic.
    TensorNotPositive
        It stores no energy in some strain.

    Notes
    -----
    Source: Thomsen's definitions, derived in ``derivations.waves``.

    Examples
    --------
    >>> thomsen(Stiffness.transversely_isotropic(3.0, 3.0, 1.0, 1.0, 1.0, 1.0))
    Thomsen(epsilon=0.0, gamma=0.0, delta=0.0)
    """
    c1111, c3333, c1133, c2323, c1212, _ = _wave_components(stiffness)
    if c3333 == c2323:
        return Thomsen((c1111 - c3333) / (2 * c3333), (c1212 - c2323) / (2 * c2323), None)
    return Thomsen(*closed_forms.thomsen(c1111, c3333, c1133, c2323, c1212))


def fastest_shear(stiffness: Stiffness, *, density: float) -> FastestShear:
    """Find the fastest shear wave over all directions and both polarisations.

    Parameters
    ----------
    stiffness : Stiffness
        Transversely isotropic about axis 3 and positive definite [Pa].
    density : float
        Bulk density [kg/m^3], > 0.

    Returns
    -------
    FastestShear
        Its speed, polarisation and angle.

    Raises
    ------
    TensorNotElastic
        The stiffness is not transversely isotropic.
    TensorNotPositive
        It stores no energy in some strain, so that a wave would have no speed.
    DensityOutOfRange
        The density is not positive and finite.

    Notes
    -----
    Three candidates settle it. SH: density times speed squared runs linearly in cos^2 from C1212 (horizontal)
    to C2323 (along axis 3). SV: it starts and ends at C2323, and with p = C1111 - C2323, q = C3333 - C2323,
    r = C1133 + C2323 it has one extremum between, at cos^2 = (p + |r|)/(p + q + 2|r|), of
    C2323 + (p q - r^2)/(p + q + 2|r|); that is a maximum where p q > r^2 (with p, q > 0).
    Source: derivative of the Christoffel root; the claim is the one that follows Table II.

    Examples
    --------
    >>> flat = Stiffness.transversely_isotropic(9e8, 4e8, 3e8, 1e8, 1e8, 3e8)
    >>> found = fastest_shear(flat, density=1200.0)
    >>> round(found.speed, 9), found.polarisation, found.degrees, found.is_horizontal_SH
    (500.0, 'SH', 90.0, True)
    """
    c1111, c3333, c1133, c2323, c1212, size = _wave_components(stiffness)
    require_density("density", density)
    candidates: list[tuple[float, Polarisation, float]] = [(c1212, "SH", 90.0), (c2323, "SV", 0.0)]
    p, q, r = c1111 - c2323, c3333 - c2323, abs(c1133 + c2323)
    if min(p, q) > 0 and p * q > r * r:
        cosine = math.sqrt((p + r) / (p + q + 2 * r))
        candidates.append((c2323 + (p * q - r * r) / (p + q + 2 * r), "SV", math.degrees(math.acos(cosine))))
    best, polarisation, degrees = max(candidates, key=lambda candidate: candidate[0])
    if tied := c1212 >= best * (1 - ROUNDING):
        best, polarisation, degrees = c1212, "SH", 90.0
    return FastestShear(math.sqrt(best) * (math.sqrt(size) / math.sqrt(density)), polarisation, degrees, tied)


def _wave_components(stiffness: Stiffness) -> tuple[float, float, float, float, float, float]:
    """C1111, C3333, C1133, C2323, C1212 over a power of two [Pa] that stands last, of a solid with waves."""
    six = stiffness.components
    if not stiffness.is_positive_definite():
        raise TensorNotPositive(f"stiffness with components {six}", allowed="needed: positive definite",
                                remedy="Check the components: some strain would cost no energy.")
    size = size_of(six.values())
    return (six["C1111"] / size, six["C3333"] / size, six["C1133"] / size, six["C2323"] / size,
            six["C1212"] / size, size)


def require_density(name: str, density: float) -> None:
    """Refuse a density that no body has.

    Parameters
    ----------
    name : str
        What it is, for the message.
    density : float
        Mass density [kg/m^3].

    Raises
    ------
    DensityOutOfRange
        It is not positive and finite.

    Notes
    -----
    Source: a speed is the root of a stiffness over a density.
    """
    if not 0 < density < math.inf:
        raise DensityOutOfRange(f"{name} = {density!r} kg/m^3", allowed="allowed 0 < density < inf",
                                remedy=f"Give the {name} in kg/m^3.")


def _squares(degrees: float) -> tuple[float, float]:
    """Squares of sine and cosine, each to its last digit near either axis and exact on both."""
    if not math.isfinite(degrees):
        raise DirectionNotValid(f"angle of {degrees!r} degrees", allowed="needed: a finite number",
                                remedy="Give the angle from axis 3 in degrees.")
    folded = abs(math.fmod(degrees, 180.0))
    acute = min(folded, 180.0 - folded)
    return math.sin(math.radians(acute)) ** 2, math.sin(math.radians(90.0 - acute)) ** 2
