"""Contact-normal density and branch-length weight about axis 3: positive form, admissible region, fabric tensor."""

from __future__ import annotations

from functools import cache

import sympy as sp

from derivations.record import Claim, Derivation, Output, Step
from derivations.sphere import axial_mean, homogeneous, sphere_mean
from derivations.symbols import D33, D3333, N11, N33, Dr33, e0, e1, e2, latex, s, w0, w1, x, y

P2 = sp.legendre(2, x)
P4 = sp.legendre(4, x)

DENSITY = 1 + D33 * P2 + D3333 * P4
"""Contact-normal density over that of an isotropic packing, 4 pi E."""

BRANCH = 1 + Dr33 * P2
"""Branch length over its mean l_e, the weight W."""

DENSITY_FORM = homogeneous(DENSITY.subs(x, sp.sqrt(y)), 2)
"""4 pi E = e0 s^2 + e1 s y + e2 y^2: the three coefficients."""

BRANCH_FORM = homogeneous(BRANCH.subs(x, sp.sqrt(y)), 1)
"""W = w0 s + w1 y: the two coefficients."""


def density_form() -> sp.Expr:
    """4 pi E with the coefficients left as symbols."""
    return e0 * s**2 + e1 * s * y + e2 * y**2


def branch_form() -> sp.Expr:
    """W with the coefficients left as symbols."""
    return w0 * s + w1 * y


def fabric_tensor() -> tuple[sp.Expr, sp.Expr]:
    """N11 and N33 of the mean of n_i n_j over the contacts, by averaging over the whole sphere."""
    n = sp.symbols("n1:4", real=True)
    density = DENSITY.subs(x, n[2])
    return sphere_mean(n[0] ** 2 * density, n), sphere_mean(n[2] ** 2 * density, n)


def admissible_rank_2() -> sp.Set:
    """Values of D33 for which the density is nowhere negative when D3333 = 0: it is linear in y, so the ends decide."""
    at_equator, at_pole = DENSITY_FORM[0].subs(D3333, 0), DENSITY_FORM[2].subs(D3333, 0)
    return sp.Intersection(sp.solveset(at_equator >= 0, D33, sp.S.Reals), sp.solveset(at_pole >= 0, D33, sp.S.Reals))


def admissible_branch() -> sp.Set:
    """Values of Dr33 for which every branch has a positive length."""
    at_equator, at_pole = BRANCH_FORM
    return sp.Intersection(sp.solveset(at_equator > 0, Dr33, sp.S.Reals), sp.solveset(at_pole > 0, Dr33, sp.S.Reals))


@cache
def fabric() -> Derivation:
    """Derive the positive forms, the admissible region and the fabric tensor."""
    in_y = density_form().subs(s, 1 - y)
    curvature = e0 - e1 + e2
    turn = (2 * e0 - e1) / (2 * curvature)
    least = e0 - (2 * e0 - e1) ** 2 / (4 * curvature)
    to_coefficients = dict(zip((e0, e1, e2), DENSITY_FORM, strict=True))
    n11, n33 = fabric_tensor()
    steps = (
        Step("Density of contact normals",
             "A density that is even, axially symmetric about axis 3 and of rank four at most has two coefficients. "
             "Its mean over the sphere is one, whatever they are, because $P_2$ and $P_4$ average to zero.",
             (rf"4\pi E = 1 + {latex(D33)} P_2(x) + {latex(D3333)} P_4(x)",),
             (Claim(axial_mean(density_form().subs(to_coefficients)), sp.Integer(1)),)),
        Step("Positive form",
             "With $s = 1 - x^2$ and $y = x^2$ the density is a quadratic form in $s$ and $y$. Its end coefficients "
             "are the density at the equator and at the pole.",
             (rf"4\pi E = {latex(density_form())}", *(f"{latex(k)} = {latex(c)}" for k, c in to_coefficients.items())),
             (Claim(density_form().subs(to_coefficients).subs(s, 1 - y).subs(y, x**2), DENSITY),
              Claim(to_coefficients[e0], DENSITY.subs(x, 0)), Claim(to_coefficients[e2], DENSITY.subs(x, 1))),
             result=True),
        Step("Least density between equator and pole",
             "As a function of $y$ on $[0, 1]$ the density is a parabola. It has its least value inside only where it "
             "is convex and turns between 0 and 1; there it is",
             (rf"4\pi E_{{\min}} = {latex(sp.factor(sp.together(least)))}",),
             (Claim(sp.diff(in_y, y).subs(y, turn), sp.Integer(0)),
              Claim(in_y.subs(y, turn), least),
              Claim(least * 4 * curvature, 4 * e0 * e2 - e1**2))),
        Step("Admissible region",
             "Hence the density is nowhere negative exactly when both ends are non-negative and the middle coefficient "
             r"is not below $-2\sqrt{e_0e_2}$. Without a rank-four part the parabola is a straight line and the ends "
             "decide.",
             (rf"{latex(e0)} \ge 0,\quad {latex(e2)} \ge 0,\quad {latex(e1)} \ge -2\sqrt{{{latex(e0)}{latex(e2)}}}",
              rf"{latex(D3333)} = 0:\quad -1 \le {latex(D33)} \le 2"),
             (Claim(admissible_rank_2(), sp.Interval(-1, 2)),
              Claim((DENSITY_FORM[0] - DENSITY_FORM[1] + DENSITY_FORM[2]).subs(D3333, 0), sp.Integer(0))), result=True),
        Step("Branch length",
             "The branch-length weight has one coefficient; every branch has a length only inside an open interval.",
             (rf"W = 1 + {latex(Dr33)} P_2(x) = {latex(branch_form())}",
              *(f"{latex(k)} = {latex(c)}" for k, c in zip((w0, w1), BRANCH_FORM, strict=True)),
              rf"-1 < {latex(Dr33)} < 2"),
             (Claim(branch_form().subs({w0: BRANCH_FORM[0], w1: BRANCH_FORM[1]}).subs(s, 1 - y).subs(y, x**2), BRANCH),
              Claim(admissible_branch(), sp.Interval.open(-1, 2))), result=True),
        Step("Fabric tensor",
             "The mean of $n_in_j$ over the contacts follows from monomial moments over the sphere. The rank-four part "
             "does not enter, and the trace is one.",
             (rf"{latex(N11)} = {latex(n11)}", rf"{latex(N33)} = {latex(n33)}",
              r"N_{ij} = \tfrac13\delta_{ij} + \tfrac{2}{15}D_{ij}"),
             (Claim(2 * n11 + n33, sp.Integer(1)),
              Claim(n33, sp.Rational(1, 3) + sp.Rational(2, 15) * D33),
              Claim(n11, sp.Rational(1, 3) + sp.Rational(2, 15) * (-D33 / 2))), result=True),
    )
    return Derivation(
        name="fabric",
        title="Fabric of a transversely isotropic assembly",
        sources=("(14)", "Figure 5", "N_ij below (23)"),
        assumptions=("The fabric is axially symmetric about axis 3 and even in n.",),
        domain=("e0 >= 0, e2 >= 0, e1 >= -2 sqrt(e0 e2)", "-1 < Dr33 < 2"),
        inputs=(D33, D3333, Dr33),
        outputs=(*(Output(k, c) for k, c in to_coefficients.items()),
                 Output(w0, BRANCH_FORM[0]), Output(w1, BRANCH_FORM[1]), Output(N11, n11), Output(N33, n33)),
        steps=steps,
    )
