"""What an evaluation would do and why: effects, route, predicted cost and accuracy."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Literal

from granular.axial_scene import AXIS_3, Axis
from granular.effects.selection import Selection, model_of, select
from granular.error_budget import (
    COARSE,
    COARSE_SHARE,
    SCALING_ERROR,
    remaining,
    route_accuracy,
    scaling_error,
    with_left_out,
)
from granular.errors import ComplianceInfinite, ResultOutOfRange, RouteOutOfDomain, WrongType
from granular.fields import Number, chosen
from granular.gradation import length_moments
from granular.hypothesis import Hypothesis
from granular.routes.catalogue import AUTO, MOST_ACCURATE, ROUTES, WITHOUT_AXIS
from granular.routes.choice import Choice, choose_for
from granular.routes.result import Promise
from granular.turning import NOT_TURNED, Turning, turning_of
from granular.units import shown

if TYPE_CHECKING:
    from collections.abc import Collection

    from granular.fabric import AxialFabric
    from granular.general.routes import GeneralRoute
    from granular.gradation import LengthMoments, SizeDistribution
    from granular.loading import Loading
    from granular.routes.catalogue import Route
    from granular.routes.work import Work
    from granular.scene import Scene

WANTED = Number(above=0.0, below=1.0)
"""Interval of a wanted relative accuracy."""


@dataclass(frozen=True, slots=True)
class Plan:
    """What an evaluation would do.

    Attributes
    ----------
    hypothesis : Hypothesis
        Kinematic or static.
    route : str
        The way of computing.
    route_reason : str
        Why this one.
    effects_simulated : tuple of str
        What the stiffness will carry.
    called_for : dict
        Effect -> why it is simulated.
    effects_not_called_for : dict
        Effect -> why it is not.
    sizes : SizeDistribution or None
        Sizes of the grains; None when all are taken as equally large.
    lengths : LengthMoments or None
        What the sizes do to the branch lengths.
    poisson_ratio : float
        Poisson ratio of the solid [-].
    evaluations : int
        Predicted number of directions in which the integrand is evaluated [-]; about where ``error_is`` an estimate.
    relative_error : float
        Predicted error of the worst component, relative to that component about axis 3, or in any other frame to the
        largest entry of the Mandel matrix; with what was left out [-].
    rtol : float or None
        Wanted relative accuracy in the same sense [-].
    left_out_error : float
        Share of ``relative_error`` that comes from effects left out for ``rtol`` [-]; before turning.
    route_error, scaling_error : float
        Shares of it that come from the route and from the step to pascals [-]; before turning.
    axis : tuple of 3 float or None
        The axis of symmetry [-], a unit vector; None without one.
    turning : Turning
        What turning to axis 3 and back makes of the error.
    selection : Selection
        How the effects were chosen.
    asked_route : str
        "auto", or the route that was asked for.
    choice : Choice
        The route with its promise, beside the others that were looked at.
    """

    hypothesis: Hypothesis
    route: str
    route_reason: str
    effects_simulated: tuple[str, ...]
    called_for: dict[str, str]
    effects_not_called_for: dict[str, str]
    sizes: SizeDistribution | None
    lengths: LengthMoments | None
    poisson_ratio: float
    evaluations: int
    relative_error: float
    rtol: float | None
    left_out_error: float
    route_error: float
    scaling_error: float
    axis: Axis | None
    turning: Turning
    selection: Selection
    asked_route: str
    choice: Choice

    @property
    def fabric(self) -> AxialFabric:
        """What the simulated effects leave of the fabric, about the axis of the scene [-]; refused without one."""
        return self.selection.fabric

    @property
    def loading(self) -> Loading | None:
        """What the stress does to the contacts, about the axis; None when all are taken as equally stiff."""
        return self.selection.loading

    @property
    def error_is(self) -> Literal["bound", "estimate"]:
        """Whether the error is proved or estimated."""
        return self.choice.promise.error_is

    @property
    def of_each_component(self) -> bool:
        """Whether errors are relative to each component, rather than to the largest entry of the Mandel matrix."""
        return self.axis == AXIS_3

    @property
    def work(self) -> Work | None:
        """Operations and functions that the route takes; None where they are not counted."""
        return self.choice.promise.work

    @property
    def route_rtol(self) -> float | None:
        """Relative accuracy that the route is asked for [-]; None when none is wanted."""
        return route_accuracy(remaining(self.turning.inside(self.rtol), self.left_out_error), self.lengths,
                              keeps_axis=self.choice.route.keeps_axis)

    @property
    def bounds(self) -> dict[str, float]:
        """Effect that the scene calls for -> how much leaving it out changes any component, at most [-].

        Relative to each component about the axis, or without one to the largest entry of the Mandel matrix.
        """
        return self.selection.bounds

    @property
    def costs(self) -> dict[str, tuple[int, int] | None]:
        """Effect that the scene calls for -> evaluations with it and without it [-]; None where one is refused."""
        return {name: _cost(self, name) for name in self.selection.considered}


def plan(scene: Scene, *, rtol: float | None = None, route: str = "auto") -> Plan:
    """Decide how a scene is evaluated, without evaluating it.

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
    Plan
        Effects with reasons, hypothesis, route, predicted cost and accuracy.

    Raises
    ------
    ConflictingKeys, MissingKey
        The scene's list of effects contradicts itself, or lacks data.
    ComplianceInfinite
        The static hypothesis with contacts that slide or have opened.
    RouteOutOfDomain
        The route does not cover the scene, or cannot promise ``rtol``.
    UnknownChoice, ValueOutOfRange, NotFinite, WrongType
        A route or accuracy that does not exist, or no scene.

    Notes
    -----
    Source: a policy of this package; every route states its own domain and accuracy.

    Examples
    --------
    >>> from granular.scene import Scene
    >>> scene = Scene(grains={"shear_modulus": "31 GPa", "poisson_ratio": 0.21},
    ...               packing={"void_ratio": 0.5744}, stress={"mean": "28 kPa"})
    >>> plan(scene).route, plan(scene).evaluations
    ('closed_form', 0)
    """
    from granular.scene import Scene

    if not isinstance(scene, Scene):
        raise WrongType(f"scene = {shown(scene)}", allowed="allowed a Scene",
                        remedy="Read one with Scene.from_toml(path), or build one with Scene(...).")
    wanted = scene.model.rtol if rtol is None else WANTED.read(rtol, "rtol")
    name = chosen(route, ("auto", *ROUTES, *WITHOUT_AXIS), name="route")
    turning = NOT_TURNED if scene.axial or scene.axis is None else _turning(scene)
    inside = turning.inside(wanted)
    _require_room(wanted, inside, turning)
    selection = select(scene, rtol=inside)
    if selection.left_out_error:
        try:
            return _planned(scene, selection, wanted, name, turning)
        except RouteOutOfDomain:  # the rest is too little for the route, or its promise holds for the whole scene only
            selection = select(scene)
    return _planned(scene, selection, wanted, name, turning)


def _turning(scene: Scene) -> Turning:
    about = scene.about_axis
    return turning_of(replace(about, loading=about.under(scene.grains.friction)))


def _planned(scene: Scene, selection: Selection, rtol: float | None, name: str, turning: Turning) -> Plan:
    hypothesis, left_out = scene.model.hypothesis, selection.left_out_error
    if hypothesis is Hypothesis.STATIC:
        _require_finite_compliance(selection)
    lengths = None if selection.sizes is None else length_moments(selection.sizes)
    scaling = scaling_error(lengths)
    wanted = remaining(turning.inside(rtol), left_out)
    left = route_accuracy(wanted, lengths, keeps_axis=name not in ROUTES or scene.axis is None
                          or ROUTES[name].keeps_axis)
    _require_reachable(wanted, left, scaling)
    choice = choose_for(name, selection.model, left)
    promise = choice.promise
    _require_accuracy(choice.route, promise, rtol, left, scaling, turning)
    return Plan(
        hypothesis=hypothesis, route=choice.route.name, route_reason=choice.reason,
        effects_simulated=tuple(selection.simulated), called_for=selection.simulated,
        effects_not_called_for=selection.not_called_for, sizes=selection.sizes, lengths=lengths,
        poisson_ratio=scene.grains.poisson_ratio, evaluations=promise.evaluations,
        relative_error=turning.outside(with_left_out(promise.relative_error + scaling, left_out)),
        rtol=rtol, left_out_error=left_out, route_error=promise.relative_error, scaling_error=scaling,
        axis=scene.axis, turning=turning, selection=selection, asked_route=name, choice=choice)


def _cost(decided: Plan, effect: str) -> tuple[int, int] | None:
    """Evaluations with an effect and without it; the model that is simulated is one of the two."""
    selection = decided.selection
    with_it, without_it = selection.with_effect(effect), selection.without_effect(effect)
    try:
        return _evaluations(decided, with_it), _evaluations(decided, without_it)
    except (RouteOutOfDomain, ComplianceInfinite, ResultOutOfRange):
        return None


def _evaluations(decided: Plan, effects: Collection[str]) -> int:
    if set(effects) == set(decided.effects_simulated):
        return decided.evaluations
    model = model_of(decided.selection.scene, effects)
    model.require_finite_compliance()
    return choose_for(decided.asked_route, model, decided.route_rtol).promise.evaluations


def _require_finite_compliance(selection: Selection) -> None:
    """Refuse contacts that slide or have opened, and say which list of effects is left without them."""
    try:
        selection.model.require_finite_compliance()
    except ComplianceInfinite as refusal:
        dropped = ("kinetic", "slip", "opening") if selection.model.opens else ("slip",)
        keep = ", ".join(f'"{name}"' for name in selection.simulated if name not in dropped)
        without = " and ".join(name for name in dropped if name in selection.simulated)
        raise ComplianceInfinite(
            refusal.found, allowed=refusal.allowed,
            remedy=f'Write effects = [{keep}] under [model] to leave {without} out, or use hypothesis = "kinematic".'
        ) from None


def _require_room(rtol: float | None, inside: float | None, turning: Turning) -> None:
    """Refuse what turning alone uses up."""
    if inside is None or inside > 0:
        return
    raise RouteOutOfDomain(f"rtol = {rtol!r} for a scene whose axis was found",
                           allowed=f"allowed rtol > {turning.added:.1e}, for turning it to axis 3 and back may cost "
                           "that much of the largest component", remedy=f"Ask for rtol = {2 * turning.added:.1e}.")


def _require_reachable(rtol: float | None, left: float | None, scaling: float) -> None:
    """Refuse what no route can make up for: the branch lengths of graded grains are not known well enough."""
    if left is None or left > 0 or scaling <= SCALING_ERROR:
        return
    raise RouteOutOfDomain(f"rtol = {rtol!r} with a gradation",
                           allowed=f"allowed rtol > {scaling * 1.005:.2e}, for the branch lengths are known to "
                           f"{scaling:.2e}", remedy="Ask for less.")


def _require_accuracy(route: Route | GeneralRoute, promise: Promise, rtol: float | None, wanted: float | None,
                      scaling: float, turning: Turning) -> None:
    if wanted is None or wanted >= promise.relative_error:
        return
    if math.isinf(promise.relative_error):
        raise RouteOutOfDomain(f"rtol = {rtol!r} by route {route.name}",
                               allowed=f"allowed no rtol there, because {route.title}, promises no accuracy",
                               remedy=f"Leave rtol out, or use route {AUTO[-1]}.")
    total = promise.relative_error + scaling
    share = 1.0 if route.keeps_axis or total <= COARSE else COARSE_SHARE
    closest = f"{turning.outside(total / share) * 1.005:.2e}"  # rounded up: it will be granted
    better = f", or use route {MOST_ACCURATE}" if route.name != MOST_ACCURATE and promise.error_is == "bound" else ""
    raise RouteOutOfDomain(f"rtol = {rtol!r} by route {route.name}",
                           allowed=f"allowed rtol >= {closest} for this fabric",
                           remedy=f"Ask for rtol = {closest}{better}.")
