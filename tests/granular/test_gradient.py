"""``axial_gradient``: certified differences, identities between slopes, limits, corners, and refusals."""

from fractions import Fraction

import numpy as np
import pytest

import granular
from granular.array_stiffness import RELATIVE_ERROR
from granular.derivatives import PARAMETERS, kernels
from granular.derivatives.rows import constant_rows, kinetic_rows
from granular.errors import ArrayNotUsable, ComplianceInfinite, FabricOutOfRange, SlopeInfinite, ValueOutOfRange
from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.loading import Loading
from granular.routes import certified

STEP = Fraction(1, 2**90)
"""Central differences err by STEP^2 times a third derivative: below 1e-30 for every state here, onset included."""

ACCURACY = 1e-13
"""Stated accuracy, of the larger of the slope and the largest component; about twenty times what is met here."""

D, DR, SR, MU, NU = range(5)

# D33, Dr33, stress ratio, friction (None: no slip), Poisson's ratio
PLAIN = [(0.0, 0.0, 1.0, None, 0.21), (0.3, -0.3, 1.5, None, 0.21), (-0.9, 1.8, 3.0, None, 0.4),
         (1.9, -0.9, 1 / 3, None, 1e-3), (0.5, 0.2, 40.0, None, 0.3), (-0.5, -0.2, 0.01, None, 0.3)]
SLIPPING = [(0.3, -0.3, 1.0, 0.2126, 0.21), (0.0, 0.0, 2.0, 0.2126, 0.21), (-0.7, 1.2, 3.0, 0.5, 0.45),
            (1.5, -0.8, 0.5, 0.15, 0.1), (0.2, 0.1, 30.0, 0.4, 0.2), (0.25, 0.5, 1.0, 1e3, 0.21)]
STICKING = [(0.3, -0.3, 1.0, 0.5, 0.21), (0.0, 0.2, 4.0, 0.75 + 2.0**-6, 0.3)]


def certified_slopes(state, parameter, hypothesis, *, kinetic=True):
    """Central differences of enclosures of 60 digits: exact but for the step."""
    ends = []
    for sign in (1, -1):
        moved = [None if number is None else Fraction(number) for number in state]
        moved[parameter] += sign * STEP
        d, dr, ratio, friction, nu = moved
        loading = Loading.of_ratio(ratio, friction=friction) if kinetic else None
        ends.append([one.midpoint for one in certified.enclose(
            AxialFabric(D33=d, Dr33=dr), poisson_ratio=nu, hypothesis=Hypothesis(hypothesis), loading=loading,
            digits=60)])
    return np.array([float((above - below) / (2 * STEP)) for above, below in zip(*ends, strict=True)])


def compare(states, hypothesis, *, kinetic=True, accuracy=ACCURACY):
    """Worst slope of each state against certified differences, over what its accuracy is stated for."""
    for state in states:
        value, jacobian = granular.axial_gradient(*state, kinetic=kinetic, hypothesis=hypothesis)
        np.testing.assert_allclose(
            value, granular.axial_stiffness(*state, kinetic=kinetic, hypothesis=hypothesis), rtol=2 * RELATIVE_ERROR)
        for parameter in range(5):
            if (state[parameter] is None) or (not kinetic and parameter in (SR, MU)):
                assert not jacobian[:, parameter].any()
                continue
            exact = certified_slopes(state, parameter, hypothesis, kinetic=kinetic)
            allowed = accuracy * np.maximum(abs(exact), value.max())
            assert (abs(jacobian[:, parameter] - exact) <= allowed).all(), (state, PARAMETERS[parameter])


@pytest.mark.parametrize("hypothesis", ["kinematic", "static"])
def test_slopes_of_equal_contacts(hypothesis):
    # a derivative of the wrong moment, or of the inverse without its sign
    compare(PLAIN[:4], hypothesis, kinetic=False)


def test_slopes_without_slip():
    # a force that is held where it moves with fabric or stress; the last two states leave the emitted series
    compare(PLAIN, "kinematic")


