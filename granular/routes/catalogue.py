"""The routes: what each one covers, promises and costs, known before it runs."""

from __future__ import annotations

import importlib
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from granular.hypothesis import Hypothesis
from granular.routes.arithmetic import FLOATS, arithmetic_for
from granular.routes.result import Promise

if TYPE_CHECKING:
    from granular.fabric import AxialFabric
    from granular.loading import Loading
    from granular.routes.result import RouteResult


@dataclass(frozen=True, slots=True)
class Price:
    """How long a route takes, in units of one operation of the rule along the meridian.

    Attributes
    ----------
    call : float
        One evaluation, however small [-].
    fractions : float
        What it takes besides where floats are not enough [-].
    operation, evaluation : float
        Each operation, and each direction [-].
    """

    call: float
    fractions: float = 0.0
    operation: float = 0.0
    evaluation: float = 0.0

    def of(self, promise: Promise, rtol: float | None) -> float:
        """Predicted time of what is promised [-].

        Parameters
        ----------
        promise : Promise
            What the route would do.
        rtol : float or None
            Wanted relative accuracy of every component [-], which decides between floats and fractions.

        Returns
        -------
        float
            In units of one operation of the rule along the meridian.

        Notes
        -----
        Accuracy: within a factor of two or so. Source: times of single evaluations; ``granular check --choices`` says
        how often the choice by these prices is a good one.
        """
        operations = 0 if promise.work is None else promise.work.operations
        return (self.call + self.operation * operations + self.evaluation * promise.evaluations
                + (0.0 if arithmetic_for(rtol) is FLOATS else self.fractions))


@dataclass(frozen=True, slots=True, kw_only=True)
class Route:
    """One way of computing; its module ``granular.routes.<name>`` is imported when it is needed.

    Attributes
    ----------
    name : str
        Name on the command line, and of the module.
    title : str
        What it does.
    domain, error_model : str
        What it serves, and where its promise comes from, in words.
    promise : callable
        Accuracy and work for a fabric, a hypothesis, a loading (or None) and a wanted relative accuracy (or None);
        None where the route does not serve them.
    price : Price
        How long it takes.
    keeps_axis : bool
        Whether C1212 = (C1111 - C1122)/2 holds to rounding, however coarse the rule is.
    """

    name: str
    title: str
    domain: str
    error_model: str
    promise: Callable[[AxialFabric, Hypothesis, Loading | None, float | None], Promise | None]
    price: Price
    keeps_axis: bool = True

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
    from granular.routes.sphere import promise

    return promise(fabric, hypothesis, loading, rtol=rtol)


def _exact(fabric: AxialFabric, hypothesis: Hypothesis, loading: Loading | None,
           _rtol: float | None) -> Promise | None:
    from granular.routes.accuracy import HALF_ULP
    from granular.routes.exact import WORK

    rational = hypothesis is Hypothesis.KINEMATIC and loading is None and fabric.collinear
    return Promise(HALF_ULP, 0, WORK) if rational else None


def _certified(fabric: AxialFabric, _hypothesis: Hypothesis, loading: Loading | None,
               _rtol: float | None) -> Promise | None:
    """Promise the last rounding alone. No work is declared, as an operation on balls has no fixed cost.

    It grows with the digits they carry, and how many the proof needs is found out by trying.
    """
    from granular.routes.accuracy import HALF_ULP

    return Promise(HALF_ULP, 0) if fabric.collinear or loading is None else None


def _midpoint(fabric: AxialFabric, hypothesis: Hypothesis, loading: Loading | None,
              _rtol: float | None) -> Promise:
    from granular.routes.midpoint import promise

    return promise(fabric, hypothesis, loading)


CATALOGUE: tuple[Route, ...] = (
    Route(name="closed_form", title="the emitted closed form", promise=_closed_form,
          domain="contacts of equal stiffness (static: branches within a factor 9; spheroids: kinematic, "
                 "1/3 <= b/a <= 3); contact forces within a factor 9 where nothing slips in part or has opened "
                 "(static: branches of one length)",
          error_model="rounding, 1 to 27 units of 2^-52 in fractions and 32 in floats; series are cut at 2^-57",
          price=Price(call=100, fractions=4500, operation=5)),
    Route(name="axial", title="a rule along the meridian", promise=_axial,
          domain="every scene with an axis of symmetry",
          error_model="growth of the integrand on the largest ellipse without a singularity (Gauss rules), width of "
                      "the strip without one (trapezoidal rule for slip and opening), rounding",
          price=Price(call=2400, fractions=4500, operation=1)),
    Route(name="sphere", title="a Lebedev rule over the sphere", promise=_sphere,
          domain="integrands without slip or opening that a polynomial of degree 131 follows",
          error_model="best approximation by polynomials, rounding",
          price=Price(call=8000, evaluation=20), keeps_axis=False),
    Route(name="exact", title="the closed form in rational numbers", promise=_exact,
          domain="contacts of equal stiffness between spheres, kinematic hypothesis",
          error_model="none but the last rounding", price=Price(call=5000)),
    Route(name="certified", title="ball arithmetic, every digit proved", promise=_certified,
          domain="every scene but spheroids with contact forces",
          error_model="carried along with every number", price=Price(call=20_000)),
    Route(name="midpoint", title="the historical rule of the printed tables, 24 panels", promise=_midpoint,
          domain="every scene with an axis of symmetry", error_model="none: nothing is promised",
          price=Price(call=6500)),
)
"""Every route."""

ROUTES: dict[str, Route] = {route.name: route for route in CATALOGUE}
"""The same by name."""

AUTO = ("closed_form", "axial")
"""Routes among which a plan chooses by itself; the last one serves every scene. The others are independent voices, and
slower: rules over the sphere know nothing of the axis, and proofs take their time."""

WITHOUT_AXIS = ("lebedev", "product")
"""Names of routes that only scenes without an axis have; see :mod:`granular.general.routes`."""

MOST_ACCURATE = "certified"
"""Route to name when another one promises too little."""
