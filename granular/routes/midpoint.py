"""The stiffness by the midpoint rule in beta that the printed tables carry: 24 panels over 0 <= beta <= pi."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import lru_cache
from typing import TYPE_CHECKING

from granular.errors import RouteOutOfDomain
from granular.hypothesis import Hypothesis
from granular.routes.accuracy import require_accuracy
from granular.routes.arithmetic import arithmetic_for
from granular.routes.axial import components_by_rule, promise_by_rule
from granular.routes.axial_kinetic import components_by_contacts, work_by_contacts
from granular.routes.axial_rules import POWERS, AxialRule
from granular.routes.contact_rule import NORMAL, ContactRule, contacts_at
from granular.routes.meridian import Directions
from granular.routes.result import Promise, RouteResult
from granular.routes.work import NOTHING, Work

if TYPE_CHECKING:
    from granular.fabric import AxialFabric
    from granular.loading import Loading

NAME = "midpoint"

PRINTED_PANELS = 24
"""Panels with which the rule gives the digits of Tables II to V, and with no other number from 6 to 60."""

PANELS = (2, 10_000)
"""Fewest and most panels that are served."""

SHARE_LEFT = Work(operations=5, functions=1)
"""Of 1 - f_r/(mu f_n) at one node."""


def promise(fabric: AxialFabric, hypothesis: Hypothesis, loading: Loading | None = None, *,
            panels: int = PRINTED_PANELS) -> Promise:
    """Say what an evaluation would take, without evaluating; of its accuracy nothing is said.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branches about axis 3 [-].
    hypothesis : Hypothesis
        Kinematic or static.
    loading : Loading or None
        Stress and friction, for contacts whose stiffness follows their force.
    panels : int
        Panels over 0 <= beta <= pi [-], 2 to 10,000.

    Returns
    -------
    Promise
        An infinite error, the number of panels, operations and functions.

    Raises
    ------
    RouteOutOfDomain
        A number of panels that is not served.
    ComplianceInfinite
        Static hypothesis with contacts that slide or have opened.

    Notes
    -----
    Accuracy: the counts are exact. Source: what is done at each panel; whether a contact has opened decides what
    eq. (21) takes there.

    Examples
    --------
    >>> from granular.fabric import AxialFabric
    >>> promise(AxialFabric(), Hypothesis.KINEMATIC).evaluations
    24
    """
    return _promise(fabric, hypothesis, panels, _contacts(fabric, hypothesis, loading, panels))


def _promise(fabric: AxialFabric, hypothesis: Hypothesis, panels: int, contacts: ContactRule | None) -> Promise:
    arithmetic = arithmetic_for(None)
    if contacts is None:
        return replace(promise_by_rule(fabric, hypothesis, midpoint_rule(panels), math.inf, arithmetic),
                       relative_error=math.inf)
    return Promise(math.inf, panels, contacts.work + work_by_contacts(fabric, hypothesis, contacts, arithmetic))


def evaluate(fabric: AxialFabric, *, poisson_ratio: float, hypothesis: Hypothesis,
             loading: Loading | None = None, rtol: float | None = None, panels: int = PRINTED_PANELS) -> RouteResult:
    """Six components over (M/V) l_e^2 k_n,ref by the midpoint rule in beta with the weight sin(beta).

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branch lengths about axis 3 [-].
    poisson_ratio : float
        Poisson's ratio of the grain material [-], 0 <= nu <= 0.5.
    hypothesis : Hypothesis
        Kinematic or static.
    loading : Loading or None
        Stress and friction, for contacts whose stiffness follows their force.
    rtol : float or None
        Relative accuracy wanted of every component [-]; refused, because none is promised.
    panels : int
        Panels over 0 <= beta <= pi [-], 2 to 10,000.

    Returns
    -------
    RouteResult
        Components [-], an infinite declared error, the number of panels, and what they took.

    Accuracy
    --------
    None promised: this is the error of the printed tables, about 3e-3 with 24 panels. It falls as 1/panels**2.

    Raises
    ------
    RouteOutOfDomain
        An ``rtol``, or a number of panels that is not served.
    ComplianceInfinite
        Static hypothesis with contacts that slide or have opened.

    Source
    ------
    Tables II to V, whose third decimals are those of this rule.

    Examples
    --------
    >>> from granular.fabric import AxialFabric
    >>> printed = evaluate(AxialFabric(Dr33=-0.3), poisson_ratio=0.21, hypothesis=Hypothesis.KINEMATIC)
    >>> round(printed.components[0] / printed.components[1], 4)
    1.4525
    """
    require_accuracy(NAME, math.inf, rtol)
    contacts = _contacts(fabric, hypothesis, loading, panels)
    promised = _promise(fabric, hypothesis, panels, contacts)
    if contacts is None:
        return promised.kept(components_by_rule(fabric, poisson_ratio=poisson_ratio, hypothesis=hypothesis,
                                                rule=midpoint_rule(panels), arithmetic=arithmetic_for(None)))
    return promised.kept(components_by_contacts(fabric, poisson_ratio=poisson_ratio, hypothesis=hypothesis,
                                                contacts=contacts, arithmetic=arithmetic_for(None)))


def _contacts(fabric: AxialFabric, hypothesis: Hypothesis, loading: Loading | None, panels: int) -> ContactRule | None:
    """The panels with what the contacts do there, and what that took; None for equal stiffness between spheres."""
    nodes = midpoint_panels(panels)
    if loading is None:
        return None if fabric.collinear else ContactRule(nodes, (1.0,) * panels)
    if hypothesis is Hypothesis.STATIC:
        loading.require_finite_compliance(fabric.D33)
    contacts = contacts_at(nodes, fabric, loading)
    return replace(contacts, work=NORMAL * panels + _work_of_slip(contacts, loading))


def _work_of_slip(contacts: ContactRule, loading: Loading) -> Work:
    """What the shear stiffness takes: where friction carries anything, the share of it that is left."""
    if contacts.chi is None:
        return NOTHING
    touching = sum(stiffness != 0 for stiffness in contacts.normal) if loading.friction else 0
    return SHARE_LEFT * touching + Work(1, 1) * len(contacts)


@lru_cache(maxsize=16)
def midpoint_panels(panels: int) -> Directions:
    """Make the nodes; they are made once in a process and kept.

    Parameters
    ----------
    panels : int
        Panels over 0 <= beta <= pi [-].

    Returns
    -------
    Directions
        Middles of the panels; half the sum over them is the average over 0 <= x <= 1.

    Raises
    ------
    RouteOutOfDomain
        A number of panels that is not served.

    Notes
    -----
    Accuracy: a few units in the last place. Source: midpoint rule in beta with the weight sin(beta).

    Examples
    --------
    >>> len(midpoint_panels(24))
    24
    """
    fewest, most = PANELS
    if not fewest <= panels <= most:
        raise RouteOutOfDomain(f"panels = {panels}", allowed=f"allowed {fewest} <= panels <= {most}",
                               remedy=f"Give {PRINTED_PANELS} panels for the digits of the printed tables.")
    angles = [(i + 0.5) * math.pi / panels for i in range(panels)]
    return Directions(tuple(math.sin(angle) ** 2 for angle in angles), tuple(math.cos(angle) ** 2 for angle in angles),
                      tuple(math.sin(angle) * math.pi / (2 * panels) for angle in angles))


@lru_cache(maxsize=16)
def midpoint_rule(panels: int) -> AxialRule:
    """The same with the products that contacts of equal stiffness need.

    Parameters
    ----------
    panels : int
        Panels over 0 <= beta <= pi [-].

    Returns
    -------
    AxialRule
        Nodes, weights and products of both.

    Notes
    -----
    Accuracy: a few units in the last place. Source: :func:`midpoint_panels`.

    Examples
    --------
    >>> len(midpoint_rule(24).columns)
    5
    """
    nodes = midpoint_panels(panels)
    rows = list(zip(nodes.measure, nodes.sine_squared, nodes.cosine_squared, strict=True))
    columns = tuple(tuple(w * s ** (POWERS - 1 - m) * y**m for w, s, y in rows) for m in range(POWERS))
    return AxialRule(nodes.sine_squared, nodes.cosine_squared, nodes.measure, columns)
