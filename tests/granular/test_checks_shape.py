"""Spheroids and gradation in ``granular check``: what is drawn, what is caught, limits from the derivations."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from fractions import Fraction
from importlib.resources import files
from types import ModuleType
from typing import Any

import pytest
import sympy

from derivations import spheroid_limits as derived
from derivations.spheroid_moments import excess
from derivations.symbols import D33, D3333, lam, varrho
from granular.checks import gradation_comparisons, spheroid_comparisons, stored
from granular.checks.limits import stiffness_ratio
from granular.checks.spheroid_cases import ALWAYS, spheroid_sample
from granular.checks.spheroid_limits import near_the_sphere, needles, plates
from granular.checks.stored import CertifiedCase, spheroid_cases, stored_comparisons
from granular.fabric import AxialFabric
from granular.gradation import LengthMoments
from granular.hypothesis import Hypothesis
from granular.routes import axial, certified, closed_form
from granular.routes.result import RouteResult

FABRICS = (AxialFabric(), AxialFabric(D33=0.5), AxialFabric(D33=-0.75, D3333=0.25))
SAMPLE = list(spheroid_sample(300, seed=5))


def test_the_sample_reaches_what_is_hard() -> None:
    """The sphere, its neighbours, the ends of the range or of the fabric are never drawn."""
    assert tuple(case.fabric.aspect_ratio for case in SAMPLE[:len(ALWAYS)]) == ALWAYS
    assert {1 / 3, 3.0, 1.0, 1 - 2.0**-53, 1 + 2.0**-52, 1e-4, 1e4} <= set(ALWAYS)
    shapes = [case.fabric.aspect_ratio for case in SAMPLE]
    assert min(shapes) == 1e-4 and max(shapes) == 1e4
    assert sum(0 < abs(shape - 1) < 1e-6 for shape in shapes) > 30 < sum(shape < 0.1 for shape in shapes)
    assert {case.fabric.free_spin for case in SAMPLE} == {True, False}
    assert {-1.0, 2.0} <= {case.fabric.D33 for case in SAMPLE}
    assert {0.0, 0.5} <= {case.poisson_ratio for case in SAMPLE}
    assert {case.fabric.D3333 == 0 for case in SAMPLE} == {True, False}
    assert SAMPLE[:40] == list(spheroid_sample(40, seed=5)) != list(spheroid_sample(40, seed=6))


def test_inputs_can_be_run_again() -> None:
    """Digits are lost where an input is shown."""
    for case in SAMPLE[:60]:
        shown = case.inputs()
        fabric = AxialFabric(D33=float(shown["D33"]), D3333=float(shown.get("D3333", 0)),
                             aspect_ratio=float(shown["aspect_ratio"]), free_spin=case.kind == "spin")
        assert (fabric, float(shown["nu"])) == (case.fabric, case.poisson_ratio)


def exactly(expression: sympy.Expr, fabric: AxialFabric, poisson_ratio: float) -> Fraction:
    """A derived expression in D33, D3333 and lam as a fraction."""
    ratio = stiffness_ratio(poisson_ratio)
    found = sympy.Rational(expression.subs({
        D33: sympy.Rational(fabric.D33), D3333: sympy.Rational(fabric.D3333),
        lam: sympy.Rational(ratio.numerator, ratio.denominator)}))
    return Fraction(int(found.p), int(found.q))


@pytest.mark.parametrize("fabric", FABRICS, ids=str)
def test_the_series_at_the_sphere_is_the_derived_one(fabric: AxialFabric) -> None:
    """A coefficient of the first-order series is mistyped."""
    expansion = list(derived.near_sphere())
    relaxed = derived.seven_components()[6].subs(derived.HERTZ).subs(derived.moments_near_sphere(-1))
    relaxed = relaxed.subs(varrho, 1 + excess)
    expansion.append((relaxed.subs(excess, 0), sympy.diff(relaxed, excess).subs(excess, 0)))
    for spin in (False, True):
        chosen = [*expansion[:4], expansion[6 if spin else 4], expansion[5]]
        spun = replace(fabric, aspect_ratio=1.5, free_spin=spin)  # e = 5/4, which the series does not know to be large
        for value, (first, slope) in zip(near_the_sphere(spun, 0.25), chosen, strict=True):
            one, per_excess = exactly(first, fabric, 0.25), exactly(slope, fabric, 0.25)
            assert value == one + Fraction(5, 4) * (per_excess - one / 3)


@pytest.mark.parametrize(("limit", "shape", "left_out"), [
    (near_the_sphere, 1 + 2.0**-40, 2.0**-74), (plates, 2.0**-33, 2.0**-58), (needles, 2.0**33, 2.0**-62)])
def test_limits_against_ball_arithmetic(limit: Any, shape: float, left_out: float) -> None:
    """A limit is not the limit, or it leaves out more than it says."""
    for fabric in FABRICS:
        for spin in (False, True):
            chosen = replace(fabric, aspect_ratio=shape, free_spin=spin)
            found = certified.enclose(chosen, poisson_ratio=0.25, hypothesis=Hypothesis.KINEMATIC)
            for enclosure, known in zip(found, limit(chosen, 0.25), strict=True):
                assert abs(enclosure.midpoint / known - 1) < left_out, enclosure.name


def test_needles_to_leading_order_are_the_derived_ones() -> None:
    """The correction in 1/r does not vanish for needles, or the leading order is another than derived."""
    fabric = replace(FABRICS[2], aspect_ratio=2.0**39)
    n11, n33 = (Fraction(1, 3) + factor * Fraction(fabric.D33) for factor in (Fraction(-1, 15), Fraction(2, 15)))
    lam_, e0 = float(stiffness_ratio(0.25)), float(fabric.density_coefficients()[0])
    size = fabric.aspect_ratio ** (-2 / 3)
    c1111, c3333, *_ = needles(fabric, 0.25)
    assert float(c1111) == pytest.approx(size * (3 + lam_) * math.pi * e0 / 16 / fabric.aspect_ratio, rel=1e-10)
    assert float(c3333) == pytest.approx(size * fabric.aspect_ratio**2 * float(n33 + 2 * lam_ * float(n11)), rel=1e-10)


def off(route: ModuleType, monkeypatch: pytest.MonkeyPatch, *, factor: float) -> None:
    """Put one component of spheroids off, and leave spheres alone."""
    right = route.evaluate

    def wrong(fabric: AxialFabric, **options: Any) -> RouteResult:
        result: RouteResult = right(fabric, **options)
        if fabric.collinear:
            return result
        six = result.components
        return RouteResult((*six[:4], six[4] * factor, six[5]), result.relative_error, result.evaluations)

    monkeypatch.setattr(route, "evaluate", wrong)


@pytest.mark.parametrize("route", [axial, closed_form])
def test_a_wrong_spheroid_is_caught(route: ModuleType, monkeypatch: pytest.MonkeyPatch) -> None:
    """C2323 of spheroids is off by 3e-15, and some part of the checks sees nothing."""
    off(route, monkeypatch, factor=1 + 3e-15)
    for others in ("stored_cases", "kinetic_cases"):
        monkeypatch.setattr(stored, others, tuple)
    for comparisons in (stored_comparisons(), spheroid_comparisons.spheroid_comparisons(20),
                        spheroid_comparisons.spheroid_limit_comparisons()):
        missed = [comparison for comparison in comparisons if not comparison.agrees]
        assert missed
        assert {comparison.route for comparison in missed} == {route.NAME}


def test_a_wrong_gradation_is_caught(monkeypatch: pytest.MonkeyPatch) -> None:
    """A moment that is off by 1e-13 agrees with the certified ones."""
    right = gradation_comparisons.length_moments

    def wrong(sizes: Any) -> LengthMoments:
        found = right(sizes)
        return replace(found, second=found.second * (1 + 1e-13))

    monkeypatch.setattr(gradation_comparisons, "length_moments", wrong)
    missed = [comparison for comparison in gradation_comparisons.gradation_comparisons() if not comparison.agrees]
    assert {comparison.group for comparison in missed} == {"gradation", "gradation: narrow"}
    assert {comparison.hypothesis for comparison in missed} == {Hypothesis.KINEMATIC}


def test_the_stored_spheroids_reach_what_they_should() -> None:
    """A kind of difficulty has no stored case."""
    cases = spheroid_cases()
    equal = [case for case in cases if case.loading is None]
    assert len(equal) >= 38 and len(cases) - len(equal) >= 25
    assert {case.fabric.aspect_ratio for case in equal} >= {1.0, 1 + 2.0**-52, 1 - 1e-8, 0.3, 3.0, 1e-4, 1e4}
    forces = {case.family.removeprefix("spheroids: ") for case in cases if case.loading is not None}
    assert forces == {"stick", "slip", "slide", "frictionless", "opening"}
    static = [case for case in cases if case.loading is not None and Hypothesis.STATIC in case.known]
    assert len(static) == 11
    for case in cases:
        if case.loading is not None:
            sticks = not case.loading.slides(case.fabric.D33)
            assert (Hypothesis.STATIC in case.known) == (sticks and not case.fabric.free_spin), case.name


EQUAL = [case for case in spheroid_cases() if case.loading is None]


@pytest.mark.parametrize("case", EQUAL, ids=lambda case: case.name)
def test_the_stored_spheroids_are_found_again(case: CertifiedCase) -> None:
    """A stored value of contacts of equal stiffness is not where ball arithmetic proves it to be."""
    for hypothesis, known in case.known.items():
        found = certified.enclose(case.fabric, poisson_ratio=case.poisson_ratio, hypothesis=hypothesis, digits=36)
        for enclosure, value in zip(found, known, strict=True):
            assert abs(enclosure.midpoint - value) <= Fraction(1, 10**33) * abs(value), enclosure.name


def test_stored_inputs_are_whole() -> None:
    """An input was stored with fewer digits than the double has."""
    text = (files("granular") / "data" / "certified_spheroid.json").read_text(encoding="utf-8")
    for entry in json.loads(text)["cases"]:
        for name in ("D33", "D3333", "aspect_ratio", "poisson_ratio", "stress_ratio", "friction"):
            if entry.get(name) is not None:
                assert Fraction(entry[name]) == Fraction(float(entry[name])), (entry["id"], name)
