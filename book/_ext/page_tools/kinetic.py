"""Which route serves an assembly with contact forces, and how far its result is from the certified one."""

from __future__ import annotations

import tomllib
from typing import Any

from granular import Evaluation, Scene, evaluate
from page_tools.markup import Markup, table
from page_tools.paper import SCENE

ASSEMBLIES: tuple[tuple[str, float, float, float, str | None], ...] = (
    ("Table III, case 2", 0.3, -0.3, 1.0, None), ("Table III, case 3", 0.3, -0.3, 1.0, "12 deg"),
    ("stress ratio 10, no slip", 0.3, -0.3, 10.0, None), ("Table V, stress ratio 1.5", 0.0, 0.0, 1.5, "12 deg"),
    ("Table V, stress ratio 2", 0.0, 0.0, 2.0, "12 deg"), ("stress ratio 1000, slip", 0.3, -0.3, 1000.0, "12 deg"))
"""Name, D33, Dr33, stress ratio and friction angle."""


def routes_table() -> Markup:
    """List the route that a plan chooses, what it costs, what it promises and what it does."""
    rows = []
    for name, fabric, branches, ratio, friction in ASSEMBLIES:
        chosen, known = (_evaluate(fabric, branches, ratio, friction, route) for route in ("auto", "certified"))
        error = max(abs(value / true - 1) for value, true in zip(chosen.normalised, known.normalised, strict=True))
        rows.append([name, f"`{chosen.plan.route}`", str(chosen.evaluations or "–"),
                     _power(chosen.relative_error), _power(error)])
    return table(["assembly", "route", "directions", "promised error", "error"], rows, label="tab-kinetic-routes",
                 align="llrrr", take_away="kinetic_routes.csv",
                 caption="Route, number of directions in which contacts are evaluated, promised relative error and the "
                         "error of the worst component against ball arithmetic.")


def _evaluate(fabric: float, branches: float, ratio: float, friction: str | None, route: str) -> Evaluation:
    content: dict[str, Any] = tomllib.loads(SCENE.read_text(encoding="utf-8"))
    content["packing"]["contact_normals"] = {"D33": fabric}
    content["branches"]["anisotropy"] = {"D33": branches}
    content["stress"]["ratio"] = ratio
    content["model"]["effects"] = "auto"
    if friction is not None:
        content["grains"]["friction_angle"] = friction
    return evaluate(Scene.model_validate(content), route=route)


def _power(error: float) -> str:
    return f"{error:.1e}".replace("-", "−") if error else "0"
