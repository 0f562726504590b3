"""Averages over the sphere for any fabric and any stress: what is averaged, and by which of two rules."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

from granular.errors import ComplianceInfinite, RouteOutOfDomain
from granular.general.components import compliance_tensor, inverted, mandel_of, stiffness_tensor, symmetric_tensor
from granular.general.loading import contact_stiffness, most_mobilised
from granular.general.meridians import Integrand
from granular.hypothesis import Hypothesis
from granular.tensors import shown_direction

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from granular.general.fabric import GeneralFabric
    from granular.general.lebedev import Assembly, Integral, Weights
    from granular.general.loading import GeneralLoading

    Array = NDArray[np.float64]

FINEST, COARSEST = 1e-12, 1e-1
"""Wanted accuracies between these can be asked for [-]."""

REACHED = 9e-13
"""What the rules over the sphere promise at best [-]: 1e-12, less room for the step to pascals."""

WANTED = 1e-9
"""Accuracy aimed at when none is asked for [-]."""


@dataclass(frozen=True, slots=True)
class Average:
    """A mean over the contacts that makes a stiffness.

    Attributes
    ----------
    integrand : Integrand
        What decides where it is not smooth.
    weights : callable
        From directions to what is averaged.
    assembly : callable
        From moments to the Mandel matrix.
    """

    integrand: Integrand
    weights: Weights
    assembly: Assembly

    @property
    def smooth(self) -> bool:
        """Whether no contact slips or has opened."""
        import numpy as np

        forces = self.integrand.forces
        return not self.integrand.slips and (forces is None or float(np.linalg.eigvalsh(forces + forces.T)[0]) > 0)

    def by_lebedev(self, rtol: float) -> Integral:
        """By Lebedev rules of rising degree; refused where the average is not smooth."""
        from granular.general import lebedev

        if not self.smooth:
            raise out_of_domain("lebedev", "where no contact slips or has opened", "product")
        return lebedev.integrated(self.weights, self.assembly, rtol=rtol)

    def by_product(self, rtol: float) -> Integral:
        """By the product rule that is split at the edges of sliding and opening."""
        from granular.general import product

        return product.integrated(self.weights, self.assembly, self.integrand, rtol=rtol)


def average_of(fabric: GeneralFabric, *, poisson_ratio: float, hypothesis: Hypothesis,
               loading: GeneralLoading | None) -> Average:
    """Put together what is averaged.

    Parameters
    ----------
    fabric : GeneralFabric
        Contact normals and branch lengths [-].
    poisson_ratio : float
        Poisson's ratio of the grain material [-], 0 to 0.5.
    hypothesis : Hypothesis
        Kinematic or static.
    loading : GeneralLoading or None
        Stress and friction; None for contacts of equal stiffness.

    Returns
    -------
    Average
        The mean.

    Raises
    ------
    ComplianceInfinite
        Static hypothesis with contacts that slide or have opened.

    Notes
    -----
    Source: eqs (1)-(7), (20)-(23) and Figure 1(b).
    """
    import numpy as np

    static = hypothesis is Hypothesis.STATIC
    forces = None if loading is None else loading.force_tensor(fabric)
    friction = None if loading is None else loading.friction
    if static and forces is not None:
        require_finite_compliance(forces, friction)
    branches = np.array(fabric.Dr) if static and fabric.Dr is not None else None
    integrand = Integrand(forces, friction, branches)
    inverse = np.asarray(np.linalg.inv(fabric.tensor()), dtype=np.float64) if static else None
    return Average(integrand, partial(_weights, fabric, integrand, poisson_ratio, static), partial(_assembled, inverse))


def out_of_domain(route: str, allowed: str, instead: str) -> RouteOutOfDomain:
    """Refuse a route that does not serve a scene.

    Parameters
    ----------
    route, allowed, instead : str
        Its name, which scenes it serves, and the route to take.

    Returns
    -------
    RouteOutOfDomain
        The refusal.

    Notes
    -----
    Source: the error format of this package.
    """
    return RouteOutOfDomain(f"route = {route}", allowed=f"allowed only scenes {allowed}",
                            remedy=f"Use the route {instead}.")


def _weights(fabric: GeneralFabric, integrand: Integrand, poisson_ratio: float, static: bool,
             directions: Array) -> tuple[Array, Array]:
    """What stands with n_i n_j n_k n_l and with n_i n_k in the average over the contacts."""
    import numpy as np

    from granular.contact_law import one_minus_stiffness_ratio, stiffness_ratio

    density, length = fabric.relative_density(directions), fabric.branch_weight(directions)
    if integrand.forces is None:
        one = np.ones_like(density)
        normal, shear, apart = (one, stiffness_ratio(poisson_ratio) * one,
                                one_minus_stiffness_ratio(poisson_ratio) * one)
    else:
        normal, shear, apart = contact_stiffness(integrand.forces, integrand.friction, directions, poisson_ratio)
    if not static:
        weight = density * length**2
        return weight * apart, weight * shear
    weight = density / (length**2 * np.maximum(shear, 1e-300))
    return -weight * apart / np.maximum(normal, 1e-300), weight


def _assembled(inverse_fabric: Array | None, moments: Array) -> Array:
    """Mandel matrix of the stiffness from the 15 and the 6 moments."""
    fourth, second = symmetric_tensor(moments[:15], 4), symmetric_tensor(moments[15:], 2)
    if inverse_fabric is None:
        return mandel_of(stiffness_tensor(fourth, second))
    return inverted(compliance_tensor(fourth, second, inverse_fabric))


def require_finite_compliance(forces: Array, friction: float | None) -> None:
    """Refuse contacts that slide or have opened: they yield without limit to their share of the stress.

    Parameters
    ----------
    forces : (3, 3) array
        B of the contact forces [-].
    friction : float or None
        Friction coefficient [-]; None for contacts that never slip.

    Returns
    -------
    None

    Raises
    ------
    ComplianceInfinite
        Some contact slides or has opened.

    Notes
    -----
    Source: Figure 1(b): the compliance averages 1/k_r, and k_r = 0 there.
    """
    used, direction = most_mobilised(forces)
    limit = math.inf if friction is None else friction
    if used < math.inf and (limit == math.inf or (limit > 0 and 1 + used**2 <= (1 + limit**2) * (1 + 1e-13))):
        return
    where = shown_direction(direction.tolist())
    what = (f"have opened along n = {where}" if used == math.inf else
            f"slide along n = {where}, where the shear force is {used:.6g} times the normal force")
    raise ComplianceInfinite(
        f"hypothesis = static with contacts that {what}",
        allowed="allowed only where every contact sticks"
        + ("" if used == math.inf else f" (here friction = {friction!r})")
        + ": one that does not yields without limit to its share of the stress, so that the compliance is infinite",
        remedy='Leave the loading or the friction out, or use hypothesis = "kinematic".')
