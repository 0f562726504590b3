"""Scenes: the file format, the published schema, and one clear sentence for everything that is wrong."""

from __future__ import annotations

import json
import math
import pickle
import tomllib
from copy import deepcopy
from fractions import Fraction
from importlib import resources
from pathlib import Path

import jsonschema
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import ValidationError

from granular import errors
from granular.errors import GranularError
from granular.gradation import Lognormal
from granular.hypothesis import Hypothesis
from granular.scene import Branches, Grains, Packing, Scene, Stress, Table
from granular.scene_schema import schema_text

EXAMPLES = sorted(Path(str(resources.files("granular") / "data" / "scenes")).glob("*.toml"))
SOUND = {
    "grains": {"shear_modulus": "31 GPa", "poisson_ratio": 0.21},
    "packing": {"void_ratio": 0.5744},
    "stress": {"mean": "28 kPa"},
}
LINE = {"intercept": 1.5, "slope": 0.1, "source": "a line for the test"}
EVERYTHING = {
    "grains": {"shear_modulus": "31 GPa", "poisson_ratio": 0.21, "friction_angle": "12 deg", "density": "2650 kg/m^3"},
    "packing": {"void_ratio": 0.5744, "coordination_number": 8.6848, "contact_normals": {"D33": 0.3, "D3333": 0.1}},
    "branches": {"anisotropy": {"D33": -0.3}, "length_ratio": 1.0},
    "gradation": {"distribution": "lognormal", "median": "5 mm", "spread": 1.5},
    "stress": {"mean": "28 kPa", "ratio": 1.0},
    "model": {"hypothesis": "static", "effects": ["packing", "branches"], "rtol": 1e-12},
}


def changed(**changes):
    """The sound scene after changes, ``table__key=value``; None deletes the key."""
    scene = deepcopy(SOUND)
    for path, value in changes.items():
        table, _, key = path.partition("__")
        if not key:
            scene[table] = value
        elif value is None:
            del scene[table][key]
        else:
            scene.setdefault(table, {})[key] = value
    return scene


def axial(D33):
    return [[-D33 / 2, 0, 0], [0, -D33 / 2, 0], [0, 0, D33]]


def diagonal(*entries):
    return [[entry if i == j else 0 for j in range(3)] for i, entry in enumerate(entries)]


def test_reads_every_key_of_the_format():
    # Breaks when a key of the scene file gets another name, unit or default.
    scene = Scene.model_validate(EVERYTHING)
    assert scene.grains.shear_modulus == 31e9
    assert scene.grains.friction_angle == math.radians(12)
    assert scene.grains.density == 2650.0
    assert scene.packing.coordination == 8.6848
    assert (scene.fabric.D33, scene.fabric.D3333, scene.fabric.Dr33) == (0.3, 0.1, -0.3)
    assert scene.length_ratio == 1.0
    assert scene.gradation.median == 0.005
    assert scene.gradation.sizes == Lognormal(0.005, 1.5, form="paper")
    assert scene.stress.mean_stress == 28e3
    assert scene.model.hypothesis is Hypothesis.STATIC
    assert scene.model.effects == ("packing", "branches")
    assert scene.model.rtol == 1e-12


def test_defaults():
    # Breaks when an optional table stops being optional, or its default moves.
    scene = Scene.model_validate(SOUND)
    assert scene.packing.coordination == 8.6848
    assert (scene.fabric.D33, scene.fabric.D3333, scene.fabric.Dr33) == (0.0, 0.0, 0.0)
    assert scene.length_ratio == 1.0
    assert scene.stress.principal == (1, 1)
    assert scene.model.hypothesis is Hypothesis.KINEMATIC
    assert scene.model.effects == "auto"
    assert scene.model.rtol is None


def test_is_built_from_parts_too():
    # Breaks when Python users cannot use the same names as the file, or part objects.
    by_parts = Scene(grains=Grains(shear_modulus="31 GPa", poisson_ratio=0.21), packing=Packing(void_ratio=0.5744),
                     branches=Branches(anisotropy={"D33": -0.3}), stress=Stress(mean=28e3))
    assert by_parts == Scene.model_validate(changed(branches={"anisotropy": {"D33": -0.3}}))


@pytest.mark.parametrize("content", [SOUND, EVERYTHING, changed(stress={"tensor": diagonal("1 kPa", 1e3, "2 kPa")}),
                                     changed(packing__contact_normals={"tensor": axial(0.3)})])
