"""Plans: which route, what it promises, and what is refused before anything is computed."""

from __future__ import annotations

import json
import math
import re
from copy import deepcopy

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import granular
from granular import errors
from granular.error_budget import COARSE, SCALING_ERROR, remaining, route_accuracy, with_left_out
from granular.planning import plan
from granular.routes.catalogue import AUTO, MOST_ACCURATE, ROUTES
from granular.scene import Scene

SOUND = {
    "grains": {"shear_modulus": "31 GPa", "poisson_ratio": 0.21},
    "packing": {"void_ratio": 0.5744},
    "stress": {"mean": "28 kPa"},
}
STEEP = 1.9
"""A branch anisotropy whose static moments the emitted series does not cover: w1/w0 = 58."""


def scene(D33=0.0, Dr33=0.0, hypothesis="kinematic", **model):
    content = deepcopy(SOUND)
    content["packing"]["contact_normals"] = {"D33": D33}
    content["branches"] = {"anisotropy": {"D33": Dr33}}
    content["model"] = {"hypothesis": hypothesis, "effects": ["packing", "branches"], **model}
    return Scene.model_validate(content)


SERVED = [(name, hypothesis) for name in ROUTES for hypothesis in ("kinematic", "static")
          if (name, hypothesis) != ("exact", "static") and name != "midpoint"]
"""Every route that promises something, under every hypothesis; static components are not rational."""


def test_auto_takes_the_closed_form_where_it_covers():
    # Breaks when a cheaper route that covers the fabric is passed over.
    decided = plan(scene(0.3, -0.3))
    assert (decided.route, decided.evaluations) == ("closed_form", 0)
    assert "closed form" in decided.route_reason


def test_auto_falls_back_to_the_axial_rule():
    # Breaks when a fabric outside the static closed form is answered by it, or by nothing.
    assert plan(scene(0.3, STEEP)).route == "closed_form"
    decided = plan(scene(0.3, STEEP, "static"))
    assert decided.route == "axial"
    assert decided.evaluations > 0
    assert "closed_form does not" in decided.route_reason


@given(st.floats(-1.0, 2.0), st.floats(-1.0, 2.0, exclude_min=True, exclude_max=True),
       st.sampled_from(["kinematic", "static"]))
def test_every_fabric_has_a_route(D33, Dr33, hypothesis):
    # Breaks when the last automatic route refuses an admissible fabric, the boundary included.
    decided = plan(scene(D33, Dr33, hypothesis))
    assert decided.route in AUTO
    assert 0 < decided.relative_error < 1e-14


def test_a_plan_explains_every_effect():
    # Breaks when an effect is neither simulated nor explained.
    decided = plan(scene(0.3))
    assert set(decided.called_for) == set(decided.effects_simulated) == {"packing", "branches"}
    assert not set(decided.called_for) & set(decided.effects_not_called_for)
    assert len(decided.called_for) + len(decided.effects_not_called_for) == 7
    assert all(decided.effects_not_called_for.values())


@pytest.mark.parametrize("name", list(ROUTES))
def test_routes_can_be_asked_for(name):
    # Breaks when a route of the catalogue cannot be named, or names another module.
    decided = plan(scene(0.3, -0.3), route=name)
    assert decided.route == name
    assert decided.relative_error > SCALING_ERROR


@pytest.mark.parametrize(("name", "hypothesis"), SERVED)
def test_a_promise_is_kept(name, hypothesis):
    # Breaks when the predicted cost or accuracy is not the one that the evaluation then reports.
    for wanted in (None, 1e-3, 1e-11):
        decided = plan(scene(0.3, -0.3, hypothesis), route=name, rtol=wanted)
        result = granular.evaluate(scene(0.3, -0.3, hypothesis), route=name, rtol=wanted)
        assert result.evaluations == decided.evaluations
        # a coarse rule's bound grows when C1212 is tied to C1111 and C1122, by 5/4 at the most
        assert decided.relative_error <= result.relative_error <= 1.25 * decided.relative_error
        assert wanted is None or result.relative_error <= wanted


def test_the_wanted_accuracy_comes_from_the_scene_or_the_call():
    # Breaks when an argument does not win over the scene.
    assert plan(scene(rtol=1e-6)).rtol == 1e-6
    assert plan(scene(rtol=1e-6), rtol=1e-9).rtol == 1e-9
    assert plan(scene()).rtol is None


def test_the_historical_rule_promises_nothing():
    # Breaks when the rule of the printed tables is handed out for an accuracy, or has no cost.
    decided = plan(scene(0.3, -0.3), route="midpoint")
    assert (decided.relative_error, decided.evaluations) == (math.inf, 24)
    assert granular.evaluate(scene(0.3, -0.3), route="midpoint").relative_error == math.inf
    with pytest.raises(errors.RouteOutOfDomain, match="promises no accuracy"):
        plan(scene(0.3, -0.3), route="midpoint", rtol=0.5)


