"""``granular cost``: names, the data file after every scene, Ctrl-C, and taking up where it was left."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import pytest

from granular import cost
from granular.cost import command, store, timing
from granular.errors import BadOption, OutputUnwritable, UnknownChoice

ROUTES = ("closed_form", "midpoint", "gauss_x")
SCENES = ("isotropic", "sliding")


@pytest.fixture(autouse=True)
def brief(monkeypatch: pytest.MonkeyPatch) -> None:
    """No repetition: what is measured is not the point here."""
    monkeypatch.setattr(timing, "SHORTEST", 1e-7)


def run(out: Path | None = None, *, scenes: tuple[str, ...] = SCENES, routes: tuple[str, ...] = ROUTES,
        **options: Any) -> int:
    return cost.run_cost(out=out, rounds=2, scenes=scenes, routes=routes, **options)


def read(path: Path) -> dict[str, Any]:
    content: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    return content


def places(content: dict[str, Any]) -> list[tuple[str, str, str, str]]:
    return [(one["scene"], one["hypothesis"], one["route"], one["setting"]) for one in content["costs"]]


def test_the_file_holds_all_of_it(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The data lack the machine, an input or a row, cannot be read back, or the table is wider than a terminal."""
    out = tmp_path / "cost.json"
    assert run(out) == 0
    content = read(out)
    assert list(content) == ["command", "machine", "rounds", "unit", "complete", "scenes", "costs"]
    assert content["command"] == ("granular cost --scene isotropic --scene sliding --route closed_form "
                                  "--route midpoint --route gauss_x --rounds 2")
    assert content["complete"] is True
    assert content["machine"]["unit_seconds"] > 0
    assert {"processor", "python", "numpy", "scipy", "python-flint", "sympy", "mpmath"} <= set(content["machine"])
    assert [(scene["name"], scene["hypothesis"]) for scene in content["scenes"]] == [
        ("isotropic", "kinematic"), ("isotropic", "static"), ("sliding", "kinematic")]
    assert content["scenes"][2]["inputs"] == {
        "poisson_ratio": 0.21, "D33": 0.0, "Dr33": 0.0, "aspect_ratio": 1.0, "stress_ratio": 2.0,
        "friction": math.tan(math.radians(12))}
    assert len(set(places(content))) == len(content["costs"])
    paper = [one for one in content["costs"] if one["paper"]]
    assert [one["setting"] for one in paper] == ["24 panels"] * 3
    for one in content["costs"]:
        assert (one["error"] is None) == (one["time_ratio"] is None) == (one["count"] == 0)
        assert one["failure"] is not None or one["error"] is not None
    assert [path.name for path in tmp_path.iterdir()] == ["cost.json"]
    shown = capsys.readouterr().out
    assert "sliding, kinematic" in shown
    assert max(len(line.rstrip()) for line in shown.splitlines() if not line.startswith("Measured")) <= 80


def test_names(capsys: pytest.CaptureFixture[str]) -> None:
    """A scene or route that does not exist is measured as nothing, or the refusal does not tell which there are."""
    with pytest.raises(UnknownChoice) as refusal:
        run(scenes=("slidng",))
    assert "sliding-spheroid" in str(refusal.value)
    with pytest.raises(UnknownChoice) as refusal:
        run(routes=("quadd",))
    assert "quad_vec" in str(refusal.value)
    listed = cost.list_of_names()
    assert all(f"  {name} " in listed for name in (*cost.NAMES, *cost.ROUTE_NAMES))
    assert capsys.readouterr().out == ""


class Stop:
    """Ctrl-C at the given step of a label."""

    def __init__(self, label: str, step: int = 1) -> None:
        self.label, self.step = label, step

    def __call__(self, label: str) -> None:
        if label == self.label:
            self.step -= 1
            if self.step == 0:
                raise KeyboardInterrupt


