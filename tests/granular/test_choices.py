"""``granular check --choices``: a poor choice is found, with a clock that the tests turn themselves."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from granular import evaluation
from granular.__main__ import run_command
from granular.checks import choice_times, choices
from granular.checks.choices import Choice, run_choices, statistics_of, summary
from granular.checks.promises import ACCURACIES
from granular.checks.random_scenes import KINDS, random_scenes
from granular.errors import OutputUnwritable, RouteOutOfDomain
from granular.evaluation import Evaluation
from granular.hypothesis import Hypothesis
from granular.routes.catalogue import ROUTES
from granular.scene import Scene

COSTS = {"closed_form": 2.0, "axial": 6.0, "sphere": 40.0, "exact": 3.0, "certified": 3.0, "midpoint": 1.0}
"""Seconds that each route takes by the clock of these tests."""

DRAWN = list(random_scenes(2 * len(KINDS), seed=3))
right = evaluation.evaluate


class Clock:
    """A clock that only evaluations move."""

    def __init__(self) -> None:
        self.now, self.calls = 0.0, 0

    def process_time(self) -> float:
        return self.now

    def evaluate(self, scene: Scene, *, rtol: float | None = None, route: str = "auto") -> Evaluation:
        result = right(scene, rtol=rtol, route=route)
        self.calls += 1
        self.now += COSTS.get(result.route, 30.0) + (0.5 if route == "auto" else 0.0)
        return result


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> Clock:
    made = Clock()
    monkeypatch.setattr(choice_times, "time", made)
    monkeypatch.setattr(evaluation, "evaluate", made.evaluate)
    return made


def test_every_accurate_route_is_timed(clock: Clock, monkeypatch: pytest.MonkeyPatch) -> None:
    """A route that could have been chosen is passed over, or one that is not accurate enough is the cheapest."""
    some = [drawn for drawn in DRAWN if drawn.kind in ("isotropic", "packing", "sliding", "all at once")
            and drawn.scene.model.hypothesis is Hypothesis.KINEMATIC]  # ball arithmetic is slow for the other
    monkeypatch.setattr(choices, "random_scenes", lambda _count, *, seed: some)
    made = list(choices.choices(len(some), seed=3, rounds=1))
    assert [(choice.drawn, choice.rtol) for choice in made] == [(drawn, rtol) for drawn in some for rtol in ACCURACIES]
    for choice in made:
        assert choice.kept and choice.chosen in choice.seconds
        assert choice.seconds.items() <= COSTS.items()
        assert choice.planned == COSTS[choice.chosen] + 0.5
        assert choice.ratio == COSTS[choice.chosen] / min(choice.seconds.values()) >= 1
        if choice.rtol < 1e-8 and choice.drawn.kind == "all at once":
            assert "midpoint" not in choice.seconds
    assert {name for choice in made for name in choice.seconds} >= {"closed_form", "axial", "exact", "certified"}
    isotropic = [choice for choice in made if choice.drawn.kind == "isotropic"]
    assert all({"closed_form", "certified"} <= set(choice.seconds) for choice in isotropic)


def test_a_route_that_promises_less_is_asked_again(clock: Clock) -> None:
    """A route that met the accuracy without promising it does not count."""
    scene = Scene(grains={"shear_modulus": 1e9, "poisson_ratio": 0.25}, packing={"void_ratio": 0.6},
                  stress={"mean": 1e5, "ratio": 1.25})
    with pytest.raises(RouteOutOfDomain):
        right(scene, rtol=1e-3, route="midpoint")
    found = choice_times.candidates(scene, 1e-3)
    assert found is not None
    assert "midpoint" in {candidate.name for candidate in found[1]}
    assert found[0].result.route in ROUTES


def test_a_plan_that_refuses_makes_no_choice(monkeypatch: pytest.MonkeyPatch) -> None:
    """A refusal of the plan ends the run, or counts as a good choice."""

    def refusing(scene: Scene, *, rtol: float | None = None, route: str = "auto") -> Evaluation:
        if route == "auto" and rtol == 1e-12:
            raise RouteOutOfDomain("rtol", allowed="allowed more", remedy="Ask for less.")
        return right(scene, rtol=rtol, route=route)

    monkeypatch.setattr(evaluation, "evaluate", refusing)
    assert {choice.rtol for choice in choices.choices(1, seed=3, rounds=1)} == {1e-3, 1e-6, 1e-9}


def test_a_hopeless_route_is_timed_once(clock: Clock) -> None:
    """Slow routes take most of the time of a run, or a short one is not timed often enough."""
    calls = dict.fromkeys(("axial", "certified", "sphere"), 0)

    def call(name: str, seconds: float) -> Any:
        def run() -> None:
            calls[name] += 1
            clock.now += seconds
        return run

    timed: list[Any] = [choice_times.Candidate(name=name, call=call(name, seconds), result=None)
                        for name, seconds in (("axial", 1e-4), ("certified", 4e-4), ("sphere", 1e-2))]
    best = choice_times.best_times(timed, against="axial", rounds=3)
    assert {name: round(seconds, 12) for name, seconds in best.items()} == {"axial": 1e-4, "certified": 4e-4,
                                                                           "sphere": 1e-2}
    assert calls == {"axial": choice_times.MOST_ROUNDS, "certified": choice_times.MOST_ROUNDS, "sphere": 1}


def made_up(ratio: float, *, rtol: float = 1e-6, kept: bool = True) -> Choice:
    return Choice(drawn=DRAWN[0], rtol=rtol, chosen="axial", planned=2.5 * ratio, kept=kept,
                  seconds={"axial": 2.0 * ratio, "certified": 2.0})


def test_statistics() -> None:
    """The share, the median or the worst is that of something else."""
    found = statistics_of([made_up(1.0), made_up(1.5), made_up(1.6), made_up(4.0, kept=False)])
    assert found == {"choices": 4, "share": 0.5, "median": 1.55, "worst": 4.0, "planned_over_chosen": 1.25,
                     "not_accurate_enough": 1}


def test_the_file_holds_the_worst(clock: Clock) -> None:
    """A poor choice cannot be found again, or a good one is listed as poor."""
    record: Any = summary([made_up(1.0), made_up(3.0, rtol=1e-3), made_up(1.2)], count=3, seed=9)
    assert [(entry["ratio"], entry["chosen"], entry["cheapest"]) for entry in record["worst"]] == [
        (3.0, "axial", "certified")]
    assert record["worst"][0]["scene"] == DRAWN[0].toml()
    assert [(entry["rtol"], entry["worst"]) for entry in record["by_rtol"]] == [(1e-6, 1.2), (1e-3, 3.0)]
    assert record["routes"] == [{"chosen": "axial", "cheapest": "axial", "count": 1},
                                {"chosen": "axial", "cheapest": "certified", "count": 2}]
    assert record["command"] == "granular check --choices 3 --seed 9" and record["machine"]["python"]
    good: Any = summary([made_up(1.0), made_up(1.2)], count=2, seed=9)
    assert [entry["ratio"] for entry in good["worst"]] == [1.2]


def test_a_poor_choice_is_found(clock: Clock, capsys: pytest.CaptureFixture[str], tmp_path: Path,
                                monkeypatch: pytest.MonkeyPatch) -> None:
    """A planner that always takes the slow route passes for a good one, or the file says something else."""
    monkeypatch.setitem(COSTS, "axial", 30.0)
    out = tmp_path / "choices.json"
    assert run_choices(4, seed=3, json_out=out) == 0
    shown = capsys.readouterr()
    record = json.loads(out.read_text(encoding="utf-8"))
    worst = record["all"]["worst"]
    assert worst in (10.0, 15.0, 30.0) and record["worst"][0]["chosen"] == "axial"  # beside 3, 2 or 1 second
    assert record["worst"][0]["scene"] in shown.out
    assert f"{100 * record['all']['share']:.1f} % within 1.5 times" in shown.out and f"worst {worst:.2f}" in shown.out
    assert "Timing choices" in shown.err and "Timing choices" not in shown.out


def test_the_command(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    """The option does not reach the check."""
    monkeypatch.setattr(choice_times, "LONG_ENOUGH", 0.0)
    assert run_command(["check", "--choices", "1", "--seed", "8"]) == 0
    assert "1 scenes from seed 8, 4 choices" in capsys.readouterr().out


def test_an_interrupted_run_leaves_no_file(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Half a file is left behind by Ctrl-C, or a missing folder ends in a traceback."""

    def interrupted(_scene: Scene) -> Any:
        raise KeyboardInterrupt

    monkeypatch.setattr(choice_times, "LONG_ENOUGH", 0.0)
    with pytest.raises(OutputUnwritable):
        run_choices(1, seed=3, json_out=tmp_path / "missing" / "choices.json")
    monkeypatch.setattr(choices, "true_stiffness", interrupted)
    with pytest.raises(KeyboardInterrupt):
        run_choices(1, seed=3, json_out=tmp_path / "choices.json")
    assert list(tmp_path.iterdir()) == []
