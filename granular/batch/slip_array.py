"""Partial slip for blocks of elements by NumPy: the same operations in the same order as the loops, without sorting.

Each coefficient is looked up for all elements of a block at once.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from granular.batch.slip_layout import (
    COLUMN_WIDTH,
    COLUMNS,
    CONTRASTS,
    DELICATE,
    HALVES,
    INTEGRALS,
    KNOWN,
    QUARTERS,
    ROWS,
    STRENGTHS,
    TERMS,
    ZONE,
    ZONE_BITS,
)
from granular.batch.slip_share import friction_used
from granular.generated.slip_table_array import onset_part, slip_components
from granular.generated.slip_table_block import slip_state

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]
    Index = NDArray[np.int64]

SUMMED = [0, 1, 2, 3, 5]
"""What ``slip_components`` takes of the state: all but the contrast."""


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
    Accuracy: that of the kernel, with the bits of the loop. Source: the derivation ``slip_table``.
    """
    varies = coefficients.shape[2] != TERMS
    with np.errstate(all="ignore"):  # what is not served may be anything
        known, kappa, margin = _state(D33, Dr33, stress_ratio, poisson_ratio, friction)
        if varies:
            position = (known[4] - CONTRASTS[0]) / COLUMN_WIDTH
            column = np.minimum(np.where(position > 0.0, position, 0.0), COLUMNS - 0.5).astype(np.int64)
            across = 2.0 * (position - column) - 1.0
            panel = _margin_panel(margin, HALVES, middle.size // (2 * COLUMNS)) * COLUMNS + column
        else:
            across, side = np.zeros(D33.size), middle.size // 4
            panel = _margin_panel(margin, QUARTERS, side) + np.where(known[4] < 0.0, 2 * side, 0)
        variable = (np.abs(margin) - middle[panel]) * narrowness[panel]
        lost, at = np.zeros((INTEGRALS, D33.size)), 0
        for terms in reversed(ROWS) if varies else (TERMS,):
            lost = lost * across + _row(coefficients, panel, at, terms, variable)
            at += terms
        return _finish(D33, Dr33, known, kappa, margin, lost, out)


def _state(D33: Array, Dr33: Array, stress_ratio: Array, poisson_ratio: Array,
           friction: Array) -> tuple[Array, Array, Array]:
    """What is known before a table is read: what ``slip_state`` gives, in rows; kappa; 1 - kappa."""
    state = np.empty(KNOWN * D33.size)
    slip_state(D33, Dr33, stress_ratio, poisson_ratio, state)
    known = state.reshape(KNOWN, -1)
    square = known[4] * known[4]
    product = 1.0 - square
    kappa = (3.0 + square) * np.abs(known[4]) / (friction * (product * np.sqrt(product)))
    margin = 1.0 - kappa
    rubbing = friction > 0.0
    kappa[~rubbing] = margin[~rubbing] = np.nan
    delicate = np.flatnonzero(rubbing & ((np.abs(margin) < 1.01 * ZONE) | (np.abs(known[4]) < DELICATE)))
    kappa[delicate], margin[delicate] = friction_used(D33[delicate], stress_ratio[delicate], friction[delicate])
    return known, kappa, margin


def _margin_panel(margin: Array, bits: int, side: int) -> Index:
    """Panel of each margin: those before the onset first, then those after it."""
    found = np.clip((np.abs(margin).view(np.int64) >> bits) - (ZONE_BITS << (52 - bits)) + 1, 0, side - 1)
    panel: Index = np.where(margin >= 0.0, found, found + side)
    return panel


def _row(coefficients: Array, panel: Index, at: int, terms: int, variable: Array) -> Array:
    """Six polynomials of each element, (6, n): even and odd powers apart, as in the emitted loops."""
    square = variable * variable
    parts = []
    for first in ((terms - 1) % 2, terms % 2):
        total = coefficients[panel, :, at + first].T
        for place in range(at + first + 2, at + terms, 2):
            total = total * square + coefficients[panel, :, place].T
        parts.append(total)
    even, odd = parts
    result: Array = even + variable * odd
    return result


def _finish(D33: Array, Dr33: Array, known: Array, kappa: Array, margin: Array, lost: Array,
            out: Array) -> int:
    """Take out what is not smooth near the onset, and write the components."""
    lost = lost * kappa
    near = np.flatnonzero(np.abs(margin) < ZONE)
    strength = STRENGTHS[np.where(margin[near] >= 0.0, 0, 1)]
    lost[:, near] -= onset_part(margin[near], known[4, near], strength)
    rows = out.reshape(-1, 6)
    for place, component in enumerate(slip_components(D33, Dr33, *known[SUMMED], *lost)):
        rows[:, place] = component
    return int(np.count_nonzero(np.isnan(rows[:, 0])))
