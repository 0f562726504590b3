"""Stiffness and compliance: notations against the tensor itself, inversion, symmetry, refusals."""

import pickle
import subprocess
import sys
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from granular.elasticity import Compliance, Stiffness
from granular.errors import DirectionNotValid, IndexNotKnown, TensorNotElastic, TensorNotInvertible
from granular.notation import ORDERS

patient = settings(deadline=None)  # a time limit would be a verdict on a busy machine
SAND = Stiffness.transversely_isotropic(9.0, 7.0, 3.0, 2.0, 2.5, 3.0)
ULP = np.finfo(float).eps


def mixed_tensor(seed=7):
    """81 components with 21 different values, so that any swapped index shows; positive definite."""
    random = np.random.default_rng(seed)
    half = random.normal(size=(3, 3, 3, 3))
    minor = half + half.transpose(1, 0, 2, 3)
    minor = minor + minor.transpose(0, 1, 3, 2)
    return np.einsum("ijmn,klmn->ijkl", minor, minor)


@st.composite
def solids(draw, smallest=1e-3):
    """Positive definite transversely isotropic stiffnesses, soft and near-singular ones included."""
    shear, vertical, plane, normal = (draw(st.floats(smallest, 10.0)) for _ in range(4))
    poised = draw(st.sampled_from([0.0, 0.5, -0.5, 0.999, -0.999, 1 - 1e-9]) | st.floats(-0.999, 0.999))
    c13 = poised * np.sqrt(plane * normal / 2)
    # in-plane sum `plane` and difference 2*shear, so that C1111 > C1122 and the 2x2 block is definite
    return Stiffness.transversely_isotropic(plane / 2 + shear, normal, plane / 2 - shear, float(c13),
                                            vertical, shear)


def rotation(angle, axis):
    """Turn about a coordinate axis (0, 1, 2)."""
    i, j = (axis + 1) % 3, (axis + 2) % 3
    turn = np.eye(3)
    turn[i, i] = turn[j, j] = np.cos(angle)
    turn[j, i], turn[i, j] = np.sin(angle), -np.sin(angle)
    return turn


@pytest.mark.parametrize("kind", [Stiffness, Compliance])
@pytest.mark.parametrize("order", sorted(ORDERS))
def test_a_voigt_matrix_does_what_the_tensor_does(kind, order):
    # a swapped pair or a missing factor 2 or 4 gives another answer for a strain with six different entries
    tensor = mixed_tensor()
    solid = kind.from_tensor(tensor)
    given_ = np.array([[1.0, 0.3, -0.7], [0.3, 2.0, 0.9], [-0.7, 0.9, -4.0]])
    answer = np.einsum("ijkl,kl->ij", tensor, given_)
    pairs = [(i - 1, j - 1) for i, j in ORDERS[order]]
    doubled = np.array([1, 1, 1, 2, 2, 2])  # engineering shear strain
    enters, leaves = (doubled, 1) if kind is Stiffness else (1, doubled)
    vector = np.array([given_[pair] for pair in pairs]) * enters
    expected = np.array([answer[pair] for pair in pairs]) * leaves
    # 1e-13: sums of 21 products of size 1..30
    np.testing.assert_allclose(solid.voigt(order) @ vector, expected, rtol=1e-13)


@pytest.mark.parametrize("kind", [Stiffness, Compliance])
@pytest.mark.parametrize("order", sorted(ORDERS))
def test_voigt_there_and_back(kind, order):
    # reading with another order or factor than writing would not return
    solid = kind.from_tensor(mixed_tensor())
    again = kind.from_voigt(solid.voigt(order), order=order)
    np.testing.assert_allclose(again.mandel(), solid.mandel(), rtol=4 * ULP)  # two roundings of 1/sqrt(2)


def test_mandel_and_components_against_the_tensor():
    # a component name that reads a neighbour
    tensor = mixed_tensor()
    solid = Stiffness.from_tensor(tensor)
    np.testing.assert_allclose(solid.tensor(), tensor, rtol=4 * ULP)
    for i, j, k, m in np.ndindex(3, 3, 3, 3):
        named = solid.component(f"C{i + 1}{j + 1}{k + 1}{m + 1}")
        assert named == pytest.approx(tensor[i, j, k, m], rel=4 * ULP)
    np.testing.assert_allclose(np.linalg.norm(solid.mandel()), np.linalg.norm(tensor), rtol=1e-14)


def test_the_papers_c44_is_horizontal_shear():
    # the clash of orders that this package exists to keep apart
    standard, paper = SAND.voigt("standard"), SAND.voigt("paper")
    assert (standard[3, 3], standard[5, 5]) == (SAND.C2323, SAND.C1212) == (2.5, 3.0)
    assert (paper[3, 3], paper[5, 5]) == (SAND.C1212, SAND.C2323)
    assert SAND.voigt()[3, 3] == standard[3, 3]


