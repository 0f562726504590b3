"""The stiffness by a rule along the meridian: serves every admissible fabric and loading, under both hypotheses.

Contacts of equal stiffness between spheres take a Gauss rule, from here; those whose stiffness follows their force, and
those of spheroids, take the rule of ``axial_kinetic``. Needs nothing but ``math`` and the fractions of the standard
library; the twin for arrays is ``axial_array``.
"""

from __future__ import annotations

from fractions import Fraction
from operator import mul
from typing import TYPE_CHECKING, Any

from granular.hypothesis import Hypothesis
from granular.routes.accuracy import require_accuracy
from granular.routes.arithmetic import FLOAT_ERROR, FRACTIONS, Arithmetic, arithmetic_for
from granular.routes.axial_rules import POWERS, AxialRule, Axis, axial_rule, crowding, nodes_needed
from granular.routes.fineness import FULL, amplification, fineness_for
from granular.routes.gauss_rule import gauss_rule
from granular.routes.meridian import LINEAR
from granular.routes.result import Promise, RouteResult, Six
from granular.routes.work import Work

if TYPE_CHECKING:
    from granular.fabric import AxialFabric
    from granular.loading import Loading
    from granular.routes.contact_rule import ContactRule

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

def promise(fabric: AxialFabric, hypothesis: Hypothesis, loading: Loading | None = None, *,
            rtol: float | None = None) -> Promise:
    """Say how well an evaluation would do and what it would take, without evaluating.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branches about axis 3 [-].
    hypothesis : Hypothesis
        Kinematic or static.
    loading : Loading or None
        Stress and friction, for contacts whose stiffness follows their force.
    rtol : float or None
        Relative accuracy wanted of every component [-]; from ``QUICK`` on the rule is as coarse as it allows.

    Returns
    -------
    Promise
        Bound for the worst of the six components, nodes, operations and functions.

    Raises
    ------
    ComplianceInfinite
        Static hypothesis with contacts that slide or have opened.

    Notes
    -----
    Accuracy: a bound. Source: :func:`granular.routes.gauss_rule.gauss_rule`,
    :func:`granular.routes.fineness.fineness_for`.

    Examples
    --------
    >>> from granular.fabric import AxialFabric
    >>> from granular.loading import Loading
    >>> sliding = Loading.of_ratio(2.0, friction=0.2)
    >>> [promise(AxialFabric(), Hypothesis.KINEMATIC, sliding, rtol=rtol).evaluations for rtol in (1e-3, 1e-12)]
    [134, 389]
    """
    arithmetic = arithmetic_for(rtol)
    if loading is None and fabric.collinear:
        return promise_by_rule(fabric, hypothesis, *_rule(fabric, hypothesis, rtol), arithmetic)
    return _by_contacts(fabric, hypothesis, _contacts(fabric, hypothesis, loading, rtol), arithmetic)


def _rule(fabric: AxialFabric, hypothesis: Hypothesis, rtol: float | None) -> tuple[AxialRule, float]:
    """The rule for contacts of equal stiffness between spheres, and its error."""
    fineness = fineness_for(rtol, fabric, hypothesis)
    if fineness is FULL:
        return suitable_rule(fabric, hypothesis), 0.0
    density = 1 if fabric.D3333 == 0 else 2
    if hypothesis is Hypothesis.KINEMATIC:
        return axial_rule(Axis.EQUATOR, 0.0, density + 5), 0.0  # exact for a polynomial of that degree in x^2
    found = gauss_rule(((1 - fabric.Dr33 / 2, 1 + fabric.Dr33),), degree=density + 2, tolerance=fineness.error)
    if found is None:  # the full rule covers every length of branches there is
        return suitable_rule(fabric, hypothesis), 2.0**-57
    return axial_rule(found.axis, found.length, found.nodes), found.error


def _contacts(fabric: AxialFabric, hypothesis: Hypothesis, loading: Loading | None, rtol: float | None) -> ContactRule:
    from granular.routes.contact_rule import suitable_contacts

    return suitable_contacts(fabric, loading, hypothesis, fineness_for(rtol, fabric, hypothesis))


def promise_by_rule(fabric: AxialFabric, hypothesis: Hypothesis, rule: AxialRule, error: float,
                    arithmetic: Arithmetic) -> Promise:
    """Say what a given rule takes and how well it does, for contacts of equal stiffness between spheres.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branch lengths about axis 3 [-].
    hypothesis : Hypothesis
        Kinematic or static.
    rule : AxialRule
        Nodes and weights on 0 <= x <= 1.
    error : float
        Bound of the error of any average by the rule, relative to that average [-].
    arithmetic : Arithmetic
        What is done with the moments.

    Returns
    -------
    Promise
        Bound for the worst component, nodes, operations and functions.

    Notes
    -----
    Accuracy: a bound, and exact counts. Source: :func:`components_by_rule`.
    """
    nodes = len(rule)
    share, ends = (1, 36) if hypothesis is Hypothesis.KINEMATIC else (2, 73)
    work = (LINEAR + Work(share + POWERS)) * nodes + arithmetic.additions(nodes) * POWERS + Work(18 + ends)
    if arithmetic is FRACTIONS:
        return Promise(RELATIVE_ERROR, nodes, work)
    return Promise(amplification(fabric, hypothesis) * error + FLOAT_ERROR, nodes, work)


