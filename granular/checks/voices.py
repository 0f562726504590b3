"""The ways of computing that are held against each other, and what each may be off."""

from __future__ import annotations

import math
from typing import Protocol

from granular.errors import ComplianceInfinite, RouteOutOfDomain
from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.loading import Loading
from granular.routes import axial, certified, closed_form, exact, sphere
from granular.routes.result import RouteResult

UNIT = 2.0**-52
"""A relative error of this size is between half a unit and one unit in the last place [-]."""

MOST_UNITS = 4.0
"""Units in the last place that a component of a stored case or of a limit may be off by the closed form and the axial
rule, whatever they declare, where all contacts are equally stiff [ulp]."""

MOST_ERROR = {Hypothesis.KINEMATIC: 2e-15, Hypothesis.STATIC: 4e-15}
"""Relative error of a component that counts as agreement of the same two routes with contact forces, however hard the
inputs, whatever the routes declare [-]."""

ORDINARY_ERROR = 1e-15
"""The same for the kinematic hypothesis well inside the admissible region [-]."""


class Voice(Protocol):
    """What a module of ``granular.routes`` offers."""

    NAME: str

    def evaluate(self, fabric: AxialFabric, *, poisson_ratio: float, hypothesis: Hypothesis,
                 loading: Loading | None = None, rtol: float | None = None) -> RouteResult:
        """Compute the six components."""


ALL: tuple[Voice, ...] = (closed_form, exact, axial, sphere, certified)


def voices() -> tuple[Voice, ...]:
    """Name the ways of computing that can be used here.

    Returns
    -------
    tuple of Voice
        Modules of ``granular.routes``; ball arithmetic only where it is installed.
    """
    return tuple(voice for voice in ALL if voice is not certified or certified.available())


def attempt(voice: Voice, fabric: AxialFabric, poisson_ratio: float, hypothesis: Hypothesis,
            loading: Loading | None = None) -> RouteResult | None:
    """Evaluate by a route, or say that it does not serve the fabric and the loading.

    Parameters
    ----------
    voice : Voice
        A module of ``granular.routes``.
    fabric : AxialFabric
        Contact normals and branch lengths [-].
    poisson_ratio : float
        Poisson's ratio of the grain material [-].
    hypothesis : Hypothesis
        Kinematic or static.
    loading : Loading or None
        Stress and friction; None for contacts that all have the same stiffness.

    Returns
    -------
    RouteResult or None
        None where the route refuses the fabric or the loading, or where the compliance is infinite.

    Notes
    -----
    Accuracy and source: the route's.

    Examples
    --------
    >>> attempt(exact, AxialFabric(), 0.21, Hypothesis.STATIC) is None
    True
    """
    try:
        return voice.evaluate(fabric, poisson_ratio=poisson_ratio, hypothesis=hypothesis, loading=loading)
    except (RouteOutOfDomain, ComplianceInfinite):
        return None


def allowed_error(voice: Voice, result: RouteResult, *, aim: float) -> float:
    """Relative error that a component of a result with contact forces may have.

    Parameters
    ----------
    voice : Voice
        The route that gave the result.
    result : RouteResult
        What it gave.
    aim : float
        Bound for the two routes that a plan chooses by itself, where it is lower than what they declare [-].

    Returns
    -------
    float
        What the route declares, or the aim [-].

    Notes
    -----
    Accuracy and source: the route's declaration, and the aim of this package.

    Examples
    --------
    >>> allowed_error(axial, RouteResult((1.0,) * 6, 2**-40, 0), aim=2e-15)
    2e-15
    """
    return min(result.relative_error, aim) if voice in (closed_form, axial) else result.relative_error


def allowed_units(voice: Voice, result: RouteResult, *, aim: float = math.inf) -> float:
    """Units in the last place that a component of a result may be off.

    Parameters
    ----------
    voice : Voice
        The route that gave the result.
    result : RouteResult
        What it gave.
    aim : float
        Bound for the two routes that a plan chooses by itself, where it is lower than what they declare [ulp].

    Returns
    -------
    float
        What the route declares, or the aim [ulp].

    Notes
    -----
    Accuracy: a relative error is between 2**52 and 2**53 times as many units; the smaller number is taken. Source:
    the aim of this package.

    Examples
    --------
    >>> allowed_units(exact, RouteResult((1.0,) * 6, 2**-53, 0), aim=MOST_UNITS)
    0.5
    """
    declared = result.relative_error / UNIT
    return min(declared, aim) if voice in (closed_form, axial) else declared
