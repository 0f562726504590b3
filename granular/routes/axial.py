"""The stiffness by a rule along the meridian: serves every admissible fabric and loading, under both hypotheses.

Contacts of equal stiffness between spheres take a Gauss rule, from here; those whose stiffness follows their force, and
those of spheroids, take the rule of ``axial_kinetic``. Needs nothing but ``math`` and the fractions of the standard
library; the twin for arrays is ``axial_array``.
"""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING

from granular.hypothesis import Hypothesis
from granular.routes.accuracy import require_accuracy
from granular.routes.axial_rules import POWERS, AxialRule, Axis, axial_rule, crowding, nodes_needed
from granular.routes.rational import accurate_sum, fractions_of, rounded
from granular.routes.result import RouteResult, Six

if TYPE_CHECKING:
    from granular.fabric import AxialFabric
    from granular.loading import Loading

NAME = "axial"

KINEMATIC_NODES = 28
"""E W^2 times a moment has degree 12 in x at most, for which 7 nodes are exact; more of them average out the rounding
of each."""

RELATIVE_ERROR = 4 * 2.0**-52
"""Bound for every component that is not subnormal [-]. On 40,000 random and boundary fabrics against ball arithmetic
the worst was 1.8 * 2**-52, which is 2.9 units in the last place (kinematic), and 1.5 * 2**-52, 2.4 units (static)."""


KINETIC_ERROR = 8 * 2.0**-52
"""The same with contact forces, and for spheroids [-]. ``granular check --random 10000`` finds 1.2e-15 at the worst, or
5.3 * 2**-52, over random and boundary assemblies with densities of rank two and four and with sticking, sliding and
opened contacts."""


def relative_error(fabric: AxialFabric, loading: Loading | None = None) -> float:
    """Declare a bound for the worst of the six components.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branches about axis 3 [-].
    loading : Loading or None
        Stress and friction, for contacts whose stiffness follows their force.

    Returns
    -------
    float
        The bound, relative to that component [-].
    """
    return RELATIVE_ERROR if loading is None and fabric.collinear else KINETIC_ERROR


def evaluate(fabric: AxialFabric, *, poisson_ratio: float, hypothesis: Hypothesis,
             loading: Loading | None = None, rtol: float | None = None) -> RouteResult:
    """Six components over (M/V) l_e^2 k_n,ref by a rule along the meridian.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branch lengths about axis 3 [-].
    poisson_ratio : float
        Poisson's ratio of the grain material [-], 0 <= nu <= 0.5.
    hypothesis : Hypothesis
        Kinematic (upper bound) or static (lower estimate).
    loading : Loading or None
        Stress and friction, for contacts whose stiffness follows their force; None for contacts of equal stiffness.
    rtol : float or None
        Relative accuracy wanted of every component [-]; refused below the declared one.

    Returns
    -------
    RouteResult
        Components [-], declared error, and the number of nodes used.

    Accuracy
    --------
    :func:`relative_error` for every component of every admissible fabric that is not subnormal, under every loading.

    Raises
    ------
    RouteOutOfDomain
        ``rtol`` is below the declared error.
    ComplianceInfinite
        Static hypothesis with contacts that slide or have opened.

    Source
    ------
    Eqs (4), (6), (7), and Figure 1(b) with (23), as three positive moments of the weight.

    Examples
    --------
    >>> from granular.fabric import AxialFabric
    >>> result = evaluate(AxialFabric(D33=2.0, Dr33=-0.999999), poisson_ratio=0.0, hypothesis=Hypothesis.STATIC)
    >>> result.components[2:4], result.evaluations
    ((0.0, 0.0), 80)
    """
    declared = relative_error(fabric, loading)
    require_accuracy(NAME, declared, rtol)
    if loading is not None or not fabric.collinear:
        from granular.routes.axial_kinetic import components_by_contacts
        from granular.routes.contact_rule import suitable_contacts

        contacts = suitable_contacts(fabric, loading, hypothesis)
        six = components_by_contacts(fabric, poisson_ratio=poisson_ratio, hypothesis=hypothesis, contacts=contacts)
        return RouteResult(six, declared, len(contacts))
    rule = suitable_rule(fabric, hypothesis)
    components = components_by_rule(fabric, poisson_ratio=poisson_ratio, hypothesis=hypothesis, rule=rule)
    return RouteResult(components, declared, len(rule))


