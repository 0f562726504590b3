"""SciPy's adaptive rules over the sphere: ``cubature`` and ``nquad`` in beta and phi, over one octant."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

from granular.cost.outside.arithmetic import Arrays, Floats
from granular.cost.outside.averages import Tally, outcome
from granular.cost.outside.integrand import Direction, on_sphere
from granular.cost.outside.route import MOST_ARRAY, MOST_SCALAR, TOLERANCES, OutsideRoute
from granular.cost.records import NotServed, Outcome
from granular.cost.scenes import CostScene

HALF_PI = math.pi / 2
"""End of beta and of phi [rad]; a mean over the sphere is 2/pi times the integral over the octant."""

NESTED_TOLERANCES = {name: rtol for name, rtol in TOLERANCES.items() if rtol >= 1e-9}


def _cubature(scene: CostScene, rtol: float) -> Outcome:
    import numpy as np
    import scipy
    import scipy.integrate

    cubature = getattr(scipy.integrate, "cubature", None)
    if cubature is None:
        raise NotServed(f"SciPy {scipy.__version__} has no cubature; it came with 1.15")
    tally = Tally(MOST_ARRAY)

    def average(function: Callable[[Direction], tuple[Any, ...]], _count: int) -> Sequence[Any]:
        def over(points: Any) -> Any:
            beta, phi = points.T
            tally.add(beta.size)
            sine = np.sin(beta)
            n = on_sphere(sine * np.cos(phi), sine * np.sin(phi), np.cos(beta), sine)
            return np.array([np.broadcast_to(value * sine, beta.shape) for value in function(n)]).T

        found = cubature(over, [0.0, 0.0], [HALF_PI, HALF_PI], rtol=rtol, atol=0.0)
        if found.status != "converged":
            tally.warning = f"{found.subdivisions} subdivisions did not reach the tolerance"
        return [float(value) / HALF_PI for value in found.estimate]

    return outcome(scene, Arrays(), average, tally)


def _nquad(scene: CostScene, rtol: float) -> Outcome:
    import warnings

    from scipy.integrate import IntegrationWarning, nquad

    tally = Tally(MOST_SCALAR)

    def average(function: Callable[[Direction], tuple[Any, ...]], count: int) -> Sequence[Any]:
        def over(beta: float, phi: float, component: int) -> float:
            tally.add()
            sine = math.sin(beta)
            n = on_sphere(sine * math.cos(phi), sine * math.sin(phi), math.cos(beta), sine)
            return float(function(n)[component] * sine)

        square, options = [(0.0, HALF_PI), (0.0, HALF_PI)], {"epsabs": 0.0, "epsrel": rtol}
        with warnings.catch_warnings(record=True) as heard:
            warnings.simplefilter("always", IntegrationWarning)
            values = [float(nquad(over, square, args=(component,), opts=options)[0]) / HALF_PI
                      for component in range(count)]
        if heard:
            tally.warning = " ".join(str(heard[0].message).split()).partition(". ")[0].rstrip(".")
        return values

    return outcome(scene, Floats(), average, tally)


CUBATURE = OutsideRoute(name="cubature", title="scipy.integrate.cubature over an octant, all components at once",
                        settings=TOLERANCES, run=_cubature)
NQUAD = OutsideRoute(name="nquad", title="scipy.integrate.nquad over an octant, one call a component",
                     settings=NESTED_TOLERANCES, run=_nquad)
