"""The number of gradation under every reading: exact values, other computations, limits, and what (19) neglects."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import quad

from granular.errors import UnknownChoice, ValueOutOfRange
from granular.gradation import Lognormal, branch_lengths
from granular.gradation.cut_sizes import cut, cut_by_volume, cut_that_gives
from granular.gradation.fitted_lengths import fitted_density, neglected
from granular.gradation.readings import (
    READINGS,
    all_branches,
    literal,
    lognormal_lengths,
    lognormal_of_power,
    of_power,
    power_that_gives,
)
from granular.gradation.stiffness_numbers import ONE_LENGTH

patient = settings(deadline=None)  # a time limit would be a verdict on a busy machine
SPREADS = (1.0001, 1.2, 1.5, 2.0, 3.0, 10.0)
PRINTED = ((1.2, 4.355, 0.0005), (1.5, 6.50, 0.005), (2.0, 29.0, 0.05))
"""Spread, a value that went from hand to hand as the literal one, and half a unit of its last digit."""


@pytest.mark.parametrize("spread", SPREADS)
def test_the_cube_root_is_the_power_of_a_third(spread):
    # a rule with too wide a step or too short a range; the other one is scalar, with other steps and another range
    assert of_power(spread, 1 / 3) == pytest.approx(literal(spread), rel=1e-12)


@pytest.mark.parametrize("spread", SPREADS)
def test_the_density_itself_has_a_closed_form(spread):
    # a wrong factor of the length in the moments: <l^2> = 2 <r^2> + 2 <r>^2 needs no integral
    assert of_power(spread, 1.0).kinematic == pytest.approx(all_branches(spread).kinematic, rel=1e-12)


def test_the_literal_values():
    # a range that ends too early: multiple precision gives these, rounded (see certify.py)
    assert [round(literal(spread).kinematic, 4) for spread in (1.2, 1.5, 2.0)] == [4.3556, 6.5509, 33.1552]


@pytest.mark.parametrize(("spread", "value", "half"), PRINTED)
def test_values_of_a_range_that_ends_at_six_deviations(spread, value, half):
    # the finding that one and the same cut, six deviations about the printed r_50, explains all three values
    assert abs(cut(spread, 6, about="printed").kinematic - value) <= half


def test_no_cut_about_the_median_by_number_explains_them():
    # the finding that a cut counted from the median by number would have to differ
    low, high = (cut_that_gives(1.5, 6.50 + sign * 0.005) for sign in (-1, 1))
    first, last = (cut_that_gives(2.0, 29.0 + sign * 0.05) for sign in (-1, 1))
    assert low < high < first < last


@pytest.mark.parametrize(("spread", "enough"), [(1.2, 20), (2.0, 20), (3.0, 25)])
def test_a_far_cut_is_no_cut(spread, enough):
    # a cut density with another norm, or a tail that is lost
    assert cut(spread, enough) == pytest.approx(literal(spread), rel=1e-12)


@pytest.mark.parametrize("spread", [1.2, 2.0, 3.0])
def test_a_narrow_cut_leaves_equal_spheres(spread):
    # a density that ends elsewhere than at twice the least and the largest radius; sizes differ by 1 % of a spread
    assert cut(spread, 0.01) == pytest.approx(ONE_LENGTH, rel=2e-4)


@pytest.mark.parametrize(("spread", "low", "high"), [(1.5, -2.0, 2.0), (2.0, -1.0, 1.0)])
def test_adaptive_quadrature_in_radius_agrees(spread, low, high):
    # a wrong Jacobian or bound: here eqs (12), (16), (17) stand as they are printed, in radius and length
    L = math.log(spread)
    least, most = math.exp(L * low), math.exp(L * high)

    def by_number(r):
        return math.exp(-0.5 * (math.log(r) / L) ** 2) / r

    def total(length):
        return quad(lambda r: by_number(r) * by_number(length - r), max(least, length - most),
                    min(most, length - least), epsabs=0, epsrel=1e-10)[0]

    def moment(k):
        middle = least + most
        return sum(quad(lambda length: length**k * total(length) ** (1 / 3), *ends, epsabs=0, epsrel=1e-7)[0]
                   for ends in ((2 * least, middle), (middle, 2 * most)))

    cube = quad(lambda r: r**3 * by_number(r), least, most)[0] / quad(by_number, least, most)[0]
    whole = moment(0)
    found = cut(spread, high)
    assert found.kinematic == pytest.approx(moment(2) / whole / cube ** (2 / 3), rel=1e-6)
    assert found.static == pytest.approx(4 * moment(-2) / whole * cube ** (2 / 3), rel=1e-6)


def test_a_share_of_the_volume_is_a_cut_about_its_median():
    # shares counted by number: one in a thousand by volume are 3.09 deviations about the median by volume
    assert cut_by_volume(2.0, 1e-3) == cut(2.0, 3.090232306167813, about="volume")


def test_the_number_rises_slowly_with_the_cut():
    # the statement of the book's page: at a spread of 2 a third of the number lies beyond six deviations
    found = [cut(2.0, k).kinematic for k in (3, 4, 5, 6, 8)]
    assert [round(value, 1) for value in found] == [6.9, 10.6, 15.9, 22.0, 30.9]


@patient
@given(st.floats(1.001, 4), st.floats(1, 12), st.floats(0.1, 3))
def test_the_kinematic_number_rises_with_the_cut(spread, k, more):
    # panels that do not meet, or an end inside them
    assert cut(spread, k + more).kinematic >= cut(spread, k).kinematic * (1 - 1e-12)


@patient
@given(st.floats(1.01, 5), st.floats(0.25, 2), st.floats(0.01, 0.5))
def test_the_kinematic_number_falls_with_the_power(spread, power, less):
    # an exponent of the length with the wrong sign
    assert of_power(spread, max(power - less, 0.25)).kinematic >= of_power(spread, power).kinematic * (1 - 1e-12)


@pytest.mark.parametrize("spread", [1.2, 1.5, 2.0, 3.0])
def test_searches_find_what_they_are_asked_for(spread):
    # a bisection that runs to the wrong end
    assert of_power(spread, power_that_gives(spread)).kinematic == pytest.approx(4, rel=1e-9)
    assert cut(spread, cut_that_gives(spread, 4.2)).kinematic == pytest.approx(4.2, rel=1e-9)
    assert math.isnan(cut_that_gives(spread, 1e9))
    assert math.isnan(power_that_gives(spread, 1e9))


@pytest.mark.parametrize("reading", READINGS, ids=lambda reading: reading.name)
def test_every_reading_begins_with_equal_spheres(reading):
    # a number over another volume: all readings meet where the sizes do
    assert reading.numbers(1.00001) == pytest.approx(ONE_LENGTH, rel=1e-8)


def test_readings_stand_in_their_order():
    # names of curves in a figure exchanged
    found = [reading.numbers(2.0).kinematic for reading in READINGS]
    assert found == sorted(found, reverse=True)


@pytest.mark.parametrize("spread", [1.001, 1.2, 2.0, 3.0])
def test_moments_of_the_fit_are_those_of_its_reading(spread):
    # a density whose mode is taken for its median
    found = neglected(spread)
    ratio = [fit / true for fit, true in zip(lognormal_lengths(spread), literal(spread), strict=True)]
    assert [found.mean_square, found.inverse_square] == pytest.approx(ratio, rel=1e-12)


@pytest.mark.parametrize("spread", [1.1, 2.0])
def test_the_largest_difference_is_nowhere_exceeded(spread):
    # a search that ends in a smaller maximum: a denser grid, over a wider range, finds nothing larger
    sizes = Lognormal("5 mm", spread)
    found = neglected(spread)
    length = 0.005 * np.exp(np.linspace(-8, 12, 1501) * math.log(spread))
    true = length * branch_lengths(sizes).density(length)
    apart = np.abs(length * fitted_density(sizes, length) - true).max() / true.max()
    assert apart <= found.largest_difference * (1 + 1e-3)
    assert apart == pytest.approx(found.largest_difference, rel=1e-2)


def test_the_fit_is_a_density():
    # a constant without the factor of the mode
    sizes = Lognormal("5 mm", 2.0)
    assert quad(lambda x: float(math.exp(x) * fitted_density(sizes, math.exp(x))), -25, 15,
                epsabs=1e-12, points=[-5.0])[0] == pytest.approx(1, rel=1e-9)


@pytest.mark.parametrize("call", [
    lambda: literal(1.0), lambda: of_power(0.5, 1.0), lambda: of_power(2.0, 0.1), lambda: cut(2.0, 0.0),
    lambda: cut_by_volume(2.0, 0.5), lambda: lognormal_lengths(11.0), lambda: neglected(1.0)])  # fmt: skip
def test_values_outside_their_interval_are_refused(call):
    # a number of something that is not there
    with pytest.raises(ValueOutOfRange):
        call()


def test_another_centre_is_refused():
    # a misspelt centre that is taken for the first one
    with pytest.raises(UnknownChoice, match="printed"):
        cut(2.0, 3.0, about="mode")


@pytest.mark.parametrize("spread", [1.05, 1.2, 1.5, 2.0, 3.0])
def test_the_third_moment_of_a_lognormal_sum_is_too_small(spread):
    # Breaks when the share is not that of two independent radii against a lognormal with two moments of their sum.
    L = math.log(spread) ** 2
    radius = [math.exp(k * k * L / 2) for k in range(4)]  # <r^k> of a classical lognormal with median 1
    first, second = 2 * radius[1], 2 * radius[2] + 2 * radius[1] ** 2
    third = 2 * radius[3] + 6 * radius[2] * radius[1]
    # a lognormal has <l^3> = (<l^2>/<l>)^3; some thirty roundings, and the powers of exp(9 L/2)
    assert neglected(spread).third_of_all == pytest.approx((second / first) ** 3 / third, rel=1e-14)


@pytest.mark.parametrize("spread", [1 + 1e-9, 1.2, 2.0, 10.0])
def test_powers_of_the_lognormal_density(spread):
    # Breaks when the exponent of the last factor, or the power 1/3 of eq. (17), is wrong.
    L = math.log(spread) ** 2
    rel = 1e-15 * (1 + 14 * L)  # as stated
    assert lognormal_of_power(spread, 1 / 3) == pytest.approx(lognormal_lengths(spread).kinematic, rel=2 * rel)
    assert lognormal_of_power(spread, 4 / 7) == pytest.approx(4 * math.cosh(L / 2) ** 4, rel=2 * rel)
    assert lognormal_of_power(spread, 1.0) == pytest.approx(2 * (math.exp(-L) + math.exp(-2 * L)), rel=2 * rel)
