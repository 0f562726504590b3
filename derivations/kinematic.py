"""Stiffness of an assembly with constant contact stiffness under the kinematic hypothesis, eqs (4) and (7)."""

from __future__ import annotations

from functools import cache

import sympy as sp

from derivations import batch_constant, contact
from derivations.axial_components import six_components
from derivations.fabric import BRANCH_FORM, DENSITY_FORM, branch_form, density_form
from derivations.record import Claim, Derivation, Function, Output, Step
from derivations.sphere import axial_mean, axial_moment, homogeneous
from derivations.symbols import (
    D33,
    D3333,
    POSITIVE_MOMENTS,
    STIFFNESS,
    Dr33,
    cos_alpha,
    e0,
    e1,
    e2,
    kn,
    kr,
    ks,
    kt,
    lam,
    latex,
    m0,
    m1,
    m2,
    nu,
    one_minus_lam,
    p0,
    p1,
    p2,
    s,
    sin_alpha,
    sin_beta,
    w0,
    w1,
    x,
    y,
)

TO_POWER_MOMENTS = {p0: m0 - 2 * m1 + m2, p1: m1 - m2, p2: m2}
"""<rho s^2>, <rho s y>, <rho y^2> in the moments m_k = <rho x^(2k)>."""

LAM = sp.Mul(2, 1 - nu, 1 / (2 - nu))
ONE_MINUS_LAM = nu / (2 - nu)

WEIGHT_SYMBOLS = sp.symbols("omega0:5", real=True)
"""Coefficients of E W^2 as a form of degree four in s and y."""


def components() -> tuple[sp.Expr, ...]:
    """Six components over (M/V) l_e^2 in the positive moments, for k_n, k_s, k_t distinct."""
    n, k = contact.NORMAL, contact.stiffness()
    return six_components(lambda i, j, q, m: n[i] * k[j, m] * n[q])


def equal_tangents() -> tuple[sp.Expr, ...]:
    """The same with k_s = k_t = k_r."""
    return tuple(sp.expand(c.subs(contact.TO_EQUAL_TANGENTS)) for c in components())


def positive_components() -> tuple[sp.Expr, ...]:
    """Six components over (M/V) l_e^2 k_n with no subtraction: lambda and 1 - lambda stand side by side."""
    return (
        3 * p0 / 8 + lam * (p0 / 8 + p1 / 2),
        p2 + lam * p1,
        one_minus_lam * p0 / 8,
        one_minus_lam * p1 / 2,
        one_minus_lam * p1 / 2 + lam * (p0 / 8 + 3 * p1 / 8 + p2 / 4),
        one_minus_lam * p0 / 8 + lam * (p0 / 4 + p1 / 4),
    )


def weight_form() -> tuple[sp.Expr, ...]:
    """Coefficients of E W^2 in s^4, s^3 y, ..., y^4."""
    return homogeneous(density_form() * branch_form() ** 2, 4)


def moments() -> tuple[sp.Expr, ...]:
    """The three positive moments of E W^2 as linear forms in its coefficients."""
    form = sum(a * s ** (4 - j) * y**j for j, a in enumerate(WEIGHT_SYMBOLS))
    return tuple(axial_mean(form * s ** (2 - k) * y**k) for k in range(3))


def closed_moments() -> tuple[sp.Expr, ...]:
    """The three positive moments of E W^2 as polynomials in D33, D3333, Dr33."""
    to_fabric = dict(zip((e0, e1, e2, w0, w1), (*DENSITY_FORM, *BRANCH_FORM), strict=True))
    weights = dict(zip(WEIGHT_SYMBOLS, weight_form(), strict=True))
    return tuple(sp.expand(m.xreplace(weights).xreplace(to_fabric)) for m in moments())


def isotropic_moments() -> dict[sp.Symbol, sp.Rational]:
    """The positive moments of the weight 1."""
    return {p: axial_moment(2 - k, k) for k, p in enumerate(POSITIVE_MOMENTS)}


def _fabric_assignments() -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
    """D33, D3333, Dr33 to the coefficients of the density and of the weight, over common denominators."""
    def over_one(expression: sp.Expr) -> sp.Expr:
        numerator, denominator = sp.fraction(sp.together(expression))
        return sp.Mul(numerator, sp.Integer(1) / denominator, evaluate=False) if denominator != 1 else numerator

    return (*((k, over_one(c)) for k, c in zip((e0, e1, e2), DENSITY_FORM, strict=True)),
            *((k, over_one(c)) for k, c in zip((w0, w1), BRANCH_FORM, strict=True)))


