"""Evaluate a scene: the stiffness with its evidence."""

from __future__ import annotations

import sys
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from granular.contact_law import reference_stiffness
from granular.elasticity import Stiffness
from granular.errors import ResultOutOfRange
from granular.hypothesis import Hypothesis
from granular.number_of_contacts import PER_CUBIC_METRE, PER_DIAMETER_CUBED, contacts_per_volume
from granular.planning import COARSE, COARSE_SHARE, Plan, plan, with_left_out
from granular.routes.catalogue import ROUTES
from granular.routes.result import COMPONENTS, Six

if TYPE_CHECKING:
    from granular.engineering import EngineeringConstants
    from granular.ratios import Ratio
    from granular.routes.work import Work
    from granular.scene import Scene
    from granular.waves import Waves


@dataclass(frozen=True, slots=True)
class Evaluation:
    """A stiffness and the evidence for it.

    Attributes
    ----------
    stiffness : Stiffness
        Stiffness of the assembly [Pa].
    normalised : tuple of 6 float
        C1111, C3333, C1122, C1133, C2323, C1212 over ``reference_stiffness`` [-].
    relative_error : float
        Bound for the worst component, relative to that component, with what was left out for a wanted accuracy [-].
    route_error : float
        Share of ``relative_error`` that the route has, with the tie of C1212 to C1111 and C1122 [-].
    reference_stiffness : float
        (M/V) l_e^2 k_n,ref [Pa]; for graded grains l_e^2 is the mean square of the branch lengths.
    evaluations : int
        Directions in which the integrand was evaluated [-]; 0 for a closed form.
    work : Work or None
        Operations and functions that the route took; None where they are not counted.
    contacts_per_volume : float
        M/V, in ``contacts_per_volume_unit``.
    contacts_per_volume_unit : str
        1/m^3 where grain sizes are simulated, else 1/(2 r_e)^3.
    density : float or None
        Bulk density of the dry assembly [kg/m^3]; None when the scene gives no density of the grains.
    plan : Plan
        What was decided beforehand, with reasons.
    """

    stiffness: Stiffness
    normalised: Six
    relative_error: float
    route_error: float
    reference_stiffness: float
    evaluations: int
    work: Work | None
    contacts_per_volume: float
    contacts_per_volume_unit: str
    density: float | None
    plan: Plan

    @property
    def hypothesis(self) -> Hypothesis:
        """Kinematic or static."""
        return self.plan.hypothesis

    @property
    def route(self) -> str:
        """The way it was computed."""
        return self.plan.route

    @property
    def effects_simulated(self) -> tuple[str, ...]:
        """What the stiffness carries."""
        return self.plan.effects_simulated

    @property
    def effects_not_called_for(self) -> dict[str, str]:
        """Effect -> why it is not simulated."""
        return self.plan.effects_not_called_for

    @property
    def ratios(self) -> tuple[Ratio, ...]:
        """C1111/C3333 and C2323/C1212 [-], exact where they are rational."""
        from granular.ratios import ratios

        return ratios(self.stiffness, fabric=self.plan.fabric, poisson_ratio=self.plan.poisson_ratio,
                      hypothesis=self.hypothesis, equal_contacts=self.plan.loading is None)

    @property
    def engineering(self) -> EngineeringConstants:
        """Young's moduli, Poisson's ratios and shear moduli of the assembly [Pa], [-]."""
        from granular.engineering import engineering_constants

        return engineering_constants(self.stiffness)

    @property
    def shear_with_free_spin(self) -> float | None:
        """C2323 [Pa] if each grain spun until it carried no net couple.

        None for spheres, and where that is simulated already or means nothing (static hypothesis).
        """
        fabric = self.plan.fabric
        if self.hypothesis is Hypothesis.STATIC or fabric.aspect_ratio == 1.0 or fabric.free_spin:
            return None
        spun = ROUTES[self.route].evaluate(replace(fabric, free_spin=True), poisson_ratio=self.plan.poisson_ratio,
                                           hypothesis=self.hypothesis, loading=self.plan.loading)
        return spun.components[COMPONENTS.index("C2323")] * self.reference_stiffness

    @property
    def waves(self) -> Waves | None:
        """Wave speeds of the dry assembly [m/s]; None when the scene gives no density of the grains."""
        if self.density is None:
            return None
        from granular.waves import waves

        return waves(self.stiffness, density=self.density)


