"""Error against time: marks where the records say, a front that nothing beats, promises apart from luck."""

import json
import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from granular.cost import timing
from granular.cost.records import Cost
from granular.cost.store import Study
from granular.figures.cost_chooser import ACCURACIES, CostChooser, answer, words
from granular.figures.cost_data import CostData, MeasuredScene, read_cost_data, series
from granular.figures.cost_pareto import LEAST, LOOKS, pareto, places
from granular.figures.cost_selection import (
    WANTED,
    as_good_as_paper,
    front,
    in_hindsight,
    outside_asked_for,
    promised_for,
)
from granular.figures.look import INK
from granular.hypothesis import Hypothesis


def cost(route="axial", setting="rtol 1e-06", error=1e-8, time=10.0, kind="product", **more):
    timed = time is not None
    record = {"scene": "sliding", "hypothesis": Hypothesis.KINEMATIC, "promised": None, "evaluations": 20,
              "spread": 0.1 if timed else None, "count": 5 if timed else 0, "failure": None}
    return Cost(route=route, setting=setting, error=error, time_ratio=time, kind=kind, **(record | more))


def scene(*costs, name="sliding", hypothesis=Hypothesis.KINEMATIC):
    return MeasuredScene(name, "some contacts slide", hypothesis, {}, 120, costs)


def data(*scenes):
    return CostData("granular cost", {"unit_seconds": 5e-6}, 5, timing.UNIT, True, scenes)


PAPER = cost("midpoint", "24 panels", 2e-2, 8.0, paper=True)
NUMBERS = st.floats(1e-18, 1e3)


def test_a_study_is_read_as_it_was_written(tmp_path):
    # a field lost or renamed between the command and the page; a scene under the other hypothesis
    study = Study("granular cost", 5)
    costs = [cost(), cost("exact", "default", None, None, failure="slip")]
    study.add(costs, [5e-6])
    study.complete = True
    study.write(tmp_path / "cost.json")
    read = read_cost_data(tmp_path / "cost.json")
    (only,) = read.scenes
    assert list(only.costs) == costs
    assert (only.label, read.unit, read.unit_seconds, read.complete) == ("sliding, kinematic", timing.UNIT, 5e-6, True)
    assert read.of_name("sliding") == (only,)
    assert read.of_name("opened") == ()


@given(st.lists(st.tuples(NUMBERS, NUMBERS), min_size=1, max_size=30))
def test_nothing_beats_the_front(points):
    # a front that keeps a point which another beats in both, or loses one that none beats
    costs = [cost(setting=f"{number} nodes", time=time, error=error) for number, (time, error) in enumerate(points)]
    kept = {(one.time_ratio, one.error) for one in front(scene(*costs))}
    for time, error in points:
        beaten = any(other != (time, error) and other[0] <= time and other[1] <= error for other in points)
        assert ((time, error) in kept) == (not beaten)


def test_a_promise_counts_and_luck_does_not():
    # the cheapest by its measured error taken for one that could have been relied on, or the reverse
    lucky = cost(setting="rtol 1e-03", error=1e-9, promised=1e-3, time=5.0)
    asked = cost(promised=1e-6, error=1e-8, time=12.0)
    found = scene(lucky, asked)
    assert promised_for(found, 1e-6) is asked
    assert promised_for(found, 1e-9) is None
    assert in_hindsight(found, 1e-9, kind="product") is lucky


def test_the_setting_that_was_asked_comes_before_a_cheaper_one_of_the_same_route():
    # the noise of equal settings choosing the row, so that 1e-3 is answered by a run at 1e-11
    asked, same = cost(setting="rtol 1e-03", promised=1e-12, time=10.0), cost(setting="rtol 1e-11", promised=1e-12,
                                                                              time=9.0)
    other = cost("closed_form", "default", promised=1e-15, time=9.5)
    assert promised_for(scene(same, asked), 1e-3) is asked
    assert promised_for(scene(same, asked, other), 1e-3) is other


def test_a_warning_is_no_answer():
    # a result that its route itself doubts, named as the cheapest
    warned = cost("quad", kind="outside", error=1e-12, time=1.0, failure="roundoff")
    good = cost("quad_vec", kind="outside", error=1e-12, time=2.0)
    found = scene(warned, good)
    assert warned in found.results
    assert in_hindsight(found, 1e-6) is good
    assert outside_asked_for(found, 1e-6) is good
    assert warned not in front(found)


def test_asked_and_kept():
    # a tolerance that was asked for and missed counted as kept, or a rule without a tolerance as asked
    missed = cost("quad", kind="outside", error=1e-5, time=1.0)
    rule = cost("gauss_x", "16 nodes", kind="outside", error=1e-12, time=1.0)
    assert outside_asked_for(scene(missed, rule), 1e-6) is None


def test_as_good_as_the_printed_rule():
    # the rule itself with more panels, or a less accurate way, offered in its place
    more, worse = cost("midpoint", "96 panels", 1e-3, 2.0), cost(error=0.1, time=1.0)
    better = cost(error=1e-3, time=9.0)
    assert as_good_as_paper(scene(PAPER, more, worse, better)) is better
    assert as_good_as_paper(scene(PAPER, more, worse)) is None
    assert as_good_as_paper(scene(better)) is None


