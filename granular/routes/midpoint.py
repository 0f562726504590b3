"""The stiffness by the midpoint rule in beta that the printed tables carry: 24 panels over 0 <= beta <= pi."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from granular.errors import RouteOutOfDomain
from granular.hypothesis import Hypothesis
from granular.routes.accuracy import require_accuracy
from granular.routes.axial import components_by_rule
from granular.routes.axial_kinetic import components_by_contacts
from granular.routes.axial_rules import POWERS, AxialRule
from granular.routes.contact_rule import contacts_at
from granular.routes.meridian import Directions
from granular.routes.result import RouteResult

if TYPE_CHECKING:
    from granular.fabric import AxialFabric
    from granular.loading import Loading

NAME = "midpoint"

PRINTED_PANELS = 24
"""Panels with which the rule gives the digits of Tables II to V, and with no other number from 6 to 60."""

PANELS = (2, 10_000)
"""Fewest and most panels that are served."""


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
        Components [-], an infinite declared error, and the number of panels.

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
    fewest, most = PANELS
    if not fewest <= panels <= most:
        raise RouteOutOfDomain(f"panels = {panels}", allowed=f"allowed {fewest} <= panels <= {most}",
                               remedy=f"Give {PRINTED_PANELS} panels for the digits of the printed tables.")
    require_accuracy(NAME, math.inf, rtol)
    if loading is None:
        components = components_by_rule(fabric, poisson_ratio=poisson_ratio, hypothesis=hypothesis,
                                        rule=_midpoint_rule(panels))
    else:
        if hypothesis is Hypothesis.STATIC:
            loading.require_finite_compliance(fabric.D33)
        components = components_by_contacts(fabric, poisson_ratio=poisson_ratio, hypothesis=hypothesis,
                                            contacts=contacts_at(_panels(panels), fabric, loading))
    return RouteResult(components, math.inf, panels)


def _panels(panels: int) -> Directions:
    """Half the sum over the panels is the average over 0 <= x <= 1."""
    angles = [(i + 0.5) * math.pi / panels for i in range(panels)]
    return Directions(tuple(math.sin(angle) ** 2 for angle in angles), tuple(math.cos(angle) ** 2 for angle in angles),
                      tuple(math.sin(angle) * math.pi / (2 * panels) for angle in angles))


def _midpoint_rule(panels: int) -> AxialRule:
    """The same with the products that contacts of equal stiffness need."""
    nodes = _panels(panels)
    rows = list(zip(nodes.measure, nodes.sine_squared, nodes.cosine_squared, strict=True))
    columns = tuple(tuple(w * s ** (POWERS - 1 - m) * y**m for w, s, y in rows) for m in range(POWERS))
    return AxialRule(nodes.sine_squared, nodes.cosine_squared, nodes.measure, columns)
