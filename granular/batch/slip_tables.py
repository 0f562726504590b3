"""Tables of what partial slip takes: polynomials in panels of the margin to sliding and of the contrast of forces."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from granular.batch.slip_layout import (
    BEFORE,
    COLUMN_WIDTH,
    COLUMNS,
    CONTRASTS,
    DENOMINATOR,
    INTEGRALS,
    OCTAVES,
    ROWS,
    TERMS,
    ZONE,
    intervals,
)
from granular.batch.slip_nodes import smooth_values

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

@dataclass(frozen=True, slots=True)
class Table:
    """Polynomials by panel.

    Attributes
    ----------
    coefficients : (panels, 6, terms) array
        Of ``DENOMINATOR`` times the integrals; highest power first, in the order in which they are used [-].
    middle, narrowness : (panels,) array
        Middle of a panel of abs(margin), and 2 over its width; NaN where a panel is not served [-].
    """

    coefficients: Array
    middle: Array
    narrowness: Array


def octaves_for(friction: float) -> int:
    """Octaves of the margin that one friction needs, at least those before the onset and one more.

    Parameters
    ----------
    friction : float
        mu > 0 [-].

    Returns
    -------
    int
        Number of octaves [-].

    Notes
    -----
    Source: kappa at the ends of the domain.

    Examples
    --------
    >>> octaves_for(0.2), octaves_for(5.0)
    (11, 9)
    """
    most = max(_kappa_at(end, friction) for end in CONTRASTS) - 1
    return max(BEFORE + 1, math.ceil(math.log2(max(most, ZONE) / ZONE)))


def _kappa_at(contrast: float, friction: float) -> float:
    return math.sinh(3 * math.atanh(abs(contrast))) / friction


@lru_cache(maxsize=32)
def friction_table(friction: float) -> Table:
    """Polynomials in the margin for one friction, before and after the onset, for either sign of the contrast.

    Parameters
    ----------
    friction : float
        mu > 0 [-].

    Returns
    -------
    Table
        Panels: c > a before the onset, after it, then c < a.

    Notes
    -----
    Accuracy: 5e-13 of a value. Source: interpolation of :func:`granular.batch.slip_nodes.smooth_values` at Chebyshev
    nodes.
    """
    side = np.array(intervals(octaves_for(friction), 4))
    first, last, signs, directions = [], [], [], []
    for direction, end in ((1, CONTRASTS[1]), (-1, -CONTRASTS[0])):
        most = _kappa_at(end, friction)
        for sign, farthest, nearest in ((1, 1.0, 1 - most), (-1, most - 1, 0.0)):
            first.append(np.maximum(side[:, 0], nearest))
            last.append(np.minimum(side[:, 1], np.where(side[:, 0] < farthest, farthest, -np.inf)))
            signs += [sign] * len(side)
            directions += [direction] * len(side)
    low, high = np.concatenate(first), np.concatenate(last)
    served = low < high
    middle, half = (low + high) / 2, (high - low) / 2
    nodes, to_chebyshev, to_powers = _interpolation(TERMS)
    margin = np.array(signs)[served, None] * (middle[served, None] + half[served, None] * nodes)
    contrast = np.array(directions)[served, None] * np.tanh(np.arcsinh(friction * (1 - margin)) / 3)
    values = DENOMINATOR * smooth_values(margin.ravel(), contrast.ravel()).reshape(INTEGRALS, *margin.shape)
    coefficients = np.zeros((served.size, INTEGRALS, TERMS))
    coefficients[served] = ((values @ to_chebyshev.T) @ to_powers.T).swapaxes(0, 1)
    with np.errstate(divide="ignore"):
        return Table(coefficients, np.where(served, middle, np.nan), np.where(served, 1 / half, np.nan))


@lru_cache(maxsize=1)
def general_table() -> Table:
    """Polynomials in margin and contrast for any friction, before and after the onset.

    Returns
    -------
    Table
        Panels of the margin before the onset, then after it, each with all panels of the contrast; 2 MB.

    Notes
    -----
    Accuracy: 4e-13 of a value. Source: interpolation of :func:`granular.batch.slip_nodes.smooth_values` at Chebyshev
    nodes; made once in a process, in the time of some 150,000 sums.
    """
    side = intervals(OCTAVES, 2)
    size = max(ROWS)
    nodes, to_chebyshev, to_powers = _interpolation(size)
    across, to_chebyshev_across, to_powers_across = _interpolation(len(ROWS))
    kept = np.arange(size)[:, None] < np.array(ROWS)
    columns = CONTRASTS[0] + COLUMN_WIDTH * (np.arange(COLUMNS)[:, None] + (1 + across) / 2)
    coefficients = np.zeros((2 * len(side) * COLUMNS, INTEGRALS, sum(ROWS)))
    middle, narrowness = np.full((2, len(coefficients)), np.nan)
    for place, (low, high, sign) in enumerate([(*pair, sign) for sign in (1, -1) for pair in side]):
        if high == math.inf or (sign > 0 and high > 1):
            continue
        margin, contrast = np.broadcast_arrays(sign * ((low + high) / 2 + (high - low) / 2 * nodes)[None, :, None],
                                               columns[:, None, :])
        values = DENOMINATOR * smooth_values(margin.ravel(), contrast.ravel()).reshape(INTEGRALS, *margin.shape)
        chebyshev = np.where(kept, to_chebyshev @ values @ to_chebyshev_across.T, 0.0)
        full = to_powers @ chebyshev @ to_powers_across.T  # both highest power first
        here = slice(place * COLUMNS, (place + 1) * COLUMNS)
        coefficients[here] = np.concatenate([full[:, :, size - terms:, len(ROWS) - 1 - power].swapaxes(0, 1)
                                             for power, terms in reversed(list(enumerate(ROWS)))], axis=-1)
        middle[here], narrowness[here] = (low + high) / 2, 2 / (high - low)
    return Table(coefficients, middle, narrowness)


def _interpolation(size: int) -> tuple[Array, Array, Array]:
    """Chebyshev nodes, the matrix from values there to Chebyshev coefficients, and from those to powers, highest first.

    The two steps stay apart: high coefficients are small, and lose nothing when they meet the large numbers of the
    second.
    """
    angles = np.pi * (np.arange(size) + 0.5) / size
    to_chebyshev = np.cos(np.outer(np.arange(size), angles)) * (2 / size)
    to_chebyshev[0] /= 2
    to_powers = np.zeros((size, size))
    for order in range(size):
        to_powers[size - 1 - order:, order] = np.polynomial.chebyshev.cheb2poly([0.0] * order + [1.0])[::-1]
    return np.cos(angles), to_chebyshev, to_powers
