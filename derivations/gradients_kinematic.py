"""Components and their slopes under the kinematic hypothesis, in moments that are all positive.

With L_m = <s^(6-m) x^(2m) (a s + c x^2)^(-2/3)> and S_k = <E W^2 s^(3-k) x^(2k) (a s + c x^2)^(-2/3)> the moments of
the normal stiffness are p_k = a S_k + c S_(k+1), because the normal force is a S + c y times itself to the power 0;
their slopes by the forces are S_k/3 and S_(k+1)/3. One family of seven integrals gives values and slopes.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from derivations.fabric import BRANCH_FORM
from derivations.forward import Assignments, Partials, slope_of, with_slopes
from derivations.kinematic import LAM, ONE_MINUS_LAM, positive_components
from derivations.record import Function
from derivations.sphere import axial_moment
from derivations.symbols import (
    D33,
    POSITIVE_MOMENTS,
    SR,
    STIFFNESS,
    Dr33,
    a,
    c,
    e0,
    e1,
    lam,
    nu,
    one_minus_lam,
    w0,
    w1,
)

FORCE_MOMENTS = sp.symbols("L0:7", positive=True)
"""<s^(6-m) x^(2m) (a s + c x^2)^(-2/3)>."""

OMEGA = sp.symbols("omega0:4", nonnegative=True)
"""Coefficients of E W^2 in s^3, s^2 y, s y^2, y^3, for a density of rank two."""

WEIGHTED = sp.symbols("S0:4", positive=True)

DENSITY_OF_RANK_TWO = ((e0, 1 - D33 / 2), (e1, 1 + D33))
BRANCHES = tuple(zip((w0, w1), BRANCH_FORM, strict=True))
FORCES = ((a, 15 / ((2 + SR) * (5 - D33))), (c, 15 * SR / ((2 + SR) * (5 + 2 * D33))))
"""Normal force at equator and pole over that of the isotropic assembly, eq. (23)."""

FORCE_PARTIALS = {a: {D33: a / (5 - D33), SR: -a / (2 + SR)},
                  c: {D33: -2 * c / (5 + 2 * D33), SR: 2 * c / (SR * (2 + SR))}}
"""Slopes of the forces in terms of the forces."""

FABRIC = (*DENSITY_OF_RANK_TWO, *BRANCHES,
          (OMEGA[0], e0 * w0**2), (OMEGA[1], w0 * (2 * e0 * w1 + e1 * w0)), (OMEGA[2], w1 * (e0 * w1 + 2 * e1 * w0)),
          (OMEGA[3], e1 * w1**2))


def components() -> Assignments:
    """Six components from the moments of the normal stiffness, no contact slipping."""
    return (lam, LAM), (one_minus_lam, ONE_MINUS_LAM), *zip(STIFFNESS, positive_components(), strict=True)


LAM_PARTIALS = {lam: {nu: -2 / (2 - nu) ** 2}, one_minus_lam: {nu: 2 / (2 - nu) ** 2}}


def constant() -> Assignments:
    """From the fabric to the components, every contact equally stiff."""
    moments: list[tuple[sp.Symbol, sp.Expr]] = []
    for k, p in enumerate(POSITIVE_MOMENTS):
        total = sp.Symbol(f"sum{k}", positive=True)
        numerator, denominator = sp.fraction(sp.together(
            sum((o * axial_moment(5 - j - k, j + k) for j, o in enumerate(OMEGA)), sp.Integer(0))))
        moments += [(total, numerator), (p, total / denominator)]
    return *FABRIC, *moments, *components()


def kinetic() -> Assignments:
    """From fabric, stress ratio and the seven integrals to the components, no contact slipping."""
    return *kinetic_moments(), *components()


def kinetic_moments() -> Assignments:
    """From fabric, stress ratio and the seven integrals to the moments of the normal stiffness."""
    weighted = tuple((S, sum((o * FORCE_MOMENTS[j + k] for j, o in enumerate(OMEGA)), sp.Integer(0)))
                     for k, S in enumerate(WEIGHTED))
    moments = tuple((p, a * WEIGHTED[k] + c * WEIGHTED[k + 1]) for k, p in enumerate(POSITIVE_MOMENTS))
    return *FABRIC, *FORCES, *weighted, *moments


def kinetic_partials() -> dict[sp.Symbol, dict[sp.Symbol, sp.Expr]]:
    """How the moments follow the forces and the fabric: the integrals themselves change with the forces too."""
    partials: dict[sp.Symbol, dict[sp.Symbol, sp.Expr]] = {**FORCE_PARTIALS, **LAM_PARTIALS}
    for k, p in enumerate(POSITIVE_MOMENTS):
        S, following = WEIGHTED[k], WEIGHTED[k + 1]
        partials[p] = {a: S / 3, c: following / 3, S: a, following: c}
    return partials


def moment_slopes(name: str, summary: str, integrals: tuple[sp.Symbol, ...], results: tuple[sp.Symbol, ...],
                  assignments: Assignments, partials: Mapping[sp.Symbol, Partials], notes: str) -> Function:
    """Emit three moments and their slopes: all three by D33, then by Dr33, then by SR."""
    variables = (D33, Dr33, SR)
    carried = with_slopes(assignments, variables, partials=partials)
    slopes = tuple(slope_of(carried, moment, variable) for variable in variables for moment in results)
    return Function(name, summary, (*variables, *integrals), carried, (*results, *slopes), unit="-", notes=notes)


FORCE_NOTES = "L0 ... L6 are the integrals of s^(6-m) x^(2m) (a s + c x^2)^(-2/3) over x from 0 to 1."


def normal_moments() -> Function:
    """Emit the moments of the normal stiffness and their slopes, for contacts that slip against friction."""
    return moment_slopes(
        "normal_moments", "Moments of E W^2 k_n over k_n,ref and their slopes by D33, Dr33 and SR.",
        FORCE_MOMENTS, POSITIVE_MOMENTS, kinetic_moments(), kinetic_partials(), FORCE_NOTES)


def gradient(name: str, summary: str, arguments: tuple[sp.Symbol, ...], variables: tuple[sp.Symbol, ...],
             assignments: Assignments, notes: str = "") -> Function:
    """Emit the components and their slopes: all six by the first variable, then by the next."""
    slopes = tuple(slope_of(assignments, component, variable) for variable in variables for component in STIFFNESS)
    return Function(name, summary, arguments, assignments, (*STIFFNESS, *slopes), unit="-", notes=notes)


def constant_gradient() -> Function:
    """Emit components and slopes for constant contact stiffness."""
    variables = (D33, Dr33, nu)
    return gradient(
        "kinematic_constant_gradient",
        "Six components over (M/V) l_e^2 k_n and their slopes by D33, Dr33 and nu, every contact equally stiff.",
        variables, variables, with_slopes(constant(), variables, partials=LAM_PARTIALS))


def kinetic_gradient() -> Function:
    """Emit components and slopes for stiffnesses that follow the contact forces."""
    variables = (D33, Dr33, SR, nu)
    return gradient(
        "kinematic_kinetic_gradient",
        "Six components over (M/V) l_e^2 k_n,ref and their slopes by D33, Dr33, SR and nu, no contact slipping.",
        (*variables, *FORCE_MOMENTS), variables,
        with_slopes(kinetic(), variables, partials=kinetic_partials()),
        notes=FORCE_NOTES)