def test_survives_dump_and_pickle(content):
    # Breaks when a default that is written out is taken for a conflict, or a record is not plain data.
    scene = Scene.model_validate(content)
    assert Scene.model_validate(scene.model_dump()) == scene
    assert pickle.loads(pickle.dumps(scene)) == scene
    assert hash(scene) == hash(Scene.model_validate(content))


def test_is_frozen():
    # Breaks when a validated scene can be changed behind the validation's back.
    with pytest.raises(ValidationError, match="frozen"):
        Scene.model_validate(SOUND).grains.poisson_ratio = 0.7


@given(st.floats(-1.0, 2.0))
def test_an_axial_tensor_is_its_D33(D33):
    # Breaks when the trace test, the symmetry test or the reading of D33 rounds differently from -D/2.
    by_tensor = Scene.model_validate(changed(packing__contact_normals={"tensor": axial(D33)}))
    assert by_tensor.fabric == Scene.model_validate(changed(packing__contact_normals={"D33": D33})).fabric


def test_zero_has_no_sign():
    # Breaks when -0.0 of a file comes out as -0.0 in a result.
    scene = Scene.model_validate(changed(grains__poisson_ratio=-0.0, branches={"anisotropy": {"D33": -0.0}}))
    assert math.copysign(1.0, scene.grains.poisson_ratio) == math.copysign(1.0, scene.fabric.Dr33) == 1.0


def test_stress_by_tensor():
    # Breaks when the mean is not a third of the trace, or the principal stresses lose exactness.
    stress = Stress(tensor=diagonal("10 kPa", 1e4, "40 kPa"))
    assert stress.mean_stress == 2e4
    assert stress.principal == (10000, 40000)
    largest = Stress(tensor=diagonal(1.7e308, 1.7e308, 1.7e308))
    assert largest.mean_stress == 1.7e308


def test_the_ratio_is_kept_exactly():
    # Breaks when principal stresses are formed in floats: kinetic fabric is decided exactly.
    assert Stress(mean=1.0, ratio=0.1).principal == (1, Fraction(0.1))


INTERVALS = [
    ("grains__poisson_ratio", [0.0, 0.5], [-5e-324, 0.5000000000000001, -1, 1]),
    ("grains__shear_modulus", [5e-324, 1e308], [0, -1, "-1 Pa"]),
    ("grains__friction_coefficient", [0.0, 1e308], [-0.1]),
    ("grains__friction_angle", [0.0, "89.999 deg", 1.5], ["90 deg", 12, "-1 deg"]),
    ("grains__density", [1e-3, "2650 kg/m^3"], [0, -2650]),
    ("packing__void_ratio", [5e-324, 1.6599999999999997], [0, -0.1, "0.5"]),
    ("packing__coordination_number", [5e-324, 1e300], [0, -6]),
    ("stress__mean", [5e-324, 1e308], [0, "-28 kPa", -1e-300]),
    ("stress__ratio", [0, 1e308], [-5e-324, -1]),
    ("model__rtol", [5e-324, 0.9999999999999999], [0, 1, -1e-9]),
]


@pytest.mark.parametrize(("path", "value"), [(p, v) for p, inside, _ in INTERVALS for v in inside])
def test_the_ends_of_an_interval_belong_where_stated(path, value):
    # Breaks when a closed end becomes open.
    Scene.model_validate(changed(**{path: value}))


@pytest.mark.parametrize(("path", "value"), [(p, v) for p, _, outside in INTERVALS for v in outside])
def test_values_outside_are_refused_with_name_and_value(path, value):
    # Breaks when a bound is dropped or its message loses the dotted name.
    with pytest.raises(GranularError) as refused:
        Scene.model_validate(changed(**{path: value}))
    assert path.replace("__", ".") in str(refused.value)
    assert "allowed" in str(refused.value)


