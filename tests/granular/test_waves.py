"""Wave speeds against the eigenvalues of the Christoffel matrix of the whole tensor, and what they claim."""

import math

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from granular.elasticity import Stiffness
from granular.errors import DensityOutOfRange, DirectionNotValid, TensorNotElastic, TensorNotPositive
from granular.routes.result import COMPONENTS
from granular.waves import bulk_density, fastest_shear, phase_velocities, thomsen, waves

patient = settings(deadline=None)  # a time limit would be a verdict on a busy machine
ISOTROPIC = Stiffness.transversely_isotropic(3.0, 3.0, 1.0, 1.0, 1.0, 1.0)
SAND = Stiffness.transversely_isotropic(9e8, 4e8, 3e8, 1e8, 1e8, 3e8)
SWAPPED = Stiffness.transversely_isotropic(3.0, 1.0, 1.0, 0.2, 2.0, 1.0)  # C2323 > C3333
TIED = Stiffness.transversely_isotropic(3.0, 2.0, 1.0, 0.2, 2.0, 1.0)  # C2323 = C3333


@st.composite
def solids(draw):
    """Positive definite solids; soft shear, negative and nearly singular C1133, shear above compression."""
    shear, vertical, plane, normal = (draw(st.floats(1e-3, 10.0)) for _ in range(4))
    poised = draw(st.sampled_from([0.0, 0.5, -0.5, 0.999, -0.999]) | st.floats(-0.999, 0.999))
    return Stiffness.transversely_isotropic(plane / 2 + shear, normal, plane / 2 - shear,
                                            poised * (plane * normal / 2) ** 0.5, vertical, shear)


angles = st.sampled_from([0.0, 45.0, 90.0, 135.0, 180.0, 1e-9, 90 - 1e-9]) | st.floats(-360.0, 360.0)


def christoffel(stiffness, direction):
    """Density times squared speeds and polarisations, from all 81 components."""
    return np.linalg.eigh(np.einsum("ijkl,j,l->ik", stiffness.tensor(), direction, direction))


@patient
@given(solids(), angles, st.floats(0.0, 6.3), st.floats(0.1, 5000.0))
@example(ISOTROPIC, 30.0, 1.0, 1.0)
@example(SWAPPED, 0.0, 0.0, 1.0)
def test_speeds_are_the_christoffel_eigenvalues(solid, degrees, azimuth, density):
    # a wrong coefficient in any closed form, or a dependence on the azimuth
    beta = math.radians(degrees)
    level = math.sin(beta)
    direction = np.array([level * math.cos(azimuth), level * math.sin(azimuth), math.cos(beta)])
    squares, _ = christoffel(solid, direction)
    speeds = phase_velocities(solid, density=density, degrees=degrees)
    ours = np.sort([density * speed**2 for speed in (speeds.P, speeds.SV, speeds.SH)])
    # 1e-14 of the largest component: it enters times sin^2, whose rounding is absolute
    np.testing.assert_allclose(ours, squares, rtol=0, atol=1e-14 * max(solid.components.values()))


@patient
@given(solids(), st.floats(0.0, 90.0))
def test_sh_is_polarised_horizontally(solid, degrees):
    # SH and SV exchanged: the horizontal vector must be an eigenvector with SH's eigenvalue
    beta = math.radians(degrees)
    direction = np.array([math.sin(beta), 0.0, math.cos(beta)])
    matrix = np.einsum("ijkl,j,l->ik", solid.tensor(), direction, direction)
    square = phase_velocities(solid, density=1.0, degrees=degrees).SH ** 2
    np.testing.assert_allclose(matrix @ [0, 1, 0], [0, square, 0], atol=1e-14 * np.abs(matrix).max())


def test_exact_at_axis_and_equator():
    # cos(90 degrees) taken for 6e-17 instead of 0 would mix components into the horizontal speeds
    result = waves(SAND, density=1600.0)
    assert (result.vertical.P, result.vertical.SH, result.vertical.SV) == (500.0, 250.0, 250.0)
    assert (result.horizontal.P, result.horizontal.SV) == (750.0, 250.0)
    assert result.horizontal.SH == pytest.approx(math.sqrt(3e8 / 1600), rel=4e-16)
    assert result.oblique == result.at(45.0) == result.at(-135.0) == result.at(405.0)
    # at 45 degrees the in-plane pair satisfies P^2 + SV^2 = (C1111 + C3333 + 2 C2323)/(2 density)
    assert result.oblique.P**2 + result.oblique.SV**2 == pytest.approx(15e8 / 3200, rel=1e-15)


def test_isotropic_speeds_do_not_depend_on_direction():
    # the double root at which P, SV formulas may lose half their digits
    for degrees in np.linspace(0, 180, 37):
        speeds = phase_velocities(ISOTROPIC, density=2.0, degrees=degrees)
        assert speeds.P == pytest.approx(math.sqrt(1.5), rel=4e-16)
        assert speeds.SV == pytest.approx(math.sqrt(0.5), rel=4e-16)
        assert speeds.SH == pytest.approx(math.sqrt(0.5), rel=4e-16)
    assert thomsen(ISOTROPIC).epsilon == thomsen(ISOTROPIC).gamma == thomsen(ISOTROPIC).delta == 0


