"""Moments of the fabric weighted with contact stiffnesses that follow from the contact forces, no contact slipping.

The normal stiffness grows with the cube root of the normal force a s + c y. Its moments are hypergeometric functions,
and these are elementary apart from one Legendre integral of the first kind.
"""

from __future__ import annotations

from functools import cache

import sympy as sp

from derivations import batch_kinetic, legendre
from derivations.fabric import BRANCH_FORM, DENSITY_FORM, density_form
from derivations.kinematic import ASSUMPTIONS, EQUAL_TANGENTS, WEIGHT_SYMBOLS, weight_form
from derivations.kinetic_series import SOFT, STIFF, THIRD, kinematic_function, series_steps, static_function
from derivations.record import Claim, Derivation, Output, Step
from derivations.sphere import axial_moment, homogeneous
from derivations.symbols import (
    D33,
    D3333,
    NORMAL_FLEXIBILITIES,
    POSITIVE_MOMENTS,
    Dr33,
    a,
    c,
    d,
    e0,
    e1,
    e2,
    s,
    w0,
    w1,
    x,
    y,
)

t = sp.Symbol("tau", real=True)
"""Relative difference of the forces, c/a - 1."""

z, k, n, m = sp.symbols("z k n m", positive=True)
u = sp.Symbol("u", positive=True)

DEGREE = 6
HALF = sp.Rational(1, 2)


def kinetic_moment(index: int, power: sp.Rational = STIFF, degree: int = DEGREE) -> sp.Expr:
    """Integral of s^(degree-m) y^m (a s + c y)^power over x from 0 to 1, as a hypergeometric function."""
    start = axial_moment(degree - index, index)
    return a**power * start * sp.hyper((-power, index + HALF), (degree + 3 * HALF,), 1 - c / a)


def kinetic_moment_from_pole(index: int, power: sp.Rational = STIFF, degree: int = DEGREE) -> sp.Expr:
    """The same after Pfaff's transformation: the argument stays in [0, 1) for c > a."""
    start = axial_moment(degree - index, index)
    return c**power * start * sp.hyper((-power, degree + 1 - index), (degree + 3 * HALF,), 1 - a / c)


def legendre_integral(relative_difference: sp.Expr) -> sp.Expr:
    """Integral of (1 + t x^2)^(-2/3) over x from 0 to 1 by Legendre's F, for a number t > -1 other than 0."""
    value = sp.sympify(relative_difference)
    kind = 1 if value > 0 else 2
    return sp.Rational(3, 2) / sp.sqrt(abs(value)) * legendre.first_kind(kind, (1 + value) ** THIRD)


def power_integrals(relative_difference: sp.Expr, count: int) -> tuple[sp.Expr, ...]:
    """I_k = integral of x^(2k) (1 + t x^2)^(1/3) over x from 0 to 1 by one F and the two-term recurrence."""
    value = sp.sympify(relative_difference)
    end = (1 + value) ** THIRD
    found = [sp.Rational(3, 5) * end + sp.Rational(2, 5) * legendre_integral(value)]
    for i in range(1, count):
        found.append(((1 + value) * end - (2 * i - 1) * found[-1]) / ((2 * i + sp.Rational(5, 3)) * value))
    return tuple(found)


def elliptic_moment(index: int, at_equator: sp.Expr, at_pole: sp.Expr) -> sp.Expr:
    """A_m in elementary terms and one F, for numbers a and c that differ."""
    integrals = power_integrals(sp.sympify(at_pole) / at_equator - 1, DEGREE + 1)
    total = sum((sp.binomial(DEGREE - index, q) * (-1) ** q * integrals[index + q] for q in range(DEGREE - index + 1)),
                sp.Integer(0))
    return sp.sympify(at_equator) ** THIRD * total


def closed_moments() -> tuple[sp.Expr, ...]:
    """<E W^2 k_n s^(2-k) y^k> over k_n,ref as hypergeometric functions."""
    to_fabric = dict(zip((e0, e1, e2, w0, w1), (*DENSITY_FORM, *BRANCH_FORM), strict=True))
    weights = tuple(weight.subs(to_fabric) for weight in weight_form())
    return tuple(sum((weight * kinetic_moment(j + row) for j, weight in enumerate(weights)), sp.Integer(0))
                 for row in range(3))


