"""Contact stiffness that follows the contact force, in ball arithmetic: the moments that make up the stiffness.

The normal stiffness is a cube root of a form in sin(beta) and cos(beta), whose moments are hypergeometric functions.
So is the shear stiffness once Mohr's circle is turned: with beta = beta* + omega, beta* the direction nearest to
sliding, the force that is left before a contact slides is

    h = a s + c x^2 - |c - a| x sqrt(s)/mu = delta + 2 R sin^2(omega),

and sin(beta), cos(beta) are linear in sin(omega), cos(omega). The moments of a polynomial of odd degree in these then
split into incomplete moments of (delta + 2 R y^2)^(1/3) with y = sin(omega) and of (M - 2 R z^2)^(1/3) with
z = cos(omega). Every number stays a fraction until the square root sqrt(1 + mu^2); which contacts stick and which
slide is decided in fractions.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from granular.fabric import AxialFabric
from granular.loading import Loading
from granular.routes.balls import ball, exact_weights, half_beta, magnitude

DEGREE = 6
"""Degree in s and x^2 of E W^2 of rank four times a component of eq. (7)."""

Three = tuple[Any, Any, Any]
"""Moments with s^2, s x^2 and x^4."""


def contact_moments(flint: Any, fabric: AxialFabric, loading: Loading) -> tuple[Three, Three | None]:
    """Moments <E W^2 k s^(2-i) x^(2i)>, i = 0, 1, 2, of the two contact stiffnesses.

    Parameters
    ----------
    flint : module
        python-flint, its working precision set.
    fabric : AxialFabric
        Contact normals and branch lengths [-].
    loading : Loading
        Stress and friction.

    Returns
    -------
    normal : tuple of 3 arb
        With the weight k_n [-].
    shear : tuple of 3 arb or None
        With the weight k_r/lambda_0 [-]; None where k_r = lambda_0 k_n in every direction.

    Notes
    -----
    Accuracy: enclosures; one that is not finite asks for a higher working precision. Source: eqs (7) and (20)-(23).
    """
    weights = squared_weights(fabric)
    a, c = loading.coefficients(fabric.D33)
    by_power = [_normal_moment(flint, a, c, j) for j in range(DEGREE + 1)]
    normal = tuple(sum((ball(flint, weight) * by_power[k + i] for k, weight in enumerate(weights)), flint.arb(0))
                   for i in range(3))
    if loading.friction == 0:
        return _three(normal), (flint.arb(0), flint.arb(0), flint.arb(0))
    if loading.friction is None or a == c:
        return _three(normal), None
    return _three(normal), _shear_moments(flint, weights, mohr(flint, a, c, Fraction(loading.friction)))


def guard_bits(fabric: AxialFabric, loading: Loading) -> int:
    """Estimate the working precision that a loading costs, so that it is rarely raised in steps.

    Returns
    -------
    int
        Bits beyond those of the wanted digits: forces of very different size, near tangency, and a shear force that
        takes little off the shear stiffness, so that their difference cancels.
    """
    a, c = loading.coefficients(fabric.D33)
    bits = magnitude(c / a) if a > 0 and c > 0 else 0
    if loading.friction:
        tilt = loading.tilt(fabric.D33)
        if tilt is not None and tilt not in {0, 1}:
            bits += magnitude(1 - tilt) // 2 if tilt > Fraction(1, 2) else magnitude(tilt) // 2
    return bits


def squared_weights(fabric: AxialFabric) -> tuple[Fraction, ...]:
    """4 pi E W^2 = sum_k w_k s^(4-k) x^(2k), exactly."""
    density, w0, w1 = exact_weights(fabric)
    weights = [Fraction(0)] * 5
    for i, e in enumerate(density):
        for j, w in enumerate((w0**2, 2 * w0 * w1, w1**2)):
            weights[i + j] += e * w
    return tuple(weights)


@dataclass(frozen=True, slots=True)
class Mohr:
    """Mohr's circle turned to the direction in which contacts are nearest to sliding.

    Attributes
    ----------
    delta : arb
        Force left before sliding in that direction [-]; negative where contacts slide there.
    double_radius, most : arb
        2 R and M = delta + 2 R [-].
    sine, cosine : arb
        Of beta* [-].
    sticks : bool
        No contact slides.
    tangent : bool
        delta is exactly zero.
    ends : tuple of (int, arb, arb, arb)
        For each arc of contacts that stick: its side, -1 towards the pole and 1 towards the equator; \\|sin(omega)\\|
        and cos(omega) at its far end; and h there [-].
    """

    delta: Any
    double_radius: Any
    most: Any
    sine: Any
    cosine: Any
    sticks: bool
    tangent: bool
    ends: tuple[tuple[int, Any, Any, Any], ...]


def mohr(flint: Any, a: Fraction, c: Fraction, friction: Fraction | None) -> Mohr:
    """Turn Mohr's circle.

    Parameters
    ----------
    flint : module
        python-flint, its working precision set.
    a, c : Fraction
        Normal force at the equator and at the pole [-], not equal, not both <= 0.
    friction : Fraction or None
        mu [-], > 0; None for the normal force itself, which is the limit of large mu.

    Returns
    -------
    Mohr
        Rational numbers turned to balls at the last moment; sticking, tangency and sliding decided exactly.

    Notes
    -----
    Source: eqs (21)-(23); 2 R = \\|c - a\\| sqrt(1 + mu^2)/mu, cos(2 beta*) = (a - c)/(2 R), and
    (M - 2 R) M = a c - (c - a)^2/(4 mu^2).
    """
    apart = abs(c - a)
    if friction is None:
        double_radius, left, small = ball(flint, apart), a * c, flint.arb(0)
    else:
        root = ball(flint, 1 + friction**2).sqrt()
        double_radius = ball(flint, apart / friction) * root
        left = a * c - (apart / (2 * friction)) ** 2
        small = (2 * root * (root + ball(flint, friction))).rsqrt()
    large = (1 - small**2).sqrt()
    middle = (a + c) / 2
    if middle >= 0:
        most = ball(flint, middle) + double_radius / 2
        delta = ball(flint, left) / most
    else:
        delta = ball(flint, middle) - double_radius / 2
        most = ball(flint, left) / delta
    sine, cosine = (large, small) if c > a else (small, large)
    pole, equator = (-1, sine, cosine, ball(flint, c)), (1, cosine, sine, ball(flint, a))
    ends = tuple(end for end, force in ((pole, c), (equator, a)) if force > 0)
    return Mohr(delta, double_radius, most, sine, cosine, left >= 0, left == 0, ends)


def _normal_moment(flint: Any, a: Fraction, c: Fraction, power: int) -> Any:
    """Int_0^1 s^(6-k) x^(2k) (a s + c x^2)^(1/3) dx over the directions in which the force presses."""
    arb, third = flint.arb, flint.arb(1) / 3
    half, rest = arb(2 * power + 1) / 2, arb(DEGREE + 1 - power)
    if a < 0:  # open near the equator: s from 0 to s0
        edge, exponent = ball(flint, c / (c - a)), rest + third
        series = edge.hypgeom_2f1(1 - half, rest, exponent + 1)
        return (ball(flint, (c - a) / 8).root(3) * edge**exponent * _beta(flint, rest, third + 1) * series)
    if c < 0:  # open near the pole: x^2 from 0 to y0
        edge, exponent = ball(flint, a / (a - c)), half + third
        series = edge.hypgeom_2f1(1 - rest, half, exponent + 1)
        return (ball(flint, (a - c) / 8).root(3) * edge**exponent * _beta(flint, half, third + 1) * series)
    complete = ball(flint, half_beta(DEGREE - power, power))
    if c <= a:
        return ball(flint, a).root(3) * complete * _series(flint, 1 - c / a, -third, half, rest + half)
    return ball(flint, c).root(3) * complete * _series(flint, 1 - a / c, -third, rest, rest + half)


def _shear_moments(flint: Any, weights: tuple[Fraction, ...], circle: Mohr) -> Three:
    """The same moments of max(h, 0)^(1/3), over the one or two arcs of contacts that stick."""
    poly = flint.arb_poly
    ahead, beside = poly([circle.sine, circle.cosine]), poly([circle.cosine, -circle.sine])
    s, y = ahead * ahead, beside * beside
    density = sum((ball(flint, weight) * s ** (4 - k) * y**k for k, weight in enumerate(weights)), poly([0])) * ahead
    arcs = [(side, list(_sine_moments(flint, circle, end, h)), list(_cosine_moments(flint, circle, end, far, h)))
            for side, end, far, h in circle.ends]
    found = []
    for i in range(3):
        turned = density * s ** (2 - i) * y**i
        even, odd = _split(flint, turned)
        found.append(sum((even[p] * sines[p] + side * odd[p] * cosines[p]
                          for side, sines, cosines in arcs for p in range(DEGREE + 1)), flint.arb(0)))
    return _three(found)


def _split(flint: Any, turned: Any) -> tuple[Any, Any]:
    """A form of degree 13 in y and z as z P(y^2) + y Q(z^2), by y^2 + z^2 = 1."""
    poly = flint.arb_poly
    variable, complement = poly([0, 1]), poly([1, -1])
    even = sum((turned[2 * j] * variable**j * complement ** (DEGREE - j) for j in range(DEGREE + 1)), poly([0]))
    odd = sum((turned[2 * j + 1] * complement**j * variable ** (DEGREE - j) for j in range(DEGREE + 1)), poly([0]))
    return even, odd


def _sine_moments(flint: Any, circle: Mohr, end: Any, h: Any) -> Iterator[Any]:
    """Int y^(2p) h^(1/3) dy from the start of the arc to its end, p = 0, ..., 6."""
    arb = flint.arb
    minus_third, one = -arb(1) / 3, arb(1)
    for p in range(DEGREE + 1):
        if circle.tangent:
            yield end ** (2 * p + 1) * h.root(3) / (arb(2 * p) + arb(5) / 3)
        elif circle.sticks:
            series = (1 - circle.delta / h).hypgeom_2f1(minus_third, one, arb(2 * p + 3) / 2)
            yield end ** (2 * p + 1) * h.root(3) / (2 * p + 1) * series
        else:
            series = (h / (h - circle.delta)).hypgeom_2f1(arb(1 - 2 * p) / 2, one, arb(7) / 3)
            yield 3 * h.root(3) * h / (8 * circle.double_radius) * end ** (2 * p - 1) * series


def _cosine_moments(flint: Any, circle: Mohr, end: Any, far: Any, h: Any) -> Iterator[Any]:
    """Int z^(2p) h^(1/3) dz from the end of the arc to its start, p = 0, ..., 6."""
    arb = flint.arb
    third, scale, root = arb(1) / 3, circle.double_radius / circle.most, circle.most.root(3)
    at_end = h / circle.most
    at_start = circle.delta / circle.most if circle.sticks and not circle.tangent else arb(0)
    for p in range(DEGREE + 1):
        half = arb(2 * p + 1) / 2
        unit = root / 2 * scale ** (-half)

        def from_middle(z: Any, p: int = p, half: Any = half) -> Any:
            """Int from z = 0."""
            series = (scale * z * z).hypgeom_2f1(-third, half, half + 1)
            return z ** (2 * p + 1) * root / (2 * p + 1) * series

        def to_edge(w: Any, half: Any = half, unit: Any = unit) -> Any:
            """Int up to the root of h, from where h = w M."""
            if w.is_zero():
                return w
            return unit * 3 * w.root(3) * w / 4 * w.hypgeom_2f1(1 + third, 1 - half, 2 + third)

        far_out, near = at_end > 0.5, at_start > 0.5
        if far_out and near:
            yield from_middle(arb(1)) - from_middle(far)
        elif far_out:
            yield unit * _beta(flint, half, 1 + third) - to_edge(at_start) - from_middle(far)
        else:
            yield to_edge(at_end) - to_edge(at_start)


def _series(flint: Any, argument: Fraction, *parameters: Any) -> Any:
    """Gauss's function of an exact argument from 0 to 1, both included."""
    return ball(flint, argument).hypgeom_2f1(*parameters) if argument else flint.arb(1)


