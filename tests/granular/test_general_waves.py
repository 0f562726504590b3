"""Waves without an axis: against the axial closed forms in any frame, the equation itself, and plain scans."""

import math
import sys
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from granular.elasticity import Stiffness
from granular.errors import DensityOutOfRange, DirectionNotValid, TensorNotPositive
from granular.general import axis_speeds, general_waves, plane_waves
from granular.general.extremes import MANY, greatest, signed
from granular.general.fabric import spread_directions
from granular.waves import phase_velocities

sys.path.insert(0, str(Path(__file__).parents[1]))
from general_fabrics import rotation
from general_solids import axial_solids, solid

patient = settings(deadline=None, max_examples=40)  # a time limit would be a verdict on a busy machine
SAND = Stiffness.transversely_isotropic(9.0, 7.0, 3.0, 2.0, 2.5, 3.0)
ISOTROPIC = Stiffness.transversely_isotropic(3.0, 3.0, 1.0, 1.0, 1.0, 1.0)
AXES = np.eye(3)


@patient
@given(axial_solids(), st.floats(0, 180), st.floats(0, 360), st.integers(0, 1000))
def test_axial_solids_in_any_frame(given_solid, degrees, azimuth, seed):
    # an index of C_ijkl n_j n_l in the wrong place, or speeds in the wrong order: the closed form is the other voice
    beta, around = math.radians(degrees), math.radians(azimuth)
    n = np.array([math.sin(beta) * math.cos(around), math.sin(beta) * math.sin(around), math.cos(beta)])
    three = phase_velocities(given_solid, density=1.0, degrees=degrees)
    expected = np.sort([three.P, three.SV, three.SH])[::-1] ** 2
    size = np.abs(given_solid.mandel()).max()
    turn = rotation(seed)
    for body, direction, units in ((given_solid, n, 20), (given_solid.rotated(turn), turn @ n, 60)):
        found = plane_waves(body, direction, density=1.0).speeds[0] ** 2
        # units of rounding of the largest component: of the eigenvalues, and of turning 36 entries by six factors
        np.testing.assert_allclose(found, expected, rtol=0, atol=units * 2.2e-16 * size)


@pytest.mark.parametrize("seed", range(4))
def test_the_wave_equation_holds(seed):
    # eigenvectors in columns taken for rows, or vectors in another order than speeds
    body, n = solid(seed), spread_directions(200).T
    found = plane_waves(body, n, density=2.0)
    assert found.speeds.shape == (200, 3)
    assert found.polarisations.shape == found.rays.shape == (200, 3, 3)
    a, tensor = found.polarisations, body.tensor()
    np.testing.assert_allclose(np.einsum("qwi,qvi->qwv", a, a), np.broadcast_to(AXES, (200, 3, 3)), atol=1e-14)
    force = np.einsum("ijkl,qj,ql,qwk->qwi", tensor, n, n, a)
    # 1e-14: components are of order 1, and a sum has nine terms
    np.testing.assert_allclose(force, 2 * found.speeds[..., None] ** 2 * a, atol=1e-14 * np.abs(tensor).max())
    assert (np.diff(found.speeds, axis=1) <= 0).all()
    # a plane wave advances along its normal with the phase velocity, whatever its ray
    np.testing.assert_allclose(np.einsum("qwj,qj->qw", found.rays, n), found.speeds, rtol=1e-13)


def test_rays_are_gradients_of_the_speed():
    # a ray of half the length, or along the polarisation: the group velocity is the gradient of |k| v(k/|k|)
    body, n, step = solid(7), np.array([[0.3, -0.5, 0.8]]), 1e-6
    n /= np.linalg.norm(n)
    found = plane_waves(body, n, density=1.0)

    def frequency(k):
        return np.linalg.norm(k) * plane_waves(body, k, density=1.0).speeds[0]

    slope = np.stack([(frequency(n + step * e) - frequency(n - step * e)) / (2 * step) for e in AXES], axis=-1)
    # central differences: step^2 and 1e-16/step
    np.testing.assert_allclose(found.rays[0], slope, atol=1e-8)


