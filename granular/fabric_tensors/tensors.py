"""Fabric tensors of the first, second and third kind, of rank two and four, of a list of directions."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from granular.errors import TooFewDirections
from granular.fabric_tensors.components import different_4, full_2, full_4, lower_rank, second_kind, third_kind

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    Array = NDArray[np.float64]

LEAST_NUMBER = 16
"""Effective number of directions from which scatter is computed: the 14 free components need 15 to scatter at all."""


@dataclass(frozen=True, slots=True, eq=False)
class FabricTensors:
    """Fabric tensors of a list of directions, all symmetric in all indices.

    Attributes
    ----------
    N2, N4 : (3, 3) and (3, 3, 3, 3) array
        First kind: means of n_i n_j and n_i n_j n_k n_l [-]; N_ii = 1.
    F2, F4 : (3, 3) and (3, 3, 3, 3) array
        Second kind: 4 pi E nearest to F_ij n_i n_j, or to F_ijkl n_i n_j n_k n_l, in the mean square [-]; F_ii = 3.
    D2, D4 : (3, 3) and (3, 3, 3, 3) array
        Third kind: 4 pi E = 1 + D_ij n_i n_j + D_ijkl n_i n_j n_k n_l + ... [-]; traceless.
    count : int
        Number of directions [-].
    effective_number : float
        (sum w)^2/sum w^2 [-]; the number for equal weights.
    covariance : (15, 15) array
        Of N_ijkl, in the order 1111, 1112, 1113, 1122, ..., 3333 [-].
    """

    N2: Array
    N4: Array
    F2: Array
    F4: Array
    D2: Array
    D4: Array
    count: int
    effective_number: float
    covariance: Array

    @classmethod
    def of_moments(cls, moments: Array, *, covariance: Array, count: int, effective_number: float) -> FabricTensors:
        """Fabric tensors of the 15 components of N_ijkl [-] and of what is known of their scatter."""
        D2, D4 = third_kind(moments)
        F2, F4 = second_kind(moments)
        return cls(N2=full_2(lower_rank(moments)), N4=full_4(moments), F2=full_2(F2), F4=full_4(F4), D2=full_2(D2),
                   D4=full_4(D4), count=count, effective_number=effective_number, covariance=covariance)

    @property
    def moments(self) -> Array:
        """The 15 different components of N_ijkl [-]."""
        return different_4(self.N4)

    def require(self, number: float = LEAST_NUMBER) -> None:
        """Refuse when there are too few directions for a statement on their scatter.

        Parameters
        ----------
        number : float
            Least effective number [-].

        Raises
        ------
        TooFewDirections
            The effective number is smaller.
        """
        if not number <= self.effective_number < float("inf"):
            raise TooFewDirections(
                f"{self.count} directions with the effective number {self.effective_number:.6g}",
                allowed=f"needed: an effective number of {number:g} or more",
                remedy="Take more directions, or weights that differ less; the tensors themselves need no number.")


def fabric_of(directions: ArrayLike, weights: ArrayLike | None = None, *, normalise: bool = False) -> FabricTensors:
    """Fabric tensors of a list of directions.

    Parameters
    ----------
    directions : (n, 3) array
        Unit vectors, one a row [-]; n and -n are the same, so that a contact is given once or twice at will.
    weights : (n,) array, optional
        How much each counts, not negative [any unit].
    normalise : bool
        Whether lengths may be other than 1, as those of branch vectors are. Every direction then counts by its weight,
        whatever its length.

    Returns
    -------
    FabricTensors
        Of three kinds, with the number of directions and the covariance of the moments.

    Raises
    ------
    ArrayNotUsable
        No real numbers, or shapes other than (n, 3) and (n,).
    NotFinite
        A component or weight is NaN or infinite.
    DirectionNotUnit
        A length is off 1 by more than 1e-6, or zero.
    ValueOutOfRange
        A negative weight, or weights that sum to zero.
    TooFewDirections
        There is none.

    Notes
    -----
    Accuracy: moments to a few units in the last place; 315/8 times that for rank four of the third kind.
    Source: Kanatani's definitions, derived in ``derivations.fabric_kinds``.

    Examples
    --------
    >>> tensors = fabric_of([[0.0, 0.0, 1.0]])
    >>> tensors.D2.diagonal().tolist(), tensors.D4[2, 2, 2, 2].item()
    ([-2.5, -2.5, 5.0], 9.0)
    """
    from granular.fabric_tensors.moments import Moments

    sums = Moments()
    sums.add(directions, weights, normalise=normalise)
    return sums.fabric()
