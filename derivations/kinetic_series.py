"""Moments of the kinetic fabric as they are emitted: series in one contrast, with exact coefficients.

With g = (sqrt(a) + sqrt(c))/2 and the contrast eta = (sqrt(c) - sqrt(a))/(sqrt(c) + sqrt(a)) = (c - a)/(4 g^2) the
normal force is g^2 [(1-eta)^2 s + (1+eta)^2 y], and its power q is the generating function of the Gegenbauer
polynomials C_n^(-q) in s - y. The first terms of the series add up to the moments for constant stiffness, so that only
their difference from these is computed by series.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import sympy as sp

from derivations.fabric import DENSITY_FORM, density_form
from derivations.kinematic import WEIGHT_SYMBOLS, moment_function
from derivations.record import Claim, Function, Step
from derivations.series import TruncatedSeries, gegenbauer_forms, truncate
from derivations.sphere import axial_mean, axial_moment
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
    eta,
    s,
    y,
)

THIRD = sp.Rational(1, 3)

STIFF, SOFT = THIRD, -THIRD
"""Powers of the normal force: that of k_n, and that of 1/k_n."""

DEGREE = {STIFF: 6, SOFT: 4}
"""Degree of E W^2 s^i y^j with i + j = 2, and of E s^i y^j."""

CONTRAST_LIMIT = sp.Rational(1, 2)
"""The series serve |eta| <= 1/2, which is 1/9 <= c/a <= 9."""

PRECISION = sp.Rational(1, 2**57)
"""What a truncated series may leave out, relative to its sum: an eighth of the rounding of a double."""

LENGTH = 60


@cache
def coefficients(power: sp.Rational, m: int) -> tuple[sp.Rational, ...]:
    """Exact coefficients in eta of the integral of s^(degree-m) y^m times the normal force to a power, over g^(2 q)."""
    degree = DEGREE[power]
    return tuple(sum(factor * axial_moment(degree - m + n - j, m + j) for j, factor in enumerate(form))
                 for n, form in enumerate(gegenbauer_forms(LENGTH, -power)))


@cache
def series(power: sp.Rational, m: int) -> TruncatedSeries:
    """The same, cut where the rest cannot be seen."""
    whole = truncate(f"{'SERIES' if power > 0 else 'INVERSE'}_{m}", coefficients(power, m), CONTRAST_LIMIT, PRECISION)
    return replace(whole, variable=eta.name)


@cache
def emitted_series(power: sp.Rational, m: int) -> TruncatedSeries:
    """The series without its first term, over eta: how far the integral is from that for constant stiffness."""
    whole = series(power, m)
    return replace(whole, coefficients=whole.coefficients[1:])


def condition(power: sp.Rational, m: int, contrast: sp.Rational) -> sp.Float:
    """Sum of the absolute terms over the absolute sum: how much the terms of a series cancel."""
    terms = [sp.N(factor * contrast**n, 25) for n, factor in enumerate(series(power, m).coefficients)]
    return sum(abs(term) for term in terms) / abs(sum(terms))


both, square, mean_square, first, correction, root = sp.symbols(
    "both square mean_square first correction root", positive=True)
departures = sp.symbols("f0:7", real=True)
constants = sp.symbols("constant0:3", positive=True)


def _root_and_contrast() -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
    """Contrast and cube root; a step of Newton's rule because cube roots of a library may be two units off."""
    return ((both, a * c), (square, a + c + 2 * sp.sqrt(both)), (eta, d / square), (mean_square, square / 4),
            (first, mean_square**THIRD), (correction, mean_square / first**2 - first), (root, first + correction / 3))


def _departures(power: sp.Rational) -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
    polynomial = sp.Function("polynomial")
    return tuple((departures[m], polynomial(sp.Symbol(emitted_series(power, m).name), eta))
                 for m in range(DEGREE[power] + 1))


