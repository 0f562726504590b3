"""Grain sizes: the lognormal density of eq. (18) in both forms, measured curves, and what all of them share."""

from __future__ import annotations

import math
import pickle
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import quad

from granular import errors
from granular.gradation import Lognormal, MeasuredCurve
from granular.number_of_contacts import contacts_per_volume

CURVE = MeasuredCurve([0.0005, 0.001, 0.002, 0.004, 0.008], [0.0, 0.2, 0.2, 0.7, 1.0])
DISTRIBUTIONS = [Lognormal(0.005, 1.5), Lognormal(0.005, 3.0, form="classical"), CURVE]
IDS = ["paper", "classical", "curve with a gap"]
SPREADS = st.floats(1.0000001, 10.0)


@st.composite
def curves(draw):
    """Admissible curves: a few points, plateaus among them, over up to some decades."""
    steps = draw(st.lists(st.floats(0.01, 3.0), min_size=1, max_size=7))
    rises = draw(st.lists(st.sampled_from([0.0, 1.0, 0.1, 0.37, 1e-3]), min_size=len(steps), max_size=len(steps)))
    rises[draw(st.integers(0, len(rises) - 1))] = 1.0
    sizes = 1e-4 * np.exp(np.concatenate([[0.0], np.cumsum(steps)]))
    fractions = np.concatenate([[0.0], np.cumsum(rises)]) / sum(rises)
    fractions[fractions > 1.0 - 1e-12] = 1.0
    return MeasuredCurve(sizes.tolist(), fractions.tolist())


def over_logarithm(function, distribution, power=0):
    """Integral of a density times a power of size, piece by piece over the logarithm of size."""
    if isinstance(distribution, MeasuredCurve):
        edges = np.log(distribution.sizes)
    else:
        middle, L = math.log(distribution.median_by_volume), distribution.log_spread
        edges = np.linspace(middle - 14.0 * L, middle + 14.0 * L, 29)
    return sum(quad(lambda x: function(math.exp(x)) * math.exp((1 + power) * x), left, right, epsabs=0.0,
                    epsrel=1e-12, limit=200)[0] for left, right in pairwise(edges)
               if function(math.exp(0.5 * (left + right))) > 0.0)


# ---- lognormal


@pytest.mark.parametrize("spread", [1.2, 1.5, 2.0])
def test_eq_18_as_printed(spread):
    # Breaks when the paper's form gets a factor 1/size, or its constant does not normalise it. quad to 1e-12.
    median, L = 0.005, math.log(spread)

    def printed(size):
        return math.exp(-((math.log10(size) - math.log10(median)) ** 2) / (2.0 * math.log10(spread) ** 2))

    constant = 1.0 / (median * math.exp(0.5 * L * L) * L * math.sqrt(2.0 * math.pi))
    sizes = Lognormal(median, spread)
    for size in (0.001, 0.004, 0.005, 0.009):
        assert sizes.density_by_volume(size) == pytest.approx(constant * printed(size), rel=1e-13)
    assert over_logarithm(sizes.density_by_volume, sizes) == pytest.approx(1.0, rel=1e-11)


def test_the_printed_median_is_the_mode():
    # Breaks when the two forms change places: (18) has its maximum at the printed size, half its volume lies elsewhere.
    paper, classical = Lognormal(0.005, 1.5), Lognormal(0.005, 1.5, form="classical")
    assert max(np.linspace(0.004, 0.006, 2001).tolist(), key=paper.density_by_volume) == pytest.approx(0.005, rel=1e-6)
    assert classical.fraction_finer(0.005) == 0.5
    # one rounding each of exp, of the product and of the logarithm
    assert paper.D50 == pytest.approx(0.005 * math.exp(math.log(1.5) ** 2), rel=1e-15)


@pytest.mark.parametrize(("spread", "printed"), [(1.2, 1.3), (1.5, 1.9), (2.0, 2.9)])
def test_table_i(spread, printed):
    # Breaks when C_u does not come out as Table I prints it: to one decimal.
    for form in ("paper", "classical"):
        assert round(Lognormal("5 mm", spread, form=form).uniformity, 1) == printed


@given(SPREADS, st.floats(1e-6, 1.0 - 1e-6))
def test_size_and_fraction_are_inverse(spread, fraction):
    # Breaks when the quantile and the fraction finer disagree. A size is rounded to 1e-16, over ln s.
    sizes = Lognormal(0.005, spread)
    allowed = 1e-13 + 4e-16 / sizes.log_spread
    assert sizes.fraction_finer(sizes.size_at(fraction)) == pytest.approx(fraction, abs=allowed)


