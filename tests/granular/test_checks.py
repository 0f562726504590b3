"""``granular check``: what it counts, what it shows, and that it fails when a route is wrong."""

from __future__ import annotations

import json
import math
import subprocess
import sys
from collections.abc import Iterator
from fractions import Fraction
from functools import lru_cache
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from granular import checks
from granular.checks import gradation_comparisons, monte_carlo, sampled_scenes
from granular.checks.comparison import Comparison, error_in_ulp, gap_in_ulp
from granular.checks.force_limit_comparisons import force_limit_comparisons
from granular.checks.limit_comparisons import limit_comparisons
from granular.checks.limits import isotropic_kinematic, kinematic_polynomial, kinematic_trace
from granular.checks.sampled_contacts import Estimate
from granular.checks.stored import stored_comparisons
from granular.errors import OutputUnwritable
from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.loading import Loading
from granular.routes import axial, certified, closed_form, exact, sphere
from granular.routes.result import RouteResult
from granular.scene import Scene


@pytest.fixture(scope="module", autouse=True)
def _enclose_once() -> Iterator[None]:
    """Ball arithmetic and random contacts answer the same question once, however often the checks run here."""
    drawn: dict[int, Estimate] = {}
    draw = sampled_scenes.sampled_stiffness

    def once(scene: Scene, *, seed: int) -> Estimate:
        if seed not in drawn:
            drawn[seed] = draw(scene, seed=seed)
        return drawn[seed]

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(certified, "enclose", lru_cache(maxsize=None)(certified.enclose))
        patch.setattr(sampled_scenes, "sampled_stiffness", once)
        yield


@pytest.fixture(scope="module")
def comparisons() -> list[Comparison]:
    return checks.table()


def test_everything_agrees(comparisons: list[Comparison]) -> None:
    """Some route disagrees with a certified value, a limit, or ball arithmetic."""
    assert [comparison for comparison in comparisons if not comparison.agrees] == []
    assert {comparison.route for comparison in comparisons} == {
        *(route.NAME for route in (closed_form, exact, axial, sphere, certified)), monte_carlo.NAME,
        gradation_comparisons.NAME, "turned", "lebedev", "product"}
    assert len(comparisons) > 3500


def test_the_table_is_short_enough_to_read(comparisons: list[Comparison]) -> None:
    """Rows are not folded, or a comparison is lost on the way."""
    rows = checks.rows(comparisons)
    assert len(rows) < 175
    groups = list(dict.fromkeys(row.group for row in rows))
    assert groups == list(dict.fromkeys(comparison.group for comparison in comparisons))
    shown = [comparison for row in rows for comparison in row.worst.values()]
    assert max(map(share, shown)) == max(map(share, comparisons))


def share(comparison: Comparison) -> float:
    """Error over what is allowed."""
    return comparison.error / comparison.allowed if comparison.allowed else 0.0


def test_a_unit_in_the_last_place() -> None:
    """The unit is taken at another number than the known value, or a wrong zero passes."""
    third = Fraction(1, 3)
    assert error_in_ulp(1 / 3, third) < 0.5
    assert error_in_ulp(math.nextafter(1 / 3, 1), third) > 0.5
    # Just below a power of two units are half as large as above it.
    assert error_in_ulp(1 - 2.0**-53, Fraction(1)) == 0.5
    assert error_in_ulp(1.0, 1 - Fraction(1, 2**53)) == 1.0
    assert error_in_ulp(5e-324, Fraction(0)) == math.inf
    assert error_in_ulp(0.0, Fraction(0)) == 0
    assert error_in_ulp(math.nan, third) == math.inf
    assert gap_in_ulp([(1, 1.0), (-1, 1 - 2.0**-52)]) == pytest.approx(2 / 3)


@pytest.mark.parametrize("route", [closed_form, axial, sphere])
def test_a_wrong_route_is_caught(route: ModuleType, monkeypatch: pytest.MonkeyPatch,
                                 capsys: pytest.CaptureFixture[str]) -> None:
    """One component of one route is off beyond what is allowed, and the command still succeeds."""
    right = route.evaluate

    def off(*arguments: object, **options: object) -> RouteResult:
        result = right(*arguments, **options)
        wrong = list(result.components)
        wrong[4] *= 1 + 4 * result.relative_error
        return RouteResult(tuple(wrong), result.relative_error, result.evaluations)

    monkeypatch.setattr(route, "evaluate", off)
    assert checks.run_checks() == 1
    shown = capsys.readouterr().out
    assert "MISSED" in shown
    assert f"MISS: paper, o000, kinematic, {route.NAME}: C2323 is off by" in shown


