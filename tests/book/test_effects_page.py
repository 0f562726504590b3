"""What the pages on effects and on routes say in words holds in the records and numbers that they show."""

from __future__ import annotations

import base64
import csv
import io
import json
import math
import re
from fractions import Fraction
from pathlib import Path

import pytest
from page_tools import effects, routes
from page_tools.effects import RANGES, bound, power
from page_tools.markup import Markup
from page_tools.refusals import refused

from granular import Hypothesis, Scene, plan
from granular.checks.bought_accuracy import bought
from granular.checks.effect_decisions import Outcome, decisions
from granular.checks.effect_examples import EXAMPLES, scene_with
from granular.checks.effect_sweeps import SWEEPS, points
from granular.effects import CATALOGUE
from granular.effects.selection import model_of, select
from granular.figures.bought_accuracy import DRAWN
from granular.gradation import length_moments
from granular.routes.catalogue import AUTO
from granular.routes.catalogue import CATALOGUE as ROUTES

NAMES = [effect.name for effect in CATALOGUE]
WEAK = 0.01
"""Parameters of effects up to which bounds are linear [-]."""


@pytest.fixture(autouse=True)
def _in_the_book(book: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(book)


def rows(shown: Markup) -> list[list[str]]:
    """Rows of the CSV file of a table."""
    data = re.search(r"base64,([A-Za-z0-9+/=]+)", shown.text)
    assert data is not None
    return list(csv.reader(io.StringIO(base64.b64decode(data[1]).decode())))[1:]


def widest(*ratios: float) -> float:
    """Largest change where ratios span a range, eq-effect-bound."""
    return max(max(ratios) - 1, 1 - min(ratios))


# ---- the records


def test_every_effect_stands_in_every_table() -> None:
    """Breaks when an effect is added and a table of the page does not know it."""
    assert [row[0] for row in rows(effects.effects_table())] == NAMES
    assert [row[0] for row in rows(effects.bounds_table())] == NAMES == list(RANGES)
    assert [row[0] for row in rows(effects.examples_table())] == NAMES


def test_every_route_stands_in_every_table() -> None:
    """Breaks when a route is added and a table of the page does not know it."""
    names = [route.name for route in ROUTES]
    assert [row[0] for row in rows(routes.routes_table())] == names
    assert [row[0] for row in rows(routes.by_hand_table())] == names
    assert AUTO == ("closed_form", "axial")  # "the closed form and the rule along the meridian"


# ---- the formulas of the bounds, which are typed

D, R, SR, S_R, CHI, KAPPA, NU = 0.3, -0.3, 1.5, 1.5, 0.8, 0.5 / (2 * math.sqrt(1.5)) / math.tan(math.radians(30)), 0.21
LAMBDA = 2 * (1 - NU) / (2 - NU)
A, C = 3 / (2 + SR), 3 * SR / (2 + SR)
DENSITY = 1 - D / 2, 1 + D
N = (1 - D / 5) ** (1 / 3), (1 + 2 * D / 5) ** (1 / 3)
KEPT = (1 - KAPPA) ** (1 / 3)
TYPED = {
    "packing": widest(*(n / e for n in N for e in DENSITY)),
    "branches": widest((1 - R / 2) ** -2, (1 + R) ** -2),
    "gradation": widest(1 / length_moments(select(scene_with(EXAMPLES["gradation"])).sizes).second),
    "deviation": widest(*(CHI ** (2 / 3) * q / over for q in (1, CHI**2) for over in (1, CHI**2, CHI**4))),
    "kinetic": widest(A ** (-1 / 3), C ** (-1 / 3)),
    "slip": max(widest(1, 1 / KEPT), widest((1 - LAMBDA) / (1 - LAMBDA * KEPT), 1)),
    "opening": math.inf,
}


@pytest.mark.parametrize("name", NAMES)
def test_typed_formulas_of_bounds_are_those_of_the_library(name: str) -> None:
    """Breaks when a bound of the library changes and its formula in the table does not, or the other way round."""
    scene = scene_with(EXAMPLES[name])
    assert select(scene).bounds[name] == pytest.approx(TYPED[name], rel=1e-9)  # gradation: errors of its moments


def test_density_without_forces_has_the_first_half_of_the_formula() -> None:
    """Breaks when `packing` carries contact forces into scenes without them."""
    model = model_of(scene_with(EXAMPLES["packing"]), {"packing"})
    effect = next(effect for effect in CATALOGUE if effect.name == "packing")
    assert effect.bound(model).value == pytest.approx(widest(*(1 / e for e in DENSITY)), rel=1e-11)


# ---- words about the bounds


@pytest.mark.parametrize("sweep", SWEEPS, ids=lambda sweep: sweep.name)
def test_words_on_the_width_of_bounds(sweep) -> None:
    """Breaks when a bound grows: within four of the change, by the static hypothesis three to five times as wide."""
    kinematic, static = ([point for point in points(sweep, one) if point.strength < WEAK] for one in Hypothesis)
    assert all(point.bound < 4 * point.change for point in kinematic)
    if sweep.name != "gradation":
        assert all(3 < wide.bound / point.bound < 5 for point, wide in zip(kinematic, static, strict=True))
    slope = math.log(kinematic[1].bound / kinematic[0].bound) / math.log(kinematic[1].strength / kinematic[0].strength)
    assert slope == pytest.approx(2 if sweep.name == "gradation" else 1, abs=0.02)


def test_gradation_has_its_change_for_a_bound() -> None:
    """Breaks when the sentence on gradation is no longer true; moments are known to 1e-12."""
    sweep = next(sweep for sweep in SWEEPS if sweep.name == "gradation")
    assert all(point.bound == pytest.approx(point.change, abs=1e-11) for point in points(sweep))


# ---- words about the worked example


def test_one_effect_stays_and_four_go() -> None:
    """Breaks when the caption of the choice counts wrong, or something can go at 1e-9."""
    scene = Scene.from_toml(effects.NEARLY)
    outcomes = [one.outcome for one in decisions(scene, effects.LOOSE)]
    assert (outcomes.count(Outcome.SIMULATED), outcomes.count(Outcome.LEFT_OUT)) == (1, 4)
    assert Outcome.LEFT_OUT not in [one.outcome for one in decisions(scene, effects.TIGHT)]


def test_worked_example_shows_both_accuracies() -> None:
    """Breaks when the two columns are exchanged, or the looser accuracy buys nothing."""
    found = {row[0]: row[1:] for row in rows(effects.worked_table())}
    assert found["simulated"][0] == "branches"
    assert found["left out for it"][1] == "-"
    assert found["route"] == ["closed_form", "axial"]
    assert "2.1 times the difference" in effects.worked_difference().text


def test_absent_effects_cost_nothing_on_the_page() -> None:
    """Breaks when an added effect makes less work or loads fewer modules, or an absent one makes any."""
    found = rows(effects.growing_table())
    assert found[-1][1:] == found[-2][1:]
    for column in (3, 5):
        counts = [int(row[column]) for row in found]
        assert counts == sorted(counts)
    assert "`branches`, `gradation`, `packing` and `opening` add no operation" in effects.growing_steps().text
    assert "same bits" in effects.absent_features().text


def test_costs_of_examples_are_those_of_plans() -> None:
    """Breaks when counts with and without an effect are exchanged."""
    found = {row[0]: row for row in rows(effects.examples_table())}
    assert found["slip"][5] == str(plan(scene_with(EXAMPLES["slip"]), rtol=effects.SHOWN_AT).evaluations)
    assert found["slip"][6] == found["kinetic"][5]
    assert found["opening"][4] == "None"
    assert found["opening"][6] == ""


# ---- words about routes


def test_words_on_directions() -> None:
    """Breaks when an accuracy costs another number of directions a digit than the caption says."""
    for name, hypothesis, label, _, _ in DRAWN:
        found = bought(name, hypothesis)
        digits = math.log10(found[0].rtol / found[-1].rtol)
        more = (found[-1].evaluations - found[0].evaluations) / digits
        assert 0.5 < more < 2 if name in ("kinetic", "unequal-branches") else 10 < more < 35, label


def test_the_closed_form_is_not_always_cheaper() -> None:
    """Breaks when the example that the page gives for it is none any more."""
    found = {(row[0], row[1]): row for row in rows(routes.choice_table())}
    closed_form, _, axial, _, chosen = found["contact forces", "1e-06"][2:]
    assert float(closed_form) > float(axial)
    assert chosen == "axial"
    assert found["equal contacts", "1e-06"][-1] == "closed_form"
    assert found["partial slip", "1e-06"][2] == ""


def test_slip_promises_what_was_wanted() -> None:
    """Breaks when the promise for slip is another one than the page says."""
    for row in rows(routes.prediction_table()):
        assert (row[3] == row[1]) == (row[0] == "partial slip")
    assert f"{bought(routes.SLIDING)[0].evaluations} directions" in routes.bought_words().text


def test_named_routes_serve_what_the_page_says() -> None:
    """Breaks when a route serves other scenes than its record, or one without a promise makes one."""
    found = {row[0]: row[1:] for row in rows(routes.by_hand_table())}
    assert found["sphere"][2] == "-"
    assert found["exact"][1:] == ["-"] * 3
    assert all(cell.startswith("none") for cell in found["midpoint"])
    assert "-" not in found["axial"] + found["certified"]


@pytest.mark.parametrize(("name", "scene", "rtol"), [("exact", "contact forces", None),
                                                     ("closed_form", "contact forces", 1e-16),
                                                     ("midpoint", "partial slip", 1e-6)])
def test_refusals_of_the_page_are_refusals(name: str, scene: str, rtol: float | None) -> None:
    """Breaks when a route that the page shows as refused is taken."""
    assert "G-RTE-01" in refused("G-RTE-01", routes.by_route(name, scene, rtol)).text


def test_stored_runs_are_quoted(tmp_path: Path) -> None:
    """Breaks when a sentence on random scenes names other numbers than its file, or is missing where there is none."""
    kept = tmp_path / "promises.json"
    kept.write_text(json.dumps({"scenes": 10000, "rtols": [1e-3, 1e-6], "broken": 0, "promises": 20000, "refused": 7,
                                "command": "granular check --promises 10000"}), encoding="utf-8")
    assert "On 10,000 random scenes at 2 accuracies 0 promises of 20,000" in routes.promises_kept(str(kept)).text
    made = tmp_path / "choices.json"
    made.write_text(json.dumps({"scenes": 300, "near": 1.5, "command": "granular check --choices 300",
                                "all": {"choices": 1200, "share": 0.996, "median": 1.0}}), encoding="utf-8")
    assert "Of 1,200 choices on 300 random scenes 99.6 %" in routes.choices_made(str(made)).text
    for sentence in (routes.promises_kept, routes.choices_made):
        assert "granular check" in sentence(str(tmp_path / "none.json")).text


def test_bounds_are_rounded_up_and_numbers_to_the_nearest() -> None:
    """Breaks when a bound is shown as less than it is."""
    assert (bound(2.01e-7), power(2.01e-7)) == (r"$2.1\cdot10^{-7}$", r"$2.0\cdot10^{-7}$")
    assert (bound(0.241), power(0.241), bound(math.inf), bound(0.0)) == ("0.25", "0.24", "no bound", "0")
    assert power(float(Fraction(1, 1000))) == "$10^{-3}$"
