"""Sums over contact lists: identities first, then limits that are known, then packings of known stiffness."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import numpy as np
import pytest

from granular.contact_law import reference_stiffness
from granular.contacts import compiled
from granular.contacts.block import ContactBlock
from granular.contacts.kernels import PairSums, stiffness_sum
from granular.contacts.material import Material
from granular.contacts.moments import Moments
from granular.contacts.summary import summarise
from granular.elasticity import Stiffness
from granular.errors import ArrayNotUsable, ConflictingKeys, ValueOutOfRange
from granular.routes.direction_sums import mandel_matrix, symmetrised

sys.path.insert(0, str(Path(__file__).parent))
from contact_lists import DEM, EXAMPLE, FACTS, icosahedron, random_block

ROUNDING = 1e-13
"""Sums of some thousand terms of one size, in two orders."""


def by_einsum(block):
    contact = (block.kn - block.ks) * block.normal[:, None] * block.normal[None] + block.ks * np.eye(3)[:, :, None]
    return np.einsum("ic,jlc,kc->ijkl", block.branch, contact, block.branch)


def test_raw_sum_is_equation_1_as_it_stands():
    # Breaks when an index of l_i k_jl l_k is in the wrong place: nothing of the lists here is symmetric.
    block, sums = random_block(9001), PairSums()
    sums.add(block.branch, block.normal, block.kn - block.ks, block.ks)
    expected = by_einsum(block)
    assert abs(sums.tensor() - expected).max() < ROUNDING * abs(expected).max()
    assert abs(expected - expected.transpose(1, 0, 2, 3)).max() > 0.01 * abs(expected).max()


@pytest.mark.parametrize("compiled_loop", [False, True])
def test_both_ways_of_summing_are_the_symmetrised_sum(compiled_loop):
    # Breaks when the compiled loop and NumPy sum different things, or one of them misses the last block.
    block = random_block(2 * compiled.BLOCK + 17)
    found = stiffness_sum(block.branch, block.normal, block.kn, block.ks, compiled=compiled_loop)
    expected = mandel_matrix(symmetrised(by_einsum(block)))
    assert abs(found - expected).max() < ROUNDING * abs(expected).max()


def test_the_loop_is_right_without_its_compiler():
    # Breaks when the loop means something else as plain Python; numba is optional.
    block, total, plain = random_block(301), np.zeros(27), np.zeros(27)
    arrays = (*block.branch, *block.normal, block.kn, block.ks)
    compiled.stiffness_sums(*arrays, plain)
    loop = compiled.compiled_sums()
    if loop is None:
        pytest.skip("numba is not installed")
    loop(*arrays, total)
    assert abs(total - plain).max() < ROUNDING * abs(plain).max()


def test_a_list_is_the_sum_of_its_blocks():
    # Breaks when something is normalised by the size of a block.
    whole, parts, block = Moments(0.3), Moments(0.3), random_block(1000)
    whole.add(block, (block.kn, block.ks))
    for here in (slice(0, 1), slice(1, 617), slice(617, 1000)):
        some = ContactBlock(branch=block.branch[:, here], normal=block.normal[:, here], kn=block.kn[here],
                            ks=block.ks[here], normal_force=block.normal_force[here],
                            shear_force=block.shear_force[:, here])
        parts.add(some, (some.kn, some.ks))
    assert (parts.contacts, parts.sliding, parts.flexible) == (whole.contacts, whole.sliding, whole.flexible)
    for name in ("normals", "branches", "mixed", "stress"):
        one, other = getattr(parts, name), getattr(whole, name)
        assert abs(one - other).max() < ROUNDING * abs(other).max()
    for name in ("kinematic", "static"):
        one, other = getattr(parts, name).tensor(), getattr(whole, name).tensor()
        assert abs(one - other).max() < ROUNDING * abs(other).max()


def test_turning_the_list_turns_the_stiffness():
    # Breaks when an axis is preferred where none may be.
    block = random_block(500)
    turn, _ = np.linalg.qr(np.random.default_rng(3).normal(size=(3, 3)))
    before = Stiffness.from_mandel(stiffness_sum(block.branch, block.normal, block.kn, block.ks))
    after = Stiffness.from_mandel(stiffness_sum(turn @ block.branch, turn @ block.normal, block.kn, block.ks))
    assert np.allclose(after.mandel(), before.rotated(turn).mandel(), rtol=0, atol=1e-12 * before.C3333)


def write_list(path, branch, normal, **more):
    columns = {f"l{i + 1}": branch[i] for i in range(3)} | {f"n{i + 1}": normal[i] for i in range(3)} | more
    rows = np.array([np.broadcast_to(column, branch.shape[1]) for column in columns.values()]).T
    np.savetxt(path, rows, delimiter=",", header=",".join(columns), comments="", fmt="%.17g")
    return path


def test_six_axes_give_the_isotropic_limits_of_both_hypotheses(tmp_path):
    # Breaks when eq. (5) is balanced wrongly: K and G are known for equal contacts in all directions.
    axes, kn, ks, length, volume = icosahedron(), 3.0, 2.0, 2.0, 7.0
    packing = summarise(write_list(tmp_path / "list.csv", length * axes, axes, kn=kn, ks=ks), volume=volume)
    unit = 6 * length**2 / volume
    for found, shear in ((packing.kinematic, unit * (2 * kn + 3 * ks) / 30),
                         (packing.static, 5 * unit / 6 * kn * ks / (3 * kn + 2 * ks))):
        assert found.component("C2323") == pytest.approx(shear, rel=1e-12)
        assert (found.component("C1111") + 2 * found.component("C1122")) / 3 == pytest.approx(unit * kn / 9, rel=1e-12)
    assert packing.normals == pytest.approx(np.eye(3) / 3, abs=1e-12)


def test_forces_give_the_stiffness_of_the_ideal_assembly(tmp_path):
    # Breaks when R_e, the exponent or a factor of eq. (20) is off: an isotropic list must be the Hertz-Mindlin medium.
    axes, length, volume, pressure = icosahedron(), 2e-3, 2e-8, 1e5
    per_volume = 6 / volume
    path = write_list(tmp_path / "list.csv", length * axes, axes, fn=3 * pressure / (per_volume * length))
    packing = summarise(path, volume=volume, material=Material(shear_modulus=29e9, poisson_ratio=0.2))
    # e and N enter as their ratio, 3 N/(pi (1 + e)) = (M/V) (2 r)^3
    coordination = per_volume * length**3 * np.pi * 1.6 / 3
    unit = reference_stiffness(29e9, 0.2, mean_stress=pressure, void_ratio=0.6, coordination_number=coordination)
    ratio = 2 * 0.8 / 1.8
    assert packing.kinematic.component("C2323") == pytest.approx(unit * (2 + 3 * ratio) / 30, rel=1e-12)
    assert packing.stress == pytest.approx(pressure * np.eye(3), rel=1e-12, abs=1e-6)


def test_estimated_forces_balance_the_stress():
    # Breaks when f_j = sigma_pj H^-1_kp n_k/l has an index transposed: its own stress must be sigma, for any branches.
    block, moments = random_block(400), Moments(None)
    moments.add(block, None)
    stress = np.array([[3.0, 0.4, -0.2], [0.4, 2.0, 0.1], [-0.2, 0.1, 5.0]])
    length = np.sqrt(np.sum(block.branch**2, axis=0))
    force = np.einsum("pj,kp,kc->jc", stress, np.linalg.inv(moments.mixed), block.normal) / length
    along = np.sum(force * block.normal, axis=0)
    carried = Moments(None)
    carried.add(ContactBlock(branch=block.branch, normal=block.normal, normal_force=along,
                             shear_force=force - along * block.normal), None)
    assert carried.stress == pytest.approx(stress, abs=1e-12)


def test_sliding_takes_the_shear_stiffness_and_then_there_is_no_static_one(tmp_path):
    # Breaks when a contact beyond its friction keeps stiffness, or an infinite compliance is inverted.
    axes = icosahedron()
    path = write_list(tmp_path / "list.csv", 2e-3 * axes, axes, fn=1.0, fs1=0.0, fs2=0.0,
                      fs3=np.array([0.0, 0.1, 0.2, 0.3, 0.31, 0.4]))
    packing = summarise(path, volume=1e-8, material=Material(shear_modulus=29e9, poisson_ratio=0.2, friction=0.3))
    assert packing.sliding == pytest.approx(3 / 6)
    assert packing.static is None
    assert "3 contacts" in packing.no_static
    assert packing.mean_ks < packing.mean_kn * (2 * 0.8 / 1.8) * 0.5


@pytest.mark.parametrize(("given", "kind"), [
    ({"shear_modulus": 0.0, "poisson_ratio": 0.2}, ValueOutOfRange), ({"friction": -0.1}, ValueOutOfRange),
    ({"shear_modulus": 1e9, "poisson_ratio": 0.6}, ValueOutOfRange), ({"shear_modulus": 1e9}, ConflictingKeys),
    ({"friction": float("nan")}, ValueOutOfRange)])
def test_impossible_materials_are_refused(given, kind):
    # Breaks when a solid that is none gives a stiffness.
    with pytest.raises(kind):
        Material(**given)


def test_a_block_of_uneven_arrays_is_refused():
    # Breaks when a force of the wrong length is broadcast over the contacts.
    with pytest.raises(ArrayNotUsable, match="normal_force"):
        ContactBlock(branch=np.ones((3, 4)), normal=np.ones((3, 4)), normal_force=np.ones(1))


def known_packings():
    yield EXAMPLE, FACTS
    for path in sorted(DEM.glob("*_meta.json")) if DEM.is_dir() else []:
        yield (DEM / path.name.replace("_meta.json", "_contacts.csv.gz")), json.loads(path.read_text("utf-8"))


@pytest.mark.parametrize(("path", "known"), [pytest.param(*one, id=f"{one[1]['name']}{k}")
                                             for k, one in enumerate(known_packings())])
def test_packings_of_known_sums(path, known):
    # Breaks when a sum differs from the one that an independent program recorded; columns are rounded to 7 digits.
    packing = summarise(path, volume=known["V"], grains=known["N_grains"], material=Material(friction=known["mu"]))
    voigt = np.array(known["eq1_voigt"])
    assert abs(packing.kinematic.voigt() - voigt).max() < 1e-6 * voigt[2, 2]
    assert packing.coordination_number == pytest.approx(known["Z"], rel=1e-12)
    assert abs(packing.stress - known["stress_love"]).max() < 1e-6 * np.trace(packing.stress)
    for key, value in (("Z_mechanical_Thornton", packing.coordination_without_rattlers),
                       ("N_sliding_0p999", packing.sliding * packing.contacts)):
        if key in known:
            assert value == pytest.approx(known[key], rel=1e-9)
    if "eq1_raw_C2323" in known:
        assert packing.raw[1, 2, 1, 2] == pytest.approx(known["eq1_raw_C2323"], rel=1e-6)
        assert packing.raw[1, 2, 2, 1] == pytest.approx(known["eq1_raw_C2332"], rel=1e-6)
        assert packing.normals == pytest.approx(np.array(known["fabric_N"]), abs=1e-7)
        assert packing.branches == pytest.approx(np.array(known["fabric_branch"]), abs=1e-7)


def test_static_sum_is_below_the_kinematic_one_in_every_strain():
    # Breaks when one of the two is wrong: C of eq. (1) less C of eq. (5) has no negative eigenvalue here.
    packing = summarise(EXAMPLE, volume=FACTS["V"])
    gap = np.linalg.eigvalsh(packing.kinematic.mandel() - packing.static.mandel())
    assert gap[0] > 0
