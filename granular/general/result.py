"""What every route of a scene without an axis returns: 21 constants, how good they are, and what they cost."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations_with_replacement
from typing import TYPE_CHECKING, Literal

from granular.notation import MANDEL_PAIRS, mandel_factor

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from granular.elasticity import Stiffness

    Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class GeneralStiffness:
    """A stiffness of an assembly without an axis.

    Attributes
    ----------
    rows : tuple of 6 tuples of 6 float
        Mandel matrix over (M/V) l_e^2 k_n,ref, order 11, 22, 33, 23, 13, 12 [-].
    relative_error : float
        Error of the worst component over the largest entry of the matrix [-].
    error_is : str
        "bound", or "estimate" where two rules were compared.
    evaluations : int
        Directions in which the integrand was evaluated [-]; 0 for a closed form.
    route : str
        What computed it; behind "axial" stands the axial route that was taken.
    axis : tuple of 3 float or None
        Axis of symmetry where the scene has one [-].
    """

    rows: tuple[tuple[float, ...], ...]
    relative_error: float
    error_is: Literal["bound", "estimate"]
    evaluations: int
    route: str
    axis: tuple[float, float, float] | None = None

    def mandel(self) -> Array:
        """Mandel matrix over (M/V) l_e^2 k_n,ref [-], (6, 6), a fresh array."""
        import numpy as np

        return np.array(self.rows)

    @property
    def components(self) -> dict[str, float]:
        """All 21 components by name, C1111 to C1212, over (M/V) l_e^2 k_n,ref [-]."""
        return {f"C{i}{j}{k}{m}": self.rows[row][column] / mandel_factor(row, column)
                for (row, (i, j)), (column, (k, m)) in combinations_with_replacement(enumerate(MANDEL_PAIRS), 2)}

    def stiffness(self, reference: float = 1.0) -> Stiffness:
        """The tensor times a reference stiffness, (M/V) l_e^2 k_n,ref [Pa]."""
        from granular.elasticity import Stiffness

        return Stiffness.from_mandel(self.rows).scaled(reference)


def rows_of(matrix: Array) -> tuple[tuple[float, ...], ...]:
    """An array as plain numbers.

    Parameters
    ----------
    matrix : (n, n) array
        Any matrix [any unit].

    Returns
    -------
    tuple of tuples of float
        Its rows [same unit], which can be compared and hashed.

    Notes
    -----
    Source: ``ndarray.tolist``.
    """
    return tuple(tuple(row) for row in matrix.tolist())
