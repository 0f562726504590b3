"""Why the moments of the shear stiffness with partial slip are elementary apart from Legendre F: the proof in steps."""

from __future__ import annotations

from functools import cache

import sympy as sp

from derivations import legendre
from derivations.mohr import identity
from derivations.record import Claim, Derivation, Output, Step
from derivations.slip_integrals import DEGREE, Arc, cosine, cosine_star, moment, rotated_form, sine, sine_star
from derivations.sphere import axial_moment
from derivations.symbols import circle_center, circle_radius, h0, latex, omega, phi, x

THIRD = sp.Rational(1, 3)
HALF = sp.Rational(1, 2)
FIVE_THIRDS = sp.Rational(5, 3)

i = sp.Symbol("i", integer=True, nonnegative=True)
n = sp.Symbol("n", integer=True, nonnegative=True)
q = sp.Symbol("q", positive=True)
"""Cube root in the integrand, u or V."""

tau = sp.Symbol("tau", real=True)
Y, Z = sp.symbols("Y Z", positive=True)
X = sp.Symbol("X", positive=True)
most = circle_center + circle_radius


def even_moment() -> sp.Expr:
    """Integral of y^(2i) (h0 + 2R y^2)^(1/3) over y from 0 to Y as an incomplete hypergeometric function."""
    return (sp.cbrt(h0) * Y ** (2 * i + 1) / (2 * i + 1)
            * sp.hyper((-THIRD, i + HALF), (i + 3 * HALF,), -2 * circle_radius * Y**2 / h0))


def odd_moment() -> sp.Expr:
    """Integral of z^(2i) (m + R - 2R z^2)^(1/3) over z from 0 to Z."""
    return (sp.cbrt(most) * Z ** (2 * i + 1) / (2 * i + 1)
            * sp.hyper((-THIRD, i + HALF), (i + 3 * HALF,), 2 * circle_radius * Z**2 / most))


def _rotation_step() -> Step:
    claims: list[Claim] = []
    turned = circle_center - circle_radius * sp.cos(2 * omega)
    for sign in (1, -1):
        star = sp.pi / 4 + sign * phi / 2
        direction = star + omega
        across = circle_center - sign * circle_radius * sp.sin(phi)
        along = circle_center + sign * circle_radius * sp.sin(phi)
        left = (across * sp.sin(direction) ** 2 + along * sp.cos(direction) ** 2
                - 2 * circle_radius * sp.cos(phi) * sp.sin(direction) * sp.cos(direction))
        claims += [identity(left, turned), identity(sp.sin(star) ** 2, (1 + sign * sp.sin(phi)) / 2)]
    claims += [identity(turned, circle_center - circle_radius + 2 * circle_radius * sp.sin(omega) ** 2),
               identity(turned, most - 2 * circle_radius * sp.cos(omega) ** 2)]
    return Step(
        "Turn to the direction nearest to sliding",
        r"With $\beta = \beta^* + \omega$ what is left of the normal force depends on $\omega$ through one square, "
        "of its sine or of its cosine. Sine and cosine of $\\beta$ are linear in those of $\\omega$.",
        (r"f_n - \frac{f_r}{\mu} = h_0 + 2R\sin^2\omega = m + R - 2R\cos^2\omega,\qquad h_0 = m - R",
         r"\sin^2\beta^* = \tfrac12(1\pm\sin\phi),\qquad \cos^2\beta^* = \tfrac12(1\mp\sin\phi)"),
        tuple(claims), result=True)


def _plain_arcs() -> tuple[Arc, Arc]:
    """Arcs of both sides with 1 in place of the cube root, from omega = 0 to the pole and to the equator."""
    arcs = []
    for side, end, other in ((1, cosine_star, sine_star), (-1, sine_star, cosine_star)):
        odd = tuple((1 - other ** (2 * j + 1)) / (2 * j + 1) for j in range(DEGREE + 1))
        even = tuple(end ** (2 * j + 1) / sp.Integer(2 * j + 1) for j in range(DEGREE + 1))
        arcs.append(Arc(side, even, odd))
    return arcs[0], arcs[1]


