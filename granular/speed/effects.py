"""What each effect costs: very many assemblies at once, and one scene after the other."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from granular.speed import questions
from granular.speed.interleaved import Way
from granular.speed.sample import sample
from granular.speed.ways import results, values

FULL_PRECISION, STATIC_FORCES = 4_000, 20_000
"""Elements of ways that sum over directions for each of them [-]."""


def arrays(size: int) -> list[Way]:
    """Effect after effect, of assemblies that are computed at once by the fastest way there is.

    Parameters
    ----------
    size : int
        Assemblies of one call [-]; ways that take long for each do fewer.

    Returns
    -------
    list of Way
        Packing alone, then more.
    """
    out = results(size)
    asked = (("packing", questions.PACKING, size), ("+ branches", questions.CONSTANT, size),
             ("+ kinetic", questions.KINETIC, size),
             ("+ slip, one friction", questions.SLIP, size),
             ("+ slip, a friction each", questions.SLIP_EACH, size),
             ("+ slip, full precision", questions.SLIP_FULL, min(size, FULL_PRECISION)),
             ("static: packing, branches", questions.STATIC, size),
             ("static: + kinetic", questions.STATIC_KINETIC, min(size, STATIC_FORCES)),
             ("static: + slip, full precision", questions.STATIC_SLIP, min(size, FULL_PRECISION)))
    return [values(name, question, sample(count), out=out[:count], threads=1) for name, question, count in asked]


GRAINS = {"shear_modulus": "31 GPa", "poisson_ratio": 0.21}
FRICTIONAL = GRAINS | {"friction_angle": "12 deg"}
NORMALS = {"void_ratio": 0.5744, "contact_normals": {"D33": 0.3}}
BRANCHES = {"anisotropy": {"D33": -0.3}}
TILTED = [[0.125, 0, 0.375], [0, -0.25, 0], [0.375, 0, 0.125]]
TENSION = [["35 kPa", 0, 0], [0, "35 kPa", 0], [0, 0, "-7 kPa"]]
LOGNORMAL = {"distribution": "lognormal", "median": "10 mm", "spread": 1.5}
CONSTANT = {"effects": ["packing", "branches"]}

SCENES: dict[str, dict[str, Any]] = {
    "packing": {"packing": NORMALS, "model": {"effects": ["packing"]}},
    "+ branches": {"packing": NORMALS, "branches": BRANCHES, "model": CONSTANT},
    "+ branches, kinetic": {"packing": NORMALS, "branches": BRANCHES},
    "+ branches, kinetic, slip": {"grains": FRICTIONAL, "packing": NORMALS, "branches": BRANCHES},
    "kinetic, some contacts slide": {"grains": FRICTIONAL, "stress": {"mean": "28 kPa", "ratio": 2.0}},
    "kinetic, some slide, some opened": {"grains": FRICTIONAL, "stress": {"tensor": TENSION}},
    "+ branches, gradation": {"packing": NORMALS, "branches": BRANCHES, "gradation": LOGNORMAL,
                              "model": {"effects": ["packing", "branches", "gradation"]}},
    "+ kinetic, flat spheroids": {"packing": NORMALS, "shape": {"aspect_ratio": 0.8}},
    "+ kinetic, no common axis": {
        "packing": {"void_ratio": 0.5744, "contact_normals": {"tensor": TILTED}},
        "stress": {"tensor": [["21 kPa", 0, 0], [0, "21 kPa", 0], [0, 0, "42 kPa"]]}, "model": {"rtol": 1e-8}},
    "static: + branches": {"packing": NORMALS, "branches": BRANCHES,
                           "model": CONSTANT | {"hypothesis": "static"}},
    "static: + branches, kinetic": {"packing": NORMALS, "branches": BRANCHES,
                                    "model": {"hypothesis": "static"}},
    "static: + branches, kinetic, slip": {"grains": FRICTIONAL, "packing": NORMALS, "branches": BRANCHES,
                                          "model": {"hypothesis": "static"}},
}
"""Tables of scene files; what is left out is that of the printed tables."""


def scene_of(tables: dict[str, Any]) -> Any:
    """A scene of some tables, completed by those of the printed ones.

    Parameters
    ----------
    tables : dict
        As in a scene file.

    Returns
    -------
    Scene
        Checked.
    """
    from granular.scene import Scene

    return Scene.model_validate({"grains": GRAINS, "packing": {"void_ratio": 0.5744},
                                 "stress": {"mean": "28 kPa"}} | tables)


def scenes(_size: int) -> list[Way]:
    """Effect after effect, of one scene at a time, with its plan; the error is the bound that the result states.

    Parameters
    ----------
    _size : int
        Not used: each is one scene [-].

    Returns
    -------
    list of Way
        Packing alone, then more.
    """
    return [_one(name, scene_of(tables)) for name, tables in SCENES.items()]


def _one(name: str, scene: Any) -> Way:
    from granular.evaluation import evaluate

    call: Callable[[], Any] = partial(evaluate, scene)
    return Way(name=name, elements=1, call=call, error=lambda: float(call().relative_error))