def test_ctrl_c_keeps_the_finished_scenes(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """An interruption loses what was finished, leaves half a scene or a half-written file, or counts wrongly."""
    out = tmp_path / "cost.json"
    assert run(out, advanced=Stop("isotropic, static", 5)) == 130
    content = read(out)
    assert content["complete"] is False
    assert {place[:2] for place in places(content)} == {("isotropic", "kinematic")}
    assert "Stopped: 1 of 3 scenes" in capsys.readouterr().err
    assert [path.name for path in tmp_path.iterdir()] == ["cost.json"]
    assert run(advanced=Stop("isotropic, kinematic")) == 130
    assert "Stopped: 0 of 3 scenes are measured." in capsys.readouterr().err


def test_resume_measures_what_is_missing(tmp_path: Path) -> None:
    """Resuming measures again what is there, leaves a gap, or changes the order of the data."""
    out, whole = tmp_path / "cost.json", tmp_path / "whole.json"
    assert run(out, advanced=Stop("sliding, kinematic")) == 130
    before = read(out)["costs"]
    seen: list[str] = []
    assert run(out, resume=True, advanced=seen.append) == 0
    assert set(seen) == {"sliding, kinematic"}
    content = read(out)
    assert content["complete"] is True
    assert content["costs"][:len(before)] == before
    assert run(whole, resume=True) == 0  # nothing to resume: all of it
    assert places(content) == places(read(whole))
    # one more route: only that one is measured, on every scene
    seen.clear()
    assert run(out, routes=(*ROUTES, "gauss_beta"), resume=True, advanced=seen.append) == 0
    assert len(seen) == 3 * (6 + 2)  # six settings and two rounds
    grown = read(out)
    assert set(places(content)) < set(places(grown))
    assert [place[0] for place in places(grown)] == sorted((place[0] for place in places(grown)), key=SCENES.index)


def test_resume_refuses_what_does_not_fit(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Times of two machines, versions or numbers of rounds are mixed; a foreign file is overwritten."""
    with pytest.raises(BadOption, match="--resume without --out"):
        run(resume=True)
    out = tmp_path / "cost.json"
    out.write_text("{}", encoding="utf-8")
    with pytest.raises(BadOption, match="no data of a cost study"):
        run(out, resume=True)
    assert out.read_text(encoding="utf-8") == "{}"
    assert run(out, scenes=("isotropic",), routes=("closed_form",)) == 0
    before = out.read_bytes()
    with pytest.raises(BadOption, match="allowed measurements in 3 rounds"):
        cost.run_cost(out=out, rounds=3, resume=True)
    described = cost.machine()
    monkeypatch.setattr(store, "machine", lambda: described | {"numpy": "0.1"})
    with pytest.raises(BadOption, match=r"allowed measurements with numpy 0\.1"):
        run(out, resume=True)
    assert out.read_bytes() == before


def test_a_file_that_cannot_be_written(tmp_path: Path) -> None:
    """Minutes are spent before a folder in the way of the file is told, or a temporary file stays behind."""
    (tmp_path / "cost.json").mkdir()
    seen: list[str] = []
    with pytest.raises(OutputUnwritable):
        run(tmp_path / "cost.json", advanced=seen.append)
    assert seen == []
    assert [path.name for path in tmp_path.iterdir()] == ["cost.json"]


def test_the_command_line(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    """Options do not arrive, or --list measures something."""
    from granular.commands import run_command

    given: dict[str, Any] = {}
    monkeypatch.setattr(cost, "run_cost", lambda **options: given.update(options) or 130)
    assert run_command(["cost", "--list"]) == 0
    assert capsys.readouterr().out == command.list_of_names()
    assert given == {}
    assert run_command(["cost", "--scene", "sliding", "--scene", "opened", "--route", "quad", "--rounds", "4", "--out",
                        str(tmp_path / "a.json"), "--resume"]) == 130
    assert given == {"out": tmp_path / "a.json", "rounds": 4, "scenes": ["sliding", "opened"], "routes": ["quad"],
                     "resume": True}
