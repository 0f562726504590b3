"""What the page on costs says is what the stored records say, whatever they will be after the next measurement."""

from __future__ import annotations

import base64
import csv
import io
import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from page_tools import cost, cost_plan, cost_tables, cost_words
from page_tools.markup import Markup

from granular.cost.records import Cost
from granular.cost.scenes import NAMES
from granular.figures.cost_data import CostData, MeasuredScene, read_cost_data
from granular.hypothesis import Hypothesis


def measured(route: str = "axial", setting: str = "rtol 1e-06", error: float | None = 1e-8, time: float | None = 10.0,
             kind: str = "product", **more: Any) -> Cost:
    """Make a measurement."""
    record: dict[str, Any] = {"scene": "sliding", "hypothesis": Hypothesis.KINEMATIC, "promised": None, "failure": None,
                              "evaluations": 20, "spread": None if time is None else 0.1, "count": 5}
    return Cost(route=route, setting=setting, error=error, time_ratio=time, kind=kind, **(record | more))


def scene(*costs: Cost, hypothesis: Hypothesis = Hypothesis.KINEMATIC) -> MeasuredScene:
    """Make a scene of measurements."""
    return MeasuredScene("sliding", "some contacts slide", hypothesis, {}, 33, costs)


def asked(time: float, *, kind: str = "product", route: str = "axial") -> Iterator[Cost]:
    """Settings of a route that are asked for the four accuracies, each twice as long as the one before."""
    for number, wanted in enumerate(cost_words.WANTED):
        yield measured(route, f"rtol {wanted:.0e}", wanted / 10, time * 2 ** number, kind, evaluations=10 + number,
                       promised=wanted if kind == "product" else None)


PAPER = measured("midpoint", "24 panels", 2e-2, 8.0, paper=True)
FAILED = measured("sympy_evalf", "any", None, None, "outside", failure="no closed form with slip")
WHOLE = scene(PAPER, *asked(10.0), *asked(50.0, kind="outside", route="quad"), FAILED)


def rows(text: str) -> list[list[str]]:
    """Rows of the CSV beside a table, with its header."""
    data = re.search(r"base64,([A-Za-z0-9+/=]+)\">these", text)
    assert data is not None
    return list(csv.reader(io.StringIO(base64.b64decode(data[1]).decode())))


def test_every_scene_has_its_section(book: Path) -> None:
    """Breaks when a scene is measured and never shown, or stands in another order than on the command line."""
    page = (book / "cost.md").read_text(encoding="utf-8")
    assert re.findall(r'^of_scene\("([a-z-]+)"\)$', page, flags=re.MULTILINE) == list(NAMES)


def test_the_stored_data_are_those_of_the_scenes(book: Path) -> None:
    """Breaks when the page would show a measurement of other scenes, or of a run that was stopped."""
    data = read_cost_data(book / "_data" / "cost.json")
    assert data.complete
    assert list(dict.fromkeys(found.name for found in data.scenes)) == list(NAMES)


def test_no_measured_number_is_typed(book: Path) -> None:
    """Breaks when a number stands in the prose: after the next measurement it would be wrong."""
    page = (book / "cost.md").read_text(encoding="utf-8")
    prose = re.sub(r"^```.*?^```|\A---.*?^---|\{numref\}`[^`]*`|\$10\^\{-17\}\$", "", page, flags=re.M | re.S)
    assert not re.findall(r"\d+", prose)


def test_a_finding_is_computed() -> None:
    """Breaks when a sentence of the finding takes another row, forgets a factor, or turns a quotient round."""
    text = cost_words.finding(WHOLE)
    assert "$10^{-3}$ costs 10.0, $10^{-6}$ costs 20.0, $10^{-9}$ costs 40.0 and $10^{-12}$ costs 80.0" in text
    assert "$10^{-12}$ takes 8.0 times as long as $10^{-3}$" in text
    assert "and 5.0 times as long (`quad`) when asked" in text
    assert "24 panels are off by 2 % and take 8.00 times the unit" in text
    assert "rtol 1e−3, has an error of 1.0e−4 and is 0.80 times as fast" in text


