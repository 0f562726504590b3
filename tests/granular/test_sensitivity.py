"""``sensitivity``: slopes in pascals against differences of evaluated scenes, what is held fixed, and refusals."""

import json

import pytest

import granular
from granular.commands import run_command
from granular.errors import SlopesNotBuilt

SAND = {"grains": {"shear_modulus": "31 GPa", "poisson_ratio": 0.21, "friction_angle": "25 deg"},
        "packing": {"void_ratio": 0.62, "contact_normals": {"D33": 0.3}},
        "branches": {"anisotropy": {"D33": -0.2}, "length_ratio": 0.98},
        "stress": {"mean": "120 kPa", "ratio": 1.6}}

HOME = {"D33": ("packing", "contact_normals", "D33"), "Dr33": ("branches", "anisotropy", "D33"),
        "stress_ratio": ("stress", "ratio"), "poisson_ratio": ("grains", "poisson_ratio"),
        "void_ratio": ("packing", "void_ratio"), "mean_stress": ("stress", "mean"),
        "shear_modulus": ("grains", "shear_modulus"), "length_ratio": ("branches", "length_ratio"),
        "coordination_number": ("packing", "coordination_number"),
        "friction_coefficient": ("grains", "friction_coefficient")}


def changed(tables, place, value):
    tables = json.loads(json.dumps(tables))
    at = tables
    for key in place[:-1]:
        at = at.setdefault(key, {})
    at[place[-1]] = value
    if place[-1] == "friction_coefficient":
        at.pop("friction_angle", None)
    return tables


def difference(tables, name, value):
    """Five-point difference; errs by its fourth power times a fifth derivative, 1e-9 of a slope or less."""
    h = 1e-3 * max(abs(value), 0.1)

    def components(step):
        scene = granular.Scene(**changed(tables, HOME[name], value + step * h))
        return granular.evaluate(scene).stiffness.components.values()

    points = zip(*(components(step) for step in (-2, -1, 1, 2)), strict=True)
    return [(a - 8 * b + 8 * c - d) / (12 * h) for a, b, c, d in points]


@pytest.mark.parametrize("hypothesis", ["kinematic", "static"])
@pytest.mark.parametrize("graded", [False, True])
def test_slopes_are_those_of_evaluate(hypothesis, graded):
    # a factor to pascals that is held where it moves, or a coordination number that does not follow the void ratio
    tables = {**SAND, "model": {"hypothesis": hypothesis}}
    if graded:
        tables["gradation"] = {"distribution": "lognormal", "median": "1 mm", "spread": 1.3}
    scene = granular.Scene(**tables)
    found = granular.sensitivity(scene)
    exact = granular.evaluate(scene).stiffness.components
    assert found.stiffness.components == pytest.approx(exact, rel=1e-14)
    assert {slope.name for slope in found.by} == set(HOME)
    for slope in found.by:
        wanted = difference(tables, slope.name, slope.value)
        scale = max(map(abs, wanted))
        assert list(slope.slopes) == pytest.approx(wanted, rel=1e-8, abs=1e-8 * scale), slope.name


def test_given_coordination_number_stays():
    scene = granular.Scene(**changed(SAND, ("packing", "coordination_number"), 7.0))
    assert granular.sensitivity(scene).logarithmic("void_ratio")[0] == pytest.approx(-2 / 3 * 0.62 / 1.62, rel=1e-14)
    assert granular.sensitivity(scene)["void_ratio"].note == "at fixed N"


def test_isotropic_scene_has_the_slopes_of_the_model_beside_it():
    # without forces the D33 slope would be half the one by Dr33; with them it is 13/30
    scene = granular.Scene(grains={"shear_modulus": "31 GPa", "poisson_ratio": 0.21}, packing={"void_ratio": 0.6},
                           stress={"mean": "100 kPa"})
    found = granular.sensitivity(scene)
    assert [d / dr for d, dr in zip(found["D33"].slopes, found["Dr33"].slopes, strict=True)] == pytest.approx(
        [13 / 30] * 6, rel=1e-12)
    assert found["D33"].note == ""
    rubbing = granular.Scene(grains={"shear_modulus": "31 GPa", "poisson_ratio": 0.21, "friction_angle": "20 deg"},
                             packing={"void_ratio": 0.6}, stress={"mean": "100 kPa"})
    assert "corner" in granular.sensitivity(rubbing)["D33"].note


def test_vanishing_component_has_no_relative_slope():
    tables = changed(SAND, ("grains", "poisson_ratio"), 0.0)
    del tables["grains"]["friction_angle"]
    found = granular.sensitivity(granular.Scene(**tables))
    assert found.relative("D33")[2] is None
    assert found.logarithmic("void_ratio")[3] is None
    assert found["poisson_ratio"].slopes[2] > 0


@pytest.mark.parametrize(("place", "value", "named"), [
    (("packing", "contact_normals", "D3333"), 0.1, "D3333"),
    (("stress",), {"tensor": [[1e5, 0, 0], [0, 1e5, 0], [0, 0, -1e4]]}, "compress"),
    (("stress",), {"tensor": [[1e5, 0, 0], [0, 2e5, 0], [0, 0, 1e5]]}, "axis 3"),
])
def test_scenes_without_slopes_are_refused(place, value, named):
    with pytest.raises(SlopesNotBuilt) as refusal:
        granular.sensitivity(granular.Scene(**changed(SAND, place, value)))
    assert named in str(refusal.value)


def test_shape_is_refused():
    with pytest.raises(SlopesNotBuilt, match="shape"):
        granular.sensitivity(granular.Scene(
            grains={"shear_modulus": "31 GPa", "poisson_ratio": 0.21}, packing={"void_ratio": 0.6},
            shape={"aspect_ratio": 0.8}, stress={"mean": "100 kPa"}))


def test_command(capsys):
    assert run_command(["sensitivity", "book/_data/sand.toml", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert set(told) == {"stiffness", "by"}
    assert told["by"]["mean_stress"]["logarithmic"]["C3333"] == pytest.approx(1 / 3)
    assert set(told["by"]["D33"]) == {"value", "unit", "note", "slope", "relative", "logarithmic"}
    assert run_command(["sensitivity", "book/_data/sand.toml"]) == 0
    assert "to first order" in capsys.readouterr().out
