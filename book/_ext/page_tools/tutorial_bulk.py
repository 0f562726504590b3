"""The worked example of a new closed form: the bulk modulus that an even strain meets. Not part of the library."""

from __future__ import annotations

from functools import cache

import sympy as sp

from derivations import contact, engineering, kinematic, kinetic_components
from derivations.record import Claim, Derivation, Function, Output, Step
from derivations.symbols import (
    C1111,
    C1122,
    C1133,
    C3333,
    D33,
    D3333,
    Dr33,
    K,
    cos_alpha,
    kn,
    latex,
    p0,
    p1,
    p2,
    sin_alpha,
    sin_beta,
    x,
)

K_even = sp.Symbol("K_even", positive=True)
NAME = r"K_\varepsilon"
"""How K_even is typeset, which derivations.symbols would know."""


def pressed_contact() -> sp.Expr:
    """Stiffness of a contact along its own normal, n_j k_jl n_l."""
    along = (contact.NORMAL.T * contact.stiffness() * contact.NORMAL)[0]
    cosines = {sin_beta: sp.sqrt(1 - x**2), sin_alpha: sp.sqrt(1 - cos_alpha**2)}
    return sp.expand(along.subs(cosines))


def of_components(six: tuple[sp.Expr, ...]) -> sp.Expr:
    """C_iijj/9: mean pressure over the volumetric strain."""
    c1111, c3333, c1122, c1133, _, _ = six
    return sp.expand((2 * c1111 + c3333 + 2 * c1122 + 4 * c1133) / 9)


def closed_form() -> sp.Expr:
    """K_even over (M/V) l_e^2 k_n for contacts that are alike."""
    bracket = sp.Rational(1, 5) + sp.Rational(2, 35) * (D33 + D3333)
    return (1 + Dr33 * (2 * D33 / 5 + Dr33 * bracket)) / 9


def less_under_pressure() -> sp.Expr:
    """How much smaller the bulk modulus under equal pressure is."""
    gap = 2 * (C1111 + C1122 - C1133 - C3333) ** 2
    return gap / (9 * (C1111 + C1122 + 2 * C3333 - 4 * C1133))


def steps() -> tuple[Step, ...]:
    """The way from one contact to the closed form."""
    alike = dict(zip((p0, p1, p2), kinematic.closed_moments(), strict=True))
    sum_of_moments = (p0 + 2 * p1 + p2) / 9
    under_pressure = engineering.constants()[-1]
    stiffness = (C1111, C3333, C1122, C1133, sp.S.Zero, sp.S.Zero)
    return (
        Step("A contact under an even strain",
             "Strained alike on all sides, a contact is pressed along its branch. As that follows the normal, the "
             "tangential stiffness does no work.",
             (r"n_jk_{jl}n_l = k_n",), (Claim(pressed_contact(), kn),)),
        Step("Sum over the contacts",
             "The mean pressure over the volumetric strain is a ninth of $C_{iijj}$. Of the moments it keeps one "
             "sum, since $s + x^2 = 1$.",
             (rf"{NAME} = \tfrac19 C_{{iijj}} = \tfrac19\frac{{M}}{{V}}\ell_e^2k_n\,({latex(p0 + 2 * p1 + p2)})",),
             (Claim(of_components(kinematic.components()), sp.expand(kn * sum_of_moments)),)),
        Step("Friction does not enter",
             "Where forces differ from contact to contact, $k_n$ goes under the average and $k_r$ is not there. Slip "
             "leaves this modulus as it is, until contacts open.",
             (rf"{NAME} = \tfrac19\frac{{M}}{{V}}\ell_e^2\,\bigl\langle 4\pi E\,W^2 k_n\bigr\rangle",),
             (Claim(of_components(kinetic_components.components()), sum_of_moments),)),
        Step("Contacts that are all alike",
             "The moments are polynomials in the fabric. Without branch "
             "anisotropy contact normals do not change it.",
             (rf"\frac{{9\,{NAME}}}{{(M/V)\,\ell_e^2k_n}} = "
              rf"1 + \tfrac25{latex(D33)}{latex(Dr33)} + \bigl(\tfrac15 + "
              rf"\tfrac2{{35}}({latex(D33)} + {latex(D3333)})\bigr)"
              rf"\bigl({latex(Dr33)}\bigr)^2",),
             (Claim(sum_of_moments.xreplace(alike), closed_form()),
              Claim(closed_form().subs(Dr33, 0), sp.Rational(1, 9))),
             result=True),
        Step("Against equal pressure",
             "Under equal pressure the sides may strain differently, and the bulk modulus $K$ is smaller: by a square, "
             "which is zero where the pressure strains all sides alike.",
             (rf"{NAME} - {latex(K)} = {latex(less_under_pressure())}",),
             (Claim(sp.factor(of_components(stiffness) - under_pressure), less_under_pressure()),)),
    )


@cache
def even_bulk() -> Derivation:
    """Derive the bulk modulus that an even strain meets."""
    emitted = Function(
        name="even_bulk",
        summary="Bulk modulus under an even strain over (M/V) l_e^2 k_n.",
        arguments=(D33, D3333, Dr33),
        assignments=((K_even, closed_form()),),
        returns=(K_even,),
    )
    return Derivation(
        name="even_bulk",
        title="Bulk modulus under an even strain",
        sources=("(4)", "(7)"),
        assumptions=kinematic.ASSUMPTIONS,
        domain=kinematic.DOMAIN[:2],
        inputs=(D33, D3333, Dr33),
        outputs=(Output(K_even, closed_form()),),
        steps=steps(),
        functions=(emitted,),
    )
