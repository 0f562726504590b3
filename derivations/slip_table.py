"""What partial slip takes from the shear stiffness, cut into a smooth part for tables and the part that is not.

At fixed forces the onset of sliding is a branch point: two roots of the integrand meet there. What is not smooth about
it is the integral between the two roots, and that is a polynomial times a power.
"""

from __future__ import annotations

from functools import cache

import sympy as sp

from derivations import slip_table_batch
from derivations.record import Claim, Derivation, Function, Output, Step
from derivations.slip_integrals import DEGREE, cosine_star, rotated_form, sine_star
from derivations.symbols import eta, kappa, margin, onset_strength

THIRD = sp.Rational(1, 3)
HALF = sp.Rational(1, 2)
FIVE_SIXTHS = sp.Rational(5, 6)

at_equator, at_pole, w = sp.symbols("S C w", real=True)
"""Squared sine and cosine of the direction nearest to sliding, and minus what is left there over the diameter 2R."""

y = sp.Symbol("y", positive=True)
n = sp.Symbol("n", integer=True, nonnegative=True)

square, even, cube, half, share, radius, left_over, factor = sp.symbols(
    "square even cube half share radius left_over factor", real=True)
E2, E4, P2, P4 = sp.symbols("S2 S4 C2 C4", real=True)
BASIS = sp.symbols("z0:6", real=True)
STEPS = sp.symbols("w1:6", real=True)
SINGULAR = sp.symbols("singular0:6", real=True)


def even_part(index: int) -> tuple[sp.Expr, ...]:
    """Coefficients of y^(2n), y = sin(omega), in the even part of s^(5-k) x^(2k) sin(beta) over cos(omega) sin(beta*).

    Each is a form of degree five in the squared sine and cosine of beta*.
    """
    form = rotated_form(index, 1)
    found = []
    for power in range(DEGREE + 1):
        total = sum((form[2 * i] * (-1) ** (power - i) * sp.binomial(DEGREE - i, power - i)
                     for i in range(power + 1)), sp.Integer(0))
        found.append(sp.expand(sp.expand(total / sine_star).subs(
            {sine_star: sp.sqrt(at_equator), cosine_star: sp.sqrt(at_pole)})))
    return tuple(found)


def _coordinate_step() -> Step:
    force_a, force_c = (1 - eta) ** 3, (1 + eta) ** 3
    return Step(
        "Two numbers",
        r"Up to the size of the forces, what slip takes depends on their contrast $\bar v$ and on the largest share "
        r"$\kappa$ of the friction that a contact uses up. In these two the onset of sliding is a straight line, "
        r"$\bar\kappa = 1 - \kappa = 0$, for whatever friction. Here $\bar v$ is the contrast of the cube roots of $a$ "
        r"and $c$, and the mean of these is 1.",
        (r"\bar v = \frac{c^{1/3}-a^{1/3}}{c^{1/3}+a^{1/3}},\qquad \kappa = \frac{|c-a|}{2\mu\sqrt{ac}}",
         r"m = 1+3\bar v^2,\quad R = \sqrt{\bar v^2(3+\bar v^2)^2 + \kappa^2(1-\bar v^2)^3},\quad h_0 = m - R = "
         r"\frac{(1-\bar v^2)^3}{m+R}\,\bar\kappa(1+\kappa)"),
        (Claim(sp.expand((force_a + force_c) / 2), 1 + 3 * eta**2),
         Claim(sp.expand((force_c - force_a) / 2), sp.expand(eta * (3 + eta**2))),
         Claim(sp.expand(force_a * force_c), sp.expand((1 - eta**2) ** 3)),
         Claim(sp.expand((1 + 3 * eta**2) ** 2 - eta**2 * (3 + eta**2) ** 2 - kappa**2 * (1 - eta**2) ** 3),
               sp.expand((1 - eta**2) ** 3 * (1 - kappa) * (1 + kappa)))), result=True)


