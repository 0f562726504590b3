"""Integration in ball arithmetic: ``acb.integral`` of python-flint in beta, every digit of it proved."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any

from granular.cost.outside.arithmetic import library
from granular.cost.outside.averages import Tally, outcome, tangents_of_edges
from granular.cost.outside.integrand import Direction, meridian
from granular.cost.outside.route import OutsideRoute
from granular.cost.records import Outcome, RouteFailed
from granular.cost.scenes import CostScene

DIGITS = {f"{digits} digits": digits for digits in (15, 30)}
"""Decimal digits asked for [-]."""

MOST, DEEPEST = 20_000, 10_000
"""Evaluations of the integrand after which it is stopped, and bisections [-]."""

GUARD = 30
"""Bits of working precision beyond the digits [-]."""


class _Balls:
    """Balls on one piece of the meridian, where every contact sticks, or slides, or has opened.

    The scheme asks whether the integrand is analytic on a ball; roots then say no next to their branch cut.
    """

    def __init__(self, flint: Any) -> None:
        self.flint = flint
        self.slides = self.opened = self.analytic = False

    def number(self, value: Fraction) -> Any:
        return self.flint.arb(value.numerator) / value.denominator

    def sqrt(self, value: Any) -> Any:
        return value.sqrt(analytic=self.analytic) if isinstance(value, self.flint.acb) else value.sqrt()

    def cbrt(self, value: Any) -> Any:
        third = self.flint.arb(1) / 3
        if not isinstance(value, self.flint.acb):
            return value**third
        if value == 0:
            return value
        if not self.analytic and value.is_finite() and value.contains(self.flint.acb(0)):
            bound = self.flint.arb(0, abs(value).upper() ** third)  # next to the edge of the sliding range
            return self.flint.acb(bound, bound)
        return value.pow(self.flint.acb(third), analytic=self.analytic)

    def pressed(self, force: Any) -> Any:
        return 0 * force if self.opened else force

    def left(self, shear: Any, limit: Any) -> Any:
        return 0 * shear if self.slides else 1 - shear / limit


def _run(scene: CostScene, digits: int) -> Outcome:
    flint = library("flint")
    tally, numbers = Tally(sys.maxsize), _Balls(flint)
    with flint.ctx.workprec(int(3.33 * digits) + GUARD):
        edges = [edge.atan() for edge in tangents_of_edges(scene, numbers.sqrt, numbers.number)]
        pieces = [(flint.acb(low), flint.acb(high), *_state(scene, low, high))
                  for low, high in pairwise([flint.arb(0), *edges, flint.arb.pi() / 2])]
        wanted = flint.arb(10) ** -digits

        def average(function: Callable[[Direction], tuple[Any, ...]], count: int) -> Sequence[Any]:
            return [sum((_integral(function, index, piece) for piece in pieces), flint.arb(0))
                    for index in range(count)]

        def _integral(function: Callable[[Direction], tuple[Any, ...]], index: int, piece: tuple[Any, ...]) -> Any:
            low, high, numbers.slides, numbers.opened = piece

            def along(beta: Any, analytic: bool) -> Any:
                tally.add()
                numbers.analytic = analytic
                sine = beta.sin()
                return function(meridian(beta.cos(), sine))[index] * sine

            left = MOST - tally.evaluations
            if left <= 0:
                raise RouteFailed(f"stopped after {MOST} evaluations of the integrand")
            return flint.acb.integral(along, low, high, rel_tol=wanted, abs_tol=wanted / 1000, eval_limit=left,
                                      depth_limit=DEEPEST).real

        result = outcome(scene, numbers, average, tally, exact=lambda component: component)
        return _read(result, digits)


def _state(scene: CostScene, low: Any, high: Any) -> tuple[bool, bool]:
    """Whether contacts slide and whether they have opened on a piece, by its middle."""
    middle = (float(low.mid()) + float(high.mid())) / 2
    if scene.loading is None:
        return False, False
    a, c = (float(force) for force in scene.loading.coefficients(scene.fabric.D33))
    sine, cosine = math.sin(middle), math.cos(middle)
    force = a * sine**2 + c * cosine**2
    limit = math.inf if scene.loading.friction is None else scene.loading.friction * force
    opened = force <= 0
    return opened or abs(c - a) * sine * cosine >= limit, opened


def _read(result: Outcome, digits: int) -> Outcome:
    """Middles and the relative radius of the worst component."""
    balls: Sequence[Any] = result.components
    if not all(ball.is_finite() for ball in balls):
        raise RouteFailed("the enclosure is infinite")
    ends = [tuple(_fraction(end) for end in (ball.lower(), ball.upper())) for ball in balls]
    middles = [(low + high) / 2 for low, high in ends]
    radius = max(float((high - low) / 2 / abs(middle)) for (low, high), middle in zip(ends, middles, strict=True))
    wide = None if radius <= 10.0 ** (2 - digits) else f"the enclosure has a relative radius of {radius:.1e}"
    return Outcome(middles, radius, result.evaluations, wide)


def _fraction(ball: Any) -> Fraction:
    mantissa, exponent = ball.mid().man_exp()
    return Fraction(int(mantissa)) * Fraction(2) ** int(exponent)


BALLS = OutsideRoute(name="ball_integral", title="acb.integral of python-flint in beta, between the break points",
                     settings=DIGITS, run=_run)
