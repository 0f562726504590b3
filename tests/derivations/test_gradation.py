"""Every closed form of gradation and branch lengths against the integral that it stands for."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from functools import cache
from typing import Any

import pytest
import sympy as sp
from mpmath import mp

from derivations import branch_directions, lognormal
from derivations.branch_lengths import MODE_RATIO, TOTAL_LOG_VARIANCE, power_moment, sum_moment
from derivations.gradation import KINEMATIC, STATIC, gradation, kinematic_number, stiffness_scale
from derivations.symbols import coordination, log_variance, mean_cube, mean_stress, nu, shear_modulus, void_ratio
from granular.generated import gradation as emitted

SPREADS = ("1.2", "1.5", "2")
CLOSE = mp.mpf(10) ** -20
"""Quadrature in 30 digits of entire functions that fall like a Gauss curve."""


@pytest.fixture(autouse=True)
def digits() -> Iterator[None]:
    """Quadrature works in 30 digits."""
    with mp.workdps(30):
        yield


def variance(spread: str) -> Any:
    """Return L = ln^2 s_r."""
    return mp.log(mp.mpf(spread)) ** 2


def number(expression: sp.Expr, at: Any) -> Any:
    """An expression of L in 30 digits."""
    return sp.lambdify(log_variance, expression, "mpmath")(at)


def density(form: Callable[[sp.Expr, sp.Expr, sp.Expr], sp.Expr], center: Any, at: Any) -> Callable[[Any], Any]:
    """A lognormal density as a function of the size, from the expression that is proved."""
    size, middle, spread = sp.symbols("size middle spread", positive=True)
    function = sp.lambdify((size, middle, spread), form(size, middle, spread), "mpmath")
    return lambda radius: function(radius, center, at)


def integral(function: Callable[[Any], Any], center: Any, at: Any) -> Any:
    """Integral over all sizes, in their logarithm, of what is a Gauss curve there."""
    deviation = mp.sqrt(at)
    ends = [mp.log(center) + step * deviation for step in range(-18, 27, 4)]
    return mp.quad(lambda u: function(mp.exp(u)) * mp.exp(u), ends)


@pytest.mark.parametrize("spread", SPREADS)
@pytest.mark.parametrize("order", [-3, -2, 0, 1, 2, 3])
def test_moments_of_both_forms(spread: str, order: int) -> None:
    """A lost 1/r, a wrong constant A or a wrong exponent changes the moment; order zero is the normalisation."""
    at, center = variance(spread), mp.mpf("1.7")
    for form, moment in ((lognormal.printed_density, lognormal.printed_moment),
                         (lognormal.classical_density, lognormal.classical_moment)):
        one = density(form, center, at)
        found = integral(lambda r, one=one: one(r) * r**order, center, at)
        expected = sp.lambdify(log_variance, moment(sp.Rational(17, 10), log_variance, sp.Integer(order)), "mpmath")(at)
        assert abs(found / expected - 1) < CLOSE


@pytest.mark.parametrize("spread", SPREADS)
def test_number_density(spread: str) -> None:
    """Eq. (12) point by point: a shift other than exp(-3 L) or another spread breaks it."""
    at = variance(spread)
    for form in (lognormal.printed_density, lognormal.classical_density):
        by_volume, by_number = density(form, mp.mpf(1), at), density(form, mp.exp(-3 * at), at)
        total = integral(lambda r, one=by_volume: one(r) / r**3, mp.exp(-2 * at), at)
        for size in ("0.2", "0.7", "1", "3"):
            radius = mp.mpf(size)
            assert abs(by_volume(radius) / radius**3 / total / by_number(radius) - 1) < CLOSE
        cube = integral(lambda r, one=by_number: one(r) * r**3, mp.mpf(1), at)
        assert abs(cube * total - 1) < CLOSE


@pytest.mark.parametrize(("spread", "printed"), [("1.2", "1.3"), ("1.5", "1.9"), ("2", "2.9")])
def test_coefficients_of_uniformity(spread: str, printed: str) -> None:
    """Percentiles by root finding on the integrated density: D60 over D10 is what Table I prints, rounded."""
    at = variance(spread)
    deviation, median = mp.sqrt(at), mp.exp(at)

    def size_at(percent: int) -> Any:
        def finer(u: Any) -> Any:
            return mp.ncdf((u - mp.log(median)) / deviation) - mp.mpf(percent) / 100

        return mp.exp(mp.findroot(finer, mp.log(median)))

    below = density(lognormal.printed_density, mp.mpf(1), at)
    ends = [mp.log(size_at(10)) - step * deviation for step in (16, 8, 4, 0)]
    assert abs(mp.quad(lambda u: below(mp.exp(u)) * mp.exp(u), ends) - mp.mpf("0.1")) < CLOSE
    exact = sp.Rational(spread)
    uniformity = size_at(60) / size_at(10)
    assert abs(uniformity - mp.mpf(str(sp.N(lognormal.uniformity(exact), 30)))) < CLOSE
    assert round(float(uniformity), 1) == float(printed)
    curvature = size_at(30) ** 2 / size_at(60) / size_at(10)
    assert abs(curvature - mp.mpf(str(sp.N(lognormal.curvature(exact), 30)))) < CLOSE


@pytest.mark.parametrize("spread", SPREADS)
@pytest.mark.parametrize("length", ["0.9", "2", "5"])
def test_one_integral_for_all_branches(spread: str, length: str) -> None:
    """The convolution of eq. (16) as it stands against the integral over the ratio of both radii."""
    at, ell = variance(spread), mp.mpf(length)
    radius = density(lognormal.classical_density, mp.mpf(1), at)
    deviation = mp.sqrt(at)
    # halves are alike; the shorter radius runs over its logarithm
    ends = [mp.log(ell / 2) - step * deviation for step in (24, 12, 6, 3, 1, 0)]
    direct = 2 * mp.quad(lambda u: radius(mp.exp(u)) * radius(ell - mp.exp(u)) * mp.exp(u), ends)

    def turned(w: Any) -> Any:
        return mp.exp(-((mp.log(ell) - mp.log(2 * mp.cosh(w / 2))) ** 2 + w * w / 4) / at)

    points = [step * deviation for step in (0, 2, 5, 10, 20, 30)]
    single = 2 * mp.quad(turned, points) / (2 * mp.pi * at * ell)
    assert abs(direct / single - 1) < mp.mpf(10) ** -15  # the convolution ends where half of ell is cut off


def literal_integrals(spread: float, *, cut: float = math.inf) -> Callable[[int], float]:
    """Int l^k g_total^(1/3) dl for radii of eq. (18) with mode 1, from (12) and (16) as they are.

    ``cut`` ends the sizes at s_r^cut from the mode on either side, the r_m and r_M of the paper. Equal steps in the
    logarithms; without a cut they converge faster than any power, to all but roundings.
    """
    at = math.log(spread) ** 2
    deviation = math.sqrt(at)
    median = math.exp(-2 * at)
    limit = cut * deviation
    step = deviation * (0.25 if math.isinf(cut) else 0.04)
    low, high = math.log(2 * median) - 25 * deviation, math.log(2 * median) + 8 * at + 25 * deviation
    if not math.isinf(cut):
        low, high = math.log(2) - limit, math.log(2) + limit

    def log_total(q: float) -> float:
        terms = []
        reach = abs(q - math.log(2 * median)) + 20 * deviation
        count = int(reach / (0.4 * step)) + 1
        for place in range(-count, count + 1):
            w = 0.4 * step * place
            log_first = q - max(w, 0.0) - math.log1p(math.exp(-abs(w)))
            log_second = log_first + w
            if abs(log_first) <= limit and abs(log_second) <= limit:
                # f_p ~ r^-3 f_v for both, and dr = r (l - r)/l dw
                volume = -(log_first**2 + log_second**2) / (2 * at)
                terms.append(volume - 2 * (log_first + log_second) - q)
        if not terms:
            return -math.inf
        largest = max(terms)
        return largest + math.log(math.fsum(math.exp(term - largest) for term in terms))

    places = [low + step * place for place in range(int((high - low) / step) + 1)]
    logs = [log_total(q) for q in places]
    largest = max(logs)
    return lambda k: math.fsum(math.exp((one - largest) / 3 + (k + 1) * q) for one, q in zip(logs, places, strict=True))


def literal_numbers(spread: float, *, cut: float = math.inf) -> tuple[float, float]:
    """<l^2>/<r^3>^(2/3) and 1/(<l^-2> <r^3>^(2/3)) by quadrature."""
    at = math.log(spread) ** 2
    limit = cut * math.sqrt(at)
    moment = literal_integrals(spread, cut=cut)
    if math.isinf(cut):
        cube = math.exp(-1.5 * at)
    else:
        step = 2 * limit / 2000
        radii = [-limit + step * place for place in range(2001)]
        by_volume, by_number = (math.fsum(math.exp(-u * u / (2 * at) - k * u) for u in radii) for k in (-1, 2))
        cube = by_volume / by_number
    scale = cube ** (2 / 3)
    return moment(2) / moment(0) / scale, moment(0) / moment(-2) / scale


@cache
def uncut(spread: str) -> tuple[float, float]:
    """Numbers of one spread with all sizes."""
    return literal_numbers(float(spread))


@pytest.mark.parametrize(("spread", "literal", "by_eq_19"), [
    ("1.2", (4.355597303318223, 3.561207899550063), (4.352, 3.559)),
    ("1.5", (6.55086707705458, 2.257330252476026), (6.219, 2.227)),
    ("2", (33.15523900113815, 0.7508649371987685), (17.196, 0.683)),
])
def test_number_that_carries_gradation(spread: str, literal: tuple[float, float],
                                       by_eq_19: tuple[float, float]) -> None:
    """Eqs (12), (16), (17) as they stand, kinematic and static, beside eq. (19), which lacks long branches.

    Equal spheres have 4: either way the stiffness depends on uniformity. Eq. (19) is 0.1, 5 and 48 % too low under
    the kinematic hypothesis. The stored values are those of this rule with half its steps; a nested quadrature over
    the radii themselves gave 4.3555973, 6.5508671 and 33.1556.
    """
    assert uncut(spread) == pytest.approx(literal, rel=1e-13)
    closed = [float(4 * number(expression, variance(spread))) for expression in (KINEMATIC, STATIC)]
    assert closed == pytest.approx(by_eq_19, abs=6e-4)


@pytest.mark.parametrize(("spread", "rounded"), [("1.2", 4.355), ("1.5", 6.50), ("2", 29.0)])
def test_number_with_sizes_cut(spread: str, rounded: float) -> None:
    """Sizes cut at six standard deviations from r_50 take 12 % off at s_r = 2: few long branches make the number."""
    assert literal_numbers(float(spread), cut=6.0)[0] == pytest.approx(rounded, rel=2e-3)  # steps end at the cuts
    assert uncut(spread)[0] > rounded


@pytest.mark.parametrize("spread", SPREADS)
def test_branch_moments_under_eq_19(spread: str) -> None:
    """Cube the closed form's density back: it must be a lognormal with the mean and mean square of the sum."""
    at = variance(spread)
    mode, spread_along = number(MODE_RATIO, at), 3 * number(TOTAL_LOG_VARIANCE, at)
    along = density(lognormal.printed_density, mode, spread_along)
    total = integral(lambda ell: along(ell) ** 3, mode, spread_along / 3)
    for order in (1, 2):
        found = integral(lambda ell, order=order: along(ell) ** 3 * ell**order, mode, spread_along / 3) / total
        assert abs(found / number(sum_moment(order), at) / mp.exp(-2 * order * at) - 1) < CLOSE
    for order in (2, -2):
        found = integral(lambda ell, order=order: along(ell) * ell**order, mode, spread_along)
        assert abs(found / number(power_moment(sp.Integer(order)), at) - 1) < CLOSE


