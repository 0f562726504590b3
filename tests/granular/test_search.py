"""``granular check --random``: the sample reaches what it should, errors are found, and files are whole or absent."""

from __future__ import annotations

import json
import math
import sys
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from granular.__main__ import run_command
from granular.checks import search
from granular.checks.force_limits import cube_root, one_stress_vanishes, weak_stress
from granular.checks.loads import loaded_sample
from granular.checks.search import Finding, Summary, findings, run_search
from granular.errors import BadOption, CertifiedArithmeticMissing, OutputUnwritable
from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.loading import Loading
from granular.routes import axial, certified
from granular.routes.result import RouteResult

SAMPLE = list(loaded_sample(600, seed=3))


def test_the_sample_is_hard() -> None:
    """A sample that stays inside the region, or far from tangency, would prove less than it says."""
    assert {case.kind for case in SAMPLE} == {"stick", "slide", "open"}
    assert {-1.0, 2.0} <= {case.fabric.D33 for case in SAMPLE}
    assert {0.0, 0.5} <= {case.poisson_ratio for case in SAMPLE}
    assert any(0 < case.poisson_ratio < 1e-12 for case in SAMPLE)
    assert min(1 + case.fabric.Dr33 for case in SAMPLE) < 1e-14 > min(2 - case.fabric.Dr33 for case in SAMPLE)
    ratios = [float(case.loading.sigma33 / case.loading.sigma11) for case in SAMPLE if case.loading.sigma11]
    assert 1.0 in ratios and 0.0 in ratios and max(ratios) > 1e9 and 0 < min(r for r in ratios if r > 0) < 1e-9
    assert {None, 0.0} <= {case.loading.friction for case in SAMPLE}
    tilts = [tilt for case in SAMPLE if (tilt := case.loading.tilt(case.fabric.D33)) is not None]
    near = [float(abs(tilt - 1)) for tilt in tilts if abs(tilt - 1) < 0.3]
    assert len(near) > 100 and min(near) < 1e-13


def test_the_same_seed_gives_the_same_sample() -> None:
    """A reported input cannot be found again, or a longer run hides what a shorter one found."""
    assert list(loaded_sample(40, seed=3)) == SAMPLE[:40]
    assert list(loaded_sample(40, seed=4)) != SAMPLE[:40]


def test_inputs_can_be_run_again() -> None:
    """Digits are lost where an input is shown."""
    for case in SAMPLE[:200]:
        shown = case.inputs()
        fabric = AxialFabric(D33=float(shown["D33"]), D3333=float(shown.get("D3333", 0)), Dr33=float(shown["Dr33"]))
        friction = None if shown["mu"] == "none" else float(shown["mu"])
        if "sigma11" in shown:
            assert float(shown["sigma11"]) == case.loading.sigma11 and float(shown["sigma33"]) == case.loading.sigma33
        else:
            assert Loading.of_ratio(float(shown["sigma33/sigma11"]), friction=friction) == case.loading
        assert fabric == case.fabric and friction == case.loading.friction
        assert float(shown["nu"]) == case.poisson_ratio


def test_both_routes_agree_with_the_enclosures() -> None:
    """The axial route, or its twin for arrays, errs by more than 2e-15 (kinematic) or 4e-15 (static)."""
    found = list(findings(80, seed=21))
    assert [finding for finding in found if not finding.agrees] == []
    assert {(finding.route, finding.hypothesis) for finding in found} == {
        (route, hypothesis) for route in ("axial", "axial_stiffness") for hypothesis in Hypothesis}
    assert sum(finding.route == "axial" for finding in found) > 200
    spheroids = [finding for finding in found if finding.case.kind in ("spheroid", "spin")]
    assert len({finding.number for finding in spheroids}) == 80
    assert {(finding.case.kind, finding.hypothesis) for finding in spheroids} == {
        ("spheroid", Hypothesis.KINEMATIC), ("spheroid", Hypothesis.STATIC), ("spin", Hypothesis.KINEMATIC)}


def off(monkeypatch: pytest.MonkeyPatch, factor: float) -> None:
    right = axial.evaluate

    def wrong(*arguments: Any, **options: Any) -> RouteResult:
        result = right(*arguments, **options)
        return RouteResult((*result.components[:5], result.components[5] * factor), result.relative_error, 0)

    monkeypatch.setattr(axial, "evaluate", wrong)


