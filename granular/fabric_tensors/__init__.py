"""Fabric tensors from directions: three kinds, their scatter, what is significant, and the density that they imply.

>>> from granular.fabric_tensors import fabric_of, uniformity
>>> tensors = fabric_of([[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]])
>>> (tensors.N2.diagonal() * 3).round(12).tolist(), abs(tensors.D2).max().round(12).item()
([1.0, 1.0, 1.0], 0.0)
"""

from __future__ import annotations

from granular.fabric_tensors.axial_fit import AxialFit, axial_fabric, symmetry_axis
from granular.fabric_tensors.density import LeastDensity, density, least_density
from granular.fabric_tensors.moments import Moments
from granular.fabric_tensors.randomised import randomised_axial_symmetry, randomised_uniformity
from granular.fabric_tensors.reach import least_seen
from granular.fabric_tensors.resampling import Resamples, bootstrap, normal_resamples
from granular.fabric_tensors.sampling import axial_tensors, directions_of, isotropic, tensors_of
from granular.fabric_tensors.significance import (
    Significance,
    axial_symmetry,
    orthotropy,
    rank_four,
    significance,
    uniformity,
)
from granular.fabric_tensors.symmetry_test import SymmetryTest
from granular.fabric_tensors.tensors import FabricTensors, fabric_of
from granular.fabric_tensors.uncertainty import (
    AxisInterval,
    Interval,
    axial_intervals,
    axis_interval,
    component_intervals,
    principal_intervals,
    resampled_components,
)

__all__ = ["AxialFit", "AxisInterval", "FabricTensors", "Interval", "LeastDensity", "Moments", "Resamples",
           "Significance", "SymmetryTest", "axial_fabric", "axial_intervals", "axial_symmetry", "axial_tensors",
           "axis_interval", "bootstrap", "component_intervals", "density", "directions_of", "fabric_of", "isotropic",
           "least_density", "least_seen", "normal_resamples", "orthotropy", "principal_intervals",
           "randomised_axial_symmetry", "randomised_uniformity", "rank_four", "resampled_components", "significance",
           "symmetry_axis", "tensors_of", "uniformity"]
