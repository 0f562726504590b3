"""``granular check --promises``: scenes reach what they should, true values are true, and broken promises are found."""

from __future__ import annotations

import json
import math
import sys
import tomllib
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from granular import evaluation
from granular.__main__ import run_command
from granular.checks import promises, true_stiffness
from granular.checks.gradation_comparisons import stored_gradations
from granular.checks.promises import ACCURACIES, Outcome, Record, outcomes, run_promises
from granular.checks.random_scenes import KINDS, random_scenes
from granular.checks.true_gradation import OUTER_STEP, computed, length_factor
from granular.errors import BadOption, CertifiedArithmeticMissing, MissingKey, OutputUnwritable, RouteOutOfDomain
from granular.evaluation import Evaluation
from granular.hertz_mindlin import moduli
from granular.hypothesis import Hypothesis
from granular.routes import axial, closed_form
from granular.scene import Scene

SAMPLE = list(random_scenes(450, seed=3))
right = evaluation.evaluate


def test_the_scenes_reach_the_ends() -> None:
    """A sample that stays in the middle would prove less than it says."""
    assert {drawn.kind for drawn in SAMPLE} == set(KINDS)
    scenes = [drawn.scene for drawn in SAMPLE]
    fabrics = [scene.fabric for scene in scenes]
    assert {-1.0, 2.0} <= {fabric.D33 for fabric in fabrics}
    assert min(1 + fabric.Dr33 for fabric in fabrics) < 1e-13 > min(2 - fabric.Dr33 for fabric in fabrics)
    assert {0.0, 0.5} <= {scene.grains.poisson_ratio for scene in scenes}
    shapes = [fabric.aspect_ratio for fabric in fabrics if fabric.aspect_ratio != 1]
    assert min(shapes) < 0.01 and max(shapes) > 100 and min(abs(shape - 1) for shape in shapes) < 1e-12
    tilts = [scene.stress.loading(scene.grains.friction).tilt(scene.fabric.D33) for scene in scenes]
    assert min(abs(float(tilt) - 1) for tilt in tilts if tilt is not None) < 1e-12
    assert any(0 < tilt < 1e-12 for tilt in tilts if tilt is not None)
    assert 0.0 in {scene.grains.friction for scene in scenes} and None in {scene.grains.friction for scene in scenes}
    assert any(scene.stress.loading(None).opens() for scene in scenes)
    static = {drawn.kind for drawn, scene in zip(SAMPLE, scenes, strict=True)
              if scene.model.hypothesis is Hypothesis.STATIC}
    assert static == set(KINDS) - {"sliding", "opening"}
    spreads = {scene.gradation.spread for scene in scenes if scene.gradation is not None}
    assert {1 + 1e-9, 10.0} <= spreads


def test_the_same_seed_gives_the_same_scenes() -> None:
    """A reported scene cannot be found again, or a longer run hides what a shorter one found."""
    assert list(random_scenes(40, seed=3)) == SAMPLE[:40]
    assert list(random_scenes(40, seed=4)) != SAMPLE[:40]


def test_a_scene_is_written_with_all_its_digits() -> None:
    """What is shown is another scene than the one that was evaluated."""
    for drawn in SAMPLE[:150]:
        assert Scene(**tomllib.loads(drawn.toml())) == drawn.scene


def test_the_unit_of_stiffness() -> None:
    """Eqs (8)-(11) and (20) are misread in one of two places: one radius and one force at a time, or in one formula.

    Half a unit in the last place for the final rounding; where N comes from the void ratio the library rounds that
    too, and the unit goes with N^(2/3).
    """
    for drawn in SAMPLE[:75]:
        if drawn.scene.gradation is None:
            known = true_stiffness.unit_of_stiffness(drawn.scene)
            error = abs(Fraction(right(drawn.scene).reference_stiffness) / known - 1)
            assert error <= 2.0**-52, drawn.number


def test_the_true_stiffness_of_the_ideal_assembly() -> None:
    """True values are those of another model than the closed formula of an isotropic packing of spheres.

    Its moduli are doubles of some ten roundings each.
    """
    scene = Scene(grains={"shear_modulus": 45e9, "poisson_ratio": 0.0625}, stress={"mean": 20e6},
                  packing={"void_ratio": 0.625, "coordination_number": 8.5})
    bulk, shear = moduli(45e9, 0.0625, mean_stress=20e6, coordination_number=8.5, void_ratio=0.625)
    c1111, c3333, c1122, c1133, c2323, c1212 = map(float, true_stiffness.true_stiffness(scene).components)
    assert (c1111, c1122, c1212) == (c3333, c1133, c2323)
    assert math.isclose(c1111, bulk + 4 * shear / 3, rel_tol=1e-14)
    assert math.isclose(c1212, shear, rel_tol=1e-14)