def test_equal_work_is_not_ranked_by_noise() -> None:
    """Breaks when runs that do the same are said to cost more or less by what the clock happened to show."""
    same = [measured(setting=f"rtol {wanted:.0e}", promised=1e-15, time=time)
            for wanted, time in zip(cost_words.WANTED, (7.0, 4.0, 4.5, 5.0), strict=True)]
    assert "`axial` states every accuracy from $10^{-3}$ to $10^{-12}$ for 4.00 to 7.00 times" in cost_words.finding(
        scene(*same))


@pytest.mark.parametrize("costs", [(PAPER,), (FAILED,), tuple(asked(10.0)), tuple(asked(9.0, kind="outside")),
                                   tuple(asked(10.0))[:2]],
                         ids=["printed rule", "failure", "library", "outside", "two accuracies"])
def test_a_scene_that_lacks_something_still_has_words(costs: tuple[Cost, ...]) -> None:
    """Breaks when the page cannot be built on data in which a route is missing."""
    lacking = scene(*costs)
    assert cost_words.finding(lacking)
    assert cost_words.caption([lacking]).startswith("Some contacts slide.")
    assert cost_words.overall(CostData("", {}, 5, "", True, (lacking,)))
    assert cost_tables.wanted_table([lacking]).text.count("\n| ") == 2 + len(cost_words.WANTED)


def test_broken_promises_are_counted() -> None:
    """Breaks when a stated error that is too small goes unseen on the page."""
    liar = measured(promised=1e-9)
    assert cost_words.kept(CostData("", {}, 5, "", True, (scene(liar, PAPER),))).endswith("1 of them break it.")
    assert cost_words.kept(CostData("", {}, 5, "", True, (WHOLE,))).endswith("every one of them keeps it.")


def test_all_rows_can_be_taken_away() -> None:
    """Breaks when a measurement, a failed one above all, is left out of the table or its file."""
    text = cost_tables.rows_table(WHOLE).text
    header, *taken = rows(text)
    assert [(row[0], row[2]) for row in taken] == [(one.route, one.setting) for one in WHOLE.costs]
    assert taken[-1][header.index("failure")] == "no closed form with slip"
    assert text.count("\n| `") == len(WHOLE.results)
    assert list(cost_tables.failures([WHOLE])) == ["- `sympy_evalf`, any: no closed form with slip"]
    assert cost_tables.without_result([WHOLE]) == "No result by `sympy_evalf`."


def test_a_scene_on_the_page(monkeypatch: pytest.MonkeyPatch) -> None:
    """Breaks when the picture loses its description, or the command measures another scene than the one shown."""
    data = CostData("granular cost", {"unit_seconds": 5e-6}, 5, "", True, (WHOLE,))
    monkeypatch.setattr(cost, "measured", lambda: data)
    text = cost.of_scene("sliding").text
    assert "$ granular cost --scene sliding\n" in text
    assert ":::{figure} data:image/svg+xml;base64," in text
    assert ":alt: Error against time of one evaluation" in text
    assert f"All {len(WHOLE.costs)} measurements" in text
    with pytest.raises(AssertionError, match="no measurement of opened"):
        cost.of_scene("opened")


def test_an_unfinished_run_stops_the_build(tmp_path: Path) -> None:
    """Breaks when the page shows half a study as if it were all."""
    path = tmp_path / "cost.json"
    path.write_text(json.dumps({"command": "", "machine": {}, "rounds": 5, "unit": "", "complete": False, "scenes": [],
                                "costs": []}), encoding="utf-8")
    with pytest.raises(AssertionError, match="not complete"):
        cost.measured.__wrapped__(str(path))


