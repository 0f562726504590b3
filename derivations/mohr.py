"""Which contacts slide: Mohr's circle against the Coulomb line, and the log-tangent variable that the rules use.

Forces are over f_ref/W throughout: f_n = a s + c x^2, f_r = |c - a| x sqrt(s).
"""

from __future__ import annotations

from functools import cache

import sympy as sp

from derivations import slip_rule
from derivations.record import Claim, Derivation, Output, Step
from derivations.slip_maps import map_steps
from derivations.symbols import (
    a,
    beta,
    c,
    circle_center,
    circle_radius,
    d,
    fn,
    fr,
    h0,
    kappa,
    latex,
    log_tangent,
    mu,
    phi,
    psi,
    psi_s,
    s,
    tangent,
    x,
)

CENTER = (a + c) / 2
"""Centre of Mohr's circle; its radius is half the difference."""

SHEAR = sp.Symbol("abs_d", positive=True)
"""The absolute value of c - a, where its square is all that is known of it."""

KAPPA = sp.Abs(c - a) / (2 * mu * sp.sqrt(a * c))
"""Largest share of its friction that a contact uses up."""

AMPLITUDE = sp.Abs(c - a) / 2 * sp.sqrt(1 + 1 / mu**2)

NORMAL_OF_T = (a * tangent**2 + c) / (1 + tangent**2)
"""f_n in t = tan(beta): s = t^2/(1 + t^2), x^2 = 1/(1 + t^2)."""

OVER_FRICTION = a * sp.sin(beta) ** 2 + c * sp.cos(beta) ** 2 - SHEAR / mu * sp.sin(beta) * sp.cos(beta)
"""f_n - f_r/mu."""


def exponential(expression: sp.Expr) -> sp.Expr:
    """Write circular and hyperbolic functions as exponentials, so that identities cancel term by term."""
    return sp.expand(sp.expand(expression).rewrite(sp.exp))


def identity(left: sp.Expr, right: sp.Expr) -> Claim:
    """Claim an identity of circular or hyperbolic functions."""
    return Claim(exponential(left), exponential(right))


def _circle_step() -> Step:
    normal = (a * s + c * x**2).subs(x, sp.sqrt(1 - s))
    shear_squared = (c - a) ** 2 * s * (1 - s)
    return Step(
        "Mohr's circle of the contact forces",
        r"Normal and shear force of all directions, over $f^\circ/W$, lie on a half circle about $m$ with radius "
        r"$|c-a|/2$: Mohr's circle of the contact plane with $a$ and $c$ in place of the principal stresses.",
        (rf"{latex(circle_center)} = {latex(sp.Mul(sp.Rational(1, 2), a + c, evaluate=False))},\qquad "
         rf"({latex(fn)} - {latex(circle_center)})^2 + f_r^2 = \tfrac14(c-a)^2",),
        (Claim((normal - CENTER) ** 2 + shear_squared, (c - a) ** 2 / 4),), result=True)


def _coulomb_step() -> Step:
    split = CENTER + (c - a) / 2 * sp.cos(2 * beta) - SHEAR / (2 * mu) * sp.sin(2 * beta)
    flat, steep = sp.pi / 2 - phi, sp.pi / 2 + phi
    cosine = circle_radius * sp.cos(2 * beta + psi)
    return Step(
        "Against the Coulomb line",
        r"A contact sticks while $f_r < \mu f_n$, with $\mu = \tan\phi$. What is left of the normal force, "
        r"$f_n - f_r/\mu$, swings with the double angle $2\beta$, turned by $\psi$: by a right angle less the friction "
        "angle when the pole carries more, by a right angle and the friction angle when the equator does.",
        (rf"{latex(fn)} - \frac{{{latex(fr)}}}{{\mu}} = {latex(circle_center)} + {latex(cosine)},\qquad "
         rf"{latex(circle_radius)} = \tfrac12|c-a|\,{latex(sp.sqrt(1 + 1 / mu**2))} = \frac{{|c-a|}}{{2\sin\phi}}",
         r"c > a:\ \tan\psi = \tfrac1\mu,\ \psi = 90^\circ - \phi;\qquad "
         r"c < a:\ \tan\psi = -\tfrac1\mu,\ \psi = 90^\circ + \phi"),
        (identity(OVER_FRICTION, split),
         identity(sp.expand(sp.expand_trig(cosine)),
                  circle_radius * (sp.cos(2 * beta) * sp.cos(psi) - sp.sin(2 * beta) * sp.sin(psi))),
         Claim(SHEAR**2 / 4 + (SHEAR / (2 * mu)) ** 2, (SHEAR / 2) ** 2 * (1 + 1 / mu**2)),
         Claim(sp.trigsimp((1 + 1 / sp.tan(phi) ** 2) * sp.sin(phi) ** 2), sp.Integer(1)),
         Claim(sp.cos(flat), sp.sin(phi)), Claim(sp.sin(flat), sp.cos(phi)), Claim(sp.tan(flat), 1 / sp.tan(phi)),
         Claim(sp.cos(steep), -sp.sin(phi)), Claim(sp.sin(steep), sp.cos(phi)),
         Claim(sp.tan(steep), -1 / sp.tan(phi))), result=True)