def test_static_slopes_without_slip():
    compare(PLAIN[1:3], "static")


def test_slopes_with_slip():
    # a sliding range whose edge is taken to add something, or a wrong sign of the shear force
    compare(SLIPPING, "kinematic")


def test_static_slopes_with_slip():
    compare(STICKING, "static")


@pytest.mark.parametrize("gap", [2.0**-10, -(2.0**-10), 2.0**-30, -(2.0**-30), 2.0**-45])
def test_slopes_near_the_onset_of_sliding(gap):
    # Nodes that stop short of the edge lose what the power -2/3 keeps there. The place of the onset is exact to
    # rounding, 2^-52/gap of itself, and the slope goes with its power -1/6.
    state = (0.0, 0.1, 4.0, 0.75 + gap, 0.21)
    compare([state], "kinematic", accuracy=ACCURACY + 2.0**-52 / abs(gap))
    slope = granular.axial_gradient(*state).jacobian[4, MU]
    assert slope > granular.axial_gradient(0.0, 0.1, 4.0, 0.75 + 4 * gap, 0.21).jacobian[4, MU]


def random_states(count, seed=7):
    rng = np.random.default_rng(seed)
    return (rng.uniform(-1, 2, count), rng.uniform(-0.95, 1.95, count), np.exp(rng.uniform(-3, 3, count)),
            np.exp(rng.uniform(-3, 2, count)), rng.uniform(0, 0.5, count))


@pytest.mark.parametrize("friction", [True, False])
@pytest.mark.parametrize("hypothesis", ["kinematic", "static"])
def test_one_shear_modulus_across_the_axis(hypothesis, friction):
    # C1212 = (C1111 - C1122)/2 for every assembly, so for the slopes too: a component with the slope of another
    d, dr, ratio, mu, nu = random_states(300)
    if hypothesis == "static" and friction:
        mu = mu + 40  # no contact slides
    value, jacobian = granular.axial_gradient(d, dr, ratio, mu if friction else None, nu, hypothesis=hypothesis)
    scale = np.maximum(abs(jacobian), value.max(axis=-1)[:, None, None]).max(axis=1)
    assert (abs(2 * jacobian[:, 5] - jacobian[:, 0] + jacobian[:, 2]) <= ACCURACY * scale).all()


def test_bulk_response_knows_no_friction():
    # C3333 + 2 C1111 + 2 C1122 + 4 C1133 holds no k_r: neither friction nor Poisson's ratio may move it
    value, jacobian = granular.axial_gradient(*random_states(300))
    bulk = jacobian[:, 1] + 2 * jacobian[:, 0] + 2 * jacobian[:, 2] + 4 * jacobian[:, 3]
    scale = np.maximum(abs(jacobian).max(axis=1), value.max(axis=-1)[:, None])
    assert (abs(bulk[:, [MU, NU]]) <= 10 * ACCURACY * scale[:, [MU, NU]]).all()


def test_first_order_sees_one_combination():
    # exact at the isotropic state: D33 + 2 Dr33 with equal contacts, 13/15 D33 + 2 Dr33 with forces
    for kinetic, weight in ((False, 1.0), (True, 13 / 15)):
        jacobian = granular.axial_gradient(0.0, 0.0, poisson_ratio=0.3, kinetic=kinetic).jacobian
        np.testing.assert_allclose(weight * jacobian[:, DR], 2 * jacobian[:, D], rtol=1e-14, atol=1e-16)
    static = granular.axial_gradient(0.0, 0.0, poisson_ratio=0.3, kinetic=False, hypothesis="static").jacobian
    quotients = static[:, D] / static[:, DR]
    lam = 1.4 / 1.7
    expected = [(32 * lam**2 + 101 * lam + 42) / (10 * lam * (16 * lam + 19)), (4 * lam + 21) / (20 * lam),
                (8 * lam + 27) / (10 * (4 * lam + 3))]
    np.testing.assert_allclose(quotients, [expected[k] for k in (0, 0, 1, 1, 2, 2)], rtol=1e-12)


