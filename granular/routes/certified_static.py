"""The static hypothesis with contact stiffness that follows the contact force: certified integration.

With the exponent -1/3 and the weight E/W^2 the moments have no short closed form. They are integrated in balls
(Petras' scheme, every error bound proved) along each side of the direction beta* in which the force h is least,

    h = delta + 2 R sin^2(omega),   omega = beta - beta*,

after the map omega = eta sinh(v), sinh(eta)^2 = delta/(2 R), which moves the zeros of h away from the path, or
omega = tau^3 where delta is exactly zero. The normal stiffness is the case of no friction limit: its beta* is the pole
or the equator.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import partial
from typing import Any

from granular.fabric import AxialFabric
from granular.loading import Loading
from granular.routes.balls import ball, exact_weights, magnitude, normal_tensor, stiffness_from_compliance
from granular.routes.certified_kinetic import Mohr, mohr

NOT_THIN = Fraction(1, 100)
"""Ratio of branch lengths at the end of an arc and a right angle away, below which that end gets a map of its own."""


def components(flint: Any, fabric: AxialFabric, poisson: Fraction, *, loading: Loading) -> tuple[Any, ...]:
    """Six static components, with the difference 1/k_n - 1/k_r taken in balls.

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

    Raises
    ------
    ComplianceInfinite
        Contacts slide or have opened over a range of directions.

    Notes
    -----
    Accuracy: enclosures, as wide as the working precision makes them. Source: eqs (20)-(23).
    """
    loading.require_finite_compliance(fabric.D33)
    a, c = loading.coefficients(fabric.D33)
    normal = _moments(flint, fabric, a, c, None)
    lam = (2 - 2 * poisson) / (2 - poisson)
    shear = [ball(flint, 1 / lam) * moment for moment in normal]
    apart = [ball(flint, 1 - 1 / lam) * moment for moment in normal]
    if loading.friction is not None and a != c:
        nearer = _moments(flint, fabric, a, c, Fraction(loading.friction))
        apart = [part + ball(flint, 1 / lam) * (n - h) for part, n, h in zip(apart, normal, nearer, strict=True)]
        shear = [ball(flint, 1 / lam) * moment for moment in nearer]
    return stiffness_from_compliance(flint, normal_tensor(flint, fabric), apart, shear)


def guard_bits(fabric: AxialFabric, loading: Loading) -> int:
    """Estimate the working precision that the difference 1/k_n - 1/k_r costs where friction is far from used up.

    Returns
    -------
    int
        Bits beyond those of the wanted digits.
    """
    tilt = loading.tilt(fabric.D33)
    return magnitude(tilt) // 2 if tilt and tilt < Fraction(1, 2) else 0


def _moments(flint: Any, fabric: AxialFabric, a: Fraction, c: Fraction, friction: Fraction | None) -> list[Any]:
    """<E W^-2 h^(-1/3) s^(2-i) x^(2i)>, i = 0, 1, 2."""
    density, w0, w1 = exact_weights(fabric)
    e = [flint.acb(ball(flint, weight)) for weight in density]
    v0, v1 = (flint.acb(ball(flint, weight)) for weight in (w0, w1))

    def weight(sine: Any, cosine: Any, power: int) -> Any:
        """E W^-2 s^(2-i) x^(2i) sin(beta)."""
        s, y = sine * sine, cosine * cosine
        length = v0 * s + v1 * y
        component = (s * s, s * y, y * y)[power]
        return ((e[0] * s + e[1] * y) * s + e[2] * y * y) * component * sine / (length * length)

    if a == c:
        quarter = flint.acb(flint.arb.pi() / 2)
        found = [_integral(flint, lambda x, _, i=i: weight(x.sin(), x.cos(), i), quarter) for i in range(3)]
        return [moment / ball(flint, a).root(3) for moment in found]
    circle = mohr(flint, a, c, friction)
    return [sum((_arc(flint, circle, side, angle, w0 / w1 if side > 0 else w1 / w0, partial(weight, power=i))
                 for side, angle in _arcs(flint, circle)), flint.arb(0)) for i in range(3)]


def _arcs(flint: Any, circle: Mohr) -> Iterator[tuple[int, Any]]:
    """Each side of beta* that is not empty, and its length."""
    for side, end, far, _ in circle.ends:
        if not end.is_zero():
            yield side, flint.acb(flint.arb.atan2(end, far))


def _arc(flint: Any, circle: Mohr, side: int, angle: Any, thin: Fraction, weight: Callable[[Any, Any], Any]) -> Any:
    """Int weight h^(-1/3) d(omega) over the directions between beta* and one end.

    Where branches at the end are much shorter than elsewhere, by the factor ``thin``, 1/W^2 has a pole near it. The
    half of the arc at that end is then mapped on its own: its distance from the end is sqrt(thin) sinh(u).
    """
    acb = flint.acb
    sine, cosine, minus_third = acb(circle.sine), acb(circle.cosine), -acb(1) / 3
    twice, delta = acb(circle.double_radius), acb(circle.delta)

    def turned(sin_omega: Any, cos_omega: Any) -> Any:
        across = side * sin_omega
        return weight(sine * cos_omega + cosine * across, cosine * cos_omega - sine * across)

    def softness(sin_omega: Any, analytic: bool) -> Any:
        return (delta + twice * sin_omega * sin_omega).pow(minus_third, analytic=analytic)

    def plain(omega: Any, analytic: bool) -> Any:
        sin_omega = omega.sin()
        return turned(sin_omega, omega.cos()) * softness(sin_omega, analytic)

    def from_root(tau: Any, analytic: bool) -> Any:
        """Integrand after omega = tau^3, in which h = 2 R omega^2 sinc(omega)^2."""
        omega = tau**3
        smooth = omega.sinc()
        return 3 * turned(omega.sin(), omega.cos()) * (twice * smooth * smooth).pow(minus_third, analytic=analytic)

    def stretched(v: Any, analytic: bool) -> Any:
        return plain(eta * v.sinh(), analytic) * eta * v.cosh()

    def from_end(u: Any, analytic: bool) -> Any:
        distance = theta * u.sinh()
        sin_distance, cos_distance = distance.sin(), distance.cos()
        directed = weight(cos_distance, sin_distance) if side > 0 else weight(sin_distance, cos_distance)
        return directed * softness((angle - distance).sin(), analytic) * theta * u.cosh()

    beyond = 0
    if thin < NOT_THIN:
        theta, angle_left = acb(ball(flint, thin)).sqrt(), angle / 2
        beyond = _integral(flint, from_end, (angle_left / theta).asinh())
    else:
        angle_left = angle
    if circle.tangent:
        return beyond + _integral(flint, from_root, angle_left.root(3))
    eta = (delta / twice).sqrt().asinh()
    if eta.real > 0.5:
        return beyond + _integral(flint, plain, angle_left)
    return beyond + _integral(flint, stretched, (angle_left / eta).asinh())


def _integral(flint: Any, integrand: Callable[..., Any], end: Any) -> Any:
    """Certified integral of a positive function from 0 to the end, about as good as the working precision allows.

    A rough size of the integral, which need not be right, keeps the scheme from refining where next to nothing lies.
    """
    goal, points = flint.arb(2) ** (10 - flint.ctx.prec), 12
    size = sum((abs(integrand(end * (2 * j + 1) / (2 * points), False)) for j in range(points)), flint.arb(0))
    wanted = (size * abs(end) / points * goal).mid()
    return flint.acb.integral(integrand, 0, end, rel_tol=goal, abs_tol=wanted).real