WRONG = [
    ("unknown key", changed(packing__void_ration=0.5), "UnknownKey", ["packing.void_ration", "void_ratio"]),
    ("unknown table", changed(packng={}), "UnknownKey", ["packng", "packing"]),
    ("key of another table", changed(grains__void_ratio=0.5), "UnknownKey", ["grains.void_ratio", "[packing]"]),
    ("D33 without its table", changed(packing__D33=0.3), "UnknownKey", ["packing.D33", "packing.contact_normals"]),
    ("key that starts like its table", changed(packing__packing_density=1), "UnknownKey",
     ["packing.packing_density"]),
    ("nothing like it", changed(zzz=1), "UnknownKey", ["zzz", "grains, packing"]),
    ("line break in a key", changed(**{"a\nb": 1}), "UnknownKey", ["a\\nb"]),
    ("empty key", changed(**{"": 1}), "UnknownKey", ['"" is not a known key']),
    ("long key", changed(**{"k" * 100000: 1}), "UnknownKey", ["kkk..."]),
    ("a thousand keys", changed(packing={f"k{i}": 1 for i in range(1000)}), "UnknownKey", ["k0", "1000 more"]),
    ("missing key", changed(grains__shear_modulus=None), "MissingKey", ["grains.shear_modulus"]),
    ("missing table", {"grains": SOUND["grains"], "packing": SOUND["packing"]}, "MissingKey", ["stress"]),
    ("empty", {}, "MissingKey", ["grains", "2 more mistakes"]),
    ("wrong unit", changed(stress__mean="28 kg"), "UnitOfOtherDimension", ["stress.mean", "28 kg", "mass"]),
    ("list for a table", changed(packing=[]), "WrongType", ["packing = []"]),
    ("number for a table", changed(packing=3), "WrongType", ["packing = 3"]),
    ("number for an inner table", changed(packing__contact_normals=0.3), "WrongType", ["packing.contact_normals"]),
    ("list of tables", changed(packing=[{"void_ratio": 0.5}]), "WrongType", ["packing"]),
    ("string for a number", changed(packing__void_ratio="0.5744"), "WrongType", ["0.5744", "quotation marks"]),
    ("truth value", changed(packing__void_ratio=True), "WrongType", ["packing.void_ratio = true"]),
    ("NaN", changed(packing__void_ratio=math.nan), "NotFinite", ["packing.void_ratio = nan"]),
    ("inf", changed(stress__mean=math.inf), "NotFinite", ["stress.mean = inf"]),
    ("huge integer", changed(packing__void_ratio=10**400), "NotFinite", ["401 digits"]),
    ("NaN in D33", changed(packing__contact_normals={"D33": math.nan}), "NotFinite", ["contact_normals.D33"]),
    ("D33 too large", changed(packing__contact_normals={"D33": 2.3}), "FabricOutOfRange",
     ["packing.contact_normals.D33 = 2.3", "-1 <= D33 <= 2"]),
    ("D33 too small", changed(packing__contact_normals={"D33": -1.0000000000000002}), "FabricOutOfRange",
     ["-1.0000000000000002"]),
    ("D33 with D3333", changed(packing__contact_normals={"D33": 0.1, "D3333": 3}), "FabricOutOfRange",
     ["D33 = 0.1 with D3333 = 3.0"]),
    ("Dr at its end", changed(branches={"anisotropy": {"D33": -1}}), "FabricOutOfRange",
     ["branches.anisotropy.D33 = -1", "-1 < D33 < 2"]),
    ("Dr too large", changed(branches={"anisotropy": {"D33": 2}}), "FabricOutOfRange", ["branches.anisotropy.D33"]),
    ("D33 of a tensor", changed(packing__contact_normals={"tensor": axial(2.5)}), "FabricOutOfRange", ["2.5"]),
    ("D3333 alone", changed(packing__contact_normals={"D3333": 0.1}), "MissingKey", ["contact_normals.D33"]),
    ("no D33", changed(branches={"anisotropy": {}}), "MissingKey", ["branches.anisotropy.D33"]),
    ("D33 and tensor", changed(packing__contact_normals={"D33": 0.1, "tensor": axial(0.1)}), "ConflictingKeys",
     ["contact_normals.D33 and tensor"]),
    ("D3333 and tensor", changed(packing__contact_normals={"D3333": 0.1, "tensor": axial(0.1)}), "ConflictingKeys",
     ["tensor and D3333"]),
    ("friction twice", changed(grains__friction_angle="12 deg", grains__friction_coefficient=0.2),
     "ConflictingKeys", ["friction_angle and friction_coefficient"]),
    ("bare degrees", changed(grains__friction_angle=12), "ValueOutOfRange", ["12", "radians", '"12 deg"']),
    ("branches with shape", changed(branches={}, shape={"aspect_ratio": 0.8}), "ConflictingKeys",
     ["branches and shape"]),
    ("mean with tensor", changed(stress__tensor=diagonal(1, 1, 1)), "ConflictingKeys", ["tensor and mean"]),
    ("ratio with tensor", changed(stress={"ratio": 1.0, "tensor": diagonal(1, 1, 1)}), "ConflictingKeys",
     ["tensor and ratio"]),
    ("no mean", changed(stress={"ratio": 1.0}), "MissingKey", ["stress.mean"]),
    ("not symmetric", changed(packing__contact_normals={"tensor": [[0, 0.1, 0], [0, 0, 0], [0, 0, 0]]}),
     "TensorUnusable", ["t12 = 0.1", "t21 = 0.0", "symmetric"]),
    ("not traceless", changed(branches={"anisotropy": {"tensor": diagonal(0.1, 0, 0)}}), "TensorUnusable",
     ["trace 0.1", "traceless"]),
    ("wrong shape", changed(packing__contact_normals={"tensor": [[0, 0], [0, 0]]}), "TensorUnusable", ["three rows"]),
    ("tensor of text", changed(stress={"tensor": "28 kPa"}), "TensorUnusable", ["stress.tensor"]),
    ("text in a tensor", changed(packing__contact_normals={"tensor": diagonal("x", 0, 0)}), "WrongType", ["t11"]),
    ("wrong unit in a tensor", changed(stress={"tensor": diagonal("1 kg", 1, 1)}), "UnitOfOtherDimension", ["t11"]),
    ("a shape about another axis", changed(packing__contact_normals={"tensor": diagonal(0.2, -0.1, -0.1)},
                                           shape={"aspect_ratio": 0.8}), "AxisNeeded",
     ["shape with packing.contact_normals.tensor", "axis 3"]),
    ("a shape under a shear stress", changed(stress={"tensor": [[1, 0, 0.1], [0, 1, 0], [0.1, 0, 1]]},
                                             shape={"aspect_ratio": 0.8}), "AxisNeeded", ["shape with stress.tensor"]),
    ("a density that is negative", changed(packing__contact_normals={"tensor": diagonal(2.2, -1.2, -1)}),
     "FabricOutOfRange", ["packing.contact_normals.tensor gives 4 pi E = -0.2 along n = (0, 1, 0)"]),
    ("a branch without length", changed(branches={"anisotropy": {"tensor": diagonal(2.2, -1.2, -1)}}),
     "FabricOutOfRange", ["branches.anisotropy.tensor gives W = -0.2 along n = (0, 1, 0)"]),
    ("a tensor of rank four alone", changed(packing__contact_normals={"tensor4": np.zeros((3, 3, 3, 3)).tolist()}),
     "MissingKey", ["tensor is not given beside tensor4"]),
    ("a tensor of rank four with a trace", changed(packing__contact_normals={
        "tensor": diagonal(0, 0, 0), "tensor4": np.ones((3, 3, 3, 3)).tolist()}), "TensorUnusable",
     ["contact_normals.tensor4 has a trace"]),
    ("a tensor of rank four that is not symmetric", changed(packing__contact_normals={
        "tensor": diagonal(0, 0, 0), "tensor4": np.eye(81)[3].reshape(3, 3, 3, 3).tolist()}), "TensorUnusable",
     ["contact_normals.tensor4 changes when indices are swapped"]),
    ("a tensor of rank three", changed(packing__contact_normals={
        "tensor": diagonal(0, 0, 0), "tensor4": np.zeros((3, 3, 3)).tolist()}), "TensorUnusable", ["three rows"]),
    ("shear beyond any mean", changed(stress={"tensor": [[1, 0, 5], [0, 1, 0], [5, 0, -3]]}), "StressNotCompressive",
     ["mean -0.33"]),
    ("only tension", changed(stress={"tensor": diagonal(-1, -1, -2)}), "StressNotCompressive",
     ["t11 = -1.0", "t33 = -2.0", "some compression"]),
    ("more tension than compression", changed(stress={"tensor": diagonal(1, 1, -3)}), "StressNotCompressive",
     ["mean", "outweighs"]),
    ("no stress", changed(stress={"tensor": diagonal(0, 0, 0)}), "StressNotCompressive", ["t11 = 0.0"]),
    ("no contacts by default", changed(packing__void_ratio=1.66), "ValueOutOfRange",
     ["packing.void_ratio = 1.66", "coordination_number"]),
    ("hypothesis", changed(model__hypothesis="Static"), "UnknownChoice", ["Static", "Did you mean static?"]),
    ("hypothesis of another type", changed(model__hypothesis=1), "WrongType", ["model.hypothesis"]),
    ("effect", changed(model__effects=["packing", "branch"]), "UnknownChoice", ["effects[1]", "branches"]),
    ("effect twice", changed(model__effects=["packing", "packing"]), "UnknownChoice", ["each word once"]),
    ("effects as a word", changed(model__effects="packing"), "WrongType", ['"auto"']),
    ("distribution", changed(gradation={"distribution": "log-normal"}), "UnknownChoice", ["lognormal"]),
    ("lognormal without spread", changed(gradation={"distribution": "lognormal", "median": "5 mm"}), "MissingKey",
     ["gradation.spread"]),
    ("spread of one", changed(gradation={"distribution": "lognormal", "median": "5 mm", "spread": 1}),
     "ValueOutOfRange", ["gradation.spread = 1", "1 < spread <= 10"]),
    ("curve without file", changed(gradation={"distribution": "curve"}), "MissingKey", ["gradation.file"]),
    ("curve with an empty file", changed(gradation={"distribution": "curve", "file": " "}), "WrongType", ["file"]),
    ("curve with median", changed(gradation={"distribution": "curve", "file": "c.csv", "median": 1}),
     "ConflictingKeys", ["gradation.median"]),
    ("curve with form", changed(gradation={"distribution": "curve", "file": "c.csv", "form": "paper"}),
     "ConflictingKeys", ["gradation.form"]),
    ("no such curve", changed(gradation={"distribution": "curve", "file": "no_such_curve.csv"}), "FileUnreadable",
     ["gradation.file", "no_such_curve.csv", "a gradation curve is needed"]),
    ("too wide", changed(gradation={"distribution": "lognormal", "median": "5 mm", "spread": 10.1}),
     "ValueOutOfRange", ["gradation.spread = 10.1", "1 < spread <= 10"]),
    ("negative size", changed(gradation={"distribution": "lognormal", "median": "-5 mm", "spread": 1.5}),
     "ValueOutOfRange", ["gradation.median", "-5 mm"]),
    ("form", changed(gradation={"distribution": "lognormal", "median": "5 mm", "spread": 1.5, "form": "Paper"}),
     "UnknownChoice", ["gradation.form", "Did you mean paper?"]),
    ("coordination twice", changed(packing__coordination_number=6, packing__coordination_relation=LINE),
     "ConflictingKeys", ["packing.coordination_number and coordination_relation"]),
    ("rising line", changed(packing__coordination_relation={**LINE, "slope": -0.1}), "ValueOutOfRange",
     ["packing.coordination_relation.slope = -0.1"]),
    ("line without slope", changed(packing__coordination_relation={"intercept": 1.66}), "MissingKey",
     ["packing.coordination_relation.slope"]),
    ("no contacts by the line", changed(packing__coordination_relation={**LINE, "intercept": 0.5}),
     "ValueOutOfRange", ["packing.void_ratio = 0.5744", "the scene's own line e = 0.5 - 0.1 N"]),
    ("spin of a static assembly", changed(shape={"aspect_ratio": 0.8, "spin": "relaxed"}, model__hypothesis="static"),
     "ConflictingKeys", ['shape.spin = "relaxed"', "static"]),
    ("spin", changed(shape={"aspect_ratio": 0.8, "spin": "free"}), "UnknownChoice", ["shape.spin"]),
    ("flat grains", changed(shape={"aspect_ratio": 0}), "ValueOutOfRange", ["shape.aspect_ratio = 0"]),
    ("keys that are no text", {**SOUND, "packing": {1: 2}}, "WrongType", ["not text"]),
    ("no dict", [1, 2], "WrongType", ["scene"]),
    ("nothing", None, "WrongType", ["scene"]),
    ("a long string", changed(packing__void_ratio="x" * 100000), "WrongType", ["xxx..."]),
    ("a deep list", changed(packing__void_ratio=[[[[[[[[1]]]]]]]]), "WrongType", ["packing.void_ratio"]),
    ("control characters", changed(stress__mean="\x1b[31m28 kPa"), "QuantityUnreadable", ["\\x1b"]),
]


