"""Mandel matrices as tuples of floats: checking, transverse isotropy, inversion and rotation.

A transversely isotropic matrix is inverted in exact rational arithmetic and rounded once: nothing overflows
on the way, a nearly singular one costs no digit, and NumPy is not needed. Every other matrix goes to NumPy.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from fractions import Fraction
from typing import TYPE_CHECKING, SupportsFloat

from granular.errors import DirectionNotValid, TensorNotElastic, TensorNotInvertible
from granular.notation import MANDEL_PAIRS, NORMAL_PAIRS

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

Six = tuple[float, float, float, float, float, float]
Rows = tuple[Six, Six, Six, Six, Six, Six]
Matrix = Iterable[Iterable[SupportsFloat]]

ROUNDING = 2.0**-40
"""Relative size below which a broken symmetry is taken for rounding: some 4000 units in the last place."""


def number(value: SupportsFloat, name: str) -> float:
    """Accept one finite number, and no text that looks like one.

    Parameters
    ----------
    value : number
        What is given [any unit].
    name : str
        What it is, for the message.

    Returns
    -------
    float
        The same number [same unit].

    Raises
    ------
    TensorNotElastic
        Not a number, or not finite.

    Notes
    -----
    Source: every formula here is a rational function of finite numbers.

    Examples
    --------
    >>> number(2, "C1111")
    2.0
    """
    try:
        plain = math.nan if isinstance(value, (str, bytes)) else float(value)
    except (TypeError, ValueError, OverflowError):
        plain = math.nan
    if not math.isfinite(plain):
        raise TensorNotElastic(f"{name} = {value!r}", allowed="needed: a finite number",
                               remedy=f"Give {name} as a finite number.")
    return plain


def symmetric_rows(matrix: Matrix, meaning: str) -> Rows:
    """Turn 36 numbers into checked, exactly symmetric rows.

    Parameters
    ----------
    matrix : (6, 6) numbers
        Mandel matrix [any unit].
    meaning : str
        ``"stiffness"`` or ``"compliance"``, for the message.

    Returns
    -------
    tuple of 6 tuples of 6 float
        The rows; differences across the diagonal within ``ROUNDING`` of the largest entry are averaged away.

    Raises
    ------
    TensorNotElastic
        A wrong shape, a value that is not a finite number, or a matrix that is not symmetric.

    Notes
    -----
    Source: a stored energy makes the matrix symmetric.
    """
    table = [list(row) if isinstance(row, Iterable) else [] for row in matrix]
    if [len(row) for row in table] != [6] * 6:
        raise TensorNotElastic(f"{meaning} with rows of {[len(row) for row in table]} numbers",
                               allowed="needed: 6 rows of 6", remedy="Give a 6x6 matrix.")
    plain = [[number(value, f"entry ({p + 1}, {q + 1}) of the {meaning}") for q, value in enumerate(row)]
             for p, row in enumerate(table)]
    slack = ROUNDING * max(abs(value) for row in plain for value in row)
    for p in range(6):
        for q in range(p):
            below, above = plain[p][q], plain[q][p]
            if abs(below - above) > slack:
                raise TensorNotElastic(
                    f"{meaning} with {below!r} at ({p + 1}, {q + 1}) and {above!r} at ({q + 1}, {p + 1})",
                    allowed="needed: the same number on both sides of the diagonal",
                    remedy="Average the two first if both were measured.")
            plain[p][q] = plain[q][p] = below if below == above else below / 2 + above / 2
    one, two, three, four, five, six = (_six(row) for row in plain)
    return one, two, three, four, five, six


def axial_rows(six: Six) -> Rows:
    """Mandel rows of a tensor that is transversely isotropic about axis 3.

    Parameters
    ----------
    six : tuple of 6 float
        X1111, X3333, X1122, X1133, X2323, X1212 [any unit].

    Returns
    -------
    tuple of 6 tuples of 6 float
        The rows [same unit].

    Notes
    -----
    Source: invariance of X_ijkl under rotation about axis 3.
    """
    x1111, x3333, x1122, x1133, x2323, x1212 = six
    return ((x1111, x1122, x1133, 0.0, 0.0, 0.0), (x1122, x1111, x1133, 0.0, 0.0, 0.0),
            (x1133, x1133, x3333, 0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 2 * x2323, 0.0, 0.0),
            (0.0, 0.0, 0.0, 0.0, 2 * x2323, 0.0), (0.0, 0.0, 0.0, 0.0, 0.0, 2 * x1212))


def six_of(rows: Rows) -> Six:
    """Read X1111, X3333, X1122, X1133, X2323, X1212 from Mandel rows.

    Parameters
    ----------
    rows : tuple of 6 tuples of 6 float
        Mandel matrix [any unit].

    Returns
    -------
    tuple of 6 float
        The components [same unit].

    Notes
    -----
    Source: Mandel's notation.
    """
    return rows[0][0], rows[2][2], rows[0][1], rows[0][2], rows[3][3] / 2, rows[5][5] / 2


def size_of(values: Iterable[float]) -> float:
    """Power of two next above the largest size, to divide by before products that could overflow or vanish.

    Parameters
    ----------
    values : floats
        Not all zero [any unit].

    Returns
    -------
    float
        A power of two [same unit]: dividing by it costs no digit.

    Notes
    -----
    Source: IEEE 754 arithmetic.

    Examples
    --------
    >>> size_of((3.0, -5.0))
    8.0
    """
    return math.ldexp(1.0, min(math.frexp(max(map(abs, values)))[1], 1023))


def is_axial(rows: Rows) -> bool:
    """Tell whether all 36 entries follow from six, to rounding.

    Parameters
    ----------
    rows : tuple of 6 tuples of 6 float
        Mandel matrix [any unit].

    Returns
    -------
    bool
        True when axis 3 is an axis of full rotational symmetry.

    Notes
    -----
    Source: X1212 = (X1111 - X1122)/2 and the zeros of ``axial_rows``.
    """
    six = six_of(rows)
    slack = ROUNDING * max(abs(value) for row in rows for value in row)
    return (abs(six[0] - six[2] - 2 * six[5]) <= slack
            and all(abs(mine - axial) <= slack for row, other in zip(rows, axial_rows(six), strict=True)
                    for mine, axial in zip(row, other, strict=True)))


def built_from_six(rows: Rows) -> bool:
    """Tell whether the entries follow from six exactly, so that the closed forms give the last digit.

    Parameters
    ----------
    rows : tuple of 6 tuples of 6 float
        Mandel matrix [any unit].

    Returns
    -------
    bool
        True for what ``axial_rows`` builds; a solid turned about axis 3 differs by its rounding.

    Notes
    -----
    Source: ``axial_rows``.
    """
    return rows == axial_rows(six_of(rows)) and is_axial(rows)


def axial_is_positive(six: Six) -> bool:
    """Decide positive definiteness of a transversely isotropic tensor, exactly for the six numbers given.

    Parameters
    ----------
    six : tuple of 6 float
        X1111, X3333, X1122, X1133, X2323, X1212 [any unit].

    Returns
    -------
    bool
        True when X2323 > 0, X1212 > 0, X3333 > 0 and (X1111 + X1122) X3333 > 2 X1133^2.

    Notes
    -----
    Source: eigenvalues of ``axial_rows``; X1111 > X1122 is X1212 > 0.
    """
    x1111, x3333, x1122, x1133, x2323, x1212 = map(Fraction, six)
    return min(x2323, x1212, x3333) > 0 and (x1111 + x1122) * x3333 > 2 * x1133**2


def axial_inverse(six: Six, meaning: str) -> Six:
    """Invert a transversely isotropic tensor: one 2x2 block and three reciprocals, exactly, then rounded.

    Parameters
    ----------
    six : tuple of 6 float
        X1111, X3333, X1122, X1133, X2323, X1212 [any unit].
    meaning : str
        ``"stiffness"`` or ``"compliance"``, for the message.

    Returns
    -------
    tuple of 6 float
        The same components of the inverse tensor [inverse unit].

    Raises
    ------
    TensorNotInvertible
        The tensor is singular, or its inverse does not fit a float.

    Notes
    -----
    Accuracy: each number is the exact inverse of the six given, rounded once (with X1212 taken for
    (X1111 - X1122)/2, which is known to fewer digits when shear is soft).
    Source: Y1111 + Y1122 = X3333/d, Y3333 = (X1111 + X1122)/d, Y1133 = -X1133/d with
    d = (X1111 + X1122) X3333 - 2 X1133^2, and Y1111 - Y1122 = 1/(2 X1212).
    """
    x1111, x3333, x1122, x1133, x2323, x1212 = map(Fraction, six)
    in_plane = x1111 + x1122
    determinant = in_plane * x3333 - 2 * x1133**2
    if 0 in (determinant, x2323, x1212):
        raise singular(meaning)
    total, difference = x3333 / determinant, 1 / (2 * x1212)
    inverse = ((total + difference) / 2, in_plane / determinant, (total - difference) / 2,
               -x1133 / determinant, 1 / (4 * x2323), 1 / (4 * x1212))
    try:
        return _six(map(float, inverse))
    except OverflowError:
        raise singular(meaning) from None


def general_inverse(rows: Rows, meaning: str) -> Rows:
    """Invert any Mandel matrix.

    Parameters
    ----------
    rows : tuple of 6 tuples of 6 float
        Mandel matrix [any unit].
    meaning : str
        ``"stiffness"`` or ``"compliance"``, for the message.

    Returns
    -------
    tuple of 6 tuples of 6 float
        The inverse [inverse unit].

    Raises
    ------
    TensorNotInvertible
        The least eigenvalue is within 6 units of rounding of zero.

    Notes
    -----
    Accuracy: the condition number times 1e-16.
    Source: LAPACK's LU factors by NumPy.
    """
    import numpy as np

    matrix = np.array(rows)
    sizes = np.abs(np.linalg.eigvalsh(matrix))
    if not sizes.min() > 6 * np.finfo(float).eps * sizes.max():
        raise singular(meaning)
    inverse = np.linalg.inv(matrix)
    return symmetric_rows(((inverse + inverse.T) / 2).tolist(), meaning)


def turned(rows: Rows, rotation: ArrayLike, meaning: str) -> Rows:
    """Turn a tensor: X'_ijkl = R_ia R_jb R_kc R_ld X_abcd.

    Parameters
    ----------
    rows : tuple of 6 tuples of 6 float
        Mandel matrix [any unit].
    rotation : (3, 3) array
        Orthogonal matrix R [-].
    meaning : str
        ``"stiffness"`` or ``"compliance"``, for the message.

    Returns
    -------
    tuple of 6 tuples of 6 float
        The turned matrix [same unit].

    Raises
    ------
    DirectionNotValid
        R is not a 3x3 orthogonal matrix to ``ROUNDING``.

    Notes
    -----
    Source: in Mandel notation the turn is one orthogonal 6x6 matrix on either side.
    """
    import numpy as np

    turn = np.asarray(rotation, dtype=float)
    off = np.abs(turn @ turn.T - np.eye(3)).max() if turn.shape == (3, 3) else math.inf
    if not off <= ROUNDING:
        raise DirectionNotValid(f"rotation of shape {turn.shape} with |R R^T - 1| = {off:.3g}",
                                allowed="needed: an orthogonal 3x3 matrix",
                                remedy="Give three orthogonal unit vectors as its columns.")
    six = _six_by_six(turn)
    product = six @ np.array(rows) @ six.T
    return symmetric_rows(((product + product.T) / 2).tolist(), meaning)


def singular(meaning: str) -> TensorNotInvertible:
    """Make the refusal of a singular tensor.

    Parameters
    ----------
    meaning : str
        ``"stiffness"`` or ``"compliance"``.

    Returns
    -------
    TensorNotInvertible
        The error, to be raised.

    Notes
    -----
    Source: a strain without stress has no inverse.
    """
    return TensorNotInvertible(f"{meaning} that is singular", allowed="needed: no zero eigenvalue",
                               remedy="Check that every kind of strain meets a stiffness above zero.")


def _six_by_six(turn: NDArray[np.float64]) -> NDArray[np.float64]:
    """Mandel matrix of the turn of a symmetric 3x3 tensor."""
    import numpy as np

    first = np.array([i - 1 for i, _ in MANDEL_PAIRS])
    second = np.array([j - 1 for _, j in MANDEL_PAIRS])
    straight = turn[np.ix_(first, first)] * turn[np.ix_(second, second)]
    crossed = turn[np.ix_(first, second)] * turn[np.ix_(second, first)]
    weight = np.where(np.arange(6) < NORMAL_PAIRS, 1.0, math.sqrt(2.0))
    pairs: NDArray[np.float64] = (straight + crossed) / 2 * np.outer(weight, weight)
    return pairs


def _six(values: Iterable[float]) -> Six:
    one, two, three, four, five, six = values
    return one, two, three, four, five, six
