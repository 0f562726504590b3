"""The Gauss rule along the meridian: exactness, node counts, ends of the region, and its twin for arrays."""

from __future__ import annotations

import math
import subprocess
import sys
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from granular.checks.comparison import worst_component
from granular.checks.sample import admissible_sample
from granular.errors import RouteOutOfDomain
from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.routes import axial, axial_array, certified
from granular.routes.axial_rules import STEP, Axis, axial_rule, crowding, nodes_needed

ULP = 2.0**-52
NEXT_TO_MINUS_ONE, NEXT_TO_TWO = math.nextafter(-1.0, 0.0), math.nextafter(2.0, 0.0)


def error(components: tuple[float, ...], fabric: AxialFabric, nu: float, hypothesis: Hypothesis) -> float:
    """Relative error of the worst component that is not zero; a wrong zero counts as 1."""
    enclosures = certified.enclose(fabric, poisson_ratio=nu, hypothesis=hypothesis)
    return max(float(abs(Fraction(value) - e.midpoint) / (abs(e.midpoint) or 1) if e.midpoint or not value else 1)
               for value, e in zip(components, enclosures, strict=True))


@given(D33=st.floats(-1, 2), Dr33=st.floats(NEXT_TO_MINUS_ONE, NEXT_TO_TWO), nu=st.just(0.0) | st.floats(1e-200, 0.5))
@settings(max_examples=150, deadline=None)
def test_declared_error_holds(D33: float, Dr33: float, nu: float) -> None:
    """Some admissible fabric of rank two errs by more than is declared."""
    fabric = AxialFabric(D33=D33, Dr33=Dr33)
    for hypothesis in Hypothesis:
        result = axial.evaluate(fabric, poisson_ratio=nu, hypothesis=hypothesis)
        assert error(result.components, fabric, nu, hypothesis) <= result.relative_error


@pytest.mark.parametrize("nu", [0.0, 1e-200, 0.21, 0.5])
@pytest.mark.parametrize("Dr33", [NEXT_TO_MINUS_ONE, -1 + 1e-9, 0.0, 2 - 1e-9, NEXT_TO_TWO])
@pytest.mark.parametrize("D33", [-1.0, -1 + 1e-16, 0.3, 2.0])
def test_corners_of_the_region(D33: float, Dr33: float, nu: float) -> None:
    """E and W vanish at the same end, or at opposite ends, to the last representable number."""
    fabric = AxialFabric(D33=D33, Dr33=Dr33)
    for hypothesis in Hypothesis:
        result = axial.evaluate(fabric, poisson_ratio=nu, hypothesis=hypothesis)
        component, units = worst_component(result.components, [
            e.midpoint for e in certified.enclose(fabric, poisson_ratio=nu, hypothesis=hypothesis)])
        assert units <= 4, component


def test_eight_nodes_integrate_the_polynomial() -> None:
    """E W^2 s^2 with D3333 has degree 12 in x: 8 Gauss nodes are exact for degree 15, 4 nodes only for degree 7."""
    fabric = AxialFabric(D33=1.186, D3333=1.5, Dr33=1.9)
    for nodes, exactly in ((8, True), (4, False)):
        rule = axial_rule(Axis.EQUATOR, 0.0, nodes)
        components = axial.components_by_rule(fabric, poisson_ratio=0.21, hypothesis=Hypothesis.KINEMATIC, rule=rule)
        # 8 ulp: rounding of eight products, times 6 where terms of the density cancel.
        assert (error(components, fabric, 0.21, Hypothesis.KINEMATIC) < 8 * ULP) is exactly


def test_gauss_rules_reproduce_every_monomial_they_should() -> None:
    """A stored node or weight is wrong; exact value B(m + 1/2, 5 - m)/2 of the columns."""
    for nodes in (8, 28, 80):
        rule = axial_rule(Axis.EQUATOR, 0.0, nodes)
        for m, column in enumerate(rule.columns):
            exactly = math.gamma(m + 0.5) * math.gamma(5 - m) / (2 * math.gamma(5.5))
            assert math.fsum(column) == pytest.approx(exactly, rel=8 * ULP)


@pytest.mark.parametrize(("Dr33", "axis"), [(1.85, Axis.EQUATOR), (1.99, Axis.EQUATOR), (-0.9, Axis.POLE),
                                            (-0.95, Axis.POLE), (NEXT_TO_TWO, Axis.EQUATOR),
                                            (NEXT_TO_MINUS_ONE, Axis.POLE)])
