"""Constant contact stiffness as it is evaluated for very many fabrics: the closed form with one division.

The density has rank two, so that E W^2 is a form of degree three in s and y. The density is averaged first, and the
squares of the branch length weight its integrals: what is common to all components is in these, so that no operation is
left that only scales. Contacts that follow their force have other integrals, and the same arithmetic from there on.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

import sympy as sp

from derivations.record import BatchFunction, Claim, Function, Step
from derivations.sphere import axial_moment
from derivations.symbols import D33, POSITIVE_MOMENTS, STIFFNESS, Dr33, e0, e1, lam, latex, nu, one_minus_lam, w0

Assignments = tuple[tuple[sp.Symbol, sp.Expr], ...]

DENSITY = sp.symbols("density0:5", nonnegative=True)
"""Integrals of s^(4-j) y^j times twice the density."""

SQUARES = sp.symbols("square0:3", nonnegative=True)
"""Coefficients of 4 W^2 in s^2, s y, y^2."""

SUMS = sp.symbols("sum0:3", nonnegative=True)
"""Moments of E W^2 over 8: what the components are made of."""

level, complement, over_complement = sp.symbols("level complement over_complement", positive=True)
half_e1, half_w1, twice_w1 = sp.symbols("half_e1 half_w1 twice_w1", nonnegative=True)
four_r1, both, later, along = sp.symbols("four_r1 both later along", nonnegative=True)

DENOMINATOR = sp.ilcm(*(axial_moment(5 - m, m).q for m in range(6)))
"""Common denominator of the integrals of s^(5-m) y^m."""

SCALE = 8 * 8 * DENOMINATOR
"""What integrals of 2 E and 4 W^2 carry beside the sums: 8 of E W^2, 8 of the components, and the denominator."""


def domain() -> tuple[sp.Rel, ...]:
    """The whole domain of the model."""
    half = sp.Rational(1, 2)
    return tuple(kind(symbol, bound, evaluate=False) for kind, symbol, bound in (
        (sp.Ge, D33, -1), (sp.Le, D33, 2), (sp.Gt, Dr33, -1), (sp.Lt, Dr33, 2), (sp.Ge, nu, 0), (sp.Le, nu, half)))


def domain_of_fabric() -> tuple[sp.Rel, ...]:
    """The same domain by the signs of products, most of which are computed anyway.

    Of two factors only one can be negative, and none of these products is rounded to zero.
    """
    return (sp.Ge(e0 * half_e1, 0, evaluate=False), sp.Gt(SQUARES[1], 0, evaluate=False), *domain()[-2:])


def integer_moment(m: int) -> sp.Integer:
    """Integral of s^(5-m) y^m over x from 0 to 1, times the common denominator."""
    return sp.Integer(axial_moment(5 - m, m) * DENOMINATOR)


def density_assignments(integrals: Sequence[sp.Expr], density: tuple[sp.Symbol, ...]) -> Assignments:
    """Integrals of 2 E from integrals without it, which have one power of s or y more: terms of one sign."""
    return ((e0, 2 - D33), (e1, 2 + 2 * D33),
            *((one, e0 * integrals[j] + e1 * integrals[j + 1]) for j, one in enumerate(density)))


def integer_density_assignments() -> Assignments:
    """The same for integrals that are whole numbers: what the two have in common goes with 2 - D33 + 1 + D33 = 3."""
    lines: list[tuple[sp.Symbol, sp.Expr]] = [(e0, 2 - D33), (half_e1, 1 + D33)]
    for j, one in enumerate(DENSITY):
        by_e0, by_half = integer_moment(j), 2 * integer_moment(j + 1)
        common = min(by_e0, by_half)
        lines.append((one, 3 * common + (by_e0 - common) * e0 + (by_half - common) * half_e1))
    return tuple(lines)


def square_assignments(level: sp.Symbol) -> Assignments:
    """From the branch lengths to the coefficients of 4 W^2, times a level."""
    level_w0, level_half_w1 = sp.symbols("level_w0 level_half_w1", nonnegative=True)
    return ((w0, 2 - Dr33), (half_w1, 1 + Dr33), (twice_w1, 4 * half_w1),
            (level_w0, level * w0), (level_half_w1, level * half_w1),
            (SQUARES[0], level_w0 * w0), (SQUARES[1], level_w0 * twice_w1), (SQUARES[2], level_half_w1 * twice_w1))


def sum_assignments(sums: tuple[sp.Symbol, ...], density: tuple[sp.Symbol, ...]) -> Assignments:
    """Sums of integrals of the density, weighted by the squares of the branch length."""
    return tuple((total, sum((density[j + k] * square for j, square in enumerate(SQUARES)), sp.Integer(0)))
                 for k, total in enumerate(sums))


def ratio_assignments() -> Assignments:
    """Tangential over normal stiffness and what is left to one, of which the second keeps its digits near nu = 0."""
    return ((complement, 2 - nu), (one_minus_lam, nu / complement), (lam, 1 - one_minus_lam))


def fabric_assignments() -> Assignments:
    """From the fabric to the sums of contacts that are all equally stiff."""
    return ((level, sp.Integer(1) / SCALE), *integer_density_assignments(), *square_assignments(level),
            *sum_assignments(SUMS, DENSITY))


def component_assignments() -> Assignments:
    """From the three sums to the components."""
    r0, r1, r2 = SUMS
    c1111, c3333, c1122, c1133, c2323, c1212 = STIFFNESS
    return (
        (four_r1, 4 * r1), (both, r0 + r1), (later, r1 + r2), (along, r2 + lam * r1),
        (c1111, 3 * r0 + lam * sp.Add(r0, four_r1)),
        (c3333, 8 * along), (c1122, one_minus_lam * r0),
        (c1133, one_minus_lam * four_r1),
        (c2323, c1133 + lam * sp.Add(both, 2 * later)),
        (c1212, c1122 + 2 * lam * both),
    )


def constant_function() -> Function:
    """Emit the six components of one fabric."""
    return Function(
        "kinematic_constant", "Six components over (M/V) l_e^2 k_n for contacts that are all equally stiff.",
        (D33, Dr33, nu),
        (*fabric_assignments(), *ratio_assignments(), *component_assignments()), STIFFNESS, unit="-")


@cache
def batch() -> tuple[BatchFunction, ...]:
    """What is emitted for batches."""
    return (BatchFunction(constant_function(), domain(), one_minus_lam, tested=domain_of_fabric()),)


def substituted(assignments: Assignments) -> dict[sp.Symbol, sp.Expr]:
    """Every assigned symbol in the arguments alone."""
    known: dict[sp.Symbol, sp.Expr] = {}
    for symbol, expression in assignments:
        known[symbol] = expression.xreplace(known)
    return known


def steps(closed: dict[sp.Symbol, sp.Expr], components: tuple[sp.Expr, ...]) -> tuple[Step, ...]:
    """Show the form for batches, and that it is the closed form again.

    ``closed`` gives the positive moments in the fabric, ``components`` the components in moments and nu.
    """
    known, in_e0 = substituted(fabric_assignments()), dict(fabric_assignments())[DENSITY[0]]
    to_sums = {p: 8 * r for p, r in zip(POSITIVE_MOMENTS, SUMS, strict=True)}
    found = substituted((*ratio_assignments(), *component_assignments()))
    return (
        Step("For very many fabrics at once",
             "Without the coefficient of rank four the density is averaged first, with integer weights over one "
             "denominator. The squares of the branch length weight its integrals, and all terms have one sign. One "
             r"division is left, that in $\bar\lambda$.",
             (rf"{latex(POSITIVE_MOMENTS[0])} = (2-D^r_{{33}})^2 d_0 + 4(2-D^r_{{33}})(1+D^r_{{33}})\,d_1 + "
              r"4(1+D^r_{33})^2 d_2,",
              r"d_j = \frac14\int_0^1 s^{4-j}x^{2j}E\,\mathrm{d}x,\qquad "
              rf"{8 * DENOMINATOR}\,d_0 = {latex(in_e0.coeff(e0))}\,(2-D_{{33}}) + {latex(in_e0.coeff(e0, 0))}",),
             (*(Claim(sp.expand(8 * known[total]), sp.expand(closed[p]))
                for total, p in zip(SUMS, POSITIVE_MOMENTS, strict=True)),
              *(Claim(sp.cancel(found[symbol] - expression.xreplace(to_sums)), sp.Integer(0))
                for symbol, expression in zip(STIFFNESS, components, strict=True)))),
    )
