"""Grain sizes by a measured gradation curve: monotone interpolation of the fraction finer in the logarithm of size."""

from __future__ import annotations

import bisect
import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import TYPE_CHECKING

from granular.errors import CurveIncomplete, CurveInPercent, CurveMalformed, CurveNotMonotone, ValueOutOfRange
from granular.gradation.size_distribution import SIZE, SizeDistribution
from granular.units import finite_number

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

MOST_PERCENT = 100.5
"""A curve that ends at this or less, and well above 1, is in percent [-]; reports round 100 %."""

LEAST_PERCENT = 1.5
"""A curve that ends at more than this is in percent [-]; less is a fraction with a mistake in it."""

CLOSEST = 1e-6
"""Two sizes that differ by less, relatively, are one: no sieve tells them apart, and rounding would [-]."""

WIDEST_RANGE = 1e12
"""Largest size over the smallest [-]: from a nanometre to a kilometre."""


@dataclass(frozen=True)
class MeasuredCurve(SizeDistribution):
    """Grain sizes by points of a gradation curve.

    Between the points the fraction finer is a piecewise cubic polynomial in the logarithm of size that rises where the
    points rise and is level where they are level (Fritsch and Butland 1984), so that the density of sizes is continuous
    and nowhere negative.

    Attributes
    ----------
    sizes : sequence of float
        Grain diameters of the points, in any order [m], > 0.
    fractions : sequence of float
        Volume fraction finer than each [-], from 0 to 1.

    Examples
    --------
    >>> curve = MeasuredCurve(["0.5 mm", "1 mm", "2 mm"], [0.0, 0.4, 1.0])
    >>> curve.fraction_finer(0.001), round(curve.D50, 6)
    (0.4, 0.001147)
    """

    sizes: tuple[float, ...]
    fractions: tuple[float, ...]

    def __init__(self, sizes: Sequence[float | str], fractions: Sequence[float]) -> None:
        """Read the points and refuse what is no gradation curve."""
        if len(sizes) != len(fractions):
            raise CurveMalformed(f"{len(sizes)} sizes with {len(fractions)} fractions",
                                 allowed="allowed one fraction for each size", remedy="Give them in pairs.")
        points = [(SIZE.read(size, f"sizes[{place}]"), finite_number(fraction, name=f"fractions[{place}]"))
                  for place, (size, fraction) in enumerate(zip(sizes, fractions, strict=True))]
        points = sound_points(points, [f"point {place}" for place in range(1, len(points) + 1)])
        object.__setattr__(self, "sizes", tuple(size for size, _ in points))
        object.__setattr__(self, "fractions", tuple(fraction for _, fraction in points))

    @cached_property
    def logarithms(self) -> tuple[float, ...]:
        """Natural logarithms of the sizes over the smallest one [-]."""
        return tuple(math.log(size / self.sizes[0]) for size in self.sizes)

    @cached_property
    def polynomials(self) -> npt.NDArray[np.float64]:
        """Coefficients (4, n - 1) [-] of the pieces of the fraction finer, highest power of the logarithm first."""
        import numpy as np
        from scipy.interpolate import PchipInterpolator

        found: npt.NDArray[np.float64] = PchipInterpolator(np.array(self.logarithms), np.array(self.fractions)).c
        return found

    @cached_property
    def _pieces(self) -> list[list[float]]:
        pieces: list[list[float]] = self.polynomials.T.tolist()
        return pieces

    @cached_property
    def _mean_inverse_cube(self) -> float:
        """Mean of (smallest size/size)^3 by volume [-]: of positive terms only, so that nothing cancels."""
        import numpy as np
        from numpy.polynomial.legendre import leggauss

        nodes, weights = leggauss(16)  # exact to rounding for exp(-3x) times a square on panels of half a unit
        total = 0.0
        for left, right, (a, b, c, _) in zip(self.logarithms, self.logarithms[1:], self._pieces, strict=False):
            edges = np.linspace(0.0, right - left, 1 + max(1, math.ceil((right - left) / 0.5)))
            half = 0.5 * np.diff(edges)[:, None]
            u = edges[:-1, None] + half * (1.0 + nodes)
            total += float((half * weights * ((3.0 * a * u + 2.0 * b) * u + c) * np.exp(-3.0 * (left + u))).sum())
        return total

    @property
    def equal_volume_diameter(self) -> float:
        """Diameter of the equal grains that are as many in as much solid, <d^3>^(1/3) by number [m]."""
        return float(self.sizes[0] * self._mean_inverse_cube ** (-1.0 / 3.0))

    def _piece_of(self, size: float) -> tuple[list[float], float]:
        place = min(bisect.bisect_right(self.sizes, size), len(self.sizes) - 1) - 1
        return self._pieces[place], math.log(size / self.sizes[place])

    def _fraction_finer(self, size: float) -> float:
        if size <= self.sizes[0] or size >= self.sizes[-1]:
            return 0.0 if size <= self.sizes[0] else 1.0
        (a, b, c, d), u = self._piece_of(size)
        return min(max(((a * u + b) * u + c) * u + d, 0.0), 1.0)

    def _density_by_volume(self, size: float) -> float:
        if not self.sizes[0] <= size <= self.sizes[-1]:
            return 0.0
        (a, b, c, _), u = self._piece_of(size)
        return max((3.0 * a * u + 2.0 * b) * u + c, 0.0) / size

    def _density_by_number(self, size: float) -> float:
        if size < self.sizes[0]:
            return 0.0
        return self._density_by_volume(size) * (self.sizes[0] / size) ** 3 / self._mean_inverse_cube

    def _size_at(self, fraction: float) -> float:
        if fraction in self.fractions:
            first = self.fractions.index(fraction)
            # nothing lies below the last point without grains
            return self.sizes[first if fraction > 0.0 else bisect.bisect_right(self.fractions, 0.0) - 1]
        place = bisect.bisect_left(self.fractions, fraction) - 1
        a, b, c, d = self._pieces[place]
        low, high = 0.0, self.logarithms[place + 1] - self.logarithms[place]
        while low < (middle := 0.5 * (low + high)) < high:
            if ((a * middle + b) * middle + c) * middle + d < fraction:
                low = middle
            else:
                high = middle
        return self.sizes[place] * math.exp(high)


