"""The stiffness in ball arithmetic: every digit that is printed is proved.

The voice that the others are measured against, and independent of them. Where all contacts are equally stiff: moments
of the weight in closed form (an exact rational number under the kinematic hypothesis, the hypergeometric function of
Gauss under the static one), the components of eqs (1) and (23) written directly in those moments, and a 3 x 3
inversion in balls. Contacts that stiffen with their force are left to ``certified_kinetic`` and ``certified_static``,
spheroids to ``certified_spheroid``.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from typing import Any

from granular.errors import CertifiedArithmeticMissing, RouteOutOfDomain
from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.loading import Loading
from granular.routes.accuracy import HALF_ULP, require_accuracy
from granular.routes.balls import (
    arithmetic,
    ball,
    exact_weights,
    fraction,
    half_beta,
    inverse_moment,
    normal_tensor,
    stiffness_from_compliance,
)
from granular.routes.rational import rounded
from granular.routes.result import COMPONENTS, RouteResult

NAME = "certified"

MOST_DIGITS = 2000
"""Beyond this the series take seconds; nothing in this package compares to more than 50 digits."""


@dataclass(frozen=True, slots=True)
class Enclosure:
    """A component that certainly lies between two rational numbers.

    Attributes
    ----------
    name : str
        Which component, e.g. ``"C1111"``.
    lower, upper : Fraction
        Proved bounds over (M/V) l_e^2 k_n,ref [-].
    """

    name: str
    lower: Fraction
    upper: Fraction

    @property
    def midpoint(self) -> Fraction:
        """Middle of the enclosure over (M/V) l_e^2 k_n,ref [-]."""
        return (self.lower + self.upper) / 2

    @property
    def radius(self) -> Fraction:
        """Half the width of the enclosure over (M/V) l_e^2 k_n,ref [-]."""
        return (self.upper - self.lower) / 2


def enclose(fabric: AxialFabric, *, poisson_ratio: float, hypothesis: Hypothesis, loading: Loading | None = None,
            digits: int = 30) -> tuple[Enclosure, ...]:
    """Enclose the six components of an assembly.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branch lengths [-]; its binary64 numbers are taken as exact.
    poisson_ratio : float
        Poisson ratio of the grain material [-], 0 <= nu <= 0.5, taken as exact.
    hypothesis : Hypothesis
        Kinematic or static.
    loading : Loading or None
        Stress and friction, taken as exact; None for contacts that all have the same stiffness.
    digits : int
        Significant decimal digits wanted of every component [-], 1 to 2000.

    Returns
    -------
    tuple of Enclosure, (6,)
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n,ref [-].

    Accuracy
    --------
    Proved: the radius is at most ``10**-digits`` times the midpoint. Working precision doubles until it is.

    Raises
    ------
    CertifiedArithmeticMissing
        python-flint is not installed.
    RouteOutOfDomain
        ``digits`` is not from 1 to 2000, or spheroids with contact forces.
    ComplianceInfinite
        Static hypothesis, and contacts slide or have opened in some directions.

    Source
    ------
    Eqs (1)-(7) and (20)-(23); moments of ``1/W**2`` by Euler's integral for the hypergeometric function.

    Examples
    --------
    >>> first, *_ = enclose(AxialFabric(), poisson_ratio=0.0, hypothesis=Hypothesis.KINEMATIC)
    >>> first.name, first.lower <= Fraction(1, 3) <= first.upper
    ('C1111', True)
    """
    if not 1 <= digits <= MOST_DIGITS:
        raise RouteOutOfDomain(f"digits = {digits}", allowed=f"allowed 1 <= digits <= {MOST_DIGITS}",
                               remedy="Ask for a number of significant digits in that range.")
    flint = arithmetic()
    compute, guard = _computation(hypothesis, fabric, loading)
    precision = int(3.33 * digits) + 40 + guard
    while True:
        with flint.ctx.workprec(precision):
            components = compute(flint, fabric, Fraction(poisson_ratio))
            found = tuple(Enclosure(name, fraction(component.lower()), fraction(component.upper()))
                          for name, component in zip(COMPONENTS, components, strict=True) if component.is_finite())
        if len(found) == len(COMPONENTS) and all(e.radius * 10**digits <= abs(e.midpoint) for e in found):
            return found
        precision *= 2


def evaluate(fabric: AxialFabric, *, poisson_ratio: float, hypothesis: Hypothesis, loading: Loading | None = None,
             rtol: float | None = None) -> RouteResult:
    """Evaluate the six components in ball arithmetic, rounded to the nearest binary64 numbers.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branch lengths [-].
    poisson_ratio : float
        Poisson ratio of the grain material [-], 0 <= nu <= 0.5.
    hypothesis : Hypothesis
        Kinematic or static.
    loading : Loading or None
        Stress and friction; None for contacts that all have the same stiffness.
    rtol : float or None
        Relative accuracy wanted of every component [-]; refused below half a unit in the last place.

    Returns
    -------
    RouteResult
        Components over (M/V) l_e^2 k_n,ref [-]; no integrand is evaluated.

    Accuracy
    --------
    Half a unit in the last place, 2**-53 of each component: only the final rounding is left.

    Raises
    ------
    CertifiedArithmeticMissing
        python-flint is not installed.
    RouteOutOfDomain
        ``rtol`` is below what a binary64 number can hold.
    ComplianceInfinite
        Static hypothesis, and contacts slide or have opened in some directions.

    Source
    ------
    Eqs (1)-(7) and (20)-(23).

    Examples
    --------
    >>> result = evaluate(AxialFabric(), poisson_ratio=0.0, hypothesis=Hypothesis.STATIC)
    >>> result.components == (1/3, 1/3, 0.0, 0.0, 1/6, 1/6)
    True
    """
    require_accuracy(NAME, HALF_ULP, rtol)
    enclosures = enclose(fabric, poisson_ratio=poisson_ratio, hypothesis=hypothesis, loading=loading)
    components = rounded(enclosure.midpoint for enclosure in enclosures)
    return RouteResult(components, HALF_ULP, 0)


def available() -> bool:
    """Say whether python-flint can be imported.

    Returns
    -------
    bool
        True when this route can be used.
    """
    try:
        arithmetic()
    except CertifiedArithmeticMissing:
        return False
    return True


def _computation(hypothesis: Hypothesis, fabric: AxialFabric,
                 loading: Loading | None) -> tuple[Callable[[Any, AxialFabric, Fraction], tuple[Any, ...]], int]:
    """What encloses the components at a given working precision, and the bits that it needs on top."""
    if not fabric.collinear:
        return _spheroids(hypothesis, fabric, loading), 0
    if loading is None:
        return (_kinematic if hypothesis is Hypothesis.KINEMATIC else _static), 0
    from granular.routes import certified_kinetic, certified_static

    module = certified_kinetic if hypothesis is Hypothesis.KINEMATIC else certified_static
    return partial(module.components, loading=loading), module.guard_bits(fabric, loading)


def _spheroids(hypothesis: Hypothesis, fabric: AxialFabric,
               loading: Loading | None) -> Callable[[Any, AxialFabric, Fraction], tuple[Any, ...]]:
    from granular.routes import certified_spheroid

    if loading is not None:
        raise RouteOutOfDomain(
            f"route = certified for aspect_ratio = {fabric.aspect_ratio!r} with contact forces",
            allowed="allowed spheroids with contacts of equal stiffness: with contact forces there is no closed form",
            remedy='Use route = "axial", which serves every scene.')
    return certified_spheroid.kinematic if hypothesis is Hypothesis.KINEMATIC else certified_spheroid.static


def _kinematic(flint: Any, fabric: AxialFabric, poisson: Fraction) -> tuple[Any, ...]:
    """Eq. (7) in the plain moments <E W^2 x^(2k)>: rational numbers, so that only the last step rounds."""
    density, w0, w1 = exact_weights(fabric)
    squared = (w0**2, 2 * w0 * w1, w1**2)
    m0, m1, m2 = (sum((e * w * half_beta(4 - i - j, i + j + k)
                       for i, e in enumerate(density) for j, w in enumerate(squared)), Fraction(0))
                  for k in range(3))
    lam = (2 - 2 * poisson) / (2 - poisson)
    in_plane, mixed = m0 - 2 * m1 + m2, m1 - m2  # <E W^2 s^2> and <E W^2 s x^2>
    components = (
        (1 - lam) * 3 * in_plane / 8 + lam * (m0 - m1) / 2,
        (1 - lam) * m2 + lam * m1,
        (1 - lam) * in_plane / 8,
        (1 - lam) * mixed / 2,
        (1 - lam) * mixed / 2 + lam * (m1 + (m0 - m1) / 2) / 4,
        (1 - lam) * in_plane / 8 + lam * (m0 - m1) / 4,
    )
    return tuple(ball(flint, component) for component in components)


def _static(flint: Any, fabric: AxialFabric, poisson: Fraction) -> tuple[Any, ...]:
    """Eq. (23) with s_jl = n_j n_l / k_n + (delta_jl - n_j n_l) / k_r, minor-symmetrised, then inverted."""
    density, w0, w1 = exact_weights(fabric)
    by_power = [inverse_moment(flint, (w0, w1), Fraction(2), 4 - m, m) for m in range(5)]
    n4, n2x2, x4 = (sum((ball(flint, e) * by_power[j + k] for j, e in enumerate(density)), flint.arb(0))
                    for k in range(3))  # <s^2>, <s x^2> and <x^4> with the weight E/W^2
    lam = (2 - 2 * poisson) / (2 - poisson)
    apart, tangent = ball(flint, 1 - 1 / lam), ball(flint, 1 / lam)
    normal_less_shear, shear = ([factor * moment for moment in (n4, n2x2, x4)] for factor in (apart, tangent))
    return stiffness_from_compliance(flint, normal_tensor(flint, fabric), normal_less_shear, shear)
