"""Slopes of the moments of the shear stiffness where contacts slip: integrals over the contacts that stick.

The nodes are those of ``granular.routes.log_tangent_array``. The slopes have the power -2/3 of what is left before
sliding (kinematic), or -4/3 (static), under the integral where the value has 1/3 or -1/3. So the arcs beside a sliding
range go on until exp(-2 v/3) is left, and directions that are about to slide are resolved as far as doubles reach.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from granular.hypothesis import Hypothesis
from granular.routes.log_tangent import TANGENT_INVERSE
from granular.routes.log_tangent_array import Arc, beside, directions, sticking
from granular.routes.windows import EQUATOR, POLE

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from granular.routes.axial_kinetic_array import Elements
    from granular.routes.slip_geometry_array import Geometry

    Array = NDArray[np.float64]

NEAREST = 60.0
"""How near nodes come to the edge of a sliding range, -v: exp(-2 v/3) = 4e-18 of a slope is left."""

SUMS = 13
"""Rows of :func:`sticking_sums`: Q0 ... Q3, R0 ... R2, three by D33 and three by Dr33."""


def sticking_sums(elements: Elements, geometry: Geometry, hypothesis: Hypothesis) -> Array:
    """Integrals over the contacts that stick from which every slope of the shear moments follows.

    Parameters
    ----------
    elements : Elements
        Density, branch lengths and forces of each element.
    geometry : Geometry
        Where its contacts stick and slide; shear forces present.
    hypothesis : Hypothesis
        Kinematic, or static where no contact slides.

    Returns
    -------
    (13, n) array
        Q0 ... Q3 and R0 ... R2 as ``derivations.gradients.shear_slopes`` wants them, then the slopes of the three
        moments by D33 and by Dr33 with the forces held [-].

    Notes
    -----
    Accuracy: a few units in the last place of the sum of the absolute terms. Source: ``derivations.gradients``.
    """
    places = [np.zeros_like(elements.a), (np.log(elements.c) - np.log(elements.a)) / 2]
    if hypothesis is Hypothesis.STATIC:
        places.append((np.log(elements.w1) - np.log(elements.w0)) / 2)
    where = np.array(places)
    low, high = POLE + where.min(axis=0), EQUATOR + where.max(axis=0)
    rho = np.sqrt(np.maximum(-geometry.left / 2, 0.0))
    wide = geometry.left < 0
    result = np.zeros((SUMS, elements.a.size))
    for outward in (False, True):
        for arc in (sticking(geometry, ~wide, low, high, TANGENT_INVERSE, where, outward=outward),
                    beside(geometry, wide, low, high, rho, where, outward=outward, nearest=NEAREST)):
            _add(result, arc, elements, hypothesis)
    return result


def _add(result: Array, arc: Arc, elements: Elements, hypothesis: Hypothesis) -> None:
    """Add the nodes of one kind of arc."""
    for index, t, measure, chi, _ in arc.blocks():
        s, y, weight = directions(t, measure)
        part = elements.of(index)
        column = {name: getattr(part, name)[:, None] for name in part.__slots__}
        branch = column["w0"] * s + column["w1"] * y
        density = column["e0"] * s + column["e1"] * y
        force = column["a"] * s + column["c"] * y
        shear = np.cbrt(force) * chi
        legendre = y - s / 2
        if hypothesis is Hypothesis.KINEMATIC:
            core = weight * density * branch * branch / (3 * (shear * shear))
            by_density = weight * branch * branch * shear * legendre
            by_branch = 2 * weight * density * branch * shear * legendre
        else:
            core = -weight * density / (3 * (branch * shear * shear) ** 2)
            by_density = weight / (branch * branch * shear) * legendre
            by_branch = -2 * density / branch * by_density
        root = np.sqrt(s * y)
        forms, cubes = (s * s, s * y, y * y), (s * s * s, s * s * y, s * y * y, y * y * y)
        rows = [*((core, form) for form in cubes), *((core * root, form) for form in forms),
                *((by_density, form) for form in forms), *((by_branch, form) for form in forms)]
        for row, (values, form) in enumerate(rows):
            result[row, index] += np.einsum("ij,ij->i", values, form)
