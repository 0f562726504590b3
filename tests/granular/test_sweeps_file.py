"""The sweep file, and the maps that are drawn of what it gives."""

from __future__ import annotations

import pytest

import granular
from granular.errors import (
    ConflictingKeys,
    FigureNotKnown,
    FileUnreadable,
    GranularError,
    SweepEmpty,
    UnknownKey,
    WrongType,
)
from granular.figures.sweep_maps import SYMBOLS, effects_map, sweep_maps
from granular.sweeps import Sweep

SCENE = """
[grains]
shear_modulus = "31 GPa"
poisson_ratio = 0.21
friction_angle = "12 deg"
[packing]
void_ratio = 0.5744
[stress]
mean = "28 kPa"
"""
D33, RATIO, HYPOTHESIS = "packing.contact_normals.D33", "stress.ratio", "model.hypothesis"


def read(tmp_path, text):
    """A sweep file beside a scene file."""
    (tmp_path / "scene.toml").write_text(SCENE, "utf-8")
    (tmp_path / "sweep.toml").write_text(text, "utf-8")
    return Sweep.from_toml(tmp_path / "sweep.toml")


@pytest.mark.parametrize("grid", [
    '"packing.contact_normals.D33" = [0.0, 0.3]\n"stress.ratio" = { start = 1.0, stop = 2.0, num = 3 }',
    "packing.contact_normals.D33 = [0.0, 0.3]\nstress.ratio = { start = 1.0, stop = 2.0, num = 3 }",
    "packing = { contact_normals = { D33 = [0.0, 0.3] } }\nstress = { ratio = [1.0, 1.5, 2.0] }",
], ids=["quoted", "dotted", "tables"])
def test_names_are_the_same_however_the_dots_are_written(grid, tmp_path):
    # Breaks when a dotted key, which TOML takes apart, is read as another field.
    sweep = read(tmp_path, f'scene = "scene.toml"\n[sweep.grid]\n{grid}\n')
    assert {axis.name: axis.values for axis in sweep.grid} == {D33: (0.0, 0.3), RATIO: (1.0, 1.5, 2.0)}
    assert sweep.shape == (2, 3)


def test_a_named_scene_is_the_same_as_its_tables(tmp_path):
    # Breaks when a scene is looked for elsewhere than beside the sweep, or read in another way.
    tables = "\n[sweep.list]\nstress.ratio = [1.0, 1.5]\n[sweep.run]\noutputs = ['ratios']\nchunk = 7\n"
    named, written = read(tmp_path, f'scene = "scene.toml"{tables}'), read(tmp_path, SCENE + tables)
    assert named == written
    assert (named.chunk, named.outputs, list(named.dimensions)) == (7, ("ratios",), ["case"])


@pytest.mark.parametrize(("text", "kind", "words"), [
    ("", SweepEmpty, "no field varies"), ("sweep = 1", WrongType, "sweep = 1"),
    ("[sweep.gird]\na = 1", UnknownKey, "the nearest known one is grid"),
    ("[sweep.run]\noutput = 1", UnknownKey, "the nearest known one is outputs"),
    ("[sweep]\ngrid = 1", WrongType, "sweep.grid = 1"),
    ("[sweep.grid]\nstress.rato = [1.0]", UnknownKey, '"stress.rato" is no field of a scene'),
    ('[sweep.grid]\n"stress.ratio" = [1.0]\nstress.ratio = [2.0]', ConflictingKeys, "given twice"),
    ('scene = "missing.toml"\n[sweep.grid]\nstress.ratio = [1.0]', FileUnreadable, "scene: "),
    ('scene = "scene.toml"\n[stress]\nmean = 1.0\n[sweep.grid]\nstress.ratio = [1.0]', ConflictingKeys,
     "scene and stress"),
    ("scene = 1\n[sweep.grid]\nstress.ratio = [1.0]", WrongType, "scene = 1"),
    ("[sweep.list]\nstress.ratio = [1.0, 2.0]\nstress.mean = [1.0]", ConflictingKeys,
     "sweep.list stress.mean has 1 values"),
])
def test_files_that_are_no_sweep_are_refused(text, kind, words, tmp_path):
    # Breaks when a slip of the pen is ignored.
    with pytest.raises(kind) as refusal:
        read(tmp_path, text)
    assert words in str(refusal.value)


def test_a_wrong_scene_is_refused_with_its_key(tmp_path):
    # Breaks when a mistake in the base hides behind the sweep.
    with pytest.raises(GranularError, match="stress is not given"):
        granular.sweep(read(tmp_path, SCENE.partition("[stress]")[0] + "[sweep.grid]\npacking.void_ratio = [0.5]"))
    with pytest.raises(UnknownKey, match=r"grains\.sher_modulus"):
        granular.sweep(read(tmp_path, SCENE.replace("shear", "sher") + "[sweep.grid]\nstress.ratio = [1.0]"))


def test_maps_have_a_panel_for_each_value_and_leave_refused_points_empty():
    # Breaks when panels are mixed up, or a map is drawn over a dimension that was not selected.
    base = {"grains": {"shear_modulus": "31 GPa", "poisson_ratio": 0.21, "friction_angle": "12 deg"},
            "packing": {"void_ratio": 0.5744}, "stress": {"mean": "28 kPa"}}
    dataset = granular.sweep(base, grid={D33: [-0.4, 0.0, 0.4], RATIO: [0.8, 1.0, 1.5, 2.5],
                                         HYPOTHESIS: ["static", "kinematic"]},
                             engine="axial_stiffness", outputs=["ratios"], invalid="nan")
    figure = sweep_maps(dataset, "C1111_over_C3333", x=D33, y=RATIO, panels=HYPOTHESIS)
    assert [axes.get_title() for axes in figure.axes] == ["static", "kinematic"]
    assert [axes.get_xlabel() for axes in figure.axes] == [f"{SYMBOLS[D33]} [–]"] * 2
    right = {"variable": "C1111_over_C3333", "x": D33, "y": RATIO, "panels": HYPOTHESIS}
    for wrong in ({"variable": "C1111"}, {"x": "case"}):
        with pytest.raises(FigureNotKnown):
            sweep_maps(dataset, **(right | wrong))
    with pytest.raises(FigureNotKnown, match="simulated"):
        effects_map(dataset, x=D33, y=RATIO)


def test_a_map_of_effects_names_the_sets_that_occur():
    # Breaks when a set of effects is named after another one, or one that does not occur stands in the legend.
    base = {"grains": {"shear_modulus": "31 GPa", "poisson_ratio": 0.21}, "packing": {"void_ratio": 0.5744},
            "stress": {"mean": "28 kPa"}}
    dataset = granular.sweep(base, grid={D33: [1e-9, 0.3], "model.rtol": [1e-12, 1e-3]}, outputs=["effects"])
    figure = effects_map(dataset, x=D33, y="model.rtol")
    assert [text.get_text() for text in figure.legends[0].get_texts()] == ["a  none", "b  packing, kinetic"]
    cells = figure.axes[0].collections[0].get_array().reshape(2, 2).tolist()
    assert cells == [[1, 1], [0, 1]]
    letters = [text.get_text() for text in figure.axes[0].texts]
    places = [tuple(float(part) for part in text.get_position()) for text in figure.axes[0].texts]
    assert letters == ["a", "b"]
    assert places[0] == (1e-9, 1e-3)  # the one cell in which nothing is simulated
