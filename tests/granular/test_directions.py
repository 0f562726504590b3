"""Densities and branch lengths by direction, and the boundary of the admissible region."""

import math

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from granular.directions import admissible_boundary, branch_weight, relative_density
from granular.errors import FabricOutOfRange
from granular.fabric import AxialFabric

patient = settings(deadline=None)  # a time limit would be a verdict on a busy machine
FABRIC = AxialFabric(D33=0.3, D3333=0.1, Dr33=-0.6)


def test_against_legendre_polynomials():
    # a wrong coefficient in the form in sin^2 and cos^2
    x = np.linspace(-1, 1, 41)
    legendre = np.polynomial.legendre.legval
    np.testing.assert_allclose(relative_density(FABRIC, x), legendre(x, [1, 0, 0.3, 0, 0.1]), rtol=1e-14)
    np.testing.assert_allclose(branch_weight(FABRIC, x), legendre(x, [1, 0, -0.6]), rtol=1e-14)


def test_averages_over_the_sphere_are_one():
    # a density that does not count every contact once
    nodes, weights = np.polynomial.legendre.leggauss(8)
    assert weights @ relative_density(FABRIC, nodes) / 2 == pytest.approx(1, rel=1e-14)
    assert weights @ branch_weight(FABRIC, nodes) / 2 == pytest.approx(1, rel=1e-14)


@patient
@given(st.floats(0, 2 * math.pi))
@example(0.0)
@example(math.pi)
@example(math.pi / 2)
@example(math.atan2(-12 / 7, 5 / 7))  # the corner where pole and equator vanish together
def test_the_boundary_is_where_fabrics_stop(angle):
    # a boundary drawn inside or outside the region that the record accepts
    D33, D3333 = (float(value) for value in admissible_boundary(angle))
    AxialFabric(D33=D33 * (1 - 1e-12), D3333=D3333 * (1 - 1e-12))
    with pytest.raises(FabricOutOfRange):
        AxialFabric(D33=D33 * (1 + 1e-9), D3333=D3333 * (1 + 1e-9))
    # on the ray that was asked for, not on the opposite one; 1e-15 times the size of the region
    assert math.cos(angle) * D33 + math.sin(angle) * D3333 == pytest.approx(math.hypot(D33, D3333), rel=1e-14)


def test_known_corners_of_the_region():
    # the interval for D3333 = 0 and the corner where the density vanishes at pole and equator
    D33, D3333 = admissible_boundary([0.0, np.pi, math.atan2(-12 / 7, 5 / 7), math.atan2(0, 1)])
    np.testing.assert_allclose(D33, [2, -1, 5 / 7, 2], rtol=1e-14)
    np.testing.assert_allclose(D3333, [0, 0, -12 / 7, 0], atol=1e-14)