def test_much_friction_is_no_slip():
    # kappa is below 1e-9, and what slip takes goes with it
    state = np.array([0.3, -0.5]), np.array([0.2, 1.0]), np.array([1.5, 0.4])
    with_friction = granular.axial_gradient(*state, 1e10, 0.21)
    without = granular.axial_gradient(*state, None, 0.21)
    np.testing.assert_allclose(with_friction.jacobian[..., [D, DR, SR, NU]], without.jacobian[..., [D, DR, SR, NU]],
                               atol=1e-9)
    assert abs(with_friction.jacobian[..., MU]).max() < 1e-9


def test_corner_at_equal_forces_gives_the_mean_of_both_sides():
    # one of the two one-sided slopes, or a jump at random, breaks this; the next term is D33 |D33|, which
    # moves their mean by a part of h
    h = 1e-5
    corner = granular.axial_gradient(0.0, 0.1, 1.0, 0.3).jacobian
    sides = granular.axial_gradient([-h, h], 0.1, 1.0, 0.3).jacobian
    assert abs(sides[1, :, D] - sides[0, :, D]).max() > 0.01
    np.testing.assert_allclose(sides[..., D].mean(axis=0), corner[:, D], atol=0.1 * h)
    assert not corner[:, MU].any()
    off_axis = granular.axial_gradient(-1.0, 0.1, 0.5, 0.3).jacobian  # equal forces again, decided exactly
    assert not off_axis[:, MU].any()


def test_ends_of_the_fabric_are_served():
    # a density that vanishes at the pole or at the equator must not divide anything
    for d in (-1.0, 2.0):
        inside = d * (1 - 2.0**-40)
        for state in ((0.5, 2.0, 0.3), (-0.9, 0.4, None)):
            at_end, beside = (granular.axial_gradient(number, *state).jacobian for number in (d, inside))
            np.testing.assert_allclose(at_end, beside, rtol=1e-9, atol=1e-9)


def test_shapes_follow_the_arguments():
    value, jacobian = granular.axial_gradient(np.zeros((3, 1)), [0.1, 0.2], 2, 0.5)
    assert value.shape == (3, 2, 6)
    assert jacobian.shape == (3, 2, 6, len(PARAMETERS))
    assert granular.axial_gradient(0, 0).jacobian.shape == (6, 5)
    assert granular.axial_gradient([], 0.0).jacobian.shape == (0, 6, 5)
    one_by_one = [granular.axial_gradient(0.0, dr, 2, 0.5).jacobian for dr in (0.1, 0.2)]
    # sums of matrix products may be ordered by the batch
    np.testing.assert_allclose(jacobian[0], one_by_one, rtol=1e-13, atol=1e-15)


def test_mixed_elements_keep_their_places():
    # elements with and without shear forces are computed apart and must come back where they were
    ratio = np.array([1.0, 2.0, 1.0, 0.5, 1.0])
    together = granular.axial_gradient(0.0, 0.1, ratio, 0.3)
    for place, one in enumerate(ratio):
        alone = granular.axial_gradient(0.0, 0.1, one, 0.3)
        np.testing.assert_allclose(together.jacobian[place], alone.jacobian, rtol=1e-13, atol=1e-15)


