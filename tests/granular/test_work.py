"""What routes say that they do is what they do: the same code run on numbers that count."""

from __future__ import annotations

import math
import sys
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import pytest

from granular.fabric import AxialFabric
from granular.generated import kinetic, mohr_circle, spheroid, static_constant
from granular.hypothesis import Hypothesis
from granular.loading import Loading
from granular.routes import (
    arithmetic,
    axial,
    axial_rules,
    closed_form,
    contact_rule,
    log_tangent,
    log_tangent_opening,
    meridian,
    opening_rule,
    plain_rule,
)
from granular.routes.work import Work

sys.path.insert(0, str(Path(__file__).parents[1]))
from counting import TALLY, Number, counting, total

RTOL = (1e-3, 1e-8, 1e-12)

CASES = [
    (AxialFabric(), None),
    (AxialFabric(D33=0.3, Dr33=-0.3), None),
    (AxialFabric(D33=0.3, D3333=0.1, Dr33=1.9), None),
    (AxialFabric(D33=-0.3, D3333=1.2), None),
    (AxialFabric(D33=0.3, Dr33=-0.3), Loading.of_ratio(1.5)),
    (AxialFabric(D33=0.3, D3333=0.1), Loading.of_ratio(1.5, friction=0.0)),
    (AxialFabric(D33=0.3), Loading.of_ratio(1e30)),
    (AxialFabric(D33=0.3, Dr33=-0.3), Loading.of_ratio(1.2, friction=0.3)),
    (AxialFabric(D33=0.3, D3333=0.1), Loading.of_ratio(2.0, friction=0.2)),
    (AxialFabric(D33=-0.3, D3333=1.2), Loading.of_ratio(0.3, friction=0.2)),
    (AxialFabric(), Loading.of_ratio(4 * (1 + 1e-9), friction=0.75)),
    (AxialFabric(Dr33=0.5), Loading.of_ratio(0.0, friction=0.75)),
    (AxialFabric(D33=0.3), Loading.of_ratio(-0.2, friction=0.2)),
    (AxialFabric(D33=0.3), Loading.of_ratio(-0.2)),
    (AxialFabric(D33=0.3), Loading.of_ratio(-1.2, friction=0.0)),
    (AxialFabric(D33=0.3), Loading(sigma11=Fraction(-1), sigma33=Fraction(5), friction=0.4)),
    (AxialFabric(D33=0.3, aspect_ratio=0.8), None),
    (AxialFabric(D33=0.3, aspect_ratio=0.8, free_spin=True), None),
    (AxialFabric(D33=0.3, D3333=0.1, aspect_ratio=1.5), Loading.of_ratio(1.2)),
    (AxialFabric(D33=0.3, aspect_ratio=1.5), Loading.of_ratio(1.2, friction=0.3)),
    (AxialFabric(aspect_ratio=1.5, free_spin=True), Loading.of_ratio(3.0, friction=0.2)),
]


SERIES = {kinetic: ("kinetic_moments", "kinetic_static_moments"), static_constant: ("static_moments",),
          spheroid: ("spheroid_moments",)}
"""Emitted series, which the closed forms feed with floats."""


@pytest.fixture
def counted(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let every number that a table gives, and every root, count."""
    def of_rule(*args: object) -> object:
        rule = axial_rules.axial_rule.__wrapped__(*args)
        numbers = [tuple(map(Number, column)) for column in rule.columns]
        return axial_rules.AxialRule(*(tuple(map(Number, part)) for part in (
            rule.sine_squared, rule.cosine_squared, rule.measure)), tuple(numbers))

    kept = plain_rule.plain_rule
    for module in (axial, contact_rule):
        monkeypatch.setattr(module, "axial_rule", of_rule)
    monkeypatch.setattr(contact_rule, "suitable_contacts", contact_rule.suitable_contacts.__wrapped__)
    def of_plain_rule(*args: object) -> object:
        before = replace(TALLY)
        directions = kept(*args)
        TALLY.operations, TALLY.functions = before.operations, before.functions
        return meridian.Directions(*(tuple(map(Number, part)) for part in (
            directions.sine_squared, directions.cosine_squared, directions.measure)))

    monkeypatch.setattr(plain_rule, "plain_rule", of_plain_rule)
    for module in (log_tangent, log_tangent_opening):
        for name in ("hyperbolic", "one_sided"):
            table = getattr(module, name)
            monkeypatch.setattr(module, name, lambda *args, table=table: [
                tuple(map(Number, row)) for row in table(*args)])
    for name in ("sticking_node", "beside_node", "between_node"):
        emitted = getattr(log_tangent, name)
        monkeypatch.setattr(log_tangent, name, lambda *args, emitted=emitted: emitted(*map(Number, args)))
    emitted_modules = (mohr_circle, kinetic, static_constant)
    for module in (meridian, contact_rule, opening_rule, log_tangent_opening, *emitted_modules):
        for name in ("sqrt", "cbrt"):
            if hasattr(module, name):
                monkeypatch.setattr(module, name, counting(getattr(math, name)))
    numbers = arithmetic.Arithmetic(name="counting", number=Number, total=total, finished=arithmetic.within_range)
    for module in (axial, closed_form):
        monkeypatch.setattr(module, "arithmetic_for", lambda rtol: numbers)
    for module, names in SERIES.items():
        for name in names:
            series = getattr(module, name)
            monkeypatch.setattr(module, name, lambda *args, series=series: series(*map(Number, args)))
    TALLY.operations = TALLY.functions = 0


def stiff(fabric: AxialFabric, loading: Loading | None, hypothesis: Hypothesis) -> bool:
    """Whether there is a stiffness: the static one needs contacts that stick, and knows no spin."""
    return hypothesis is Hypothesis.KINEMATIC or not (
        fabric.free_spin or (loading is not None and loading.slides(fabric.D33)))


ALL = [(*case, hypothesis) for case in CASES for hypothesis in Hypothesis if stiff(*case, hypothesis)]
COVERED = [case for case in ALL if closed_form.covers(case[0], case[2], case[1])]


@pytest.mark.parametrize("rtol", RTOL)
@pytest.mark.parametrize(("fabric", "loading", "hypothesis"), ALL)
def test_the_axial_route_counts_right(fabric: AxialFabric, loading: Loading | None, hypothesis: Hypothesis,
                                      rtol: float, counted: None) -> None:
    """An operation more or less in a node, a sum or an end breaks it."""
    result = axial.evaluate(fabric, poisson_ratio=0.21, hypothesis=hypothesis, loading=loading, rtol=rtol)
    assert result.work == Work(TALLY.operations, TALLY.functions), (result.evaluations, TALLY)


@pytest.mark.parametrize(("fabric", "loading", "hypothesis"), COVERED)
def test_the_closed_forms_count_right(fabric: AxialFabric, loading: Loading | None, hypothesis: Hypothesis,
                                      counted: None) -> None:
    """An emitted form that grows, or is called in another way, breaks it."""
    result = closed_form.evaluate(fabric, poisson_ratio=0.21, hypothesis=hypothesis, loading=loading, rtol=1e-9)
    assert result.work == Work(TALLY.operations, TALLY.functions)
