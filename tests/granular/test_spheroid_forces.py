"""Forces between spheroids that balance the stress: the sum over the contacts, spheres, and stresses exchanged."""

import numpy as np
import pytest

from granular.fabric import AxialFabric
from granular.loading import Loading
from granular.spheroid import branch_vectors
from granular.spheroid_forces import balancing

X, WEIGHT = np.polynomial.legendre.leggauss(60)  # cosines from -1 to 1; smooth integrands, so that 60 nodes do


@pytest.mark.parametrize("shape", [0.5, 0.8, 1.25, 2.0])
@pytest.mark.parametrize(("D33", "ratio"), [(0.0, 1.0), (0.3, 1.5), (-0.5, 0.4)])
def test_the_sum_over_the_contacts_is_the_given_stress(shape, D33, ratio):
    # a share on the wrong principal stress or multiplied instead of divided, or the density left out of the shares
    found = balancing(Loading.of_ratio(ratio), AxialFabric(D33=D33, aspect_ratio=shape))
    n = np.array([np.sqrt(1 - X**2), 0 * X, X])
    branch = branch_vectors(shape, n)
    unit = branch / np.linalg.norm(branch, axis=0)
    density = WEIGHT / 2 * (1 + D33 * (3 * X**2 - 1) / 2)
    sigma11 = float(found.sigma11) / (1 / 3 - D33 / 15)
    sigma33 = float(found.sigma33) / (1 / 3 + 2 * D33 / 15)
    # |l| cancels between force and branch; half of the horizontal sum belongs to each horizontal axis
    assert np.sum(density * unit[0] * sigma11 * n[0]) / 2 == pytest.approx(1.0, rel=1e-12)
    assert np.sum(density * unit[2] * sigma33 * n[2]) == pytest.approx(ratio, rel=1e-12)


def test_spheres_need_no_other_stress():
    # shares that are not 1 to rounding where nothing deviates
    given = Loading.of_ratio(1.5, friction=0.2)
    found = balancing(given, AxialFabric(D33=0.3))
    assert float(found.sigma33 / found.sigma11) == pytest.approx(1.5, rel=1e-15)
    assert found.friction == given.friction
