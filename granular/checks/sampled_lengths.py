"""Branch lengths drawn from grain sizes by volume, through eqs (12), (16) and (17) as they stand."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.random import Generator
    from numpy.typing import NDArray

    from granular.gradation import SizeDistribution

    Array = NDArray[np.float64]

RADII, RATIOS, LENGTHS = 4000, 501, 1000
"""Points of the tables: radii, ratios of two radii in the convolution, lengths."""

NEGLIGIBLE = 1e-120
"""Radii whose share is less than this of the largest are left out; eq. (17) takes a cube root [-]."""


@dataclass(frozen=True, slots=True)
class LengthTable:
    """Branch lengths of graded spheres along any one direction.

    Attributes
    ----------
    mean_cube : float
        <r^3> by number of grains [m^3].
    log_length : (n,) array
        Natural logarithm of the length over a metre, in equal steps [-].
    share : (n,) array
        l g(l) there, with the sum 1 over the steps [-].
    """

    mean_cube: float
    log_length: Array
    share: Array

    def draw(self, rng: Generator, count: int, *, leaning: float) -> tuple[Array, Array]:
        """Draw lengths more often by the power ``leaning`` of the length; [m], and weights that make good for it [-].

        Lengths spread so widely that those which count most would hardly be drawn.
        """
        import numpy as np

        power = np.exp(leaning * (self.log_length - self.log_length.mean()))
        leaned = self.share * power
        steps = (leaned[1:] + leaned[:-1]) / 2
        whole = steps.sum() / ((self.share[1:] + self.share[:-1]) / 2).sum()
        heaped = np.concatenate([[0.0], np.cumsum(steps)])
        found = np.interp(rng.random(count) * heaped[-1], heaped, self.log_length)
        return np.exp(found), whole * np.exp(-leaning * (found - self.log_length.mean()))


def length_table(sizes: SizeDistribution) -> LengthTable:
    """Tabulate the branch lengths of grain sizes.

    Parameters
    ----------
    sizes : SizeDistribution
        Grain sizes; only their density by volume is used.

    Returns
    -------
    LengthTable
        Mean cube of the radius, and lengths.

    Notes
    -----
    Accuracy: 1e-4, which a sample of a million contacts does not see. Source: eqs (12), (16) and (17), by equal steps
    in logarithms of radii, of their ratio, and of lengths.

    Examples
    --------
    >>> from granular.gradation import Lognormal
    >>> table = length_table(Lognormal("2 mm", 1.5, form="classical"))
    >>> round(table.mean_cube * 1e9, 4)  # exp(-9/2 ln^2 1.5)
    0.4772
    """
    import numpy as np

    log_radius, by_volume = _densities(sizes)
    by_number = by_volume * np.exp(-3 * log_radius)  # eq. (12), not yet normalised
    whole = _sum(by_number * np.exp(log_radius))
    mean_cube = _sum(by_volume * np.exp(log_radius)) / whole
    with np.errstate(divide="ignore"):
        log_density = np.log(by_number / whole)
    first, last = log_radius[[0, -1]]
    log_length = np.linspace(first, last, LENGTHS) + np.log(2.0)
    length = np.exp(log_length)[:, None]
    ratio = np.linspace(first - last, last - first, RATIOS)
    one, other = length / (1 + np.exp(-ratio)), length / (1 + np.exp(ratio))
    density = np.exp(sum(np.interp(np.log(r), log_radius, log_density, left=-np.inf, right=-np.inf)
                         for r in (one, other)))
    total = (density * one * other / length).sum(axis=1)  # eq. (16): dr = r (l - r)/l d(ratio)
    share = np.cbrt(total) * np.exp(log_length)  # eq. (17), times l
    return LengthTable(float(mean_cube), log_length, share / share.sum())


def _densities(sizes: SizeDistribution) -> tuple[Array, Array]:
    """Logarithms of radii in equal steps, and the density of eq. (13) by volume there, in any unit."""
    import numpy as np

    middle = np.log(sizes.D50 / 2)
    wide = np.linspace(middle - 27.0, middle + 27.0, RADII)
    seen = sizes.density_by_volume(2 * np.exp(wide)) * np.exp(-2 * wide)
    kept = np.flatnonzero(seen > NEGLIGIBLE * seen.max())
    step = wide[1] - wide[0]
    log_radius = np.linspace(wide[kept[0]] - step, wide[kept[-1]] + step, RADII)
    return log_radius, np.asarray(sizes.density_by_volume(2 * np.exp(log_radius)), dtype=float)


def _sum(values: Array) -> float:
    """A sum over equal steps of a logarithm; the steps cancel in quotients."""
    return float(values.sum())
