"""Branch lengths of a measured gradation curve: Gauss rules on pieces on which everything is smooth.

In units of the smallest size, with x = ln r, the density of radii by number is a piecewise quadratic polynomial in x
times r^-4. Its self-convolution, eq. (16), is the integral over the smaller of the two radii, split where either radius
meets a point of the curve. As a function of length it has kinks at the sums of two points, and it starts and ends there
with whole powers, of which eq. (17) takes the cube root. The integrals over length are therefore split at the sums, and
each piece is mapped by a polynomial that is flat to third order at both ends, which turns thirds of powers into whole
ones. Pieces whose Gauss rules of two orders differ are halved. All terms are positive, so that nothing cancels.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

from granular.gradation.branch_lengths import BranchLengths, Moment
from granular.gradation.measured_curve import MeasuredCurve

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    Array = npt.NDArray[np.float64]

INNER_NODES = 10
"""Nodes on a piece of the convolution [-]."""

ORDERS = (10, 16)
"""Nodes of the two rules on a piece of length [-]; their difference is the error that is stated."""

WIDEST_PIECE = 0.7
"""Largest ratio of the ends of a piece, as a logarithm [-]: ten nodes are then exact to rounding."""

MOST_SUMS = 1300
"""With more sums of two points than this, pieces begin at some of them and halving finds the rest [-]."""

WANTED = 1e-12
"""Relative error at which halving ends [-]."""

MOST_PIECES = 6000
"""Pieces at which halving ends too [-]; what is then not settled shows in the error that is stated."""

NARROWEST_PIECE = 1e-9
"""Width of a piece over its length that is not halved [-]: rounding is all that differs inside."""

ROUNDING = 1e-14
"""What rounding adds to the error of a moment; 2e-15 is the most that was measured where no piece is narrow [-]."""

_CONTROL = (-2.0, 0.0, 2.0)


class _Nodes(NamedTuple):
    """Nodes and weights of eq. (17), not normalised, one row a piece, by one rule."""

    lengths: Array
    weights: Array

    def power(self, power: float) -> Array:
        """Integral of length^power over each piece [in units of the smallest size]."""
        found: Array = (self.weights * self.lengths**power).sum(axis=1)
        return found


@dataclass(frozen=True)
class CurveBranches(BranchLengths):
    """Branch lengths of a measured gradation curve.

    Attributes
    ----------
    sizes : MeasuredCurve
        Grain sizes.
    """

    sizes: MeasuredCurve

    @property
    def relative_error(self) -> float:
        """Bound of the relative error of both densities where they are above 1e-30 of their maximum [-]."""
        return WANTED

    @property
    def _unit(self) -> float:
        """Length in which the smallest radius is 1 [m]."""
        return 0.5 * self.sizes.sizes[0]

    def _total_density(self, length: float) -> float:
        return self._convolved(length) / (self._number_of_grains**2 * self._unit)

    def _density(self, length: float) -> float:
        whole, _ = self._integral(0.0)
        return math.cbrt(self._convolved(length)) / (whole * self._unit)

    def _convolved(self, length: float) -> float:
        import numpy as np

        scaled = length / self._unit
        if not 2.0 < scaled < 2.0 * self._radii[-1]:
            return 0.0
        return float(self._convolution(np.array([scaled]))[0])

    def _moment(self, power: float) -> Moment:
        (top, top_error), (bottom, bottom_error) = self._integral(power), self._integral(0.0)
        # where two points are close, rounding of their distance enters the density between them
        rounding = ROUNDING + 2.0**-53 / float((self._logarithms[1:] - self._logarithms[:-1]).min())
        return Moment(value=top / bottom * self._unit**power,
                      relative_error=top_error / top + bottom_error / bottom + rounding)

    def _integral(self, power: float) -> tuple[float, float]:
        """Integral of length^power times eq. (17), not normalised, and what two rules differ by."""
        coarse, fine = (rule.power(power) for rule in self._rules)
        return float(fine.sum()), float(abs(fine - coarse).sum())

    @cached_property
    def _logarithms(self) -> Array:
        import numpy as np

        return np.array(self.sizes.logarithms)

    @cached_property
    def _radii(self) -> Array:
        import numpy as np

        return np.exp(self._logarithms)

    @cached_property
    def _number_of_grains(self) -> float:
        """Integral of the density of radii that is convolved: grains per solid volume of one smallest grain [-]."""
        return (self.sizes.sizes[0] / self.sizes.equal_volume_diameter) ** 3

    @cached_property
    def _density_pieces(self) -> Array:
        """Coefficients (3, n - 1) of the density by volume over ln r, highest power first."""
        import numpy as np

        cubic, square, linear, _ = self.sizes.polynomials
        return np.stack([3.0 * cubic, 2.0 * square, linear])

    @cached_property
    def _knots(self) -> Array:
        """Points of the curve in ln r, with more where they are far apart."""
        return _divided(self._logarithms)

    def _convolution(self, lengths: Array) -> Array:
        """Integral of n(r) n(l - r) over r at each length, which lies between twice the least and largest radius."""
        import numpy as np
        from numpy.polynomial.legendre import leggauss

        nodes, weights = leggauss(INNER_NODES)
        row, middle, half = self._pieces_of(lengths)
        total = lengths[row]
        own, other = self._piece_at(middle), self._piece_at(np.log(total - np.exp(middle)))
        grains = (self._density_pieces[:, own] != 0.0).any(axis=0) & (self._density_pieces[:, other] != 0.0).any(axis=0)
        row, own, other = row[grains], own[grains], other[grains]  # no grains of sizes inside a gap
        middle, half, total = middle[grains], half[grains], total[grains]
        x = middle[:, None] + half[:, None] * nodes
        r = np.exp(x)
        rest = total[:, None] - r
        by_volume = self._polynomial(own, x) * self._polynomial(other, np.log(rest))
        terms = by_volume / (r * r * r * (rest * rest) ** 2)
        found: Array = np.multiply(2.0, np.bincount(row, (terms @ weights) * half, minlength=len(lengths)))
        return found

    def _pieces_of(self, lengths: Array) -> tuple[npt.NDArray[np.intp], Array, Array]:
        """Row, middle and half width of the pieces over ln of the smaller radius, for all lengths in one list."""
        import numpy as np

        largest = self._radii[-1]
        top = np.log(0.5 * lengths)[:, None]
        bottom = np.log(np.maximum(lengths - largest, 1.0))[:, None]
        # where the larger radius meets a point of the curve; a point above the length is met nowhere
        met = np.log(np.maximum(lengths[:, None] - self._radii, 1.0))
        knots = np.broadcast_to(self._knots, (len(lengths), len(self._knots)))
        edges = np.concatenate([knots, met, top, bottom], axis=1)
        edges = np.sort(np.clip(edges, bottom, top), axis=1)
        widths = np.diff(edges, axis=1)
        place = np.nonzero(widths > 0.0)
        half = 0.5 * widths[place]
        return place[0], edges[:, :-1][place] + half, half

    def _piece_at(self, x: Array) -> npt.NDArray[np.intp]:
        import numpy as np

        return np.clip(np.searchsorted(self._logarithms, x, side="right") - 1, 0, len(self._logarithms) - 2)

    def _polynomial(self, piece: npt.NDArray[np.intp], x: Array) -> Array:
        import numpy as np

        u = x - self._logarithms[piece][:, None]
        square, linear, constant = self._density_pieces[:, piece, None]
        density: Array = np.maximum((square * u + linear) * u + constant, 0.0)
        return density

    @cached_property
    def _rules(self) -> tuple[_Nodes, _Nodes]:
        """Nodes by the coarse and the fine rule, on pieces on which the two agree."""
        import numpy as np

        edges = self._edges()
        left, right = edges[:-1], edges[1:]
        done: list[tuple[_Nodes, _Nodes]] = []
        settled, pieces = np.zeros(len(_CONTROL)), 0
        while len(left):
            pieces += len(left)
            coarse, fine = (self._nodes_on(left, right, order) for order in ORDERS)
            values = np.stack([fine.power(k) for k in _CONTROL])
            errors = abs(values - np.stack([coarse.power(k) for k in _CONTROL]))
            share = WANTED / max(50, len(edges)) * (settled + values.sum(axis=1))
            halve = (errors > share[:, None]).any(axis=0) & (right - left > NARROWEST_PIECE * right)
            if pieces > MOST_PIECES:
                halve[:] = False
            done.append((_Nodes(*(part[~halve] for part in coarse)), _Nodes(*(part[~halve] for part in fine))))
            settled += values[:, ~halve].sum(axis=1)
            middle = 0.5 * (left[halve] + right[halve])
            left, right = np.concatenate([left[halve], middle]), np.concatenate([middle, right[halve]])
        both = [_Nodes(*(np.concatenate(parts) for parts in zip(*rule, strict=True)))
                for rule in zip(*done, strict=True)]
        return both[0], both[1]

    def _edges(self) -> Array:
        """Ends of the pieces of length: sums of two points of the curve, with more where they are far apart."""
        import numpy as np

        r = self._radii
        all_sums = np.add.outer(r, r)[np.triu_indices(len(r))]
        sums = all_sums if len(all_sums) <= MOST_SUMS else np.concatenate([r[0] + r, r + r, r + r[-1]])
        sums = np.unique(sums)
        apart = np.concatenate([[True], np.diff(sums) > 1e-13 * sums[1:]])  # two sums that differ by rounding are one
        return np.exp(_divided(np.log(sums[apart])))

    def _nodes_on(self, left: Array, right: Array, order: int) -> _Nodes:
        import numpy as np
        from numpy.polynomial.legendre import leggauss

        points, weights = leggauss(order)
        t = 0.5 * (1.0 + points)
        width = (right - left)[:, None]
        lengths = left[:, None] + width * (t**3 * (10.0 - 15.0 * t + 6.0 * t * t))
        slope = 30.0 * (t * (1.0 - t)) ** 2
        blocks = np.array_split(lengths.ravel(), math.ceil(lengths.size / 256))  # of a size that stays in the cache
        density = np.cbrt(np.concatenate([self._convolution(block) for block in blocks])).reshape(lengths.shape)
        return _Nodes(lengths, density * width * slope * (0.5 * weights))


def _divided(edges: Array) -> Array:
    """Edges in a logarithm, with more between those that are farther apart than a piece may be wide."""
    import numpy as np

    parts = np.maximum(1.0, np.ceil(np.diff(edges) / WIDEST_PIECE)).astype(int)
    inner = [np.linspace(left, right, count, endpoint=False)
             for left, right, count in zip(edges[:-1], edges[1:], parts, strict=True)]
    return np.concatenate([*inner, edges[-1:]])
