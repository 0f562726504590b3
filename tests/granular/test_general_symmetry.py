"""Classes of symmetry: tensors made in a frame, turned at random, and found again."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

from granular.elasticity import Stiffness
from granular.errors import TensorNotElastic
from granular.general import GeneralFabric, GeneralLoading, classify, general_stiffness
from granular.general.symmetry import axial_part, isotropic_part, orthotropic_part

sys.path.insert(0, str(Path(__file__).parents[1]))
from general_fabrics import apart, rotation

PARTS = {"isotropic": isotropic_part, "transversely isotropic": axial_part, "orthotropic": orthotropic_part}


def some_stiffness(seed: int) -> np.ndarray:
    """A positive definite Mandel matrix without symmetry."""
    a = np.random.default_rng(seed).normal(size=(6, 6))
    return a @ a.T


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("name", PARTS)
def test_a_class_is_found_in_any_frame(name: str, seed: int) -> None:
    """The class, its axis or frame, and distances of zero to it and to all less symmetric ones."""
    turn = rotation(seed)
    matrix = Stiffness.from_mandel(PARTS[name](some_stiffness(seed))).rotated(turn).mandel()
    found = classify(matrix)
    distances = (found.isotropic, found.transversely_isotropic, found.orthotropic)
    assert found.name == name
    place = list(PARTS).index(name)
    assert max(distances[place:]) < 1e-13
    assert min(distances[:place], default=1.0) > 1e-2
    if name == "transversely isotropic":
        assert abs(np.array(found.axis) @ turn[:, 2]) == pytest.approx(1, abs=1e-12)
    seen = Stiffness.from_mandel(matrix).rotated(np.array(found.frame)).mandel()
    assert apart(orthotropic_part(seen), seen) < 1e-12


@pytest.mark.parametrize("seed", range(4))
def test_distances_do_not_depend_on_the_frame(seed: int) -> None:
    """A minimum found from one side only would differ after a turn; and they fall from class to class."""
    matrix = some_stiffness(seed)
    one, two = classify(matrix), classify(Stiffness.from_mandel(matrix).rotated(rotation(seed + 9)).mandel())
    assert one.name == two.name == "general"
    for name in ("isotropic", "transversely_isotropic", "orthotropic"):
        assert getattr(one, name) == pytest.approx(getattr(two, name), rel=1e-8)
    assert one.isotropic >= one.transversely_isotropic >= one.orthotropic > 0


@pytest.mark.parametrize("part", PARTS.values(), ids=PARTS)
def test_projections_are_orthogonal_and_invariant(part) -> None:
    """What is left over is orthogonal to the class; a turn that the class does not feel changes nothing."""
    a, b = some_stiffness(5), some_stiffness(6)
    assert np.abs(part(part(a)) - part(a)).max() < 1e-13
    assert np.sum((a - part(a)) * part(b)) == pytest.approx(0, abs=1e-12)
    angle = 0.7
    about_3 = np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]])
    turn = {isotropic_part: rotation(1), axial_part: about_3, orthotropic_part: np.diag([1.0, -1.0, -1.0])}[part]
    turned = Stiffness.from_mandel(part(a)).rotated(turn).mandel()
    assert np.abs(turned - part(a)).max() < 1e-13


def test_axial_part_is_the_mean_over_turns() -> None:
    """By eight equal turns about axis 3, which are enough for components of rank four."""
    matrix = some_stiffness(7)
    turns = [np.array([[np.cos(t), -np.sin(t), 0], [np.sin(t), np.cos(t), 0], [0, 0, 1]])
             for t in np.arange(8) * np.pi / 4]
    mean = np.mean([Stiffness.from_mandel(matrix).rotated(turn).mandel() for turn in turns], axis=0)
    assert np.abs(mean - axial_part(matrix)).max() < 1e-13


def test_a_small_disturbance_is_measured() -> None:
    """The distance of a nearly orthotropic tensor is the disturbance, less what another frame takes up."""
    base = orthotropic_part(some_stiffness(8))
    disturbed = base + 1e-5 * np.linalg.norm(base) * np.eye(6)[[3]].T @ np.eye(6)[[4]] / np.sqrt(2)
    disturbed = (disturbed + disturbed.T) / 2
    found = classify(disturbed, tolerance=1e-9)
    assert found.name == "general"
    assert 1e-8 < found.orthotropic <= 0.5e-5 * 1.0001
    assert classify(disturbed, tolerance=1e-4).name == "orthotropic"


def test_symmetry_of_assemblies() -> None:
    """Coaxial fabric and stress make an orthotropic solid, an axis a transversely isotropic one, shear none of both."""
    turn = rotation(3)
    def stiffness(D: np.ndarray, stress: np.ndarray) -> np.ndarray:
        return general_stiffness(GeneralFabric(turn @ D @ turn.T), poisson_ratio=0.21, hypothesis="kinematic",
                                 loading=GeneralLoading(turn @ stress @ turn.T), rtol=1e-11).mandel()

    D, stress = np.diag([0.3, 0.1, -0.4]), np.diag([1.0, 1.5, 2.0])
    assert classify(stiffness(D, stress)).name == "orthotropic"
    assert classify(stiffness(np.diag([0.2, 0.2, -0.4]), np.diag([1.0, 1.0, 2.0]))).name == "transversely isotropic"
    assert classify(stiffness(0 * D, np.eye(3))).name == "isotropic"
    skew = stress + 0.3 * np.array([[0, 1, 0.5], [1, 0, 0.2], [0.5, 0.2, 0]])
    assert classify(stiffness(D, skew)).name == "general"


def test_zero_and_wrong_tensors() -> None:
    """No division by a norm of zero; a matrix that is not symmetric is refused."""
    assert classify(np.zeros((6, 6))).name == "isotropic"
    with pytest.raises(TensorNotElastic):
        classify(np.arange(36.0).reshape(6, 6))
