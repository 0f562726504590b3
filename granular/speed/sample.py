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
    D33, Dr33, stress_ratio, friction : (n,) array
        Contact normals in [-1, 2], branches in [-0.9, 1.9], stress ratio in [1/3, 3] and friction in [0.1, 1], the
        last two uniform in their logarithm [-].
    """

    D33: Array
    Dr33: Array
    stress_ratio: Array
    friction: Array

    def first(self, count: int) -> Sample:
        """The first few of them."""
        return Sample(self.D33[:count], self.Dr33[:count], self.stress_ratio[:count], self.friction[:count])


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

    rng = np.random.default_rng(1999)
    return Sample(rng.uniform(-1.0, 2.0, size), rng.uniform(-0.9, 1.9, size),
                  np.exp(rng.uniform(-np.log(3.0), np.log(3.0), size)),
                  np.exp(rng.uniform(np.log(0.1), 0.0, size)))
