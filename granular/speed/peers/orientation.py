"""Elasticipy: a stiffness turned into many directions, and the weighted mean of what comes of it."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, Any

from granular.speed.interleaved import Way
from granular.speed.sample import POISSON

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]


def average(degree: int, D33: float = 0.3) -> tuple[Way, Way]:
    """Kinematic stiffness of an assembly of equal spheres as a mean over directions.

    Parameters
    ----------
    degree : int
        Of the Lebedev rule whose directions and weights both take [-].
    D33 : float
        Contact normals [-].

    Returns
    -------
    ours, theirs : Way
        Both give a Mandel or Voigt matrix over (M/V) l_e^2 k_n [-].

    Raises
    ------
    ModuleNotFoundError
        Elasticipy is not installed.

    Notes
    -----
    Source: eq. (4) by directions; one contact along axis 3 has C3333 = k_n and C2323 = C1313 = k_r/4.
    """
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # what it loads speaks of parts that will go; that is its own matter
        from elasticipy.tensors.elasticity import StiffnessTensor
    from scipy.integrate import lebedev_rule
    from scipy.spatial.transform import Rotation

    from granular.contact_law import stiffness_ratio

    n, weight = lebedev_rule(degree)
    share = _share(n, weight, D33)
    contact = _one_contact(stiffness_ratio(POISSON))
    turns = Rotation.from_matrix(_frames(n))

    def theirs() -> object:
        turned = StiffnessTensor(contact, check_positive_definite=False) * turns
        return (turned.matrix() * share[:, None, None]).sum(axis=0)

    def error(call: Callable[[], Any], twice: float) -> float:
        from granular.array_stiffness import axial_stiffness

        c1111, c3333, _, c1133, c2323, _ = axial_stiffness(D33, 0.0, poisson_ratio=POISSON, kinetic=False).tolist()
        matrix = call()
        places = (((0, 0), c1111), ((2, 2), c3333), ((0, 2), c1133), ((3, 3), twice * c2323))
        return max(float(abs(matrix[place] / known - 1)) for place, known in places)

    ours = partial(by_sums, n, share)
    return (Way(name="this package, 21 sums", elements=n.shape[1], call=ours, error=partial(error, ours, 2.0)),
            Way(name="Elasticipy, rotate and average", elements=n.shape[1], call=theirs,
                error=partial(error, theirs, 1.0)))


def by_sums(n: Array, share: Array) -> Array:
    """The same by the fifteen and six moments of the directions.

    Parameters
    ----------
    n : (3, q) array
        Directions [-].
    share : (q,) array
        Share of the contacts in each [-].

    Returns
    -------
    (6, 6) array
        Mandel matrix over (M/V) l_e^2 k_n [-].

    Notes
    -----
    Source: eq. (4).

    Examples
    --------
    >>> import numpy as np
    >>> round(float(by_sums(np.array([[0.0], [0.0], [1.0]]), np.ones(1))[2, 2]), 12)
    1.0
    """
    from granular.contact_law import one_minus_stiffness_ratio, stiffness_ratio
    from granular.general.components import mandel_of, stiffness_tensor, symmetric_tensor
    from granular.general.lebedev import monomials

    moments = monomials(n) @ share
    return mandel_of(stiffness_tensor(one_minus_stiffness_ratio(POISSON) * symmetric_tensor(moments[:15], 4),
                                      stiffness_ratio(POISSON) * symmetric_tensor(moments[15:], 2)))


def _share(n: Array, weight: Array, D33: float) -> Array:
    import numpy as np

    share: Array = weight * (1 + D33 * (3 * n[2] ** 2 - 1) / 2) / (4 * np.pi)
    return share


def _one_contact(ratio: float) -> Array:
    import numpy as np

    return np.diag([0.0, 0.0, 1.0, ratio / 4, ratio / 4, 0.0])


def _frames(n: Array) -> Array:
    """A rotation for each direction that takes axis 3 there, (q, 3, 3)."""
    import numpy as np

    least = np.eye(3)[np.abs(n).argmin(axis=0)].T
    first = np.cross(least, n, axis=0)
    first /= np.linalg.norm(first, axis=0)
    frames: Array = np.stack([first, np.cross(n, first, axis=0), n], axis=1).transpose(2, 0, 1)
    return frames