def _nearest_step() -> Step:
    swing = circle_center + circle_radius * sp.cos(2 * beta + psi)
    nearest = (sp.pi - psi) / 2
    return Step(
        "Nearest to sliding: Rankine's planes",
        r"The least value is $h_0 = m - R$, at $2\beta^* + \psi = 180^\circ$: contacts whose plane lies as a failure "
        "plane does behind a wall.",
        (r"c > a:\ \beta^* = 45^\circ + \tfrac12\phi;\qquad c < a:\ \beta^* = 45^\circ - \tfrac12\phi",
         rf"{latex(h0)} = {latex(circle_center)} - {latex(circle_radius)} = "
         r"\frac{4ac\mu^2 - (c-a)^2}{4\mu^2(m + R)}"),
        (Claim(sp.diff(swing, beta).subs(beta, nearest), sp.Integer(0)),
         Claim(swing.subs(beta, nearest), circle_center - circle_radius),
         Claim(sp.diff(swing, beta, 2).subs(beta, nearest), 4 * circle_radius),
         Claim(nearest.subs(psi, sp.pi / 2 - phi), sp.pi / 4 + phi / 2),
         Claim(nearest.subs(psi, sp.pi / 2 + phi), sp.pi / 4 - phi / 2),
         Claim(CENTER**2 - (c - a) ** 2 / 4 * (1 + 1 / mu**2), (4 * a * c * mu**2 - (c - a) ** 2) / (4 * mu**2))),
        result=True)


def _onset_step() -> Step:
    sine = sp.Symbol("sin_phi", positive=True)
    active, passive = a * (1 + sine) / (1 - sine), a * (1 - sine) / (1 + sine)
    squared_mu = sine**2 / (1 - sine**2)
    nearest = sp.tan(sp.pi / 4 + phi / 2)
    half = sp.tan(phi / 2)
    return Step(
        "Onset of sliding",
        r"The first contact slides when the circle touches the line, $m = R$. The ratio of the forces at pole and "
        r"equator is then that of the principal stresses in a soil at failure with the friction angle $\phi$, and "
        r"$\tan\beta^* = \sqrt{c/a}$.",
        (r"4ac\mu^2 = (c-a)^2 \iff \tfrac12(a+c)\sin\phi = \tfrac12|c-a| \iff "
         r"\frac ca = \frac{1\pm\sin\phi}{1\mp\sin\phi}",),
        (*(claim for ratio, sign in ((active, 1), (passive, -1)) for claim in (
            Claim(sp.cancel(4 * a * ratio * squared_mu), sp.cancel((ratio - a) ** 2)),
            Claim(sp.cancel((a + ratio) * sine), sp.cancel(sign * (ratio - a))))),
         Claim(sp.cancel(sp.expand_trig(nearest) ** 2),
               sp.cancel(((1 + sp.Symbol("z")) / (1 - sp.Symbol("z"))).subs(
                   sp.Symbol("z"), 2 * half / (1 + half**2)))),
         identity(sp.sin(phi) * (sp.cos(phi / 2) ** 2 + sp.sin(phi / 2) ** 2),
                  2 * sp.sin(phi / 2) * sp.cos(phi / 2))), result=True)


