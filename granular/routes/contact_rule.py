"""Which directions to take along the meridian, and what the contacts do in each of them.

Needs nothing but ``math``, fractions and decimals of the standard library.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from math import cbrt, sqrt
from typing import TYPE_CHECKING

from granular.hypothesis import Hypothesis
from granular.routes.axial_rules import axial_rule
from granular.routes.fineness import FULL, Fineness
from granular.routes.gauss_rule import gauss_rule
from granular.routes.meridian import Directions
from granular.routes.windows import EQUATOR, POLE, place_of_forces, places_of_branches, window
from granular.routes.work import NOTHING, Work

if TYPE_CHECKING:
    from granular.fabric import AxialFabric
    from granular.loading import Loading


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
    error : float
        Bound of the error of any average by this rule, relative to that average [-].
    work : Work
        What the nodes and the contacts there took.
    """

    directions: Directions
    normal: tuple[float, ...]
    chi: tuple[float, ...] | None = None
    gamma: tuple[float, ...] | None = None
    error: float = math.inf
    work: Work = NOTHING

    def __len__(self) -> int:
        """Count the nodes."""
        return len(self.directions)


@lru_cache(maxsize=16)
def suitable_contacts(fabric: AxialFabric, loading: Loading | None, hypothesis: Hypothesis,
                      fineness: Fineness = FULL) -> ContactRule:
    """Choose the nodes for a fabric, a loading and a hypothesis.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branch lengths about axis 3 [-].
    loading : Loading or None
        Stress and friction; None for contacts of equal stiffness.
    hypothesis : Hypothesis
        Kinematic or static.
    fineness : Fineness
        How close the nodes are.

    Returns
    -------
    ContactRule
        Nodes that integrate every moment to ``fineness.error``.

    Raises
    ------
    ComplianceInfinite
        Static hypothesis with contacts that slide or have opened.

    Notes
    -----
    Source: ``granular.routes.gauss_rule`` where the integrand is smooth, ``granular.routes.log_tangent`` elsewhere.
    """
    if loading is None:
        directions, error = _smooth_directions(fabric, None, hypothesis, fineness)
        return ContactRule(directions, (1.0,) * len(directions), error=error)
    if hypothesis is Hypothesis.STATIC:
        loading.require_finite_compliance(fabric.D33)
    if loading.opens():
        from granular.routes.opening_rule import closed_contacts_of

        return closed_contacts_of(fabric, loading, hypothesis, fineness)
    if loading.friction and loading.slips(fabric.D33):
        from granular.routes.slip_rule import slipping_contacts

        return slipping_contacts(fabric, loading, hypothesis, fineness)
    directions, error = _smooth_directions(fabric, loading, hypothesis, fineness)
    a, c = loading.coefficients(fabric.D33)
    normal = normal_stiffness(directions, float(a), float(c))
    if loading.friction == 0:
        return ContactRule(directions, normal, (0.0,) * len(directions), (1.0,) * len(directions), error,
                           NORMAL * len(directions))
    return ContactRule(directions, normal, error=error, work=NORMAL * len(directions))


def _smooth_directions(fabric: AxialFabric, loading: Loading | None, hypothesis: Hypothesis,
                       fineness: Fineness) -> tuple[Directions, float]:
    """Gauss nodes where enough are stored, otherwise the trapezoidal rule in log(tan(beta)); with the error."""
    forces = None if loading is None else loading.coefficients(fabric.D33)
    factors = tuple((float(p), float(q)) for p, q in ([forces] if forces else []) + _branch_factors(fabric, hypothesis))
    rule = gauss_rule(factors, degree=_degree(fabric, hypothesis), tolerance=fineness.error)
    if rule is not None:
        return axial_rule(rule.axis, rule.length, rule.nodes).directions, rule.error
    from granular.routes.plain_rule import plain_rule

    branches = places_of_branches(fabric, hypothesis)
    if forces is None:
        low = fineness.share * POLE + min(0.0, *map(math.floor, branches))
        high = fineness.share * EQUATOR + max(0.0, *map(math.ceil, branches))
        singular = math.ceil(max(map(abs, branches)))
        return plain_rule(math.floor(low), math.ceil(high), singular, fineness), fineness.error
    a, c = forces
    low, high = window(branches, a, c, hypothesis, slips=False, share=fineness.share)
    places = [*branches, *([place_of_forces(a, c)] if a > 0 and c > 0 else [])]
    return plain_rule(low, high, math.ceil(max(map(abs, places))), fineness), fineness.error


def _branch_factors(fabric: AxialFabric, hypothesis: Hypothesis) -> list[tuple[float, float]]:
    """P and q of the factors p s + q x^2 by which the branches divide."""
    if not fabric.collinear:
        squared = fabric.aspect_ratio**2
        return [(1.0, squared if hypothesis is Hypothesis.KINEMATIC else squared**2)]
    return [] if hypothesis is Hypothesis.KINEMATIC else [(1 - fabric.Dr33 / 2, 1 + fabric.Dr33)]


def _degree(fabric: AxialFabric, hypothesis: Hypothesis) -> int:
    """Degree in s and x^2 of the density, of a moment, and of what the branches multiply by."""
    density = 1 if fabric.D3333 == 0 else 2
    if fabric.collinear:
        return density + 2 + (2 if hypothesis is Hypothesis.KINEMATIC else 0)
    return density + 2 + (0 if hypothesis is Hypothesis.KINEMATIC else 1)


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


NORMAL = Work(operations=3, functions=1)
"""Of the normal stiffness at one node."""


def normal_stiffness(rule: Directions, a: float, c: float) -> tuple[float, ...]:
    """k_n/k_n,ref at the nodes [-] from the normal force at the equator and at the pole, none of them negative."""
    return tuple(cbrt(a * s + c * y) for s, y in zip(rule.sine_squared, rule.cosine_squared, strict=True))
