"""The rules over directions and over panels say what they do: the same code run on numbers and arrays that count."""

from __future__ import annotations

import math
import sys
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

from granular.errors import ComplianceInfinite
from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.loading import Loading
from granular.routes import arithmetic, axial_rules, contact_rule, meridian, midpoint, sphere
from granular.routes.catalogue import ROUTES
from granular.routes.work import Work

sys.path.insert(0, str(Path(__file__).parents[1]))
from counting import TALLY, Number, Numbers, counting, total

KINEMATIC, STATIC = Hypothesis

SMOOTH = [
    (AxialFabric(), None),
    (AxialFabric(D33=0.3, Dr33=-0.3), None),
    (AxialFabric(D33=0.3, D3333=0.1), None),
    (AxialFabric(D33=0.3, Dr33=-0.3), Loading.of_ratio(1.5)),
    (AxialFabric(D33=0.3), Loading.of_ratio(1.5)),
    (AxialFabric(D33=0.3, aspect_ratio=0.8), None),
    (AxialFabric(D33=0.3, aspect_ratio=0.8, free_spin=True), None),
    (AxialFabric(D33=0.3, D3333=0.1, aspect_ratio=1.2), Loading.of_ratio(1.2)),
]
"""What a rule over the sphere serves."""

ROUGH = [
    (AxialFabric(D33=-0.3, D3333=1.2), Loading.of_ratio(0.3, friction=0.2)),
    (AxialFabric(D33=0.3, Dr33=-0.3), Loading.of_ratio(1.2, friction=0.3)),
    (AxialFabric(D33=0.3, D3333=0.1), Loading.of_ratio(1.5, friction=0.0)),
    (AxialFabric(D33=0.3), Loading.of_ratio(-0.2, friction=0.2)),
    (AxialFabric(D33=0.3), Loading.of_ratio(-0.2)),
    (AxialFabric(D33=0.3), Loading(sigma11=Fraction(-1), sigma33=Fraction(5), friction=0.4)),
    (AxialFabric(D33=0.3, aspect_ratio=1.5, free_spin=True), Loading.of_ratio(3.0, friction=0.2)),
]
"""What only the rule with panels serves: slip, opening, and both at once."""

TAKEN = (11, 35)
"""Degrees of rules over the sphere that are set against each other [-]."""


def counted_at(degree: int, monkeypatch: pytest.MonkeyPatch, fabric: AxialFabric, hypothesis: Hypothesis,
               loading: Loading | None) -> Work:
    """What NumPy does, element by element, for the rule of a degree; arrays stay what they are."""
    directions, weights = sphere._rule(degree)
    with monkeypatch.context() as patched:
        patched.setattr(np, "asarray", np.asanyarray)
        patched.setattr(sphere, "_rule", lambda degree: (directions.view(Numbers), weights.view(Numbers)))
        TALLY.operations = TALLY.functions = 0
        sphere.components_by_degree(fabric, poisson_ratio=0.21, hypothesis=hypothesis, degree=degree, loading=loading)
    return Work(TALLY.operations, TALLY.functions)


@pytest.mark.parametrize("hypothesis", Hypothesis)
@pytest.mark.parametrize(("fabric", "loading"), SMOOTH)
def test_the_rule_over_the_sphere_counts_right(fabric: AxialFabric, loading: Loading | None, hypothesis: Hypothesis,
                                               monkeypatch: pytest.MonkeyPatch) -> None:
    """An operation more or less in a direction breaks it; what does not grow with the directions cancels here."""
    promised = sphere.promise(fabric, hypothesis, loading, rtol=1e-3)
    if promised is None:
        pytest.skip("not served")
    few, many = (counted_at(degree, monkeypatch, fabric, hypothesis, loading) for degree in TAKEN)
    more = sphere.directions_of(TAKEN[1]) - sphere.directions_of(TAKEN[0])
    assert promised.work is not None
    assert (many.operations - few.operations) * promised.evaluations == promised.work.operations * more
    assert (many.functions - few.functions) * promised.evaluations == promised.work.functions * more


def test_sums_over_products_count_as_numpy_says(monkeypatch: pytest.MonkeyPatch) -> None:
    """Counts of sums over products follow another convention than NumPy's own report."""
    n, normals = np.ones((3, 50)), np.eye(3)
    report = np.einsum_path("iq,ij,jq->q", n, normals, n, optimize=False)[1]
    TALLY.operations = 0
    np.einsum("iq,ij,jq->q", n.view(Numbers), normals, n.view(Numbers))
    naive = next(line.split()[-1] for line in report.splitlines() if "Naive FLOP" in line)
    assert float(naive) == pytest.approx(TALLY.operations, rel=1e-3)  # the report gives four digits


