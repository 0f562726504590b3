"""Tables of the notation, from the records that derivations and programs use."""

from __future__ import annotations

from derivations.symbols import GLOSSARY
from granular.notation import ORDERS
from page_tools.markup import Markup, plain, table

SHEAR_PLACES = (3, 4, 5)


def voigt_orders() -> Markup:
    """Both Voigt orders, with the tensor component that each two-index shear name means."""
    rows = []
    for name, pairs in ORDERS.items():
        shear = [f"$C_{{{i}{j}{i}{j}}}$" for i, j in (pairs[place] for place in SHEAR_PLACES)]
        rows.append([f"`{name}`", " ".join(f"{i}{j}" for i, j in pairs), *shear])
    return table(["order", "index pairs", "$C_{44}$", "$C_{55}$", "$C_{66}$"], rows, label="tab-orders",
                 caption="The two Voigt orders. `standard` is the default; `paper` is that of Pan & Dong (1999).")


def symbols() -> Markup:
    """Every declared symbol with its unit, domain and meaning."""
    rows = [[f"${quantity.latex}$", plain(quantity.meaning), plain(quantity.unit), plain(quantity.domain)]
            for quantity in GLOSSARY]
    return table(["symbol", "meaning", "unit", "values"], rows, label="tab-symbols",
                 caption="Symbols of the derivations.")
