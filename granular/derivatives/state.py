"""A scene as the arguments of ``axial_stiffness`` and the factor to pascals, for slopes and fits."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from granular.errors import SlopesNotBuilt
from granular.hypothesis import Hypothesis

if TYPE_CHECKING:
    from granular.scene import Scene


@dataclass(frozen=True, slots=True, kw_only=True)
class AxialState:
    """What the axial model needs of a scene.

    Attributes
    ----------
    D33, Dr33 : float
        P2 coefficients of contact normals and branch lengths [-].
    stress_ratio : float
        sigma33/sigma11 [-], > 0.
    friction : float or None
        Friction coefficient between grains [-]; None for contacts that never slip.
    poisson_ratio : float
        Of the grain material [-].
    kinetic : bool
        Whether contact stiffness follows the contact force.
    hypothesis : Hypothesis
        Kinematic or static.
    factor : float
        Pascals for one unit of the normalised components [Pa].
    """

    D33: float
    Dr33: float
    stress_ratio: float
    friction: float | None
    poisson_ratio: float
    kinetic: bool
    hypothesis: Hypothesis
    factor: float

    @property
    def corner(self) -> bool:
        """Whether friction meets equal forces in all directions, where slopes have a jump."""
        from granular.loading import Loading

        if not self.kinetic or self.friction is None:
            return False
        a, c = Loading.of_ratio(self.stress_ratio).coefficients(self.D33)
        return a == c


def axial_state(scene: Scene) -> AxialState:
    """Read a scene for slopes: its own list of effects, or with "auto" all that could matter beside it.

    Parameters
    ----------
    scene : Scene
        Assembly, stress and model, symmetric about axis 3.

    Returns
    -------
    AxialState
        Arguments and factor.

    Raises
    ------
    SlopesNotBuilt
        A shape, a rank-four density, a stress without compression along or across axis 3, or a tensor that is not
        symmetric about axis 3.
    GranularError
        As ``granular.planning.plan``.

    Notes
    -----
    Under "auto" contact forces count even where the scene itself has equal ones, because a fabric or stress beside it
    has not. Source: effects as in ``granular.effects``, reference stiffness as in eqs (8), (9) and (20).
    """
    from granular.contact_law import reference_stiffness
    from granular.planning import plan

    _require_axial_model(scene)
    decided = plan(scene)
    sigma11, sigma33 = scene.stress.principal
    if scene.model.effects == "auto":
        fabric, kinetic, friction = scene.fabric, True, scene.grains.friction
    else:
        fabric, loading = decided.fabric, decided.loading
        kinetic, friction = loading is not None, None if loading is None else loading.friction
    factor = reference_stiffness(
        scene.grains.shear_modulus, scene.grains.poisson_ratio, mean_stress=scene.stress.mean_stress,
        void_ratio=scene.packing.void_ratio, coordination_number=scene.packing.coordination,
        length_ratio=scene.length_ratio)
    if decided.lengths is not None:
        static = decided.hypothesis is Hypothesis.STATIC  # 1/<l^-2> in place of <l^2>
        factor *= 1 / decided.lengths.inverse_second if static else decided.lengths.second
    return AxialState(
        D33=fabric.D33, Dr33=fabric.Dr33, stress_ratio=float(sigma33 / sigma11), friction=friction,
        poisson_ratio=scene.grains.poisson_ratio, kinetic=kinetic, hypothesis=decided.hypothesis, factor=factor)


def _require_axial_model(scene: Scene) -> None:
    """Refuse what the axial model of rank two does not hold."""
    reason = None
    if scene.shape is not None:
        reason = "a shape", "Delete [shape], or describe the branches by anisotropy."
    elif not scene.axial:
        reason = "a tensor that is not symmetric about axis 3", "Turn the scene until axis 3 is its axis."
    elif scene.fabric.D3333 != 0:
        reason = f"D3333 = {scene.fabric.D3333!r}", "Delete D3333."
    else:
        sigma11, sigma33 = scene.stress.principal
        if sigma11 <= 0 or sigma33 <= 0:
            reason = "a stress that does not compress along and across axis 3", "Give two compressive stresses."
    if reason is not None:
        raise SlopesNotBuilt(f"a scene with {reason[0]}",
                             allowed="allowed spheres with fabric and branches of rank two about axis 3, under "
                             "compression, where slopes are wanted", remedy=reason[1])
