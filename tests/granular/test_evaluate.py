"""Evaluations: the paper's numbers, an independent integral, bounds that hold, and results that cannot be held."""

from __future__ import annotations

import json
import math
from copy import deepcopy
from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import quad

import granular
from granular import errors
from granular.contact_law import one_minus_stiffness_ratio, stiffness_ratio
from granular.report import evaluation_as_json
from granular.routes.catalogue import ROUTES
from granular.routes.result import COMPONENTS
from granular.scene import Scene

SOUND = {
    "grains": {"shear_modulus": "31 GPa", "poisson_ratio": 0.21},
    "packing": {"void_ratio": 0.5744},
    "stress": {"mean": "28 kPa"},
}
BOTH = {"effects": ["packing", "branches"]}
D33S = st.sampled_from([-1.0, 2.0, 0.0, 1e-300]) | st.floats(-1.0, 2.0)
DR33S = st.sampled_from([0.0, -0.3, math.nextafter(-1.0, 0.0), math.nextafter(2.0, 0.0)]) | st.floats(
    -1.0, 2.0, exclude_min=True, exclude_max=True)
POISSON = st.sampled_from([0.0, 0.21, 0.5, 1e-12]) | st.floats(1e-12, 0.5)
HYPOTHESES = st.sampled_from(["kinematic", "static"])


def scene(D33=0.0, Dr33=0.0, *, D3333=0.0, nu=0.21, hypothesis="kinematic", **tables):
    content = deepcopy(SOUND)
    content["grains"]["poisson_ratio"] = nu
    content["packing"]["contact_normals"] = {"D33": D33, "D3333": D3333}
    content["branches"] = {"anisotropy": {"D33": Dr33}}
    content["model"] = {"hypothesis": hypothesis, **BOTH}
    for name, table in tables.items():
        content[name] = {**content.get(name, {}), **table}
    return Scene.model_validate(content)


TABLE_II = [
    (0.0, -0.3, Fraction(678697, 466603), 1.4545, 0.8445),
    (0.3, 0.0, Fraction(4001, 4793), 0.8348, 1.0980),
    (0.3, -0.3, Fraction(452950, 368827), 1.2281, 0.9085),
]


@pytest.mark.parametrize(("D33", "Dr33", "exact", "compression", "shear"), TABLE_II, ids=["II-1", "II-2", "II-3"])
def test_table_ii(D33, Dr33, exact, compression, shear):
    # Breaks when the published table is no longer met: exactly where it is rational, and in its four known digits.
    result = granular.evaluate(scene(D33, Dr33))
    first, second = result.ratios
    assert first.exact == exact
    assert first.value == exact.numerator / exact.denominator  # the double nearest to the fraction
    assert (round(first.value, 4), round(second.value, 4)) == (compression, shear)
    six = result.stiffness.components
    assert six["C1111"] / six["C3333"] == pytest.approx(first.value, rel=4 * result.relative_error)
    assert six["C2323"] / six["C1212"] == pytest.approx(second.value, rel=4 * result.relative_error)


def test_case_2_of_table_ii_by_hand():
    # Breaks when the exact route and the paper's integrals part: with W = 1, <E x^4> and the others are sums of
    # 1/3, 1/5, 1/7 and 1/9, done here on paper for D33 = 3/10 and lambda_0 = 158/179.
    lam, D = Fraction(158, 179), Fraction(3, 10)

    def mean(power):  # of (1 + D P2) x^power over 0..1
        return Fraction(1, power + 1) * (1 - D / 2) + Fraction(3, 2) * D * Fraction(1, power + 3)

    x0, x2, x4 = mean(0), mean(2), mean(4)
    c3333 = (1 - lam) * x4 + lam * x2
    c1111 = (1 - lam) * Fraction(3, 8) * (x0 - 2 * x2 + x4) + lam * (x0 - x2) / 2
    assert c1111 / c3333 == TABLE_II[1][2]


