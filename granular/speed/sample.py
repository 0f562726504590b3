"""Random assemblies to be computed at once: every fabric, the stress ratios and frictions of soils."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

FRICTION = 0.21255656167002213
"""tan(12 deg) [-], that of the printed tables."""

POISSON = 0.21
"""Poisson's ratio of the printed tables [-]."""


@dataclass(frozen=True, slots=True)
class Sample:
    """Random assemblies.

    Attributes
    ----------
    D33, Dr33, stress_ratio, friction, poisson_ratio : (n,) array
        Contact normals in [-1, 2], branches in [-0.9, 1.9], stress ratio in [1/3, 3] and friction in [0.1, 1], these
        two uniform in their logarithm, Poisson's ratio of the grains in [0, 1/2] [-].
    """

    D33: Array
    Dr33: Array
    stress_ratio: Array
    friction: Array
    poisson_ratio: Array

    def first(self, count: int) -> Sample:
        """The first few of them."""
        return Sample(self.D33[:count], self.Dr33[:count], self.stress_ratio[:count], self.friction[:count],
                      self.poisson_ratio[:count])


def sample(size: int) -> Sample:
    """Draw assemblies, the same ones each time.

    Parameters
    ----------
    size : int
        How many [-].

    Returns
    -------
    Sample
        The assemblies.

    Notes
    -----
    Source: NumPy's default generator, seed 1999.

    Examples
    --------
    >>> float(sample(100).D33.min()) >= -1
    True
    """
    import numpy as np

    # a row for each assembly, so that few are the first of many
    D33, Dr33, stress_ratio, friction, poisson_ratio = np.random.default_rng(1999).random((size, 5)).T
    return Sample(3 * D33 - 1, 2.8 * Dr33 - 0.9, 3.0 ** (2 * stress_ratio - 1), 10.0 ** (friction - 1),
                  poisson_ratio / 2)
