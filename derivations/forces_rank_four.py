"""The force estimate of higher rank, eq. (22): which of the many solutions is meant, and what it gives.

A vector-valued cubic A_p(n) = A_pijk n_i n_j n_k is kept as its thirty coefficients: for each p the ten of a
symmetric tensor of rank three, which count 1, 3 or 6 times in a contraction.
"""

from __future__ import annotations

from functools import cache

import sympy as sp

from derivations.fabric import DENSITY
from derivations.record import Claim, Step
from derivations.sphere import axial_mean, homogeneous, sphere_mean
from derivations.symbols import D33, D3333, N33, latex, p0, p1, p2, s, sin_beta, x, y

N = sp.symbols("n1:4", real=True)

CUBIC = tuple((i, j, 3 - i - j) for i in range(3, -1, -1) for j in range(3 - i, -1, -1))
"""Exponents of the ten monomials of degree three."""

MULTIPLICITY = sp.diag(*(sp.factorial(3) / (sp.factorial(i) * sp.factorial(j) * sp.factorial(k))
                         for i, j, k in CUBIC))
"""How often each component of a symmetric tensor of rank three occurs among the 27."""

MONOMIALS = sp.Matrix([N[0] ** i * N[1] ** j * N[2] ** k for i, j, k in CUBIC])

AXIAL_1 = 2 * (p0 * s + 4 * p1 * x**2) / (p0**2 + 4 * p1**2)
"""A_1(n)/n_1 of least norm for an axial fabric."""

AXIAL_3 = (3 * p1 * s + 2 * p2 * x**2) / (3 * p1**2 + 2 * p2**2)
"""A_3(n)/n_3 of least norm for an axial fabric."""


@cache
def fabric_tensor_4() -> sp.ImmutableMatrix:
    """N_qijk of an axial fabric in p0 = <E s^2>, p1 = <E s x^2>, p2 = <E x^4>: three rows of ten."""
    def entry(q: int, column: int) -> sp.Expr:
        powers = list(CUBIC[column])
        powers[q] += 1
        if any(power % 2 for power in powers):
            return sp.Integer(0)
        across = sp.Rational(3 if 4 in powers[:2] else 1, 8)  # azimuthal means of cos^4 and cos^2 sin^2
        return {0: across * p0, 2: p1 / 2, 4: p2}[powers[2]]
    return sp.ImmutableMatrix(3, 10, entry)


def gram() -> sp.Matrix:
    """N N^T, contracted over three indices."""
    return fabric_tensor_4() * MULTIPLICITY * fabric_tensor_4().T


def least_norm() -> sp.Matrix:
    """A_pijk = (N N^T)^-1_pq N_qijk: three rows of ten."""
    return gram().inv() * fabric_tensor_4()


def closed_means() -> dict[sp.Symbol, sp.Expr]:
    """p0, p1, p2 of the contact-normal density itself."""
    density = DENSITY.subs(x, sp.sqrt(y))
    return {p: axial_mean(sp.expand(density * s ** (2 - k) * y**k)) for k, p in enumerate((p0, p1, p2))}


def _vanish(*expressions: sp.Expr) -> Claim:
    """All of them are zero: an arbitrary combination is."""
    weights = sp.symbols(f"c0:{len(expressions)}")
    return Claim(sum(w * sp.cancel(sp.together(e)) for w, e in zip(weights, expressions, strict=True)), sp.Integer(0))


def _mean_claim() -> Claim:
    """Entries of N_qijk, averaged over the sphere with the density inserted."""
    density = DENSITY.subs(x, N[2])
    direct = sp.Matrix(3, 10, lambda q, column: sphere_mean(N[q] * MONOMIALS[column] * density, N))
    return _vanish(*(fabric_tensor_4().subs(closed_means()) - direct))


def _count_step() -> Step:
    m = sp.Symbol("m", integer=True, positive=True)
    unknown = 3 * sp.binomial(2 * m + 1, 2)
    family = 3 * m * (2 * m + 1) - 9
    return Step(
        "Higher rank has many solutions, eq. (22)",
        r"With a fabric tensor of rank $2m$ the constraint is nine equations, while symmetric coefficients are "
        "$3m(2m+1)$. For $m = 1$ these are nine and there is one solution; for $m = 2$ they are thirty, the nine "
        "equations are independent, and the solutions form a family of 21 dimensions. All of them return the mean "
        "stress. Of the family the one of least norm is taken.",
        (r"A_{p\,i_2\dots i_{2m}}N_{i\,i_2\dots i_{2m}} = \delta_{ip},\qquad \dim = "
         rf"{latex(family)}",),
        (Claim(sp.expand(unknown.rewrite(sp.gamma).gammasimp()) - 9, family),
         Claim(family.subs(m, 1), sp.Integer(0)), Claim(family.subs(m, 2), sp.Integer(21)),
         Claim(sp.Integer((fabric_tensor_4() * MULTIPLICITY).rank()) * 3, sp.Integer(9))))


