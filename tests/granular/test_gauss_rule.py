"""Gauss rules along the meridian are as good as they say, for any factor that an integrand may divide by."""

from __future__ import annotations

import math
import random
from fractions import Fraction

import mpmath
import pytest

from granular.routes.axial_rules import Axis, axial_rule
from granular.routes.gauss_rule import SIZES, GaussRule, gauss_rule

TOLERANCES = (1e-2, 1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13)

THIRD, HALF = Fraction(1, 3), Fraction(1, 2)

EXPONENTS = (THIRD, -THIRD, Fraction(-1), Fraction(-2), HALF, -HALF)
"""Forces and their inverse, spheroids, inverse squares of branches, lengths of branches of spheroids [-]."""

DEGREES = (3, 4, 5, 6)
"""Densities of rank two and four, static and kinematic [-]."""

ROUNDING = 4e-15
"""Of a sum of positive terms, each a product of at most nine factors that carry half a unit of rounding [-]."""

EXTREMES = (0.0, 5e-324, 1e-300, 1e-30, 1 / 3, 1.0, math.nextafter(1.0, 2.0), math.nextafter(1.0, 0.0), 1e30, 1e300)


def random_places(count: int, *, seed: int) -> list[tuple[float, float]]:
    """Factors p s + q y of every contrast that is met, on any scale; a third of them within a factor of ten."""
    rng = random.Random(seed)
    reach = (1.0, 4.0, 12.0)
    return [(scale, scale * 10 ** rng.uniform(-far, far))
            for far in (rng.choice(reach) for _ in range(count)) for scale in (10 ** rng.uniform(-3, 3),)]


def average(rule: GaussRule, i: int, j: int, place: tuple[float, float], exponent: Fraction) -> float:
    nodes = axial_rule(rule.axis, rule.length, rule.nodes)
    p, q = place
    return math.fsum(w * s**i * y**j * raised(p * s + q * y, exponent) for w, s, y in zip(
        nodes.measure, nodes.sine_squared, nodes.cosine_squared, strict=True))


def raised(value: float, exponent: Fraction) -> float:
    """A power with no rounding of its exponent."""
    if exponent.denominator == 3:
        return math.cbrt(value) if exponent > 0 else 1 / math.cbrt(value)
    return value ** float(exponent)


def truth(i: int, j: int, place: tuple[float, float], exponent: Fraction) -> mpmath.mpf:
    """Euler's integral with y as its variable, or s where that one keeps the argument from leaving 0 to 1."""
    with mpmath.workdps(50):
        p, q = map(mpmath.mpf, place)
        power = mpmath.mpf(exponent.numerator) / exponent.denominator
        low, high, other = (q, p, j + mpmath.mpf(1) / 2) if p >= q else (p, q, i + mpmath.mpf(1))
        series = mpmath.hyp2f1(-power, other, i + j + mpmath.mpf(3) / 2, (high - low) / high)
        return high**power * mpmath.beta(j + mpmath.mpf(1) / 2, i + 1) / 2 * series


def test_the_true_average_is_true() -> None:
    """The measure of all others here is wrong: plain quadrature of one average in 30 digits."""
    with mpmath.workdps(30):
        for place, exponent in (((2.0, 0.5), THIRD), ((0.5, 2.0), Fraction(-2))):
            p, q = place
            power = mpmath.mpf(exponent.numerator) / exponent.denominator
            plain = mpmath.quad(lambda x, p=p, q=q, power=power:
                                (1 - x * x) ** 2 * x**6 * (p * (1 - x * x) + q * x * x) ** power, [0, 1])
            assert abs(truth(2, 3, place, exponent) / plain - 1) < 1e-25  # quadrature of an analytic function


def test_looser_takes_fewer_nodes() -> None:
    """A looser accuracy costs more nodes, or the rule of a tighter one is given up."""
    spared = 0
    for place in random_places(60, seed=1):
        for degree in DEGREES:
            found = [gauss_rule((place,), degree=degree, tolerance=tolerance) for tolerance in TOLERANCES]
            nodes = [math.inf if rule is None else rule.nodes for rule in found]
            assert nodes == sorted(nodes)
            spared += nodes[0] < nodes[-1]
    assert spared > 200  # otherwise accuracy buys nothing


def test_the_bound_is_below_what_was_wanted() -> None:
    """A rule promises less than it was chosen for, or takes nodes that are not stored."""
    for place in random_places(60, seed=2):
        for tolerance in TOLERANCES:
            rule = gauss_rule((place,), degree=5, tolerance=tolerance)
            if rule is not None:
                assert 0 < rule.error <= tolerance * (1 + 1e-12)  # logarithms round
                assert rule.nodes in SIZES


@pytest.mark.parametrize("exponent", EXPONENTS)
def test_the_bound_holds_for_random_averages(exponent: Fraction) -> None:
    """An average s^i y^j (p s + q y)^e errs by more than the rule says."""
    rng = random.Random(f"averages {exponent}")
    served = 0
    for place in random_places(70, seed=3):
        degree = rng.choice(DEGREES)
        i = rng.randint(0, degree)
        j = rng.randint(0, degree - i)
        rule = gauss_rule((place,), degree=degree, tolerance=rng.choice(TOLERANCES))
        if rule is None:
            continue
        served += 1
        known = truth(i, j, place, exponent)
        error = float(abs(average(rule, i, j, place, exponent) - known) / known)
        assert error <= rule.error + ROUNDING, (i, j, place, rule)
    assert served > 50




