"""Convergence of the rules for branch lengths: written a second time, against certified moments."""

from __future__ import annotations

from pathlib import Path

import pytest

from granular.checks.length_rule import SPREADS, STRETCHES, measure_times, rule_errors, second_moment
from granular.gradation import Lognormal, length_moments
from granular.gradation.lognormal_branches import INNER_STEP, OUTER_STEP


@pytest.mark.parametrize("spread", SPREADS)
def test_errors_fall_to_rounding(spread: float) -> None:
    """Breaks when the steps of the library no longer reach rounding, or the rules stop to converge exponentially."""
    errors = [rule.error for rule in rule_errors(spread)]
    assert len(errors) == len(STRETCHES)
    assert errors[-1] < 5e-15  # a few roundings of exponents
    assert errors[0] < 1e-4
    assert errors[-2] < 1e-12  # steps a quarter wider have room


@pytest.mark.parametrize("spread", [1.001, 1.7, 5.0])
def test_library_agrees_with_the_second_writing(spread: float) -> None:
    """Breaks when the library's rules leave something out that counts."""
    again, _, _ = second_moment(spread, inner=INNER_STEP, outer=OUTER_STEP)
    assert length_moments(Lognormal(1.0, spread)).second == pytest.approx(again, rel=2e-14)


def test_times_name_their_machine(tmp_path: Path) -> None:
    """Breaks when a stored time has lost the machine that it was measured on."""
    curve = tmp_path / "curve.csv"
    curve.write_text("1 mm, 0\n2 mm, 0.5\n4 mm, 1\n", encoding="utf-8")
    found = measure_times(curve, rounds=1)
    assert found["machine"]["python"]
    assert len(found["seconds"]) == len(SPREADS) + 1
    assert all(0 < seconds < 60 for seconds in found["seconds"].values())
