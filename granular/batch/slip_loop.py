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
    HALVES,
    INTEGRALS,
    KNOWN,
    QUARTERS,
    TERMS,
    margin_panels,
)
from granular.batch.slip_share import HELPERS as OF_SHARES
from granular.batch.slip_steps import contrast_panels, in_order, shares, sort_by_panel, take_onset_out, write_components
from granular.generated.panel_rows import (
    add_row_4,
    add_row_7,
    add_row_10,
    add_row_11,
    add_row_12,
    add_row_13,
    set_row_4,
    set_row_11,
)
from granular.generated.slip_table_array import onset_part, slip_components
from granular.generated.slip_table_loop import slip_state

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

CHUNK, CHUNK_VARIES = 1 << 15, 1 << 15
"""Elements that are sorted together with one friction and with friction that varies: some hundred for each panel,
and what is known of them stays near the processor."""

PART = 512
"""Elements that go through the steps after the table together: what is known of them stays in the nearest cache."""


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
    side, bits = (middle.size // (2 * COLUMNS), HALVES) if varies else (middle.size // 4, QUARTERS)
    chunk = CHUNK_VARIES if varies else CHUNK
    unserved, most = 0, min(chunk, D33.size)
    room = most + ALIGNED * min(most, middle.size)
    all_state, all_kappa, all_margin = np.empty(KNOWN * most), np.empty(most), np.empty(most)
    all_panel, all_where = np.empty(most, dtype=np.int64), np.empty(most, dtype=np.int64)
    all_near, variable, other = np.empty(most, dtype=np.int64), np.zeros(room), np.zeros(room)
    across, lost, lost_here = np.zeros(most), np.zeros((INTEGRALS, room)), np.zeros((INTEGRALS, min(most, PART)))
    start = np.zeros(middle.size + 1, dtype=np.int64)
    for begin in range(0, D33.size, chunk):
        end = min(begin + chunk, D33.size)
        size = end - begin
        d, dr, ratio, nu = D33[begin:end], Dr33[begin:end], stress_ratio[begin:end], poisson_ratio[begin:end]
        state, kappa, margin = all_state[:KNOWN * size], all_kappa[:size], all_margin[:size]
        panel, where = all_panel[:size], all_where[:size]
        slip_state(d, dr, ratio, nu, state)
        near = all_near[:shares(d, ratio, friction[begin:end], state, kappa, margin, all_near)]
        margin_panels(margin, bits, side, panel)
        contrast_panels(state, side, varies, panel, across)
        sort_by_panel(panel, margin, start, where, variable)
        if varies:
            for i in range(size):
                other[where[i]] = across[i]
        for one in range(middle.size):
            first, last = start[one], start[one + 1]
            if first == last:
                continue
            for place in range(first, last):
                variable[place] = (variable[place] - middle[one]) * narrowness[one]
            for k in range(0, INTEGRALS, 3):
                if varies:
                    sum_rows(coefficients[one], k, variable[first:last], other[first:last], lost, first, last)
                else:
                    set_row_11(coefficients[one], k, 0, variable[first:last], lost, first, last)
        done = 0
        for first in range(0, size, PART):
            last = min(first + PART, size)
            in_order(lost, where[first:last], kappa[first:last], lost_here)
            done = take_onset_out(near, done, first, last, margin, state, lost_here)
            unserved += write_components(d, dr, state, first, last, lost_here, out[6 * begin:6 * end])
    return unserved


def sum_rows(rows: Array, k: int, variable: Array, other: Array, values: Array, first: int, last: int) -> None:
    """Sum all rows of ``slip_tables.ROWS``, the highest power of the contrast first.

    Parameters
    ----------
    rows : (6, terms) array
        Coefficients of polynomials, highest power first [-].
    variable, other : (n,) array
        Place in the panel along margin and contrast [-].
    k : int
        The first of three polynomials [-].
    values : (6, m) array
        To be filled from ``first`` to ``last`` [-].
    first, last : int
        Where the elements of the panel begin and end [-].

    Notes
    -----
    Source: the table.
    """
    set_row_4(rows, k, 0, variable, values, first, last)
    add_row_4(rows, k, 4, variable, other, values, first, last)
    for at in (8, 15):
        add_row_7(rows, k, at, variable, other, values, first, last)
    for at in (22, 32):
        add_row_10(rows, k, at, variable, other, values, first, last)
    for at in (42, 53):
        add_row_11(rows, k, at, variable, other, values, first, last)
    add_row_12(rows, k, 64, variable, other, values, first, last)
    for at in (76, 89):
        add_row_13(rows, k, at, variable, other, values, first, last)


HELPERS: tuple[Callable[..., object], ...] = (
    *OF_SHARES, onset_part, slip_components, slip_state, set_row_4, set_row_11, add_row_4, add_row_7,
    add_row_10, add_row_11, add_row_12, add_row_13,
    shares, margin_panels, contrast_panels, sort_by_panel, in_order, take_onset_out, write_components, sum_rows)
"""What a compiler has to know before it compiles a loop."""
