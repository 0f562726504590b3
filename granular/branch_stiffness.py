"""The kinematic stiffness of branches that are any function of direction: eq. (6), by rules over the sphere."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from granular.errors import BranchesUnusable, RouteOutOfDomain
from granular.fabric import AxialFabric

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from granular.loading import Loading

    Array = NDArray[np.float64]

LADDER = (11, 17, 23, 29, 35, 41, 47, 53, 59, 65, 71, 77, 83, 89, 95, 101, 107, 113, 119, 125, 131)
"""Degrees of the Lebedev rules that are tried one after the other."""

SAFETY = 10.0
"""The difference between two degrees, times this, is the error that is stated: an estimate, no bound."""


@dataclass(frozen=True, slots=True)
class DirectionalStiffness:
    """A stiffness without assumed symmetry.

    Attributes
    ----------
    mandel : (6, 6) array
        Stiffness over (M/V) l_e^2 k_n,ref in Mandel notation, order 11, 22, 33, 23, 13, 12 [-].
    relative_error : float
        Estimated error of the worst component, relative to the largest [-].
    evaluations : int
        Directions of the rule that was used last [-].
    """

    mandel: Array
    relative_error: float
    evaluations: int


def stiffness_by_direction(branch_products: Callable[[Array], ArrayLike], *, fabric: AxialFabric | None = None,
                           poisson_ratio: float, loading: Loading | None = None, free_spin: bool = False,
                           rtol: float = 1e-9) -> DirectionalStiffness:
    """Average l_i k_jl l_k over the directions of the contact normals, for any branches.

    Parameters
    ----------
    branch_products : callable
        From normals (3, q) to <l_i l_k>/l_e^2, (3, 3, q) [-], the same for n and -n; ``granular.branch_products`` has
        what is usual.
    fabric : AxialFabric, optional
        Contact normals about axis 3; its own branches are not used. Isotropic by default.
    poisson_ratio : float
        Poisson's ratio of the grain material [-], 0 to 0.5.
    loading : Loading, optional
        Stress and friction, for contacts whose stiffness follows their force; the estimate of the force neglects the
        deviation, as eq. (22) does.
    free_spin : bool
        Each grain spins until it carries no net couple; otherwise grains turn with the mean deformation.
    rtol : float
        Wanted accuracy relative to the largest component [-], 1e-13 to 1e-1.

    Returns
    -------
    DirectionalStiffness
        Stiffness, estimated error and cost.

    Raises
    ------
    BranchesUnusable
        The function returns another shape, something not finite, or something that is not even.
    RouteOutOfDomain
        ``rtol`` is outside its range, or the highest degree does not reach it.

    Notes
    -----
    Accuracy: rules of rising degree until two agree; ten times their difference is stated. Smooth branches gain a
    factor for each degree; with sliding contacts nothing better than about 1e-3 is reached. Source: eqs (5) and (6).

    Examples
    --------
    >>> from granular.branch_products import spheroid_branches
    >>> found = stiffness_by_direction(spheroid_branches(0.9), poisson_ratio=0.21)
    >>> round(float(found.mandel[0, 0] / found.mandel[2, 2]), 4)
    1.3983
    """
    if not 1e-13 <= rtol <= 1e-1:
        raise RouteOutOfDomain(f"rtol = {rtol!r} by a rule over the sphere", allowed="allowed 1e-13 <= rtol <= 0.1",
                               remedy="Give a relative accuracy in that range.")
    axial = AxialFabric() if fabric is None else fabric
    before, error = None, math.inf
    for degree in LADDER:
        mandel, directions = _by_degree(branch_products, axial, poisson_ratio, loading, free_spin, degree)
        if before is not None:
            error = SAFETY * float(abs(mandel - before).max() / abs(mandel).max())
            if error <= rtol:
                return DirectionalStiffness(mandel, max(error, 1e-14), directions)
        before = mandel
    raise RouteOutOfDomain(f"rtol = {rtol!r} by a rule over the sphere",
                           allowed=f"allowed about {error:.1e} and more for this function of direction",
                           remedy="Ask for less, or give a smoother function.")


def _by_degree(branch_products: Callable[[Array], ArrayLike], fabric: AxialFabric, poisson_ratio: float,
               loading: Loading | None, free_spin: bool, degree: int) -> tuple[Array, int]:
    from scipy.integrate import lebedev_rule

    from granular.directions import relative_density
    from granular.routes.direction_sums import contact_tensor, fourth_rank, mandel_matrix, spin_relaxed, symmetrised
    from granular.routes.sphere import contact_stiffness

    n, area = lebedev_rule(degree)
    products = _checked(branch_products(n), branch_products(-n))
    density = area / (4 * math.pi) * relative_density(fabric, n[2])
    _, shear, apart = contact_stiffness(fabric, loading, n[2], poisson_ratio)
    raw = fourth_rank(density * products, contact_tensor(n, apart, shear))
    return mandel_matrix(spin_relaxed(raw) if free_spin else symmetrised(raw)), int(area.size)


def _checked(products: ArrayLike, reversed_products: ArrayLike) -> Array:
    import numpy as np

    found, other = np.asarray(products, dtype=float), np.asarray(reversed_products, dtype=float)
    if found.ndim != 3 or found.shape[:2] != (3, 3) or not np.all(np.isfinite(found)):
        raise BranchesUnusable(f"branch products with the shape {found.shape}",
                               allowed="allowed finite numbers (3, 3, q), for q directions",
                               remedy="Return <l_i l_k>/l_e^2 in every direction.")
    apart = float(np.abs(found - other).max())
    if not apart <= 1e-9 * float(np.abs(found).max()):
        raise BranchesUnusable(f"branch products that differ by {apart:.3g} between n and -n",
                               allowed="allowed the same for both: a contact has no preferred side",
                               remedy="Give an even function of direction.")
    return found
