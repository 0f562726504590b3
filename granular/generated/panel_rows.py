"""Rows of polynomials in two variables for the elements of a panel: loops over elements, to be compiled.

Emitted by ``derivations write``; do not edit. Even and odd powers are summed apart, each by Horner's rule in the square
of the variable.
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

Array: TypeAlias = npt.NDArray[np.float64]


def add_row_4(rows: Array, at: int, variable: Array, other: Array, v0: Array, v1: Array, v2: Array) -> None:
    """Multiply three values of each element by one variable, and add a polynomial in the other to each.

    Parameters
    ----------
    rows : (3, terms) array [-]
        Coefficients of the three polynomials, highest power first.
    at : int
        Place of the first of the 4 that are used.
    variable : (n,) array [-]
        Variable of the polynomials.
    other : (n,) array [-]
        Factor of the values.
    v0, v1, v2 : (n,) array [-]
        Values, changed in place.

    Operations: 25.
    """
    a0 = rows[0, at + 0]
    a1 = rows[0, at + 1]
    a2 = rows[0, at + 2]
    a3 = rows[0, at + 3]
    b0 = rows[1, at + 0]
    b1 = rows[1, at + 1]
    b2 = rows[1, at + 2]
    b3 = rows[1, at + 3]
    c0 = rows[2, at + 0]
    c1 = rows[2, at + 1]
    c2 = rows[2, at + 2]
    c3 = rows[2, at + 3]
    for r in range(variable.size):
        x = variable[r]
        z = x*x
        v0[r] = v0[r]*other[r] + ((a1*z + a3) + x*(a0*z + a2))
        v1[r] = v1[r]*other[r] + ((b1*z + b3) + x*(b0*z + b2))
        v2[r] = v2[r]*other[r] + ((c1*z + c3) + x*(c0*z + c2))


def add_row_7(rows: Array, at: int, variable: Array, other: Array, v0: Array, v1: Array, v2: Array) -> None:
    """Multiply three values of each element by one variable, and add a polynomial in the other to each.

    Parameters
    ----------
    rows : (3, terms) array [-]
        Coefficients of the three polynomials, highest power first.
    at : int
        Place of the first of the 7 that are used.
    variable : (n,) array [-]
        Variable of the polynomials.
    other : (n,) array [-]
        Factor of the values.
    v0, v1, v2 : (n,) array [-]
        Values, changed in place.

    Operations: 43.
    """
    a0 = rows[0, at + 0]
    a1 = rows[0, at + 1]
    a2 = rows[0, at + 2]
    a3 = rows[0, at + 3]
    a4 = rows[0, at + 4]
    a5 = rows[0, at + 5]
    a6 = rows[0, at + 6]
    b0 = rows[1, at + 0]
    b1 = rows[1, at + 1]
    b2 = rows[1, at + 2]
    b3 = rows[1, at + 3]
    b4 = rows[1, at + 4]
    b5 = rows[1, at + 5]
    b6 = rows[1, at + 6]
    c0 = rows[2, at + 0]
    c1 = rows[2, at + 1]
    c2 = rows[2, at + 2]
    c3 = rows[2, at + 3]
    c4 = rows[2, at + 4]
    c5 = rows[2, at + 5]
    c6 = rows[2, at + 6]
    for r in range(variable.size):
        x = variable[r]
        z = x*x
        v0[r] = v0[r]*other[r] + ((((a0*z + a2)*z + a4)*z + a6) + x*((a1*z + a3)*z + a5))
        v1[r] = v1[r]*other[r] + ((((b0*z + b2)*z + b4)*z + b6) + x*((b1*z + b3)*z + b5))
        v2[r] = v2[r]*other[r] + ((((c0*z + c2)*z + c4)*z + c6) + x*((c1*z + c3)*z + c5))


def add_row_10(rows: Array, at: int, variable: Array, other: Array, v0: Array, v1: Array, v2: Array) -> None:
    """Multiply three values of each element by one variable, and add a polynomial in the other to each.

    Parameters
    ----------
    rows : (3, terms) array [-]
        Coefficients of the three polynomials, highest power first.
    at : int
        Place of the first of the 10 that are used.
    variable : (n,) array [-]
        Variable of the polynomials.
    other : (n,) array [-]
        Factor of the values.
    v0, v1, v2 : (n,) array [-]
        Values, changed in place.

    Operations: 61.
    """
    a0 = rows[0, at + 0]
    a1 = rows[0, at + 1]
    a2 = rows[0, at + 2]
    a3 = rows[0, at + 3]
    a4 = rows[0, at + 4]
    a5 = rows[0, at + 5]
    a6 = rows[0, at + 6]
    a7 = rows[0, at + 7]
    a8 = rows[0, at + 8]
    a9 = rows[0, at + 9]
    b0 = rows[1, at + 0]
    b1 = rows[1, at + 1]
    b2 = rows[1, at + 2]
    b3 = rows[1, at + 3]
    b4 = rows[1, at + 4]
    b5 = rows[1, at + 5]
    b6 = rows[1, at + 6]
    b7 = rows[1, at + 7]
    b8 = rows[1, at + 8]
    b9 = rows[1, at + 9]
    c0 = rows[2, at + 0]
    c1 = rows[2, at + 1]
    c2 = rows[2, at + 2]
    c3 = rows[2, at + 3]
    c4 = rows[2, at + 4]
    c5 = rows[2, at + 5]
    c6 = rows[2, at + 6]
    c7 = rows[2, at + 7]
    c8 = rows[2, at + 8]
    c9 = rows[2, at + 9]
    for r in range(variable.size):
        x = variable[r]
        z = x*x
        v0[r] = v0[r]*other[r] + (((((a1*z + a3)*z + a5)*z + a7)*z + a9) + x*((((a0*z + a2)*z + a4)*z + a6)*z + a8))
        v1[r] = v1[r]*other[r] + (((((b1*z + b3)*z + b5)*z + b7)*z + b9) + x*((((b0*z + b2)*z + b4)*z + b6)*z + b8))
        v2[r] = v2[r]*other[r] + (((((c1*z + c3)*z + c5)*z + c7)*z + c9) + x*((((c0*z + c2)*z + c4)*z + c6)*z + c8))


def add_row_12(rows: Array, at: int, variable: Array, other: Array, v0: Array, v1: Array, v2: Array) -> None:
    """Multiply three values of each element by one variable, and add a polynomial in the other to each.

    Parameters
    ----------
    rows : (3, terms) array [-]
        Coefficients of the three polynomials, highest power first.
    at : int
        Place of the first of the 12 that are used.
    variable : (n,) array [-]
        Variable of the polynomials.
    other : (n,) array [-]
        Factor of the values.
    v0, v1, v2 : (n,) array [-]
        Values, changed in place.

    Operations: 73.
    """
    a0 = rows[0, at + 0]
    a1 = rows[0, at + 1]
    a2 = rows[0, at + 2]
    a3 = rows[0, at + 3]
    a4 = rows[0, at + 4]
    a5 = rows[0, at + 5]
    a6 = rows[0, at + 6]
    a7 = rows[0, at + 7]
    a8 = rows[0, at + 8]
    a9 = rows[0, at + 9]
    a10 = rows[0, at + 10]
    a11 = rows[0, at + 11]
    b0 = rows[1, at + 0]
    b1 = rows[1, at + 1]
    b2 = rows[1, at + 2]
    b3 = rows[1, at + 3]
    b4 = rows[1, at + 4]
    b5 = rows[1, at + 5]
    b6 = rows[1, at + 6]
    b7 = rows[1, at + 7]
    b8 = rows[1, at + 8]
    b9 = rows[1, at + 9]
    b10 = rows[1, at + 10]
    b11 = rows[1, at + 11]
    c0 = rows[2, at + 0]
    c1 = rows[2, at + 1]
    c2 = rows[2, at + 2]
    c3 = rows[2, at + 3]
    c4 = rows[2, at + 4]
    c5 = rows[2, at + 5]
    c6 = rows[2, at + 6]
    c7 = rows[2, at + 7]
    c8 = rows[2, at + 8]
    c9 = rows[2, at + 9]
    c10 = rows[2, at + 10]
    c11 = rows[2, at + 11]
    for r in range(variable.size):
        x = variable[r]
        z = x*x
        v0[r] = v0[r]*other[r] + ((((((a1*z + a3)*z + a5)*z + a7)*z + a9)*z + a11) + x*(((((a0*z + a2)*z + a4)*z + a6)*z + a8)*z + a10))
        v1[r] = v1[r]*other[r] + ((((((b1*z + b3)*z + b5)*z + b7)*z + b9)*z + b11) + x*(((((b0*z + b2)*z + b4)*z + b6)*z + b8)*z + b10))
        v2[r] = v2[r]*other[r] + ((((((c1*z + c3)*z + c5)*z + c7)*z + c9)*z + c11) + x*(((((c0*z + c2)*z + c4)*z + c6)*z + c8)*z + c10))


def add_row_14(rows: Array, at: int, variable: Array, other: Array, v0: Array, v1: Array, v2: Array) -> None:
    """Multiply three values of each element by one variable, and add a polynomial in the other to each.

    Parameters
    ----------
    rows : (3, terms) array [-]
        Coefficients of the three polynomials, highest power first.
    at : int
        Place of the first of the 14 that are used.
    variable : (n,) array [-]
        Variable of the polynomials.
    other : (n,) array [-]
        Factor of the values.
    v0, v1, v2 : (n,) array [-]
        Values, changed in place.

    Operations: 85.
    """
    a0 = rows[0, at + 0]
    a1 = rows[0, at + 1]
    a2 = rows[0, at + 2]
    a3 = rows[0, at + 3]
    a4 = rows[0, at + 4]
    a5 = rows[0, at + 5]
    a6 = rows[0, at + 6]
    a7 = rows[0, at + 7]
    a8 = rows[0, at + 8]
    a9 = rows[0, at + 9]
    a10 = rows[0, at + 10]
    a11 = rows[0, at + 11]
    a12 = rows[0, at + 12]
    a13 = rows[0, at + 13]
    b0 = rows[1, at + 0]
    b1 = rows[1, at + 1]
    b2 = rows[1, at + 2]
    b3 = rows[1, at + 3]
    b4 = rows[1, at + 4]
    b5 = rows[1, at + 5]
    b6 = rows[1, at + 6]
    b7 = rows[1, at + 7]
    b8 = rows[1, at + 8]
    b9 = rows[1, at + 9]
    b10 = rows[1, at + 10]
    b11 = rows[1, at + 11]
    b12 = rows[1, at + 12]
    b13 = rows[1, at + 13]
    c0 = rows[2, at + 0]
    c1 = rows[2, at + 1]
    c2 = rows[2, at + 2]
    c3 = rows[2, at + 3]
    c4 = rows[2, at + 4]
    c5 = rows[2, at + 5]
    c6 = rows[2, at + 6]
    c7 = rows[2, at + 7]
    c8 = rows[2, at + 8]
    c9 = rows[2, at + 9]
    c10 = rows[2, at + 10]
    c11 = rows[2, at + 11]
    c12 = rows[2, at + 12]
    c13 = rows[2, at + 13]
    for r in range(variable.size):
        x = variable[r]
        z = x*x
        v0[r] = v0[r]*other[r] + (((((((a1*z + a3)*z + a5)*z + a7)*z + a9)*z + a11)*z + a13) + x*((((((a0*z + a2)*z + a4)*z + a6)*z + a8)*z + a10)*z + a12))
        v1[r] = v1[r]*other[r] + (((((((b1*z + b3)*z + b5)*z + b7)*z + b9)*z + b11)*z + b13) + x*((((((b0*z + b2)*z + b4)*z + b6)*z + b8)*z + b10)*z + b12))
        v2[r] = v2[r]*other[r] + (((((((c1*z + c3)*z + c5)*z + c7)*z + c9)*z + c11)*z + c13) + x*((((((c0*z + c2)*z + c4)*z + c6)*z + c8)*z + c10)*z + c12))
