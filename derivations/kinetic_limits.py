"""Limits of the stiffness with contact forces: weak and strong anisotropy of the stress, friction, onset of sliding.

The integrals are those of :mod:`derivations.kinetic`, of degree six: A_k = <s^(6-k) x^(2k) k_n> and, with slip,
H_k = <s^(6-k) x^(2k) k_r>/lambda_0 over x from 0 to 1, k from 0 to 6.
"""

from __future__ import annotations

from functools import cache

import sympy as sp

from derivations import kinematic, kinetic_components
from derivations.kinetic import kinetic_moment, kinetic_moment_from_pole
from derivations.kinetic_series import THIRD
from derivations.record import Claim, Derivation, Output, Step
from derivations.sphere import axial_moment
from derivations.symbols import (
    POSITIVE_MOMENTS,
    STIFFNESS,
    TANGENTIAL_MOMENTS,
    a,
    beta,
    c,
    d0,
    d1,
    lam,
    latex,
    mu,
    one_minus_lam,
    p0,
    p1,
    p2,
    q0,
    q1,
    q2,
    s,
    x,
    y,
)

HALF = sp.Rational(1, 2)
DEGREE = 6

t = sp.Symbol("tau", real=True)
w, size, ratio, small = sp.symbols("w abs_d r epsilon_1", positive=True)
onset_stick = sp.Symbol("K_stick", positive=True)
onset_slip = sp.Symbol("K_slip", negative=True)


def gammas(expression: sp.Expr) -> sp.Expr:
    """Reduce gamma functions: of symbols where arguments differ by whole numbers, of numbers to arguments in (0, 1]."""
    reduced = sp.expand_func(expression.rewrite(sp.gamma))
    return sp.simplify(reduced.replace(lambda e: isinstance(e, sp.gamma) and e.args[0].is_Rational,
                                       lambda e: _shifted_gamma(e.args[0])))


def _shifted_gamma(number: sp.Rational) -> sp.Expr:
    """Gamma of a rational by Gamma(z + 1) = z Gamma(z), from the one with its argument in (0, 1]."""
    start = number - sp.ceiling(number) + 1
    return sp.gamma(start) * (sp.rf(start, number - start) if number >= start else 1 / sp.rf(number, start - number))


@cache
def weak_moments(order: int = 3) -> tuple[sp.Expr, ...]:
    """Moments of k_n over a^(1/3) for an isotropic fabric, to the powers of tau = c/a - 1 below ``order``."""
    return tuple(sum((sp.binomial(THIRD, n) * axial_moment(2 - k, k + n) * t**n for n in range(order)), sp.Integer(0))
                 for k in range(3))


@cache
def weak_components() -> tuple[sp.Expr, ...]:
    """Six components over a^(1/3) to second order in tau, isotropic fabric, no slip."""
    at = dict(zip(POSITIVE_MOMENTS, weak_moments(), strict=True))
    return tuple(sp.collect(sp.expand(e.subs(one_minus_lam, 1 - lam).xreplace(at)), t)
                 for e in kinematic.positive_components())


WEAK = {
    "C1111": ((3 + 2 * lam) / 15, sp.Rational(1, 105) + 4 * lam / 315, -(1 + 2 * lam) / 945),
    "C3333": ((3 + 2 * lam) / 15, sp.Rational(1, 21) + 2 * lam / 105, -sp.Rational(1, 81) - 2 * lam / 567),
    "C1122": tuple((1 - lam) * f for f in (sp.Rational(1, 15), sp.Rational(1, 315), -sp.Rational(1, 2835))),
    "C1133": tuple((1 - lam) * f for f in (sp.Rational(1, 15), sp.Rational(1, 105), -sp.Rational(1, 567))),
    "C2323": (sp.Rational(1, 15) + lam / 10, sp.Rational(1, 105) + 4 * lam / 315,
              -sp.Rational(1, 567) - 17 * lam / 5670),
    "C1212": (sp.Rational(1, 15) + lam / 10, sp.Rational(1, 315) + lam / 126, -sp.Rational(1, 2835) - lam / 810),
}
"""Coefficients of 1, tau, tau^2, written so that they can be read."""


