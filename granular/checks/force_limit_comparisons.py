"""Every route against every limit with contact forces."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import product

from granular.checks.comparison import Comparison, gap_in_ulp, worst_relative
from granular.checks.force_limits import one_stress_vanishes, weak_stress
from granular.checks.limits import isotropic_kinematic, isotropic_static, kinematic_polynomial
from granular.checks.on_the_fly import certified_components
from granular.checks.voices import MOST_ERROR, UNIT, Voice, allowed_error, attempt
from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.loading import Loading
from granular.routes import axial, certified, closed_form
from granular.routes.result import RouteResult

VOICES: tuple[Voice, ...] = (closed_form, axial)

FABRICS = tuple(AxialFabric(D33=d33, D3333=d3333, Dr33=dr33) for d33, d3333, dr33 in (
    (0.0, 0.0, 0.0), (0.3, 0.2, -0.3), (-1.0, 0.0, 0.5), (2.0, 0.0, -0.75), (1.5, 0.0, 1.999)))

BALANCED = ((AxialFabric(D33=-1.0, Dr33=0.5), 0.5), (AxialFabric(D33=2.0, Dr33=-0.75), 3.0),
            (AxialFabric(Dr33=1.5), 1.0))
"""Fabrics under the stress ratio at which every contact carries the same force."""

POISSON_RATIOS = (0.0, 0.21, 0.5)

SMALL, LARGE = 1e-200, 1e200
"""Friction that differs from none, or from no slip, by nothing that a double holds."""


def force_limit_comparisons() -> Iterator[Comparison]:
    """Compare the routes that a plan chooses with every limit that has contact forces.

    Returns
    -------
    iterator of Comparison
        One for each limit, fabric, Poisson's ratio and route that serves them.

    Notes
    -----
    Accuracy: a component may be off by :func:`granular.checks.voices.allowed_error`, each term of an identity by as
    much, a zero by nothing. Source: eqs (7) and (20)-(23).

    Examples
    --------
    >>> all(comparison.agrees for comparison in force_limit_comparisons() if comparison.route == "closed_form")
    True
    """
    for voice, nu in product(VOICES, POISSON_RATIOS):
        yield from _known_values(voice, nu)
        for fabric in FABRICS:
            yield from _identities(voice, fabric, nu)
        yield from _onset(voice, nu)


def _known_values(voice: Voice, nu: float) -> Iterator[Comparison]:
    for fabric, ratio in BALANCED:
        for friction in (None, 0.3):
            yield from _value(voice, fabric, Loading.of_ratio(ratio, friction=friction), nu, "forces: a = c",
                              kinematic_polynomial(fabric, nu))
    isotropic = AxialFabric()
    even = Loading.of_ratio(1.0, friction=0.3)
    yield from _value(voice, isotropic, even, nu, "forces: K and G", isotropic_kinematic(isotropic, nu))
    yield from _value(voice, isotropic, even, nu, "forces: K and G", isotropic_static(isotropic, nu),
                      Hypothesis.STATIC)
    for exponent, sign in product((21, 30, 45), (1, -1)):
        ratio = 1 + sign * 2.0**-exponent
        yield from _value(voice, isotropic, Loading.of_ratio(ratio), nu, "forces: SR near 1",
                          weak_stress(Fraction(ratio), nu))
    for fabric in FABRICS:
        for along, exact, near in (
                (True, Loading(sigma11=Fraction(0), sigma33=Fraction(1)), Loading.of_ratio(1e100)),
                (False, Loading.of_ratio(0.0), Loading.of_ratio(1e-100))):
            known = one_stress_vanishes(fabric, nu, along=along)
            for loading in (exact, near):
                yield from _value(voice, fabric, loading, nu, f"forces: SR to {'inf' if along else '0'}", known)


def _value(voice: Voice, fabric: AxialFabric, loading: Loading, nu: float, group: str, known: Sequence[Fraction],
           hypothesis: Hypothesis = Hypothesis.KINEMATIC) -> Iterator[Comparison]:
    result = attempt(voice, fabric, nu, hypothesis, loading)
    if result is not None:
        component, error, units = worst_relative(result.components, known)
        allowed = allowed_error(voice, result, aim=MOST_ERROR[hypothesis])
        yield Comparison(group=group, case=_name(fabric, loading, nu), hypothesis=hypothesis, route=voice.NAME,
                         component=component, error=error * units, allowed=allowed * units)


def _identities(voice: Voice, fabric: AxialFabric, nu: float) -> Iterator[Comparison]:
    for ratio in (1.4, 1e-3, 1e6):
        results = {mu: attempt(voice, fabric, nu, Hypothesis.KINEMATIC, Loading.of_ratio(ratio, friction=mu))
                   for mu in (None, 0.0, SMALL, 0.3, LARGE)}
        for friction, result in results.items():
            if result is None:
                continue
            gap = _gap(voice, fabric, Loading.of_ratio(ratio, friction=friction), nu, result)
            six = result.components
            yield gap("forces: C1212", "C1212", [(2, six[5]), (-1, six[0]), (1, six[2])])
            sticking = results[None]
            if sticking is not None and friction is not None:
                yield gap("forces: trace", "C3333", [
                    (sign * factor, components[i]) for components, sign in ((six, 1), (sticking.components, -1))
                    for i, factor in ((1, 1), (0, 2), (2, 2), (3, 4))])
            if friction is None and nu == 0:
                exact = gap("forces: exact zeros", "C1133", [(1, six[3])])
                yield replace(exact, error=0.0 if six[2] == six[3] == 0 else math.inf, allowed=0.0)
            if friction == 0:
                yield gap("forces: no friction", "C2323", [(1, six[4]), (-1, six[3])])
                yield gap("forces: no friction", "C1212", [(1, six[5]), (-1, six[2])])
        for group, friction, limit in (("forces: mu to 0", SMALL, 0.0), ("forces: mu to inf", LARGE, None)):
            near, at = results[friction], results[limit]
            if near is None or at is None or (limit is None and nu == 0):
                continue  # without nu the coupling at large mu is all that mu leaves, and no limit
            gap = _gap(voice, fabric, Loading.of_ratio(ratio, friction=friction), nu, near)
            for index, name in enumerate(("C1111", "C3333", "C1122", "C1133", "C2323", "C1212")):
                yield gap(group, name, [(1, near.components[index]), (-1, at.components[index])])


def _onset(voice: Voice, nu: float) -> Iterator[Comparison]:
    """Exact tangency, and one double of mu to each side, against ball arithmetic where it is installed."""
    if not certified.available():
        return
    for ratio, mu in product((4.0, 0.25), (math.nextafter(0.75, 0.0), 0.75, math.nextafter(0.75, 1.0))):
        loading = Loading.of_ratio(ratio, friction=mu)
        known = certified_components(AxialFabric(), nu, Hypothesis.KINEMATIC, loading)
        yield from _value(voice, AxialFabric(), loading, nu, "forces: onset", known)


def _gap(voice: Voice, fabric: AxialFabric, loading: Loading, nu: float,
         result: RouteResult) -> Callable[[str, str, Sequence[tuple[int, float]]], Comparison]:
    """Comparisons of identities between rounded numbers of one input."""
    # Twice the relative error of UNIT is at most one unit in the last place of each term.
    allowed = 2 * allowed_error(voice, result, aim=MOST_ERROR[Hypothesis.KINEMATIC]) / UNIT

    def compare(group: str, component: str, terms: Sequence[tuple[int, float]]) -> Comparison:
        return Comparison(group=group, case=_name(fabric, loading, nu), hypothesis=Hypothesis.KINEMATIC,
                          route=voice.NAME, component=component, error=gap_in_ulp(terms), allowed=allowed)

    return compare


def _name(fabric: AxialFabric, loading: Loading, nu: float) -> str:
    stress = f"SR = {float(loading.sigma33):g}" if loading.sigma11 == 1 else "SR = inf"
    friction = "" if loading.friction is None else f", mu = {loading.friction:g}"
    return f"D33 = {fabric.D33:g}, Dr33 = {fabric.Dr33:g}, {stress}{friction}, nu = {nu:g}"
