"""Steps of the loops for partial slip: shares of friction, panels, the onset, components. Each is to be compiled."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from granular.batch.slip_layout import (
    ALIGNED,
    COLUMN_WIDTH,
    COLUMNS,
    CONTRAST,
    CONTRASTS,
    DELICATE,
    INTEGRALS,
    STRENGTHS,
    ZONE,
)
from granular.batch.slip_share import friction_used
from granular.generated.slip_table_array import onset_part, slip_components

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]
    Index = NDArray[np.int64]


def shares(D33: Array, stress_ratio: Array, friction: Array, state: Array, kappa: Array, margin: Array,
           near: Index) -> int:
    """Fill kappa and 1 - kappa of each element, NaN where there is no friction, and find those near the onset.

    Parameters
    ----------
    D33, stress_ratio, friction : (n,) array
        As for ``axial_stiffness`` [-].
    state : (6 n,) array
        From ``slip_state`` [-].
    kappa, margin : (n,) array
        To be filled [-].
    near : (n,) array of int
        To be filled, as far as there are any, with the elements whose margin is below ``ZONE`` [-].

    Returns
    -------
    int
        How many these are [-].

    Notes
    -----
    Accuracy: some 512 units in the last place of kappa; a few where the margin is small. Source: the derivation
    ``slip_table``.
    """
    size, found = D33.size, 0
    for i in range(size):
        contrast = state[CONTRAST * size + i]
        square = contrast * contrast
        product = 1.0 - square
        kappa[i] = (3.0 + square) * abs(contrast) / (friction[i] * (product * np.sqrt(product)))
        margin[i] = 1.0 - kappa[i]
    for i in range(size):
        if not friction[i] > 0.0:
            kappa[i] = margin[i] = np.nan
        elif abs(margin[i]) < 1.01 * ZONE or abs(state[CONTRAST * size + i]) < DELICATE:
            kappa[i], margin[i] = friction_used(D33[i], stress_ratio[i], friction[i])
            if abs(margin[i]) < ZONE:
                near[found] = i
                found += 1
    return found


def contrast_panels(state: Array, side: int, varies: bool, panel: Index, across: Array) -> None:
    """Go on from the panel of the margin to that of the contrast as well.

    Parameters
    ----------
    state : (6 n,) array
        From ``slip_state`` [-].
    side : int
        Panels of the margin on each side of the onset [-].
    varies : bool
        Whether friction varies: then there are panels of the contrast, else its sign decides.
    panel : (n,) array of int
        Panel of the margin, changed in place [-].
    across : (n,) array
        To be filled with the place in a panel of the contrast, from -1 to 1, if friction varies [-].

    Notes
    -----
    Source: the table.
    """
    size = panel.size
    for i in range(size):
        contrast = state[CONTRAST * size + i]
        if varies:
            position = (contrast - CONTRASTS[0]) / COLUMN_WIDTH
            column = int(min(position if position > 0.0 else 0.0, COLUMNS - 0.5))
            across[i] = 2.0 * (position - column) - 1.0
            panel[i] = panel[i] * COLUMNS + column
        elif contrast < 0.0:
            panel[i] += 2 * side


def sort_by_panel(panel: Index, margin: Array, start: Index, where: Index, variable: Array) -> None:
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
        where[i] = start[panel[i] + 1]
        start[panel[i] + 1] += 1
    for one in range(start.size - 1):
        start[one + 1] = start[one] + (start[one + 1] + ALIGNED - 1) // ALIGNED * ALIGNED
    for i in range(panel.size):
        place = where[i] + start[panel[i]]
        where[i] = place
        variable[place] = abs(margin[i])


def in_order(lost: Array, where: Index, kappa: Array, lost_here: Array) -> None:
    """Bring what slip takes back into the order of the elements, times kappa.

    Parameters
    ----------
    lost : (6, places) array
        Values of the table, in sorted order [-].
    where : (n,) array of int
        Sorted place of each element [-].
    kappa : (n,) array
        Share of the friction that is used up [-].
    lost_here : (6, m) array
        To be filled up to n <= m [-].

    Notes
    -----
    Source: the table.
    """
    for k in range(INTEGRALS):
        own, here = lost[k], lost_here[k]
        for i in range(where.size):
            here[i] = own[where[i]] * kappa[i]


def take_onset_out(near: Index, done: int, first: int, last: int, margin: Array, state: Array, lost: Array) -> int:
    """Take the part that is not smooth out of the elements near the onset, as far as they are in a part of all.

    Parameters
    ----------
    near : (m,) array of int
        Elements near the onset, in their order [-].
    done : int
        How many of them come before the part [-].
    first, last : int
        Where the part begins and ends [-].
    margin : (n,) array
        1 - kappa [-].
    state : (6 n,) array
        From ``slip_state`` [-].
    lost : (6, last - first or more) array
        What slip takes, and what is not smooth about it near the onset [-].

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
        part = onset_part(margin[i], state[CONTRAST * margin.size + i], STRENGTHS[0 if margin[i] >= 0.0 else 1])
        for k in range(INTEGRALS):
            lost[k, i - first] -= part[k]
        done += 1
    return done


def write_components(D33: Array, Dr33: Array, state: Array, first: int, last: int, lost: Array, out: Array) -> int:
    """Write the components of a part of the elements, and count those that are not served.

    Parameters
    ----------
    D33, Dr33 : (n,) array
        As for ``axial_stiffness`` [-].
    state : (6 n,) array
        From ``slip_state`` [-].
    first, last : int
        Where the part begins and ends [-].
    lost : (6, last - first or more) array
        What slip takes from them [-].
    out : (6 n,) array
        To be filled as far as the part goes [-].

    Returns
    -------
    int
        Elements that are not served: all their components are NaN [-].

    Notes
    -----
    Source: the derivation ``slip_table``.
    """
    size, unserved = D33.size, 0
    d, dr, rows = D33[first:last], Dr33[first:last], out[6 * first:6 * last]
    sum0, sum1, sum2 = state[first:last], state[size + first:size + last], state[2 * size + first:2 * size + last]
    level, shear = state[3 * size + first:3 * size + last], state[5 * size + first:5 * size + last]
    for i in range(last - first):
        place = 6 * i
        found = slip_components(
            d[i], dr[i], sum0[i], sum1[i], sum2[i], level[i], shear[i],
            lost[0, i], lost[1, i], lost[2, i], lost[3, i], lost[4, i], lost[5, i])
        rows[place] = found[0]
        rows[place + 1] = found[1]
        rows[place + 2] = found[2]
        rows[place + 3] = found[3]
        rows[place + 4] = found[4]
        rows[place + 5] = found[5]
        unserved += found[0] != found[0]
    return unserved
