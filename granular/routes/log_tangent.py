"""One rule for all contacts, sticking, nearly sliding and sliding: the trapezoidal rule in the logarithm of tan(beta).

With t = tan(beta) = sqrt(c/a) exp(sigma) the share of its friction that a contact uses up is kappa/cosh(sigma), so
that the shear stiffness loses the factor chi = (1 - kappa/cosh(sigma))^(1/3), whatever the fabric and the stress.
Everything else has its singularities on the lines Im(sigma) = +-pi/2. Three maps send the sticking directions, the
directions beside a sliding range, and the sliding range itself to a whole line on which the integrand is analytic in
a strip of half width pi/4 and dies off exponentially. There the trapezoidal rule errs like exp(-2 pi (pi/4)/step).

What each node computes is emitted from ``derivations.slip_rule``; the maps are proved in ``derivations.slip_maps``.
They need no function but square and cube roots once exp and sinh of fixed nodes are tabulated. An arc is a list of
nodes (t, measure, chi, gamma) with gamma = 1 - chi formed without subtraction.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import lru_cache
from math import sqrt

from granular.generated.mohr_circle import beside_node, between_node, sticking_node

STEPS = 12
"""Nodes for each unit of the mapped variable: exp(-2 pi (pi/4) 12) = 2e-26, times 1e7 for the high poles at t = +-i."""

STEP = 1 / STEPS

LONGEST = 400
"""Half length of the tables in units of the mapped variable; no scene of doubles comes near it."""

TANGENT = 2.0**-40
"""Smallest scale r of the map beside a direction that is about to slide. A smaller one leaves r^(5/3) = 1e-20 of a
moment of chi unresolved; moments of 1/chi, which grow there, use ``TANGENT_INVERSE``, with r^(1/3) = 1e-18."""

TANGENT_INVERSE = 2.0**-180

WIDEST = 2.0**60
"""Largest scale of the maps beside a sliding range; beyond it their shape changes by less than 2^-120."""

Node = tuple[float, float, float, float]
"""t = tan(beta), measure d(sigma), chi and gamma [-]."""


@lru_cache(maxsize=1)
def exponentials() -> tuple[float, ...]:
    """Exponentials exp((j + 1/2) step), j = 0, 1, ..., each to three units in the last place.

    Returns
    -------
    tuple of float
        The table [-]; whole and fractional part are raised separately, so that a long table stays as good.
    """
    fractions = [math.exp((j + 0.5) / STEPS) for j in range(STEPS)]
    return tuple(math.exp(whole) * fraction for whole in range(LONGEST) for fraction in fractions)


def _exponential(j: int) -> float:
    table = exponentials()
    return table[j] if j >= 0 else 1 / table[-1 - j]


def _hyperbolic(j: int) -> tuple[float, float]:
    """Return sinh and cosh of (j + 1/2) step."""
    grown = exponentials()[j if j >= 0 else -1 - j]
    sine = math.sinh((abs(j + 0.5)) / STEPS) if grown < 3 else (grown - 1 / grown) / 2
    return (sine if j >= 0 else -sine), (grown + 1 / grown) / 2


def _range(first: float, last: float) -> range:
    """Numbers of the nodes between two values of the mapped variable."""
    return range(math.floor(first * STEPS - 0.5), math.ceil(last * STEPS - 0.5) + 1)


def _half_sinh(sigma: float) -> float:
    """Return sinh(sigma/2) for any finite sigma that fits."""
    return math.sinh(min(max(sigma / 2, -700.0), 700.0))


def sticking(center: float, low: float, high: float, *, r: float, delta: float, kappa: float) -> Iterator[Node]:
    """Nodes over all directions when every contact sticks: sinh(sigma/2) = r sinh(v).

    Parameters
    ----------
    center : float
        tan(beta) where contacts are nearest to sliding [-].
    low, high : float
        Range of log(tan(beta)) that matters [-].
    r : float
        Scale of the map [-], sqrt((1 - kappa)/2) or larger.
    delta, kappa : float
        1 - kappa, and kappa [-].

    Yields
    ------
    Node
        t, measure, chi, gamma [-].
    """
    middle = math.log(center)
    first, last = (math.asinh(_half_sinh(end - middle) / r) for end in (low, high))
    for j in _range(first, last):
        sine, cosine = _hyperbolic(j)
        growth, rate, chi, loss = sticking_node(sine, cosine, r, delta, kappa)
        yield center * growth if sine > 0 else center / growth, rate * STEP, chi, loss


def beside(edge: float, end: float, *, rho: float, outward: bool) -> Iterator[Node]:
    """Nodes of the sticking directions beside a sliding range: sinh(sigma/2) = rho (1 + P(w)).

    Parameters
    ----------
    edge : float
        tan(beta) at the edge of the sliding range [-].
    end : float
        log(tan(beta)) up to which directions matter [-].
    rho : float
        sinh(psi/2) where cosh(psi) = kappa [-]; ``WIDEST`` for a wider range.
    outward : bool
        True for directions beyond the edge (towards the equator), False for those before it (towards the pole).

    Yields
    ------
    Node
        t, measure, chi, gamma [-].
    """
    distance = abs(end - math.log(edge))
    psi = 2 * math.asinh(rho)
    v = math.acosh(max(1.0, _half_sinh(min(psi + distance, 1300.0)) / rho))
    for j in _range(-21.0, v):
        grown = _exponential(j)
        p = grown * grown / (2 * (1 + grown))
        growth, rate, chi, loss = beside_node(p, p * (2 + grown) / (1 + grown), rho)
        yield edge * growth if outward else edge / growth, rate * STEP, chi, loss


def between(first: float, last: float) -> Iterator[Node]:
    """Nodes of a range in which every contact slides: sinh(sigma/2) = rho S/sqrt(1 + rho^2 + S^2), S = sinh(v).

    Parameters
    ----------
    first, last : float
        tan(beta) at its ends [-].

    Yields
    ------
    Node
        t, measure, chi = 0, gamma = 1 [-].
    """
    # from the quotient: logarithms of far ends would lose the place of the near one
    edge = sqrt(sqrt(last / first))
    center, rho = sqrt(first) * sqrt(last), (edge - 1) * (edge + 1) / (2 * edge)
    reach = sqrt(1 + rho * rho)
    far = math.log(reach) + 21.5
    for j in _range(-far, far):
        sine, cosine = _hyperbolic(j)
        growth, rate = between_node(sine, cosine, rho, reach)
        yield center * growth if sine > 0 else center / growth, rate * STEP, 0.0, 1.0
