"""Engineering constants against the compliance and against pulling the solid in every direction."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from granular.elasticity import Stiffness
from granular.engineering import engineering_constants, normal_stiffness, young_modulus
from granular.errors import DirectionNotValid, TensorNotElastic, TensorNotPositive

patient = settings(deadline=None)  # a time limit would be a verdict on a busy machine
SAND = Stiffness.transversely_isotropic(9.0, 7.0, 3.0, 2.0, 2.5, 3.0)


@st.composite
def solids(draw):
    """Positive definite solids, auxetic ones included, away from singular so that 1e-12 can be asked for."""
    shear, vertical, plane, normal = (draw(st.floats(0.05, 10.0)) for _ in range(4))
    poised = draw(st.sampled_from([0.0, 0.9, -0.9]) | st.floats(-0.9, 0.9))
    return Stiffness.transversely_isotropic(plane / 2 + shear, normal, plane / 2 - shear,
                                            poised * (plane * normal / 2) ** 0.5, vertical, shear)


@patient
@given(solids())
def test_constants_against_the_inverse_matrix(solid):
    # nu13 and nu31 exchanged, or a modulus of the wrong axis: LAPACK's inverse is the other voice
    soft = np.linalg.inv(solid.mandel())
    made = engineering_constants(solid)
    expected = {"E1": 1 / soft[0, 0], "E3": 1 / soft[2, 2], "nu12": -soft[0, 1] / soft[0, 0],
                "nu13": -soft[0, 2] / soft[0, 0], "nu31": -soft[0, 2] / soft[2, 2],
                "G23": solid.C2323, "G12": solid.C1212, "K": 1 / soft[:3, :3].sum()}
    for name, value in expected.items():
        # absolute part: ratios near zero are differences of numbers of order 1 times the condition, below 1e4
        assert getattr(made, name) == pytest.approx(value, rel=1e-10, abs=1e-11), name


@patient
@given(solids(), st.floats(-360, 360))
def test_pulling_along_any_direction(solid, degrees):
    # a wrong weight of the mixed term: turn the solid and read the components along axis 3
    beta = np.radians(degrees)
    turn = np.array([[np.cos(beta), 0, -np.sin(beta)], [0, 1, 0], [np.sin(beta), 0, np.cos(beta)]])
    turned = solid.rotated(turn)
    assert normal_stiffness(solid, degrees=degrees) == pytest.approx(turned.C3333, rel=1e-13)
    assert young_modulus(solid, degrees=degrees) == pytest.approx(1 / turned.compliance().S3333, rel=1e-9)


def test_moduli_along_the_axes():
    # E1 and E3 exchanged with the angle
    made = engineering_constants(SAND)
    assert young_modulus(SAND, degrees=0.0) == pytest.approx(made.E3, rel=1e-15)
    assert young_modulus(SAND, degrees=90.0) == pytest.approx(made.E1, rel=1e-15)
    assert normal_stiffness(SAND, degrees=90.0) == pytest.approx(SAND.C1111, rel=1e-15)
    assert made.nu31 / made.E3 == pytest.approx(made.nu13 / made.E1, rel=1e-15)


def test_isotropic_solid():
    # Lame constants 1 and 1: E = 2.5, nu = 0.25, K = 5/3
    made = engineering_constants(Stiffness.transversely_isotropic(3.0, 3.0, 1.0, 1.0, 1.0, 1.0))
    assert (made.E1, made.E3, made.nu12, made.nu13, made.nu31) == (2.5, 2.5, 0.25, 0.25, 0.25)
    assert (made.G23, made.G12) == (1.0, 1.0)
    assert made.K == pytest.approx(5 / 3, rel=2e-16)


@pytest.mark.parametrize("scale", [1e-280, 1e-120, 1e120, 1e290])
def test_any_unit(scale):
    # products of three stiffnesses beyond double range
    ours, plain = engineering_constants(SAND.scaled(scale)), engineering_constants(SAND)
    assert ours.E1 == pytest.approx(plain.E1 * scale, rel=4e-15)
    assert ours.K == pytest.approx(plain.K * scale, rel=4e-15)
    assert ours.nu12 == pytest.approx(plain.nu12, rel=4e-15)


def test_bad_input_is_refused():
    # moduli of a solid that has none
    with pytest.raises(TensorNotPositive):
        engineering_constants(Stiffness.transversely_isotropic(1.0, 1.0, 0.0, 1.0, 1.0, 0.5))
    with pytest.raises(TensorNotPositive):
        young_modulus(Stiffness.transversely_isotropic(3.0, 3.0, 1.0, 1.0, -1.0, 1.0), degrees=0.0)
    with pytest.raises(TensorNotElastic):
        engineering_constants(Stiffness.from_mandel(np.diag([1.0, 2, 3, 4, 5, 6])))
    with pytest.raises(DirectionNotValid):
        young_modulus(SAND, degrees=float("inf"))
