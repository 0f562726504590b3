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


def emitted_files() -> Markup:
    """List every derivation with its page, its cost before and after simplification and its digest."""
    index = json.loads(files("granular.generated").joinpath("index.json").read_text(encoding="utf-8"))
    rows = [[f"[{plain(entry['title'])}]({PAGE_OF[name]}.md)", f"`{name}`",
             f"{entry['operations_before']} → {entry['operations_after'] or '–'}", f"`{entry['sha256'][:12]}`"]
            for name, entry in index.items()]
    return table(["derivation", "name", "operations", "SHA-256"], rows, label="tab-emitted", align="llrl",
                 caption="Derivations; arithmetic operations of the outputs as derived → in the emitted functions.")
