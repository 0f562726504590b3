"""Lebedev rules over the whole sphere: the bound holds at every degree, and what it cannot do is refused."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest

from granular.checks.sample import admissible_sample
from granular.errors import RouteOutOfDomain
from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.routes import certified, sphere, sphere_bounds


def error(components: tuple[float, ...], fabric: AxialFabric, nu: float, hypothesis: Hypothesis) -> float:
    enclosures = certified.enclose(fabric, poisson_ratio=nu, hypothesis=hypothesis)
    return max(float(abs(Fraction(value) - e.midpoint) / (abs(e.midpoint) or 1) if e.midpoint or not value else 1)
               for value, e in zip(components, enclosures, strict=True))


@pytest.mark.parametrize("degree", [degree for degree in sphere_bounds.DEGREES if degree >= 9])
@pytest.mark.parametrize("fabric", [
    AxialFabric(D33=0.3, Dr33=-0.3), AxialFabric(D33=-1.0, Dr33=0.9), AxialFabric(D33=0.5, D3333=0.5, Dr33=-0.7),
    AxialFabric(D33=2.0, Dr33=1.6)], ids=str)
def test_the_bound_holds_at_every_degree(fabric: AxialFabric, degree: int) -> None:
    """The declared error of a rule is below its real error."""
    for hypothesis in Hypothesis:
        declared = sphere_bounds.declared_error(fabric, hypothesis=hypothesis, degree=degree)
        components = sphere.components_by_degree(fabric, poisson_ratio=0.21, hypothesis=hypothesis, degree=degree)
        assert error(components, fabric, 0.21, hypothesis) <= declared


@pytest.mark.parametrize("rtol", [None, 1e-3, 1e-8])
def test_random_fabrics(rtol: float | None) -> None:
    """The degree that is chosen misses the wanted accuracy, or the route refuses what it can do."""
    served = 0
    for fabric, nu in admissible_sample(60, seed=5):
        for hypothesis in Hypothesis:
            try:
                result = sphere.evaluate(fabric, poisson_ratio=nu, hypothesis=hypothesis, rtol=rtol)
            except RouteOutOfDomain:
                assert hypothesis is Hypothesis.STATIC
                assert not -0.7 < fabric.Dr33 < 1.4
                continue
            served += 1
            found = error(result.components, fabric, nu, hypothesis)
            assert found <= result.relative_error <= (rtol or sphere_bounds.WANTED)
    assert served > 70


def test_the_lowest_degree_that_is_enough_is_taken() -> None:
    """More directions than needed: rank two under uniform strain is a polynomial of degree 10, rank four of 12."""
    def directions(fabric: AxialFabric, hypothesis: Hypothesis, rtol: float) -> int:
        return sphere.evaluate(fabric, poisson_ratio=0.21, hypothesis=hypothesis, rtol=rtol).evaluations

    assert directions(AxialFabric(D33=0.3, Dr33=1.9), Hypothesis.KINEMATIC, 1e-12) == 50
    assert directions(AxialFabric(D33=0.3, D3333=0.1), Hypothesis.KINEMATIC, 1e-12) == 86
    coarse, fine = (directions(AxialFabric(Dr33=0.5), Hypothesis.STATIC, rtol) for rtol in (1e-4, 1e-10))
    assert coarse < fine


def test_a_rule_of_too_low_a_degree_promises_nothing() -> None:
    """A polynomial beyond the degree of the rule is declared exact, and is not."""
    fabric = AxialFabric(D33=0.3, Dr33=-0.3)
    assert sphere_bounds.declared_error(fabric, hypothesis=Hypothesis.KINEMATIC, degree=9) == math.inf
    components = sphere.components_by_degree(fabric, poisson_ratio=0.21, hypothesis=Hypothesis.KINEMATIC, degree=7)
    assert error(components, fabric, 0.21, Hypothesis.KINEMATIC) > 1e-6


@pytest.mark.parametrize("Dr33", [1.999, -0.999])
def test_strong_anisotropy_is_refused(Dr33: float) -> None:
    """The static rule answers where 5810 directions do not resolve 1/W^2, or the refusal says nothing useful."""
    with pytest.raises(RouteOutOfDomain, match=r"G-RTE-01.*degree 131.*route axial"):
        sphere.evaluate(AxialFabric(Dr33=Dr33), poisson_ratio=0.21, hypothesis=Hypothesis.STATIC)


def test_equal_contacts_leave_exact_zeros() -> None:
    """At nu = 0 nothing couples the directions; rounding makes a coupling."""
    for hypothesis in Hypothesis:
        result = sphere.evaluate(AxialFabric(D33=0.3, Dr33=0.4), poisson_ratio=0.0, hypothesis=hypothesis)
        assert result.components[2:4] == (0.0, 0.0)


@pytest.mark.parametrize("degree", [0, 4, 13, 132])
def test_a_degree_without_a_rule_is_refused(degree: int) -> None:
    """A degree that no rule has, or one whose rule has negative weights, must not reach SciPy."""
    with pytest.raises(RouteOutOfDomain, match=f"degree = {degree}"):
        sphere.directions_of(degree)
