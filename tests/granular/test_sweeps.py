"""Sweeps in memory: what is read, how it is laid out, and that every point is what its scene alone would give."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import granular
from granular.array_stiffness import RELATIVE_ERROR
from granular.errors import (
    AxisNeeded,
    BadOption,
    ComplianceInfinite,
    ConflictingKeys,
    FabricOutOfRange,
    MissingKey,
    SweepEmpty,
    SweepTooLarge,
    UnitOfOtherDimension,
    UnknownChoice,
    UnknownKey,
    ValueOutOfRange,
    WrongType,
)
from granular.sweeps import Sweep
from granular.sweeps.axes import read_axis
from granular.sweeps.points import chunk_shape, chunks_of, shape_of
from granular.sweeps.scene_fields import scene_fields

BASE = {"grains": {"shear_modulus": "31 GPa", "poisson_ratio": 0.21, "friction_angle": "12 deg",
                   "density": "2650 kg/m^3"},
        "packing": {"void_ratio": 0.5744}, "stress": {"mean": "28 kPa"}}
D33, RATIO, HYPOTHESIS = "packing.contact_normals.D33", "stress.ratio", "model.hypothesis"


def axis(name, values, *, distinct=True):
    return read_axis(name, values, place="grid", distinct=distinct)


def test_ranges_pass_through_the_decimals_that_people_mean():
    # Breaks when steps are added up in binary: the third value would be 0.30000000000000004.
    assert axis(RATIO, {"start": 0.1, "stop": 0.5, "num": 5}).values == (0.1, 0.2, 0.3, 0.4, 0.5)
    assert axis(D33, {"start": 1, "stop": -0.5, "num": 4}).values == (1.0, 0.5, 0.0, -0.5)


def test_logarithmic_ranges_end_exactly_and_pass_through_powers_of_ten():
    # Breaks when the values come from a library of functions that rounds differently elsewhere.
    found = axis("stress.mean", {"start": "1 kPa", "stop": "1 MPa", "num": 4, "spacing": "log"})
    assert found.values == found.labels == (1e3, 1e4, 1e5, 1e6)
    odd = axis("stress.mean", {"start": 7.0, "stop": 1e300, "num": 13, "spacing": "log"}).values
    assert (odd[0], odd[-1]) == (7.0, 1e300)
    steps = np.diff(np.log(odd))
    assert np.allclose(steps, steps[0], rtol=1e-13)  # the logarithm of 1e300 is rounded at 1e-16 of itself


def test_values_are_read_as_in_a_scene_file():
    # Breaks when a unit is forgotten, or an array is no list.
    assert axis("stress.mean", ["28 kPa", 1e5]).values == (28e3, 1e5)
    assert axis("grains.friction_angle", np.array([0.1, 0.2])).values == (0.1, 0.2)
    assert axis(HYPOTHESIS, ["static", "kinematic"]).labels == ("static", "kinematic")
    assert axis("model.effects", [["packing"], "auto"]).labels == ('["packing"]', "auto")


@pytest.mark.parametrize(("name", "values", "kind"), [
    ("stress.rato", [1.0], UnknownKey), ("", [1.0], UnknownKey), ("stress", [1.0], UnknownKey),
    (RATIO, [], SweepEmpty), (RATIO, 1.0, WrongType), (RATIO, "1.0", WrongType), (RATIO, [1.0, "2"], WrongType),
    (RATIO, [1.0, None], ValueOutOfRange), (RATIO, [-1.0], ValueOutOfRange),
    ("stress.mean", ["28 rad"], UnitOfOtherDimension),
    (HYPOTHESIS, ["dynamic"], UnknownChoice), (RATIO, [1.0, 2.0, 1], ConflictingKeys),
    (RATIO, {"start": 1.0, "stop": 2.0}, MissingKey), (RATIO, {"start": 1.0, "stop": 2.0, "number": 3}, UnknownKey),
    (RATIO, {"start": 1.0, "stop": 2.0, "num": 2.0}, WrongType),
    (RATIO, {"start": 1.0, "stop": 2.0, "num": 0}, SweepEmpty),
    (RATIO, {"start": 1.0, "stop": 2.0, "num": 1}, ValueOutOfRange),
    (RATIO, {"start": 1.0, "stop": 1.0, "num": 3}, ConflictingKeys),
    (RATIO, {"start": 1.0, "stop": 2.0, "num": 10**15}, SweepTooLarge),
    (RATIO, {"start": 0.0, "stop": 2.0, "num": 3, "spacing": "log"}, ValueOutOfRange),
    (HYPOTHESIS, {"start": 0.0, "stop": 2.0, "num": 3}, WrongType),
])
def test_axes_that_cannot_be_are_refused(name, values, kind):
    # Breaks when one of them is taken, or fills the memory first.
    with pytest.raises(kind):
        axis(name, values)


def test_every_key_of_a_scene_is_a_field():
    # Breaks when a table is added to the scene whose keys a sweep cannot reach.
    names = set(scene_fields())
    assert {"grains.shear_modulus", "packing.coordination_relation.slope", "branches.anisotropy.D33",
            "gradation.spread", "shape.aspect_ratio", "stress.tensor", "model.rtol"} <= names


@given(st.lists(st.integers(1, 9), min_size=1, max_size=4), st.integers(1, 200))
def test_chunks_cover_the_grid_once(shape, wanted):
    # Breaks when a point is left out, computed twice, or a chunk grows beyond what was asked.
    seen = np.zeros(shape, dtype=int)
    for chunk in chunks_of(shape, chunk_shape(shape, wanted)):
        seen[chunk] += 1
        assert math.prod(shape_of(chunk)) <= wanted
    assert (seen == 1).all()


def test_every_point_has_the_bits_of_its_scene_alone():
    # Breaks when a point is laid down in another place, or something of its neighbour stays in its scene.
    sweep = Sweep.of(BASE, grid={D33: [-0.4, 0.3], RATIO: [1.0, 2.0]}, chunk=3, outputs=[
        "stiffness", "mandel", "ratios", "reference_stiffness", "engineering", "waves", "relative_error", "route",
        "effects", "evaluations"])
    dataset = granular.sweep(sweep)
    assert dataset.attrs["complete"] == 1
    for d in (-0.4, 0.3):
        for ratio in (1.0, 2.0):
            scene = BASE | {"packing": {"void_ratio": 0.5744, "contact_normals": {"D33": d}},
                            "stress": {"mean": "28 kPa", "ratio": ratio}}
            alone, here = granular.evaluate(granular.Scene.model_validate(scene)), dataset.sel({D33: d, RATIO: ratio})
            assert {name: float(here[name]) for name in alone.stiffness.components} == alone.stiffness.components
            assert here.mandel.values.tolist() == [list(row) for row in alone.stiffness.rows]
            assert [float(here.C1111_over_C3333), float(here.C2323_over_C1212)] == [r.value for r in alone.ratios]
            assert (float(here.E3), float(here.nu31)) == (alone.engineering.E3, alone.engineering.nu31)
            assert (float(here.P_vertical), float(here.SH_horizontal)) == (alone.waves.vertical.P,
                                                                           alone.waves.horizontal.SH)
            assert (float(here.relative_error), here.route.item(), int(here.evaluations)) == (
                alone.relative_error, alone.route, alone.evaluations)
            simulated = here.effect.values[here.simulated.values].tolist()
            assert simulated == list(alone.effects_simulated)


def test_units_and_provenance_stand_in_the_attributes():
    # Breaks when a variable says nothing of its unit, or the dataset nothing of its origin.
    dataset = granular.sweep(BASE, grid={"stress.mean": ["28 kPa", "1 MPa"]}, outputs=["stiffness", "waves"])
    assert dataset.C1111.attrs["units"] == "Pa"
    assert dataset["stress.mean"].attrs["units"] == "Pa"
    assert dataset.epsilon.attrs["units"] == "1"
    assert all(variable.attrs["long_name"] for variable in dataset.data_vars.values())
    assert dataset.attrs["granular_version"] == granular.__version__
    assert len(dataset.attrs["granular_source_sha256"]) == len(dataset.attrs["sweep_sha256"]) == 64


def test_fields_that_vary_together_share_a_dimension():
    # Breaks when they are combined with each other instead.
    dataset = granular.sweep(BASE, grid={RATIO: [1.0, 1.5]}, outputs=["reference_stiffness"],
                             together={"packing.void_ratio": [0.5, 0.6], "packing.coordination_number": [9.0, 8.0]})
    assert dict(dataset.sizes) == {RATIO: 2, "case": 2}
    assert dataset["packing.coordination_number"].dims == ("case",)
    scene = BASE | {"packing": {"void_ratio": 0.6, "coordination_number": 8.0}}
    alone = granular.evaluate(granular.Scene.model_validate(scene))
    assert float(dataset.reference_stiffness[0, 1]) == alone.reference_stiffness


def test_tables_that_the_base_lacks_are_added_and_a_scene_is_a_base():
    # Breaks when only keys that stand there already can vary, or a scene loses a key on its way.
    scene = granular.Scene.model_validate(BASE | {"model": {"effects": ["branches"], "hypothesis": "static"}})
    dataset = granular.sweep(scene, grid={"branches.anisotropy.D33": [-0.3, 0.0]}, outputs=["ratios", "effects"])
    assert dataset.effect.values[dataset.simulated[0].values].tolist() == ["branches"]
    assert float(dataset.C1111_over_C3333[1]) == 1.0


def test_arrays_agree_with_scenes_within_both_bounds():
    # Breaks when an argument goes to the wrong place, or another scale is taken.
    grid = {D33: [-0.5, 0.0, 0.7], "branches.anisotropy.D33": [-0.3, 0.2], RATIO: [1.0, 1.5],
            "grains.poisson_ratio": [0.0, 0.3], "stress.mean": [28e3, 1e6]}
    outputs = ["stiffness", "ratios", "reference_stiffness", "relative_error"]
    slow = granular.sweep(BASE, grid=grid, outputs=outputs)
    fast = granular.sweep(BASE, grid=grid, outputs=outputs, engine="axial_stiffness", chunk=7)
    assert fast.attrs["engine"] == "axial_stiffness"
    assert fast.reference_stiffness.equals(slow.reference_stiffness)
    bound = float((slow.relative_error + fast.relative_error).max())
    assert bound < 100 * RELATIVE_ERROR
    for name in ("C1111", "C3333", "C1122", "C1133", "C2323", "C1212"):
        assert (abs(fast[name] - slow[name]) <= bound * abs(slow[name])).all()


@pytest.mark.parametrize("engine", ["evaluate", "axial_stiffness"])
def test_a_refused_point_is_named_or_left_empty(engine):
    # Breaks when a gap looks like a number, or its neighbours are lost with it.
    grid = {HYPOTHESIS: ["kinematic", "static"], RATIO: [1.0, 3.0]}
    with pytest.raises(ComplianceInfinite, match=r'point model.hypothesis = "static", stress.ratio = 3.0: '):
        granular.sweep(BASE, grid=grid, engine=engine)
    dataset = granular.sweep(BASE, grid=grid, engine=engine, invalid="nan")
    assert dataset.refusal.values.tolist() == [["", ""], ["", "G-STA-01"]]
    assert np.isnan(dataset.C1111.values).tolist() == [[False, False], [False, True]]
    assert np.isnan(dataset.relative_error.values).tolist() == [[False, False], [False, True]]


def test_points_outside_are_refused_before_anything_is_computed(monkeypatch):
    # Breaks when hours are spent before the last point turns out to be none.
    monkeypatch.setattr("granular.sweeps.engine.Task.compute", lambda self: pytest.fail("computed"))
    with pytest.raises(FabricOutOfRange, match=r"point packing\.contact_normals\.D33 = 2\.3: packing\.contact_norm"):
        granular.sweep(BASE, grid={RATIO: [1.0, 1.5], D33: [0.0, 2.3]})
    with pytest.raises(ConflictingKeys, match=r"friction_coefficient = 0\.2: grains\.friction_angle and"):
        granular.sweep(BASE, grid={"grains.friction_coefficient": [0.2]})
    with pytest.raises(MissingKey, match="aspect_ratio"):  # a mistake of the sweep itself is never a gap
        granular.sweep(BASE, grid={"shape.spin": ["fixed"]}, invalid="nan")


@pytest.mark.parametrize(("options", "kind"), [
    ({"grid": {}}, SweepEmpty), ({"grid": [1]}, WrongType),
    ({"together": {RATIO: [1.0], D33: [0.1, 0.2]}}, ConflictingKeys),
    ({"grid": {RATIO: [1.0]}, "together": {RATIO: [1.0]}}, ConflictingKeys),
    ({"grid": {RATIO: [1.0]}, "outputs": ["stifness"]}, UnknownChoice),
    ({"grid": {RATIO: [1.0]}, "outputs": []}, SweepEmpty),
    ({"grid": {RATIO: [1.0]}, "outputs": ["route", "route"]}, ConflictingKeys),
    ({"grid": {RATIO: [1.0]}, "outputs": "route"}, WrongType),
    ({"grid": {RATIO: [1.0]}, "engine": "fast"}, UnknownChoice),
    ({"grid": {RATIO: [1.0]}, "route": "fast"}, UnknownChoice), ({"grid": {RATIO: [1.0]}, "chunk": 0}, WrongType),
    ({"grid": {RATIO: [1.0]}, "invalid": "skip"}, UnknownChoice), ({"grid": {RATIO: [1.0]}, "workers": 0}, BadOption),
    ({"grid": {RATIO: [1.0]}, "workers": 2, "scheduler": "tcp://127.0.0.1:1"}, BadOption),
    ({"grid": {RATIO: {"start": 1, "stop": 2, "num": 2000}, D33: {"start": 0, "stop": 1, "num": 501}}}, SweepTooLarge),
    ({"grid": {"gradation.spread": [1.5]}, "engine": "axial_stiffness"}, BadOption),
    ({"grid": {RATIO: [1.0]}, "outputs": ["route"], "engine": "axial_stiffness"}, BadOption),
])
def test_options_that_cannot_be_are_refused(options, kind):
    # Breaks when one of them is ignored.
    with pytest.raises(kind):
        granular.sweep(BASE, **options)


@pytest.mark.parametrize("tables", [
    {"gradation": {"distribution": "lognormal", "median": "5 mm", "spread": 1.5}}, {"shape": {"aspect_ratio": 0.8}},
    {"stress": {"tensor": [[1e4, 0, 0], [0, 1e4, 0], [0, 0, 2e4]]}}, {"model": {"effects": ["packing"]}},
    {"packing": {"void_ratio": 0.6, "contact_normals": {"D33": 0.1, "D3333": 0.1}}},
], ids=lambda tables: next(iter(tables)))
def test_arrays_refuse_what_they_would_ignore(tables):
    # Breaks when a part of the scene is dropped without a word.
    with pytest.raises(BadOption, match='engine = "evaluate"'):
        granular.sweep(BASE | tables, grid={"grains.poisson_ratio": [0.1, 0.2]}, engine="axial_stiffness")


def test_waves_need_a_density():
    # Breaks when they are silently empty.
    with pytest.raises(MissingKey, match="density"):
        granular.sweep(BASE | {"grains": {"shear_modulus": 31e9, "poisson_ratio": 0.21}}, grid={RATIO: [1.0]},
                       outputs=["waves"])


def test_a_large_sweep_is_one_that_says_so():
    # Breaks when the flag is ignored; nothing is computed here.
    sweep = Sweep.of(BASE, grid={RATIO: {"start": 1, "stop": 2, "num": 2000}, D33: {"start": 0, "stop": 1, "num": 501}})
    sweep.require_size(large=True)
    with pytest.raises(SweepTooLarge, match=r"1,002,000 points \(2000 x 501\)"):
        sweep.require_size(large=False)


def test_a_scene_without_an_axis_keeps_all_its_constants_or_is_refused():
    """Six components of a stiffness that has more, or gaps in their place, would be a loss in silence."""
    tilted = BASE | {"packing": {"void_ratio": 0.5744, "contact_normals": {
        "tensor": [[0.125, 0, 0.375], [0, -0.25, 0], [0.375, 0, 0.125]]}},
        "stress": {"tensor": [[21e3, 0, 0], [0, 21e3, 0], [0, 0, 42e3]]}, "model": {"rtol": 1e-4}}
    grid = {"grains.friction_coefficient": [0.3]}
    tilted["grains"] = {key: value for key, value in BASE["grains"].items() if key != "friction_angle"}
    with pytest.raises(AxisNeeded, match="mandel"):
        granular.sweep(tilted, grid=grid, invalid="nan")
    kept = granular.sweep(tilted, grid=grid, outputs=["mandel"])
    assert abs(kept.mandel.values[0, 0, 4]) > 1e-3 * kept.mandel.values[0, 0, 0]
