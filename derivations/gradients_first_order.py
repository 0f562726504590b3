"""What the stiffness sees of a weak anisotropy: one combination of D33 and Dr33, and what tells the two apart."""

from __future__ import annotations

from functools import cache

import sympy as sp

from derivations import static
from derivations.fabric import fabric_tensor
from derivations.gradients import closed_components
from derivations.gradients_kinematic import FORCES
from derivations.kinematic import positive_components
from derivations.record import Claim, Derivation, Output, Step
from derivations.sphere import axial_mean
from derivations.symbols import (
    D33,
    D3333,
    N11,
    N33,
    POSITIVE_MOMENTS,
    SR,
    STIFFNESS,
    Dr33,
    a,
    c,
    lam,
    latex,
    mu,
    nu,
    one_minus_lam,
    s,
    y,
)

THIRD = sp.Rational(1, 3)
P2 = y - s / 2
"""Second Legendre polynomial as a form in s and y."""

DENSITY, BRANCH = 1 + D33 * P2, 1 + Dr33 * P2
ISOTROPIC = {D33: 0, Dr33: 0}


def first_order(expression: sp.Expr, variables: tuple[sp.Symbol, ...] = (D33, Dr33)) -> sp.Expr:
    """Keep the value and the terms of first order in the variables."""
    at_rest = dict.fromkeys(variables, 0)
    linear = sum((sp.diff(expression, v).subs(at_rest) * v for v in variables), sp.Integer(0))
    return sp.expand(expression.subs(at_rest) + linear)


def moments(weight: sp.Expr) -> dict[sp.Symbol, sp.Expr]:
    """The three positive moments of a weight, to first order in the fabric."""
    linear = first_order(weight)
    return {p: axial_mean(sp.expand(linear * s ** (2 - k) * y**k)) for k, p in enumerate(POSITIVE_MOMENTS)}


def static_slopes() -> tuple[tuple[sp.Expr, sp.Expr], ...]:
    """Slopes of the six static components by D33 and Dr33 at the isotropic state, every contact equally stiff."""
    tensors = {n: form.subs(D3333, 0) for n, form in zip((N11, N33), fabric_tensor(), strict=True)}
    closed = {**moments(DENSITY / BRANCH**2), one_minus_lam: 1 - lam}
    components = tuple(form.subs(closed).subs(tensors) for form in static.positive_stiffness())
    return tuple((sp.factor(sp.diff(form, D33).subs(ISOTROPIC)), sp.factor(sp.diff(form, Dr33).subs(ISOTROPIC)))
                 for form in components)


def _weight_step() -> Step:
    weight = sp.expand(DENSITY * BRANCH**2)
    p = sp.Symbol("P2", real=True)
    in_p2 = sp.expand((1 + D33 * p) * (1 + Dr33 * p) ** 2)
    return Step(
        "What the weight holds",
        r"Under the kinematic hypothesis fabric and branches enter as $E W^2$ alone. To first order that is the sum "
        r"$D_{33} + 2D^r_{33}$ times $P_2$: the number of contacts in a direction and the square of their length do "
        "the same thing.",
        (r"4\pi E W^2 = 1 + (D_{33}+2D^r_{33})P_2 + (2D_{33}D^r_{33}+(D^r_{33})^2)P_2^2 + D_{33}(D^r_{33})^2P_2^3",),
        (Claim(in_p2, 1 + (D33 + 2 * Dr33) * p + (2 * D33 * Dr33 + Dr33**2) * p**2 + D33 * Dr33**2 * p**3),
         Claim(sp.expand(in_p2.subs(p, P2)), weight),
         Claim(first_order(weight), sp.expand(1 + (D33 + 2 * Dr33) * P2))), result=True)


def _constant_step() -> Step:
    components = closed_components()
    return Step(
        "Constant contact stiffness: one combination",
        "So every slope by $D^r_{33}$ is twice that by $D_{33}$ at the isotropic state, for all six components and any "
        "Poisson's ratio: no set of elastic measurements tells the two apart there.",
        (r"\frac{\partial C_{ijkl}}{\partial D^r_{33}}\Big|_0 = 2\,\frac{\partial C_{ijkl}}{\partial D_{33}}\Big|_0",),
        tuple(Claim(sp.factor(sp.diff(form, Dr33).subs(ISOTROPIC)), sp.factor(2 * sp.diff(form, D33).subs(ISOTROPIC)))
              for form in components), result=True)


def _valley_step() -> Step:
    total = sp.Symbol("Delta", real=True)
    along = sp.expand((2 * D33 * Dr33 + Dr33**2).subs(D33, total - 2 * Dr33))
    return Step(
        "Second order: along the valley",
        r"Keep $\Delta = D_{33} + 2D^r_{33}$ and move along it. The weight changes by the second order only, "
        r"with $-3(D^r_{33})^2$: a trade of 0.1 in $D^r_{33}$ changes it by a few hundredths, and both signs of "
        r"$D^r_{33}$ do the same where $\Delta = 0$.",
        (r"2D_{33}D^r_{33} + (D^r_{33})^2 = 2\Delta D^r_{33} - 3(D^r_{33})^2",),
        (Claim(along, 2 * total * Dr33 - 3 * Dr33**2),), result=True)


