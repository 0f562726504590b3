"""Sliding contacts on Mohr's circle: functions of arrays.

Emitted by ``derivations write`` from the derivation ``mohr_circle``; do not edit.
Source: (21), (23) of Pan & Dong (1999).
Domain: a, c > 0: no contact opens, unless stated; mu > 0.
Operations: 83 (36 in the outputs as derived).
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
import numpy.typing as npt
from numpy import cbrt, sqrt

Array: TypeAlias = npt.NDArray[np.float64]


def sticking_node(
    sinh_v: Array, cosh_v: Array, scale: Array, left: Array, kappa: Array,
) -> tuple[Array, Array, Array, Array]:
    """A node of sinh(sigma/2) = scale sinh(v), for contacts that all stick.

    With left = 1 - kappa and scale = sqrt(left/2) or more. growth is exp(|sigma|), rate is d(sigma)/dv, chi
    is the shear stiffness over that without slip, loss is 1 - chi.

    Parameters
    ----------
    sinh_v : (...) array [-]
    cosh_v : (...) array [-]
    scale : (...) array [-]
    left : (...) array [-]
    kappa : (...) array [-]
        Largest share of its friction that a contact uses up.

    Returns
    -------
    growth : (...) array [-]
    rate : (...) array [-]
    chi : (...) array [-]
    loss : (...) array [-]

    Operations: 25.
    """
    q = scale*sinh_v
    root = sqrt(q*q + 1)
    cosh_sigma = 2*q*q + 1
    share = (left + 2*q*q)/cosh_sigma
    chi = cbrt(share)
    loss = kappa/(cosh_sigma*(chi*chi + chi + 1))
    growth = (root + abs(q))**2
    rate = 2*cosh_v*scale/root
    return growth, rate, chi, loss


def beside_node(P: Array, slope: Array, edge_sine: Array) -> tuple[Array, Array, Array, Array]:
    """A node of sinh(sigma/2) = edge_sine (1 + P), for sticking contacts beside a sliding range.

    With P = e^(2w)/(2 (1 + e^w)), slope = dP/dw and edge_sine = sinh(psi/2) at the edge of the range. growth
    is exp(|sigma| - psi), the ratio of tan(beta) to its value at the edge.

    Parameters
    ----------
    P : (...) array [-]
    slope : (...) array [-]
    edge_sine : (...) array [-]

    Returns
    -------
    growth : (...) array [-]
    rate : (...) array [-]
    chi : (...) array [-]
    loss : (...) array [-]

    Operations: 37.
    """
    at_edge = edge_sine + sqrt(edge_sine*edge_sine + 1)
    q = edge_sine*(P + 1)
    root = sqrt(q*q + 1)
    cosh_sigma = 2*q*q + 1
    share = 2*P*edge_sine*edge_sine*(P + 2)/cosh_sigma
    chi = cbrt(share)
    loss = (2*edge_sine*edge_sine + 1)/(cosh_sigma*(chi*chi + chi + 1))
    growth = (q + root)**2/(at_edge*at_edge)
    rate = 2*edge_sine*slope/root
    return growth, rate, chi, loss


def between_node(sinh_v: Array, cosh_v: Array, edge_sine: Array, reach: Array) -> tuple[Array, Array]:
    """A node of sinh(sigma/2) = edge_sine S/sqrt(reach^2 + S^2), inside a sliding range.

    With edge_sine = sinh(psi/2) at the ends of the range and reach = sqrt(1 + edge_sine^2).

    Parameters
    ----------
    sinh_v : (...) array [-]
    cosh_v : (...) array [-]
    edge_sine : (...) array [-]
    reach : (...) array [-]

    Returns
    -------
    growth : (...) array [-]
    rate : (...) array [-]

    Operations: 21.
    """
    under = sqrt(reach*reach + sinh_v*sinh_v)
    q = edge_sine*sinh_v/under
    root = sqrt(q*q + 1)
    growth = (root + abs(q))**2
    rate = 2*cosh_v*edge_sine*reach*reach/(root*under*under*under)
    return growth, rate
