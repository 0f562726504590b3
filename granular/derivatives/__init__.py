"""Exact slopes of the stiffness: by fabric, stress ratio, friction and Poisson's ratio, and of scenes in pascals.

``axial_gradient`` is the twin of ``granular.axial_stiffness`` for arrays, ``sensitivity`` tells for one scene how much
each component changes with each number of the scene. The slopes are derived in ``derivations.gradients``.
"""

from granular.derivatives.axial_gradient import PARAMETERS, AxialGradient, axial_gradient
from granular.derivatives.sensitivity import Sensitivity, sensitivity

__all__ = ["PARAMETERS", "AxialGradient", "Sensitivity", "axial_gradient", "sensitivity"]
