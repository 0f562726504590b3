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

    from granular.batch.constant import KINEMATIC, STATIC
    from granular.batch.evaluation import evaluate_batch

    result = np.empty((D33.size, len(COMPONENTS)))
    kernel = KINEMATIC if hypothesis is Hypothesis.KINEMATIC else STATIC
    left = evaluate_batch(kernel, (D33, Dr33, nu), result)
    for start in range(0, left.size, BLOCK):
        here = left[start:start + BLOCK]
        result[here] = _by_gauss_rule(D33[here], Dr33[here], nu[here])
    return result


def _by_gauss_rule(D33: Array, Dr33: Array, nu: Array) -> Array:
    """Static components where branch lengths differ too much for a kernel."""
    import numpy as np

    from granular.generated.static_constant_array import stiffness_from_moments
    from granular.routes.axial_array import static_moments

    moments = static_moments(D33, Dr33)
    return np.stack(stiffness_from_moments(moments[0], moments[1], moments[2], D33, nu), axis=-1)


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
    if alike.any():
        result[alike] = with_equal_contacts(D33[alike], Dr33[alike], nu[alike], hypothesis)
    rest = ~alike
    if rest.any():
        result[rest] = components(D33[rest], Dr33[rest], stress_ratio[rest],
                                  None if friction is None else friction[rest], nu[rest], hypothesis=hypothesis)
    return result
