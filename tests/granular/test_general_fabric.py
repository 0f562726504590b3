"""Fabric tensors without an axis: what is refused and why, and the closed form for contacts of equal stiffness."""

from __future__ import annotations

import math
import sys
from pathlib import Path

import numpy as np
import pytest

from granular.errors import FabricOutOfRange, StressNotCompressive, TensorUnusable, ValueOutOfRange
from granular.general import GeneralFabric, GeneralLoading, general_stiffness
from granular.general.closed_form import RELATIVE_ERROR
from granular.general.fabric import least_density, spread_directions
from granular.hypothesis import Hypothesis
from granular.routes.direction_sums import contact_tensor, fourth_rank, mandel_matrix, symmetrised

sys.path.insert(0, str(Path(__file__).parents[1]))
from general_fabrics import apart, general_fabric, harmonic, rotation


def summed(fabric: GeneralFabric, nu: float, hypothesis: Hypothesis, degree: int = 83) -> np.ndarray:
    """Eq. (1) and Figure 1(b) as they stand, over a Lebedev rule: nothing of moments or closed forms."""
    from scipy.integrate import lebedev_rule

    n, area = lebedev_rule(degree)
    density = area / (4 * math.pi) * fabric.relative_density(n)
    length, ratio = fabric.branch_weight(n), 2 * (1 - nu) / (2 - nu)
    one = np.ones_like(length)
    if hypothesis is Hypothesis.KINEMATIC:
        branch = length * n
        contacts = contact_tensor(n, (1 - ratio) * one, ratio * one)
        raw = fourth_rank(density * branch[:, None] * branch[None, :], contacts)
        return mandel_matrix(symmetrised(raw))
    carried = np.linalg.inv(fabric.tensor()) @ n / length
    raw = fourth_rank(density * carried[:, None] * carried[None, :],
                      contact_tensor(n, (1 - 1 / ratio) * one, one / ratio))
    return np.linalg.inv(mandel_matrix(symmetrised(raw)))


@pytest.mark.parametrize("hypothesis", Hypothesis)
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_closed_form_against_the_sum(seed: int, hypothesis: Hypothesis) -> None:
    """Eq. (1) summed over directions: a wrong moment or index shows; 1e-13 is rounding of 2000 directions."""
    fabric = general_fabric(seed, branches=0.6 if hypothesis is Hypothesis.KINEMATIC else 0.0)
    found = general_stiffness(fabric, poisson_ratio=0.21, hypothesis=hypothesis)
    assert (found.route, found.error_is, found.evaluations) == ("closed_form", "bound", 0)
    assert found.relative_error == RELATIVE_ERROR
    assert apart(found.mandel(), summed(fabric, 0.21, hypothesis)) < 1e-13


def test_static_average_with_branches_against_the_sum() -> None:
    """1/W^2 has no closed form: rules over the sphere take over, and say so."""
    fabric = general_fabric(4)
    found = general_stiffness(fabric, poisson_ratio=0.21, hypothesis="static", rtol=1e-11)
    assert (found.route, found.error_is) == ("lebedev", "estimate")
    assert apart(found.mandel(), summed(fabric, 0.21, Hypothesis.STATIC, 131)) < 1e-11


def test_twenty_one_components_are_those_of_the_matrix() -> None:
    """A component read from the wrong place, or with the wrong factor of Mandel's notation."""
    found = general_stiffness(general_fabric(5), poisson_ratio=0.3, hypothesis="kinematic")
    tensor = found.stiffness().tensor()
    assert len(found.components) == 21
    for name, value in found.components.items():
        i, j, k, m = (int(digit) - 1 for digit in name[1:])
        assert value == pytest.approx(tensor[i, j, k, m], rel=1e-15)
    assert found.stiffness(5.0).C1111 == pytest.approx(5 * found.components["C1111"], rel=1e-15)


def test_rank_four_moments_alone() -> None:
    """Without D, Dr and shear stiffness differences only (8/315) D_ijkl is left next to the isotropic part."""
    fourth = harmonic(rotation(6)[0], 0.5)
    nu = 0.5
    plain, with_four = (general_stiffness(GeneralFabric(D4=d4), poisson_ratio=nu, hypothesis="kinematic")
                        for d4 in (None, fourth))
    difference = (with_four.stiffness().tensor() - plain.stiffness().tensor()) / (1 / 3)  # 1 - lambda at nu = 1/2
    assert np.abs(difference - 8 / 315 * fourth).max() < 1e-15


