"""Ball arithmetic: enclosures are right, narrow, nested, and independent of how moments are integrated."""

from __future__ import annotations

import math
import sys
from fractions import Fraction

import flint
import pytest

from granular.checks.stored import CertifiedCase, stored_cases
from granular.errors import CertifiedArithmeticMissing, RouteOutOfDomain
from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.routes import certified, exact
from granular.routes.balls import exact_weights, inverse_moment

FABRICS = (AxialFabric(), AxialFabric(D33=0.3, D3333=0.2, Dr33=-0.3), AxialFabric(D33=2.0, Dr33=1.999),
           AxialFabric(D33=-1.0, Dr33=math.nextafter(-1.0, 0.0)))


@pytest.mark.parametrize("case", stored_cases(), ids=lambda case: case.name)
def test_the_stored_values_are_found_again(case: CertifiedCase) -> None:
    """A stored value, certified by other means to 1e-33, is not where this route certifies it to be."""
    for hypothesis, known in case.known.items():
        found = certified.enclose(case.fabric, poisson_ratio=case.poisson_ratio, hypothesis=hypothesis, digits=40)
        for enclosure, value in zip(found, known, strict=True):
            assert abs(enclosure.midpoint - value) <= Fraction(1, 10**33) * abs(value), enclosure.name


@pytest.mark.parametrize("hypothesis", Hypothesis)
@pytest.mark.parametrize("fabric", FABRICS, ids=str)
def test_enclosures_are_narrow_and_nested(fabric: AxialFabric, hypothesis: Hypothesis) -> None:
    """More digits lead outside the enclosure of fewer digits, or an enclosure is wider than asked for."""
    coarse, fine = (certified.enclose(fabric, poisson_ratio=0.21, hypothesis=hypothesis, digits=digits)
                    for digits in (12, 60))
    for wide, narrow in zip(coarse, fine, strict=True):
        assert wide.lower <= narrow.lower <= narrow.upper <= wide.upper
        assert narrow.radius <= Fraction(1, 10**60) * abs(narrow.midpoint)


@pytest.mark.parametrize("fabric", FABRICS, ids=str)
def test_the_kinematic_enclosure_holds_the_rational_value(fabric: AxialFabric) -> None:
    """The emitted closed form in exact arithmetic and the balls disagree."""
    enclosures = certified.enclose(fabric, poisson_ratio=0.21, hypothesis=Hypothesis.KINEMATIC)
    rational = exact.rational_components(fabric, poisson_ratio=0.21, decimal=False)
    for enclosure, value in zip(enclosures, rational, strict=True):
        assert enclosure.lower <= value <= enclosure.upper


@pytest.mark.parametrize("Dr33", [-0.9375, 0.0, 0.25, 1.5])
def test_moments_by_certified_integration(Dr33: float) -> None:
    """The hypergeometric form of a moment does not overlap with its integral, certified on its own."""
    fabric = AxialFabric(Dr33=Dr33)
    _, w0, w1 = exact_weights(fabric)
    with flint.ctx.workprec(120):
        a, b = (flint.acb(flint.fmpq(w.numerator, w.denominator)) for w in (w0, w1))
        for m in range(5):
            integral = flint.acb.integral(
                lambda x, _, m=m: (1 - x * x) ** (4 - m) * x ** (2 * m) / (a * (1 - x * x) + b * x * x) ** 2, 0, 1)
            moment = inverse_moment(flint, (w0, w1), Fraction(2), 4 - m, m)
            assert integral.real.overlaps(moment)
            assert moment.rel_accuracy_bits() > 100


def test_components_are_correctly_rounded() -> None:
    """More than the final rounding is lost on the way to floats."""
    result = certified.evaluate(AxialFabric(D33=0.3, Dr33=1.5), poisson_ratio=0.21, hypothesis=Hypothesis.STATIC)
    enclosures = certified.enclose(AxialFabric(D33=0.3, Dr33=1.5), poisson_ratio=0.21, hypothesis=Hypothesis.STATIC)
    for value, enclosure in zip(result.components, enclosures, strict=True):
        assert abs(Fraction(value) - enclosure.midpoint) <= Fraction(math.ulp(value)) / 2
    assert result.relative_error == 2.0**-53


def test_tiny_coupling_and_no_coupling() -> None:
    """At nu = 0 the search for relative accuracy of a zero does not end, or a tiny nu loses its digits."""
    for hypothesis in Hypothesis:
        none = certified.enclose(AxialFabric(Dr33=0.3), poisson_ratio=0.0, hypothesis=hypothesis)
        assert none[2].lower == none[2].upper == none[3].midpoint == 0
        tiny = certified.enclose(AxialFabric(Dr33=0.3), poisson_ratio=1e-300, hypothesis=hypothesis)
        assert 0 < tiny[2].lower < 1e-299


@pytest.mark.parametrize("digits", [0, -3, 2001])
def test_digits_out_of_range(digits: int) -> None:
    """A number of digits that means nothing is taken."""
    with pytest.raises(RouteOutOfDomain, match="digits"):
        certified.enclose(AxialFabric(), poisson_ratio=0.21, hypothesis=Hypothesis.STATIC, digits=digits)


def test_without_python_flint(monkeypatch: pytest.MonkeyPatch) -> None:
    """A missing library shows as an ImportError instead of as a refusal that says how to install it."""
    monkeypatch.setitem(sys.modules, "flint", None)
    assert not certified.available()
    with pytest.raises(CertifiedArithmeticMissing, match=r"G-RTE-02.*pip install"):
        certified.evaluate(AxialFabric(), poisson_ratio=0.21, hypothesis=Hypothesis.STATIC)
