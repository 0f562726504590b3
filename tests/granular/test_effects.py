"""Effects: what a scene calls for, decided exactly, and what of the scene each of them carries."""

from __future__ import annotations

import importlib
import math
from copy import deepcopy
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

import granular.effects
from granular.effects import CATALOGUE, Called, Effect, selection
from granular.effects.selection import LEFT_OUT, SHARE, rounded_up, select
from granular.errors import ConflictingKeys, MissingKey
from granular.fabric import AxialFabric
from granular.loading import Loading
from granular.scene import EFFECT_NAMES, Scene

BY_NAME = {effect.name: effect for effect in CATALOGUE}
SOUND = {
    "grains": {"shear_modulus": "31 GPa", "poisson_ratio": 0.21},
    "packing": {"void_ratio": 0.5744},
    "stress": {"mean": "28 kPa"},
}


def scene(D33=0.0, ratio=1.0, **tables):
    content = deepcopy(SOUND)
    content["packing"]["contact_normals"] = {"D33": D33}
    content["stress"]["ratio"] = ratio
    for name, table in tables.items():
        content[name] = {**content.get(name, {}), **table}
    return Scene.model_validate(content)


def called(name, *args, **tables):
    return BY_NAME[name].called_for(scene(*args, **tables)).wanted


def test_the_catalogue_names_all_effects_of_the_scene_file():
    # Breaks when an effect is added to one of the two lists only.
    assert tuple(BY_NAME) == EFFECT_NAMES


def test_every_file_of_the_package_is_in_the_catalogue():
    # Breaks when an effect has a file and no line in the catalogue.
    files = {path.stem for path in Path(granular.effects.__file__).parent.glob("*.py")}
    assert files - {"__init__", "bound", "effect", "forms", "ranges", "selection"} == set(EFFECT_NAMES)
    for name in EFFECT_NAMES:
        assert importlib.import_module(f"granular.effects.{name}").EFFECT is BY_NAME[name]


@pytest.mark.parametrize("effect", CATALOGUE, ids=list(BY_NAME))
def test_every_effect_describes_itself(effect):
    # Breaks when a record is incomplete: the book and the messages show these texts.
    assert effect.title and effect.equations and effect.without
    assert effect.called_for(scene()).reason
    assert not effect.called_for(scene()).wanted


@pytest.mark.parametrize("effect", CATALOGUE, ids=list(BY_NAME))
def test_every_effect_carries_something(effect):
    # Breaks when an effect is in the catalogue and changes nothing of what is computed.
    assert any((effect.add_to_fabric, effect.add_to_loading, effect.sizes))


EXACT = [(-1.0, 0.5), (0.0, 1.0), (1.0, 1.75), (2.0, 3.0), (0.5, 4 / 3)]


@pytest.mark.parametrize(("D33", "ratio"), EXACT[:-1])
def test_uniform_force_is_found_exactly(D33, ratio):
    # Breaks when a = c is decided in floats: there 5 (SR - 1) = D (SR + 2) holds to the last bit.
    assert not called("kinetic", D33, ratio)
    assert not called("slip", D33, ratio, grains={"friction_coefficient": 0.2})


@pytest.mark.parametrize(("D33", "ratio"), EXACT)
def test_one_unit_of_the_last_place_away_is_called_for(D33, ratio):
    # Breaks when a tolerance hides a small kinetic fabric: what is called for is never left out silently.
    assert called("kinetic", D33, math.nextafter(ratio, math.inf))
    assert called("kinetic", D33, math.nextafter(ratio, 0.0))


def test_a_ratio_that_no_double_holds_is_called_for():
    # Breaks when "equal in floats" passes: D = 1/2 needs SR = 4/3.
    assert called("kinetic", 0.5, 4 / 3)


def test_stress_tensor_and_ratio_decide_alike():
    # Breaks when the principal stresses of a tensor are divided in floats before they are compared.
    tensor = [[4.0, 0, 0], [0, 4.0, 0], [0, 0, 7.0]]
    content = {**SOUND, "packing": {"void_ratio": 0.5, "contact_normals": {"D33": 1.0}}, "stress": {"tensor": tensor}}
    assert not BY_NAME["kinetic"].called_for(Scene.model_validate(content)).wanted
    tensor[2][2] = math.nextafter(7.0, 8.0)
    assert BY_NAME["kinetic"].called_for(Scene.model_validate(content)).wanted


