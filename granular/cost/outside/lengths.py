"""What lognormal sizes do to the stiffness, from eqs (12), (16) and (17) as they stand, by any rule for integrals."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

LOWEST, HIGHEST = -18.0, 20.0
"""Lengths that matter reach so many log standard deviations below and above two medians [-]."""

SMALLEST = 1e-300
"""Radii that round to zero are moved here, where no grains are."""


def length_factor(spread: float, *, static: bool,
                  integral: Callable[[Callable[[Any], Sequence[Any]], int, Any, Any, Sequence[Any]], Sequence[Any]],
                  ) -> float:
    """<l^2>_g, or 1/<l^-2>_g under the static hypothesis, over the square of twice the radius of mean volume.

    Parameters
    ----------
    spread : float
        Geometric standard deviation of the sizes [-], > 1.
    static : bool
        Static hypothesis.
    integral : callable
        A rule between two ends, in doubles.

    Returns
    -------
    float
        The factor [-].

    Notes
    -----
    Accuracy: that of the rule, used within itself. Source: eqs (12), (16) and (17), radii over their median by number.
    """
    import numpy as np

    deviation, power = math.log(spread), -2 if static else 2

    def by_number(radius: Any) -> Any:
        if isinstance(radius, float):
            some = max(radius, SMALLEST)
            return math.exp(-(math.log(some) / deviation) ** 2 / 2) / some
        some = np.maximum(radius, SMALLEST)
        return np.exp(-(np.log(some) / deviation) ** 2 / 2) / some

    def all_lengths(length: float) -> float:
        half = length / 2
        pairs = integral(lambda u: [half * by_number(half * (1 + u)) * by_number(half * (1 - u))], 1, 0.0, 1.0, ())
        return float(pairs[0])

    def outer(z: Any) -> Sequence[Any]:
        if getattr(z, "ndim", 0):
            return list(np.array([outer(float(one)) for one in z]).T)
        length = 2 * math.exp(deviation * z)
        density = math.cbrt(all_lengths(length)) * length
        return [density, density * length**power]

    whole, moment = integral(outer, 2, LOWEST, HIGHEST, ())
    mean, equal = float(moment / whole), 4 * math.exp(3 * deviation**2)
    return 1 / (equal * mean) if static else mean / equal
