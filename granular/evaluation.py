"""Evaluate a scene: the stiffness with its evidence."""

from __future__ import annotations

import sys
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from granular.axial_scene import AXIS_3, Axis
from granular.contact_law import reference_stiffness
from granular.effects.bound import Simulated
from granular.elasticity import Stiffness
from granular.error_budget import COARSE, COARSE_SHARE, with_left_out
from granular.errors import AxisNeeded, ResultOutOfRange
from granular.hypothesis import Hypothesis
from granular.number_of_contacts import PER_CUBIC_METRE, PER_DIAMETER_CUBED, contacts_per_volume
from granular.planning import Plan, plan
from granular.routes.catalogue import ROUTES
from granular.routes.result import COMPONENTS, Six

if TYPE_CHECKING:
    from granular.effects.forms import GeneralSimulated
    from granular.engineering import EngineeringConstants
    from granular.general import Symmetry
    from granular.general.engineering import GeneralEngineering
    from granular.general.waves import GeneralWaves
    from granular.ratios import Ratio
    from granular.routes.work import Work
    from granular.scene import Scene
    from granular.waves import Waves

LEAST_DISTANCE = 1e-9
"""Distance to a class of symmetry over the norm that counts as belonging to it, however accurate a stiffness is [-]."""


@dataclass(frozen=True, slots=True)
class Evaluation:
    """A stiffness and the evidence for it.

    Attributes
    ----------
    stiffness : Stiffness
        Stiffness of the assembly in the frame of the scene [Pa].
    about_axis : Stiffness or None
        The same in a frame whose axis 3 is the axis of symmetry of the scene [Pa]; None where it has none.
    normalised_six : tuple of 6 float or None
        Six components about the axis over ``reference_stiffness`` [-]; None where there is none.
    relative_error : float
        Error of the worst component with what was left out for a wanted accuracy [-]: relative to that component for a
        scene about axis 3, relative to the largest entry of the Mandel matrix for any other.
    route_error : float
        Share of ``relative_error`` that the route has, with the tie of C1212 to C1111 and C1122 [-]; before turning.
    rule : str
        The route, or where that is ``sphere`` without an axis, the rule that it took.
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
    about_axis: Stiffness | None
    normalised_six: Six | None
    relative_error: float
    route_error: float
    rule: str
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
    def axis(self) -> Axis | None:
        """Axis of symmetry [-], a unit vector; None where fabric and stress share none."""
        return self.plan.axis

    @property
    def error_is(self) -> str:
        """"bound", or "estimate" where rules over the sphere were compared."""
        return self.plan.error_is

    @property
    def normalised(self) -> Six:
        """C1111, C3333, C1122, C1133, C2323, C1212 about the axis over ``reference_stiffness`` [-]."""
        if self.normalised_six is None:
            raise AxisNeeded("a stiffness without an axis", allowed="allowed six components only where there is one",
                             remedy="Use stiffness.mandel(), over reference_stiffness.")
        return self.normalised_six

    @property
    def ratios(self) -> tuple[Ratio, ...]:
        """C1111/C3333 and C2323/C1212 about the axis [-], exact where they are rational; none without an axis."""
        from granular.ratios import ratios

        if self.about_axis is None:
            return ()
        return ratios(self.about_axis, fabric=self.plan.fabric, poisson_ratio=self.plan.poisson_ratio,
                      hypothesis=self.hypothesis, equal_contacts=self.plan.loading is None)

    @property
    def symmetry(self) -> Symmetry:
        """Class of symmetry with its axis or frame, and the distance to every class [-]."""
        from granular.general import classify

        return classify(self.stiffness.rows, tolerance=max(LEAST_DISTANCE, 10 * min(self.relative_error, 0.01)))

    @property
    def engineering(self) -> EngineeringConstants:
        """Young's moduli, Poisson's ratios and shear moduli of the assembly about axis 3 [Pa], [-]."""
        from granular.engineering import engineering_constants

        return engineering_constants(self._about_axis_3())

    @property
    def general_engineering(self) -> GeneralEngineering:
        """Moduli along the coordinate axes and their extremes over all directions, with an axis or not [Pa], [-]."""
        from granular.general.engineering import general_engineering

        return general_engineering(self.stiffness)

    @property
    def shear_with_free_spin(self) -> float | None:
        """C2323 [Pa] if each grain spun until it carried no net couple.

        None for spheres, and where that is simulated already or means nothing (static hypothesis).
        """
        if self.hypothesis is Hypothesis.STATIC or self.axis != AXIS_3:
            return None
        fabric = self.plan.fabric
        if fabric.aspect_ratio == 1.0 or fabric.free_spin:
            return None
        spun = ROUTES[self.route].evaluate(replace(fabric, free_spin=True), poisson_ratio=self.plan.poisson_ratio,
                                           hypothesis=self.hypothesis, loading=self.plan.loading)
        return spun.components[COMPONENTS.index("C2323")] * self.reference_stiffness

    @property
    def waves(self) -> Waves | None:
        """Wave speeds of the dry assembly about axis 3 [m/s]; None when the scene gives no density of the grains."""
        if self.density is None:
            return None
        from granular.waves import waves

        return waves(self._about_axis_3(), density=self.density)

    @property
    def general_waves(self) -> GeneralWaves | None:
        """Wave speeds of the dry assembly with an axis or without [m/s]; None without a density of the grains."""
        if self.density is None:
            return None
        from granular.general.waves import general_waves

        return general_waves(self.stiffness, density=self.density)

    def _about_axis_3(self) -> Stiffness:
        """The stiffness, where the vertical is its axis."""
        if self.axis != AXIS_3:
            raise AxisNeeded("a stiffness that is not symmetric about axis 3", allowed="allowed only axis 3 there",
                             remedy="Use general_engineering and general_waves.")
        return self.stiffness


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
    Accuracy: every component to ``relative_error`` of itself for a scene about axis 3, otherwise of the largest entry
    of the Mandel matrix. It holds the route's bound (an estimate by rules over the sphere without an axis, see
    ``error_is``), that of the branch lengths of graded grains, the roundings, and the bounds of effects that were left
    out for ``rtol``. Source: eqs (1)-(23).

    Examples
    --------
    >>> from granular.scene import Scene
    >>> scene = Scene(grains={"shear_modulus": "31 GPa", "poisson_ratio": 0.21},
    ...               packing={"void_ratio": 0.5744}, stress={"mean": "28 kPa"})
    >>> f"{evaluate(scene).stiffness.C1111 / 1e6:.1f} MPa"
    '556.8 MPa'
    """
    decided = plan(scene, rtol=rtol, route=route)
    coordination, lengths = scene.packing.coordination, decided.lengths
    reference = reference_stiffness(
        scene.grains.shear_modulus, decided.poisson_ratio, mean_stress=scene.stress.mean_stress,
        void_ratio=scene.packing.void_ratio, coordination_number=coordination, length_ratio=scene.length_ratio)
    factor = 1.0
    if lengths is not None:
        reference *= lengths.second
        if decided.hypothesis is Hypothesis.STATIC:  # 1/<l^-2> in place of <l^2>
            factor = 1 / (lengths.second * lengths.inverse_second)
    model = decided.selection.model
    found = (_about_axis(decided, model, reference, factor) if isinstance(model, Simulated)
             else _by_tensors(decided, model, reference, factor))
    return Evaluation(
        stiffness=found.stiffness, about_axis=found.about_axis, normalised_six=found.six,
        relative_error=decided.turning.outside(with_left_out(found.error + decided.scaling_error,
                                                             decided.left_out_error)),
        route_error=found.error, rule=found.rule, reference_stiffness=reference, evaluations=found.evaluations,
        work=found.work, contacts_per_volume=contacts_per_volume(
            scene.packing.void_ratio, coordination,
            grain_diameter=1.0 if lengths is None else lengths.equal_volume_diameter),
        contacts_per_volume_unit=PER_DIAMETER_CUBED if lengths is None else PER_CUBIC_METRE,
        density=_bulk_density(scene), plan=decided)


