"""Nodes for contacts that do not slip, where singularities come too close to the interval for stored Gauss rules."""

from __future__ import annotations

from functools import lru_cache
from math import sqrt

from granular.routes import log_tangent
from granular.routes.fineness import FULL, Fineness
from granular.routes.meridian import Directions


@lru_cache(maxsize=64)
def plain_rule(low: float, high: float, singular: int, fineness: Fineness = FULL) -> Directions:
    """Nodes of the trapezoidal rule in log(tan(beta)) for contacts that do not slip.

    Parameters
    ----------
    low, high : float
        Range of log(tan(beta)) that matters [-].
    singular : int
        Largest distance of a singularity of forces, directions or branch lengths from 45 deg, in log(tan(beta)) [-].
    fineness : Fineness
        How close the nodes are.

    Returns
    -------
    Directions
        Nodes that integrate every moment to ``fineness.error``.

    Notes
    -----
    Source: ``granular.routes.log_tangent``.
    """
    return Directions.of_tangents((t, measure) for t, measure, _, _ in log_tangent.sticking(
        1.0, low, high, r=sqrt(0.5), delta=1.0, kappa=0.0, singular=singular, fineness=fineness))
