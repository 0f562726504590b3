"""granular: the elastic stiffness of granular assemblies from the statistics of their contacts.

Names are loaded when first used, so that ``import granular`` costs next to nothing.

>>> import granular
>>> scene = granular.Scene.model_validate({
...     "grains": {"shear_modulus": "31 GPa", "poisson_ratio": 0.21},
...     "packing": {"void_ratio": 0.5744, "coordination_number": 8.6848},
...     "stress": {"mean": "28 kPa"}})
>>> round(granular.evaluate(scene).stiffness.C3333 / 1e6, 1)
556.8
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from granular.array_stiffness import axial_stiffness
    from granular.branch_stiffness import stiffness_by_direction
    from granular.contacts import summarise
    from granular.derivatives import axial_gradient, sensitivity
    from granular.elasticity import Compliance, Stiffness
    from granular.errors import GranularError
    from granular.evaluation import Evaluation, evaluate
    from granular.fabric import AxialFabric
    from granular.fabric_tensors import fabric_of
    from granular.fitting import fit
    from granular.general import GeneralFabric, GeneralLoading, classify, general_stiffness
    from granular.gradation import Lognormal, MeasuredCurve, length_moments, read_curve
    from granular.hypothesis import Hypothesis
    from granular.planning import Plan, plan
    from granular.scene import Scene
    from granular.sweeps import open_sweep, sweep

__version__ = "0.1.0"

_HOME = {
    "AxialFabric": "granular.fabric",
    "Compliance": "granular.elasticity",
    "Evaluation": "granular.evaluation",
    "GeneralFabric": "granular.general",
    "GeneralLoading": "granular.general",
    "GranularError": "granular.errors",
    "Hypothesis": "granular.hypothesis",
    "Lognormal": "granular.gradation",
    "MeasuredCurve": "granular.gradation",
    "Plan": "granular.planning",
    "Scene": "granular.scene",
    "Stiffness": "granular.elasticity",
    "axial_gradient": "granular.derivatives",
    "axial_stiffness": "granular.array_stiffness",
    "classify": "granular.general",
    "evaluate": "granular.evaluation",
    "fabric_of": "granular.fabric_tensors",
    "fit": "granular.fitting",
    "general_stiffness": "granular.general",
    "length_moments": "granular.gradation",
    "open_sweep": "granular.sweeps",
    "plan": "granular.planning",
    "read_curve": "granular.gradation",
    "sensitivity": "granular.derivatives",
    "stiffness_by_direction": "granular.branch_stiffness",
    "summarise": "granular.contacts",
    "sweep": "granular.sweeps",
}

__all__ = [
    "AxialFabric", "Compliance", "Evaluation", "GeneralFabric", "GeneralLoading", "GranularError", "Hypothesis",
    "Lognormal", "MeasuredCurve", "Plan", "Scene", "Stiffness", "axial_gradient", "axial_stiffness", "classify",
    "evaluate", "fabric_of", "fit", "general_stiffness", "length_moments", "open_sweep", "plan", "read_curve",
    "sensitivity", "stiffness_by_direction", "summarise", "sweep",
]


def __getattr__(name: str) -> Any:
    """Load a public name from the module that defines it."""
    try:
        home = _HOME[name]
    except KeyError:
        raise AttributeError(f"module 'granular' has no attribute {name!r}") from None
    value = getattr(importlib.import_module(home), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    """List the public names."""
    return sorted([*globals(), *_HOME])
