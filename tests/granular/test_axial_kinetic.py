"""The rule for contact forces, slip and opening, for scenes and for arrays, against independent voices."""

import itertools
import math
import warnings
from fractions import Fraction

import numpy as np
import pytest
import scipy.integrate
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import granular
from granular.errors import ComplianceInfinite
from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.loading import Loading
from granular.routes import axial, closed_form, midpoint, sphere
from granular.routes.contact_rule import suitable_contacts

NU = 0.21
TWELVE = math.tan(math.radians(12))
BOTH = (Hypothesis.KINEMATIC, Hypothesis.STATIC)


def ratios(route, fabric, loading, **options):
    c1111, c3333, _, _, c2323, c1212 = route.evaluate(fabric, poisson_ratio=NU, hypothesis=Hypothesis.KINEMATIC,
                                                      loading=loading, **options).components
    return c1111 / c3333, c2323 / c1212


PRINTED = [  # case of Tables III to V, fabric, stress ratio, friction, exact, 24 panels
    ("III-2", (0.3, -0.3), 1.0, None, (1.2559, 0.8995), (1.2538, 0.9001)),
    ("III-3", (0.3, -0.3), 1.0, TWELVE, (1.2809, 0.9012), (1.2786, 0.9018)),
    ("IV 0.3", (0.3, 0.0), 1.0, TWELVE, (0.8595, 1.0896), (0.8572, 1.0910)),
    ("IV 0.5", (0.5, 0.0), 1.0, TWELVE, (0.7767, 1.1583), (0.7743, 1.1601)),
    ("V 1.5", (0.0, 0.0), 1.5, TWELVE, (0.9756, 1.0807), (0.9726, 1.0822)),
    ("V 2", (0.0, 0.0), 2.0, TWELVE, (0.9381, 1.1918), (0.9401, 1.1807)),
]


@pytest.mark.parametrize("case", PRINTED, ids=[case[0] for case in PRINTED])
def test_tables_iii_to_v(case):
    # any slip in eqs (20)-(23): exact values and the historical rule, both to the four decimals once computed by hand
    _, (d, dr), ratio, friction, exact, panels = case
    fabric, loading = AxialFabric(D33=d, Dr33=dr), Loading.of_ratio(ratio, friction=friction)
    assert ratios(axial, fabric, loading) == pytest.approx(exact, abs=5.1e-5)
    assert ratios(midpoint, fabric, loading) == pytest.approx(panels, abs=5.1e-5)


def moments_by_quadrature(fabric, loading, hypothesis):
    """Nine moments by adaptive quadrature with break points, from eqs (20)-(23) as they stand."""
    a, c = (float(value) for value in loading.coefficients(fabric.D33))
    mu = loading.friction
    points = []
    if mu and a > 0 and c > 0:
        k = abs(c - a) / (2 * mu)
        near = math.atan(math.sqrt(c / a))
        root = k * k - a * c
        points = [near] if root <= 0 else [math.atan((k - math.sqrt(root)) / a), math.atan((k + math.sqrt(root)) / a)]

    def integrand(beta, which, power):
        s, y = math.sin(beta) ** 2, math.cos(beta) ** 2
        kn = np.cbrt(max(a * s + c * y, 0.0))
        h = a * s + c * y - (abs(c - a) * math.sqrt(s * y) / mu if mu else 0.0)
        kr = np.cbrt(max(h, 0.0))
        branch = (1 - fabric.Dr33 / 2) * s + (1 + fabric.Dr33) * y
        density = (1 - fabric.D33 / 2) * s + (1 + fabric.D33) * y
        weight = density * (branch**2 if hypothesis is Hypothesis.KINEMATIC else branch**-2)
        k = (kn, kr)[which]
        return (weight * (k if hypothesis is Hypothesis.KINEMATIC else 1 / k) * s ** (2 - power) * y**power
                * math.sin(beta))

    ends = [0.0, *points, math.pi / 2]
    return [[sum(scipy.integrate.quad(integrand, low, high, args=(which, power), epsabs=0, epsrel=1e-12, limit=200)[0]
                 for low, high in itertools.pairwise(ends)) for power in range(3)] for which in (0, 1)]


