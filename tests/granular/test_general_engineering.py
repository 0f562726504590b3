"""Engineering constants without an axis: against the axial ones, LAPACK's inverse, cubic closed forms, plain scans."""

import math
import sys
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from granular.elasticity import Stiffness
from granular.engineering import engineering_constants, young_modulus
from granular.errors import TensorNotPositive
from granular.general import general_engineering
from granular.general.engineering import along
from granular.general.extremes import signed

sys.path.insert(0, str(Path(__file__).parents[1]))
from general_fabrics import rotation
from general_solids import axial_solids, solid

patient = settings(deadline=None, max_examples=40)  # a time limit would be a verdict on a busy machine
SAND = Stiffness.transversely_isotropic(9.0, 7.0, 3.0, 2.0, 2.5, 3.0)


def cubic(c11: float, c12: float, c44: float) -> Stiffness:
    return Stiffness.from_voigt([[c11, c12, c12, 0, 0, 0], [c12, c11, c12, 0, 0, 0], [c12, c12, c11, 0, 0, 0],
                                 [0, 0, 0, c44, 0, 0], [0, 0, 0, 0, c44, 0], [0, 0, 0, 0, 0, c44]])


@patient
@given(axial_solids())
def test_axial_solids(body):
    # directions exchanged in a ratio, or a modulus of another axis: the closed form is the other voice
    expected, found = engineering_constants(body), general_engineering(body)
    for name in ("E1", "E3", "nu12", "nu13", "nu31", "G23", "G12", "K"):
        # the compliance is exact; the closed form loses up to the condition, below 1e4, of 1e-16 and some products
        assert getattr(found, name) == pytest.approx(getattr(expected, name), rel=1e-10, abs=1e-11), name
    assert (found.E2, found.nu21, found.nu23, found.nu32, found.G13) == (
        found.E1, found.nu12, found.nu13, found.nu31, found.G23)


@pytest.mark.parametrize("seed", range(5))
def test_constants_against_the_inverse_matrix(seed):
    # a factor of Mandel's notation, or nu_ij read as nu_ji
    body = solid(seed)
    soft, found = np.linalg.inv(body.mandel()), general_engineering(body)
    for i in range(3):
        assert getattr(found, f"E{i + 1}") == pytest.approx(1 / soft[i, i], rel=1e-12)
        for j in range(3):
            if i != j:
                ratio = -soft[i, j] / soft[i, i]
                assert getattr(found, f"nu{i + 1}{j + 1}") == pytest.approx(ratio, rel=1e-11, abs=1e-13)
    assert (found.G23, found.G13, found.G12) == pytest.approx(1 / (2 * soft.diagonal()[3:]), rel=1e-12)
    assert found.nu12 / found.E1 == pytest.approx(found.nu21 / found.E2, rel=1e-13)
    assert pytest.approx(soft[:3, :3].sum(), rel=1e-12) == 1 / found.K
    assert found.K_voigt == pytest.approx(body.mandel()[:3, :3].sum() / 9, rel=1e-14)


@pytest.mark.parametrize(("c11", "c12", "c44"), [(168.0, 121.0, 75.0), (107.0, 61.0, 28.0), (50.0, 7.0, 6.0)])
def test_cubic_crystals(c11, c12, c44):
    # means over directions with a wrong weight, or the greatest taken for the least modulus
    found = general_engineering(cubic(c11, c12, c44))
    zener = 2 * c44 / (c11 - c12)
    # Ranganathan and Ostoja-Starzewski: A = (6/5)(sqrt(Z) - 1/sqrt(Z))^2 with Zener's ratio Z
    assert found.universal_anisotropy == pytest.approx(1.2 * (math.sqrt(zener) - 1 / math.sqrt(zener)) ** 2, rel=1e-12)
    assert found.K == pytest.approx(found.K_voigt, rel=1e-14)
    assert found.K == pytest.approx((c11 + 2 * c12) / 3, rel=1e-14)
    assert found.G_voigt == pytest.approx((c11 - c12 + 3 * c44) / 5, rel=1e-14)
    assert found.G == pytest.approx(5 * (c11 - c12) * c44 / (4 * c44 + 3 * (c11 - c12)), rel=1e-14)
    edge = 1 / found.E1  # along a cube edge, and along its diagonal: s11 - (2/3)(s11 - s12 - s44/2)
    diagonal = edge - 2 / 3 * (1 / (c11 - c12) - 1 / (2 * c44))
    low, high = sorted((1 / edge, 1 / diagonal))
    assert (found.softest.value, found.stiffest.value) == pytest.approx((low, high), rel=1e-13)
    on_edge, on_diagonal = ((found.softest, found.stiffest) if zener > 1 else (found.stiffest, found.softest))
    assert on_edge.direction == (1.0, 0.0, 0.0)
    # a round top: its height to 1e-14 leaves its place to 1e-7, and some room for a flat one
    np.testing.assert_allclose(np.abs(on_diagonal.direction), 1 / math.sqrt(3), atol=1e-6)


