"""The stiffness of a scene from contacts drawn at random: points where grains touch, lengths and forces.

Nothing is shared with the routes: contacts are points of the surface of a spheroid, drawn evenly over a sphere that is
then stretched, the branch is twice the vector to that point, lengths are drawn, and every contact has the force of
eq. (23) and the stiffness of eqs (20) and (21).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from granular.checks.sampled_contacts import Contacts, Estimate, estimate
from granular.hypothesis import Hypothesis

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from granular.checks.sampled_lengths import LengthTable
    from granular.planning import Plan
    from granular.scene import Scene

    Array = NDArray[np.float64]


def sampled_stiffness(scene: Scene, *, seed: int) -> Estimate:
    """Estimate the stiffness of a scene by eq. (1).

    Parameters
    ----------
    scene : Scene
        Assembly, stress and wanted model; no [branches].
    seed : int
        Start of the random numbers.

    Returns
    -------
    Estimate
        C1111, C3333, C1122, C1133, C2323, C1212 and their standard errors [Pa].

    Notes
    -----
    Accuracy: the standard errors; about 0.2 % of a component. Source: eqs (1), (8)-(17), (20)-(23).
    """
    from granular.planning import plan

    decided = plan(scene)
    table = _table(decided)
    per_volume = contacts_per_volume(scene, table)
    found = estimate(drawing(scene, decided, table, per_volume, seed=seed), hypothesis=decided.hypothesis,
                     free_spin=decided.fabric.free_spin)
    return Estimate(tuple(per_volume * value for value in found.components),
                    tuple(per_volume * error for error in found.standard_errors))


def contacts_per_volume(scene: Scene, table: LengthTable | None) -> float:
    """Contacts per volume, M/V of eqs (8)-(11).

    Parameters
    ----------
    scene : Scene
        Void ratio and coordination number.
    table : LengthTable or None
        Grain sizes; None for grains of radius 1 m.

    Returns
    -------
    float
        M/V [1/m^3].

    Notes
    -----
    Accuracy: that of the table. Source: eqs (8)-(11); two grains share a contact.
    """
    mean_cube = 1.0 if table is None else table.mean_cube
    grains = 1 / ((1 + scene.packing.void_ratio) * 4 / 3 * math.pi * mean_cube)
    return grains * scene.packing.coordination / 2


def drawing(scene: Scene, decided: Plan, table: LengthTable | None, per_volume: float,
            *, seed: int) -> Callable[[int], Contacts]:
    """Make a function that draws contacts of a scene.

    Parameters
    ----------
    scene : Scene
        Solid and mean stress.
    decided : Plan
        Fabric and loading that are simulated.
    table : LengthTable or None
        Branch lengths; None for grains of radius 1 m.
    per_volume : float
        M/V [1/m^3].
    seed : int
        Start of the random numbers.

    Returns
    -------
    callable
        From a number of contacts to contacts in metres and newtons.

    Notes
    -----
    The point M u of a spheroid has its normal along M^-1 u. Evenly drawn u give normals with the density
    det M abs(M^-1 u)^3/(4 pi), which the weights turn into E(n). Accuracy: exact but for rounding. Source: eqs (1),
    (14) and (20)-(23).
    """
    import numpy as np

    rng = np.random.default_rng(seed)
    fabric = decided.fabric
    equator = fabric.aspect_ratio ** (-1 / 3)  # with the volume of a sphere of radius 1, so that det M = 1
    axes = np.array([[equator], [equator], [equator * fabric.aspect_ratio]])
    springs = _Springs.of(scene, decided, per_volume)

    def draw(count: int) -> Contacts:
        u = rng.standard_normal((3, count))
        u /= np.sqrt(np.sum(u * u, axis=0))
        outwards = u / axes
        steepness = np.sqrt(np.sum(outwards**2, axis=0))
        normal = outwards / steepness
        x2 = normal[2] ** 2
        weight = (1 + fabric.D33 * (3 * x2 - 1) / 2 + fabric.D3333 * (35 * x2**2 - 30 * x2 + 3) / 8) / steepness**3
        size = np.full(count, 2.0)
        if table is not None:
            size, made_good = table.draw(rng, count, leaning=1.0 if springs.stiff else -1.0)
            weight = weight * made_good
        branch = size * axes * u
        return Contacts(weight, normal, branch, *springs.at(normal, np.sqrt(np.sum(branch**2, axis=0))))

    return draw


def _table(decided: Plan) -> LengthTable | None:
    if decided.sizes is None:
        return None
    from granular.checks.sampled_lengths import length_table

    return length_table(decided.sizes)


@dataclass(frozen=True, slots=True)
class _Springs:
    """What the stress and the solid make of a contact: eqs (20)-(23)."""

    force_by_normal: Array
    contact_modulus: float
    shear_share: float
    friction: float | None
    stiff: bool

    @classmethod
    def of(cls, scene: Scene, decided: Plan, per_volume: float) -> _Springs:
        """Principal forces for a branch of one metre, sigma A/(M/V) with A the inverse of N, and material numbers."""
        import numpy as np

        loading, d33, pressure = decided.loading, decided.fabric.D33, scene.stress.mean_stress
        stresses, normals = np.full(3, pressure), np.full(3, 1 / 3)
        if loading is not None:
            scale = pressure / float(loading.mean)
            stresses = scale * np.array([float(loading.sigma11), float(loading.sigma11), float(loading.sigma33)])
            normals = 1 / 3 + 2 / 15 * d33 * np.array([-1 / 2, -1 / 2, 1])
        nu = scene.grains.poisson_ratio
        return cls(force_by_normal=(stresses / normals / per_volume)[:, None],
                   contact_modulus=scene.grains.shear_modulus / (1 - nu), shear_share=2 * (1 - nu) / (2 - nu),
                   friction=None if loading is None else loading.friction,
                   stiff=decided.hypothesis is Hypothesis.KINEMATIC)

    def at(self, normal: Array, length: Array) -> tuple[Array, Array]:
        """k_n and k_r [N/m] of contacts with these normals and branch lengths [m]."""
        import numpy as np

        force = self.force_by_normal * normal / length
        pressing = np.sum(force * normal, axis=0)
        sideways = np.sqrt(np.sum((force - pressing * normal) ** 2, axis=0))
        pressing = np.maximum(pressing, 0.0)
        radius = length / 4
        k_n = np.cbrt(3 * self.contact_modulus**2 * 2 * radius * pressing)
        if self.friction is None:
            return k_n, self.shear_share * k_n
        with np.errstate(divide="ignore", invalid="ignore"):
            left = np.where(pressing > 0, 1 - sideways / (pressing * self.friction), 0.0)
        return k_n, self.shear_share * np.cbrt(np.maximum(left, 0.0)) * k_n
