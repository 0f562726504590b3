"""The solid of the grains, and the stiffness that Hertz and Mindlin give a contact of known force."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from granular.contact_law import stiffness_ratio
from granular.errors import ConflictingKeys, ValueOutOfRange

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from granular.contacts.block import ContactBlock

    Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, kw_only=True)
class Material:
    """What is known of the grains; nothing of it is needed for a list that has kn and ks.

    Parameters
    ----------
    shear_modulus : float or None
        Gs [Pa], > 0.
    poisson_ratio : float or None
        nu [-], 0 to 0.5.
    friction : float or None
        Friction coefficient mu between grains [-], >= 0.

    Raises
    ------
    ValueOutOfRange
        A value outside its range.
    ConflictingKeys
        Shear modulus without Poisson's ratio, or the reverse.
    """

    shear_modulus: float | None = None
    poisson_ratio: float | None = None
    friction: float | None = None

    def __post_init__(self) -> None:
        for name, value, least, most in (("shear_modulus", self.shear_modulus, 0.0, math.inf),
                                         ("poisson_ratio", self.poisson_ratio, 0.0, 0.5),
                                         ("friction", self.friction, 0.0, math.inf)):
            if value is not None and not (least <= value <= most and math.isfinite(value)):
                raise ValueOutOfRange(f"{name} = {value!r}", allowed=f"allowed {least:g} <= {name} <= {most:g}",
                                      remedy=f"Give {name} in SI units inside that range.")
        if self.shear_modulus == 0.0:
            raise ValueOutOfRange("shear_modulus = 0.0", allowed="allowed shear_modulus > 0", remedy="Give it in Pa.")
        if (self.shear_modulus is None) != (self.poisson_ratio is None):
            raise ConflictingKeys("one of shear_modulus and poisson_ratio is given without the other",
                                  allowed="allowed both or none", remedy="Give both, such as --shear-modulus 29e9 "
                                  "--poisson-ratio 0.2.")

    @property
    def elastic(self) -> tuple[float, float] | None:
        """Gs [Pa] and nu [-], where they are given."""
        if self.shear_modulus is None or self.poisson_ratio is None:
            return None
        return self.shear_modulus, self.poisson_ratio

    def stiffness(self, block: ContactBlock) -> tuple[Array, Array] | None:
        """Contact stiffnesses from contact forces.

        Parameters
        ----------
        block : ContactBlock
            Contacts with normal force; with shear force if friction is to reduce their shear stiffness.

        Returns
        -------
        kn, ks : (n,) array
            Normal and shear stiffness [N/m]; None where force or elasticity are not given.

        Notes
        -----
        R_e is R1 R2/(R1 + R2) where radii are given, else l/4. With friction the shear stiffness falls with the shear
        force and is zero where the contact slides. Accuracy: a few units in the last place. Source: eqs (20) and (21).
        """
        import numpy as np

        if self.elastic is None or block.normal_force is None:
            return None
        shear_modulus, poisson_ratio = self.elastic
        if block.radii is None:
            radius = np.sqrt(np.sum(block.branch**2, axis=0)) / 4
        else:
            radius = block.radii[0] * block.radii[1] / block.radii.sum(axis=0)
        kn = np.cbrt(3 * (shear_modulus / (1 - poisson_ratio)) ** 2 * 2 * radius * block.normal_force)
        ks = stiffness_ratio(poisson_ratio) * kn
        if self.friction is not None and block.shear_force is not None:
            shear, limit = np.sqrt(np.sum(block.shear_force**2, axis=0)), self.friction * block.normal_force
            with np.errstate(divide="ignore", invalid="ignore"):
                ks = ks * np.cbrt(np.where(shear < limit, 1 - shear / limit, 0.0))
        return kn, ks
