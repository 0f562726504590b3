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
    DENOMINATOR,
    HALVES,
    INTEGRALS,
    KNOWN,
    POSITIVE,
    QUARTERS,
    ROWS,
    STRENGTHS,
    TERMS,
    ZONE,
    ZONE_BITS,
)
from granular.batch.slip_share import friction_used
from granular.generated.slip_table_array import onset_part
from granular.generated.slip_table_block import slip_rows, slip_state

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]
    Index = NDArray[np.int64]


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
        level, contrast, kappa, margin = _state(D33, stress_ratio, friction)
        if varies:
            position = (contrast - CONTRASTS[0]) / COLUMN_WIDTH
            column = np.minimum(np.where(position > 0.0, position, 0.0), COLUMNS - 0.5).astype(np.int64)
            across = 2.0 * (position - column) - 1.0
            panel = _margin_panel(margin, HALVES, middle.size // (2 * COLUMNS)) * COLUMNS + column
        else:
            across, side = np.zeros(D33.size), middle.size // 4
            panel = _margin_panel(margin, QUARTERS, side) + np.where(contrast < 0.0, 2 * side, 0)
        variable = (np.abs(margin) - middle[panel]) * narrowness[panel]
        lost, at = np.zeros((INTEGRALS, D33.size)), 0
        for terms in reversed(ROWS) if varies else (TERMS,):
            lost = lost * across + _row(coefficients, panel, at, terms, variable)
            at += terms
        lost *= kappa
        near = np.flatnonzero(np.abs(margin) < ZONE)
        strength = DENOMINATOR * STRENGTHS[np.where(margin[near] >= 0.0, 0, 1)]
        lost[:, near] -= onset_part(margin[near], contrast[near], strength)
        l0, l1, l2, l3, l4, l5 = lost
        return slip_rows(D33, Dr33, poisson_ratio, level, contrast, l0, l1, l2, l3, l4, l5, out)


def _state(D33: Array, stress_ratio: Array, friction: Array) -> tuple[Array, Array, Array, Array]:
    """What is known before a table is read: the level of the stiffness, the contrast, kappa, and 1 - kappa."""
    state = np.empty(KNOWN * D33.size)
    slip_state(D33, stress_ratio, friction, state)
    level, contrast, kappa, margin = state.reshape(KNOWN, -1)
    rubbing = friction > 0.0
    kappa[~rubbing] = margin[~rubbing] = np.nan
    delicate = np.flatnonzero(rubbing & ((np.abs(margin) < 1.01 * ZONE) | (np.abs(contrast) < DELICATE)))
    kappa[delicate], margin[delicate] = friction_used(D33[delicate], stress_ratio[delicate], friction[delicate])
    return level, contrast, kappa, margin


def _margin_panel(margin: Array, bits: int, side: int) -> Index:
    """Panel of each margin: those before the onset first, then those after it."""
    found = np.clip(((margin.view(np.int64) & POSITIVE) >> bits) - (ZONE_BITS << (52 - bits)) + 1, 0, side - 1)
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
