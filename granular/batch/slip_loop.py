"""Partial slip for blocks of elements, as loops to be compiled: elements are sorted by panel of a table.

Within a panel the coefficients are the same for all elements, so that polynomials become vector code without looking
anything up. A value does not depend on its neighbours: every element takes the same operations in the same order.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from granular.batch.slip_layout import ALIGNED, COLUMNS, INTEGRALS, KNOWN, QUARTERS, TERMS
from granular.batch.slip_parts import components, values_for_any, values_for_one
from granular.batch.slip_share import HELPERS as OF_SHARES
from granular.batch.slip_steps import (
    look_closer,
    panels_of_any,
    panels_of_one,
    sort_across,
    sort_by_panel,
    take_onset_out,
)
from granular.generated import panel_rows
from granular.generated.rows import part_of
from granular.generated.slip_table_array import onset_part
from granular.generated.slip_table_loop import slip_rows, slip_state

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

CHUNK = 1 << 16
"""Elements that are sorted together: some hundred for each panel."""


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
    variable, other, across, lost = np.zeros(room), np.zeros(room), np.zeros(most), np.zeros(INTEGRALS * room)
    start = np.zeros(middle.size + 1, dtype=np.int64)
    for begin in range(0, D33.size, CHUNK):
        end = min(begin + CHUNK, D33.size)
        size = end - begin
        d, dr, ratio = part_of(D33, begin, end), part_of(Dr33, begin, end), part_of(stress_ratio, begin, end)
        nu, mu, state = part_of(poisson_ratio, begin, end), part_of(friction, begin, end), all_state[:KNOWN * size]
        panel, where = part_of(all_panel, 0, size), part_of(all_where, 0, size)
        slip_state(d, ratio, mu, state)
        contrast, margin = part_of(state, size, 2 * size), part_of(state, 3 * size, 4 * size)
        found = look_closer(d, ratio, mu, contrast, part_of(state, 2 * size, 3 * size), margin, all_near)
        if varies:
            panels_of_any(margin, contrast, side, panel, across)
            sort_by_panel(panel, margin, start, where, variable)
            sort_across(across, where, other)
            values_for_any(coefficients, middle, narrowness, start, variable, other, lost)
        else:
            panels_of_one(margin, contrast, QUARTERS, side, panel)
            sort_by_panel(panel, margin, start, where, variable)
            values_for_one(coefficients, middle, narrowness, start, variable, lost)
        unserved += components(d, dr, nu, state, part_of(all_near, 0, found), where, lost,
                               part_of(out, 6 * begin, 6 * end), streamed)
    return unserved


ROWS = tuple(getattr(panel_rows, name) for name in dir(panel_rows) if name.startswith(("set_row", "add_row")))
"""Every emitted sum of polynomials."""

HELPERS: tuple[Callable[..., object], ...] = (
    *OF_SHARES, *ROWS, onset_part, slip_rows, slip_state, look_closer, panels_of_any, panels_of_one, sort_across,
    sort_by_panel, take_onset_out, values_for_any, values_for_one, components)
"""What a compiler has to know before it compiles a loop."""
