"""Orders of index pairs: how the 81 components of an elastic tensor stand in a 6x6 matrix.

Two Voigt orders are in use for this model, and they swap the shear components, so an order is always named:

========  ======================  ==========  ==========
order     pairs                   C44         C66
========  ======================  ==========  ==========
standard  11 22 33 23 13 12       C2323       C1212
paper     11 22 33 12 13 23       C1212       C2323
========  ======================  ==========  ==========

``paper`` is the order of Pan & Dong (1999). Mandel (Kelvin) matrices inside this package stand in the
standard order. In Mandel notation a shear row and a shear column each carry ``sqrt(2)``; then the matrix of
the inverse tensor is the inverse of the matrix, rotations are orthogonal matrices, and eigenvalues mean
something. In Voigt notation the last two fail, and stiffness and compliance carry different factors.
"""

from __future__ import annotations

import math
from typing import Literal, get_args

from granular.errors import IndexNotKnown

Order = Literal["standard", "paper"]
"""Names of the two Voigt orders."""

ORDERS: dict[Order, tuple[tuple[int, int], ...]] = {
    "standard": ((1, 1), (2, 2), (3, 3), (2, 3), (1, 3), (1, 2)),
    "paper": ((1, 1), (2, 2), (3, 3), (1, 2), (1, 3), (2, 3)),
}
"""Index pairs of each order, counted from 1 as in print."""

MANDEL_PAIRS = ORDERS["standard"]
"""Index pairs of the rows of every Mandel matrix in this package."""

NORMAL_PAIRS = 3
"""The first three pairs of every order are normal (11, 22, 33); the rest are shear."""

_POSITION = {pair: row for row, (i, j) in enumerate(MANDEL_PAIRS) for pair in ((i, j), (j, i))}
_FACTORS = (1.0, math.sqrt(2.0), 2.0)


def row_of(i: int, j: int) -> int:
    """Row of the index pair ``ij`` (counted from 1) in a Mandel matrix; ``ij`` and ``ji`` share it.

    Parameters
    ----------
    i, j : int
        Tensor indices, 1 to 3 [-].

    Returns
    -------
    int
        Row 0 to 5 [-].

    Notes
    -----
    Source: the minor symmetry of stress and strain; the order is a choice of this package.

    Examples
    --------
    >>> row_of(2, 3), row_of(3, 2)
    (3, 3)
    """
    return _POSITION[i, j]


def mandel_factor(row: int, column: int) -> float:
    """What a tensor component is multiplied by to stand in a Mandel matrix: 1, sqrt(2) or exactly 2.

    Parameters
    ----------
    row, column : int
        Place in the matrix, 0 to 5 [-].

    Returns
    -------
    float
        The factor [-].

    Notes
    -----
    Source: Mandel's notation, which keeps the norm of tensor and matrix equal.

    Examples
    --------
    >>> mandel_factor(0, 2), mandel_factor(3, 3)
    (1.0, 2.0)
    """
    return _FACTORS[(row >= NORMAL_PAIRS) + (column >= NORMAL_PAIRS)]


def voigt_rows(order: Order) -> tuple[int, ...]:
    """Mandel row of each row of a Voigt matrix.

    Parameters
    ----------
    order : "standard" or "paper"
        Name of the Voigt order.

    Returns
    -------
    tuple of 6 int
        ``rows[m]`` is the Mandel row that stands at place ``m`` [-].

    Raises
    ------
    IndexNotKnown
        The order has no such name.

    Notes
    -----
    Source: the paper's order is the one written out under PARAMETRIC STUDY OF MICROFEATURES.

    Examples
    --------
    >>> voigt_rows("paper")
    (0, 1, 2, 5, 4, 3)
    """
    if order not in ORDERS:
        raise IndexNotKnown(f"index order {order!r}", allowed=f"known: {', '.join(get_args(Order))}",
                            remedy="Name one of the known orders.")
    return tuple(row_of(i, j) for i, j in ORDERS[order])


def component_place(name: str, symbol: str) -> tuple[int, int]:
    """Row and column of a component named by its tensor indices.

    Parameters
    ----------
    name : str
        The symbol and four indices 1 to 3, e.g. ``"C2323"``.
    symbol : str
        ``"C"`` for a stiffness, ``"S"`` for a compliance.

    Returns
    -------
    tuple of 2 int
        Row and column of the Mandel matrix [-].

    Raises
    ------
    IndexNotKnown
        The name is anything else; two-index names such as C44 mean different things in different orders.

    Notes
    -----
    Source: minor symmetry.

    Examples
    --------
    >>> component_place("C3323", "C")
    (2, 3)
    """
    digits = name[1:]
    if name[:1] != symbol or len(digits) != 4 or set(digits) - set("123"):
        raise IndexNotKnown(f"component {name!r}", allowed=f"allowed: {symbol} and four indices from 1 to 3",
                            remedy=f"Name it by its tensor indices, for example {symbol}2323.")
    first, second, third, fourth = map(int, digits)
    return row_of(first, second), row_of(third, fourth)
