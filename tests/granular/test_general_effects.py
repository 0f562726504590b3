"""Bounds of effects in scenes without an axis: never exceeded by what leaving an effect out really changes.

"Really" is the closed form or a Lebedev rule with the effect and without it, over the largest entry of the Mandel
matrix.
"""

from __future__ import annotations

import math
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from granular.effects import CATALOGUE
from granular.effects.bound import Change
from granular.effects.forms import (
    GeneralSimulated,
    eigenvalue_range,
    largest_change_of_form,
    least_force,
    with_forces_of,
)
from granular.effects.kinetic import forces_are_equal
from granular.effects.ranges import Range
from granular.effects.selection import model_of, select
from granular.general import GeneralFabric, GeneralLoading, general_stiffness
from granular.general.fabric import density_range
from granular.general.loading import most_mobilised
from granular.hypothesis import Hypothesis
from granular.scene import Scene

sys.path.insert(0, str(Path(__file__).parents[1]))
from general_fabrics import apart, general_fabric, rotation, traceless

BY_NAME = {effect.name: effect for effect in CATALOGUE}
NU = 0.21
RTOL = 1e-7
"""Wanted of each of two evaluations: far below the changes that are compared."""


def simulated(fabric, loading, hypothesis) -> GeneralSimulated:
    return GeneralSimulated(fabric=fabric, loading=loading, sizes=None, poisson_ratio=NU, hypothesis=hypothesis)


def matrix(model: GeneralSimulated) -> np.ndarray:
    return general_stiffness(model.fabric, poisson_ratio=NU, hypothesis=model.hypothesis, loading=model.loading,
                             rtol=RTOL).mandel()


def without(model: GeneralSimulated, name: str) -> GeneralSimulated:
    """The model after one effect has been left out."""
    if name == "packing":
        return replace(model, fabric=replace(model.fabric, D=np.zeros((3, 3)), D4=None))
    if name == "branches":
        return replace(model, fabric=replace(model.fabric, Dr=None))
    return replace(model, loading=replace(model.loading, friction=None) if name == "slip" else None)


def stress(size: float, seed: int) -> np.ndarray:
    """A stress whose least principal value is 1 - size times the mean."""
    return np.eye(3) + traceless(size, seed)


def model(seed: int, size: float, hypothesis: Hypothesis, friction: float | None, *,
          rank_four: bool) -> GeneralSimulated:
    whole = general_fabric(seed)
    fabric = GeneralFabric(size * np.array(whole.D), Dr=size * np.array(whole.Dr),
                           D4=size * np.array(whole.D4) if rank_four else None)
    return simulated(fabric, GeneralLoading(stress(0.5 * size, seed + 7), friction), hypothesis)


CASES = [(seed, size, name, hypothesis) for seed, size in ((1, 1e-6), (2, 1e-2), (3, 0.3), (4, 1.0))
         for name in ("packing", "branches", "kinetic", "slip") for hypothesis in Hypothesis]


@pytest.mark.parametrize(("seed", "size", "name", "hypothesis"), CASES)
def test_no_bound_is_exceeded(seed, size, name, hypothesis):
    # Breaks when a bound is no bound: tensors of every size that share nothing, by both hypotheses.
    given = model(seed, size, hypothesis, 3.0 if name == "slip" else None, rank_four=seed % 2 == 0)
    bound = BY_NAME[name].bound_in(given).value
    assert bound > 0
    if math.isinf(bound):
        assert (name, hypothesis) == ("packing", Hypothesis.STATIC) or size == 1.0
        return
    assert apart(matrix(without(given, name)), matrix(given)) <= bound + 3 * RTOL


@pytest.mark.parametrize(("name", "factor"), [("packing", 6), ("branches", 6), ("kinetic", 6), ("slip", 6)])
@pytest.mark.parametrize("hypothesis", Hypothesis)
def test_bounds_are_near_the_truth_where_effects_are_small(name, factor, hypothesis):
    # Breaks when a bound grows careless: an effect that could go within an accuracy would be simulated.
    given = model(5, 1e-3, hypothesis, 3.0 if name == "slip" else None, rank_four=False)
    if name == "packing" and hypothesis is Hypothesis.STATIC:  # N moves, and nothing is claimed
        assert math.isinf(BY_NAME[name].bound_in(given).value)
        return
    change = apart(matrix(without(given, name)), matrix(given))
    assert change < BY_NAME[name].bound_in(given).value < factor * change


def test_slip_and_packing_together():
    # Breaks when other forces tilt contacts nearer to sliding than is allowed for.
    for seed, size in ((1, 1e-3), (3, 0.3)):
        given = model(seed, size, Hypothesis.KINEMATIC, 2.0, rank_four=False)
        bound = BY_NAME["packing"].bound_in(given).value
        assert apart(matrix(without(given, "packing")), matrix(given)) <= bound + 3 * RTOL
        assert bound < 30 * size


def test_rank_four_alone_leaves_the_forces():
    # Breaks when the static hypothesis has no bound for a part that does not enter N, or a wrong one.
    fabric = GeneralFabric(D4=0.5 * np.array(general_fabric(3).D4))
    for hypothesis in Hypothesis:
        given = simulated(fabric, GeneralLoading(stress(0.3, 4)), hypothesis)
        bound = BY_NAME["packing"].bound_in(given).value
        assert apart(matrix(without(given, "packing")), matrix(given)) <= bound + 3 * RTOL
        assert bound < 1.0


