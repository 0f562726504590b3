"""``granular cost``: errors are right, times are ratios, and the data file is whole or absent."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from granular import cost
from granular.cost import Cost
from granular.errors import OutputUnwritable
from granular.hypothesis import Hypothesis


@pytest.fixture
def few(monkeypatch: pytest.MonkeyPatch) -> None:
    """Two settings of each kind and no repetition: what is measured is not the point here."""
    for name, values in {"NODES": (4, 28), "DEGREES": (5, 23), "PANELS": (24, 48), "DIGITS": (15, 30),
                         "SHORTEST": 1e-6}.items():
        monkeypatch.setattr(cost, name, values)


@pytest.mark.usefixtures("few")
def test_records() -> None:
    """A setting is missing, its error is not what its rule gives, or ratios are not relative to the first."""
    rounds: list[None] = []
    costs = cost.measure(rounds=2, advanced=lambda: rounds.append(None))
    assert len(rounds) == 2 * len(cost.CASES) * len(Hypothesis)
    # floats, fractions, two settings of four routes; the rational route under the kinematic hypothesis only
    assert len(costs) == len(cost.CASES) * (11 + 10)
    for one in costs:
        assert one.time_ratio > 0
        if (one.route, one.setting) == ("closed_form", "floats"):
            assert one.time_ratio == 1
            assert one.error < 2e-15  # about a dozen roundings
    errors = {(one.route, one.setting): one.error for one in costs
              if (one.case, one.hypothesis) == ("Table II, case 3", Hypothesis.STATIC)}
    assert errors["axial", "28 nodes"] < 1e-15
    assert errors["axial", "4 nodes"] > 1e-3
    assert errors["sphere", "degree 23"] < 1e-8 < errors["sphere", "degree 5"]
    assert errors["certified", "30 digits"] < 1e-30
    # second order: doubling the panels divides the error by four, to the next order in 1/24^2
    assert errors["midpoint", "24 panels"] / errors["midpoint", "48 panels"] == pytest.approx(4, rel=0.02)


@pytest.mark.usefixtures("few")
def test_the_command_writes_its_data(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The data lack the machine, or cannot be read back into records; the table does not say where it was measured."""
    out = tmp_path / "cost.json"
    assert cost.run_cost(out=out, rounds=2) == 0
    content = json.loads(out.read_text(encoding="utf-8"))
    assert content["machine"]["processor"]
    assert {"python", "numpy", "scipy", "python-flint"} <= set(content["machine"])
    assert next(Cost(**record).setting for record in content["costs"]) == "floats"
    assert [path.name for path in tmp_path.iterdir()] == ["cost.json"]
    shown = capsys.readouterr().out
    assert "Measured in 2 rounds on" in shown
    assert max(len(line) for line in shown.splitlines() if not line.startswith("Measured")) <= 80


@pytest.mark.usefixtures("few")
def test_a_file_that_cannot_be_written(tmp_path: Path) -> None:
    """A folder in the way of the file ends in a traceback or leaves a temporary file behind."""
    (tmp_path / "cost.json").mkdir()
    with pytest.raises(OutputUnwritable):
        cost.run_cost(out=tmp_path / "cost.json", rounds=2)
    assert [path.name for path in tmp_path.iterdir()] == ["cost.json"]
