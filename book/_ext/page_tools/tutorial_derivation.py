"""The tutorial on new closed forms: a derivation shown, broken, emitted in memory, tested, and its places."""

from __future__ import annotations

import ast
import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from types import ModuleType
from typing import Any

import sympy as sp

from derivations.emit.scalar import scalar_module
from derivations.present import verdict
from derivations.record import Claim
from derivations.symbols import Dr33
from granular import Scene, evaluate
from granular.routes.result import Six
from page_tools.contents import BOOK, page_link, steps_shown
from page_tools.cost_words import short
from page_tools.markup import Markup, table
from page_tools.steps import steps_of
from page_tools.tutorial_bulk import closed_form, even_bulk, of_components

ROOT = BOOK.parent
FABRICS = ((0.0, 0.0, 0.0), (0.3, 0.0, -0.3), (-0.5, 0.1, 0.6), (2.0, 0.0, -0.9))
"""D33, D3333, Dr33 of the test: isotropic, Table II case 3, one of rank four, and a corner of what is admissible."""

FRICTIONS = (None, 1.0, 0.5, 0.3, 0.2)
"""Friction coefficients [-]; none for contacts that never slip."""

MODEL = "waves"
"""A derivation of the library that is as small: the table of places follows it through the project."""


def derived(*, first: int = 1, last: int | None = None) -> Markup:
    """Show steps of the example, each checked."""
    return steps_of(even_bulk(), first=first, last=last)


def wrong_step() -> Markup:
    """Show what becomes of a step with a wrong coefficient."""
    right = even_bulk().steps[3]
    slipped = closed_form().subs(Dr33, 0) + Dr33**2 / 45
    wrong = replace(right, claims=(Claim(closed_form(), slipped), *right.claims[1:]))
    assert not wrong.holds(), "the coefficient is wrong"
    found, left = verdict(wrong).split(" leaves ")
    return Markup(f"```text\n{found.partition(':')[0]}: what is left over is\n  {left}\n```\n")


def emitted_text() -> str:
    """The module that would be written."""
    return scalar_module(even_bulk())


def emitted() -> Markup:
    """Show it."""
    return Markup(f"```python\n{emitted_text()}```\n")


def emitted_function() -> Callable[[float, float, float], tuple[float]]:
    """The emitted function, from the text, without any file."""
    module = ModuleType("even_bulk")
    exec(compile(emitted_text(), "even_bulk", "exec"), module.__dict__)
    function: Callable[[float, float, float], tuple[float]] = module.__dict__["even_bulk"]
    return function


def scene(D33: float, D3333: float, Dr33: float, **more: Any) -> Scene:
    """A scene with a fabric."""
    content: dict[str, Any] = {
        "grains": {"shear_modulus": "31 GPa", "poisson_ratio": 0.21},
        "packing": {"void_ratio": 0.6, "contact_normals": {"D33": D33, "D3333": D3333}},
        "branches": {"anisotropy": {"D33": Dr33}}, "stress": {"mean": "100 kPa"}}
    for key, value in more.items():
        content[key] = content.get(key, {}) | value
    return Scene.model_validate(content)


def by_components(six: Six) -> float:
    """The same modulus from six components."""
    return float(of_components(tuple(sp.Float(value, 17) for value in six)))


def voices() -> list[tuple[tuple[float, float, float], float, float, float]]:
    """Fabric, emitted value, and by how much two other ways to it differ [-]."""
    rows = []
    for fabric in FABRICS:
        value, = emitted_function()(*fabric)
        alike = scene(*fabric, model={"effects": ["packing", "branches"]})
        others = [by_components(evaluate(alike, route=route).normalised) for route in ("closed_form", "axial")]
        rows.append((fabric, value, *(abs(other / value - 1) for other in others)))
    return rows


def voices_table() -> Markup:
    """Hold the emitted function against the six components, by closed form and by quadrature."""
    rows = [[*(f"{part:g}".replace("-", "−") for part in fabric), f"{value:.12f}", short(closed), short(axial)]
            for fabric, value, closed, axial in voices()]
    return table(["$D_{33}$", "$D_{3333}$", "$D^r_{33}$", "emitted", "off the components", "off the quadrature"], rows,
                 label="tab-even-bulk", align="rrrrrr",
                 caption="$K_\\varepsilon$ over $(M/V)\\,\\ell_e^2k_n$ by the emitted function, and how far from it, "
                         "over its value, the sum of the library's components is, with these by closed form and by "
                         "quadrature.")


def under_friction(friction: float | None) -> Six:
    """Components of a fabric under a stress ratio, by the friction between its grains."""
    grains = {} if friction is None else {"friction_coefficient": friction}
    return evaluate(scene(0.3, 0.0, -0.2, grains=grains, stress={"ratio": 2.0})).normalised


def friction_table() -> Markup:
    """The modulus with less and less friction, beside one that feels it."""
    rows = []
    for friction in FRICTIONS:
        six = under_friction(friction)
        rows.append(["never slips" if friction is None else f"{friction:g}", f"{by_components(six):.12f}",
                     f"{six[4]:.6f}"])
    return table(["friction", "$K_\\varepsilon$", "$C_{2323}$"], rows, label="tab-even-bulk-friction", align="lrr",
                 caption="Over $(M/V)\\,\\ell_e^2k_{n,\\mathrm{ref}}$, for $D_{33} = 0.3$, $D^r_{33} = -0.2$ and the "
                         "stress ratio 2. Friction decides over the shear stiffness and leaves $K_\\varepsilon$ alone.")


def callers(name: str) -> list[str]:
    """Modules of the library that import what a derivation emits."""
    found = []
    for path in sorted((ROOT / "granular").rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ImportFrom) and node.module == "granular.generated" and any(
                    alias.name in (name, f"{name}_array") for alias in node.names):
                found.append(path.relative_to(ROOT).as_posix())
    return found


def places() -> list[tuple[str, list[str], str]]:
    """What belongs where for a derivation of the library: part, files, and what fails without it."""
    index = json.loads((ROOT / "granular/generated/index.json").read_text(encoding="utf-8"))
    files = index[MODEL]["files"]
    emitted_code = [name for name in files if name.startswith("granular/")]
    return [
        ("symbols, once each", ["derivations/symbols.py"], "an input without meaning and unit"),
        ("the derivation", [f"derivations/{MODEL}.py"], "a step that does not hold"),
        ("one line that lists it", ["derivations/catalogue.py"], "nothing is emitted"),
        ("code that is emitted", emitted_code, "`derivations check`, with the difference"),
        ("formulas that are emitted", [name for name in files if name not in emitted_code], "the same"),
        ("functions for users", callers(MODEL)[-1:], "a docstring without unit or source"),
        ("a test", [f"tests/derivations/test_{MODEL}.py"], "a wrong coefficient"),
    ]


def places_table() -> Markup:
    """The files of a small derivation of the library, each of which must exist."""
    rows = []
    for part, files, breaks in places():
        missing = [name for name in files if not Path(ROOT, name).is_file()]
        assert files and not missing, f"{part}: {missing or 'no file'}"
        rows.append([part, "<br>".join(f"`{name}`" for name in files), breaks])
    shown = dict.fromkeys(place.page for (name, _), place in steps_shown().items() if name == MODEL)
    rows.append(["a page", ", ".join(page_link(page) for page in shown), "a link or a step that does not hold"])
    return table(["part", f"for `{MODEL}`", "what a test finds"], rows, label="tab-places", align="lll",
                 caption=f"Where the parts of a derivation are, followed through the project for `{MODEL}`. The first, "
                         "second, third, sixth, seventh and last row are written by hand.")