@given(st.floats(-1.0, 2.0), st.floats(0.0, 1e300))
def test_every_stress_has_a_reason(D33, ratio):
    # Breaks when extreme ratios overflow while the reason is put into words.
    for effect in CATALOGUE:
        assert isinstance(effect.called_for(scene(D33, ratio)).reason, str)


@pytest.mark.parametrize(("name", "tables", "wanted"), [
    ("packing", {"packing": {"contact_normals": {"D33": 0.0, "D3333": 0.1}}}, True),
    ("packing", {"packing": {"contact_normals": {"D33": -0.0, "D3333": 0.0}}}, False),
    ("branches", {"branches": {"anisotropy": {"D33": 5e-324}}}, True),
    ("branches", {"branches": {"length_ratio": 1.2}}, False),
    ("gradation", {"gradation": {"distribution": "lognormal", "median": 1.0, "spread": 1.0000000000000002}}, True),
    ("deviation", {"shape": {"aspect_ratio": 0.8}}, True),
    ("deviation", {"shape": {"aspect_ratio": 1.0}}, False),
    ("slip", {"grains": {"friction_coefficient": 0.2}}, False),
    ("slip", {"grains": {"friction_coefficient": 0.2}, "stress": {"ratio": 1.5}}, True),
    ("slip", {"stress": {"ratio": 1.5}}, False),
    ("slip", {"grains": {"friction_coefficient": 0.0}}, True),
    ("slip", {"grains": {"friction_angle": "0 deg"}}, True),
    ("opening", {"stress": {"ratio": 0.0}}, False),
    ("opening", {"stress": {"mean": None, "tensor": [[1, 0, 0], [0, 1, 0], [0, 0, -1e-300]]}}, True),
    ("opening", {"stress": {"mean": None, "tensor": [[-1, 0, 0], [0, -1, 0], [0, 0, 3]]}}, True),
])
def test_called_for(name, tables, wanted):
    # Breaks when an effect is called for by anything but the feature it stands for.
    content = deepcopy(SOUND)
    for table, keys in tables.items():
        content.setdefault(table, {}).update(keys)
    assert BY_NAME[name].called_for(Scene.model_validate(content)).wanted is wanted


def test_horizontal_tension_opens_contacts():
    # Breaks when only the pole is looked at, or a force that just vanishes is taken for a tension.
    content = {**SOUND, "stress": {"tensor": [[-1, 0, 0], [0, -1, 0], [0, 0, 3.0]]}}
    opening = BY_NAME["opening"].called_for(Scene.model_validate(content))
    assert opening == Called(True, "the estimated normal force is a tension around the equator")
    content["stress"] = {"tensor": [[0, 0, 0], [0, 0, 0], [0, 0, 3.0]]}
    assert not BY_NAME["opening"].called_for(Scene.model_validate(content)).wanted


# ---- selection


def test_auto_simulates_what_is_called_for():
    # Breaks when auto simulates more, or less, than the scene calls for.
    chosen = select(scene(branches={"anisotropy": {"D33": -0.3}}))
    assert list(chosen.simulated) == ["branches"]
    assert set(chosen.not_called_for) == set(EFFECT_NAMES) - {"branches"}
    assert chosen.fabric == AxialFabric(Dr33=-0.3)


def test_a_list_is_honoured():
    # Breaks when an anisotropy that the list leaves out is still simulated, or its loss is not reported.
    chosen = select(scene(0.3, branches={"anisotropy": {"D33": -0.3}}, model={"effects": ["packing"]}))
    assert chosen.fabric == AxialFabric(D33=0.3)
    assert list(chosen.simulated) == ["packing"]
    assert chosen.not_called_for["branches"].startswith(LEFT_OUT)
    assert chosen.not_called_for["kinetic"].startswith(LEFT_OUT)
    assert not chosen.not_called_for["opening"].startswith(LEFT_OUT)


def test_an_empty_list_is_the_ideal_assembly():
    # Breaks when an empty list is taken for "auto".
    chosen = select(scene(0.3, 2.0, model={"effects": []}))
    assert chosen.fabric == AxialFabric()
    assert chosen.simulated == {}


SIZES = {"distribution": "lognormal", "median": "5 mm", "spread": 1.5}


