"""Partial slip by tables against the kinetic kernel: ratios measured side by side, printed, never judged."""

from __future__ import annotations

from functools import partial

import numpy as np
import pytest

from granular.batch import kinetic, slip
from granular.batch.engines import Engine
from granular.batch.evaluation import evaluate_batch
from granular.batch.full_precision import with_forces
from granular.hypothesis import Hypothesis
from granular.speed.interleaved import Way, measure
from granular.speed.sample import FRICTION, sample

pytestmark = pytest.mark.benchmark

ROUNDS = 15
ACCURACY = 20_000
"""Elements whose error is printed beside the times."""


@pytest.mark.parametrize("size", [10_000, 1_000_000])
@pytest.mark.parametrize("engine", list(Engine))
def test_against_the_kinetic_kernel(engine: Engine, size: int) -> None:
    """One friction is to stay below 2.5 times the kinetic kernel at a million elements, any friction below 6 times."""
    drawn = sample(size)
    nu, out = np.random.default_rng(7).uniform(0, 0.5, size), np.zeros((size, 6))
    columns = [drawn.D33, drawn.Dr33, drawn.stress_ratio, nu]
    frictions = {"one friction": (slip.one_friction(FRICTION), np.array(FRICTION)),
                 "any friction": (slip.any_friction(), drawn.friction)}

    ways = [Way(name="kinetic", elements=size,
                call=partial(evaluate_batch, kinetic.KINEMATIC, columns, out, engine=engine, threads=1))]
    ways += [Way(name=name, elements=size,
                 call=partial(evaluate_batch, kernel, [*columns, friction], out, engine=engine, threads=1))
             for name, (kernel, friction) in frictions.items()]
    print(f"\n{engine.value}, one thread")
    for found in measure(ways, rounds=ROUNDS):
        print(f"{found.name:14} {found.elements:8} elements {found.nanoseconds:8.2f} ns each, "
              f"{found.ratio:6.2f} times kinetic (least over least {found.least:6.2f})")
    few = [column[:ACCURACY] for column in columns]
    for name, (kernel, friction) in frictions.items():
        mu = np.broadcast_to(friction, (size,))[:ACCURACY]
        ours = np.zeros((len(mu), 6))
        evaluate_batch(kernel, [*few, mu], ours, engine=engine)
        exact = with_forces(few[0], few[1], few[2], mu.copy(), few[3], Hypothesis.KINEMATIC)
        print(f"{name:14} largest relative error of {len(mu)} elements {np.nanmax(np.abs(ours / exact - 1)):.1e}")
