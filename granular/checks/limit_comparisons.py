"""Every route against every limit."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import product

from granular.checks.comparison import Comparison, gap_in_ulp, worst_component
from granular.checks.limits import (
    Known,
    isotropic_kinematic,
    isotropic_static,
    kinematic_polynomial,
    kinematic_trace,
)
from granular.checks.voices import MOST_UNITS, Voice, allowed_units, attempt
from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.routes import axial, closed_form, sphere
from granular.routes.result import RouteResult

VOICES: tuple[Voice, ...] = (closed_form, axial, sphere)

FABRICS = tuple(AxialFabric(D33=d33, Dr33=dr33) for d33, dr33 in (
    (0.0, 0.0), (0.3, -0.3), (-1.0, 0.5), (2.0, -0.75), (1e-9, 1.5), (-0.25, -0.999), (1.5, 1.999)))

ISOTROPIC = {Hypothesis.KINEMATIC: isotropic_kinematic, Hypothesis.STATIC: isotropic_static}

POISSON_RATIOS = (0.0, 0.21, 0.5)

FRICTIONLESS = 1.0
"""No grain has this Poisson's ratio; k_r/k_n = 2 (1 - nu)/(2 - nu) vanishes there, which is a limit of the formulas."""


def limit_comparisons() -> Iterator[Comparison]:
    """Compare every route with every limit.

    Returns
    -------
    iterator of Comparison
        One for each limit, fabric, Poisson's ratio and route that serves them.

    Notes
    -----
    Accuracy: a component may be off by :func:`granular.checks.voices.allowed_units`, each term of an identity by as
    much, a zero by nothing. Source: eqs (4), (7) and (23).

    Examples
    --------
    >>> all(comparison.agrees for comparison in limit_comparisons() if comparison.route == "closed_form")
    True
    """
    for voice, nu in product(VOICES, POISSON_RATIOS):
        for fabric, hypothesis in product(FABRICS, Hypothesis):
            if outcome := _evaluate(voice, hypothesis, fabric, nu):
                yield from _identities(outcome)
                if hypothesis is Hypothesis.KINEMATIC:
                    yield _value(outcome, "polynomial in D, Dr", kinematic_polynomial)
        for hypothesis, known in ISOTROPIC.items():
            if outcome := _evaluate(voice, hypothesis, AxialFabric(), nu):
                yield _value(outcome, "isotropic K and G", known)
    for voice, fabric in product(VOICES, FABRICS):
        if outcome := _evaluate(voice, Hypothesis.KINEMATIC, fabric, FRICTIONLESS):
            yield from _frictionless(outcome)


@dataclass(frozen=True, slots=True)
class _Outcome:
    """What one route gave at one point."""

    voice: Voice
    hypothesis: Hypothesis
    fabric: AxialFabric
    nu: float
    result: RouteResult

    def comparison(self, group: str, component: str, error: float) -> Comparison:
        """Say how far off a component is, against what the route may be off."""
        return Comparison(group=group, case=f"D33 = {self.fabric.D33:g}, Dr33 = {self.fabric.Dr33:g}, nu = {self.nu:g}",
                          hypothesis=self.hypothesis, route=self.voice.NAME, component=component, error=error,
                          allowed=allowed_units(self.voice, self.result, aim=MOST_UNITS))


def _evaluate(voice: Voice, hypothesis: Hypothesis, fabric: AxialFabric, nu: float) -> _Outcome | None:
    result = attempt(voice, fabric, nu, hypothesis)
    return None if result is None else _Outcome(voice, hypothesis, fabric, nu, result)


def _value(outcome: _Outcome, group: str, known: Known) -> Comparison:
    component, error = worst_component(outcome.result.components, known(outcome.fabric, outcome.nu))
    return outcome.comparison(group, component, error)


def _identities(outcome: _Outcome) -> Iterator[Comparison]:
    c1111, c3333, c1122, c1133, _, c1212 = outcome.result.components
    yield outcome.comparison("C1212 identity", "C1212", gap_in_ulp([(2, c1212), (-1, c1111), (1, c1122)]))
    if outcome.hypothesis is Hypothesis.KINEMATIC:
        yield outcome.comparison("trace identity", "C3333", gap_in_ulp(
            [(1, c3333), (2, c1111), (2, c1122), (4, c1133)], kinematic_trace(outcome.fabric)))
    if outcome.nu == 0:
        error = 0.0 if c1122 == c1133 == 0 else math.inf
        yield replace(outcome.comparison("nu = 0: exact zeros", "C1122" if c1122 else "C1133", error), allowed=0.0)


def _frictionless(outcome: _Outcome) -> Iterator[Comparison]:
    _, _, c1122, c1133, c2323, c1212 = outcome.result.components
    yield outcome.comparison("no friction: C2323", "C2323", gap_in_ulp([(1, c2323), (-1, c1133)]))
    yield outcome.comparison("no friction: C1212", "C1212", gap_in_ulp([(1, c1212), (-1, c1122)]))
