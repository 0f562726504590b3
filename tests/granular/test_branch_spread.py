"""A spread of lengths that changes with direction: Kummer functions against rules over the sphere, and its limits."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.special import hyp1f1

from granular import AxialFabric
from granular.branch_products import along_normals, lognormal_lengths
from granular.branch_spread import exponential_moments, stiffness_with_spread
from granular.branch_stiffness import stiffness_by_direction
from granular.errors import BranchesUnusable, ValueOutOfRange

NU = 0.21


@pytest.mark.parametrize("zeta", [-60.0, -3.0, -1e-9, 0.0, 1e-9, 3.0, 60.0])
def test_moments_are_kummer_functions(zeta: float) -> None:
    """Breaks when a series ends early for either sign."""
    for k, moment in enumerate(exponential_moments(zeta, 5)):
        # SciPy's own function is good to about 1e-12 here
        assert moment == pytest.approx(hyp1f1(k + 0.5, k + 1.5, zeta) / (2 * k + 1), rel=1e-12)


@given(st.floats(-60, 60))
def test_moments_follow_from_one_another(zeta: float) -> None:
    """Breaks when two moments of one exponent do not belong together."""
    moments = exponential_moments(zeta, 6)
    for k in range(5):
        left, right = 2 * zeta * moments[k + 1], math.exp(zeta) - (2 * k + 1) * moments[k]
        assert left == pytest.approx(right, abs=1e-14 * max(math.exp(zeta), 1))  # the recurrence subtracts


@pytest.mark.parametrize(("spread", "anisotropy", "fabric", "form"), [
    (1.5, 0.5, AxialFabric(), "paper"), (1.5, -1.0, AxialFabric(D33=0.3, Dr33=-0.3), "paper"),
    (3.0, 2.0, AxialFabric(D33=0.3, D3333=0.1, Dr33=-0.3), "classical"), (2.0, -0.7, AxialFabric(Dr33=0.8), "paper")])
def test_agrees_with_rules_over_the_sphere(spread: float, anisotropy: float, fabric: AxialFabric, form: str) -> None:
    """Breaks when the closed form is not the average of eq. (7) over the directions."""
    log_variance = math.log(spread) ** 2

    def even(n: np.ndarray) -> np.ndarray:
        found: np.ndarray = (3 * n[2] ** 2 - 1) / 2
        return found

    lengths = lognormal_lengths(lambda n: 1 + fabric.Dr33 * even(n),
                                lambda n: np.exp(np.sqrt(log_variance * (1 + anisotropy * even(n)))), form=form)
    normals = AxialFabric(D33=fabric.D33, D3333=fabric.D3333)
    found = stiffness_by_direction(along_normals(lengths), fabric=normals, poisson_ratio=NU, rtol=1e-12).mandel
    c1111, c3333, c1122, c1133, c2323, c1212 = stiffness_with_spread(spread, anisotropy, poisson_ratio=NU,
                                                                     fabric=fabric, form=form)
    # the rule states ten times its last change; both err by a few roundings
    assert [c1111, c3333, c1122, c1133, 2 * c2323, 2 * c1212] == pytest.approx(
        [found[0, 0], found[2, 2], found[0, 1], found[0, 2], found[3, 3], found[5, 5]], rel=1e-13)


def test_equal_spread_multiplies() -> None:
    """Breaks when a spread that is the same everywhere does more than multiply the stiffness of one length."""
    from granular import axial_stiffness

    fabric = AxialFabric(D33=0.3, Dr33=-0.3)
    one_length = axial_stiffness(0.3, -0.3, poisson_ratio=NU, kinetic=False)
    found = np.array(stiffness_with_spread(1.5, 0.0, poisson_ratio=NU, fabric=fabric))
    np.testing.assert_allclose(found, one_length * math.exp(4 * math.log(1.5) ** 2), rtol=1e-14)


def test_refusals() -> None:
    """Breaks when a log variance below zero in some direction, or a spheroid, is computed with."""
    with pytest.raises(ValueOutOfRange):
        stiffness_with_spread(1.5, 2.1, poisson_ratio=NU)
    with pytest.raises(BranchesUnusable):
        stiffness_with_spread(1.5, 0.1, poisson_ratio=NU, fabric=AxialFabric(aspect_ratio=0.8))
