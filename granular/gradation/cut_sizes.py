"""Eq. (17) with lognormal grain sizes that end somewhere: r_m and r_M of eqs (10) to (16).

In units of the median size by number, with L = ln s_r, a length l and the ratio exp(w) of its two radii have the
density exp(-[(ln l - c(w))^2 + w^2/4]/L^2) with c(w) = ln(2 cosh(w/2)), up to a bound of w that the length sets.
"""

from __future__ import annotations

import math
from statistics import NormalDist
from typing import TYPE_CHECKING

from granular.fields import Number, chosen
from granular.gradation.lognormal import SPREAD
from granular.gradation.stiffness_numbers import Numbers, argument_that_gives, numbers_of

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

NODES, PANEL = 16, 0.7
"""Gauss nodes on a panel, and the widest panel in spreads [-]."""

CENTRES = {"number": 0.0, "printed": 2.0, "volume": 3.0}
"""How far a centre lies above the median by number, in units of L spreads [-]."""

_CUT = Number(at_least=0.01, at_most=40.0, why="no grain is farther out",
              remedy="Give the cut in geometric standard deviations.")
_SHARE = Number(above=0.0, at_most=0.49, remedy="Give the share of the volume that is left out at either end.")
_WANTED = Number(above=0.0)


def cut(spread: float, deviations: float, *, about: str = "number") -> Numbers:
    """Eq. (17) with grain sizes that end on either side of a centre.

    Parameters
    ----------
    spread : float
        Geometric standard deviation of grain sizes s_r [-], 1 < spread <= 10.
    deviations : float
        Distance of the smallest and the largest size from the centre, in geometric standard deviations [-], 0.01 to
        40: sizes reach from centre/spread^deviations to centre spread^deviations.
    about : str
        The centre: "number" for the median by number, "printed" for r_50 of eq. (18), which is the mode, "volume" for
        the median by volume.

    Returns
    -------
    Numbers
        Both numbers [-].

    Raises
    ------
    ValueOutOfRange
        A number is outside its interval.
    UnknownChoice
        Another centre.

    Notes
    -----
    Accuracy: 1e-12. Source: eqs (10)-(12), (16), (17) with r_m and r_M, by Gauss rules on panels of the bound of w.

    Examples
    --------
    >>> [round(cut(2.0, deviations).kinematic, 1) for deviations in (3, 4, 5, 6, 8)]
    [6.9, 10.6, 15.9, 22.0, 30.9]
    >>> [round(cut(spread, 6, about="printed").kinematic, 1) for spread in (1.2, 1.5, 2.0)]
    [4.4, 6.5, 29.0]
    """
    L, k = math.log(SPREAD.read(spread, "spread")), _CUT.read(deviations, "deviations")
    centre = CENTRES[chosen(about, tuple(CENTRES), name="about")] * L
    return _between(L, centre - k, centre + k)


def cut_by_volume(spread: float, share: float) -> Numbers:
    """Eq. (17) with grain sizes that end where a share of the volume is finer, and where as much is coarser.

    Parameters
    ----------
    spread : float
        Geometric standard deviation of grain sizes s_r [-], 1 < spread <= 10.
    share : float
        Volume fraction that is left out at either end [-], 0 < share <= 0.49.

    Returns
    -------
    Numbers
        Both numbers [-].

    Raises
    ------
    ValueOutOfRange
        An argument is outside its interval.

    Notes
    -----
    Accuracy: 1e-12. Source: as for :func:`cut`.

    Examples
    --------
    >>> [round(cut_by_volume(2.0, share).kinematic, 2) for share in (1e-2, 1e-3, 1e-6)]
    [11.77, 16.69, 26.72]
    """
    return cut(spread, -NormalDist().inv_cdf(_SHARE.read(share, "share")), about="volume")


def cut_that_gives(spread: float, kinematic: float, *, about: str = "number") -> float:
    """Cut of the sizes at which the kinematic number has a given value.

    Parameters
    ----------
    spread : float
        Geometric standard deviation of grain sizes s_r [-], 1 < spread <= 10.
    kinematic : float
        <l^2>/<r^3>^(2/3) [-].
    about : str
        The centre, as in :func:`cut`.

    Returns
    -------
    float
        Deviations as in :func:`cut` [-], 1 to 20; nan where none of them gives the value.

    Raises
    ------
    ValueOutOfRange, UnknownChoice
        As there.

    Notes
    -----
    Accuracy: 1e-10 as long as the number still rises with the cut. Source: bisection of :func:`cut`.

    Examples
    --------
    >>> [round(cut_that_gives(spread, value, about="printed"), 2) for spread, value in ((1.5, 6.50), (2.0, 29.0))]
    [6.0, 5.99]
    """
    wanted = _WANTED.read(kinematic, "kinematic")
    return argument_that_gives(wanted, lambda deviations: cut(spread, deviations, about=about).kinematic, 1.0, 20.0)


def _between(L: float, low: float, high: float) -> Numbers:
    """Eq. (17) of sizes from exp(L low) to exp(L high), by the bound of w as the variable.

    For lengths l up to the sum of the smallest and the largest radius, the smaller grain ends w at ln(l/r_m - 1), and
    beyond it the larger one at -ln(l/r_M - 1). Either bound, as the variable, makes the density analytic up to the
    ends of the range, but for the cube root where the bound is zero.
    """
    import numpy as np

    width = high - low
    panel = PANEL * min(1.0, 1.0 / L)
    first = min(panel, width)
    root, root_weights = _on_panels(0.0, first ** (1.0 / 3.0), 1)
    bound, measure = _on_panels(first, width, math.ceil((width - first) / panel))
    bound = np.concatenate([root**3, bound])
    measure = np.concatenate([3.0 * root * root * root_weights, measure])

    part, part_weights = _on_panels(0.0, 1.0, math.ceil(width / panel))
    t = bound[:, None] * part
    stretch = np.logaddexp(0.5 * L * t, -0.5 * L * t)

    def log_h(log_length: Array) -> Array:
        exponents = -(((log_length[:, None] - stretch) / L) ** 2) - 0.25 * t * t
        top = exponents.max(axis=1)
        found: Array = top + np.log(bound * (np.exp(exponents - top[:, None]) @ part_weights))
        return found

    short = L * low + np.logaddexp(0.0, L * bound)
    long = L * high + np.logaddexp(0.0, -L * bound)
    log_density = np.concatenate([(log_h(short) - short) / 3.0 + L * (low + bound),
                                  (log_h(long) - long) / 3.0 + L * (high - bound)])
    log_cube = 4.5 * L * L + math.log(_normal_between(low - 3.0 * L, high - 3.0 * L) / _normal_between(low, high))
    return numbers_of(log_density, np.concatenate([short, long]), np.concatenate([measure, measure]), log_cube)


def _on_panels(low: float, high: float, panels: int) -> tuple[Array, Array]:
    import numpy as np
    from numpy.polynomial.legendre import leggauss

    points, weights = leggauss(NODES)
    edges = np.linspace(low, high, panels + 1)
    half = 0.5 * np.diff(edges)[:, None]
    return (edges[:-1, None] + half * (1.0 + points)).ravel(), (half * weights).ravel()


def _normal_between(low: float, high: float) -> float:
    """Share of a standard normal distribution between two values, without a difference of two numbers near one."""
    if low > 0.0:
        low, high = -high, -low
    return 0.5 * (math.erfc(-high / math.sqrt(2.0)) - math.erfc(-low / math.sqrt(2.0)))
