"""``granular check``: what it counts, what it shows, and that it fails when a route is wrong."""

from __future__ import annotations

import json
import math
import subprocess
import sys
from fractions import Fraction
from pathlib import Path
from types import ModuleType

import pytest

from granular import checks
from granular.checks.comparison import Comparison, error_in_ulp, gap_in_ulp
from granular.checks.limit_comparisons import limit_comparisons
from granular.checks.limits import isotropic_kinematic, kinematic_polynomial, kinematic_trace
from granular.errors import OutputUnwritable
from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.routes import axial, certified, closed_form, exact, sphere
from granular.routes.result import RouteResult


@pytest.fixture(scope="module")
def comparisons() -> list[Comparison]:
    return checks.table()


def test_everything_agrees(comparisons: list[Comparison]) -> None:
    """Some route disagrees with a certified value, a limit, or ball arithmetic."""
    assert [comparison for comparison in comparisons if not comparison.agrees] == []
    assert {comparison.route for comparison in comparisons} == {
        route.NAME for route in (closed_form, exact, axial, sphere, certified)}
    assert len(comparisons) > 800


def test_the_table_is_short_enough_to_read(comparisons: list[Comparison]) -> None:
    """Rows are not folded, or a comparison is lost on the way."""
    rows = checks.rows(comparisons)
    assert len(rows) < 80
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
