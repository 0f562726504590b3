"""Kernels of ``granular.batch`` against moving the same arrays: ratios measured side by side, printed, never judged."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np
import pytest

from granular.batch import constant, kinetic
from granular.batch.engines import Engine
from granular.batch.evaluation import evaluate_batch
from granular.batch.kernel import Kernel
from granular.speed.interleaved import Measured, Way, measure
from granular.speed.limit import moved
from granular.speed.sample import sample

pytestmark = pytest.mark.benchmark

ROUNDS = 15
KERNELS = [constant.KINEMATIC, constant.STATIC, kinetic.KINEMATIC]


def arguments(kernel: Kernel, size: int) -> tuple[np.ndarray, ...]:
    """One array for each input; Poisson's ratio varies like the others."""
    drawn = sample(size)
    known = {"D33": drawn.D33, "Dr33": drawn.Dr33, "stress_ratio": drawn.stress_ratio,
             "poisson_ratio": np.random.default_rng(7).uniform(0, 0.5, size)}
    return tuple(known[name] for name in kernel.inputs)


def ways(kernel: Kernel, size: int) -> list[Way]:
    """The limit, both engines, and the compiled one on two threads."""
    inputs, out = arguments(kernel, size), np.zeros((size, 6))

    def way(name: str, **options: object) -> Way:
        call: Callable[[], object] = partial(evaluate_batch, kernel, inputs, out, **options)
        return Way(name=name, elements=size, call=call)

    return [Way(name="moving the same arrays", elements=size, call=moved(inputs, out)),
            *(way(f"{engine.value}, one thread", engine=engine, threads=1) for engine in reversed(Engine)),
            way("compiled, two threads", engine=Engine.COMPILED, threads=2)]


def shown(found: Measured) -> str:
    return (f"{found.name:24} {found.elements:8} elements {found.nanoseconds:8.2f} ns each, "
            f"{found.ratio:6.2f} times (least over least {found.least:6.2f})")


@pytest.mark.parametrize("size", [100, 10_000, 1_000_000])
@pytest.mark.parametrize("kernel", KERNELS, ids=lambda kernel: kernel.name)
def test_against_moving_the_arrays(kernel: Kernel, size: int) -> None:
    """Constant stiffness is to stay below 1.15 times the move of a million elements, the kinetic fabric below 4.5."""
    print(f"\n{kernel.name}")
    for found in measure(ways(kernel, size), rounds=ROUNDS):
        print(shown(found))
