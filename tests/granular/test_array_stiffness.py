"""``axial_stiffness``: the scalar routes element by element, a ufunc's manners, and refusals that name the element."""

import math
import warnings

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import granular
from granular.array_stiffness import RELATIVE_ERROR
from granular.batch.engines import Engine
from granular.batch.evaluation import BLOCK as BLOCKS
from granular.errors import (
    ArrayNotUsable,
    ComplianceInfinite,
    FabricOutOfRange,
    RouteOutOfDomain,
    UnknownChoice,
    ValueOutOfRange,
)
from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.routes import axial, closed_form

BLOCK = BLOCKS[Engine.NUMPY]

patient = settings(deadline=None)  # a time limit would be a verdict on a busy machine
BATCH = 4 * np.finfo(float).eps
"""Where branch lengths differ most, moments come from a matrix product, whose order of sums depends on the batch."""
HYPOTHESES = [Hypothesis.KINEMATIC, Hypothesis.STATIC]
EDGES_OF_DR = [math.nextafter(-1, 0), -1 + 1e-9, -0.99, -16 / 19, math.nextafter(-16 / 19, -1), -0.3, 0.0, 1e-300,
               16 / 11, math.nextafter(16 / 11, 2), 1.9, 2 - 1e-9, math.nextafter(2, 0)]
fabrics = st.sampled_from([-1.0, 0.0, 2.0]) | st.floats(-1, 2)
branches = st.sampled_from(EDGES_OF_DR) | st.floats(-1, 2, exclude_min=True, exclude_max=True)
ratios = st.sampled_from([0.0, 0.5]) | st.floats(1e-200, 0.5)  # below, a scalar may be too small and is refused


def stiffness(D33, Dr33, hypothesis, nu=0.21):
    return granular.axial_stiffness(D33, Dr33, poisson_ratio=nu, kinetic=False, hypothesis=hypothesis)


def scalar(d, dr, nu, hypothesis):
    """The same numbers one at a time, by the closed form where it serves and by the Gauss rule elsewhere."""
    fabric = AxialFabric(D33=d, Dr33=dr)
    route = closed_form if closed_form.covers(fabric, hypothesis) else axial
    return route.evaluate(fabric, poisson_ratio=nu, hypothesis=hypothesis)


@pytest.mark.parametrize("hypothesis", HYPOTHESES)
@patient
@given(st.lists(st.tuples(fabrics, branches, ratios), min_size=1, max_size=12))
def test_equal_to_the_scalar_routes(hypothesis, cases):
    # an element sent to the wrong formula, or mixed up with its neighbour
    d, dr, nu = (np.array(column) for column in zip(*cases, strict=True))
    ours = stiffness(d, dr, hypothesis, nu)
    assert ours.shape == (len(cases), 6)
    for row, case in zip(ours, cases, strict=True):
        one = scalar(*case, hypothesis)
        # both declared bounds together: 8 ulp for the array, at most a few for the scalar; and a few steps of
        # the smallest numbers, where a Poisson's ratio next to zero leaves C1122 without a full mantissa
        np.testing.assert_allclose(row, one.components, rtol=RELATIVE_ERROR + one.relative_error, atol=1e-320)


@pytest.mark.parametrize("hypothesis", HYPOTHESES)
def test_the_whole_boundary(hypothesis):
    # corners where a weight vanishes and a dead branch would give 0/0
    d, dr = np.meshgrid([-1.0, math.nextafter(-1, 0), 0.0, 2.0], EDGES_OF_DR)
    ours = stiffness(d, dr, hypothesis)
    assert np.isfinite(ours).all()
    assert (ours > 0).all()
    for index in np.ndindex(d.shape):
        one = scalar(float(d[index]), float(dr[index]), 0.21, hypothesis)
        np.testing.assert_allclose(ours[index], one.components, rtol=RELATIVE_ERROR + one.relative_error, atol=0)


@pytest.mark.parametrize("hypothesis", HYPOTHESES)
@pytest.mark.parametrize(("d_shape", "dr_shape", "nu_shape", "expected"), [
    ((), (), (), ()),
    ((3,), (), (), (3,)),
    ((4, 1), (1, 5), (), (4, 5)),
    ((2, 1, 3), (4, 1), (1,), (2, 4, 3)),
    ((0,), (), (), (0,)),
    ((0, 1), (1, 5), (), (0, 5)),
    ((1, 0, 2), (3, 1, 1), (2,), (3, 0, 2)),
])  # fmt: skip
def test_shapes_broadcast_like_a_ufunc(hypothesis, d_shape, dr_shape, nu_shape, expected):
    # a wrong axis order in the result, or an empty array refused
    d = np.linspace(-0.9, 1.9, math.prod(d_shape)).reshape(d_shape)
    dr = np.linspace(-0.95, 1.95, math.prod(dr_shape)).reshape(dr_shape)
    nu = np.linspace(0.1, 0.4, math.prod(nu_shape)).reshape(nu_shape)
    ours = stiffness(d, dr, hypothesis, nu)
    assert (ours.shape, ours.dtype) == ((*expected, 6), np.float64)
    full = [np.broadcast_to(array, expected) for array in (d, dr, nu)]
    for index in np.ndindex(*expected):
        alone = stiffness(*(array[index] for array in full[:2]), hypothesis, full[2][index])
        np.testing.assert_allclose(ours[index], alone, rtol=BATCH)


