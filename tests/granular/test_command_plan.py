"""The commands plan and run --explain: what they show, at every width, and as JSON."""

from __future__ import annotations

import json
from importlib import resources
from pathlib import Path

import pytest

from granular.__main__ import main

SCENES = Path(str(resources.files("granular") / "data" / "scenes"))


@pytest.fixture
def command(capsys):
    """Run a command in this process; give exit code, standard output and standard error."""
    def run(*arguments):
        with pytest.raises(SystemExit) as left:
            main([str(argument) for argument in arguments])
        captured = capsys.readouterr()
        return left.value.code, captured.out, captured.err
    return run


def test_plan_explains_and_computes_nothing(command, monkeypatch):
    # Breaks when plan evaluates, or leaves a decision unexplained.
    monkeypatch.setattr("granular.routes.closed_form.evaluate", None)
    code, out, _ = command("plan", SCENES / "table_ii_3.toml")
    assert code == 0
    for part in ("closed_form", "packing    yes", "contact normals with D33 = 0.3", "kinetic    no ", "left out by the",
                 "error bound", "error budget", "with/without"):
        assert part in out
    content = json.loads(command("plan", SCENES / "table_ii_3.toml", "--json")[1])
    assert content["effects"]["simulated"] == ["packing", "branches"]
    assert set(content) == {"hypothesis", "route", "route_reason", "evaluations", "evaluations_are", "relative_error",
                            "error_is", "axis", "rtol", "effects", "bounds", "costs", "left_out_error", "work"}
    assert set(content["bounds"]) == set(content["costs"]) == {"packing", "branches", "kinetic"}
    assert content["left_out_error"] == 0.0


def test_what_has_no_bound_is_null(command):
    # Breaks when infinity reaches JSON, or an effect without a stiffness beside it ends the plan.
    content = json.loads(command("plan", SCENES / "table_v_2.toml", "--json")[1])
    assert content["bounds"] == {"kinetic": None, "slip": None}
    assert content["costs"]["slip"]["with"] == content["evaluations"] > content["costs"]["slip"]["without"]


@pytest.mark.parametrize("columns", [45, 80, 140])
def test_run_explains_itself(command, monkeypatch, columns):
    # Breaks when --explain drops a part of the result or of the plan, at any width of the terminal.
    monkeypatch.setenv("COLUMNS", str(columns))
    code, out, _ = command("run", SCENES / "aligned_spheroids.toml", "--explain")
    words = " ".join(out.split())
    assert code == 0
    assert out.index("C1111") < out.index("Effects, and")
    for part in ("closed_form does not", "effects left out 0, route 1.8e-15", "counted", "predicted",
                 "every contact is compressed", "aspect_ratio = 0.8"):
        assert part in words


def test_json_explains_on_request_only(command):
    # Breaks when the plan is missing, or differs from what plan prints.
    path = SCENES / "table_iii_3.toml"
    content = json.loads(command("run", path, "--json", "--explain")[1])
    assert content.pop("plan") == json.loads(command("plan", path, "--json")[1])
    assert content == json.loads(command("run", path, "--json")[1])


NEARLY = """\
[grains]
shear_modulus = "31 GPa"
poisson_ratio = 0.21
friction_angle = "12 deg"

[packing]
void_ratio = 0.5744
contact_normals = { D33 = 0.3 }

[branches]
anisotropy = { D33 = 1e-9 }

[stress]
mean = "28 kPa"
"""


def test_what_an_accuracy_leaves_out_is_shown(command, tmp_path):
    # Breaks when an effect that was left out is passed off as one that the scene does not call for.
    path = tmp_path / "scene.toml"
    path.write_text(NEARLY, "utf-8")
    content = json.loads(command("plan", path, "--rtol", "1e-6", "--json")[1])
    assert 0 < content["bounds"]["branches"] <= content["left_out_error"] < 1e-8
    assert "branches" not in content["effects"]["simulated"]
    assert "within its share of rtol = 1e-06" in content["effects"]["not_called_for"]["branches"]
    out = command("run", path, "--rtol", "1e-6")[1]
    assert out.index("left out") < out.index("branches: would change") < out.index("not called for")
    assert "effects left out 2" in command("run", path, "--rtol", "1e-6", "--explain")[1]
    assert "left out" not in command("run", path)[1]
