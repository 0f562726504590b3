"""The page on fabric from wave speeds: what it says in words against the experiments that it compares."""

from __future__ import annotations

from pathlib import Path

import pytest
from page_tools.fit import EXPERIMENTS, _alone, _planned, data_file

from granular.fitting.result import combinations_at
from granular.fitting.solver import minima


@pytest.fixture(scope="module")
def errors() -> dict[str, tuple[float, float, float]]:
    """Standard errors of the best combination, of D33 and of Dr33, by experiment."""
    found = {}
    for name, options in EXPERIMENTS.items():
        best, worst = combinations_at(*_planned(**options))
        found[name] = best.standard_error, _alone(best, worst, 0), _alone(best, worst, 1)
    return found


def test_words_about_the_experiments(errors: dict[str, tuple[float, float, float]]) -> None:
    """Breaks when a change of the model makes a bullet of the page untrue."""
    alone, ratios, friction, both, believed, static = errors.values()
    assert alone[1] > 3  # longer than the admissible range of D33
    assert all(best < 0.1 for best, _, _ in errors.values())
    assert both[1] < 0.2 < min(ratios[1], friction[1])
    assert believed[1] < both[1] / 2
    assert static[1] > 1  # speeds along and across the axis do not see C1122 and C1133


def test_singular_directions_give_the_errors_of_each_unknown() -> None:
    """Breaks when the two independent directions are put together wrongly; the inverse matrix is the other way."""
    import numpy as np

    problem, at = _planned(ratios=(0.5, 2.0))
    _, slopes = problem.residuals(at)
    covariance = np.linalg.inv(slopes.T @ slopes)
    best, worst = combinations_at(problem, at)
    for place in range(2):
        assert _alone(best, worst, place) == pytest.approx(np.sqrt(covariance[place, place]), rel=1e-6)


def test_planned_experiment_is_at_its_minimum() -> None:
    """Breaks when the data of a planned experiment are not those of its fabric."""
    problem, at = _planned(ratios=(0.5, 2.0))
    assert minima(problem)[0].unknowns == pytest.approx(at, abs=1e-7)


def test_data_file_is_shown(book: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Breaks when a line of the file is wider than the page."""
    monkeypatch.chdir(book)
    text = data_file("_data/fit_sand.toml").text
    assert text.startswith("```toml\n")
    assert max(map(len, text.splitlines())) <= 74
