"""Rows of polynomials in two variables for the elements of a panel: loops over elements, to be compiled.

Emitted by ``derivations write``; do not edit. Even and odd powers are summed apart, each by Horner's rule in the square
of the variable.
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

Array: TypeAlias = npt.NDArray[np.float64]


def set_row_4(rows: Array, k: int, at: int, variable: Array, values: Array, first: int, last: int) -> None:
    """Set three values of each element to polynomials.

    Parameters
    ----------
    rows : (6, terms) array [-]
        Coefficients of polynomials, highest power first.
    k : int
        The first of the three polynomials.
    at : int
        Place of the first of the 4 that are used.
    variable : (n,) array [-]
        Variable of the polynomials.
    values : (6, m) array [-]
        Values, n of three rows of which are set.
    first, last : int
        Where these begin and end.

    Operations: 19.
    """
    a0 = rows[k + 0, at + 0]
    a1 = rows[k + 0, at + 1]
    a2 = rows[k + 0, at + 2]
    a3 = rows[k + 0, at + 3]
    b0 = rows[k + 1, at + 0]
    b1 = rows[k + 1, at + 1]
    b2 = rows[k + 1, at + 2]
    b3 = rows[k + 1, at + 3]
    c0 = rows[k + 2, at + 0]
    c1 = rows[k + 2, at + 1]
    c2 = rows[k + 2, at + 2]
    c3 = rows[k + 2, at + 3]
    v0 = values[k + 0, first:last]
    v1 = values[k + 1, first:last]
    v2 = values[k + 2, first:last]
    for r in range(variable.size):
        x = variable[r]
        z = x*x
        even0 = a1
        odd0 = a0
        even1 = b1
        odd1 = b0
        even2 = c1
        odd2 = c0
        even0 = even0*z + a3
        odd0 = odd0*z + a2
        even1 = even1*z + b3
        odd1 = odd1*z + b2
        even2 = even2*z + c3
        odd2 = odd2*z + c2
        v0[r] = (even0 + x*odd0)
        v1[r] = (even1 + x*odd1)
        v2[r] = (even2 + x*odd2)


def set_row_11(rows: Array, k: int, at: int, variable: Array, values: Array, first: int, last: int) -> None:
    """Set three values of each element to polynomials.

    Parameters
    ----------
    rows : (6, terms) array [-]
        Coefficients of polynomials, highest power first.
    k : int
        The first of the three polynomials.
    at : int
        Place of the first of the 11 that are used.
    variable : (n,) array [-]
        Variable of the polynomials.
    values : (6, m) array [-]
        Values, n of three rows of which are set.
    first, last : int
        Where these begin and end.

    Operations: 61.
    """
    a0 = rows[k + 0, at + 0]
    a1 = rows[k + 0, at + 1]
    a2 = rows[k + 0, at + 2]
    a3 = rows[k + 0, at + 3]
    a4 = rows[k + 0, at + 4]
    a5 = rows[k + 0, at + 5]
    a6 = rows[k + 0, at + 6]
    a7 = rows[k + 0, at + 7]
    a8 = rows[k + 0, at + 8]
    a9 = rows[k + 0, at + 9]
    a10 = rows[k + 0, at + 10]
    b0 = rows[k + 1, at + 0]
    b1 = rows[k + 1, at + 1]
    b2 = rows[k + 1, at + 2]
    b3 = rows[k + 1, at + 3]
    b4 = rows[k + 1, at + 4]
    b5 = rows[k + 1, at + 5]
    b6 = rows[k + 1, at + 6]
    b7 = rows[k + 1, at + 7]
    b8 = rows[k + 1, at + 8]
    b9 = rows[k + 1, at + 9]
    b10 = rows[k + 1, at + 10]
    c0 = rows[k + 2, at + 0]
    c1 = rows[k + 2, at + 1]
    c2 = rows[k + 2, at + 2]
    c3 = rows[k + 2, at + 3]
    c4 = rows[k + 2, at + 4]
    c5 = rows[k + 2, at + 5]
    c6 = rows[k + 2, at + 6]
    c7 = rows[k + 2, at + 7]
    c8 = rows[k + 2, at + 8]
    c9 = rows[k + 2, at + 9]
    c10 = rows[k + 2, at + 10]
    v0 = values[k + 0, first:last]
    v1 = values[k + 1, first:last]
    v2 = values[k + 2, first:last]
    for r in range(variable.size):
        x = variable[r]
        z = x*x
        even0 = a0
        even1 = b0
        even2 = c0
        even0 = even0*z + a2
        odd0 = a1
        even1 = even1*z + b2
        odd1 = b1
        even2 = even2*z + c2
        odd2 = c1
        even0 = even0*z + a4
        odd0 = odd0*z + a3
        even1 = even1*z + b4
        odd1 = odd1*z + b3
        even2 = even2*z + c4
        odd2 = odd2*z + c3
        even0 = even0*z + a6
        odd0 = odd0*z + a5
        even1 = even1*z + b6
        odd1 = odd1*z + b5
        even2 = even2*z + c6
        odd2 = odd2*z + c5
        even0 = even0*z + a8
        odd0 = odd0*z + a7
        even1 = even1*z + b8
        odd1 = odd1*z + b7
        even2 = even2*z + c8
        odd2 = odd2*z + c7
        even0 = even0*z + a10
        odd0 = odd0*z + a9
        even1 = even1*z + b10
        odd1 = odd1*z + b9
        even2 = even2*z + c10
        odd2 = odd2*z + c9
        v0[r] = (even0 + x*odd0)
        v1[r] = (even1 + x*odd1)
        v2[r] = (even2 + x*odd2)


def add_row_4(rows: Array, k: int, at: int, variable: Array, other: Array, values: Array, first: int, last: int) -> None:
    """Multiply three values of each element by one variable, and add a polynomial in the other to each.

    Parameters
    ----------
    rows : (6, terms) array [-]
        Coefficients of polynomials, highest power first.
    k : int
        The first of the three polynomials.
    at : int
        Place of the first of the 4 that are used.
    variable : (n,) array [-]
        Variable of the polynomials.
    other : (n,) array [-]
        Factor of the values.
    values : (6, m) array [-]
        Values, n of three rows of which are changed in place.
    first, last : int
        Where these begin and end.

    Operations: 25.
    """
    a0 = rows[k + 0, at + 0]
    a1 = rows[k + 0, at + 1]
    a2 = rows[k + 0, at + 2]
    a3 = rows[k + 0, at + 3]
    b0 = rows[k + 1, at + 0]
    b1 = rows[k + 1, at + 1]
    b2 = rows[k + 1, at + 2]
    b3 = rows[k + 1, at + 3]
    c0 = rows[k + 2, at + 0]
    c1 = rows[k + 2, at + 1]
    c2 = rows[k + 2, at + 2]
    c3 = rows[k + 2, at + 3]
    v0 = values[k + 0, first:last]
    v1 = values[k + 1, first:last]
    v2 = values[k + 2, first:last]
    for r in range(variable.size):
        x = variable[r]
        z = x*x
        even0 = a1
        odd0 = a0
        even1 = b1
        odd1 = b0
        even2 = c1
        odd2 = c0
        even0 = even0*z + a3
        odd0 = odd0*z + a2
        even1 = even1*z + b3
        odd1 = odd1*z + b2
        even2 = even2*z + c3
        odd2 = odd2*z + c2
        v0[r] = v0[r]*other[r] + (even0 + x*odd0)
        v1[r] = v1[r]*other[r] + (even1 + x*odd1)
        v2[r] = v2[r]*other[r] + (even2 + x*odd2)


def add_row_7(rows: Array, k: int, at: int, variable: Array, other: Array, values: Array, first: int, last: int) -> None:
    """Multiply three values of each element by one variable, and add a polynomial in the other to each.

    Parameters
    ----------
    rows : (6, terms) array [-]
        Coefficients of polynomials, highest power first.
    k : int
        The first of the three polynomials.
    at : int
        Place of the first of the 7 that are used.
    variable : (n,) array [-]
        Variable of the polynomials.
    other : (n,) array [-]
        Factor of the values.
    values : (6, m) array [-]
        Values, n of three rows of which are changed in place.
    first, last : int
        Where these begin and end.

    Operations: 43.
    """
    a0 = rows[k + 0, at + 0]
    a1 = rows[k + 0, at + 1]
    a2 = rows[k + 0, at + 2]
    a3 = rows[k + 0, at + 3]
    a4 = rows[k + 0, at + 4]
    a5 = rows[k + 0, at + 5]
    a6 = rows[k + 0, at + 6]
    b0 = rows[k + 1, at + 0]
    b1 = rows[k + 1, at + 1]
    b2 = rows[k + 1, at + 2]
    b3 = rows[k + 1, at + 3]
    b4 = rows[k + 1, at + 4]
    b5 = rows[k + 1, at + 5]
    b6 = rows[k + 1, at + 6]
    c0 = rows[k + 2, at + 0]
    c1 = rows[k + 2, at + 1]
    c2 = rows[k + 2, at + 2]
    c3 = rows[k + 2, at + 3]
    c4 = rows[k + 2, at + 4]
    c5 = rows[k + 2, at + 5]
    c6 = rows[k + 2, at + 6]
    v0 = values[k + 0, first:last]
    v1 = values[k + 1, first:last]
    v2 = values[k + 2, first:last]
    for r in range(variable.size):
        x = variable[r]
        z = x*x
        even0 = a0
        even1 = b0
        even2 = c0
        even0 = even0*z + a2
        odd0 = a1
        even1 = even1*z + b2
        odd1 = b1
        even2 = even2*z + c2
        odd2 = c1
        even0 = even0*z + a4
        odd0 = odd0*z + a3
        even1 = even1*z + b4
        odd1 = odd1*z + b3
        even2 = even2*z + c4
        odd2 = odd2*z + c3
        even0 = even0*z + a6
        odd0 = odd0*z + a5
        even1 = even1*z + b6
        odd1 = odd1*z + b5
        even2 = even2*z + c6
        odd2 = odd2*z + c5
        v0[r] = v0[r]*other[r] + (even0 + x*odd0)
        v1[r] = v1[r]*other[r] + (even1 + x*odd1)
        v2[r] = v2[r]*other[r] + (even2 + x*odd2)


def add_row_10(rows: Array, k: int, at: int, variable: Array, other: Array, values: Array, first: int, last: int) -> None:
    """Multiply three values of each element by one variable, and add a polynomial in the other to each.

    Parameters
    ----------
    rows : (6, terms) array [-]
        Coefficients of polynomials, highest power first.
    k : int
        The first of the three polynomials.
    at : int
        Place of the first of the 10 that are used.
    variable : (n,) array [-]
        Variable of the polynomials.
    other : (n,) array [-]
        Factor of the values.
    values : (6, m) array [-]
        Values, n of three rows of which are changed in place.
    first, last : int
        Where these begin and end.

    Operations: 61.
    """
    a0 = rows[k + 0, at + 0]
    a1 = rows[k + 0, at + 1]
    a2 = rows[k + 0, at + 2]
    a3 = rows[k + 0, at + 3]
    a4 = rows[k + 0, at + 4]
    a5 = rows[k + 0, at + 5]
    a6 = rows[k + 0, at + 6]
    a7 = rows[k + 0, at + 7]
    a8 = rows[k + 0, at + 8]
    a9 = rows[k + 0, at + 9]
    b0 = rows[k + 1, at + 0]
    b1 = rows[k + 1, at + 1]
    b2 = rows[k + 1, at + 2]
    b3 = rows[k + 1, at + 3]
    b4 = rows[k + 1, at + 4]
    b5 = rows[k + 1, at + 5]
    b6 = rows[k + 1, at + 6]
    b7 = rows[k + 1, at + 7]
    b8 = rows[k + 1, at + 8]
    b9 = rows[k + 1, at + 9]
    c0 = rows[k + 2, at + 0]
    c1 = rows[k + 2, at + 1]
    c2 = rows[k + 2, at + 2]
    c3 = rows[k + 2, at + 3]
    c4 = rows[k + 2, at + 4]
    c5 = rows[k + 2, at + 5]
    c6 = rows[k + 2, at + 6]
    c7 = rows[k + 2, at + 7]
    c8 = rows[k + 2, at + 8]
    c9 = rows[k + 2, at + 9]
    v0 = values[k + 0, first:last]
    v1 = values[k + 1, first:last]
    v2 = values[k + 2, first:last]
    for r in range(variable.size):
        x = variable[r]
        z = x*x
        even0 = a1
        odd0 = a0
        even1 = b1
        odd1 = b0
        even2 = c1
        odd2 = c0
        even0 = even0*z + a3
        odd0 = odd0*z + a2
        even1 = even1*z + b3
        odd1 = odd1*z + b2
        even2 = even2*z + c3
        odd2 = odd2*z + c2
        even0 = even0*z + a5
        odd0 = odd0*z + a4
        even1 = even1*z + b5
        odd1 = odd1*z + b4
        even2 = even2*z + c5
        odd2 = odd2*z + c4
        even0 = even0*z + a7
        odd0 = odd0*z + a6
        even1 = even1*z + b7
        odd1 = odd1*z + b6
        even2 = even2*z + c7
        odd2 = odd2*z + c6
        even0 = even0*z + a9
        odd0 = odd0*z + a8
        even1 = even1*z + b9
        odd1 = odd1*z + b8
        even2 = even2*z + c9
        odd2 = odd2*z + c8
        v0[r] = v0[r]*other[r] + (even0 + x*odd0)
        v1[r] = v1[r]*other[r] + (even1 + x*odd1)
        v2[r] = v2[r]*other[r] + (even2 + x*odd2)


def add_row_11(rows: Array, k: int, at: int, variable: Array, other: Array, values: Array, first: int, last: int) -> None:
    """Multiply three values of each element by one variable, and add a polynomial in the other to each.

    Parameters
    ----------
    rows : (6, terms) array [-]
        Coefficients of polynomials, highest power first.
    k : int
        The first of the three polynomials.
    at : int
        Place of the first of the 11 that are used.
    variable : (n,) array [-]
        Variable of the polynomials.
    other : (n,) array [-]
        Factor of the values.
    values : (6, m) array [-]
        Values, n of three rows of which are changed in place.
    first, last : int
        Where these begin and end.

    Operations: 67.
    """
    a0 = rows[k + 0, at + 0]
    a1 = rows[k + 0, at + 1]
    a2 = rows[k + 0, at + 2]
    a3 = rows[k + 0, at + 3]
    a4 = rows[k + 0, at + 4]
    a5 = rows[k + 0, at + 5]
    a6 = rows[k + 0, at + 6]
    a7 = rows[k + 0, at + 7]
    a8 = rows[k + 0, at + 8]
    a9 = rows[k + 0, at + 9]
    a10 = rows[k + 0, at + 10]
    b0 = rows[k + 1, at + 0]
    b1 = rows[k + 1, at + 1]
    b2 = rows[k + 1, at + 2]
    b3 = rows[k + 1, at + 3]
    b4 = rows[k + 1, at + 4]
    b5 = rows[k + 1, at + 5]
    b6 = rows[k + 1, at + 6]
    b7 = rows[k + 1, at + 7]
    b8 = rows[k + 1, at + 8]
    b9 = rows[k + 1, at + 9]
    b10 = rows[k + 1, at + 10]
    c0 = rows[k + 2, at + 0]
    c1 = rows[k + 2, at + 1]
    c2 = rows[k + 2, at + 2]
    c3 = rows[k + 2, at + 3]
    c4 = rows[k + 2, at + 4]
    c5 = rows[k + 2, at + 5]
    c6 = rows[k + 2, at + 6]
    c7 = rows[k + 2, at + 7]
    c8 = rows[k + 2, at + 8]
    c9 = rows[k + 2, at + 9]
    c10 = rows[k + 2, at + 10]
    v0 = values[k + 0, first:last]
    v1 = values[k + 1, first:last]
    v2 = values[k + 2, first:last]
    for r in range(variable.size):
        x = variable[r]
        z = x*x
        even0 = a0
        even1 = b0
        even2 = c0
        even0 = even0*z + a2
        odd0 = a1
        even1 = even1*z + b2
        odd1 = b1
        even2 = even2*z + c2
        odd2 = c1
        even0 = even0*z + a4
        odd0 = odd0*z + a3
        even1 = even1*z + b4
        odd1 = odd1*z + b3
        even2 = even2*z + c4
        odd2 = odd2*z + c3
        even0 = even0*z + a6
        odd0 = odd0*z + a5
        even1 = even1*z + b6
        odd1 = odd1*z + b5
        even2 = even2*z + c6
        odd2 = odd2*z + c5
        even0 = even0*z + a8
        odd0 = odd0*z + a7
        even1 = even1*z + b8
        odd1 = odd1*z + b7
        even2 = even2*z + c8
        odd2 = odd2*z + c7
        even0 = even0*z + a10
        odd0 = odd0*z + a9
        even1 = even1*z + b10
        odd1 = odd1*z + b9
        even2 = even2*z + c10
        odd2 = odd2*z + c9
        v0[r] = v0[r]*other[r] + (even0 + x*odd0)
        v1[r] = v1[r]*other[r] + (even1 + x*odd1)
        v2[r] = v2[r]*other[r] + (even2 + x*odd2)


def add_row_12(rows: Array, k: int, at: int, variable: Array, other: Array, values: Array, first: int, last: int) -> None:
    """Multiply three values of each element by one variable, and add a polynomial in the other to each.

    Parameters
    ----------
    rows : (6, terms) array [-]
        Coefficients of polynomials, highest power first.
    k : int
        The first of the three polynomials.
    at : int
        Place of the first of the 12 that are used.
    variable : (n,) array [-]
        Variable of the polynomials.
    other : (n,) array [-]
        Factor of the values.
    values : (6, m) array [-]
        Values, n of three rows of which are changed in place.
    first, last : int
        Where these begin and end.

    Operations: 73.
    """
    a0 = rows[k + 0, at + 0]
    a1 = rows[k + 0, at + 1]
    a2 = rows[k + 0, at + 2]
    a3 = rows[k + 0, at + 3]
    a4 = rows[k + 0, at + 4]
    a5 = rows[k + 0, at + 5]
    a6 = rows[k + 0, at + 6]
    a7 = rows[k + 0, at + 7]
    a8 = rows[k + 0, at + 8]
    a9 = rows[k + 0, at + 9]
    a10 = rows[k + 0, at + 10]
    a11 = rows[k + 0, at + 11]
    b0 = rows[k + 1, at + 0]
    b1 = rows[k + 1, at + 1]
    b2 = rows[k + 1, at + 2]
    b3 = rows[k + 1, at + 3]
    b4 = rows[k + 1, at + 4]
    b5 = rows[k + 1, at + 5]
    b6 = rows[k + 1, at + 6]
    b7 = rows[k + 1, at + 7]
    b8 = rows[k + 1, at + 8]
    b9 = rows[k + 1, at + 9]
    b10 = rows[k + 1, at + 10]
    b11 = rows[k + 1, at + 11]
    c0 = rows[k + 2, at + 0]
    c1 = rows[k + 2, at + 1]
    c2 = rows[k + 2, at + 2]
    c3 = rows[k + 2, at + 3]
    c4 = rows[k + 2, at + 4]
    c5 = rows[k + 2, at + 5]
    c6 = rows[k + 2, at + 6]
    c7 = rows[k + 2, at + 7]
    c8 = rows[k + 2, at + 8]
    c9 = rows[k + 2, at + 9]
    c10 = rows[k + 2, at + 10]
    c11 = rows[k + 2, at + 11]
    v0 = values[k + 0, first:last]
    v1 = values[k + 1, first:last]
    v2 = values[k + 2, first:last]
    for r in range(variable.size):
        x = variable[r]
        z = x*x
        even0 = a1
        odd0 = a0
        even1 = b1
        odd1 = b0
        even2 = c1
        odd2 = c0
        even0 = even0*z + a3
        odd0 = odd0*z + a2
        even1 = even1*z + b3
        odd1 = odd1*z + b2
        even2 = even2*z + c3
        odd2 = odd2*z + c2
        even0 = even0*z + a5
        odd0 = odd0*z + a4
        even1 = even1*z + b5
        odd1 = odd1*z + b4
        even2 = even2*z + c5
        odd2 = odd2*z + c4
        even0 = even0*z + a7
        odd0 = odd0*z + a6
        even1 = even1*z + b7
        odd1 = odd1*z + b6
        even2 = even2*z + c7
        odd2 = odd2*z + c6
        even0 = even0*z + a9
        odd0 = odd0*z + a8
        even1 = even1*z + b9
        odd1 = odd1*z + b8
        even2 = even2*z + c9
        odd2 = odd2*z + c8
        even0 = even0*z + a11
        odd0 = odd0*z + a10
        even1 = even1*z + b11
        odd1 = odd1*z + b10
        even2 = even2*z + c11
        odd2 = odd2*z + c10
        v0[r] = v0[r]*other[r] + (even0 + x*odd0)
        v1[r] = v1[r]*other[r] + (even1 + x*odd1)
        v2[r] = v2[r]*other[r] + (even2 + x*odd2)


def add_row_13(rows: Array, k: int, at: int, variable: Array, other: Array, values: Array, first: int, last: int) -> None:
    """Multiply three values of each element by one variable, and add a polynomial in the other to each.

    Parameters
    ----------
    rows : (6, terms) array [-]
        Coefficients of polynomials, highest power first.
    k : int
        The first of the three polynomials.
    at : int
        Place of the first of the 13 that are used.
    variable : (n,) array [-]
        Variable of the polynomials.
    other : (n,) array [-]
        Factor of the values.
    values : (6, m) array [-]
        Values, n of three rows of which are changed in place.
    first, last : int
        Where these begin and end.

    Operations: 79.
    """
    a0 = rows[k + 0, at + 0]
    a1 = rows[k + 0, at + 1]
    a2 = rows[k + 0, at + 2]
    a3 = rows[k + 0, at + 3]
    a4 = rows[k + 0, at + 4]
    a5 = rows[k + 0, at + 5]
    a6 = rows[k + 0, at + 6]
    a7 = rows[k + 0, at + 7]
    a8 = rows[k + 0, at + 8]
    a9 = rows[k + 0, at + 9]
    a10 = rows[k + 0, at + 10]
    a11 = rows[k + 0, at + 11]
    a12 = rows[k + 0, at + 12]
    b0 = rows[k + 1, at + 0]
    b1 = rows[k + 1, at + 1]
    b2 = rows[k + 1, at + 2]
    b3 = rows[k + 1, at + 3]
    b4 = rows[k + 1, at + 4]
    b5 = rows[k + 1, at + 5]
    b6 = rows[k + 1, at + 6]
    b7 = rows[k + 1, at + 7]
    b8 = rows[k + 1, at + 8]
    b9 = rows[k + 1, at + 9]
    b10 = rows[k + 1, at + 10]
    b11 = rows[k + 1, at + 11]
    b12 = rows[k + 1, at + 12]
    c0 = rows[k + 2, at + 0]
    c1 = rows[k + 2, at + 1]
    c2 = rows[k + 2, at + 2]
    c3 = rows[k + 2, at + 3]
    c4 = rows[k + 2, at + 4]
    c5 = rows[k + 2, at + 5]
    c6 = rows[k + 2, at + 6]
    c7 = rows[k + 2, at + 7]
    c8 = rows[k + 2, at + 8]
    c9 = rows[k + 2, at + 9]
    c10 = rows[k + 2, at + 10]
    c11 = rows[k + 2, at + 11]
    c12 = rows[k + 2, at + 12]
    v0 = values[k + 0, first:last]
    v1 = values[k + 1, first:last]
    v2 = values[k + 2, first:last]
    for r in range(variable.size):
        x = variable[r]
        z = x*x
        even0 = a0
        even1 = b0
        even2 = c0
        even0 = even0*z + a2
        odd0 = a1
        even1 = even1*z + b2
        odd1 = b1
        even2 = even2*z + c2
        odd2 = c1
        even0 = even0*z + a4
        odd0 = odd0*z + a3
        even1 = even1*z + b4
        odd1 = odd1*z + b3
        even2 = even2*z + c4
        odd2 = odd2*z + c3
        even0 = even0*z + a6
        odd0 = odd0*z + a5
        even1 = even1*z + b6
        odd1 = odd1*z + b5
        even2 = even2*z + c6
        odd2 = odd2*z + c5
        even0 = even0*z + a8
        odd0 = odd0*z + a7
        even1 = even1*z + b8
        odd1 = odd1*z + b7
        even2 = even2*z + c8
        odd2 = odd2*z + c7
        even0 = even0*z + a10
        odd0 = odd0*z + a9
        even1 = even1*z + b10
        odd1 = odd1*z + b9
        even2 = even2*z + c10
        odd2 = odd2*z + c9
        even0 = even0*z + a12
        odd0 = odd0*z + a11
        even1 = even1*z + b12
        odd1 = odd1*z + b11
        even2 = even2*z + c12
        odd2 = odd2*z + c11
        v0[r] = v0[r]*other[r] + (even0 + x*odd0)
        v1[r] = v1[r]*other[r] + (even1 + x*odd1)
        v2[r] = v2[r]*other[r] + (even2 + x*odd2)