@pytest.mark.parametrize("hypothesis", HYPOTHESES)
def test_strides_and_blocks(hypothesis):
    # elements lost at the seam of two blocks, or read along the wrong stride
    size = 2 * BLOCK + 3
    d = np.linspace(-1, 2, 3 * size)[::-3]
    dr = np.asfortranarray(np.linspace(-0.99, 1.99, 2 * size).reshape(size, 2))[:, 1]
    ours = stiffness(d, dr, hypothesis)
    assert ours.flags.c_contiguous
    for index in (0, BLOCK - 1, BLOCK, 2 * BLOCK - 1, 2 * BLOCK, size - 1):
        np.testing.assert_allclose(ours[index], stiffness(d[index], dr[index], hypothesis), rtol=BATCH)


@pytest.mark.parametrize("hypothesis", HYPOTHESES)
def test_integers_and_single_precision_are_numbers(hypothesis):
    # arithmetic left in the argument's own precision would lose half the digits, or wrap around
    np.testing.assert_array_equal(stiffness(1, 0, hypothesis), stiffness(1.0, 0.0, hypothesis))
    np.testing.assert_array_equal(stiffness(np.int8([-1, 0, 2]), 0, hypothesis),
                                  stiffness([-1.0, 0.0, 2.0], 0.0, hypothesis))
    single = np.float32(0.3)
    np.testing.assert_array_equal(stiffness(single, 0, hypothesis), stiffness(float(single), 0.0, hypothesis))
    np.testing.assert_array_equal(stiffness(np.array([0.3], dtype=">f8"), 0, hypothesis)[0],
                                  stiffness(0.3, 0.0, hypothesis))


def test_arguments_are_left_alone():
    # work done in place on the caller's array
    d = np.array([0.1, 0.2])
    d.flags.writeable = False
    stiffness(d, d, "static")
    np.testing.assert_array_equal(d, [0.1, 0.2])


@pytest.mark.parametrize("hypothesis", ["kinematic", "static"])
def test_nothing_is_computed_that_is_not_used(hypothesis):
    # a formula evaluated outside its domain and masked afterwards warns about 0/0 or overflow
    d, dr = np.meshgrid(np.linspace(-1, 2, 31), [*EDGES_OF_DR, *np.linspace(-0.999, 1.999, 31)])
    with warnings.catch_warnings(), np.errstate(all="raise", under="ignore"):
        warnings.simplefilter("error")
        assert np.isfinite(stiffness(d, dr, hypothesis)).all()


def test_the_kinematic_is_stiffer_than_the_static():
    # hypotheses exchanged
    d, dr = np.meshgrid(np.linspace(-1, 2, 13), np.linspace(-0.9, 1.9, 13))
    assert (stiffness(d, dr, "kinematic")[..., [0, 1, 4, 5]]
            >= stiffness(d, dr, "static")[..., [0, 1, 4, 5]] * (1 - 1e-14)).all()


def test_kinetic_is_answered_where_all_contacts_carry_the_same():
    # D33 = -1 with ratio 1/2 and D33 = 2 with ratio 3 balance exactly, like D33 = 0 under equal stress
    d, ratio = np.array([0.0, -1.0, 2.0]), np.array([1.0, 0.5, 3.0])
    with_forces = granular.axial_stiffness(d, -0.3, ratio, 0.2)
    np.testing.assert_array_equal(with_forces, stiffness(d, -0.3, "kinematic"))
    assert granular.axial_stiffness(0.0, -0.3).shape == (6,)


