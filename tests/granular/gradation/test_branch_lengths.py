"""Branch lengths: exact identities, the definitions by plain quadrature, certified values, claims of the paper."""

from __future__ import annotations

import importlib.util
import json
import math
from importlib import resources
from itertools import pairwise
from pathlib import Path

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import quad

from granular import errors
from granular.gradation import Lognormal, MeasuredCurve, branch_lengths, curve_branches, length_moments

STORED = json.loads((resources.files("granular") / "data" / "certified_gradation.json").read_text("utf-8"))["cases"]
SIEVES = MeasuredCurve([6.3e-5, 1.25e-4, 2.5e-4, 5e-4, 1e-3, 2e-3, 4e-3], [0, 0.05, 0.2, 0.55, 0.8, 0.95, 1])
GAP = MeasuredCurve([1e-4, 2e-4, 2e-3, 4e-3], [0, 0.3, 0.3, 1])
WIDE = MeasuredCurve(np.geomspace(1e-6, 1e-2, 20).tolist(), (np.linspace(0, 1, 20) ** 1.7).tolist())
NARROW = MeasuredCurve([1e-3, 1.0001e-3], [0, 1])
FINES = MeasuredCurve([1e-6, 1e-4, 2e-4, 2e-3, 4e-3], [0, 1e-15, 0.3, 0.3, 1])
CURVES = {"sieves": SIEVES, "gap": GAP, "four decades": WIDE, "narrow": NARROW, "hardly any fines": FINES,
          "two points": MeasuredCurve([1e-6, 1e-2], [0, 1])}


