"""The stiffness by a cubature rule over the whole sphere, straight from the tensors of the paper.

Nothing of the axial algebra is used: directions are vectors, the fabric is a tensor, and the compliance is inverted
as a 6 x 6 matrix. Slow and independent, which is what it is for.
"""

from __future__ import annotations

import math
from functools import lru_cache
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
from granular.routes.result import Promise, RouteResult, Six
from granular.routes.sphere_bounds import DEGREES, WANTED, declared_error
from granular.routes.work import Work
from granular.spheroid import branch_vectors

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from granular.fabric import AxialFabric
    from granular.loading import Loading

    Array = NDArray[np.float64]

NAME = "sphere"

FABRIC = Work(operations=37)
"""Of the density in one direction. A sum over products counts every factor beyond the first and every term."""

BRANCH, SPHEROID_BRANCH = Work(operations=31), Work(operations=17, functions=1)
"""Of the branch vector in one direction, along the normal and between spheroids."""

FORCE, SPHEROID_FORCE = Work(operations=27, functions=1), Work(operations=63, functions=7)
"""Of k_n from the force of one direction; spheroids compute their branch length anew."""

SUMS = {Hypothesis.KINEMATIC: Work(operations=2 + 30 + 12 + 162),
        Hypothesis.STATIC: Work(operations=2 + 33 + 5 + 22 + 21 + 12 + 162, functions=1)}
"""Of the rest in one direction: k_r and k_n - k_r, the contact tensor, the products of two vectors, and 81 sums.
Static besides: the length of the branch, N_ik, and the force that a stress puts on the contact."""


def promise(fabric: AxialFabric, hypothesis: Hypothesis, loading: Loading | None = None, *,
            rtol: float | None = None) -> Promise | None:
    """Say how well an evaluation would do and what it would take, without evaluating.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branch lengths about axis 3 [-].
    hypothesis : Hypothesis
        Kinematic or static.
    loading : Loading or None
        Stress and friction, for contacts whose stiffness follows their force.
    rtol : float or None
        Relative accuracy wanted of every component [-]; None aims at ``WANTED``.

    Returns
    -------
    Promise or None
        Bound for the worst of the six components, directions, operations and functions, for the lowest degree that is
        good enough, or for the highest where none is; None where nothing is promised.

    Notes
    -----
    Accuracy: a bound; the counts are exact for what grows with the number of directions. Left out are the 3 x 3 and
    6 x 6 algebra at the end, which does not. Source: :func:`declared_error`.

    Examples
    --------
    >>> from granular.fabric import AxialFabric
    >>> [promise(AxialFabric(Dr33=0.3), Hypothesis.STATIC, rtol=rtol).evaluations for rtol in (1e-3, 1e-12)]
    [110, 590]
    """
    degree, error = _suitable(fabric, hypothesis, loading, rtol)
    return _promise(fabric, hypothesis, loading, degree, error) if _is_good_enough(error, rtol) else None


def _suitable(fabric: AxialFabric, hypothesis: Hypothesis, loading: Loading | None,
              rtol: float | None) -> tuple[int, float]:
    """The lowest degree that is good enough, or the highest, and its error."""
    wanted, degree, error = WANTED if rtol is None else rtol, 0, math.inf
    for degree in DEGREES:
        error = declared_error(fabric, hypothesis=hypothesis, degree=degree, loading=loading)
        if error <= wanted:
            break
    return degree, error


def _is_good_enough(error: float, rtol: float | None) -> bool:
    """Whether something is promised: what is wanted is weighed later."""
    return error <= WANTED if rtol is None else not math.isinf(error)


def _promise(fabric: AxialFabric, hypothesis: Hypothesis, loading: Loading | None, degree: int,
             error: float) -> Promise:
    directions = directions_of(degree)
    return Promise(error, directions, _work_of_direction(fabric, hypothesis, loading) * directions)


def _work_of_direction(fabric: AxialFabric, hypothesis: Hypothesis, loading: Loading | None) -> Work:
    """What one direction takes where no contact slips."""
    branch, force = (BRANCH, FORCE) if fabric.aspect_ratio == 1.0 else (SPHEROID_BRANCH, SPHEROID_FORCE)
    return FABRIC + branch + SUMS[hypothesis] + (Work() if loading is None else force)


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
        Components [-], declared error, the number of directions, and what they took.

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
    degree, error = _suitable(fabric, hypothesis, loading, rtol)
    if not _is_good_enough(error, rtol):
        raise RouteOutOfDomain(
            f"route = sphere for {_branches(fabric)}" + ("" if loading is None else " with contact forces"),
            allowed=f"allowed integrands without slip for which a rule of degree {DEGREES[-1]} is good enough "
            f"({_likely(error)} here)",
            remedy="Use the route axial, which serves every scene.")
    require_accuracy(NAME, error, rtol)
    components = components_by_degree(fabric, poisson_ratio=poisson_ratio, hypothesis=hypothesis, degree=degree,
                                      loading=loading)
    return _promise(fabric, hypothesis, loading, degree, error).kept(components)


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
    directions, weights = _rule(degree)
    return components_by_cubature(fabric, poisson_ratio=poisson_ratio, hypothesis=hypothesis,
                                  directions=directions, weights=weights, loading=loading)


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


@lru_cache(maxsize=len(DEGREES))
def _rule(degree: int) -> tuple[Array, Array]:
    """Directions and weights of the Lebedev rule of a degree, or a refusal that names the degrees there are.

    A rule is made once in a process and kept.
    """
    from scipy.integrate import lebedev_rule

    if degree not in DEGREES:
        raise RouteOutOfDomain(f"degree = {degree!r}", allowed=f"allowed {', '.join(map(str, DEGREES))}",
                               remedy="Give the degree of a Lebedev rule with positive weights.")
    directions, area = lebedev_rule(degree)
    weights = area / (4 * math.pi)
    for kept in (directions, weights):
        kept.setflags(write=False)
    return directions, weights


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
    if fabric.aspect_ratio == 1.0:
        branch = n * (1 + np.einsum("iq,ij,jq->q", n, branches, n))
    else:
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
