"""Slopes of the six components by fabric, stress ratio, friction and Poisson's ratio: how they follow, and the code."""

from __future__ import annotations

from functools import cache

import sympy as sp

from derivations import gradients_batch, gradients_kinematic, gradients_series, gradients_static
from derivations.forward import slope_symbol, with_slopes
from derivations.gradients_kinematic import FORCE_PARTIALS, FORCES, LAM_PARTIALS
from derivations.kinematic import LAM, ONE_MINUS_LAM, closed_moments, positive_components
from derivations.record import Claim, Derivation, Function, Output, Step
from derivations.symbols import (
    D33,
    D3333,
    POSITIVE_MOMENTS,
    SR,
    STIFFNESS,
    TANGENTIAL_MOMENTS,
    Dr33,
    a,
    c,
    coordination,
    d,
    lam,
    latex,
    mean_stress,
    mu,
    nu,
    one_minus_lam,
    s,
    shear_modulus,
    void_ratio,
    w0,
    w1,
    y,
)

THIRD = sp.Rational(1, 3)

side = sp.Symbol("side", real=True)
"""Sign of c - a."""

Q = sp.symbols("Q0:4", positive=True)
"""<E W^2 s^(3-k) x^(2k) h^(-2/3)>/3 over the contacts that stick, h the normal force less the shear force over mu."""

R = sp.symbols("R0:3", positive=True)
"""<E W^2 s^(2-k) x^(2k) x sqrt(s) h^(-2/3)>/3 over the same."""

line_slope = sp.Symbol("coordination_by_void_ratio", real=True)


def closed_components() -> tuple[sp.Expr, ...]:
    """Six components over (M/V) l_e^2 k_n in D33, Dr33 and nu, every contact equally stiff."""
    closed = {p: moment.subs(D3333, 0) for p, moment in zip(POSITIVE_MOMENTS, closed_moments(), strict=True)}
    closed |= {lam: LAM, one_minus_lam: ONE_MINUS_LAM}
    return tuple(component.xreplace(closed) for component in positive_components())


def shear_slopes() -> Function:
    """Emit how the moments of the shear stiffness follow forces and friction: through both forces and through mu."""
    slopes = {}
    for q, (across, along, sheared) in zip(TANGENTIAL_MOMENTS, zip(Q, Q[1:], R, strict=False), strict=True):
        by_a, by_c = across + side * sheared / mu, along - side * sheared / mu
        slopes[slope_symbol(q, D33)] = by_a * FORCE_PARTIALS[a][D33] + by_c * FORCE_PARTIALS[c][D33]
        slopes[slope_symbol(q, SR)] = by_a * FORCE_PARTIALS[a][SR] + by_c * FORCE_PARTIALS[c][SR]
        slopes[slope_symbol(q, mu)] = side * d * sheared / mu**2
    return Function(
        "shear_slopes", "Slopes of the moments of k_r/lambda_0 by D33 and SR through the forces, and by mu.",
        (D33, SR, mu, a, c, d, side, *Q, *R), tuple(slopes.items()), tuple(slopes), unit="-",
        notes="Q0 ... Q3 are <w s^(3-k) x^(2k)>, R0 ... R2 are <w s^(2-k) x^(2k) x sqrt(s)>, both with w = "
              "E W^2 h^(-2/3)/3 over the contacts that stick; side is the sign of d = c - a. For flexibilities "
              "1/(k_r/lambda_0) take w = -E W^-2 h^(-4/3)/3.")