@pytest.mark.parametrize("case", stored_gradations(), ids=lambda case: case.name)
def test_moments_of_branch_length_are_the_stored_ones(case: Any) -> None:
    """The convolution or a moment is wrong, or the steps are too long for 20 digits."""
    for found, hypothesis in zip(computed(case.spread), Hypothesis, strict=True):
        assert abs(found / case.known[hypothesis] - 1) < 1e-22
    assert length_factor(case.spread, Hypothesis.STATIC) == 1 / case.known[Hypothesis.STATIC]


@pytest.mark.parametrize("spread", [1 + 1e-9, 1.0001, 2.5])
def test_other_steps_give_the_same_moments(spread: float) -> None:
    """Digits are lost next to a spread of one, where nothing is stored."""
    for one, other in zip(computed(spread), computed(spread, step=OUTER_STEP * Fraction(5, 6)), strict=True):
        assert abs(one / other - 1) < 1e-22


def test_a_list_of_effects_is_followed() -> None:
    """True values carry what the scene's own list leaves out."""
    tables: dict[str, Any] = {"grains": {"shear_modulus": 1e9, "poisson_ratio": 0.25, "friction_coefficient": 0.3},
                              "packing": {"void_ratio": 0.6, "contact_normals": {"D33": 0.5}},
                              "stress": {"mean": 1e5, "ratio": 1.5}, "branches": {"anisotropy": {"D33": -0.25}},
                              "gradation": {"distribution": "lognormal", "median": "5 mm", "spread": 1.5}}
    found = set()
    for effects in ([], ["packing"], ["branches"], ["gradation"], ["packing", "kinetic"],
                    ["packing", "kinetic", "slip"]):
        scene = Scene(**tables, model={"effects": effects})
        truth = true_stiffness.true_stiffness(scene)
        assert true_stiffness.true_error(right(scene), truth)[1] < 5e-14, effects
        found.add(truth.components)
    assert len(found) == 6


def test_only_lognormal_sizes_are_known(tmp_path: Path) -> None:
    """A curve is taken for a lognormal distribution without a spread."""
    curve = tmp_path / "curve.csv"
    curve.write_text("size [mm], fraction finer\n1, 0\n2, 0.5\n4, 1\n", encoding="utf-8")
    scene = Scene(grains={"shear_modulus": 1e9, "poisson_ratio": 0.25}, packing={"void_ratio": 0.6},
                  stress={"mean": 1e5}, gradation={"distribution": "curve", "file": str(curve)})
    with pytest.raises(MissingKey):
        true_stiffness.true_stiffness(scene)


def test_promises_are_kept() -> None:
    """A result errs by more than was wanted or stated at any of the four accuracies, or the plan refuses."""
    found = list(outcomes(2 * len(KINDS), seed=11))
    assert [outcome.as_json() for outcome in found if not outcome.kept or outcome.refusal] == []
    assert {(outcome.drawn.kind, outcome.rtol) for outcome in found} == {
        (kind, rtol) for kind in KINDS for rtol in ACCURACIES}


def off(monkeypatch: pytest.MonkeyPatch, module: Any, factor: float) -> None:
    correct = module.evaluate

    def wrong(*arguments: Any, **options: Any) -> Any:
        from dataclasses import replace

        result = correct(*arguments, **options)
        return replace(result, components=(*result.components[:3], result.components[3] * factor,
                                           *result.components[4:]))

    monkeypatch.setattr(module, "evaluate", wrong)


@pytest.mark.parametrize("module", [closed_form, axial], ids=["closed form", "axial"])
def test_a_wrong_route_is_found(module: Any, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str],
                                tmp_path: Path) -> None:
    """A route that is wrong passes, is not shown with its scene, or the file says something else."""
    off(monkeypatch, module, 1 + 1e-7)
    out = tmp_path / "promises.json"
    assert run_promises(len(KINDS), seed=5, json_out=out) == 1
    shown = capsys.readouterr().out
    record = json.loads(out.read_text(encoding="utf-8"))
    assert (record["seed"], record["scenes"], record["promises"]) == (5, 15, 60)
    assert record["command"] == "granular check --promises 15 --seed 5"
    assert f"60 promises asked for, {record['refused']} refused, {record['broken']} broken" in shown
    assert record["broken"] == len(record["misses"]) == sum(group["misses"] for group in record["by_kind"]) > 3
    worst = record["worst"][0]
    assert (worst["component"], worst["kept"], worst["route"]) == ("C1133", False, module.NAME)
    assert worst["scene"] in shown and 0.5e-7 < worst["error"] < 2e-7
    group = next(group for group in record["by_kind"] if group["rtol"] == 1e-9 and group["kind"] == worst["kind"])
    assert 50 < group["worst_error_over_rtol"] < 200
    assert group["worst_error_over_bound"] > 50


