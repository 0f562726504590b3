"""Balls with contact forces: stored values, independent quadrature, limits, extremes, and what is refused."""

from __future__ import annotations

import itertools
import math
import sys
from collections.abc import Callable
from fractions import Fraction

import mpmath
import numpy as np
import pytest
import quadpy

from granular.checks.stored import CertifiedCase, kinetic_cases
from granular.contact_distribution import normal_stiffness, shear_stiffness
from granular.errors import CertifiedArithmeticMissing, ComplianceInfinite
from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.loading import Loading
from granular.routes import certified, certified_kinetic
from granular.routes.certified import Enclosure
from granular.routes.result import COMPONENTS

KINEMATIC, STATIC = Hypothesis.KINEMATIC, Hypothesis.STATIC
MIXED = AxialFabric(D33=0.3, D3333=0.2, Dr33=-0.3)
OPENING = (Loading(sigma11=Fraction(-1, 5), sigma33=Fraction(1), friction=0.3),
           Loading(sigma11=Fraction(1), sigma33=Fraction(-3, 2), friction=0.3),
           Loading(sigma11=Fraction(1), sigma33=Fraction(-3, 2)))


def enclose(fabric: AxialFabric, loading: Loading | None, *, nu: float = 0.21, hypothesis: Hypothesis = KINEMATIC,
            digits: int = 30) -> dict[str, Enclosure]:
    found = certified.enclose(fabric, poisson_ratio=nu, hypothesis=hypothesis, loading=loading, digits=digits)
    return {enclosure.name: enclosure for enclosure in found}


def middle(enclosure: Enclosure) -> mpmath.mpf:
    return mpmath.mpf(enclosure.midpoint.numerator) / enclosure.midpoint.denominator


def relative(value: Fraction, known: Fraction) -> float:
    return float(abs(value - known) / abs(known))


@pytest.mark.parametrize("case", kinetic_cases(), ids=lambda case: f"{case.name}-{case.family}")
def test_the_stored_values_are_found_again(case: CertifiedCase) -> None:
    """A stored value, certified by other means to 1e-33, is not where this route certifies it to be."""
    assert case.loading is not None
    assert (STATIC in case.known) != case.loading.slides(case.fabric.D33)
    for hypothesis, known in case.known.items():
        found = enclose(case.fabric, case.loading, nu=case.poisson_ratio, hypothesis=hypothesis, digits=36)
        for name, value in zip(COMPONENTS, known, strict=True):
            assert abs(found[name].midpoint - value) <= Fraction(1, 10**33) * abs(value), name


def by_quadrature(fabric: AxialFabric, loading: Loading, nu: float) -> tuple[mpmath.mpf, ...]:
    """Eq. (7) by mpmath.quad in beta, broken where contacts open, begin to slide, or are nearest to sliding."""
    a, c = (mpmath.mpf(value.numerator) / value.denominator for value in loading.coefficients(fabric.D33))
    d, q, dr = (mpmath.mpf(value) for value in (fabric.D33, fabric.D3333, fabric.Dr33))
    lam = 2 * (1 - mpmath.mpf(nu)) / (2 - mpmath.mpf(nu))
    shear = None if loading.friction is None else abs(c - a) / mpmath.mpf(loading.friction)
    breaks = {mpmath.mpf(0), mpmath.pi / 2}
    if a * c < 0:
        breaks.add(mpmath.atan(mpmath.sqrt(-c / a)))
    if shear:
        apart = shear**2 - 4 * a * c
        spread = shear + mpmath.sqrt(apart) if apart > 0 else 2 * mpmath.sqrt(a * c)
        breaks |= {mpmath.atan(root) for root in (2 * c / spread, spread / (2 * a) if a else -1) if root > 0}

    def force(beta: mpmath.mpf) -> mpmath.mpf:
        return a * mpmath.sin(beta) ** 2 + c * mpmath.cos(beta) ** 2

    def left(beta: mpmath.mpf) -> mpmath.mpf:
        return force(beta) - (shear or 0) * mpmath.sin(beta) * mpmath.cos(beta)

    def moments(stiffness: Callable[[mpmath.mpf], mpmath.mpf]) -> list[mpmath.mpf]:
        def integrand(beta: mpmath.mpf, i: int) -> mpmath.mpf:
            x, s = mpmath.cos(beta), mpmath.sin(beta) ** 2
            density = 1 + d * mpmath.legendre(2, x) + q * mpmath.legendre(4, x)
            length = 1 + dr * mpmath.legendre(2, x)
            return (density * length**2 * mpmath.cbrt(max(stiffness(beta), 0)) * s ** (2 - i) * x ** (2 * i)
                    * mpmath.sin(beta))

        ends = sorted(breaks)
        return [mpmath.fsum(mpmath.quad(lambda beta, i=i: integrand(beta, i), [low, high])
                            for low, high in itertools.pairwise(ends)) for i in range(3)]

    n = moments(force)
    h = [lam * moment for moment in moments(left)]
    g = [x - y for x, y in zip(n, h, strict=True)]
    return (3 * g[0] / 8 + (h[0] + h[1]) / 2, g[2] + h[1] + h[2], g[0] / 8, g[1] / 2,
            g[1] / 2 + (h[1] + h[2] + (h[0] + h[1]) / 2) / 4, g[0] / 8 + (h[0] + h[1]) / 4)


