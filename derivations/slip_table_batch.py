"""Partial slip as it is evaluated for very many assemblies: what comes before a table is read, and what comes after."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import sympy as sp

from derivations import batch_kinetic
from derivations.batch_constant import (
    DENOMINATOR,
    SUMS,
    density_assignments,
    level,
    ratio_assignments,
    square_assignments,
    substituted,
    sum_assignments,
)
from derivations.kinetic_components import positive_components
from derivations.record import BatchFunction, Claim, Function, Step
from derivations.symbols import (
    D33,
    POSITIVE_MOMENTS,
    STIFFNESS,
    TANGENTIAL_MOMENTS,
    Dr33,
    d0,
    d1,
    lam,
    one_minus_lam,
    v,
)

LOST = sp.symbols("lost0:6", nonnegative=True)
"""Integrals of s^(5-m) y^m of what slip takes, in units of the mean cube root of the forces."""

LOST_DENSITY = sp.symbols("lost_density0:5", nonnegative=True)
LOST_SUMS = sp.symbols("taken0:3", nonnegative=True)
KEPT_SUMS = sp.symbols("kept0:3", nonnegative=True)

shear0, shear1, quarter, both, later, along, whole = sp.symbols(
    "shear0 shear1 quarter both later along whole", nonnegative=True)


def state_function() -> Function:
    """Emit the sums of the normal stiffness, their level, the contrast of the forces, and what Poisson's ratio does."""
    kinetic = batch_kinetic.kinetic_function()
    return Function(
        "slip_state", "The sums of the normal stiffness, their level, the cubic contrast of the forces, 1 - k_r/k_n.",
        kinetic.arguments, batch_kinetic.sums_of_forces(), (*SUMS, level, v, one_minus_lam), unit="-",
        series=kinetic.series, notes=kinetic.notes)


def component_function() -> Function:
    """Emit the six components from the sums of the normal stiffness and what slip takes."""
    r, taken, kept = SUMS, LOST_SUMS, KEPT_SUMS
    c1111, c3333, c1122, c1133, c2323, c1212 = STIFFNESS
    return Function(
        "slip_components", "Six components over (M/V) l_e^2 k_n,ref with partial slip.",
        (D33, Dr33, *r, level, one_minus_lam, *LOST),
        (*density_assignments(LOST, LOST_DENSITY), (whole, DENOMINATOR * level), *square_assignments(whole),
         *sum_assignments(taken, LOST_DENSITY), (lam, 1 - one_minus_lam),
         *((left, all_ - lost) for left, all_, lost in zip(kept, r, taken, strict=True)),
         (shear0, one_minus_lam * r[0] + lam * taken[0]), (quarter, one_minus_lam * r[1] + lam * taken[1]),
         (shear1, 4 * quarter), (both, kept[0] + kept[1]), (later, kept[1] + kept[2]), (along, r[2] + lam * kept[1]),
         (c1111, 3 * r[0] + lam * sp.Add(kept[0], 4 * kept[1])), (c3333, 8 * along),
         (c1122, shear0), (c1133, shear1),
         (c2323, shear1 + lam * sp.Add(both, 2 * later)), (c1212, shear0 + 2 * lam * both)),
        STIFFNESS, unit="-", notes="What slip takes is counted in units of the mean cube root of the forces.")


@cache
def batch() -> tuple[BatchFunction, ...]:
    """What is emitted for batches."""
    kinetic, = batch_kinetic.batch()
    return (replace(kinetic, function=state_function(), apart=True),)


def components_step() -> Step:
    """Show that the components are those of two weights again."""
    ratio = substituted(ratio_assignments())[one_minus_lam]
    found: dict[sp.Symbol, sp.Expr] = {one_minus_lam: ratio}
    assigned = [symbol for symbol, _ in component_function().assignments]
    for symbol, expression in component_function().assignments[assigned.index(LOST_SUMS[-1]) + 1:]:
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
         *(Claim(sp.cancel(sp.together(found[symbol] - expression.xreplace(weights))), sp.Integer(0))
           for symbol, expression in zip(STIFFNESS, positive_components(), strict=True))), result=True)
