"""What the stress does to the contacts: forces, onset of sliding, opening, decided exactly."""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from granular.contact_distribution import normal_force, normal_stiffness, shear_force, shear_stiffness
from granular.contact_law import stiffness_ratio
from granular.errors import ComplianceInfinite, StressNotCompressive, ValueOutOfRange
from granular.fabric import AxialFabric
from granular.loading import Loading

NODES, WEIGHTS = (np.array(part) for part in np.polynomial.legendre.leggauss(24))


@given(st.floats(-1, 2), st.floats(0, 1e6))
def test_forces_balance_the_stress(D33, ratio):
    # a fabric tensor with the printed coefficients, or forces that do not add up to the stress
    loading = Loading.of_ratio(ratio)
    a, c = loading.coefficients(D33)
    exact = Fraction(D33)
    n11, n33 = Fraction(1, 3) - exact / 15, Fraction(1, 3) + 2 * exact / 15
    assert a * n11 / loading.sigma11 == c * n33 / loading.sigma33 if ratio else c == 0
    assert (2 * a * n11 + c * n33) == 1  # the mean stress, on the scale of a = c = 1 for an isotropic assembly


@pytest.mark.parametrize(("D33", "ratio"), [(0.3, 1.0), (-0.7, 2.5), (1.9, 0.2)])
def test_forces_integrate_to_the_stress(D33, ratio):
    # the same by quadrature over the directions: <l_i f_j> is the stress
    fabric, loading = AxialFabric(D33=D33, Dr33=0.4), Loading.of_ratio(ratio)
    density = 1 + D33 * (3 * NODES**2 - 1) / 2
    branch = 1 + 0.4 * (3 * NODES**2 - 1) / 2
    force, shear = (pull(fabric, loading, NODES) for pull in (normal_force, shear_force))
    s = np.sqrt(1 - NODES**2)
    a, c = (float(value) for value in loading.coefficients(D33))
    along = force * NODES + np.sign(c - a) * shear * s * np.sign(NODES)  # f_3, with f_r towards the pole where c > a
    mean = WEIGHTS @ (density * branch * NODES * along) / 2
    assert mean * 3 / float(loading.sigma33 / loading.mean) == pytest.approx(1, rel=1e-12)


@given(st.floats(-1, 2), st.floats(1e-3, 1e3), st.floats(1e-3, 1e2))
def test_sliding_is_where_the_force_reaches_the_cone(D33, ratio, friction):
    # an onset that does not agree with the contacts themselves
    fabric, loading = AxialFabric(D33=D33), Loading.of_ratio(ratio, friction=friction)
    x = np.cos(np.linspace(0, math.pi / 2, 4001))
    used = (shear_force(fabric, loading, x) / (friction * normal_force(fabric, loading, x))).max()
    tilt = math.sqrt(float(loading.tilt(D33)))
    assert used <= tilt * (1 + 1e-12)
    assert used >= tilt * (1 - 1e-3) or tilt < 1e-6 or not 1e-2 < ratio < 1e2
    assert loading.slides(D33) == (loading.tilt(D33) > 1)


def test_onset_on_the_rankine_planes():
    # an onset that is not at c/a = (1 + sin phi)/(1 - sin phi): exactly 4 for tan(phi) = 3/4
    assert Loading.of_ratio(4.0, friction=0.75).tilt(0.0) == 1
    assert not Loading.of_ratio(4.0, friction=0.75).slides(0.0)
    assert Loading.of_ratio(4.0, friction=math.nextafter(0.75, 0)).slides(0.0)
    assert Loading.of_ratio(0.25, friction=0.75).tilt(0.0) == 1


def test_ends():
    # limits without a value taken for zero or infinity
    assert Loading.of_ratio(0.0, friction=0.5).tilt(0.0) is None
    assert Loading.of_ratio(0.0, friction=0.5).slides(0.0)
    assert Loading.of_ratio(1.0, friction=0.0).slides(0.0)
    assert Loading.of_ratio(1.0, friction=0.0).slips(0.0)
    assert not Loading.of_ratio(1.0, friction=0.5).slips(0.0)
    assert not Loading.of_ratio(3.0).slides(0.0)
    assert Loading(sigma11=Fraction(1), sigma33=Fraction(-1)).opens()


@pytest.mark.parametrize(("arguments", "kind"), [
    ({"sigma11": Fraction(1), "sigma33": Fraction(-2)}, StressNotCompressive),
    ({"sigma11": Fraction(0), "sigma33": Fraction(0)}, StressNotCompressive),
    ({"sigma11": Fraction(1), "sigma33": Fraction(1), "friction": -0.1}, ValueOutOfRange),
    ({"sigma11": Fraction(1), "sigma33": Fraction(1), "friction": math.inf}, ValueOutOfRange),
    ({"sigma11": Fraction(1), "sigma33": Fraction(1), "friction": math.nan}, ValueOutOfRange),
])
def test_impossible_loadings_are_refused(arguments, kind):
    # a loading that no formula can take
    with pytest.raises(kind):
        Loading(**arguments)


def test_an_infinite_compliance_is_refused_in_words():
    # a division by zero, or an error without value and remedy
    with pytest.raises(ComplianceInfinite, match=r"friction_coefficient = 0\.2.*stress ratio 4.*effect slip"):
        Loading.of_ratio(4.0, friction=0.2).require_finite_compliance(0.0)
    with pytest.raises(ComplianceInfinite, match=r"have opened.*effect kinetic"):
        Loading(sigma11=Fraction(1), sigma33=Fraction(-1)).require_finite_compliance(0.0)
    Loading.of_ratio(1.2, friction=0.2).require_finite_compliance(0.0)


def test_stiffness_by_direction():
    # the printed exponent 1/2, or stiffness that depends on the branch length
    fabric, loading = AxialFabric(D33=0.3, Dr33=-0.6), Loading.of_ratio(2.0, friction=math.tan(math.radians(12)))
    x = np.linspace(0, 1, 101)
    normal, shear = normal_force(fabric, loading, x), shear_force(fabric, loading, x)
    kn = normal_stiffness(fabric, loading, x)
    np.testing.assert_allclose(kn, normal_stiffness(AxialFabric(D33=0.3), loading, x), rtol=1e-14)
    expected = stiffness_ratio(0.21) * np.cbrt(np.maximum(1 - shear / (normal * loading.friction), 0)) * kn
    np.testing.assert_allclose(shear_stiffness(fabric, loading, x, poisson_ratio=0.21), expected, rtol=1e-9, atol=1e-12)
    assert (expected == 0).any()


def test_opened_contacts_carry_nothing():
    # the cube root of a negative force
    fabric, loading = AxialFabric(), Loading(sigma11=Fraction(1), sigma33=Fraction(-1, 2), friction=0.3)
    x = np.linspace(0.9, 1, 11)
    assert (normal_force(fabric, loading, x) < 0).all()
    assert (normal_stiffness(fabric, loading, x) == 0).all()
    assert (shear_stiffness(fabric, loading, x, poisson_ratio=0.2) == 0).all()
