"""What accuracy costs: ratios of times measured side by side, printed and never judged."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable
from itertools import pairwise

import numpy as np
import pytest
import quadpy

from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.routes import axial, certified, sphere

pytestmark = pytest.mark.benchmark

FABRIC = AxialFabric(D33=0.3, Dr33=-0.3)


def seconds(call: Callable[[], object], repeats: int = 20) -> float:
    start = time.perf_counter()
    for _ in range(repeats):
        call()
    return (time.perf_counter() - start) / repeats


def side_by_side(calls: dict[str, Callable[[], object]], rounds: int = 9) -> dict[str, float]:
    """Median over the rounds of each time over that of the first call in the same round."""
    observed: dict[str, list[float]] = {name: [] for name in calls}
    for _ in range(rounds):
        times = {name: seconds(call) for name, call in calls.items()}
        first = next(iter(times.values()))
        for name, value in times.items():
            observed[name].append(value / first)
    return {name: statistics.median(values) for name, values in observed.items()}


def test_spherical_rules_of_two_libraries() -> None:
    """Error and time of rules on the sphere, per library and degree; errors must fall with the degree."""
    known = [float(e.midpoint) for e in certified.enclose(FABRIC, poisson_ratio=0.21, hypothesis=Hypothesis.STATIC)]
    calls: dict[str, Callable[[], object]] = {
        "axial 28": lambda: axial.evaluate(FABRIC, poisson_ratio=0.21, hypothesis=Hypothesis.STATIC)}
    errors: dict[str, float] = {}

    def error(components: tuple[float, ...]) -> float:
        return max(abs(value / exactly - 1) for value, exactly in zip(components, known, strict=True))

    for name in ("mclaren_05", "heo_xu_13", "lebedev_017", "lebedev_029", "lebedev_047"):
        rule = quadpy.u3.schemes[name]()

        def by_rule(points: np.ndarray = rule.points, weights: np.ndarray = rule.weights) -> tuple[float, ...]:
            return sphere.components_by_cubature(FABRIC, poisson_ratio=0.21, hypothesis=Hypothesis.STATIC,
                                                 directions=points, weights=weights)

        calls[name] = by_rule
        errors[name] = error(by_rule())
    own = error(axial.evaluate(FABRIC, poisson_ratio=0.21, hypothesis=Hypothesis.STATIC).components)
    print()
    for name, ratio in side_by_side(calls).items():
        print(f"{name:14} {ratio:8.2f} x axial 28   error {errors.get(name, own):.1e}")
    in_order = list(errors.values())
    assert all(later < earlier or later < 1e-13 for earlier, later in pairwise(in_order))
