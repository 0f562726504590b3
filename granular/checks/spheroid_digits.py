"""What the elementary form of spheroids leaves of a double: arc tangent and recurrence against ball arithmetic.

Every step of the recurrence divides by r^2 - 1, so that near the sphere the elementary form is an identity and no way
of computing. It is kept for showing that; nothing else calls it.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.spheroid import squared_equator

if TYPE_CHECKING:
    from granular.routes.result import Six


def by_arc_tangent(aspect_ratio: float, *, D33: float = 0.0, poisson_ratio: float = 0.21) -> Six:
    """Six components of aligned spheroids by the elementary form as it stands, in doubles.

    Parameters
    ----------
    aspect_ratio : float
        b/a with b along axis 3 [-], > 0.
    D33 : float
        P2 coefficient of the contact-normal density [-], -1 to 2.
    poisson_ratio : float
        Poisson's ratio of the grain material [-], 0 to 0.5.

    Returns
    -------
    tuple of 6 float
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n [-], for contacts of one stiffness between
        grains that turn with the mean deformation.

    Raises
    ------
    ZeroDivisionError
        The squared aspect ratio is 1 to rounding.

    Notes
    -----
    Accuracy: none is promised; near r = 1 the error grows like the second inverse power of \\|r - 1\\| for isotropic
    normals, and like the third for others, which need L_3. Source: the elementary form and its recurrence in
    ``derivations.spheroid_moments``.

    Examples
    --------
    >>> [round(value, 6) for value in by_arc_tangent(0.5)[:2]]
    [0.621827, 0.066399]
    """
    from granular.generated.spheroid import stiffness_from_moments

    squared = aspect_ratio**2
    e = squared - 1.0
    root = math.sqrt(abs(e))
    l0 = (math.atan(root) if e > 0 else math.atanh(root)) / root
    l1 = (1.0 - l0) / e
    l2 = (1.0 / 3.0 - l1) / e
    l3 = (1.0 / 5.0 - l2) / e
    p0 = (1.0 - D33 / 2) * l0 + (5 * D33 / 2 - 2.0) * l1 + (1.0 - 7 * D33 / 2) * l2 + 3 * D33 / 2 * l3
    p1 = (1.0 - D33 / 2) * l1 + (2 * D33 - 1.0) * l2 - 3 * D33 / 2 * l3
    p2 = (1.0 - D33 / 2) * l2 + 3 * D33 / 2 * l3
    size = float(squared_equator(aspect_ratio))
    c1111, c3333, c1122, c1133, c2323, c1212 = stiffness_from_moments(p0, p1, p2, squared, poisson_ratio)
    return size * c1111, size * c3333, size * c1122, size * c1133, size * c2323, size * c1212


def worst_error(components: Six, fabric: AxialFabric, *, poisson_ratio: float = 0.21,
                hypothesis: Hypothesis = Hypothesis.KINEMATIC) -> float:
    """Relative error of the worst of six components for contacts of one stiffness, against ball arithmetic.

    Parameters
    ----------
    components : tuple of 6 float
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n [-].
    fabric : AxialFabric
        Contact normals and branches [-].
    poisson_ratio : float
        Poisson's ratio of the grain material [-], above 0, so that no component is zero.
    hypothesis : Hypothesis
        Kinematic or static.

    Returns
    -------
    float
        The error [-].

    Raises
    ------
    CertifiedArithmeticMissing
        Ball arithmetic is not installed.

    Notes
    -----
    Accuracy: the certified values are the nearest doubles. Source: ``granular.routes.certified``.

    Examples
    --------
    >>> worst_error(by_arc_tangent(0.5), AxialFabric(aspect_ratio=0.5)) < 1e-13
    True
    """
    from granular.routes import certified

    known = certified.evaluate(fabric, poisson_ratio=poisson_ratio, hypothesis=hypothesis).components
    return max(abs(value / true - 1.0) for value, true in zip(components, known, strict=True))
