"""Densities that fabric tensors imply: values, the least one, and the axial fabric nearest to them."""

from __future__ import annotations

import hypothesis.strategies as st
import numpy as np
import pytest
from hypothesis import given, settings
from scipy.integrate import lebedev_rule

from granular.errors import DirectionNotUnit, FabricOutOfRange, UnknownChoice
from granular.fabric import AxialFabric
from granular.fabric_tensors import axial_fabric, density, directions_of, fabric_of, least_density, symmetry_axis
from granular.fabric_tensors.density import half_sphere
from granular.fabric_tensors.sampling import axial_tensors, isotropic, tensors_of, uniform

AXES = [(0.0, 0.0, 1.0), (1.0, 2.0, 2.0), (3.0, 0.0, -4.0)]


def any_tensors(seed, count=12):
    return fabric_of(uniform(np.random.default_rng(seed), count))


@pytest.mark.parametrize("axis", AXES)
def test_axial_density(axis):
    # a form of the second kind that is another function on the sphere than the Legendre series
    n = uniform(np.random.default_rng(1), 100)
    cosine = n @ np.array(axis) / np.linalg.norm(axis)
    P2, P4 = (3 * cosine**2 - 1) / 2, (35 * cosine**4 - 30 * cosine**2 + 3) / 8
    tensors = axial_tensors(0.7, -0.2, axis)
    assert density(tensors, n) == pytest.approx(1 + 0.7 * P2 - 0.2 * P4, abs=1e-13)
    assert density(tensors, n, rank=2) == pytest.approx(1 + 0.7 * P2, abs=1e-13)
    assert density(tensors, n, rank=0) == pytest.approx(np.ones(100), abs=1e-14)


@pytest.mark.parametrize("rank", [0, 2, 4])
def test_density_has_the_moments_it_was_made_of(rank):
    # a rank that changes what the lower ones say: integrated with a rule exact for degree 8
    points, weights = lebedev_rule(11)
    tensors = any_tensors(3)
    again = fabric_of(points.T, weights * (density(tensors, points.T, rank=rank) + 100))  # a weight is not negative
    assert 101 * again.D2 == pytest.approx(tensors.D2 * (rank >= 2), abs=1e-10)
    assert 101 * again.D4 == pytest.approx(tensors.D4 * (rank >= 4), abs=1e-9)


@settings(max_examples=25, deadline=None)
@given(seed=st.integers(0, 10_000), count=st.integers(1, 60), rank=st.sampled_from([2, 4]))
def test_no_direction_lies_below_the_least(seed, count, rank):
    # a search that ends in another basin: 20,000 directions, 1 degree apart
    tensors = any_tensors(seed, count)
    least = least_density(tensors, rank=rank)
    assert least.value <= density(tensors, half_sphere(20_000), rank=rank).min() + 1e-12
    assert density(tensors, least.direction[None, :], rank=rank)[0] == pytest.approx(least.value, abs=1e-11)
    if rank == 2:
        # the least value of a form of rank two is its least principal value
        assert least.value == pytest.approx(1 + np.linalg.eigvalsh(tensors.D2)[0], abs=1e-11)


@pytest.mark.parametrize("axis", AXES)
@pytest.mark.parametrize(("D33", "D3333"), [(0.3, 0.0), (2.0, 0.0), (-1.0, 0.0), (1.0, 1.0), (-0.5, -0.8), (0.0, 2.0)])
def test_least_density_of_axial_fabrics(D33, D3333, axis):
    # minima on a ring, where Newton's method has a flat direction: a parabola in cos^2 gives the value
    y = np.linspace(0, 1, 100_001)
    expected = (1 + D33 * (3 * y - 1) / 2 + D3333 * (35 * y**2 - 30 * y + 3) / 8).min()
    # 1e-9: the step in y squared
    assert least_density(axial_tensors(D33, D3333, axis)).value == pytest.approx(expected, abs=1e-9)


def test_words_say_what_is_negative():
    # a negative density that is passed over in silence
    assert "would be negative" in least_density(axial_tensors(2.5)).words
    assert "nowhere below 4 pi E = 0.85" in least_density(axial_tensors(0.3)).words
    assert least_density(axial_tensors(-1.5)).direction == pytest.approx([0, 0, 1], abs=1e-7)


