"""Every route of this package in its default setting and over its settings."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from functools import partial

from granular.cost.records import PRODUCT, Outcome, RouteFailed, Setting
from granular.cost.scenes import CostScene
from granular.hypothesis import Hypothesis
from granular.routes import axial, certified, midpoint, sphere
from granular.routes.catalogue import ROUTES
from granular.routes.result import RouteResult

DEFAULT = "default"
"""Setting of a route that is asked for nothing in particular."""

TOLERANCES = tuple(float(f"1e-{digits}") for digits in range(3, 15))
NODES = (4, 8, 12, 16, 20, 28, 40, 80)
DEGREES = (5, 11, 17, 23, 29, 47, 83, 131)
PANELS = (12, 24, 48, 96, 384, 1536)
DIGITS = (15, 30, 50, 100)

Stiffness = Callable[[], Outcome]
"""Six components of grains of one size, with what is promised for them and the count."""


def product_settings(scene: CostScene) -> Iterator[Setting]:
    """List every route of the catalogue in every setting.

    Parameters
    ----------
    scene : CostScene
        What is computed.

    Returns
    -------
    iterator of Setting
        For each route first its default, which is refused where the route does not serve the scene.

    Notes
    -----
    Source: ``granular.routes.catalogue``.
    """
    yield _setting(scene, "closed_form", "floats", partial(_emitted, scene))
    for name in ROUTES:
        yield _setting(scene, name, DEFAULT, partial(_evaluate, scene, name), paper=name == midpoint.NAME)
        if name in ("closed_form", "axial"):
            for rtol in TOLERANCES:
                yield _setting(scene, name, f"rtol {rtol:.0e}", partial(_evaluate, scene, name, rtol))
    if scene.fabric.collinear and scene.loading is None:
        for nodes in NODES:
            yield _setting(scene, axial.NAME, f"{nodes} nodes", partial(_by_nodes, scene, nodes))
    for degree in DEGREES:
        yield _setting(scene, sphere.NAME, f"degree {degree}", partial(_by_degree, scene, degree))
    for panels in PANELS:
        if panels != midpoint.PRINTED_PANELS:
            yield _setting(scene, midpoint.NAME, f"{panels} panels", partial(_by_panels, scene, panels))
    for digits in DIGITS:
        yield _setting(scene, certified.NAME, f"{digits} digits", partial(_by_digits, scene, digits))


def _setting(scene: CostScene, route: str, name: str, stiffness: Stiffness, *, paper: bool = False) -> Setting:
    def call() -> Outcome:
        found = stiffness()
        if scene.spread is None:
            return found
        factor, error = _length_factor(scene)
        return Outcome([float(component) * factor for component in found.components],
                       None if found.promised is None else found.promised + error, found.evaluations)

    return Setting(route=route, kind=PRODUCT, name=f"{midpoint.PRINTED_PANELS} panels" if paper else name, call=call,
                   paper=paper)


def _evaluate(scene: CostScene, route: str, rtol: float | None = None) -> Outcome:
    return _outcome(ROUTES[route].evaluate(scene.fabric, poisson_ratio=scene.poisson_ratio,
                                           hypothesis=scene.hypothesis, loading=scene.loading, rtol=rtol))


def _outcome(result: RouteResult) -> Outcome:
    return Outcome(result.components, _promised(result.relative_error), result.evaluations)


def _promised(error: float) -> float | None:
    return None if math.isinf(error) else error


def _by_nodes(scene: CostScene, nodes: int) -> Outcome:
    rule = axial.suitable_rule(scene.fabric, scene.hypothesis, nodes=nodes)
    six = axial.components_by_rule(scene.fabric, poisson_ratio=scene.poisson_ratio, hypothesis=scene.hypothesis,
                                   rule=rule)
    return Outcome(six, None, nodes)


def _by_degree(scene: CostScene, degree: int) -> Outcome:
    from granular.routes.sphere_bounds import declared_error

    promised = declared_error(scene.fabric, hypothesis=scene.hypothesis, degree=degree, loading=scene.loading)
    six = sphere.components_by_degree(scene.fabric, poisson_ratio=scene.poisson_ratio, hypothesis=scene.hypothesis,
                                      degree=degree, loading=scene.loading)
    return Outcome(six, _promised(promised), sphere.directions_of(degree))


def _by_panels(scene: CostScene, panels: int) -> Outcome:
    return _outcome(midpoint.evaluate(scene.fabric, poisson_ratio=scene.poisson_ratio, hypothesis=scene.hypothesis,
                                      loading=scene.loading, panels=panels))


def _by_digits(scene: CostScene, digits: int) -> Outcome:
    """Middles of the enclosures, exact."""
    six = certified.enclose(scene.fabric, poisson_ratio=scene.poisson_ratio, hypothesis=scene.hypothesis,
                            loading=scene.loading, digits=digits)
    return Outcome(tuple(enclosure.midpoint for enclosure in six), float(f"1e-{digits}"))


def _length_factor(scene: CostScene) -> tuple[float, float]:
    """What sizes do to the stiffness, computed anew at every call, and its error with the roundings."""
    from granular.gradation import Lognormal, branch_lengths

    assert scene.spread is not None
    sizes = Lognormal(1.0, scene.spread)
    kinematic = scene.hypothesis is Hypothesis.KINEMATIC
    moment = branch_lengths(sizes).moment(2.0 if kinematic else -2.0)
    scale = sizes.equal_volume_diameter**2
    return (moment.value / scale if kinematic else 1 / (moment.value * scale)), moment.relative_error + 2.0**-50


def _emitted(scene: CostScene) -> Outcome:
    """The emitted functions as they stand, in floats, with no rounding kept in check."""
    return Outcome(emitted_floats(scene))


def emitted_floats(scene: CostScene) -> tuple[float, float, float, float, float, float]:
    """Six components from the emitted functions in floats, where there is a closed form without slip.

    Parameters
    ----------
    scene : CostScene
        What is computed.

    Returns
    -------
    tuple of 6 float
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n,ref [-].

    Raises
    ------
    RouteFailed
        There is no closed form that floats can take.

    Notes
    -----
    Accuracy: about a dozen roundings. Source: ``granular.generated``.
    """
    from granular.generated import kinematic_constant, kinetic, spheroid, static_constant
    from granular.routes.closed_form import covers

    fabric, nu, kinematic = scene.fabric, scene.poisson_ratio, scene.hypothesis is Hypothesis.KINEMATIC
    slips = scene.loading is not None and scene.loading.slips(fabric.D33)
    if slips or not covers(fabric, scene.hypothesis, scene.loading):
        raise RouteFailed("no closed form is emitted for this scene that doubles can evaluate")
    if not fabric.collinear:
        from granular.spheroid import squared_equator

        moments = spheroid.spheroid_moments(fabric.D33, fabric.D3333, fabric.aspect_ratio)
        size = float(squared_equator(fabric.aspect_ratio))
        c1111, c3333, c1122, c1133, c2323, c1212 = spheroid.stiffness_from_moments(
            *moments, fabric.aspect_ratio**2, nu)
        return size * c1111, size * c3333, size * c1122, size * c1133, size * c2323, size * c1212
    if scene.loading is None:
        constant = kinematic_constant.kinematic_constant if kinematic else static_constant.static_constant
        return constant(fabric.D33, fabric.D3333, fabric.Dr33, nu)
    a, c = scene.loading.coefficients(fabric.D33)
    if kinematic:
        moments = kinetic.kinetic_moments(fabric.D33, fabric.D3333, fabric.Dr33, float(a), float(c), float(c - a))
        return kinematic_constant.stiffness_from_moments(*moments, nu)
    moments = kinetic.kinetic_static_moments(fabric.D33, fabric.D3333, float(a), float(c), float(c - a))
    return static_constant.stiffness_from_moments(*moments, fabric.D33, nu)