def test_the_ends_of_a_lognormal_distribution():
    # Breaks when an end is a division by zero: nothing is finer than 0, everything finer than infinity.
    sizes = Lognormal(0.005, 1.5)
    assert (sizes.fraction_finer(0.0), sizes.density_by_volume(0.0), sizes.density_by_number(0.0)) == (0.0, 0.0, 0.0)
    assert (sizes.size_at(0.0), sizes.size_at(1.0)) == (0.0, math.inf)
    assert sizes.density_by_number(1e-300) == 0.0
    assert sizes.fraction_finer(1e300) == 1.0


@pytest.mark.parametrize(("median", "spread", "form", "kind"), [
    (0.0, 1.5, "paper", "ValueOutOfRange"), (-1.0, 1.5, "paper", "ValueOutOfRange"),
    (1e200, 1.5, "paper", "ValueOutOfRange"), ("5 kg", 1.5, "paper", "UnitOfOtherDimension"),
    (0.005, 1.0, "paper", "ValueOutOfRange"), (0.005, 0.5, "paper", "ValueOutOfRange"),
    (0.005, 10.5, "paper", "ValueOutOfRange"), (0.005, math.nan, "paper", "NotFinite"),
    (0.005, 1.5, "printed", "UnknownChoice")])
def test_what_is_no_lognormal_distribution(median, spread, form, kind):
    # Breaks when a value that means nothing is computed with.
    with pytest.raises(getattr(errors, kind)):
        Lognormal(median, spread, form=form)


# ---- measured curves


def test_the_points_are_on_the_curve():
    # Breaks when the interpolation leaves its points.
    assert CURVE.fraction_finer(np.array(CURVE.sizes)).tolist() == list(CURVE.fractions)
    assert CURVE.size_at(0.7) == 0.004


@given(curves())
def test_the_interpolation_is_monotone(curve):
    # Breaks when the interpolation overshoots: a fraction would fall, a density be negative. A cubic rounds by 4e-16.
    sizes = np.geomspace(0.5 * curve.sizes[0], 2.0 * curve.sizes[-1], 257)
    assert (np.diff(curve.fraction_finer(sizes)) >= -4e-16).all()
    assert (curve.density_by_volume(sizes) >= 0.0).all()


@given(curves(), st.floats(0.0, 1.0))
def test_the_size_at_a_fraction_has_that_fraction(curve, fraction):
    # Breaks when the inverse finds the wrong piece. A size is rounded to 1e-16 and the steepest piece has width 0.01.
    size = curve.size_at(fraction)
    assert curve.sizes[0] <= size <= curve.sizes[-1] * (1.0 + 2.0**-50)
    assert curve.fraction_finer(size) == pytest.approx(fraction, abs=1e-12)


def test_a_gap_has_no_grains_and_one_size_at_its_fraction():
    # Breaks when a level part of the curve gets a density, or its fraction a size inside the gap.
    assert CURVE.density_by_volume(0.0015) == CURVE.density_by_number(0.0015) == 0.0
    assert CURVE.size_at(0.2) == 0.001
    level_ends = MeasuredCurve([1, 2, 3, 4], [0, 0, 1, 1])
    assert (level_ends.size_at(0.0), level_ends.size_at(1.0)) == (2.0, 3.0)


def test_beyond_its_ends_a_curve_has_no_grains():
    # Breaks when a curve is extrapolated.
    assert CURVE.fraction_finer([0.0, 0.0004, 0.009]).tolist() == [0.0, 0.0, 1.0]
    assert CURVE.density_by_volume([0.0, 0.0004, 0.009]).tolist() == [0.0, 0.0, 0.0]


def test_the_density_is_continuous():
    # Breaks when the interpolation has corners at its points: the density would jump. One part in 10^9 away.
    for size in CURVE.sizes[1:-1]:
        below, above = CURVE.density_by_volume([size * (1 - 1e-9), size * (1 + 1e-9)])
        assert below == pytest.approx(above, abs=1e-5 * CURVE.density_by_volume(0.003))


def test_points_come_in_pairs():
    # Breaks when a curve of unequal columns is cut to the shorter one.
    with pytest.raises(errors.CurveMalformed, match="3 sizes with 2 fractions"):
        MeasuredCurve([1, 2, 3], [0, 1])
    with pytest.raises(errors.CurveNotMonotone, match="point 2"):
        MeasuredCurve([1, 2, 3, 4], [0, 0.6, 0.5, 1])