def test_moments_of_the_sum_without_a_root() -> None:
    """With g_total itself the number is 2 (e^-L + e^-2L), below 4: the cube root is what makes it grow."""
    at = variance("2")
    radius = density(lognormal.classical_density, mp.mpf(1), at)
    first, second = (integral(lambda r, k=k: radius(r) * r**k, mp.mpf(1), at) for k in (1, 2))
    found = (2 * second + 2 * first**2) / integral(lambda r: radius(r) * r**3, mp.mpf(1), at) ** (mp.mpf(2) / 3)
    assert abs(found - 2 * (mp.exp(-at) + mp.exp(-2 * at))) < CLOSE
    assert abs(found - number(kinematic_number(sp.Integer(1)), at)) < CLOSE


def test_first_orders() -> None:
    """At s_r = 1.02 the changes over L by quadrature are 5/2 and -7/2, and eq. (19) is off by L^2/2."""
    at = math.log(1.02) ** 2
    kinematic, static = (math.log(one / 4) for one in uncut("1.02"))
    assert kinematic == pytest.approx(2.5 * at + 13 / 8 * at**2, abs=30 * at**3)
    assert static == pytest.approx(-3.5 * at + at**2 / 8, abs=30 * at**3)
    for literal, expression in ((kinematic, KINEMATIC), (static, STATIC)):
        neglected = literal - float(mp.log(number(expression, variance("1.02"))))
        assert neglected / at**2 == pytest.approx(0.5, abs=0.01)