@pytest.mark.parametrize("name", ["auto", *(name for name in ROUTES if name != "midpoint")])
@pytest.mark.parametrize("wanted", [1e-20, 1e-17, 5e-324])
def test_more_than_is_promised_is_refused(name, wanted):
    # Breaks when a result is handed out that is worse than what was asked for; the remedy must work.
    tilted = scene(0.3, -0.3, "kinematic" if name == "exact" else "static")
    with pytest.raises(errors.RouteOutOfDomain, match="rtol") as refused:
        plan(tilted, rtol=wanted, route=name)
    asked = float(refused.value.remedy.split("rtol = ")[1].split(",")[0].rstrip("."))
    assert plan(tilted, rtol=asked, route=name).relative_error <= asked
    assert (MOST_ACCURATE in refused.value.remedy) == (name != MOST_ACCURATE)


@given(st.sampled_from(SERVED), st.floats(1e-17, 0.5))
def test_accepted_means_kept(served, wanted):
    # Breaks when an accuracy is accepted by the plan and refused, or missed, by the route.
    name, hypothesis = served
    try:
        decided = plan(scene(0.3, -0.3, hypothesis), rtol=wanted, route=name)
    except errors.RouteOutOfDomain:
        return
    assert decided.relative_error <= wanted
    assert granular.evaluate(scene(0.3, -0.3, hypothesis), rtol=wanted, route=name).relative_error <= wanted


def test_equality_is_accepted():
    # Breaks when the declared bound itself is refused because a subtraction was rounded.
    bound = plan(scene(0.3, -0.3, "static")).relative_error
    assert granular.evaluate(scene(0.3, -0.3, "static"), rtol=bound).relative_error <= bound


@pytest.mark.parametrize(("stress", "kept"), [
    ({"mean": "28 kPa", "ratio": 4.0}, ["packing", "kinetic"]),
    ({"tensor": [[1, 0, 0], [0, 1, 0], [0, 0, -0.5]]}, ["packing"])])
def test_an_infinite_compliance_says_what_to_leave_out(stress, kept):
    # Breaks when the remedy leaves the compliance infinite, or leaves out more than it must.
    content = deepcopy(SOUND) | {"stress": stress, "model": {"hypothesis": "static"}}
    content["grains"]["friction_angle"] = "12 deg"
    content["packing"]["contact_normals"] = {"D33": 0.3}
    with pytest.raises(errors.ComplianceInfinite) as refused:
        plan(Scene.model_validate(content))
    effects = json.loads(re.search(r"effects = (\[.*?\])", refused.value.remedy)[1])
    assert effects == kept
    content["model"]["effects"] = effects
    assert granular.evaluate(Scene.model_validate(content)).effects_simulated == tuple(kept)


def test_a_route_that_does_not_serve_the_fabric_is_refused():
    # Breaks when the static closed form answers outside its series.
    with pytest.raises(errors.RouteOutOfDomain, match=r"closed_form .*static.*axial"):
        plan(scene(0.3, STEEP, "static"), route="closed_form")
    with pytest.raises(errors.RouteOutOfDomain, match="sphere"):
        plan(scene(0.3, 1.999999, "static"), route="sphere")
    with pytest.raises(errors.RouteOutOfDomain, match=r"exact .*static"):
        plan(scene(0.3, 0.0, "static"), route="exact")


@pytest.mark.parametrize(("options", "kind"), [
    ({"route": "axil"}, errors.UnknownChoice), ({"route": ""}, errors.UnknownChoice),
    ({"route": None}, errors.WrongType), ({"rtol": 0}, errors.ValueOutOfRange),
    ({"rtol": -1e-9}, errors.ValueOutOfRange), ({"rtol": 1}, errors.ValueOutOfRange),
    ({"rtol": math.nan}, errors.NotFinite), ({"rtol": math.inf}, errors.NotFinite),
    ({"rtol": "1e-9"}, errors.WrongType), ({"rtol": True}, errors.WrongType),
])
def test_bad_options(options, kind):
    # Breaks when a misspelt option is taken for a default.
    with pytest.raises(kind):
        plan(scene(), **options)


@pytest.mark.parametrize("thing", ["scene.toml", None, SOUND])
def test_only_scenes_are_planned(thing):
    # Breaks when a path or a dict gets an AttributeError instead of the way to make a scene of it.
    with pytest.raises(errors.WrongType, match=r"Scene\.from_toml"):
        plan(thing)


@given(st.floats(1e-15, 0.999))
def test_the_route_gets_what_the_last_steps_leave(rtol):
    # Breaks when the error of scaling, or of tying C1212, is not taken off the wanted accuracy.
    left, tied = route_accuracy(rtol), route_accuracy(rtol, keeps_axis=False)
    assert left + SCALING_ERROR <= rtol * (1 + 2.0**-52)
    assert tied == left if rtol <= COARSE else 1.25 * tied < rtol


# ---- effects that a wanted accuracy cannot tell


def next_to_nothing(power, **tables):
    size = 10.0**power
    content = deepcopy(SOUND) | {"stress": {"mean": "28 kPa", "ratio": 1 + size}}
    content["grains"]["friction_coefficient"] = 0.3
    content["packing"]["contact_normals"] = {"D33": -size, "D3333": size / 2}
    content["gradation"] = {"distribution": "lognormal", "median": 1.0, "spread": 1 + size}
    return Scene.model_validate(content | tables)


