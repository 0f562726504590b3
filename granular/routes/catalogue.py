"""The routes: what each one covers, promises and costs, known before it runs."""

from __future__ import annotations

import importlib
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from granular.hypothesis import Hypothesis
from granular.routes.result import RouteResult

if TYPE_CHECKING:
    from granular.fabric import AxialFabric

Promise = tuple[float, int]
"""Bound for the worst component relative to that component, and number of evaluations of the integrand [-]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Route:
    """One way of computing; its module ``granular.routes.<name>`` is imported when it is needed.

    Attributes
    ----------
    name : str
        Name on the command line, and of the module.
    title : str
        What it does.
    covers : callable
        Whether it serves a fabric under a hypothesis.
    promise : callable
        Accuracy and cost for a fabric that it serves.
    """

    name: str
    title: str
    covers: Callable[[AxialFabric, Hypothesis], bool]
    promise: Callable[[AxialFabric, Hypothesis], Promise]

    def evaluate(self, fabric: AxialFabric, *, poisson_ratio: float, hypothesis: Hypothesis) -> RouteResult:
        """Compute the six components.

        Parameters
        ----------
        fabric : AxialFabric
            Contact normals and branch lengths about axis 3 [-].
        poisson_ratio : float
            Poisson ratio of the solid [-], 0 to 0.5.
        hypothesis : Hypothesis
            Kinematic or static.

        Returns
        -------
        RouteResult
            Components over (M/V) l_e^2 k_n,ref [-], error bound and cost.

        Notes
        -----
        Accuracy: as promised. Source: the route's own.
        """
        module = importlib.import_module(f"granular.routes.{self.name}")
        result: RouteResult = module.evaluate(fabric, poisson_ratio=poisson_ratio, hypothesis=hypothesis)
        return result


def _closed_form_covers(fabric: AxialFabric, hypothesis: Hypothesis) -> bool:
    from granular.routes.closed_form import covers

    return covers(fabric, hypothesis)


def _closed_form_promise(fabric: AxialFabric, hypothesis: Hypothesis) -> Promise:
    from granular.routes.closed_form import relative_error

    return relative_error(fabric, hypothesis), 0


def _axial_promise(fabric: AxialFabric, hypothesis: Hypothesis) -> Promise:
    from granular.routes.axial import RELATIVE_ERROR, suitable_rule

    return RELATIVE_ERROR, len(suitable_rule(fabric, hypothesis))


def _certified_promise(_fabric: AxialFabric, _hypothesis: Hypothesis) -> Promise:
    from granular.routes.accuracy import HALF_ULP

    return HALF_ULP, 0


def _everything(_fabric: AxialFabric, _hypothesis: Hypothesis) -> bool:
    return True


CATALOGUE: tuple[Route, ...] = (
    Route(name="closed_form", title="the emitted closed form", covers=_closed_form_covers,
          promise=_closed_form_promise),
    Route(name="axial", title="a Gauss rule along the meridian", covers=_everything, promise=_axial_promise),
    Route(name="certified", title="ball arithmetic, every digit proved", covers=_everything,
          promise=_certified_promise),
)
"""Every route, cheapest first."""

AUTO = ("closed_form", "axial")
"""Routes that a plan tries by itself, in this order; the last one serves every fabric."""

MOST_ACCURATE = "certified"
"""Route to name when another one promises too little."""

ROUTES: dict[str, Route] = {route.name: route for route in CATALOGUE}
"""The same by name."""
