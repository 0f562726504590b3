"""From a rule for integrals to six components: what every outside route along the meridian shares."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

from granular.cost.outside import lengths
from granular.cost.outside.integrand import (
    Direction,
    Numbers,
    balance_integrand,
    balanced,
    meridian,
    problem_of,
    stiffness_integrand,
    stiffness_of,
)
from granular.cost.records import NotServed, Outcome, RouteFailed
from granular.cost.scenes import CostScene

Average = Callable[[Callable[[Direction], tuple[Any, ...]], int], Sequence[Any]]
"""Mean over all directions of a function with so many values."""

Integral = Callable[[Callable[[Any], Sequence[Any]], int, Any, Any, Sequence[Any]], Sequence[Any]]
"""Integral of a function with so many values between two ends, with break points in between."""


class Tally:
    """Counts the directions in which the integrand is evaluated, and stops a route that takes too many."""

    def __init__(self, most: int) -> None:
        """Start at nothing.

        Parameters
        ----------
        most : int
            Directions after which a route is stopped [-].
        """
        self.evaluations, self.most = 0, most
        self.warning: str | None = None

    def add(self, directions: int = 1) -> None:
        """Count directions.

        Raises
        ------
        RouteFailed
            There were too many.
        """
        self.evaluations += directions
        if self.evaluations > self.most:
            raise RouteFailed(f"stopped after {self.most} evaluations of the integrand")


def outcome(scene: CostScene, numbers: Numbers, average: Average, tally: Tally, integral: Integral | None = None, *,
            exact: Callable[[Any], Any] = float) -> Outcome:
    """Six components by a rule.

    Parameters
    ----------
    scene : CostScene
        What is computed.
    numbers : Numbers
        The arithmetic.
    average : callable
        The rule over directions.
    tally : Tally
        Counts of the rule.
    integral : callable or None
        The rule between two ends, for sizes of grains; None where it is none.
    exact : callable
        Takes a component to a float or a Fraction.

    Returns
    -------
    Outcome
        Components and count.

    Raises
    ------
    NotServed
        Sizes of grains, and the rule does not integrate over them.

    Notes
    -----
    Accuracy: that of the rule. Source: eqs (1)-(23).
    """
    if scene.spread is not None and integral is None:
        raise NotServed("not set up for the integrals over sizes of grains, one inside another")
    problem = problem_of(scene, numbers)
    if problem.static and problem.spheroid:
        fabric = problem
        problem = balanced(problem, average(lambda n: balance_integrand(fabric, n), 2))
    six = stiffness_of(problem, average(lambda n: stiffness_integrand(problem, n), 6))
    if scene.spread is not None and integral is not None:
        factor = lengths.length_factor(scene.spread, static=problem.static, integral=integral)
        six = tuple(component * factor for component in six)
    return Outcome([exact(component) for component in six], None, tally.evaluations, tally.warning)


def along_beta(integral: Integral, edges: Sequence[Any], tally: Tally, half_pi: Any = math.pi / 2,
               functions: Any = math) -> Average:
    """Mean over directions by a rule in beta over [0, pi/2].

    Parameters
    ----------
    integral : callable
        The rule between two ends.
    edges : sequence
        Break points in beta [rad].
    tally : Tally
        Counts the directions.
    half_pi : number
        pi/2 in that arithmetic [rad].
    functions : module
        Where ``sin`` and ``cos`` are.

    Returns
    -------
    callable
        The rule over directions.
    """
    def average(function: Callable[[Direction], tuple[Any, ...]], count: int) -> Sequence[Any]:
        def along(beta: Any) -> Sequence[Any]:
            tally.add(getattr(beta, "size", 1))
            sine = functions.sin(beta)
            return [value * sine for value in function(meridian(functions.cos(beta), sine))]

        return integral(along, count, 0 * half_pi, half_pi, edges)

    return average


def break_points(scene: CostScene) -> list[float]:
    """Angles at which contacts begin to slide or to open, or where they are nearest to sliding [rad]."""
    return [math.atan(tangent) for tangent in tangents_of_edges(scene, math.sqrt, float)]


def tangents_of_edges(scene: CostScene, sqrt: Callable[[Any], Any], number: Callable[[Any], Any]) -> list[Any]:
    """tan(beta) at which contacts begin to slide or to open, in increasing order [-].

    Parameters
    ----------
    scene : CostScene
        What is computed.
    sqrt : callable
        Square root in some arithmetic.
    number : callable
        Takes a rational number into that arithmetic.

    Returns
    -------
    list
        Roots t of a t^2 - (\\|c - a\\|/mu) t + c = 0, and of a t^2 + c = 0; where contacts are nearest to sliding if
        all stick.

    Notes
    -----
    Source: eqs (21) and (23).
    """
    from fractions import Fraction

    if scene.loading is None:
        return []
    a, c = scene.loading.coefficients(scene.fabric.D33)
    edges = [sqrt(number(-c / a))] if a * c < 0 else []
    if scene.loading.friction is not None and a != c:
        half = abs(c - a) / (2 * Fraction(scene.loading.friction))
        left = half * half - a * c
        if left > 0:
            far = number(half) + sqrt(number(left))  # a t for the larger root; the other follows from the product
            edges += [edge for edge in (number(c) / far, far / number(a)) if edge > 0]
        else:
            edges.append(sqrt(number(c / a)))
    return sorted(edges)