def test_what_slides_or_opens_has_no_bound():
    # Breaks when a stiffness that leaving an effect out would bring back is taken for a small change.
    fabric = general_fabric(6)
    sliding = simulated(fabric, GeneralLoading(stress(0.6, 1), 0.05), Hypothesis.KINEMATIC)
    opened = simulated(fabric, GeneralLoading(stress(1.3, 1)), Hypothesis.KINEMATIC)
    assert most_mobilised(sliding.forces)[0] > 0.05
    assert opened.opens
    for given, name in ((sliding, "slip"), (sliding, "kinetic"), (opened, "kinetic"), (opened, "opening"),
                        (opened, "packing")):
        assert math.isinf(BY_NAME[name].bound_in(given).value), name


def test_a_form_moves_every_entry_by_no_more_than_its_bound():
    # Breaks when the argument about forms is wrong: random forms between lo and hi of another one.
    rng = np.random.default_rng(3)
    plain = simulated(GeneralFabric(), None, Hypothesis.KINEMATIC)
    for _ in range(50):
        root = rng.normal(size=(6, 6))
        first = root @ root.T
        share = rng.uniform(0.8, 1.3, size=6)
        other = root @ np.diag(share) @ root.T
        bound = largest_change_of_form(Change(normal=Range.of(*share.tolist())), plain)
        assert apart(other, first) <= bound * (1 + 1e-12)


def test_ranges_enclose():
    # Breaks when an extreme of a form, of a density or of a force is cut off.
    rng = np.random.default_rng(4)
    n = rng.normal(size=(3, 4000))
    n /= np.linalg.norm(n, axis=0)
    fabric, forces = general_fabric(9), np.eye(3) + traceless(0.6, 5)
    low, high = density_range(fabric)
    assert low <= fabric.relative_density(n).min() < fabric.relative_density(n).max() <= high
    form = ((forces @ n) * n).sum(axis=0)
    span = eigenvalue_range(forces)
    assert math.exp(span.low) <= form.min() < form.max() <= math.exp(span.high)
    assert least_force(forces) == pytest.approx(0.4)
    below = np.eye(3) + traceless(0.5, 6)
    quotient = form / ((below @ n) * n).sum(axis=0)
    span = eigenvalue_range(forces, beside=below)
    assert math.exp(span.low) <= quotient.min() < quotient.max() <= math.exp(span.high)


def test_tilts_change_by_no_more_than_allowed():
    # Breaks when the bound of the change of the shear force over the normal force misses a direction.
    rng = np.random.default_rng(5)
    n = rng.normal(size=(3, 4000))
    n /= np.linalg.norm(n, axis=0)
    with_it = model(7, 0.2, Hypothesis.KINEMATIC, 2.0, rank_four=False)
    less = without(with_it, "packing")
    share = []
    for one in (with_it, less):
        force = one.forces @ n
        pressing = (force * n).sum(axis=0)
        share.append(1 - np.linalg.norm(force - pressing * n, axis=0) / pressing / 2.0)
    ratio = np.log(share[1] / share[0]) / 3
    found = with_forces_of(Change(), with_it, less).chi
    assert found.low <= ratio.min() < ratio.max() <= found.high


def test_what_is_called_for_is_decided_exactly():
    # Breaks when a stress that presses every contact alike, 3 p N, is told from it by rounding, or the other way round.
    # 2/5 of these entries are doubles, and so is the stress
    D = np.array([[0.625, 0.3125, 0], [0.3125, -0.3125, 0], [0, 0, -0.3125]])
    content = {"grains": {"shear_modulus": "31 GPa", "poisson_ratio": NU, "friction_coefficient": 0.3},
               "packing": {"void_ratio": 0.5744, "contact_normals": {"tensor": D}},
               "branches": {"anisotropy": {"tensor": np.diag([0.1, 0.2, -0.3])}},
               "stress": {"tensor": 8 * (np.eye(3) + 2 * D / 5)}}
    scene = Scene.model_validate(content)
    assert scene.axis is None
    assert forces_are_equal(scene)
    assert set(select(scene).simulated) == {"packing", "branches"}
    content["stress"]["tensor"][0, 0] = math.nextafter(content["stress"]["tensor"][0, 0], 20.0)
    assert set(select(Scene.model_validate(content)).simulated) == {"packing", "branches", "kinetic", "slip"}


def test_a_model_holds_what_its_effects_carry():
    # Breaks when an effect puts its share where another one belongs, or one that is left out leaves a trace.
    content = {"grains": {"shear_modulus": "31 GPa", "poisson_ratio": NU, "friction_coefficient": 0.3},
               "packing": {"void_ratio": 0.5744, "contact_normals": {"tensor": traceless(0.3, 1)}},
               "branches": {"anisotropy": {"tensor": traceless(0.3, 2)}},
               "stress": {"tensor": rotation(3) @ np.diag([1.0, 2.0, 3.0]) @ rotation(3).T}}
    scene = Scene.model_validate(content)
    bare = model_of(scene, set())
    assert (bare.fabric, bare.loading) == (GeneralFabric(), None)
    assert model_of(scene, {"packing"}).fabric == replace(scene.general_fabric, Dr=None)
    assert model_of(scene, {"branches"}).fabric.Dr == scene.general_fabric.Dr
    assert model_of(scene, {"kinetic"}).loading.friction is None
    assert model_of(scene, {"kinetic", "slip"}).loading.friction == 0.3
    absent = Scene.model_validate({**content, "packing": {"void_ratio": 0.5744}, "branches": None,
                                   "model": {"effects": ["packing", "branches", "deviation"]}})
    assert absent.axis is None
    bounds = select(absent).bounds
    assert bounds["packing"] == bounds["branches"] == bounds["deviation"] == 0.0 < bounds["kinetic"]
