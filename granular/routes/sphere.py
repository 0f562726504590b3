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
from granular.routes.result import RouteResult, Six

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from granular.fabric import AxialFabric
    from granular.loading import Loading

    Array = NDArray[np.float64]

NAME = "sphere"

DEGREES = (3, 5, 7, 9, 11, 15, 17, 19, 21, 23, 29, 31, 35, 41, 47, 53, 59, 65, 71, 77, 83, 89, 95, 101, 107, 113,
           119, 125, 131)
"""Degrees of the Lebedev rules whose weights are all positive, which the bound below needs (not 13, 25 and 27)."""

WANTED = 1e-12
"""Relative accuracy aimed at when none is asked for [-]: about twenty times the rounding of a few thousand terms."""

ROUNDING = 1.5e-14
"""Rounding of the sums and of the inverse [-], times the ratio of branch lengths when it is 1/W^2 that is averaged.
Worst over all degrees and some thousand random and boundary fabrics: 5e-15 (kinematic), 9e-15 (static)."""


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
            f"route = sphere for Dr33 = {fabric.Dr33!r}" + ("" if loading is None else " with contact forces"),
            allowed=f"allowed integrands without slip for which a rule of degree {DEGREES[-1]} is good enough "
            f"({_likely(errors[degree])} here)",
            remedy="Use the route axial, which serves every scene.")
    require_accuracy(NAME, errors[degree], rtol)
    components = components_by_degree(fabric, poisson_ratio=poisson_ratio, hypothesis=hypothesis, degree=degree,
                                      loading=loading)
    return RouteResult(components, errors[degree], directions_of(degree))


def _likely(error: float) -> str:
    return "nothing is promised" if math.isinf(error) else f"its relative error may be {error:.2g}"


