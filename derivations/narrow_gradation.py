"""Nearly equal grains: eqs (16) and (17) as they stand, in powers of the log variance, beside eq. (19)."""

from __future__ import annotations

from functools import cache

import sympy as sp

from derivations.branch_lengths import MEAN_GROWTH
from derivations.record import Claim, Step
from derivations.symbols import log_variance

eps = sp.Symbol("epsilon_s", positive=True)
"""ln s_r, the standard deviation of the logarithms."""

t, z = sp.symbols("t z", real=True)
"""Logarithm of the ratio of both radii, and of the length over that of two median grains, each over eps."""

HIGHEST = 4
"""Power of eps that is kept."""


def _cut(expression: sp.Expr) -> sp.Expr:
    """Drop what is beyond the highest power kept."""
    polynomial = sp.Poly(sp.expand(expression), eps)
    return sum((c * eps**n for (n,), c in polynomial.terms() if n <= HIGHEST), sp.Integer(0))


def _exponential(small: sp.Expr) -> sp.Expr:
    """Exponential of a power series that starts with eps."""
    total = term = sp.Integer(1)
    for n in range(1, HIGHEST + 1):
        term = _cut(term * small / n)
        total += term
    return sp.expand(total)


def _logarithm(near_one: sp.Expr) -> sp.Expr:
    """Logarithm of a power series that starts with 1."""
    small, total, term = sp.expand(near_one - 1), sp.Integer(0), sp.Integer(-1)
    for n in range(1, HIGHEST + 1):
        term = _cut(-term * small)
        total += term / n
    return sp.expand(total)


def _normal_mean(polynomial: sp.Expr, variable: sp.Symbol, variance: sp.Rational) -> sp.Expr:
    """Mean over a normal variable with mean zero: odd powers vanish, even ones are double factorials."""
    terms = sp.Poly(polynomial, variable).terms()
    return sp.expand(sum((c * variance ** (n // 2) * sp.factorial2(n - 1) for (n,), c in terms if n % 2 == 0),
                         sp.Integer(0)))


def log_cosh() -> sp.Expr:
    """[c(w) - ln 2]/eps at w = eps t."""
    return eps * t**2 / 8 - eps**3 * t**4 / 192


@cache
def skewness() -> sp.Expr:
    """Logarithm of h plus z^2: what makes the density of all branches differ from a normal one in z."""
    bend = log_cosh()
    return _logarithm(_normal_mean(_exponential(_cut(2 * z * bend - bend**2)), t, sp.Integer(2)))


@cache
def log_moment(power: int) -> sp.Expr:
    """Logarithm of <l^power>_g by eq. (17), lengths in units of two median grains by number."""
    def total(k: sp.Rational) -> sp.Expr:
        weight = skewness() / 3 + (k + sp.Rational(2, 3)) * eps * z
        return _logarithm(_normal_mean(_exponential(weight), z, sp.Rational(3, 2)))

    return sp.expand(total(sp.Integer(power)) - total(sp.Integer(0)))


def log_factors() -> tuple[sp.Expr, sp.Expr]:
    """Logarithms of the kinematic and the static number over 4."""
    return log_moment(2) - 3 * eps**2, -log_moment(-2) - 3 * eps**2


def by_eq_19() -> tuple[sp.Expr, sp.Expr]:
    """The same by eq. (19)."""
    growth = sp.series(sp.log(MEAN_GROWTH), log_variance, 0, 3).removeO().subs(log_variance, eps**2)
    return sp.expand(9 * growth - 2 * eps**2), sp.expand(-3 * growth - 2 * eps**2)


def narrow_step() -> Step:
    """Literal numbers of nearly equal grains to second order in L."""
    (kinematic, static), (kinematic_19, static_19) = log_factors(), by_eq_19()
    return Step(
        "Nearly equal grains without eq. (19)",
        r"For small $L$ the integrals of eqs (16) and (17) can be done in powers of $\ln s_r$, with the density of all "
        r"branches as it is. The change in proportion to $L$ is the one above, so that the dependence on uniformity is "
        r"not due to eq. (19). What that neglects begins with $\tfrac12L^2$, for both hypotheses.",
        (r"\ln\frac{\langle\ell^2\rangle}{4\langle r^3\rangle_p^{2/3}} = \tfrac52L + \tfrac{13}{8}L^2+\dots,\qquad "
         r"\ln\frac{1}{4\langle\ell^{-2}\rangle\langle r^3\rangle_p^{2/3}} = -\tfrac72L + \tfrac18L^2+\dots",),
        (Claim(sp.series(sp.log(sp.cosh(eps * t / 2)) / eps, eps, 0, 5).removeO(), log_cosh()),
         Claim(kinematic, sp.Rational(5, 2) * eps**2 + sp.Rational(13, 8) * eps**4),
         Claim(static, -sp.Rational(7, 2) * eps**2 + eps**4 / 8),
         Claim(kinematic - kinematic_19, eps**4 / 2), Claim(static - static_19, eps**4 / 2)), result=True)