def moment_function() -> Function:
    """Emit the positive moments of E W^2: all terms are non-negative for a density of rank two."""
    o = WEIGHT_SYMBOLS
    sums, quotients = [], []
    for k, moment in enumerate(moments()):
        numerator, denominator = sp.fraction(sp.together(moment))
        total = sp.Symbol(f"sum{k}", positive=True)
        sums.append((total, numerator))
        quotients.append((POSITIVE_MOMENTS[k], total / denominator))
    products = (
        (o[0], e0 * w0 * w0),
        (o[1], w0 * sp.Add(2 * e0 * w1, e1 * w0)),
        (o[2], e0 * w1**2 + 2 * e1 * w0 * w1 + e2 * w0**2),
        (o[3], w1 * sp.Add(e1 * w1, 2 * e2 * w0)),
        (o[4], e2 * w1 * w1),
    )
    return Function(
        "positive_moments", "Moments <E W^2 s^2>, <E W^2 s x^2>, <E W^2 x^4> of the kinematic weight.",
        (D33, D3333, Dr33), (*_fabric_assignments(), *products, *sums, *quotients), POSITIVE_MOMENTS)


def stiffness_function() -> Function:
    """Emit the six components from the moments and Poisson's ratio."""
    return Function(
        "stiffness_from_moments", "Six components over (M/V) l_e^2 k_n from the positive moments.",
        (p0, p1, p2, nu),
        ((lam, LAM), (one_minus_lam, ONE_MINUS_LAM), *zip(STIFFNESS, positive_components(), strict=True)), STIFFNESS,
        unit="-")


def three_function() -> Function:
    """Emit the six components for three different contact stiffnesses."""
    return Function(
        "stiffness_from_moments", "Six components over (M/V) l_e^2 from the positive moments; k_s along the meridian.",
        (p0, p1, p2, kn, ks, kt), tuple(zip(STIFFNESS, _grouped(components()), strict=True)), STIFFNESS,
        unit="N/m")


def _grouped(expressions: tuple[sp.Expr, ...]) -> tuple[sp.Expr, ...]:
    return tuple(sp.collect(e, (kn, ks, kt)) for e in expressions)


def _moment_steps() -> tuple[Step, ...]:
    n, k = contact.NORMAL, contact.stiffness()
    unit = {sin_alpha: 0, cos_alpha: 1}
    sample = (n[2] * k[2, 2] * n[2]).subs(unit)
    power = tuple(sp.collect(sp.expand(c.subs(TO_POWER_MOMENTS)), (kn, kr)) for c in equal_tangents())
    return (
        Step("Contact tensor along a meridian",
             "Inserting $n$, $s$, $t$ into eq. (2) makes every component of $n_ik_{jl}n_k$ a polynomial in "
             "the sines and cosines of the two angles. The azimuth is averaged exactly, monomial by monomial.",
             (rf"n_3k_{{33}}n_3 = {latex(sp.factor(sample))}",),
             (Claim(sample, x**2 * (kn * x**2 + ks * sin_beta**2)),)),
        Step("Six components, each linear in three moments",
             r"What remains are quadratic forms in $s = 1 - x^2$ and $y = x^2$, so that three moments of the weight "
             r"$\rho = E W^2$ carry everything: $p_0 = \langle\rho s^2\rangle$, $p_1 = \langle\rho s y\rangle$, "
             r"$p_2 = \langle\rho y^2\rangle$. Minor symmetry is included.",
             tuple(f"{latex(c)} = {latex(e)}" for c, e in zip(STIFFNESS, _grouped(components()), strict=True)),
             (Claim(components()[5], (components()[0] - components()[2]) / 2),), result=True),
        Step("Equal tangential stiffness",
             r"For $k_s = k_t = k_r$ and with the moments $m_k = \langle\rho x^{2k}\rangle$ the components become",
             tuple(f"{latex(c)} = {latex(e)}" for c, e in zip(STIFFNESS, power, strict=True)),
             tuple(Claim(a, b) for a, b in zip(
                 equal_tangents(),
                 (e.subs({lam: kr / kn, one_minus_lam: 1 - kr / kn}) * kn for e in positive_components()),
                 strict=True))),
        Step("A check without the tangential stiffness",
             "This sum is the response to isotropic compression, in which no contact is sheared: $k_r$ drops out.",
             (r"C_{3333} + 2C_{1111} + 2C_{1122} + 4C_{1133} = k_n\langle\rho\rangle",),
             (Claim(sum(f * c for f, c in zip((2, 1, 2, 4), equal_tangents()[:4], strict=True)),
                    kn * (p0 + 2 * p1 + p2)),)),
    )