@settings(deadline=None)
@given(st.floats(-13, -2), st.floats(-13, -0.5), st.sampled_from(["kinematic", "static"]),
       st.sampled_from([{"branches": {"anisotropy": {"D33": 1e-5}}}, {"shape": {"aspect_ratio": 1.00001}}]))
def test_what_was_left_out_is_part_of_the_error(power, accuracy, hypothesis, branches):
    # Breaks when the error of a result is that of its route alone, or exceeds what was asked for.
    given_scene = next_to_nothing(power, **branches, model={"hypothesis": hypothesis})
    wanted, full = 10.0**accuracy, granular.evaluate(given_scene)
    decided, result = plan(given_scene, rtol=wanted), granular.evaluate(given_scene, rtol=wanted)
    assert decided.left_out_error <= wanted / 2
    assert decided.relative_error <= result.relative_error <= wanted
    assert result.evaluations == decided.evaluations
    for name, value in full.stiffness.components.items():
        true = abs(result.stiffness.components[name] - value) / value
        assert true <= result.relative_error + full.relative_error


def test_leaving_out_buys_evaluations():
    # Breaks when the smaller model is computed as the larger one, or without an accuracy anything is left out.
    nearly = next_to_nothing(-6)
    assert plan(nearly).left_out_error == 0.0
    assert plan(nearly).evaluations > 0 < plan(nearly, rtol=1e-9).evaluations
    assert plan(nearly, rtol=1e-3).evaluations == 0
    assert granular.evaluate(nearly, rtol=1e-3).evaluations == 0


def test_an_accuracy_is_not_refused_for_what_was_left_out():
    # Breaks when effects spend what the route needs, while the whole scene could be had as accurately.
    nearly = scene(0.3, 1e-16, effects="auto")
    bound = plan(nearly).relative_error
    assert plan(nearly, rtol=bound).relative_error <= bound
    assert plan(nearly, rtol=1e-13).left_out_error > 0


def test_the_remainder_and_the_left_out_make_up_the_wanted_accuracy():
    # Breaks when the route is given more than is left.
    assert remaining(1e-6, 0.0) == 1e-6
    assert remaining(None, 0.0) is None
    assert with_left_out(remaining(1e-3, 4e-4), 4e-4) <= 1e-3
    assert with_left_out(1e-15, 0.0) == 1e-15
    assert with_left_out(0.5, 0.5) == 1.25


@pytest.mark.parametrize("name", ["auto", "axial"])
@pytest.mark.parametrize("hypothesis", ["kinematic", "static"])
def test_costs_are_those_of_the_models_with_and_without(name, hypothesis):
    # Breaks when the cost of an effect is not what evaluating with it and without it counts.
    content = deepcopy(SOUND) | {"stress": {"mean": "28 kPa", "ratio": 1.1}, "shape": {"aspect_ratio": 0.9}}
    content["grains"]["friction_angle"] = "20 deg"
    content["packing"]["contact_normals"] = {"D33": 0.3}
    without = {"packing": ["deviation", "kinetic", "slip"], "deviation": ["packing", "kinetic", "slip"],
               "kinetic": ["packing", "deviation"], "slip": ["packing", "deviation", "kinetic"]}

    def counted(effects):
        content["model"] = {"hypothesis": hypothesis, "effects": effects}
        return granular.evaluate(Scene.model_validate(content), route=name).evaluations

    whole = counted("auto")
    content["model"] = {"hypothesis": hypothesis}
    costs = plan(Scene.model_validate(content), route=name).costs
    assert costs == {effect: (whole, counted(rest)) for effect, rest in without.items()}


def test_a_list_shows_what_it_leaves_out_at_its_cost():
    # Breaks when an effect that the list leaves out has no bound and no cost in the plan.
    content = deepcopy(SOUND) | {"stress": {"mean": "28 kPa", "ratio": 1.1}, "model": {"effects": []}}
    decided = plan(Scene.model_validate(content), route="axial")
    content["model"]["effects"] = ["kinetic"]
    listed = plan(Scene.model_validate(content), route="axial")
    assert decided.costs["kinetic"] == (listed.evaluations, decided.evaluations) == listed.costs["kinetic"]
    assert 0 < decided.bounds["kinetic"] < 0.1


def test_a_model_without_a_stiffness_has_no_cost():
    # Breaks when the plan of a scene fails for another scene, whose contacts slide under the static hypothesis.
    content = deepcopy(SOUND) | {"stress": {"mean": "28 kPa", "ratio": 2.0}}
    content["grains"]["friction_angle"] = "12 deg"
    content["model"] = {"hypothesis": "static", "effects": ["kinetic"]}
    decided = plan(Scene.model_validate(content))
    assert decided.costs["slip"] is None
    assert decided.bounds["slip"] == math.inf


def test_the_public_names_are_functions():
    # Breaks when a submodule of the same name hides granular.plan or granular.evaluate.
    assert callable(granular.plan)
    assert callable(granular.evaluate)