def test_equal_shear_speeds():
    # a division by the difference of two speeds, or a splitting made of rounding
    found = plane_waves(ISOTROPIC, [1.0, 2.0, -3.0], density=1.0)
    np.testing.assert_allclose(found.speeds[0], [math.sqrt(3), 1, 1], rtol=1e-15)
    np.testing.assert_allclose(found.rays[0], found.speeds[0][:, None] * found.directions, atol=2e-15)
    everywhere = general_waves(ISOTROPIC, density=1.0)
    assert everywhere.largest_splitting.value <= 1e-14
    assert everywhere.fastest_qP.direction == everywhere.slowest_qP.direction == (1.0, 0.0, 0.0)
    along = plane_waves(SAND.rotated(rotation(3)), rotation(3)[:, 2], density=1.0)
    assert along.speeds[0, 1] == pytest.approx(along.speeds[0, 2], rel=1e-14)


def test_acoustic_axis_off_the_axes():
    # rays or polarisations that are no numbers where SV and SH cross at an angle
    body = Stiffness.transversely_isotropic(9.0, 9.0, 3.0, 2.0, 2.5, 3.0)
    low, high = 1.0, 89.0
    for _ in range(60):
        middle = (low + high) / 2
        three = phase_velocities(body, density=1.0, degrees=middle)
        low, high = (middle, high) if three.SV > three.SH else (low, middle)
    beta = math.radians(low)
    found = plane_waves(body, [math.sin(beta), 0, math.cos(beta)], density=1.0)
    assert 5 < low < 85
    assert found.speeds[0, 1] == pytest.approx(found.speeds[0, 2], rel=1e-14)
    assert np.isfinite(found.rays).all()
    np.testing.assert_allclose(np.einsum("wj,j->w", found.rays[0], found.directions[0]), found.speeds[0], rtol=1e-13)


def test_speeds_along_the_axes_of_an_orthotropic_solid():
    # axes exchanged, or a component of another plane: 1111, 1313, 1212 along axis 1 and so on
    body = Stiffness.from_voigt([[16, 2, 3, 0, 0, 0], [2, 25, 4, 0, 0, 0], [3, 4, 36, 0, 0, 0],
                                 [0, 0, 0, 9, 0, 0], [0, 0, 0, 0, 4, 0], [0, 0, 0, 0, 0, 1]])
    found = axis_speeds(body, density=1.0)
    assert [(one.qP, one.qS1, one.qS2) for one in found] == [(4.0, 2.0, 1.0), (5.0, 3.0, 1.0), (6.0, 3.0, 2.0)]
    one, two, three = map(tuple, AXES)
    assert [axis.polarisations for axis in found] == [(one, three, two), (two, three, one), (three, two, one)]
    assert general_waves(body, density=1.0).along_2 == found[1]


@pytest.mark.parametrize("seed", range(6))
def test_extremes_are_not_passed_by_any_direction(seed):
    # a search that stops on a lower hill: 60,000 random directions, with none of its own, find nothing better
    body = solid(seed, least=0.02)
    n = np.random.default_rng(seed).normal(size=(60_000, 3))
    fast, shear, slow = plane_waves(body, n, density=1.0).speeds.T
    found = general_waves(body, density=1.0)
    split = 2 * (shear - slow) / (shear + slow)
    for extreme, scan, at in (
            (found.fastest_qP.value, fast.max(), found.at(found.fastest_qP.direction).speeds[0, 0]),
            (-found.slowest_qP.value, -fast.min(), -found.at(found.slowest_qP.direction).speeds[0, 0]),
            (found.largest_splitting.value, split.max(), None)):
        # 1e-13: rounding. Directions are 0.01 rad apart, and half that from a top costs 1e-2 at most of sharp hills.
        assert scan <= extreme + 1e-13
        assert extreme - scan < 1e-2
        if at is not None:
            assert at == pytest.approx(extreme, rel=1e-14)


