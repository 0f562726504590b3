"""Examples, sweeps and decisions that pages on effects and routes show, and their figures."""

import importlib.util
import math
from itertools import pairwise
from pathlib import Path

import pytest
from matplotlib.colors import to_hex

import granular
from granular.checks.bought_accuracy import ACCURACIES, bought
from granular.checks.effect_decisions import Outcome, decisions
from granular.checks.effect_examples import (
    ADDED,
    EXAMPLES,
    GROWING,
    PLAIN,
    change_without,
    listing,
    measured,
    relative_change,
    scene_with,
)
from granular.checks.effect_sweeps import STRESS_RATIO, SWEEPS, closest, points, strengths
from granular.checks.random_scenes import random_scenes
from granular.effects import CATALOGUE
from granular.effects.selection import SHARE, select
from granular.figures import files
from granular.figures.bought_accuracy import DRAWN as SCENES
from granular.figures.bought_accuracy import bought_accuracy
from granular.figures.effect_bounds import LOOKS, effect_bounds
from granular.figures.effect_decision import effect_decision
from granular.hypothesis import Hypothesis

spec = importlib.util.spec_from_file_location("figure_rules", Path(__file__).with_name("test_figures.py"))
rules = importlib.util.module_from_spec(spec)
spec.loader.exec_module(rules)
test_no_text_is_small = rules.test_no_text_is_small
test_no_text_is_cut_or_overlaps = rules.test_no_text_is_cut_or_overlaps
test_every_axis_names_its_unit = rules.test_every_axis_names_its_unit

NEARLY = granular.Scene.from_toml(Path(__file__).parents[2] / "book" / "_data" / "nearly_isotropic.toml")
NAMES = tuple(effect.name for effect in CATALOGUE)
SLIDING_AND_OPENED = scene_with(EXAMPLES["opening"], "[grains]\nfriction_coefficient = 0.3")
DRAWN = {"bounds": effect_bounds, "bought": bought_accuracy, "loose": lambda: effect_decision(NEARLY, 1e-3),
         "tight": lambda: effect_decision(NEARLY, 1e-9),
         "opened": lambda: effect_decision(SLIDING_AND_OPENED, 1e-6)}


@pytest.fixture(scope="module", params=DRAWN)
def drawn(request):
    figure = DRAWN[request.param]()
    files.static_bytes(figure, "svg")  # settles the layout
    figure.draw_without_rendering()
    return figure


# ---- examples

def test_a_plain_scene_calls_for_nothing():
    # an effect in the scene that the others are compared with
    assert not select(scene_with()).simulated
    assert PLAIN.count("[") == 3


def test_every_effect_has_an_example_and_only_one_more_comes_along():
    # an effect without an example, or one whose example needs more than it has to
    assert tuple(EXAMPLES) == NAMES
    along = {"packing": {"kinetic"}, "slip": {"kinetic"}, "opening": {"kinetic"}}
    for name in NAMES:
        assert set(select(scene_with(EXAMPLES[name])).simulated) == {name, *along.get(name, ())}


@pytest.mark.parametrize("hypothesis", list(Hypothesis))
@pytest.mark.parametrize("name", [name for name in NAMES if name != "opening"])
def test_examples_change_by_no_more_than_their_bounds(name, hypothesis):
    # a bound of one scene beside the change of another, or with and without exchanged
    found = measured(name, hypothesis=hypothesis)
    assert 0 < found.change <= found.bound.value
    assert name in found.with_it.effects_simulated
    assert name not in found.without_it.effects_simulated


def test_what_has_no_stiffness_without_an_effect_is_said_to_have_none():
    # a number where contacts would carry a tension
    found = measured("opening")
    assert (found.change, found.without_it, found.bound.value) == (None, None, math.inf)


def test_a_list_of_effects_changes_nothing_else():
    # a validator that runs on the copy of a scene and not on the scene, or a list out of order
    for name in NAMES:
        scene = scene_with(EXAMPLES[name])
        listed = listing(scene, select(scene).simulated)
        assert listed.model.effects == tuple(select(scene).simulated)
        assert granular.evaluate(listed).stiffness == granular.evaluate(scene).stiffness


def test_relative_changes_are_those_of_the_worst_component():
    # a mean over components, or the wrong one in the denominator: k_n is the same, and sizes multiply all by one number
    graded, plain = (granular.evaluate(scene_with(*parts)) for parts in ((EXAMPLES["gradation"],), ()))
    change = relative_change(plain, graded)
    assert change == pytest.approx(abs(plain.stiffness.C2323 / graded.stiffness.C2323 - 1), rel=1e-12)
    assert change == pytest.approx(change_without(scene_with(EXAMPLES["gradation"]), "gradation"), rel=1e-12)