@pytest.mark.parametrize(("d", "dr", "ratio", "mu", "hypothesis"), [
    (0.3, -0.3, 1.5, None, Hypothesis.KINEMATIC), (0.3, -0.3, 1.5, 0.4, Hypothesis.KINEMATIC),
    (-0.6, 0.9, 3.0, 0.3, Hypothesis.KINEMATIC), (0.0, 0.0, 0.3, 0.2, Hypothesis.KINEMATIC),
    (0.3, -0.3, 1.5, None, Hypothesis.STATIC), (0.7, 0.5, 0.6, 0.9, Hypothesis.STATIC),
    (-1.0, -0.5, 2.0, 1.5, Hypothesis.STATIC),
])
def test_against_adaptive_quadrature(d, dr, ratio, mu, hypothesis):
    # a weight, a Jacobian or a component wrong in the mapped rule; quad itself is good to about 1e-9 here
    fabric, loading = AxialFabric(D33=d, Dr33=dr), Loading.of_ratio(ratio, friction=mu)
    (p0, p1, p2), (q0, q1, q2) = moments_by_quadrature(fabric, loading, hypothesis)
    lam = 2 * (1 - NU) / (2 - NU)
    if hypothesis is Hypothesis.KINEMATIC:
        q0, q1, q2 = lam * q0, lam * q1, lam * q2
        d0, d1 = p0 - q0, p1 - q1
        expected = (3 * p0 / 8 + q0 / 8 + q1 / 2, p2 + q1, d0 / 8, d1 / 2,
                    d1 / 2 + q0 / 8 + 3 * q1 / 8 + q2 / 4, d0 / 8 + q0 / 4 + q1 / 4)
    else:
        q0, q1, q2 = q0 / lam, q1 / lam, q2 / lam
        n11, n33 = 1 / 3 - d / 15, 1 / 3 + 2 * d / 15
        s11, s33 = (3 * p0 / 8 + q0 / 8 + q1 / 2) / n11**2, (p2 + q1) / n33**2
        s12, s13 = (p0 - q0) / 8 / n11**2, (p1 - q1) / 2 / (n11 * n33)
        s44 = ((p1 + q0) / n11**2 + (p1 + 2 * q2 + q1) / n33**2 + 2 * (p1 - q1) / (n11 * n33)) / 8
        block = np.linalg.inv([[s11, s12, s13], [s12, s11, s13], [s13, s13, s33]])
        expected = (block[0, 0], block[2, 2], block[0, 1], block[0, 2], 1 / (4 * s44), 1 / (2 * (s11 - s12)))
    found = axial.evaluate(fabric, poisson_ratio=NU, hypothesis=hypothesis, loading=loading).components
    assert found == pytest.approx(expected, rel=3e-8)


@settings(max_examples=60)
@given(st.floats(-1, 2), st.floats(-0.999, 1.999), st.floats(0.15, 6), st.floats(0, 0.5), st.sampled_from(BOTH))
def test_against_the_series(d, dr, ratio, nu, hypothesis):
    # contact forces without slip by two ways that share nothing but the components
    assume(nu == 0 or nu > 1e-290)  # below, C1122 may be too small for a double, which a scene refuses
    fabric = AxialFabric(D33=d, Dr33=dr if hypothesis is Hypothesis.KINEMATIC else 0.0)
    loading = Loading.of_ratio(ratio)
    if not closed_form.covers(fabric, hypothesis, loading):
        return
    one, other = (route.evaluate(fabric, poisson_ratio=nu, hypothesis=hypothesis, loading=loading)
                  for route in (axial, closed_form))
    bound = one.relative_error + other.relative_error
    assert one.components == pytest.approx(other.components, rel=bound, abs=0)


@settings(max_examples=20)
@given(st.floats(-1, 2), st.floats(-0.9, 1.9), st.floats(0.3, 3), st.sampled_from((0.0, 0.1)))
def test_against_the_sphere(d, dr, ratio, d3333):
    # the reduction from tensors to the meridian, under contact forces
    fabric = AxialFabric(D33=d / 4, Dr33=dr, D3333=d3333)
    loading = Loading.of_ratio(ratio)
    by_sphere = sphere.evaluate(fabric, poisson_ratio=NU, hypothesis=Hypothesis.KINEMATIC, loading=loading)
    by_axis = axial.evaluate(fabric, poisson_ratio=NU, hypothesis=Hypothesis.KINEMATIC, loading=loading)
    assert by_axis.components == pytest.approx(by_sphere.components, rel=by_sphere.relative_error, abs=0)


@pytest.mark.parametrize(("ratio", "mu", "hypothesis", "tolerance"), [
    (1.5, 0.5, Hypothesis.KINEMATIC, 1e-12), (1.5, 0.5, Hypothesis.STATIC, 1e-12),
    # contacts slide: the sphere rule has no edge to follow, so that it is good to two or three digits
    (2.0, TWELVE, Hypothesis.KINEMATIC, 1e-2)])