def declared_error(fabric: AxialFabric, *, hypothesis: Hypothesis, degree: int,
                   loading: Loading | None = None) -> float:
    """Bound the error of a degree.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branch lengths about axis 3 [-].
    hypothesis : Hypothesis
        Kinematic or static.
    degree : int
        Degree of a rule with positive weights [-], one of ``DEGREES``.
    loading : Loading or None
        Stress and friction; None for contacts of equal stiffness.

    Returns
    -------
    float
        Bound for the worst component, relative to that component [-]; ``math.inf`` where nothing is promised.

    Accuracy
    --------
    A proved bound of the rule plus the measured rounding.

    Notes
    -----
    Kinematic: polynomials of the density's degree plus 8, which the rule integrates exactly, or nothing is
    promised. Static: let q be a polynomial with \\|q - 1/W^2\\| <= eta/W^2 everywhere such that the rule is exact
    for q times the rest. As rule and integral are positive, the average of anything positive over W^2 errs by at
    most 2 eta/(1 - eta) of itself. The shear compliances are such averages. The block of the normal directions is
    a diagonally dominant M-matrix whose row sums and off-diagonal entries are such averages, so that an entry of its
    inverse errs by 5 times as much to first order; 6 is used. The best q that is a combination of two
    Chebyshev polynomials is explicit. Contact forces without slip are served under the kinematic hypothesis, with a
    polynomial for k_n in place of 1/W^2; with slip no polynomial is near, and nothing is promised.

    Source
    ------
    Entrywise perturbation of diagonally dominant M-matrices (Alfa, Xue, Ye, Math. Comp. 71, 2002).

    Examples
    --------
    >>> from granular.fabric import AxialFabric
    >>> declared_error(AxialFabric(Dr33=0.3), hypothesis=Hypothesis.STATIC, degree=131) < 1e-12
    True
    """
    density = 2 if fabric.D3333 == 0 else 4
    shortest, longest = sorted((1 - fabric.Dr33 / 2, 1 + fabric.Dr33))
    if hypothesis is Hypothesis.KINEMATIC:
        beyond = degree - density - 8
        if beyond < 0:
            return math.inf
        if loading is None:
            return ROUNDING
        eta = _force_approximation(fabric, loading, beyond // 2)
        return 2 * eta / (1 - eta) + ROUNDING if eta < 0.01 else math.inf
    if loading is not None:
        return math.inf
    # Products with E, n_i, n_k and s_jl have the degree density + 4; the rest is there to follow 1/W^2.
    halves = (degree - density - 4) // 2 + 2
    if halves < 2:
        return math.inf
    eta = _relative_approximation(shortest / (longest - shortest), halves) if longest > shortest else 0.0
    if eta > 0.01:
        return math.inf
    return 6 * 2 * eta / (1 - eta) + ROUNDING * longest / shortest


def _force_approximation(fabric: AxialFabric, loading: Loading, order: int) -> float:
    """Bound of the relative error of the best polynomial of an order in y = 2 x^2 - 1 for (a s + c x^2)^(1/3).

    Up to a factor it is (1 + w y)^(1/3), at least (1 - |w|)^(1/3) on the interval and at most 2^(1/3) on the Bernstein
    ellipse that runs through the singularity.
    """
    a, c = (float(value) for value in loading.coefficients(fabric.D33))
    if loading.opens() or loading.slips(fabric.D33) or not (a > 0 and c > 0):
        return math.inf
    w = abs(c - a) / (c + a)
    if w == 0:
        return 0.0
    if w == 1:  # to rounding: the singularity is at the end of the interval
        return math.inf
    grown = (1 + math.sqrt((1 - w) * (1 + w))) / w
    if order * math.log(grown) > 300:
        return 0.0
    return 2 * math.cbrt(2 / (1 - w)) * grown**-order / (grown - 1)


def _relative_approximation(gap: float, halves: int) -> float:
    """Smallest \\|1 - q W^2\\| that a T_j(y) + b T_(j-1)(y) reaches, in y = 2 x^2 - 1 of either sign.

    W has its zero at \\|y\\| = 1 + 2 gap outside the interval; 1 - q W^2 must be 1 there, with slope 0.
    """
    angle, j = 2 * math.asinh(math.sqrt(gap)), halves
    if j * angle > 300:
        return 0.0
    ratio = j * math.sinh(j * angle) / ((j - 1) * math.sinh((j - 1) * angle))
    a = 1 / (math.cosh(j * angle) - ratio * math.cosh((j - 1) * angle))
    return abs(a) * (1 + ratio)


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
    Eq. (1), and Figure 1(b) with eq. (23).
    """
    import numpy as np

    n = directions
    normals, branches = (np.diag([-value / 2, -value / 2, value]) for value in (fabric.D33, fabric.Dr33))
    squared = n[2] ** 2
    rank_four = fabric.D3333 * ((35 * squared - 30) * squared + 3) / 8
    density = weights * (1 + np.einsum("iq,ij,jq->q", n, normals, n) + rank_four)
    branch = 1 + np.einsum("iq,ij,jq->q", n, branches, n)
    normal, shear, apart = _contact_stiffness(fabric, loading, n[2], poisson_ratio)
    if hypothesis is Hypothesis.KINEMATIC:
        spring = _contact_tensor(n, apart, shear)
        return _components(_mandel(_fourth_rank(n, spring, density * branch**2)))
    flexibility = _contact_tensor(n, -apart / (normal * shear), 1 / shear)
    carried = np.linalg.inv((density * n) @ n.T) @ n
    compliance = _mandel(_fourth_rank(carried, flexibility, density / branch**2))
    return _components(np.asarray(np.linalg.inv(compliance), dtype=np.float64))


def _contact_stiffness(fabric: AxialFabric, loading: Loading | None, cosine: Array,
                       poisson_ratio: float) -> tuple[Array, Array, Array]:
    """k_n, k_r and k_n - k_r over k_n,ref in every direction; without slip nothing is subtracted."""
    import numpy as np

    from granular.contact_distribution import normal_stiffness, shear_stiffness

    normal = np.ones_like(cosine) if loading is None else normal_stiffness(fabric, loading, cosine)
    if loading is None or not loading.slips(fabric.D33):
        share = poisson_ratio / (2 - poisson_ratio)
        return normal, 2 * (1 - poisson_ratio) / (2 - poisson_ratio) * normal, share * normal
    shear = shear_stiffness(fabric, loading, cosine, poisson_ratio=poisson_ratio)
    return normal, shear, normal - shear


def _contact_tensor(n: Array, along: Array, isotropic: Array) -> Array:
    """Evaluate along n_j n_l + isotropic delta_jl in every direction, (3, 3, n)."""
    import numpy as np

    tensor: Array = along * n[:, None] * n[None, :] + isotropic * np.eye(3)[:, :, None]
    return tensor


def _fourth_rank(vectors: Array, contact: Array, weights: Array) -> Array:
    """Sum v_i c_jl v_k over the directions into T_ijkl, symmetrised in ij and in kl.

    Mirrors through the three coordinate planes leave the fabric as it is, so that components with an index an odd
    number of times vanish; what rounding makes of them is dropped.
    """
    import numpy as np

    outer = (weights * vectors[:, None] * vectors[None, :]).reshape(9, -1)
    raw = (outer @ contact.reshape(9, -1).T).reshape(3, 3, 3, 3).transpose(0, 2, 1, 3)
    half = (raw + raw.transpose(1, 0, 2, 3)) / 2
    index = np.indices((3, 3, 3, 3))
    even = np.all([(index == axis).sum(axis=0) % 2 == 0 for axis in range(3)], axis=0)
    symmetric: Array = np.where(even, (half + half.transpose(0, 1, 3, 2)) / 2, 0.0)
    return symmetric


def _mandel(tensor: Array) -> Array:
    """Write the 6 x 6 Mandel matrix of a fourth-rank tensor, order 11, 22, 33, 23, 13, 12."""
    import numpy as np

    first, second = np.array([0, 1, 2, 1, 0, 0]), np.array([0, 1, 2, 2, 2, 1])
    scale = np.array([1.0, 1.0, 1.0] + 3 * [math.sqrt(2)])
    matrix: Array = tensor[first[:, None], second[:, None], first[None, :], second[None, :]]
    return matrix * np.outer(scale, scale)


def _components(mandel: Array) -> Six:
    return (float(mandel[0, 0]), float(mandel[2, 2]), float(mandel[0, 1]), float(mandel[0, 2]),
            float(mandel[3, 3] / 2), float(mandel[5, 5] / 2))
