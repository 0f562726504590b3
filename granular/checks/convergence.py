"""How fast the rule for slip converges: its error against the density of equidistant nodes."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import lru_cache

from granular.fabric import AxialFabric
from granular.generated import mohr_circle
from granular.hypothesis import Hypothesis
from granular.loading import Loading
from granular.routes import certified
from granular.routes.axial_kinetic import components_by_contacts
from granular.routes.contact_rule import ContactRule
from granular.routes.log_tangent import TANGENT
from granular.routes.log_tangent_tables import STEPS
from granular.routes.meridian import Directions
from granular.routes.slip_geometry import Sliding, Sticking, slip_geometry

POISSON_RATIO, FABRIC = 0.21, AxialFabric()
STATES = {"every contact sticks": Loading.of_ratio(3, friction=0.75),
          "at the onset": Loading.of_ratio(4, friction=0.75),
          "some contacts slide": Loading.of_ratio(6, friction=0.75)}
"""Three stresses on an isotropic packing; with mu = 3/4 the second is exactly at the onset of sliding."""

NODES = tuple(range(2, STEPS + 1))
"""Nodes for each unit of the mapped variable; the library takes the last, and lets them hurry off in the tails."""

FARTHEST, NEAREST = 50.0, 24.0
"""Ends of the mapped lines, beyond which less than rounding is left."""


def predicted(nodes: int) -> float:
    """Error of the trapezoidal rule in a strip of half width pi/4.

    Parameters
    ----------
    nodes : int
        Nodes for each unit of the mapped variable [-].

    Returns
    -------
    float
        exp(-2 pi (pi/4)/step) [-].

    Notes
    -----
    Source: Poisson's summation formula.

    Examples
    --------
    >>> 7e-3 < predicted(1) < 8e-3
    True
    """
    return math.exp(-2 * math.pi * (math.pi / 4) * nodes)


@lru_cache(maxsize=len(STATES))
def errors(state: str) -> tuple[float, ...]:
    """Worst relative error of six components for each density of nodes, against certified values.

    Parameters
    ----------
    state : str
        One of ``STATES``.

    Returns
    -------
    tuple of float
        One for each of ``NODES`` [-].

    Raises
    ------
    CertifiedArithmeticMissing
        python-flint is not installed.

    Notes
    -----
    Accuracy: certified values are rounded to double. Source: ``granular.routes.log_tangent`` with equidistant nodes.

    Examples
    --------
    >>> errors("at the onset")[-1] < 2e-15
    True
    """
    loading = STATES[state]
    known = certified.evaluate(FABRIC, poisson_ratio=POISSON_RATIO, hypothesis=Hypothesis.KINEMATIC, loading=loading)
    found = []
    for nodes in NODES:
        six = components_by_contacts(FABRIC, poisson_ratio=POISSON_RATIO, hypothesis=Hypothesis.KINEMATIC,
                                     contacts=_contacts(loading, nodes))
        found.append(max(abs(value / true - 1) for value, true in zip(six, known.components, strict=True)))
    return tuple(found)


def _contacts(loading: Loading, nodes: int) -> ContactRule:
    """Equidistant nodes of the three maps, and what the contacts do there."""
    a, c = loading.coefficients(FABRIC.D33)
    assert loading.friction is not None  # the states have friction
    rows = list(_rows(slip_geometry(a, c, loading.friction), nodes))
    directions = Directions.of_tangents((t, measure) for t, measure, *_ in rows)
    normal = tuple(math.cbrt(float(a) * s + float(c) * y) for s, y in zip(
        directions.sine_squared, directions.cosine_squared, strict=True))
    return ContactRule(directions, normal, tuple(row[2] for row in rows), tuple(row[3] for row in rows))


def _rows(geometry: Sticking | Sliding, nodes: int) -> Iterator[tuple[float, float, float, float]]:
    """Yield tan(beta), d(log tan(beta)), chi and 1 - chi at the nodes."""
    if isinstance(geometry, Sticking):
        scale = max(math.sqrt(geometry.delta / 2), TANGENT)
        for u in _equidistant(-FARTHEST, FARTHEST, nodes):
            growth, rate, chi, gamma = mohr_circle.sticking_node(
                math.sinh(u), math.cosh(u), scale, geometry.delta, geometry.kappa)
            yield geometry.center * growth ** math.copysign(1, u), rate / nodes, chi, gamma
        return
    assert geometry.pole is not None and geometry.equator is not None  # contacts stick at pole and equator
    for w in _equidistant(-NEAREST, FARTHEST, nodes):
        grown = math.exp(w)
        p = grown * grown / (2 * (1 + grown))
        growth, rate, chi, gamma = mohr_circle.beside_node(p, p * (2 + grown) / (1 + grown), geometry.rho)
        yield geometry.equator * growth, rate / nodes, chi, gamma
        yield geometry.pole / growth, rate / nodes, chi, gamma
    center, half = math.sqrt(geometry.pole * geometry.equator), math.log(geometry.equator / geometry.pole) / 4
    for u in _equidistant(-NEAREST, NEAREST, nodes):
        growth, rate = mohr_circle.between_node(math.sinh(u), math.cosh(u), math.sinh(half), math.cosh(half))
        yield center * growth ** math.copysign(1, u), rate / nodes, 0.0, 1.0


def _equidistant(first: float, last: float, nodes: int) -> Iterator[float]:
    yield from ((j + 0.5) / nodes for j in range(math.floor(first * nodes), math.ceil(last * nodes)))
