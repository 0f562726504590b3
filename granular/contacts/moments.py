"""Sums over a contact list that make its fabric, its stress and its stiffness, block by block."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from granular.contacts.kernels import PairSums, products

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from granular.contacts.block import ContactBlock

    Array = NDArray[np.float64]

SLIDING = 0.999
"""Share of the Coulomb limit from which a contact counts as sliding [-]."""

NORMALS, BRANCHES = DIRECTIONS = ("normals", "branches")
"""Directions that a fabric may be that of."""


class Moments:
    """Everything that a sum over the contacts gives, from one reading of the list.

    Attributes
    ----------
    contacts : int
        M [-].
    normals, branches : (6,) array
        Sums of n_i n_j, and of the same for unit branches [-], in the order 11 22 33 23 13 12.
    mixed : (3, 3) array
        Sum of l_i n_k/l [-]: what balances the stress with the force estimate.
    lengths : dict
        Sums of l [m], l^2 [m^2], l^-2 [1/m^2], and of P2, P2^2 [-] and l P2 [m] once with the angle of the normal from
        axis 3 and once with that of the branch.
    stress : (3, 3) array
        Sum of l_i f_j [N m].
    forces, shears : int
        Contacts with a normal force, and with a shear force [-].
    sliding : int
        Contacts that slide [-].
    kinematic, static : PairSums
        Sums of eq. (1) [N m], and of n_k n_m s_jl/l^2 [1/(N m)].
    stiff, flexible : int
        Contacts with a stiffness, and with a shear stiffness above zero [-].
    kn, ks : float
        Sums of the stiffnesses [N/m].
    kn_l2 : float
        Sum of kn l^2 [N m].
    least_radius : float
        Smallest radius of all [m]; infinite where the list has none.
    """

    def __init__(self, friction: float | None) -> None:
        """Begin at zero.

        Parameters
        ----------
        friction : float or None
            Friction coefficient [-], for contacts that slide.
        """
        import numpy as np

        self._friction, self.least_radius = friction, math.inf
        self.contacts = self.forces = self.shears = self.sliding = self.stiff = self.flexible = 0
        self.normals, self.branches = np.zeros(6), np.zeros(6)
        self.mixed, self.stress = np.zeros((3, 3)), np.zeros((3, 3))
        self.lengths = dict.fromkeys(("l", "l2", "inverse_l2", *(f"{name} of {of}" for of in DIRECTIONS for name in
                                                                 ("P2", "P2^2", "l P2"))), 0.0)
        self.kinematic, self.static = PairSums(), PairSums()
        self.kn = self.ks = self.kn_l2 = 0.0

    def add(self, block: ContactBlock, stiffness: tuple[Array, Array] | None) -> None:
        """Take some more contacts.

        Parameters
        ----------
        block : ContactBlock
            The contacts.
        stiffness : pair of (n,) array, or None
            kn and ks of each [N/m].

        Notes
        -----
        Accuracy: about 1e-15 of the sum of magnitudes. Source: eqs (1), (2), (5), (14), (23) and (24).
        """
        import numpy as np

        normal, branch = block.normal, block.branch
        squared = np.sum(branch**2, axis=0)
        length = np.sqrt(squared)
        self.contacts += block.size
        self.normals += products(normal).sum(axis=1)
        self.branches += products(branch / length).sum(axis=1)
        self.mixed += (branch / length) @ normal.T
        for name, values in (("l", length), ("l2", squared), ("inverse_l2", 1 / squared)):
            self.lengths[name] += float(values.sum())
        for of, cosine in zip(DIRECTIONS, (normal[2], branch[2] / length), strict=True):
            p2 = 1.5 * cosine**2 - 0.5
            for name, values in (("P2", p2), ("P2^2", p2**2), ("l P2", length * p2)):
                self.lengths[f"{name} of {of}"] += float(values.sum())
        if block.radii is not None:
            self.least_radius = min(self.least_radius, float(block.radii.min(initial=math.inf)))
        self._add_forces(block)
        if stiffness is None:
            return
        kn, ks = stiffness
        self.stiff += block.size
        self.kn += float(kn.sum())
        self.kn_l2 += float(kn @ squared)
        self.ks += float(ks.sum())
        self.kinematic.add(branch, normal, kn - ks, ks)
        some = (ks > 0) & (kn > 0)
        self.flexible += int(some.sum())
        if self.flexible == self.stiff:  # or the compliance is infinite anyway
            self.static.add(normal / length, normal, 1 / kn - 1 / ks, 1 / ks)

    def _add_forces(self, block: ContactBlock) -> None:
        import numpy as np

        force, shear = block.normal_force, block.shear_force
        if force is None:
            return
        self.forces += block.size
        self.stress += block.branch @ (force * block.normal).T
        if shear is None:
            return
        self.shears += block.size
        self.stress += block.branch @ shear.T
        if self._friction is not None:
            size = np.sqrt(np.sum(shear**2, axis=0))
            self.sliding += int((size >= SLIDING * self._friction * force).sum())