@given(D33S, DR33S, POISSON)
@settings(max_examples=30)
def test_the_kinematic_stiffness_is_the_integral_of_eq_7(D33, Dr33, nu):
    # Breaks when a component is assembled from the wrong moments. Quadrature in x, from the table of the six
    # integrands and not from any emitted form; polynomials, so that quad is good to 1e-13.
    result = granular.evaluate(scene(D33, Dr33, nu=nu))
    lam, rest = stiffness_ratio(nu), one_minus_stiffness_ratio(nu)

    def average(integrand):
        def weighted(x):
            p2 = (3 * x * x - 1) / 2
            return (1 + D33 * p2) * (1 + Dr33 * p2) ** 2 * integrand(x * x, 1 - x * x)
        return quad(weighted, 0, 1, epsabs=0, epsrel=1e-13)[0]

    expected = (
        average(lambda x2, s: rest * 3 / 8 * s * s + lam * s / 2),
        average(lambda x2, s: rest * x2 * x2 + lam * x2),
        average(lambda x2, s: rest * s * s / 8),
        average(lambda x2, s: rest * x2 * s / 2),
        average(lambda x2, s: rest * x2 * s / 2 + lam * (x2 + s / 2) / 4),
        average(lambda x2, s: rest * s * s / 8 + lam * s / 4),
    )
    assert result.normalised == pytest.approx(expected, rel=1e-11, abs=0.0)


@given(D33S, DR33S, POISSON, HYPOTHESES)
@settings(max_examples=60)
def test_every_evaluation_carries_sound_evidence(D33, Dr33, nu, hypothesis):
    # Breaks when an admissible fabric, its boundary included, gives an unstable solid, NaN, or a bound that ball
    # arithmetic refutes.
    given_scene = scene(D33, Dr33, nu=nu, hypothesis=hypothesis)
    result = granular.evaluate(given_scene)
    proved = granular.evaluate(given_scene, route="certified")
    assert result.stiffness.is_positive_definite()
    assert proved.relative_error < 5e-16  # half a unit of the route and 1.5 units of 2^-52 of the scaling
    for name in COMPONENTS:
        found, exact = result.stiffness.components[name], proved.stiffness.components[name]
        assert abs(found - exact) <= (result.relative_error + proved.relative_error) * exact
    assert (result.stiffness.C1122 == 0.0) == (nu == 0.0)
    json.dumps(evaluation_as_json(result), allow_nan=False)


@given(D33S, DR33S, POISSON)
@settings(max_examples=30)
def test_uniform_stress_never_gives_more_than_uniform_strain(D33, Dr33, nu):
    # Breaks when the two hypotheses are swapped: the difference is positive semidefinite (Cauchy-Schwarz). Seen in
    # the bulk response and both shears; rounding of either side.
    soft, stiff = (granular.evaluate(scene(D33, Dr33, nu=nu, hypothesis=name)).stiffness.components
                   for name in ("static", "kinematic"))
    for weights in ({"C2323": 1}, {"C1212": 1}, {"C3333": 1}, {"C1111": 1, "C1122": 1},
                    {"C3333": 1, "C1111": 2, "C1122": 2, "C1133": 4}):
        low, high = (sum(weight * six[name] for name, weight in weights.items()) for six in (soft, stiff))
        assert low <= high * (1 + 1e-14)


def test_the_isotropic_assembly_of_the_paper():
    # Breaks when the numbers in MPa move (the paper's own are about 9.81 times too large).
    stiffness = granular.evaluate(Scene.model_validate(SOUND)).stiffness
    in_megapascals = [round(value / 1e6, 1) for value in stiffness.components.values()]
    assert in_megapascals == [556.8, 556.8, 13.7, 13.7, 271.5, 271.5]


@pytest.mark.parametrize(("route", "hypothesis"), [
    (name, hypothesis) for name in ROUTES for hypothesis in ("kinematic", "static")
    if (name, hypothesis) != ("exact", "static")])  # static components are not rational
def test_all_routes_agree_within_their_bounds(route, hypothesis):
    # Breaks when one of the ways of computing drifts, with the fourth-rank fabric switched on.
    given_scene = scene(0.3, -0.3, D3333=0.1, hypothesis=hypothesis)
    found, exact = (granular.evaluate(given_scene, route=name) for name in (route, "certified"))
    bound = found.relative_error + exact.relative_error
    assert found.normalised == pytest.approx(exact.normalised, rel=bound, abs=0.0)


