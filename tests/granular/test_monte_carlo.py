"""Contacts drawn at random: eq. (1) as it stands against the evaluation, and errors that mean what they say."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.stats import t as student

from granular.checks import monte_carlo
from granular.checks.monte_carlo import ALLOWED, LARGEST_ERROR, SCENES, monte_carlo_comparisons, scene_of
from granular.checks.sampled_contacts import BATCHES, Contacts, estimate, raw_estimate
from granular.checks.sampled_lengths import length_table
from granular.checks.sampled_scenes import contacts_per_volume, drawing, sampled_stiffness
from granular.errors import ValueOutOfRange
from granular.evaluation import evaluate
from granular.gradation import Lognormal, length_moments
from granular.gradation.branch_lengths import branch_lengths
from granular.hypothesis import Hypothesis
from granular.planning import plan
from granular.routes.result import COMPONENTS
from granular.scene import Scene


def off(scene: Scene, *, seed: int) -> list[float]:
    """How many standard errors each component is off, and that each is known well."""
    found, stiffness = sampled_stiffness(scene, seed=seed), evaluate(scene).stiffness
    known = [getattr(stiffness, name) for name in COMPONENTS]
    assert all(error <= LARGEST_ERROR * value for error, value in zip(found.standard_errors, known, strict=True))
    return [(value - true) / error
            for value, error, true in zip(found.components, found.standard_errors, known, strict=True)]


def test_everything_drawn_agrees() -> None:
    """Eq. (1) over random contacts is not what the library evaluates, or the draw says too little."""
    found = list(monte_carlo_comparisons())
    assert [comparison for comparison in found if not comparison.agrees] == []
    assert {comparison.case for comparison in found} == set(SCENES)
    assert {comparison.unit for comparison in found} == {"standard errors"}


def test_the_chance_of_a_false_alarm() -> None:
    """The stated chance that a right component is further off than is allowed is another one."""
    chance = 2 * student.sf(ALLOWED, BATCHES - 1)
    assert 1 / chance == pytest.approx(1.1e6, rel=0.1)
    assert 1 / (chance * len(SCENES) * len(COMPONENTS)) > 20_000


def test_the_same_seed_gives_the_same_contacts() -> None:
    """A check that fails cannot be run again."""
    scene = scene_of(**SCENES["graded spheroids, r = 0.6, spin"])
    assert sampled_stiffness(scene, seed=3) == sampled_stiffness(scene, seed=3) != sampled_stiffness(scene, seed=4)


@pytest.mark.parametrize("factor", [1.02, math.nan])
def test_a_wrong_stiffness_is_caught(factor: float, monkeypatch: pytest.MonkeyPatch) -> None:
    """A stiffness that is off by two per cent, or no number, agrees with the sample."""
    from granular import evaluation

    class Wrong:
        def __init__(self, right: Any) -> None:
            self.stiffness = type("Off", (), {name: getattr(right.stiffness, name) * factor for name in COMPONENTS})()
            self.hypothesis = right.hypothesis

    monkeypatch.setattr(monte_carlo, "SCENES", {"one": SCENES["spheroids, r = 2, slip"]})
    monkeypatch.setattr(evaluation, "evaluate", lambda scene: Wrong(evaluate(scene)))
    (comparison,) = monte_carlo_comparisons()
    assert not comparison.agrees


def test_gradation_that_is_left_out_is_caught() -> None:
    """The sample does not see what gradation does: it would agree with grains of one size."""
    graded = scene_of(**SCENES["gradation, s_r = 1.5"])
    found = sampled_stiffness(graded, seed=1)
    equal = evaluate(scene_of()).stiffness
    assert abs(found.components[0] - equal.C1111) > 100 * found.standard_errors[0]


def test_a_measured_curve(tmp_path: Path) -> None:
    """Branch lengths of a sieve curve are not those of eqs (12), (16) and (17)."""
    curve = tmp_path / "curve.csv"
    curve.write_text("size,fraction finer\n0.5 mm,0\n1 mm,0.3\n2 mm,0.7\n4 mm,1\n", encoding="utf-8")
    scene = scene_of(gradation={"distribution": "curve", "file": str(curve)}, normals=0.2)
    assert max(map(abs, off(scene, seed=7))) < ALLOWED


def test_a_density_of_rank_four_between_spheroids() -> None:
    """D3333 is lost between the contact normals and the weights of the sample."""
    scene = scene_of(shape={"aspect_ratio": 1.4}, normals=0.3)
    normals = {"D33": 0.3, "D3333": 0.6}
    fourth = Scene.model_validate(scene.model_dump(exclude_none=True, mode="json") | {
        "packing": {"void_ratio": 0.5744, "contact_normals": normals}})
    assert max(map(abs, off(fourth, seed=11))) < ALLOWED


def test_the_raw_sum_of_spheroids() -> None:
    """The sum before symmetrisation is another one: minor symmetry fails, and by as much as the moments say."""
    shape, lam = 2.0, 2 * (1 - 0.21) / (2 - 0.21)
    scene = scene_of(shape={"aspect_ratio": shape})
    decided, per_volume = plan(scene), contacts_per_volume(scene, None)
    found = raw_estimate(drawing(scene, decided, None, per_volume, seed=5))

    def mean(form: Any) -> float:
        return float(quad(lambda x: form(1 - x * x, x * x) / (1 + (shape**2 - 1) * x * x), 0, 1, epsrel=1e-12)[0])

    across, along = (mean(lambda s, y: (s / 2) * ((1 - lam) * y + lam)),
                     shape**4 * mean(lambda s, y: y * ((1 - lam) * s / 2 + lam)))
    both = shape**2 * mean(lambda s, y: (1 - lam) * s * y / 2)
    unit = evaluate(scene).reference_stiffness / per_volume * shape ** (-2 / 3)
    for value, error, known in zip(found.components, found.standard_errors, (across, along, both), strict=True):
        assert abs(value - unit * known) < ALLOWED * error
        assert error < LARGEST_ERROR * value
    assert (across, along, both) == pytest.approx((0.2125, 1.9221, 0.0152), abs=5e-5)


def test_standard_errors_mean_what_they_say() -> None:
    """Components scatter more, or less, than their standard errors say: over 60 seeds within a third."""
    scene = scene_of(shape={"aspect_ratio": 2.0, "spin": "relaxed"}, normals=0.3, ratio=1.2)
    decided, per_volume = plan(scene), contacts_per_volume(scene, None)
    found = [estimate(drawing(scene, decided, None, per_volume, seed=seed), hypothesis=Hypothesis.KINEMATIC,
                      free_spin=True, batches=20) for seed in range(60)]
    scatter = np.std([one.components for one in found], axis=0, ddof=1)
    stated = np.sqrt(np.mean(np.square([one.standard_errors for one in found]), axis=0))
    assert scatter == pytest.approx(stated, rel=0.35)  # the scatter of 60 is known to 1/sqrt(118), 9 %


def test_contacts_that_are_all_alike_have_no_error() -> None:
    """A weight or a batch is counted twice: one contact along axis 3 must give k_n l^2 exactly."""
    def draw(count: int) -> Contacts:
        one = np.ones(count)
        pole = np.array([[0.0], [0.0], [1.0]]) * one
        return Contacts(one, pole, 3 * pole, 2 * one, one)

    found = estimate(draw, hypothesis=Hypothesis.KINEMATIC, batches=4)
    assert found.components[1] == pytest.approx(18.0, rel=1e-14)
    assert found.standard_errors == pytest.approx([0.0] * 6, abs=1e-13)


@pytest.mark.parametrize(("spread", "form"), [(1.2, "paper"), (1.5, "classical"), (2.0, "paper")])
def test_lengths_against_the_rules(spread: float, form: str) -> None:
    """The table, by direct quadrature of eqs (12), (16) and (17), is off by more than the sample may overlook."""
    sizes = Lognormal(2e-3, spread, form=form)
    table, lengths = length_table(sizes), branch_lengths(sizes)
    equal = sizes.equal_volume_diameter
    assert table.mean_cube == pytest.approx((equal / 2) ** 3, rel=1e-4)
    length, step = np.exp(table.log_length), table.log_length[1] - table.log_length[0]
    for power in (-2.0, 0.0, 1.0, 2.0):
        assert np.sum(table.share * length**power) == pytest.approx(lengths.moment(power).value, rel=1e-4)
    middle = slice(400, 600, 20)
    assert table.share[middle] / length[middle] / step == pytest.approx(lengths.density(length[middle]), rel=1e-3)


@pytest.mark.parametrize("leaning", [-1.0, 0.0, 1.0])
def test_lengths_are_drawn_as_often_as_their_weights_say(leaning: float) -> None:
    """Weights do not make good for drawing long branches more often."""
    sizes = Lognormal(2e-3, 1.3)
    length, weight = length_table(sizes).draw(np.random.default_rng(8), 400_000, leaning=leaning)
    for power, known in ((0.0, 1.0), (2.0, length_moments(sizes).second * sizes.equal_volume_diameter**2)):
        terms = weight * length**power
        assert abs(terms.mean() - known) < 5 * terms.std() / math.sqrt(terms.size) + 1e-4 * known


def test_a_scene_that_means_nothing_is_refused() -> None:
    """A case of the sample is built past the checks of a scene."""
    with pytest.raises(ValueOutOfRange):
        scene_of(ratio=-1.0)