@pytest.mark.parametrize("axis", AXES)
@pytest.mark.parametrize(("D33", "D3333"), [(0.3, 0.1), (-0.6, 0.0), (1.2, 0.3)])
def test_axial_fabric_is_found(D33, D3333, axis):
    # another axis, or coefficients about another one
    unit = np.array(axis) / np.linalg.norm(axis)
    for given_axis in (None, axis, -unit):
        fit = axial_fabric(axial_tensors(D33, D3333, axis), given_axis)
        assert fit.fabric.D33 == pytest.approx(D33, abs=1e-12)
        assert fit.fabric.D3333 == pytest.approx(D3333, abs=1e-12)
        assert abs(fit.axis @ unit) == pytest.approx(1, abs=1e-14)
        assert fit.misfit == pytest.approx(0, abs=1e-12)
    assert axial_fabric(axial_tensors(D33, D3333, axis), axis, rank=2).fabric == AxialFabric(
        D33=axial_fabric(axial_tensors(D33, D3333, axis), axis).fabric.D33)


def test_misfit_is_what_is_left_in_the_mean_square():
    # mean squares with other factors: the rest, integrated
    tensors = tensors_of(np.diag([-0.5, -0.1, 0.6]), axial_tensors(0.0, 0.2, axis=(1, 0, 0)).D4)
    fit = axial_fabric(tensors)
    points, weights = lebedev_rule(11)
    n, weights = points.T, weights / weights.sum()
    whole = density(tensors, n) - 1
    rest = whole + 1 - density(axial_tensors(fit.fabric.D33, fit.fabric.D3333), n)
    assert fit.misfit == pytest.approx(weights @ rest**2 / (weights @ whole**2), rel=1e-12)
    assert fit.residual == pytest.approx(np.sqrt(weights @ rest**2), rel=1e-12)
    # nearest: any other coefficients leave more
    for step in (0.01, -0.01):
        other = whole + 1 - density(axial_tensors(fit.fabric.D33 + step, fit.fabric.D3333 - step / 2), n)
        assert weights @ other**2 > weights @ rest**2


def test_fitted_axis_is_the_best():
    # the principal value that is largest instead of farthest from zero
    tensors = tensors_of(np.diag([0.5, 0.4, -0.9]))
    assert symmetry_axis(tensors) == pytest.approx([0, 0, 1], abs=1e-14)
    best = axial_fabric(tensors, None).misfit
    assert all(axial_fabric(tensors, n).misfit >= best for n in half_sphere(200))


def test_isotropic_fabric_has_no_misfit():
    # nothing divided by nothing
    fit = axial_fabric(isotropic())
    assert (fit.fabric.D33, fit.residual) == (pytest.approx(0, abs=1e-14), pytest.approx(0, abs=1e-14))


@pytest.mark.parametrize("attempt", [
    lambda: axial_fabric(axial_tensors(2.5)),
    lambda: axial_fabric(axial_tensors(0.0, 3.0)),
    lambda: axial_fabric(fabric_of([[0, 0, 1]])),
    lambda: directions_of(axial_tensors(2.5), 10),
])
def test_negative_densities_are_refused(attempt):
    # contacts from a density that cannot be
    with pytest.raises(FabricOutOfRange):
        attempt()


@pytest.mark.parametrize(("attempt", "error"), [
    (lambda: density(isotropic(), [[0, 0, 1]], rank=3), UnknownChoice),
    (lambda: density(isotropic(), [[0, 0, 2]]), DirectionNotUnit),
    (lambda: least_density(isotropic(), rank=6), UnknownChoice),
    (lambda: axial_fabric(isotropic(), rank=0), UnknownChoice),
    (lambda: axial_fabric(isotropic(), [0, 0, 0]), DirectionNotUnit),
])
def test_refusals(attempt, error):
    # a question that has no answer here
    with pytest.raises(error):
        attempt()


@pytest.mark.parametrize("tensors", [axial_tensors(1.0, 0.5, axis=(1, 2, 2)), axial_tensors(-1.0),
                                     tensors_of(np.diag([-0.9, 0.3, 0.6]))])
def test_drawn_directions_have_the_density(tensors):
    # rejection with a bound that is too low cuts the peaks
    found = fabric_of(directions_of(tensors, 100_000, seed=3))
    # one standard deviation of a component is at most 9/sqrt(1e5) = 0.028; the largest of 96 stays below four
    assert found.D2 == pytest.approx(tensors.D2, abs=0.06)
    assert found.D4 == pytest.approx(tensors.D4, abs=0.11)
