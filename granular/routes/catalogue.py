"""The routes: what each one covers, promises and costs, known before it runs."""

from __future__ import annotations

import importlib
import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from granular.hypothesis import Hypothesis

if TYPE_CHECKING:
    from granular.fabric import AxialFabric
    from granular.routes.result import RouteResult


@dataclass(frozen=True, slots=True)
class Promise:
    """What a route would give.

    Attributes
    ----------
    relative_error : float
        Bound for the worst component, relative to that component [-].
    evaluations : int
        Directions in which the integrand would be evaluated [-].
    """

    relative_error: float
    evaluations: int


@dataclass(frozen=True, slots=True, kw_only=True)
class Route:
    """One way of computing; its module ``granular.routes.<name>`` is imported when it is needed.

    Attributes
    ----------
    name : str
        Name on the command line, and of the module.
    title : str
        What it does.
    promise : callable
        Accuracy and cost for a fabric, a hypothesis and a wanted relative accuracy (or None); None where the route
        does not serve that fabric.
    """

    name: str
    title: str
    promise: Callable[[AxialFabric, Hypothesis, float | None], Promise | None]

    def evaluate(self, fabric: AxialFabric, *, poisson_ratio: float, hypothesis: Hypothesis,
                 rtol: float | None = None) -> RouteResult:
        """Compute the six components.

        Parameters
        ----------
        fabric : AxialFabric
            Contact normals and branch lengths about axis 3 [-].
        poisson_ratio : float
            Poisson ratio of the solid [-], 0 to 0.5.
        hypothesis : Hypothesis
            Kinematic or static.
        rtol : float, optional
            Wanted relative accuracy of every component [-].

        Returns
        -------
        RouteResult
            Components over (M/V) l_e^2 k_n,ref [-], error bound and cost.

        Raises
        ------
        RouteOutOfDomain
            The route does not serve the fabric, or cannot promise ``rtol``.

        Notes
        -----
        Accuracy: as promised. Source: the route's own.
        """
        module = importlib.import_module(f"granular.routes.{self.name}")
        result: RouteResult = module.evaluate(fabric, poisson_ratio=poisson_ratio, hypothesis=hypothesis, rtol=rtol)
        return result


def _closed_form(fabric: AxialFabric, hypothesis: Hypothesis, _rtol: float | None) -> Promise | None:
    from granular.routes.closed_form import covers, relative_error

    return Promise(relative_error(fabric, hypothesis), 0) if covers(fabric, hypothesis) else None


def _axial(fabric: AxialFabric, hypothesis: Hypothesis, _rtol: float | None) -> Promise:
    from granular.routes.axial import RELATIVE_ERROR, suitable_rule

    return Promise(RELATIVE_ERROR, len(suitable_rule(fabric, hypothesis)))


def _sphere(fabric: AxialFabric, hypothesis: Hypothesis, rtol: float | None) -> Promise | None:
    from granular.routes.sphere import DEGREES, WANTED, declared_error

    wanted = WANTED if rtol is None else rtol
    for degree in DEGREES:
        error = declared_error(fabric, hypothesis=hypothesis, degree=degree)
        if error <= wanted:
            break
    if math.isinf(error) or (rtol is None and error > WANTED):
        return None
    from scipy.integrate import lebedev_rule

    return Promise(error, int(lebedev_rule(degree)[1].size))


def _exact(_fabric: AxialFabric, hypothesis: Hypothesis, _rtol: float | None) -> Promise | None:
    from granular.routes.accuracy import HALF_ULP

    return Promise(HALF_ULP, 0) if hypothesis is Hypothesis.KINEMATIC else None


def _certified(_fabric: AxialFabric, _hypothesis: Hypothesis, _rtol: float | None) -> Promise:
    from granular.routes.accuracy import HALF_ULP

    return Promise(HALF_ULP, 0)


CATALOGUE: tuple[Route, ...] = (
    Route(name="closed_form", title="the emitted closed form", promise=_closed_form),
    Route(name="axial", title="a Gauss rule along the meridian", promise=_axial),
    Route(name="sphere", title="a Lebedev rule over the sphere", promise=_sphere),
    Route(name="exact", title="the closed form in rational numbers", promise=_exact),
    Route(name="certified", title="ball arithmetic, every digit proved", promise=_certified),
)
"""Every route."""

ROUTES: dict[str, Route] = {route.name: route for route in CATALOGUE}
"""The same by name."""

AUTO = ("closed_form", "axial")
"""Routes that a plan tries by itself, in this order; the last one serves every fabric."""

MOST_ACCURATE = "certified"
"""Route to name when another one promises too little."""
