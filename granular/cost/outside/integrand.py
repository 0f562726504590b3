"""The integrand of the stiffness as the equations stand, for every outside route and every kind of number.

Nothing of the routes of this package is used: eqs (1), (4) and (6) with the stiffness of a contact, eqs (20)-(23), or
Figure 1(b) with its flexibility. A direction comes with the products of its components, so that the same lines serve
rules over the sphere and, with the products averaged over the azimuth, rules along the meridian.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any, NamedTuple, Protocol

from granular.cost.scenes import CostScene
from granular.hypothesis import Hypothesis


class Direction(NamedTuple):
    """Cosine and sine of the angle from axis 3, and products of the components of the unit vector."""

    cosine: Any
    sine: Any
    n11: Any
    n22: Any
    n33: Any
    n1111: Any
    n3333: Any
    n1122: Any
    n1133: Any
    n2233: Any


def meridian(cosine: Any, sine: Any) -> Direction:
    """Average the products over the azimuth."""
    s, x2 = sine * sine, cosine * cosine
    return Direction(cosine, sine, s / 2, s / 2, x2, 3 * s * s / 8, x2 * x2, s * s / 8, s * x2 / 2, s * x2 / 2)


def on_sphere(n1: Any, n2: Any, n3: Any, sine: Any) -> Direction:
    """Products of a unit vector."""
    a, b, c = n1 * n1, n2 * n2, n3 * n3
    return Direction(n3, sine, a, b, c, a * a, c * c, a * b, a * c, b * c)


class Numbers(Protocol):
    """What the integrand needs of a kind of number beyond the four operations."""

    def number(self, value: Fraction) -> Any:
        """A rational number in this arithmetic."""

    def sqrt(self, value: Any) -> Any:
        """Square root of a positive number."""

    def cbrt(self, value: Any) -> Any:
        """Cube root of a number that is not negative."""

    def pressed(self, force: Any) -> Any:
        """The force where it presses, 0 where it would be a tension."""

    def left(self, shear: Any, limit: Any) -> Any:
        """1 - shear/limit where that is positive, else 0; 0 without a limit."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Problem:
    """The numbers of one scene in one arithmetic.

    Attributes
    ----------
    numbers : Numbers
        The arithmetic.
    static, forces, slips, spheroid : bool
        Static hypothesis; stiffness follows the force; friction is given; spheroids.
    D33, Dr33, lam0, mu, a, c, r2, size : number
        Fabric [-]; k_r/k_n without slip; friction; normal force at equator and pole over that of the isotropic
        assembly; squared aspect ratio; (a/r_e) of a spheroid.
    A11, A33 : number
        Inverse of the fabric tensor of eq. (23), static hypothesis [-].
    """

    numbers: Any
    static: bool
    forces: bool
    slips: bool
    spheroid: bool
    D33: Any
    Dr33: Any
    lam0: Any
    mu: Any
    a: Any
    c: Any
    r2: Any
    size: Any
    A11: Any
    A33: Any


def problem_of(scene: CostScene, numbers: Numbers) -> Problem:
    """Take the numbers of a scene into an arithmetic.

    Parameters
    ----------
    scene : CostScene
        What is computed; its doubles are taken as exact.
    numbers : Numbers
        The arithmetic.

    Returns
    -------
    Problem
        Its numbers, each rounded once.

    Notes
    -----
    Source: eqs (21) and (23) with N11 = 1/3 - D33/15, N33 = 1/3 + 2 D33/15.
    """
    fabric, nu = scene.fabric, Fraction(scene.poisson_ratio)
    d = Fraction(fabric.D33)
    n11, n33 = Fraction(1, 3) - d / 15, Fraction(1, 3) + 2 * d / 15
    a = c = mu = Fraction(1)
    if scene.loading is not None:
        mean = (2 * scene.loading.sigma11 + scene.loading.sigma33) / 3
        a, c = scene.loading.sigma11 / (3 * mean * n11), scene.loading.sigma33 / (3 * mean * n33)
        mu = Fraction(scene.loading.friction or 0)
    ratio = numbers.number(Fraction(fabric.aspect_ratio))
    values = {"D33": d, "Dr33": Fraction(fabric.Dr33), "lam0": 2 * (1 - nu) / (2 - nu), "mu": mu, "a": a, "c": c,
              "A11": 1 / n11, "A33": 1 / n33}
    return Problem(numbers=numbers, static=scene.hypothesis is Hypothesis.STATIC, forces=scene.loading is not None,
                   slips=scene.loading is not None and scene.loading.friction is not None,
                   spheroid=fabric.aspect_ratio != 1.0, r2=ratio * ratio, size=1 / numbers.cbrt(ratio),
                   **{name: numbers.number(value) for name, value in values.items()})


