"""Quadrature of many digits: ``mpmath.quad`` in beta, on pieces between the break points."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from granular.cost.outside.arithmetic import Multiple, rational
from granular.cost.outside.averages import Tally, along_beta, outcome, tangents_of_edges
from granular.cost.outside.route import MOST_SCALAR, OutsideRoute
from granular.cost.records import Outcome
from granular.cost.scenes import CostScene

DIGITS = {f"{digits} digits": digits for digits in (15, 30, 50)}
"""Decimal digits of the working precision [-]."""

LOST = 3
"""Digits that may be lost before the estimated error counts as not reached [-]."""


def _run(scene: CostScene, digits: int) -> Outcome:
    numbers = Multiple()
    mp = numbers.mp
    tally = Tally(MOST_SCALAR)
    with mp.workdps(digits):
        edges = [mp.atan(edge) for edge in tangents_of_edges(scene, mp.sqrt, numbers.number)]

        def integral(function: Callable[[Any], Sequence[Any]], count: int, low: Any, high: Any,
                     ends: Sequence[Any]) -> Sequence[Any]:
            known: dict[Any, Sequence[Any]] = {}

            def component(beta: Any, index: int) -> Any:
                # the nodes of all components are the same
                if beta not in known:
                    known[beta] = function(beta)
                return known[beta][index]

            found = []
            for index in range(count):
                value, error = mp.quad(lambda beta, i=index: component(beta, i), [low, *ends, high], error=True)
                if error > mp.mpf(10) ** (LOST - digits) * abs(value):
                    tally.warning = f"its own estimate of the error is {mp.nstr(error / abs(value), 2)}"
                found.append(value)
            return found

        average = along_beta(integral, edges, tally, mp.pi / 2, mp)
        return outcome(scene, numbers, average, tally, exact=rational)


MPMATH = OutsideRoute(name="mpmath_quad", title="mpmath.quad in beta, on pieces between the break points",
                      settings=DIGITS, run=_run)
