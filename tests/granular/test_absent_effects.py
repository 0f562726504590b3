"""An effect that a scene does not call for costs nothing: no module is imported, no direction added, no bit changed.

Modules are counted in fresh interpreters, not seconds: a time would be a verdict on the machine.
"""

from __future__ import annotations

import importlib.util
import json
import subprocess
import sys
from copy import deepcopy

import pytest

import granular
from granular.effects import CATALOGUE
from granular.scene import Scene

SOUND = {
    "grains": {"shear_modulus": "31 GPa", "poisson_ratio": 0.21},
    "packing": {"void_ratio": 0.5744},
    "stress": {"mean": "28 kPa"},
}
FORCES = {"stress": {"ratio": 1.2}}
FRICTION = {"grains": {"friction_coefficient": 0.3}}
PULLED = {"stress": {"tensor": [[3.0, 0, 0], [0, 3.0, 0], [0, 0, -0.5]], "mean": None}}
LOGNORMAL = {"gradation": {"distribution": "lognormal", "median": "5 mm", "spread": 1.5}}
SPHEROIDS = {"shape": {"aspect_ratio": 0.8}}
LENGTHS = {"branches": {"anisotropy": {"D33": -0.3}}}
NORMALS = {"packing": {"contact_normals": {"D33": 0.3}}}


def content(*parts):
    whole = deepcopy(SOUND)
    for part in parts:
        for table, keys in part.items():
            whole[table] = {**whole.get(table, {}), **keys}
    return whole


def scene(*parts):
    return Scene.model_validate(content(*parts))


# ---- modules

SCENES = {
    "ideal": [], "fabric": [NORMALS, LENGTHS], "forces": [NORMALS, FORCES], "slip": [FORCES, FRICTION],
    "opening": [PULLED], "opening with slip": [PULLED, FRICTION], "sizes": [LOGNORMAL], "shape": [SPHEROIDS],
    "shape with forces": [SPHEROIDS, FORCES], "friction without shear forces": [FRICTION, LENGTHS],
    "branches with forces": [LENGTHS, FORCES],
}
REPORT = """
import json, sys
import granular
from granular.scene import Scene
result = granular.evaluate(Scene.model_validate(json.loads(sys.argv[1])), rtol=json.loads(sys.argv[2]))
json.dump([list(result.effects_simulated), sorted(name for name in sys.modules if name.startswith("granular."))],
          sys.stdout)
"""


@pytest.mark.parametrize(("parts", "hypothesis", "rtol"), [
    *((name, "kinematic", None) for name in SCENES), ("fabric", "static", None), ("forces", "static", None),
    ("shape", "static", None), ("slip", "static", 1e-6), ("forces", "kinematic", 1e-3)])
def test_a_scene_without_an_effect_imports_none_of_its_modules(parts, hypothesis, rtol):
    # Breaks when a module of an effect is imported for scenes without it, or its list names modules that are not used.
    whole = content(*SCENES[parts], {"model": {"hypothesis": hypothesis}})
    done = subprocess.run([sys.executable, "-c", REPORT, json.dumps(whole), json.dumps(rtol)], capture_output=True,
                          text=True, check=True, timeout=60)
    simulated, loaded = json.loads(done.stdout)
    for effect in CATALOGUE:
        if effect.name in simulated:
            assert not effect.modules or set(effect.modules) & set(loaded), effect.name
        else:
            assert not set(effect.modules) & set(loaded), effect.name


@pytest.mark.parametrize("effect", CATALOGUE, ids=lambda effect: effect.name)
def test_modules_of_effects_exist(effect):
    # Breaks when a module was renamed, so that nothing watches it any more.
    assert all(importlib.util.find_spec(name) for name in effect.modules)


# ---- bits

ABSENT = {
    "spheres": {"shape": {"aspect_ratio": 1.0}},
    "branches of one length": {"branches": {"anisotropy": {"D33": 0.0}}},
    "isotropic normals": {"packing": {"contact_normals": {"D33": 0.0, "D3333": 0.0}}},
    "a tensor of nothing": {"packing": {"contact_normals": {"tensor": [[0.0] * 3] * 3}}},
    "friction without shear forces": FRICTION,
    "an isotropic stress": {"stress": {"ratio": 1.0}},
}


@pytest.mark.parametrize("hypothesis", ["kinematic", "static"])
@pytest.mark.parametrize("route", ["auto", "axial"])
@pytest.mark.parametrize("name", list(ABSENT))
def test_an_absent_effect_written_out_changes_no_bit(name, route, hypothesis):
    # Breaks when an absent effect goes through the larger model, whose roundings are others.
    model = {"model": {"hypothesis": hypothesis}}
    assert_same(scene(model), scene(model, ABSENT[name]), route)


@pytest.mark.parametrize("hypothesis", ["kinematic", "static"])
@pytest.mark.parametrize("rtol", [None, 1e-3, 1e-9])
@pytest.mark.parametrize("absent", ["spheres", "branches of one length", "isotropic normals"])
def test_an_absent_effect_changes_no_bit_beside_forces(absent, hypothesis, rtol):
    # Breaks when an absent effect moves the nodes of those that are there.
    beside = [FORCES, FRICTION, {"model": {"hypothesis": hypothesis}}]
    assert_same(scene(*beside), scene(*beside, ABSENT[absent]), "auto", rtol)


def test_equal_forces_under_an_anisotropic_fabric_change_no_bit():
    # Breaks when forces that the stress makes equal in all directions are simulated: 5 (SR - 1) = D (SR + 2) exactly.
    equal = [{"packing": {"contact_normals": {"D33": 1.0}}}, {"stress": {"ratio": 1.75}}]
    only_packing = scene(*equal, {"model": {"effects": ["packing"]}})
    for route in ("auto", "axial"):
        assert_same(only_packing, scene(*equal, FRICTION), route)


def test_opening_that_is_listed_without_a_tension_changes_no_bit():
    # Breaks when contacts that may open are integrated by another rule though none does.
    for listed in (["kinetic"], ["kinetic", "slip"]):
        plain, watched = (scene(FORCES, FRICTION, {"model": {"effects": names}}) for names in (
            listed, [*listed, "opening"]))
        assert_same(plain, watched, "auto")


def test_what_an_accuracy_leaves_out_changes_no_bit_of_the_rest():
    # Breaks when a negligible effect is left out of the list and not of the computation.
    nearly = scene(NORMALS, {"branches": {"anisotropy": {"D33": 1e-9}}})
    loose, listed = granular.evaluate(nearly, rtol=1e-6), scene(NORMALS, {"model": {"effects": ["packing", "kinetic"]}})
    assert loose.effects_simulated == ("packing", "kinetic")
    assert loose.normalised == granular.evaluate(listed, rtol=loose.plan.rtol).normalised


def assert_same(less, more, route, rtol=None):
    first, second = (granular.evaluate(each, route=route, rtol=rtol) for each in (less, more))
    assert first.stiffness == second.stiffness
    assert (first.evaluations, first.relative_error, first.effects_simulated) == (
        second.evaluations, second.relative_error,
        tuple(name for name in second.effects_simulated if name != "opening"))