@pytest.mark.parametrize("seed", range(4))
def test_extremes_are_not_passed_by_any_direction(seed):
    # a search that stops on a lower hill
    body = solid(seed, least=0.02)
    n = np.random.default_rng(seed).normal(size=(3, 60_000))
    young = 1 / along(body.compliance(), n / np.linalg.norm(n, axis=0))
    found = general_engineering(body)
    # 1e-12: the condition of the solid. Directions are 0.01 rad apart, and half that from a top costs 1 % at most.
    assert young.max() * (1 - 1e-12) <= found.stiffest.value <= young.max() * 1.01
    assert young.min() * 0.99 <= found.softest.value <= young.min() * (1 + 1e-12)


def test_what_turns_and_what_does_not():
    # a mean or an extreme that depends on the frame
    body, turn = solid(8), rotation(8)
    plain, turned = general_engineering(body), general_engineering(body.rotated(turn))
    for name in ("K", "K_voigt", "G", "G_voigt", "universal_anisotropy"):
        assert getattr(plain, name) == pytest.approx(getattr(turned, name), rel=1e-12), name
    for one, other in ((plain.stiffest, turned.stiffest), (plain.softest, turned.softest)):
        assert one.value == pytest.approx(other.value, rel=1e-12)
        np.testing.assert_allclose(signed(turn @ one.direction), other.direction, atol=3e-6)


@patient
@given(axial_solids(), st.floats(0, 90))
def test_young_modulus_of_an_axial_solid(body, degrees):
    # the form with a wrong weight of mixed terms
    beta = math.radians(degrees)
    found = 1 / along(body.compliance(), np.array([[math.sin(beta)], [0], [math.cos(beta)]]))[0]
    # the sum cancels at most the ratio of the moduli, below 1e4
    assert found == pytest.approx(young_modulus(body, degrees=degrees), rel=1e-10)
    constants = general_engineering(body)
    assert constants.softest.value * (1 - 1e-10) <= found <= constants.stiffest.value * (1 + 1e-10)


def test_isotropic_solid():
    # an index made of rounding, a ratio of -0.0, or a direction for what has none
    found = general_engineering(Stiffness.transversely_isotropic(3.0, 3.0, 1.0, 1.0, 1.0, 1.0))
    assert 0 <= found.universal_anisotropy < 1e-14
    assert found.stiffest.value == pytest.approx(2.5, rel=1e-15)
    assert found.stiffest.direction == found.softest.direction == (1.0, 0.0, 0.0)
    loose = general_engineering(Stiffness.from_mandel(np.eye(6)))
    assert str(loose.nu12) == str(loose.nu31) == "0.0"


@pytest.mark.parametrize("scale", [1e-280, 1e-120, 1e120, 1e290])
def test_any_unit(scale):
    # an inverse beyond double range
    ours, plain = general_engineering(SAND.scaled(scale)), general_engineering(SAND)
    for name in ("E1", "G13", "K", "G_voigt"):
        assert getattr(ours, name) == pytest.approx(getattr(plain, name) * scale, rel=1e-14)
    assert ours.softest.value == pytest.approx(plain.softest.value * scale, rel=1e-13)
    assert ours.universal_anisotropy == pytest.approx(plain.universal_anisotropy, rel=1e-12)


def test_bad_input_is_refused():
    # moduli of a solid that has none
    with pytest.raises(TensorNotPositive):
        general_engineering(Stiffness.from_mandel(np.diag([1.0, 2, 3, 4, 5, 0])))