@pytest.mark.parametrize(("content", "kind", "parts"), [case[1:] for case in WRONG], ids=[case[0] for case in WRONG])
def test_everything_wrong_gets_one_sentence(content, kind, parts):
    # Breaks when a mistake passes, escapes as a pydantic report, or is reported without its name, value or remedy.
    with pytest.raises(GranularError) as refused:
        Scene.model_validate(content)
    message = str(refused.value)
    assert type(refused.value) is getattr(errors, kind)
    assert all(part in message for part in parts), message
    assert message.isprintable()
    assert len(message) < 500


def test_the_first_mistake_is_told_and_the_others_are_counted():
    # Breaks when several mistakes become several sentences, or a typed key hides behind what it made missing.
    with pytest.raises(errors.UnknownKey, match=r"void_ration .*3 more mistakes"):
        Scene.model_validate({"grains": {"shear_modulus": "31 kg", "poisson_ratio": 0.7},
                              "packing": {"void_ration": 0.5}, "stress": {"mean": 1}})


def test_parts_refuse_by_themselves():
    # Breaks when only the whole scene turns pydantic's report into a sentence.
    with pytest.raises(errors.ValueOutOfRange, match=r"poisson_ratio = 0\.7"):
        Grains(shear_modulus=1.0, poisson_ratio=0.7)
    with pytest.raises(errors.MissingKey):
        Scene()


