"""Assemblies without an axis of symmetry: any traceless fabric tensors, any stress, all 21 constants.

Nothing heavy is loaded before something is computed.
"""

from __future__ import annotations

from granular.general.engineering import GeneralEngineering, general_engineering
from granular.general.extremes import Extreme
from granular.general.fabric import GeneralFabric
from granular.general.loading import GeneralLoading
from granular.general.result import GeneralStiffness
from granular.general.stiffness import general_stiffness
from granular.general.symmetry import Symmetry, classify
from granular.general.waves import GeneralWaves, PlaneWaves, ThreeWaves, axis_speeds, general_waves, plane_waves

__all__ = [
    "Extreme", "GeneralEngineering", "GeneralFabric", "GeneralLoading", "GeneralStiffness", "GeneralWaves",
    "PlaneWaves", "Symmetry", "ThreeWaves", "axis_speeds", "classify", "general_engineering", "general_stiffness",
    "general_waves", "plane_waves",
]