def stiffness_integrand(problem: Problem, n: Direction) -> tuple[Any, ...]:
    """Six components of 4 pi times the integrand of eq. (1), or of Figure 1(b), symmetrised.

    Parameters
    ----------
    problem : Problem
        The scene.
    n : Direction
        Where.

    Returns
    -------
    tuple of 6 numbers
        C1111, C3333, C1122, C1133, C2323, C1212 over (M/V) l_e^2 k_n,ref [-], or those of the compliance.

    Notes
    -----
    Source: eqs (1), (4), (6), (20)-(23), Figure 1(b).
    """
    density = 1 + problem.D33 * _p2(n)
    normal, shear = contact(problem, n)
    across, along = branch(problem, n)
    if problem.static:
        length = _length(problem, n, across)
        across, along, normal, shear = problem.A11 / length, problem.A33 / length, 1 / normal, 1 / shear
    apart = normal - shear
    return (
        density * across * across * (apart * n.n1111 + shear * n.n11),
        density * along * along * (apart * n.n3333 + shear * n.n33),
        density * across * across * apart * n.n1122,
        density * across * along * apart * n.n1133,
        density * (across * across * (apart * n.n2233 + shear * n.n22) + 2 * across * along * apart * n.n2233
                   + along * along * (apart * n.n2233 + shear * n.n33)) / 4,
        density * across * across * (apart * n.n1122 + shear * (n.n11 + n.n22) / 4))


def balance_integrand(problem: Problem, n: Direction) -> tuple[Any, ...]:
    """4 pi times the integrand of <n^l_i n_k>, which is not N_ik for spheroids: components 11 and 33 [-]."""
    density = 1 + problem.D33 * _p2(n)
    across, along = branch(problem, n)
    length = _length(problem, n, across)
    return density * across * n.n11 / length, density * along * n.n33 / length


def contact(problem: Problem, n: Direction) -> tuple[Any, Any]:
    """k_n and k_r over k_n,ref in a direction [-], eqs (20), (21) and (23)."""
    numbers, one = problem.numbers, 1 + 0 * n.cosine
    if not problem.forces:
        return one, problem.lam0 * one
    force = numbers.pressed(problem.a * n.sine * n.sine + problem.c * n.cosine * n.cosine)
    normal = numbers.cbrt(force)
    if not problem.slips:
        return normal, problem.lam0 * normal
    tangential = (problem.c - problem.a) * n.sine * n.cosine
    if problem.c < problem.a:
        tangential = -tangential
    return normal, problem.lam0 * numbers.cbrt(numbers.left(tangential, problem.mu * force)) * normal


def branch(problem: Problem, n: Direction) -> tuple[Any, Any]:
    """Factors of n_1, n_2 and of n_3 in the branch vector over l_e [-], eqs (4)-(6)."""
    if not problem.spheroid:
        length = 1 + problem.Dr33 * _p2(n)
        return length, length
    across = problem.size / problem.numbers.sqrt(n.sine * n.sine + problem.r2 * n.cosine * n.cosine)
    return across, problem.r2 * across


def stiffness_of(problem: Problem, six: Any) -> tuple[Any, ...]:
    """Six components of the stiffness from the averages: themselves, or the inverse of the compliance."""
    if not problem.static:
        return tuple(six)
    s11, s33, s12, s13, s2323, s1212 = six
    total, apart = s11 + s12, s11 - s12
    det = s33 * total - 2 * s13 * s13
    c33, c13 = total / det, -s13 / det
    plus, minus = s33 / det, 1 / apart
    return ((plus + minus) / 2, c33, (plus - minus) / 2, c13, 1 / (4 * s2323), 1 / (4 * s1212))


def balanced(problem: Problem, balance: Any) -> Problem:
    """The same with forces that balance the stress on spheroids."""
    across, along = balance
    return replace(problem, A11=1 / across, A33=1 / along)


def _p2(n: Direction) -> Any:
    return (3 * n.cosine * n.cosine - 1) / 2


def _length(problem: Problem, n: Direction, across: Any) -> Any:
    if not problem.spheroid:
        return across
    x2 = n.cosine * n.cosine
    return across * problem.numbers.sqrt(n.sine * n.sine + problem.r2 * problem.r2 * x2)
