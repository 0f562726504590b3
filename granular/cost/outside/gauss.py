"""Gauss-Legendre rules in x = cos(beta) and in beta, over the whole quarter circle, with no break points."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import lru_cache
from typing import Any

from granular.cost.outside.arithmetic import Arrays
from granular.cost.outside.averages import Tally, along_beta, outcome
from granular.cost.outside.integrand import Direction, meridian
from granular.cost.outside.route import MOST_ARRAY, OutsideRoute
from granular.cost.records import Outcome
from granular.cost.scenes import CostScene

NODES = {f"{nodes} nodes": nodes for nodes in (4, 8, 16, 32, 64, 128)}


@lru_cache
def _rule(nodes: int) -> tuple[Any, Any]:
    """Nodes and weights on [0, 1], made once."""
    import numpy as np

    points, weights = np.polynomial.legendre.leggauss(nodes)
    return (points + 1) / 2, weights / 2


def _integral(nodes: int) -> Callable[..., Sequence[Any]]:
    points, weights = _rule(nodes)

    def integral(function: Callable[[Any], Sequence[Any]], _count: int, low: Any, high: Any,
                 _edges: Sequence[Any]) -> Sequence[Any]:
        width = high - low
        return [width * float(weights @ values) for values in function(low + width * points)]

    return integral


def _in_beta(scene: CostScene, nodes: int) -> Outcome:
    import numpy as np

    tally, integral = Tally(MOST_ARRAY), _integral(nodes)
    average = along_beta(integral, (), tally, math.pi / 2, np)
    return outcome(scene, Arrays(), average, tally, integral)


def _in_x(scene: CostScene, nodes: int) -> Outcome:
    import numpy as np

    tally, integral = Tally(MOST_ARRAY), _integral(nodes)

    def average(function: Callable[[Direction], tuple[Any, ...]], count: int) -> Sequence[Any]:
        def along(x: Any) -> Sequence[Any]:
            tally.add(x.size)
            return function(meridian(x, np.sqrt((1 - x) * (1 + x))))

        return integral(along, count, 0.0, 1.0, ())

    return outcome(scene, Arrays(), average, tally, integral)


IN_X = OutsideRoute(name="gauss_x", title="Gauss-Legendre rule in x = cos(beta), NumPy", settings=NODES, run=_in_x)
IN_BETA = OutsideRoute(name="gauss_beta", title="Gauss-Legendre rule in beta, NumPy", settings=NODES, run=_in_beta)
