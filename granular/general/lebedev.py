"""Integrals over the sphere by Lebedev rules of rising degree: for smooth integrands."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

DEGREES = (11, 15, 19, 23, 29, 35, 41, 47, 53, 59, 71, 83, 95, 107, 119, 131)
"""Degrees that are tried one after the other."""

POINTS = dict(zip(DEGREES, (50, 86, 146, 194, 302, 434, 590, 770, 974, 1202, 1730, 2354, 3074, 3890, 4802, 5810),
                  strict=True))
"""Directions of each rule [-]; half of them are evaluated."""

ALL_POINTS = sum(POINTS.values()) // 2
"""Directions of all of them [-]."""

SAFETY = 10.0
"""The difference between two degrees, times this, is the error that is stated: an estimate."""

FLOOR = 1e-14
"""Smallest error that is stated [-]: rounding of the rules and of the sums."""

Weights = Callable[["Array"], "tuple[Array, Array]"]
"""From directions (3, q) to what stands with n_i n_j n_k n_l and with n_i n_k, (q,) each."""

Assembly = Callable[["Array"], "Array"]
"""From the 15 and the 6 moments, one after the other, to the Mandel matrix of the stiffness."""


@dataclass(frozen=True, slots=True)
class Integral:
    """What a rule over the sphere found.

    Attributes
    ----------
    mandel : (6, 6) array
        Stiffness [-].
    error : float
        Estimated error of the worst entry over the largest one [-].
    evaluations : int
        Directions in which the integrand was evaluated, all told [-].
    """

    mandel: Array
    error: float
    evaluations: int


def monomials(directions: Array) -> Array:
    """The fifteen products of four components of each direction, and the six of two.

    Parameters
    ----------
    directions : (3, q) array
        Unit vectors [-].

    Returns
    -------
    (21, q) array
        Products in the order of ``components.FOURS`` and ``components.TWOS`` [-].

    Notes
    -----
    Source: symmetry of the moments.

    Examples
    --------
    >>> import numpy as np
    >>> monomials(np.array([[0.0], [0.6], [0.8]]))[-1].round(2).tolist()
    [0.64]
    """
    import numpy as np

    from granular.general.components import FOURS, TWOS

    two = {(i, k): directions[i] * directions[k] for i, k in TWOS}
    rows = [two[i, j] * two[k, m] for i, j, k, m in FOURS]
    found: Array = np.stack([*rows, *two.values()])
    return found


def integrated(weights: Weights, assembly: Assembly, *, rtol: float) -> Integral:
    """Average over the sphere until two rules agree.

    Parameters
    ----------
    weights : callable
        The integrand.
    assembly : callable
        From moments to the stiffness.
    rtol : float
        Wanted error of the worst entry over the largest one [-].

    Returns
    -------
    Integral
        The stiffness by the last rule, whether it reaches ``rtol`` or not.

    Notes
    -----
    Accuracy: ten times the difference of the last two degrees, an estimate. Source: Lebedev's rules by SciPy.
    """
    import numpy as np
    from scipy.integrate import lebedev_rule

    before, error, evaluations = None, math.inf, 0
    for degree in DEGREES:
        n, area = lebedev_rule(degree)
        half = n[:, _upper(n)]  # both weights are even
        share = area[_upper(n)] / (2 * math.pi)
        fourth, second = weights(half)
        products = monomials(half)
        mandel = assembly(np.concatenate([products[:15] @ (share * fourth), products[15:] @ (share * second)]))
        evaluations += half.shape[1]
        if before is not None:
            error = max(SAFETY * float(np.abs(mandel - before).max() / np.abs(mandel).max()), FLOOR)
            if error <= rtol:
                break
        before = mandel
    return Integral(mandel, error, evaluations)


def _upper(n: Array) -> NDArray[np.bool_]:
    """One of each two opposite directions."""
    chosen: NDArray[np.bool_] = (n[2] > 0) | ((n[2] == 0) & ((n[1] > 0) | ((n[1] == 0) & (n[0] > 0))))
    return chosen