def _root_step() -> Step:
    claims = []
    for index in range(DEGREE + 1):
        form = rotated_form(index, 1)
        odd_free = sum(form[2 * i] * y ** (2 * i) * (1 - y**2) ** (DEGREE - i) for i in range(DEGREE + 1))
        back = {at_equator: sine_star**2, at_pole: cosine_star**2}
        collected = sine_star * sum(coefficient.subs(back) * y ** (2 * power)
                                    for power, coefficient in enumerate(even_part(index)))
        claims.append(Claim(sp.expand(odd_free), sp.expand(collected)))
    first = sp.beta(n + HALF, 4 * THIRD).rewrite(sp.gamma)
    ratio = sp.cancel(sp.expand_func(first.subs(n, n + 1) / first))
    return Step(
        "Between the roots",
        r"Turned to the direction nearest to sliding, $h = h_0 + 2R\,y^2$ with $y = \sin\omega$. Between its roots "
        r"only the even part of the weight counts, and over $\cos\omega$ this is a polynomial in $y^2$. Its integral "
        r"is a polynomial in $w = -h_0/2R$ times a power.",
        (r"\int_{-\sqrt w}^{\sqrt w} y^{2n}(w-y^2)^{1/3}\,\mathrm{d}y = w^{n+5/6}\,"
         r"\mathrm{B}\!\left(n+\tfrac12,\tfrac43\right)",
         r"W_k = (2R)^{1/3}\,w^{5/6}\,\mathrm{B}\!\left(\tfrac12,\tfrac43\right)\sin\beta^*\,Q_k(w),\qquad "
         r"Q_k = (\sin^2\beta^*)^{5-k}(\cos^2\beta^*)^k + \dots"),
        (*claims, Claim(ratio, sp.cancel((n + HALF) / (n + 1 + FIVE_SIXTHS))),
         *(Claim(sp.Rational(6 * power + 3, 6 * power + 11), ratio.subs(n, power)) for power in range(DEGREE)),
         *(Claim(even_part(index)[0], at_equator ** (DEGREE - index) * at_pole**index) for index in range(DEGREE + 1))),
        result=True)


def _branch_step() -> Step:
    """The coefficient of the power on each side, from the integral over a whole line, continued in its exponent."""
    claims = []
    between = sp.beta(n + HALF, 4 * THIRD).rewrite(sp.gamma)
    for power in range(DEGREE + 1):
        exponent = -power - FIVE_SIXTHS
        sticking = sp.gamma(power + HALF) * sp.gamma(exponent) / sp.gamma(-THIRD)
        sliding = sp.gamma(4 * THIRD) * sp.gamma(exponent) / sp.gamma(HALF - power)
        here = between.subs(n, power)
        claims += [Claim(_of_gammas(sticking / here), (-1) ** power * sp.sqrt(3)),
                   Claim(_of_gammas(sliding / here), sp.Integer(-2))]
    return Step(
        "What is not smooth",
        r"Over the whole line the powers of $y$ have integrals that are continued in the exponent; they give the part "
        r"of every moment that has a branch point at the onset. It is $W_k$ times a number on either side, with "
        r"$|w|^{5/6}$ for the power. What is left is one analytic function on both sides, which a table can hold.",
        (r"H_k - \sqrt3\,W_k \ (\kappa < 1),\qquad H_k + 2\,W_k \ (\kappa > 1)\qquad\text{one analytic function}",
         r"\int_{-\infty}^{\infty}\! y^{2n}(\varepsilon+y^2)^{1/3}\mathrm{d}y \to (-1)^n\sqrt3\,\varepsilon^{n+5/6}\,"
         r"\mathrm{B}\!\left(n+\tfrac12,\tfrac43\right),\qquad 2\int_{\sqrt w}^{\infty}\! y^{2n}(y^2-w)^{1/3}"
         r"\mathrm{d}y \to -2\,w^{n+5/6}\,\mathrm{B}\!\left(n+\tfrac12,\tfrac43\right)"),
        tuple(claims), result=True)


def _of_gammas(ratio: sp.Expr) -> sp.Expr:
    """Reduce a number made of gamma functions at sixths, by reflection and shifts to between 0 and 1."""
    def shifted(value: sp.Expr) -> sp.Expr:
        whole = sp.floor(value)
        start = value - whole
        steps = (sp.prod([start + i for i in range(whole)]) if whole >= 0
                 else 1 / sp.prod([start - i for i in range(1, 1 - whole)]))
        known = {FIVE_SIXTHS: 2 * sp.pi / sp.gamma(sp.Rational(1, 6)),
                 2 * THIRD: 2 * sp.pi / (sp.sqrt(3) * sp.gamma(THIRD))}
        return steps * known.get(start, sp.gamma(start))
    return sp.simplify(ratio.replace(sp.gamma, shifted))