def _least_norm_step() -> Step:
    fabric, solution = fabric_tensor_4(), least_norm()
    other = sp.Matrix(3, 10, sp.symbols("z0:30", real=True))
    multiplier = gram().inv()
    constraint = other * MULTIPLICITY * fabric.T
    product = (solution * MULTIPLICITY * other.T).trace()
    total = ((solution + other) * MULTIPLICITY * (solution + other).T).trace()
    parts = (solution * MULTIPLICITY * solution.T).trace() + (other * MULTIPLICITY * other.T).trace()
    return Step(
        "The solution of least norm",
        r"It is a combination of the fabric tensor's own rows. A change $Z$ that keeps the constraint, "
        r"$Z_{pijk}N_{qijk} = 0$, is perpendicular to it, so that it can only add to the norm.",
        (r"A_{pijk} = \Lambda_{pq}N_{qijk},\qquad \Lambda^{-1}_{pq} = N_{pijk}N_{qijk}",
         r"A_{pijk}Z_{pijk} = \Lambda_{pq}\,Z_{pijk}N_{qijk},\qquad "
         r"|A+Z|^2 = |A|^2 + |Z|^2 + 2A_{pijk}Z_{pijk}"),
        (_vanish(*(solution * MULTIPLICITY * fabric.T - sp.eye(3))),
         _vanish(*(solution - multiplier * fabric)),
         _vanish(product - (multiplier * constraint.T).trace()),
         _vanish(sp.expand(total - parts - 2 * product))), result=True)


def _axial_step() -> Step:
    solution = least_norm() * MULTIPLICITY * MONOMIALS
    on_sphere = {N[0]: sin_beta, N[1]: 0, N[2]: x}
    balance_3 = sp.expand(sp.numer(sp.together(AXIAL_3)) * y)
    balance_1 = sp.expand(sp.numer(sp.together(AXIAL_1)) * s)

    def average(form: sp.Expr) -> sp.Expr:
        weights = homogeneous(form.subs(x, sp.sqrt(y)), 2)
        return sp.expand(sum(w * p for w, p in zip(weights, (p0, p1, p2), strict=True)))

    return Step(
        "Axial fabric",
        r"The moments $p_0 = \langle Es^2\rangle$, $p_1 = \langle Esx^2\rangle$, $p_2 = \langle Ex^4\rangle$ of the "
        r"contact-normal density carry everything; the same three as in the stiffness with $W = 1$. The rank-four "
        "part of the density enters, unlike for rank two.",
        (rf"A_3(n) = x\,{latex(AXIAL_3)},\qquad A_1(n) = n_1\,{latex(AXIAL_1)}",
         *(f"{latex(p)} = {latex(e)}" for p, e in closed_means().items())),
        (_mean_claim(),
         _vanish(solution[2].subs(on_sphere) - x * AXIAL_3.subs(s, sin_beta**2)),
         _vanish(solution[0].subs(on_sphere) - sin_beta * AXIAL_1.subs(s, sin_beta**2)),
         Claim(average(balance_3), sp.denom(sp.together(AXIAL_3))),
         Claim(average(balance_1), 2 * sp.denom(sp.together(AXIAL_1)))), result=True)


def _comparison_step() -> Step:
    isotropic = {p: e.subs({D33: 0, D3333: 0}) for p, e in closed_means().items()}
    second = {p: e.subs(D3333, 0) for p, e in closed_means().items()}
    to_y = {s: 1 - y, x: sp.sqrt(y)}
    slope_3 = sp.diff(AXIAL_3.subs(second), D33).subs(D33, 0).subs(to_y)
    slope_2 = sp.diff(1 / (sp.Rational(1, 3) + 2 * D33 / 15), D33).subs(D33, 0)
    density_slope = sp.diff(DENSITY, D33).subs(x, sp.sqrt(y))
    return Step(
        "Rank four against rank two",
        r"For an isotropic fabric both give $A_p(n) = 3n_p$. In an anisotropic one they part at first order: under a "
        "stress along axis 3 the force over $x$ of rank two is the same in all directions, that of rank four varies "
        "with $y = x^2$. Both keep the balance.",
        (rf"\frac{{A_3(n)}}{{x}} = 3 + \left({latex(sp.expand(slope_3))}\right){latex(D33)} + \dots,\qquad "
         rf"\frac{{1}}{{{latex(N33)}}} = 3 {latex(slope_2)}\,{latex(D33)} + \dots",),
        (Claim(AXIAL_3.subs(isotropic).subs(to_y), sp.Integer(3)),
         Claim(AXIAL_1.subs(isotropic).subs(to_y), sp.Integer(3)),
         Claim(axial_mean(sp.expand((3 * density_slope + slope_3) * y)), sp.Integer(0)),
         Claim(axial_mean(sp.expand((3 * density_slope + slope_2) * y)), sp.Integer(0)),
         Claim(sp.expand(slope_3), sp.Rational(9, 7) * y - sp.Rational(69, 35)), Claim(slope_2, -sp.Rational(6, 5))))


def rank_four_steps() -> tuple[Step, ...]:
    """Count the solutions, pick the one of least norm, write it out for an axial fabric, compare with rank two."""
    return _count_step(), _least_norm_step(), _axial_step(), _comparison_step()