@pytest.mark.parametrize(("fabric", "loading"), [
    (MIXED, OPENING[0]), (MIXED, OPENING[1]), (MIXED, OPENING[2]),
    (AxialFabric(D33=1.9, Dr33=-0.3), Loading(sigma11=Fraction(-45, 100), sigma33=Fraction(1), friction=2.0)),
    (AxialFabric(D33=1.9, Dr33=-0.3), Loading(sigma11=Fraction(0), sigma33=Fraction(1), friction=2.0)),
    (AxialFabric(Dr33=-0.3), Loading(sigma11=Fraction(1), sigma33=Fraction(0), friction=0.5)),
    (AxialFabric(), Loading.of_ratio(4, friction=0.75)),
    (MIXED, Loading.of_ratio(2.0, friction=0.2)),
    (MIXED, Loading.of_ratio(0.4))], ids=str)
def test_quadrature_with_break_points(fabric: AxialFabric, loading: Loading) -> None:
    """A closed form of an opened, sliding or tangent arc differs from its integral."""
    found = enclose(fabric, loading).values()
    with mpmath.workdps(25):
        for enclosure, value in zip(found, by_quadrature(fabric, loading, 0.21), strict=True):
            assert abs(middle(enclosure) / value - 1) < mpmath.mpf(10) ** -22, enclosure.name


# With shear forces k_r has a kink at the equator and a cone at the pole, so that the rule converges slowly.
@pytest.mark.parametrize(("friction", "accuracy"), [(None, 1e-13), (1.5, 2e-5)])
def test_the_sphere_by_another_library(friction: float | None, accuracy: float) -> None:
    """The reduction to an integral along the meridian is wrong: a rule over the sphere gives something else."""
    fabric, loading, nu = MIXED, Loading.of_ratio(1.2, friction=friction), 0.21
    rule = quadpy.u3.schemes["lebedev_047"]()
    normals = np.asarray(rule.points)
    x = normals[2]
    density = 1 + fabric.D33 * (3 * x**2 - 1) / 2 + fabric.D3333 * (35 * x**4 - 30 * x**2 + 3) / 8
    branch = density * (1 + fabric.Dr33 * (3 * x**2 - 1) / 2) ** 2 * np.asarray(rule.weights)
    k_n, k_r = normal_stiffness(fabric, loading, x), shear_stiffness(fabric, loading, x, poisson_ratio=nu)
    fourth = np.einsum("q,iq,jq,kq,lq->ijkl", branch * (k_n - k_r), *[normals] * 4)
    second = np.einsum("q,iq,lq,jk->ijkl", branch * k_r, normals, normals, np.eye(3))
    tensor = fourth + sum(np.einsum(f"ijkl->{order}", second) for order in ("ijkl", "jikl", "ijlk", "jilk")) / 4
    found = enclose(fabric, loading, nu=nu)
    for name, enclosure in found.items():
        indices = tuple(int(digit) - 1 for digit in name[1:])
        assert tensor[indices] == pytest.approx(float(enclosure.midpoint), rel=accuracy), name


