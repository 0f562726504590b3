"""``fit``: known fabrics given back, intervals that cover, what cannot be told apart, refusals."""

import json
from copy import deepcopy

import numpy as np
import pint
import pytest

import granular
from granular.commands import run_command
from granular.errors import (
    ConflictingKeys,
    GranularError,
    MeasurementsTooFew,
    MissingKey,
    UnknownChoice,
    ValueOutOfRange,
)
from granular.fitting import Data
from granular.fitting.problem import Problem
from granular.fitting.quantities import SPEED, quantity, reading
from granular.fitting.solver import minima
from granular.units import in_si

SPEEDS = ("Vp_vertical", "Vp_horizontal", "Vs_vh", "Vs_hh")


def measured(D33, Dr33, ratios, names=SPEEDS, *, share=0.01, friction=None, hypothesis="kinematic", e=0.6,
             factors=(1, 1), noise=None, **fit):
    """Tables of a data file with what a known fabric gives."""
    states = []
    grains = {"shear_modulus": 31e9, "poisson_ratio": 0.21, "density": 2650.0}
    if friction is not None:
        grains["friction_coefficient"] = friction
    for ratio in ratios:
        stress = {"mean": 1e5 * (2 + ratio) / 3, "ratio": ratio}
        found = granular.evaluate(granular.Scene(
            grains=grains, packing={"void_ratio": e, "contact_normals": {"D33": D33}}, stress=stress,
            branches={"anisotropy": {"D33": Dr33}}, model={"hypothesis": hypothesis}))
        components = {name: value * factors[name in ("C2323", "C1212")]
                      for name, value in found.stiffness.components.items()}
        state = {"stress": stress}
        for name in names:
            kind = quantity(name)
            value = float(np.prod([c**p for c, p in zip(components.values(), kind.powers, strict=True)])
                          * found.density**kind.density_power)
            scatter = 0.0 if noise is None else noise.standard_normal()
            state[name] = {"value": value * (1 + share * scatter), "uncertainty": share * value}
        states.append(state)
    return {"grains": grains, "packing": {"void_ratio": e}, "model": {"hypothesis": hypothesis}, "measured": states,
            "fit": fit}


@pytest.mark.parametrize("options", [
    {"ratios": [1.0, 2.0], "scale": "modes", "factors": (0.6, 0.4)},
    {"ratios": [0.6, 1.5, 2.5], "scale": "common modes", "factors": (0.6, 0.4)},
    {"ratios": [1.0], "scale": "none"},
    {"ratios": [1.0, 1.5], "scale": "states", "hypothesis": "static", "factors": (0.7, 0.7)},
    {"ratios": [1.5], "scale": "common", "factors": (2, 2),
     "names": ("C1111", "C3333", "C2323/C1212", "C1122", "C1133")},
])
def test_data_without_noise_give_the_fabric_back(options):
    # a slope of the wrong sign, a factor on the wrong mode, a density that is forgotten; eight digits are asked for
    # although the valley is so flat that chi-square tells only the square root of its own digits
    found = granular.fit(measured(0.3, -0.2, **options))
    values = [one.value for one in found.estimates]
    assert found.chi_square < 1e-20
    if options["ratios"] == [1.5]:  # another fabric and factor give the very same data, and it is nearer to isotropy
        [twin] = found.others
        assert twin["chi_square"] < 1e-20
        assert [twin["D33"], twin["Dr33"]] == pytest.approx([0.3, -0.2], abs=1e-8)
        assert sum(value**2 for value in values) < 0.3**2 + 0.2**2
        return
    assert values == pytest.approx([0.3, -0.2], abs=1e-8)
    for factor in found.factors:
        true = options.get("factors", (1, 1))["shear" in factor.name]
        assert factor.value == pytest.approx(true, rel=1e-8)


def test_fabric_with_friction_is_given_back():
    found = granular.fit(measured(0.4, 0.1, [1.0, 1.8], friction=0.5, scale="none"))
    assert [one.value for one in found.estimates] == pytest.approx([0.4, 0.1], abs=1e-8)


def test_other_unknowns():
    tables = measured(0.2, 0.0, [1.0, 2.0], scale="none", unknowns=["D33", "coordination_number"], e=0.7)
    found = granular.fit(tables)
    assert found["D33"].value == pytest.approx(0.2, abs=1e-8)
    assert found["coordination_number"].value == pytest.approx((1.66 - 0.7) / 0.125, rel=1e-8)
    tables = measured(0.3, 0.0, [1.6, 2.2], friction=0.35, scale="common", unknowns=["D33", "friction_coefficient"])
    del tables["grains"]["friction_coefficient"]
    found = granular.fit(tables)
    assert [one.value for one in found.estimates] == pytest.approx([0.3, 0.35], abs=1e-8)


