"""Branches across the boundaries of a periodic cell, where a program wrote both centres inside it."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from granular.errors import ContactImpossible, ValueOutOfRange

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]


def periods(cell: Sequence[float]) -> Array:
    """Check the edges of a periodic cell.

    Parameters
    ----------
    cell : sequence of 3 float
        Edges along the axes [m], 0 where there is no period.

    Returns
    -------
    (3, 1) array
        The periods [m], infinite where there is none.

    Raises
    ------
    ValueOutOfRange
        An edge that is negative or not finite, or no period at all.

    Notes
    -----
    Source: a rectangular cell.

    Examples
    --------
    >>> periods((0.02, 0.02, 0)).ravel().tolist()
    [0.02, 0.02, inf]
    """
    import numpy as np

    edges = [float(edge) for edge in cell]
    if len(edges) != 3 or not all(edge >= 0 and math.isfinite(edge) for edge in edges) or not any(edges):
        raise ValueOutOfRange(f"cell = {' '.join(f'{edge:g}' for edge in edges)}",
                              allowed="allowed three edges >= 0, not all 0", remedy="Give the edges of the periodic "
                              "cell in m, 0 along an axis without period, such as --cell 0.02 0.02 0.")
    return np.array([[edge or math.inf] for edge in edges])


def across_periods(branch: Array, cell: Array, *, numbers: NDArray[np.int64], place_of: Callable[[int], str]) -> Array:
    """Make each branch the shortest that the periods allow.

    Parameters
    ----------
    branch : (3, n) array
        Differences of centres, both inside the cell [m].
    cell : (3, 1) array
        The periods [m].
    numbers : (n,) array of int
        Number of each contact in the list, from 1 [-].
    place_of : callable
        Number of a contact -> where it stands.

    Returns
    -------
    (3, n) array
        Branches [m].

    Raises
    ------
    ContactImpossible
        A branch of more than one and a half periods, which two centres in one cell cannot have.

    Notes
    -----
    Accuracy: a rounding of the period. Source: the minimum image in a rectangular cell.
    """
    import numpy as np

    times = np.rint(branch / cell)
    far = np.abs(times).max(axis=0) > 1
    if far.any():
        worst = int(np.argmax(far))
        axis = int(np.argmax(np.abs(times[:, worst])))
        raise ContactImpossible(
            f"{int(far.sum())} branch{'' if far.sum() == 1 else 'es'} longer than the periodic cell, first "
            f"l{axis + 1} = {branch[axis, worst]:.4g} m in {place_of(int(numbers[worst]))}",
            allowed=f"allowed up to the edge {cell[axis, 0]:.4g} m", remedy="Give the edges of the cell in the unit of "
            "the list; take centres that are inside it.")
    whole: Array = branch - times * np.where(np.isfinite(cell), cell, 0.0)
    return whole
