"""Steps of the loops for partial slip that go over small parts: values of a table, and components from them.

What is known of the elements of a part stays in the nearest cache. Each step is to be compiled.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.batch.slip_layout import INTEGRALS
from granular.batch.slip_steps import take_onset_out
from granular.generated.panel_rows import (
    add_row_13,
    add_rows_7_7,
    add_rows_10_10,
    add_rows_11_11,
    add_rows_12_13,
    set_row_11,
    set_rows_4_4,
)
from granular.generated.rows import part_of, read_rows, scratch_of, write_rows
from granular.generated.slip_table_loop import slip_rows

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]
    Index = NDArray[np.int64]
    Places = NDArray[np.uint32]

PART = 384
"""Elements of a part."""

SPACING = PART + 8
"""Numbers from one column of a part to the next, so that no two of them are a power of two apart."""

NUMBERS = INTEGRALS * SPACING
"""All columns of a part."""


def values_for_one(coefficients: Array, middle: Array, narrowness: Array, start: Index, variable: Array,
                   lost: Array) -> None:
    """Read the table of one friction for elements that are sorted by panel.

    Parameters
    ----------
    coefficients, middle, narrowness : array
        Of a :class:`granular.batch.slip_tables.Table` [-].
    start : (panels + 1,) array of int
        Where each panel starts [-].
    variable : (places,) array
        Size of the margin [-].
    lost : (6 places,) array
        To be filled with rows, what slip takes over kappa [-].

    Notes
    -----
    Source: the table.
    """
    columns = scratch_of(NUMBERS)
    for one in range(middle.size):
        for first in range(start[one], start[one + 1], PART):
            last = min(first + PART, start[one + 1])
            for k in range(0, INTEGRALS, 3):
                set_row_11(coefficients, one, k, 0, part_of(variable, first, last), middle[one], narrowness[one],
                           columns, SPACING)
            write_rows(columns, INTEGRALS, SPACING, part_of(lost, INTEGRALS * first, INTEGRALS * last), False)


def values_for_any(coefficients: Array, middle: Array, narrowness: Array, start: Index, variable: Array, other: Array,
                   lost: Array) -> None:
    """Read the table of any friction for elements that are sorted by panel.

    Parameters
    ----------
    coefficients, middle, narrowness, start, lost : array
        As for :func:`values_for_one`; rows of ``slip_tables.ROWS``, the highest power of the contrast first [-].
    variable : (places,) array
        Size of the margin; changed to the place in the panel [-].
    other : (places,) array
        Place in the panel along the contrast [-].

    Notes
    -----
    Source: the table.
    """
    columns = scratch_of(NUMBERS)
    for one in range(middle.size):
        for first in range(start[one], start[one + 1], PART):
            last = min(first + PART, start[one + 1])
            x, y = part_of(variable, first, last), part_of(other, first, last)
            for i in range(last - first):
                x[i] = (x[i] - middle[one]) * narrowness[one]
            for k in range(0, INTEGRALS, 3):
                set_rows_4_4(coefficients, one, k, 0, x, y, columns, SPACING)
                add_rows_7_7(coefficients, one, k, 8, x, y, columns, SPACING)
                add_rows_10_10(coefficients, one, k, 22, x, y, columns, SPACING)
                add_rows_11_11(coefficients, one, k, 42, x, y, columns, SPACING)
                add_rows_12_13(coefficients, one, k, 64, x, y, columns, SPACING)
                add_row_13(coefficients, one, k, 89, x, y, columns, SPACING)
            write_rows(columns, INTEGRALS, SPACING, part_of(lost, INTEGRALS * first, INTEGRALS * last), False)


def components(D33: Array, Dr33: Array, poisson_ratio: Array, state: Array, near: Index, where: Places, lost: Array,
               out: Array, streamed: bool) -> int:
    """Write the components of each element.

    Parameters
    ----------
    D33, Dr33, poisson_ratio : (n,) array
        As for ``axial_stiffness`` [-].
    state : (4 n,) array
        From ``slip_state``, with the digits that ``look_closer`` gave back [-].
    near : (m,) array of int
        Elements near the onset, in their order [-].
    where : (n,) array of int
        Which row of ``lost`` each element has [-].
    lost : (6 places,) array
        What slip takes over kappa [-].
    out : (6 n,) array
        To be filled [-].
    streamed : bool
        Whether results go past the caches, where a compiler knows how.

    Returns
    -------
    int
        Elements that are not served: all their components are NaN [-].

    Notes
    -----
    Source: the derivation ``slip_table``.
    """
    size, unserved, done, columns = D33.size, 0, 0, scratch_of(NUMBERS)
    level, contrast = part_of(state, 0, size), part_of(state, size, 2 * size)
    kappa, margin = part_of(state, 2 * size, 3 * size), part_of(state, 3 * size, 4 * size)
    for first in range(0, size, PART):
        last = min(first + PART, size)
        n = last - first
        read_rows(lost, INTEGRALS, part_of(where, first, last), part_of(kappa, first, last), columns, SPACING)
        done = take_onset_out(near, done, first, last, margin, contrast, columns, SPACING)
        unserved += slip_rows(
            part_of(D33, first, last), part_of(Dr33, first, last), part_of(poisson_ratio, first, last),
            part_of(level, first, last), part_of(contrast, first, last), part_of(columns, 0, n),
            part_of(columns, SPACING, SPACING + n), part_of(columns, 2 * SPACING, 2 * SPACING + n),
            part_of(columns, 3 * SPACING, 3 * SPACING + n), part_of(columns, 4 * SPACING, 4 * SPACING + n),
            part_of(columns, 5 * SPACING, 5 * SPACING + n), part_of(out, 6 * first, 6 * last), streamed)
    return unserved