@pytest.mark.parametrize(("tensor", "direction"), [
    ([[-1.2, 0, 0], [0, 0.6, 0], [0, 0, 0.6]], "(1, 0, 0)"),
    ([[0.7, 0, 0], [0, 0.7, 0], [0, 0, -1.4]], "(0, 0, 1)")])
def test_negative_densities_are_refused(tensor: list[list[float]], direction: str) -> None:
    """The refusal names the direction in which contacts would be fewer than none, and the value."""
    with pytest.raises(FabricOutOfRange, match=r"G-FAB-01.*4 pi E = -0\.[24]") as refusal:
        GeneralFabric(tensor)
    assert direction in str(refusal.value).replace("-0", "0")


@pytest.mark.parametrize("seed", range(4))
def test_least_density_with_rank_four(seed: int) -> None:
    """A minimum between the first directions must be found: 200,000 others find none below it."""
    fabric = general_fabric(seed, branches=0.0)
    least, direction = least_density(fabric)
    assert fabric.relative_density(direction[:, None])[0] == pytest.approx(least, abs=1e-15)
    dense = fabric.relative_density(spread_directions(200_000)).min()
    assert dense - 1e-4 < least <= dense


def test_rank_four_out_of_range_is_refused() -> None:
    """P4 is least at -3/7, off the axis: 1 - 3/7 * 2.4 < 0 in directions that no axis of a tensor has."""
    with pytest.raises(FabricOutOfRange, match=r"D with D4 gives 4 pi E = -0\.02857"):
        GeneralFabric(D4=harmonic(rotation(1)[2], 2.4))
    GeneralFabric(D4=harmonic(rotation(1)[2], 7 / 3))  # the boundary itself belongs to it


def test_the_boundary_of_rank_two_is_admissible() -> None:
    """No contacts in one direction is allowed; no branch is not."""
    turn = rotation(3)
    fabric = GeneralFabric(turn @ np.diag([-1.0, 0.4, 0.6]) @ turn.T)
    assert least_density(fabric)[0] == pytest.approx(0, abs=1e-15)
    with pytest.raises(FabricOutOfRange, match=r"Dr gives W = 0 along"):
        GeneralFabric(Dr=np.diag([-1.0, 0.4, 0.6]))


def test_unusable_tensors_are_refused() -> None:
    """Each of these would silently mean something else."""
    with pytest.raises(TensorUnusable, match="t12"):
        GeneralFabric([[0, 0.1, 0], [0.2, 0, 0], [0, 0, 0]])
    with pytest.raises(TensorUnusable, match="trace"):
        GeneralFabric(np.eye(3) * 0.1)
    with pytest.raises(TensorUnusable, match="trace"):
        GeneralFabric(D4=harmonic(np.array([0, 0, 1.0]), 0.1) + 0.01 * np.einsum("i,j,k,l", *[[0, 0, 1.0]] * 4))
    with pytest.raises(TensorUnusable, match="swapped"):
        GeneralFabric(D4=np.einsum("ij,kl", np.diag([1.0, -1, 0]), np.diag([0, 1.0, -1])))
    with pytest.raises(TensorUnusable, match="shape"):
        GeneralFabric(D4=np.eye(3))
    with pytest.raises(StressNotCompressive, match="G-SCN-09"):
        GeneralLoading(np.diag([1.0, 1.0, -3.0]))
    with pytest.raises(ValueOutOfRange, match="friction"):
        GeneralLoading(np.eye(3), friction=-0.1)


def test_mean_of_forces_is_the_stress() -> None:
    """Eq. (23) with A = N^-1: the mean of l_i f_j over the contacts is the stress, whatever fabric and stress are."""
    from scipy.integrate import lebedev_rule

    fabric = general_fabric(7)
    loading = GeneralLoading(rotation(8) @ np.diag([3.0, 1.0, 0.2]) @ rotation(8).T, friction=0.3)
    n, area = lebedev_rule(29)
    density = area / (4 * math.pi) * fabric.relative_density(n)
    force = loading.force_tensor(fabric) @ n  # over 3 p
    assert np.abs(3 * (density * n) @ force.T - np.array(loading.stress) / loading.mean).max() < 1e-14