@pytest.mark.parametrize(("arguments", "kind", "found"), [
    ({"D33": [0.0, 2.5], "Dr33": 0.0}, FabricOutOfRange, "D33[1] = 2.5"),
    ({"D33": 0.0, "Dr33": 0.0, "friction_coefficient": [0.2, 0.0]}, ValueOutOfRange,
     "friction_coefficient = 0.0 in element 1 of 2"),
    ({"D33": 0.0, "Dr33": 0.0, "stress_ratio": [1.0, 4.0], "friction_coefficient": 0.75}, SlopeInfinite,
     "onset of sliding in element 1 of 2"),
    ({"D33": 0.0, "Dr33": 0.0, "stress_ratio": 4.0, "friction_coefficient": 0.75, "hypothesis": "static"},
     SlopeInfinite, "onset of sliding"),
    ({"D33": 0.0, "Dr33": 0.0, "stress_ratio": 4.0, "friction_coefficient": 0.5, "hypothesis": "static"},
     ComplianceInfinite, "slide"),
    ({"D33": [0.0, 1.0], "Dr33": [0.0, 0.1, 0.2]}, ArrayNotUsable, "shapes"),
])
def test_refusals_name_the_element(arguments, kind, found):
    with pytest.raises(kind) as refusal:
        granular.axial_gradient(**arguments)
    assert found in str(refusal.value)


@pytest.mark.parametrize("kinetic", [True, False])
def test_engines_and_routes_agree(kinetic):
    # the batch kernels, their two engines, and the integrals that serve what they do not: 1e-14 of what is stated for
    # each, many times what is met
    d, dr, _, _, nu = random_states(500)
    ratio = np.exp(np.random.default_rng(2).uniform(-2, 2, 500))  # some beyond the kernel
    state = (d, dr, ratio, None, nu)
    rows = (kinetic_rows(d, dr, ratio, nu, Hypothesis.KINEMATIC) if kinetic
            else constant_rows(d, dr, nu, Hypothesis.KINEMATIC)).reshape(-1, 6, 6)
    value, jacobian = granular.axial_gradient(*state, kinetic=kinetic, engine="numpy")
    np.testing.assert_allclose(value, rows[:, 0], rtol=2 * RELATIVE_ERROR)
    scale = np.maximum(abs(rows[:, 1:]), rows[:, :1].max(axis=-1, keepdims=True))
    assert (abs(np.moveaxis(jacobian, -1, -2) - rows[:, 1:]) <= 1e-14 * scale).all()


def test_loops_are_the_blocks():
    # the loop, uncompiled, must give the bits of the block; a compiled one does the same operations
    d, dr, ratio, _, nu = random_states(40)
    ratio = np.clip(ratio, 0.4, 2.5)
    for kernel, inputs in ((kernels.CONSTANT, (d, dr, nu)), (kernels.KINETIC, (d, dr, ratio, nu))):
        one, other = np.empty(40 * 36), np.empty(40 * 36)
        assert kernel.loop()(*inputs, one, False) == kernel.array()(*inputs, other) == 0
        assert one.tobytes() == other.tobytes()


def test_the_memory_of_an_earlier_result_is_taken_again():
    # rows written beside it, or columns of the last call left where this one has none
    earlier = granular.axial_gradient([0.5, -0.5], 0.3, 2.0, 0.4)
    again = granular.axial_gradient([0.1, 0.2], 0.0, kinetic=False, out=earlier)
    fresh = granular.axial_gradient([0.1, 0.2], 0.0, kinetic=False)
    assert again is earlier
    np.testing.assert_array_equal(again.value, fresh.value)
    np.testing.assert_array_equal(again.jacobian, fresh.jacobian)


@pytest.mark.parametrize(("place", "said"), [
    (np.zeros((2, 6)), "is a ndarray"),
    (granular.axial_gradient([0.1, 0.2, 0.3], 0.0), r"shape \(3,\), needed: shape \(2,\)"),
    (type(granular.axial_gradient(0, 0))(np.zeros((2, 6)), np.zeros((2, 6, 5))), "not its own"),
])
def test_memory_that_is_no_earlier_result(place, said):
    # values written where a caller does not look, or half of them lost
    with pytest.raises(ArrayNotUsable, match=said):
        granular.axial_gradient([0.1, 0.2], 0.0, out=place)


def test_memory_that_is_read_meanwhile():
    # an argument overwritten before it has been read
    earlier = granular.axial_gradient([0.1, 0.2], 0.0)
    with pytest.raises(ArrayNotUsable, match="shares its memory"):
        granular.axial_gradient(earlier.value[:, 0], 0.0, out=earlier)
