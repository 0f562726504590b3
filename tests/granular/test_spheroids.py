"""Aligned spheroids: exact identities, the stored table, every route against the others, and what is refused."""

from __future__ import annotations

import importlib.util
import math
import sys
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from granular.checks.spheroid_cases import spheroid_sample
from granular.checks.stored import spheroid_cases
from granular.errors import ConflictingKeys, FabricOutOfRange, ResultOutOfRange, RouteOutOfDomain
from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.loading import Loading
from granular.routes import axial, certified, closed_form, exact, sphere
from granular.spheroid import branch_vectors, squared_equator

patient = settings(deadline=None, max_examples=60)  # a time limit would be a verdict on a busy machine
shapes = st.floats(-4, 4).map(lambda power: 10.0**power) | st.floats(-15, -1).map(lambda power: 1 + 10.0**power)
NEXT_TO_ONE = (1 - 2.0**-53, 1 + 2.0**-52, 1 - 1e-8, 1 + 1e-8)

# nu = 0.21, D = 0: b/a, C1111/C3333, C2323/C1212, and C2323 with free spin over the one without
TABLE = {0.3: ("51.296", ".5083", ".0716"), 0.5: ("9.3649", ".5520", ".3401"), 0.7: ("3.1317", ".6587", ".7276"),
         0.8: ("2.0380", ".7447", ".8801"), 0.9: ("1.3983", ".8572", ".9716"), 0.95: ("1.1771", ".9246", ".9932"),
         1.1: (".7394", "1.1767", ".9769"), 1.5: (".2790", "2.2969", ".6749"), 2.0: (".1140", "4.9059", ".3584"),
         3.0: (".0327", "15.923", ".1173")}


def by_axial(fabric: AxialFabric, nu: float = 0.21, hypothesis: Hypothesis = Hypothesis.KINEMATIC,
             loading: Loading | None = None) -> tuple[float, ...]:
    """Six components by the rule along the meridian."""
    return axial.evaluate(fabric, poisson_ratio=nu, hypothesis=hypothesis, loading=loading).components


@pytest.mark.parametrize("shape", TABLE)
def test_the_stored_table_from_certified_values(shape: float) -> None:
    """Certified components, whose decimals are proved, round to other ratios than the stored ones."""
    found = [certified.enclose(AxialFabric(aspect_ratio=shape, free_spin=spin), poisson_ratio=0.21,
                               hypothesis=Hypothesis.KINEMATIC) for spin in (False, True)]
    fixed, free = ({one.name: one.midpoint for one in six} for six in found)
    ratios = (fixed["C1111"] / fixed["C3333"], fixed["C2323"] / fixed["C1212"], free["C2323"] / fixed["C2323"])
    for ratio, printed in zip(ratios, TABLE[shape], strict=True):
        unit = Fraction(1, 10 ** len(printed.split(".")[1]))
        assert abs(ratio - Fraction(printed)) <= unit / 2, printed


def test_the_stored_cases_hold_the_table() -> None:
    """A row of the table has no certified case, so that `granular check` does not see it."""
    ordinary = {case.fabric.aspect_ratio for case in spheroid_cases() if case.family == "spheroids: ordinary"}
    assert ordinary == set(TABLE)


@patient
@given(shapes, st.floats(-1, 2), st.sampled_from([0.0, 0.21, 0.5]))
def test_exact_identities(shape: float, d33: float, nu: float) -> None:
    """The sum that is <E> = 1 for every shape, isotropy about axis 3, or zeros at nu = 0, are not kept.

    (s + y)(s + r^2 y)/Q = 1 makes 2 (C1111 + C1122) + C3333/r^2 + 2 (1 + 1/r^2) C1133 = r^(-2/3), whatever k_r is.
    """
    c1111, c3333, c1122, c1133, _, c1212 = by_axial(AxialFabric(D33=d33, aspect_ratio=shape), nu)
    squared = shape**-2
    total = 2 * (c1111 + c1122) + c3333 * squared + 2 * (1 + squared) * c1133
    assert total == pytest.approx(shape ** (-2 / 3), rel=4e-15)  # all terms are positive, each good to 2e-15
    assert c1111 - c1122 == pytest.approx(2 * c1212, rel=4e-15)
    if nu == 0:
        assert c1122 == c1133 == 0


@patient
@given(shapes, st.floats(-1, 2), st.just(0.0) | st.floats(1e-12, 0.5), st.floats(0.2, 5))
def test_free_spin_never_stiffens(shape: float, d33: float, nu: float, ratio: float) -> None:
    """Grains that are free to spin resist shear more than those that are not, or anything but C2323 changes."""
    fabric = AxialFabric(D33=d33, aspect_ratio=shape)
    for loading in (None, Loading.of_ratio(ratio), Loading.of_ratio(ratio, friction=0.3)):
        fixed, free = (by_axial(replace(fabric, free_spin=spin), nu, loading=loading) for spin in (False, True))
        assert free[4] <= fixed[4] * (1 + 4e-15)
        assert [*free[:4], free[5]] == pytest.approx([*fixed[:4], fixed[5]], rel=2e-15)