def _on_circle(polynomial: sp.Expr) -> sp.Expr:
    """Use cos^2 = 1 - sin^2 for beta*."""
    return sp.rem(sp.Poly(sp.expand(polynomial), cosine_star, sine_star),
                  sp.Poly(cosine_star**2 + sine_star**2 - 1, cosine_star, sine_star)).as_expr()


def _split_step() -> Step:
    power = 2 * DEGREE + 1
    forms = tuple(
        Claim(sp.expand(sum(factor * sine**j * cosine ** (power - j)
                            for j, factor in enumerate(rotated_form(index, side)))),
              sp.expand((sine_star * cosine + side * cosine_star * sine) ** (power - 2 * index)
                        * (cosine_star * cosine - side * sine_star * sine) ** (2 * index)))
        for index, side in ((0, 1), (2, -1)))
    return Step(
        "Split into even and odd powers",
        r"With $s = \sin^2\beta$, $x = \cos\beta$ the moments have degree eleven in sine and cosine of $\omega$, on "
        r"either side of $\beta^*$. In a term with an even power of $\sin\omega$ the odd power of the cosine makes "
        r"$y = \sin\omega$ the variable; in one with an odd power it is $z = \cos\omega$. The rest is a binomial sum. "
        "With 1 in place of the cube root the two sides add up to the moments of the isotropic assembly.",
        (r"H_k = \int_0^1 s^{5-k}x^{2k}\max\left(f_n - \tfrac{f_r}{\mu},\,0\right)^{1/3}\mathrm{d}x = \sum_\pm\left["
         r"\sum_{j\ \text{even}} c^\pm_{kj}\int y^j(1-y^2)^{\frac{10-j}2}(h_0+2Ry^2)^{1/3}\mathrm{d}y + "
         r"\sum_{j\ \text{odd}} c^\pm_{kj}\int z^{11-j}(1-z^2)^{\frac{j-1}2}(m+R-2Rz^2)^{1/3}\mathrm{d}z\right]",
         r"(\sin\beta^*\cos\omega \pm \cos\beta^*\sin\omega)^{11-2k}(\cos\beta^*\cos\omega \mp "
         r"\sin\beta^*\sin\omega)^{2k} = \sum_{j=0}^{11} c^\pm_{kj}\sin^j\omega\,\cos^{11-j}\omega"),
        (*forms, *(Claim(_on_circle(moment(index, _plain_arcs())), axial_moment(DEGREE - index, index))
                   for index in (0, 2, DEGREE))), result=True)


def _hyper_step() -> Step:
    rising = sp.gamma(i + n + HALF) * sp.gamma(i + 3 * HALF) / (sp.gamma(i + HALF) * sp.gamma(i + n + 3 * HALF))
    ratio = (sp.binomial(THIRD, n + 1) / sp.binomial(THIRD, n)).rewrite(sp.gamma)
    return Step(
        "Incomplete hypergeometric functions",
        "Expanded in powers of the square and integrated term by term, both kinds of integral from zero are one "
        "function with different arguments.",
        (rf"\int_0^Y y^{{2i}}(h_0+2Ry^2)^{{1/3}}\,\mathrm{{d}}y = {latex(sp.cbrt(h0))}\,"
         r"\frac{Y^{2i+1}}{2i+1}\,{}_2F_1\!\left(-\tfrac13, i+\tfrac12; i+\tfrac32; -\frac{2RY^2}{h_0}\right)",
         r"\int_0^Z z^{2i}(m+R-2Rz^2)^{1/3}\,\mathrm{d}z = (m+R)^{1/3}\,"
         r"\frac{Z^{2i+1}}{2i+1}\,{}_2F_1\!\left(-\tfrac13, i+\tfrac12; i+\tfrac32; \frac{2RZ^2}{m+R}\right)"),
        (Claim(sp.cancel(sp.expand_func(rising)), sp.cancel((2 * i + 1) / (2 * i + 2 * n + 1))),
         Claim(sp.cancel(sp.expand_func(ratio)), -(n - THIRD) / (n + 1)),
         *(Claim(sp.hyper((-THIRD, k + HALF), (k + 3 * HALF,), sp.Integer(0)), sp.Integer(1)) for k in range(2))),
        result=True)


