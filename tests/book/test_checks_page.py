"""The page of checks shows every comparison that is made, each in the unit in which it counts."""

from __future__ import annotations

import pytest
from page_tools import checks

from granular.checks.comparison import STANDARD_ERRORS, Comparison
from granular.hypothesis import Hypothesis


def comparison(group: str, route: str, error: float, **other: str) -> Comparison:
    return Comparison(group=group, case="one", hypothesis=Hypothesis.KINEMATIC, route=route, component="C1111",
                      error=error, allowed=5.0, **other)


@pytest.fixture
def compared(monkeypatch: pytest.MonkeyPatch) -> list[Comparison]:
    made = [comparison("interior", "axial", 1.25), comparison("gradation", "lengths", 3.5),
            comparison("sampled: graded", "monte_carlo", 2.75, unit=STANDARD_ERRORS)]
    monkeypatch.setattr(checks, "compared", lambda: made)
    return made


@pytest.mark.usefixtures("compared")
def test_every_group_stands_in_one_of_the_tables() -> None:
    """Breaks when a group has a row of dashes, or none, because its way of computing is no route."""
    routes, samples = checks.check_table(Hypothesis.KINEMATIC).text, checks.sizes_and_samples().text
    assert "| interior (1) |" in routes and "1.25" in routes
    assert "gradation" not in routes and "sampled" not in routes
    assert "| gradation (1) | kinematic | 3.50 | 5 | units |" in samples
    assert "| sampled: graded (1) | kinematic | 2.75 | 5 | standard errors |" in samples


def test_a_miss_stops_the_page(compared: list[Comparison]) -> None:
    """Breaks when a page is built over a comparison that does not agree, sampled or not."""
    compared.append(comparison("sampled: graded", "monte_carlo", 7.0, unit=STANDARD_ERRORS))
    with pytest.raises(AssertionError, match="misses"):
        checks.check_table(Hypothesis.KINEMATIC)