def test_exponent_that_balances() -> None:
    """At p = 4/7 the first order vanishes, at 1/3 it does not; the rest is 4 cosh^4(L/2)."""
    small = mp.mpf(10) ** -10
    assert abs(number(kinematic_number(sp.Rational(4, 7)), small) / 4 - 1) < small**2
    assert abs((number(kinematic_number(sp.Rational(1, 3)), small) / 4 - 1) / small - mp.mpf(5) / 2) < 20 * small
    assert abs(number(kinematic_number(sp.Rational(4, 7)), mp.mpf(1)) - 4 * mp.cosh(mp.mpf(1) / 2) ** 4) < CLOSE


@pytest.mark.parametrize("index", range(4))
@pytest.mark.parametrize("zeta", ["-40", "-0.3", "0.3", "7"])
def test_kummer_moments(index: int, zeta: str) -> None:
    """Both forms against quadrature, for spreads that are larger across the axis and along it."""
    at = mp.mpf(zeta)
    found = mp.quad(lambda x: x ** (2 * index) * mp.exp(at * x * x), [0, mp.mpf(1) / 4, mp.mpf(1) / 2, 1])
    for form in (branch_directions.kummer_moment, branch_directions.kummer_moment_from_pole):
        value = sp.lambdify(branch_directions.zeta, form(sp.Integer(index)), "mpmath")(at)
        assert abs(value / found - 1) < CLOSE