def test_the_growing_scene_holds_what_is_added_to_it():
    # an effect that is listed and absent, so that it seems to cost nothing
    assert set(select(scene_with(GROWING)).simulated) == set(ADDED) - {"opening"}


# ---- sweeps

def test_every_effect_that_can_be_weak_is_swept():
    # a new effect without a panel; contacts open or do not
    assert [sweep.name for sweep in SWEEPS] == [name for name in NAMES if name != "opening"]


@pytest.mark.parametrize("hypothesis", list(Hypothesis))
@pytest.mark.parametrize("sweep", SWEEPS, ids=lambda sweep: sweep.name)
def test_no_change_of_a_sweep_is_above_its_bound(sweep, hypothesis):
    # a bound that is none, or one that belongs to another parameter; weak effects grow with their parameter
    found = points(sweep, hypothesis)
    assert all(0 < point.change <= point.bound for point in found)
    assert all(one.bound < other.bound for one, other in pairwise(found) if other.bound < 1)
    assert [point.strength for point in found] == list(strengths(sweep))
    # tests of the bounds allow as much: a static component carries five powers of its integrands
    assert 1 <= closest(sweep, hypothesis) < (15 if hypothesis is Hypothesis.STATIC else 4)


def test_friction_is_used_up_to_the_share_that_is_drawn():
    # kappa of eq. (21) mistaken for its square or its inverse
    sweep = SWEEPS[-1]
    for share in (1e-3, 0.5, 0.999):
        scene = sweep.scene(share)
        tilt = scene.stress.loading(scene.grains.friction).tilt(0.0)
        assert math.sqrt(tilt) == pytest.approx(share, rel=1e-14)
        assert scene.stress.ratio == STRESS_RATIO


# ---- decisions

def test_decisions_are_those_of_the_plan():
    # a story of the choice that is not the choice: random scenes of every kind, many of them with faint effects
    for drawn_at_random in random_scenes(120, seed=5):
        scene = drawn_at_random.scene
        if scene.model.effects != "auto":
            continue
        for rtol in (1e-3, 1e-6):
            made, selection = decisions(scene, rtol), select(scene, rtol=rtol)
            assert [one.name for one in made] == list(reversed(NAMES))
            for outcome, names in ((Outcome.SIMULATED, selection.simulated), (Outcome.LEFT_OUT, selection.spent)):
                assert {one.name for one in made if one.outcome is outcome} == set(names)
            assert {one.name: one.bound for one in made if one.outcome is Outcome.LEFT_OUT} == {
                name: bound.value for name, bound in selection.spent.items()}


def test_the_budget_shrinks_as_it_is_spent():
    # a share that every effect may spend anew
    made = decisions(NEARLY, 1e-3)
    assert made[0].rest == SHARE * 1e-3
    assert all(other.rest <= one.rest for one, other in pairwise(made))
    assert made[-1].rest < 0.8 * SHARE * 1e-3  # slip alone spends a sixth


# ---- accuracy

@pytest.mark.parametrize("name, hypothesis", [scene[:2] for scene in SCENES])
def test_accuracy_is_bought_with_directions(name, hypothesis):
    # a rule that is as fine for every accuracy, or an error above the promise
    found = bought(name, hypothesis)
    assert [one.rtol for one in found] == list(ACCURACIES)
    assert all(one.error <= one.promised <= one.rtol for one in found)
    assert all(one.evaluations <= other.evaluations and one.operations <= other.operations
               for one, other in pairwise(found))
    assert found[-1].evaluations > 1.5 * found[0].evaluations


# ---- figures

def test_bounds_are_lines_and_changes_are_marks():
    # curves under the colour of the other hypothesis, or bounds drawn as changes
    for panel, sweep in zip(effect_bounds().axes, SWEEPS, strict=True):
        for hypothesis, (colour, _) in LOOKS.items():
            bound, change = (line for line in panel.lines if to_hex(line.get_color()) == colour)
            found = points(sweep, hypothesis)
            assert list(change.get_ydata()) == [point.change for point in found]
            assert list(bound.get_ydata()) == [point.bound for point in found if math.isfinite(point.bound)]
            dashes = "--" if hypothesis is Hypothesis.STATIC else "-"
            assert (bound.get_linestyle(), change.get_linestyle()) == (dashes, "None")


def test_the_picture_of_the_choice_says_what_is_decided():
    # an outcome beside the name of another effect
    axes = effect_decision(NEARLY, 1e-3).axes[0]
    heights = {text.get_text(): text.get_position()[1] for text in axes.texts if text.get_text() in NAMES}
    outcomes = {text.get_position()[1]: text.get_text() for text in axes.texts if text.get_text() in list(Outcome)}
    assert {name: outcomes[height] for name, height in heights.items()} == {
        one.name: one.outcome for one in decisions(NEARLY, 1e-3)}
