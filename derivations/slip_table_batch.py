"""Partial slip as it is evaluated for very many assemblies: what comes before a table is read, and what comes after."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import sympy as sp

from derivations import batch_constant, batch_kinetic
from derivations.batch_constant import DENOMINATOR, SUMS, WEIGHTS, complement, factor, share
from derivations.kinetic_components import positive_components
from derivations.record import BatchFunction, Claim, Function, Step
from derivations.symbols import D33, POSITIVE_MOMENTS, STIFFNESS, TANGENTIAL_MOMENTS, Dr33, d0, d1, nu, v

LOST = sp.symbols("lost0:6", nonnegative=True)
"""Integrals of s^(5-m) y^m of what slip takes, in units of the mean cube root of the forces."""

LOST_SUMS = sp.symbols("taken0:3", nonnegative=True)
KEPT_SUMS = sp.symbols("kept0:3", nonnegative=True)

sums_factor = sp.Symbol("sums_factor", positive=True)
contrast = sp.Symbol("contrast", real=True)
shear0, shear1, both, scale = sp.symbols("shear0 shear1 both scale", nonnegative=True)


def state_function() -> Function:
    """Emit the sums of the normal stiffness, their factor, and the contrast of the forces."""
    kinetic = batch_kinetic.kinetic_function()
    before = kinetic.assignments[:-len(batch_constant.component_assignments())]
    return Function(
        "slip_state", "The sums of the normal stiffness, their factor, and the cubic contrast of the forces.",
        kinetic.arguments, (*before, (sums_factor, factor), (contrast, v)), (*SUMS, sums_factor, contrast), unit="-",
        series=kinetic.series, notes=kinetic.notes)


def component_function() -> Function:
    """Emit the six components from the sums of the normal stiffness and what slip takes."""
    r, taken, kept = SUMS, LOST_SUMS, KEPT_SUMS
    c1111, c3333, c1122, c1133, c2323, c1212 = STIFFNESS
    sums = tuple((total, scale * sum((LOST[j + k] * o for j, o in enumerate(WEIGHTS)), sp.Integer(0)))
                 for k, total in enumerate(taken))
    return Function(
        "slip_components", "Six components over (M/V) l_e^2 k_n,ref with partial slip.",
        (D33, Dr33, nu, *r, factor, *LOST),
        (*batch_constant.weight_assignments(), (complement, 2 - nu), (share, 2 - 2 * nu),
         (scale, sp.Integer(DENOMINATOR)), *sums,
         *((left, whole - lost) for left, whole, lost in zip(kept, r, taken, strict=True)),
         (shear0, nu * r[0] + share * taken[0]), (shear1, 4 * sp.Add(nu * r[1], share * taken[1])),
         (both, kept[0] + kept[1]),
         (c1111, factor * sp.Add(3 * complement * r[0], share * sp.Add(kept[0], 4 * kept[1]))),
         (c3333, factor * 8 * sp.Add(complement * r[2], share * kept[1])),
         (c1122, factor * shear0), (c1133, factor * shear1),
         (c2323, factor * sp.Add(shear1, share * sp.Add(both, 2 * sp.Add(kept[1], kept[2])))),
         (c1212, factor * sp.Add(shear0, 2 * share * both))),
        STIFFNESS, unit="-", notes="What slip takes is counted in units of the mean cube root of the forces.")


@cache
def batch() -> tuple[BatchFunction, ...]:
    """What is emitted for batches."""
    kinetic, = batch_kinetic.batch()
    return (replace(kinetic, function=state_function()),)


def components_step() -> Step:
    """Show that the components are those of two weights again."""
    lam0 = (2 - 2 * nu) / (2 - nu)
    found: dict[sp.Symbol, sp.Expr] = {factor: 1 / (8 * complement)}
    sums = dict(zip(LOST_SUMS, sp.symbols("l0:3", nonnegative=True), strict=True))
    skipped = {symbol for symbol, _ in batch_constant.weight_assignments()} | set(LOST_SUMS)
    for symbol, expression in component_function().assignments:
        if symbol not in skipped:
            found[symbol] = expression.xreplace(found)
    weights = dict(zip(POSITIVE_MOMENTS, SUMS, strict=True))
    for q, d, r, lost in zip(TANGENTIAL_MOMENTS, (d0, d1, None), SUMS, sums.values(), strict=True):
        weights[q] = lam0 * (r - lost)
        if d is not None:
            weights[d] = nu / (2 - nu) * r + lam0 * lost
    used = sp.sqrt(1 - v**2) ** 3
    return Step(
        "For very many assemblies at once",
        r"In the cubic contrast $\bar v$ of the forces the share of the friction has no other root than that of "
        r"$1-\bar v^2$. A table holds $L_k/\kappa$, what slip takes from the six integrals, in panels of "
        r"$\bar\kappa$ and $\bar v$; with $\lambda_0 = 2(1-\nu)/(2-\nu)$ the components keep one division.",
        (r"L_k = \int_0^1 s^{5-k}x^{2k}\left[f_n^{1/3} - \max\left(f_n - \tfrac{f_r}\mu, 0\right)^{1/3}\right]"
         r"\mathrm{d}x,\qquad \kappa = \frac{|\bar v|(3+\bar v^2)}{\mu(1-\bar v^2)^{3/2}}",),
        (Claim(sp.expand((1 + v) ** 3 - (1 - v) ** 3), sp.expand(2 * v * (3 + v**2))),
         Claim(sp.expand((1 + v) ** 3 * (1 - v) ** 3), sp.expand(used**2)),
         *(Claim(sp.cancel(sp.together(found[symbol].xreplace(sums).subs(complement, 2 - nu)
                                       - expression.xreplace(weights))), sp.Integer(0))
           for symbol, expression in zip(STIFFNESS, positive_components(), strict=True))), result=True)
