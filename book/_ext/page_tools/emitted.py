"""What the derivations emit, from the index that stands beside the emitted files."""

from __future__ import annotations

import json
from importlib.resources import files

from page_tools.markup import Markup, plain, table

PAGE_OF = {"fabric": "fabric", "fabric_kinds": "fabric_tensors", "equations": "kinematic",
           "kinematic_constant": "kinematic", "static_constant": "static", "kinematic_three": "kinematic",
           "static_three": "static", "isotropic": "kinematic", "engineering": "engineering", "waves": "waves",
           "contact_forces": "forces", "mohr_circle": "sliding", "kinetic_components": "kinetic", "kinetic": "kinetic",
           "kinetic_limits": "kinetic_limits", "partial_slip": "partial_slip", "gradation": "gradation",
           "spheroid": "shape", "general_constant": "general_fabric", "gradients": "fit",
           "first_order_fabric": "fit", "slip_table": "partial_slip"}
"""The page that shows each derivation with its steps."""


SHEET = {"formulas_fabric": ("fabric", "equations", "gradation", "fabric_kinds"),
         "formulas_stiffness": ("kinematic_constant", "static_constant", "isotropic", "kinematic_three", "static_three",
                                "general_constant", "spheroid"),
         "formulas_forces": ("contact_forces", "mohr_circle", "kinetic_components", "kinetic", "partial_slip",
                             "slip_table", "kinetic_limits"),
         "formulas_use": ("engineering", "waves", "first_order_fabric", "gradients")}
"""The derivations on each page of the formula sheet."""


def emitted_files() -> Markup:
    """List every derivation with its pages, the equations it is from, its cost and its digest."""
    index = json.loads(files("granular.generated").joinpath("index.json").read_text(encoding="utf-8"))
    rows = [[f"[{plain(index[name]['title'])}]({PAGE_OF[name]}.md)", f"[`{name}`]({page}.md)",
             ", ".join(index[name]["sources"]) or "–",
             f"{index[name]['operations_before']} → {index[name]['operations_after'] or '–'}",
             f"`{index[name]['sha256'][:8]}`"]
            for page, names in SHEET.items() for name in names]
    return table(["derivation", "on the sheet", "from", "operations", "SHA-256"], rows, label="tab-emitted",
                 align="lllrl", caption="Derivations, the equations of the paper that they start from or reach, and "
                 "arithmetic operations of the outputs as derived → in the emitted functions.")
