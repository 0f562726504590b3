"""Hertz contacts: stiffness ratio, reference stiffness, and two published limits."""

from __future__ import annotations

import math

import mpmath
import pytest
from hypothesis import given
from hypothesis import strategies as st

from granular.contact_law import (
    normal_stiffness,
    one_minus_stiffness_ratio,
    reference_stiffness,
    stiffness_ratio,
)
from granular.errors import ResultOutOfRange
from granular.number_of_contacts import contacts_per_volume

POISSON = st.floats(0.0, 0.5)
POSITIVE = st.floats(1e-100, 1e100)
PAPER = {"shear_modulus": 31e9, "poisson_ratio": 0.21, "mean_stress": 28e3, "void_ratio": 0.5744,
         "coordination_number": 8.6848}


def reference(*, shear_modulus, poisson_ratio, **assembly):
    return reference_stiffness(shear_modulus, poisson_ratio, **assembly)


def by_definition(*, shear_modulus, poisson_ratio, mean_stress, void_ratio, coordination_number, length_ratio, radius):
    """(M/V) l_e^2 k_n in 60 digits, step by step as eqs (8), (9), (20), (23) read, with a grain radius."""
    with mpmath.workdps(60):
        G, nu, p, e, N, lr, r = map(mpmath.mpf, (shear_modulus, poisson_ratio, mean_stress, void_ratio,
                                                 coordination_number, length_ratio, radius))
        per_volume = N / 2 / ((1 + e) * 4 * mpmath.pi / 3 * r**3)
        branch = lr * 2 * r
        force = 3 * p / (per_volume * branch)
        stiffness = mpmath.cbrt(3) * (G / (1 - nu)) ** (mpmath.mpf(2) / 3) * mpmath.cbrt(branch / 2 * force)
        return per_volume * branch**2 * stiffness


@given(st.fixed_dictionaries({
    "shear_modulus": POSITIVE, "poisson_ratio": POISSON, "mean_stress": POSITIVE, "void_ratio": st.floats(1e-3, 1e3),
    "coordination_number": st.floats(1e-3, 1e3), "length_ratio": st.floats(1e-3, 1e3)}), st.floats(1e-9, 1e3))
def test_reference_stiffness_by_its_definition(values, radius):
    # Breaks when a factor is lost, the grain size stays in, or the result is rounded more than once: it is the
    # double nearest to the definition, whatever the radius there (60 digits leave no doubt about ties).
    assert reference(**values) == float(by_definition(**values, radius=radius))


@given(st.floats(1e-9, 1e3))
def test_reference_stiffness_is_free_of_the_grain_size(diameter):
    # Breaks when l and R_e no longer cancel in k_n: the product of the three parts, 10 roundings, for any size.
    per_volume = contacts_per_volume(0.5744, 8.6848, grain_diameter=diameter)
    k = normal_stiffness(31e9, 0.21, mean_stress=28e3, contacts_per_volume=per_volume)
    assert per_volume * diameter**2 * k == pytest.approx(reference(**PAPER), rel=10 * 2.0**-53)


def isotropic(unit, nu):
    """C1111, C2323, C1122 of the isotropic kinematic assembly: <x^4> = 1/5 and so on, C = K and G of model limits."""
    lam = stiffness_ratio(nu)
    bulk, shear = unit / 9, unit * (2 + 3 * lam) / 30
    return bulk + 4 * shear / 3, shear, bulk - 2 * shear / 3


def test_the_papers_isotropic_assembly():
    # Breaks when the Hertz law loses a factor. The paper prints 5465, 2665 and 134 MPa, about 9.81 times too large;
    # an independent Hertz-Mindlin formula gives these, to the printed four digits.
    c1111, c2323, c1122 = isotropic(reference(**PAPER), 0.21)
    assert round(c1111 / 1e6, 1) == 556.8
    assert round(c2323 / 1e6, 1) == 271.5
    assert round(c1122 / 1e6, 2) == 13.71


def test_walton_rough_limit():
    # Breaks when the isotropic limit leaves the Hertz-Mindlin medium: K and G of the independent formula to 1e-13
    # (20 roundings), and the ten digits of its published check values.
    bulk_solid, G, porosity, C, P = 36.6e9, 45e9, 0.4, 8.6, 20e6
    nu = (3 * bulk_solid - 2 * G) / (2 * (3 * bulk_solid + G))
    common = C**2 * (1 - porosity) ** 2 * G**2 * P / (math.pi**2 * (1 - nu) ** 2)
    K = math.cbrt(common / 18)
    Gm = (5 - 4 * nu) / (5 * (2 - nu)) * math.cbrt(3 * common / 2)
    unit = reference_stiffness(G, nu, mean_stress=P, void_ratio=porosity / (1 - porosity), coordination_number=C)
    assert unit / 9 == pytest.approx(K, rel=1e-13)
    assert unit * (2 + 3 * stiffness_ratio(nu)) / 30 == pytest.approx(Gm, rel=1e-13)
    assert (f"{K / 1e9:.10f}", f"{Gm / 1e9:.10f}") == ("1.9063198609", "2.8028054171")


@given(POISSON)
def test_the_stiffness_ratio_and_its_complement(nu):
    # Breaks when 1 - lambda_0 is formed by subtraction. 5 roundings of numbers of size 1.
    assert stiffness_ratio(nu) + one_minus_stiffness_ratio(nu) == pytest.approx(1.0, abs=5 * 2.0**-53)
    assert 2 / 3 <= stiffness_ratio(nu) + 2.0**-52
    assert stiffness_ratio(nu) <= 1.0


@pytest.mark.parametrize("nu", [5e-324, 1e-300, 1e-16])
def test_the_complement_keeps_its_digits(nu):
    # Breaks when a tiny Poisson ratio drowns in 1: C1122 and C1133 are proportional to this.
    assert one_minus_stiffness_ratio(nu) == nu / 2


@pytest.mark.parametrize(("change", "size"), [
    ({"shear_modulus": 1e308, "mean_stress": 1e308}, "e+"), ({"length_ratio": 1e200}, "e+"),
    ({"shear_modulus": 1e-310, "mean_stress": 1e-310}, "e-"), ({"length_ratio": 1e-200}, "e-"),
])
def test_a_result_outside_double_precision_is_refused(change, size):
    # Breaks when infinity, zero or a subnormal number passes for a stiffness.
    with pytest.raises(ResultOutOfRange, match=size.replace("+", r"\+")):
        reference(**{**PAPER, **change})


@pytest.mark.parametrize("scale", [1e-200, 1e-100, 1e100, 1e200])
def test_intermediate_values_may_leave_double_precision(scale):
    # Breaks when G^2 or p is multiplied out in floats: ref ~ G^(2/3) p^(1/3) l^2 is an ordinary number here.
    extreme = reference(**{**PAPER, "shear_modulus": 31e9 * scale, "mean_stress": 28e3 * scale,
                           "length_ratio": 1 / math.sqrt(scale)})
    # the three scaled inputs are rounded, which moves the result by some units of the last place
    assert extreme == pytest.approx(reference(**PAPER), rel=1e-15)
