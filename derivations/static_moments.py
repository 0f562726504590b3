"""Moments of E/W^2: elementary closed forms, and a series whose coefficients are exact.

With g = (sqrt(w0) + sqrt(w1))/2 and the contrast v the weight is W = g^2 [(1-v)^2 s + (1+v)^2 y], and 1/W^2 is the
generating function of the Gegenbauer polynomials C_n^(2) in s - y. A factor (1-v)^3, (1-v)^2, 1, (1+v), (1+v)^2 taken
out of the five integrals leaves power series without cancellation for |v| <= 1/2.
"""

from __future__ import annotations

from functools import cache

import sympy as sp

from derivations.fabric import BRANCH_FORM, DENSITY_FORM, branch_form, density_form
from derivations.record import Claim, Function, Step
from derivations.series import TruncatedSeries, gegenbauer_forms, power_of_one_plus, product, truncate
from derivations.sphere import axial_mean, axial_moment
from derivations.symbols import (
    D33,
    D3333,
    POSITIVE_MOMENTS,
    Dr33,
    e0,
    e1,
    e2,
    latex,
    s,
    v,
    w0,
    w1,
    x,
    y,
)

ratio = sp.Symbol("varrho", positive=True)
elementary = sp.Symbol("L", positive=True)
"""Integral of 1/(1 + (varrho - 1) x^2) over x from 0 to 1: atan or atanh, or 1 when varrho = 1."""

CONTRAST_LIMIT = sp.Rational(1, 2)
"""The series serve |v| <= 1/2, which is 1/9 <= w1/w0 <= 9."""

OUTER_FACTORS = ((3, 0), (2, 0), (0, 0), (0, 1), (0, 2))
"""Powers of 1 - v and 1 + v that divide the five series; they make every series well conditioned."""

PRECISION = sp.Rational(1, 2**57)
"""What a truncated series may leave out, relative to its sum: an eighth of the rounding of a double."""


def elementary_integral(k: int) -> sp.Expr:
    """Integral of s^(4-k) y^k/(s + varrho y)^2 over x from 0 to 1, in varrho and L.

    Polynomial division in q = 1 + (varrho - 1) y leaves 1/q^2, 1/q and a polynomial; the first integrates to
    (1/varrho + L)/2, the second to L.
    """
    q = sp.Symbol("q", positive=True)
    in_q = sp.expand((ratio - q) ** (4 - k) * (q - 1) ** k / q**2)
    total = sp.Integer(0)
    for power in range(-2, 3):
        coefficient = in_q.coeff(q, power)
        if power >= 0:
            integral = axial_mean((1 + (ratio - 1) * y) ** power)
        else:
            integral = elementary if power == -1 else (1 / ratio + elementary) / 2
        total += coefficient * integral
    return total / (ratio - 1) ** 4


@cache
def series(k: int) -> TruncatedSeries:
    """Exact coefficients in v of the k-th integral times its outer factor, cut where the rest cannot be seen."""
    length = 72
    plain = [sum(c * axial_moment(4 - k + n - j, k + j) for j, c in enumerate(form))
             for n, form in enumerate(gegenbauer_forms(length))]
    minus, plus = OUTER_FACTORS[k]
    cleared = product(product(plain, power_of_one_plus(minus, -1, length)), power_of_one_plus(plus, 1, length))
    return truncate(f"SERIES_{k}", tuple(cleared), CONTRAST_LIMIT, PRECISION)


def moment_function() -> Function:
    """Emit the positive moments of E/W^2 by the five series."""
    mean, square = sp.symbols("geometric_mean square", positive=True)
    integrals = sp.symbols("h0:5", positive=True)
    polynomial = sp.Function("polynomial")
    divisors = (w0 * (w0 + mean) / 2, square * w0 / 4, square**2 / 16, square * (w1 + mean) / 8, square * w1 / 4)
    over_one = ((e0, sp.Mul(8 - 4 * D33 + 3 * D3333, sp.Rational(1, 8), evaluate=False)),
                (e1, sp.Mul(4 + D33 - 6 * D3333, sp.Rational(1, 2), evaluate=False)),
                (e2, DENSITY_FORM[2]),
                (w0, sp.Mul(2 - Dr33, sp.Rational(1, 2), evaluate=False)), (w1, BRANCH_FORM[1]))
    return Function(
        "static_moments", "Moments <E W^-2 s^2>, <E W^-2 s x^2>, <E W^-2 x^4> of the static weight.",
        (D33, D3333, Dr33),
        (*over_one,
         (mean, sp.sqrt(w0 * w1)), (square, (4 + Dr33) / 2 + 2 * mean), (v, 3 * Dr33 / (2 * square)),
         *((h, polynomial(sp.Symbol(series(k).name), v) / divisors[k]) for k, h in enumerate(integrals)),
         *((p, e0 * integrals[k] + e1 * integrals[k + 1] + e2 * integrals[k + 2])
           for k, p in enumerate(POSITIVE_MOMENTS))),
        POSITIVE_MOMENTS,
        notes="The series hold for 1/9 <= w1/w0 <= 9, that is -16/19 <= Dr33 <= 16/11.",
        series=tuple(series(k) for k in range(5)))


