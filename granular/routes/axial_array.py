"""The Gauss rule along the meridian for whole arrays of fabrics: the twin of ``axial``, with the same rules."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from granular.hypothesis import Hypothesis
from granular.routes.axial import KINEMATIC_NODES
from granular.routes.axial_rules import ROUND, STEP, Axis, axial_rule, nodes_needed
from granular.routes.expansions import accurate_sum, two_sum

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    Array = NDArray[np.float64]

BLOCK = 4096
"""Fabrics evaluated at a time, so that a block of fabrics times nodes stays near the processor."""

GROUP = 4
"""Nodes whose products are added by plain matrix multiplication; it divides the 28 and the 80 nodes of a rule."""

RELATIVE_ERROR = 8 * 2.0**-52
"""Bound for every component that is not subnormal [-]. On 80,000 random and boundary fabrics the worst was
4.6 * 2**-52 (kinematic) and 6.0 * 2**-52 (static): here the formulas after the moments round as well."""


def components(D33: ArrayLike, Dr33: ArrayLike, poisson_ratio: ArrayLike, *, D3333: ArrayLike = 0.0,
               hypothesis: Hypothesis) -> Array:
    """Six components over (M/V) l_e^2 k_n,ref for arrays of fabrics that are known to be admissible.

    Parameters
    ----------
    D33, D3333 : float or (...) array
        P2 and P4 coefficients of the contact-normal density [-], with E nowhere negative.
    Dr33 : float or (...) array
        P2 coefficient of the branch-length weight [-], -1 < Dr33 < 2.
    poisson_ratio : float or (...) array
        Poisson's ratio of the grain material [-], 0 <= nu <= 0.5.
    hypothesis : Hypothesis
        Kinematic (upper bound) or static (lower estimate).

    Returns
    -------
    (..., 6) array
        C1111, C3333, C1122, C1133, C2323, C1212 [-] of each element of the broadcast arguments.

    Accuracy
    --------
    ``RELATIVE_ERROR`` for every component of every admissible fabric.

    Raises
    ------
    ValueError
        Shapes that do not broadcast together.

    Source
    ------
    Eqs (4), (7), and Figure 1(b) with (23).

    Examples
    --------
    >>> components([0.0, 0.3], -0.3, 0.21, hypothesis=Hypothesis.STATIC).shape
    (2, 6)
    """
    from granular.generated import kinematic_constant_array, static_constant_array

    d33, d3333, dr33, nu = np.broadcast_arrays(*(np.asarray(value, dtype=np.float64)
                                                 for value in (D33, D3333, Dr33, poisson_ratio)))
    if hypothesis is Hypothesis.KINEMATIC:
        p0, p1, p2 = kinematic_moments(d33, dr33, D3333=d3333)
        parts = kinematic_constant_array.stiffness_from_moments(p0, p1, p2, nu)
    else:
        p0, p1, p2 = static_moments(d33, dr33, D3333=d3333)
        parts = static_constant_array.stiffness_from_moments(p0, p1, p2, d33, nu)
    result: Array = np.stack(parts, axis=-1)
    return result


def kinematic_moments(D33: ArrayLike, Dr33: ArrayLike, *, D3333: ArrayLike = 0.0) -> Array:
    """Moments <E W^2 s^2>, <E W^2 s x^2>, <E W^2 x^4> of the kinematic weight.

    Parameters
    ----------
    D33, D3333 : float or (...) array
        P2 and P4 coefficients of the contact-normal density [-], with E nowhere negative.
    Dr33 : float or (...) array
        P2 coefficient of the branch-length weight [-], -1 < Dr33 < 2.

    Returns
    -------
    (3, ...) array
        The moments [-], 4 pi E taken as the density of x on 0 <= x <= 1.

    Accuracy
    --------
    Two to three units in the last place of each moment.

    Raises
    ------
    ValueError
        Shapes that do not broadcast together.

    Source
    ------
    Eq. (7).

    Examples
    --------
    >>> kinematic_moments(0.0, [0.0, 0.5]).shape
    (3, 2)
    """
    return _moments(D33, D3333, Dr33, Hypothesis.KINEMATIC)


def static_moments(D33: ArrayLike, Dr33: ArrayLike, *, D3333: ArrayLike = 0.0) -> Array:
    """Moments <E W^-2 s^2>, <E W^-2 s x^2>, <E W^-2 x^4> of the static weight.

    Parameters
    ----------
    D33, D3333 : float or (...) array
        P2 and P4 coefficients of the contact-normal density [-], with E nowhere negative.
    Dr33 : float or (...) array
        P2 coefficient of the branch-length weight [-], -1 < Dr33 < 2, up to one rounding from either end.

    Returns
    -------
    (3, ...) array
        The moments [-], 4 pi E taken as the density of x on 0 <= x <= 1.

    Accuracy
    --------
    Two to three units in the last place of each moment.

    Raises
    ------
    ValueError
        Shapes that do not broadcast together.

    Source
    ------
    Figure 1(b) with eq. (23).

    Examples
    --------
    >>> bool(static_moments(0.0, 1.9999999)[0] > 1e8)
    True
    """
    return _moments(D33, D3333, Dr33, Hypothesis.STATIC)


def _moments(D33: ArrayLike, D3333: ArrayLike, Dr33: ArrayLike, hypothesis: Hypothesis) -> Array:
    d33, d3333, dr33 = np.broadcast_arrays(*(np.asarray(value, dtype=np.float64)
                                             for value in (D33, D3333, Dr33)))
    shape, d33, d3333, dr33 = dr33.shape, d33.ravel(), d3333.ravel(), dr33.ravel()
    result = np.empty((3, dr33.size))
    for start in range(0, dr33.size, BLOCK):
        here = slice(start, start + BLOCK)
        # Every term is exact in binary, so that only the sums have to be guarded where E nearly vanishes.
        q = d3333[here]
        one = np.ones_like(q)
        density = (accurate_sum(one, -d33[here] / 2, q / 4, q / 8),
                   accurate_sum(2 * one, d33[here] / 2, -2 * q, -q),
                   accurate_sum(one, d33[here], q))
        averages = _averages(dr33[here], hypothesis)
        for k in range(3):
            result[k, here] = sum(e * averages[j + k] for j, e in enumerate(density))
    return result.reshape(3, *shape)


def _averages(dr33: Array, hypothesis: Hypothesis) -> Array:
    """<s^(4-m) x^(2m) W^2>, or the same with W^-2, for m = 0 ... 4; one rule at a time, all its fabrics at once."""
    w0, w0_rest = two_sum(np.ones(()), -dr33 / 2)
    w1, w1_rest = two_sum(np.ones(()), dr33)
    steps = np.zeros(dr33.shape, dtype=np.int64)
    if hypothesis is Hypothesis.STATIC:
        steps = _crowding(w0, w1)
    result = np.empty((5, dr33.size))
    for code in np.unique(steps).tolist():
        sine_squared, cosine_squared, columns = _rule(code)
        here = np.flatnonzero(steps == code)
        a, b, a_rest, b_rest = (part[here, None] for part in (w0, w1, w0_rest, w1_rest))
        branch = a * sine_squared + (b * cosine_squared + (a_rest * sine_squared + b_rest * cosine_squared))
        weight = branch * branch
        if hypothesis is Hypothesis.STATIC:
            weight = 1 / weight
        result[:, here] = _guarded_products(weight, columns)
    return result


def _guarded_products(weight: Array, columns: Array) -> Array:
    """Multiply columns @ weight.T in groups of nodes whose sums are added without loss, (5, fabrics)."""
    groups = weight.shape[1] // GROUP
    by_group = np.matmul(columns.reshape(-1, groups, GROUP).transpose(1, 0, 2),
                         weight.reshape(-1, groups, GROUP).transpose(1, 2, 0))
    return accurate_sum(*by_group)


def _crowding(w0: Array, w1: Array) -> NDArray[np.int64]:
    """L / STEP of the rule about the equator, minus that of the rule about the pole, as in ``crowding``."""
    with np.errstate(divide="ignore", invalid="ignore"):
        equator = np.sqrt(w0 / (w1 - w0))
        reach = np.sqrt(w1 / (w0 - w1))
        pole = reach / (1 + np.hypot(1, reach))
        about_equator = w0 <= ROUND * w1
        distance = np.where(about_equator, np.where(w1 > w0, equator, np.inf), pole)
    steps = np.maximum(1, np.rint(np.arcsinh(1 / distance) / STEP)).astype(np.int64)
    return np.where(about_equator, steps, -steps)


@lru_cache(maxsize=256)
def _rule(steps: int) -> tuple[Array, Array, Array]:
    """The rule of a number of steps: about the equator when positive, about the pole when negative."""
    length = abs(steps) * STEP
    rule = axial_rule(Axis.POLE if steps < 0 else Axis.EQUATOR, length,
                      nodes_needed(length) if steps else KINEMATIC_NODES)
    return np.array(rule.sine_squared), np.array(rule.cosine_squared), np.array(rule.columns)
