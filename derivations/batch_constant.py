"""Constant contact stiffness as it is evaluated for very many fabrics: the closed form with one division.

The density has rank two, so that E W^2 is a form of degree three in s and y and its moments have small integer weights
over a common denominator.
"""

from __future__ import annotations

from functools import cache

import sympy as sp

from derivations.record import BatchFunction, Claim, Function, Step
from derivations.sphere import axial_moment
from derivations.symbols import D33, POSITIVE_MOMENTS, STIFFNESS, Dr33, e0, e1, latex, nu, w0, w1

WEIGHTS = sp.symbols("omega0:4", nonnegative=True)
"""Coefficients of 8 E W^2 as a form of degree three."""

SUMS = sp.symbols("sum0:3", nonnegative=True)

mixed, mixed_too, factor, share, complement = sp.symbols("mixed mixed_too factor share complement", nonnegative=True)
shear0, shear1, both = sp.symbols("shear0 shear1 both", nonnegative=True)

DENOMINATOR = sp.ilcm(*(axial_moment(5 - m, m).q for m in range(6)))
"""Common denominator of the integrals of s^(5-m) y^m."""

SCALE = 8 * 8 * DENOMINATOR
"""What the sums carry beside the components: 8 of E W^2, 8 of the components, and the denominator."""


def domain() -> tuple[sp.Rel, ...]:
    """The whole domain of the model."""
    half = sp.Rational(1, 2)
    return tuple(kind(symbol, bound, evaluate=False) for kind, symbol, bound in (
        (sp.Ge, D33, -1), (sp.Le, D33, 2), (sp.Gt, Dr33, -1), (sp.Lt, Dr33, 2), (sp.Ge, nu, 0), (sp.Le, nu, half)))


def integer_moment(m: int) -> sp.Integer:
    """Integral of s^(5-m) y^m over x from 0 to 1, times the common denominator."""
    return sp.Integer(axial_moment(5 - m, m) * DENOMINATOR)


def weight_assignments() -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
    """From the fabric to the coefficients of 8 E W^2: no subtraction but those that are exact."""
    return (
        (e0, 2 - D33), (e1, 2 + 2 * D33), (w0, 2 - Dr33), (w1, 2 + 2 * Dr33),
        (mixed, e0 * w1), (mixed_too, e1 * w0),
        (WEIGHTS[0], e0 * w0 * w0), (WEIGHTS[1], w0 * sp.Add(2 * mixed, mixed_too)),
        (WEIGHTS[2], w1 * sp.Add(mixed, 2 * mixed_too)), (WEIGHTS[3], e1 * w1 * w1),
    )


def component_assignments() -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
    """From the three sums to the components, times 8 (2 - nu)."""
    r0, r1, r2 = SUMS
    c1111, c3333, c1122, c1133, c2323, c1212 = STIFFNESS
    return (
        (shear0, nu * r0), (shear1, 4 * sp.Mul(nu, r1, evaluate=False)), (both, r0 + r1),
        (c1111, factor * sp.Add(3 * complement * r0, share * sp.Add(r0, 4 * r1))),
        (c3333, factor * 8 * sp.Add(complement * r2, share * r1)),
        (c1122, factor * shear0), (c1133, factor * shear1),
        (c2323, factor * sp.Add(shear1, share * sp.Add(both, 2 * sp.Add(r1, r2)))),
        (c1212, factor * sp.Add(shear0, 2 * share * both)),
    )


def constant_function() -> Function:
    """Emit the six components of one fabric."""
    weighted = tuple((total, sum((integer_moment(j + k) * o for j, o in enumerate(WEIGHTS)), sp.Integer(0)))
                     for k, total in enumerate(SUMS))
    return Function(
        "kinematic_constant", "Six components over (M/V) l_e^2 k_n for contacts that are all equally stiff.",
        (D33, Dr33, nu),
        (*weight_assignments(), *weighted, (complement, 2 - nu), (share, 2 - 2 * nu),
         (factor, 1 / (SCALE * complement)), *component_assignments()), STIFFNESS, unit="-")


@cache
def batch() -> tuple[BatchFunction, ...]:
    """What is emitted for batches."""
    return (BatchFunction(constant_function(), domain(), factor),)


def steps(closed: dict[sp.Symbol, sp.Expr], components: tuple[sp.Expr, ...]) -> tuple[Step, ...]:
    """Show the form for batches, and that it is the closed form again.

    ``closed`` gives the positive moments in the fabric, ``components`` the components in moments and nu.
    """
    known: dict[sp.Symbol, sp.Expr] = {}
    for symbol, expression in weight_assignments():
        known[symbol] = expression.xreplace(known)
    sums = [sum((integer_moment(j + k) * known[o] for j, o in enumerate(WEIGHTS)), sp.Integer(0)) for k in range(3)]
    to_sums = {p: r / (8 * DENOMINATOR) for p, r in zip(POSITIVE_MOMENTS, SUMS, strict=True)}
    found: dict[sp.Symbol, sp.Expr] = {complement: 2 - nu, share: 2 - 2 * nu, factor: 1 / (SCALE * (2 - nu))}
    for symbol, expression in component_assignments():
        found[symbol] = expression.xreplace(found)
    first = sum((integer_moment(j) * o for j, o in enumerate(WEIGHTS)), sp.Integer(0))
    return (
        Step("For very many fabrics at once",
             "Without the coefficient of rank four the moments have integer weights over one denominator, and "
             r"$\lambda$, $\bar\lambda$ share the divisor $2 - \nu$: one division is left. Every sum has terms of one "
             "sign.",
             (rf"8\cdot{DENOMINATOR}\,{latex(POSITIVE_MOMENTS[0])} = {latex(first)}",),
             (*(Claim(sp.expand(total), sp.expand(8 * DENOMINATOR * closed[p]))
                for total, p in zip(sums, POSITIVE_MOMENTS, strict=True)),
              *(Claim(sp.cancel(found[symbol] - expression.xreplace(to_sums)), sp.Integer(0))
                for symbol, expression in zip(STIFFNESS, components, strict=True)))),
    )
