"""Which directions to take where friction wears on the shear stiffness, and what the contacts do in each of them."""

from __future__ import annotations

import math
from collections.abc import Iterator
from math import sqrt
from typing import TYPE_CHECKING

from granular.hypothesis import Hypothesis
from granular.routes import log_tangent
from granular.routes.contact_rule import NORMAL, ContactRule, normal_stiffness
from granular.routes.fineness import Fineness
from granular.routes.log_tangent import BESIDE, BETWEEN, STICKING, TANGENT, TANGENT_INVERSE, WIDEST
from granular.routes.meridian import Directions
from granular.routes.slip_geometry import Sliding, Sticking, slip_geometry
from granular.routes.windows import EQUATOR, POLE, place_of_forces, places_of_branches, window
from granular.routes.work import Work

if TYPE_CHECKING:
    from granular.fabric import AxialFabric
    from granular.loading import Loading


def slipping_contacts(fabric: AxialFabric, loading: Loading, hypothesis: Hypothesis,
                      fineness: Fineness) -> ContactRule:
    """Choose nodes for contacts that slip against friction, none of which has opened.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branch lengths about axis 3 [-].
    loading : Loading
        Stress and friction, mu > 0.
    hypothesis : Hypothesis
        Kinematic or static.
    fineness : Fineness
        How close the nodes are.

    Returns
    -------
    ContactRule
        Nodes that integrate every moment to what the fineness promises.

    Notes
    -----
    Source: ``granular.routes.log_tangent``.
    """
    a, c = loading.coefficients(fabric.D33)
    branches = places_of_branches(fabric, hypothesis)
    low, high = window(branches, a, c, hypothesis, slips=True, share=fineness.share)
    places = [*branches, *([place_of_forces(a, c)] if a > 0 and c > 0 else [])]
    geometry = slip_geometry(a, c, loading.friction or 0.0)
    smallest = TANGENT if hypothesis is Hypothesis.KINEMATIC else TANGENT_INVERSE
    nodes: list[log_tangent.Node] = []
    work = Work()
    for price, arc in _arcs(geometry, low, high, smallest, places, fineness):
        before = len(nodes)
        nodes += arc
        work += price * (len(nodes) - before)
    rule = Directions.of_tangents((t, measure) for t, measure, _, _ in nodes)
    return ContactRule(rule, normal_stiffness(rule, float(a), float(c)), tuple(node[2] for node in nodes),
                       tuple(node[3] for node in nodes), fineness.error,
                       work + rule.work_of_tangents() + NORMAL * len(nodes))


def _arcs(geometry: Sticking | Sliding, low: float, high: float, smallest: float, places: list[float],
          fineness: Fineness) -> Iterator[tuple[Work, Iterator[log_tangent.Node]]]:
    """Arcs of nodes, and what each of their nodes takes."""
    if isinstance(geometry, Sticking):
        r, middle = max(sqrt(geometry.delta / 2), smallest), math.log(geometry.center)
        yield STICKING, log_tangent.sticking(
            geometry.center, low, high, r=r, delta=geometry.delta, kappa=geometry.kappa,
            singular=max(abs(place - middle) for place in places), fineness=fineness)
        return
    pole, equator, rho = geometry.pole, geometry.equator, min(geometry.rho, WIDEST)
    if pole is not None and equator is not None and rho < smallest:
        touching = Sticking(center=sqrt(pole) * sqrt(equator), kappa=1.0, delta=0.0)
        yield from _arcs(touching, low, high, smallest, places, fineness)
        return
    if pole is not None:
        edge = math.log(pole)
        yield BESIDE, log_tangent.beside(pole, min(low, edge + fineness.share * POLE), rho=rho, outward=False,
                                         singular=max(0.0, edge - min(places)), fineness=fineness)
    if equator is not None:
        edge = math.log(equator)
        yield BESIDE, log_tangent.beside(equator, max(high, edge + fineness.share * EQUATOR), rho=rho, outward=True,
                                         singular=max(0.0, max(places) - edge), fineness=fineness)
    first, last = max(pole or 0.0, math.exp(low)), min(equator or math.inf, math.exp(high))
    if first < last:
        middle = (math.log(first) + math.log(last)) / 2
        yield BETWEEN, log_tangent.between(first, last, singular=max(abs(place - middle) for place in places),
                                           fineness=fineness)