def test_residuals_have_the_slopes_that_are_claimed():
    # any error in the chain of logarithms, powers and factors; central differences err by 1e-9 here
    tables = measured(0.3, -0.2, [1.0, 2.0], friction=0.5, scale="modes")
    problem = Problem.of(Data.of_tables(tables))
    at = np.array([0.2, 0.1, 0.3, -0.2, 0.1, 0.2])
    _, slopes = problem.residuals(at)
    h = 1e-6 * np.eye(at.size)
    numeric = [(problem.residuals(at + step)[0] - problem.residuals(at - step)[0]) / 2e-6 for step in h]
    np.testing.assert_allclose(slopes.T, numeric, rtol=1e-6, atol=1e-6 * abs(slopes).max())


def test_best_factors_are_those_of_the_whole_fit():
    problem = Problem.of(Data.of_tables(measured(0.3, -0.2, [1.0, 2.0], scale="modes",
                                                 noise=np.random.default_rng(3))))
    best = minima(problem)[0]
    factors, chi_square = problem.best_factors(best.unknowns[:2])
    np.testing.assert_allclose(factors, best.unknowns[2:], atol=1e-7)
    assert chi_square == pytest.approx(best.chi_square, rel=1e-10)


def test_valley_of_the_isotropic_state():
    # equal contacts: D33 + 2 Dr33 alone is seen at first order; forces: 13/15 D33 + 2 Dr33
    for effects, weight in ((["packing", "branches"], 2.0), ("auto", 30 / 13)):
        tables = measured(0.0, 0.0, [1.0], scale="states")
        tables["model"] = {"effects": effects}
        problem = Problem.of(Data.of_tables(tables))
        _, slopes = problem.residuals(np.zeros(problem.size))
        # the slopes of every measurement by both unknowns are in the same proportion, to rounding
        np.testing.assert_allclose(slopes[:, 1], weight * slopes[:, 0], rtol=1e-12)


def test_combination_that_is_known_best():
    found = granular.fit(measured(0.05, -0.02, [1.0], scale="states"))
    best, worst = found.combinations
    assert best.coefficients[1] == pytest.approx(30 / 13, rel=0.05)  # of first order, at a fabric of a few hundredths
    assert best.standard_error < worst.standard_error / 30
    [twin] = found.others  # in one isotropic state two fabrics give the very same speeds
    assert [twin["D33"], twin["Dr33"]] == pytest.approx([0.05, -0.02], abs=1e-8)
    assert best.value == pytest.approx(sum(one.value * weight for one, weight in zip(
        found.estimates, best.coefficients, strict=True)), rel=1e-12)


def test_standard_errors_cover():
    # 30 noisy copies of one experiment: squared distances from the truth over the covariance add up to chi-square
    # with 60 degrees of freedom; 3.5 standard deviations of it either way
    noise, total = np.random.default_rng(11), 0.0
    exact = measured(0.4, 0.3, [0.5, 1.0, 2.5], share=0.002, scale="common")
    for _ in range(30):
        tables = deepcopy(exact)
        for state in tables["measured"]:
            for name in SPEEDS:
                state[name]["value"] += state[name]["uncertainty"] * noise.standard_normal()
        problem = Problem.of(Data.of_tables(tables))
        best = minima(problem)[0]
        _, slopes = problem.residuals(best.unknowns)
        off = (best.unknowns[:2] - [0.4, 0.3])
        covariance = np.linalg.inv(slopes.T @ slopes)[:2, :2]
        total += off @ np.linalg.solve(covariance, off)
    assert abs(total - 60) < 3.5 * np.sqrt(120)


def test_profile_agrees_with_the_slopes_where_all_is_linear():
    # small uncertainties: the profile is a parabola, and its ends are 1 and 1.96 standard errors away
    found = granular.fit(measured(0.4, 0.3, [0.5, 1.0, 2.5], share=1e-5, scale="common"))
    for one in found.estimates:
        narrow, wide = one.intervals
        for interval, factor in ((narrow, 1.0), (wide, 1.959964)):
            assert interval.low == pytest.approx(one.value - factor * one.standard_error, rel=1e-4)
            assert interval.high == pytest.approx(one.value + factor * one.standard_error, rel=1e-4)
            assert not interval.low_open
            assert not interval.high_open


def test_interval_ends_where_chi_square_has_risen():
    found = granular.fit(measured(0.3, -0.2, [1.0, 2.0], scale="common"))
    from scipy.optimize import least_squares

    one, problem = found.estimates[0], found.problem
    for end in (one.intervals[0].low, one.intervals[0].high):
        def others(rest, end=end):
            return problem.residuals(np.concatenate([[end], rest]))[0]

        heights = [2 * least_squares(others, start[1:], xtol=1e-14, ftol=1e-14).cost
                   for start in (found.minimum.unknowns, found.minimum.unknowns + 0.3)]
        # linear interpolation in a last bracket of a hundredth of the distance
        assert min(heights) - found.chi_square == pytest.approx(1.0, abs=2e-3)


def test_data_that_no_fabric_gives_are_told_not_refused():
    tables = measured(0.0, 0.0, [1.0], scale="states", share=0.001)
    tables["measured"][0]["Vs_hh"]["value"] *= 1.3
    found = granular.fit(tables)
    assert found.p_value < 1e-6
    assert max(abs(one.sigmas) for one in found.residuals) > 10


