"""Partial slip as it is evaluated for very many assemblies: what comes before a table is read, and what comes after."""

from __future__ import annotations

from fractions import Fraction
from functools import cache

import sympy as sp

from derivations import batch_kinetic
from derivations.batch_constant import (
    DENOMINATOR,
    DENSITY,
    SUMS,
    complement,
    density_assignments,
    domain,
    level,
    ratio_assignments,
    square_assignments,
    substituted,
    sum_assignments,
)
from derivations.batch_kinetic import (
    FORCE_INTEGRALS,
    HIGH,
    LOW,
    PRECISION,
    RATIOS,
    over_roots,
    root_a,
    root_c,
    root_series,
    roots,
    unit,
)
from derivations.economised import economise, rationals
from derivations.kinetic_components import positive_components
from derivations.record import BatchFunction, Claim, Function, Step
from derivations.series import TruncatedSeries
from derivations.symbols import (
    D33,
    POSITIVE_MOMENTS,
    SR,
    STIFFNESS,
    TANGENTIAL_MOMENTS,
    Dr33,
    a,
    c,
    d0,
    d1,
    kappa,
    lam,
    margin,
    mu,
    nu,
    one_minus_lam,
    v,
)

LOST = sp.symbols("lost0:6", nonnegative=True)
"""DENOMINATOR times the integrals of s^(5-m) y^m of what slip takes, in units of the mean cube root of the forces."""

LOST_DENSITY = sp.symbols("lost_density0:5", nonnegative=True)
LOST_SUMS = sp.symbols("taken0:3", nonnegative=True)
KEPT_SUMS = sp.symbols("kept0:3", nonnegative=True)

shear0, shear1, quarter, both, later, along = sp.symbols("shear0 shear1 quarter both later along", nonnegative=True)
square, growth = sp.symbols("square growth", nonnegative=True)
"""Squared contrast; how much faster than the contrast the share of a friction of 1 grows that is used up."""

contrast = sp.Symbol("contrast", real=True)

SHARE_TERMS = 40
"""Taylor terms of the share to start from: what is beyond is below 2^-100."""


def share_terms() -> list[Fraction]:
    """Exact coefficients of (3 + z) (1 - z)^(-3/2)."""
    binomial = [Fraction(1)]
    for n in range(1, SHARE_TERMS):
        binomial.append(binomial[-1] * Fraction(2 * n + 1, 2 * n))
    return [3 * one + before for one, before in zip(binomial, [Fraction(0), *binomial], strict=False)]


@cache
def share_series() -> TruncatedSeries:
    """(3 + z) (1 - z)^(-3/2) in z = v^2, as a polynomial."""
    exact = share_terms()
    reach = max(-LOW, HIGH) ** 2
    coefficients, rest = economise(exact, Fraction(0), reach, 3 * PRECISION)
    return TruncatedSeries("SHARE", rationals(coefficients), sp.Rational(reach.numerator, reach.denominator),
                           sp.Rational(rest.numerator, rest.denominator) / 3, "v^2")


def state_function() -> Function:
    """Emit what a table is read by: the contrast of the forces and the share of the friction that is used up."""
    polynomial, series = sp.Function("polynomial"), share_series()
    before = batch_kinetic.sums_of_forces()
    to_roots = before[:[symbol for symbol, _ in before].index(complement)]
    return Function(
        "slip_state", "Level of the stiffness, cubic contrast of the forces, share of the friction used up and left.",
        (D33, SR, mu),
        (*to_roots, (roots, root_a + root_c), (over_roots, 1 / roots), (level, unit * roots),
         (v, (root_c - root_a) * over_roots), (square, v * v), (growth, polynomial(sp.Symbol(series.name), square)),
         (kappa, growth * sp.Abs(v) / mu), (margin, 1 - kappa)),
        (level, v, kappa, margin), unit="-", series=(*root_series(), series),
        notes="Served for 1/9 <= c/a <= 6 with a and c the normal forces at equator and pole.")