@pytest.mark.parametrize("wrong", ["slide", "stick", "nothing"])
def test_contact_forces_are_caught(wrong: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """A route that is off only where contacts slide, or only where they stick, still agrees with everything."""
    right = axial.evaluate

    def off(fabric: AxialFabric, *, loading: Loading | None = None, **options: Any) -> RouteResult:
        result = right(fabric, loading=loading, **options)
        if loading is None or loading.slides(fabric.D33) != (wrong == "slide") or wrong == "nothing":
            return result
        shear = result.components[4] * (1 + 4e-15)
        return RouteResult((*result.components[:4], shear, result.components[5]), result.relative_error, 0)

    monkeypatch.setattr(axial, "evaluate", off)
    missed = {comparison.group for comparison in stored_comparisons() if not comparison.agrees}
    expected = {"slide": {"forces: friction", "forces: paper", "spheroids: slide"},
                "stick": {"forces: c - a tiny", "forces: nu-edge", "spheroids: stick"}}
    assert missed >= expected.get(wrong, set())
    loaded = ("forces", "spheroids: stick", "spheroids: sl", "spheroids: frictionless", "spheroids: opening")
    assert all(group.startswith(loaded) for group in missed)


def test_a_coupling_at_zero_is_caught(monkeypatch: pytest.MonkeyPatch) -> None:
    """1 - k_r/k_n formed by subtraction would leave a C1122 of 1e-17 where it must vanish."""
    right = closed_form.evaluate

    def off(*arguments: object, **options: object) -> RouteResult:
        result = right(*arguments, **options)
        return RouteResult((*result.components[:2], 1e-17, *result.components[3:]), result.relative_error, 0)

    monkeypatch.setattr(closed_form, "evaluate", off)
    missed = {comparison.group for comparison in limit_comparisons() if not comparison.agrees}
    assert "nu = 0: exact zeros" in missed


def test_the_command(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    """The table is wider than a terminal, the summary is missing, or the data cannot be read back."""
    out = tmp_path / "checks.json"
    assert checks.run_checks(json_out=out) == 0
    *table, summary = capsys.readouterr().out.splitlines()
    assert max(map(len, table)) <= 80
    assert all(heading in table[1] for heading in ("case", "route", "kinematic", "static", "verdict"))
    records = json.loads(out.read_text(encoding="utf-8"))
    assert summary.startswith(f"{len(records)} comparisons, 0 misses, worst ")
    assert all(record["agrees"] for record in records)
    assert [path.name for path in tmp_path.iterdir()] == ["checks.json"]


def test_data_that_cannot_be_written(tmp_path: Path) -> None:
    """A missing folder ends in a traceback, or leaves half a file."""
    with pytest.raises(OutputUnwritable):
        checks.run_checks(json_out=tmp_path / "missing" / "checks.json")


def test_without_python_flint(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    """Without ball arithmetic the rest is not checked, or nobody is told that a voice is missing."""
    monkeypatch.setitem(sys.modules, "flint", None)
    assert checks.run_checks() == 0
    shown = capsys.readouterr().out
    assert "certified voice is missing" in shown
    assert "certified  " not in shown


def test_the_console_script() -> None:
    """``granular check`` does not reach the checks, or loads the symbolic library."""
    code = ("import sys; from granular.__main__ import run_command; code = run_command(['check']);"
            "sys.exit(code or ('sympy' in sys.modules) * 3)")
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    assert "0 misses" in run.stdout


def test_limits_are_consistent_among_themselves() -> None:
    """A coefficient of the polynomial, of the trace or of an isotropic modulus is mistyped."""
    fabric = AxialFabric(D33=0.25, Dr33=-0.5)
    for nu in (0.0, 0.25, 0.5, 1.0):
        c1111, c3333, c1122, c1133, c2323, c1212 = kinematic_polynomial(fabric, nu)
        assert c1111 - c1122 == 2 * c1212
        assert c3333 + 2 * c1111 + 2 * c1122 + 4 * c1133 == kinematic_trace(fabric)
        assert kinematic_polynomial(AxialFabric(), nu) == isotropic_kinematic(AxialFabric(), nu)
        assert kinematic_polynomial(fabric, nu) == exact.rational_components(fabric, poisson_ratio=nu)
        if nu == 1:
            assert (c1133, c1122) == (c2323, c1212)


def test_records_are_frozen_and_name_what_they_compare(comparisons: list[Comparison]) -> None:
    """A record lost a field, or can be changed after the fact."""
    first = comparisons[0]
    assert (first.group, first.case, first.hypothesis, first.route) == (
        "paper", "o000", Hypothesis.KINEMATIC, "closed_form")
    with pytest.raises(AttributeError):
        first.error = 0.0  # type: ignore[misc]


def test_limits_with_forces_are_hit(monkeypatch: pytest.MonkeyPatch) -> None:
    """A route that ignores friction, or the stress, passes the limits with contact forces."""
    groups = {comparison.group for comparison in force_limit_comparisons()}
    assert groups >= {f"forces: {name}" for name in (
        "a = c", "K and G", "SR near 1", "SR to inf", "SR to 0", "C1212", "trace", "exact zeros", "no friction",
        "mu to 0", "mu to inf", "onset")}
    right = axial.evaluate

    def without_friction(fabric: AxialFabric, *, loading: Loading | None = None, **options: Any) -> RouteResult:
        assert loading is not None
        return right(fabric, loading=Loading(sigma11=loading.sigma11, sigma33=loading.sigma33), **options)

    monkeypatch.setattr(axial, "evaluate", without_friction)
    missed = {comparison.group for comparison in force_limit_comparisons() if not comparison.agrees}
    assert {"forces: no friction", "forces: onset"} <= missed