def test_sizes_and_shape_are_carried_together():
    # Breaks when one of the two loses the other, or a spin is forgotten on the way.
    chosen = select(scene(0.3, gradation=SIZES, shape={"aspect_ratio": 0.8, "spin": "relaxed"}))
    assert list(chosen.simulated) == ["packing", "gradation", "deviation", "kinetic"]
    assert chosen.fabric == AxialFabric(D33=0.3, aspect_ratio=0.8, free_spin=True)
    assert chosen.sizes is not None
    assert chosen.sizes.uniformity == pytest.approx(1.863, abs=5e-4)  # to the digits of the table of the normal law


def test_sizes_and_shape_can_be_left_out():
    # Breaks when a list keeps what it leaves out, or does not say what that means.
    chosen = select(scene(gradation=SIZES, shape={"aspect_ratio": 0.8}, model={"effects": []}))
    assert (chosen.fabric, chosen.sizes) == (AxialFabric(), None)
    assert "all grains then have one size" in chosen.not_called_for["gradation"]
    assert "taken as spheres" in chosen.not_called_for["deviation"]


def test_spheres_that_spin_call_for_the_deviation():
    # Breaks when free spin is simulated for spheroids only: the contacts of spheres turn with them as well.
    chosen = select(scene(0.3, shape={"aspect_ratio": 1.0, "spin": "relaxed"}))
    assert "deviation" in chosen.simulated
    assert chosen.fabric.free_spin


@pytest.mark.parametrize(("listed", "tables", "kind", "parts"), [
    (["slip"], {"grains": {"friction_angle": "12 deg"}}, ConflictingKeys, ["slip without kinetic", "Add kinetic"]),
    (["opening"], {}, ConflictingKeys, ["opening without kinetic"]),
    (["kinetic", "slip"], {}, MissingKey, ["friction_angle", "slip"]),
    (["gradation"], {}, MissingKey, ["gradation", "no grain sizes", "Add [gradation]"]),
    (["kinetic"], {"stress": {"mean": None, "tensor": [[1, 0, 0], [0, 1, 0], [0, 0, -1]]}}, ConflictingKeys,
     ["kinetic without opening", "Add opening"]),
])
def test_a_list_that_contradicts_itself_is_refused(listed, tables, kind, parts):
    # Breaks when a cube root of a negative force, or slip without friction, is computed as if nothing were wrong.
    content = deepcopy(SOUND) | {"model": {"effects": listed}}
    for table, keys in tables.items():
        content[table].update(keys)
    with pytest.raises(kind) as refused:
        select(Scene.model_validate(content))
    assert all(part in str(refused.value) for part in parts)


def test_contact_forces_reach_the_loading():
    # Breaks when kinetic brings friction along, or slip forgets the stress.
    given = scene(0.3, 1.5, grains={"friction_coefficient": 0.2})
    assert select(given).loading == Loading.of_ratio(1.5, friction=0.2)
    only_kinetic = select(scene(0.3, 1.5, grains={"friction_coefficient": 0.2}, model={"effects": ["kinetic"]}))
    assert only_kinetic.loading == Loading.of_ratio(1.5)
    assert only_kinetic.fabric == AxialFabric()
    assert select(scene(0.3, model={"effects": ["packing"]})).loading is None


def test_no_friction_at_all_slips_without_shear_forces():
    # Breaks when slip is simulated without the contact forces that it needs.
    chosen = select(scene(0.0, 1.0, grains={"friction_coefficient": 0.0}))
    assert list(chosen.simulated) == ["kinetic", "slip"]
    assert chosen.simulated["kinetic"] == "slip needs it"


NEARLY = {"packing": {"contact_normals": {"D33": 1e-8}}, "branches": {"anisotropy": {"D33": -1e-8}},
          "stress": {"ratio": 1 + 1e-8}, "grains": {"friction_coefficient": 0.3}}
"""Every effect of branches along the normals, and each of them next to nothing."""


