"""The integrals over directions that values and slopes are made of, where no contact slips."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from granular.generated.gauss_legendre import NODES, WEIGHTS
from granular.routes.plain_rule import plain_rule
from granular.routes.windows import EQUATOR, POLE

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]
    Index = NDArray[np.intp]

SERIES = 9.0
"""Forces at pole and equator up to this factor apart take the emitted series."""

MILD = (1 / 9, 12.0)
"""Ratios of pole to equator, of forces and of branch lengths, for which ``GAUSS`` nodes in x reach 1e-16."""

GAUSS = 40

ENTRIES = 2**15
"""Elements times nodes evaluated at a time."""


def force_integrals(a: Array, c: Array, d: Array) -> Array:
    """Integrals of s^(6-m) x^(2m) (a s + c x^2)^(-2/3) over x from 0 to 1.

    Parameters
    ----------
    a, c, d : (n,) array
        Normal force at equator and pole over that of the isotropic assembly, > 0, and c - a [-].

    Returns
    -------
    (7, n) array
        m = 0 ... 6 [-].

    Notes
    -----
    Accuracy: four units in the last place of each. Source: ``derivations.gradients_series``.

    Examples
    --------
    >>> one = np.ones(1)
    >>> round(float(force_integrals(one, one, 0 * one)[6, 0]), 15) == round(1 / 13, 15)
    True
    """
    from granular.generated.gradients_array import force_moments

    result = np.empty((7, a.size))
    near = (c <= SERIES * a) & (a <= SERIES * c)
    if near.all():
        result[:] = force_moments(a, c, d)
        return result
    result[:, near] = force_moments(a[near], c[near], d[near])
    for index, s, y, measure in _groups(np.flatnonzero(~near), _distance(a, c)):
        force = np.cbrt(np.outer(a[index], s) + np.outer(c[index], y))
        result[:, index] = _columns(s, y, measure, 6).T @ (1 / (force * force)).T
    return result


def soft_integrals(w0: Array, w1: Array, a: Array, c: Array) -> Array:
    """Integrals of s^(5-m) x^(2m) W^-3 (a s + c x^2)^(-4/3) over x from 0 to 1.

    Parameters
    ----------
    w0, w1 : (n,) array
        Branch length at equator and pole [-], > 0.
    a, c : (n,) array
        Normal force there over that of the isotropic assembly [-], > 0.

    Returns
    -------
    (6, n) array
        m = 0 ... 5 [-].

    Notes
    -----
    Accuracy: four units in the last place of each. Source: ``derivations.gradients_static``.

    Examples
    --------
    >>> one = np.ones(1)
    >>> round(float(soft_integrals(one, one, one, one)[5, 0]), 15) == round(1 / 11, 15)
    True
    """
    result = np.empty((6, a.size))
    for index, s, y, measure in _soft_groups(w0, w1, a, c):
        force = np.cbrt(np.outer(a[index], s) + np.outer(c[index], y))
        branch = np.outer(w0[index], s) + np.outer(w1[index], y)
        square = force * force
        result[:, index] = _columns(s, y, measure, 5).T @ (1 / (branch * branch * branch * square * square)).T
    return result


def short_integrals(w0: Array, w1: Array) -> Array:
    """Integrals of s^(4-m) x^(2m)/W^3 over x from 0 to 1.

    Parameters
    ----------
    w0, w1 : (n,) array
        Branch length at equator and pole [-], > 0.

    Returns
    -------
    (5, n) array
        m = 0 ... 4 [-].

    Notes
    -----
    Accuracy: four units in the last place of each. Source: ``derivations.gradients_static``.

    Examples
    --------
    >>> one = np.ones(1)
    >>> round(float(short_integrals(one, one)[4, 0]), 15) == round(1 / 9, 15)
    True
    """
    result = np.empty((5, w0.size))
    for index, s, y, measure in _soft_groups(w0, w1, w0, w1):
        branch = np.outer(w0[index], s) + np.outer(w1[index], y)
        result[:, index] = _columns(s, y, measure, 4).T @ (1 / (branch * branch * branch)).T
    return result


Group = "tuple[Index, Array, Array, Array]"


def _soft_groups(w0: Array, w1: Array, a: Array, c: Array) -> list[tuple[Index, Array, Array, Array]]:
    """Elements that take the same nodes: Gauss nodes in x where all is mild, else log-tangent nodes."""
    mild = np.ones(a.shape, dtype=bool)
    for equator, pole in ((w0, w1), (a, c)):
        mild &= (pole >= MILD[0] * equator) & (pole <= MILD[1] * equator)
    s, y, measure = _gauss()
    groups = [(index, s, y, measure) for index in _pieces(np.flatnonzero(mild), s.size)]
    distance = np.maximum(_distance(w0, w1), _distance(a, c))
    return groups + _groups(np.flatnonzero(~mild), distance)


def _groups(chosen: Index, distance: Array) -> list[tuple[Index, Array, Array, Array]]:
    """Log-tangent nodes for each of the chosen elements, by the distance of its farthest singularity."""
    groups = []
    reach = np.ceil(distance[chosen]).astype(np.intp)
    for singular in np.unique(reach).tolist():
        s, y, measure = _far(singular)
        groups += [(index, s, y, measure) for index in _pieces(chosen[reach == singular], s.size)]
    return groups


def _pieces(index: Index, nodes: int) -> list[Index]:
    size = max(1, ENTRIES // nodes)
    return [index[start:start + size] for start in range(0, index.size, size)]


def _distance(equator: Array, pole: Array) -> Array:
    """How far from 45 degrees the singularity of a form in s and x^2 lies, in log(tan(beta))."""
    result: Array = np.abs(np.log(pole) - np.log(equator)) / 2
    return result


def _columns(s: Array, y: Array, measure: Array, degree: int) -> Array:
    """Weight times s^(degree-m) y^m at each node, (nodes, degree + 1)."""
    result: Array = np.stack([measure * s ** (degree - m) * y**m for m in range(degree + 1)], axis=-1)
    return result


@lru_cache(maxsize=1)
def _gauss() -> tuple[Array, Array, Array]:
    x = np.array(NODES[GAUSS])
    return (1 - x) * (1 + x), x * x, np.array(WEIGHTS[GAUSS])


@lru_cache(maxsize=64)
def _far(singular: int) -> tuple[Array, Array, Array]:
    rule = plain_rule(POLE - singular, EQUATOR + singular, singular)
    return np.array(rule.sine_squared), np.array(rule.cosine_squared), np.array(rule.measure)