def _closing_steps() -> tuple[Step, ...]:
    positive = positive_components()
    return (
        Step("Positive form",
             r"Written in the positive moments, with $\bar\lambda = 1 - \lambda = \nu/(2 - \nu)$ as a quantity of its "
             "own, every component is a sum of non-negative terms: nothing cancels, whatever the fabric.",
             (rf"{latex(lam)} = {latex(LAM)}, \quad {latex(one_minus_lam)} = {latex(ONE_MINUS_LAM)}",
              *(f"{latex(c)} = {latex(e)}" for c, e in zip(STIFFNESS, positive, strict=True))),
             (Claim(LAM + ONE_MINUS_LAM, sp.Integer(1)),
              Claim(positive[5], ((positive[0] - positive[2]) / 2).subs(one_minus_lam, 1 - lam)
                    + positive[5] - positive[5].subs(one_minus_lam, 1 - lam))), result=True),
        Step("Moments of the fabric",
             r"$E W^2$ is a form of degree four, $\sum_j\omega_j s^{4-j}y^j$, whose coefficients are products "
             r"of the end "
             "values of $E$ and $W$. Its moments are rational combinations, because the integral of $s^i x^{2j}$ over "
             "$x$ from 0 to 1 is rational.",
             (*(f"{latex(o)} = {latex(e)}" for o, e in zip(WEIGHT_SYMBOLS, weight_form(), strict=True)),
              *(f"{latex(p)} = {latex(m)}" for p, m in zip(POSITIVE_MOMENTS, moments(), strict=True))),
             (Claim(sum(c * p for c, p in zip((1, 2, 1), closed_moments(), strict=True)),
                    axial_mean(homogeneous_weight())),), result=True),
        Step("Isotropic fabric",
             "Without any anisotropy the moments are plain fractions.",
             tuple(f"{latex(p)} = {latex(m)}" for p, m in isotropic_moments().items()),
             tuple(Claim(m.subs({D33: 0, D3333: 0, Dr33: 0}), isotropic_moments()[p])
                   for p, m in zip(POSITIVE_MOMENTS, closed_moments(), strict=True))),
    )


def homogeneous_weight() -> sp.Expr:
    """E W^2 as a polynomial in s and y with the fabric inserted."""
    to_fabric = dict(zip((e0, e1, e2, w0, w1), (*DENSITY_FORM, *BRANCH_FORM), strict=True))
    return sp.expand((density_form() * branch_form() ** 2).subs(to_fabric))


ASSUMPTIONS = (
    "Every contact displaces with the mean strain (kinematic hypothesis): an upper bound.",
    "Branch vectors are parallel to contact normals.",
    "All contacts have the same stiffness.",
)
EQUAL_TANGENTS = "The tangential stiffness of a contact is a fixed share of the normal one, in all directions."
DISTINCT_TANGENTS = "One tangential stiffness of a contact acts along the meridian, another along the parallel."
DOMAIN = ("E nowhere negative", "-1 < Dr33 < 2", "0 <= nu <= 1/2")


@cache
def kinematic_constant() -> Derivation:
    """Derive the stiffness for k_s = k_t = k_r = lambda k_n, the case of Hertz-Mindlin contacts without slip."""
    to_closed = dict(zip(POSITIVE_MOMENTS, closed_moments(), strict=True))
    ratios = {lam: LAM, one_minus_lam: ONE_MINUS_LAM}
    return Derivation(
        name="kinematic_constant",
        title="Stiffness with constant contact stiffness, kinematic hypothesis",
        sources=("(2)", "(4)", "(7)"),
        assumptions=(*ASSUMPTIONS, EQUAL_TANGENTS),
        domain=DOMAIN,
        inputs=(D33, D3333, Dr33, nu),
        outputs=tuple(Output(c, e.xreplace(to_closed).xreplace(ratios))
                      for c, e in zip(STIFFNESS, positive_components(), strict=True)),
        steps=(*_moment_steps(), *_closing_steps(), *batch_constant.steps(
            {p: m.subs(D3333, 0) for p, m in to_closed.items()},
            tuple(e.xreplace(ratios) for e in positive_components()))),
        functions=(moment_function(), stiffness_function()),
        batch=batch_constant.batch(),
    )


@cache
def kinematic_three() -> Derivation:
    """Derive the stiffness for k_n, k_s, k_t distinct, eq. (2) as it stands."""
    return Derivation(
        name="kinematic_three",
        title="Stiffness with three contact stiffnesses, kinematic hypothesis",
        sources=("(2)", "(4)", "(7)"),
        assumptions=(*ASSUMPTIONS, DISTINCT_TANGENTS),
        domain=("p0, p1, p2 from kinematic_constant.positive_moments", "kn, ks, kt > 0"),
        inputs=(p0, p1, p2, kn, ks, kt),
        outputs=tuple(Output(c, e, "N/m") for c, e in zip(STIFFNESS, components(), strict=True)),
        steps=_moment_steps()[:2],
        functions=(three_function(),),
    )