@pytest.mark.parametrize("factor", [1 + 1e-14, math.nan])
def test_an_error_is_found(factor: float, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str],
                           tmp_path: Path) -> None:
    """A route that is wrong passes, the worst are not shown with their inputs, or the file says something else."""
    off(monkeypatch, factor)
    out = tmp_path / "search.json"
    assert run_search(8, seed=5, json_out=out) == 1
    shown = capsys.readouterr().out
    assert max(map(len, shown.splitlines()[:-1])) <= 80
    record = json.loads(out.read_text(encoding="utf-8"))
    assert f"{record['comparisons']} comparisons, {record['misses']} beyond" in shown
    assert record["misses"] >= 8
    worst = record["worst"][0]
    assert (worst["component"], worst["route"], worst["agrees"]) == ("C1212", "axial", False)
    assert all(f"{name} = {value}" in shown for name, value in worst["inputs"].items())
    assert len(record["worst"]) == 10


def test_the_command(capsys: pytest.CaptureFixture[str]) -> None:
    """The options do not reach the search, or progress is mixed into the result."""
    assert run_command(["check", "--random", "3", "--seed", "8"]) == 0
    shown = capsys.readouterr()
    assert "3 inputs from seed 8 and as many spheroids" in shown.out
    assert "Searching" in shown.err and "Searching" not in shown.out


@pytest.mark.parametrize("count", ["0", "-3", "many", "1.5"])
def test_numbers_that_are_none(count: str) -> None:
    """A count that means nothing is taken, or ends in a traceback."""
    with pytest.raises(BadOption):
        run_command(["check", "--random", count])


def test_an_interrupted_search_leaves_no_file(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Half a file is left behind by Ctrl-C, or an older file is lost to it."""
    out = tmp_path / "search.json"
    out.write_text("older", encoding="utf-8")
    calls: list[int] = []

    def interrupted(*_arguments: Any, **_options: Any) -> Any:
        calls.append(1)
        if len(calls) > 3:
            raise KeyboardInterrupt
        return certified_enclose(*_arguments, **_options)

    certified_enclose = certified.enclose
    monkeypatch.setattr(search.certified, "enclose", interrupted)
    with pytest.raises(KeyboardInterrupt):
        run_search(50, seed=5, json_out=out)
    assert out.read_text(encoding="utf-8") == "older"
    assert [path.name for path in tmp_path.iterdir()] == ["search.json"]


def test_a_file_that_cannot_be_written(tmp_path: Path) -> None:
    """A missing folder ends in a traceback."""
    with pytest.raises(OutputUnwritable):
        run_search(1, seed=5, json_out=tmp_path / "missing" / "search.json")


def test_without_python_flint(monkeypatch: pytest.MonkeyPatch) -> None:
    """Without ball arithmetic the search reports that nothing is wrong."""
    monkeypatch.setitem(sys.modules, "flint", None)
    with pytest.raises(CertifiedArithmeticMissing):
        run_search(1, seed=5)


def test_the_summary_keeps_the_worst() -> None:
    """The worst are lost when there are more than ten, or static and kinematic errors are not weighed alike."""
    summary = Summary()
    for number in range(30):
        for hypothesis, scale in ((Hypothesis.KINEMATIC, 1e-17), (Hypothesis.STATIC, 2e-17)):
            summary.add(Finding(number=number, case=SAMPLE[0], hypothesis=hypothesis, route="axial",
                                component="C1111", error=number * scale))
    assert [finding.number for finding in summary.worst] == [n for n in range(29, 24, -1) for _ in range(2)]
    assert summary.comparisons == 60 and summary.misses == 0
    assert [count for count, _ in summary.by_route.values()] == [30, 30]


def test_known_limits_against_ball_arithmetic() -> None:
    """A Beta function, a coefficient of an expansion or the cube root is mistyped."""
    assert abs(cube_root(cube_root(Fraction(5)) ** 3) ** 3 - 5) < 1e-44
    fabric = AxialFabric(D33=0.3, D3333=0.2, Dr33=-0.3)
    for along, loading in ((True, Loading.of_ratio(1e100)), (False, Loading.of_ratio(0.0))):
        found = certified.enclose(fabric, poisson_ratio=0.21, hypothesis=Hypothesis.KINEMATIC, loading=loading)
        for enclosure, known in zip(found, one_stress_vanishes(fabric, 0.21, along=along), strict=True):
            assert abs(enclosure.midpoint / known - 1) < 1e-28, enclosure.name
    ratio = 1 + 2.0**-30
    found = certified.enclose(AxialFabric(), poisson_ratio=0.21, hypothesis=Hypothesis.KINEMATIC,
                              loading=Loading.of_ratio(ratio))
    for enclosure, known in zip(found, weak_stress(Fraction(ratio), 0.21), strict=True):
        assert abs(enclosure.midpoint / known - 1) < 1e-26, enclosure.name