def certify():
    """The script that remakes the stored values."""
    path = Path(__file__).with_name("certify.py")
    spec = importlib.util.spec_from_file_location("certify", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def convolved(density, length, edges):
    """Integral of density(r) density(length - r) between edges, by quad."""
    return sum(quad(lambda r: density(r) * density(length - r), left, right, epsabs=0.0, epsrel=1e-11)[0]
               for left, right in pairwise(edges) if density(0.5 * (left + right)) > 0.0)


# ---- lognormal


@pytest.mark.parametrize("case", STORED, ids=lambda case: case["id"])
@pytest.mark.parametrize("form", ["paper", "classical"])
def test_certified_second_moments(case, form):
    # Breaks when a step, a range or a rounding costs more than the error that the result states.
    found = length_moments(Lognormal(0.005, float(case["spread"]), form=form))
    assert found.relative_error <= (1e-14 if float(case["spread"]) <= 3.0 else 3e-14)
    with mpmath.workdps(40):
        for name in ("second", "inverse_second"):
            known = mpmath.mpf(case[name])
            assert abs(getattr(found, name) - known) <= found.relative_error * known, name


@pytest.mark.parametrize("case", STORED[2:5:2], ids=lambda case: case["id"])
def test_the_stored_values_can_be_remade(case):
    # Breaks when the script and the stored file part: here to 15 digits, which takes seconds.
    remade = certify().certified(float(case["spread"]), digits=15)
    for name, value in zip(("second", "inverse_second"), remade, strict=True):
        assert abs(value - mpmath.mpf(case[name])) <= 1e-14 * value


@pytest.mark.parametrize("spread", [1.0 + 2.0**-52, 1.0 + 1e-12, 1.0 + 1e-6])
def test_a_spread_near_one_is_one_size(spread):
    # Breaks when a difference of nearly equal numbers is divided by ln s. To first order 1 + 5/2 L^2 and 1 + 7/2 L^2.
    found = length_moments(Lognormal(0.005, spread))
    assert found.second == pytest.approx(1.0 + 2.5 * math.log(spread) ** 2, rel=found.relative_error)
    assert found.inverse_second == pytest.approx(1.0 + 3.5 * math.log(spread) ** 2, rel=found.relative_error)


@pytest.mark.parametrize("spread", [1.1, 1.5, 3.0])
def test_total_density_by_its_definition(spread):
    # Breaks when the change of variables behind the trapezoidal rule is wrong: (16) by quad over the radius, to 1e-10.
    sizes = Lognormal(0.005, spread)
    lengths = branch_lengths(sizes)

    def by_radius(radius):
        return 2.0 * sizes.density_by_number(2.0 * radius)

    for diameters in (0.5, 1.0, 1.7, 4.0):
        length = diameters * sizes.equal_volume_diameter
        edges = length * np.array([1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 0.01, 0.03, 0.1, 0.2, 0.3, 0.4, 0.5])
        assert lengths.total_density(length) == pytest.approx(2.0 * convolved(by_radius, length, edges), rel=1e-10)


@given(st.floats(1.001, 3.0), st.sampled_from([1, 2, 3]))
@settings(max_examples=20)
def test_moments_of_all_branches(spread, power):
    # Breaks when (16) is no density of the sum of two independent radii: <(r1 + r2)^k> by binomials. 400 equal steps.
    sizes = Lognormal(0.005, spread)
    L, lengths = sizes.log_spread, branch_lengths(sizes)
    z = np.linspace(-12.0, 12.0 + 4.0 * power * L, 400)
    length = sizes.median_by_number * np.exp(L * z)
    found = float((lengths.total_density(length) * length ** (power + 1)).sum()) * (z[1] - z[0]) * L
    radius = [(sizes.median_by_number / 2) ** k * math.exp(k * k * L * L / 2) for k in range(power + 1)]
    assert found == pytest.approx(sum(math.comb(power, k) * radius[k] * radius[power - k] for k in range(power + 1)),
                                  rel=1e-11)


@pytest.mark.parametrize("spread", [1.0 + 1e-12, 1.5, 10.0])
def test_densities_far_away(spread):
    # Breaks when a length far from all branches overflows or never ends: hardly any branch is there.
    lengths = branch_lengths(Lognormal(0.005, spread))
    assert (lengths.total_density([1e-29, 1e29]) < 1e-100).all()
    assert (lengths.density([1e-29, 1e29]) < 1e-50).all()


# ---- measured curves


@pytest.mark.parametrize("curve", CURVES.values(), ids=CURVES)
def test_a_finer_rule_agrees(curve, monkeypatch):
    # Breaks when nodes or pieces are too few, or the stated error is too small: more nodes on narrower pieces.
    found = length_moments(curve)
    for name, value in (("INNER_NODES", 16), ("WIDEST_PIECE", 0.4), ("ORDERS", (16, 24)), ("WANTED", 1e-14)):
        monkeypatch.setattr(curve_branches, name, value)
    finer = length_moments(MeasuredCurve(curve.sizes, curve.fractions))
    assert found.relative_error < 1e-11
    assert found.second == pytest.approx(finer.second, rel=found.relative_error)
    assert found.inverse_second == pytest.approx(finer.inverse_second, rel=found.relative_error)


def test_total_density_of_a_curve_by_its_definition():
    # Breaks when a split is missing or a piece is looked up wrongly: (16) by quad over the radius, split by hand.
    lengths, radii = branch_lengths(SIEVES), 0.5 * np.array(SIEVES.sizes)

    def by_radius(radius):
        return 2.0 * SIEVES.density_by_number(2.0 * radius)

    for length in (1e-4, 3e-4, 1.3e-3, 3.5e-3):
        low, high = max(radii[0], length - radii[-1]), min(radii[-1], length - radii[0])
        edges = np.unique(np.clip(np.concatenate([radii, length - radii]), low, high))
        assert lengths.total_density(length) == pytest.approx(convolved(by_radius, length, edges), rel=1e-9)


@pytest.mark.parametrize("curve", [SIEVES, GAP, NARROW], ids=["sieves", "gap", "narrow"])
def test_densities_of_a_curve(curve):
    # Breaks when a density is not normalised, or (17) is no cube root of (16). Equal steps of ln l leave 1 %.
    lengths = branch_lengths(curve)
    x = np.linspace(math.log(curve.sizes[0]), math.log(curve.sizes[-1]), 1001)
    length = np.exp(x[1:-1])
    total, along = lengths.total_density(length), lengths.density(length)
    step = x[1] - x[0]
    assert (total * length).sum() * step == pytest.approx(1.0, rel=1e-2)
    assert (along * length).sum() * step == pytest.approx(1.0, rel=1e-2)
    where = total > 0.0
    ratio = along[where] / np.cbrt(total[where])
    assert ratio == pytest.approx(ratio[0], rel=1e-12)
    assert lengths.density(0.9 * curve.sizes[0]) == lengths.total_density(1.1 * curve.sizes[-1]) == 0.0


def test_a_curve_of_a_lognormal_distribution():
    # Breaks when curve and lognormal disagree on (12), (16) or (17). Points two fifths of a spread apart leave 5e-3.
    sizes = Lognormal(1.0, 1.5)
    points = 1.5 ** np.linspace(-8.0, 10.0, 46)
    fractions = sizes.fraction_finer(points)
    fractions[0], fractions[-1] = 0.0, 1.0
    curve, exact = length_moments(MeasuredCurve(points.tolist(), fractions.tolist())), length_moments(sizes)
    assert curve.second == pytest.approx(exact.second, rel=5e-3)
    assert curve.inverse_second == pytest.approx(exact.inverse_second, rel=5e-3)
    assert curve.equal_volume_diameter == pytest.approx(exact.equal_volume_diameter, rel=5e-3)


def test_a_narrow_curve_is_one_size():
    # Breaks when rounding of close sizes reaches the moments: they are within the square of the width of 1.
    found = length_moments(MeasuredCurve([1.0, 1.0 + 2e-6], [0, 1]))
    assert found.second == pytest.approx(1.0, abs=1e-11)
    assert found.inverse_second == pytest.approx(1.0, abs=1e-11)


# ---- what holds for all of them


@given(st.floats(-20.0, 20.0))
@settings(max_examples=20)
def test_the_mean_size_does_not_matter(exponent):
    # Breaks when a length stays in the dimensionless moments: the paper's first claim, exact by scaling.
    factor = 10.0**exponent
    for near, far in ((Lognormal(0.005, 1.5), Lognormal(0.005 * factor, 1.5)),
                      (GAP, MeasuredCurve([size * factor for size in GAP.sizes], GAP.fractions))):
        here, there = length_moments(near), length_moments(far)
        assert there.second == pytest.approx(here.second, rel=1e-13)
        assert there.inverse_second == pytest.approx(here.inverse_second, rel=1e-13)
        assert there.equal_volume_diameter == pytest.approx(here.equal_volume_diameter * factor, rel=1e-13)


def test_uniformity_does_matter():
    # Breaks when the numbers against the paper's second claim change: 4 for equal spheres, exact to four digits.
    found = [4.0 * length_moments(Lognormal("5 mm", spread)).second for spread in (1.2, 1.5, 2.0)]
    assert found == pytest.approx([4.3556, 6.5509, 33.155], rel=1e-4)


@pytest.mark.parametrize(("spread", "cut"), [(1.2, 4.355), (1.5, 6.50), (2.0, 29.0)])
def test_cut_off_tails_give_less(spread, cut):
    # Breaks when finite limits r_m and r_M in (11) and (16) no longer explain 29.0 in place of 33.2: eq. (18) between
    # r50/s^6 and r50 s^6, by a curve of 31 points whose interpolation leaves 1 %.
    sizes = Lognormal(1.0, spread)
    points = spread ** np.linspace(-6.0, 6.0, 31)
    least, most = sizes.fraction_finer(points[[0, -1]])
    fractions = (sizes.fraction_finer(points) - least) / (most - least)
    fractions[0], fractions[-1] = 0.0, 1.0
    found = length_moments(MeasuredCurve(points.tolist(), fractions.tolist())).second
    assert 4.0 * found == pytest.approx(cut, rel=1e-2)


@pytest.mark.parametrize("sizes", [Lognormal(0.005, 1.5), SIEVES], ids=["lognormal", "sieves"])
def test_moments_are_ordered(sizes):
    # Breaks when a power is applied to the wrong density: power means grow with their power.
    lengths = branch_lengths(sizes)
    means = [lengths.moment(power).value ** (1.0 / power) for power in (-4, -2, -1, 1, 2, 4)]
    assert means == sorted(means)
    assert lengths.moment(0.0).value == 1.0


def test_what_has_no_branch_lengths():
    # Breaks when something else than a distribution, or a power beyond double precision, gets through.
    with pytest.raises(errors.WrongType, match="Lognormal or MeasuredCurve"):
        branch_lengths(0.005)
    with pytest.raises(errors.ValueOutOfRange, match="power"):
        branch_lengths(SIEVES).moment(5)
    with pytest.raises(errors.ValueOutOfRange, match="length"):
        branch_lengths(SIEVES).density(0.0)
