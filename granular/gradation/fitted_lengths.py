"""What eq. (19) neglects: a lognormal density of branch lengths in place of the cube root of a self-convolution.

The sum of two lognormal radii is not lognormal. Eq. (19) is met by a lognormal density with the same first two moments,
of which the cube root is lognormal again.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from granular.gradation.lognormal import Lognormal

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    Array = NDArray[np.float64]

WIDTH = 6.0
"""Densities are compared so many standard deviations of ln l on either side of the mode of eq. (19) [-]."""

POINTS = 201
"""Lengths at which they are compared before the place of the largest difference is refined."""


@dataclass(frozen=True, slots=True)
class Neglected:
    """Eq. (19) against eq. (17), for lognormal sizes.

    Attributes
    ----------
    spread : float
        Geometric standard deviation of grain sizes s_r [-].
    spread_of_lengths : float
        s_l of eq. (19) [-].
    largest_difference : float
        Largest distance of the two densities of ln l, over the largest value of the true one [-].
    at : float
        Length at which it is, over the mode of eq. (19) [-].
    mean, mean_square, inverse_square : float
        <l>, <l^2> and <l^-2> by eq. (19) over those by eq. (17) [-].
    third_of_all : float
        <l^3> of all branches, before the cube root, by the lognormal density that has their first two moments, over the
        true one [-]: 1/(1 + tanh^3(ln(s_r)^2/2)).
    """

    spread: float
    spread_of_lengths: float
    largest_difference: float
    at: float
    mean: float
    mean_square: float
    inverse_square: float
    third_of_all: float


def fitted_density(sizes: Lognormal, length: ArrayLike) -> Array:
    """Density of branch lengths along any one direction by eq. (19).

    Parameters
    ----------
    sizes : Lognormal
        Grain sizes.
    length : float or (...) array
        Branch length [m], > 0.

    Returns
    -------
    (...) array
        g [1/m].

    Notes
    -----
    Accuracy: 1e-14. Source: eq. (19), with s_l and l_50 from ``derivations.gradation``.

    Examples
    --------
    >>> sizes = Lognormal(0.005, 1.5)
    >>> [round(float(density), 1) for density in fitted_density(sizes, [0.004, 0.005])]
    [192.7, 153.2]
    """
    import numpy as np

    mode, variance = _parameters(sizes)
    x = np.log(np.asarray(length, dtype=float) / mode)
    density: Array = np.exp(-x * x / (2.0 * variance) - 0.5 * variance) / (mode * math.sqrt(2.0 * math.pi * variance))
    return density


def neglected(spread: float) -> Neglected:
    """Compare eq. (19) with eq. (17).

    Parameters
    ----------
    spread : float
        Geometric standard deviation of grain sizes s_r [-], 1 < spread <= 10.

    Returns
    -------
    Neglected
        The largest difference of the densities, and ratios of moments.

    Raises
    ------
    ValueOutOfRange
        The spread is outside its interval.

    Notes
    -----
    Accuracy: 1e-12 (moments), 1e-12 of the largest density (largest difference). Source: eqs (16), (17), (19).

    Examples
    --------
    >>> found = neglected(1.5)
    >>> round(found.largest_difference, 4), round(found.mean_square, 4)
    (0.0095, 0.9494)
    """
    import numpy as np
    from scipy.optimize import minimize_scalar

    from granular.gradation.branch_lengths import branch_lengths

    sizes = Lognormal(1.0, spread)
    lengths = branch_lengths(sizes)
    mode, variance = _parameters(sizes)
    deviation = math.sqrt(variance)

    def true(x: float) -> float:
        length = mode * math.exp(x)
        return float(length * lengths.density(length))

    def apart(x: float) -> float:
        length = mode * math.exp(x)
        return abs(float(length * fitted_density(sizes, length)) - true(x))

    def largest(function: Callable[[float], float], start: int) -> tuple[float, float]:
        step = grid[1] - grid[0]
        found = minimize_scalar(lambda x: -function(x), bounds=(grid[start] - step, grid[start] + step),
                                method="bounded", options={"xatol": 1e-6 * step})
        return float(found.x), -float(found.fun)

    # a density of ln l is highest where eq. (19) has its median, one variance above the mode
    grid = np.linspace(variance - WIDTH * deviation, variance + WIDTH * deviation, POINTS)
    highest = largest(true, int(np.argmax([true(x) for x in grid])))[1]
    place, difference = largest(apart, int(np.argmax([apart(x) for x in grid])))
    first, second, inverse = (mode**k * math.exp(variance * k * (k + 2) / 2) / lengths.moment(k).value
                              for k in (1.0, 2.0, -2.0))
    return Neglected(spread=spread, spread_of_lengths=math.exp(deviation), largest_difference=difference / highest,
                     at=math.exp(place), mean=first, mean_square=second, inverse_square=inverse,
                     third_of_all=1.0 / (1.0 + math.tanh(sizes.log_spread**2 / 2.0) ** 3))


def _parameters(sizes: Lognormal) -> tuple[float, float]:
    """l_50 of eq. (19), which is its mode, and the variance of ln l."""
    from granular.generated.gradation import branch_parameters

    square = sizes.log_spread**2
    variance, over_mode = branch_parameters(square)
    mode_of_radius = 0.5 * sizes.median_by_volume * math.exp(-square)
    return over_mode * mode_of_radius, variance
