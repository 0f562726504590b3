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
    COLUMN_WIDTH,
    COLUMNS,
    CONTRASTS,
    HALVES,
    INTEGRALS,
    KNOWN,
    QUARTERS,
    TERMS,
    margin_panels,
)
from granular.batch.slip_share import HELPERS as OF_SHARES
from granular.batch.slip_steps import in_order, shares, sort_by_panel, take_onset_out, write_components
from granular.generated.panel_rows import add_row_4, add_row_7, add_row_10, add_row_12, add_row_14
from granular.generated.slip_table_array import onset_part, slip_components
from granular.generated.slip_table_loop import slip_state

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

CHUNK, CHUNK_VARIES = 1 << 14, 1 << 15
"""Elements that are sorted together with one friction and with friction that varies: some hundred for each panel,
and what is known of them stays near the processor."""


def partial_slip(D33: Array, Dr33: Array, stress_ratio: Array, poisson_ratio: Array, friction: Array,
                 coefficients: Array, middle: Array, narrowness: Array, out: Array) -> int:
    """Six components of each element, with one friction for all of them or with any, as the table goes.

    Parameters
    ----------
    D33, Dr33, stress_ratio, poisson_ratio, friction : (n,) array
        As for ``axial_stiffness`` [-].
    coefficients, middle, narrowness : array
        Of a :class:`granular.batch.slip_tables.Table` [-].
    out : (6 n,) array
        To be filled; NaN for elements that are not served [-].

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
    variable, other, start = np.zeros(room), np.zeros(room), np.zeros(middle.size + 1, dtype=np.int64)
    across, lost, lost_here = np.zeros(most), np.zeros((INTEGRALS, room)), np.zeros((INTEGRALS, most))
    for begin in range(0, D33.size, chunk):
        end = min(begin + chunk, D33.size)
        size = end - begin
        d, dr, ratio, nu = D33[begin:end], Dr33[begin:end], stress_ratio[begin:end], poisson_ratio[begin:end]
        state, kappa, margin = all_state[:KNOWN * size], all_kappa[:size], all_margin[:size]
        panel, where = all_panel[:size], all_where[:size]
        slip_state(d, dr, ratio, nu, state)
        shares(d, ratio, friction[begin:end], state, kappa, margin)
        margin_panels(margin, bits, side, panel)
        for i in range(size):
            contrast = state[KNOWN * i + 4]
            if varies:
                position = (contrast - CONTRASTS[0]) / COLUMN_WIDTH
                column = int(min(position if position > 0.0 else 0.0, COLUMNS - 0.5))
                across[i] = 2.0 * (position - column) - 1.0
                panel[i] = panel[i] * COLUMNS + column
            elif contrast < 0.0:
                panel[i] += 2 * side
        sort_by_panel(panel, start, where)
        for i in range(size):
            variable[where[i]] = (abs(margin[i]) - middle[panel[i]]) * narrowness[panel[i]]
            other[where[i]] = across[i]
        for one in range(middle.size):
            first, last = start[one], start[one + 1]
            if first == last:
                continue
            for k in range(0, INTEGRALS, 3):
                rows, x, y = coefficients[one, k:k + 3], variable[first:last], other[first:last]
                v0, v1, v2 = lost[k, first:last], lost[k + 1, first:last], lost[k + 2, first:last]
                v0[:] = v1[:] = v2[:] = 0.0
                if varies:
                    add_rows(rows, x, y, v0, v1, v2)
                else:
                    add_row_12(rows, 0, x, y, v0, v1, v2)
        in_order(lost, where, kappa, lost_here)
        take_onset_out(margin, state, lost_here)
        unserved += write_components(d, dr, state, lost_here, out[6 * begin:6 * end])
    return unserved


def add_rows(rows: Array, variable: Array, other: Array, v0: Array, v1: Array, v2: Array) -> None:
    """Add all rows of ``slip_tables.ROWS``, the highest power of the contrast first.

    Parameters
    ----------
    rows : (3, terms) array
        Coefficients of three polynomials [-].
    variable, other : (n,) array
        Place in the panel along margin and contrast [-].
    v0, v1, v2 : (n,) array
        Zeros, to be filled [-].

    Notes
    -----
    Source: the table.
    """
    for at in (0, 4):
        add_row_4(rows, at, variable, other, v0, v1, v2)
    for at in (8, 15):
        add_row_7(rows, at, variable, other, v0, v1, v2)
    for at in (22, 32):
        add_row_10(rows, at, variable, other, v0, v1, v2)
    for at in (42, 54, 66):
        add_row_12(rows, at, variable, other, v0, v1, v2)
    for at in (78, 92):
        add_row_14(rows, at, variable, other, v0, v1, v2)


HELPERS: tuple[Callable[..., object], ...] = (
    *OF_SHARES, onset_part, slip_components, slip_state, add_row_4, add_row_7, add_row_10, add_row_12, add_row_14,
    shares, margin_panels, sort_by_panel, in_order, take_onset_out, write_components, add_rows)
"""What a compiler has to know before it compiles a loop."""
