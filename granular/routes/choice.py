"""Which route a scene takes: the cheapest one that keeps the wanted accuracy."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from granular.errors import RouteOutOfDomain
from granular.routes.catalogue import AUTO, ROUTES, WITHOUT_AXIS, Route
from granular.routes.result import Promise

if TYPE_CHECKING:
    from granular.effects.bound import Simulated
    from granular.effects.forms import GeneralSimulated
    from granular.fabric import AxialFabric
    from granular.general.routes import GeneralRoute
    from granular.hypothesis import Hypothesis
    from granular.loading import Loading


@dataclass(frozen=True, slots=True, kw_only=True)
class Considered:
    """A route that a plan looked at.

    Attributes
    ----------
    route : Route or GeneralRoute
        Which one.
    promise : Promise or None
        What it would give; None where it does not serve the scene.
    price : float
        Predicted time in units of one operation of the rule along the meridian [-]; infinite without a promise. Without
        an axis the predicted number of directions.
    """

    route: Route | GeneralRoute
    promise: Promise | None
    price: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Choice:
    """The route that was chosen.

    Attributes
    ----------
    route : Route or GeneralRoute
        Which one.
    promise : Promise
        What it gives.
    reason : str
        Why this one.
    considered : tuple of Considered
        All that were looked at, in the order of the catalogue.
    """

    route: Route | GeneralRoute
    promise: Promise
    reason: str
    considered: tuple[Considered, ...]


def choose_for(name: str, model: Simulated | GeneralSimulated, rtol: float | None) -> Choice:
    """Choose the route of what the simulated effects leave of a scene, with an axis or without one.

    Parameters
    ----------
    name : str
        "auto", or the name of a route.
    model : Simulated or GeneralSimulated
        Fabric, loading and hypothesis.
    rtol : float or None
        Wanted relative accuracy, of every component about the axis, or without one of every component over the
        largest [-].

    Returns
    -------
    Choice
        The route; where none keeps ``rtol``, the one that comes nearest.

    Raises
    ------
    RouteOutOfDomain
        The route that was named does not serve the scene.
    ComplianceInfinite
        Static hypothesis with contacts that slide or have opened.

    Notes
    -----
    Accuracy: as promised. Source: :func:`choose`, :func:`granular.general.routes.choose_general`.
    """
    from granular.effects.bound import Simulated

    if isinstance(model, Simulated):
        return choose(name, model.fabric, model.hypothesis, model.loading, rtol)
    from granular.general.routes import choose_general

    return choose_general(name, model.fabric, model.hypothesis, model.loading, rtol)


def choose(name: str, fabric: AxialFabric, hypothesis: Hypothesis, loading: Loading | None,
           rtol: float | None) -> Choice:
    """Choose the route with the lowest price among those that keep the wanted accuracy.

    Parameters
    ----------
    name : str
        "auto", or the name of a route.
    fabric : AxialFabric
        Contact normals and branches about axis 3 [-].
    hypothesis : Hypothesis
        Kinematic or static.
    loading : Loading or None
        Stress and friction; None for contacts of equal stiffness.
    rtol : float or None
        Relative accuracy wanted of every normalised component [-].

    Returns
    -------
    Choice
        The route; where none keeps ``rtol``, the one that comes nearest.

    Raises
    ------
    RouteOutOfDomain
        The route that was named does not serve the scene.
    ComplianceInfinite
        Static hypothesis with contacts that slide or have opened.

    Notes
    -----
    Accuracy: as promised. Source: :class:`granular.routes.catalogue.Price`.

    Examples
    --------
    >>> from granular.fabric import AxialFabric
    >>> from granular.hypothesis import Hypothesis
    >>> choose("auto", AxialFabric(D33=0.3), Hypothesis.KINEMATIC, None, 1e-9).route.name
    'closed_form'
    """
    if name in WITHOUT_AXIS:
        raise RouteOutOfDomain(f"route = {name} with an axis",
                               allowed="allowed only scenes whose fabric and stress share no axis",
                               remedy="Use the route sphere, a rule over the sphere that serves scenes with an axis.")
    considered = tuple(_considered(ROUTES[known], fabric, hypothesis, loading, rtol)
                       for known in (AUTO if name == "auto" else (name,)))
    serving = [one for one in considered if one.promise is not None]
    if not serving:
        # one named route that does not serve the scene: it says best itself what it serves
        ROUTES[name].evaluate(fabric, poisson_ratio=0.0, hypothesis=hypothesis, loading=loading)
        raise RouteOutOfDomain(f"route = {name} for {fabric}" + ("" if loading is None else " with contact forces"),
                               allowed=f"it does not serve this scene by the {hypothesis} hypothesis",
                               remedy=f"Use route {AUTO[-1]}, which serves every admissible scene.")
    keeping = [one for one in serving if rtol is None or _error(one) <= rtol]
    best = min(keeping, key=lambda one: one.price) if keeping else min(serving, key=_error)
    assert best.promise is not None
    return Choice(route=best.route, promise=best.promise, reason=_reason(name, best, considered, rtol),
                  considered=considered)


def _considered(route: Route, fabric: AxialFabric, hypothesis: Hypothesis, loading: Loading | None,
                rtol: float | None) -> Considered:
    promise = route.promise(fabric, hypothesis, loading, rtol)
    price = math.inf if promise is None else route.price.of(promise, rtol)
    return Considered(route=route, promise=promise, price=price)


def _error(one: Considered) -> float:
    return math.inf if one.promise is None else one.promise.relative_error


def _reason(name: str, best: Considered, considered: tuple[Considered, ...], rtol: float | None) -> str:
    if name != "auto":
        return f"{best.route.title}, as asked for"
    passed = [f"{one.route.name} does not" for one in considered if one.promise is None]
    passed += [f"{one.route.name} promises {_error(one):.1e} only" for one in considered
               if one.promise is not None and rtol is not None and _error(one) > rtol and one is not best]
    why = "the cheapest that keeps the wanted accuracy" if rtol is not None else "the cheapest that serves this scene"
    return f"{best.route.title}, {why}" + (f" ({', '.join(passed)})" if passed else "")
