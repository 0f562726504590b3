"""Lognormal grain sizes: eq. (18) as printed, and the classical density with the factor 1/size."""

from __future__ import annotations

import math
from dataclasses import dataclass

from granular.fields import Number, chosen
from granular.gradation.size_distribution import SIZE, SizeDistribution

WIDEST = 10.0
"""Largest spread that is served [-]: two thirds of the volume then span two decades of size."""

SPREAD = Number(
    above=1.0, at_most=WIDEST, why="grains of one size need no gradation",
    remedy="Leave the gradation out for grains of one size; beyond the bound branch lengths are not checked.")
"""Interval of a spread [-]."""

UNIFORMITY = Number(above=1.0, why="D60 is larger than D10", remedy="Leave the gradation out for grains of one size.")
"""Interval of a coefficient of uniformity [-]; the widest that is served follows from that of the spread."""


@dataclass(frozen=True)
class Lognormal(SizeDistribution):
    """Lognormal grain sizes by volume.

    Eq. (18) is a density in size without the factor 1/size of the classical lognormal density. Its constant makes it
    the classical one with the median ``median exp(ln(spread)^2)``, and what it prints as the median is its mode.

    Attributes
    ----------
    median : float
        Median size by volume of the classical form; the most frequent size of eq. (18) [m], > 0.
    spread : float
        Geometric standard deviation s_r [-], 1 < spread <= 10.
    form : str
        "paper" for eq. (18) as printed, "classical" for the density with 1/size.

    Examples
    --------
    >>> sand = Lognormal("5 mm", 1.5, form="classical")
    >>> round(sand.D50, 12), round(sand.uniformity, 3), round(Lognormal("5 mm", 1.5).D50, 6)
    (0.005, 1.863, 0.005893)
    >>> round(Lognormal.of_uniformity("5 mm", 1.8).spread, 3)
    1.467
    """

    median: float
    spread: float
    form: str = "paper"

    def __post_init__(self) -> None:
        """Read the quantities and refuse those that mean nothing."""
        object.__setattr__(self, "median", SIZE.read(self.median, "median"))
        object.__setattr__(self, "spread", SPREAD.read(self.spread, "spread"))
        object.__setattr__(self, "form", chosen(self.form, ("paper", "classical"), name="form"))

    @classmethod
    def of_uniformity(cls, median: float, uniformity: float, *, form: str = "paper") -> Lognormal:
        """Take the coefficient of uniformity C_u = D60/D10 [-], > 1, in place of the spread."""
        from statistics import NormalDist

        normal = NormalDist()
        wide = UNIFORMITY.read(uniformity, "uniformity")
        return cls(median, wide ** (1.0 / (normal.inv_cdf(0.6) - normal.inv_cdf(0.1))), form=form)

    @property
    def log_spread(self) -> float:
        """Standard deviation of the natural logarithm of size, ln s_r [-]."""
        return math.log(self.spread)

    @property
    def median_by_volume(self) -> float:
        """Size than which half of the volume is finer [m]."""
        return self.median * math.exp(self.log_spread**2) if self.form == "paper" else self.median

    @property
    def median_by_number(self) -> float:
        """Size than which half of the grains are finer [m]; the distribution by number has the same spread."""
        return self.median_by_volume * math.exp(-3.0 * self.log_spread**2)

    @property
    def equal_volume_diameter(self) -> float:
        """Diameter of the equal grains that are as many in as much solid, <d^3>^(1/3) by number [m]."""
        return self.median_by_volume * math.exp(-1.5 * self.log_spread**2)

    def _fraction_finer(self, size: float) -> float:
        if size == 0.0:
            return 0.0
        return 0.5 * math.erfc(-math.log(size / self.median_by_volume) / (self.log_spread * math.sqrt(2.0)))

    def _density_by_volume(self, size: float) -> float:
        return self._density(size, self.median_by_volume)

    def _density_by_number(self, size: float) -> float:
        return self._density(size, self.median_by_number)

    def _density(self, size: float, median: float) -> float:
        if size == 0.0:
            return 0.0
        z = math.log(size / median) / self.log_spread
        # exp takes 1/size too, so that a tiny size does not overflow before the density underflows
        return math.exp(-0.5 * z * z - math.log(size)) / (self.log_spread * math.sqrt(2.0 * math.pi))

    def _size_at(self, fraction: float) -> float:
        if fraction in (0.0, 1.0):
            return 0.0 if fraction == 0.0 else math.inf
        from statistics import NormalDist

        return self.median_by_volume * math.exp(self.log_spread * NormalDist().inv_cdf(fraction))