@dataclass(frozen=True, slots=True, kw_only=True)
class _Found:
    """What a route has found, in pascals; the fields mean what they mean in Evaluation."""

    stiffness: Stiffness
    about_axis: Stiffness | None
    six: Six | None
    error: float
    rule: str
    evaluations: int
    work: Work | None


def _about_axis(decided: Plan, model: Simulated, reference: float, factor: float) -> _Found:
    """Compute six components about the axis, and turn them into the frame of the scene."""
    result = ROUTES[decided.route].evaluate(
        model.fabric, poisson_ratio=model.poisson_ratio, hypothesis=model.hypothesis, loading=model.loading,
        rtol=decided.route_rtol)
    components, error = result.components, result.relative_error
    if not ROUTES[decided.route].keeps_axis:
        components, error = _axially_tied(components, error)
    if factor != 1.0:
        components = _times(components, factor)
    about = Stiffness.transversely_isotropic(*_in_pascals(components, reference, decided))
    stiffness = about
    if decided.axis is not None and decided.axis != AXIS_3:
        from granular.general.axis import rotation_to

        stiffness = about.rotated(rotation_to(decided.axis))
    return _Found(stiffness=stiffness, about_axis=about, six=components, error=error, rule=decided.route,
                  evaluations=result.evaluations, work=result.work)


def _by_tensors(decided: Plan, model: GeneralSimulated, reference: float, factor: float) -> _Found:
    """Compute all 21 constants."""
    from granular.general.routes import GENERAL_ROUTES

    result = GENERAL_ROUTES[decided.route].evaluate(
        model.fabric, poisson_ratio=model.poisson_ratio, hypothesis=model.hypothesis, loading=model.loading,
        rtol=decided.route_rtol)
    largest = max(max(row) for row in result.rows) * factor
    _require_in_range("largest component", largest, largest * reference, reference)
    return _Found(stiffness=Stiffness.from_mandel([[value * factor * reference for value in row]
                                                   for row in result.rows]),
                  about_axis=None, six=None, error=result.relative_error, rule=result.route,
                  evaluations=result.evaluations, work=None)


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
    for name, normalised, value in zip(COMPONENTS, components, six, strict=True):
        if not (decided.poisson_ratio == 0.0 and name in ("C1122", "C1133")):  # these two vanish then
            _require_in_range(name, normalised, value, reference)
    return six


def _require_in_range(name: str, normalised: float, value: float, reference: float) -> None:
    smallest, largest = sys.float_info.min, sys.float_info.max
    if not (normalised >= smallest and smallest <= value <= largest):
        raise ResultOutOfRange(f"{name} = {normalised!r} x {reference!r} Pa",
                               allowed=f"allowed {smallest:.3g} to {largest:.3g} Pa",
                               remedy="Check the units of shear_modulus and mean stress.")


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
