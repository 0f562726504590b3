"""The fabric of a transversely isotropic assembly: contact normals and branch vectors about axis 3."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction

from granular.errors import ConflictingKeys, FabricOutOfRange

FLATTEST = 1e12
"""Aspect ratios, or their inverses, reach up to here: far beyond any grain, and nothing overflows yet."""


@dataclass(frozen=True, slots=True)
class AxialFabric:
    """Contact-normal density and branch vectors, axially symmetric about axis 3.

    ``E(n) = (1 + D33 P2(x) + D3333 P4(x)) / (4 pi)`` with ``x = cos(beta)``. Branch vectors either follow the contact
    normals, with the length ``W(n) = 1 + Dr33 P2(x)`` over l_e, or are those of aligned spheroids.

    Parameters
    ----------
    D33 : float
        P2 coefficient of the contact-normal density [-]; -1 <= D33 <= 2 when D3333 = 0.
    D3333 : float
        P4 coefficient of the contact-normal density [-]; E must not be negative in any direction.
    Dr33 : float
        P2 coefficient of the branch-length weight [-]; -1 < Dr33 < 2, so that every branch has a length.
    aspect_ratio : float
        b/a of aligned spheroids with b along axis 3 [-], inside (1e-12, 1e12); 1 for spheres. Their branch vector is
        l = 2 M^2 n/abs(M n) with M = diag(a, a, b), and l_e is twice the equal-volume radius.
    free_spin : bool
        Each grain spins until it carries no net couple; otherwise grains turn with the mean deformation. Means
        something under the kinematic hypothesis only.

    Raises
    ------
    FabricOutOfRange
        E would be negative, W or the aspect ratio would not be positive, or a value is not finite. The region is
        decided in exact rational arithmetic, so that its boundary belongs to it.
    ConflictingKeys
        A branch-length weight and a shape (or a spin) are both given.

    Notes
    -----
    Source: eq. (14) with the weight of Figure 5, and assumption (a) of the parametric study, with the rank-4
    term added; eqs (5) and (6) for spheroids. The admissible region is derived in ``derivations.fabric``, the branch
    vector in ``derivations.spheroid``.
    """

    D33: float = 0.0
    D3333: float = 0.0
    Dr33: float = 0.0
    aspect_ratio: float = 1.0
    free_spin: bool = False

    def __post_init__(self) -> None:
        for name in ("D33", "D3333", "Dr33", "aspect_ratio"):
            value = getattr(self, name)
            if not math.isfinite(value):
                raise FabricOutOfRange(f"{name} = {value}", allowed="a finite number is needed",
                                       remedy=f"Give {name} as a finite number.")
        self._require_positive_branches()
        self._require_positive_density()
        self._require_one_kind_of_branches()

    @property
    def collinear(self) -> bool:
        """Whether the stiffness is that of branch vectors along the contact normals between grains that do not spin."""
        return self.aspect_ratio == 1.0 and not self.free_spin

    def _require_one_kind_of_branches(self) -> None:
        if not 1 / FLATTEST < self.aspect_ratio < FLATTEST:
            raise FabricOutOfRange(f"aspect_ratio = {self.aspect_ratio!r}",
                                   allowed=f"allowed {1 / FLATTEST:g} < aspect_ratio < {FLATTEST:g}",
                                   remedy="Give b/a of the grains, with b along axis 3.")
        if self.Dr33 != 0.0 and not self.collinear:
            raise ConflictingKeys(f"Dr33 = {self.Dr33!r} is given with a shape",
                                  allowed="allowed one of the two (a shape has its own branch vectors)",
                                  remedy="Leave Dr33 or the shape out.")

    def _require_positive_branches(self) -> None:
        if not -1 < self.Dr33 < 2:
            raise FabricOutOfRange(f"Dr33 = {self.Dr33!r}",
                                   allowed="allowed -1 < Dr33 < 2 (the branch length would not be positive)",
                                   remedy="Give Dr33 strictly inside the interval.")

    def _require_positive_density(self) -> None:
        if self.D3333 == 0.0:
            if not -1 <= self.D33 <= 2:
                raise FabricOutOfRange(f"D33 = {self.D33!r}",
                                       allowed="allowed -1 <= D33 <= 2 (E(n) would be negative)",
                                       remedy="Give D33 inside the interval.")
            return
        equator, between, pole = self.density_coefficients()
        if equator < 0 or pole < 0 or (between < 0 and between**2 > 4 * equator * pole):
            raise FabricOutOfRange(
                f"D33 = {self.D33!r} with D3333 = {self.D3333!r}",
                allowed="allowed only where 1 + D33 P2(x) + D3333 P4(x) >= 0 for all x "
                f"(its least value would be {self._least_density():.6g})",
                remedy="Bring D3333 closer to zero, or D33 inside the region drawn on the book's fabric page.")

    def density_coefficients(self) -> tuple[Fraction, Fraction, Fraction]:
        """Coefficients of 4 pi E = e0 s^2 + e1 s x^2 + e2 x^4 with s = 1 - x^2 [-], exactly."""
        d, q = Fraction(self.D33), Fraction(self.D3333)
        return 1 - d / 2 + 3 * q / 8, 2 + d / 2 - 3 * q, 1 + d + q

    def _least_density(self) -> float:
        equator, between, pole = self.density_coefficients()
        curvature = equator - between + pole
        ends = [equator, pole]
        if curvature > 0 and 0 < (turn := (2 * equator - between) / (2 * curvature)) < 1:
            ends.append(equator * (1 - turn) ** 2 + between * turn * (1 - turn) + pole * turn**2)
        return float(min(ends))