# Measured against 40 digits on 12,000 fabrics of rank two, boundaries included, |eta| <= 1/2, in units of 2^-53:
# 4.1 (kinematic) and 3.3 (static) at the worst with fractions as arguments; 6.5 and 4.3 with floats, where the
# coefficients of the fabric are rounded as well. The terms of the series add up to at most 1.82 times their sum, and
# the largest of them, the first, is not rounded before it is added.
NOTES = ("The series hold for 1/9 <= c/a <= 9. The difference d = c - a is an argument of its own, so that nothing is "
         "lost when a and c are close.")


def kinematic_function() -> Function:
    """Emit the positive moments of E W^2 k_n: those for constant stiffness, and what the forces change in them."""
    *fabric_part, last0, last1, last2 = moment_function().assignments
    at_rest = tuple((symbol, value) for symbol, (_, value) in zip(constants, (last0, last1, last2), strict=True))
    changed = tuple(sum((o * departures[j + k] for j, o in enumerate(WEIGHT_SYMBOLS)), sp.Integer(0))
                    for k in range(3))
    return Function(
        "kinetic_moments",
        "Moments <E W^2 k_n s^2>, <E W^2 k_n s x^2>, <E W^2 k_n x^4> over k_n,ref, no contact slipping.",
        (D33, D3333, Dr33, a, c, d),
        (*fabric_part, *at_rest, *_root_and_contrast(), *_departures(STIFF),
         *((p, root * (constants[k] + eta * changed[k])) for k, p in enumerate(POSITIVE_MOMENTS))),
        POSITIVE_MOMENTS, notes=NOTES, series=tuple(emitted_series(STIFF, m) for m in range(7)))


def static_function() -> Function:
    """Emit the positive moments of E/k_n for branches of one length."""
    density = (e0, e1, e2)
    over_one = ((e0, sp.Mul(8 - 4 * D33 + 3 * D3333, sp.Rational(1, 8), evaluate=False)),
                (e1, sp.Mul(4 + D33 - 6 * D3333, sp.Rational(1, 2), evaluate=False)), (e2, DENSITY_FORM[2]))
    at_rest, changed = [], []
    for k in range(3):
        numerator, denominator = sp.fraction(sp.together(axial_mean(density_form() * s ** (2 - k) * y**k)))
        at_rest.append((constants[k], sp.Mul(numerator, sp.Rational(1, denominator), evaluate=False)))
        changed.append(sum((e * departures[j + k] for j, e in enumerate(density)), sp.Integer(0)))
    return Function(
        "kinetic_static_moments",
        "Moments <E s^2/k_n>, <E s x^2/k_n>, <E x^4/k_n> times k_n,ref, no contact slipping, Dr33 = 0.",
        (D33, D3333, a, c, d),
        (*over_one, *at_rest, *_root_and_contrast(), *_departures(SOFT),
         *((u, (constants[k] + eta * changed[k]) / root) for k, u in enumerate(NORMAL_FLEXIBILITIES))),
        NORMAL_FLEXIBILITIES, notes=NOTES, series=tuple(emitted_series(SOFT, m) for m in range(5)))


def _force_in_contrast() -> sp.Expr:
    return (1 - eta) ** 2 * s + (1 + eta) ** 2 * y


@cache
def _binomial_series(power: sp.Rational, order: int) -> sp.Expr:
    """The first terms of a power of the normal force over g^2, by the binomial series of (1 + w)^q with w = O(eta)."""
    w = sp.expand(_force_in_contrast().subs(s, 1 - y) - 1)
    total = sp.expand(sum(sp.binomial(power, n) * w**n for n in range(order)))
    return sp.expand(sum(total.coeff(eta, n) * eta**n for n in range(order)))


def _direct_series(power: sp.Rational, m: int, order: int) -> sp.Expr:
    """The first terms of an integral again, without Gegenbauer polynomials."""
    return sp.expand(axial_mean(_binomial_series(power, order) * s ** (DEGREE[power] - m) * y**m))


