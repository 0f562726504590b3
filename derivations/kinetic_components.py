"""Components when normal and tangential stiffness vary differently over the directions: each has moments of its own."""

from __future__ import annotations

from functools import cache

import sympy as sp

from derivations import contact, kinematic, static
from derivations.fabric import fabric_tensor
from derivations.record import Claim, Derivation, Function, Output, Step
from derivations.symbols import (
    COMPLIANCE,
    D33,
    N11,
    N33,
    NORMAL_FLEXIBILITIES,
    POSITIVE_MOMENTS,
    S2323,
    STIFFNESS,
    TANGENTIAL_FLEXIBILITIES,
    TANGENTIAL_MOMENTS,
    d0,
    d1,
    g0,
    g1,
    kn,
    kr,
    latex,
    p0,
    p1,
    p2,
    q0,
    q1,
    q2,
    u0,
    u1,
    u2,
    v0,
    v1,
    v2,
)

NORMAL_LESS_TANGENTIAL = {d0: p0 - q0, d1: p1 - q1}
TANGENTIAL_LESS_NORMAL = {g0: v0 - u0, g1: v1 - u1}

BULK = u0 * u2 + v1 * (u0 + u1 + u2) + u1 * g1
SHEAR = u0 + v0 + 2 * v1

fifteen_N11, fifteen_N33, A11, A33 = sp.symbols("fifteen_N11 fifteen_N33 A11 A33", positive=True)
delta, shear_sum, vertical = sp.symbols("delta shear_sum eight_S2323", positive=True)


def averaged_apart(component: sp.Expr, normal: sp.Expr, tangential: sp.Expr, for_normal: tuple[sp.Symbol, ...],
                   for_tangential: tuple[sp.Symbol, ...]) -> sp.Expr:
    """Give each contact stiffness its own moments.

    The component is linear in the moments and in k_n, k_r (or their inverses), so that a stiffness which varies from
    direction to direction goes under the average: k_n p_j becomes one moment, k_r p_j another.
    """
    expanded = sp.expand(component)
    return sp.expand(sum(
        (expanded.coeff(stiffness).xreplace(dict(zip(POSITIVE_MOMENTS, own, strict=True)))
         for stiffness, own in ((normal, for_normal), (tangential, for_tangential))), sp.Integer(0)))


def components() -> tuple[sp.Expr, ...]:
    """Six components over (M/V) l_e^2 in the moments of E W^2 k_n and of E W^2 k_r."""
    return tuple(averaged_apart(c, kn, kr, POSITIVE_MOMENTS, TANGENTIAL_MOMENTS) for c in kinematic.equal_tangents())


def positive_components() -> tuple[sp.Expr, ...]:
    """The same with no subtraction: where k_n - k_r enters it has moments of its own."""
    return (3 * p0 / 8 + (q0 / 8 + q1 / 2), p2 + q1, d0 / 8, d1 / 2, d1 / 2 + (q0 / 8 + 3 * q1 / 8 + q2 / 4),
            d0 / 8 + (q0 + q1) / 4)


def compliance() -> tuple[sp.Expr, ...]:
    """Six compliance components times (M/V) l_e^2 in the moments of E W^-2/k_n and of E W^-2/k_r."""
    equal = (c.subs(contact.TO_EQUAL_TANGENTS) for c in static.components())
    return tuple(averaged_apart(c, 1 / kn, 1 / kr, NORMAL_FLEXIBILITIES, TANGENTIAL_FLEXIBILITIES) for c in equal)


def positive_compliance() -> tuple[sp.Expr, ...]:
    """The same with 1/k_r - 1/k_n under averages of its own."""
    return (
        (3 * u0 / 8 + (v0 / 8 + v1 / 2)) / N11**2,
        (u2 + v1) / N33**2,
        -g0 / (8 * N11**2),
        -g1 / (2 * N11 * N33),
        ((u1 + v0) / N11**2 + (u1 + 2 * v2 + v1) / N33**2 - 2 * g1 / (N11 * N33)) / 8,
        (u0 / 4 + v0 / 4 + v1 / 2) / (2 * N11**2),
    )


