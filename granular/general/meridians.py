"""Nodes along meridians about any pole, with panels that shrink towards the edges of sliding and opening.

Along one meridian the squared forces are polynomials of degree four in the tangent of the angle, so that every edge is
a root, found whether it is real or not: a pair of complex roots close to the meridian is an edge about to appear, and
the integrand bends there as sharply. Panels shrink geometrically towards each root until the nearest other root is as
far away as the panel is long; the last one before a real edge is mapped by a cube, which undoes the cube root there.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]
    Complex = NDArray[np.complex128]
    Whole = NDArray[np.int64]

SHRINK = 0.3
"""Length of a panel over that of its neighbour away from a root [-]."""

FAR = 0.7
"""Complex roots further from the meridian than this get no panels of their own [rad]."""

REAL = 1e-9
"""Imaginary parts below this belong to real roots [rad]."""


AT_END = 3e-8
"""Roots this close to an end of a meridian lie on it: a double root there is known to half the digits [rad]."""

TOUCHING = 1e-6
"""Two edges closer than this are not counted: rounding decides whether a double root is real [rad]."""


@dataclass(frozen=True, slots=True)
class Integrand:
    """What decides where the integrand is not smooth.

    Attributes
    ----------
    forces : (3, 3) array or None
        B of the contact forces [-]; None for contacts of equal stiffness.
    friction : float or None
        Friction coefficient [-].
    branches : (3, 3) array or None
        Dr where 1/W^2 is averaged [-], None where W^2 is.
    """

    forces: Array | None
    friction: float | None
    branches: Array | None

    @property
    def slips(self) -> bool:
        """Whether shear forces take anything from the stiffness."""
        return self.forces is not None and self.friction is not None and self.friction > 0


@dataclass(frozen=True, slots=True)
class Meridians:
    """Great circles from a pole, each up to an edge of its triangle.

    Attributes
    ----------
    pole, towards, limit : (k, 3) arrays
        Pole, unit vector at a right angle to it in the plane of the meridian, and normal of the edge that ends it [-].
    """

    pole: Array
    towards: Array
    limit: Array

    def ends(self) -> Array:
        """Angle from the pole to the edge [rad], (k,)."""
        import numpy as np

        found: Array = np.arctan2((self.limit * self.pole).sum(axis=1), -(self.limit * self.towards).sum(axis=1))
        return found


def directions(meridians: Meridians, which: Whole, angle: Array) -> Array:
    """Unit vectors at given angles from the pole.

    Parameters
    ----------
    meridians : Meridians
        The great circles.
    which : (q,) array of int
        Meridian of each direction [-].
    angle : (q,) array
        Angle from the pole [rad].

    Returns
    -------
    (3, q) array
        Directions [-].

    Notes
    -----
    Source: polar coordinates.
    """
    import numpy as np

    found: Array = np.cos(angle) * meridians.pole[which].T + np.sin(angle) * meridians.towards[which].T
    return found


def special_angles(integrand: Integrand, meridians: Meridians) -> Complex:
    """Complex angles at which the integrand is not smooth, on each meridian.

    Parameters
    ----------
    integrand : Integrand
        Forces, friction and branches.
    meridians : Meridians
        The great circles.

    Returns
    -------
    (k, m) complex array
        Angles from the pole [rad]: edges of sliding (4), zeros of the shear force (2), edges of opening (2), zeros of
        the branch length (2), where they matter.

    Notes
    -----
    Accuracy: that of eigenvalues; 1e-8 for double roots. Source: \\|B n\\|^2 = (1 + mu^2) (n B n)^2 at the edge of
    sliding.
    """
    import numpy as np

    half = meridians.ends() / 2
    cosine, sine = np.cos(half)[:, None], np.sin(half)[:, None]
    a = cosine * meridians.pole + sine * meridians.towards
    b = cosine * meridians.towards - sine * meridians.pole
    found = []
    if integrand.forces is not None:
        B = integrand.forces
        normal = _quadratic((B + B.T) / 2, a, b)
        found.append(half[:, None] + _angles(_roots(normal)))
        if integrand.slips:
            assert integrand.friction is not None
            squared = _quadratic(B.T @ B, a, b)
            edge = (1 + integrand.friction**2) * _product(normal, normal)
            edge -= _product(squared, np.array([[1.0, 0.0, 1.0]]))
            found.append(half[:, None] + _angles(_roots(edge)))
            found.append(_shearless(B, meridians))
    if integrand.branches is not None:
        found.append(half[:, None] + _angles(_roots(_quadratic(np.eye(3) + integrand.branches, a, b))))
    if not found:
        return np.empty((half.size, 0), dtype=complex)
    return np.concatenate(found, axis=1)


def _quadratic(tensor: Array, a: Array, b: Array) -> Array:
    """Coefficients of a form along a + b t, rising."""
    import numpy as np

    of_a, of_b = a @ tensor, b @ tensor
    return np.stack([(of_a * a).sum(axis=1), 2 * (of_a * b).sum(axis=1), (of_b * b).sum(axis=1)], axis=1)


def _product(one: Array, other: Array) -> Array:
    """Product of two quadratics, row by row."""
    import numpy as np

    found = np.zeros((max(len(one), len(other)), 5))
    for i in range(3):
        for j in range(3):
            found[:, i + j] += one[:, i] * other[:, j]
    return found


def _roots(coefficients: Array) -> Complex:
    """Roots of polynomials of one degree: eigenvalues of companion matrices.

    A vanishing leading coefficient is lifted to rounding, which only moves a root that is far away.
    """
    import numpy as np

    degree = coefficients.shape[1] - 1
    lead = coefficients[:, -1]
    least = 1e-15 * np.abs(coefficients).max(axis=1) + 1e-300
    lead = np.where(np.abs(lead) < least, np.where(lead < 0, -least, least), lead)
    companion = np.zeros((len(lead), degree, degree))
    companion[:, np.arange(1, degree), np.arange(degree - 1)] = 1
    companion[:, :, -1] = -coefficients[:, :-1] / lead[:, None]
    return np.linalg.eigvals(companion).astype(complex)


def _angles(tangents: Complex) -> Complex:
    """Complex angles by their tangents: real part within a right angle, imaginary part at most 50."""
    import numpy as np

    x, y = tangents.real, tangents.imag
    with np.errstate(over="ignore", invalid="ignore"):
        squared = x * x + y * y
        real = np.arctan2(2 * x, 1 - squared) / 2
        imaginary = np.arctanh(np.clip(2 * y / (1 + squared), -1 + 1e-16, 1 - 1e-16)) / 2
    return real + 1j * np.where(np.isfinite(imaginary), imaginary, 0.0)


def _shearless(B: Array, meridians: Meridians) -> Complex:
    """Where the shear force would vanish: (n x B n) over the sine is P cos + Q sin, as B n = b n at the pole."""
    import numpy as np

    pole, towards = meridians.pole, meridians.towards
    of_pole = (pole @ B.T * pole).sum(axis=1)
    turned = towards @ B.T
    P = np.cross(pole, turned - of_pole[:, None] * towards)
    Q = np.cross(towards, turned)
    scale = (Q**2).sum(axis=1)
    along, across = -(P * Q).sum(axis=1), np.sqrt((np.cross(P, Q) ** 2).sum(axis=1))
    size = along**2 + across**2
    real = np.mod(np.arctan2(2 * along * scale, scale**2 - size) / 2, math.pi)
    share = np.divide(2 * across * scale, scale**2 + size, out=np.ones_like(scale), where=scale**2 + size > 0)
    imaginary = np.arctanh(np.clip(share, 0.0, 1 - 1e-16)) / 2
    return np.stack([real + 1j * imaginary, real - 1j * imaginary], axis=1)


@dataclass(frozen=True, slots=True)
class Panels:
    """Pieces of meridians that carry Gauss nodes.

    Attributes
    ----------
    which : (p,) array of int
        Meridian of each [-], in rising order.
    root, near, far : (p,) arrays
        The root that the panel belongs to, and its ends as signed distances from there [rad].
    cubic : (p,) array of bool
        Whether nodes crowd towards the root like a cube.
    """

    which: Whole
    root: Array
    near: Array
    far: Array
    cubic: NDArray[np.bool_]


def panels(integrand: Integrand, meridians: Meridians, *, finest: float) -> Panels:
    """Cut the meridians into panels.

    Parameters
    ----------
    integrand : Integrand
        Forces, friction and branches.
    meridians : Meridians
        The great circles.
    finest : float
        Distances between roots below this are not resolved [rad].

    Returns
    -------
    Panels
        Those on which the integrand is not zero throughout.

    Notes
    -----
    Accuracy: n Gauss nodes on each panel leave about 11^-n of the part that is not smooth. Source: geometric meshes.
    """
    import numpy as np

    ends = meridians.ends()
    roots = special_angles(integrand, meridians)
    counted = (np.abs(roots.imag) < FAR) & (roots.real > AT_END) & (roots.real < ends[:, None] - AT_END)
    real = counted & (np.abs(roots.imag) < REAL)
    zero = np.zeros_like(ends)
    place = np.concatenate([zero[:, None], np.where(counted, roots.real, ends[:, None]), ends[:, None]], axis=1)
    edge = np.concatenate([zero[:, None] > 0, real, zero[:, None] > 0], axis=1)
    order = np.argsort(place, axis=1, kind="stable")
    place, edge = np.take_along_axis(place, order, axis=1), np.take_along_axis(edge, order, axis=1)
    gap = np.abs(place[:, :, None] - roots[:, None, :])
    gap = np.where((gap < REAL) & edge[:, :, None], np.inf, gap)  # an edge itself is dealt with by the cube
    apart = np.maximum(gap.min(axis=2, initial=10.0), finest)
    length = np.diff(place, axis=1) / 2
    which, column = np.nonzero(length > 1e-15)
    middle = place[which, column] + length[which, column]
    if integrand.forces is not None:
        n = directions(meridians, which, middle)
        pressed = ((integrand.forces @ n) * n).sum(axis=0) > 0
        which, column = which[pressed], column[pressed]
    both = np.repeat(which, 2)
    ends_of = np.stack([column, column + 1], axis=1).ravel()
    half = np.repeat(length[which, column], 2)
    sign = np.tile([1.0, -1.0], which.size)
    return _shrunk(both, place[both, ends_of], half, sign, edge[both, ends_of], apart[both, ends_of])


def _shrunk(which: Whole, root: Array, half: Array, sign: Array, edge: NDArray[np.bool_], apart: Array) -> Panels:
    import numpy as np

    wanted = np.where(edge, 0.25, 1.0) * apart
    steps = np.ceil(np.log(np.maximum(half / wanted, 1.0)) / -math.log(SHRINK) - 1e-9).astype(np.int64)
    parent = np.repeat(np.arange(which.size), steps + 1)
    level = np.arange(parent.size) - np.repeat(np.cumsum(steps + 1) - (steps + 1), steps + 1)
    far = half[parent] * SHRINK**level
    last = level == steps[parent]
    near = np.where(last, 0.0, far * SHRINK)
    return Panels(which[parent], root[parent], sign[parent] * near, sign[parent] * far, last & edge[parent])


def edges_passed(integrand: Integrand, meridians: Meridians) -> Whole:
    """Count the edges of sliding and opening on each meridian; two that all but touch are none.

    Parameters
    ----------
    integrand : Integrand
        Forces, friction and branches.
    meridians : Meridians
        The great circles.

    Returns
    -------
    (k,) array of int
        Edges [-]; where it changes from one meridian to the next, the integral along a meridian is not smooth.

    Notes
    -----
    Source: real roots of the same polynomials.
    """
    import numpy as np

    roots = special_angles(integrand, meridians)
    kept = 0 if integrand.forces is None else 6 if integrand.slips else 2
    roots = roots[:, :kept]
    apart = np.abs(roots[:, :, None] - roots[:, None, :]) + 10 * np.eye(kept)
    inside = (np.abs(roots.imag) < REAL) & (apart.min(axis=2, initial=10.0) > TOUCHING)
    inside &= (roots.real > 0) & (roots.real < meridians.ends()[:, None])
    if integrand.forces is not None:
        which, column = np.nonzero(inside)
        n = directions(meridians, which, roots.real[which, column])
        pressed = ((integrand.forces @ n) * n).sum(axis=0) > -1e-9
        inside[which, column] = pressed
    count: Whole = inside.sum(axis=1)
    return count
