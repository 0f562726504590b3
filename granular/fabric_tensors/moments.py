"""Sums over directions: the moments of rank four, and those of rank eight that tell how much they scatter."""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.errors import NotFinite, TooFewDirections, ValueOutOfRange
from granular.fabric_tensors.components import QUADRUPLE_TIMES, QUADRUPLES, quadruple_products
from granular.fabric_tensors.reading import read_directions, read_weights

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from granular.fabric_tensors.tensors import FabricTensors

    Array = NDArray[np.float64]

ROWS = 8192
"""Directions taken at a time: their products stay in cache."""

SMALLEST = 1e-290
"""Sums of squared weights below this lose digits [unit of the weights, squared]."""

WHOLE = tuple(times if four[0] == four[1] and four[2] == four[3] else 0.0
              for four, times in zip(QUADRUPLES, (t / (3 if t == 6 else 1) for t in QUADRUPLE_TIMES), strict=True))
"""Contraction of n_i n_j n_k n_l with delta_ij delta_kl, which is 1 for a unit vector."""


class Moments:
    """Weighted sums over a list of directions of any length; the memory does not grow with the list.

    Add block after block, merge the sums of several files or processes, then ask for the tensors.

    Notes
    -----
    Accuracy: sums of positive blocks of 8192; another order of the same blocks changes the last digits only.
    Source: the covariance of a mean of products of rank four is made of moments of rank eight.

    Examples
    --------
    >>> one, other = Moments(), Moments()
    >>> one.add([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    >>> other.add([[0.0, 0.0, 1.0]])
    >>> one.merge(other).count
    3
    """

    __slots__ = ("_fourth", "_second", "_squares", "_sum", "count")

    def __init__(self) -> None:
        """Begin with no direction."""
        import numpy as np

        self.count = 0
        """Number of directions [-]."""
        self._sum = 0.0
        self._squares = 0.0
        self._fourth = np.zeros(15)
        self._second = np.zeros((15, 15))

    def add(self, directions: ArrayLike, weights: ArrayLike | None = None, *, normalise: bool = False) -> None:
        """Add a block of directions.

        Parameters
        ----------
        directions : (n, 3) array
            Unit vectors [-]; n and -n are the same.
        weights : (n,) array, optional
            Not negative [any unit, the same in all blocks].
        normalise : bool
            Whether lengths may be other than 1.

        Raises
        ------
        ArrayNotUsable, NotFinite, DirectionNotUnit, ValueOutOfRange
            As for :func:`granular.fabric_tensors.fabric_of`; nothing of the block is added then.
        """
        import numpy as np

        unit = read_directions(directions, normalise=normalise, first=self.count)
        by_weight = read_weights(weights, len(unit), first=self.count)
        for start in range(0, len(unit), ROWS):
            products = quadruple_products(unit[start:start + ROWS])
            weight = by_weight[start:start + ROWS]
            weighted = weight[:, None] * products
            with np.errstate(over="ignore", invalid="ignore"):  # refused when the mean is asked for
                self._sum += float(weight.sum())
                self._squares += float(weight @ weight)
                self._fourth += weighted.sum(axis=0)
                self._second += weighted.T @ weighted
        self.count += len(unit)

    def merge(self, other: Moments) -> Moments:
        """Sums over both lists; neither is changed.

        Parameters
        ----------
        other : Moments
            Sums over other directions.

        Returns
        -------
        Moments
            Sums over all.
        """
        both = Moments()
        both.count = self.count + other.count
        both._sum = self._sum + other._sum
        both._squares = self._squares + other._squares
        both._fourth = self._fourth + other._fourth
        both._second = self._second + other._second
        return both

    @property
    def effective_number(self) -> float:
        """Number of equally weighted directions that scatter as much, (sum w)^2/sum w^2 [-]."""
        return self._sum * (self._sum / self._squares) if self._squares > 0 else 0.0

    def mean(self) -> Array:
        """Moments N_ijkl.

        Returns
        -------
        (15,) array
            In the order of ``components.QUADRUPLES`` [-].

        Raises
        ------
        TooFewDirections
            There is none.
        ValueOutOfRange
            The weights are zero, or so small that their squares lose digits.
        NotFinite
            The weights, or their squares, sum to more than double precision holds.
        """
        if self.count == 0:
            raise TooFewDirections("0 directions", allowed="needed: at least 1", remedy="Add directions first.")
        if self._squares < SMALLEST:
            raise ValueOutOfRange(f"sum of the weights = {self._sum:g}, of their squares {self._squares:g}",
                                  allowed=f"allowed sums of squares >= {SMALLEST:g}",
                                  remedy="Give larger weights; their unit is free.")
        if not self._squares < float("inf"):
            raise NotFinite("sum of the squared weights = inf", allowed="allowed a finite sum",
                            remedy="Give weights in a larger unit, so that they are smaller.")
        mean: Array = self._fourth / self._sum
        return mean

    def covariance(self) -> Array:
        """Covariance of the moments N_ijkl, as independent directions have it.

        Returns
        -------
        (15, 15) array
            Without bias for equal weights [-]; for others the sum of w^2 (m - mean)(m - mean) over (sum w)^2. NaN when
            the effective number is 1.
        """
        import numpy as np

        mean, whole = self.mean(), np.array(WHOLE)
        first = self._second @ whole  # sum of w^2 m
        centred = (self._second - np.outer(first, mean) - np.outer(mean, first)
                   + (whole @ first) * np.outer(mean, mean))
        number = self.effective_number
        if number <= 1 + 1e-12:
            return np.full((15, 15), np.nan)
        covariance: Array = centred / self._sum**2 * (number / (number - 1))
        return covariance

    def fabric(self) -> FabricTensors:
        """Fabric tensors of all directions added so far.

        Returns
        -------
        FabricTensors
            Of three kinds.
        """
        from granular.fabric_tensors.tensors import FabricTensors

        return FabricTensors.of_moments(self.mean(), covariance=self.covariance(), count=self.count,
                                        effective_number=self.effective_number)
