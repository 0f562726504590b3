"""The routes of scenes without an axis: what each one covers, promises and costs, known before it runs."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from granular.errors import RouteOutOfDomain
from granular.general import closed_form
from granular.general.prediction import directions_of_lebedev, directions_of_product
from granular.general.result import GeneralStiffness, rows_of
from granular.general.sphere import COARSEST, REACHED, WANTED, average_of, out_of_domain
from granular.routes.catalogue import ROUTES
from granular.routes.choice import Choice, Considered
from granular.routes.result import Promise

if TYPE_CHECKING:
    from granular.general.fabric import GeneralFabric
    from granular.general.lebedev import Integral
    from granular.general.loading import GeneralLoading
    from granular.general.sphere import Average
    from granular.hypothesis import Hypothesis


@dataclass(frozen=True, slots=True, kw_only=True)
class GeneralRoute:
    """One way of computing 21 constants.

    Attributes
    ----------
    name : str
        Name on the command line.
    title : str
        What it does.
    domain, error_model : str
        What it serves, and where its promise comes from, in words.
    promise : callable
        Accuracy and work for a fabric, a hypothesis, a loading (or None) and an accuracy; None where the route does not
        serve them.
    compute : callable
        The stiffness.
    """

    name: str
    title: str
    domain: str
    error_model: str
    promise: Callable[[GeneralFabric, Hypothesis, GeneralLoading | None, float], Promise | None]
    compute: Callable[[GeneralFabric, Hypothesis, GeneralLoading | None, float, float], GeneralStiffness]

    @property
    def keeps_axis(self) -> bool:
        """There is no axis, and no component follows from two others."""
        return True

    def evaluate(self, fabric: GeneralFabric, *, poisson_ratio: float, hypothesis: Hypothesis,
                 loading: GeneralLoading | None = None, rtol: float | None = None) -> GeneralStiffness:
        """Compute the 21 constants.

        Parameters
        ----------
        fabric : GeneralFabric
            Contact normals and branch lengths [-].
        poisson_ratio : float
            Poisson ratio of the solid [-], 0 to 0.5.
        hypothesis : Hypothesis
            Kinematic or static.
        loading : GeneralLoading, optional
            Stress and friction, for contacts whose stiffness follows their force.
        rtol : float, optional
            Wanted error of every component over the largest [-].

        Returns
        -------
        GeneralStiffness
            Components over (M/V) l_e^2 k_n,ref [-], error and cost.

        Raises
        ------
        RouteOutOfDomain
            The route does not serve them, or does not reach ``rtol``.
        ComplianceInfinite
            The static hypothesis with contacts that slide or have opened.

        Notes
        -----
        Accuracy: as promised. Source: the route's own.
        """
        return self.compute(fabric, hypothesis, loading, poisson_ratio, aimed_at(rtol))


def aimed_at(rtol: float | None) -> float:
    """The accuracy that a rule over the sphere aims at.

    Parameters
    ----------
    rtol : float or None
        Wanted error of every component over the largest [-].

    Returns
    -------
    float
        1e-9 when none is wanted, and never coarser than a tenth [-].

    Notes
    -----
    Source: a choice.

    Examples
    --------
    >>> aimed_at(None), aimed_at(0.5)
    (1e-09, 0.1)
    """
    return WANTED if rtol is None else min(rtol, COARSEST)


def choose_general(name: str, fabric: GeneralFabric, hypothesis: Hypothesis, loading: GeneralLoading | None,
                   rtol: float | None) -> Choice:
    """Choose the first route that serves a scene without an axis.

    Parameters
    ----------
    name : str
        "auto", or the name of a route.
    fabric : GeneralFabric
        Contact normals and branch lengths [-].
    hypothesis : Hypothesis
        Kinematic or static.
    loading : GeneralLoading or None
        Stress and friction; None for contacts of equal stiffness.
    rtol : float or None
        Wanted error of every component over the largest [-].

    Returns
    -------
    Choice
        The route; where it does not keep ``rtol``, its promise says so.

    Raises
    ------
    RouteOutOfDomain
        The route that was named does not serve the scene.
    ComplianceInfinite
        Static hypothesis with contacts that slide or have opened.

    Notes
    -----
    Accuracy: as promised. Source: the closed form is exact but for rounding, so that nothing is gained by another.

    Examples
    --------
    >>> from granular.general.fabric import GeneralFabric
    >>> from granular.hypothesis import Hypothesis
    >>> choose_general("auto", GeneralFabric(), Hypothesis.STATIC, None, None).route.name
    'closed_form'
    """
    if name != "auto" and name not in GENERAL_ROUTES:
        raise RouteOutOfDomain(f"route = {name} without an axis",
                               allowed=f"allowed only scenes whose fabric and stress share an axis, for it is "
                               f"{ROUTES[name].title}", remedy=f"Use one of the routes {', '.join(GENERAL_ROUTES)}.")
    considered = []
    for known in (GENERAL_AUTO if name == "auto" else (name,)):
        route = GENERAL_ROUTES[known]
        promise = route.promise(fabric, hypothesis, loading, aimed_at(rtol))
        considered.append(Considered(route=route, promise=promise, price=0.0 if promise is None else
                                     promise.evaluations))
        if promise is not None:
            passed = "".join(f" ({one.route.name} does not)" for one in considered[:-1])
            reason = "as asked for" if name != "auto" else f"the first that serves this scene{passed}"
            return Choice(route=route, promise=promise, reason=f"{route.title}, {reason}", considered=tuple(considered))
    # one named route that does not serve the scene: it says best itself what it serves
    GENERAL_ROUTES[name].evaluate(fabric, poisson_ratio=0.0, hypothesis=hypothesis, loading=loading)
    raise out_of_domain(name, f"such as these: {GENERAL_ROUTES[name].domain}", GENERAL_AUTO[-1])


def _closed_form_promise(fabric: GeneralFabric, hypothesis: Hypothesis, loading: GeneralLoading | None,
                         _rtol: float) -> Promise | None:
    served = loading is None and closed_form.covers(fabric, hypothesis)
    return Promise(closed_form.RELATIVE_ERROR, 0) if served else None


def _by_closed_form(fabric: GeneralFabric, hypothesis: Hypothesis, loading: GeneralLoading | None,
                    poisson_ratio: float, rtol: float) -> GeneralStiffness:
    if _closed_form_promise(fabric, hypothesis, loading, rtol) is None:
        raise out_of_domain("closed_form", "with contacts of equal stiffness (static: and branches of one length)",
                            "product")
    matrix = closed_form.mandel_matrix(fabric, poisson_ratio=poisson_ratio, hypothesis=hypothesis)
    return GeneralStiffness(rows_of(matrix), closed_form.RELATIVE_ERROR, "bound", 0, "closed_form")


def _average(fabric: GeneralFabric, hypothesis: Hypothesis, loading: GeneralLoading | None) -> Average:
    """What is averaged, as far as a promise needs it: no Poisson's ratio enters."""
    return average_of(fabric, poisson_ratio=0.0, hypothesis=hypothesis, loading=loading)


