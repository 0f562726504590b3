"""Scenes with grain sizes and grain shapes, from the tables of the scene file to pascals."""

from __future__ import annotations

import math
from copy import deepcopy
from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from granular import Scene, evaluate, plan
from granular.errors import FabricOutOfRange, ResultOutOfRange, RouteOutOfDomain
from granular.fabric import AxialFabric
from granular.gradation import Lognormal, length_moments
from granular.hypothesis import Hypothesis
from granular.report import evaluation_as_json
from granular.routes import axial, certified
from granular.spheroid import squared_equator, stress_carried

SOUND = {
    "grains": {"shear_modulus": "31 GPa", "poisson_ratio": 0.21},
    "packing": {"void_ratio": 0.5744},
    "stress": {"mean": "28 kPa"},
}
SIZES = {"distribution": "lognormal", "median": "5 mm", "spread": 1.5}
ULP = 2.0**-52


def scene(**tables):
    content = deepcopy(SOUND)
    for name, table in tables.items():
        content[name] = {**content.get(name, {}), **table}
    return Scene.model_validate(content)


def six(result):
    return tuple(result.stiffness.components.values())


# ---- sizes


@given(st.floats(1e-6, 1e3), st.sampled_from(["paper", "classical"]))
def test_the_mean_size_does_not_matter(median, form):
    # Breaks when a length is left over anywhere between the grain size and the stiffness.
    reference = evaluate(scene(gradation=SIZES))
    other = evaluate(scene(gradation={**SIZES, "median": median, "form": form}))
    # the moments are those of a density without unit; what is left is the error that both state
    assert six(other) == pytest.approx(six(reference), rel=other.relative_error + reference.relative_error)


@pytest.mark.parametrize("hypothesis", Hypothesis)
def test_sizes_multiply_the_stiffness_of_equal_spheres(hypothesis):
    # Breaks when the static stiffness takes <l^2> in place of 1/<l^-2>, or sizes change a ratio of components.
    model = {"hypothesis": hypothesis}
    equal, graded = evaluate(scene(model=model)), evaluate(scene(model=model, gradation=SIZES))
    moments = length_moments(Lognormal("5 mm", 1.5))
    factor = moments.second if hypothesis is Hypothesis.KINEMATIC else 1 / moments.inverse_second
    assert six(graded) == pytest.approx([factor * value for value in six(equal)], rel=graded.relative_error)
    assert graded.reference_stiffness == pytest.approx(moments.second * equal.reference_stiffness, rel=4 * ULP)


def test_contacts_per_volume_count_grains_of_the_mean_volume():
    # Breaks when the median, or the mean size, takes the place of the sphere of mean volume in eqs (8) and (11).
    result = evaluate(scene(gradation=SIZES))
    diameter = 0.005 * math.exp(math.log(1.5) ** 2 * (1 - 3 + 3 / 2))  # of (18): median, by number, mean cube
    contacts = 3 * 8.6848 / (math.pi * 1.5744 * diameter**3)
    assert result.contacts_per_volume_unit == "1/m^3"
    assert result.contacts_per_volume == pytest.approx(contacts, rel=1e-13)  # some forty roundings


def test_a_spread_that_vanishes_leaves_equal_spheres():
    # Breaks when the rules for branch lengths lose digits as the sizes become equal.
    equal = evaluate(scene())
    nearly = evaluate(scene(gradation={**SIZES, "spread": 1 + ULP}))
    assert six(nearly) == pytest.approx(six(equal), rel=nearly.relative_error)


def test_sizes_left_out_of_the_list_are_left_out_of_the_numbers():
    # Breaks when a list without gradation still changes the stiffness or the unit of contacts.
    without = evaluate(scene(gradation=SIZES, model={"effects": []}))
    assert six(without) == six(evaluate(scene()))
    assert without.contacts_per_volume_unit == "1/(2 r_e)^3"


def test_length_ratio_and_sizes_both_count():
    # Breaks when one of the two lengths replaces the other.
    longer = evaluate(scene(gradation=SIZES, branches={"length_ratio": 1.5}))
    assert longer.stiffness.C1111 == pytest.approx(2.25 * evaluate(scene(gradation=SIZES)).stiffness.C1111, rel=1e-13)


def test_no_more_accuracy_is_granted_than_the_branch_lengths_have():
    # Breaks when a bound forgets the error of the branch lengths; what is allowed must then be granted.
    graded = scene(gradation=SIZES)
    with pytest.raises(RouteOutOfDomain, match="branch lengths are known") as refused:
        plan(graded, rtol=1e-15)
    assert refused.value.allowed.startswith("allowed rtol > ")
    assert evaluate(graded, rtol=3e-14).relative_error <= 3e-14


@pytest.mark.parametrize("rtol", [2e-14, 3e-14, 1e-13, 1e-12])
@pytest.mark.parametrize("route", ["axial", "closed_form", "sphere", "certified"])
def test_what_is_granted_with_sizes_is_kept(route, rtol):
    # Breaks when the share of the branch lengths is not taken off what the route may err.
    try:
        granted = plan(scene(gradation=SIZES), rtol=rtol, route=route)
    except RouteOutOfDomain as refused:
        closest = float(refused.allowed.partition("rtol >")[2].strip("= ").split()[0].rstrip(","))
        assert evaluate(scene(gradation=SIZES), rtol=1.01 * closest, route=route).relative_error <= 1.01 * closest
        return
    assert granted.relative_error <= rtol
    assert evaluate(scene(gradation=SIZES), rtol=rtol, route=route).relative_error <= rtol


# ---- shape