def test_spin_means_nothing_for_isotropic_spheres() -> None:
    """Spheres without fabric carry a net couple when they turn with the mean deformation."""
    fixed, free = (by_axial(AxialFabric(free_spin=spin)) for spin in (False, True))
    assert free == pytest.approx(fixed, rel=1e-15)
    # with a fabric contacts do turn them
    fixed, free = (by_axial(AxialFabric(D33=0.5, free_spin=spin)) for spin in (False, True))
    assert free[4] < fixed[4] * (1 - 1e-4)


@pytest.mark.parametrize("hypothesis", Hypothesis)
@pytest.mark.parametrize("shape", NEXT_TO_ONE)
@pytest.mark.parametrize("loading", [None, Loading.of_ratio(1.2), Loading.of_ratio(1.2, friction=0.5)], ids=str)
def test_spheres_are_met_from_both_sides(shape: float, loading: Loading | None, hypothesis: Hypothesis) -> None:
    """The rule of spheroids does not go over into that of spheres: a component jumps at r = 1."""
    fabric = AxialFabric(D33=0.3)
    spheres = by_axial(fabric, hypothesis=hypothesis, loading=loading)
    near = by_axial(replace(fabric, aspect_ratio=shape), hypothesis=hypothesis, loading=loading)
    # no component changes faster than 4 times itself with r; two routes with 2e-15 each
    assert near == pytest.approx(spheres, rel=4 * abs(shape - 1) + 4e-15)


def test_every_voice_says_the_same() -> None:
    """A route leaves its declared error of the certified value, on random shapes under both hypotheses."""
    served: dict[str, int] = {}
    for case in spheroid_sample(80, seed=12):
        for hypothesis in (Hypothesis.KINEMATIC,) if case.fabric.free_spin else Hypothesis:
            known = certified.enclose(case.fabric, poisson_ratio=case.poisson_ratio, hypothesis=hypothesis)
            for route in (axial, closed_form, sphere):
                try:
                    found = route.evaluate(case.fabric, poisson_ratio=case.poisson_ratio, hypothesis=hypothesis)
                except RouteOutOfDomain:
                    continue
                served[route.NAME] = served.get(route.NAME, 0) + 1
                for value, one in zip(found.components, known, strict=True):
                    assert abs(Fraction(value) - one.midpoint) <= Fraction(found.relative_error) * one.midpoint
    assert served["axial"] > 100 and served["closed_form"] > 30 and served["sphere"] > 30


@patient
@given(st.floats(0.6, 1.6), st.floats(-0.9, 1.8), st.floats(0.4, 2.5))
def test_contact_forces_against_the_whole_sphere(shape: float, d33: float, ratio: float) -> None:
    """Forces between spheroids are not the same along the meridian and on the sphere, where nothing is axial."""
    fabric, loading = AxialFabric(D33=d33, aspect_ratio=shape), Loading.of_ratio(ratio)
    for spin in (False, True):
        found = sphere.evaluate(replace(fabric, free_spin=spin), poisson_ratio=0.3, hypothesis=Hypothesis.KINEMATIC,
                                loading=loading, rtol=1e-6)
        assert by_axial(replace(fabric, free_spin=spin), 0.3, loading=loading) == pytest.approx(
            found.components, rel=found.relative_error)


def test_static_forces_of_spheroids_against_the_whole_sphere() -> None:
    """Balanced forces are carried by other branches along the meridian than on the sphere."""
    for shape in (0.7, 1.3):
        for loading in (None, Loading.of_ratio(1.2), Loading.of_ratio(1.1, friction=0.6)):
            fabric = AxialFabric(D33=0.3, aspect_ratio=shape)
            found = sphere.components_by_degree(fabric, poisson_ratio=0.21, hypothesis=Hypothesis.STATIC, degree=131,
                                                loading=loading)
            known = by_axial(fabric, hypothesis=Hypothesis.STATIC, loading=loading)
            assert found == pytest.approx(known, rel=1e-8 if loading is None or loading.friction is None else 1e-3)


def certify() -> Any:
    """The script that remakes the stored values."""
    path = Path(__file__).with_name("certify_spheroid.py")
    spec = importlib.util.spec_from_file_location("certify_spheroid", path)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module  # its dataclass asks for it
    spec.loader.exec_module(module)
    return module


def test_the_stored_inputs_are_those_of_the_script() -> None:
    """The stored file was not remade after the script changed."""
    script, stored = certify(), spheroid_cases()
    cases = [*script.equal_cases(), *script.force_cases()]
    assert [(f"spheroids: {case.family}", case.why, case.aspect_ratio, case.D33, case.D3333, case.spin == "relaxed",
             case.poisson_ratio, case.friction) for case in cases] == [
        (case.family, case.why, case.fabric.aspect_ratio, case.fabric.D33, case.fabric.D3333, case.fabric.free_spin,
         case.poisson_ratio, case.loading.friction if case.loading else None) for case in stored]