def onset_part() -> Function:
    """Emit the part that is not smooth: the six W_k times a number that differs between the two sides."""
    squares = (at_equator, at_pole)
    fours = tuple(square * square for square in (E2, P2))
    basis = (E4 * at_equator, E4 * at_pole, E2 * at_equator * P2, E2 * at_pole * P2, P4 * at_equator, P4 * at_pole)
    return Function(
        "onset_part", "What is not smooth at the onset of sliding in the six moments of the stiffness left by slip.",
        (margin, eta, onset_strength),
        ((square, eta * eta), (even, 1 - square), (cube, even**3), (half, eta * (3 + square)), (share, 1 - margin),
         (radius, sp.sqrt(half**2 + share**2 * cube)),
         (left_over, margin * (1 + share) * cube / (1 + 3 * square + radius)),
         (w, -left_over / (2 * radius)),
         (at_equator, HALF + half / (2 * radius)), (at_pole, HALF - half / (2 * radius)),
         (E2, squares[0] ** 2), (P2, squares[1] ** 2), (E4, fours[0]), (P4, fours[1]),
         *zip(BASIS, basis, strict=True),
         *((symbol, sp.Rational(6 * i + 3, 6 * i + 11) * w) for i, symbol in enumerate(STEPS)),
         (factor, onset_strength * sp.cbrt(sp.Abs(left_over)) * sp.sqrt(sp.Abs(w) * at_equator)),
         *((symbol, factor * _nested(index)) for index, symbol in enumerate(SINGULAR))),
        SINGULAR, unit="-",
        notes="Contrast of the cube roots of the forces, with 1 for the mean of these. The strength is B(1/2, 4/3) "
              "times sqrt(3) before the onset, margin > 0, and times -2 after it.")


def _nested(index: int) -> sp.Expr:
    """Q_k by Horner's rule, its coefficients as sums over the basis of forms of degree five."""
    forms = [sp.Poly(coefficient, at_equator, at_pole) for coefficient in even_part(index)]
    total: sp.Expr = sp.Integer(0)
    for power in range(DEGREE, -1, -1):
        own = sum((forms[power].coeff_monomial(at_equator ** (DEGREE - j) * at_pole**j) * b
                   for j, b in enumerate(BASIS)), sp.Integer(0))
        total = own + (STEPS[power] * total if power < DEGREE else 0)
    return total


def singular_moments() -> tuple[sp.Expr, ...]:
    """The same in closed form, in margin, eta and strength."""
    apart = eta * (3 + eta**2)
    radius = sp.sqrt(apart**2 + (1 - margin) ** 2 * (1 - eta**2) ** 3)
    left = margin * (2 - margin) * (1 - eta**2) ** 3 / (1 + 3 * eta**2 + radius)
    across, along = (1 + apart / radius) / 2, (1 - apart / radius) / 2
    power = sp.cbrt(sp.Abs(left)) * sp.sqrt(sp.Abs(left) / (2 * radius) * across)
    found = []
    for index in range(DEGREE + 1):
        polynomial, ratio = sp.Integer(0), sp.Integer(1)
        for i, coefficient in enumerate(even_part(index)):
            polynomial += ratio * coefficient.subs({at_equator: across, at_pole: along}) * (-left / (2 * radius)) ** i
            ratio *= (i + HALF) / (i + 1 + FIVE_SIXTHS)
        found.append(onset_strength * power * polynomial)
    return tuple(found)


@cache
def slip_table() -> Derivation:
    """Derive what is smooth and what is not about the onset of sliding."""
    return Derivation(
        name="slip_table",
        title="Partial slip about its onset: what a table can hold",
        sources=("(20)", "(21)", "(23)"),
        assumptions=("Contact forces follow from the mean stress by the fabric tensor of rank two.",
                     "Contacts follow Hertz across and Mindlin along the contact; a sliding one has no shear "
                     "stiffness.",
                     "The density of contact normals is of rank two."),
        domain=("a, c > 0, a != c", "margin <= 1"),
        inputs=(margin, eta, onset_strength),
        outputs=tuple(Output(symbol, e) for symbol, e in zip(SINGULAR, singular_moments(), strict=True)),
        steps=(_coordinate_step(), _root_step(), _branch_step(), slip_table_batch.components_step()),
        functions=(onset_part(),),
        batch=slip_table_batch.batch(),
    )