def at_pole_only(index: int) -> sp.Expr:
    """A_k over c^(1/3) when the stress along the axis is overwhelming."""
    return sp.beta(index + sp.Rational(5, 6), DEGREE + 1 - index) / 2


def at_equator_only(index: int) -> sp.Expr:
    """A_k over a^(1/3) when the stress across the axis is overwhelming."""
    return sp.beta(index + HALF, DEGREE + 4 * THIRD - index) / 2


def little_slip(index: int) -> sp.Expr:
    """Limit of mu (A_k - H_k)/|c - a| for large mu: a third of <s^(6-k) x^(2k) x sqrt(s) (a s + c y)^(-2/3)>."""
    upper, lower = (2 * THIRD, sp.Integer(index + 1)), (DEGREE + 5 * HALF,)
    return (a ** (-2 * THIRD) * sp.beta(index + 1, DEGREE + 3 * HALF - index) / 6
            * sp.hyper(upper, lower, 1 - c / a))


def sticking_at_equator(index: int) -> sp.Expr:
    """What the contacts near the equator add to H_k for small mu."""
    return a**THIRD * (mu * a / size) ** (2 * index + 1) * sp.beta(2 * index + 1, 4 * THIRD)


def sticking_at_pole(index: int) -> sp.Expr:
    """What the contacts near the pole add to H_k for small mu."""
    power = 2 * (DEGREE - index) + 2
    return c**THIRD * (mu * c / size) ** power * sp.beta(power, 4 * THIRD)


ONSET_STICK = sp.sqrt(sp.pi) * sp.gamma(-sp.Rational(5, 6)) / sp.gamma(-THIRD)
ONSET_SLIP = sp.gamma(sp.Rational(4, 3)) * sp.gamma(-sp.Rational(5, 6)) / sp.sqrt(sp.pi)


def _gauss(kind: sp.Expr) -> sp.Expr:
    """Value of the hypergeometric function of a product at the argument 1, by Gauss's theorem."""
    (function,) = kind.atoms(sp.hyper)
    (first, second), (third,) = function.ap, function.bq
    value = (sp.gamma(third) * sp.gamma(third - first - second)
             / (sp.gamma(third - first) * sp.gamma(third - second)))
    return kind.subs(function, value)


def _stress_steps() -> tuple[Step, ...]:
    shown = tuple(
        f"{latex(symbol)} = {latex(first)} + \\left({latex(second)}\\right)\\tau"
        f" + \\left({latex(third)}\\right)\\tau^2 + \\dots"
        for symbol in STIFFNESS for first, second, third in [WEAK[symbol.name]])
    expected = tuple(sum((f * t**n for n, f in enumerate(WEAK[symbol.name])), sp.Integer(0)) for symbol in STIFFNESS)
    return (
        Step("Nearly equal forces",
             r"For an isotropic fabric the moments are power series in $\tau = c/a - 1$. Over $(M/V)\ell_e^2 k_n^\circ "
             r"a^{1/3}$ and to second order the components are",
             shown,
             (*(Claim(found, sp.expand(wanted)) for found, wanted in zip(weak_components(), expected, strict=True)),
              Claim(sp.series((1 + t * y) ** THIRD, t, 0, 3).removeO(),
                    sum(sp.binomial(THIRD, n) * (t * y) ** n for n in range(3)))), result=True),
        Step("Isotropic limit",
             r"At $\tau = 0$, $a = 1$ these are the components for constant stiffness, with bulk modulus $1/9$ and the "
             r"shear modulus $(2+3\lambda)/30$.",
             (r"C_{1111} = C_{3333} = \frac{3+2\lambda}{15},\quad C_{1122} = C_{1133} = \frac{1-\lambda}{15},\quad "
              r"C_{2323} = C_{1212} = \frac{2+3\lambda}{30}",),
             (*(Claim(component.subs(t, 0),
                      e.subs(one_minus_lam, 1 - lam).xreplace(kinematic.isotropic_moments()))
                for component, e in zip(weak_components(), kinematic.positive_components(), strict=True)),
              Claim(((weak_components()[1] + 2 * weak_components()[3]) / 3).subs(t, 0), sp.Rational(1, 9)))),
        Step("Overwhelming stress along the axis",
             r"For $c/a\to\infty$ the normal force is $cy$ everywhere but at the equator, and Gauss's theorem gives "
             "the hypergeometric function at 1.",
             (r"A_k \to \frac{c^{1/3}}{2}\,\mathrm{B}\!\left(k+\tfrac56, 7-k\right)",),
             (Claim(sp.limit(((a * s + c * y) / c).subs(a, ratio * c), ratio, 0), y),
              *(Claim(gammas(_gauss(kinetic_moment_from_pole(k)) / c**THIRD), gammas(at_pole_only(k)))
                for k in range(DEGREE + 1))), result=True),
        Step("Overwhelming stress across the axis",
             r"For $c/a\to 0$ it is $as$ everywhere but at the pole.",
             (r"A_k \to \frac{a^{1/3}}{2}\,\mathrm{B}\!\left(k+\tfrac12, \tfrac{22}{3}-k\right)",),
             (Claim(((a * s + c * y) / a).subs(c, 0), s),
              *(Claim(gammas(_gauss(kinetic_moment(k)) / a**THIRD), gammas(at_equator_only(k)))
                for k in range(DEGREE + 1))), result=True),
    )