def promises(**more: Any) -> dict[str, Any]:
    """Outcome of a check of promises, as its file has it."""
    group = {"kind": "sliding", "rtol": 1e-3, "count": 10, "refused": 0, "misses": 0, "worst_error_over_rtol": 0.25}
    return {"command": "granular check --promises 10 --seed 1", "scenes": 10, "rtols": [1e-3], "promises": 10,
            "refused": 0, "broken": 0, "by_kind": [group | more.pop("group", {})]} | more


@pytest.mark.parametrize(("more", "sentence", "cell"), [
    ({}, "of the others none was broken. The largest true error is 0.25 of", "0.25 |"),
    ({"broken": 2, "group": {"misses": 2, "worst_error_over_rtol": 3.0}}, "**2 were broken**", "**3.0** |"),
    ({"group": {"worst_error_over_rtol": None, "misses": 1}}, "", "**no number** |"),
    ({"group": {"refused": 10}}, "", "refused (10) |")])
def test_promises_in_words(tmp_path: Path, more: dict[str, Any], sentence: str, cell: str) -> None:
    """Breaks when a broken promise, or a result that is no number, looks like a kept one."""
    path = tmp_path / "promises.json"
    path.write_text(json.dumps(promises(**more)), encoding="utf-8")
    text = cost_plan.promise_table(str(path)).text
    assert sentence in text
    assert cell in text
    assert "`granular check --promises 10 --seed 1` checks it again." in text


def test_a_share_is_never_rounded_up(tmp_path: Path) -> None:
    """Breaks when one poor choice in ten thousand becomes a hundred percent."""
    group = {"choices": 10000, "share": 0.9999, "median": 1.0, "worst": 2.5, "planned_over_chosen": 1.05,
             "not_accurate_enough": 0}
    path = tmp_path / "choices.json"
    path.write_text(json.dumps({
        "command": "granular check --choices 2500 --seed 1", "scenes": 2500, "near": 1.5, "rounds": 7, "all": group,
        "machine": {"processor": "some"}, "by_rtol": [group | {"rtol": 1e-6}], "by_kind": [group | {"kind": "faint"}],
    }), encoding="utf-8")
    text = cost_plan.choice_table(str(path)).text
    assert "99.9 % take at most 1.5 times" in text
    assert "the worst 2.50" in text
    assert [row[0] for row in rows(text)] == ["choices", "all", "rtol 1e-06", "faint"]


def test_stored_checks_of_the_plan_are_shown(book: Path) -> None:
    """Breaks when the files of the two checks change their format under the page."""
    for shown in (cost_plan.promise_table(str(book / cost_plan.PROMISES)),
                  cost_plan.choice_table(str(book / cost_plan.CHOICES))):
        assert isinstance(shown, Markup)
        assert "granular check --" in shown.text


def test_a_reader_picks_scene_and_accuracy(built: Path, chromium: str) -> None:
    """Breaks when the controls of the built page do not move the marks and the words, or raise an error."""
    from chromium import Chromium

    page = built / "cost.html"
    assert "cost-chooser" in page.read_text(encoding="utf-8"), "build the book again"
    state = """(() => { const plot = document.getElementById("plotly-cost-chooser");
      return [document.querySelector(".cost-chooser .answer").textContent,
              plot.data.find(trace => trace.name === "wanted").y[0]]; })()"""
    pick = """(() => { const [scene, accuracy] = document.querySelectorAll(".cost-chooser :is(select, input)");
      scene.value = 0; scene.dispatchEvent(new Event("change"));
      accuracy.value = accuracy.max; accuracy.dispatchEvent(new Event("input")); })()"""
    with Chromium(chromium) as browser:
        browser.open(page, width=1280)
        before = browser.ask(state)
        browser.ask(pick)
        after = browser.ask(state)
        assert not [event for event in browser.events if event.get("method") == "Runtime.exceptionThrown"]
    first = json.loads((built.parents[1] / "_data" / "cost.json").read_text(encoding="utf-8"))["scenes"][0]
    assert after[0].startswith(f"{first['name']}, {first['hypothesis']}, ")
    assert after[0] != before[0]
    assert after[1] < before[1]