def closed_flexibilities() -> tuple[sp.Expr, ...]:
    """<E s^(2-k) y^k/k_n> times k_n,ref as hypergeometric functions, for branches of one length."""
    return tuple(sum((weight * kinetic_moment(j + row, SOFT, 4) for j, weight in enumerate(DENSITY_FORM)),
                     sp.Integer(0)) for row in range(3))


def _moment_step() -> Step:
    form = sum(o * s ** (4 - j) * y**j for j, o in enumerate(WEIGHT_SYMBOLS))
    degree_six = sum(o * s ** (6 - j) * y**j for j, o in enumerate(WEIGHT_SYMBOLS))
    tangential = homogeneous(density_form() * s**2, 4)
    return Step(
        "Stiffness from the contact force, eq. (20)",
        r"The normal stiffness grows with the cube root of the normal force, which is $as + cy$ over that of the "
        r"isotropic assembly. Without slip $k_r = \lambda k_n$, so the components for constant stiffness hold with "
        r"moments of $E W^2 k_n$, and seven integrals give those.",
        (r"\frac{k_n}{k_n^{\circ}} = (as + cy)^{1/3},\qquad p_k = \sum_{j=0}^4\omega_j A_{j+k},\qquad "
         r"A_m = \int_0^1 s^{6-m}x^{2m}(as+cy)^{1/3}\,\mathrm{d}x",),
        (Claim(sp.expand(form * s**2), sp.expand(degree_six)),
         Claim(sp.expand(sum(e * s ** (4 - j) * y**j for j, e in enumerate(tangential))),
               sp.expand(density_form() * s**2)),
         *(Claim(kinetic_moment(i).subs(c, a), a**THIRD * axial_moment(6 - i, i)) for i in range(7))), result=True)


def _euler_steps() -> tuple[Step, ...]:
    """Expand the integrand in powers of z = 1 - c/a; the ratio of successive terms identifies the function."""
    here, ahead = (sp.beta(m + n + j + HALF, 7 - m).rewrite(sp.gamma) for j in (0, 1))
    factor = (sp.binomial(THIRD, n + 1) / sp.binomial(THIRD, n)).rewrite(sp.gamma)
    hyper_ratio = (n - THIRD) * (n + m + HALF) / ((n + 15 * HALF) * (n + 1))
    pole_ratio = (n - THIRD) * (n + 7 - m) / ((n + 15 * HALF) * (n + 1))
    from_pole = tuple(sp.beta(m + HALF, 7 - m + n + j).rewrite(sp.gamma) for j in (0, 1))
    return (
        Step("Hypergeometric form",
             r"With $y = x^2$ as the variable this is Euler's integral. Expanded in $z = 1 - c/a$ its terms are beta "
             "functions, and the ratio of one to the next is that of a hypergeometric function, for every $m$ at once.",
             (r"A_m = \frac{a^{1/3}}{2}\,\mathrm{B}\!\left(m+\tfrac12, 7-m\right)\,"
              r"{}_2F_1\!\left(-\tfrac13, m+\tfrac12; \tfrac{15}{2}; 1-\tfrac ca\right)",),
             (Claim(sp.expand((a * s + c * y).subs(s, 1 - y)), sp.expand(a * (1 - (1 - c / a) * y))),
              Claim(sp.diff(sp.sqrt(y), y) * s ** (6 - m) * y**m, s ** (6 - m) * y ** (m - HALF) / 2),
              Claim(_ratio(-factor * ahead / here), sp.cancel(hyper_ratio)),
              *(Claim(sp.beta(i + HALF, 7 - i).rewrite(sp.gamma) / 2, axial_moment(6 - i, i)) for i in range(7)),
              *(Claim(_binomial_coefficient(i, order), _hyper_coefficient(i, order))
                for i in range(7) for order in range(4))), result=True),
        Step("Seen from the pole",
             r"Exchanging $s$ and $y$ gives the expansion in $1 - a/c$, which is Pfaff's transformation of the first "
             "form. The argument then lies between 0 and 1 for $c > a$.",
             (r"A_m = \frac{c^{1/3}}{2}\,\mathrm{B}\!\left(m+\tfrac12, 7-m\right)\,"
              r"{}_2F_1\!\left(-\tfrac13, 7-m; \tfrac{15}{2}; 1-\tfrac ac\right)",),
             (Claim(sp.expand((a * s + c * y).subs(y, 1 - s)), sp.expand(c * (1 - (1 - a / c) * s))),
              Claim(_ratio(-factor * from_pole[1] / from_pole[0]), sp.cancel(pole_ratio)),
              Claim(sp.cancel((z / (z - 1)).subs(z, 1 - c / a)), sp.cancel(1 - a / c)),
              Claim(15 * HALF - (m + HALF), 7 - m),
              Claim(a**THIRD * (1 - (1 - c / a)) ** THIRD, c**THIRD)), result=True),
    )


