"""Components and their slopes under the static hypothesis, in moments that are all positive.

With T_m = <s^(5-m) x^(2m) W^-3 (a s + c x^2)^(-4/3)> the moments of the normal flexibility are two steps up, one with
a S + c y and one with W = w0 s + w1 y; every slope of them is a sum of T_m as well. The stiffness is the inverse of
the compliance, so its slope is -C S' C, written out here from the positive form of the inverse.
"""

from __future__ import annotations

import sympy as sp

from derivations.forward import Assignments, slope_symbol, with_slopes
from derivations.gradients_kinematic import (
    BRANCHES,
    DENSITY_OF_RANK_TWO,
    FORCE_PARTIALS,
    FORCES,
    LAM_PARTIALS,
    gradient,
    moment_slopes,
)
from derivations.kinematic import LAM, ONE_MINUS_LAM
from derivations.kinetic_components import functions as component_functions
from derivations.record import Function
from derivations.symbols import (
    D33,
    NORMAL_FLEXIBILITIES,
    SR,
    STIFFNESS,
    TANGENTIAL_FLEXIBILITIES,
    Dr33,
    a,
    c,
    e0,
    e1,
    g0,
    g1,
    lam,
    nu,
    one_minus_lam,
    w0,
    w1,
)

SHORT_MOMENTS = sp.symbols("H0:5", positive=True)
"""<s^(4-m) x^(2m) W^-3>."""

SOFT_MOMENTS = sp.symbols("T0:6", positive=True)
"""<s^(5-m) x^(2m) W^-3 (a s + c x^2)^(-4/3)>."""

Z = sp.symbols("Z0:5", positive=True)
"""<E s^(4-k) x^(2k) W^-3 (a s + c x^2)^(-4/3)>."""

Y = sp.symbols("Y0:4", positive=True)
"""<E s^(3-k) x^(2k) W^-3> times (a s + c x^2)^(-1/3), or times 1."""

FLEXIBILITIES = (*NORMAL_FLEXIBILITIES, *TANGENTIAL_FLEXIBILITIES, g0, g1)
DIRECTION = sp.Symbol("t", real=True)
"""Stands for any variable in the slope of the inverse."""


def _inverse() -> Assignments:
    """The stiffness from moments of the flexibilities, in positive form."""
    return component_functions()[2].assignments


def _equal_tangents() -> Assignments:
    """Moments of the tangential flexibility, and how far they exceed the normal one, for k_r = lambda k_n."""
    return ((lam, LAM), (one_minus_lam, ONE_MINUS_LAM),
            *((v, u / lam) for u, v in zip(NORMAL_FLEXIBILITIES, TANGENTIAL_FLEXIBILITIES, strict=True)),
            *((g, one_minus_lam * v) for g, v in zip((g0, g1), TANGENTIAL_FLEXIBILITIES, strict=False)))


def _weighted(results: tuple[sp.Symbol, ...], integrals: tuple[sp.Symbol, ...]) -> Assignments:
    """Average with the density: e0 s + e1 y."""
    return tuple((result, e0 * integrals[k] + e1 * integrals[k + 1]) for k, result in enumerate(results))


def _branches() -> Assignments:
    """Moments of the normal flexibility from Y."""
    return tuple((u, w0 * Y[k] + w1 * Y[k + 1]) for k, u in enumerate(NORMAL_FLEXIBILITIES))


def constant() -> Assignments:
    """From the fabric to the components, every contact equally stiff."""
    return *DENSITY_OF_RANK_TWO, *BRANCHES, *_weighted(Y, SHORT_MOMENTS), *_branches(), *_equal_tangents(), *_inverse()


def kinetic() -> Assignments:
    """From fabric, stress ratio and six integrals to the components, no contact slipping."""
    return *kinetic_moments(), *_equal_tangents(), *_inverse()


def kinetic_moments() -> Assignments:
    """From fabric, stress ratio and six integrals to the moments of the normal flexibility."""
    forces = tuple((y, a * Z[k] + c * Z[k + 1]) for k, y in enumerate(Y))
    return *DENSITY_OF_RANK_TWO, *BRANCHES, *FORCES, *_weighted(Z, SOFT_MOMENTS), *forces, *_branches()


