"""Steps of the loops for partial slip: shares of friction, panels, the onset, components. Each is to be compiled."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from granular.batch.slip_layout import ALIGNED, DELICATE, INTEGRALS, KNOWN, STRENGTHS, ZONE
from granular.batch.slip_share import friction_used
from granular.generated.slip_table_array import onset_part, slip_components

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]
    Index = NDArray[np.int64]


def shares(D33: Array, stress_ratio: Array, friction: Array, state: Array, kappa: Array, margin: Array) -> None:
    """Fill kappa and 1 - kappa of each element; NaN where there is no friction.

    Parameters
    ----------
    D33, stress_ratio, friction : (n,) array
        As for ``axial_stiffness`` [-].
    state : (6 n,) array
        From ``slip_state`` [-].
    kappa, margin : (n,) array
        To be filled [-].

    Notes
    -----
    Accuracy: some 128 units in the last place of kappa; a few where the margin is small. Source: the derivation
    ``slip_table``.
    """
    for i in range(D33.size):
        contrast = state[KNOWN * i + 4]
        square = contrast * contrast
        product = 1.0 - square
        kappa[i] = (3.0 + square) * abs(contrast) / (friction[i] * (product * np.sqrt(product)))
        margin[i] = 1.0 - kappa[i]
    for i in range(D33.size):
        if not friction[i] > 0.0:
            kappa[i] = margin[i] = np.nan
        elif abs(margin[i]) < 1.01 * ZONE or abs(state[KNOWN * i + 4]) < DELICATE:
            kappa[i], margin[i] = friction_used(D33[i], stress_ratio[i], friction[i])


def sort_by_panel(panel: Index, start: Index, where: Index) -> None:
    """Fill where each panel starts, and the place of each element among those of its panel.

    Parameters
    ----------
    panel : (n,) array of int
        Panel of each element [-].
    start : (panels + 1,) array of int
        To be filled with multiples of ``ALIGNED`` [-].
    where : (n,) array of int
        To be filled [-].

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
        where[i] += start[panel[i]]


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


def take_onset_out(margin: Array, state: Array, lost: Array) -> None:
    """Take the part that is not smooth out of the elements near the onset.

    Parameters
    ----------
    margin : (n,) array
        1 - kappa [-].
    state : (6 n,) array
        From ``slip_state`` [-].
    lost : (6, m) array
        What slip takes, and what is not smooth about it near the onset, n <= m [-].

    Notes
    -----
    Source: the derivation ``slip_table``.
    """
    for i in range(margin.size):
        if abs(margin[i]) < ZONE:
            part = onset_part(margin[i], state[KNOWN * i + 4], STRENGTHS[0 if margin[i] >= 0.0 else 1])
            for k in range(INTEGRALS):
                lost[k, i] -= part[k]


def write_components(D33: Array, Dr33: Array, state: Array, lost: Array, out: Array) -> int:
    """Write the components of each element, and count those that are not served.

    Parameters
    ----------
    D33, Dr33 : (n,) array
        As for ``axial_stiffness`` [-].
    state : (6 n,) array
        From ``slip_state`` [-].
    lost : (6, m) array
        What slip takes, n <= m [-].
    out : (6 n,) array
        To be filled [-].

    Returns
    -------
    int
        Elements that are not served: all their components are NaN [-].

    Notes
    -----
    Source: the derivation ``slip_table``.
    """
    unserved = 0
    for i in range(D33.size):
        known, place = KNOWN * i, 6 * i
        found = slip_components(
            D33[i], Dr33[i], state[known], state[known + 1], state[known + 2], state[known + 3], state[known + 5],
            lost[0, i], lost[1, i], lost[2, i], lost[3, i], lost[4, i], lost[5, i])
        out[place] = found[0]
        out[place + 1] = found[1]
        out[place + 2] = found[2]
        out[place + 3] = found[3]
        out[place + 4] = found[4]
        out[place + 5] = found[5]
        unserved += found[0] != found[0]
    return unserved
