"""The elementary form of spheroids: right where nothing cancels, without a digit next to the sphere."""

import pytest

from granular.checks.spheroid_digits import by_arc_tangent, worst_error
from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.routes import closed_form


@pytest.mark.parametrize("shape", [0.3, 0.5, 1.5, 2.0])
@pytest.mark.parametrize("D33", [0.0, 0.3, -0.5])
def test_the_elementary_form_is_right_far_from_the_sphere(shape, D33):
    # a coefficient of L_k, a sign in the recurrence or the wrong branch of the arc tangent
    fabric = AxialFabric(D33=D33, aspect_ratio=shape)
    assert worst_error(by_arc_tangent(shape, D33=D33), fabric) < 1e-13  # three divisions by 0.75 or less


@pytest.mark.parametrize(("D33", "power"), [(0.0, 2), (0.3, 3)])
@pytest.mark.parametrize("distance", [1e-2, 1e-3, 1e-4, 1e-5])
def test_digits_are_lost_as_the_docstring_says(D33, power, distance):
    # the flaw removed, or one power of the distance more or less
    found = worst_error(by_arc_tangent(1 - distance, D33=D33), AxialFabric(D33=D33, aspect_ratio=1 - distance))
    assert 1e-18 < found * distance**power < 2e-15  # rounding of the first integral decides within this


@pytest.mark.parametrize("distance", [0.0, 1e-15, 1e-8, 1e-6, 1e-3])
def test_the_series_keeps_every_digit_there(distance):
    # the series exchanged for the elementary form
    fabric = AxialFabric(D33=0.3, aspect_ratio=1 + distance, free_spin=False)
    found = closed_form.evaluate(fabric, poisson_ratio=0.21, hypothesis=Hypothesis.KINEMATIC)
    assert worst_error(found.components, fabric) <= found.relative_error


def test_at_the_sphere_there_is_no_number():
    # a guard added: the point of the function is that it has none
    with pytest.raises(ZeroDivisionError):
        by_arc_tangent(1.0)
