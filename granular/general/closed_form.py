"""Closed form for contacts of equal stiffness and any fabric, in exact fractions: one rounding of each component."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, Any

from granular.general.components import compliance_tensor, inverted, symmetric_tensor
from granular.general.fabric import GeneralFabric
from granular.hypothesis import Hypothesis
from granular.notation import MANDEL_PAIRS, mandel_factor
from granular.routes.rational import fractions_of
from granular.tensors import ZERO

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

RELATIVE_ERROR = 2 * 2.0**-52
"""Bound for every component, relative to itself [-]: rounding of the fraction, of sqrt(2) and of their product."""


def covers(fabric: GeneralFabric, hypothesis: Hypothesis) -> bool:
    """Tell whether there is a closed form for contacts of equal stiffness.

    Parameters
    ----------
    fabric : GeneralFabric
        Contact normals and branch lengths [-].
    hypothesis : Hypothesis
        Kinematic or static.

    Returns
    -------
    bool
        The static average of E/W^2 has none unless all branches have one length.

    Notes
    -----
    Source: a mean of a polynomial over the sphere is rational, that of a quotient is not.

    Examples
    --------
    >>> covers(GeneralFabric(), Hypothesis.STATIC)
    True
    """
    return hypothesis is Hypothesis.KINEMATIC or fabric.Dr is None or fabric.Dr == ZERO


def mandel_matrix(fabric: GeneralFabric, *, poisson_ratio: float, hypothesis: Hypothesis) -> Array:
    """Stiffness over (M/V) l_e^2 k_n of contacts of equal stiffness.

    Parameters
    ----------
    fabric : GeneralFabric
        Contact normals and branch lengths [-], exactly as given in floats.
    poisson_ratio : float
        Poisson's ratio of the grain material [-], 0 to 0.5.
    hypothesis : Hypothesis
        Kinematic, or static with branches of one length.

    Returns
    -------
    (6, 6) array
        Mandel matrix, order 11, 22, 33, 23, 13, 12 [-].

    Notes
    -----
    Accuracy: ``RELATIVE_ERROR``, a bound. Source: eqs (4), (6) and (7), and Figure 1(b) with (23);
    ``derivations.general_constant``.

    Examples
    --------
    >>> matrix = mandel_matrix(GeneralFabric(), poisson_ratio=0.0, hypothesis=Hypothesis.KINEMATIC)
    >>> matrix[0].tolist()
    [0.3333333333333333, 0.0, 0.0, 0.0, 0.0, 0.0]
    """
    import numpy as np

    from granular.generated.general_constant import stiffness_from_tensor_moments, tensor_moments

    moments = tensor_moments(*_arguments(fabric))
    nu = Fraction(poisson_ratio)
    if hypothesis is Hypothesis.KINEMATIC:
        values = iter(stiffness_from_tensor_moments(*fractions_of(*moments, nu)))
        matrix = np.empty((6, 6))
        for row in range(6):
            for column in range(row, 6):
                matrix[row, column] = matrix[column, row] = float(next(values)) * mandel_factor(row, column)
        return matrix
    ratio = 2 * (1 - nu) / (2 - nu)
    fourth = symmetric_tensor(moments, 4)
    second = np.trace(fourth, axis1=2, axis2=3)
    return inverted(compliance_tensor(fourth * (1 - 1 / ratio), second / ratio, _inverse_fabric(fabric)))


def _arguments(fabric: GeneralFabric) -> Any:
    """Components in the order of the emitted function."""
    from granular.general.components import FOURS

    pairs = [(i - 1, j - 1) for i, j in MANDEL_PAIRS]
    normals = [Fraction(fabric.D[i][j]) for i, j in pairs]
    fourth = [Fraction(0 if fabric.D4 is None else fabric.D4[i][j][k][m]) for i, j, k, m in FOURS]
    branches = [Fraction(0 if fabric.Dr is None else fabric.Dr[i][j]) for i, j in pairs]
    return [*normals, *fourth, *branches]


def _inverse_fabric(fabric: GeneralFabric) -> NDArray[np.object_]:
    """N^-1 in fractions, by cofactors."""
    import numpy as np

    n = [[Fraction(int(i == j), 3) + Fraction(2, 15) * Fraction(fabric.D[i][j]) for j in range(3)] for i in range(3)]
    cofactors = [[n[(i + 1) % 3][(j + 1) % 3] * n[(i + 2) % 3][(j + 2) % 3]
                  - n[(i + 1) % 3][(j + 2) % 3] * n[(i + 2) % 3][(j + 1) % 3] for j in range(3)] for i in range(3)]
    determinant = sum(n[0][j] * cofactors[0][j] for j in range(3))
    return np.array([[cofactors[j][i] / determinant for j in range(3)] for i in range(3)], dtype=object)