def test_no_node_is_missing(Dr33: float, axis: Axis) -> None:
    """Too few nodes would show against more of them, and far too few show."""
    fabric = AxialFabric(D33=0.3, Dr33=Dr33)
    rule = axial.suitable_rule(fabric, Hypothesis.STATIC)
    assert crowding(1 - Dr33 / 2, 1 + Dr33)[0] is axis

    def components(nodes: int) -> tuple[float, ...]:
        return axial.components_by_rule(fabric, poisson_ratio=0.21, hypothesis=Hypothesis.STATIC,
                                        rule=axial.suitable_rule(fabric, Hypothesis.STATIC, nodes=nodes))

    assert components(len(rule)) == pytest.approx(components(80), rel=4 * ULP)
    assert components(8) != pytest.approx(components(80), rel=1e-12)


def test_rules_crowd_where_the_branches_are_short() -> None:
    """The rule is chosen for the wrong end, or L leaves the range for which node counts were found."""
    lengths = []
    for exponent in range(-53, 55):
        axis, length = crowding(1.0, 2.0**exponent)
        assert axis is (Axis.POLE if exponent < 0 else Axis.EQUATOR)
        assert length % STEP == 0
        assert nodes_needed(length) in (28, 80)
        lengths.append(length)
    assert min(lengths) == STEP
    assert max(lengths) <= 20


def test_rounded_nodes_keep_their_relative_accuracy() -> None:
    """Small s near the pole, or x^2 near the equator, comes out of a subtraction from 1."""
    for axis, small in ((Axis.POLE, "sine_squared"), (Axis.EQUATOR, "cosine_squared")):
        rule = axial_rule(axis, 20.0, 80)
        nearest, other = min(getattr(rule, small)), max(rule.sine_squared if axis is Axis.EQUATOR
                                                        else rule.cosine_squared)
        assert 0 < nearest < 1e-17
        assert other == 1.0


def test_the_scalar_path_needs_no_numpy() -> None:
    """An import of numpy slipped into the route of single scenes."""
    code = ("import sys; from granular.fabric import AxialFabric; from granular.hypothesis import Hypothesis;"
            "from granular.routes import axial;"
            "axial.evaluate(AxialFabric(Dr33=1.9), poisson_ratio=0.2, hypothesis=Hypothesis.STATIC);"
            "print('numpy' in sys.modules)")
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.strip() == "False"


def test_wanted_accuracy() -> None:
    """An accuracy that is not kept is promised, or one that is kept is refused."""
    fabric = AxialFabric()
    axial.evaluate(fabric, poisson_ratio=0.21, hypothesis=Hypothesis.STATIC, rtol=1e-12)
    for rtol in (1e-16, 0.0, -1.0, math.nan):
        with pytest.raises(RouteOutOfDomain):
            axial.evaluate(fabric, poisson_ratio=0.21, hypothesis=Hypothesis.STATIC, rtol=rtol)


@pytest.mark.parametrize("hypothesis", Hypothesis)
def test_the_array_twin_agrees(hypothesis: Hypothesis) -> None:
    """An element of an array errs by more than is declared, or takes another rule than its scalar twin."""
    sample = list(admissible_sample(200, seed=3))
    found = axial_array.components(
        [fabric.D33 for fabric, _ in sample], [fabric.Dr33 for fabric, _ in sample], [nu for _, nu in sample],
        D3333=[fabric.D3333 for fabric, _ in sample], hypothesis=hypothesis)
    for (fabric, nu), row in zip(sample, found.tolist(), strict=True):
        assert error(tuple(row), fabric, nu, hypothesis) <= axial_array.RELATIVE_ERROR


def test_array_arguments_broadcast() -> None:
    """Shapes do not combine as those of a NumPy ufunc, or an element depends on its neighbours or on its block."""
    D33, Dr33 = np.linspace(-1, 2, 5)[:, None], np.array([NEXT_TO_MINUS_ONE, 0.0, NEXT_TO_TWO])
    together = axial_array.components(D33, Dr33, 0.21, hypothesis=Hypothesis.STATIC)
    assert together.shape == (5, 3, 6)
    alone = axial_array.components(D33[4, 0], Dr33[2], 0.21, hypothesis=Hypothesis.STATIC)
    # The order of summation inside a matrix product may depend on its size: one unit in each of three moments.
    assert together[4, 2] == pytest.approx(alone, rel=4 * ULP)
    many = np.full(axial_array.BLOCK + 7, 0.3)
    repeated = axial_array.static_moments(many, -0.3)
    assert repeated.shape == (3, many.size)
    assert np.ptp(repeated, axis=1) == pytest.approx(0, abs=4 * ULP)
    assert axial_array.static_moments([], []).shape == (3, 0)