def _ratio(of_gammas: sp.Expr) -> sp.Expr:
    """Reduce a ratio of gamma functions whose arguments differ by whole numbers."""
    return sp.cancel(sp.expand_func(of_gammas))


def _binomial_coefficient(index: int, order: int) -> sp.Rational:
    """Coefficient of z^order in A_m over a^(1/3), by the binomial series under the integral."""
    return sp.binomial(THIRD, order) * (-1) ** order * axial_moment(6 - index, index + order)


def _hyper_coefficient(index: int, order: int) -> sp.Rational:
    """The same from the hypergeometric series."""
    rising = sp.rf(-THIRD, order) * sp.rf(index + HALF, order) / (sp.rf(15 * HALF, order) * sp.factorial(order))
    return axial_moment(6 - index, index) * rising


def _recurrence_steps() -> tuple[Step, ...]:
    """Derivatives of products of powers, by their logarithms: T' = T (log T)'."""
    base, sine, force = 1 + t * x**2, 1 - x**2, a * (1 - x**2) + c * x**2
    of_two = (2 * k - 1) * sp.log(x) + sp.Rational(4, 3) * sp.log(base)
    of_three = (2 * k - 1) * sp.log(x) + (6 - k) * sp.log(sine) + sp.Rational(4, 3) * sp.log(force)
    two_terms = (2 * k - 1) + (2 * k + sp.Rational(5, 3)) * t * x**2
    bracket = ((2 * k - 1) * a * s**2 + _middle() * s * y - 2 * (6 - k) * c * y**2).subs({s: sine, y: x**2})
    return (
        Step("Two-term recurrence",
             r"With $\tau = c/a - 1$ the powers of $x$ have integrals $I_k$ that follow one from the other: integrate "
             r"the derivative of $x^{2k-1}(1+\tau x^2)^{4/3}$ from 0 to 1.",
             (r"I_k = \int_0^1 x^{2k}(1+\tau x^2)^{1/3}\,\mathrm{d}x,\qquad "
              r"\left(2k+\tfrac53\right)\tau I_k = (1+\tau)^{4/3} - (2k-1) I_{k-1}",),
             (Claim(sp.cancel(sp.diff(of_two, x) * x * base), sp.expand(two_terms)),), result=True),
        Step("Three-term recurrence",
             r"In the same way the derivative of $x^{2k-1}s^{6-k}(as+cy)^{4/3}$ links three neighbours. It vanishes at "
             "both ends for $k$ from 1 to 5, and nothing but the moments themselves remains.",
             (r"(2k-1)\,a A_{k-1} + \left[(2k-1)c - 2(6-k)a + \tfrac83(c-a)\right] A_k - 2(6-k)\,c A_{k+1} = 0",),
             (Claim(sp.cancel(sp.diff(of_three, x) * x * sine * force), sp.expand(bracket)),
              *(Claim(sp.expand(_recurrence_on_series(i)), sp.Integer(0)) for i in range(1, 6)))),
    )


def _middle() -> sp.Expr:
    return (2 * k - 1) * c - 2 * (6 - k) * a + sp.Rational(8, 3) * (c - a)


def _recurrence_on_series(i: int) -> sp.Expr:
    """The three-term relation on the first powers of z, with a = 1 and c = 1 - z."""
    order = 4
    series = [sum(_binomial_coefficient(index, q) * z**q for q in range(order)) for index in (i - 1, i, i + 1)]
    at = {k: i, a: 1, c: 1 - z}
    total = sp.expand(((2 * k - 1) * a).subs(at) * series[0] + _middle().subs(at) * series[1]
                      - (2 * (6 - k) * c).subs(at) * series[2])
    return sum((total.coeff(z, q) * z**q for q in range(order)), sp.Integer(0))