def test_a_coarse_rule_still_gives_a_transversely_isotropic_solid():
    # Breaks when the scatter of a coarse rule contradicts the symmetry, or its bound is not widened for the repair.
    given_scene = scene(1.0, -0.3, hypothesis="static")
    coarse, exact = granular.evaluate(given_scene, route="sphere", rtol=1e-2), granular.evaluate(given_scene)
    assert coarse.stiffness.is_transversely_isotropic()
    assert coarse.relative_error < 1e-2
    assert coarse.normalised == pytest.approx(exact.normalised, rel=coarse.relative_error)


def test_effects_left_out_of_the_list_are_left_out_of_the_numbers():
    # Breaks when the list only changes the report.
    ideal = granular.evaluate(Scene.model_validate(SOUND))
    assert granular.evaluate(scene(0.3, -0.3, model={"effects": []})).stiffness == ideal.stiffness
    assert granular.evaluate(scene(0.3, -0.3, model={"effects": ["packing"]})).stiffness == granular.evaluate(
        scene(0.3, 0.0)).stiffness


@given(st.floats(1e-3, 1e3))
def test_length_ratio_enters_squared(length_ratio):
    # Breaks when l_e is forgotten, or enters k_n as well. Three roundings.
    longer = granular.evaluate(scene(branches={"length_ratio": length_ratio}))
    assert longer.reference_stiffness == pytest.approx(
        length_ratio**2 * granular.evaluate(scene()).reference_stiffness, rel=3 * 2.0**-53)


@given(st.floats(1e-3, 1e9))
def test_stiffness_grows_with_the_cube_root_of_the_stress(mean):
    # Breaks when the Hertz exponent moves. One rounding on either side and one in cbrt's argument.
    assert granular.evaluate(scene(stress={"mean": mean})).reference_stiffness == pytest.approx(
        math.cbrt(mean / 28e3) * granular.evaluate(scene()).reference_stiffness, rel=1e-15)


def test_the_stress_ratio_leaves_the_list_alone():
    # Breaks when anything but the mean stress enters while kinetic fabric is left out.
    assert granular.evaluate(scene(0.3, stress={"ratio": 3.0})).stiffness == granular.evaluate(scene(0.3)).stiffness
    tensor = [["14 kPa", 0, 0], [0, "14 kPa", 0], [0, 0, "56 kPa"]]
    content = {**SOUND, "stress": {"tensor": tensor}, "model": BOTH}
    assert granular.evaluate(Scene.model_validate(content)).stiffness == granular.evaluate(
        Scene.model_validate(SOUND)).stiffness


def test_contacts_per_volume_say_their_unit():
    # Breaks when a number per cube of a diameter could be taken for one per cubic metre.
    result = granular.evaluate(scene())
    assert result.contacts_per_volume == pytest.approx(3 * 8.6848 / (math.pi * 1.5744), rel=1e-15)
    assert result.contacts_per_volume_unit == "1/(2 r_e)^3"


def test_waves_need_a_density_and_use_that_of_the_assembly():
    # Breaks when the density of the grains is taken for that of the assembly: speeds would be 25 % too low.
    assert granular.evaluate(scene()).waves is None
    result = granular.evaluate(scene(0.3, grains={"density": "2650 kg/m^3"}))
    assert result.waves.density == 2650 / 1.5744
    # two roundings, a division and a square root
    assert result.waves.vertical.P == pytest.approx(math.sqrt(result.stiffness.C3333 / (2650 / 1.5744)), rel=1e-14)