@pytest.mark.parametrize("order", sorted(ORDERS))
def test_voigt_compliance_is_the_inverse_of_voigt_stiffness(order):
    # compliance factors 2 and 4 left out
    np.testing.assert_allclose(SAND.compliance().voigt(order) @ SAND.voigt(order), np.eye(6), atol=1e-15)


@patient
@given(solids())
def test_the_closed_inverse_is_the_exact_inverse(solid):
    # a slip in the 2x2 block, or digits lost where it is nearly singular; rounded once, so equal
    c = {name: Fraction(value) for name, value in solid.components.items()}
    s = solid.compliance().components
    in_plane, difference = c["C1111"] + c["C1122"], 2 * c["C1212"]
    determinant = in_plane * c["C3333"] - 2 * c["C1133"] ** 2
    exact = {"S1111": (c["C3333"] / determinant + 1 / difference) / 2,
             "S3333": in_plane / determinant,
             "S1122": (c["C3333"] / determinant - 1 / difference) / 2,
             "S1133": -c["C1133"] / determinant,
             "S2323": 1 / (4 * c["C2323"]),
             "S1212": 1 / (4 * c["C1212"])}
    for name, value in exact.items():
        assert s[name] == float(value), name


@patient
@given(solids(smallest=0.05))
def test_closed_and_general_inverse_agree(solid):
    # two independent ways: closed form against LAPACK on the whole matrix
    matrix = solid.mandel()
    room = 50 * ULP * np.linalg.cond(matrix)
    difference = np.abs(np.linalg.inv(matrix) - solid.compliance().mandel()).max()
    assert difference <= room * np.abs(np.linalg.inv(matrix)).max()


@patient
@given(solids())
def test_positive_definiteness_by_inequalities_and_by_energy(solid):
    # inequalities that accept a solid without energy, or refuse one with it
    assert solid.is_positive_definite()
    values = solid.components
    for name, broken in (("C2323", -values["C2323"]), ("C2323", 0.0), ("C3333", -1.0), ("C3333", 0.0)):
        assert not Stiffness.transversely_isotropic(**{**values, name: broken}).is_positive_definite()
    softened = Stiffness.transversely_isotropic(**{**values, "C1111": values["C1122"] - 2.0, "C1212": -1.0})
    assert not softened.is_positive_definite()


def test_the_edge_of_definiteness_is_exact():
    # (C1111 + C1122) C3333 = 2 C1133^2 exactly stores no energy; one unit in the last place above does
    edge = Stiffness.transversely_isotropic(3.0, 2.0, 1.0, 2.0, 1.0, 1.0)
    above = Stiffness.transversely_isotropic(3.0, float(np.nextafter(2.0, 3.0)), 1.0, 2.0, 1.0, 1.0)
    assert not edge.is_positive_definite()
    assert above.is_positive_definite()
    with pytest.raises(TensorNotInvertible, match="singular"):
        edge.compliance()


def test_general_tensors_are_judged_by_eigenvalues():
    # the general path left out or turned round
    solid = Stiffness.from_tensor(mixed_tensor())
    assert solid.is_positive_definite()
    assert not solid.scaled(-1.0).is_positive_definite()
    np.testing.assert_allclose(solid.compliance().stiffness().mandel(), solid.mandel(), rtol=1e-9)
    direction = np.arange(1.0, 7.0)
    flat = Stiffness.from_mandel(np.outer(direction, direction))
    assert not flat.is_positive_definite()
    with pytest.raises(TensorNotInvertible, match="singular"):
        flat.compliance()


@patient
@given(solids(smallest=0.05), st.floats(-7, 7), st.sampled_from([0, 1, 2]))
def test_rotation_against_einsum(solid, angle, axis):
    # a rotation matrix transposed or with wrong shear weights
    turn = rotation(angle, axis)
    expected = np.einsum("ia,jb,kc,ld,abcd", turn, turn, turn, turn, solid.tensor())
    scale = np.abs(expected).max()
    np.testing.assert_allclose(solid.rotated(turn).tensor(), expected, atol=1e-14 * scale, rtol=0)
    if axis == 2:
        assert solid.rotated(turn).is_transversely_isotropic()


def test_turning_swaps_the_axes_of_a_mixed_tensor():
    # active and passive rotation told apart: a quarter turn about 3 carries direction 1 to direction 2
    solid = Stiffness.from_tensor(mixed_tensor())
    quarter = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    turned = solid.rotated(quarter)
    assert turned.component("C2222") == pytest.approx(solid.component("C1111"), rel=1e-14)
    assert turned.component("C2333") == pytest.approx(solid.component("C1333"), rel=1e-14)
    assert turned.component("C1333") == pytest.approx(-solid.component("C2333"), rel=1e-14)


