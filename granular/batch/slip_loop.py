"""Partial slip for blocks of elements, as loops to be compiled: elements are sorted by panel of a table.

Within a panel the coefficients are the same for all elements, so that polynomials become vector code without looking
anything up. A value does not depend on its neighbours: every element takes the same operations in the same order.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from granular.batch.slip_layout import (
    ALIGNED,
    COLUMNS,
    INTEGRALS,
    KNOWN,
    QUARTERS,
    TERMS,
)
from granular.batch.slip_share import HELPERS as OF_SHARES
from granular.batch.slip_steps import (
    look_closer,
    panels_of_any,
    panels_of_one,
    sort_by_panel,
    take_onset_out,
)
from granular.generated.panel_rows import (
    add_row_13,
    add_rows_7_7,
    add_rows_10_10,
    add_rows_11_11,
    add_rows_12_13,
    set_row_11,
    set_rows_4_4,
)
from granular.generated.rows import read_rows, scratch_of, write_rows
from granular.generated.slip_table_array import onset_part
from granular.generated.slip_table_loop import slip_rows, slip_state

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

CHUNK = 1 << 15
"""Elements that are sorted together: some hundred for each panel, and what is known of them stays near the processor."""

PART = 384
"""Elements that go through the steps after the table together: what is known of them stays in the nearest cache."""

SPACING = PART + 8
"""Numbers from one column of a part to the next, so that no two of them are a power of two apart."""

NUMBERS = INTEGRALS * SPACING
"""All of a part."""


def partial_slip(D33: Array, Dr33: Array, stress_ratio: Array, poisson_ratio: Array, friction: Array,
                 coefficients: Array, middle: Array, narrowness: Array, out: Array, streamed: bool) -> int:
    """Six components of each element, with one friction for all of them or with any, as the table goes.

    Parameters
    ----------
    D33, Dr33, stress_ratio, poisson_ratio, friction : (n,) array
        As for ``axial_stiffness`` [-].
    coefficients, middle, narrowness : array
        Of a :class:`granular.batch.slip_tables.Table` [-].
    out : (6 n,) array
        To be filled; NaN for elements that are not served [-].
    streamed : bool
        Whether results go past the caches, where a compiler knows how.

    Returns
    -------
    int
        Elements that are not served [-].

    Notes
    -----
    Accuracy: that of the kernel. Source: the derivation ``slip_table``.
    """
    varies = coefficients.shape[2] != TERMS
    side = middle.size // (2 * COLUMNS) if varies else middle.size // 4
    unserved, most = 0, min(CHUNK, D33.size)
    room = most + ALIGNED * min(most, middle.size)
    all_state, all_near = np.empty(KNOWN * most), np.empty(most, dtype=np.int64)
    all_panel, all_where = np.empty(most, dtype=np.uint16), np.empty(most, dtype=np.uint32)
    variable, other, across = np.zeros(room), np.zeros(room), np.zeros(most)
    lost, columns = np.zeros(INTEGRALS * room), scratch_of(NUMBERS)
    l0, l1, l2, l3, l4, l5 = (columns[0:PART], columns[SPACING:SPACING + PART],
                              columns[2 * SPACING:2 * SPACING + PART], columns[3 * SPACING:3 * SPACING + PART],
                              columns[4 * SPACING:4 * SPACING + PART], columns[5 * SPACING:5 * SPACING + PART])
    start = np.zeros(middle.size + 1, dtype=np.int64)
    for begin in range(0, D33.size, CHUNK):
        end = min(begin + CHUNK, D33.size)
        size = end - begin
        d, dr, ratio, nu = D33[begin:end], Dr33[begin:end], stress_ratio[begin:end], poisson_ratio[begin:end]
        mu, state, panel, where = friction[begin:end], all_state[:KNOWN * size], all_panel[:size], all_where[:size]
        slip_state(d, ratio, mu, state)
        level, contrast, kappa, margin = state[:size], state[size:2 * size], state[2 * size:3 * size], state[3 * size:]
        near = all_near[:look_closer(d, ratio, mu, contrast, kappa, margin, all_near)]
        if varies:
            panels_of_any(margin, contrast, side, panel, across)
        else:
            panels_of_one(margin, contrast, QUARTERS, side, panel)
        sort_by_panel(panel, margin, start, where, variable)
        if varies:
            for i in range(size):
                other[where[i]] = across[i]
        for one in range(middle.size):
            for first in range(start[one], start[one + 1], PART):
                last = min(first + PART, start[one + 1])
                for place in range(first, last):
                    variable[place] = (variable[place] - middle[one]) * narrowness[one]
                for k in range(0, INTEGRALS, 3):
                    if varies:
                        sum_rows(coefficients[one], k, variable[first:last], other[first:last], columns)
                    else:
                        set_row_11(coefficients[one], k, 0, variable[first:last], columns, SPACING)
                write_rows(columns, INTEGRALS, SPACING, lost[6 * first:6 * last], False)
        done = 0
        for first in range(0, size, PART):
            last = min(first + PART, size)
            n = last - first
            read_rows(lost, INTEGRALS, where[first:last], kappa[first:last], columns, SPACING)
            done = take_onset_out(near, done, first, last, margin, contrast, columns, SPACING)
            unserved += slip_rows(
                d[first:last], dr[first:last], nu[first:last], level[first:last], contrast[first:last], l0[:n], l1[:n],
                l2[:n], l3[:n], l4[:n], l5[:n], out[6 * (begin + first):6 * (begin + last)], streamed)
    return unserved


def sum_rows(rows: Array, k: int, variable: Array, other: Array, columns: Array) -> None:
    """Sum all rows of ``slip_tables.ROWS``, the highest power of the contrast first.

    Parameters
    ----------
    rows : (6, terms) array
        Coefficients of polynomials, highest power first [-].
    k : int
        The first of three polynomials [-].
    variable, other : (n,) array
        Place in the panel along margin and contrast [-].
    columns : (6 SPACING,) array
        To be filled: the first n of three columns [-].

    Notes
    -----
    Source: the table.
    """
    set_rows_4_4(rows, k, 0, variable, other, columns, SPACING)
    add_rows_7_7(rows, k, 8, variable, other, columns, SPACING)
    add_rows_10_10(rows, k, 22, variable, other, columns, SPACING)
    add_rows_11_11(rows, k, 42, variable, other, columns, SPACING)
    add_rows_12_13(rows, k, 64, variable, other, columns, SPACING)
    add_row_13(rows, k, 89, variable, other, columns, SPACING)


HELPERS: tuple[Callable[..., object], ...] = (
    *OF_SHARES, onset_part, slip_rows, slip_state, set_row_11, set_rows_4_4, add_rows_7_7, add_rows_10_10,
    add_rows_11_11, add_rows_12_13, add_row_13, look_closer, panels_of_any, panels_of_one, sort_by_panel,
    take_onset_out, sum_rows)
"""What a compiler has to know before it compiles a loop."""
