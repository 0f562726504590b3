"""How many Gauss nodes a smooth integrand needs along the meridian, and where they crowd, for a wanted accuracy.

Where no contact slips or has opened, the integrand is a polynomial in s and x^2 times powers of a few functions
p s + q x^2: the estimated force, the branch length, the radius of a spheroid. Each has its singularity where that
function vanishes, off the interval. Gauss nodes on a line t that is mapped to x converge like rho^(-2n), rho the size
of the largest ellipse around the interval of t without a singularity; what the polynomial grows to on the ellipse
counts against it. All of this is known before anything is evaluated.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache

from granular.generated.gauss_legendre import NODES
from granular.routes.axial_rules import STEP, Axis

SIZES = tuple(sorted(NODES))
"""Numbers of nodes for which Gauss rules are stored."""

CONSTANT = 64 / 15
"""Constant of the error of Gauss rules on an ellipse."""

OTHER_POWERS = 4.0
"""Room for the powers of p s + q x^2, whose size on an ellipse is taken for that on the interval, but for nearness to
their singularity. Over 20,000 random and boundary scenes and six accuracies none of it was needed."""

ELLIPSES = tuple(math.exp(0.06 * 1.25**k) for k in range(24))
"""Sizes of the ellipses that are tried [-]: the half axes added, over half the interval."""

FARTHEST = 40.0
"""Longest sinh map that is tried [-]; singularities closer than exp(-40) to the interval are left to other rules."""


@dataclass(frozen=True, slots=True)
class GaussRule:
    """A Gauss rule for a smooth integrand.

    Attributes
    ----------
    axis : Axis
        The end about which nodes crowd.
    length : float
        Length L of the sinh map [-]; 0 leaves the Gauss nodes in x where they are.
    nodes : int
        Number of nodes [-].
    error : float
        Bound of the error of any average, relative to that average [-].
    """

    axis: Axis
    length: float
    nodes: int
    error: float


Place = tuple[float, float]
"""p and q of a factor p s + q x^2, p, q >= 0 [-]."""


@lru_cache(maxsize=256)
def gauss_rule(places: tuple[Place, ...], *, degree: int, tolerance: float) -> GaussRule | None:
    """Choose the Gauss rule with the fewest nodes.

    Parameters
    ----------
    places : tuple of (float, float)
        p and q of the factors p s + q x^2 that are raised to other powers than whole positive ones [-].
    degree : int
        Degree of the polynomial in s and x^2 [-].
    tolerance : float
        Wanted error of any average, relative to that average [-], > 0.

    Returns
    -------
    GaussRule or None
        None when no stored rule is good enough.

    Notes
    -----
    Accuracy: ``error`` is the growth of the integrand on the best ellipse over the size of that ellipse to the power
    2 n, relative to the smallest average that a polynomial of the degree with positive coefficients may have. Source:
    Gauss quadrature of analytic functions, Trefethen, Approximation Theory and Practice (2013), th. 19.3.

    Examples
    --------
    >>> gauss_rule((), degree=5, tolerance=1e-3)
    GaussRule(axis=<Axis.EQUATOR: 'equator'>, length=0.0, nodes=6, error=0.0)
    >>> gauss_rule(((1.0, 3.0),), degree=5, tolerance=1e-3).nodes < gauss_rule(((1.0, 3.0),), degree=5,
    ...                                                                        tolerance=1e-12).nodes
    True
    """
    singular = tuple(place for place in places if place[0] != place[1])
    if not singular:
        return GaussRule(Axis.EQUATOR, 0.0, degree + 1, 0.0)
    best: GaussRule | None = None
    scale = math.log(OTHER_POWERS * CONSTANT / _smallest_average(degree))
    for axis, length in _maps(singular):
        ellipse = _largest_ellipse(axis, length, singular)
        candidates = [(scale + growth * degree + rest, math.log(size))
                      for size, growth, rest in _ellipses(axis, length, ellipse)]
        if not candidates:
            continue
        wanted = math.log(tolerance)
        needed = min((height - wanted) / (2 * rate) for height, rate in candidates)
        nodes = next((size for size in SIZES if size >= needed), None)
        if nodes is None or (best is not None and nodes >= best.nodes):
            continue
        logarithm = min(height - 2 * nodes * rate for height, rate in candidates)
        best = GaussRule(axis, length, nodes, math.exp(max(logarithm, -200.0)))
    return best


def _maps(places: tuple[Place, ...]) -> Iterator[tuple[Axis, float]]:
    """The line itself, and sinh maps that bring the singularities to i pi/2 or half way there."""
    yield Axis.EQUATOR, 0.0
    for p, q in places:
        axis, distance = _nearest(p, q)
        length = math.asinh(1 / distance) if distance > 0 else math.inf
        for share in (1.0, 0.5):
            rounded = max(1, round(min(share * length, 2 * FARTHEST) / STEP)) * STEP
            if rounded <= FARTHEST:
                yield axis, rounded


def _nearest(p: float, q: float) -> tuple[Axis, float]:
    """The end that a singularity is next to, and its distance in x or in tan(beta/2)."""
    if p < q:
        return Axis.EQUATOR, math.sqrt(p / (q - p))
    reach = math.sqrt(q / (p - q))
    return Axis.POLE, reach / (1 + math.hypot(1, reach))


def _largest_ellipse(axis: Axis, length: float, places: tuple[Place, ...]) -> float:
    """Size of the largest ellipse in t that holds no singularity."""
    scale = math.sinh(length)
    found = []
    for p, q in places:
        x = cmath.sqrt(p / (p - q))
        if axis is Axis.EQUATOR:
            found.append(_unmapped(x, length, scale))
        else:
            tangent = cmath.sqrt((1 - x) / (1 + x))
            found += [_unmapped(tangent, length, scale), _unmapped(-tangent, length, scale)]
    if axis is Axis.POLE:  # where x itself has its pole
        found.append(_unmapped(1j, length, scale))
    return min(found)


def _unmapped(y: complex, length: float, scale: float) -> float:
    """Size of the ellipse through the point that is mapped to y."""
    t = cmath.asinh(y * scale) / length if length else y
    z = 2 * t - 1
    root = cmath.sqrt(z * z - 1)
    return max(abs(z + root), abs(z - root))


def _ellipses(axis: Axis, length: float, largest: float) -> Iterator[tuple[float, float, float]]:
    """Sizes of ellipses inside the largest, growth of s and x^2 on them, and what else adds to the error (logarithms).

    That is the slope of the map, nearness to a double pole, and the smallness of the ellipse.
    """
    for size, (growth, slope) in zip(ELLIPSES, _growth(axis, length), strict=True):
        if size >= largest:
            return
        yield size, growth, slope - 2 * math.log(1 - size / largest) - math.log(1 - size**-2)


@lru_cache(maxsize=16)
def _smallest_average(degree: int) -> float:
    """Smallest average of s^i x^2j with i + j = degree: half the beta function of j + 1/2 and i + 1."""
    return min(math.exp(math.lgamma(j + 0.5) + math.lgamma(degree - j + 1) - math.lgamma(degree + 1.5)) / 2
               for j in range(degree + 1))


@lru_cache(maxsize=256)
def _growth(axis: Axis, length: float) -> tuple[tuple[float, float], ...]:
    """Logarithms of the largest \\|s\\| or \\|x^2\\|, and of the largest slope \\|dx/dt\\|, on each ellipse."""
    return tuple(_growth_on(size, axis, length, math.sinh(length)) for size in ELLIPSES)


def _growth_on(size: float, axis: Axis, length: float, scale: float) -> tuple[float, float]:
    largest, steepest = 1.0, 0.0
    for step in range(12):
        point = size * cmath.exp(1j * math.pi * step / 11)
        t = (point + 1 / point) / 4 + 0.5
        try:
            y = cmath.sinh(length * t) / scale if length else t
            slope = length * cmath.cosh(length * t) / scale if length else 1.0
            squared = y * y
            x2 = squared
            if axis is Axis.POLE:
                x2, slope = ((1 - squared) / (1 + squared)) ** 2, slope * 4 * y / (1 + squared) ** 2
        except (OverflowError, ZeroDivisionError):
            return math.inf, math.inf
        largest, steepest = max(largest, abs(x2), abs(1 - x2)), max(steepest, abs(slope))
    return math.log(largest), math.log(steepest)
