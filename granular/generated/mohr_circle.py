"""Sliding contacts on Mohr's circle: scalar functions.

Emitted by ``derivations write`` from the derivation ``mohr_circle``; do not edit.
Source: (21), (23) of Pan & Dong (1999).
Domain: a, c > 0: no contact opens, unless stated; mu > 0.
Operations: 83 (36 in the outputs as derived).
"""

from __future__ import annotations

from math import cbrt, sqrt


def sticking_node(
    sinh_v: float, cosh_v: float, scale: float, left: float, kappa: float,
) -> tuple[float, float, float, float]:
    """A node of sinh(sigma/2) = scale sinh(v), for contacts that all stick.

    With left = 1 - kappa and scale = sqrt(left/2) or more. growth is exp(|sigma|), rate is d(sigma)/dv, chi
    is the shear stiffness over that without slip, loss is 1 - chi.

    Parameters
    ----------
    sinh_v : float [-]
    cosh_v : float [-]
    scale : float [-]
    left : float [-]
    kappa : float [-]
        Largest share of its friction that a contact uses up.

    Returns
    -------
    growth : float [-]
    rate : float [-]
    chi : float [-]
    loss : float [-]

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


def beside_node(P: float, slope: float, edge_sine: float) -> tuple[float, float, float, float]:
    """A node of sinh(sigma/2) = edge_sine (1 + P), for sticking contacts beside a sliding range.

    With P = e^(2w)/(2 (1 + e^w)), slope = dP/dw and edge_sine = sinh(psi/2) at the edge of the range. growth
    is exp(|sigma| - psi), the ratio of tan(beta) to its value at the edge.

    Parameters
    ----------
    P : float [-]
    slope : float [-]
    edge_sine : float [-]

    Returns
    -------
    growth : float [-]
    rate : float [-]
    chi : float [-]
    loss : float [-]

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


def between_node(sinh_v: float, cosh_v: float, edge_sine: float, reach: float) -> tuple[float, float]:
    """A node of sinh(sigma/2) = edge_sine S/sqrt(reach^2 + S^2), inside a sliding range.

    With edge_sine = sinh(psi/2) at the ends of the range and reach = sqrt(1 + edge_sine^2).

    Parameters
    ----------
    sinh_v : float [-]
    cosh_v : float [-]
    edge_sine : float [-]
    reach : float [-]

    Returns
    -------
    growth : float [-]
    rate : float [-]

    Operations: 21.
    """
    under = sqrt(reach*reach + sinh_v*sinh_v)
    q = edge_sine*sinh_v/under
    root = sqrt(q*q + 1)
    growth = (root + abs(q))**2
    rate = 2*cosh_v*edge_sine*reach*reach/(root*under*under*under)
    return growth, rate