def _density_partials(results: tuple[sp.Symbol, ...],
                      integrals: tuple[sp.Symbol, ...]) -> dict[sp.Symbol, dict[sp.Symbol, sp.Expr]]:
    return {result: {e0: integrals[k], e1: integrals[k + 1]} for k, result in enumerate(results)}


def constant_partials() -> dict[sp.Symbol, dict[sp.Symbol, sp.Expr]]:
    """How the moments follow the branch lengths: 1/W^2 by W is -2/W^3."""
    return {**LAM_PARTIALS, **_density_partials(Y, SHORT_MOMENTS),
            **{u: {w0: -2 * Y[k], w1: -2 * Y[k + 1], Y[k]: w0, Y[k + 1]: w1}
               for k, u in enumerate(NORMAL_FLEXIBILITIES)}}


def kinetic_partials() -> dict[sp.Symbol, dict[sp.Symbol, sp.Expr]]:
    """How the moments follow forces, branch lengths and density; forces enter to the power -1/3."""
    partials = {**constant_partials(), **FORCE_PARTIALS, **_density_partials(Z, SOFT_MOMENTS)}
    for k, y in enumerate(Y):
        partials[y] = {Z[k]: a, Z[k + 1]: c}
    for k, u in enumerate(NORMAL_FLEXIBILITIES):
        partials[u] |= {a: -(w0 * Z[k] + w1 * Z[k + 1]) / 3, c: -(w0 * Z[k + 1] + w1 * Z[k + 2]) / 3}
    return partials


SOFT_NOTES = "T0 ... T5 are the integrals of s^(5-m) x^(2m) W^-3 (a s + c x^2)^(-4/3) over x from 0 to 1."


def constant_gradient() -> Function:
    """Emit components and slopes for constant contact stiffness."""
    variables = (D33, Dr33, nu)
    return gradient(
        "static_constant_gradient",
        "Six static components over (M/V) l_e^2 k_n and their slopes by D33, Dr33 and nu, every contact equally stiff.",
        (*variables, *SHORT_MOMENTS), variables,
        with_slopes(constant(), variables, partials=constant_partials()),
        notes="H0 ... H4 are the integrals of s^(4-m) x^(2m) / W^3 over x from 0 to 1.")


def kinetic_gradient() -> Function:
    """Emit components and slopes for stiffnesses that follow the contact forces."""
    variables = (D33, Dr33, SR, nu)
    return gradient(
        "static_kinetic_gradient",
        "Six static components over (M/V) l_e^2 k_n,ref and their slopes by D33, Dr33, SR and nu, no contact slipping.",
        (*variables, *SOFT_MOMENTS), variables,
        with_slopes(kinetic(), variables, partials=kinetic_partials()),
        notes=SOFT_NOTES)


def normal_moments() -> Function:
    """Emit the moments of the normal flexibility and their slopes, for contacts that slip against friction."""
    return moment_slopes(
        "soft_moments", "Moments of E W^-2/k_n times k_n,ref and their slopes by D33, Dr33 and SR.",
        SOFT_MOMENTS, NORMAL_FLEXIBILITIES, kinetic_moments(), kinetic_partials(), SOFT_NOTES)


def inverse_slope() -> Function:
    """Emit the slope of the stiffness along any direction in which the flexibilities change."""
    changing = (*FLEXIBILITIES, D33)
    slopes = {(symbol, DIRECTION): slope_symbol(symbol, DIRECTION) for symbol in changing}
    assignments = with_slopes(_inverse(), (DIRECTION,), slopes=slopes)
    return Function(
        "static_slope",
        "Slope of the six static components along a direction in which flexibilities and fabric change.",
        (*changing, *slopes.values()), assignments,
        tuple(slope_symbol(component, DIRECTION) for component in STIFFNESS), unit="-",
        notes="A name that ends in _t is the slope of that quantity along the direction.")