# ---- what all distributions share


@pytest.mark.parametrize("sizes", DISTRIBUTIONS, ids=IDS)
def test_densities_integrate_to_one(sizes):
    # Breaks when a density lacks a factor: quad to 1e-12 on every piece.
    assert over_logarithm(sizes.density_by_volume, sizes) == pytest.approx(1.0, rel=1e-10)
    assert over_logarithm(sizes.density_by_number, sizes) == pytest.approx(1.0, rel=1e-10)


@pytest.mark.parametrize("sizes", DISTRIBUTIONS, ids=IDS)
def test_the_equal_volume_diameter_is_the_mean_cube_by_number(sizes):
    # Breaks when (12) weights with another power than the cube: quad to 1e-12 on every piece.
    mean_cube = over_logarithm(sizes.density_by_number, sizes, power=3)
    assert sizes.equal_volume_diameter == pytest.approx(mean_cube ** (1 / 3), rel=1e-10)


@pytest.mark.parametrize("sizes", DISTRIBUTIONS, ids=IDS)
def test_grains_per_volume_fill_the_solid(sizes):
    # Breaks when (11) loses a factor: number of grains times their mean volume is the solid, 1/(1 + e).
    number, mean_volume = sizes.grains_per_volume(0.6), math.pi / 6 * sizes.equal_volume_diameter**3
    assert number * mean_volume == pytest.approx(1 / 1.6, rel=1e-15)
    # two contacts share each pair of grains, eq. (8)
    assert number * 8.0 / 2 == pytest.approx(
        contacts_per_volume(0.6, 8.0, grain_diameter=sizes.equal_volume_diameter), rel=2e-15)


@pytest.mark.parametrize("sizes", DISTRIBUTIONS, ids=IDS)
def test_coefficients_of_the_curve(sizes):
    # Breaks when C_u or C_c is formed of other sizes.
    D10, D30, D60 = sizes.size_at([0.1, 0.3, 0.6])
    assert (sizes.D10, sizes.D30, sizes.D60, sizes.D50) == (D10, D30, D60, sizes.size_at(0.5))
    assert sizes.uniformity == pytest.approx(D60 / D10, rel=1e-15)
    assert sizes.curvature == pytest.approx(D30**2 / (D10 * D60), rel=1e-15)


@pytest.mark.parametrize("sizes", DISTRIBUTIONS, ids=IDS)
def test_numbers_and_arrays(sizes):
    # Breaks when an array comes back in another shape, or a number as an array.
    for name, values in (("fraction_finer", [[0.001, 0.003]]), ("density_by_volume", [[0.001, 0.003]]),
                         ("density_by_number", [[0.001, 0.003]]), ("size_at", [[0.2, 0.4]])):
        found = getattr(sizes, name)(values)
        assert found.shape == (1, 2)
        one = getattr(sizes, name)(values[0][1])
        assert type(one) is float
        assert found[0, 1] == one
    with pytest.raises(errors.ValueOutOfRange, match="fraction"):
        sizes.size_at(1.1)
    with pytest.raises(errors.ValueOutOfRange, match="size"):
        sizes.fraction_finer([0.001, -0.001])


@pytest.mark.parametrize("sizes", DISTRIBUTIONS, ids=IDS)
def test_is_plain_data(sizes):
    # Breaks when a distribution cannot be compared, hashed or sent to a worker, also after it was used.
    assert sizes.equal_volume_diameter > 0.0
    again = pickle.loads(pickle.dumps(sizes))
    assert again == sizes
    assert hash(again) == hash(sizes)


@given(st.floats(1.001, 30.0), st.sampled_from(["paper", "classical"]))
def test_a_coefficient_of_uniformity_gives_its_spread(uniformity, form):
    # Breaks when the quantiles of 10 and 60 per cent are exchanged, or the form changes a ratio of sizes.
    sizes = Lognormal.of_uniformity("2 mm", uniformity, form=form)
    assert sizes.uniformity == pytest.approx(uniformity, rel=1e-14)  # a power, two exponentials, and two quantiles
    assert sizes.form == form


@pytest.mark.parametrize("uniformity", [1.0, 0.5, 1e3])
def test_impossible_uniformities_are_refused(uniformity):
    # Breaks when D60 may be smaller than D10, or a spread beyond what is checked is served.
    with pytest.raises(errors.ValueOutOfRange):
        Lognormal.of_uniformity("2 mm", uniformity)
