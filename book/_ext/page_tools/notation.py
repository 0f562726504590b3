"""Voigt orders and the factors of matrices, from the records and classes that programs use."""

from __future__ import annotations

from granular import Compliance, Stiffness
from granular.notation import MANDEL_PAIRS, ORDERS
from page_tools.markup import Markup, table

SHEAR_PLACES = (3, 4, 5)

EXACT = 1e-12
"""Factors are recognised to this [-]: far above rounding, far below the difference of two of them."""


def voigt_orders() -> Markup:
    """Both Voigt orders, with the tensor component that each two-index shear name means."""
    rows = []
    for name, pairs in ORDERS.items():
        shear = [f"$C_{{{i}{j}{i}{j}}}$" for i, j in (pairs[place] for place in SHEAR_PLACES)]
        rows.append([f"`{name}`", " ".join(f"{i}{j}" for i, j in pairs), *shear])
    return table(["order", "index pairs", "$C_{44}$", "$C_{55}$", "$C_{66}$"], rows, label="tab-orders",
                 caption="The two Voigt orders. `standard` is the default; `paper` is that of Pan & Dong (1999).")


FULL = [[10.0, 1.1, 1.2, 1.3, 1.4, 1.5], [1.1, 11.0, 1.6, 1.7, 1.8, 1.9], [1.2, 1.6, 12.0, 2.1, 2.2, 2.3],
        [1.3, 1.7, 2.1, 13.0, 2.4, 2.5], [1.4, 1.8, 2.2, 2.4, 14.0, 2.6], [1.5, 1.9, 2.3, 2.5, 2.6, 15.0]]
"""A Mandel matrix without any zero, of which the factors of all notations are read."""

BLOCKS = {"normal, normal": (0, 1), "normal, shear": (0, 3), "shear, shear": (3, 4)}
"""A row and a column out of each block of the matrices."""

PRINTED = {1.0: "1", 2.0: "2", 4.0: "4", 2.0**0.5: r"$\sqrt2$"}


def factors() -> Markup:
    """What a tensor component is multiplied by, where it stands in each kind of matrix."""
    rows = []
    for block, (row, column) in BLOCKS.items():
        found = [_factor(matrix[row][column], tensor, row, column) for tensor in (Stiffness, Compliance)
                 for matrix in (tensor.from_mandel(FULL).voigt(), FULL)]
        rows.append([block, found[0], found[2], found[1] if found[1] == found[3] else f"{found[1]}, {found[3]}"])
    return table(["row, column", "Voigt stiffness", "Voigt compliance", "Mandel, either"], rows, label="tab-factors",
                 align="lrrr", caption="Factor between a tensor component and the entry of the matrix.")


def _factor(entry: float, tensor: type[Stiffness | Compliance], row: int, column: int) -> str:
    """The factor in print, of an entry over its tensor component."""
    indices = "".join(f"{i}{j}" for i, j in (MANDEL_PAIRS[row], MANDEL_PAIRS[column]))
    factor = entry / tensor.from_mandel(FULL).component(tensor.symbol + indices)
    return next(text for value, text in PRINTED.items() if abs(factor / value - 1) < EXACT)
