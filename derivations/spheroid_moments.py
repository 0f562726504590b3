"""Moments of E/Q for aligned spheroids: elementary closed forms, and a series whose coefficients are exact.

With g = (1 + chi)/2 and the contrast v = (chi - 1)/(chi + 1), Q = s + chi^2 y = g^2 [(1-v)^2 s + (1+v)^2 y], and 1/Q is
the generating function of the Chebyshev polynomials of the second kind in s - y. A factor 1-v, 1-v, 1, 1, 1+v taken out
of the five integrals leaves power series whose terms hardly cancel for |v| <= 1/2.
"""

from __future__ import annotations

from functools import cache

import sympy as sp

from derivations.fabric import DENSITY, DENSITY_FORM, density_form
from derivations.record import Claim, Function, Step
from derivations.series import TruncatedSeries, gegenbauer_forms, power_of_one_plus, product, truncate
from derivations.sphere import axial_moment
from derivations.static_moments import CONTRAST_LIMIT, PRECISION
from derivations.symbols import (
    D33,
    D3333,
    POSITIVE_MOMENTS,
    aspect_ratio,
    e0,
    e1,
    e2,
    latex,
    s,
    v,
    x,
    y,
)

excess = sp.Symbol("e", real=True)
"""varrho - 1, so that Q = 1 + e x^2."""

ELEMENTARY = sp.symbols("L0:5", positive=True)
"""L_k, the integral of x^(2k)/(1 + e x^2) over x from 0 to 1."""

OUTER_FACTORS = ((1, 0), (1, 0), (0, 0), (0, 0), (0, 1))
"""Powers of 1 - v and 1 + v that divide the five series; they keep sum |terms| below twice the sum."""

FABRIC = dict(zip((e0, e1, e2), DENSITY_FORM, strict=True))
"""The coefficients of the density in D33 and D3333."""


def in_elementary(form: sp.Expr) -> sp.Expr:
    """Integral of a polynomial in s and y over Q, as a linear form in L_0 to L_4."""
    terms = sp.Poly(sp.expand(form.subs(s, 1 - y)), y).terms()
    return sp.expand(sum(coefficient * ELEMENTARY[power] for (power,), coefficient in terms))


def elementary_moments() -> tuple[sp.Expr, ...]:
    """<E s^2/Q>, <E s y/Q>, <E y^2/Q> as linear forms in L_0 to L_4, with e0, e1, e2 for the density."""
    return tuple(in_elementary(density_form() * s ** (2 - k) * y**k) for k in range(3))


def by_recurrence(first: sp.Expr, squared_excess: sp.Expr = excess) -> tuple[sp.Expr, ...]:
    """L_0 to L_4 from L_0."""
    found = [first]
    for k in range(4):
        found.append((sp.Rational(1, 2 * k + 1) - found[-1]) / squared_excess)
    return tuple(found)


@cache
def series(k: int) -> TruncatedSeries:
    """Exact coefficients in v of the integral of s^(4-k) y^k/Q times g^2 and its outer factor, cut as all others."""
    length = 72
    plain = [sum(c * axial_moment(4 - k + n - j, k + j) for j, c in enumerate(form))
             for n, form in enumerate(gegenbauer_forms(length, sp.Integer(1)))]
    minus, plus = OUTER_FACTORS[k]
    cleared = product(product(plain, power_of_one_plus(minus, -1, length)), power_of_one_plus(plus, 1, length))
    return truncate(f"SERIES_{k}", tuple(cleared), CONTRAST_LIMIT, PRECISION)


def moment_function() -> Function:
    """Emit the moments of E/Q by the five series; 1 - v = 1/g and 1 + v = chi/g."""
    mean = sp.Symbol("mean_axis", positive=True)
    integrals = sp.symbols("h0:5", positive=True)
    polynomial = sp.Function("polynomial")
    divisors = (mean, mean, mean**2, mean**2, aspect_ratio * mean)
    over_one = ((e0, sp.Mul(8 - 4 * D33 + 3 * D3333, sp.Rational(1, 8), evaluate=False)),
                (e1, sp.Mul(4 + D33 - 6 * D3333, sp.Rational(1, 2), evaluate=False)),
                (e2, DENSITY_FORM[2]))
    return Function(
        "spheroid_moments", "Moments <E s^2/Q>, <E s x^2/Q>, <E x^4/Q> with Q = s + r^2 x^2, r the aspect ratio.",
        (D33, D3333, aspect_ratio),
        (*over_one,
         (mean, sp.Mul(1 + aspect_ratio, sp.Rational(1, 2), evaluate=False)),
         (v, (aspect_ratio - 1) / (aspect_ratio + 1)),
         *((h, polynomial(sp.Symbol(series(k).name), v) / divisors[k]) for k, h in enumerate(integrals)),
         *((p, e0 * integrals[k] + e1 * integrals[k + 1] + e2 * integrals[k + 2])
           for k, p in enumerate(POSITIVE_MOMENTS))),
        POSITIVE_MOMENTS,
        notes="The series hold for 1/3 <= aspect_ratio <= 3.",
        series=tuple(series(k) for k in range(5)))


def _geometric_check(k: int, order: int) -> Claim:
    """The first coefficients again, from the geometric series of 1/(1 + e y) with e = 4v/(1-v)^2."""
    e = sp.Symbol("e")
    geometric = sum((-1) ** n * axial_moment(4 - k, k + n) * e**n for n in range(order))
    minus, plus = OUTER_FACTORS[k]
    in_v = geometric.subs(e, 4 * v / (1 - v) ** 2) * (1 - v) ** (minus - 2) * (1 + v) ** plus
    expected = sum(c * v**n for n, c in enumerate(series(k).coefficients[:order]))
    return Claim(sp.series(in_v, v, 0, order).removeO(), sp.expand(expected))


