"""Three maps of the log-tangent variable to a whole line, and the slip limit of contacts that open beyond it."""

from __future__ import annotations

import sympy as sp

from derivations.record import Claim, Step
from derivations.symbols import a, c, fn, fr, kappa, latex, log_tangent, mu, psi_s, tangent

u, w, vartheta = sp.symbols("u w vartheta", real=True)
"""Variables of the maps, and an imaginary part."""

r_stick = sp.Symbol("r_kappa", positive=True)
"""Scale of the map over sticking directions, sqrt((1 - kappa)/2)."""

rho = sp.Symbol("rho_kappa", positive=True)
"""Scale of the maps about a sliding range, sinh(psi_s/2)."""

reach = sp.Symbol("R_1", positive=True)
"""Reach of the map inside a sliding range."""

opened = sp.Symbol("abs_c", positive=True)
"""The absolute value of a negative c."""

BESIDE = sp.exp(2 * w) / (2 * (1 + sp.exp(w)))
"""P of the map beside a sliding range."""


def _cosh_of(half_sine: sp.Expr) -> sp.Expr:
    """Return cosh(sigma) from sinh(sigma/2)."""
    return 1 + 2 * half_sine**2


def _identity(left: sp.Expr, right: sp.Expr) -> Claim:
    return Claim(sp.expand(sp.expand(left).rewrite(sp.exp)), sp.expand(sp.expand(right).rewrite(sp.exp)))


def _stick_step() -> Step:
    half_sine = r_stick * sp.sinh(u)
    left = _cosh_of(half_sine) - (1 - 2 * r_stick**2)
    turned = (1 - r_stick**2 + r_stick**2 * sp.cosh(2 * u + sp.I * sp.pi / 2))
    return Step(
        "Map when every contact sticks",
        r"Near the onset of sliding the margin of friction has two zeros close to the real axis, at "
        r"$\sinh\tfrac\sigma2 = \pm i\,r_\kappa$. A map with that scale moves them to $u = \pm\tfrac12 i\pi$, however "
        r"close they were. On the lines $|\operatorname{Im}u| = \tfrac14\pi$ the real part of $\cosh\sigma$ is "
        r"$1 - r_\kappa^2 \ge \tfrac12$, while all other singularities, at vanishing normal force and at $t = \pm i$, "
        r"have $\operatorname{Im}\sigma = \pm\tfrac12\pi$ and so real part zero. The trapezoidal rule with step "
        r"$\Delta$ therefore errs like $e^{-\pi^2/(2\Delta)}$.",
        (rf"\sinh\tfrac\sigma2 = {latex(r_stick)}\sinh u,\qquad {latex(r_stick)} = \sqrt{{\tfrac12(1-\kappa)}}",
         rf"2\sinh^2\tfrac\sigma2 + 1 - \kappa = {latex(2 * r_stick**2)}\cosh^2 u,\qquad "
         rf"\frac{{\mathrm{{d}}\sigma}}{{\mathrm{{d}}u}} = \frac{{2\,{latex(r_stick)}\cosh u}}{{\cosh\frac\sigma2}}",
         rf"\cosh\sigma = 1 - {latex(r_stick**2)} + {latex(r_stick**2)}\cosh 2u"),
        (_identity(left, 2 * r_stick**2 * sp.cosh(u) ** 2),
         Claim(2 * ((1 - kappa) / 2), 1 - kappa),
         Claim(2 * sp.diff(half_sine, u), 2 * r_stick * sp.cosh(u)),
         _identity(_cosh_of(half_sine), 1 - r_stick**2 + r_stick**2 * sp.cosh(2 * u)),
         _identity(turned, 1 - r_stick**2 + sp.I * r_stick**2 * sp.sinh(2 * u)),
         _identity(sp.cosh(u + sp.I * sp.pi / 2), sp.I * sp.sinh(u))), result=True)


