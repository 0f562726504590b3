"""The stiffness with contact forces and partial slip for whole arrays of assemblies: the twin of ``axial_kinetic``.

No loop runs over elements: those that need the same arcs are evaluated together, a block of elements times nodes at a
time, sorted by the number of nodes that they need.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from granular.hypothesis import Hypothesis
from granular.routes.log_tangent import TANGENT, TANGENT_INVERSE
from granular.routes.log_tangent_array import ENTRIES, beside, between, directions, sticking
from granular.routes.plain_rule import plain_rule
from granular.routes.slip_geometry_array import Geometry, forces, slip_geometry
from granular.routes.windows import EQUATOR, EQUATOR_INVERSE, EQUATOR_SLIP, POLE, POLE_INVERSE, POLE_SLIP

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]
    Index = NDArray[np.intp]

RELATIVE_ERROR = 8 * 2.0**-52
"""Bound for every component that is not subnormal [-]."""

MILD = (1 / 3, 12.0)
"""Ratios c/a for which 28 Gauss nodes in x integrate a kinematic moment to 1e-17."""

GAUSS, NOBODY = -1, -2
"""Marks of elements that take the Gauss nodes, and of those that take no plain rule."""


@dataclass(frozen=True, slots=True)
class Elements:
    """What the integrand of each element needs.

    Attributes
    ----------
    e0, e1, w0, w1 : (n,) array
        Density of contact normals and branch-length weight at equator and pole [-].
    a, c : (n,) array
        Normal force at equator and pole over that of the isotropic assembly [-].
    """

    e0: Array
    e1: Array
    w0: Array
    w1: Array
    a: Array
    c: Array

    def of(self, index: Index) -> Elements:
        """Take some of the elements."""
        return Elements(*(getattr(self, name)[index] for name in self.__slots__))


def components(D33: Array, Dr33: Array, stress_ratio: Array, friction: Array | None, poisson_ratio: Array, *,
               hypothesis: Hypothesis) -> Array:
    """Six components over (M/V) l_e^2 k_n,ref for arrays of assemblies that are known to be admissible.

    Parameters
    ----------
    D33, Dr33 : (n,) array
        P2 coefficients of the contact-normal density and of the branch-length weight [-].
    stress_ratio : (n,) array
        sigma33/sigma11 [-], > 0.
    friction : (n,) array or None
        mu [-], >= 0; None for contacts that never slip.
    poisson_ratio : (n,) array
        Poisson's ratio of the grain material [-], 0 <= nu <= 0.5.
    hypothesis : Hypothesis
        Kinematic, or static where no contact slides.

    Returns
    -------
    (n, 6) array
        C1111, C3333, C1122, C1133, C2323, C1212 [-].

    Accuracy
    --------
    ``RELATIVE_ERROR`` for every component.

    Source
    ------
    Eq. (7), and Figure 1(b) with (23).

    Examples
    --------
    >>> one = np.ones(1)
    >>> components(0 * one, 0 * one, one, None, 0 * one, hypothesis=Hypothesis.KINEMATIC).shape
    (1, 6)
    """
    from granular.generated import kinetic_components_array as emitted

    nu = poisson_ratio
    lam0, rest = 2 * (1 - nu) / (2 - nu), nu / (2 - nu)
    normal, shear, lost = moments(D33, Dr33, stress_ratio, friction, hypothesis=hypothesis)
    if hypothesis is Hypothesis.KINEMATIC:
        (p0, p1, p2), (q0, q1, q2), (d0, d1, _) = normal, lam0 * shear, rest * normal + lam0 * lost
        parts = emitted.stiffness_from_weights(p0, p1, p2, q0, q1, q2, d0, d1)
    else:
        (u0, u1, u2), (v0, v1, v2), (d0, d1, _) = normal, shear / lam0, (rest * normal + lost) / lam0
        parts = emitted.stiffness_from_flexibilities(u0, u1, u2, v0, v1, v2, d0, d1, D33)
    result: Array = np.stack(parts, axis=-1)
    return result


def moments(D33: Array, Dr33: Array, stress_ratio: Array, friction: Array | None, *,
            hypothesis: Hypothesis) -> Array:
    """Moments of the normal stiffness, of the shear stiffness over lambda_0, and of what slip takes from it.

    Parameters
    ----------
    D33, Dr33, stress_ratio, friction, hypothesis
        As for :func:`components`.

    Returns
    -------
    (3, 3, n) array
        For k_n, k_n chi, k_n (1 - chi) (kinematic) or 1/k_n, 1/(k_n chi), (1 - chi)/(k_n chi) (static), the moments
        with s^2, s x^2 and x^4 of E W^2, or of E/W^2 [-].

    Accuracy
    --------
    Two to three units in the last place of each moment.

    Source
    ------
    ``granular.routes.log_tangent``.
    """
    a, c = forces(D33, stress_ratio)
    elements = Elements(1 - D33 / 2, 1 + D33, 1 - Dr33 / 2, 1 + Dr33, a, c)
    result = np.zeros((3, 3, D33.size))
    slips = np.zeros(D33.shape, dtype=bool)
    if friction is not None:
        rubbing = np.flatnonzero(friction > 0)
        geometry = slip_geometry(D33[rubbing], stress_ratio[rubbing], friction[rubbing])
        sheared = geometry.kappa > 0
        slips[rubbing] = sheared
        if sheared.any():
            _add_slipping(result, elements, geometry.of(np.flatnonzero(sheared)), rubbing[sheared], hypothesis)
    for plain in _plain_groups(elements, ~slips, hypothesis):
        result[0][:, plain.index] = plain.moments.T
        row = np.ones(plain.index.shape, dtype=np.intp) if friction is None else np.where(
            friction[plain.index] == 0, 2, 1)  # without friction all of it is lost
        for part in (1, 2):
            result[part][:, plain.index[row == part]] = plain.moments[row == part].T
    return result


@dataclass(frozen=True, slots=True)
class _Plain:
    """Moments of a block of elements whose contacts do not slip."""

    index: Index
    moments: Array


def _plain_groups(elements: Elements, chosen: NDArray[np.bool_], hypothesis: Hypothesis) -> Iterator[_Plain]:
    """Elements without slip: 28 Gauss nodes in x, or a log-tangent rule that reaches beyond their singularities."""
    ratio = elements.c / elements.a
    reach = np.ceil(np.abs(_places(elements, hypothesis)).max(axis=0)).astype(np.intp)
    if hypothesis is Hypothesis.KINEMATIC:
        reach[(ratio >= MILD[0]) & (ratio <= MILD[1])] = GAUSS
    reach[~chosen] = NOBODY
    for singular in np.unique(reach[chosen]).tolist():
        members = np.flatnonzero(reach == singular)
        s, y, measure = _gauss_rule() if singular == GAUSS else _plain_rule(hypothesis, singular)
        for start in range(0, members.size, max(1, ENTRIES // s.size)):
            index = members[start:start + max(1, ENTRIES // s.size)]
            part = elements.of(index)
            yield _Plain(index, _weighted(part, s, y, measure, hypothesis)[0])


def _weighted(part: Elements, s: Array, y: Array, measure: Array, hypothesis: Hypothesis,
              chi: Array | None = None, gamma: Array | None = None) -> list[Array]:
    """Three moments of each weight, (n, 3), from nodes (n or 1, nodes)."""
    column = {name: getattr(part, name)[:, None] for name in part.__slots__}
    branch = column["w0"] * s + column["w1"] * y
    normal = np.cbrt(column["a"] * s + column["c"] * y)
    density = measure * (column["e0"] * s + column["e1"] * y)
    if hypothesis is Hypothesis.KINEMATIC:
        weights = [density * (branch * branch) * normal]
        if chi is not None and gamma is not None:
            weights += [weights[0] * chi, weights[0] * gamma]
    else:
        weights = [density / (branch * branch * normal)]
        if chi is not None and gamma is not None:
            yielding = weights[0] / chi
            weights += [yielding, yielding * gamma]
    forms = (s * s, s * y, y * y)
    return [np.stack([(weight * form).sum(axis=-1) for form in forms], axis=-1) for weight in weights]


def _add_slipping(result: Array, elements: Elements, geometry: Geometry, members: Index,
                  hypothesis: Hypothesis) -> None:
    """Add the arcs of the elements whose contacts carry shear forces."""
    smallest = TANGENT if hypothesis is Hypothesis.KINEMATIC else TANGENT_INVERSE
    here = elements.of(members)
    places = _places(here, hypothesis)
    low, high = _window(places, hypothesis)
    rho = np.sqrt(np.maximum(-geometry.left / 2, 0.0))
    wide = rho >= smallest
    for arc in (arc for outward in (False, True) for arc in (
            sticking(geometry, ~wide, low, high, smallest, places, outward=outward),
            beside(geometry, wide, low, high, rho, places, outward=outward),
            between(geometry, wide, low, high, places, outward=outward))):
        for index, t, measure, chi, gamma in arc.blocks():
            s, y, weight = directions(t, measure)
            sums = _weighted(here.of(index), s, y, weight, hypothesis, chi, gamma)
            for row, moment in enumerate(sums):
                result[row][:, members[index]] += moment.T


def _places(elements: Elements, hypothesis: Hypothesis) -> Array:
    """log(tan(beta)) of the singularities, as in ``axial_kinetic``."""
    places = [np.zeros_like(elements.a), (np.log(elements.c) - np.log(elements.a)) / 2]
    if hypothesis is Hypothesis.STATIC:
        places.append((np.log(elements.w1) - np.log(elements.w0)) / 2)
    return np.array(places)


def _window(places: Array, hypothesis: Hypothesis) -> tuple[Array, Array]:
    """Range of log(tan(beta)) that matters where contacts slip, as in ``axial_kinetic``."""
    if hypothesis is Hypothesis.KINEMATIC:
        zero = np.zeros_like(places[0])
        return zero + POLE_SLIP, zero + EQUATOR_SLIP
    return POLE + places.min(axis=0), EQUATOR + places.max(axis=0)


@lru_cache(maxsize=1)
def _gauss_rule() -> tuple[Array, Array, Array]:
    """28 Gauss nodes in x."""
    from granular.routes.axial_rules import Axis, axial_rule

    rule = axial_rule(Axis.EQUATOR, 0.0, 28)
    s, y = np.array(rule.sine_squared), np.array(rule.cosine_squared)
    measure = np.array(rule.columns).T @ np.array([1.0, 4.0, 6.0, 4.0, 1.0])
    return s, y, measure


@lru_cache(maxsize=64)
def _plain_rule(hypothesis: Hypothesis, singular: int) -> tuple[Array, Array, Array]:
    """Nodes for contacts that do not slip, as far as any fabric and force with such singularities needs them."""
    low, high = (POLE, EQUATOR) if hypothesis is Hypothesis.KINEMATIC else (POLE_INVERSE - singular,
                                                                            EQUATOR_INVERSE + singular)
    rule = plain_rule(low, high, singular)
    return np.array(rule.sine_squared), np.array(rule.cosine_squared), np.array(rule.measure)