def _friction_steps() -> tuple[Step, ...]:
    force, shear = sp.symbols("g q", positive=True)
    loss = sp.series(force**THIRD - (force - small * shear) ** THIRD, small, 0, 2).removeO()
    margin = (a * sp.sin(beta) ** 2 + c * sp.cos(beta) ** 2 - size * sp.sin(beta) * sp.cos(beta) / mu)
    near_pole = sp.limit(margin.subs(beta, mu * c * w / size), mu, 0)
    near_equator = sp.limit(margin.subs(beta, sp.pi / 2 - mu * a * w / size), mu, 0)
    scale = sp.Symbol("scale", positive=True)
    rest = 1 - w
    caps = ((-3 * rest ** (4 * THIRD) / 4, rest**THIRD),
            (3 * rest ** (7 * THIRD) / 7 - 3 * rest ** (4 * THIRD) / 4, rest**THIRD - rest ** (4 * THIRD)))
    return (
        Step("Large friction",
             r"$k_n - k_r/\lambda_0$ falls with $1/\mu$, so the moments with slip approach those without from below.",
             (r"A_k - H_k \to \frac{|c-a|}{3\mu}\int_0^1\frac{s^{6-k}x^{2k}\,x\sqrt s}{(as+cy)^{2/3}}\,\mathrm{d}x"
              r" = \frac{|c-a|}{6\mu a^{2/3}}\,\mathrm{B}\!\left(k+1,\tfrac{15}{2}-k\right)"
              r"{}_2F_1\!\left(\tfrac23,k+1;\tfrac{17}{2};1-\tfrac ca\right)",),
             (Claim(sp.simplify(loss), small * shear / (3 * force ** (2 * THIRD))),
              *(Claim(gammas(sp.binomial(-2 * THIRD, n) * (-1) ** n * sp.beta(k + n + 1, sp.Rational(15, 2) - k)),
                      gammas(sp.beta(k + 1, sp.Rational(15, 2) - k) * sp.rf(2 * THIRD, n) * sp.rf(k + 1, n)
                             / (sp.rf(sp.Rational(17, 2), n) * sp.factorial(n))))
                for k in range(DEGREE + 1) for n in range(3))), result=True),
        Step("Small friction",
             r"For $a \ne c$ only contacts near the equator and near the pole still stick when $\mu\to 0$: there the "
             r"shear force vanishes. With $\beta = (\mu c/|c-a|)\,w$ from the pole, and the same with $a$ from the "
             r"equator, the margin to sliding is $c(1-w)$ and $a(1-w)$, and $k_r$ goes to zero in every direction.",
             (r"H_0 \to \tfrac34 a^{1/3}\,\frac{\mu a}{|c-a|},\qquad "
              r"H_6 \to \tfrac{9}{28}c^{1/3}\left(\frac{\mu c}{|c-a|}\right)^2",),
             (Claim(sp.expand(near_pole), sp.expand(c * (1 - w))),
              Claim(sp.expand(near_equator), sp.expand(a * (1 - w))),
              Claim(sp.limit(sp.sin(scale * w) / scale, scale, 0), w),
              *(Claim(sp.expand(sp.diff(primitive, w)), sp.expand(integrand)) for primitive, integrand in caps),
              *(Claim(primitive.subs(w, 1) - primitive.subs(w, 0), gammas(sp.beta(k, 4 * THIRD)))
                for k, (primitive, _) in enumerate(caps, start=1)),
              Claim(gammas(sticking_at_equator(0)), sp.Rational(3, 4) * a**THIRD * mu * a / size),
              Claim(gammas(sticking_at_pole(6)), sp.Rational(9, 28) * c**THIRD * (mu * c / size) ** 2)), result=True),
        Step("Equal forces",
             r"For $a = c$ the force on every contact is along its normal: no contact slips, however small $\mu > 0$.",
             (r"a = c:\quad f_r = 0,\quad k_r = \lambda_0 k_n,\quad H_k = A_k",),
             (Claim((a * s + c * y - (c - a) * x * sp.sqrt(s) / mu).subs(c, a), a * (s + y)),)),
    )


