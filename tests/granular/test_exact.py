"""Rational components, and the midpoint rule that the printed tables carry."""

from __future__ import annotations

import math
from fractions import Fraction
from types import ModuleType

import pytest

from granular.errors import ResultOutOfRange, RouteOutOfDomain
from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.routes import axial, certified, closed_form, exact, midpoint


def test_decimals_are_read_as_written() -> None:
    """0.3 is read as the binary number next to it where 3/10 is meant, or the other way round."""
    fabric = AxialFabric(D33=0.3)
    decimal = exact.rational_components(fabric, poisson_ratio=0.21)
    binary = exact.rational_components(fabric, poisson_ratio=0.21, decimal=False)
    assert decimal[0].denominator < 10**9 < binary[0].denominator
    assert float(abs(decimal[0] / binary[0] - 1)) < 2.0**-52


def test_identities_hold_exactly() -> None:
    """C1111 - C1122 = 2 C1212 and the sum without k_r, with a density of rank four, to the last digit."""
    fabric = AxialFabric(D33=0.25, D3333=-0.125, Dr33=0.5)
    sums = set()
    for nu in (0.0, 0.21, 0.5):
        c1111, c3333, c1122, c1133, _, c1212 = exact.rational_components(fabric, poisson_ratio=nu)
        assert c1111 - c1122 == 2 * c1212
        sums.add(c3333 + 2 * c1111 + 2 * c1122 + 4 * c1133)
    assert sums == {1 + Fraction(1, 10) + Fraction(1, 560)}


def test_only_the_final_rounding_is_lost() -> None:
    """A float slipped into the rational arithmetic."""
    fabric = AxialFabric(D33=-0.7, D3333=0.1, Dr33=1.3)
    result = exact.evaluate(fabric, poisson_ratio=0.3, hypothesis=Hypothesis.KINEMATIC)
    rational = exact.rational_components(fabric, poisson_ratio=0.3, decimal=False)
    assert result.components == tuple(float(value) for value in rational)
    assert (result.relative_error, result.evaluations) == (2.0**-53, 0)


def test_the_static_hypothesis_is_refused() -> None:
    """A static component, which is not rational, is passed off as exact."""
    with pytest.raises(RouteOutOfDomain, match="kinematic"):
        exact.evaluate(AxialFabric(), poisson_ratio=0.21, hypothesis=Hypothesis.STATIC)


@pytest.mark.parametrize("hypothesis", Hypothesis)
def test_the_midpoint_rule_is_of_second_order(hypothesis: Hypothesis) -> None:
    """The rule of the printed tables converges at another rate, that is, it is another rule."""
    fabric = AxialFabric(D33=0.3, Dr33=-0.3)

    def c3333(panels: int) -> float:
        return midpoint.evaluate(fabric, poisson_ratio=0.21, hypothesis=hypothesis, panels=panels).components[1]

    limit = c3333(6144)
    ratio = (c3333(96) - limit) / (c3333(192) - limit)
    assert ratio == pytest.approx(4, rel=1e-2)  # the next order is 1/96^2 of it, the limit itself errs by 1/32^2


def test_the_midpoint_rule_promises_nothing() -> None:
    """The rule of the printed tables is given an accuracy, or takes a number of panels that makes no sense."""
    arguments = {"poisson_ratio": 0.21, "hypothesis": Hypothesis.KINEMATIC}
    assert midpoint.evaluate(AxialFabric(), **arguments).relative_error == math.inf
    with pytest.raises(RouteOutOfDomain):
        midpoint.evaluate(AxialFabric(), **arguments, rtol=0.5)
    for panels in (1, 0, -24, 10_001):
        with pytest.raises(RouteOutOfDomain, match="panels"):
            midpoint.evaluate(AxialFabric(), **arguments, panels=panels)


@pytest.mark.parametrize("route", [closed_form, exact, axial, certified])
def test_a_component_short_of_digits_is_refused(route: ModuleType) -> None:
    """A lateral component below the smallest normal double kept its promise of relative accuracy by luck only."""
    with pytest.raises(ResultOutOfRange, match="poisson_ratio = 0"):
        route.evaluate(AxialFabric(Dr33=-0.3), poisson_ratio=1e-307, hypothesis=Hypothesis.KINEMATIC)
    zero = route.evaluate(AxialFabric(Dr33=-0.3), poisson_ratio=0.0, hypothesis=Hypothesis.KINEMATIC)
    assert zero.components[2:4] == (0.0, 0.0)
