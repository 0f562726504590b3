"""Six components from what contacts do at some directions: what another rule, or another law, would give."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from granular import AxialFabric
from granular.contact_law import one_minus_stiffness_ratio, stiffness_ratio
from granular.generated.kinetic_components import stiffness_from_weights

Array = NDArray[np.float64]


def components(fabric: AxialFabric, poisson_ratio: float, *, directions: Sequence[tuple[float, float]] | Array,
               measure: Array, normal: Array, chi: Array, gamma: Array) -> tuple[float, ...]:
    """Average contacts over directions (squared sine, squared cosine) with a measure that integrates over the cosine.

    ``chi`` is the factor by which slip lowers the shear stiffness, ``gamma`` is 1 less that; both may be given apart
    so that nothing is subtracted.
    """
    s, y = np.asarray(directions).T
    second, fourth = y - s / 2, y * y - 3 * s * y + 3 * s * s / 8
    density = 1 + fabric.D33 * second + fabric.D3333 * fourth
    weight = measure * density * (1 + fabric.Dr33 * second) ** 2 * normal
    ratio, rest = stiffness_ratio(poisson_ratio), one_minus_stiffness_ratio(poisson_ratio)

    def moments(values: Array) -> list[float]:
        return [float((values * s ** (2 - k) * y**k).sum()) for k in range(3)]

    apart = moments(weight * (rest + ratio * gamma))[:2]
    return stiffness_from_weights(*moments(weight), *moments(ratio * weight * chi), *apart)


def gauss(nodes: int) -> tuple[Array, Array]:
    """Gauss nodes in the angle: squared sine and cosine of each, and the measure."""
    points, weights = np.polynomial.legendre.leggauss(nodes)
    angles = (points + 1) * np.pi / 4
    return np.stack([np.sin(angles) ** 2, np.cos(angles) ** 2], axis=1), weights * np.pi / 4 * np.sin(angles)