def _beside_step() -> Step:
    half_sine = rho * (1 + BESIDE)
    growth = 1 + sp.exp(w)
    margin = _cosh_of(half_sine) - (1 + 2 * rho**2)
    return Step(
        "Map beside a sliding range",
        r"From the edge outwards the margin of friction grows from zero. The map sends the edge to $w = -\infty$, "
        r"where the cube root of the margin dies off like $e^{2w/3}$. It is the one above for $\kappa > 1$, "
        r"$\sinh\tfrac\sigma2 = \rho_\kappa\cosh u$, with $u = \ln(1 + e^w)$; since the argument of $1 + e^w$ is no "
        r"larger than that of $e^w$, the strip $|\operatorname{Im}w| < \tfrac14\pi$ stays within "
        r"$|\operatorname{Im}u| < \tfrac14\pi$, where $\operatorname{Re}\cosh\sigma \ge 1 + \rho_\kappa^2$.",
        (rf"\sinh\tfrac\sigma2 = \rho_\kappa(1 + P),\qquad P = \frac{{e^{{2w}}}}{{2(1+e^w)}},\qquad \rho_\kappa = "
         rf"\sinh\tfrac{{{latex(psi_s)}}}{{2}}",
         r"\cosh\sigma - \kappa = 2\rho_\kappa^2P(2+P),\qquad \frac{\mathrm{d}P}{\mathrm{d}w} = P\,"
         r"\frac{2+e^w}{1+e^w},\qquad \frac{\mathrm{d}\sigma}{\mathrm{d}w} = "
         r"\frac{2\rho_\kappa}{\cosh\frac\sigma2}\,\frac{\mathrm{d}P}{\mathrm{d}w}"),
        (_identity(_cosh_of(sp.sinh(psi_s / 2)), sp.cosh(psi_s)),
         Claim(sp.cancel(margin), sp.cancel(2 * rho**2 * BESIDE * (2 + BESIDE))),
         Claim(sp.cancel((growth + 1 / growth) / 2), sp.cancel(1 + BESIDE)),
         Claim(sp.cancel(sp.diff(BESIDE, w)), sp.cancel(BESIDE * (2 + sp.exp(w)) / (1 + sp.exp(w)))),
         _identity(_cosh_of(rho * sp.cosh(u)), 1 + rho**2 + rho**2 * sp.cosh(2 * u)),
         Claim(sp.expand(sp.cosh(2 * u + 2 * sp.I * vartheta), complex=True),
               sp.cosh(2 * u) * sp.cos(2 * vartheta) + sp.I * sp.sinh(2 * u) * sp.sin(2 * vartheta)),
         Claim(sp.powsimp(BESIDE * sp.exp(-2 * w)).subs(sp.exp(w), 0), sp.Rational(1, 2))), result=True)