def evaluate(scene: Scene, *, rtol: float | None = None, route: str = "auto") -> Evaluation:
    """Compute the stiffness of a scene.

    Parameters
    ----------
    scene : Scene
        Assembly, stress and wanted model.
    rtol : float, optional
        Wanted relative accuracy of every component [-], inside (0, 1); by default the scene's own.
    route : str
        "auto", or the name of a route.

    Returns
    -------
    Evaluation
        Stiffness [Pa], its error bound, route, effects and cost.

    Raises
    ------
    ConflictingKeys, MissingKey, ComplianceInfinite, RouteOutOfDomain, UnknownChoice, ValueOutOfRange, NotFinite,
    WrongType
        As ``granular.planning.plan``.
    ResultOutOfRange
        A component does not fit into double precision with all its digits.

    Notes
    -----
    Accuracy: every component to ``relative_error`` of itself; the route's bound, that of the branch lengths of graded
    grains, the roundings, and the bounds of effects that were left out for ``rtol``. Source: eqs (1)-(23).

    Examples
    --------
    >>> from granular.scene import Scene
    >>> scene = Scene(grains={"shear_modulus": "31 GPa", "poisson_ratio": 0.21},
    ...               packing={"void_ratio": 0.5744}, stress={"mean": "28 kPa"})
    >>> f"{evaluate(scene).stiffness.C1111 / 1e6:.1f} MPa"
    '556.8 MPa'
    """
    decided = plan(scene, rtol=rtol, route=route)
    result = ROUTES[decided.route].evaluate(
        decided.fabric, poisson_ratio=decided.poisson_ratio, hypothesis=decided.hypothesis, loading=decided.loading,
        rtol=decided.route_rtol)
    components, error = result.components, result.relative_error
    if not ROUTES[decided.route].keeps_axis:
        components, error = _axially_tied(components, error)
    coordination, lengths = scene.packing.coordination, decided.lengths
    reference = reference_stiffness(
        scene.grains.shear_modulus, decided.poisson_ratio, mean_stress=scene.stress.mean_stress,
        void_ratio=scene.packing.void_ratio, coordination_number=coordination, length_ratio=scene.length_ratio)
    if lengths is not None:
        reference *= lengths.second
        if decided.hypothesis is Hypothesis.STATIC:  # 1/<l^-2> in place of <l^2>
            components = _times(components, 1 / (lengths.second * lengths.inverse_second))
    return Evaluation(
        stiffness=Stiffness.transversely_isotropic(*_in_pascals(components, reference, decided)),
        normalised=components, relative_error=with_left_out(error + decided.scaling_error, decided.left_out_error),
        route_error=error, reference_stiffness=reference, evaluations=result.evaluations, work=result.work,
        contacts_per_volume=contacts_per_volume(
            scene.packing.void_ratio, coordination,
            grain_diameter=1.0 if lengths is None else lengths.equal_volume_diameter),
        contacts_per_volume_unit=PER_DIAMETER_CUBED if lengths is None else PER_CUBIC_METRE,
        density=_bulk_density(scene), plan=decided)


def _axially_tied(components: Six, error: float) -> tuple[Six, float]:
    """Make C1212 follow from C1111 and C1122 where a coarse rule has not kept that, and widen the bound for it."""
    c1111, c3333, c1122, c1133, c2323, _ = components
    if error <= COARSE_SHARE * COARSE:
        return components, error
    shear = (c1111 - c1122) / 2
    return (c1111, c3333, c1122, c1133, c2323, shear), error * (c1111 + c1122) / (c1111 - c1122)


def _times(components: Six, factor: float) -> Six:
    c1111, c3333, c1122, c1133, c2323, c1212 = (component * factor for component in components)
    return c1111, c3333, c1122, c1133, c2323, c1212


def _in_pascals(components: Six, reference: float, decided: Plan) -> Six:
    """Scale, and refuse what double precision cannot hold: neither infinity nor lost digits pass for a result."""
    c1111, c3333, c1122, c1133, c2323, c1212 = (component * reference for component in components)
    six = c1111, c3333, c1122, c1133, c2323, c1212
    smallest, largest = sys.float_info.min, sys.float_info.max
    for name, normalised, value in zip(COMPONENTS, components, six, strict=True):
        vanishes = decided.poisson_ratio == 0.0 and name in ("C1122", "C1133")
        if not (vanishes or (normalised >= smallest and smallest <= value <= largest)):
            raise ResultOutOfRange(f"{name} = {normalised!r} x {reference!r} Pa",
                                   allowed=f"allowed {smallest:.3g} to {largest:.3g} Pa",
                                   remedy="Check the units of shear_modulus and mean stress.")
    return six


def _bulk_density(scene: Scene) -> float | None:
    if scene.grains.density is None:
        return None
    from granular.waves import bulk_density

    density = bulk_density(scene.grains.density, scene.packing.void_ratio)
    if density < sys.float_info.min:
        raise ResultOutOfRange(f"density of the assembly = {density!r} kg/m^3",
                               allowed=f"allowed from {sys.float_info.min:.3g} kg/m^3",
                               remedy="Check the unit of density.")
    return density
