"""Assemblies without an axis of symmetry: any traceless fabric tensors, any stress, all 21 constants.

Nothing heavy is loaded before something is computed.
"""

from __future__ import annotations

from granular.general.fabric import GeneralFabric
from granular.general.loading import GeneralLoading
from granular.general.stiffness import GeneralStiffness, general_stiffness
from granular.general.symmetry import Symmetry, classify

__all__ = ["GeneralFabric", "GeneralLoading", "GeneralStiffness", "Symmetry", "classify", "general_stiffness"]