@pytest.mark.parametrize("degree", [3, 4, 5, 6])
def test_the_bound_holds_for_the_smallest_averages(degree: int) -> None:
    """A bound that takes averages of s^i y^j for as large as their largest value breaks it.

    With factors next to 1, a rule that is one node short of exact misses the same whatever the average.
    """
    for i in range(degree + 1):
        j = degree - i
        for contrast in (1e-12, 1e-6, 1e-4):
            for rule in (gauss_rule(((1.0, 1 + contrast),), degree=degree, tolerance=10**-(k / 4)) for k in range(41)):
                if rule is None:
                    continue
                known = truth(i, j, (1.0, 1 + contrast), THIRD)
                error = float(abs(average(rule, i, j, (1.0, 1 + contrast), THIRD) - known) / known)
                assert error <= rule.error + ROUNDING, (i, j, contrast, rule)


@pytest.mark.parametrize(("powers", "place", "tolerance"), [
    ((2, 4), (1.0, 2.858560090247683e-14), 6e-14), ((4, 2), (1.0, 7.321879126439155e-14), 3.1e-14),
    ((1, 4), (1.0, 4.075273010705203e-12), 2.5e-11), ((3, 3), (1.0, 8.197377693253408e-14), 1.8e-11),
    ((2, 4), (1.0, 3.601871544238037e-15), 8e-11), ((4, 2), (1.0, 1.444102438254148e-15), 1.01e-10)])
def test_the_bound_holds_where_forces_vanish_at_the_pole(powers: tuple[int, int], place: tuple[float, float],
                                                         tolerance: float) -> None:
    """Nodes crowd about the pole, and what the map grows to off the line is not counted; the worst of 20,000 draws."""
    rule = gauss_rule((place,), degree=sum(powers), tolerance=tolerance)
    if rule is not None:
        known = truth(*powers, place, THIRD)
        assert float(abs(average(rule, *powers, place, THIRD) - known) / known) <= rule.error + ROUNDING


@pytest.mark.parametrize("exponent", EXPONENTS)
@pytest.mark.parametrize("place", [(p, q) for p in EXTREMES for q in EXTREMES if p + q > 0])
def test_places_at_the_ends_are_served_well_or_not_at_all(place: tuple[float, float], exponent: Fraction) -> None:
    """A factor that vanishes at an end, or is huge, ends in an exception, or in a rule that is worse than it says."""
    for tolerance in (1e-3, 1e-9):
        rule = gauss_rule((place,), degree=5, tolerance=tolerance)
        if rule is None:
            assert min(place) / max(place) < 1e-14  # singularities that no stored rule reaches are extreme
            continue
        assert 0 <= rule.error <= tolerance * (1 + 1e-12)
        over = (place[0] / max(place), place[1] / max(place))  # so that no power overflows
        for i, j in ((4, 1), (0, 3), (5, 0)):
            known = truth(i, j, over, exponent)
            error = float(abs(average(rule, i, j, over, exponent) - known) / known)
            assert error <= rule.error + ROUNDING, (i, j, rule)


@pytest.mark.parametrize("place", [(0.0, 1.0), (1.0, 0.0), (1e-300, 1.0), (1.0, 1e-300), (1e-300, 1e300)])
def test_nothing_is_promised_where_nothing_is_enough(place: tuple[float, float]) -> None:
    """A rule is promised for an integrand whose singularity lies on the interval, or next to its end."""
    assert gauss_rule((place,), degree=5, tolerance=1e-3) is None
    assert gauss_rule(((1.0, 2.0), place), degree=5, tolerance=1e-3) is None


def test_every_factor_counts() -> None:
    """Of several factors only one is looked at; the rule for both is coarser than that for either."""
    near_pole, near_equator = (1.0, 1e-2), (1e-2, 1.0)
    both = gauss_rule((near_pole, near_equator), degree=5, tolerance=1e-6)
    assert both is not None
    for one in (near_pole, near_equator):
        alone = gauss_rule((one,), degree=5, tolerance=1e-6)
        assert alone is not None
        assert alone.nodes <= both.nodes


def test_the_ends_change_places() -> None:
    """Nodes crowd about the wrong end: at the pole s is small, at the equator y is."""
    for contrast in (1e-3, 1e-6, 1e-12):
        for place, axis in (((contrast, 1.0), Axis.EQUATOR), ((1.0, contrast), Axis.POLE)):
            rule = gauss_rule((place,), degree=5, tolerance=1e-6)
            assert rule is not None
            assert rule.axis is axis
            assert rule.length > 0


@pytest.mark.parametrize("degree", DEGREES)
@pytest.mark.parametrize("places", [(), ((1.0, 1.0),), ((1e-300, 1e-300), (7.0, 7.0))])
def test_polynomials_are_exact(degree: int, places: tuple[tuple[float, float], ...]) -> None:
    """A polynomial is not integrated exactly, takes a node too many, or a constant factor counts as a singularity."""
    rule = gauss_rule(places, degree=degree, tolerance=1e-3)
    assert rule == GaussRule(Axis.EQUATOR, 0.0, degree + 1, 0.0)
    fewer = GaussRule(Axis.EQUATOR, 0.0, degree, 0.0)
    for i in range(degree + 1):
        for j in range(degree + 1 - i):
            known = truth(i, j, (1.0, 1.0), Fraction(1))
            assert abs(average(rule, i, j, (1.0, 1.0), Fraction(1)) / known - 1) < ROUNDING
            missed = abs(average(fewer, i, j, (1.0, 1.0), Fraction(1)) / known - 1)
            assert (missed > 1e-9) == (i + j == degree), (i, j)  # Gauss nodes square: one less, one power less