def _onset_steps() -> tuple[Step, ...]:
    exponent, b = sp.Symbol("q", positive=True), sp.Symbol("b", positive=True)
    sticking_slope = sp.integrate((1 + w**2) ** (-2 * THIRD), (w, 0, sp.oo)) * 2
    u = sp.Symbol("u", positive=True)
    sliding_slope = sp.beta(sp.Rational(1, 6), THIRD)
    return (
        Step("Scale of the onset",
             r"Near the onset the margin to sliding is $\delta + 2R\sin^2\omega$ with a small $\delta$. The change is "
             r"confined to $\omega = w\sqrt{|\delta|/2R}$, where the weight is that of $\beta^*$: it is "
             r"$|\delta|^{5/6}$ times a number, and the stiffness has an infinite slope at the onset.",
             (r"H_k - H_k\big|_{\delta=0} \to K\,\frac{|\delta|^{5/6}}{\sqrt{2R}}\,"
              r"\sin^{13-2k}\beta^*\cos^{2k}\beta^*",
              r"K = \int_{-\infty}^{\infty}\left[\max(w^2\pm1, 0)^{1/3} - |w|^{2/3}\right]\mathrm{d}w",),
             (Claim(sp.limit(sp.sin(sp.sqrt(small) * w) ** 2 / small, small, 0), w**2),
              Claim(sp.powsimp(b**THIRD * sp.sqrt(b)), b ** sp.Rational(5, 6)),
              Claim(sp.diff(-sp.cos(beta), beta) * sp.sin(beta) ** 12, sp.sin(beta) ** 13)), result=True),
        Step("Contacts about to slide",
             r"With $b$ in place of 1 the integral is $b^{5/6}K$ by scaling. Its derivative in $b$ converges, "
             r"$\tfrac13\int(b+w^2)^{-2/3}\mathrm{d}w$, and gives $K$: the value at $q=-\tfrac13$ of "
             r"$\sqrt\pi\,\Gamma(q-\tfrac12)/\Gamma(q)$, which is $\int(1+w^2)^{-q}\mathrm{d}w$ where that exists.",
             (r"K = \tfrac65\cdot\tfrac13\int_{-\infty}^{\infty}\frac{\mathrm{d}w}{(1+w^2)^{2/3}} = "
              r"\frac{\sqrt\pi\,\Gamma(-\frac56)}{\Gamma(-\frac13)} \approx "
              rf"{sp.N(ONSET_STICK, 8)}",),
             (Claim(sp.diff((b + w**2) ** THIRD, b), (b + w**2) ** (-2 * THIRD) / 3),
              Claim(sp.simplify(sticking_slope), sp.sqrt(sp.pi) * sp.gamma(sp.Rational(1, 6)) / sp.gamma(2 * THIRD)),
              Claim(gammas(sp.Rational(2, 5) * sticking_slope / ONSET_STICK), sp.Integer(1)),
              Claim(gammas(sp.gamma(exponent + HALF) / sp.gamma(exponent - HALF)), exponent - HALF)), result=True),
        Step("Contacts that slide",
             r"In the same way with $w^2 - b$; the integrand vanishes at the edges, so they do not contribute to the "
             r"derivative. With $w^2 = 1/u$ it is a beta function.",
             (r"K = -\tfrac65\cdot\tfrac13\int_{|w|>1}\frac{\mathrm{d}w}{(w^2-1)^{2/3}} = "
              r"\frac{\Gamma(\frac43)\,\Gamma(-\frac56)}{\sqrt\pi} \approx "
              rf"{sp.N(ONSET_SLIP, 8)}",),
             (Claim(sp.diff((w**2 - b) ** THIRD, b), -((w**2 - b) ** (-2 * THIRD)) / 3),
              Claim(sp.cancel((w**2 - 1).subs(w, 1 / sp.sqrt(u))), sp.cancel((1 - u) / u)),
              Claim(sp.diff(1 / sp.sqrt(u), u), -(u ** (-3 * HALF)) / 2),
              Claim(gammas(-sp.Rational(2, 5) * sliding_slope / ONSET_SLIP), sp.Integer(1))), result=True),
    )


