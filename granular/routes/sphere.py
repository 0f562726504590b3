"""The stiffness by a cubature rule over the whole sphere, straight from the tensors of the paper.

Nothing of the axial algebra is used: directions are vectors, the fabric is a tensor, and the compliance is inverted
as a 6 x 6 matrix. Slow and independent, which is what it is for.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from granular.errors import RouteOutOfDomain
from granular.hypothesis import Hypothesis
from granular.routes.accuracy import require_accuracy
from granular.routes.direction_sums import (
    axial_components,
    axially_clean,
    contact_tensor,
    fourth_rank,
    mandel_matrix,
    spin_relaxed,
    symmetrised,
)
from granular.routes.result import RouteResult, Six
from granular.routes.sphere_bounds import DEGREES, WANTED, declared_error
from granular.spheroid import branch_vectors

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from granular.fabric import AxialFabric
    from granular.loading import Loading

    Array = NDArray[np.float64]

NAME = "sphere"

def evaluate(fabric: AxialFabric, *, poisson_ratio: float, hypothesis: Hypothesis,
             loading: Loading | None = None, rtol: float | None = None) -> RouteResult:
    """Six components over (M/V) l_e^2 k_n,ref by a Lebedev rule, of the lowest degree that is good enough.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branch lengths about axis 3 [-].
    poisson_ratio : float
        Poisson's ratio of the grain material [-], 0 <= nu <= 0.5.
    hypothesis : Hypothesis
        Kinematic (upper bound) or static (lower estimate).
    loading : Loading or None
        Stress and friction, for contacts whose stiffness follows their force; served where no contact slips or opens.
    rtol : float or None
        Relative accuracy wanted of every component [-]; None aims at ``WANTED``.

    Returns
    -------
    RouteResult
        Components [-], declared error, and the number of directions.

    Accuracy
    --------
    :func:`declared_error` of the degree that was chosen.

    Raises
    ------
    RouteOutOfDomain
        The highest degree, 131, is not enough, or ``rtol`` is below rounding.

    Source
    ------
    Eq. (1) with l_i = l n_i, and Figure 1(b) with eq. (23); C_ijkl minor-symmetrised.

    Examples
    --------
    >>> from granular.fabric import AxialFabric
    >>> evaluate(AxialFabric(D33=0.3), poisson_ratio=0.21, hypothesis=Hypothesis.KINEMATIC).evaluations
    50
    """
    wanted = WANTED if rtol is None else rtol
    errors = {degree: declared_error(fabric, hypothesis=hypothesis, degree=degree, loading=loading)
              for degree in DEGREES}
    degree = next((degree for degree, error in errors.items() if error <= wanted), DEGREES[-1])
    if math.isinf(errors[degree]) or (rtol is None and errors[degree] > WANTED):
        raise RouteOutOfDomain(
            f"route = sphere for {_branches(fabric)}" + ("" if loading is None else " with contact forces"),
            allowed=f"allowed integrands without slip for which a rule of degree {DEGREES[-1]} is good enough "
            f"({_likely(errors[degree])} here)",
            remedy="Use the route axial, which serves every scene.")
    require_accuracy(NAME, errors[degree], rtol)
    components = components_by_degree(fabric, poisson_ratio=poisson_ratio, hypothesis=hypothesis, degree=degree,
                                      loading=loading)
    return RouteResult(components, errors[degree], directions_of(degree))


def _branches(fabric: AxialFabric) -> str:
    return f"Dr33 = {fabric.Dr33!r}" if fabric.collinear else f"aspect_ratio = {fabric.aspect_ratio!r}"


def _likely(error: float) -> str:
    return "nothing is promised" if math.isinf(error) else f"its relative error may be {error:.2g}"


def components_by_degree(fabric: AxialFabric, *, poisson_ratio: float, hypothesis: Hypothesis,
                         degree: int, loading: Loading | None = None) -> Six:
    """Evaluate the six components by the Lebedev rule of a given degree, with no promise about its error.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branch lengths about axis 3 [-].
    poisson_ratio : float
        Poisson's ratio of the grain material [-], 0 <= nu <= 0.5.
    hypothesis : Hypothesis
        Kinematic or static.
    degree : int
        Degree of a Lebedev rule [-].
    loading : Loading or None
        Stress and friction; None for contacts of equal stiffness.

    Returns
    -------
    tuple of 6 float
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n,ref [-].

    Accuracy
    --------
    Of the rule; see :func:`declared_error`.

    Raises
    ------
    RouteOutOfDomain
        There is no Lebedev rule with positive weights of that degree.

    Source
    ------
    Eq. (1), and Figure 1(b) with eq. (23).
    """
    directions, area = _rule(degree)
    return components_by_cubature(fabric, poisson_ratio=poisson_ratio, hypothesis=hypothesis,
                                  directions=directions, weights=area / (4 * math.pi), loading=loading)


def directions_of(degree: int) -> int:
    """Count the directions of the Lebedev rule of a degree.

    Parameters
    ----------
    degree : int
        Degree of a Lebedev rule [-].

    Returns
    -------
    int
        Directions [-].

    Raises
    ------
    RouteOutOfDomain
        There is no Lebedev rule with positive weights of that degree.

    Examples
    --------
    >>> directions_of(131)
    5810
    """
    return int(_rule(degree)[1].size)


def _rule(degree: int) -> tuple[Array, Array]:
    """Directions and areas of the Lebedev rule of a degree, or a refusal that names the degrees there are."""
    from scipy.integrate import lebedev_rule

    if degree not in DEGREES:
        raise RouteOutOfDomain(f"degree = {degree!r}", allowed=f"allowed {', '.join(map(str, DEGREES))}",
                               remedy="Give the degree of a Lebedev rule with positive weights.")
    directions, area = lebedev_rule(degree)
    return directions, area


def components_by_cubature(fabric: AxialFabric, *, poisson_ratio: float, hypothesis: Hypothesis, directions: Array,
                           weights: Array, loading: Loading | None = None) -> Six:
    """Evaluate the six components as a weighted sum over given directions.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branch lengths about axis 3 [-].
    poisson_ratio : float
        Poisson's ratio of the grain material [-], 0 <= nu <= 0.5.
    hypothesis : Hypothesis
        Kinematic or static.
    directions : (3, n) array
        Unit vectors [-].
    weights : (n,) array
        Weights of the directions [-], with the sum 1.
    loading : Loading or None
        Stress and friction, for contacts whose stiffness follows their force, slip and opening included.

    Returns
    -------
    tuple of 6 float
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n,ref [-].

    Accuracy
    --------
    Of the rule.

    Source
    ------
    Eq. (1), and Figure 1(b) with eq. (23). The forces of spheroids under the static hypothesis balance the stress by
    the mean of n^l_i n_k over the contacts, n^l along the branch, in place of N_ik.
    """
    import numpy as np

    n = directions
    normals, branches = (np.diag([-value / 2, -value / 2, value]) for value in (fabric.D33, fabric.Dr33))
    squared = n[2] ** 2
    rank_four = fabric.D3333 * ((35 * squared - 30) * squared + 3) / 8
    density = weights * (1 + np.einsum("iq,ij,jq->q", n, normals, n) + rank_four)
    branch = n * (1 + np.einsum("iq,ij,jq->q", n, branches, n))
    if fabric.aspect_ratio != 1.0:
        branch = branch_vectors(fabric.aspect_ratio, n)
    normal, shear, apart = contact_stiffness(fabric, loading, n[2], poisson_ratio)
    if hypothesis is Hypothesis.KINEMATIC:
        spring = contact_tensor(n, apart, shear)
        raw = axially_clean(fourth_rank(density * branch[:, None] * branch[None, :], spring))
        return axial_components(mandel_matrix(spin_relaxed(raw) if fabric.free_spin else symmetrised(raw)))
    flexibility = contact_tensor(n, -apart / (normal * shear), 1 / shear)
    length = np.sqrt(np.sum(branch**2, axis=0))
    carried = np.linalg.inv((density / length * branch) @ n.T).T @ n / length
    raw = axially_clean(fourth_rank(density * carried[:, None] * carried[None, :], flexibility))
    return axial_components(np.asarray(np.linalg.inv(mandel_matrix(symmetrised(raw))), dtype=np.float64))


def contact_stiffness(fabric: AxialFabric, loading: Loading | None, cosine: Array,
                       poisson_ratio: float) -> tuple[Array, Array, Array]:
    """Contact stiffnesses in every direction.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals about axis 3 [-].
    loading : Loading or None
        Stress and friction; None for contacts of equal stiffness.
    cosine : (n,) array
        Cosine of the angle from axis 3 [-].
    poisson_ratio : float
        Poisson's ratio of the grain material [-], 0 <= nu <= 0.5.

    Returns
    -------
    normal, shear, apart : (n,) array
        k_n, k_r and k_n - k_r over k_n,ref [-].

    Accuracy
    --------
    A few units in the last place; without slip nothing is subtracted.

    Source
    ------
    Eqs (20), (21) and (23).
    """
    import numpy as np

    from granular.contact_distribution import normal_stiffness, shear_stiffness

    normal = np.ones_like(cosine) if loading is None else normal_stiffness(fabric, loading, cosine)
    if loading is None or not loading.slips(fabric.D33):
        share = poisson_ratio / (2 - poisson_ratio)
        return normal, 2 * (1 - poisson_ratio) / (2 - poisson_ratio) * normal, share * normal
    shear = shear_stiffness(fabric, loading, cosine, poisson_ratio=poisson_ratio)
    return normal, shear, normal - shear
