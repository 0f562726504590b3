"""From moments of contact stiffness or flexibility to the 6 x 6 stiffness, in floats or in exact fractions."""

from __future__ import annotations

from fractions import Fraction
from itertools import combinations_with_replacement
from typing import TYPE_CHECKING, Any

from granular.errors import TensorNotInvertible
from granular.notation import MANDEL_PAIRS, NORMAL_PAIRS, mandel_factor

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

FOURS = tuple(combinations_with_replacement(range(3), 4))
"""Indices of the fifteen moments of rank four, from 0, in the order of the emitted function."""

TWOS = tuple(combinations_with_replacement(range(3), 2))
"""Indices of the six moments of rank two, from 0."""


def symmetric_tensor(values: Any, rank: int) -> Any:
    """Fill a fully symmetric tensor from its different components.

    Parameters
    ----------
    values : sequence of 15 or 6 numbers
        Components in the order of ``FOURS`` or ``TWOS`` [any unit].
    rank : int
        4 or 2 [-].

    Returns
    -------
    (3, 3, 3, 3) or (3, 3) array
        The tensor [same unit]; of objects where the values are fractions.

    Notes
    -----
    Source: symmetry.

    Examples
    --------
    >>> symmetric_tensor([1.0, 2.0, 3.0, 4.0, 5.0, 6.0], 2).tolist()
    [[1.0, 2.0, 3.0], [2.0, 4.0, 5.0], [3.0, 5.0, 6.0]]
    """
    import numpy as np

    places = {indices: place for place, indices in enumerate(FOURS if rank == 4 else TWOS)}
    flat = [values[places[tuple(sorted(index))]] for index in np.ndindex(*(3,) * rank)]
    exact = isinstance(values[0], Fraction)
    return np.array(flat, dtype=object if exact else float).reshape((3,) * rank)


def stiffness_tensor(apart: Any, shear: Any) -> Any:
    """C_ijkl from the moments of k_n - k_r and of k_r.

    Parameters
    ----------
    apart : (3, 3, 3, 3) array
        Mean of E W^2 (k_n - k_r) n_i n_j n_k n_l [any one unit].
    shear : (3, 3) array
        Mean of E W^2 k_r n_i n_k [same unit].

    Returns
    -------
    (3, 3, 3, 3) array
        The stiffness over (M/V) l_e^2 [same unit], minor-symmetrised.

    Notes
    -----
    Source: eqs (1) and (2) with k_s = k_t; ``derivations.general_constant``.
    """
    return apart + _with_deltas(shear)


def compliance_tensor(apart: Any, shear: Any, inverse_fabric: Any) -> Any:
    """S_pjql from the moments of 1/k_n - 1/k_r and of 1/k_r.

    Parameters
    ----------
    apart : (3, 3, 3, 3) array
        Mean of E W^-2 (1/k_n - 1/k_r) n_i n_j n_k n_l [any one unit].
    shear : (3, 3) array
        Mean of E W^-2 n_i n_k/k_r [same unit].
    inverse_fabric : (3, 3) array
        A = N^-1 [-].

    Returns
    -------
    (3, 3, 3, 3) array
        The compliance times (M/V) l_e^2 [same unit], minor-symmetrised.

    Notes
    -----
    Source: Figure 1(b) with eq. (23): f_j = sigma_pj A_pk n_k.
    """
    import numpy as np

    identity = np.eye(3, dtype=int)
    raw = apart + np.einsum("ab,jl->ajbl", shear, identity)
    raw = np.einsum("pa,ajbl->pjbl", inverse_fabric, raw)
    raw = np.einsum("qb,pjbl->pjql", inverse_fabric, raw)
    half = raw + raw.transpose(1, 0, 2, 3)
    return (half + half.transpose(0, 1, 3, 2)) / 4


def _with_deltas(second: Any) -> Any:
    """Mean of delta_jl Q_ik over the exchange of indices inside each pair."""
    import numpy as np

    raw = np.einsum("ik,jl->ijkl", second, np.eye(3, dtype=int))
    half = raw + raw.transpose(1, 0, 2, 3)
    return (half + half.transpose(0, 1, 3, 2)) / 4


def mandel_of(tensor: Any) -> Array:
    """Mandel matrix of a fourth-rank tensor with minor and major symmetry.

    Parameters
    ----------
    tensor : (3, 3, 3, 3) array
        Components [any one unit], floats or fractions.

    Returns
    -------
    (6, 6) array
        The matrix, exactly symmetric, order 11, 22, 33, 23, 13, 12 [same unit].

    Notes
    -----
    Accuracy: one rounding of each component and one of its factor. Source: Mandel's notation.
    """
    import numpy as np

    matrix = np.empty((6, 6))
    for row, (i, j) in enumerate(MANDEL_PAIRS):
        for column, (k, m) in enumerate(MANDEL_PAIRS[:row + 1]):
            matrix[row, column] = matrix[column, row] = (float(tensor[i - 1, j - 1, k - 1, m - 1])
                                                         * mandel_factor(row, column))
    return matrix


def inverted(compliance: Any) -> Array:
    """Mandel matrix of the stiffness from the compliance tensor.

    Parameters
    ----------
    compliance : (3, 3, 3, 3) array
        S_ijkl with minor and major symmetry [any one unit], floats or fractions.

    Returns
    -------
    (6, 6) array
        Stiffness [inverse unit].

    Raises
    ------
    TensorNotInvertible
        The compliance is singular.

    Notes
    -----
    Accuracy: exact up to the last rounding for fractions, the condition number times 1e-16 for floats.
    Source: in Voigt's notation with engineering strains inverse tensors have inverse matrices, too.
    """
    import numpy as np

    if compliance.dtype != object:
        found = np.linalg.inv(mandel_of(compliance))
        return np.asarray((found + found.T) / 2, dtype=np.float64)
    pairs = [(i - 1, j - 1) for i, j in MANDEL_PAIRS]
    factors = [1] * NORMAL_PAIRS + [2] * (6 - NORMAL_PAIRS)
    rows = [[compliance[i, j, k, m] * f * g for (k, m), g in zip(pairs, factors, strict=True)]
            for (i, j), f in zip(pairs, factors, strict=True)]
    voigt = _exact_inverse(rows)
    matrix = np.empty((6, 6))
    for row in range(6):
        for column in range(6):
            matrix[row, column] = float(voigt[row][column]) * mandel_factor(row, column)
    return matrix


def _exact_inverse(rows: list[list[Fraction]]) -> list[list[Fraction]]:
    """Gauss and Jordan in fractions."""
    size = len(rows)
    table = [list(row) + [Fraction(int(r == c)) for c in range(size)] for r, row in enumerate(rows)]
    for column in range(size):
        pivot = next((r for r in range(column, size) if table[r][column] != 0), None)
        if pivot is None:
            raise TensorNotInvertible("compliance that is singular", allowed="needed: no zero eigenvalue",
                                      remedy="Check that every kind of stress meets a compliance above zero.")
        table[column], table[pivot] = table[pivot], table[column]
        scale = table[column][column]
        table[column] = [value / scale for value in table[column]]
        for r in range(size):
            if r != column and (factor := table[r][column]) != 0:
                table[r] = [value - factor * other for value, other in zip(table[r], table[column], strict=True)]
    return [row[size:] for row in table]