def _by_contacts(fabric: AxialFabric, hypothesis: Hypothesis, contacts: ContactRule,
                 arithmetic: Arithmetic) -> Promise:
    from granular.routes.axial_kinetic import work_by_contacts

    work = contacts.work + work_by_contacts(fabric, hypothesis, contacts, arithmetic)
    if arithmetic is FRACTIONS:
        return Promise(KINETIC_ERROR, len(contacts), work)
    return Promise(amplification(fabric, hypothesis) * contacts.error + FLOAT_ERROR, len(contacts), work)


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
        Relative accuracy wanted of every component [-]; refused below the declared one. From ``QUICK`` on it is
        served with as few nodes as it allows, in floats.

    Returns
    -------
    RouteResult
        Components [-], declared error, and the number of nodes used.

    Accuracy
    --------
    That of :func:`promise` for every component of every admissible fabric that is not subnormal, under every loading.

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
    arithmetic = arithmetic_for(rtol)
    if loading is not None or not fabric.collinear:
        from granular.routes.axial_kinetic import components_by_contacts

        contacts = _contacts(fabric, hypothesis, loading, rtol)
        promised = _by_contacts(fabric, hypothesis, contacts, arithmetic)
        require_accuracy(NAME, promised.relative_error, rtol)
        six = components_by_contacts(fabric, poisson_ratio=poisson_ratio, hypothesis=hypothesis, contacts=contacts,
                                     arithmetic=arithmetic)
    else:
        rule, error = _rule(fabric, hypothesis, rtol)
        promised = promise_by_rule(fabric, hypothesis, rule, error, arithmetic)
        require_accuracy(NAME, promised.relative_error, rtol)
        six = components_by_rule(fabric, poisson_ratio=poisson_ratio, hypothesis=hypothesis, rule=rule,
                                 arithmetic=arithmetic)
    return promised.kept(six)


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
                       rule: AxialRule, arithmetic: Arithmetic = FRACTIONS) -> Six:
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
    arithmetic : Arithmetic
        What is done with the moments.

    Returns
    -------
    tuple of 6 float
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n,ref [-].

    Accuracy
    --------
    The error of the rule, plus rounding of about one unit in the last place of each moment; what is done with the
    moments is exact in fractions.

    Source
    ------
    Eqs (4), (7), and Figure 1(b) with (23).
    """
    from granular.generated import kinematic_constant, static_constant

    d33, nu = arithmetic.numbers(fabric.D33, poisson_ratio)
    averages = _averages(fabric, hypothesis, rule, arithmetic)
    density = arithmetic.numbers(*fabric.density_coefficients())
    p0, p1, p2 = (sum((e * averages[j + k] for j, e in enumerate(density)), arithmetic.number(0)) for k in range(3))
    # in fractions the moments are the only rounded numbers here
    if hypothesis is Hypothesis.KINEMATIC:
        return arithmetic.finished(kinematic_constant.stiffness_from_moments(p0, p1, p2, nu))
    return arithmetic.finished(static_constant.stiffness_from_moments(p0, p1, p2, d33, nu))


def _averages(fabric: AxialFabric, hypothesis: Hypothesis, rule: AxialRule, arithmetic: Arithmetic) -> list[Any]:
    """<s^(4-m) x^(2m) W^2>, or the same with W^-2, for m = 0 ... 4."""
    w0, w0_rest = _split(1 - Fraction(fabric.Dr33) / 2)
    w1, w1_rest = _split(1 + Fraction(fabric.Dr33))
    # What rounding took from w0 and w1 is put back at every node; left out, it would shift all nodes alike.
    branch = [w0 * s + (w1 * x2 + (w0_rest * s + w1_rest * x2))
              for s, x2 in zip(rule.sine_squared, rule.cosine_squared, strict=True)]
    weight = [w * w for w in branch] if hypothesis is Hypothesis.KINEMATIC else [1 / (w * w) for w in branch]
    return [arithmetic.total(list(map(mul, weight, rule.columns[m]))) for m in range(POWERS)]


def _split(exact: Fraction) -> tuple[float, float]:
    """A rational number as a float and the float of what is left."""
    nearest = float(exact)
    return nearest, float(exact - Fraction(nearest))