def reference_slopes() -> Function:
    """Emit the slopes of the logarithm of the reference stiffness."""
    by_e, by_n, by_nu = (sp.Symbol(f"log_reference_{v.name}", real=True) for v in (void_ratio, coordination, nu))
    return Function(
        "reference_slopes", "Slopes of the logarithm of (M/V) l_e^2 k_n,ref by void ratio, coordination number and nu.",
        (void_ratio, coordination, nu, line_slope),
        ((by_n, sp.Rational(2, 3) / coordination),
         (by_e, line_slope * by_n - sp.Rational(2, 3) / (1 + void_ratio)),
         (by_nu, sp.Rational(2, 3) / (1 - nu))), (by_e, by_n, by_nu), unit="-",
        notes="coordination_by_void_ratio is dN/de where N follows from e, and 0 where N is given.")


def _force_steps() -> tuple[Step, ...]:
    force = a * s + c * y
    power = force ** sp.Rational(-2, 3)
    plain = force**THIRD
    return (
        Step("Forces follow stress and fabric, eq. (23)",
             "The two numbers that give the normal force of every direction have slopes that are multiples of "
             "themselves.",
             tuple(rf"\frac{{\partial {latex(force)}}}{{\partial {latex(v)}}} = {latex(partial)}"
                   for force, by in FORCE_PARTIALS.items() for v, partial in by.items()),
             tuple(Claim(sp.diff(dict(FORCES)[force], v), partial.subs(dict(FORCES)))
                   for force, by in FORCE_PARTIALS.items() for v, partial in by.items()), result=True),
        Step("One family of integrals for values and slopes",
             r"With $S_k = \langle E W^2 s^{3-k}x^{2k}(as+cy)^{-2/3}\rangle$ the moments of the normal stiffness and "
             "their slopes by the forces are sums of positive terms. A moment is homogeneous of degree 1/3 in the "
             "forces, which ties the slopes to the value.",
             (r"p_k = a S_k + c S_{k+1},\qquad \frac{\partial p_k}{\partial a} = \tfrac13 S_k,\qquad "
              r"\frac{\partial p_k}{\partial c} = \tfrac13 S_{k+1}",),
             (Claim(sp.powsimp(sp.expand(force) * power), plain),
              Claim(sp.diff(plain, a), s * power / 3), Claim(sp.diff(plain, c), y * power / 3),
              Claim(sp.simplify(a * sp.diff(plain, a) + c * sp.diff(plain, c)), plain / 3)), result=True),
        Step("Poisson's ratio",
             r"It enters through $\lambda_0$ alone.",
             tuple(rf"\frac{{\mathrm{{d}}{latex(symbol)}}}{{\mathrm{{d}}\nu}} = {latex(by[nu])}"
                   for symbol, by in LAM_PARTIALS.items()),
             tuple(Claim(sp.diff(whole, nu), LAM_PARTIALS[symbol][nu])
                   for symbol, whole in ((lam, LAM), (one_minus_lam, ONE_MINUS_LAM)))),
    )


