"""The routes: what each one covers, promises and costs, known before it runs."""

from __future__ import annotations

import importlib
import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from granular.hypothesis import Hypothesis
from granular.routes.result import Promise

if TYPE_CHECKING:
    from granular.fabric import AxialFabric
    from granular.loading import Loading
    from granular.routes.result import RouteResult


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
        Accuracy and cost for a fabric, a hypothesis, a loading (or None) and a wanted relative accuracy (or None);
        None where the route does not serve them.
    """

    name: str
    title: str
    promise: Callable[[AxialFabric, Hypothesis, Loading | None, float | None], Promise | None]

    def evaluate(self, fabric: AxialFabric, *, poisson_ratio: float, hypothesis: Hypothesis,
                 loading: Loading | None = None, rtol: float | None = None) -> RouteResult:
        """Compute the six components.

        Parameters
        ----------
        fabric : AxialFabric
            Contact normals and branch lengths about axis 3 [-].
        poisson_ratio : float
            Poisson ratio of the solid [-], 0 to 0.5.
        hypothesis : Hypothesis
            Kinematic or static.
        loading : Loading, optional
            Stress and friction, for contacts whose stiffness follows their force.
        rtol : float, optional
            Wanted relative accuracy of every component [-].

        Returns
        -------
        RouteResult
            Components over (M/V) l_e^2 k_n,ref [-], error bound and cost.

        Raises
        ------
        RouteOutOfDomain
            The route does not serve them, or cannot promise ``rtol``.
        ComplianceInfinite
            The static hypothesis with contacts that slide or have opened.

        Notes
        -----
        Accuracy: as promised. Source: the route's own.
        """
        module = importlib.import_module(f"granular.routes.{self.name}")
        result: RouteResult = module.evaluate(fabric, poisson_ratio=poisson_ratio, hypothesis=hypothesis,
                                              loading=loading, rtol=rtol)
        return result


def _closed_form(fabric: AxialFabric, hypothesis: Hypothesis, loading: Loading | None,
                 rtol: float | None) -> Promise | None:
    from granular.routes.closed_form import covers, promise

    return promise(fabric, hypothesis, loading, rtol=rtol) if covers(fabric, hypothesis, loading) else None


def _axial(fabric: AxialFabric, hypothesis: Hypothesis, loading: Loading | None, rtol: float | None) -> Promise:
    from granular.routes.axial import promise

    return promise(fabric, hypothesis, loading, rtol=rtol)


def _sphere(fabric: AxialFabric, hypothesis: Hypothesis, loading: Loading | None,
            rtol: float | None) -> Promise | None:
    from granular.routes.sphere import directions_of
    from granular.routes.sphere_bounds import DEGREES, WANTED, declared_error

    wanted = WANTED if rtol is None else rtol
    for degree in DEGREES:
        error = declared_error(fabric, hypothesis=hypothesis, degree=degree, loading=loading)
        if error <= wanted:
            break
    if math.isinf(error) or (rtol is None and error > WANTED):
        return None
    return Promise(error, directions_of(degree))


def _exact(fabric: AxialFabric, hypothesis: Hypothesis, loading: Loading | None,
           _rtol: float | None) -> Promise | None:
    from granular.routes.accuracy import HALF_ULP
    from granular.routes.exact import WORK

    rational = hypothesis is Hypothesis.KINEMATIC and loading is None and fabric.collinear
    return Promise(HALF_ULP, 0, WORK) if rational else None


def _certified(fabric: AxialFabric, _hypothesis: Hypothesis, loading: Loading | None,
               _rtol: float | None) -> Promise | None:
    from granular.routes.accuracy import HALF_ULP

    return Promise(HALF_ULP, 0) if fabric.collinear or loading is None else None


def _midpoint(_fabric: AxialFabric, _hypothesis: Hypothesis, _loading: Loading | None,
              _rtol: float | None) -> Promise:
    from granular.routes.midpoint import PRINTED_PANELS

    return Promise(math.inf, PRINTED_PANELS)


CATALOGUE: tuple[Route, ...] = (
    Route(name="closed_form", title="the emitted closed form", promise=_closed_form),
    Route(name="axial", title="a rule along the meridian", promise=_axial),
    Route(name="sphere", title="a Lebedev rule over the sphere", promise=_sphere),
    Route(name="exact", title="the closed form in rational numbers", promise=_exact),
    Route(name="certified", title="ball arithmetic, every digit proved", promise=_certified),
    Route(name="midpoint", title="the historical rule of the printed tables, 24 panels", promise=_midpoint),
)
"""Every route."""

ROUTES: dict[str, Route] = {route.name: route for route in CATALOGUE}
"""The same by name."""

AUTO = ("closed_form", "axial")
"""Routes that a plan tries by itself, in this order; the last one serves every fabric."""

MOST_ACCURATE = "certified"
"""Route to name when another one promises too little."""