def test_what_is_not_transversely_isotropic_has_no_six_components():
    # six numbers of a general solid would be taken for the whole of it
    general = Stiffness.from_tensor(mixed_tensor())
    assert not general.is_transversely_isotropic()
    with pytest.raises(TensorNotElastic, match="transverse isotropy"):
        _ = general.components
    assert not SAND.rotated(rotation(0.3, 0)).is_transversely_isotropic()


def test_one_symmetry_broken_at_a_time_is_noticed():
    # a test for transverse isotropy that forgets an entry
    for row, column in ((0, 0), (1, 2), (3, 3), (4, 4), (5, 5), (0, 3), (3, 5), (0, 1)):
        broken = SAND.mandel()
        broken[row, column] += 1e-6
        broken[column, row] = broken[row, column]
        assert not Stiffness.from_mandel(broken).is_transversely_isotropic(), (row, column)


@pytest.mark.parametrize(("change", "message"), [
    ({"C1111": float("nan")}, "C1111 = nan"),
    ({"C3333": float("inf")}, "C3333 = inf"),
    ({"C2323": "2.5"}, "C2323 = '2.5'"),
    ({"C2323": None}, "C2323 = None"),
    ({"C1212": 2.9}, "C1212 = 2.9 beside"),
])  # fmt: skip
def test_bad_components_are_named(change, message):
    # a message that does not say which number is wrong
    with pytest.raises(TensorNotElastic, match="G-ELA-02") as refusal:
        Stiffness.transversely_isotropic(**{**SAND.components, **change})
    assert message in str(refusal.value)


def test_bad_matrices_are_refused():
    # wrong shape, asymmetry and missing minor symmetry going in unseen
    with pytest.raises(TensorNotElastic, match="6 rows of 6"):
        Stiffness.from_mandel(np.eye(5))
    with pytest.raises(TensorNotElastic, match="6 rows of 6"):
        Stiffness.from_mandel([1.0, 2.0])
    lopsided = SAND.mandel()
    lopsided[0, 1] += 1e-3
    with pytest.raises(TensorNotElastic, match=r"at \(2, 1\)"):
        Stiffness.from_mandel(lopsided)
    with pytest.raises(TensorNotElastic, match="3, 3, 3"):
        Stiffness.from_tensor(np.ones((3, 3)))
    crooked = mixed_tensor()
    crooked[1, 2] *= 1.1
    with pytest.raises(TensorNotElastic, match="two indices of a pair"):
        Stiffness.from_tensor(crooked)
    with pytest.raises(TensorNotElastic, match="entry"):
        SAND.scaled(1e308)
    with pytest.raises(DirectionNotValid, match="orthogonal"):
        SAND.rotated(2 * np.eye(3))
    with pytest.raises(DirectionNotValid, match="orthogonal"):
        SAND.rotated(np.eye(2))
    with pytest.raises(IndexNotKnown):
        SAND.voigt("vasp")
    with pytest.raises(IndexNotKnown, match="S2323"):
        SAND.compliance().component("C2323")


def test_rounding_across_the_diagonal_is_averaged():
    # a matrix from a numerical sum must be accepted, and be exactly symmetric afterwards
    rough = SAND.mandel()
    rough[0, 1] *= 1 + 4 * ULP
    matrix = Stiffness.from_mandel(rough).mandel()
    np.testing.assert_array_equal(matrix, matrix.T)


@pytest.mark.parametrize("scale", [1e-300, 1e-150, 1.0, 1e9, 1e150, 1e300])
def test_any_unit_inverts(scale):
    # a determinant that overflows or underflows; each number is rounded once in scaling and once in inverting
    ours = SAND.scaled(scale).compliance().components
    for name, value in SAND.compliance().components.items():
        assert ours[name] * scale == pytest.approx(value, rel=8 * ULP)


def test_records_compare_print_and_travel():
    # a repr that does not rebuild the record; stiffness equal to a compliance of the same numbers
    general = Stiffness.from_tensor(mixed_tensor())
    for solid in (SAND, SAND.compliance(), general):
        assert eval(repr(solid)) == solid
        assert pickle.loads(pickle.dumps(solid)) == solid
        assert hash(solid) == hash(type(solid).from_mandel(solid.mandel()))
    assert Compliance.from_mandel(SAND.mandel()) != SAND
    with pytest.raises(AttributeError):
        SAND.rows = ()
    assert list(SAND.components) == ["C1111", "C3333", "C1122", "C1133", "C2323", "C1212"]


def test_six_numbers_never_load_numpy():
    # a scalar path that pays 0.1 s for an import
    code = ("import sys; from granular.elasticity import Stiffness as S; "
            "s = S.transversely_isotropic(9.0, 7.0, 3.0, 2.0, 2.5, 3.0); "
            "s.compliance().stiffness(), s.is_positive_definite(), s.components, repr(s.scaled(2.0)); "
            "print(sorted({'numpy', 'scipy', 'sympy'} & set(sys.modules)))")
    answer = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert answer.stdout == "[]\n"