def _slip_steps() -> tuple[Step, ...]:
    sheared = sp.sqrt(s * y)
    h = a * s + c * y - side * d * sheared / mu
    in_forces = h.subs(d, c - a)
    omega, delta = sp.Symbol("omega", positive=True), sp.Symbol("delta", positive=True)
    peak = sp.integrate((1 + omega**2) ** sp.Rational(-2, 3), (omega, 0, sp.oo))
    return (
        Step("Slip",
             r"Where a contact sticks, $k_r$ is $\lambda_0$ times the cube root of $h$, the normal force less the "
             r"shear force over $\mu$, with $\pm$ the sign of $c - a$. At the edge of a sliding range $h$ is zero, so "
             "that the moving edge adds nothing: only contacts that stick count. Where $a = c$ the shear force has a "
             "corner and the slopes by $D_{33}$ and SR have a jump.",
             (r"\frac{\partial h}{\partial a} = s \pm \frac{x\sqrt s}{\mu},\qquad "
              r"\frac{\partial h}{\partial c} = y \mp \frac{x\sqrt s}{\mu},\qquad "
              r"\frac{\partial h}{\partial \mu} = \frac{|c-a|\,x\sqrt s}{\mu^2},\qquad "
              r"\frac{\partial q_k}{\partial\theta} = \tfrac13\Bigl\langle E W^2 s^{2-k}x^{2k}h^{-2/3}\,"
              r"\frac{\partial h}{\partial\theta}\Bigr\rangle",),
             (Claim(sp.diff(in_forces, a), s + side * sheared / mu),
              Claim(sp.diff(in_forces, c), y - side * sheared / mu),
              Claim(sp.diff(h, mu), side * d * sheared / mu**2)), result=True),
        Step("Near the onset of sliding",
             r"Next to the direction $\omega = 0$ that is nearest to sliding $h$ is proportional to $\delta + "
             r"\omega^2$. The integral of $h^{-2/3}$ grows like $|\delta|^{-1/6}$, so that the slopes by $D_{33}$, SR "
             "and $\\mu$ are infinite exactly at the onset, and finite beside it.",
             (rf"\int_0^\infty\frac{{\mathrm{{d}}\omega}}{{(\delta+\omega^2)^{{2/3}}}} = "
              rf"\delta^{{-1/6}}\,{latex(peak)}",),
             (Claim(sp.simplify(sp.gammasimp(peak) / (sp.sqrt(sp.pi) * sp.gamma(sp.Rational(1, 6))
                                                      / (2 * sp.gamma(sp.Rational(2, 3))))), sp.Integer(1)),
              Claim(sp.powdenest(((delta + (sp.sqrt(delta) * omega) ** 2) / delta) ** sp.Rational(-2, 3), force=True),
                    (1 + omega**2) ** sp.Rational(-2, 3)))),
    )


def _static_steps() -> tuple[Step, ...]:
    force, branch = a * s + c * y, w0 * s + w1 * y
    core = branch**-3 * force ** sp.Rational(-4, 3)
    soft = branch**-2 * force**-THIRD
    block, change = (sp.Matrix(2, 2, lambda i, j, name=name: sp.Symbol(f"{name}{min(i, j)}{max(i, j)}"))
                     for name in ("S", "T"))
    small = sp.Symbol("epsilon")
    moved = (block + small * change).inv().diff(small).subs(small, 0)
    return (
        Step("Static hypothesis",
             r"With $T_m = \langle s^{5-m}x^{2m}W^{-3}(as+cy)^{-4/3}\rangle$ the moments of $E/(W^2k_n)$ and all their "
             "slopes are sums of positive terms again.",
             (r"\frac{1}{W^2 k_n} = \frac{W\,(as+cy)}{W^3 (as+cy)^{4/3}},\qquad "
              r"\frac{\partial}{\partial W}\frac1{W^2} = -\frac2{W^3},\qquad "
              r"\frac{\partial}{\partial a}\frac1{k_n} = -\frac{s}{3(as+cy)^{4/3}}",),
             (Claim(sp.simplify(branch * force * core / soft), sp.Integer(1)),
              Claim(sp.simplify(sp.diff(soft, w0) / (-2 * s * force * core)), sp.Integer(1)),
              Claim(sp.simplify(sp.diff(soft, a) / (-s * branch * core / 3)), sp.Integer(1)))),
        Step("Slope of the inverse",
             "The stiffness is the inverse of the compliance, shown here for the block of the two stretches.",
             (r"C' = -C\,S'\,C",),
             tuple(Claim(sp.cancel(sp.together(entry)), sp.Integer(0))
                   for entry in moved + block.inv() * change * block.inv()), result=True),
    )