def nodes_of(fabric: AxialFabric, hypothesis: Hypothesis, loading: Loading | None = None) -> int:
    """Count the nodes that an evaluation takes, without evaluating.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branch lengths about axis 3 [-].
    hypothesis : Hypothesis
        Kinematic or static.
    loading : Loading or None
        Stress and friction, for contacts whose stiffness follows their force.

    Returns
    -------
    int
        Nodes [-].

    Raises
    ------
    ComplianceInfinite
        Static hypothesis with contacts that slide or have opened.
    """
    if loading is None and fabric.collinear:
        return len(suitable_rule(fabric, hypothesis))
    from granular.routes.contact_rule import suitable_contacts

    return len(suitable_contacts(fabric, loading, hypothesis))


def suitable_rule(fabric: AxialFabric, hypothesis: Hypothesis, *, nodes: int | None = None) -> AxialRule:
    """Choose the rule of a fabric: plain Gauss nodes, or nodes that crowd where branches are short.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branch lengths about axis 3 [-].
    hypothesis : Hypothesis
        Kinematic or static.
    nodes : int or None
        Number of nodes [-]; None takes as many as rounding asks for.

    Returns
    -------
    AxialRule
        Nodes and weights on 0 <= x <= 1.

    Accuracy
    --------
    With ``nodes=None`` the rule itself errs by less than 4e-18 of every moment.

    Source
    ------
    :func:`granular.routes.axial_rules.crowding`.
    """
    if hypothesis is Hypothesis.KINEMATIC:
        return axial_rule(Axis.EQUATOR, 0.0, nodes or KINEMATIC_NODES)
    axis, length = crowding(1 - fabric.Dr33 / 2, 1 + fabric.Dr33)
    return axial_rule(axis, length, nodes or nodes_needed(length))


def components_by_rule(fabric: AxialFabric, *, poisson_ratio: float, hypothesis: Hypothesis,
                       rule: AxialRule) -> Six:
    """Evaluate the six components by a given rule, with no promise about its error.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branch lengths about axis 3 [-].
    poisson_ratio : float
        Poisson's ratio of the grain material [-], 0 <= nu <= 0.5.
    hypothesis : Hypothesis
        Kinematic or static.
    rule : AxialRule
        Nodes and weights on 0 <= x <= 1.

    Returns
    -------
    tuple of 6 float
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n,ref [-].

    Accuracy
    --------
    The error of the rule, plus rounding of about one unit in the last place of each moment; what is done with the
    moments is exact.

    Source
    ------
    Eqs (4), (7), and Figure 1(b) with (23).
    """
    from granular.generated import kinematic_constant, static_constant

    d33, nu = Fraction(fabric.D33), Fraction(poisson_ratio)
    averages = _averages(fabric, hypothesis, rule)
    density = fabric.density_coefficients()
    p0, p1, p2 = (sum((e * averages[j + k] for j, e in enumerate(density)), Fraction(0)) for k in range(3))
    # The moments are the only rounded numbers here.
    if hypothesis is Hypothesis.KINEMATIC:
        return rounded(kinematic_constant.stiffness_from_moments(*fractions_of(p0, p1, p2, nu)))
    return rounded(static_constant.stiffness_from_moments(*fractions_of(p0, p1, p2, d33, nu)))


def _averages(fabric: AxialFabric, hypothesis: Hypothesis, rule: AxialRule) -> list[Fraction]:
    """<s^(4-m) x^(2m) W^2>, or the same with W^-2, for m = 0 ... 4."""
    w0, w0_rest = _split(1 - Fraction(fabric.Dr33) / 2)
    w1, w1_rest = _split(1 + Fraction(fabric.Dr33))
    # What rounding took from w0 and w1 is put back at every node; left out, it would shift all nodes alike.
    branch = [w0 * s + (w1 * x2 + (w0_rest * s + w1_rest * x2))
              for s, x2 in zip(rule.sine_squared, rule.cosine_squared, strict=True)]
    weight = [w * w for w in branch] if hypothesis is Hypothesis.KINEMATIC else [1 / (w * w) for w in branch]
    return [accurate_sum(list(map(float.__mul__, weight, rule.columns[m]))) for m in range(POWERS)]


def _split(exact: Fraction) -> tuple[float, float]:
    """A rational number as a float and the float of what is left."""
    nearest = float(exact)
    return nearest, float(exact - Fraction(nearest))