def _hypothesis_steps() -> tuple[Step, ...]:
    apart = kinetic_components.positive_components()
    sliding = {**dict.fromkeys(TANGENTIAL_MOMENTS, sp.Integer(0)), d0: p0, d1: p1}
    alike = {q0: p0, q1: p1, q2: p2, d0: sp.Integer(0), d1: sp.Integer(0)}
    slid, same = (tuple(e.subs(at) for e in apart) for at in (sliding, alike))
    weight = sp.Symbol("rho", positive=True)
    return (
        Step("All contacts slide",
             r"With $k_r = 0$ the contact forces are central, and Cauchy's relations hold.",
             (r"k_r = 0:\quad C_{1133} = C_{2323},\quad C_{1122} = C_{1212}",),
             (Claim(slid[3], slid[4]), Claim(slid[2], slid[5])), result=True),
        Step("Equal normal and tangential stiffness",
             r"With $\nu = 0$, hence $\lambda_0 = 1$, and no slip, the lateral components vanish exactly.",
             (r"\lambda_0 = 1:\quad C_{1122} = C_{1133} = 0",),
             (Claim(same[2], sp.Integer(0)), Claim(same[3], sp.Integer(0)),
              *(Claim(e.subs({lam: 1, one_minus_lam: 0}), f)
                for e, f in zip(kinematic.positive_components(), same, strict=True)))),
        Step("A sum without the tangential stiffness",
             r"Whatever slips, the response to isotropic compression is the mean of $k_n$; and the plane across the "
             r"axis is isotropic.",
             (r"C_{3333} + 2C_{1111} + 2C_{1122} + 4C_{1133} = \langle E W^2 k_n\rangle",
              r"C_{1212} = \tfrac12\left(C_{1111} - C_{1122}\right)"),
             (Claim(sp.expand(sum(f * e for f, e in zip((2, 1, 2, 4), apart[:4], strict=True))
                              .subs({d0: p0 - q0, d1: p1 - q1})), p0 + 2 * p1 + p2),
              Claim(sp.expand(weight * (s**2 + 2 * s * y + y**2).subs(s, 1 - y)), weight),
              Claim(sp.expand((apart[5] - (apart[0] - apart[2]) / 2).subs({d0: p0 - q0})), sp.Integer(0)))),
    )


@cache
def kinetic_limits() -> Derivation:
    """Derive the limits of the stiffness with contact forces and slip."""
    return Derivation(
        name="kinetic_limits",
        title="Limits of the stiffness with contact forces",
        sources=("(7)", "(20)", "(21)"),
        assumptions=("Every contact displaces with the mean strain (kinematic hypothesis).",
                     "Branch vectors are parallel to contact normals.",
                     "Contact forces follow from the mean stress and the fabric tensor of rank two."),
        domain=("a, c > 0", "each limit as stated"),
        inputs=(lam, a, c, mu),
        outputs=(*(Output(symbol, e) for symbol, e in zip(STIFFNESS, weak_components(), strict=True)),
                 Output(onset_stick, ONSET_STICK), Output(onset_slip, ONSET_SLIP)),
        steps=(*_stress_steps(), *_friction_steps(), *_onset_steps(), *_hypothesis_steps()),
    )
