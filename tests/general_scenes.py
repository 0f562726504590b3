"""Scenes given by tensors: with an axis in any frame, and without one."""

from __future__ import annotations

from copy import deepcopy

import numpy as np
from general_fabrics import harmonic

from granular.scene import Scene

SOUND = {
    "grains": {"shear_modulus": "31 GPa", "poisson_ratio": 0.21},
    "packing": {"void_ratio": 0.5744},
    "stress": {"mean": "28 kPa"},
}
AXIS = np.diag([-0.5, -0.5, 1.0])
FABRIC = [[0.2, 0.1, 0.05], [0.1, -0.15, -0.05], [0.05, -0.05, -0.05]]
BRANCHES = [[-0.1, 0.05, 0.0], [0.05, 0.2, 0.1], [0.0, 0.1, -0.1]]
STRESS = [[30e3, 4e3, 1e3], [4e3, 25e3, -2e3], [1e3, -2e3, 20e3]]


def scene(**tables) -> Scene:
    content = deepcopy(SOUND)
    for name, table in tables.items():
        content[name] = table if name == "stress" else {**content.get(name, {}), **table}
    return Scene.model_validate(content)


def general(friction=None, **tables) -> Scene:
    """A scene whose three tensors share nothing."""
    grains = {} if friction is None else {"friction_coefficient": friction}
    return scene(**{"packing": {"contact_normals": {"tensor": FABRIC}},
                    "branches": {"anisotropy": {"tensor": BRANCHES}}, "stress": {"tensor": STRESS},
                    "grains": grains, **tables})


def axial(turn, D33, Dr33, ratio, friction, D3333=0.0, hypothesis="kinematic") -> Scene:
    """An axial scene by tensors in a turned frame; about axis 3, in the usual way, without a turn."""
    grains = {} if friction is None else {"friction_coefficient": friction}
    if turn is None:
        return scene(packing={"contact_normals": {"D33": D33, "D3333": D3333}}, branches={"anisotropy": {"D33": Dr33}},
                     stress={"tensor": np.diag([1e4, 1e4, ratio * 1e4])}, grains=grains,
                     model={"hypothesis": hypothesis})
    normals = {"tensor": turn @ (D33 * AXIS) @ turn.T}
    if D3333:
        normals["tensor4"] = harmonic(turn[:, 2], D3333)
    return scene(packing={"contact_normals": normals},
                 branches={"anisotropy": {"tensor": turn @ (Dr33 * AXIS) @ turn.T}},
                 stress={"tensor": turn @ np.diag([1e4, 1e4, ratio * 1e4]) @ turn.T}, grains=grains,
                 model={"hypothesis": hypothesis})


def apart(one, other):
    """Difference of the worst entry over the largest."""
    return np.abs(one.mandel() - other.mandel()).max() / np.abs(other.mandel()).max()