def test_thomsen_parameters_are_slopes_of_the_speeds():
    # a wrong delta: near the axis v_P = v_P(0)(1 + delta sin^2 + O(sin^4))
    result = waves(SAND, density=1600.0)
    s = math.sin(math.radians(0.5)) ** 2
    assert (result.at(0.5).P / result.vertical.P - 1) / s == pytest.approx(result.thomsen.delta, rel=2e-3)
    assert result.horizontal.P**2 / result.vertical.P**2 == pytest.approx(1 + 2 * result.thomsen.epsilon)
    assert result.horizontal.SH**2 / result.vertical.SH**2 == pytest.approx(1 + 2 * result.thomsen.gamma)


def test_delta_has_no_value_where_compression_and_shear_tie():
    # a division by zero on a solid that has perfectly good speeds
    result = waves(TIED, density=1.0)
    assert result.thomsen.delta is None
    assert (result.thomsen.epsilon, result.thomsen.gamma) == (0.25, -0.25)


@patient
@given(solids())
@example(ISOTROPIC)
@example(SWAPPED)
@example(TIED)
@example(Stiffness.transversely_isotropic(4.0, 4.0, 1.0, -0.5, 1.0, 1.5))  # SV bulges at 45 degrees
def test_the_fastest_shear_wave_is_the_fastest(solid):
    # an SV maximum between the axes overlooked, or one claimed that is not reached; 181 angles as witnesses
    found = fastest_shear(solid, density=2.0)
    witnesses = [phase_velocities(solid, density=2.0, degrees=degrees) for degrees in np.linspace(0, 90, 181)]
    # along an axis the pure shear pair is SH there, so the SV root, never above it, is a fair witness
    best = max(max(speeds.SV, speeds.SH) for speeds in witnesses)
    assert found.speed >= best * (1 - 1e-12)
    reached = phase_velocities(solid, density=2.0, degrees=found.degrees)
    at_its_angle = reached.SH if found.polarisation == "SH" or found.degrees == 0 else reached.SV
    # the maximum is flat: an angle known to 1e-8 gives the speed to 1e-15, and SV itself carries its rounding
    assert at_its_angle == pytest.approx(found.speed, rel=1e-9)
    c = solid.components
    assert found.is_horizontal_SH == (math.sqrt(c["C1212"] / 2.0) >= found.speed * (1 - 1e-12))


@pytest.mark.parametrize(("stiffness", "polarisation", "degrees", "claim"), [
    (SAND, "SH", 90.0, True),
    (ISOTROPIC, "SH", 90.0, True),
    (Stiffness.transversely_isotropic(9.0, 9.0, 5.0, 4.0, 3.0, 2.0), "SV", 0.0, False),
    (Stiffness.transversely_isotropic(4.0, 4.0, 1.0, -0.5, 1.0, 1.5), "SV", 45.0, False),
])  # fmt: skip
def test_which_wave_is_fastest(stiffness, polarisation, degrees, claim):
    # the paper's claim reported true where vertical shear or an oblique SV is faster
    found = fastest_shear(stiffness, density=1.0)
    assert (found.polarisation, found.is_horizontal_SH) == (polarisation, claim)
    assert found.degrees == pytest.approx(degrees, abs=1e-12)


@pytest.mark.parametrize("scale", [1e-280, 1e-100, 1e250])
def test_no_product_overflows_or_vanishes(scale):
    # products of two stiffnesses beyond double range would give 0 or inf speeds
    ours = waves(SAND.scaled(scale), density=1600.0)
    plain = waves(SAND, density=1600.0)
    for mine, other in zip((ours.oblique.P, ours.oblique.SV, ours.fastest_shear.speed),
                           (plain.oblique.P, plain.oblique.SV, plain.fastest_shear.speed), strict=True):
        assert mine == pytest.approx(other * math.sqrt(scale), rel=4e-15)
    assert ours.thomsen.delta == pytest.approx(plain.thomsen.delta, rel=4e-15)


def test_bulk_density():
    # grains' density taken for the assembly's: speeds 25 % too low
    assert bulk_density(2650.0, 0.5744) == pytest.approx(1683.18, abs=0.01)
    assert bulk_density(2650.0, 0.0) == 2650.0


@pytest.mark.parametrize("density", [0.0, -1.0, math.nan, math.inf])
def test_impossible_densities_are_refused(density):
    # a speed of inf or nan, or of an imaginary wave
    for call in (lambda: waves(SAND, density=density), lambda: bulk_density(density, 0.5),
                 lambda: fastest_shear(SAND, density=density)):
        with pytest.raises(DensityOutOfRange, match="kg/m"):
            call()


def test_other_bad_input_is_refused():
    # each would end as nan, a math domain error or the speeds of another solid
    with pytest.raises(DensityOutOfRange, match="void_ratio"):
        bulk_density(2650.0, -0.1)
    with pytest.raises(DirectionNotValid):
        phase_velocities(SAND, density=1.0, degrees=math.nan)
    with pytest.raises(TensorNotPositive):
        waves(Stiffness.transversely_isotropic(1.0, 1.0, 0.0, 1.0, 1.0, 0.5), density=1.0)
    with pytest.raises(TensorNotElastic, match="transverse"):
        waves(Stiffness.from_mandel(np.diag([1.0, 2, 3, 4, 5, 6])), density=1.0)


def test_the_order_of_components_is_the_products():
    # the record handed on by keyword would silently reorder if this list changed
    assert tuple(SAND.components) == COMPONENTS
