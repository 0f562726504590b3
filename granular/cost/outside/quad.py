"""SciPy's adaptive rules along the meridian: ``quad`` with and without break points, and ``quad_vec``."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from granular.cost.outside.arithmetic import Floats
from granular.cost.outside.averages import Tally, along_beta, break_points, outcome
from granular.cost.outside.route import MOST_SCALAR, TOLERANCES, OutsideRoute
from granular.cost.records import NotServed, Outcome
from granular.cost.scenes import CostScene

SUBDIVISIONS = 200
"""Most intervals of ``quad`` [-]; its default is 50."""


def _quad(scene: CostScene, rtol: float, *, points: bool = False) -> Outcome:
    """One integral for each component."""
    from scipy.integrate import quad

    edges = break_points(scene) if points else []
    if points and not edges:
        raise NotServed("this scene has no break points; see quad")
    tally = Tally(MOST_SCALAR)

    def integral(function: Callable[[float], Sequence[float]], count: int, low: float, high: float,
                 ends: Sequence[float]) -> Sequence[float]:
        found = []
        for component in range(count):
            value, _, _, *message = quad(lambda t, i=component: function(t)[i], low, high, epsabs=0.0, epsrel=rtol,
                                         limit=SUBDIVISIONS, points=list(ends) or None, full_output=1)
            if message:
                tally.warning = _first_sentence(message[0])
            found.append(float(value))
        return found

    average = along_beta(integral, edges, tally)
    return outcome(scene, Floats(), average, tally, integral)


def _quad_with_points(scene: CostScene, rtol: float) -> Outcome:
    return _quad(scene, rtol, points=True)


def _quad_vec(scene: CostScene, rtol: float) -> Outcome:
    """All components in one integral."""
    import numpy as np
    from scipy.integrate import quad_vec

    tally = Tally(MOST_SCALAR)

    def integral(function: Callable[[float], Sequence[float]], _count: int, low: float, high: float,
                 _edges: Sequence[float]) -> Sequence[float]:
        value, _, found = quad_vec(lambda t: np.array(function(t)), low, high, epsabs=1e-200, epsrel=rtol,
                                   norm="max", full_output=True)
        if not found.success:
            tally.warning = _first_sentence(found.message)
        return [float(one) for one in value]

    average = along_beta(integral, (), tally)
    return outcome(scene, Floats(), average, tally, integral)


def _first_sentence(message: str) -> str:
    return " ".join(message.split()).partition(". ")[0].rstrip(".")


QUAD = OutsideRoute(name="quad", title="scipy.integrate.quad in beta, one call a component", settings=TOLERANCES,
                    run=_quad)
QUAD_POINTS = OutsideRoute(name="quad_points", title="the same, told where contacts begin to slide or open",
                           settings=TOLERANCES, run=_quad_with_points)
QUAD_VEC = OutsideRoute(name="quad_vec", title="scipy.integrate.quad_vec in beta, all components at once",
                        settings=TOLERANCES, run=_quad_vec)
