"""The stiffness of an assembly without an axis: all 21 constants, by the route that suits."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal, get_args

from granular.axial_scene import AXIS_3
from granular.errors import RouteOutOfDomain, UnknownChoice, ValueOutOfRange
from granular.general.axis import axial_scene, rotation_to
from granular.general.result import GeneralStiffness
from granular.general.routes import GENERAL_ROUTES, choose_general
from granular.general.sphere import COARSEST, FINEST, out_of_domain
from granular.hypothesis import Hypothesis
from granular.turning import turning_of

if TYPE_CHECKING:
    from granular.axial_scene import AxialScene
    from granular.general.fabric import GeneralFabric
    from granular.general.loading import GeneralLoading

ROOM = 1e-14
"""Least accuracy that a route about an axis is asked for [-]; below, it gives what it has."""

Route = Literal["auto", "axial", "closed_form", "sphere", "lebedev", "product"]
"""Names of the ways to compute."""


def general_stiffness(fabric: GeneralFabric, *, poisson_ratio: float, hypothesis: Hypothesis | str,
                      loading: GeneralLoading | None = None, rtol: float = 1e-9,
                      route: Route = "auto") -> GeneralStiffness:
    """Compute the stiffness of an assembly for any fabric and any stress.

    Parameters
    ----------
    fabric : GeneralFabric
        Contact normals and branch lengths [-].
    poisson_ratio : float
        Poisson's ratio of the grain material [-], 0 to 0.5.
    hypothesis : Hypothesis or str
        "kinematic" or "static".
    loading : GeneralLoading, optional
        Stress and friction, for contacts whose stiffness follows their force; contacts of equal stiffness otherwise.
    rtol : float
        Wanted error of every component over the largest [-], 1e-12 to 0.1.
    route : str
        "auto", or one of "axial" (scenes with an axis in whatever frame), "closed_form" (contacts of equal stiffness),
        "lebedev" (smooth integrands), "product" (all scenes), "sphere" (one of these two).

    Returns
    -------
    GeneralStiffness
        All 21 constants over (M/V) l_e^2 k_n,ref, with their error and the route.

    Raises
    ------
    ValueOutOfRange
        ``poisson_ratio`` is outside its interval.
    UnknownChoice
        There is no such hypothesis or route.
    RouteOutOfDomain
        ``rtol`` is outside its range, or the named route does not serve the scene or does not reach ``rtol``.
    ComplianceInfinite
        Static hypothesis with contacts that slide or have opened.

    Notes
    -----
    Accuracy: a bound by the closed form and, but for ``granular.turning``, by the axial routes; an
    estimate by rules over the sphere, the difference between two of them. Source: eqs (1)-(7), (20)-(23) and
    Figure 1(b).

    Examples
    --------
    >>> from granular.general.fabric import GeneralFabric
    >>> from granular.general.loading import GeneralLoading
    >>> sheared = GeneralLoading([[1.0, 0.4, 0.0], [0.4, 1.0, 0.0], [0.0, 0.0, 0.8]], friction=0.3)
    >>> found = general_stiffness(GeneralFabric([[0.3, 0, 0], [0, -0.1, 0], [0, 0, -0.2]]), poisson_ratio=0.2,
    ...                           hypothesis="kinematic", loading=sheared, rtol=1e-6)
    >>> found.route, found.relative_error <= 1e-6, len(found.components)
    ('product', True, 21)
    """
    _require(poisson_ratio, hypothesis, rtol, route)
    hypothesis = Hypothesis(hypothesis)
    if route in ("auto", "axial"):
        scene = axial_scene(fabric, loading)
        if scene is not None:
            return _by_axial_route(scene, poisson_ratio, hypothesis, rtol)
        if route == "axial":
            raise out_of_domain(route, "whose tensors share an axis", "auto")
    name = choose_general(route, fabric, hypothesis, loading, rtol).route.name
    return GENERAL_ROUTES[name].evaluate(fabric, poisson_ratio=poisson_ratio, hypothesis=hypothesis, loading=loading,
                                         rtol=rtol)


def _require(poisson_ratio: float, hypothesis: Hypothesis | str, rtol: float, route: str) -> None:
    if not 0 <= poisson_ratio <= 0.5:
        raise ValueOutOfRange(f"poisson_ratio = {poisson_ratio!r}", allowed="allowed 0 <= poisson_ratio <= 0.5",
                              remedy="Give Poisson's ratio of the grain material.")
    for name, value, known in (("hypothesis", hypothesis, tuple(map(str, Hypothesis))),
                               ("route", route, get_args(Route))):
        if value not in known:
            raise UnknownChoice(f"{name} = {value!r}", allowed=f"allowed {', '.join(known)}",
                                remedy="Name one of them.")
    if not FINEST <= rtol <= COARSEST:
        raise RouteOutOfDomain(f"rtol = {rtol!r} without an axis",
                               allowed=f"allowed {FINEST:g} <= rtol <= {COARSEST:g}",
                               remedy="Give a relative accuracy in that range.")


def _by_axial_route(scene: AxialScene, poisson_ratio: float, hypothesis: Hypothesis, rtol: float) -> GeneralStiffness:
    from granular.mandel import axial_rows, turned
    from granular.routes.catalogue import ROUTES
    from granular.routes.choice import choose

    turning = turning_of(scene)
    left = turning.inside(rtol)
    inside = left if left is not None and left > ROOM else None  # what the route has anyway, and the result says so
    chosen = choose("auto", scene.fabric, hypothesis, scene.loading, inside)
    result = ROUTES[chosen.route.name].evaluate(
        scene.fabric, poisson_ratio=poisson_ratio, hypothesis=hypothesis, loading=scene.loading, rtol=inside)
    rows: tuple[tuple[float, ...], ...] = axial_rows(result.components)
    if scene.axis != AXIS_3:
        rows = turned(axial_rows(result.components), rotation_to(scene.axis), "stiffness")
    return GeneralStiffness(rows, turning.outside(result.relative_error), "bound", result.evaluations,
                            f"axial: {chosen.route.name}", scene.axis)