def _kinetic_step() -> Step:
    forces = dict(FORCES)
    stiffness = ((a * s + c * y) ** THIRD).subs(forces)
    at_one = sp.expand(sum((sp.diff(stiffness, v).subs({D33: 0, SR: 1}) * step
                            for v, step in ((D33, D33), (SR, SR - 1))), sp.Integer(0)).subs(s, 1 - y))
    seen = sp.Rational(13, 15) * D33 + 2 * Dr33 + sp.Rational(2, 9) * (SR - 1)
    weight = sp.expand((D33 + 2 * Dr33) * P2.subs(s, 1 - y) + at_one)
    whole = DENSITY * BRANCH**2 * stiffness
    at_rest = {D33: 0, Dr33: 0, SR: 1, s: 1 - y}
    mixed = tuple(sp.expand(sp.diff(whole, v, SR).subs(at_rest)) for v in (D33, Dr33))
    p = sp.Symbol("P_2", real=True)
    expected = (sp.Rational(38, 135) * p**2 - sp.Rational(2, 45) * p - sp.Rational(2, 45), sp.Rational(4, 9) * p**2)
    return Step(
        "Contact forces: another combination, and the stress",
        r"Where more contacts share the load each carries less, and is softer. Without slip this changes the "
        r"combination to $\tfrac{13}{15}D_{33} + 2D^r_{33}$, and a stress ratio adds to the same sum; still one number "
        "at first order. A stress away from isotropic makes the slopes by $D_{33}$ and $D^r_{33}$ differ, in "
        r"proportion to $\mathrm{SR}-1$: measurements at several stress ratios on one fabric tell them apart.",
        (r"4\pi E W^2\frac{k_n}{k_n^\circ} = 1 + \left(\tfrac{13}{15}D_{33} + 2D^r_{33} + "
         r"\tfrac29(\mathrm{SR}-1)\right)P_2 + \dots",
         *(rf"\frac{{\partial^2}}{{\partial {latex(v)}\,\partial\mathrm{{SR}}}}"
           rf"\,4\pi E W^2\frac{{k_n}}{{k_n^\circ}}\Big|_0 = {latex(form)}"
           for v, form in zip((D33, Dr33), expected, strict=True))),
        (Claim(weight, sp.expand(seen * P2.subs(s, 1 - y))),
         *(Claim(found, sp.expand(form.subs(p, P2.subs(s, 1 - y))))
           for found, form in zip(mixed, expected, strict=True))), result=True)


def _slip_step() -> Step:
    forces = dict(FORCES)
    apart = sp.expand(first_order((c - a).subs(forces).subs(SR, 1), (D33,)))
    return Step(
        "Friction: a corner",
        r"With friction the shear stiffness loses a part that grows with $|c - a|$, which under isotropic stress is "
        r"$\tfrac35|D_{33}|$, while $D^r_{33}$ brings no shear force. This breaks the tie at first order already, by "
        "the size of $D_{33}$ and not by its sign.",
        (r"c - a = -\tfrac35 D_{33} + \dots,\qquad \frac{k_r}{\lambda_0 k_n} = 1 - "
         r"\frac{|D_{33}|\,x\sqrt s}{5\mu} + \dots",),
        (Claim(apart, -sp.Rational(3, 5) * D33),
         Claim(sp.diff((1 - sp.Rational(3, 5) * D33 * sp.sqrt(s * y) / mu) ** THIRD, D33).subs(D33, 0),
               -sp.sqrt(s * y) / (5 * mu))), result=True)


def _static_step() -> Step:
    slopes = static_slopes()
    quotients = tuple(sp.factor(by_d / by_dr) for by_d, by_dr in slopes)
    expected = {
        "C1111": (32 * lam**2 + 101 * lam + 42) / (10 * lam * (16 * lam + 19)),
        "C1122": (4 * lam + 21) / (20 * lam),
        "C2323": (8 * lam + 27) / (10 * (4 * lam + 3)),
    }
    groups = {"C1111": "C1111", "C3333": "C1111", "C1122": "C1122", "C1133": "C1122", "C2323": "C2323",
              "C1212": "C2323"}
    shown = []
    for name, text in (("C1111", r"C_{1111}, C_{3333}"), ("C1122", r"C_{1122}, C_{1133}"),
                       ("C2323", r"C_{2323}, C_{1212}")):
        shown.append(rf"\frac{{\partial C/\partial D_{{33}}}}{{\partial C/\partial D^r_{{33}}}}\Big|_0 = "
                     rf"{latex(expected[name])}\qquad\text{{for }}{text}")
    return Step(
        "Static hypothesis: three combinations",
        "Under uniform stress the fabric tensor of the contact normals enters as well, and branches divide. The "
        r"quotient of the two slopes then differs from component to component: little between stretch and shear, much "
        r"for $C_{1122}$ and $C_{1133}$. There the two are told apart at first order, as far as the hypothesis is "
        "believed.",
        tuple(shown),
        tuple(Claim(quotient, expected[groups[symbol.name]]) for symbol, quotient in zip(STIFFNESS, quotients,
                                                                                         strict=True)), result=True)


@cache
def first_order_fabric() -> Derivation:
    """Derive which combination of contact normals and branch lengths the stiffness sees."""
    linear = {**moments(DENSITY * BRANCH**2), one_minus_lam: 1 - lam}
    return Derivation(
        name="first_order_fabric",
        title="What the stiffness sees of a weak fabric",
        sources=("(4)", "(7)", "(20)", "(21)", "(23)", "Figure 1(b)"),
        assumptions=("Density of contact normals and branch lengths of rank two about one axis.",
                     "Branch vectors are parallel to contact normals."),
        domain=("near D33 = Dr33 = 0 and SR = 1",),
        inputs=(D33, Dr33, lam, SR, mu, nu),
        outputs=tuple(Output(symbol, sp.expand(component.xreplace(linear)))
                      for symbol, component in zip(STIFFNESS, positive_components(), strict=True)),
        steps=(_weight_step(), _constant_step(), _valley_step(), _kinetic_step(), _slip_step(), _static_step()),
    )
