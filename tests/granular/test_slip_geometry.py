"""Where contacts stick and slide: decided exactly for a scene, and in exact sums of doubles for arrays."""

import math
import random
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from granular.loading import Loading
from granular.routes import slip_geometry as scalar
from granular.routes import slip_geometry_array as arrays
from granular.routes.expansions import accurate_sum, folded_sum, products, two_product, two_sum


def near_the_onset(count, seed):
    """Fabrics, stress ratios and frictions, half of them within any distance of the onset of sliding."""
    rng = random.Random(seed)
    for _ in range(count):
        d = rng.choice([rng.uniform(-1, 2), -1.0, 2.0, 0.0, rng.choice([-1, 1]) * 10 ** rng.uniform(-17, -3)])
        close = 1 + rng.uniform(-0.9, 0.9) * 10 ** rng.uniform(-16, 0)
        ratio = 10 ** rng.uniform(-10, 10) if rng.random() < 0.6 else close
        a, c = Loading.of_ratio(ratio).coefficients(d)
        onset = float(abs(c - a)) / (2 * math.sqrt(float(a) * float(c)))
        near = onset * (1 + rng.choice([-1, 1]) * 0.9 * 10 ** rng.uniform(-16, 0))
        friction = 10 ** rng.uniform(-10, 6) if rng.random() < 0.5 else near
        if a != c and friction > 0:
            yield d, ratio, friction


def test_arrays_against_exact_decisions():
    # sticking and sliding confused next to the onset, or 1 - kappa formed by subtraction: it then has no digits left
    sample = [*near_the_onset(1500, seed=3), (0.0, 4.0, 0.75), (0.0, 0.25, 0.75), (0.0, 4.0, math.nextafter(0.75, 0))]
    d, ratio, friction = (np.array(column) for column in zip(*sample, strict=True))
    with np.errstate(all="raise"):
        found = arrays.slip_geometry(d, ratio, friction)
    for k in range(d.size):
        exact = scalar.slip_geometry(*Loading.of_ratio(ratio[k]).coefficients(d[k]), friction[k])
        if isinstance(exact, scalar.Sticking):
            assert found.left[k] == pytest.approx(exact.delta, rel=1e-14, abs=0)
            assert found.center[k] == pytest.approx(exact.center, rel=1e-15)
            assert found.kappa[k] == pytest.approx(exact.kappa, rel=1e-15)
        else:
            assert found.left[k] < 0
            assert math.sqrt(-found.left[k] / 2) == pytest.approx(exact.rho, rel=2e-15)
            for edge, known in ((found.pole[k], exact.pole), (found.equator[k], exact.equator)):
                assert known is None or edge == pytest.approx(known, rel=2e-15)


def test_exact_tangency_is_recognised():
    # an onset that a rounding turns into sliding, which the static hypothesis could then not bear
    one = arrays.slip_geometry(np.array([0.0, 0.0]), np.array([4.0, 0.25]), np.array([0.75, 0.75]))
    assert one.left.tolist() == [0.0, 0.0]
    assert scalar.slip_geometry(Fraction(4), Fraction(1), 0.75).delta == 0.0


@pytest.mark.parametrize(("a", "c", "expected"), [(0, 1, (True, False)), (1, 0, (False, True))])
def test_a_force_that_vanishes_has_one_edge(a, c, expected):
    # a division by the force that vanishes
    found = scalar.slip_geometry(Fraction(a), Fraction(c), 0.5)
    assert (found.pole is not None, found.equator is not None) == expected
    edge = found.pole if c else found.equator
    assert edge == pytest.approx(0.5 if c else 2.0)


def test_extreme_friction_and_stress():
    # an overflow on the way to an edge that is itself an ordinary number
    found = scalar.slip_geometry(*Loading.of_ratio(1e-100).coefficients(0.0), 0.5)
    assert found.equator == pytest.approx(2.0)
    assert arrays.slip_geometry(np.zeros(1), np.array([1e-100]), np.array([0.5])).equator[0] == pytest.approx(2.0)
    with np.errstate(all="raise", under="ignore"):
        arrays.slip_geometry(np.zeros(3), np.array([1e300, 1e-300, 2.0]), np.array([1e-300, 1e300, 5e-324]))


doubles = st.floats(-1e100, 1e100).filter(lambda value: value == 0 or abs(value) > 1e-100)


@given(doubles, doubles)
def test_sums_and_products_lose_nothing(a, b):
    # an error term that is rounded itself
    total, rest = two_sum(np.array(a), np.array(b))
    assert Fraction(total.item()) + Fraction(rest.item()) == Fraction(a) + Fraction(b)
    product, rest = two_product(np.array(a), np.array(b))
    assert Fraction(product.item()) + Fraction(rest.item()) == Fraction(a) * Fraction(b)


@given(st.lists(doubles, min_size=1, max_size=8), st.lists(doubles, min_size=1, max_size=3))
def test_folded_sums(left, right):
    # cancellation that eats the result, beyond what the number of folds promises
    terms = products([np.array(value) for value in left], [np.array(value) for value in right])
    one, other = (sum((Fraction(value) for value in side), Fraction(0)) for side in (left, right))
    exact = one * other
    size = sum(abs(Fraction(term.item())) for term in terms)
    for folds in (2, 3, 8):
        found = Fraction(folded_sum(terms, folds).item())
        assert abs(found - exact) <= abs(exact) * Fraction(1, 2**52) + size * Fraction(100, 2 ** (53 * folds))
    assert abs(folded_sum([*terms, *(-term for term in terms)], 8).item()) <= float(size) * 2.0**-400
    assert accurate_sum(*terms).item() == pytest.approx(float(exact), rel=1e-15, abs=float(size) * 1e-28)