def test_a_wanted_accuracy_leaves_out_what_it_cannot_tell():
    # Breaks when a negligible effect is simulated under a loose accuracy, or left out under none or a strict one.
    nearly = scene(**{**NEARLY, "gradation": {"distribution": "lognormal", "median": 1.0, "spread": 1.0001}})
    everything = ["packing", "branches", "gradation", "kinetic", "slip"]
    assert list(select(nearly).simulated) == everything
    assert list(select(nearly, rtol=1e-10).simulated) == everything
    loose = select(nearly, rtol=1e-5)
    assert loose.simulated == {}
    assert (loose.fabric, loose.loading, loose.sizes) == (AxialFabric(), None, None)
    assert 0 < loose.left_out_error <= SHARE * 1e-5
    for name in everything:
        assert loose.not_called_for[name] == (f"would change no component by more than "
                                              f"{rounded_up(loose.bounds[name])}, within its share of rtol = 1e-05")


def test_a_list_is_never_cut():
    # Breaks when what a scene lists is left out for an accuracy.
    listed = scene(**NEARLY, model={"effects": ["packing", "branches"]})
    assert list(select(listed, rtol=0.5).simulated) == ["packing", "branches"]
    assert select(listed, rtol=0.5).left_out_error == 0.0


def test_what_saves_most_goes_first_and_what_it_needs_after_it():
    # Breaks when kinetic goes before slip, or the budget is spent on the density of normals while slip stays.
    nearly = scene(**NEARLY)
    together = select(nearly, rtol=1e-5)
    assert list(together.spent) == ["slip", "kinetic", "branches", "packing"]
    order = select(nearly, rtol=2.001 * together.spent["slip"].value)
    assert list(order.spent) == ["slip"]
    assert list(order.simulated) == ["packing", "branches", "kinetic"]
    assert order.loading == Loading.of_ratio(1 + 1e-8)
    sliding = scene(**{**NEARLY, "grains": {"friction_coefficient": 1e-9}})
    assert "kinetic" in select(sliding, rtol=1e-3).simulated


def test_bounds_of_several_effects_are_put_together():
    # Breaks when the sum is taken where changes come one upon the other, or the budget is exceeded by it.
    loose = select(scene(1e-3, branches={"anisotropy": {"D33": 1e-3}}), rtol=0.5)
    product = math.prod(1 + bound.value for bound in loose.spent.values())
    assert len(loose.spent) == 3
    assert product - 1 <= loose.left_out_error <= (product - 1) * (1 + 1e-12)  # rounding of the product above


def test_leaving_an_effect_out_takes_along_what_needs_it():
    # Breaks when kinetic gets a bound, or a cost, beside slip that stays without it.
    chosen = select(scene(0.0, 1.001, grains={"friction_coefficient": 0.3}))
    assert chosen.without_effect("kinetic") == set()
    assert chosen.with_effect("slip") == {"kinetic", "slip"}
    assert chosen.bounds["kinetic"] > chosen.bounds["slip"] > 0
    alone = select(scene(0.0, 1.001))
    assert chosen.bounds["kinetic"] == pytest.approx((1 + chosen.bounds["slip"]) * (1 + alone.bounds["kinetic"]) - 1)


def test_what_excludes_each_other_has_no_scene():
    # Breaks when a record excludes an effect that a scene may well have beside it, or on one side only.
    pairs = {(effect.name, other) for effect in CATALOGUE for other in effect.excludes}
    assert pairs == {("branches", "deviation"), ("deviation", "branches")}
    with pytest.raises(ConflictingKeys):
        scene(branches={"anisotropy": {"D33": 0.1}}, shape={"aspect_ratio": 0.9})


@pytest.mark.parametrize("effect", CATALOGUE, ids=list(BY_NAME))
def test_an_absent_effect_changes_nothing(effect):
    # Breaks when the bound of an effect that is listed and absent is not zero.
    if effect.name in ("slip", "gradation"):  # they need data to be listed
        return
    absent = scene(model={"effects": sorted({effect.name, *effect.requires})})
    assert select(absent).bounds[effect.name] == 0.0


def test_a_new_effect_is_one_record(monkeypatch):
    # Breaks when the selection knows an effect by name: one more record must be enough to be simulated.
    flat = Effect(name="flat", title="t", equations="e", without="w",
                  called_for=lambda given: Called(given.stress.mean_stress > 1, "pressed"),
                  add_to_fabric=lambda _, fabric: replace(fabric, Dr33=1.0))
    monkeypatch.setattr(selection, "CATALOGUE", (*CATALOGUE, flat))
    chosen = select(scene(0.0))
    assert chosen.simulated == {"flat": "pressed"}
    assert chosen.fabric == AxialFabric(Dr33=1.0)
