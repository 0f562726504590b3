"""Three cube-root integrals as Legendre integrals of the first kind with the moduli sin 15 deg and sin 75 deg."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from derivations.record import Claim, Step
from derivations.symbols import latex

SQRT3 = sp.sqrt(3)
SCALE = sp.Integer(3) ** sp.Rational(-1, 4)
"""Factor of every identity, 3^(-1/4)."""

SMALL_PARAMETER = (2 - SQRT3) / 4
"""Squared modulus of the first kind, sin^2 of 15 degrees."""

LARGE_PARAMETER = (2 + SQRT3) / 4
"""Squared modulus of the second and third kind, sin^2 of 75 degrees."""

argument = sp.Symbol("Y", real=True)


@dataclass(frozen=True)
class FirstKind:
    """One integral from its root: amplitude and squared modulus of F, what stands under the root of the integrand.

    ``sign`` is +1 when the argument is the upper limit and -1 when it is the lower one.
    """

    start: sp.Integer
    cosine_numerator: sp.Expr
    cosine_denominator: sp.Expr
    parameter: sp.Expr
    radicand: sp.Expr
    sign: int
    integral: str

    def cosine(self) -> sp.Expr:
        """Cosine of the amplitude."""
        return self.cosine_numerator / self.cosine_denominator


KINDS = {
    1: FirstKind(sp.Integer(1), SQRT3 + 1 - argument, SQRT3 - 1 + argument, SMALL_PARAMETER, argument**3 - 1, 1,
                 r"\int_1^Y\frac{\mathrm{d}y}{\sqrt{y^3-1}}"),
    2: FirstKind(sp.Integer(1), SQRT3 - 1 + argument, SQRT3 + 1 - argument, LARGE_PARAMETER, 1 - argument**3, -1,
                 r"\int_Y^1\frac{\mathrm{d}y}{\sqrt{1-y^3}}"),
    3: FirstKind(sp.Integer(-1), SQRT3 - 1 - argument, SQRT3 + 1 + argument, LARGE_PARAMETER, 1 + argument**3, 1,
                 r"\int_{-1}^Y\frac{\mathrm{d}y}{\sqrt{1+y^3}}"),
}


def first_kind(kind: int, argument_value: sp.Expr) -> sp.Expr:
    """Integral between the root of the integrand's radicand and the argument, by Legendre's F.

    Parameters
    ----------
    kind : int
        1: of 1/sqrt(y^3 - 1) from 1 to Y >= 1. 2: of 1/sqrt(1 - y^3) from Y <= 1 to 1. 3: of 1/sqrt(1 + y^3) from -1
        to Y >= -1.
    argument_value : sympy.Expr
        The limit Y.

    Returns
    -------
    sympy.Expr
        ``3**(-1/4) * elliptic_f(acos(...), m)`` in SymPy's convention, m the squared modulus.
    """
    form = KINDS[kind]
    cosine = form.cosine().subs(argument, sp.sympify(argument_value))
    return SCALE * sp.elliptic_f(sp.acos(cosine), form.parameter)


def complete(kind: int) -> sp.Expr:
    """Integral over the whole range, in gamma functions: 1 from 1 to infinity, 2 from 0 to 1, 3 from -1 to 0.

    The substitution y^3 -> u turns each into a beta function.
    """
    sixth, half = sp.Rational(1, 6), sp.Rational(1, 2)
    first = {1: sixth, 2: 2 * sixth, 3: 2 * sixth}[kind]
    return sp.gamma(first) * sp.gamma(half) / (3 * sp.gamma(first + half))


def identity_claims(kind: int) -> tuple[Claim, ...]:
    """Why F is the integral: it starts at zero, its slope has the right sign and the right square.

    With c = cos phi, dF/dY = -c'/sqrt((1 - c^2)(1 - m + m c^2)); both roots are positive on the range.
    """
    form = KINDS[kind]
    top, bottom, m = form.cosine_numerator, form.cosine_denominator, form.parameter
    slope = sp.expand(sp.diff(top, argument) * bottom - top * sp.diff(bottom, argument))
    under = sp.expand((bottom**2 - top**2) * ((1 - m) * bottom**2 + m * top**2))
    return (
        Claim(top.subs(argument, form.start), bottom.subs(argument, form.start)),
        Claim(slope, -form.sign * 2 * SQRT3),
        Claim(sp.expand(slope**2 * form.radicand / SQRT3), under),
    )


def elliptic_identity_steps() -> tuple[Step, ...]:
    """Three steps, one for each identity; every claim is a polynomial identity over the rationals and sqrt 3."""
    because = {
        1: r"The cosine of the amplitude is 1 at $Y = 1$ and falls with $Y$, with slope $-2\sqrt3$ over the squared "
           r"denominator. The squared slope of $F$ is then $1/(Y^3-1)$ exactly, so both sides start together and grow "
           r"alike. The modulus is $\sin 15^\circ$, $k^2 = (2-\sqrt3)/4$.",
        2: r"In the same way below the root: $F$ vanishes at $Y = 1$ and grows as $Y$ falls. The modulus is "
           r"$\sin 75^\circ$, $k^2 = (2+\sqrt3)/4$.",
        3: r"The sign of $y$ turned round gives the integral from the root of $1 + y^3$, with the same modulus "
           r"$\sin 75^\circ$.",
    }
    titles = {1: "Legendre form above the root", 2: "Legendre form below the root",
              3: "Legendre form from the negative root"}
    turned = Claim(KINDS[3].cosine(), KINDS[2].cosine().subs(argument, -argument))
    return tuple(
        Step(titles[kind], because[kind],
             (rf"{form.integral} = 3^{{-1/4}}\,F\!\left(\varphi\,\Big|\,{latex(sp.together(form.parameter))}\right)",
              rf"\cos\varphi = {latex(form.cosine())}",),
             (*identity_claims(kind), *((turned,) if kind == 3 else ())), result=True)
        for kind, form in KINDS.items())
