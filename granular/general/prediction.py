"""How many directions a rule over the sphere will take, told beforehand from the growth of the integrand.

On the ellipse with the sum of half-axes exp(r) that runs through the nearest singularity a function of f_n = n.B n, or
of W = 1 + n.Dr n, is followed by polynomials of degree d in n to about exp(-r d/2); the rules, which are exact for more
than their degree promises, to about exp(-0.6 r d). The factors before it are measured. All this says what an evaluation
will cost, and nothing about its error, which is found from the values themselves.
"""

from __future__ import annotations

import math
from itertools import pairwise
from typing import TYPE_CHECKING

from granular.general.lebedev import DEGREES, FLOOR, POINTS, SAFETY
from granular.general.loading import most_mobilised

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from granular.general.sphere import Average

    Array = NDArray[np.float64]

RATE = 0.6
"""Share of the growth that rules over the sphere gain with each degree [-]."""

SMOOTH, STICKING, SLIDING = 5e3, 17e3, 40e3
"""Directions that the product rule takes for each decimal digit of the wanted accuracy, where nothing slips, where
every contact sticks, and where some slide [-]: measured, true to a factor of about three."""


def directions_of_lebedev(average: Average, rtol: float) -> int | None:
    """Predict how many directions the Lebedev rules take.

    Parameters
    ----------
    average : Average
        What is averaged.
    rtol : float
        Wanted error of the worst entry over the largest one [-].

    Returns
    -------
    int or None
        Directions, all degrees together [-]; None where the last degree will not do, or some contact slips or opens.

    Notes
    -----
    Accuracy: within a degree or two. Source: see the head of this file.
    """
    if not average.smooth:
        return None
    spent = POINTS[DEGREES[0]] // 2
    for before, degree in pairwise(DEGREES):
        spent += POINTS[degree] // 2
        if max(SAFETY * _error(average, before), FLOOR) <= rtol:
            return spent
    return None


def directions_of_product(average: Average, rtol: float) -> int:
    """Predict how many directions the product rule takes.

    Parameters
    ----------
    average : Average
        What is averaged.
    rtol : float
        Wanted error of the worst entry over the largest one [-].

    Returns
    -------
    int
        Directions [-].

    Notes
    -----
    Accuracy: a factor of about three. Source: measurements on a few dozen scenes.
    """
    integrand, each = average.integrand, SMOOTH
    if integrand.slips:
        assert integrand.forces is not None
        assert integrand.friction is not None
        each = STICKING if most_mobilised(integrand.forces)[0] < integrand.friction else SLIDING
    return round(each * -math.log10(rtol))


def _error(average: Average, degree: int) -> float:
    """Error of one degree over the largest entry, about [-]."""
    import numpy as np

    forces, branches = average.integrand.forces, average.integrand.branches
    found = 0.0
    if forces is not None:
        r = _growth((forces + forces.T) / 2)
        found += 0.2 * min(r, 1.0) ** 2.5 * math.exp(-RATE * r * degree)
    if branches is not None:
        found += 8.0 * math.exp(-RATE * _growth(np.eye(3) + branches) * degree)
    return found


def _growth(tensor: Array) -> float:
    """Logarithm of the sum of half-axes of the ellipse on which the form of a positive tensor vanishes."""
    import numpy as np

    low, _, high = np.linalg.eigvalsh(tensor)
    return math.acosh((high + low) / (high - low)) if high > low else 50.0