def positive_stiffness(bulk: sp.Expr = BULK, shear: sp.Expr = SHEAR) -> tuple[sp.Expr, ...]:
    """The inverse of the compliance with no subtraction outside the vertical shear."""
    c1212 = 2 * N11**2 / shear
    c1122 = N11**2 * ((u2 + v1) * g0 + 2 * g1**2) / (bulk * shear)
    return (c1122 + 2 * c1212, N33**2 * (u0 + v1) / bulk, c1122, N11 * N33 * g1 / bulk,
            1 / (4 * positive_compliance()[4]), c1212)


def _kinematic_steps() -> tuple[Step, ...]:
    apart = components()
    return (
        Step("Two weights",
             r"With contact forces $k_n$ and $k_r$ vary over the directions, and with slip they vary differently. "
             "Eq. (7) is linear in both, so each component needs three moments of either: $p_j$ with $k_n$, $q_j$ with "
             "$k_r$.",
             (r"p_j = \langle E W^2 k_n s^{2-j}x^{2j}\rangle,\quad q_j = \langle E W^2 k_r s^{2-j}x^{2j}\rangle,\quad "
              r"d_j = \langle E W^2 (k_n - k_r) s^{2-j}x^{2j}\rangle",
              *(f"{latex(symbol)} = {latex(e)}" for symbol, e in zip(STIFFNESS, apart, strict=True))),
             tuple(Claim(kn * e.subs(dict(zip(TANGENTIAL_MOMENTS, POSITIVE_MOMENTS, strict=True))), whole.subs(kr, kn))
                   for e, whole in zip(apart, kinematic.equal_tangents(), strict=True))),
        Step("No subtraction",
             "Where the difference of the two stiffnesses enters it is averaged as itself; then every component is a "
             "sum of non-negative terms, and nothing is lost when a contact hardly yields sideways more than along its "
             "normal.",
             tuple(f"{latex(symbol)} = {latex(e)}" for symbol, e in zip(STIFFNESS, positive_components(), strict=True)),
             tuple(Claim(e.xreplace(NORMAL_LESS_TANGENTIAL), whole)
                   for e, whole in zip(positive_components(), apart, strict=True)), result=True),
        Step("A check without the tangential stiffness",
             "The response to isotropic compression does not shear any contact, with slip or without.",
             (r"C_{3333} + 2C_{1111} + 2C_{1122} + 4C_{1133} = \langle E W^2 k_n\rangle",),
             (Claim(sum(f * e for f, e in zip((2, 1, 2, 4), apart[:4], strict=True)), p0 + 2 * p1 + p2),)),
    )


def _static_steps() -> tuple[Step, ...]:
    apart = compliance()
    exact = static.inverse(apart)
    symbols = (sp.Symbol("Delta"), sp.Symbol("Sigma"))
    *stretching, _, horizontal = positive_stiffness(*symbols)
    shown = (*stretching, 1 / (4 * S2323), horizontal)
    return (
        Step("Two flexibilities",
             "The compliance is linear in $1/k_n$ and $1/k_r$, which are averaged apart in the same way: $u_j$, $v_j$ "
             "and, for the difference, $g_j$.",
             (r"u_j = \Bigl\langle \frac{E}{W^2 k_n} s^{2-j}x^{2j}\Bigr\rangle,\quad "
              r"v_j = \Bigl\langle \frac{E}{W^2 k_r} s^{2-j}x^{2j}\Bigr\rangle,\quad "
              r"g_j = \Bigl\langle \frac{E}{W^2}\Bigl(\frac1{k_r}-\frac1{k_n}\Bigr) s^{2-j}x^{2j}\Bigr\rangle",
              *(f"{latex(symbol)} = {latex(e)}" for symbol, e in zip(COMPLIANCE, positive_compliance(), strict=True))),
             tuple(Claim(sp.expand(e.xreplace(TANGENTIAL_LESS_NORMAL)), whole)
                   for e, whole in zip(positive_compliance(), apart, strict=True)), result=True),
        Step("Stiffness in positive form",
             r"With $\Delta$ and $\Sigma$ as below the inverse has no subtraction outside the vertical shear.",
             (rf"\Delta = {latex(BULK)},\quad \Sigma = {latex(SHEAR)}",
              *(f"{latex(symbol)} = {latex(e)}" for symbol, e in zip(STIFFNESS, shown, strict=True))),
             tuple(Claim(sp.cancel(sp.together(e.xreplace(TANGENTIAL_LESS_NORMAL) - f)), sp.Integer(0))
                   for e, f in zip(positive_stiffness(), exact, strict=True)), result=True),
    )


