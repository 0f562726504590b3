"""Elements that no kernel serves, for any fabric, stress and friction: each by the rule that its singularities need."""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.hypothesis import Hypothesis
from granular.routes.result import COMPONENTS

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

RELATIVE_ERROR = 2.0**-49
"""Bound of every component that is not subnormal [-]; the worst met in the tests is about half."""

BLOCK = 8192
"""Elements evaluated at a time, so that the dozen intermediate arrays stay in cache."""

LARGEST_RATIO = 9.0
"""Branch lengths at pole and equator up to this factor apart take the emitted static moments."""


def with_equal_contacts(D33: Array, Dr33: Array, nu: Array, hypothesis: Hypothesis) -> Array:
    """Contacts that are all equally stiff.

    Parameters
    ----------
    D33, Dr33, nu : (n,) array
        Admissible P2 coefficients and Poisson's ratio [-].
    hypothesis : Hypothesis
        Kinematic or static.

    Returns
    -------
    (n, 6) array
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n [-].

    Notes
    -----
    Accuracy: ``RELATIVE_ERROR``. Source: eqs (4), (7), and Figure 1(b).
    """
    import numpy as np

    result = np.empty((D33.size, len(COMPONENTS)))
    if hypothesis is Hypothesis.KINEMATIC:
        from granular.batch.constant import KINEMATIC
        from granular.batch.evaluation import evaluate_batch

        evaluate_batch(KINEMATIC, (D33, Dr33, nu), result)
        return result
    for start in range(0, D33.size, BLOCK):
        here = slice(start, start + BLOCK)
        for column, values in enumerate(_static(D33[here], Dr33[here], nu[here])):
            result[here, column] = values
    return result


def _static(D33: Array, Dr33: Array, nu: Array) -> tuple[Array, ...]:
    """Each element by exactly one way of computing its moments: the emitted series, or the axial Gauss rule."""
    import numpy as np

    from granular.generated import static_constant_array as emitted
    from granular.routes.axial_array import static_moments

    moments = np.empty((3, *D33.shape))
    pole, equator = 2 * (1 + Dr33), 2 - Dr33
    near = (pole <= LARGEST_RATIO * equator) & (equator <= LARGEST_RATIO * pole)
    if near.any():
        moments[:, near] = emitted.static_moments(D33[near], np.zeros(()), Dr33[near])
    far = ~near
    if far.any():
        moments[:, far] = static_moments(D33[far], Dr33[far])
    return emitted.stiffness_from_moments(moments[0], moments[1], moments[2], D33, nu)


def with_forces(D33: Array, Dr33: Array, stress_ratio: Array, friction: Array | None, nu: Array,
                hypothesis: Hypothesis) -> Array:
    """Contacts whose stiffness follows their force.

    Parameters
    ----------
    D33, Dr33, stress_ratio, nu : (n,) array
        Admissible P2 coefficients, sigma33/sigma11 and Poisson's ratio [-].
    friction : (n,) array or None
        Friction between grains [-]; None for contacts that never slip.
    hypothesis : Hypothesis
        Kinematic, or static where no contact slides.

    Returns
    -------
    (n, 6) array
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n,ref [-].

    Notes
    -----
    Accuracy: ``RELATIVE_ERROR``. Source: eqs (4), (7), and Figure 1(b) with (20)-(23).
    """
    import numpy as np

    from granular.routes.axial_kinetic_array import components
    from granular.routes.slip_geometry_array import equal_forces

    alike = equal_forces(D33, stress_ratio)
    if friction is not None:
        alike &= friction > 0
    result = np.empty((D33.size, len(COMPONENTS)))
    result[alike] = with_equal_contacts(D33[alike], Dr33[alike], nu[alike], hypothesis)
    rest = ~alike
    if rest.any():
        result[rest] = components(D33[rest], Dr33[rest], stress_ratio[rest],
                                  None if friction is None else friction[rest], nu[rest], hypothesis=hypothesis)
    return result
