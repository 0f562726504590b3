"""The two Voigt orders, from the record that programs use."""

from __future__ import annotations

from granular.notation import ORDERS
from page_tools.markup import Markup, table

SHEAR_PLACES = (3, 4, 5)


def voigt_orders() -> Markup:
    """Both Voigt orders, with the tensor component that each two-index shear name means."""
    rows = []
    for name, pairs in ORDERS.items():
        shear = [f"$C_{{{i}{j}{i}{j}}}$" for i, j in (pairs[place] for place in SHEAR_PLACES)]
        rows.append([f"`{name}`", " ".join(f"{i}{j}" for i, j in pairs), *shear])
    return table(["order", "index pairs", "$C_{44}$", "$C_{55}$", "$C_{66}$"], rows, label="tab-orders",
                 caption="The two Voigt orders. `standard` is the default; `paper` is that of Pan & Dong (1999).")
