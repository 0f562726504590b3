"""What the stress does to the contacts: principal stresses, friction, and the force estimate of eq. (23)."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction

from granular.errors import ComplianceInfinite, StressNotCompressive, ValueOutOfRange


@dataclass(frozen=True, slots=True, kw_only=True)
class Loading:
    """An axially symmetric stress on the contacts, and the friction that limits their shear force.

    A route that is given no loading takes all contacts as equally stiff.

    Parameters
    ----------
    sigma11, sigma33 : Fraction
        Principal stresses across and along axis 3 up to a common positive factor [-], compression positive; their
        mean (2 sigma11 + sigma33)/3 must be positive.
    friction : float or None
        Friction coefficient mu between grains [-], >= 0; None for contacts that never slip.

    Raises
    ------
    StressNotCompressive
        The mean stress is not positive.
    ValueOutOfRange
        The friction is negative or not finite.

    Notes
    -----
    Source: eqs (20)-(23).

    Examples
    --------
    >>> Loading.of_ratio(1.5, friction=0.2126).coefficients(0.0)
    (Fraction(6, 7), Fraction(9, 7))
    """

    sigma11: Fraction
    sigma33: Fraction
    friction: float | None = None

    def __post_init__(self) -> None:
        if self.mean <= 0:
            raise StressNotCompressive(
                f"mean stress = {float(self.mean):.6g} on the scale of the two principal stresses",
                allowed="allowed a mean stress above 0 (compression is positive)", remedy="Give a compressive stress.")
        if self.friction is not None and not (math.isfinite(self.friction) and self.friction >= 0):
            raise ValueOutOfRange(f"friction_coefficient = {self.friction!r}",
                                  allowed="allowed 0 <= friction_coefficient < inf",
                                  remedy="Give a coefficient in that range, or none for contacts that never slip.")

    @classmethod
    def of_ratio(cls, stress_ratio: float | Fraction, *, friction: float | None = None) -> Loading:
        """Take the stress ratio sigma33/sigma11 [-] in place of two stresses."""
        return cls(sigma11=Fraction(1), sigma33=Fraction(stress_ratio), friction=friction)

    @property
    def mean(self) -> Fraction:
        """Mean stress on the scale of the two principal stresses [-]."""
        return (2 * self.sigma11 + self.sigma33) / 3

    def coefficients(self, D33: float | Fraction) -> tuple[Fraction, Fraction]:
        """Normal contact force at the equator and at the pole, over that of the isotropic assembly, for W = 1.

        Parameters
        ----------
        D33 : float or Fraction
            P2 coefficient of the contact-normal density [-]; D3333 does not enter the fabric tensor of rank two.

        Returns
        -------
        tuple of 2 Fraction
            a and c [-]: in the direction x = cos(beta), with s = 1 - x^2, the normal force is (a s + c x^2)/W and
            the shear force \\|c - a\\| x sqrt(s)/W, over 3 p V/(M l_e). Exact for the doubles given.

        Notes
        -----
        Source: eq. (23) with N11 = 1/3 - D33/15, N33 = 1/3 + 2 D33/15.
        """
        d33 = Fraction(D33)
        return 5 * self.sigma11 / (self.mean * (5 - d33)), 5 * self.sigma33 / (self.mean * (5 + 2 * d33))

    def tilt(self, D33: float | Fraction) -> Fraction | None:
        """Square of kappa = \\|c - a\\|/(2 mu sqrt(a c)), which decides whether contacts slide [-].

        Returns
        -------
        Fraction or None
            Below 1 every contact sticks, at 1 one direction is just about to slide, above 1 some slide. 0 without
            friction data or shear force. None where it has no value: without friction (mu = 0), or where a or c is
            not positive, contacts slide next to the direction in which the normal force vanishes.

        Notes
        -----
        Source: onset of sliding 4 a c mu^2 = (c - a)^2, eqs (21) and (23).
        """
        a, c = self.coefficients(D33)
        if self.friction is None or a == c:
            return Fraction(0)
        if self.friction == 0 or a <= 0 or c <= 0:
            return None
        return (c - a) ** 2 / (4 * a * c * Fraction(self.friction) ** 2)

    def slips(self, D33: float | Fraction) -> bool:
        """Whether friction takes anything from the shear stiffness: shear forces against it, or no friction at all."""
        if self.friction is None:
            return False
        a, c = self.coefficients(D33)
        return self.friction == 0 or a != c

    def opens(self) -> bool:
        """Whether contacts open in some directions: one of the principal stresses is a tension."""
        return self.sigma11 < 0 or self.sigma33 < 0

    def slides(self, D33: float | Fraction) -> bool:
        """Whether contacts slide, or have opened, over a range of directions, so that the compliance is infinite.

        Notes
        -----
        With equal forces in all directions contacts slide only without friction. Source: eqs (20) and (21).
        """
        if self.opens() or self.friction == 0:
            return True
        tilt = self.tilt(D33)
        return tilt is None or tilt > 1

    def require_finite_compliance(self, D33: float | Fraction) -> None:
        """Refuse a static evaluation with contacts that slide or have opened.

        Raises
        ------
        ComplianceInfinite
            The static compliance is infinite.

        Notes
        -----
        Source: Figure 1(b): the compliance averages 1/k_r, and k_r = 0 there.
        """
        if not self.slides(D33):
            return
        ratio = f"{float(self.sigma33 / self.sigma11):.6g}" if self.sigma11 else "inf"
        found, effect = ("have opened under a tension", "kinetic, with all that needs it,") if self.opens() else (
            f"slide (friction_coefficient = {self.friction!r}, D33 = {float(D33)!r}, stress ratio {ratio})", "slip")
        raise ComplianceInfinite(
            f"hypothesis = static with contacts that {found}",
            allowed="allowed only where every contact sticks: one that does not yields without limit to its share of "
            "the stress, so that the compliance is infinite",
            remedy=f'Leave the effect {effect} out, or use hypothesis = "kinematic".')