def _along(numerator: sp.Expr, power: sp.Expr, square: sp.Expr) -> sp.Expr:
    """Derivative along x of numerator q^power, where q^3 = square, divided by q."""
    slope = sp.diff(square, x) / (3 * q**2)
    total = (sp.diff(numerator, x) * q**power + numerator * power * q ** (power - 1) * slope) / q
    return sp.expand(sp.expand(total).subs(q**3, square))


def _reduction_step() -> Step:
    square = 1 + tau * x**2
    k = sp.Symbol("k", positive=True)
    two = sp.expand(_along(x ** (2 * k - 1), sp.Integer(4), square) / x ** (2 * k - 2))
    first = sp.expand(q**3 * (sp.Rational(3, 5) * (q + x * 2 * tau * x / (3 * q**2)) + sp.Rational(2, 5) / q**2) / q)
    scaled = 2 * circle_radius * Y**2 / h0
    return Step(
        "When every contact sticks",
        r"Scaled to its upper end each integral is one of $I_k(\tau)$ as for contacts that do not slip, with $\tau = "
        r"2RY^2/h_0$ or $\tau = -2RZ^2/(m+R)$. The recurrence leads to $I_0$, and integration by parts to one "
        "Legendre integral; of the first kind for the even part and of the second for the odd part.",
        (r"\int_0^Y y^{2i}(h_0+2Ry^2)^{1/3}\,\mathrm{d}y = h_0^{1/3}\,Y^{2i+1}\,I_i(\tau),\qquad "
         r"I_k = \frac{(1+\tau)^{4/3} - (2k-1)I_{k-1}}{(2k+\frac53)\,\tau}",
         r"I_0 = \tfrac35(1+\tau)^{1/3} + \tfrac25\int_0^1\frac{\mathrm{d}x}{(1+\tau x^2)^{2/3}}"),
        (Claim(sp.expand(h0 + 2 * circle_radius * (Y * x) ** 2), sp.expand(h0 * square.subs(tau, scaled))),
         Claim(sp.expand(most - 2 * circle_radius * (Z * x) ** 2),
               sp.expand(most * square.subs(tau, -2 * circle_radius * Z**2 / most)).cancel()),
         Claim(sp.powsimp(two), sp.expand(2 * k - 1 + (2 * k + FIVE_THIRDS) * tau * x**2)),
         Claim(first.subs(q**3, square), sp.expand(square))), result=True)


def _sliding_step() -> Step:
    square = x**2 - 1
    k = sp.Symbol("k", positive=True)
    two = sp.expand(_along(x ** (2 * k - 1), sp.Integer(4), square) / x ** (2 * k - 2))
    first = sp.expand(q**3 * (sp.Rational(3, 5) * (q + x * 2 * x / (3 * q**2)) - sp.Rational(2, 5) / q**2) / q)
    below = sp.sqrt(1 + q**3)
    edge = sp.sqrt(-h0 / (2 * circle_radius))
    return Step(
        "Beside a sliding range",
        r"For $h_0 < 0$ contacts slide up to $|\sin\omega| = y_s$, the root of the bracket. In $y/y_s$ the integrals "
        r"of the even part start at 1. With $V^3 = X^2 - 1$ they reduce as before, to the Legendre integral of the "
        "third kind between 0 and $V$.",
        (r"y_s = \sqrt{\frac{-h_0}{2R}},\quad X = \frac{Y}{y_s}:\qquad \int_{y_s}^Y y^{2i}(h_0+2Ry^2)^{1/3}\,"
         r"\mathrm{d}y = (2R)^{1/3}\,y_s^{2i+5/3}\,\hat I_i",
         r"\hat I_k = \frac{X^{2k-1}V^4 + (2k-1)\hat I_{k-1}}{2k+\frac53},\qquad "
         r"\hat I_0 = \tfrac35XV - \tfrac35\int_0^V\frac{\mathrm{d}v}{\sqrt{1+v^3}}"),
        (Claim(sp.expand(h0 + 2 * circle_radius * (edge * x) ** 2), sp.expand(-h0 * square)),
         Claim(sp.powsimp(two), sp.expand((2 * k + FIVE_THIRDS) * x**2 - (2 * k - 1))),
         Claim(sp.expand(first.subs(q**3, square)), sp.expand(square)),
         Claim(sp.simplify(sp.diff(below, q) / q**2), sp.Rational(3, 2) / below),
         Claim(sp.Rational(2, 5) * sp.Rational(3, 2), sp.Rational(3, 5))), result=True)