def _estimate(evaluations: int, rtol: float) -> Promise:
    return Promise(max(rtol, REACHED), evaluations, error_is="estimate")


def _lebedev_promise(fabric: GeneralFabric, hypothesis: Hypothesis, loading: GeneralLoading | None,
                     rtol: float) -> Promise | None:
    from granular.general.lebedev import ALL_POINTS

    average = _average(fabric, hypothesis, loading)
    if not average.smooth:
        return None
    return _estimate(directions_of_lebedev(average, max(rtol, REACHED)) or ALL_POINTS, rtol)


def _product_promise(fabric: GeneralFabric, hypothesis: Hypothesis, loading: GeneralLoading | None,
                     rtol: float) -> Promise:
    return _estimate(directions_of_product(_average(fabric, hypothesis, loading), max(rtol, REACHED)), rtol)


def _sphere_promise(fabric: GeneralFabric, hypothesis: Hypothesis, loading: GeneralLoading | None,
                    rtol: float) -> Promise:
    average, reached = _average(fabric, hypothesis, loading), max(rtol, REACHED)
    return _estimate(directions_of_lebedev(average, reached) or directions_of_product(average, reached), rtol)


def _by_lebedev(fabric: GeneralFabric, hypothesis: Hypothesis, loading: GeneralLoading | None, poisson_ratio: float,
                rtol: float) -> GeneralStiffness:
    average = average_of(fabric, poisson_ratio=poisson_ratio, hypothesis=hypothesis, loading=loading)
    return _kept(average.by_lebedev(rtol), "lebedev", rtol)