@pytest.mark.parametrize("hypothesis", Hypothesis)
@pytest.mark.parametrize(("fabric", "loading"), SMOOTH)
@pytest.mark.parametrize("rtol", [1e-3, 1e-9, None])
def test_a_promise_of_the_sphere_is_kept(fabric: AxialFabric, loading: Loading | None, hypothesis: Hypothesis,
                                         rtol: float | None) -> None:
    """A plan predicts other directions or other work than an evaluation takes."""
    promised = ROUTES["sphere"].promise(fabric, hypothesis, loading, rtol)
    if promised is None:
        pytest.skip("not served")
    result = sphere.evaluate(fabric, poisson_ratio=0.21, hypothesis=hypothesis, loading=loading, rtol=rtol)
    assert promised.kept(result.components) == result


def test_a_rule_over_the_sphere_is_made_once() -> None:
    """Directions are made anew at every call, which their count leaves out, or can be changed by a caller."""
    directions, weights = sphere._rule(35)
    assert sphere._rule(35)[0] is directions
    with pytest.raises(ValueError, match="read-only"):
        weights[0] = 1.0


@pytest.fixture
def counted(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let the numbers of the panels, and every root, count."""
    nodes, rule = (replace(made(midpoint.PRINTED_PANELS)) for made in (midpoint.midpoint_panels,
                                                                       midpoint.midpoint_rule))
    nodes = meridian.Directions(*(tuple(map(Number, part)) for part in (
        nodes.sine_squared, nodes.cosine_squared, nodes.measure)))
    rule = axial_rules.AxialRule(nodes.sine_squared, nodes.cosine_squared, nodes.measure,
                                 tuple(tuple(map(Number, column)) for column in rule.columns))
    monkeypatch.setattr(midpoint, "midpoint_panels", lambda panels: nodes)
    monkeypatch.setattr(midpoint, "midpoint_rule", lambda panels: rule)
    numbers = arithmetic.Arithmetic(name="counting", number=Number, total=total, finished=arithmetic.within_range)
    monkeypatch.setattr(midpoint, "arithmetic_for", lambda rtol: numbers)
    for module in (contact_rule, meridian):
        for name in ("sqrt", "cbrt"):
            if hasattr(module, name):
                monkeypatch.setattr(module, name, counting(getattr(math, name)))
    TALLY.operations = TALLY.functions = 0


@pytest.mark.parametrize("hypothesis", Hypothesis)
@pytest.mark.parametrize(("fabric", "loading"), SMOOTH + ROUGH)
def test_the_rule_with_panels_counts_right(fabric: AxialFabric, loading: Loading | None, hypothesis: Hypothesis,
                                           counted: None) -> None:
    """An operation more or less at a panel breaks it; so does a share of friction where contacts have opened."""
    if hypothesis is STATIC and (fabric.free_spin or (loading is not None and loading.slides(fabric.D33))):
        pytest.skip("no finite compliance")
    try:
        result = midpoint.evaluate(fabric, poisson_ratio=0.21, hypothesis=hypothesis, loading=loading)
    except ComplianceInfinite:
        pytest.skip("no finite compliance")
    assert result.work == Work(TALLY.operations, TALLY.functions), TALLY


@pytest.mark.parametrize(("fabric", "loading"), SMOOTH + ROUGH)
def test_a_promise_of_the_panels_is_kept(fabric: AxialFabric, loading: Loading | None) -> None:
    """A plan predicts other work than an evaluation takes, or one number of panels takes that of another."""
    result = midpoint.evaluate(fabric, poisson_ratio=0.21, hypothesis=KINEMATIC, loading=loading)
    promised = ROUTES["midpoint"].promise(fabric, KINEMATIC, loading, None)
    assert promised is not None
    assert promised.kept(result.components) == result
    other = midpoint.evaluate(fabric, poisson_ratio=0.21, hypothesis=KINEMATIC, loading=loading, panels=48)
    assert other == midpoint.promise(fabric, KINEMATIC, loading, panels=48).kept(other.components)
    assert other.work is not None
    assert result.work is not None
    assert other.work.operations > result.work.operations


def test_panels_of_spheroids_are_those_of_spheroids() -> None:
    """Spheroids with contacts of equal stiffness are answered with the stiffness of spheres."""
    for hypothesis in Hypothesis:
        fabric = AxialFabric(D33=0.3, aspect_ratio=0.8)
        found = midpoint.evaluate(fabric, poisson_ratio=0.21, hypothesis=hypothesis, panels=2000)
        known = ROUTES["axial"].evaluate(fabric, poisson_ratio=0.21, hypothesis=hypothesis)
        assert found.components == pytest.approx(known.components, rel=1e-6)  # 2000 panels err by 3e-3 (24/2000)^2


def test_proofs_declare_no_work() -> None:
    """Work is told of balls, whose operations have no fixed cost."""
    promised = ROUTES["certified"].promise(AxialFabric(), KINEMATIC, None, None)
    assert promised is not None
    assert promised.work is None