def rows_function() -> Function:
    """Emit the six components from the contrast of the forces and what slip takes."""
    r, taken, kept = SUMS, LOST_SUMS, KEPT_SUMS
    c1111, c3333, c1122, c1133, c2323, c1212 = STIFFNESS
    polynomial, series = sp.Function("polynomial"), [batch_kinetic.series(m) for m in range(6)]
    return Function(
        "slip_rows", "Six components over (M/V) l_e^2 k_n,ref with partial slip.",
        (D33, Dr33, nu, level, v, *LOST),
        ((contrast, v), *((f, polynomial(sp.Symbol(one.name), contrast)) for f, one in zip(FORCE_INTEGRALS, series,
                                                                                          strict=True)),
         *density_assignments(FORCE_INTEGRALS, DENSITY), *density_assignments(LOST, LOST_DENSITY)[2:],
         *square_assignments(level), *sum_assignments(r, DENSITY), *sum_assignments(taken, LOST_DENSITY),
         *ratio_assignments(),
         *((left, all_ - lost) for left, all_, lost in zip(kept, r, taken, strict=True)),
         (shear0, one_minus_lam * r[0] + lam * taken[0]), (quarter, one_minus_lam * r[1] + lam * taken[1]),
         (shear1, 4 * quarter), (both, kept[0] + kept[1]), (later, kept[1] + kept[2]), (along, r[2] + lam * kept[1]),
         (c1111, 3 * r[0] + lam * sp.Add(kept[0], 4 * kept[1])), (c3333, 8 * along),
         (c1122, shear0), (c1133, shear1),
         (c2323, shear1 + lam * sp.Add(both, 2 * later)), (c1212, shear0 + 2 * lam * both)),
        STIFFNESS, unit="-", series=tuple(series),
        notes=f"What slip takes is counted in units of the mean cube root of the forces, times {DENOMINATOR}.")


@cache
def batch() -> tuple[BatchFunction, ...]:
    """What is emitted for batches."""
    least, most = RATIOS
    return (BatchFunction(state_function(), (*domain()[:2], sp.Le(a, 1 / least * c), sp.Le(c, most * a)), level,
                          (c, root_c), apart=True),
            BatchFunction(rows_function(), (*domain()[2:], sp.Gt(level, 0, evaluate=False),
                                             sp.Ge(LOST[0], 0, evaluate=False)), one_minus_lam,
                          (contrast, FORCE_INTEGRALS[-1])))


def components_step() -> Step:
    """Show that the components are those of two weights again."""
    ratio = substituted(ratio_assignments())[one_minus_lam]
    found: dict[sp.Symbol, sp.Expr] = {one_minus_lam: ratio, lam: 1 - ratio}
    assigned = [symbol for symbol, _ in rows_function().assignments]
    for symbol, expression in rows_function().assignments[assigned.index(lam) + 1:]:
        found[symbol] = expression.xreplace(found)
    weights = {p: 8 * r for p, r in zip(POSITIVE_MOMENTS, SUMS, strict=True)}
    for q, d, r, lost in zip(TANGENTIAL_MOMENTS, (d0, d1, None), SUMS, LOST_SUMS, strict=True):
        weights[q] = 8 * (1 - ratio) * (r - lost)
        if d is not None:
            weights[d] = 8 * (ratio * r + (1 - ratio) * lost)
    used = sp.sqrt(1 - v**2) ** 3
    return Step(
        "For very many assemblies at once",
        r"In the cubic contrast $\bar v$ of the forces the share of the friction has no other root than that of "
        r"$1-\bar v^2$. A table holds $L_k/\kappa$, what slip takes from the six integrals, in panels of "
        r"$\bar\kappa$ and $\bar v$. The components need no division of their own.",
        (r"L_k = \int_0^1 s^{5-k}x^{2k}\left[f_n^{1/3} - \max\left(f_n - \tfrac{f_r}\mu, 0\right)^{1/3}\right]"
         r"\mathrm{d}x,\qquad \kappa = \frac{|\bar v|(3+\bar v^2)}{\mu(1-\bar v^2)^{3/2}}",),
        (Claim(sp.expand((1 + v) ** 3 - (1 - v) ** 3), sp.expand(2 * v * (3 + v**2))),
         Claim(sp.expand((1 + v) ** 3 * (1 - v) ** 3), sp.expand(used**2)),
         Claim(sp.series((3 + square) / (1 - square) ** sp.Rational(3, 2), square, 0, 6).removeO(),
               sum(sp.Rational(t.numerator, t.denominator) * square**n for n, t in enumerate(share_terms()[:6]))),
         *(Claim(sp.cancel(sp.together(found[symbol] - expression.xreplace(weights))), sp.Integer(0))
           for symbol, expression in zip(STIFFNESS, positive_components(), strict=True))), result=True)