def test_extremes_turn_with_the_solid():
    # a search that favours the frame
    body, turn = solid(11), rotation(11)
    plain, turned = general_waves(body, density=1.0), general_waves(body.rotated(turn), density=1.0)
    for one, other in ((plain.fastest_qP, turned.fastest_qP), (plain.slowest_qP, turned.slowest_qP),
                       (plain.largest_splitting, turned.largest_splitting)):
        assert one.value == pytest.approx(other.value, rel=1e-12)
        # round hills: a height to 1e-14 leaves the place to 1e-7, and some room for flat ones
        np.testing.assert_allclose(signed(turn @ one.direction), other.direction, atol=3e-6)


def test_a_valley_with_an_edge_on_a_circle():
    # steps by derivatives: with C1133 = -C2323 the two in-plane waves are uncoupled, and the greater of
    # 3 s + 2 c and 2 s + 3 c is least, 5/2, where they cross at 45 degrees
    body = Stiffness.transversely_isotropic(3.0, 3.0, 2.0, -2.0, 2.0, 0.5)
    for frame in (np.eye(3), rotation(2)):
        found = general_waves(body.rotated(frame), density=1.0)
        assert found.slowest_qP.value == pytest.approx(math.sqrt(2.5), rel=1e-12)
        assert abs(frame[:, 2] @ found.slowest_qP.direction) == pytest.approx(math.sqrt(0.5), abs=1e-6)


def test_ties_name_a_coordinate_axis():
    # axis 1 shown as (0.9999999, 0.0003, 0) or as any other horizontal direction
    found = general_waves(SAND, density=1.0)
    assert found.fastest_qP.direction == (1.0, 0.0, 0.0)
    assert found.fastest_qP.value == 3.0
    assert greatest(lambda n: 0 * n[0]).direction == (1.0, 0.0, 0.0)
    assert signed(np.array([0.0, -1.0, 0.0])) == (0.0, 1.0, 0.0)


def test_directions_that_tie():
    # one of a ring, or one of two mirror images, told as the only one
    assert general_waves(solid(1), density=1.0).fastest_qP.ties == ()
    assert len(general_waves(SAND, density=1.0).fastest_qP.ties) >= MANY
    for axes, count in ((np.eye(3), 3), (np.array([[1, 1, 1], [1, 1, -1], [1, -1, 1], [1, -1, -1]]) / 3**0.5, 4)):
        top = greatest(lambda n, axes=axes: ((axes @ n) ** 4).sum(axis=0) if len(axes) == 3 else -(n**4).sum(axis=0))
        assert len({top.direction, *top.ties}) == count
        for place in (top.direction, *top.ties):
            assert np.abs(axes @ place).max() == pytest.approx(1, abs=1e-12)


@pytest.mark.parametrize("scale", [1e-280, 1e-100, 1e250])
def test_no_product_overflows_or_vanishes(scale):
    # squares beyond double range would give 0 or inf speeds
    body = solid(1)
    ours = general_waves(body.scaled(scale), density=1600.0)
    plain = general_waves(body, density=1600.0)
    for mine, other in ((ours.along_2.qS2, plain.along_2.qS2), (ours.fastest_qP.value, plain.fastest_qP.value),
                        (ours.slowest_qP.value, plain.slowest_qP.value)):
        assert mine == pytest.approx(other * math.sqrt(scale), rel=1e-13)
    assert ours.largest_splitting.value == pytest.approx(plain.largest_splitting.value, rel=1e-12)


def test_bad_input_is_refused():
    # each would end as nan or as the speeds of another direction
    for density in (0.0, -1.0, math.nan, math.inf):
        with pytest.raises(DensityOutOfRange, match="kg/m"):
            plane_waves(SAND, AXES, density=density)
    with pytest.raises(TensorNotPositive):
        general_waves(Stiffness.from_mandel(np.diag([1.0, 2, 3, 4, 5, -6])), density=1.0)
    for bad, message in (([1.0, 2.0], "shape"), ([[[1.0, 2.0, 3.0]]], "shape"), ("north", "shape"),
                         ([[0, 0, 1], [0, 0, 0]], "direction 2"), ([[0, math.nan, 1]], "direction 1"),
                         ([math.inf, 0, 0], "direction 1")):
        with pytest.raises(DirectionNotValid, match=message):
            plane_waves(SAND, bad, density=1.0)
    assert plane_waves(SAND, np.zeros((0, 3)), density=1.0).speeds.shape == (0, 3)