@pytest.mark.parametrize("hypothesis", Hypothesis)
@pytest.mark.parametrize("loading", [Loading.of_ratio(1.5, friction=0.4), Loading.of_ratio(0.25, friction=0.75),
                                     Loading.of_ratio(1e100), Loading.of_ratio(0.0)], ids=str)
def test_enclosures_are_narrow_and_nested(loading: Loading, hypothesis: Hypothesis) -> None:
    """More digits lead outside the enclosure of fewer digits, or an enclosure is wider than asked for."""
    fabric = AxialFabric(Dr33=-0.3)
    coarse, fine = (enclose(fabric, loading, hypothesis=hypothesis, digits=digits) for digits in (12, 50))
    for name, wide in coarse.items():
        assert wide.lower <= fine[name].lower <= fine[name].upper <= wide.upper
        assert fine[name].radius <= Fraction(1, 10**50) * abs(fine[name].midpoint)


EXTREMES = list(itertools.product(
    (AxialFabric(D33=2.0, Dr33=math.nextafter(2.0, 0.0)), AxialFabric(D33=-1.0, Dr33=math.nextafter(2.0, 0.0))),
    (0.0, 1e-100, 1.0, 1 + 2.0**-52, 1e100), (None, 0.0, 1e-16, 1e16), (0.0, 1e-16, 0.5)))


def test_every_extreme_is_enclosed() -> None:
    """Some corner of the admissible inputs has no enclosure, a zero that is not exact, or an exact zero too many."""
    for fabric, ratio, friction, nu in EXTREMES:
        loading = Loading.of_ratio(ratio, friction=friction)
        found = enclose(fabric, loading, nu=nu)
        uncoupled = nu == 0 and friction != 0 and loading.tilt(fabric.D33) == 0
        assert all(enclosure.lower > 0 for name, enclosure in found.items() if name not in {"C1122", "C1133"})
        for name in ("C1122", "C1133"):
            if uncoupled:
                assert found[name].lower == found[name].upper == 0
            else:
                assert found[name].lower > 0, (fabric, loading, nu)


def test_equal_forces_are_the_constant_case() -> None:
    """The two branches of the code disagree where stress and fabric cancel, a = c, but for the factor a^(1/3)."""
    fabric, loading = AxialFabric(D33=-1.0, Dr33=0.4), Loading.of_ratio(0.5, friction=0.1)
    a, c = loading.coefficients(fabric.D33)
    assert a == c
    factor = mpmath.mpf(a.numerator) / a.denominator
    for hypothesis in Hypothesis:
        with_forces, without = (enclose(fabric, given, hypothesis=hypothesis) for given in (loading, None))
        with mpmath.workdps(30):
            for name, enclosure in with_forces.items():
                assert abs(middle(enclosure) / mpmath.cbrt(factor) / middle(without[name]) - 1) < 1e-28


def test_friction_between_its_limits() -> None:
    """No friction is not the limit of small mu, or no friction limit is not the limit of large mu."""
    loading = Loading.of_ratio(1.7, friction=0.0)
    small, none = (enclose(MIXED, Loading.of_ratio(1.7, friction=mu)) for mu in (1e-14, 0.0))
    large, unlimited = (enclose(MIXED, Loading.of_ratio(1.7, friction=mu)) for mu in (1e14, None))
    for name in COMPONENTS:
        assert 0 < relative(small[name].midpoint, none[name].midpoint) < 1e-13
        assert 0 < relative(large[name].midpoint, unlimited[name].midpoint) < 1e-12
    free = enclose(MIXED, loading)
    for one, other in (("C2323", "C1133"), ("C1212", "C1122")):
        assert abs(free[one].midpoint - free[other].midpoint) <= free[one].radius + free[other].radius