def test_no_table_has_a_key_of_its_own_name():
    # Breaks when dotted names become ambiguous.
    for name, field in Scene.model_fields.items():
        model = next((m for m in Table.__subclasses__() if m.__name__.lower() == name), None)
        if model is not None:
            assert name not in model.model_fields, field


SCALARS = (st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=20)
           | st.sampled_from(["28 kPa", "kinematic", "auto", 0.3, 10**400]))
VALUES = st.recursive(SCALARS, lambda inner: st.lists(inner, max_size=4)
                      | st.dictionaries(st.sampled_from(["D33", "tensor", "mean", "x", ""]), inner, max_size=3),
                      max_leaves=8)


@given(st.data())
def test_no_scene_brings_a_traceback(data):
    # Breaks when some value of some key raises anything but a GranularError of one line.
    scene = deepcopy(EVERYTHING)
    for _ in range(data.draw(st.integers(1, 3))):
        table = scene[data.draw(st.sampled_from(sorted(scene)))]
        table[data.draw(st.sampled_from(sorted(table)))] = data.draw(VALUES)
    try:
        Scene.model_validate(scene)
    except GranularError as refused:
        assert len(str(refused).splitlines()) == 1


# ---- schema


def test_the_published_schema_is_the_one_of_the_models():
    # Breaks when a model changes and the file does not: `granular schema > granular/data/scene.schema.json`.
    published = (resources.files("granular") / "data" / "scene.schema.json").read_text("utf-8")
    assert published == schema_text(Scene)
    assert json.loads(published) == Scene.json_schema()


