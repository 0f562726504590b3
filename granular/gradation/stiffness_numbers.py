"""The two numbers by which gradation enters the stiffness, and what every way of computing them shares."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]


class Numbers(NamedTuple):
    """What gradation does to the stiffness of the same packing."""

    kinematic: float
    """<l^2>/<r^3>^(2/3) [-]; 4 for equal spheres."""
    static: float
    """4 <r^3>^(2/3) <l^-2> [-]; 1 for equal spheres."""


ONE_LENGTH = Numbers(4.0, 1.0)
"""All branches of the length 2 <r^3>^(1/3), that of the grains of mean volume: exactly what equal spheres have."""


def numbers_of(log_density: Array, log_length: Array, weights: Array, log_cube: float) -> Numbers:
    """Both numbers from a density of lengths at the nodes of a rule.

    Parameters
    ----------
    log_density, log_length : (n,) array
        Logarithms of the density, of any norm, times the derivative of the length, and of the length [-].
    weights : (n,) array
        Of the rule [-].
    log_cube : float
        Logarithm of <r^3> in the same unit of length [-].

    Returns
    -------
    Numbers
        Both numbers [-].

    Notes
    -----
    Accuracy: that of the rule, and 1e-16 times the largest logarithm. Source: eqs (7) and (11).

    Examples
    --------
    >>> import numpy as np
    >>> two, one = np.log([2.0]), np.zeros(1)
    >>> [round(number, 12) for number in numbers_of(one, two, one + 1, 0.0)]
    [4.0, 1.0]
    """
    import numpy as np

    def moment(power: float) -> float:
        exponent = log_density + power * log_length
        return float(exponent.max() + np.log(np.exp(exponent - exponent.max()) @ weights))

    whole, cube = moment(0.0), 2.0 / 3.0 * log_cube
    return Numbers(math.exp(moment(2.0) - whole - cube), 4.0 * math.exp(moment(-2.0) - whole + cube))


def argument_that_gives(wanted: float, function: Callable[[float], float], low: float, high: float) -> float:
    """Find where a function that rises on the way from one argument to another has a value.

    Parameters
    ----------
    wanted : float
        The value [any unit].
    function : callable
        Of one float.
    low, high : float
        Where it is least and where it is largest [any unit]; ``high`` may be the smaller one of the two.

    Returns
    -------
    float
        The argument [same unit]; nan where the function has the value nowhere between.

    Notes
    -----
    Accuracy: 1e-11. Source: bisection.

    Examples
    --------
    >>> round(argument_that_gives(0.25, lambda x: 1 / x, 8.0, 1.0), 9)
    4.0
    """
    if not function(low) <= wanted <= function(high):
        return math.nan
    while abs(high - low) > 1e-11 * abs(high):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if function(middle) < wanted else (low, middle)
    return 0.5 * (low + high)