@pytest.mark.parametrize(("aspect", "compression", "shear"), [
    (0.3, "51.296", "0.5083"), (0.5, "9.3649", "0.5520"), (0.8, "2.0380", "0.7447"), (0.9, "1.3983", "0.8572"),
    (1.0, "1.0000", "1.0000"), (1.1, "0.7394", "1.1767"), (2.0, "0.1140", "4.9059"), (3.0, "0.0327", "15.923")])
def test_ratios_of_spheroids(aspect, compression, shear):
    # Breaks when the branch vector, its scale, or the symmetrisation of a shaped scene is wrong; digits as tabulated.
    found = evaluate(scene(shape={"aspect_ratio": aspect})).ratios
    for ratio, printed in zip(found, (compression, shear), strict=True):
        assert f"{ratio.value:.{len(printed.partition('.')[2])}f}" == printed


@given(st.floats(-9.2, 9.2), st.sampled_from([-1.0, 0.0, 0.3, 2.0]), st.sampled_from([0.0, 1e-9, 0.21, 0.5]),
       st.booleans(), st.sampled_from(Hypothesis))
@settings(max_examples=60)
def test_the_axial_rule_serves_every_spheroid(log_aspect, D33, nu, free_spin, hypothesis):
    # Breaks when nodes do not crowd where the branches of flat or long grains change fast.
    fabric = AxialFabric(D33=D33, aspect_ratio=math.exp(log_aspect), free_spin=free_spin)
    found = axial.evaluate(fabric, poisson_ratio=nu, hypothesis=hypothesis)
    known = certified.enclose(fabric, poisson_ratio=nu, hypothesis=hypothesis)
    for value, enclosure in zip(found.components, known, strict=True):
        assert abs(Fraction(value) - enclosure.midpoint) <= Fraction(found.relative_error) * abs(enclosure.midpoint)


def test_a_sphere_of_any_spelling_is_a_sphere():
    # Breaks when aspect_ratio = 1 goes another way than no shape at all.
    assert six(evaluate(scene(shape={"aspect_ratio": 1}))) == six(evaluate(scene()))


def test_equal_volume_fixes_the_size():
    # Breaks when the unit of length is the equator or the pole of the grain in place of the equal-volume radius.
    flat = evaluate(scene(shape={"aspect_ratio": 0.5}, model={"effects": ["deviation"]}))
    assert flat.reference_stiffness == evaluate(scene()).reference_stiffness
    assert float(squared_equator(0.5)) ** 3 == pytest.approx(4.0, rel=4 * ULP)  # a^2 b = 1 with b = a/2


def test_free_spin_softens_vertical_shear_alone():
    # Breaks when the spin enters another component, or stiffens.
    fixed = evaluate(scene(shape={"aspect_ratio": 0.8}))
    free = evaluate(scene(shape={"aspect_ratio": 0.8, "spin": "relaxed"}))
    assert free.stiffness.C2323 == fixed.shear_with_free_spin
    assert free.shear_with_free_spin is None
    assert free.stiffness.C2323 < fixed.stiffness.C2323
    names = [name for name in fixed.stiffness.components if name != "C2323"]
    assert all(fixed.stiffness.components[name] == free.stiffness.components[name] for name in names)


def test_json_of_a_scene_with_sizes_and_shape():
    # Breaks when what the text shows is not in the object that programs read.
    content = evaluation_as_json(evaluate(scene(gradation=SIZES, shape={"aspect_ratio": 0.8})))
    assert content["grain_sizes"]["uniformity"] == pytest.approx(1.863, abs=5e-4)
    assert content["C2323_with_free_spin"] < content["stiffness"]["C2323"]
    assert content["effects"]["simulated"] == ["gradation", "deviation"]


def test_contact_forces_of_spheroids_are_served_by_the_axial_rule_alone():
    # Breaks when a route answers a scene that it does not serve.
    loaded = scene(shape={"aspect_ratio": 0.8}, stress={"ratio": 1.5}, grains={"friction_angle": "12 deg"})
    assert plan(loaded).route == "axial"
    for route in ("closed_form", "certified"):
        with pytest.raises(RouteOutOfDomain, match=r"aspect_ratio = 0\.8"):
            evaluate(loaded, route=route)


def test_frictionless_spheroids_that_spin_are_refused_by_name():
    # Breaks when 0/0 or a stiffness of zero reaches the user without its reason.
    loose = scene(shape={"aspect_ratio": 0.8, "spin": "relaxed"}, grains={"friction_coefficient": 0.0})
    with pytest.raises(ResultOutOfRange, match="free to spin"):
        evaluate(loose)


@pytest.mark.parametrize("aspect", [0.0, -1.0, 1e-12, 1e12, math.inf, math.nan])
def test_impossible_aspect_ratios_are_refused(aspect):
    # Breaks when a fabric is built of grains without a volume.
    with pytest.raises(FabricOutOfRange, match="aspect_ratio"):
        AxialFabric(aspect_ratio=aspect)


@pytest.mark.parametrize(("aspect", "D33"), [(0.8, 0.0), (2.0, 0.3), (1.0, -0.5)])
def test_forces_without_the_deviation_miss_the_stress_by_a_known_share(aspect, D33):
    # Breaks when the balance is averaged with other branches; here a plain sum over a fine grid in x says it again.
    n = 200_000
    across = along = 0.0
    for x in ((i + 0.5) / n for i in range(n)):
        s, y = 1 - x * x, x * x
        weight = (1 + D33 * (3 * y - 1) / 2) / math.sqrt(s + aspect**4 * y) / n
        across += weight * s / 2
        along += weight * y * aspect**2
    found = stress_carried(AxialFabric(D33=D33, aspect_ratio=aspect))
    # the midpoint rule errs by h^2/24 times a second derivative of order 10
    assert found == pytest.approx((across / (1 / 3 - D33 / 15), along / (1 / 3 + 2 * D33 / 15)), rel=1e-9)
