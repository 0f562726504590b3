"""Any stress on an assembly without an axis, and the contact forces that it puts on the contacts."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING

from granular.errors import StressNotCompressive, ValueOutOfRange
from granular.general.result import rows_of
from granular.tensors import SymmetricTensor, Tensor

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from granular.general.fabric import GeneralFabric

    Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class GeneralLoading:
    """A stress that need not share its axes with the fabric, and the friction between grains.

    Parameters
    ----------
    stress : (3, 3) array
        Symmetric stress tensor up to a positive factor [-] or [Pa], compression positive, with a positive mean.
    friction : float, optional
        Friction coefficient mu between grains [-], >= 0; none for contacts that never slip.

    Raises
    ------
    TensorUnusable
        The stress is not symmetric.
    StressNotCompressive
        The mean stress is not positive.
    ValueOutOfRange
        The friction is negative or not finite.

    Notes
    -----
    Source: eqs (20)-(23).

    Examples
    --------
    >>> from granular.general.fabric import GeneralFabric
    >>> GeneralLoading([[2.0, 0, 0], [0, 2.0, 0], [0, 0, 2.0]]).force_tensor(GeneralFabric()).round(12).tolist()
    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
    """

    stress: Tensor
    friction: float | None = None

    def __post_init__(self) -> None:
        """Read the tensor and check what a route relies on."""
        (a, b, c), (d, e, f), (g, h, i) = SymmetricTensor().read(self.stress, "stress")
        b, c, f = (b + d) / 2, (c + g) / 2, (f + h) / 2
        object.__setattr__(self, "stress", ((a, b, c), (b, e, f), (c, f, i)))
        if not self.mean > 0:
            raise StressNotCompressive(f"stress with the mean {self.mean!r}",
                                       allowed="allowed a mean above 0 (compression is positive)",
                                       remedy="Give a stress whose compression outweighs its tension.")
        if self.friction is not None and not (math.isfinite(self.friction) and self.friction >= 0):
            raise ValueOutOfRange(f"friction = {self.friction!r}", allowed="allowed 0 <= friction < inf",
                                  remedy="Give a coefficient in that range, or none for contacts that never slip.")

    @property
    def mean(self) -> float:
        """Mean stress [as given], compression positive."""
        return math.fsum((self.stress[0][0] / 3, self.stress[1][1] / 3, self.stress[2][2] / 3))

    def force_tensor(self, fabric: GeneralFabric) -> Array:
        """B of the estimated contact force: f = B n over that of the isotropic assembly, for W = 1.

        Parameters
        ----------
        fabric : GeneralFabric
            Contact normals [-].

        Returns
        -------
        (3, 3) array
            B_jk = sigma_pj A_pk/(3 p) [-] with A = N^-1; not symmetric unless stress and fabric share their axes.

        Notes
        -----
        Accuracy: 1e-15. Source: eq. (23); D_ijkl does not enter.
        """
        import numpy as np

        shape = np.array(self.stress) / self.mean
        forces: Array = np.linalg.solve(fabric.tensor(), shape).T / 3
        return forces


def contact_stiffness(forces: Array, friction: float | None, directions: Array,
                      poisson_ratio: float) -> tuple[Array, Array, Array]:
    """Contact stiffnesses in every direction from the estimated force.

    Parameters
    ----------
    forces : (3, 3) array
        B of :meth:`GeneralLoading.force_tensor` [-].
    friction : float or None
        Friction coefficient [-]; None for contacts that never slip.
    directions : (3, q) array
        Unit vectors [-].
    poisson_ratio : float
        Poisson's ratio of the grain material [-], 0 to 0.5.

    Returns
    -------
    normal, shear, apart : (q,) array
        k_n, k_r and k_n - k_r over k_n,ref [-]; zero where the contact has opened, k_r = 0 where it slides.

    Notes
    -----
    Accuracy: a few units in the last place, apart from the edge of sliding, where k_r is a cube root of a difference.
    Source: eqs (20), (21) and (23). k_n does not depend on the branch length.

    Examples
    --------
    >>> import numpy as np
    >>> normal, shear, _ = contact_stiffness(np.eye(3), 0.3, np.eye(3), 0.0)
    >>> normal.tolist(), shear.tolist()
    ([1.0, 1.0, 1.0], [1.0, 1.0, 1.0])
    """
    import numpy as np

    from granular.contact_law import one_minus_stiffness_ratio, stiffness_ratio

    force = forces @ directions
    pressing = (force * directions).sum(axis=0)
    normal = np.cbrt(np.maximum(pressing, 0.0))
    ratio = stiffness_ratio(poisson_ratio)
    if friction is None:
        return normal, ratio * normal, one_minus_stiffness_ratio(poisson_ratio) * normal
    if friction == 0:
        return normal, np.zeros_like(normal), normal
    aside = np.sqrt(((force - pressing * directions) ** 2).sum(axis=0))
    shear = ratio * np.cbrt(np.maximum(pressing - aside / friction, 0.0))
    return normal, shear, normal - shear


def most_mobilised(forces: Array) -> tuple[float, Array]:
    """Largest shear force over normal force, and the direction of it: contacts slide where friction is less.

    Parameters
    ----------
    forces : (3, 3) array
        B of :meth:`GeneralLoading.force_tensor` [-].

    Returns
    -------
    ratio : float
        Largest f_r/f_n over all directions [-]; infinite where contacts have opened.
    direction : (3,) array
        Where [-].

    Notes
    -----
    Accuracy: 1e-14 of 1 + ratio^2; the highest of 4000 directions are followed uphill. Source: eq. (23).

    Examples
    --------
    >>> import numpy as np
    >>> round(most_mobilised(np.diag([1.0, 1.0, 1.5]))[0], 12)  # (1.5 - 1)/(2 sqrt(1.5))
    0.204124145232
    """
    import numpy as np

    ratio, direction = _most_mobilised(rows_of(forces))
    return ratio, np.array(direction)


@lru_cache(maxsize=64)
def _most_mobilised(rows: tuple[tuple[float, ...], ...]) -> tuple[float, tuple[float, ...]]:
    """The same of plain numbers: a plan asks for it several times, and the search takes as long as a coarse rule."""
    import numpy as np
    from scipy.optimize import minimize

    from granular.general.fabric import spread_directions

    forces = np.array(rows)
    symmetric, squared = (forces + forces.T) / 2, forces.T @ forces
    values, vectors = np.linalg.eigh(symmetric)
    if values[0] <= 0:
        return math.inf, tuple(vectors[:, 0].tolist())

    def steepness(n: Array) -> tuple[float, Array]:
        """-\\|f\\|^2/f_n^2 for n of any length, and its gradient."""
        length, pressing, force = n @ n, n @ symmetric @ n, n @ squared @ n
        value = force * length / pressing**2
        slope = 2 * value * (squared @ n / force + n / length - 2 * symmetric @ n / pressing)
        return -float(value), -slope

    n = spread_directions(4000)
    height = ((squared @ n) * n).sum(axis=0) / ((symmetric @ n) * n).sum(axis=0) ** 2
    best = n[:, np.argsort(height)[-12:]].T
    found = [minimize(steepness, start, jac=True, method="BFGS", options={"gtol": 1e-10}) for start in best]
    top = min(found, key=lambda one: float(one.fun))
    return math.sqrt(max(-float(top.fun) - 1, 0.0)), tuple((top.x / np.linalg.norm(top.x)).tolist())