def test_result_is_complete():
    found = granular.fit(measured(0.3, -0.2, [1.0, 2.0], noise=np.random.default_rng(5)))
    assert found.degrees_of_freedom == 8 - 6
    assert 0 < found.p_value < 1
    assert found.covariance.shape == found.correlation.shape == (6, 6)
    np.testing.assert_allclose(np.diag(found.correlation), 1, rtol=1e-12)
    assert sum(one.sigmas**2 for one in found.residuals) == pytest.approx(found.chi_square, rel=1e-9)
    with pytest.raises(KeyError, match="no estimate"):
        found["D3333"]


@pytest.mark.parametrize(("text", "name", "expected"), [
    ("412 m/s +- 4 m/s", "Vp_vertical", (412.0, 4.0)),
    ("0.412 km/s ± 1 %", "Vp_vertical", (412.0, 4.12)),
    ("412 +- 4 m/s", "Vs_hv", (412.0, 4.0)),
    ({"value": "280 MPa", "uncertainty": "5 MPa"}, "C1111", (280e6, 5e6)),
    ("0.83 +/- 0.02", "C1111/C3333", (0.83, 0.02)),
])
def test_readings(text, name, expected):
    assert reading(text, quantity(name)) == pytest.approx(expected, rel=1e-15)


def test_units_of_speed_are_those_of_pint():
    for unit in SPEED.units:
        assert in_si(f"1 {unit}", SPEED) == pytest.approx(pint.Quantity(f"1 {unit}").to("m/s").magnitude, rel=1e-15)


def spoiled(**changes):
    tables = measured(0.3, -0.2, [1.0, 2.0])
    for path, value in changes.items():
        at, keys = tables, path.split("__")
        for key in keys[:-1]:
            at = at[int(key)] if key.isdigit() else at.setdefault(key, {})
        if value is None:
            del at[keys[-1]]
        else:
            at[keys[-1]] = value
    return tables


@pytest.mark.parametrize(("changes", "kind", "named"), [
    ({"measured": None}, MissingKey, "measured"),
    ({"measured": [{"Vs_hh": "200 +- 2 m/s"}], "stress": {"mean": "100 kPa"}}, MeasurementsTooFew, "D33, Dr33, factor"),
    ({"measured": [{"label": "empty"}], "stress": {"mean": "100 kPa"}}, MeasurementsTooFew, "nothing is measured"),
    ({"measured__0__Vs_hh": "200 m/s"}, MissingKey, "uncertainty of Vs_hh"),
    ({"measured__0__Vs_hh": "200 m/s +- 0 m/s"}, ValueOutOfRange, "state 1: uncertainty of Vs_hh"),
    ({"measured__1__Vs_hh": "200 m/s +- -2 m/s"}, ValueOutOfRange, "state 2: uncertainty of Vs_hh"),
    ({"measured__0__Vs_hh": "200 kPa +- 2 kPa"}, GranularError, "Vs_hh"),
    ({"measured__0__Vs_h": "200 m/s +- 2 m/s"}, UnknownChoice, "Vs_hh"),
    ({"measured": {"C1111/Vs_hh": "1 +- 0.1", "stress": {"mean": 1e5}}}, UnknownChoice, "ratio"),
    ({"grains__density": None}, MissingKey, "density"),
    ({"packing__contact_normals": {"D33": 0.1}}, ConflictingKeys, "D33 is unknown"),
    ({"fit__unknowns": ["D33", "D33"]}, UnknownChoice, "once"),
    ({"fit__unknowns": ["D44"]}, UnknownChoice, "D44"),
    ({"fit__unknowns": ["coordination_number"]}, ConflictingKeys, "both multiply"),
    ({"fit__scales": "none"}, GranularError, "scales"),
    ({"model__hypothesis": "static", "grains__friction_coefficient": 0.3}, ConflictingKeys, "friction"),
])
def test_refusals(changes, kind, named):
    with pytest.raises(kind) as refusal:
        granular.fit(spoiled(**changes))
    assert named in str(refusal.value)


def test_command(tmp_path, capsys):
    file = tmp_path / "data.toml"
    file.write_text('[grains]\nshear_modulus = "31 GPa"\npoisson_ratio = 0.21\n[packing]\nvoid_ratio = 0.6\n'
                    '[stress]\nmean = "100 kPa"\nratio = 2.0\n[fit]\nscale = "states"\n[measured]\n'
                    '"C1111/C3333" = "0.70 +- 0.01"\n"C2323/C1212" = "1.10 +- 0.02"\n'
                    '"C1111/C1212" = "2.1 +- 0.1"\n')
    picture = tmp_path / "fit.svg"
    assert run_command(["fit", str(file), "--json", "--plot", str(picture)]) == 0
    told = json.loads(capsys.readouterr().out)
    assert set(told["estimates"]) == {"D33", "Dr33"}
    assert len(told["estimates"]["D33"]["intervals"]) == 2
    assert told["degrees_of_freedom"] == 1
    assert picture.read_text().startswith("<?xml")
    assert run_command(["fit", str(file)]) == 0
    shown = capsys.readouterr().out
    assert "What the data see" in shown
    assert "C1111/C3333" in shown
