"""Steps of the loops for partial slip: shares of friction, panels, sorting, the onset. Each is to be compiled."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from granular.batch.slip_layout import (
    ALIGNED,
    COLUMN_WIDTH,
    COLUMNS,
    CONTRASTS,
    DELICATE,
    DENOMINATOR,
    HALVES,
    INTEGRALS,
    POSITIVE,
    STRENGTHS,
    ZONE,
    ZONE_BITS,
)
from granular.batch.slip_share import friction_used
from granular.generated.rows import scratch_of
from granular.generated.slip_table_array import onset_part

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]
    Index = NDArray[np.int64]
    Panels = NDArray[np.uint16]
    Places = NDArray[np.uint32]

GROUP = 256
"""Elements that are looked at together, a byte for each: where eight bytes are zero none of them is special."""

TOGETHER = 64
"""Special elements that are computed together."""


def look_closer(D33: Array, stress_ratio: Array, friction: Array, contrast: Array, kappa: Array, margin: Array,
                near: Index) -> int:
    """Give back the digits that kappa and 1 - kappa lost where they are small, and find elements near the onset.

    Parameters
    ----------
    D33, stress_ratio, friction : (n,) array
        As for ``axial_stiffness`` [-].
    contrast : (n,) array
        From ``slip_state`` [-].
    kappa, margin : (n,) array
        Also from there; changed in place, to NaN where there is no friction [-].
    near : (n,) array of int
        To be filled, as far as there are any, with the elements whose margin is below ``ZONE``, in their order; the
        rest is overwritten [-].

    Returns
    -------
    int
        How many these are [-].

    Notes
    -----
    Accuracy: some 512 units in the last place of kappa; a few where the margin is small. Source: the derivation
    ``slip_table``.
    """
    size, count, found = D33.size, 0, 0
    special = np.zeros(GROUP, dtype=np.uint8)
    eights = special.view(np.uint64)
    for first in range(0, size, GROUP):
        last = min(first + GROUP, size)
        mu, eta, left = friction[first:last], contrast[first:last], margin[first:last]
        for i in range(last - first):
            special[i] = (abs(left[i]) < 1.01 * ZONE) | (abs(eta[i]) < DELICATE) | (not mu[i] > 0.0)
        special[last - first:] = 0
        for eight in range((last - first + 7) // 8):
            if eights[eight]:
                for i in range(8 * eight, min(8 * eight + 8, last - first)):
                    near[count] = first + i
                    count += special[i]
    d, ratio, mu = scratch_of(TOGETHER), scratch_of(TOGETHER), scratch_of(TOGETHER)
    used, left = scratch_of(TOGETHER), scratch_of(TOGETHER)
    for first in range(0, count, TOGETHER):
        some = near[first:min(first + TOGETHER, count)]
        for j in range(some.size):
            d[j], ratio[j], mu[j] = D33[some[j]], stress_ratio[some[j]], friction[some[j]]
        for j in range(some.size):
            used[j], left[j] = friction_used(d[j], ratio[j], mu[j])
        for j in range(some.size):
            i = some[j]
            kappa[i], margin[i] = (used[j], left[j]) if mu[j] > 0.0 else (np.nan, np.nan)
            if abs(margin[i]) < ZONE:
                near[found] = i
                found += 1
    return found


def panels_of_one(margin: Array, contrast: Array, bits: int, side: int, panel: Panels) -> None:
    """Fill the panel of each element where friction is one: those before the onset first, then those after it.

    Parameters
    ----------
    margin, contrast : (n,) array
        1 - kappa; the cubic contrast of the forces, whose sign decides [-].
    bits : int
        ``HALVES`` or ``QUARTERS`` [-].
    side : int
        Panels of the margin on each side of the onset [-].
    panel : (n,) array of int
        To be filled [-].

    Notes
    -----
    Source: the layout of a double.
    """
    leading, zone = margin.view(np.int64), (ZONE_BITS << (52 - bits)) - 1
    for i in range(margin.size):
        found = min(max(((leading[i] & POSITIVE) >> bits) - zone, 0), side - 1)
        panel[i] = found + (0 if margin[i] >= 0.0 else side) + (2 * side if contrast[i] < 0.0 else 0)


def panels_of_any(margin: Array, contrast: Array, side: int, panel: Panels, across: Array) -> None:
    """Fill the panel of each element where friction varies, and its place in it along the contrast.

    Parameters
    ----------
    margin, contrast : (n,) array
        1 - kappa; the cubic contrast of the forces [-].
    side : int
        Panels of the margin on each side of the onset [-].
    panel : (n,) array of int
        To be filled [-].
    across : (n,) array
        To be filled with the place in a panel of the contrast, from -1 to 1 [-].

    Notes
    -----
    Source: the layout of a double.
    """
    leading, zone = margin.view(np.int64), (ZONE_BITS << (52 - HALVES)) - 1
    for i in range(margin.size):
        found = min(max(((leading[i] & POSITIVE) >> HALVES) - zone, 0), side - 1)
        position = (contrast[i] - CONTRASTS[0]) / COLUMN_WIDTH
        column = int(min(position if position > 0.0 else 0.0, COLUMNS - 0.5))
        across[i] = 2.0 * (position - column) - 1.0
        panel[i] = (found + (0 if margin[i] >= 0.0 else side)) * COLUMNS + column


def sort_by_panel(panel: Panels, margin: Array, start: Index, where: Places, variable: Array) -> None:
    """Fill where each panel starts, the place of each element among those of its panel, and their margins there.

    Parameters
    ----------
    panel : (n,) array of int
        Panel of each element [-].
    margin : (n,) array
        1 - kappa [-].
    start : (panels + 1,) array of int
        To be filled with multiples of ``ALIGNED`` [-].
    where : (n,) array of int
        To be filled [-].
    variable : (places,) array
        To be filled with the size of the margin, in sorted order [-].

    Notes
    -----
    Source: counting sort.
    """
    start[:] = 0
    for i in range(panel.size):
        before = start[panel[i]]
        where[i] = before
        start[panel[i]] = before + 1
    begin = 0
    for one in range(start.size):
        size = start[one]
        start[one] = begin
        begin += (size + ALIGNED - 1) // ALIGNED * ALIGNED
    for i in range(panel.size):
        where[i] += start[panel[i]]
        variable[where[i]] = abs(margin[i])


def sort_across(across: Array, where: Places, other: Array) -> None:
    """Bring the places along the contrast into sorted order too.

    Parameters
    ----------
    across : (n,) array
        Place in a panel of the contrast [-].
    where : (n,) array of int
        Sorted place of each element [-].
    other : (places,) array
        To be filled [-].

    Notes
    -----
    Source: :func:`sort_by_panel`.
    """
    for i in range(where.size):
        other[where[i]] = across[i]


def take_onset_out(near: Index, done: int, first: int, last: int, margin: Array, contrast: Array,
                   columns: Array, spacing: int) -> int:
    """Take the part that is not smooth out of the elements near the onset, as far as they are in a part of all.

    Parameters
    ----------
    near : (m,) array of int
        Elements near the onset, in their order [-].
    done : int
        How many of them come before the part [-].
    first, last : int
        Where the part begins and ends [-].
    margin, contrast : (n,) array
        1 - kappa; the cubic contrast of the forces [-].
    columns : (6 spacing,) array
        What slip takes, and what is not smooth about it near the onset [-].
    spacing : int
        Numbers from one column to the next [-].

    Returns
    -------
    int
        How many of the elements come before the next part [-].

    Notes
    -----
    Source: the derivation ``slip_table``.
    """
    while done < near.size and near[done] < last:
        i = near[done]
        part = onset_part(margin[i], contrast[i], DENOMINATOR * STRENGTHS[0 if margin[i] >= 0.0 else 1])
        for k in range(INTEGRALS):
            columns[spacing * k + i - first] -= part[k]
        done += 1
    return done