def test_an_effect_that_was_left_out_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    """True values share the planner's choice of effects, so that one it should not leave out is never missed."""

    def without_branches(scene: Scene, *, rtol: float | None = None, route: str = "auto") -> Evaluation:
        return right(scene.model_copy(update={"branches": None}) if rtol == 1e-6 else scene, rtol=rtol, route=route)

    faint = [drawn for drawn in SAMPLE[:150] if drawn.kind == "faint"]
    monkeypatch.setattr(promises, "random_scenes", lambda _count, *, seed: faint)
    monkeypatch.setattr(evaluation, "evaluate", without_branches)
    found = list(outcomes(len(faint), seed=3))
    less = [outcome for outcome in found if "branches" in outcome.left_out]
    assert {outcome.rtol for outcome in less} >= {1e-6}
    for outcome in less:
        if outcome.rtol == 1e-6:
            assert outcome.kept == (outcome.error <= min(1e-6, outcome.bound))
            assert outcome.error > abs(outcome.drawn.scene.fabric.Dr33) / 1e4
    assert any(not outcome.kept for outcome in less)


def test_what_is_no_result_is_a_miss_unless_it_is_a_refusal(monkeypatch: pytest.MonkeyPatch) -> None:
    """A crash counts as a kept promise, or a refusal as a broken one."""

    def failing(scene: Scene, *, rtol: float | None = None, route: str = "auto") -> Evaluation:
        if rtol == 1e-3:
            raise ZeroDivisionError("float division by zero")
        if rtol == 1e-6:
            raise RouteOutOfDomain("rtol", allowed="allowed more", remedy="Ask for less.")
        return right(scene, rtol=rtol, route=route)

    monkeypatch.setattr(evaluation, "evaluate", failing)
    record = Record()
    for outcome in outcomes(1, seed=5):
        record.add(outcome)
    assert (record.broken, record.refused) == (1, 1)
    miss, refusal = record.misses[0].as_json(), record.refusals[0].as_json()
    assert (miss["component"], miss["error"]) == ("ZeroDivisionError: float division by zero", None)
    assert "Ask for less" in str(refusal["refusal"]) and refusal["kept"]
    group = record.groups["isotropic", 1e-6].as_json("isotropic", 1e-6)
    assert (group["count"], group["refused"], group["mean_evaluations"]) == (1, 1, None)


def test_a_wrong_zero_is_a_miss() -> None:
    """A component that is 0 where it should be tiny, or the reverse, passes for accurate, or breaks the file."""

    def outcome(error: float, *, bound: float, doubt: float = 0.0) -> Outcome:
        return Outcome(drawn=SAMPLE[0], rtol=1e-3, error=error, component="C1122", bound=bound, doubt=doubt)

    assert not outcome(math.inf, bound=1e-3).kept and outcome(math.inf, bound=1e-3).as_json()["error"] is None
    assert not outcome(1e-5, bound=1e-6).kept and not outcome(math.nan, bound=1e-6).kept
    assert outcome(3e-15, bound=2e-15, doubt=2e-15).kept and outcome(1e-4, bound=1e-3).kept
    assert not outcome(1e-4, bound=1.01e-3).kept  # states more than was wanted


def test_the_command(capsys: pytest.CaptureFixture[str]) -> None:
    """The options do not reach the check, or progress is mixed into the result."""
    assert run_command(["check", "--promises", "3", "--seed", "8"]) == 0
    shown = capsys.readouterr()
    assert "3 scenes from seed 8, 12 promises asked for, 0 refused, 0 broken" in shown.out
    assert "Checking promises" in shown.err and "Checking promises" not in shown.out


@pytest.mark.parametrize("options", [["--promises", "0"], ["--promises", "many"],
                                     ["--promises", "2", "--choices", "2"], ["--random", "2", "--promises", "2"]])
def test_options_that_mean_nothing(options: list[str]) -> None:
    """A count that means nothing is taken, or one of two checks is silently left out."""
    with pytest.raises(BadOption):
        run_command(["check", *options])


def test_an_interrupted_check_leaves_no_file(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Half a file is left behind by Ctrl-C, or an older file is lost to it."""
    out = tmp_path / "promises.json"
    out.write_text("older", encoding="utf-8")
    correct, calls = promises.true_stiffness, []

    def interrupted(scene: Scene) -> Any:
        calls.append(1)
        if len(calls) > 3:
            raise KeyboardInterrupt
        return correct(scene)

    monkeypatch.setattr(promises, "true_stiffness", interrupted)
    with pytest.raises(KeyboardInterrupt):
        run_promises(50, seed=5, json_out=out)
    assert out.read_text(encoding="utf-8") == "older"
    assert [path.name for path in tmp_path.iterdir()] == ["promises.json"]


def test_a_file_that_cannot_be_written(tmp_path: Path) -> None:
    """A missing folder ends in a traceback."""
    with pytest.raises(OutputUnwritable):
        run_promises(1, seed=5, json_out=tmp_path / "missing" / "promises.json")


def test_without_python_flint(monkeypatch: pytest.MonkeyPatch) -> None:
    """Without ball arithmetic the check reports that every promise was kept."""
    monkeypatch.setitem(sys.modules, "flint", None)
    with pytest.raises(CertifiedArithmeticMissing):
        run_promises(1, seed=5)