def _between_step() -> Step:
    sine = sp.Symbol("S", real=True)
    half_sine = rho * sine / sp.sqrt(reach**2 + sine**2)
    under = reach**2 + sine**2
    line = -sp.Rational(1, 2) + sp.I * vartheta
    on_line = 1 + 2 * rho**2 * line / (reach**2 + line)
    shifted = reach**2 - sp.Rational(1, 2)
    expected = (shifted * (shifted - rho**2) + (1 + 2 * rho**2) * vartheta**2) / (shifted**2 + vartheta**2)
    conjugate = 1 + 2 * rho**2 * sp.conjugate(line) / (reach**2 + sp.conjugate(line))
    return Step(
        "Map of the sliding range",
        r"The normal force alone is summed over the sliding range, from one end to the other. On the lines "
        r"$|\operatorname{Im}u| = \tfrac14\pi$, where $S^2 = -\tfrac12 + i\vartheta$, the real part of $\cosh\sigma$ "
        r"stays positive when $R_1^2 > \rho_\kappa^2 + \tfrac12$. Being harmonic it is then positive in the whole "
        "strip between them, and the singularities stay outside.",
        (r"\sinh\tfrac\sigma2 = \frac{\rho_\kappa S}{\sqrt{R_1^2 + S^2}},\qquad S = \sinh u,\qquad "
         r"\frac{\mathrm{d}\sigma}{\mathrm{d}u} = \frac{2\rho_\kappa R_1^2\cosh u}"
         r"{(R_1^2+S^2)^{3/2}\cosh\frac\sigma2}",
         r"\operatorname{Re}\cosh\sigma = \frac{(R_1^2-\frac12)(R_1^2-\frac12-\rho_\kappa^2)"
         r" + (1+2\rho_\kappa^2)\vartheta^2}{(R_1^2-\frac12)^2+\vartheta^2}"),
        (Claim(sp.expand(2 * sp.diff(half_sine, sine) * under ** sp.Rational(3, 2)), 2 * rho * reach**2),
         Claim(sp.diff(sp.sinh(u), u), sp.cosh(u)),
         Claim(rho**2 - sp.cancel(half_sine**2), sp.cancel(rho**2 * reach**2 / under)),
         _identity(sp.sinh(u + sp.I * sp.pi / 4) ** 2, -sp.Rational(1, 2) + sp.I * sp.sinh(2 * u) / 2),
         Claim(sp.cancel(sp.together((on_line + conjugate) / 2)), sp.cancel(expected))), result=True)


def _opening_step() -> Step:
    t = sp.sqrt(opened / a) * sp.exp(log_tangent)
    limit = sp.Symbol("sigma_1", positive=True)
    at_limit = sp.sqrt(opened / a) * sp.exp(limit)
    shear = 2 * sp.sqrt(a * opened) * sp.sinh(limit)  # |c - a|/mu
    sticking = 2 * sp.cosh((log_tangent + limit) / 2) * sp.sinh((log_tangent - limit) / 2)
    turned = sp.expand((a * tangent + c / tangent).subs(tangent, 1 / tangent))
    return Step(
        "Contacts that open",
        r"When one principal stress is a tension, say $c < 0 < a$, the contacts about that axis open. Measured from "
        r"the direction in which the normal force vanishes the same variable shows contacts that have opened at "
        r"$\sigma < 0$, that slide at $0 < \sigma < \sigma_1$, and that stick beyond. The case $a < 0 < c$ follows by "
        r"exchanging $t$ and $1/t$, $a$ and $c$.",
        (rf"c < 0 < a,\quad t = \sqrt{{\tfrac{{|c|}}{{a}}}}\,e^\sigma:\qquad \frac{{1+t^2}}{{t}}\,{latex(fn)} = "
         rf"2\sqrt{{a|c|}}\,\sinh\sigma,\qquad \frac{{{latex(fr)}}}{{{latex(mu)} {latex(fn)}}} = "
         r"\frac{\kappa'}{\sinh\sigma},\qquad \kappa' = \frac{|c-a|}{2\mu\sqrt{a|c|}}",
         rf"\sinh\sigma_1 = \kappa',\qquad 1 - \frac{{{latex(fr)}}}{{{latex(mu)} {latex(fn)}}} = "
         r"\frac{2\cosh\frac{\sigma+\sigma_1}2\,\sinh\frac{\sigma-\sigma_1}2}{\sinh\sigma}"),
        (_identity(sp.expand(a * t - opened / t), 2 * sp.sqrt(a * opened) * sp.sinh(log_tangent)),
         _identity(a * at_limit**2 - shear * at_limit - opened, sp.Integer(0)),
         _identity(sp.sinh(log_tangent) - sp.sinh(limit), sticking),
         Claim(turned, c * tangent + a / tangent)), result=True)


def map_steps() -> tuple[Step, ...]:
    """The maps of sticking directions, beside a sliding range and inside it, and the slip limit of opening."""
    return _stick_step(), _beside_step(), _between_step(), _opening_step()