def _legendre_steps() -> tuple[Step, ...]:
    base = 1 + t * x**2
    by_parts = sp.Rational(3, 5) * sp.diff(x * base**THIRD, x) + sp.Rational(2, 5) * base ** (-2 * THIRD)
    size = sp.Symbol("abs_tau", positive=True)
    above, below = sp.sqrt((u**3 - 1) / size), sp.sqrt((1 - u**3) / size)
    above_form, below_form, _ = legendre.elliptic_identity_steps()
    pattern = tuple(sp.binomial(6, q) * (-1) ** q for q in range(7))
    return (
        Step("One integral is left",
             r"All $A_m$ are combinations of the $I_k$, and the recurrence leads them back to $I_0$. Integration by "
             r"parts takes the elementary part out of it; what is left is the integral $J$ of $(1+\tau x^2)^{-2/3}$.",
             (r"A_m = a^{1/3}\sum_{q=0}^{6-m}\binom{6-m}{q}(-1)^q I_{m+q},\qquad "
              r"I_0 = \tfrac35(1+\tau)^{1/3} + \tfrac25 J",),
             (Claim(sp.simplify(by_parts / base**THIRD), sp.Integer(1)),
              Claim(sp.expand((1 - y) ** 6), sum(factor * y**q for q, factor in enumerate(pattern)))),
             result=True),
        above_form,
        below_form,
        Step("Elementary terms and one Legendre integral",
             r"With $u^3 = 1 + \tau x^2$ as the variable, $J$ is the integral of $1/\sqrt{u^3-1}$ for $c > a$, and of "
             r"$1/\sqrt{1-u^3}$ for $c < a$. The modulus is $\sin 15^\circ$ or $\sin 75^\circ$, whatever the "
             r"forces. Near $\tau = 0$ this form loses digits, so it serves as an identity.",
             (r"J = \frac{3}{2\sqrt{\tau}}\,3^{-1/4} F\!\left(\varphi\,\Big|\,\frac{2-\sqrt3}{4}\right),\quad "
              r"\cos\varphi = \frac{\sqrt3+1-u_1}{\sqrt3-1+u_1},\quad u_1 = (1+\tau)^{1/3} > 1",
              r"J = \frac{3}{2\sqrt{-\tau}}\,3^{-1/4} F\!\left(\varphi\,\Big|\,\frac{2+\sqrt3}{4}\right),\quad "
              r"\cos\varphi = \frac{\sqrt3-1+u_1}{\sqrt3+1-u_1},\quad u_1 < 1"),
             (Claim(sp.simplify(sp.diff(above, u) / u**2 * sp.sqrt(size) * sp.sqrt(u**3 - 1)), sp.Rational(3, 2)),
              Claim(sp.simplify(-sp.diff(below, u) / u**2 * sp.sqrt(size) * sp.sqrt(1 - u**3)), sp.Rational(3, 2)),
              Claim(sp.expand(1 + size * above**2), u**3), Claim(sp.expand(1 - size * below**2), u**3)),
             result=True),
    )


@cache
def kinetic() -> Derivation:
    """Derive the moments of E W^2 k_n and of E/k_n when the contact stiffness follows the contact force."""
    return Derivation(
        name="kinetic",
        title="Moments of the kinetic fabric without slip",
        sources=("(7)", "(20)", "(25)", "(26)"),
        assumptions=(ASSUMPTIONS[1], "Contact forces follow from the mean stress and the fabric tensor of rank two.",
                     EQUAL_TANGENTS, "No contact slips and none opens."),
        domain=("a, c > 0", "E nowhere negative", "-1 < Dr33 < 2; static: Dr33 = 0",
                "the emitted series: 1/9 <= c/a <= 9"),
        inputs=(D33, D3333, Dr33, a, c, d),
        outputs=(*(Output(symbol, e) for symbol, e in zip(POSITIVE_MOMENTS, closed_moments(), strict=True)),
                 *(Output(symbol, e) for symbol, e in zip(NORMAL_FLEXIBILITIES, closed_flexibilities(), strict=True))),
        steps=(_moment_step(), *_euler_steps(), *_recurrence_steps(), *_legendre_steps(), *series_steps(),
               *batch_kinetic.steps()),
        functions=(kinematic_function(), static_function()),
        batch=batch_kinetic.batch(),
    )