def _geometric_check(k: int, order: int) -> Claim:
    """The first coefficients again, from the geometric series of 1/(1 + e y)^2 with e = 4v/(1-v)^2."""
    e = sp.Symbol("e")
    geometric = sum((-1) ** n * (n + 1) * axial_moment(4 - k, k + n) * e**n for n in range(order))
    minus, plus = OUTER_FACTORS[k]
    in_v = (geometric.subs(e, 4 * v / (1 - v) ** 2) * (1 - v) ** (minus - 4) * (1 + v) ** plus)
    expected = sum(c * v**n for n, c in enumerate(series(k).coefficients[:order]))
    return Claim(sp.series(in_v, v, 0, order).removeO(), sp.expand(expected))


def moment_steps() -> tuple[Step, ...]:
    """Show the elementary form and the series of the moments."""
    q = 1 + (ratio - 1) * x**2
    to_ratio = {w0: (1 - v) ** 2, w1: (1 + v) ** 2}
    gegenbauer = sum(v**n * sp.gegenbauer(n, 2, s - y) for n in range(4))
    squared = sp.expand(branch_form().subs(to_ratio).subs(s, 1 - y) ** 2)
    remainder = sp.series(sp.expand(gegenbauer.subs(s, 1 - y)) * squared, v, 0, 4).removeO()
    return (
        Step("Five integrals",
             "With $E$ in positive form the moments need five integrals, which depend on one number only, the ratio of "
             "the branch lengths at pole and equator.",
             (r"p_k = \sum_{j=0}^{2} e_j H_{j+k},\qquad H_k = \frac{1}{w_0^2}\int_0^1 "
              r"\frac{s^{4-k}y^k}{(s+\varrho\,y)^2}\,\mathrm{d}x,\qquad \varrho = \frac{w_1}{w_0}",),
             (Claim(sp.expand(density_form() * s**2),
                    sp.expand(e0 * s**4 + e1 * s**3 * y + e2 * s**2 * y**2)),), result=True),
        Step("Elementary form",
             r"Division by $q = 1 + (\varrho - 1) x^2$ leaves $1/q^2$ and $1/q$; both integrate to the arc "
             r"tangent, or to the hyperbolic one for $\varrho < 1$. Near $\varrho = 1$ this form loses digits, so it "
             "serves as an identity.",
             (r"L = \int_0^1\frac{\mathrm{d}x}{q} = \frac{\arctan\sqrt{\varrho-1}}{\sqrt{\varrho-1}},\qquad "
              r"\int_0^1\frac{\mathrm{d}x}{q^2} = \tfrac12\Bigl(\tfrac1\varrho + L\Bigr)",
              rf"w_0^2 H_4 = {latex(sp.factor(elementary_integral(4)))}"),
             (Claim(sp.together(sp.diff(x / (2 * q), x) + 1 / (2 * q)), sp.together(1 / q**2)),
              Claim(sp.cancel(sp.together(sum(sp.binomial(4, k) * elementary_integral(k) for k in range(5)))),
                    (1 / ratio + elementary) / 2)),
             result=True),
        Step("Gegenbauer series",
             "In the contrast $v$, $1/W^2$ is the generating function of the Gegenbauer polynomials. Every coefficient "
             "of the integrals is therefore an exact rational number.",
             (r"\frac{1}{W^2} = \frac{1}{g^4}\sum_n C^{(2)}_n(s-y)\,v^n,\qquad g=\tfrac12(\sqrt{w_0}+\sqrt{w_1}),"
              r"\qquad v = \frac{\sqrt{w_1}-\sqrt{w_0}}{\sqrt{w_1}+\sqrt{w_0}}",),
             (Claim(sp.expand(remainder), sp.Integer(1)),)),
        Step("Well-conditioned series",
             "Factors $(1-v)^3$, $(1-v)^2$, 1, $1+v$, $(1+v)^2$ taken out of the five integrals leave series "
             r"$\Phi_k(v)$ whose terms hardly cancel for $|v| \le \tfrac12$. They are cut where the rest is below "
             "$2^{-57}$ of the sum; "
             + ", ".join(str(len(series(k).coefficients)) for k in range(5)) + " terms are kept.",
             (r"H_0 = \frac{2\,\Phi_0}{w_0(w_0+\sqrt{w_0w_1})}", r"H_1 = \frac{\Phi_1}{g^2w_0}",
              r"H_2 = \frac{\Phi_2}{g^4}", r"H_3 = \frac{2\,\Phi_3}{g^2(w_1+\sqrt{w_0w_1})}",
              r"H_4 = \frac{\Phi_4}{g^2w_1}"),
             tuple(_geometric_check(k, 5) for k in range(5))),
    )