def _root_step() -> Step:
    here, ahead = (sp.beta(i + HALF + j, sp.Rational(4, 3)).rewrite(sp.gamma) for j in (0, 1))
    y = sp.Symbol("y", positive=True)
    return Step(
        "The odd part up to the root",
        "The odd part runs from the end of the arc to its own root, the same direction. From zero to the root it is a "
        "beta function; from zero to the end of the arc it is as before.",
        (r"z_s = \sqrt{\frac{m+R}{2R}}:\qquad \int_0^{z_s} z^{2i}(m+R-2Rz^2)^{1/3}\,\mathrm{d}z = "
         r"\tfrac12(m+R)^{1/3}\,z_s^{2i+1}\,\mathrm{B}\!\left(i+\tfrac12, \tfrac43\right)",),
        (Claim(sp.cancel((most / (2 * circle_radius)).subs(circle_center, circle_radius + h0)
                         - h0 / (2 * circle_radius)), sp.Integer(1)),
         Claim(sp.diff(sp.sqrt(y), y) * sp.sqrt(y) ** 2 * (1 - y) ** THIRD, sp.sqrt(y) * (1 - y) ** THIRD / 2),
         Claim(sp.cancel(sp.expand_func(ahead / here)), sp.cancel((2 * i + 1) / (2 * i + 2 + FIVE_THIRDS)))),
        result=True)


def _tangency_step() -> Step:
    y = sp.Symbol("y", positive=True)
    power = 2 * i + FIVE_THIRDS
    return Step(
        "At the onset of sliding",
        r"For $h_0 = 0$ exactly the cube root is that of a square, $|\sin\omega|^{2/3}$, and the even part elementary; "
        "the odd part ends at its root, which is 1.",
        (r"\int_0^Y y^{2i}(2Ry^2)^{1/3}\,\mathrm{d}y = (2R)^{1/3}\,\frac{Y^{2i+5/3}}{2i+\frac53}",),
        (Claim(sp.powsimp(sp.diff(y**power / power, y)), sp.powsimp(y ** (2 * i) * y ** sp.Rational(2, 3))),
         Claim((most / (2 * circle_radius)).subs(circle_center, circle_radius), sp.Integer(1))), result=True)


@cache
def partial_slip() -> Derivation:
    """Derive the closed form of the moments of the shear stiffness with partial slip."""
    *_, third = legendre.elliptic_identity_steps()
    return Derivation(
        name="partial_slip",
        title="Moments with partial slip in closed form",
        sources=("(20)", "(21)", "(23)"),
        assumptions=("Contact forces follow from the mean stress by the fabric tensor of rank two.",
                     "Contacts follow Hertz across and Mindlin along the contact; a sliding one has no shear "
                     "stiffness.",
                     "The density of contact normals is of rank two; with a rank-four part the degree is thirteen."),
        domain=("a, c not both negative, a != c", "mu > 0",
                "an identity: near a = c and near the onset of sliding it loses digits"),
        inputs=(circle_center, circle_radius, h0),
        outputs=(Output(sp.Symbol("Y_i"), even_moment()), Output(sp.Symbol("Z_i"), odd_moment())),
        steps=(_rotation_step(), _split_step(), _hyper_step(), _reduction_step(), third, _sliding_step(),
               _root_step(), _tangency_step()),
    )