@pytest.mark.parametrize("tables", [
    {"grains": {"shear_modulus": 1e308}, "stress": {"mean": 1e308}},
    {"grains": {"shear_modulus": 1e-310}, "stress": {"mean": 1e-310}},
    {"branches": {"length_ratio": 1e200}}, {"branches": {"length_ratio": 1e-200}},
    {"grains": {"shear_modulus": 1.7e308}, "stress": {"mean": 1e308}, "branches": {"length_ratio": 2.0}},
    {"packing": {"coordination_number": 5e-324}, "grains": {"shear_modulus": 1e-150}, "stress": {"mean": 1e-150}},
])
def test_a_result_that_double_precision_cannot_hold_is_refused(tables):
    # Breaks when infinity, zero or a subnormal number is handed out as a stiffness.
    with pytest.raises(errors.ResultOutOfRange, match="shear_modulus"):
        granular.evaluate(scene(0.3, -0.3, **tables))


def test_a_component_that_loses_its_digits_is_refused():
    # Breaks when C1122 = (1 - lambda_0) p0/8 with a tiny Poisson ratio underflows silently.
    with pytest.raises(errors.ResultOutOfRange, match="C1122"):
        granular.evaluate(scene(nu=5e-324))
    with pytest.raises(errors.ResultOutOfRange, match="C1122"):  # each factor is an ordinary number, the product not
        granular.evaluate(scene(nu=1e-9, branches={"length_ratio": 1e-154}, stress={"mean": 1e-3}))
    assert granular.evaluate(scene(nu=1e-290)).stiffness.C1122 > 0


@pytest.mark.parametrize(("density", "void_ratio"), [(1e-320, 0.5), (1e-300, 1e300)])
def test_densities_outside_double_precision_are_refused(density, void_ratio):
    # Breaks when a bulk density of zero, or one that has lost its digits, reaches the wave speeds.
    with pytest.raises(errors.GranularError, match="density"):
        granular.evaluate(scene(grains={"density": density},
                                packing={"void_ratio": void_ratio, "coordination_number": 6.0}))


@pytest.mark.parametrize(("modulus", "density"), [(1e300, 1e-300), (1e-290, 1e300), (1e300, 1e300)])
def test_extreme_waves_are_finite(modulus, density):
    # Breaks when a speed is formed as the square root of a quotient that overflows.
    waves = granular.evaluate(scene(0.3, grains={"density": density, "shear_modulus": modulus})).waves
    assert all(0 < speed < math.inf for speed in (waves.vertical.P, waves.horizontal.SH, waves.fastest_shear.speed))


def test_long_decimals_have_a_ratio_too():
    # Breaks when the exact fraction of a 17-digit input is anything but the ratio of the components.
    result = granular.evaluate(scene(0.1234567890123456, -0.30000000000000004, nu=0.21000000000000002))
    first, _ = result.ratios
    assert first.value == float(first.exact)
    assert first.value == pytest.approx(result.stiffness.C1111 / result.stiffness.C3333, rel=1e-14)
    assert granular.evaluate(scene(0.3, hypothesis="static")).ratios[0].exact is None


def test_json_holds_the_whole_answer():
    # Breaks when a key of the interface is lost, a number is rounded, or the matrix is not the components.
    result = granular.evaluate(scene(0.3, -0.3, grains={"density": 2650}))
    content = json.loads(json.dumps(evaluation_as_json(result), allow_nan=False))
    assert set(content) == {"stiffness", "relative_error", "error_is", "axis", "reference_stiffness", "hypothesis",
                            "route", "evaluations", "work", "effects", "contacts_per_volume",
                            "contacts_per_volume_unit", "waves"}
    assert (content["error_is"], content["axis"]) == ("bound", [0.0, 0.0, 1.0])
    assert content["work"] == {"operations": 103, "functions": 0}  # what the emitted form says of itself
    for name in ("relative_error", "reference_stiffness", "hypothesis", "route", "evaluations", "contacts_per_volume",
                 "contacts_per_volume_unit"):
        assert content[name] == getattr(result, name)
    for name in COMPONENTS:
        assert content["stiffness"][name] == result.stiffness.component(name)
    assert content["stiffness"]["mandel"] == result.stiffness.mandel().tolist()
    assert content["effects"] == {"simulated": ["packing", "branches"],
                                  "not_called_for": result.effects_not_called_for}
    assert set(content["waves"]) == {"density", "vertical", "horizontal", "thomsen"}
