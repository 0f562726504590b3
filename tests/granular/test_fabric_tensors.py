"""Fabric tensors of directions: exact identities, sums in any order, any axes, and what is refused."""

from __future__ import annotations

import importlib
import subprocess
import sys
from itertools import pairwise

import hypothesis.strategies as st
import numpy as np
import pytest
from hypothesis import given, settings
from scipy.integrate import lebedev_rule

from granular.errors import ArrayNotUsable, DirectionNotUnit, NotFinite, TooFewDirections, ValueOutOfRange
from granular.fabric_tensors import Moments, directions_of, fabric_of
from granular.fabric_tensors.components import full_4, moments_of, quadruple_products, rotation_matrix, third_kind
from granular.fabric_tensors.moments import ROWS
from granular.fabric_tensors.sampling import axial_tensors, isotropic, tensors_of, uniform

NAMES = ("N2", "N4", "F2", "F4", "D2", "D4")
FULL = "ai,bj,ck,dl,ijkl->abcd"


def random_directions(count, seed=1):
    return uniform(np.random.default_rng(seed), count)


def quaternion_rotation(parts):
    w, x, y, z = np.asarray(parts) / np.linalg.norm(parts)
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                     [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


rotations = st.tuples(*[st.floats(-1, 1)] * 4).filter(lambda q: np.linalg.norm(q) > 0.1).map(quaternion_rotation)


@pytest.mark.parametrize("degree", [5, 11, 23])
def test_isotropic_points_have_no_anisotropy(degree):
    # a constant of the third kind that is off: Lebedev's rules of degree 5 and more integrate rank four exactly
    points, weights = lebedev_rule(degree)
    tensors = fabric_of(points.T, weights)
    assert abs(tensors.D2).max() < 1e-13  # 15/2 times the rounding of 1/3
    assert abs(tensors.D4).max() < 1e-12  # 315/8 times that of 1/5
    assert tensors.N2 == pytest.approx(np.eye(3) / 3, abs=1e-14)
    assert tensors.N4[0, 0, 0, 0] == pytest.approx(1 / 5, rel=1e-13)
    assert tensors.N4[0, 0, 1, 1] == pytest.approx(1 / 15, rel=1e-13)


@pytest.mark.parametrize(("D33", "D3333"), [(0.3, 0.0), (-0.9, 0.4), (1.5, 0.6), (0.0, -0.3)])
@pytest.mark.parametrize("axis", [(0.0, 0.0, 1.0), (1.0, -2.0, 2.0)])
def test_density_that_is_integrated_comes_back(D33, D3333, axis):
    # a component put in another's place, or P4 with another factor; the rule of degree 11 is exact for rank 4 + 4
    points, weights = lebedev_rule(11)
    cosine = points.T @ np.array(axis) / np.linalg.norm(axis)
    legendre = 1 + D33 * (3 * cosine**2 - 1) / 2 + D3333 * (35 * cosine**4 - 30 * cosine**2 + 3) / 8
    found, known = fabric_of(points.T, weights * legendre), axial_tensors(D33, D3333, axis)
    for name in NAMES:
        assert getattr(found, name) == pytest.approx(getattr(known, name), abs=2e-12)
    unit = np.array(axis) / np.linalg.norm(axis)
    assert np.einsum("ij,i,j", found.D2, unit, unit) == pytest.approx(D33, abs=1e-12)
    assert np.einsum("ijkl,i,j,k,l", found.D4, *[unit] * 4) == pytest.approx(D3333, abs=2e-12)


def test_kinds_by_their_definitions():
    # relations of the three kinds, with the tensor algebra written out in full: no function of the library but the list
    n = random_directions(40)
    tensors, one = fabric_of(n), np.eye(3)
    N2, N4 = np.einsum("mi,mj->ij", n, n) / 40, np.einsum("mi,mj,mk,ml->ijkl", n, n, n, n) / 40

    def symmetric(a, b):
        orders = ("ij,kl->ijkl", "ik,jl->ijkl", "il,jk->ijkl")
        return sum(np.einsum(order, p, q) for order in orders for p, q in ((a, b), (b, a))) / 6

    expected = {
        "N2": N2, "N4": N4, "D2": 15 / 2 * (N2 - one / 3), "F2": 15 / 2 * (N2 - one / 5),
        "D4": 315 / 8 * (N4 - 6 / 7 * symmetric(one, N2) + 3 / 35 * symmetric(one, one)),
        "F4": 315 / 8 * (N4 - 2 / 3 * symmetric(one, N2) + 1 / 21 * symmetric(one, one))}
    for name, value in expected.items():
        assert getattr(tensors, name) == pytest.approx(value, abs=1e-12)
    assert np.einsum("iikl->kl", tensors.D4) == pytest.approx(np.zeros((3, 3)), abs=1e-12)
    assert np.einsum("iikl->kl", tensors.N4) == pytest.approx(tensors.N2, abs=1e-15)
    assert np.einsum("iikl->kl", tensors.F4) == pytest.approx(5 / 3 * one + 7 / 6 * tensors.D2, abs=1e-12)
    assert np.trace(tensors.F2) == pytest.approx(3, abs=1e-14)


def test_moments_there_and_back():
    # the way back from the third kind is not the inverse
    moments = quadruple_products(random_directions(30)).mean(axis=0)
    assert moments_of(*third_kind(moments)) == pytest.approx(moments, abs=1e-15)


def test_both_ends_of_a_contact_are_the_same():
    # an odd power anywhere
    n = random_directions(50)
    signs = np.where(np.arange(50) % 3 == 0, -1.0, 1.0)[:, None]
    for name in NAMES:
        assert getattr(fabric_of(n), name) == pytest.approx(getattr(fabric_of(signs * n), name), abs=1e-13)


def test_weights_count_as_repetitions():
    # weights that enter the means in another way than the number of copies
    n, times = random_directions(20), np.arange(20) % 4
    weighted, repeated = fabric_of(n, times), fabric_of(np.repeat(n, times, axis=0))
    assert weighted.D4 == pytest.approx(repeated.D4, abs=1e-12)
    assert weighted.count == 20
    assert weighted.effective_number == pytest.approx(times.sum() ** 2 / (times**2).sum(), rel=1e-14)
    # the unit of weights is free
    assert fabric_of(n, 1e150 * times).covariance == pytest.approx(weighted.covariance, rel=1e-9, abs=1e-16)


@settings(max_examples=30, deadline=None)
@given(rotation=rotations, seed=st.integers(0, 5))
def test_turned_directions_have_turned_tensors(rotation, seed):
    # a tensor that depends on the axes
    n = random_directions(60, seed)
    tensors, turned = fabric_of(n), fabric_of(n @ rotation.T)
    for kind in "NFD":
        second = rotation @ getattr(tensors, f"{kind}2") @ rotation.T
        fourth = np.einsum(FULL, *[rotation] * 4, getattr(tensors, f"{kind}4"))
        assert getattr(turned, f"{kind}2") == pytest.approx(second, abs=1e-12)
        assert getattr(turned, f"{kind}4") == pytest.approx(fourth, abs=1e-11)
    matrix = rotation_matrix(rotation)
    assert turned.moments == pytest.approx(matrix @ tensors.moments, abs=1e-14)
    assert turned.covariance == pytest.approx(matrix @ tensors.covariance @ matrix.T, abs=1e-15)


@settings(max_examples=20, deadline=None)
@given(cuts=st.lists(st.integers(0, 3 * ROWS), max_size=4), weighted=st.booleans())
def test_blocks_in_any_cut_give_the_same(cuts, weighted):
    # a row lost or counted twice at the edge of a block
    n = random_directions(3 * ROWS)
    w = np.linspace(0, 2, len(n)) if weighted else None
    whole, sums, ends = fabric_of(n, w), Moments(), [0, *sorted(cuts), len(n)]
    for start, stop in pairwise(ends):
        part = Moments()
        part.add(n[start:stop], None if w is None else w[start:stop])
        sums = part.merge(sums)
    again = sums.fabric()
    assert (again.count, again.effective_number) == (len(n), pytest.approx(whole.effective_number, rel=1e-12))
    assert again.D4 == pytest.approx(whole.D4, abs=1e-11)
    assert again.covariance == pytest.approx(whole.covariance, abs=1e-17)


def test_merging_changes_neither():
    # sums that share their arrays
    one, other = Moments(), Moments()
    one.add(random_directions(30, 1))
    other.add(random_directions(30, 2))
    before = one.mean().copy()
    both = one.merge(other)
    both.add(random_directions(30, 3))
    assert (one.count, other.count, both.count) == (30, 30, 90)
    assert (one.mean() == before).all()


def test_a_refused_block_leaves_the_sums_as_they_were():
    # a block that is added up to its bad row
    sums = Moments()
    sums.add(random_directions(10))
    before = sums.mean().copy()
    with pytest.raises(NotFinite, match="direction 12 "):
        sums.add([[1, 0, 0], [0, 1, 0], [0, 0, np.nan]])
    assert sums.count == 10
    assert (sums.mean() == before).all()


def test_memory_does_not_grow_with_the_list():
    # sums that keep directions: the state of a million is that of one
    sums = Moments()
    sums.add(random_directions(1))
    size = sum(np.asarray(getattr(sums, name)).nbytes for name in Moments.__slots__)
    sums.add(random_directions(100_000))
    assert sum(np.asarray(getattr(sums, name)).nbytes for name in Moments.__slots__) == size


def test_lengths():
    # a length that weighs, or a unit vector of seven digits that is refused
    n = random_directions(30)
    lengths = np.geomspace(1e-200, 1e200, 30)[:, None]
    assert fabric_of(n * lengths, normalise=True).D4 == pytest.approx(fabric_of(n).D4, abs=1e-12)
    assert fabric_of(n.round(7)).count == 30
    assert fabric_of([[0, 0, 1]]).D2[2, 2] == 5


@pytest.mark.parametrize(("error", "match", "arguments", "options"), [
    (NotFinite, "direction 1 ", ([[0, 0, 1], [0, np.inf, 0]],), {}),
    (NotFinite, "direction 0 .*1 more", ([[np.nan] * 3] * 2,), {"normalise": True}),
    (DirectionNotUnit, r"direction 1 .*length 1\.00001", ([[0, 0, 1], [0, 0, 1.00001]],), {}),
    (DirectionNotUnit, "direction 0 .*length 0", ([[0, 0, 0]],), {}),
    (DirectionNotUnit, "any length but 0", ([[0, 0, 5], [0, 0, 0]],), {"normalise": True}),
    (DirectionNotUnit, "length inf", ([[1.7e308, 1.7e308, 1.7e308]],), {}),
    (ArrayNotUsable, "shape", ([0, 0, 1],), {}),
    (ArrayNotUsable, "shape", ([[0, 1]],), {}),
    (ArrayNotUsable, "real numbers", ([["a", "b", "c"]],), {}),
    (ArrayNotUsable, "real numbers", ([[0, 0, 1], [0, 1]],), {}),
    (ArrayNotUsable, "real numbers", ([[0, 0, 1j]],), {}),
    (ArrayNotUsable, "weights of shape", ([[0, 0, 1]], [1, 2]), {}),
    (ValueOutOfRange, "weight 1 = -1", ([[0, 0, 1], [0, 1, 0]], [1, -1]), {}),
    (NotFinite, "weight 0 = nan", ([[0, 0, 1]], [np.nan]), {}),
    (ValueOutOfRange, "sum of the weights", ([[0, 0, 1]], [0]), {}),
    (ValueOutOfRange, "sum of the weights", ([[0, 0, 1]], [1e-160]), {}),
    (NotFinite, "squared weights", ([[0, 0, 1]], [1e200]), {}),
    (TooFewDirections, "0 directions", (np.empty((0, 3)),), {}),
])
def test_refusals(error, match, arguments, options):
    # an input that would give a wrong number
    with pytest.raises(error, match=match):
        fabric_of(*arguments, **options)


def test_known_tensors_need_no_list():
    # a density whose tensors are taken for those of a list
    assert abs(isotropic().D2).max() < 1e-15
    tensors = tensors_of(axial_tensors(0.3).D2, axial_tensors(0.0, 0.2).D4)
    assert tensors.D4 == pytest.approx(axial_tensors(0.3, 0.2).D4, abs=1e-13)
    with pytest.raises(TooFewDirections):
        tensors.require()


def test_full_tensor_is_symmetric():
    # an index put in another's place
    tensor = full_4(np.arange(15.0))
    for order in ((1, 0, 2, 3), (0, 2, 1, 3), (3, 1, 2, 0)):
        assert (tensor == tensor.transpose(order)).all()


def test_same_seed_same_directions():
    # random numbers from a global state
    draws = [directions_of(axial_tensors(0.5), 50, seed=seed) for seed in (3, 3, 4)]
    assert (draws[0] == draws[1]).all()
    assert not (draws[0] == draws[2]).all()


def test_import_is_light():
    # a numeric library loaded by looking at the package
    importlib.import_module("granular.fabric_tensors")
    code = "import sys, granular.fabric_tensors; print(sorted({'numpy', 'scipy', 'sympy'} & set(sys.modules)))"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout == "[]\n"