@pytest.mark.parametrize(("d", "ratio"), [(0.3, 1.0), (0.0, 1.5), (0.0, math.nextafter(1, 2)), (0.3, 5.6 / 4.7)])
def test_forces_are_felt_elsewhere(d, ratio):
    # an answer with equal contact stiffness where the stress or the fabric makes forces differ, however little
    felt = granular.axial_stiffness([0.0, d], 0.0, [1.0, ratio], poisson_ratio=0.0, friction_coefficient=0.5)
    equal = granular.axial_stiffness([0.0, d], 0.0, [1.0, ratio], poisson_ratio=0.0, kinetic=False)
    np.testing.assert_array_equal(felt[0], equal[0])
    assert (equal[1, 2:4] == 0).all()  # nu = 0: only slip can make C1122 and C1133
    assert (felt[1, 2:4] > 0).all()


def test_no_shear_stiffness_without_friction():
    # friction of zero taken for none given: every contact slides, and the Cauchy relations hold
    c1111, c3333, c1122, c1133, c2323, c1212 = granular.axial_stiffness([0.3, 0.0], 0.2, [2.0, 1.0], 0.0).T
    np.testing.assert_allclose(c1133, c2323, rtol=1e-15)
    np.testing.assert_allclose(c1122, c1212, rtol=1e-15)
    assert (c1111 > 0).all()
    assert (c3333 > 0).all()


def test_static_with_sliding_contacts_names_the_element():
    # an infinite compliance inverted into zeros, or an error that does not say where
    ratios = np.array([1.0, 1.2, 4.0, 9.0])
    with pytest.raises(ComplianceInfinite, match=r"stress ratio 4.*element 2 of 4"):
        granular.axial_stiffness(0.0, 0.0, ratios, 0.2, hypothesis="static")
    assert np.isfinite(granular.axial_stiffness(0.0, 0.0, [1.0, 4.0], [0.2, 0.75], hypothesis="static")).all()


@pytest.mark.parametrize(("arguments", "kind", "message"), [
    ({"D33": [[0.0, 1.0], [2.5, math.nan]]}, FabricOutOfRange, "D33[1, 0] = 2.5"),
    ({"D33": math.nan}, FabricOutOfRange, "D33 = nan"),
    ({"D33": [0.0, -math.inf]}, FabricOutOfRange, "D33[1] = -inf"),
    ({"D33": math.nextafter(2, 3)}, FabricOutOfRange, "D33 = 2.00"),
    ({"Dr33": [0.0, -1.0]}, FabricOutOfRange, "Dr33[1] = -1.0"),
    ({"Dr33": 2}, FabricOutOfRange, "Dr33 = 2"),
    ({"poisson_ratio": [0.2, 0.6]}, ValueOutOfRange, "poisson_ratio[1] = 0.6"),
    ({"poisson_ratio": math.nan}, ValueOutOfRange, "poisson_ratio = nan"),
    ({"stress_ratio": 0.0}, ValueOutOfRange, "stress_ratio = 0.0"),
    ({"stress_ratio": math.inf}, ValueOutOfRange, "stress_ratio = inf"),
    ({"friction_coefficient": [0.1, -0.1]}, ValueOutOfRange, "friction_coefficient[1] = -0.1"),
    ({"D33": "0.3"}, ArrayNotUsable, "D33 holds str"),
    ({"D33": ["0.3", 1.0]}, ArrayNotUsable, "D33 holds str"),
    ({"D33": [None, 1.0]}, ArrayNotUsable, "D33 holds object"),
    ({"D33": [[1.0], [1.0, 0.5]]}, ArrayNotUsable, "different lengths"),
    ({"D33": 0.1 + 0j}, ArrayNotUsable, "complex"),
    ({"D33": True}, ArrayNotUsable, "bool"),
    ({"D33": np.ma.masked_array([0.1, 9.0], mask=[False, True])}, ArrayNotUsable, "masked"),
    ({"D33": [0.1, 0.2], "Dr33": [0.0, 0.1, 0.2]}, ArrayNotUsable, "D33 (2,), Dr33 (3,)"),
    ({"hypothesis": "voigt"}, UnknownChoice, "hypothesis = 'voigt'"),
    ({"rtol": 1e-17}, RouteOutOfDomain, "rtol = 1e-17"),
    ({"rtol": math.nan}, RouteOutOfDomain, "rtol = nan"),
    ({"invalid": "ignore"}, UnknownChoice, "invalid = 'ignore'"),
    ({"engine": "fortran"}, UnknownChoice, "engine = 'fortran'"),
    ({"threads": 0}, ValueOutOfRange, "threads = 0"),
    ({"threads": 1.5}, ValueOutOfRange, "threads = 1.5"),
    ({"out": np.empty(5)}, ArrayNotUsable, "out has shape (5,), needed: shape (6,)"),
    ({"out": np.empty(6, np.float32)}, ArrayNotUsable, "out holds <f4"),
    ({"out": np.empty(6, ">f8")}, ArrayNotUsable, "out holds >f8"),
    ({"out": [0.0] * 6}, ArrayNotUsable, "out is a list"),
    ({"out": np.broadcast_to(0.0, 6)}, ArrayNotUsable, "out is read only"),
])  # fmt: skip
def test_bad_elements_are_named(arguments, kind, message):
    # a NaN that travels into the result, or a message without the place
    with pytest.raises(kind) as refusal:
        granular.axial_stiffness(**{"D33": 0.0, "Dr33": 0.0, "kinetic": False, **arguments})
    assert message in str(refusal.value)
    assert str(refusal.value).endswith(".")