def _elementary_steps() -> tuple[Step, ...]:
    root, k, n, below = sp.Symbol("root", positive=True), sp.Symbol("k"), sp.Symbol("n"), sp.Symbol("F")
    moments = elementary_moments()
    of_rank_two = tuple(sp.collect(sp.expand(m.subs(FABRIC).subs(D3333, 0)), ELEMENTARY) for m in moments)
    slope = 1 / (1 + excess * x**2)
    raised = (x ** (2 * k + 1) / (2 * k + 1) - below) / excess
    by_parts = sp.diff(raised, x) + sp.diff(raised, below) * x ** (2 * k) * slope
    ratio_of_terms = (1 + n) * (k + sp.Rational(1, 2) + n) / ((k + sp.Rational(3, 2) + n) * (1 + n))
    return (
        Step("Elementary form of the moments",
             r"For contacts of equal stiffness the moments are those of $E/Q$ with $Q = 1 + ex^2$, $e = \varrho - 1$. "
             "As the density is a polynomial in $x^2$, they are linear in four integrals $L_k$; with a rank-four "
             "part of the density in five.",
             (r"L_k = \int_0^1\frac{x^{2k}}{1 + ex^2}\,\mathrm dx",
              *(f"{latex(p)} = {sp.latex(m, symbol_names={D33: 'D_{33}'})}"
                for p, m in zip(POSITIVE_MOMENTS, of_rank_two, strict=True))),
             (*(Claim(sum(c * y ** ELEMENTARY.index(one) for one, c in m.as_coefficients_dict(*ELEMENTARY).items()),
                      sp.expand((density_form() * s ** (2 - j) * y**j).subs(s, 1 - y)))
                for j, m in enumerate(moments)),
              Claim(sum(c * p for c, p in zip((1, 2, 1), moments, strict=True)).subs(FABRIC),
                    in_elementary(DENSITY.subs(x, sp.sqrt(y))))),
             result=True),
        Step("Arc tangent, recurrence, hypergeometric function",
             r"The first integral is elementary; the others follow by polynomial division, or at once as Gauss's "
             r"function. Near $e = 0$ the recurrence loses digits, so it serves as an identity.",
             (r"L_0 = \frac{\arctan\sqrt e}{\sqrt e}\ (e > 0),\qquad "
              r"L_0 = \frac{\operatorname{artanh}\sqrt{-e}}{\sqrt{-e}}\ (e < 0),\qquad "
              r"L_{k+1} = \frac1e\left(\frac1{2k+1} - L_k\right)",
              r"L_k = \sum_{n=0}^\infty\frac{(-e)^n}{2k+2n+1} = \frac{1}{2k+1}\;"
              r"{}_2F_1\bigl(1, k+\tfrac12; k+\tfrac32; -e\bigr)"),
             (Claim(sp.diff(sp.atan(root * x) / root, x), slope.subs(excess, root**2)),
              Claim(sp.diff(sp.atanh(root * x) / root, x), slope.subs(excess, -(root**2))),
              Claim(sp.powsimp(sp.expand(by_parts)), sp.powsimp(sp.expand(x ** (2 * k + 2) * slope))),
              Claim(ratio_of_terms, (2 * k + 2 * n + 1) / (2 * k + 2 * (n + 1) + 1))), result=True),
    )


def moment_steps() -> tuple[Step, ...]:
    """Show the elementary form and the series of the moments."""
    chi = (1 + v) / (1 - v)
    chebyshev = sum(v**n * sp.chebyshevu(n, s - y) for n in range(4))
    form = (1 - v) ** 2 * s + (1 + v) ** 2 * y
    remainder = sp.series(sp.expand((chebyshev * form).subs(s, 1 - y)), v, 0, 4).removeO()
    return (
        *_elementary_steps(),
        Step("Series in the contrast",
             r"In the contrast $v$ of the two semi-axes, $1/Q$ is the generating function of the Chebyshev "
             "polynomials of the second kind. Every coefficient of the five integrals $H_k$ is therefore an exact "
             r"rational number, and nothing is singular at $\chi = 1$.",
             (r"p_k = \sum_{j=0}^2e_jH_{j+k},\qquad H_k = \int_0^1\frac{s^{4-k}y^k}{Q}\,\mathrm dx",
              r"\frac1Q = \frac1{g^2}\sum_nU_n(s - y)\,v^n,\qquad g = \tfrac12(1 + \chi),\qquad "
              r"v = \frac{\chi - 1}{\chi + 1}"),
             (Claim(sp.expand(remainder), sp.Integer(1)),
              Claim(sp.cancel(form * ((1 + chi) / 2) ** 2), sp.cancel(s + chi**2 * y)))),
        Step("Well-conditioned series",
             r"Factors $1 - v = 1/g$ out of the first two integrals and $1 + v = \chi/g$ out of the last leave series "
             r"$\Phi_k(v)$ whose terms hardly cancel for $|v| \le \tfrac12$. They are cut where the rest is below "
             "$2^{-57}$ of the sum; "
             + ", ".join(str(len(series(k).coefficients)) for k in range(5)) + " terms are kept.",
             (r"H_0 = \frac{\Phi_0}{g},\quad H_1 = \frac{\Phi_1}{g},\quad H_2 = \frac{\Phi_2}{g^2},\quad "
              r"H_3 = \frac{\Phi_3}{g^2},\quad H_4 = \frac{\Phi_4}{g\chi},\qquad \tfrac13 \le \chi \le 3",),
             (*(_geometric_check(k, 5) for k in range(5)),
              Claim(sp.cancel((1 - v) * (1 + chi) / 2), sp.Integer(1)),
              Claim(sp.cancel((1 + v) * (1 + chi) / 2), sp.cancel(chi)))),
    )