def test_continuous_through_tangency() -> None:
    """The formulas of sticking, tangent and sliding contacts do not meet where one direction begins to slide."""
    at = Loading.of_ratio(4.0, friction=0.75)
    assert at.tilt(0.0) == 1
    touching = enclose(AxialFabric(), at)
    for friction in (math.nextafter(0.75, 0), math.nextafter(0.75, 1)):
        for name, enclosure in enclose(AxialFabric(), Loading.of_ratio(4.0, friction=friction)).items():
            # C changes like the power 5/6 of the distance, which is 1e-16: less than 1e-12.
            assert 0 < relative(enclosure.midpoint, touching[name].midpoint) < 1e-12


def test_the_shear_stiffness_does_not_enter_the_trace() -> None:
    """Something of k_r is left in C3333 + 2 C1111 + 2 C1122 + 4 C1133, which is <E W^2 k_n>."""
    def trace(friction: float | None, nu: float) -> tuple[Fraction, Fraction]:
        found = enclose(MIXED, Loading(sigma11=Fraction(1), sigma33=Fraction(3), friction=friction), nu=nu)
        terms = [(1, "C3333"), (2, "C1111"), (2, "C1122"), (4, "C1133")]
        return (sum((k * found[name].lower for k, name in terms), Fraction(0)),
                sum((k * found[name].upper for k, name in terms), Fraction(0)))

    bounds = [trace(friction, nu) for friction, nu in ((None, 0.0), (0.3, 0.21), (0.0, 0.5), (1e9, 0.1))]
    assert max(low for low, _ in bounds) <= min(high for _, high in bounds)


@pytest.mark.parametrize("loading", [*OPENING, Loading.of_ratio(2.0, friction=0.2), Loading.of_ratio(1.0, friction=0.0),
                                     Loading.of_ratio(0.0, friction=0.5)], ids=str)
def test_an_infinite_compliance_is_refused(loading: Loading) -> None:
    """A static stiffness is given although some contacts carry nothing, or carry no shear."""
    with pytest.raises(ComplianceInfinite, match="G-STA-01"):
        enclose(MIXED, loading, hypothesis=STATIC)


def test_static_at_exact_tangency_and_without_stress_across() -> None:
    """1/k grows without bound in one direction, and its integrable edge is taken for an infinite compliance."""
    for loading in (Loading.of_ratio(4.0, friction=0.75), Loading.of_ratio(0.0), Loading(sigma11=Fraction(0),
                                                                                         sigma33=Fraction(1))):
        upper = enclose(AxialFabric(), loading)
        lower = enclose(AxialFabric(), loading, hypothesis=STATIC)
        # The static estimate is the softer one against a change of volume and in both shears.
        assert all(0 < lower[name].upper < upper[name].lower for name in ("C3333", "C1111", "C2323", "C1212"))


def test_exact_decisions() -> None:
    """Tangency is decided on rounded numbers."""
    flint = pytest.importorskip("flint")
    circle = certified_kinetic.mohr(flint, Fraction(1), Fraction(4), Fraction(3, 4))
    assert circle.sticks and circle.tangent
    beyond = certified_kinetic.mohr(flint, Fraction(1), Fraction(4), Fraction(3, 4) - Fraction(1, 10**400))
    assert not beyond.sticks and not beyond.tangent


def test_without_python_flint(monkeypatch: pytest.MonkeyPatch) -> None:
    """A missing library shows as an ImportError instead of as a refusal that says how to install it."""
    monkeypatch.setitem(sys.modules, "flint", None)
    with pytest.raises(CertifiedArithmeticMissing, match=r"G-RTE-02.*pip install"):
        enclose(MIXED, Loading.of_ratio(2.0))


def test_components_are_correctly_rounded() -> None:
    """More than the final rounding is lost on the way to floats."""
    loading = Loading.of_ratio(2.0, friction=0.3)
    result = certified.evaluate(MIXED, poisson_ratio=0.21, hypothesis=KINEMATIC, loading=loading)
    for value, enclosure in zip(result.components, enclose(MIXED, loading).values(), strict=True):
        assert abs(Fraction(value) - enclosure.midpoint) <= Fraction(math.ulp(value)) / 2


