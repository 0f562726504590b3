"""The rule in the logarithm of tan(beta) where one principal stress is a tension and contacts have opened.

The coordinate is u = tan(beta), or its inverse, so that contacts are closed for u > u0. There the normal force is
b (u - u0)(u + u0)/(1 + u^2), and with friction contacts slide from u0 to u1 and stick beyond. Distances from u0 are
formed without subtraction, so that the rules stay good however close u1 comes to u0.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from decimal import Decimal, localcontext
from fractions import Fraction
from math import cbrt, sqrt

from granular.routes.decimals import DIGITS, decimal
from granular.routes.fineness import FULL, Fineness
from granular.routes.log_tangent import half_sinh, node_range, singular_sine
from granular.routes.log_tangent_tables import first_node, hyperbolic, one_sided, reached, start_after
from granular.routes.work import Work

Opened = tuple[float, float, float, float, float]
"""u, measure d(sigma), chi, gamma, and the normal force times (1 + u^2)/b [-]."""


NEAREST = 42.0
"""How near nodes come to the end of the sticking contacts, -v, when nothing but rounding may be left: e^v is left."""


@dataclass(frozen=True, slots=True)
class OpenedRange:
    """Where contacts are open, slide and stick.

    Attributes
    ----------
    edge : float
        u0: contacts are open below it [-].
    slip_edge : float
        u1: contacts slide between u0 and u1 [-]; u0 itself without friction data.
    gap : float
        u1 - u0 [-], without cancellation.
    rate : float
        \\|c - a\\|/(mu b) [-]; 0 without friction data.
    """

    edge: float
    slip_edge: float
    gap: float
    rate: float


def opened_range(pressed: Fraction, pulled: Fraction, friction: float | None) -> OpenedRange:
    """Find where contacts are open, slide and stick.

    Parameters
    ----------
    pressed, pulled : Fraction
        Coefficient of the normal force in the direction that is compressed, > 0, and in the other one, < 0 [-].
    friction : float or None
        mu [-], > 0; None for contacts that never slip.

    Returns
    -------
    OpenedRange
        Rounded once from 50 digits.

    Notes
    -----
    Source: roots of b u^2 - \\|b'\\| and of b u^2 - (\\|c - a\\|/mu) u - \\|b'\\|, eqs (21) and (23).

    Examples
    --------
    >>> opened_range(Fraction(1), Fraction(-1, 4), None).edge
    0.5
    """
    with localcontext(DIGITS):
        edge = decimal(-pulled / pressed).sqrt()
        if friction is None:
            return OpenedRange(float(edge), float(edge), 0.0, 0.0)
        half = min(decimal((pressed - pulled) / (2 * pressed * Fraction(friction))), Decimal(2) ** 450)
        root = (half * half + edge * edge).sqrt()
        gap = half + half * half / (root + edge)
        return OpenedRange(float(edge), float(edge + gap), float(gap), float(2 * half))


def closed_contacts(where: OpenedRange, end: float, places: list[float],
                    fineness: Fineness = FULL) -> Iterator[Opened]:
    """Nodes over the contacts that are closed, the sliding ones included.

    Parameters
    ----------
    where : OpenedRange
        From :func:`opened_range`.
    end : float
        log(u) up to which directions matter [-].
    places : list of float
        log(u) of the singularities of directions and branches [-].
    fineness : Fineness
        How close the nodes are.

    Yields
    ------
    Opened
        u, measure, chi, gamma, force [-].
    """
    yield from _sticking(where, end, max(places), fineness)
    if where.gap > 0:
        yield from _sliding(where, places, fineness)


STICKING, STICKING_ALL, SLIDING, SLIDING_BEFORE = Work(21, 1), Work(12), Work(23, 3), Work(3)
"""Of one node of each of the two maps, of the first without friction data, and what the second takes besides in the
half towards the open contacts."""


def work_of_closed(where: OpenedRange, nodes: list[Opened]) -> Work:
    """Count what :func:`closed_contacts` did.

    Parameters
    ----------
    where : OpenedRange
        From :func:`opened_range`.
    nodes : list of Opened
        Its nodes.

    Returns
    -------
    Work
        Operations and functions.
    """
    if not where.gap:
        return STICKING_ALL * len(nodes)
    sliding = [u for u, _, chi, _, _ in nodes if chi == 0.0]
    middle = math.sqrt(where.edge) * math.sqrt(where.slip_edge)
    return (STICKING * (len(nodes) - len(sliding)) + SLIDING * len(sliding)
            + SLIDING_BEFORE * sum(u < middle for u in sliding))


def _sticking(where: OpenedRange, end: float, singular: float, fineness: Fineness) -> Iterator[Opened]:
    """Sticking contacts by u = u1 (1 + e^v)^2, analytic up to Im(v) = pi/4, zeros of force and slip on Im(v) = pi.

    Nodes hurry below the zero of the force, whose distance from u1 decides where that is, and beyond the singularities.
    """
    u0, u1, step = where.edge, where.slip_edge, 1 / fineness.steps
    far = (max(end, math.log(u1) + 41.0 * fineness.share) - math.log(u1)) / 2
    narrow = math.floor(math.log(where.gap / u1)) if 0 < where.gap < u1 else 0
    start = start_after(max(0.0, (singular - math.log(u1)) / 2) - narrow)
    last = reached(far - narrow, start)
    count = math.ceil(last * fineness.steps) - first_node(fineness, NEAREST) + 1
    scale, curved, measure = math.exp(narrow), u0 * u0 / u1, 2 * step
    for unscaled, pace in one_sided(start, fineness, NEAREST)[:count]:
        grown = scale * unscaled
        beyond = u1 * grown * (2 + grown)
        u = u1 + beyond
        above = beyond + where.gap
        force = above * (u + u0)
        if not where.gap:
            yield u, measure * pace * grown / (1 + grown), 1.0, 0.0, force
            continue
        left = beyond * (u + curved)
        chi = cbrt(left / force)
        yield u, measure * pace * grown / (1 + grown), chi, where.rate * u / force / (1 + chi + chi * chi), force


def _sliding(where: OpenedRange, places: list[float], fineness: Fineness) -> Iterator[Opened]:
    """From u0 to u1, by the map of a sliding range; the distance from u0 is formed from that of the mapped ends."""
    u0, middle = where.edge, (math.log(where.edge) + math.log(where.slip_edge)) / 2
    width = math.log1p(where.gap / u0) / 2  # sigma reaches from -width to width
    rho = half_sinh(width)
    across = reach = math.sqrt(1 + rho * rho)
    singular = max(abs(place - middle) for place in places)
    start = start_after(math.asinh(1.5 * singular_sine(min(singular, 2 * width))))
    far = reached(math.log(reach) + 31.0 * fineness.share, start)
    table = hyperbolic(start, fineness.steps)
    squared, both, twice, measure = reach * reach, rho * reach, u0 * 2, 2 / fineness.steps * rho
    for j in node_range(-far, far, fineness.steps):
        sine, cosine = table[j if j >= 0 else -1 - j]
        sine = sine if j >= 0 else -sine
        under = sqrt(squared + sine * sine)
        q = rho * sine / under
        root = sqrt(1 + q * q)
        half = (q * across + rho * root if q > 0 else (both / under) ** 2 / (rho * root - q * across))
        above = twice * half * (half + sqrt(1 + half * half))
        u = u0 + above
        yield u, measure * cosine / root * (reach / under) ** 2 / under, 0.0, 1.0, above * (u + u0)
