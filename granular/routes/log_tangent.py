"""One rule for all contacts, sticking, nearly sliding and sliding: the trapezoidal rule in the logarithm of tan(beta).

With t = tan(beta) = sqrt(c/a) exp(sigma) the share of its friction that a contact uses up is kappa/cosh(sigma), so
that the shear stiffness loses the factor chi = (1 - kappa/cosh(sigma))^(1/3), whatever the fabric and the stress.
Everything else has its singularities on the lines Im(sigma) = +-pi/2. Three maps send the sticking directions, the
directions beside a sliding range, and the sliding range itself to a whole line on which the integrand is analytic in
a strip of half width pi/4 and dies off exponentially. There the trapezoidal rule errs like exp(-2 pi (pi/4)/step).
Nodes hurry off beyond the last singularity, see ``log_tangent_tables``.

What each node computes is emitted from ``derivations.slip_rule``; the maps are proved in ``derivations.slip_maps``.
They need no function but square and cube roots once exp and sinh of fixed nodes are tabulated. An arc is a list of
nodes (t, measure, chi, gamma) with gamma = 1 - chi formed without subtraction.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from math import sqrt

from granular.generated.mohr_circle import beside_node, between_node, sticking_node
from granular.routes.fineness import FULL, Fineness
from granular.routes.log_tangent_tables import first_node, hyperbolic, one_sided, reached, start_after
from granular.routes.work import Work

TANGENT = 2.0**-40
"""Smallest scale r of the map beside a direction that is about to slide. A smaller one leaves r^(5/3) = 1e-20 of a
moment of chi unresolved; moments of 1/chi, which grow there, use ``TANGENT_INVERSE``, with r^(1/3) = 1e-18."""

TANGENT_INVERSE = 2.0**-180

WIDEST = 2.0**60
"""Largest scale of the maps beside a sliding range; beyond it their shape changes by less than 2^-120."""

Node = tuple[float, float, float, float]
"""t = tan(beta), measure d(sigma), chi and gamma [-]."""

STICKING, BESIDE, BETWEEN = Work(22, 2), Work(42, 3), Work(19, 2)
"""Of one node of each of the three maps."""


def node_range(first: float, last: float, steps: int = FULL.steps) -> range:
    """Numbers of the nodes between two values of w."""
    return range(math.floor(first * steps - 0.5), math.ceil(last * steps - 0.5) + 1)


def half_sinh(sigma: float) -> float:
    """Return sinh(sigma/2) for any finite sigma that fits."""
    return math.sinh(min(max(sigma / 2, -700.0), 700.0))


def singular_sine(distance: float) -> float:
    """Modulus of sinh(sigma/2) at the singularities sigma = +-distance +- i pi/2 [-]."""
    return sqrt(math.cosh(min(distance, 700.0)) / 2)


def sticking(center: float, low: float, high: float, *, r: float, delta: float, kappa: float,
             singular: float, fineness: Fineness = FULL) -> Iterator[Node]:
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
    singular : float
        Largest distance of a singularity of forces, directions or branch lengths from the centre, in sigma [-].
    fineness : Fineness
        How close the nodes are.

    Yields
    ------
    Node
        t, measure, chi, gamma [-].
    """
    middle = math.log(center)
    start = start_after(math.asinh(singular_sine(singular) / r))
    first, last = (reached(math.asinh(half_sinh(end - middle) / r), start) for end in (low, high))
    table, step = hyperbolic(start, fineness.steps), 1 / fineness.steps
    for j in node_range(first, last, fineness.steps):
        sine, cosine = table[j if j >= 0 else -1 - j]
        growth, rate, chi, loss = sticking_node(sine, cosine, r, delta, kappa)
        yield center * growth if j >= 0 else center / growth, rate * step, chi, loss


def beside(edge: float, end: float, *, rho: float, outward: bool, singular: float,
           fineness: Fineness = FULL) -> Iterator[Node]:
    """Nodes of the sticking directions beside a sliding range: sinh(sigma/2) = rho (1 + P(v)).

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
    singular : float
        How far beyond the edge the last singularity lies, in sigma [-], >= 0.
    fineness : Fineness
        How close the nodes are.

    Yields
    ------
    Node
        t, measure, chi, gamma [-].
    """
    psi, distance = 2 * math.asinh(rho), abs(end - math.log(edge))
    start = start_after(math.asinh(singular_sine(psi + singular) / rho))
    last = reached(math.acosh(max(1.0, half_sinh(psi + distance) / rho)), start)
    count, step = math.ceil(last * fineness.steps) - first_node(fineness) + 1, 1 / fineness.steps
    for grown, pace in one_sided(start, fineness)[:count]:
        p = grown * grown / (2 * (1 + grown))
        growth, rate, chi, loss = beside_node(p, p * (2 + grown) / (1 + grown) * pace, rho)
        yield edge * growth if outward else edge / growth, rate * step, chi, loss


def between(first: float, last: float, *, singular: float, fineness: Fineness = FULL) -> Iterator[Node]:
    """Nodes of a range in which every contact slides: sinh(sigma/2) = rho S/sqrt(1 + rho^2 + S^2), S = sinh(v).

    Parameters
    ----------
    first, last : float
        tan(beta) at its ends [-].
    singular : float
        Largest distance of a singularity of forces and directions from the middle, in sigma [-].
    fineness : Fineness
        How close the nodes are.

    Yields
    ------
    Node
        t, measure, chi = 0, gamma = 1 [-].
    """
    # from the quotient: logarithms of far ends would lose the place of the near one
    edge = sqrt(sqrt(last / first))
    center, rho = sqrt(first) * sqrt(last), (edge - 1) * (edge + 1) / (2 * edge)
    reach = sqrt(1 + rho * rho)
    start = start_after(math.asinh(1.5 * singular_sine(min(singular, 2 * math.log(edge)))))
    far = reached(math.log(reach) + 21.5 * fineness.share, start)
    table, step = hyperbolic(start, fineness.steps), 1 / fineness.steps
    for j in node_range(-far, far, fineness.steps):
        sine, cosine = table[j if j >= 0 else -1 - j]
        growth, rate = between_node(sine, cosine, rho, reach)
        yield center * growth if j >= 0 else center / growth, rate * step, 0.0, 1.0
