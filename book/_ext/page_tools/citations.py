"""Which public names of the library say in their docstring that they compute an equation or a figure of the paper."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from functools import cache
from importlib.resources import files
from pathlib import Path

from derivations.citations import equations_cited

BESIDE = ("checks", "cost", "figures", "speed")
"""Packages that hold results of the others against each other, measure or draw them."""

_FIGURE = re.compile(r"\bFigure (\d)")


@cache
def documented() -> dict[str, str]:
    """Docstring of every public function, class and method written by hand, by its full name; nothing is imported."""
    root = Path(str(files("granular")))
    found: dict[str, str] = {}
    for path in sorted(path for path in root.rglob("*.py") if path.parent.name != "generated"):
        module = ".".join(("granular", *path.relative_to(root).with_suffix("").parts)).removesuffix(".__init__")
        found.update(_definitions(ast.parse(path.read_text(encoding="utf-8")), module))
    return found


def _definitions(scope: ast.Module | ast.ClassDef, name: str) -> Iterator[tuple[str, str]]:
    for node in scope.body:
        if isinstance(node, ast.FunctionDef | ast.ClassDef) and not node.name.startswith("_"):
            yield f"{name}.{node.name}", ast.get_docstring(node) or ""
            if isinstance(node, ast.ClassDef):
                yield from _definitions(node, f"{name}.{node.name}")


@cache
def citing() -> dict[str, frozenset[str]]:
    """Public names by the place of the paper that they cite: ``(7)``, ``Figure 5``."""
    found: dict[str, set[str]] = {}
    for name, text in documented().items():
        flat = " ".join(text.split())
        places = [*(f"({number})" for number in equations_cited(flat)),
                  *(f"Figure {digit}" for digit in _FIGURE.findall(flat))]
        for place in places:
            found.setdefault(place, set()).add(name)
    return {place: frozenset(names) for place, names in found.items()}


def computing(place: str) -> frozenset[str]:
    """Public names that compute what they cite: for an equation, none that only measures, checks or draws."""
    names = citing().get(place, frozenset())
    if place.startswith("Figure"):
        return names
    return frozenset(name for name in names if name.split(".")[1] not in BESIDE)
