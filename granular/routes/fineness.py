"""How fine the rules along the meridian have to be for a wanted accuracy, and how far they have to reach."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from granular.hypothesis import Hypothesis
from granular.routes.accuracy import RANK_FOUR_FACTOR
from granular.routes.arithmetic import FLOAT_ERROR, QUICK

if TYPE_CHECKING:
    from granular.fabric import AxialFabric


@dataclass(frozen=True, slots=True)
class Fineness:
    """Settings of a rule along the meridian.

    Attributes
    ----------
    steps : int
        Nodes of the trapezoidal rule for each unit of the mapped line [-].
    share : float
        Length of its windows over that which leaves 2^-60 of a moment outside [-].
    error : float
        Bound of the error of any average, relative to that average [-]; also what Gauss rules are chosen for.
    """

    steps: int
    share: float
    error: float


FULL = Fineness(steps=14, share=1.0, error=2.0**-56)
"""To rounding: exp(-2 pi (pi/4) 14) = 1e-30 leaves room for the high poles of the directions at t = +-i, which multiply
it by up to 1e9, and for the narrowing of the strip where nodes begin to hurry."""

LOOSEST = 1e-3
"""A looser accuracy than this buys nothing more: the error models hold for small errors [-]."""

COARSEST = 4
"""Fewest nodes for each unit."""

AT_COARSEST, GAIN = 1.5e-3, 3.75
"""Error of the coarsest rule [-], and the logarithm by which one more node for each unit divides it. On 10,000 random
and boundary scenes with slip and opening the worst were 2.4e-4, 6.3e-6, 1.3e-7, 2.8e-9, 5.6e-11, 1.1e-12 for 4 to 9
nodes; a climb towards the worst found four times that. The strips of analyticity alone would give 4.9."""

CUT, REACH = 5.0, 41.6
"""What windows leave outside is at most CUT exp(-REACH share) of a moment; the worst found is 2.8 exp(-REACH share)."""


def fineness_for(rtol: float | None, fabric: AxialFabric, hypothesis: Hypothesis) -> Fineness:
    """Find the coarsest settings that keep a wanted accuracy.

    Parameters
    ----------
    rtol : float or None
        Wanted relative accuracy of every component [-]; None for all that doubles hold.
    fabric : AxialFabric
        Contact normals and branches about axis 3 [-].
    hypothesis : Hypothesis
        Kinematic or static.

    Returns
    -------
    Fineness
        ``FULL`` where ``rtol`` is None or below ``QUICK``.

    Notes
    -----
    Accuracy: rule and windows together err by at most ``error``, which leaves ``FLOAT_ERROR`` to rounding. Source: the
    trapezoidal rule of functions analytic in a strip, Trefethen and Weideman, SIAM Review 56 (2014), th. 5.1, with
    constants as measured.

    Examples
    --------
    >>> from granular.fabric import AxialFabric
    >>> [fineness_for(rtol, AxialFabric(), Hypothesis.KINEMATIC).steps for rtol in (1e-3, 1e-6, 1e-12)]
    [5, 6, 10]
    """
    if rtol is None or not rtol >= QUICK:
        return FULL
    wanted = min(rtol, LOOSEST) * (1 - 2.0**-40)  # so that no rounding makes a promise of more than was wanted
    error = (wanted - FLOAT_ERROR) / amplification(fabric, hypothesis)
    steps = COARSEST + max(0, math.ceil(math.log(AT_COARSEST / (0.9 * error)) / GAIN))
    spacing = AT_COARSEST * math.exp(-GAIN * (steps - COARSEST))
    return Fineness(steps, math.log(CUT / (error - spacing)) / REACH, error)


def amplification(fabric: AxialFabric, hypothesis: Hypothesis) -> float:
    """By how much the error of averages may grow on the way to a component.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branches about axis 3 [-].
    hypothesis : Hypothesis
        Kinematic or static.

    Returns
    -------
    float
        The factor [-]. Kinematic: 1, as components are sums of averages with positive factors, and 4 with free spin, a
        quotient of three of them. Static: 6, as an entry of the inverse of a diagonally dominant M-matrix errs by 5
        times as much as the averages to first order, and 8 for spheroids, whose balance of forces is averaged too.
        Times ``RANK_FOUR_FACTOR`` where terms of the density cancel.

    Notes
    -----
    Accuracy: a bound for errors up to 0.01. Source: Alfa, Xue and Ye (2002), entrywise perturbation of diagonally
    dominant M-matrices.
    """
    cancelling = RANK_FOUR_FACTOR if fabric.density_coefficients()[1] < 0 else 1.0
    if hypothesis is Hypothesis.STATIC:
        return cancelling * (6 if fabric.collinear else 8)
    return cancelling * (4 if fabric.free_spin else 1)