@pytest.mark.parametrize(("shape", "spin"), [(0.5, "fixed"), (1e4, "relaxed")])
def test_the_quadrature_of_the_script_against_ball_arithmetic(shape: float, spin: str) -> None:
    """What was stored for contact forces rests on a quadrature that is wrong where balls can tell.

    With half as many nodes as for the stored values the error is the root of theirs.
    """
    script = certify()
    case = script.Case(family="", why="", aspect_ratio=shape, D33=0.3, spin=spin)
    for name, six in script.components(case, halvings=3).items():
        known = certified.enclose(AxialFabric(D33=0.3, aspect_ratio=shape, free_spin=spin == "relaxed"),
                                  poisson_ratio=0.21, hypothesis=Hypothesis(name))
        for value, one in zip(six, known, strict=True):
            assert abs(value / script.exact(one.midpoint) - 1) < 1e-14, (name, one.name)


@pytest.mark.parametrize("aspect_ratio", [1.0, 0.8, 3.0])
def test_the_volume_of_a_grain_is_that_of_a_sphere(aspect_ratio: float) -> None:
    """a^2 b = r_e^3 is not kept, or its cube root has lost digits."""
    squared = squared_equator(aspect_ratio)
    assert abs(squared**3 * Fraction(aspect_ratio) ** 2 - 1) < Fraction(1, 10**37)
    assert squared_equator(8.0) == pytest.approx(Fraction(1, 4), rel=1e-37)


@patient
@given(st.floats(0.1, 10), st.floats(0, math.pi), st.floats(0, 2 * math.pi))
def test_branches_end_on_the_surface(shape: float, polar: float, azimuth: float) -> None:
    """Half a branch is not a point of the spheroid whose normal is n, or spheroids touch elsewhere."""
    n = [math.sin(polar) * math.cos(azimuth), math.sin(polar) * math.sin(azimuth), math.cos(polar)]
    equator = shape ** (-1 / 3)
    axes = (equator, equator, equator * shape)
    point = [float(component) for component in branch_vectors(shape, n)]  # half of l over r_e, as l over 2 r_e
    assert sum((p / axis) ** 2 for p, axis in zip(point, axes, strict=True)) == pytest.approx(1, rel=1e-14)
    normal = [p / axis**2 for p, axis in zip(point, axes, strict=True)]
    steepness = math.sqrt(sum(component**2 for component in normal))
    assert [component / steepness for component in normal] == pytest.approx(n, abs=1e-14)


def test_spheroids_without_friction_that_spin_have_no_shear_stiffness() -> None:
    """A zero stiffness, or one of rounding errors, passes for a result."""
    fabric, loading = AxialFabric(aspect_ratio=0.8, free_spin=True), Loading.of_ratio(1.0, friction=0.0)
    with pytest.raises(ResultOutOfRange, match="free to spin"):
        by_axial(fabric, loading=loading)
    assert min(by_axial(replace(fabric, free_spin=False), loading=loading)) > 0


@pytest.mark.parametrize("aspect_ratio", [0.0, -1.0, 1e-12, 1e12, math.nan, math.inf])
def test_shapes_that_are_none(aspect_ratio: float) -> None:
    """An aspect ratio that is not positive, not finite, or beyond what doubles carry is taken."""
    with pytest.raises(FabricOutOfRange, match="aspect_ratio"):
        AxialFabric(aspect_ratio=aspect_ratio)


@pytest.mark.parametrize("options", [{"aspect_ratio": 0.8}, {"free_spin": True}])
def test_a_shape_has_its_own_branches(options: dict[str, Any]) -> None:
    """A branch-length weight is silently ignored beside a shape."""
    with pytest.raises(ConflictingKeys, match="Dr33"):
        AxialFabric(Dr33=0.1, **options)


@pytest.mark.parametrize(("route", "fabric", "hypothesis", "loading", "words"), [
    (closed_form, AxialFabric(aspect_ratio=3.0000000000000004), Hypothesis.KINEMATIC, None, "1/3"),
    (closed_form, AxialFabric(aspect_ratio=0.5), Hypothesis.STATIC, None, "1/3"),
    (closed_form, AxialFabric(aspect_ratio=0.5), Hypothesis.KINEMATIC, Loading.of_ratio(1.0), "equal stiffness"),
    (exact, AxialFabric(aspect_ratio=0.5), Hypothesis.KINEMATIC, None, "along the contact normals"),
    (certified, AxialFabric(aspect_ratio=0.5), Hypothesis.KINEMATIC, Loading.of_ratio(1.0), "equal stiffness"),
    (sphere, AxialFabric(aspect_ratio=1e-3), Hypothesis.KINEMATIC, None, "degree 131"),
])
def test_routes_say_what_they_do_not_serve(route: Any, fabric: AxialFabric, hypothesis: Hypothesis,
                                           loading: Loading | None, words: str) -> None:
    """A route answers for spheroids where it promises nothing."""
    with pytest.raises(RouteOutOfDomain, match=words):
        route.evaluate(fabric, poisson_ratio=0.21, hypothesis=hypothesis, loading=loading)
