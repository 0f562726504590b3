"""Time of values with slopes over the time of values, measured side by side; it tells and does not judge."""

from __future__ import annotations

import time
from collections.abc import Callable

import numpy as np
import pytest

import granular

ROUNDS = 7

SHAPES = {"constant": {"kinetic": False}, "kinetic": {}, "slip": {"friction": True},
          "constant, static": {"kinetic": False, "hypothesis": "static"}, "kinetic, static": {"hypothesis": "static"}}


def once(call: Callable[[], object]) -> float:
    """Processor time of one call [s]: other work on the machine does not count."""
    start = time.thread_time()
    call()
    return time.thread_time() - start


@pytest.mark.benchmark
@pytest.mark.parametrize("size", [100, 10_000, 200_000])
@pytest.mark.parametrize("name", SHAPES)
def test_slopes_over_values(name: str, size: int) -> None:
    """Prints the median and the least of the ratios; nothing fails."""
    options = dict(SHAPES[name])
    friction = options.pop("friction", False)
    count = min(size, 10_000) if friction or "static" in name else size
    rng = np.random.default_rng(1)
    state = (rng.uniform(-1, 2, count), rng.uniform(-0.9, 1.9, count), np.exp(rng.uniform(-1.09, 1.09, count)),
             np.exp(rng.uniform(-2, 1, count)) if friction else None, rng.uniform(0, 0.5, count))

    def values() -> object:
        return granular.axial_stiffness(*state, threads=1, **options)

    def slopes() -> object:
        return granular.axial_gradient(*state, threads=1, **options)

    values(), slopes()
    times = np.array([[once(values), once(slopes)] for _ in range(ROUNDS)])
    ratios = times[:, 1] / times[:, 0]
    print(f"\n{name}, {count} elements: values {times[:, 0].min() / count * 1e9:.0f} ns, with slopes "
          f"{np.median(ratios):.2f} times (median of {ROUNDS}), least over least "
          f"{times[:, 1].min() / times[:, 0].min():.2f}")
