"""Rows of polynomials in two variables for the elements of a panel: loops over elements, to be compiled.

Emitted by ``derivations write``; do not edit. Even and odd powers are summed apart, each by Horner's rule in the square
of the variable.
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from granular.generated.rows import aligned_frame

Array: TypeAlias = npt.NDArray[np.float64]


def set_row_11(rows: Array, one: int, k: int, at: int, variable: Array, middle: float, narrowness: float, columns: Array, spacing: int) -> None:
    """Set three values of each element to polynomials.

    Parameters
    ----------
    rows : (panels, 6, terms) array [-]
        Coefficients of polynomials, highest power first.
    one : int
        The panel.
    k : int
        The first of the three polynomials.
    at : int
        Place of the first coefficient that is used, of 11 in turn.
    variable : (n,) array [-]
        Variable of the polynomials.
    middle, narrowness : float [-]
        What is taken from the variable first, and what it is multiplied by then.
    columns : (6 spacing,) array [-]
        Values, of which the first n of three columns are set.
    spacing : int
        Numbers from one column to the next.

    Operations: 63.
    """
    aligned_frame()
    a0 = rows[one, k + 0, at + 0]
    a1 = rows[one, k + 0, at + 1]
    a2 = rows[one, k + 0, at + 2]
    a3 = rows[one, k + 0, at + 3]
    a4 = rows[one, k + 0, at + 4]
    a5 = rows[one, k + 0, at + 5]
    a6 = rows[one, k + 0, at + 6]
    a7 = rows[one, k + 0, at + 7]
    a8 = rows[one, k + 0, at + 8]
    a9 = rows[one, k + 0, at + 9]
    a10 = rows[one, k + 0, at + 10]
    b0 = rows[one, k + 1, at + 0]
    b1 = rows[one, k + 1, at + 1]
    b2 = rows[one, k + 1, at + 2]
    b3 = rows[one, k + 1, at + 3]
    b4 = rows[one, k + 1, at + 4]
    b5 = rows[one, k + 1, at + 5]
    b6 = rows[one, k + 1, at + 6]
    b7 = rows[one, k + 1, at + 7]
    b8 = rows[one, k + 1, at + 8]
    b9 = rows[one, k + 1, at + 9]
    b10 = rows[one, k + 1, at + 10]
    c0 = rows[one, k + 2, at + 0]
    c1 = rows[one, k + 2, at + 1]
    c2 = rows[one, k + 2, at + 2]
    c3 = rows[one, k + 2, at + 3]
    c4 = rows[one, k + 2, at + 4]
    c5 = rows[one, k + 2, at + 5]
    c6 = rows[one, k + 2, at + 6]
    c7 = rows[one, k + 2, at + 7]
    c8 = rows[one, k + 2, at + 8]
    c9 = rows[one, k + 2, at + 9]
    c10 = rows[one, k + 2, at + 10]
    v0 = columns[spacing*(k + 0):spacing*(k + 0) + variable.size]
    v1 = columns[spacing*(k + 1):spacing*(k + 1) + variable.size]
    v2 = columns[spacing*(k + 2):spacing*(k + 2) + variable.size]
    for r in range(variable.size):
        x = (variable[r] - middle)*narrowness
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


def set_rows_4_4(rows: Array, one: int, k: int, at: int, variable: Array, other: Array, columns: Array, spacing: int) -> None:
    """Set three values of each element to polynomials, then multiply them by one variable and add another.

    Parameters
    ----------
    rows : (panels, 6, terms) array [-]
        Coefficients of polynomials, highest power first.
    one : int
        The panel.
    k : int
        The first of the three polynomials.
    at : int
        Place of the first coefficient that is used, of 4 and 4 in turn.
    variable : (n,) array [-]
        Variable of the polynomials.
    other : (n,) array [-]
        Factor of the values.
    columns : (6 spacing,) array [-]
        Values, of which the first n of three columns are set.
    spacing : int
        Numbers from one column to the next.

    Operations: 43.
    """
    aligned_frame()
    a0 = rows[one, k + 0, at + 0]
    a1 = rows[one, k + 0, at + 1]
    a2 = rows[one, k + 0, at + 2]
    a3 = rows[one, k + 0, at + 3]
    a4 = rows[one, k + 0, at + 4]
    a5 = rows[one, k + 0, at + 5]
    a6 = rows[one, k + 0, at + 6]
    a7 = rows[one, k + 0, at + 7]
    b0 = rows[one, k + 1, at + 0]
    b1 = rows[one, k + 1, at + 1]
    b2 = rows[one, k + 1, at + 2]
    b3 = rows[one, k + 1, at + 3]
    b4 = rows[one, k + 1, at + 4]
    b5 = rows[one, k + 1, at + 5]
    b6 = rows[one, k + 1, at + 6]
    b7 = rows[one, k + 1, at + 7]
    c0 = rows[one, k + 2, at + 0]
    c1 = rows[one, k + 2, at + 1]
    c2 = rows[one, k + 2, at + 2]
    c3 = rows[one, k + 2, at + 3]
    c4 = rows[one, k + 2, at + 4]
    c5 = rows[one, k + 2, at + 5]
    c6 = rows[one, k + 2, at + 6]
    c7 = rows[one, k + 2, at + 7]
    v0 = columns[spacing*(k + 0):spacing*(k + 0) + variable.size]
    v1 = columns[spacing*(k + 1):spacing*(k + 1) + variable.size]
    v2 = columns[spacing*(k + 2):spacing*(k + 2) + variable.size]
    for r in range(variable.size):
        x = variable[r]
        z = x*x
        y = other[r]
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
        value0 = (even0 + x*odd0)
        value1 = (even1 + x*odd1)
        value2 = (even2 + x*odd2)
        even0 = a5
        odd0 = a4
        even1 = b5
        odd1 = b4
        even2 = c5
        odd2 = c4
        even0 = even0*z + a7
        odd0 = odd0*z + a6
        even1 = even1*z + b7
        odd1 = odd1*z + b6
        even2 = even2*z + c7
        odd2 = odd2*z + c6
        v0[r] = value0*y + (even0 + x*odd0)
        v1[r] = value1*y + (even1 + x*odd1)
        v2[r] = value2*y + (even2 + x*odd2)


def add_rows_7_7(rows: Array, one: int, k: int, at: int, variable: Array, other: Array, columns: Array, spacing: int) -> None:
    """Multiply three values of each element by one variable, and add polynomials in turn in the other.

    Parameters
    ----------
    rows : (panels, 6, terms) array [-]
        Coefficients of polynomials, highest power first.
    one : int
        The panel.
    k : int
        The first of the three polynomials.
    at : int
        Place of the first coefficient that is used, of 7 and 7 in turn.
    variable : (n,) array [-]
        Variable of the polynomials.
    other : (n,) array [-]
        Factor of the values.
    columns : (6 spacing,) array [-]
        Values, of which the first n of three columns are changed in place.
    spacing : int
        Numbers from one column to the next.

    Operations: 85.
    """
    aligned_frame()
    a0 = rows[one, k + 0, at + 0]
    a1 = rows[one, k + 0, at + 1]
    a2 = rows[one, k + 0, at + 2]
    a3 = rows[one, k + 0, at + 3]
    a4 = rows[one, k + 0, at + 4]
    a5 = rows[one, k + 0, at + 5]
    a6 = rows[one, k + 0, at + 6]
    a7 = rows[one, k + 0, at + 7]
    a8 = rows[one, k + 0, at + 8]
    a9 = rows[one, k + 0, at + 9]
    a10 = rows[one, k + 0, at + 10]
    a11 = rows[one, k + 0, at + 11]
    a12 = rows[one, k + 0, at + 12]
    a13 = rows[one, k + 0, at + 13]
    b0 = rows[one, k + 1, at + 0]
    b1 = rows[one, k + 1, at + 1]
    b2 = rows[one, k + 1, at + 2]
    b3 = rows[one, k + 1, at + 3]
    b4 = rows[one, k + 1, at + 4]
    b5 = rows[one, k + 1, at + 5]
    b6 = rows[one, k + 1, at + 6]
    b7 = rows[one, k + 1, at + 7]
    b8 = rows[one, k + 1, at + 8]
    b9 = rows[one, k + 1, at + 9]
    b10 = rows[one, k + 1, at + 10]
    b11 = rows[one, k + 1, at + 11]
    b12 = rows[one, k + 1, at + 12]
    b13 = rows[one, k + 1, at + 13]
    c0 = rows[one, k + 2, at + 0]
    c1 = rows[one, k + 2, at + 1]
    c2 = rows[one, k + 2, at + 2]
    c3 = rows[one, k + 2, at + 3]
    c4 = rows[one, k + 2, at + 4]
    c5 = rows[one, k + 2, at + 5]
    c6 = rows[one, k + 2, at + 6]
    c7 = rows[one, k + 2, at + 7]
    c8 = rows[one, k + 2, at + 8]
    c9 = rows[one, k + 2, at + 9]
    c10 = rows[one, k + 2, at + 10]
    c11 = rows[one, k + 2, at + 11]
    c12 = rows[one, k + 2, at + 12]
    c13 = rows[one, k + 2, at + 13]
    v0 = columns[spacing*(k + 0):spacing*(k + 0) + variable.size]
    v1 = columns[spacing*(k + 1):spacing*(k + 1) + variable.size]
    v2 = columns[spacing*(k + 2):spacing*(k + 2) + variable.size]
    for r in range(variable.size):
        x = variable[r]
        z = x*x
        y = other[r]
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
        value0 = v0[r]*y + (even0 + x*odd0)
        value1 = v1[r]*y + (even1 + x*odd1)
        value2 = v2[r]*y + (even2 + x*odd2)
        even0 = a7
        even1 = b7
        even2 = c7
        even0 = even0*z + a9
        odd0 = a8
        even1 = even1*z + b9
        odd1 = b8
        even2 = even2*z + c9
        odd2 = c8
        even0 = even0*z + a11
        odd0 = odd0*z + a10
        even1 = even1*z + b11
        odd1 = odd1*z + b10
        even2 = even2*z + c11
        odd2 = odd2*z + c10
        even0 = even0*z + a13
        odd0 = odd0*z + a12
        even1 = even1*z + b13
        odd1 = odd1*z + b12
        even2 = even2*z + c13
        odd2 = odd2*z + c12
        v0[r] = value0*y + (even0 + x*odd0)
        v1[r] = value1*y + (even1 + x*odd1)
        v2[r] = value2*y + (even2 + x*odd2)


def add_rows_10_10(rows: Array, one: int, k: int, at: int, variable: Array, other: Array, columns: Array, spacing: int) -> None:
    """Multiply three values of each element by one variable, and add polynomials in turn in the other.

    Parameters
    ----------
    rows : (panels, 6, terms) array [-]
        Coefficients of polynomials, highest power first.
    one : int
        The panel.
    k : int
        The first of the three polynomials.
    at : int
        Place of the first coefficient that is used, of 10 and 10 in turn.
    variable : (n,) array [-]
        Variable of the polynomials.
    other : (n,) array [-]
        Factor of the values.
    columns : (6 spacing,) array [-]
        Values, of which the first n of three columns are changed in place.
    spacing : int
        Numbers from one column to the next.

    Operations: 121.
    """
    aligned_frame()
    a0 = rows[one, k + 0, at + 0]
    a1 = rows[one, k + 0, at + 1]
    a2 = rows[one, k + 0, at + 2]
    a3 = rows[one, k + 0, at + 3]
    a4 = rows[one, k + 0, at + 4]
    a5 = rows[one, k + 0, at + 5]
    a6 = rows[one, k + 0, at + 6]
    a7 = rows[one, k + 0, at + 7]
    a8 = rows[one, k + 0, at + 8]
    a9 = rows[one, k + 0, at + 9]
    a10 = rows[one, k + 0, at + 10]
    a11 = rows[one, k + 0, at + 11]
    a12 = rows[one, k + 0, at + 12]
    a13 = rows[one, k + 0, at + 13]
    a14 = rows[one, k + 0, at + 14]
    a15 = rows[one, k + 0, at + 15]
    a16 = rows[one, k + 0, at + 16]
    a17 = rows[one, k + 0, at + 17]
    a18 = rows[one, k + 0, at + 18]
    a19 = rows[one, k + 0, at + 19]
    b0 = rows[one, k + 1, at + 0]
    b1 = rows[one, k + 1, at + 1]
    b2 = rows[one, k + 1, at + 2]
    b3 = rows[one, k + 1, at + 3]
    b4 = rows[one, k + 1, at + 4]
    b5 = rows[one, k + 1, at + 5]
    b6 = rows[one, k + 1, at + 6]
    b7 = rows[one, k + 1, at + 7]
    b8 = rows[one, k + 1, at + 8]
    b9 = rows[one, k + 1, at + 9]
    b10 = rows[one, k + 1, at + 10]
    b11 = rows[one, k + 1, at + 11]
    b12 = rows[one, k + 1, at + 12]
    b13 = rows[one, k + 1, at + 13]
    b14 = rows[one, k + 1, at + 14]
    b15 = rows[one, k + 1, at + 15]
    b16 = rows[one, k + 1, at + 16]
    b17 = rows[one, k + 1, at + 17]
    b18 = rows[one, k + 1, at + 18]
    b19 = rows[one, k + 1, at + 19]
    c0 = rows[one, k + 2, at + 0]
    c1 = rows[one, k + 2, at + 1]
    c2 = rows[one, k + 2, at + 2]
    c3 = rows[one, k + 2, at + 3]
    c4 = rows[one, k + 2, at + 4]
    c5 = rows[one, k + 2, at + 5]
    c6 = rows[one, k + 2, at + 6]
    c7 = rows[one, k + 2, at + 7]
    c8 = rows[one, k + 2, at + 8]
    c9 = rows[one, k + 2, at + 9]
    c10 = rows[one, k + 2, at + 10]
    c11 = rows[one, k + 2, at + 11]
    c12 = rows[one, k + 2, at + 12]
    c13 = rows[one, k + 2, at + 13]
    c14 = rows[one, k + 2, at + 14]
    c15 = rows[one, k + 2, at + 15]
    c16 = rows[one, k + 2, at + 16]
    c17 = rows[one, k + 2, at + 17]
    c18 = rows[one, k + 2, at + 18]
    c19 = rows[one, k + 2, at + 19]
    v0 = columns[spacing*(k + 0):spacing*(k + 0) + variable.size]
    v1 = columns[spacing*(k + 1):spacing*(k + 1) + variable.size]
    v2 = columns[spacing*(k + 2):spacing*(k + 2) + variable.size]
    for r in range(variable.size):
        x = variable[r]
        z = x*x
        y = other[r]
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
        value0 = v0[r]*y + (even0 + x*odd0)
        value1 = v1[r]*y + (even1 + x*odd1)
        value2 = v2[r]*y + (even2 + x*odd2)
        even0 = a11
        odd0 = a10
        even1 = b11
        odd1 = b10
        even2 = c11
        odd2 = c10
        even0 = even0*z + a13
        odd0 = odd0*z + a12
        even1 = even1*z + b13
        odd1 = odd1*z + b12
        even2 = even2*z + c13
        odd2 = odd2*z + c12
        even0 = even0*z + a15
        odd0 = odd0*z + a14
        even1 = even1*z + b15
        odd1 = odd1*z + b14
        even2 = even2*z + c15
        odd2 = odd2*z + c14
        even0 = even0*z + a17
        odd0 = odd0*z + a16
        even1 = even1*z + b17
        odd1 = odd1*z + b16
        even2 = even2*z + c17
        odd2 = odd2*z + c16
        even0 = even0*z + a19
        odd0 = odd0*z + a18
        even1 = even1*z + b19
        odd1 = odd1*z + b18
        even2 = even2*z + c19
        odd2 = odd2*z + c18
        v0[r] = value0*y + (even0 + x*odd0)
        v1[r] = value1*y + (even1 + x*odd1)
        v2[r] = value2*y + (even2 + x*odd2)


def add_rows_11_11(rows: Array, one: int, k: int, at: int, variable: Array, other: Array, columns: Array, spacing: int) -> None:
    """Multiply three values of each element by one variable, and add polynomials in turn in the other.

    Parameters
    ----------
    rows : (panels, 6, terms) array [-]
        Coefficients of polynomials, highest power first.
    one : int
        The panel.
    k : int
        The first of the three polynomials.
    at : int
        Place of the first coefficient that is used, of 11 and 11 in turn.
    variable : (n,) array [-]
        Variable of the polynomials.
    other : (n,) array [-]
        Factor of the values.
    columns : (6 spacing,) array [-]
        Values, of which the first n of three columns are changed in place.
    spacing : int
        Numbers from one column to the next.

    Operations: 133.
    """
    aligned_frame()
    a0 = rows[one, k + 0, at + 0]
    a1 = rows[one, k + 0, at + 1]
    a2 = rows[one, k + 0, at + 2]
    a3 = rows[one, k + 0, at + 3]
    a4 = rows[one, k + 0, at + 4]
    a5 = rows[one, k + 0, at + 5]
    a6 = rows[one, k + 0, at + 6]
    a7 = rows[one, k + 0, at + 7]
    a8 = rows[one, k + 0, at + 8]
    a9 = rows[one, k + 0, at + 9]
    a10 = rows[one, k + 0, at + 10]
    a11 = rows[one, k + 0, at + 11]
    a12 = rows[one, k + 0, at + 12]
    a13 = rows[one, k + 0, at + 13]
    a14 = rows[one, k + 0, at + 14]
    a15 = rows[one, k + 0, at + 15]
    a16 = rows[one, k + 0, at + 16]
    a17 = rows[one, k + 0, at + 17]
    a18 = rows[one, k + 0, at + 18]
    a19 = rows[one, k + 0, at + 19]
    a20 = rows[one, k + 0, at + 20]
    a21 = rows[one, k + 0, at + 21]
    b0 = rows[one, k + 1, at + 0]
    b1 = rows[one, k + 1, at + 1]
    b2 = rows[one, k + 1, at + 2]
    b3 = rows[one, k + 1, at + 3]
    b4 = rows[one, k + 1, at + 4]
    b5 = rows[one, k + 1, at + 5]
    b6 = rows[one, k + 1, at + 6]
    b7 = rows[one, k + 1, at + 7]
    b8 = rows[one, k + 1, at + 8]
    b9 = rows[one, k + 1, at + 9]
    b10 = rows[one, k + 1, at + 10]
    b11 = rows[one, k + 1, at + 11]
    b12 = rows[one, k + 1, at + 12]
    b13 = rows[one, k + 1, at + 13]
    b14 = rows[one, k + 1, at + 14]
    b15 = rows[one, k + 1, at + 15]
    b16 = rows[one, k + 1, at + 16]
    b17 = rows[one, k + 1, at + 17]
    b18 = rows[one, k + 1, at + 18]
    b19 = rows[one, k + 1, at + 19]
    b20 = rows[one, k + 1, at + 20]
    b21 = rows[one, k + 1, at + 21]
    c0 = rows[one, k + 2, at + 0]
    c1 = rows[one, k + 2, at + 1]
    c2 = rows[one, k + 2, at + 2]
    c3 = rows[one, k + 2, at + 3]
    c4 = rows[one, k + 2, at + 4]
    c5 = rows[one, k + 2, at + 5]
    c6 = rows[one, k + 2, at + 6]
    c7 = rows[one, k + 2, at + 7]
    c8 = rows[one, k + 2, at + 8]
    c9 = rows[one, k + 2, at + 9]
    c10 = rows[one, k + 2, at + 10]
    c11 = rows[one, k + 2, at + 11]
    c12 = rows[one, k + 2, at + 12]
    c13 = rows[one, k + 2, at + 13]
    c14 = rows[one, k + 2, at + 14]
    c15 = rows[one, k + 2, at + 15]
    c16 = rows[one, k + 2, at + 16]
    c17 = rows[one, k + 2, at + 17]
    c18 = rows[one, k + 2, at + 18]
    c19 = rows[one, k + 2, at + 19]
    c20 = rows[one, k + 2, at + 20]
    c21 = rows[one, k + 2, at + 21]
    v0 = columns[spacing*(k + 0):spacing*(k + 0) + variable.size]
    v1 = columns[spacing*(k + 1):spacing*(k + 1) + variable.size]
    v2 = columns[spacing*(k + 2):spacing*(k + 2) + variable.size]
    for r in range(variable.size):
        x = variable[r]
        z = x*x
        y = other[r]
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
        value0 = v0[r]*y + (even0 + x*odd0)
        value1 = v1[r]*y + (even1 + x*odd1)
        value2 = v2[r]*y + (even2 + x*odd2)
        even0 = a11
        even1 = b11
        even2 = c11
        even0 = even0*z + a13
        odd0 = a12
        even1 = even1*z + b13
        odd1 = b12
        even2 = even2*z + c13
        odd2 = c12
        even0 = even0*z + a15
        odd0 = odd0*z + a14
        even1 = even1*z + b15
        odd1 = odd1*z + b14
        even2 = even2*z + c15
        odd2 = odd2*z + c14
        even0 = even0*z + a17
        odd0 = odd0*z + a16
        even1 = even1*z + b17
        odd1 = odd1*z + b16
        even2 = even2*z + c17
        odd2 = odd2*z + c16
        even0 = even0*z + a19
        odd0 = odd0*z + a18
        even1 = even1*z + b19
        odd1 = odd1*z + b18
        even2 = even2*z + c19
        odd2 = odd2*z + c18
        even0 = even0*z + a21
        odd0 = odd0*z + a20
        even1 = even1*z + b21
        odd1 = odd1*z + b20
        even2 = even2*z + c21
        odd2 = odd2*z + c20
        v0[r] = value0*y + (even0 + x*odd0)
        v1[r] = value1*y + (even1 + x*odd1)
        v2[r] = value2*y + (even2 + x*odd2)


def add_rows_12_13(rows: Array, one: int, k: int, at: int, variable: Array, other: Array, columns: Array, spacing: int) -> None:
    """Multiply three values of each element by one variable, and add polynomials in turn in the other.

    Parameters
    ----------
    rows : (panels, 6, terms) array [-]
        Coefficients of polynomials, highest power first.
    one : int
        The panel.
    k : int
        The first of the three polynomials.
    at : int
        Place of the first coefficient that is used, of 12 and 13 in turn.
    variable : (n,) array [-]
        Variable of the polynomials.
    other : (n,) array [-]
        Factor of the values.
    columns : (6 spacing,) array [-]
        Values, of which the first n of three columns are changed in place.
    spacing : int
        Numbers from one column to the next.

    Operations: 151.
    """
    aligned_frame()
    a0 = rows[one, k + 0, at + 0]
    a1 = rows[one, k + 0, at + 1]
    a2 = rows[one, k + 0, at + 2]
    a3 = rows[one, k + 0, at + 3]
    a4 = rows[one, k + 0, at + 4]
    a5 = rows[one, k + 0, at + 5]
    a6 = rows[one, k + 0, at + 6]
    a7 = rows[one, k + 0, at + 7]
    a8 = rows[one, k + 0, at + 8]
    a9 = rows[one, k + 0, at + 9]
    a10 = rows[one, k + 0, at + 10]
    a11 = rows[one, k + 0, at + 11]
    a12 = rows[one, k + 0, at + 12]
    a13 = rows[one, k + 0, at + 13]
    a14 = rows[one, k + 0, at + 14]
    a15 = rows[one, k + 0, at + 15]
    a16 = rows[one, k + 0, at + 16]
    a17 = rows[one, k + 0, at + 17]
    a18 = rows[one, k + 0, at + 18]
    a19 = rows[one, k + 0, at + 19]
    a20 = rows[one, k + 0, at + 20]
    a21 = rows[one, k + 0, at + 21]
    a22 = rows[one, k + 0, at + 22]
    a23 = rows[one, k + 0, at + 23]
    a24 = rows[one, k + 0, at + 24]
    b0 = rows[one, k + 1, at + 0]
    b1 = rows[one, k + 1, at + 1]
    b2 = rows[one, k + 1, at + 2]
    b3 = rows[one, k + 1, at + 3]
    b4 = rows[one, k + 1, at + 4]
    b5 = rows[one, k + 1, at + 5]
    b6 = rows[one, k + 1, at + 6]
    b7 = rows[one, k + 1, at + 7]
    b8 = rows[one, k + 1, at + 8]
    b9 = rows[one, k + 1, at + 9]
    b10 = rows[one, k + 1, at + 10]
    b11 = rows[one, k + 1, at + 11]
    b12 = rows[one, k + 1, at + 12]
    b13 = rows[one, k + 1, at + 13]
    b14 = rows[one, k + 1, at + 14]
    b15 = rows[one, k + 1, at + 15]
    b16 = rows[one, k + 1, at + 16]
    b17 = rows[one, k + 1, at + 17]
    b18 = rows[one, k + 1, at + 18]
    b19 = rows[one, k + 1, at + 19]
    b20 = rows[one, k + 1, at + 20]
    b21 = rows[one, k + 1, at + 21]
    b22 = rows[one, k + 1, at + 22]
    b23 = rows[one, k + 1, at + 23]
    b24 = rows[one, k + 1, at + 24]
    c0 = rows[one, k + 2, at + 0]
    c1 = rows[one, k + 2, at + 1]
    c2 = rows[one, k + 2, at + 2]
    c3 = rows[one, k + 2, at + 3]
    c4 = rows[one, k + 2, at + 4]
    c5 = rows[one, k + 2, at + 5]
    c6 = rows[one, k + 2, at + 6]
    c7 = rows[one, k + 2, at + 7]
    c8 = rows[one, k + 2, at + 8]
    c9 = rows[one, k + 2, at + 9]
    c10 = rows[one, k + 2, at + 10]
    c11 = rows[one, k + 2, at + 11]
    c12 = rows[one, k + 2, at + 12]
    c13 = rows[one, k + 2, at + 13]
    c14 = rows[one, k + 2, at + 14]
    c15 = rows[one, k + 2, at + 15]
    c16 = rows[one, k + 2, at + 16]
    c17 = rows[one, k + 2, at + 17]
    c18 = rows[one, k + 2, at + 18]
    c19 = rows[one, k + 2, at + 19]
    c20 = rows[one, k + 2, at + 20]
    c21 = rows[one, k + 2, at + 21]
    c22 = rows[one, k + 2, at + 22]
    c23 = rows[one, k + 2, at + 23]
    c24 = rows[one, k + 2, at + 24]
    v0 = columns[spacing*(k + 0):spacing*(k + 0) + variable.size]
    v1 = columns[spacing*(k + 1):spacing*(k + 1) + variable.size]
    v2 = columns[spacing*(k + 2):spacing*(k + 2) + variable.size]
    for r in range(variable.size):
        x = variable[r]
        z = x*x
        y = other[r]
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
        value0 = v0[r]*y + (even0 + x*odd0)
        value1 = v1[r]*y + (even1 + x*odd1)
        value2 = v2[r]*y + (even2 + x*odd2)
        even0 = a12
        even1 = b12
        even2 = c12
        even0 = even0*z + a14
        odd0 = a13
        even1 = even1*z + b14
        odd1 = b13
        even2 = even2*z + c14
        odd2 = c13
        even0 = even0*z + a16
        odd0 = odd0*z + a15
        even1 = even1*z + b16
        odd1 = odd1*z + b15
        even2 = even2*z + c16
        odd2 = odd2*z + c15
        even0 = even0*z + a18
        odd0 = odd0*z + a17
        even1 = even1*z + b18
        odd1 = odd1*z + b17
        even2 = even2*z + c18
        odd2 = odd2*z + c17
        even0 = even0*z + a20
        odd0 = odd0*z + a19
        even1 = even1*z + b20
        odd1 = odd1*z + b19
        even2 = even2*z + c20
        odd2 = odd2*z + c19
        even0 = even0*z + a22
        odd0 = odd0*z + a21
        even1 = even1*z + b22
        odd1 = odd1*z + b21
        even2 = even2*z + c22
        odd2 = odd2*z + c21
        even0 = even0*z + a24
        odd0 = odd0*z + a23
        even1 = even1*z + b24
        odd1 = odd1*z + b23
        even2 = even2*z + c24
        odd2 = odd2*z + c23
        v0[r] = value0*y + (even0 + x*odd0)
        v1[r] = value1*y + (even1 + x*odd1)
        v2[r] = value2*y + (even2 + x*odd2)


def add_row_13(rows: Array, one: int, k: int, at: int, variable: Array, other: Array, columns: Array, spacing: int) -> None:
    """Multiply three values of each element by one variable, and add a polynomial in the other.

    Parameters
    ----------
    rows : (panels, 6, terms) array [-]
        Coefficients of polynomials, highest power first.
    one : int
        The panel.
    k : int
        The first of the three polynomials.
    at : int
        Place of the first coefficient that is used, of 13 in turn.
    variable : (n,) array [-]
        Variable of the polynomials.
    other : (n,) array [-]
        Factor of the values.
    columns : (6 spacing,) array [-]
        Values, of which the first n of three columns are changed in place.
    spacing : int
        Numbers from one column to the next.

    Operations: 79.
    """
    aligned_frame()
    a0 = rows[one, k + 0, at + 0]
    a1 = rows[one, k + 0, at + 1]
    a2 = rows[one, k + 0, at + 2]
    a3 = rows[one, k + 0, at + 3]
    a4 = rows[one, k + 0, at + 4]
    a5 = rows[one, k + 0, at + 5]
    a6 = rows[one, k + 0, at + 6]
    a7 = rows[one, k + 0, at + 7]
    a8 = rows[one, k + 0, at + 8]
    a9 = rows[one, k + 0, at + 9]
    a10 = rows[one, k + 0, at + 10]
    a11 = rows[one, k + 0, at + 11]
    a12 = rows[one, k + 0, at + 12]
    b0 = rows[one, k + 1, at + 0]
    b1 = rows[one, k + 1, at + 1]
    b2 = rows[one, k + 1, at + 2]
    b3 = rows[one, k + 1, at + 3]
    b4 = rows[one, k + 1, at + 4]
    b5 = rows[one, k + 1, at + 5]
    b6 = rows[one, k + 1, at + 6]
    b7 = rows[one, k + 1, at + 7]
    b8 = rows[one, k + 1, at + 8]
    b9 = rows[one, k + 1, at + 9]
    b10 = rows[one, k + 1, at + 10]
    b11 = rows[one, k + 1, at + 11]
    b12 = rows[one, k + 1, at + 12]
    c0 = rows[one, k + 2, at + 0]
    c1 = rows[one, k + 2, at + 1]
    c2 = rows[one, k + 2, at + 2]
    c3 = rows[one, k + 2, at + 3]
    c4 = rows[one, k + 2, at + 4]
    c5 = rows[one, k + 2, at + 5]
    c6 = rows[one, k + 2, at + 6]
    c7 = rows[one, k + 2, at + 7]
    c8 = rows[one, k + 2, at + 8]
    c9 = rows[one, k + 2, at + 9]
    c10 = rows[one, k + 2, at + 10]
    c11 = rows[one, k + 2, at + 11]
    c12 = rows[one, k + 2, at + 12]
    v0 = columns[spacing*(k + 0):spacing*(k + 0) + variable.size]
    v1 = columns[spacing*(k + 1):spacing*(k + 1) + variable.size]
    v2 = columns[spacing*(k + 2):spacing*(k + 2) + variable.size]
    for r in range(variable.size):
        x = variable[r]
        z = x*x
        y = other[r]
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
        v0[r] = v0[r]*y + (even0 + x*odd0)
        v1[r] = v1[r]*y + (even1 + x*odd1)
        v2[r] = v2[r]*y + (even2 + x*odd2)