def _terms(power: sp.Rational) -> str:
    return ", ".join(str(len(series(power, m).coefficients)) for m in range(DEGREE[power] + 1))


def series_steps() -> tuple[Step, ...]:
    """Show the contrast, the generating function and the two families of series."""
    root_a, root_c = sp.sqrt(a), sp.sqrt(c)
    contrast = (root_c - root_a) / (root_c + root_a)
    order = 5
    return (
        Step("Contrast of the forces",
             r"With $g = (\sqrt a + \sqrt c)/2$ and the contrast $\eta$ the normal force is $g^2$ times a form that "
             r"lies between $(1-|\eta|)^2$ and $(1+|\eta|)^2$. The contrast follows from $d = c - a$ without any "
             "subtraction.",
             (r"\eta = \frac{\sqrt c - \sqrt a}{\sqrt c + \sqrt a} = \frac{d}{a + c + 2\sqrt{ac}},\qquad "
              r"as + cy = g^2\left[(1-\eta)^2 s + (1+\eta)^2 y\right]",),
             (Claim(sp.simplify(contrast * (root_a + root_c) ** 2), c - a),
              Claim((root_a + root_c) ** 2, a + c + 2 * sp.sqrt(a * c)),
              Claim(sp.simplify(((root_a + root_c) / 2) ** 2 * _force_in_contrast().subs(eta, contrast)),
                    a * s + c * y))),
        Step("Gegenbauer series",
             r"A power of the normal force is the generating function of the Gegenbauer polynomials in $s - y$, so "
             "every coefficient of the integrals is an exact rational number.",
             (r"(as + cy)^q = g^{2q}\sum_n C_n^{(-q)}(s - y)\,\eta^n",
              r"A_m = g^{2/3}\,\Phi_m(\eta),\qquad \Phi_m = \sum_n \eta^n\int_0^1 s^{6-m}x^{2m}"
              r"C_n^{(-1/3)}(s-y)\,\mathrm{d}x",),
             (*(Claim(sp.expand(sum(eta**n * sp.gegenbauer(n, -power, s - y) for n in range(order)).subs(s, 1 - y)),
                      _binomial_series(power, order)) for power in (STIFF, SOFT)),
              *(Claim(sum(factor * eta**n for n, factor in enumerate(coefficients(STIFF, m)[:order])),
                      _direct_series(STIFF, m, order)) for m in range(7)))),
        Step("Constant stiffness and the rest",
             "The first terms are the moments for constant contact stiffness. What the forces change is a second sum, "
             r"with a factor $\eta$ in front. The series are cut where the rest is below $2^{-57}$ of the whole for "
             rf"$|\eta| \le \tfrac12$; for $m = 0$ to 6 they keep {_terms(STIFF)} terms.",
             (r"p_k = g^{2/3}\left[p_k^{\circ} + \eta\sum_{j=0}^4\omega_j\,\frac{\Phi_{j+k}-\Phi_{j+k}(0)}{\eta}"
              r"\right]",),
             tuple(Claim(coefficients(STIFF, m)[0], axial_moment(6 - m, m)) for m in range(7))),
        Step("Compliance",
             rf"The moments of $1/k_n$ follow with the power $-1/3$. A single series needs branches of one length, "
             rf"$W = 1$; for $m = 0$ to 4 they keep {_terms(SOFT)} terms.",
             (r"A_m^- = \int_0^1 s^{4-m}x^{2m}(as + cy)^{-1/3}\,\mathrm{d}x = g^{-2/3}\,\Phi_m^-(\eta),\qquad "
              r"u_k = \sum_{j=0}^{2}e_j A^-_{j+k}",),
             (*(Claim(sum(factor * eta**n for n, factor in enumerate(coefficients(SOFT, m)[:order])),
                      _direct_series(SOFT, m, order)) for m in range(5)),
              *(Claim(coefficients(SOFT, m)[0], axial_moment(4 - m, m)) for m in range(5)))),
    )
