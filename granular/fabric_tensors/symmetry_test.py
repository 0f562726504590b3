"""One test of a symmetry: what is asked, the statistic, how often chance gives as much, and a verdict in words."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

USUAL_LEVEL = 0.05
"""Chance at which a verdict in words calls a departure significant [-]."""


@dataclass(frozen=True, slots=True)
class SymmetryTest:
    """Result of a test.

    Attributes
    ----------
    name : str
        Short name.
    holds, fails : str
        What may be said when the symmetry stands and when it falls.
    statistic : float
        Chi-squared, or its like [-].
    degrees_of_freedom : int
        Numbers that are zero when the symmetry holds [-].
    p : float
        Chance of a statistic as large under the symmetry [-].
    """

    name: str
    holds: str
    fails: str
    statistic: float
    degrees_of_freedom: int
    p: float

    def significant(self, level: float = USUAL_LEVEL) -> bool:
        """Whether chance gives as much in fewer than a share ``level`` of all lists."""
        return self.p < level

    @property
    def words(self) -> str:
        """Verdict at the usual level of 5 %."""
        chance = "p < 1e-12" if self.p < 1e-12 else f"p = {self.p:.2g}"
        return f"{self.fails if self.significant() else self.holds} ({chance})"


def chi_squared(statistic: float, degrees_of_freedom: int) -> float:
    """Chance of a value as large, for many directions.

    Parameters
    ----------
    statistic : float
        The value [-].
    degrees_of_freedom : int
        Of the distribution [-].

    Returns
    -------
    float
        Upper tail [-].

    Notes
    -----
    Accuracy: that of ``scipy.special``. Source: chi-squared distribution.

    Examples
    --------
    >>> round(chi_squared(11.0705, 5), 4)
    0.05
    """
    from scipy.special import chdtrc

    return float(chdtrc(degrees_of_freedom, statistic))


def squared_distance(departure: Array, covariance: Array, number: float) -> tuple[float, float]:
    """Squared distance of several numbers from zero in units of their own scatter, and the chance of as much.

    Parameters
    ----------
    departure : (m,) array
        Numbers that would be zero [-].
    covariance : (m, m) array
        Estimated from the same directions [-].
    number : float
        Effective number of directions, above m [-].

    Returns
    -------
    statistic, p : float
        Hotelling's T squared [-], and its upper tail by the F distribution [-].

    Notes
    -----
    Accuracy: exact for normal scatter; without the F distribution short lists would be called anisotropic too often.
    Numbers that do not scatter at all are zero by construction, or hopelessly off: p is 1 or 0.
    Source: Hotelling's test.

    Examples
    --------
    >>> import numpy as np
    >>> statistic, p = squared_distance(np.array([2.0]), np.array([[1.0]]), 1e9)
    >>> statistic, round(p, 4)
    (4.0, 0.0455)
    """
    import numpy as np
    from scipy.special import fdtrc

    size = len(departure)
    spread, frame = np.linalg.eigh(covariance)
    along = frame.T @ departure
    sound = spread > 1e-13 * max(float(spread[-1]), 1e-13)
    if np.any(np.abs(along[~sound]) > 1e-9):
        return float("inf"), 0.0
    statistic = float(np.sum(along[sound] ** 2 / spread[sound]))
    dof = int(np.sum(sound))
    if dof == 0:
        return 0.0, 1.0
    scaled = statistic * (number - dof) / (dof * (number - 1))
    return statistic, float(fdtrc(min(dof, size), number - dof, scaled))
