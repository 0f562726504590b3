"""The stiffness in ball arithmetic: every digit that is printed is proved.

The voice that the others are measured against, and independent of them: moments of the weight in closed form
(an exact rational number under the kinematic hypothesis, the hypergeometric function of Gauss under the static
one), the components of eqs (1) and (23) written directly in those moments, and a 3 x 3 inversion in balls.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from granular.errors import CertifiedArithmeticMissing, RouteOutOfDomain
from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.routes.accuracy import HALF_ULP, require_accuracy
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


def enclose(fabric: AxialFabric, *, poisson_ratio: float, hypothesis: Hypothesis,
            digits: int = 30) -> tuple[Enclosure, ...]:
    """Enclose the six components of an assembly whose contacts all have the same stiffness.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branch lengths [-]; its binary64 numbers are taken as exact.
    poisson_ratio : float
        Poisson ratio of the grain material [-], 0 <= nu <= 0.5, taken as exact.
    hypothesis : Hypothesis
        Kinematic or static.
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
        ``digits`` is not from 1 to 2000.

    Source
    ------
    Eqs (1)-(7) and (23); moments of ``1/W**2`` by Euler's integral for the hypergeometric function.

    Examples
    --------
    >>> first, *_ = enclose(AxialFabric(), poisson_ratio=0.0, hypothesis=Hypothesis.KINEMATIC)
    >>> first.name, first.lower <= Fraction(1, 3) <= first.upper
    ('C1111', True)
    """
    if not 1 <= digits <= MOST_DIGITS:
        raise RouteOutOfDomain(f"digits = {digits}", allowed=f"allowed 1 <= digits <= {MOST_DIGITS}",
                               remedy="Ask for a number of significant digits in that range.")
    flint = _arithmetic()
    components = _kinematic if hypothesis is Hypothesis.KINEMATIC else _static
    precision = int(3.33 * digits) + 40
    while True:
        with flint.ctx.workprec(precision):
            balls = components(flint, fabric, Fraction(poisson_ratio))
            found = tuple(Enclosure(name, _fraction(ball.lower()), _fraction(ball.upper()))
                          for name, ball in zip(COMPONENTS, balls, strict=True) if ball.is_finite())
        if len(found) == len(COMPONENTS) and all(e.radius * 10**digits <= abs(e.midpoint) for e in found):
            return found
        precision *= 2


def evaluate(fabric: AxialFabric, *, poisson_ratio: float, hypothesis: Hypothesis,
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

    Source
    ------
    Eqs (1)-(7) and (23).

    Examples
    --------
    >>> result = evaluate(AxialFabric(), poisson_ratio=0.0, hypothesis=Hypothesis.STATIC)
    >>> result.components == (1/3, 1/3, 0.0, 0.0, 1/6, 1/6)
    True
    """
    require_accuracy(NAME, HALF_ULP, rtol)
    enclosures = enclose(fabric, poisson_ratio=poisson_ratio, hypothesis=hypothesis)
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
        _arithmetic()
    except CertifiedArithmeticMissing:
        return False
    return True


def _arithmetic() -> Any:
    try:
        import flint
    except ImportError as error:
        raise CertifiedArithmeticMissing(
            "python-flint is not installed", allowed="ball arithmetic needs it",
            remedy="Install it with: pip install 'granular[certified]'.") from error
    return flint


def _fraction(end_point: Any) -> Fraction:
    """Turn the end point of a ball, a dyadic number, into a fraction."""
    mantissa, exponent = (int(part) for part in end_point.man_exp())
    return Fraction(mantissa) * Fraction(2) ** exponent


def _ball(flint: Any, value: Fraction) -> Any:
    return flint.arb(flint.fmpq(value.numerator, value.denominator))


