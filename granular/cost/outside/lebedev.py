"""Lebedev rules over the sphere of two libraries, read once and kept."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import lru_cache, partial
from typing import Any

from granular.cost.outside.arithmetic import Arrays, library
from granular.cost.outside.averages import Tally, outcome
from granular.cost.outside.integrand import Direction, on_sphere
from granular.cost.outside.route import MOST_ARRAY, OutsideRoute
from granular.cost.records import Outcome
from granular.cost.scenes import CostScene

DEGREES = {f"degree {degree}": degree for degree in (5, 11, 17, 29, 47, 83, 131)}


Rule = tuple[Any, Any, str | None]
"""Directions, weights with the sum 1, and what the library warns of."""


@lru_cache
def _scipy_rule(degree: int) -> Rule:
    from scipy.integrate import lebedev_rule

    points, weights = lebedev_rule(degree)
    return points, weights / (4 * math.pi), None


@lru_cache
def _quadpy_rule(degree: int) -> Rule:
    import warnings

    schemes = library("quadpy").u3.schemes
    with warnings.catch_warnings(record=True) as heard:
        warnings.simplefilter("always")
        rule = schemes[f"lebedev_{degree:03d}"]()
    return rule.points, rule.weights, str(heard[0].message).rstrip(".") if heard else None


def _run(rule: Callable[[int], Rule], scene: CostScene, degree: int) -> Outcome:
    import numpy as np

    tally = Tally(MOST_ARRAY)
    points, weights, tally.warning = rule(degree)

    def average(function: Callable[[Direction], tuple[Any, ...]], _count: int) -> Sequence[Any]:
        tally.add(weights.size)
        n1, n2, n3 = points
        return [float(weights @ values) for values in function(on_sphere(n1, n2, abs(n3), np.hypot(n1, n2)))]

    return outcome(scene, Arrays(), average, tally)


SCIPY = OutsideRoute(name="lebedev_scipy", title="Lebedev rule of SciPy", settings=DEGREES,
                     run=partial(_run, _scipy_rule))
QUADPY = OutsideRoute(name="lebedev_quadpy", title="Lebedev rule of quadpy", settings=DEGREES,
                      run=partial(_run, _quadpy_rule))