def _reference_step() -> Step:
    reference = ((coordination / (1 + void_ratio)) ** sp.Rational(2, 3) * mean_stress**THIRD
                 * (shear_modulus / (1 - nu)) ** sp.Rational(2, 3))
    log = sp.expand_log(sp.log(reference), force=True)
    return Step(
        "In pascals",
        r"All components are multiplied by $(M/V)\,\ell_e^2 k_n^\circ$, which is the product of "
        r"$(\bar N/(1+e))^{2/3}$, $(G_s/(1-\nu))^{2/3}$, $p^{1/3}$ and a number. Where $\bar N$ follows from $e$ by a "
        r"line, the slope by $e$ has that part too.",
        (r"\frac{\partial\ln C}{\partial e}\Big|_{\bar N} = -\frac{2}{3(1+e)},\qquad "
         r"\frac{\partial\ln C}{\partial\bar N} = \frac{2}{3\bar N},\qquad "
         r"\frac{\partial\ln C}{\partial p} = \frac1{3p},\qquad \frac{\partial\ln C}{\partial G_s} = \frac2{3G_s}",),
        (Claim(sp.diff(log, void_ratio), -sp.Rational(2, 3) / (1 + void_ratio)),
         Claim(sp.diff(log, coordination), sp.Rational(2, 3) / coordination),
         Claim(sp.diff(log, nu), sp.Rational(2, 3) / (1 - nu)),
         Claim(sp.diff(log, mean_stress), THIRD / mean_stress),
         Claim(sp.diff(log, shear_modulus), sp.Rational(2, 3) / shear_modulus)), result=True)


def _constant_step() -> Step:
    assignments = gradients_kinematic.constant()
    variables = (D33, Dr33, nu)
    forward: dict[sp.Symbol, sp.Expr] = {}
    for symbol, expression in with_slopes(assignments, variables, partials=LAM_PARTIALS):
        forward[symbol] = expression.xreplace(forward)
    closed = closed_components()
    return Step(
        "Constant contact stiffness",
        "The closed forms are polynomials in $D_{33}$ and $D^r_{33}$. What is emitted carries slopes along with the "
        "values, one assignment each; put together they are the derivatives of the closed forms.",
        tuple(rf"\frac{{\partial {latex(symbol)}}}{{\partial {latex(v)}}}\Big|_0 = "
              + latex(sp.factor(sp.diff(form, v).subs({D33: 0, Dr33: 0})))
              for symbol, form in list(zip(STIFFNESS, closed, strict=True))[:2] for v in (D33, Dr33)),
        tuple(Claim(sp.cancel(sp.together(forward[slope_symbol(symbol, v)] - sp.diff(form, v))), sp.Integer(0))
              for symbol, form in zip(STIFFNESS, closed, strict=True) for v in variables))


@cache
def gradients() -> Derivation:
    """Derive the slopes of every component by everything that it depends on."""
    return Derivation(
        name="gradients",
        title="Slopes of the stiffness",
        sources=("(7)", "(20)", "(21)", "(23)", "Figure 1(b)"),
        assumptions=("As for the components: uniform strain or contact forces from the mean stress, branches parallel "
                     "to contact normals, a density of contact normals of rank two.",),
        domain=("-1 <= D33 <= 2", "-1 < Dr33 < 2", "0 <= nu <= 1/2", "a, c > 0: no contact opens",
                "with slip: mu > 0, not exactly at the onset of sliding", "the emitted series: 1/9 <= c/a <= 9"),
        inputs=(D33, Dr33, SR, mu, nu),
        outputs=tuple(Output(slope_symbol(symbol, v), sp.factor(sp.diff(form, v)))
                      for v in (D33, Dr33, nu) for symbol, form in zip(STIFFNESS, closed_components(), strict=True)),
        steps=(_constant_step(), *_force_steps(), *_slip_steps(), *_static_steps(), _reference_step(),
               gradients_batch.step()),
        functions=(gradients_kinematic.constant_gradient(), gradients_kinematic.kinetic_gradient(),
                   gradients_static.constant_gradient(), gradients_static.kinetic_gradient(),
                   gradients_static.inverse_slope(), gradients_kinematic.normal_moments(),
                   gradients_static.normal_moments(), shear_slopes(), reference_slopes(),
                   gradients_series.force_moments()),
        batch=gradients_batch.batch(),
    )