def _by_product(fabric: GeneralFabric, hypothesis: Hypothesis, loading: GeneralLoading | None, poisson_ratio: float,
                rtol: float) -> GeneralStiffness:
    average = average_of(fabric, poisson_ratio=poisson_ratio, hypothesis=hypothesis, loading=loading)
    return _kept(average.by_product(rtol), "product", rtol)


def _by_sphere(fabric: GeneralFabric, hypothesis: Hypothesis, loading: GeneralLoading | None, poisson_ratio: float,
               rtol: float) -> GeneralStiffness:
    """Lebedev where that is expected to do, and the product rule where it is not, or did not."""
    average = average_of(fabric, poisson_ratio=poisson_ratio, hypothesis=hypothesis, loading=loading)
    spent = 0
    if directions_of_lebedev(average, rtol) is not None:
        found = average.by_lebedev(rtol)
        if found.error <= rtol:
            return _kept(found, "lebedev", rtol)
        spent = found.evaluations
    return _kept(average.by_product(rtol), "product", rtol, spent)


def _kept(found: Integral, rule: str, rtol: float, spent: int = 0) -> GeneralStiffness:
    """The result, or a refusal where the rule has not reached what was wanted."""
    if found.error > rtol:
        raise RouteOutOfDomain(f"rtol = {rtol!r} by the route {rule}",
                               allowed=f"allowed about {found.error:.1e} and more for this scene",
                               remedy="Ask for less." if rule == "product" else "Ask for less, or use product.")
    return GeneralStiffness(rows_of(found.mandel), found.error, "estimate", found.evaluations + spent, rule)


_ESTIMATE = "an estimate from the difference of two rules"

GENERAL_CATALOGUE: tuple[GeneralRoute, ...] = (
    GeneralRoute(name="closed_form", title="the emitted closed form in fractions",
                 domain="contacts of equal stiffness (static: and branches of one length)",
                 error_model="rounding, 2 units of 2^-52", promise=_closed_form_promise, compute=_by_closed_form),
    GeneralRoute(name="sphere", title="the rule over the sphere that suits, lebedev or product",
                 domain="every scene without an axis", error_model=_ESTIMATE, promise=_sphere_promise,
                 compute=_by_sphere),
    GeneralRoute(name="lebedev", title="Lebedev rules of rising degree over the sphere",
                 domain="integrands without slip or opening that a polynomial of degree 131 follows",
                 error_model=_ESTIMATE, promise=_lebedev_promise, compute=_by_lebedev),
    GeneralRoute(name="product", title="a product rule over the sphere, split where contacts slide or open",
                 domain="every scene without an axis", error_model=_ESTIMATE, promise=_product_promise,
                 compute=_by_product),
)
"""Every route for scenes without an axis."""

GENERAL_ROUTES: dict[str, GeneralRoute] = {route.name: route for route in GENERAL_CATALOGUE}
"""The same by name."""

GENERAL_AUTO = ("closed_form", "sphere")
"""Routes among which a plan chooses by itself; the last one serves every scene."""