def test_settings_run_from_coarse_to_fine():
    # a line that zigzags since the printed rule is listed first, or tolerances joined with numbers of nodes
    costs = [cost(setting=name) for name in ("24 panels", "12 panels", "default", "48 panels", "rtol 1e-12",
                                             "rtol 1e-03")]
    assert [[one.setting for one in members] for members in series(costs)] == [
        ["12 panels", "24 panels", "48 panels"], ["default"], ["rtol 1e-03", "rtol 1e-12"]]


def test_marks_stand_where_the_records_say():
    # axes exchanged, the ring on another rule, a front through other points, an exact result that vanishes
    costs = [PAPER, cost(time=12.0), cost("quad", kind="outside", error=0.0, time=300.0),
             cost("exact", "default", None, None, failure="slip")]
    axes = pareto([scene(*costs)]).axes[0]
    drawn = {line.get_label(): np.column_stack(line.get_data()).tolist() for line in axes.lines}
    assert drawn["axial"] == [[12.0, 1e-8]]
    assert drawn["adaptive"] == [[300.0, LEAST]]
    assert drawn["the paper's rule"] == [[8.0, 2e-2]]
    assert drawn["front"] == [[8.0, 2e-2], [12.0, 1e-8], [300.0, LEAST]]
    assert "exact" not in drawn
    assert axes.get_xlabel() == ""  # the label of both panels is the figure's
    assert any("24 panels" in text.get_text() for text in axes.texts)
    assert places(costs[1:2]) == ([12.0], [1e-8])


def test_two_hypotheses_share_their_axes():
    # panels that look alike while their scales differ
    both = [scene(cost(time=time), hypothesis=hypothesis) for time, hypothesis in zip((10.0, 1e5), Hypothesis,
                                                                                      strict=True)]
    first, second = pareto(both).axes
    assert first.get_xlim() == second.get_xlim()
    assert [axes.get_title() for axes in (first, second)] == ["kinematic", "static"]


def test_routes_of_the_catalogue_have_a_look_of_their_own():
    # two routes that cannot be told apart, or a new one drawn in the look of none
    from granular.routes.catalogue import ROUTES

    assert set(ROUTES) <= set(LOOKS)
    assert len(set(LOOKS.values())) == len(LOOKS)
    assert INK not in {colour for _, colour in LOOKS.values()}


@pytest.fixture
def chooser():
    found = scene(PAPER, cost(promised=1e-6, time=12.0), cost("quad", kind="outside", time=300.0))
    evil = scene(cost("new_route", "default", 1e-3, 3.0, promised=1e-2, failure="</script><b>&"), name="equal-contacts")
    return CostChooser(data(evil, found))


def test_every_state_is_in_the_page(chooser):
    # an accuracy without an answer, a mark on another point than the words name
    states = chooser.states()
    assert len(states) == 2
    assert all(len(state["answers"]) == len(ACCURACIES) for state in states)
    assert len({len(state["traces"]) for state in states}) == 1
    second = states[1]["answers"][ACCURACIES.index(1e-6)]
    assert second["marks"][0]["x"] == [12.0]
    assert second["marks"][1]["x"] == [300.0]
    assert "<code>axial</code>, rtol 1e-6," in second["words"]
    assert "60 µs" in second["words"]  # 12 units of 5 µs
    none = states[1]["answers"][ACCURACIES.index(1e-12)]
    assert none["marks"][0]["x"] == none["marks"][1]["x"] == []
    assert "No route" in none["words"]


def test_the_first_state_is_that_of_the_controls(chooser):
    # a slider that says one accuracy while the picture shows another
    page = chooser._repr_html_()
    place, wanted = chooser.start
    assert (place, ACCURACIES[wanted]) == (1, 1e-6)
    assert f'<option value="{place}" selected>' in page
    assert f'value="{wanted}" aria-label' in page
    state = chooser.states()[place]
    figure = chooser.figure()
    assert [list(trace.x) for trace in figure.data[:len(state["traces"])]] == [trace["x"] for trace in state["traces"]]
    shown = re.search(r'<p class="answer"[^>]*>(.*?)</p>', page)
    assert shown is not None
    assert shown[1] == state["answers"][wanted]["words"]


def test_records_cannot_end_the_script(chooser):
    # a message of a library that closes the script and breaks the page, or text from another machine
    page = chooser._repr_html_()
    content = re.search(r'<script type="application/json">(.*?)</script>', page, flags=re.DOTALL)
    assert content is not None
    assert json.loads(content[1])["states"][1]["answers"][0]["words"] == chooser.states()[1]["answers"][0]["words"]
    assert "</script><b>" not in page
    assert not re.search(r"(?:src|href)=\"(?!data:)", page)


def test_an_unknown_route_is_shown_all_the_same(chooser):
    # a new route left out of the picture since no look was given to it
    assert "new_route" in [trace.name for trace in chooser.figure().data]


def test_words_say_what_the_record_says():
    # the stated error given as the true one
    found = scene(cost(error=3e-9, promised=1e-6, time=12.0, evaluations=20))
    text = words(found, answer(found, 1e-6), 1e-5)
    assert "states 10<sup>−6</sup> beforehand" in text
    assert "<b>3.0·10<sup>−9</sup></b> with 20 directions" in text
    assert "120 µs" in text or "0.12 ms" in text
    assert "Nothing from outside" in text


def test_wanted_accuracies_are_stops_of_the_slider():
    # a table that names an accuracy which the picture cannot show
    assert set(WANTED) <= set(ACCURACIES)