def _beta(flint: Any, first: Any, second: Any) -> Any:
    return first.gamma() * second.gamma() / (first + second).gamma()


def _three(moments: Any) -> Three:
    first, second, third = moments
    return first, second, third


def components(flint: Any, fabric: AxialFabric, poisson: Fraction, *, loading: Loading) -> tuple[Any, ...]:
    """Six components of eq. (7) as sums of positive terms, the difference k_n - k_r taken in balls.

    Parameters
    ----------
    flint : module
        python-flint, its working precision set.
    fabric : AxialFabric
        Contact normals and branch lengths [-].
    poisson : Fraction
        Poisson's ratio of the grain material [-].
    loading : Loading
        Stress and friction.

    Returns
    -------
    tuple of arb, (6,)
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n,ref [-].

    Notes
    -----
    Accuracy: enclosures, as wide as the working precision makes them. Source: eqs (7) and (20)-(23).
    """
    normal, sticking = contact_moments(flint, fabric, loading)
    lam, rest = ball(flint, (2 - 2 * poisson) / (2 - poisson)), ball(flint, poisson / (2 - poisson))
    shear = [lam * moment for moment in (normal if sticking is None else sticking)]
    apart = [rest * moment for moment in normal]
    if sticking is not None:
        apart = [part + lam * (n - h) for part, n, h in zip(apart, normal, sticking, strict=True)]
    return (3 * normal[0] / 8 + shear[0] / 8 + shear[1] / 2,
            normal[2] + shear[1],
            apart[0] / 8,
            apart[1] / 2,
            apart[1] / 2 + shear[2] / 4 + 3 * shear[1] / 8 + shear[0] / 8,
            apart[0] / 8 + shear[0] / 4 + shear[1] / 4)
