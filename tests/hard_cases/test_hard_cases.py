"""The corpus of hard inputs: the package is right on each, and an obvious formula is wrong by what is stated."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest

from granular.array_stiffness import axial_stiffness
from granular.checks import hard_cases
from granular.checks.hard_cases import HardCase, HardComparison, relative_error
from granular.checks.naive import NAIVE
from granular.checks.stored import kinetic_cases
from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.loading import Loading
from granular.routes import certified
from granular.routes.result import COMPONENTS

COMPARED = hard_cases.comparison()
CASES = hard_cases.hard_cases()
MOST = {Hypothesis.KINEMATIC: 2e-15, Hypothesis.STATIC: 4e-15}


@pytest.mark.parametrize("compared", COMPARED, ids=lambda compared: compared.name)
def test_stable_and_naive(compared: HardComparison) -> None:
    """The package has lost digits on a hard input, or the naive way is no longer as wrong as the corpus says."""
    assert compared.stable_error <= MOST[compared.case.hypothesis]
    assert not compared.naive_error < compared.case.off_by
    assert compared.case.off_by > 100 * MOST[compared.case.hypothesis]
    assert compared.as_stated
    assert math.isinf(compared.case.off_by) == (not math.isfinite(compared.naive_error))


@pytest.mark.parametrize("case", [case for case in CASES if case.scale is None], ids=lambda case: case.name)
def test_the_value_is_certified(case: HardCase) -> None:
    """A value of the corpus is not where ball arithmetic proves it to be."""
    found = certified.enclose(case.fabric, poisson_ratio=case.poisson_ratio, hypothesis=case.hypothesis,
                              loading=case.loading, digits=36)
    enclosure = found[COMPONENTS.index(case.component)]
    assert abs(enclosure.midpoint - case.certified) <= Fraction(1, 10**33) * abs(case.certified)


@pytest.mark.parametrize("case", [case for case in CASES if case.scale is not None], ids=lambda case: case.name)
def test_the_unit_of_stiffness_is_a_cube_root(case: HardCase) -> None:
    """The cube of the stored unit is not the fraction that it should be."""
    scale = case.scale
    assert scale is not None
    modulus, nu, pressure, density, length = map(Fraction, (
        scale.shear_modulus, case.poisson_ratio, scale.mean_stress, scale.contacts_per_volume, scale.branch_length))
    cube = 3 * (modulus / (1 - nu)) ** 2 * 3 * pressure / (2 * density) * (density * length**2) ** 3
    assert abs(case.certified**3 / cube - 1) < Fraction(1, 10**32)


@pytest.mark.parametrize(("gravity", "scale", "known"), [
    ("pascals", (31e9, 28e3, 5e9, 1e-3), "1692751677.920639745342498226627864"),
    ("hardly any", (31e9, 1e-300, 5e9, 1e-3), "5.574516978091534408471424673118225e-93"),
    ("nanometres", (31e9, 28e3, 1e27, 1e-9), "578912930.5881826982650813664914417")])
def test_certified_units_of_stiffness(gravity: str, scale: tuple[float, float, float, float], known: str) -> None:
    """k_n,ref of a real material, of a vanishing pressure, or of nanometre grains has lost digits."""
    from granular.contact_law import normal_stiffness

    modulus, pressure, density, length = scale
    spring = normal_stiffness(modulus, 0.21, mean_stress=pressure, contacts_per_volume=density)
    # Three roundings after the one of k_n,ref.
    assert relative_error(spring * length * (density * length), Fraction(known)) < 4e-16, gravity


def test_every_family_is_covered() -> None:
    """A kind of difficulty has certified cases but no place in the corpus."""
    easy = {"isotropic", "interior"}
    assert {case.family for case in kinetic_cases()} - easy <= {case.family for case in CASES}
    assert {"opening", "scale", "shape-near-1", "extreme-shape"} <= {case.family for case in CASES}
    assert set(NAIVE) <= {case.naive for case in CASES}
    assert len(CASES) >= 25


def test_arrays_are_right_on_the_same_cases() -> None:
    """The function for arrays loses digits where the route for one scene does not."""
    for case in CASES:
        if case.scale is not None or case.loading is None or case.loading.sigma11 != 1:
            continue
        row = axial_stiffness(case.fabric.D33, case.fabric.Dr33, float(case.loading.sigma33), case.loading.friction,
                              case.poisson_ratio, hypothesis=case.hypothesis)
        value = float(row[COMPONENTS.index(case.component)])
        assert relative_error(value, case.certified) <= MOST[case.hypothesis], case.name


SPHEROIDS = ("arc tangent and recurrence", "24 Gauss nodes in x")


@pytest.mark.parametrize("label", [label for label in NAIVE if "recurrence" not in label and label not in SPHEROIDS])
def test_naive_ways_are_right_on_an_ordinary_input(label: str) -> None:
    """A naive way is wrong everywhere, so that its failure on a hard input would show nothing."""
    fabric = AxialFabric(D33=0.3, Dr33=-0.3)
    without_slip = "powers" in label
    loading = Loading.of_ratio(1.1, friction=None if without_slip else 0.6)
    known = certified.enclose(fabric, poisson_ratio=0.21, hypothesis=Hypothesis.KINEMATIC, loading=loading)
    allowed = 5e-3 if "midpoint" in label else 1e-13
    for value, enclosure in zip(NAIVE[label](fabric, loading, 0.21, Hypothesis.KINEMATIC), known, strict=True):
        assert relative_error(value, enclosure.midpoint) < allowed, enclosure.name


@pytest.mark.parametrize(("label", "ratio"), [("recurrence upwards", 12.0), ("recurrence downwards", 1.2)])
def test_recurrences_are_right_in_their_own_range(label: str, ratio: float) -> None:
    """A recurrence is wrong in both directions, which no instability explains."""
    fabric, loading = AxialFabric(), Loading.of_ratio(ratio)
    known = certified.enclose(fabric, poisson_ratio=0.21, hypothesis=Hypothesis.KINEMATIC, loading=loading)
    for value, enclosure in zip(NAIVE[label](fabric, loading, 0.21, Hypothesis.KINEMATIC), known, strict=True):
        assert relative_error(value, enclosure.midpoint) < 1e-12, enclosure.name


@pytest.mark.parametrize("label", SPHEROIDS)
def test_naive_spheroids_are_right_on_ordinary_grains(label: str) -> None:
    """A naive way is wrong for all grains, so that its failure on hard ones would show nothing."""
    for spin in (False, True) if "Gauss" in label else (False,):
        fabric = AxialFabric(D33=0.3, aspect_ratio=0.6, free_spin=spin)
        known = certified.enclose(fabric, poisson_ratio=0.21, hypothesis=Hypothesis.KINEMATIC)
        for value, enclosure in zip(NAIVE[label](fabric, None, 0.21, Hypothesis.KINEMATIC), known, strict=True):
            assert relative_error(value, enclosure.midpoint) < 1e-13, enclosure.name


def test_the_elementary_form_loses_all_digits_below_1e_6() -> None:
    """The error no longer grows towards the sphere, so that the corpus would show nothing."""
    errors = []
    for away in (1e-2, 1e-4, 1e-6, 1e-8):
        fabric = AxialFabric(D33=0.3, aspect_ratio=1 - away)
        known = certified.enclose(fabric, poisson_ratio=0.21, hypothesis=Hypothesis.KINEMATIC)
        values = NAIVE["arc tangent and recurrence"](fabric, None, 0.21, Hypothesis.KINEMATIC)
        errors.append(max(relative_error(value, one.midpoint) for value, one in zip(values, known, strict=True)))
    assert errors == sorted(errors) and errors[0] < 1e-7 and errors[2] > 1e-2


def test_the_printed_slip_of_a_negative_stiffness() -> None:
    """C2323/C1212 of Table V at SR = 2 is no longer 1.192, or a negative k_r no longer turns it into 1.768."""
    arguments = (AxialFabric(), Loading.of_ratio(2.0, friction=math.tan(math.radians(12))), 0.21, Hypothesis.KINEMATIC)
    wrong = NAIVE["cube root of a negative number"](*arguments)
    right = NAIVE["64 Gauss nodes, not split"](*arguments)
    assert wrong[4] / wrong[5] == pytest.approx(1.768, abs=5e-4)
    assert right[4] / right[5] == pytest.approx(1.192, abs=3e-3)


def test_relative_errors_of_what_is_no_number() -> None:
    """NaN counts as right, or a number passes for zero."""
    assert math.isnan(relative_error(math.nan, Fraction(1)))
    assert relative_error(math.inf, Fraction(1)) == math.inf
    assert relative_error(1e-300, Fraction(0)) == math.inf
    assert relative_error(0.0, Fraction(0)) == 0.0
