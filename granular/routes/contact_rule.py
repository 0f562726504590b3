"""Which directions to take, and what the contacts do in each of them: forces, slip, sliding and opening.

Needs nothing but ``math``, fractions and decimals of the standard library.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from math import cbrt, sqrt
from typing import TYPE_CHECKING

from granular.hypothesis import Hypothesis
from granular.routes import log_tangent
from granular.routes.log_tangent import TANGENT, TANGENT_INVERSE, WIDEST
from granular.routes.log_tangent_opening import closed_contacts, opened_range
from granular.routes.meridian import Directions
from granular.routes.slip_geometry import Sliding, Sticking, slip_geometry

if TYPE_CHECKING:
    from granular.fabric import AxialFabric
    from granular.loading import Loading

POLE, EQUATOR = -21.0, 41.0
"""log(tan(beta)) beyond which 2^-60 of a moment is left: contacts thin out like tan(beta)^2 towards the pole and like
1/tan(beta) towards the equator."""

POLE_INVERSE, EQUATOR_INVERSE = -32.0, 123.0
"""The same where the inverse of a vanishing normal force lets moments grow by tan(beta)^(2/3) on the way."""

POLE_SLIP, EQUATOR_SLIP = -26.0, 62.0
"""The same for what slip takes from the shear stiffness, which may grow by tan(beta) where the force vanishes like
tan(beta)^(2/3), on the way to a direction of vanishing force."""


@dataclass(frozen=True, slots=True)
class ContactRule:
    """Directions with weights, and what the contacts do in each of them.

    Attributes
    ----------
    directions : Directions
        Directions and weights.
    normal : tuple of float
        k_n/k_n,ref at each node [-].
    chi, gamma : tuple of float or None
        (k_r/k_n)/lambda_0 and 1 minus that [-]; None where no contact slips.
    """

    directions: Directions
    normal: tuple[float, ...]
    chi: tuple[float, ...] | None = None
    gamma: tuple[float, ...] | None = None

    def __len__(self) -> int:
        """Count the nodes."""
        return len(self.directions)


@lru_cache(maxsize=16)
def suitable_contacts(fabric: AxialFabric, loading: Loading | None, hypothesis: Hypothesis) -> ContactRule:
    """Choose the nodes for a fabric, a loading and a hypothesis.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branch lengths about axis 3 [-].
    loading : Loading or None
        Stress and friction; None for contacts of equal stiffness.
    hypothesis : Hypothesis
        Kinematic or static.

    Returns
    -------
    ContactRule
        Nodes that integrate every moment to rounding.

    Raises
    ------
    ComplianceInfinite
        Static hypothesis with contacts that slide or have opened.

    Notes
    -----
    Source: ``granular.routes.log_tangent``.
    """
    branches = _places_of_branches(fabric, hypothesis)
    if loading is None:
        rule = plain_rule(POLE + min(0.0, *map(math.floor, branches)), EQUATOR + max(0.0, *map(math.ceil, branches)),
                          math.ceil(max(map(abs, branches))))
        return ContactRule(rule, (1.0,) * len(rule))
    a, c = loading.coefficients(fabric.D33)
    if hypothesis is Hypothesis.STATIC:
        loading.require_finite_compliance(fabric.D33)
    slips = loading.slips(fabric.D33) and loading.friction != 0
    low, high = _window(branches, a, c, hypothesis, slips=slips)
    if loading.opens():
        return _opened(a, c, loading.friction, low, high)
    # singularities of the directions, of vanishing forces, of the branches
    places = [*branches, *([_place_of_forces(a, c)] if a > 0 and c > 0 else [])]
    if not slips or loading.friction is None:
        rule = plain_rule(low, high, math.ceil(max(map(abs, places))))
        normal = _normal(rule, float(a), float(c))
        slides = loading.friction == 0
        nothing, all_of_it = (0.0,) * len(rule), (1.0,) * len(rule)
        return ContactRule(rule, normal, nothing, all_of_it) if slides else ContactRule(rule, normal)
    geometry = slip_geometry(a, c, loading.friction)
    smallest = TANGENT if hypothesis is Hypothesis.KINEMATIC else TANGENT_INVERSE
    nodes = list(_slip_nodes(geometry, low, high, smallest, places))
    rule = Directions.of_tangents((t, measure) for t, measure, _, _ in nodes)
    return ContactRule(rule, _normal(rule, float(a), float(c)), tuple(node[2] for node in nodes),
                       tuple(node[3] for node in nodes))


def contacts_at(rule: Directions, fabric: AxialFabric, loading: Loading) -> ContactRule:
    """Evaluate the contact stiffness at the nodes of any rule, as eqs (20) and (21) stand.

    Parameters
    ----------
    rule : Directions
        Directions and weights.
    fabric : AxialFabric
        Contact normals and branch lengths about axis 3 [-].
    loading : Loading
        Stress and friction.

    Returns
    -------
    ContactRule
        The same nodes with what the contacts do there; next to the onset of sliding chi loses digits.

    Notes
    -----
    Source: eqs (20), (21) and (23).
    """
    exact_a, exact_c = loading.coefficients(fabric.D33)
    a, c, d = float(exact_a), float(exact_c), abs(float(exact_c - exact_a))
    force = [max(a * s + c * y, 0.0) for s, y in zip(rule.sine_squared, rule.cosine_squared, strict=True)]
    normal = tuple(map(cbrt, force))
    if not loading.slips(fabric.D33):
        return ContactRule(rule, normal)
    left = [1 - d * sqrt(s * y) / (loading.friction * f) if loading.friction and f else 0.0
            for s, y, f in zip(rule.sine_squared, rule.cosine_squared, force, strict=True)]
    chi = tuple(cbrt(max(share, 0.0)) for share in left)
    return ContactRule(rule, normal, chi, tuple(1 - share for share in chi))


def _window(branches: list[float], a: Fraction, c: Fraction, hypothesis: Hypothesis, *,
            slips: bool) -> tuple[float, float]:
    """Range of log(tan(beta)) that matters, in whole units."""
    first, last = min(branches), max(branches)
    if hypothesis is Hypothesis.KINEMATIC:
        low, high = (POLE_SLIP, EQUATOR_SLIP) if slips else (POLE, EQUATOR)
        return math.floor(low + first), math.ceil(high + last)
    forces = _place_of_forces(a, c)
    if slips:
        return math.floor(POLE + min(forces, first)), math.ceil(EQUATOR + max(forces, last))
    low, high = max(POLE_INVERSE, POLE + min(0.0, forces)), min(EQUATOR_INVERSE, EQUATOR + max(0.0, forces))
    return math.floor(low + first), math.ceil(high + last)


def _place_of_forces(a: Fraction, c: Fraction) -> float:
    """log(tan(beta)) at which the normal force has its singularity."""
    if a > 0 and c > 0:
        return (math.log(c) - math.log(a)) / 2
    return math.inf if c > a else -math.inf


def _places_of_branches(fabric: AxialFabric, hypothesis: Hypothesis) -> list[float]:
    """log(tan(beta)) at which the directions and the branches have their singularities, where they have any."""
    if not fabric.collinear:  # s + r^2 y in a denominator; s + r^4 y there and under a root
        shape = math.log(fabric.aspect_ratio)
        return [0.0, shape] if hypothesis is Hypothesis.KINEMATIC else [0.0, 2 * shape]
    if hypothesis is Hypothesis.KINEMATIC:
        return [0.0]
    return [0.0, (math.log(1 + fabric.Dr33) - math.log(1 - fabric.Dr33 / 2)) / 2]


def _slip_nodes(geometry: Sticking | Sliding, low: float, high: float, smallest: float,
                places: list[float]) -> Iterator[log_tangent.Node]:
    if isinstance(geometry, Sticking):
        r, middle = max(sqrt(geometry.delta / 2), smallest), math.log(geometry.center)
        yield from log_tangent.sticking(
            geometry.center, low, high, r=r, delta=geometry.delta, kappa=geometry.kappa,
            singular=max(abs(place - middle) for place in places))
        return
    pole, equator, rho = geometry.pole, geometry.equator, min(geometry.rho, WIDEST)
    if pole is not None and equator is not None and rho < smallest:
        touching = Sticking(center=sqrt(pole) * sqrt(equator), kappa=1.0, delta=0.0)
        yield from _slip_nodes(touching, low, high, smallest, places)
        return
    if pole is not None:
        edge = math.log(pole)
        yield from log_tangent.beside(pole, min(low, edge + POLE), rho=rho, outward=False,
                                      singular=max(0.0, edge - min(places)))
    if equator is not None:
        edge = math.log(equator)
        yield from log_tangent.beside(equator, max(high, edge + EQUATOR), rho=rho, outward=True,
                                      singular=max(0.0, max(places) - edge))
    first, last = max(pole or 0.0, math.exp(low)), min(equator or math.inf, math.exp(high))
    if first < last:
        middle = (math.log(first) + math.log(last)) / 2
        yield from log_tangent.between(first, last, singular=max(abs(place - middle) for place in places))


@lru_cache(maxsize=64)
def plain_rule(low: float, high: float, singular: int) -> Directions:
    """Nodes for contacts that do not slip.

    Parameters
    ----------
    low, high : float
        Range of log(tan(beta)) that matters [-].
    singular : int
        Largest distance of a singularity of forces, directions or branch lengths from 45 deg, in log(tan(beta)) [-].

    Returns
    -------
    Directions
        Nodes that integrate every moment to rounding.
    """
    return Directions.of_tangents((t, measure) for t, measure, _, _ in log_tangent.sticking(
        1.0, low, high, r=sqrt(0.5), delta=1.0, kappa=0.0, singular=singular))


def _normal(rule: Directions, a: float, c: float) -> tuple[float, ...]:
    return tuple(cbrt(a * s + c * y) for s, y in zip(rule.sine_squared, rule.cosine_squared, strict=True))


def _opened(a: Fraction, c: Fraction, friction: float | None, low: float, high: float) -> ContactRule:
    """Contacts are closed around the equator (c < 0), or around the pole (a < 0)."""
    towards_equator = a > 0
    pressed, pulled, end = (a, c, high) if towards_equator else (c, a, -low)
    where = opened_range(pressed, pulled, friction or None)
    nodes = list(closed_contacts(where, end))
    rule = Directions.of_tangents((u if towards_equator else 1 / u, measure) for u, measure, *_ in nodes)
    scale = float(pressed)
    # force/(1 + u^2): 1/(1 + u^2) is y, or s where the coordinate is the inverse tangent
    shrink = rule.cosine_squared if towards_equator else rule.sine_squared
    normal = tuple(cbrt(scale * force * part) for (*_, force), part in zip(nodes, shrink, strict=True))
    if friction is None:
        return ContactRule(rule, normal)
    if friction == 0:
        return ContactRule(rule, normal, (0.0,) * len(nodes), (1.0,) * len(nodes))
    return ContactRule(rule, normal, tuple(node[2] for node in nodes), tuple(node[3] for node in nodes))
