"""Gauss-Legendre rules on 0 <= x <= 1 whose nodes crowd towards the direction in which 1/W^2 is largest.

Gauss nodes t on [0, 1] are sent to y = sinh(L t)/sinh(L). About the equator x = y; about the pole y is the tangent
of half the angle, x = (1 - y^2)/(1 + y^2). The poles of 1/W^2 beside the peak then lie near L t = i pi/2, at the
same distance from the interval for every fabric, and so does the only other singularity, at the far end. The
number of nodes therefore grows with L alone, and L is the logarithm of w1/w0: it is at most 20 for any
representable fabric.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from decimal import Decimal, localcontext
from enum import Enum
from functools import lru_cache

from granular.generated.gauss_legendre import NODES, WEIGHTS
from granular.routes.meridian import Directions

POWERS = 5
"""Columns of a rule: s^(4-m) x^(2m), m = 0 ... 4, the products of a density and a moment that are quadratic each."""

STEP = 0.5
"""L is rounded to a multiple of this, so that at most 80 rules exist and each is made once.

The singularity then lies a little beside i pi/2; the errors stated at ``nodes_needed`` include that."""

DIGITS = 30
"""Rules are made in decimal arithmetic with this many digits and rounded once."""


class Axis(Enum):
    """The direction in which the branches are shortest, and the nodes crowd."""

    EQUATOR = "equator"
    POLE = "pole"


@dataclass(frozen=True, slots=True)
class AxialRule:
    """Nodes and weights for averages over 0 <= x <= 1.

    Attributes
    ----------
    sine_squared, cosine_squared : tuple of float, (n,)
        s = 1 - x^2 and x^2 at the nodes [-], each with full relative accuracy.
    measure : tuple of float, (n,)
        Weights [-].
    columns : tuple of tuple of float, (5, n)
        Weight times s^(4-m) x^(2m), m = 0 ... 4 [-].
    """

    sine_squared: tuple[float, ...]
    cosine_squared: tuple[float, ...]
    measure: tuple[float, ...]
    columns: tuple[tuple[float, ...], ...]

    def __len__(self) -> int:
        """Count the nodes."""
        return len(self.sine_squared)

    @property
    def directions(self) -> Directions:
        """The nodes with their weights alone."""
        return Directions(self.sine_squared, self.cosine_squared, self.measure)


def crowding(w0: float, w1: float) -> tuple[Axis, float]:
    """Where and how strongly the nodes have to crowd for a weight 1/(w0 s + w1 x^2)^2.

    Parameters
    ----------
    w0, w1 : float
        Branch length at equator and pole over its mean scale [-], > 0.

    Returns
    -------
    axis : Axis
        The end with the shorter branches.
    L : float
        Length of the sinh map [-], a positive multiple of ``STEP``.

    Accuracy
    --------
    The pole of the weight is met to within ``STEP / 2`` in L.

    Source
    ------
    The zeros of W = w0 + (w1 - w0) x^2, in x about the equator and in tan(beta/2) about the pole.

    Examples
    --------
    >>> crowding(1.0, 1.0)
    (<Axis.EQUATOR: 'equator'>, 0.5)
    >>> crowding(1.5, 2.0**-53)
    (<Axis.POLE: 'pole'>, 20.0)
    """
    if w0 <= ROUND * w1:
        distance = math.sqrt(w0 / (w1 - w0)) if w1 > w0 else math.inf
        return Axis.EQUATOR, _rounded_length(distance)
    reach = math.sqrt(w1 / (w0 - w1))
    return Axis.POLE, _rounded_length(reach / (1 + math.hypot(1, reach)))


ROUND = 1.35
"""Up to this w0/w1 the weight is so flat that the mildest rule about the equator integrates it (error < 1e-23)."""


def _rounded_length(distance: float) -> float:
    """L with sinh(L) = 1/distance, to the nearest multiple of STEP but not below it."""
    return max(1, round(math.asinh(1 / distance) / STEP)) * STEP


def nodes_needed(length: float) -> int:
    """How many Gauss nodes integrate every moment of the weight to rounding.

    Parameters
    ----------
    length : float
        Length L of the sinh map [-], > 0.

    Returns
    -------
    int
        28 or 80 nodes [-].

    Accuracy
    --------
    Error of the rule below 4e-18 of every moment, measured in 50 digits over the whole range of each choice.

    Source
    ------
    Gauss rules converge as rho**(-2 n), rho = 1.49 or more for a singularity at i pi/2 beside an end and L <= 20.

    Examples
    --------
    >>> nodes_needed(0.5), nodes_needed(20.0)
    (28, 80)
    """
    return 28 if length <= 3 else 80


@lru_cache(maxsize=256)
def axial_rule(axis: Axis, length: float, nodes: int) -> AxialRule:
    """Make a rule; it is made once in a process and kept.

    Parameters
    ----------
    axis : Axis
        The end about which nodes crowd.
    length : float
        Length L of the sinh map [-], >= 0; 0 leaves the Gauss nodes where they are.
    nodes : int
        Number of nodes [-], one for which Gauss-Legendre nodes are stored.

    Returns
    -------
    AxialRule
        Nodes and weights on 0 <= x <= 1.

    Accuracy
    --------
    Every entry is correctly rounded but for the rounding of the stored Gauss nodes and weights.

    Source
    ------
    Change of variable x = sinh(L t)/sinh(L), or x = (1 - y^2)/(1 + y^2) with that y.

    Examples
    --------
    >>> rule = axial_rule(Axis.EQUATOR, 0.5, 16)
    >>> len(rule), abs(sum(rule.columns[4]) - 1/9) < 1e-16
    (16, True)
    """
    with localcontext() as context:
        context.prec = DIGITS
        one, span = Decimal(1), Decimal(length)
        rows = []
        for t, mirrored, weight in zip(NODES[nodes], NODES[nodes][::-1], WEIGHTS[nodes], strict=True):
            # The far half is measured from its own end, where the stored node keeps more digits than 1 - t does.
            y, slope = _sinh_map(span, Decimal(t) if t < mirrored else one - Decimal(mirrored))
            if axis is Axis.EQUATOR:
                cosine_squared, per_slope = y * y, one
                sine_squared = one - cosine_squared
            else:
                cosine_squared = ((one - y * y) / (one + y * y)) ** 2
                sine_squared = (2 * y / (one + y * y)) ** 2
                per_slope = 4 * y / (one + y * y) ** 2
            measure = Decimal(weight) * slope * per_slope
            rows.append((float(sine_squared), float(cosine_squared), float(measure), *(
                float(measure * sine_squared ** (POWERS - 1 - m) * cosine_squared**m) for m in range(POWERS))))
    sines, cosines, measures, *columns = zip(*rows, strict=True)
    return AxialRule(sines, cosines, measures, tuple(columns))


def _sinh_map(length: Decimal, t: Decimal) -> tuple[Decimal, Decimal]:
    """Return y = sinh(L t)/sinh(L) and dy/dt."""
    if not length:
        return t, Decimal(1)
    grown, whole = (length * t).exp(), length.exp()
    denominator = whole - 1 / whole
    return (grown - 1 / grown) / denominator, length * (grown + 1 / grown) / denominator
