"""Tanh-sinh rule in beta, on pieces that end where contacts begin to slide or to open."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import lru_cache
from itertools import pairwise
from typing import Any

from granular.cost.outside.arithmetic import Arrays
from granular.cost.outside.averages import Tally, along_beta, break_points, outcome
from granular.cost.outside.route import MOST_ARRAY, OutsideRoute
from granular.cost.records import Outcome
from granular.cost.scenes import CostScene

LEVELS = {f"level {level}": level for level in (1, 2, 3, 4, 5)}
"""The step is halved at each level."""

FARTHEST = 3.3
"""Beyond this the nodes come closer to the ends than doubles can tell."""


@lru_cache
def _rule(level: int) -> tuple[Any, Any]:
    """Nodes and weights on [0, 1], made once."""
    import numpy as np

    step = 2.0**-level
    t = step * np.arange(-int(FARTHEST / step), int(FARTHEST / step) + 1)
    inner = math.pi / 2 * np.sinh(t)
    return 1 / (1 + np.exp(-2 * inner)), step * math.pi / 4 * np.cosh(t) / np.cosh(inner) ** 2


def _run(scene: CostScene, level: int) -> Outcome:
    import numpy as np

    points, weights = _rule(level)
    tally = Tally(MOST_ARRAY)

    def integral(function: Callable[[Any], Sequence[Any]], count: int, low: float, high: float,
                 edges: Sequence[float]) -> Sequence[Any]:
        total = np.zeros(count)
        for start, end in pairwise([low, *edges, high]):
            values = function(start + (end - start) * points)
            total += [(end - start) * float(weights @ value) for value in values]
        return [float(value) for value in total]

    average = along_beta(integral, break_points(scene), tally, math.pi / 2, np)
    return outcome(scene, Arrays(), average, tally, integral)


TANH_SINH = OutsideRoute(name="tanh_sinh", title="tanh-sinh rule in beta, on pieces between the break points, NumPy",
                         settings=LEVELS, run=_run)
