"""Which directions to take where contacts have opened, and what the closed ones do in each of them."""

from __future__ import annotations

from math import cbrt
from typing import TYPE_CHECKING

from granular.routes.contact_rule import ContactRule
from granular.routes.fineness import Fineness
from granular.routes.log_tangent_opening import closed_contacts, opened_range, work_of_closed
from granular.routes.meridian import Directions
from granular.routes.windows import places_of_branches, window
from granular.routes.work import Work

if TYPE_CHECKING:
    from granular.fabric import AxialFabric
    from granular.hypothesis import Hypothesis
    from granular.loading import Loading


def closed_contacts_of(fabric: AxialFabric, loading: Loading, hypothesis: Hypothesis,
                       fineness: Fineness) -> ContactRule:
    """Choose nodes for contacts around the equator, or around the pole, that a tension along the other has left.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branch lengths about axis 3 [-].
    loading : Loading
        Stress and friction; one principal stress is a tension.
    hypothesis : Hypothesis
        Kinematic.
    fineness : Fineness
        How close the nodes are.

    Returns
    -------
    ContactRule
        Nodes that integrate every moment to what the fineness promises.

    Notes
    -----
    Source: ``granular.routes.log_tangent_opening``.
    """
    a, c = loading.coefficients(fabric.D33)
    branches = places_of_branches(fabric, hypothesis)
    low, high = window(branches, a, c, hypothesis,
                       slips=loading.slips(fabric.D33) and loading.friction != 0, share=fineness.share)
    towards_equator = a > 0
    pressed, pulled, end = (a, c, high) if towards_equator else (c, a, -low)
    places = branches if towards_equator else [-place for place in branches]
    where = opened_range(pressed, pulled, loading.friction or None)
    nodes = list(closed_contacts(where, end, places, fineness))
    rule = Directions.of_tangents((u if towards_equator else 1 / u, measure) for u, measure, *_ in nodes)
    scale = float(pressed)
    # force/(1 + u^2): 1/(1 + u^2) is y, or s where the coordinate is the inverse tangent
    shrink = rule.cosine_squared if towards_equator else rule.sine_squared
    normal = tuple(cbrt(scale * force * part) for (*_, force), part in zip(nodes, shrink, strict=True))
    work = (work_of_closed(where, nodes) + rule.work_of_tangents() + Work(2, 1) * len(nodes)
            + (Work() if towards_equator else Work(1) * len(nodes)))
    if loading.friction is None:
        return ContactRule(rule, normal, error=fineness.error, work=work)
    if loading.friction == 0:
        return ContactRule(rule, normal, (0.0,) * len(nodes), (1.0,) * len(nodes), fineness.error, work)
    return ContactRule(rule, normal, tuple(node[2] for node in nodes), tuple(node[3] for node in nodes), fineness.error,
                       work)
