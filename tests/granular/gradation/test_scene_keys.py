"""Scene keys of gradation, of the coordination line, and of the spin of grains."""

from __future__ import annotations

import pickle
import subprocess
import sys

import pytest

from granular.errors import CurveIncomplete, ValueOutOfRange
from granular.gradation import Lognormal, MeasuredCurve
from granular.number_of_contacts import DEFAULT_RELATION, CoordinationRelation
from granular.scene import Gradation, Packing, Scene, Shape

LINE = {"intercept": 1.5, "slope": 0.1, "source": "a line for the test"}
SOUND = {"grains": {"shear_modulus": "31 GPa", "poisson_ratio": 0.21}, "packing": {"void_ratio": 0.5744},
         "stress": {"mean": "28 kPa"}}
CURVE = "size [mm], finer\n1, 0\n2, 1\n"


def test_the_classical_form_is_named():
    # Breaks when the form of the density does not reach the distribution: its median is another size.
    classical = Gradation(distribution="lognormal", median="5 mm", spread=1.5, form="classical")
    assert classical.sizes == Lognormal(0.005, 1.5, form="classical")
    assert classical.sizes.D50 == 0.005


def test_another_coordination_line():
    # Breaks when the scene's own line is read and not used, or loses its source.
    by_keys = Packing(void_ratio=0.5, coordination_relation=LINE)
    assert by_keys.relation == CoordinationRelation(**LINE)
    assert by_keys.coordination == 10.0
    assert Packing(void_ratio=0.5, coordination_relation=CoordinationRelation(**LINE)) == by_keys
    assert Packing(void_ratio=0.5).relation is DEFAULT_RELATION


@pytest.mark.parametrize("slope", [0.0, -0.1])
def test_a_line_falls(slope):
    # Breaks when a relation with more contacts in a looser packing, or a division by zero, can be built.
    with pytest.raises(ValueOutOfRange, match="slope"):
        CoordinationRelation(intercept=1.5, slope=slope, source="test")


def test_spin_is_fixed_by_default():
    # Breaks when the default of spin moves, or a spin written out as fixed disturbs the static hypothesis.
    assert Shape(aspect_ratio=0.8).spin == "fixed"
    Scene.model_validate({**SOUND, "shape": {"aspect_ratio": 0.8, "spin": "fixed"}, "model": {"hypothesis": "static"}})


def write_scene(folder, curve):
    (folder / "curve.csv").write_text(curve, encoding="utf-8")
    lines = ['[grains]\nshear_modulus = "31 GPa"\npoisson_ratio = 0.21', "[packing]\nvoid_ratio = 0.5744",
             '[gradation]\ndistribution = "curve"\nfile = "curve.csv"', '[stress]\nmean = "28 kPa"']
    (folder / "scene.toml").write_text("\n".join(lines), encoding="utf-8")
    return folder / "scene.toml"


def test_a_curve_is_looked_for_in_the_folder_of_its_scene(tmp_path):
    # Breaks when a scene only runs from its own folder, or a dumped scene loses its curve.
    scene = Scene.from_toml(write_scene(tmp_path, CURVE))
    assert scene.gradation.sizes == MeasuredCurve(["1 mm", "2 mm"], [0, 1])
    assert Scene.model_validate(scene.model_dump()) == scene
    assert pickle.loads(pickle.dumps(scene)) == scene
    assert hash(scene) == hash(Scene.model_validate(scene.model_dump()))


def test_a_curve_of_a_scene_built_in_python_stands_in_the_working_directory(tmp_path, monkeypatch):
    # Breaks when a relative name is looked for anywhere else.
    (tmp_path / "curve.csv").write_text(CURVE, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    assert Gradation(distribution="curve", file="curve.csv").sizes == MeasuredCurve(["1 mm", "2 mm"], [0, 1])


def test_a_wrong_curve_is_told_under_the_key_that_names_it(tmp_path, monkeypatch):
    # Breaks when a scene with an unusable curve is built, and fails later or elsewhere.
    monkeypatch.chdir(tmp_path)
    write_scene(tmp_path, CURVE.replace("1, 0\n", "1, 0.1\n"))
    with pytest.raises(CurveIncomplete, match=r'gradation\.file = "curve\.csv": the curve runs from 0\.1 at'):
        Scene.from_toml("scene.toml")


def test_a_scene_with_a_gradation_loads_no_numeric_library(tmp_path):
    # Breaks when a lognormal gradation, or the reading of a curve, costs the import of NumPy.
    path = write_scene(tmp_path, CURVE)
    script = (f"import sys; from granular.scene import Gradation, Scene; Scene.from_toml({str(path)!r})\n"
              "from granular.gradation import length_moments\n"
              'length_moments(Gradation(distribution="lognormal", median=0.005, spread=1.5).sizes)\n'
              'assert not {"numpy", "scipy", "mpmath"} & set(sys.modules)')
    subprocess.run([sys.executable, "-c", script], check=True, timeout=60)
