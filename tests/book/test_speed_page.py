"""What the page on speed says is what the stored records say, whatever they will be after the next measurement."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from page_tools import speed

from granular.speed.comparisons import catalogue
from granular.speed.interleaved import Measured
from granular.speed.store import Row, Study, read


def study(*ways: Measured) -> Study:
    """One comparison with some ways."""
    row = Row(name="kinetic", title="kinetic", each="assembly", errors="", size=10**6, ways=ways, failure=None)
    return Study(command="granular speed", rounds=3, machine={"load": "0.5"}, rows=[row], agreements=[])


def way(ratio: float, wanted: float | None = None, memory: float | None = None) -> Measured:
    """A measurement with a bound."""
    return Measured(name=f"way {ratio:g}", elements=10**6, ratio=ratio, least=ratio, spread=0.1, nanoseconds=25.0,
                    rounds=3, error=2e-16, wanted=wanted, memory=memory, memory_wanted=memory and 0.2)


def test_the_stored_run_is_whole(book: Path) -> None:
    """Breaks when the page would show a run that was stopped, or one of other comparisons."""
    stored = read(book / "_data" / "speed.json")
    assert {row.name for row in stored.rows} == {comparison.name for comparison in catalogue()}
    assert stored.command.startswith("granular speed")
    assert "--only" not in stored.command
    assert "--largest" not in stored.command


def test_no_measured_number_is_typed(book: Path) -> None:
    """Breaks when a number stands in the prose: after the next measurement it would be wrong."""
    page = (book / "speed.md").read_text(encoding="utf-8")
    prose = re.sub(r"^```.*?^```|\A---.*?^---|\{numref\}`[^`]*`|\$[^$]*\$|`[^`]*`", "", page, flags=re.M | re.S)
    assert re.findall(r"\d+", prose.replace("C11", "")) == []


def test_bounds_are_judged_as_they_are(monkeypatch: pytest.MonkeyPatch) -> None:
    """Breaks when a bound that is missed is called met, a memory is left out, or a way without a bound is judged."""
    monkeypatch.setattr(speed, "measured", lambda: study(way(1.0), way(4.0, 4.5), way(5.0, 4.5), way(1.5, None, 0.3)))
    text = speed.wanted().text
    lines = [line for line in text.splitlines() if line.startswith("| way")]
    assert [line.split(" | ")[-1] for line in lines] == ["yes |", "**no** |", "**no** |"]
    assert "way 4, over way 1<br>`kinetic`, $10^{6}$ | 4.5 | 4.00" in lines[0]
    assert "memory" in lines[2]
    said = speed.met().text
    assert said.startswith("1 of 3 bounds are met in the stored run. Not met in `kinetic`.")
    assert "was 0.5 when" in said


def test_an_unfinished_run_stops_the_build(monkeypatch: pytest.MonkeyPatch) -> None:
    """Breaks when a page shows what is left of a run that was stopped."""
    speed.measured.cache_clear()
    monkeypatch.setattr(speed, "read", lambda _path: study(way(1.0)))
    with pytest.raises(AssertionError, match="has no constant"):
        speed.measured("other.json")
    speed.measured.cache_clear()


def test_the_bracket_is_shown_wrong_by_quadrature() -> None:
    """Breaks when the right and the wrong formula change places."""
    errors = [line.split(" | ")[-1] for line in speed.bracket().text.splitlines() if line.startswith("| $")]
    assert float(errors[0].strip(" |").replace("−", "-")) < 1e-13  # quadrature was asked for it
    assert float(errors[1].strip(" |").replace("−", "-")) > 1e-2