def test_slip_against_the_sphere(ratio, mu, hypothesis, tolerance):
    # slip along a meridian that is not the one of the shear force
    fabric, loading = AxialFabric(D33=0.3, Dr33=-0.3), Loading.of_ratio(ratio, friction=mu)
    by_sphere = sphere.components_by_degree(fabric, poisson_ratio=NU, hypothesis=hypothesis, degree=131,
                                            loading=loading)
    by_axis = axial.evaluate(fabric, poisson_ratio=NU, hypothesis=hypothesis, loading=loading).components
    assert by_axis == pytest.approx(by_sphere, rel=max(tolerance, 2e-4))


SLIPPING = st.tuples(st.floats(-1, 2), st.floats(-0.999999, 1.999999), st.floats(-10, 10), st.floats(-10, 6),
                     st.sampled_from((0.0, 1e-16, 0.21, 0.5)))


@settings(max_examples=80)
@given(SLIPPING)
def test_scenes_and_arrays_agree(point):
    # the two implementations of one rule: geometry in decimals and in exact sums of doubles
    d, dr, log_ratio, log_mu, nu = point
    assume(d == 0 or abs(d) > 1e-290)  # below, C1122 may be too small for a double, which a scene refuses
    ratio, mu = 10**log_ratio, 10**log_mu
    loading = Loading.of_ratio(ratio, friction=mu)
    for hypothesis in BOTH:
        if hypothesis is Hypothesis.STATIC and loading.slides(d):
            continue
        scalar = axial.evaluate(AxialFabric(D33=d, Dr33=dr), poisson_ratio=nu, hypothesis=hypothesis, loading=loading)
        array = granular.axial_stiffness(d, dr, ratio, mu, nu, hypothesis=hypothesis)
        assert array.tolist() == pytest.approx(scalar.components, rel=3e-15, abs=0)


def test_arrays_raise_no_warning():
    # a dead branch evaluated outside its domain, an overflow on the way, a division by a vanishing force
    d, ratio, mu = np.meshgrid([-1.0, 0.0, 0.3, 2.0], [1e-100, 1e-10, 0.25, 1.0, 1 + 2**-52, 4.0, 1e10, 1e100],
                               [1e-16, 1e-10, 0.2, 0.75, 1.0, 1e6, 1e16])
    with warnings.catch_warnings(), np.errstate(all="raise", under="ignore"):
        warnings.simplefilter("error")
        assert np.isfinite(granular.axial_stiffness(d, -0.3, ratio, mu, 0.0)).all()
        assert np.isfinite(granular.axial_stiffness(d, 1.999999, ratio, hypothesis="static")).all()


def test_each_element_is_its_own():
    # an element that changes with its neighbours: blocks, sorting and masks put back in the wrong place
    rng = np.random.default_rng(7)
    d, dr = rng.uniform(-1, 2, 300), rng.uniform(-0.9, 1.9, 300)
    ratio, mu = 10 ** rng.uniform(-3, 3, 300), 10 ** rng.uniform(-3, 2, 300)
    mu[::7] = 0
    ratio[::5], d[::5] = 1.0, 0.0
    together = granular.axial_stiffness(d, dr, ratio, mu)
    for k in range(0, 300, 11):
        alone = granular.axial_stiffness(d[k], dr[k], ratio[k], mu[k])
        np.testing.assert_allclose(together[k], alone, rtol=2e-15)


def test_absent_effects_change_no_bit():
    # an effect that a scene does not call for, simulated all the same
    d, dr = 0.0, np.linspace(-0.9, 1.9, 5)
    constant = granular.axial_stiffness(d, dr, kinetic=False)
    np.testing.assert_array_equal(granular.axial_stiffness(d, dr), constant)
    np.testing.assert_array_equal(granular.axial_stiffness(d, dr, 1.0, 0.3), constant)
    kinetic = granular.axial_stiffness(0.3, dr, 1.5)
    np.testing.assert_array_equal(granular.axial_stiffness([0.3], dr, [1.5]), kinetic)