def sound_points(points: list[tuple[float, float]], places: list[str]) -> list[tuple[float, float]]:
    """Sort the points of a gradation curve by size, and refuse them where they are no such curve.

    Parameters
    ----------
    points : list of tuple
        Size [m] and fraction finer [-] of each point.
    places : list of str
        What to call each point in a message, e.g. "line 3".

    Returns
    -------
    list of tuple
        The same points with sizes ascending.

    Raises
    ------
    CurveMalformed, CurveInPercent, CurveNotMonotone, CurveIncomplete, ValueOutOfRange
        Fewer than two points, percent, a fraction outside 0 to 1, one size twice, a fraction that falls, or ends
        other than 0 and 1.

    Notes
    -----
    Source: F(r) of eq. (13) is the integral of a density.

    Examples
    --------
    >>> sound_points([(0.002, 1.0), (0.001, 0.0)], ["line 1", "line 2"])
    [(0.001, 0.0), (0.002, 1.0)]
    """
    if len(points) < 2:
        raise CurveMalformed(f"{len(points) or 'no'} point{'' if len(points) == 1 else 's'}",
                             allowed="allowed two points or more", remedy="Add the sizes at which nothing and "
                             "everything is finer.")
    largest = max(fraction for _, fraction in points)
    if LEAST_PERCENT < largest <= MOST_PERCENT:
        raise CurveInPercent(f"the largest fraction finer is {largest!r}, as in a table of percentages",
                             allowed="allowed fractions from 0 to 1", remedy="Divide the second column by 100.")
    for (_, fraction), place in zip(points, places, strict=True):
        if not 0.0 <= fraction <= 1.0:
            raise ValueOutOfRange(f"the fraction finer of {place} is {fraction!r}",
                                  allowed="allowed 0 <= fraction <= 1", remedy="Correct it there.")
    ordered = sorted(zip(points, places, strict=True), key=lambda pair: pair[0][0])
    for ((below, less), first), ((size, more), second) in pairwise(ordered):
        if size - below <= CLOSEST * size:
            both = f"the same size {size!r} m" if below == size else f"the sizes {below!r} m and {size!r} m"
            raise CurveNotMonotone(f"{first} and {second} have {both}",
                                   allowed="allowed one fraction for each size, and sizes more than a millionth apart",
                                   remedy="Delete one of them.")
        if less > more:
            raise CurveNotMonotone(
                f"the fraction finer falls from {less!r} ({first}, {below!r} m) to {more!r} ({second}, {size!r} m)",
                allowed="allowed only a fraction that rises with size or stays",
                remedy="Correct one of the two rows, or exchange the columns if they hold the fraction coarser.")
    (start, _), (end, _) = ordered[0], ordered[-1]
    if end[0] > WIDEST_RANGE * start[0]:
        raise ValueOutOfRange(f"the sizes run from {start[0]!r} m to {end[0]!r} m",
                              allowed=f"allowed up to {WIDEST_RANGE:g} times the smallest",
                              remedy="Check the units of the sizes.")
    if start[1] != 0.0 or end[1] != 1.0:
        raise CurveIncomplete(f"the curve runs from {start[1]!r} at {start[0]!r} m to {end[1]!r} at {end[0]!r} m",
                              allowed="allowed only curves from 0 to 1",
                              remedy="Add the size of the smallest grains with 0 and of the largest with 1.")
    return [point for point, _ in ordered]