def _tensor_assignments() -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
    n11, n33 = fabric_tensor()
    return (fifteen_N11, sp.expand(15 * n11)), (fifteen_N33, sp.expand(15 * n33))


def functions() -> tuple[Function, ...]:
    """Emit stiffness and compliance; + - * / only, so that exact fractions give exact components."""
    c1111, c3333, c1122, c1133, c2323, c1212 = STIFFNESS
    tensors = {N11: 1 / A11, N33: 1 / A33}
    flexibilities = (*NORMAL_FLEXIBILITIES, *TANGENTIAL_FLEXIBILITIES, g0, g1, D33)
    return (
        Function(
            "stiffness_from_weights",
            "Six components over (M/V) l_e^2 k_n,ref from moments of E W^2 k_n, E W^2 k_r and E W^2 (k_n - k_r).",
            (*POSITIVE_MOMENTS, *TANGENTIAL_MOMENTS, d0, d1),
            tuple(zip(STIFFNESS, positive_components(), strict=True)), STIFFNESS, unit="-",
            notes="All contact stiffnesses over k_n,ref."),
        Function(
            "compliance_from_weights",
            "Six compliances times (M/V) l_e^2 k_n,ref from moments of E W^-2/k_n, E W^-2/k_r and their difference.",
            flexibilities,
            (*_tensor_assignments(), (A11, 15 / fifteen_N11), (A33, 15 / fifteen_N33),
             *((symbol, e.xreplace(tensors)) for symbol, e in zip(COMPLIANCE, positive_compliance(), strict=True))),
            COMPLIANCE, unit="-", notes="All contact flexibilities times k_n,ref."),
        Function(
            "stiffness_from_flexibilities",
            "Six components over (M/V) l_e^2 k_n,ref from moments of E W^-2/k_n, E W^-2/k_r and their difference.",
            flexibilities,
            (*_tensor_assignments(), (delta, BULK), (shear_sum, SHEAR),
             (vertical, (u1 + v0) / fifteen_N11**2 + (u1 + 2 * v2 + v1) / fifteen_N33**2
              - 2 * g1 / (fifteen_N11 * fifteen_N33)),
             (c1212, 2 * fifteen_N11**2 / (225 * shear_sum)),
             (c1122, fifteen_N11**2 * ((u2 + v1) * g0 + 2 * g1**2) / (225 * delta * shear_sum)),
             (c1111, c1122 + 2 * c1212),
             (c3333, fifteen_N33**2 * (u0 + v1) / (225 * delta)),
             (c1133, fifteen_N11 * fifteen_N33 * g1 / (225 * delta)),
             (c2323, 2 / (225 * vertical))),
            STIFFNESS, unit="-", notes="All contact flexibilities times k_n,ref."),
    )


@cache
def kinetic_components() -> Derivation:
    """Derive stiffness and compliance from separate moments of the normal and the tangential contact stiffness."""
    n11, n33 = fabric_tensor()
    return Derivation(
        name="kinetic_components",
        title="Stiffness with contact stiffnesses that vary over the directions",
        sources=("(2)", "(7)", "(23)", "(24)", "Figure 1(b)"),
        assumptions=(
            "Every contact displaces with the mean strain (kinematic), or carries its share of the mean stress "
            "(static).",
            "Branch vectors are parallel to contact normals.",
            "Contact stiffness depends on the direction alone; tangentially it is the same in all directions.",
        ),
        domain=("k_n > 0 and k_r >= 0", "flexibilities: k_r > 0 in every direction", "-1 <= D33 <= 2"),
        inputs=(*POSITIVE_MOMENTS, *TANGENTIAL_MOMENTS, d0, d1,
                *NORMAL_FLEXIBILITIES, *TANGENTIAL_FLEXIBILITIES, g0, g1, D33),
        outputs=(*(Output(symbol, e) for symbol, e in zip(STIFFNESS, positive_components(), strict=True)),
                 *(Output(symbol, e.xreplace({N11: n11, N33: n33}))
                   for symbol, e in zip(COMPLIANCE, positive_compliance(), strict=True))),
        steps=(*_kinematic_steps(), *_static_steps()),
        functions=functions(),
    )