def test_a_modest_accuracy_is_granted():
    # rtol refused although kept
    assert granular.axial_stiffness(0.0, 0.0, rtol=1e-12).shape == (6,)


CASES = [{"kinetic": False}, {"kinetic": True}, {"kinetic": False, "hypothesis": "static"}, {"hypothesis": "static"},
         {"friction_coefficient": 0.5}]


@pytest.mark.parametrize("options", CASES, ids=str)
def test_out_is_filled_and_returned(options):
    # a result written elsewhere, in another order, or over arguments that are still to be read
    rng = np.random.default_rng(5)
    d, dr, ratio = rng.uniform(-1, 2, (4, 1)), rng.uniform(-0.9, 1.9, 3), rng.uniform(0.2, 5, (4, 3))
    known = granular.axial_stiffness(d, dr, ratio, **options)
    for out in (np.empty((4, 3, 6)), np.empty((6, 3, 4)).T, np.empty((8, 3, 12))[::-2, :, ::2],
                np.empty(4 * 3 * 6 * 8 + 1, np.uint8)[1:].view(np.float64).reshape(4, 3, 6)):
        assert granular.axial_stiffness(d, dr, ratio, out=out, **options) is out
        np.testing.assert_array_equal(out, known)
    over = np.empty((4, 3, 6))
    over[..., 0] = ratio
    np.testing.assert_array_equal(granular.axial_stiffness(d, dr, over[..., 0], out=over, **options), known)


@pytest.mark.parametrize("options", CASES, ids=str)
def test_invalid_elements_can_become_nan(options):
    # a valid neighbour lost, an invalid one answered, or a mask that is not that of the first component
    d = np.array([[0.1], [math.nan], [0.3], [2.5]])
    ratio, nu = np.array([1.0, -1.0, 1.5, math.inf]), np.array(0.2)
    found = granular.axial_stiffness(d, -0.3, ratio, poisson_ratio=nu, invalid="nan", **options)
    valid = np.isin(np.arange(4), [0, 2])
    np.testing.assert_array_equal(~np.isnan(found), np.broadcast_to((valid[:, None] & valid)[..., None], found.shape))
    np.testing.assert_array_equal(found[::2, ::2], granular.axial_stiffness(d[::2], -0.3, ratio[::2], poisson_ratio=nu,
                                                                          **options))
    assert np.isnan(granular.axial_stiffness(0.1, 0.1, math.nan, invalid="nan", **options)).all()


def test_an_infinite_compliance_can_become_nan():
    # sliding contacts refused although NaN was asked for, or the sticking ones lost with them
    found = granular.axial_stiffness(0.0, 0.0, [1.0, 1.2, 4.0], 0.2, hypothesis="static", invalid="nan")
    assert np.isnan(found).all(axis=-1).tolist() == np.isnan(found).any(axis=-1).tolist() == [False, False, True]


@pytest.mark.parametrize("kinetic", [False, True])
def test_kernel_and_sums_meet(kinetic):
    # an element that the kernel leaves, put in the place of another
    ratio = np.array([1e-3, 0.34, 0.3, 1.0, 3.0, 20.0, 1e6])
    found = granular.axial_stiffness(0.3, -0.3, ratio, kinetic=kinetic)
    for row, one in zip(found, ratio.tolist(), strict=True):
        np.testing.assert_array_equal(row, granular.axial_stiffness(0.3, -0.3, one, kinetic=kinetic))


@pytest.mark.parametrize("kinetic", [False, True])
def test_engines_and_threads_change_no_bit(kinetic):
    # two ways that differ in the last place, so that a result would depend on the machine
    rng = np.random.default_rng(2)
    arguments = rng.uniform(-1, 2, 5000), rng.uniform(-0.9, 1.9, 5000), rng.uniform(0.1, 8, 5000)
    known = granular.axial_stiffness(*arguments, kinetic=kinetic, engine="numpy")
    for options in ({"engine": "compiled"}, {"engine": "compiled", "threads": 3}, {"engine": "numpy", "threads": 2}):
        np.testing.assert_array_equal(granular.axial_stiffness(*arguments, kinetic=kinetic, **options), known)