@pytest.mark.parametrize("spread", ["1.0000001", "1.2", "2", "10"])
def test_emitted_parameters_lose_no_digit(spread: str) -> None:
    """Near equal sizes 1 + e^L would leave half the digits; the emitted code keeps all but a few roundings."""
    at = math.log(float(spread)) ** 2
    exact = [number(expression, mp.mpf(at)) for expression in (3 * TOTAL_LOG_VARIANCE, MODE_RATIO, KINEMATIC, STATIC)]
    found = (*emitted.branch_parameters(at), *emitted.gradation_factor(at))
    # an exponent of size x that is rounded costs x roundings: 9 L/2 is 40 at a spread of 10
    for value, reference in zip(found, exact, strict=True):
        assert abs(value / reference - 1) < (2 + 20 * at) * 2.0**-52
    changes = [float(one - 1) for one in exact[2:]]
    assert [value - 1 for value in found[2:]] == pytest.approx(changes, rel=1e-15 * (1 + 20 * at), abs=3e-16)


def test_emitted_moments() -> None:
    """The two forms side by side: the same density has the median r50 exp(L)."""
    (printed,), (classical,) = (emitted.printed_lognormal_moment(2e-3, 0.4, 3.0),
                                emitted.classical_lognormal_moment(2e-3 * math.exp(0.4), 0.4, 3.0))
    assert printed == pytest.approx(8e-9 * math.exp(3.0), rel=1e-15 * 8)
    assert classical == pytest.approx(printed, rel=1e-15 * 8)


def test_equal_spheres_exactly() -> None:
    """Without spread all factors are exactly 1 and the length exactly the diameter."""
    assert emitted.gradation_factor(0.0) == (1.0, 1.0)
    assert emitted.branch_parameters(0.0) == (0.0, 2.0)


def test_stiffness_scale_of_equal_spheres() -> None:
    """At L = 0 the full factor is (M/V) l^2 k_n of equal spheres, whatever their radius."""
    at = {coordination: 8, void_ratio: sp.Rational(3, 5), mean_stress: 28000, shear_modulus: 31 * 10**9,
          nu: sp.Rational(21, 100)}
    whole = sp.N(stiffness_scale(sp.Integer(1)).subs(at), 30)
    contacts = gradation().output("contacts_per_volume").expression
    for radius in (sp.Rational(1, 1000), sp.Rational(1, 7)):
        number_of_contacts = contacts.subs({**at, mean_cube: radius**3})
        force = 3 * 28000 / (number_of_contacts * 2 * radius)
        normal = sp.cbrt(3 * force * radius) * (31 * 10**9 / (1 - sp.Rational(21, 100))) ** sp.Rational(2, 3)
        assert abs(sp.N(number_of_contacts * 4 * radius**2 * normal, 30) / whole - 1) < sp.Float("1e-25", 30)