def test_the_schema_is_a_schema():
    # Breaks when the schema itself is wrong.
    jsonschema.Draft202012Validator.check_schema(Scene.json_schema())


@pytest.mark.parametrize("content", [SOUND, EVERYTHING, changed(stress={"tensor": diagonal("1 kPa", 1e3, "2 kPa")}),
                                     *(tomllib.loads(path.read_text("utf-8")) for path in EXAMPLES)])
def test_the_schema_takes_what_a_scene_takes(content):
    # Breaks when the schema is narrower than the models.
    jsonschema.Draft202012Validator(Scene.json_schema()).validate(content)


def test_the_schema_refuses_what_structure_alone_shows():
    # Breaks when the schema is looser than it could be. What it cannot know: units, admissible fabrics, tensors,
    # and values far inside Python.
    beyond = {"FabricOutOfRange", "UnitOfOtherDimension", "AxisNeeded", "NotFinite"}
    unseen = {"not symmetric", "not traceless", "a tensor of rank four with a trace", "shear beyond any mean",
              "a tensor of rank four that is not symmetric", "only tension", "more tension than compression",
              "no stress",
              "no contacts by default", "no contacts by the line", "bare degrees", "curve with an empty file",
              "no such curve", "negative size", "keys that are no text", "text in a tensor", "control characters"}
    validator = jsonschema.Draft202012Validator(Scene.json_schema())
    passed = [name for name, content, kind, _ in WRONG
              if kind not in beyond and name not in unseen and validator.is_valid(content)]
    assert passed == []
