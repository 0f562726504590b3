"""How well a Lebedev rule follows an integrand over the sphere: a proved bound, known before anything is computed."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from granular.hypothesis import Hypothesis

if TYPE_CHECKING:
    from granular.fabric import AxialFabric
    from granular.loading import Loading

DEGREES = (3, 5, 7, 9, 11, 15, 17, 19, 21, 23, 29, 31, 35, 41, 47, 53, 59, 65, 71, 77, 83, 89, 95, 101, 107, 113,
           119, 125, 131)
"""Degrees of the Lebedev rules whose weights are all positive, which the bound needs (not 13, 25 and 27)."""

WANTED = 1e-12
"""Relative accuracy aimed at when none is asked for [-]: about twenty times the rounding of a few thousand terms."""

ROUNDING = 1.5e-14
"""Rounding of the sums and of the inverse [-], times the ratio of branch lengths when it is 1/W^2 that is averaged.
Worst over all degrees and some thousand random and boundary fabrics: 5e-15 (kinematic), 9e-15 (static)."""


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
    if not fabric.collinear:
        return _error_of_spheroids(fabric, hypothesis, loading, (degree - density - 4) // 2)
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


def _error_of_spheroids(fabric: AxialFabric, hypothesis: Hypothesis, loading: Loading | None, order: int) -> float:
    """Bound the error for branches (n1, n2, r^2 n3)/sqrt(Q), with polynomials of this order in y = 2 x^2 - 1.

    They follow 1/Q, and the contact forces. The static average has a root besides, for which nothing is promised. The
    shear stiffness with free spin is a quotient of three averages, so that it errs by four times as much.
    """
    if hypothesis is Hypothesis.STATIC or order < 0:
        return math.inf
    smallest, largest = sorted((1.0, fabric.aspect_ratio**2))
    if loading is None:
        forces, left = 0.0, order
    else:
        left = order // 2
        forces = _force_approximation(fabric, loading, order - left)
    # the best polynomial for 1/(g + y) in relative error leaves 1/T_(m+1) at the zero of g + y
    angle = 2 * math.asinh(math.sqrt(smallest / (largest - smallest))) if largest > smallest else math.inf
    shape = 0.0 if (left + 1) * angle > 300 else 1 / math.cosh((left + 1) * angle)
    eta = forces + shape + forces * shape
    amplified = 8 if fabric.free_spin else 2
    return amplified * eta / (1 - eta) + ROUNDING * amplified if eta < 0.01 else math.inf


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