@pytest.mark.parametrize("hypothesis", BOTH)
@pytest.mark.parametrize("ratio", [4.0, 0.25])
def test_exact_tangency(ratio, hypothesis):
    # |sigma|^(2/3) at the onset: the limit from the sticking side, and finite by the static hypothesis
    fabric = AxialFabric(Dr33=0.2)

    def at(mu):
        return np.array(axial.evaluate(fabric, poisson_ratio=NU, hypothesis=hypothesis,
                                       loading=Loading.of_ratio(ratio, friction=mu)).components)

    onset, above = at(0.75), at(0.75 * (1 + 1e-12))
    exponent = 5 / 6 if hypothesis is Hypothesis.KINEMATIC else 1 / 6
    gap = np.abs(above / onset - 1)
    assert (gap > 0).all()
    assert (gap < 30 * 1e-12**exponent).all()
    if hypothesis is Hypothesis.STATIC:
        with pytest.raises(ComplianceInfinite):
            at(math.nextafter(0.75, 0))
    else:
        assert np.abs(at(math.nextafter(0.75, 0)) / onset - 1).max() < 1e-12


@pytest.mark.parametrize("hypothesis", BOTH)
def test_ends_of_the_stress_ratio(hypothesis):
    # a limit that is refused, divided by zero, or not reached: sigma33 = 0 and sigma11 = 0
    fabric = AxialFabric(D33=0.3, Dr33=-0.3)

    def at(sigma11, sigma33):
        return axial.evaluate(fabric, poisson_ratio=NU, hypothesis=hypothesis,
                              loading=Loading(sigma11=Fraction(sigma11), sigma33=Fraction(sigma33))).components

    assert at(1, 0) == pytest.approx(at(1, Fraction(1, 10**80)), rel=1e-15)
    assert at(0, 1) == pytest.approx(at(Fraction(1, 10**80), 1), rel=1e-15)


def test_opening_is_the_continuation_of_no_stress():
    # contacts that open with a jump: a small tension must change little, and take stiffness away
    fabric = AxialFabric(D33=0.3)

    def at(sigma33, mu):
        return np.array(axial.evaluate(fabric, poisson_ratio=NU, hypothesis=Hypothesis.KINEMATIC, loading=Loading(
            sigma11=Fraction(1), sigma33=Fraction(sigma33), friction=mu)).components)

    for mu in (None, 0.3, 0.0):
        assert at(Fraction(-1, 10**9), mu) == pytest.approx(at(0, mu), rel=1e-6)
        # over the unit, which falls with the mean stress; back to pascals it is (1 + sigma33/2)^(1/3) of that
        assert at(Fraction(-1, 2), mu)[1] * 0.75 ** (1 / 3) < at(0, mu)[1]


def test_opened_contacts_have_no_static_compliance():
    # an infinite compliance inverted
    with pytest.raises(ComplianceInfinite, match="opened"):
        axial.evaluate(AxialFabric(), poisson_ratio=NU, hypothesis=Hypothesis.STATIC,
                       loading=Loading(sigma11=Fraction(1), sigma33=Fraction(-1, 2)))


def test_the_trace_is_free_of_slip():
    # C3333 + 2 C1111 + 2 C1122 + 4 C1133 = <E W^2 k_n>, whatever the friction
    fabric = AxialFabric(D33=0.5, Dr33=-0.4)
    totals = []
    for mu in (None, 0.0, 0.05, 0.3, 5.0):
        c1111, c3333, c1122, c1133, *_ = axial.evaluate(
            fabric, poisson_ratio=NU, hypothesis=Hypothesis.KINEMATIC, loading=Loading.of_ratio(2.5, friction=mu)
        ).components
        totals.append(c3333 + 2 * c1111 + 2 * c1122 + 4 * c1133)
    assert totals == pytest.approx([totals[0]] * 5, rel=2e-15)


def test_the_static_estimate_stays_below():
    # hypotheses exchanged, or weights of slip put on the wrong side
    d, dr, ratio = np.meshgrid([-0.8, 0.0, 1.2], [-0.7, 0.0, 1.2], [0.7, 1.0, 1.6])
    upper = granular.axial_stiffness(d, dr, ratio, 3.0)[..., [0, 1, 4, 5]]
    lower = granular.axial_stiffness(d, dr, ratio, 3.0, hypothesis="static")[..., [0, 1, 4, 5]]
    assert (lower <= upper * (1 + 1e-14)).all()


def test_the_number_of_nodes_is_bounded():
    # a rule that grows without end near the onset or under extreme stress
    worst = max(len(suitable_contacts(AxialFabric(D33=d), Loading.of_ratio(ratio, friction=mu), Hypothesis.KINEMATIC))
                for d in (-1.0, 0.0, 2.0) for ratio in (1e-100, 1e-10, 0.25, 4.0, 1e10, 1e100)
                for mu in (1e-16, 1e-4, 0.75, math.nextafter(0.75, 0), 1e4, 1e16))
    assert worst < 4000
