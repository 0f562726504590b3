"""Scene files of the paper's cases, to download and run: the same as what the tables are computed from."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from typing import Any

from page_tools.gradation import assemblies
from page_tools.markup import Markup, file_link
from page_tools.paper import SCENE, cases
from page_tools.paper_tables import TABLES

SECTIONS = ("grains", "packing", "branches", "gradation", "stress", "model")


def scene_text(name: str, case: Mapping[str, str]) -> str:
    """Write one case of Tables II to V as a scene file."""
    content = _material()
    fabric, branches = float(case["D33"]), float(case["Dr33"])
    if fabric:
        content["packing"]["contact_normals"] = {"D33": fabric}
    if branches:
        content["branches"] = {"anisotropy": {"D33": branches}}
    if "stress_ratio" in case:
        content["grains"]["friction_angle"] = case["friction_angle"]
        content["stress"]["ratio"] = float(case["stress_ratio"])
    content["model"] = {"effects": case.get("effects", "packing branches").split()}
    return f"# Pan & Dong (1999), Table {name}, {_words(case)}\n{_toml(content)}"


def gradation_text(case: Mapping[str, str]) -> str:
    """Write one assembly of Table I as a scene file; sizes are diameters."""
    content = _material()
    content["gradation"] = {"distribution": "lognormal", "median": f"{2 * float(case['r50_mm']):g} mm",
                            "spread": float(case["spread"])}
    return f"# Pan & Dong (1999), Table I, curve {case['curve']}\n{_toml(content)}"


def scene_files(name: str) -> Markup:
    """Offer the scenes of one of Tables II to V."""
    return _offered([(f"table_{name.lower()}_{place}.toml", scene_text(name, case), _words(case))
                     for place, case in enumerate(cases(TABLES[name]), start=1)])


def gradation_files(data: str) -> Markup:
    """Offer the scenes of Table I."""
    return _offered([(f"table_i_{case['curve']}.toml", gradation_text(case), f"curve {case['curve']}")
                     for case, _ in assemblies(data)])


def _offered(files: list[tuple[str, str, str]]) -> Markup:
    links = ", ".join(file_link(file, text, words, kind="application/toml") for file, text, words in files)
    return Markup(f"Scene files for `granular run`: {links}.\n")


def _material() -> dict[str, Any]:
    """Grains, void ratio and mean stress of the parametric study."""
    content = tomllib.loads(SCENE.read_text(encoding="utf-8"))
    return {"grains": {key: content["grains"][key] for key in ("shear_modulus", "poisson_ratio")},
            "packing": {"void_ratio": content["packing"]["void_ratio"]}, "stress": {"mean": content["stress"]["mean"]}}


def _words(case: Mapping[str, str]) -> str:
    name = case["case"]
    return name.replace("SR =", "stress ratio") if "=" in name else f"case {name}"


def _toml(content: Mapping[str, Mapping[str, Any]]) -> str:
    """Sections in the order of the book's examples."""
    return "\n".join(f"\n[{section}]\n" + "\n".join(f"{key} = {_value(value)}" for key, value in keys.items())
                     for section in SECTIONS if (keys := content.get(section))) + "\n"


def _value(value: Any) -> str:
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {_value(inner)}" for key, inner in value.items()) + " }"
    if isinstance(value, list):
        return "[" + ", ".join(map(_value, value)) + "]"
    return f'"{value}"' if isinstance(value, str) else repr(value)
