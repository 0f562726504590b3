"""The stress that contacts carry once those that slide are cut down to their friction."""

from __future__ import annotations

import pytest

from granular.carried import carried_stress
from granular.fabric import AxialFabric
from granular.loading import Loading

FABRICS = (AxialFabric(), AxialFabric(D33=0.3, Dr33=-0.3), AxialFabric(D33=1.0, D3333=0.2, Dr33=0.5))


@pytest.mark.parametrize("fabric", FABRICS)
@pytest.mark.parametrize("ratio", [0.4, 1.0, 2.5])
def test_forces_that_stick_balance_the_stress(fabric: AxialFabric, ratio: float) -> None:
    """Breaks when a component, a sign of the shear force or the unit of the forces is wrong, whatever the fabric."""
    mean = (2 + ratio) / 3
    found = carried_stress(fabric, Loading.of_ratio(ratio))
    assert found == pytest.approx((1 / mean, ratio / mean), rel=1e-12)  # some thousands of terms are summed


def test_without_friction_the_stress_is_that_of_normal_forces() -> None:
    """Breaks when a cut shear force keeps a part: 3 <x^2 (a s + c x^2)> = (2 a + 3 c)/5, and (4 a + c)/5 across."""
    loading = Loading.of_ratio(2.0, friction=0.0)
    a, c = (float(value) for value in loading.coefficients(0.0))
    assert carried_stress(AxialFabric(), loading) == pytest.approx(((4 * a + c) / 5, (2 * a + 3 * c) / 5), rel=1e-12)


def test_sliding_keeps_the_mean_and_lowers_the_ratio() -> None:
    """Breaks when cutting shear forces changes the trace, to which they do not contribute."""
    sigma11, sigma33 = carried_stress(AxialFabric(), Loading.of_ratio(2.0, friction=0.2126))
    assert 2 * sigma11 + sigma33 == pytest.approx(3.0, rel=1e-12)
    assert 1.0 < sigma33 / sigma11 < 2.0
