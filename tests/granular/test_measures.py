"""Measures of anisotropy against the scalar records and against the definitions."""

from __future__ import annotations

import math

import numpy as np
import pytest

import granular
from granular.elasticity import Stiffness
from granular.engineering import engineering_constants
from granular.errors import ArrayNotUsable
from granular.measures import MEASURES, measure
from granular.waves import waves

GRID = granular.axial_stiffness([-0.4, 0.0, 0.3, 0.9], [[-0.4], [0.0], [0.3]], 1.5, 0.2126)
"""Fabrics whose longitudinal waves are the faster ones."""


@pytest.mark.parametrize("place", list(np.ndindex(3, 4)))
def test_measures_of_a_grid_are_those_of_each_assembly(place):
    """Breaks when a component is taken for another, or a measure for its inverse."""
    solid = Stiffness.transversely_isotropic(*GRID[place].tolist())
    constants, thomsen = engineering_constants(solid), waves(solid, density=1.0).thomsen
    speeds = waves(solid, density=1.0)
    expected = {
        "C1111/C3333": (speeds.horizontal.P / speeds.vertical.P) ** 2,
        "C2323/C1212": (speeds.vertical.SH / speeds.horizontal.SH) ** 2,
        "E1/E3": constants.E1 / constants.E3, "nu31": constants.nu31, "nu12": constants.nu12,
        "epsilon": thomsen.epsilon, "gamma": thomsen.gamma, "delta": thomsen.delta,
        "P anisotropy": speeds.horizontal.P / speeds.vertical.P - 1}
    assert set(expected) == set(MEASURES)
    for name, value in expected.items():
        # 1e-12: differences of components and squares of rounded speeds
        assert measure(GRID, name)[place] == pytest.approx(value, rel=1e-12, abs=1e-12), name


def test_an_isotropic_solid_has_the_stated_values():
    """Breaks when a map draws its thick line elsewhere."""
    solid = [3.0, 3.0, 1.0, 1.0, 1.0, 1.0]
    for one in MEASURES.values():
        assert one.isotropic is None or measure(solid, one.name) == one.isotropic


def test_shapes_and_refused_elements_pass_through():
    """Breaks when the components are looked for along another axis, or nan becomes a number."""
    assert measure(GRID, "delta").shape == (3, 4)
    assert math.isnan(measure(granular.axial_stiffness(3.0, 0.0, invalid="nan"), "E1/E3"))
    with pytest.raises(ArrayNotUsable, match="six components"):
        measure(GRID[..., :5], "delta")