def _exact_weights(fabric: AxialFabric) -> tuple[tuple[Fraction, Fraction, Fraction], Fraction, Fraction]:
    """4 pi E = sum_j e_j s^(2-j) x^(2j) and W = w0 s + w1 x^2 with s = 1 - x^2, exactly."""
    d33, d3333, dr33 = Fraction(fabric.D33), Fraction(fabric.D3333), Fraction(fabric.Dr33)
    density = (1 - d33 / 2 + 3 * d3333 / 8, 2 + d33 / 2 - 3 * d3333, 1 + d33 + d3333)
    return density, 1 - dr33 / 2, 1 + dr33


def _half_beta(power_of_s: int, power_of_square: int) -> Fraction:
    """Int_0^1 s^a x^(2b) dx = B(b + 1/2, a + 1)/2, a rational number."""
    value = Fraction(1, 2 * power_of_square + 1)
    for j in range(1, power_of_s + 1):
        value *= Fraction(2 * j, 2 * power_of_square + 1 + 2 * j)
    return value


def _kinematic(flint: Any, fabric: AxialFabric, poisson: Fraction) -> tuple[Any, ...]:
    """Eq. (7) in the plain moments <E W^2 x^(2k)>: rational numbers, so that only the last step rounds."""
    density, w0, w1 = _exact_weights(fabric)
    squared = (w0**2, 2 * w0 * w1, w1**2)
    m0, m1, m2 = (sum((e * w * _half_beta(4 - i - j, i + j + k)
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
    return tuple(_ball(flint, component) for component in components)


def _static_moment(flint: Any, w0: Fraction, w1: Fraction, power: int) -> Any:
    """<s^(4-m) x^(2m) / W^2>, with the larger weight taken out so that the argument lies in [0, 1)."""
    arb = flint.arb
    if w0 >= w1:
        series = _ball(flint, (w0 - w1) / w0).hypgeom_2f1(2, arb(2 * power + 1) / 2, arb(11) / 2)
    else:
        series = _ball(flint, (w1 - w0) / w1).hypgeom_2f1(2, arb(5 - power), arb(11) / 2)
    return _ball(flint, _half_beta(4 - power, power) / max(w0, w1) ** 2) * series


def _static(flint: Any, fabric: AxialFabric, poisson: Fraction) -> tuple[Any, ...]:
    """Eq. (23) with s_jl = n_j n_l / k_n + (delta_jl - n_j n_l) / k_r, minor-symmetrised, then inverted."""
    density, w0, w1 = _exact_weights(fabric)
    by_power = [_static_moment(flint, w0, w1, m) for m in range(5)]
    n4, n2x2, x4 = (sum((_ball(flint, e) * by_power[j + k] for j, e in enumerate(density)), flint.arb(0))
                    for k in range(3))  # <s^2>, <s x^2> and <x^4> with the weight E/W^2
    n2, x2 = n4 + n2x2, n2x2 + x4
    lam = (2 - 2 * poisson) / (2 - poisson)
    normal, tangent = _ball(flint, 1 - 1 / lam), _ball(flint, 1 / lam)
    d33 = Fraction(fabric.D33)
    a1, a3 = _ball(flint, 1 / (Fraction(1, 3) - d33 / 15)), _ball(flint, 1 / (Fraction(1, 3) + 2 * d33 / 15))
    s1111 = a1**2 * (normal * 3 * n4 / 8 + tangent * n2 / 2)
    s3333 = a3**2 * (normal * x4 + tangent * x2)
    s1122 = a1**2 * normal * n4 / 8
    s1133 = a1 * a3 * normal * n2x2 / 2
    s2323 = (a1**2 * (normal * n2x2 / 2 + tangent * n2 / 2) + 2 * a1 * a3 * normal * n2x2 / 2
             + a3**2 * (normal * n2x2 / 2 + tangent * x2)) / 4
    s1212 = (s1111 - s1122) / 2
    # Cramer's rule, in the form in which C1122 is exactly zero where s1122 and s1133 are.
    apart, together = s1111 - s1122, (s1111 + s1122) * s3333 - 2 * s1133**2
    return ((s1111 * s3333 - s1133**2) / (apart * together), (s1111 + s1122) / together,
            (s1133**2 - s1122 * s3333) / (apart * together), -s1133 / together, 1 / (4 * s2323), 1 / (4 * s1212))