def _log_tangent_step() -> Step:
    t = sp.sqrt(c / a) * sp.exp(log_tangent)
    normal = sp.expand(a * t + c / t)
    share = (2 * sp.sinh(log_tangent / 2) ** 2 + 1 - kappa) / sp.cosh(log_tangent)
    direct = 1 - kappa / sp.cosh(log_tangent)
    cosine = 1 / sp.sqrt(1 + tangent**2)
    return Step(
        "The log-tangent variable",
        r"With $t = \tan\beta$ both forces have the common factor $t/(1+t^2)$. Measured on a logarithmic scale from "
        r"$\sqrt{c/a}$, $t = \sqrt{c/a}\,e^\sigma$, the share of the friction that is used up is the same bell for "
        r"every fabric and every stress; only its height $\kappa$ differs. Nothing is subtracted in the last form.",
        (rf"t = \sqrt{{\tfrac ca}}\,e^{{\sigma}}:\qquad \frac{{1+t^2}}{{t}}\,{latex(fn)} = "
         rf"2\sqrt{{ac}}\,\cosh\sigma,\qquad \frac{{1+t^2}}{{t}}\,{latex(fr)} = |c-a|",
         rf"\frac{{{latex(fr)}}}{{\mu {latex(fn)}}} = \frac{{{latex(kappa)}}}{{\cosh\sigma}},\qquad "
         rf"{latex(kappa)} = \frac{{|c-a|}}{{2\mu\sqrt{{ac}}}}",
         rf"1 - \frac{{{latex(fr)}}}{{\mu {latex(fn)}}} = "
         r"\frac{2\sinh^2\frac\sigma2 + 1 - \kappa}{\cosh\sigma}",
         r"\mathrm{d}x = -s\,x\,\mathrm{d}\sigma"),
        (Claim(sp.cancel(NORMAL_OF_T * (1 + tangent**2) / tangent), sp.expand(a * tangent + c / tangent)),
         identity(normal, 2 * sp.sqrt(a * c) * sp.cosh(log_tangent)),
         Claim(sp.powsimp(cosine * tangent * cosine * (1 + tangent**2) / tangent), sp.Integer(1)),
         Claim(sp.powsimp(KAPPA / (SHEAR / mu / (2 * sp.sqrt(a * c)))), sp.Abs(c - a) / SHEAR),
         identity(share * sp.cosh(log_tangent), sp.expand(direct * sp.cosh(log_tangent))),
         Claim(sp.simplify(tangent * sp.diff(cosine, tangent)), sp.simplify(-tangent**2 / (1 + tangent**2) * cosine)),
         Claim(sp.diff(t, log_tangent), t)), result=True)


def _sliding_step() -> Step:
    edge = sp.sqrt(c / a) * sp.exp(psi_s)
    slope = 2 * sp.sqrt(a * c) * sp.cosh(psi_s)  # |c - a|/mu = 2 kappa sqrt(ac)
    return Step(
        "Sticking and sliding directions",
        r"Every contact sticks exactly when $\kappa \le 1$. Otherwise the contacts of one range of directions slide, "
        r"$|\sigma| < \psi_s$; the tangents at its ends are the roots of a quadratic, and neither needs a "
        "difference of nearly equal numbers.",
        (rf"\kappa^2 - 1 = \frac{{(c-a)^2 - 4ac\mu^2}}{{4ac\mu^2}},\qquad "
         rf"\cosh{latex(psi_s)} = {latex(kappa)}",
         r"a\,t^2 - \frac{|c-a|}{\mu}\,t + c = 0:\qquad t_{1,2} = \sqrt{\tfrac ca}\left(\kappa \mp "
         r"\sqrt{\kappa^2-1}\right)"),
        (Claim(sp.cancel((c - a) ** 2 / (4 * mu**2 * a * c) - 1),
               sp.cancel(((c - a) ** 2 - 4 * a * c * mu**2) / (4 * a * c * mu**2))),
         Claim(KAPPA**2, (c - a) ** 2 / (4 * mu**2 * a * c)),
         *(identity(a * t**2 - slope * t + c, sp.Integer(0)) for t in (edge, edge.subs(psi_s, -psi_s))),
         identity(sp.exp(psi_s), sp.cosh(psi_s) + sp.sinh(psi_s)),
         Claim((kappa + sp.sqrt(kappa**2 - 1)) * (kappa - sp.sqrt(kappa**2 - 1)), sp.Integer(1))), result=True)


@cache
def mohr_circle() -> Derivation:
    """Derive which contacts stick, slide or open, and the maps by which the stiffness is summed over directions."""
    return Derivation(
        name="mohr_circle",
        title="Sliding contacts on Mohr's circle",
        sources=("(21)", "(23)"),
        assumptions=("Contact forces follow from the mean stress by the fabric tensor of rank two.",
                     "A contact slides where the shear force reaches the friction coefficient times the normal force."),
        domain=("a, c > 0: no contact opens, unless stated", "mu > 0"),
        inputs=(a, c, mu),
        outputs=(Output(circle_center, CENTER), Output(circle_radius, AMPLITUDE), Output(h0, CENTER - AMPLITUDE),
                 Output(kappa, KAPPA), Output(d, c - a)),
        steps=(_circle_step(), _coulomb_step(), _nearest_step(), _onset_step(), _log_tangent_step(), _sliding_step(),
               *map_steps()),
        functions=slip_rule.functions(),
    )
