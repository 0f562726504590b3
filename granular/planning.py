"""What an evaluation would do and why: effects, route, predicted cost and accuracy."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from granular.effects.selection import select
from granular.errors import RouteOutOfDomain, WrongType
from granular.fabric import AxialFabric
from granular.fields import Number, chosen
from granular.hypothesis import Hypothesis
from granular.routes.catalogue import AUTO, MOST_ACCURATE, ROUTES, Route
from granular.units import shown

if TYPE_CHECKING:
    from granular.scene import Scene

SCALING_ERROR = 2.0**-52
"""What the step to pascals adds: a reference stiffness and a product, each rounded once [-]."""

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
    fabric : AxialFabric
        What the simulated effects leave of the scene's fabric [-].
    poisson_ratio : float
        Poisson ratio of the solid [-].
    evaluations : int
        Predicted number of directions in which the integrand is evaluated [-].
    relative_error : float
        Predicted bound for the worst component, relative to that component [-].
    rtol : float or None
        Wanted relative accuracy [-].
    """

    hypothesis: Hypothesis
    route: str
    route_reason: str
    effects_simulated: tuple[str, ...]
    called_for: dict[str, str]
    effects_not_called_for: dict[str, str]
    fabric: AxialFabric
    poisson_ratio: float
    evaluations: int
    relative_error: float
    rtol: float | None


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
    EffectNotBuilt
        The scene calls for an effect that is not built.
    RouteOutOfDomain
        The route does not cover the fabric, or cannot promise ``rtol``.
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
    name = chosen(route, ("auto", *ROUTES), name="route")
    selection = select(scene)
    fabric, hypothesis = selection.fabric, scene.model.hypothesis
    best, reason = _first_covering(fabric, hypothesis) if name == "auto" else (ROUTES[name], "it was asked for")
    _require_cover(best, fabric, hypothesis)
    error, evaluations = best.promise(fabric, hypothesis)
    error += SCALING_ERROR
    _require_accuracy(best, error, wanted)
    return Plan(
        hypothesis=hypothesis, route=best.name, route_reason=reason,
        effects_simulated=tuple(selection.simulated), called_for=selection.simulated,
        effects_not_called_for=selection.not_called_for, fabric=fabric,
        poisson_ratio=scene.grains.poisson_ratio, evaluations=evaluations, relative_error=error, rtol=wanted)


def _first_covering(fabric: AxialFabric, hypothesis: Hypothesis) -> tuple[Route, str]:
    passed = ""
    for route in (ROUTES[name] for name in AUTO):
        if route.covers(fabric, hypothesis):
            return route, f"{route.title}, the cheapest that covers this fabric{passed}"
        passed = f" ({route.name} does not)"
    raise AssertionError("the last route of AUTO covers every fabric")


def _require_cover(route: Route, fabric: AxialFabric, hypothesis: Hypothesis) -> None:
    if not route.covers(fabric, hypothesis):
        raise RouteOutOfDomain(f"route = {route.name} for {fabric}",
                               allowed=f"it does not cover this fabric by the {hypothesis} hypothesis",
                               remedy=f"Use route {AUTO[-1]}, which serves every admissible fabric.")


def _require_accuracy(route: Route, error: float, rtol: float | None) -> None:
    if rtol is None or rtol >= error:
        return
    closest = f"{error * 1.005:.2e}"  # rounded up, so that it is granted when it is asked for
    better = "" if route.name == MOST_ACCURATE else f", or use route {MOST_ACCURATE}"
    raise RouteOutOfDomain(f"rtol = {rtol!r} by route {route.name}",
                           allowed=f"allowed rtol >= {closest} for this fabric",
                           remedy=f"Ask for rtol = {closest}{better}.")
