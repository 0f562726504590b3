"""Branch lengths that depend on direction: median and spread of eq. (19) by direction, and the moments they need."""

from __future__ import annotations

import sympy as sp

from derivations.lognormal import HALF, classical_moment, printed_moment
from derivations.record import Claim, Step
from derivations.symbols import W, branch_log_variance, mean_branch_length, x

zeta = sp.Symbol("zeta", real=True)
mean_variance = sp.Symbol("L_e", positive=True)
spread_fabric = sp.Symbol("D_s", real=True)
k = sp.Symbol("k", integer=True, nonnegative=True)
n = sp.Symbol("n", integer=True, nonnegative=True)

P2 = (3 * x**2 - 1) / 2


def kummer_moment(index: sp.Expr) -> sp.Expr:
    """Integral of x^(2k) exp(zeta x^2) over x from 0 to 1."""
    return sp.hyper((index + HALF,), (index + 3 * HALF,), zeta) / (2 * index + 1)


def kummer_moment_from_pole(index: sp.Expr) -> sp.Expr:
    """The same by Kummer's transformation: a series of positive terms when zeta is negative."""
    return sp.exp(zeta) * sp.hyper((sp.Integer(1),), (index + 3 * HALF,), -zeta) / (2 * index + 1)


def branch_direction_steps() -> tuple[Step, ...]:
    """Mean square by direction, the Dirac delta, Kummer moments."""
    return _direction_step(), _delta_step(), _spread_step(), _kummer_step(), _transformation_step()


def _direction_step() -> Step:
    center = mean_branch_length * W
    return Step(
        "Median and spread by direction, eq. (14)",
        r"With $\ell_{50}$ and $s_\ell$ of each direction in eq. (19) the stiffness needs the mean square of each "
        r"direction. The median enters like the length of a mono-sized assembly, with $W^2$; the spread multiplies. "
        "In the classical form the exponent is half of that in the form of eq. (18).",
        (r"\langle\ell^2\rangle(n) = \ell_{50}^2(n)\,e^{4L_\ell(n)}\ \text{(18)},\qquad "
         r"\langle\ell^2\rangle(n) = \tilde\ell^2(n)\,e^{2L_\ell(n)}\ \text{(classical)}",),
        (Claim(printed_moment(center, branch_log_variance, sp.Integer(2)),
               mean_branch_length**2 * W**2 * sp.exp(4 * branch_log_variance)),
         Claim(classical_moment(center, branch_log_variance, sp.Integer(2)),
               mean_branch_length**2 * W**2 * sp.exp(2 * branch_log_variance))), result=True)


def _delta_step() -> Step:
    def variation(moment: sp.Expr) -> sp.Expr:
        return moment.subs(k, 2) / moment.subs(k, 1) ** 2

    printed, classical = (form(mean_branch_length, branch_log_variance, k)
                          for form in (printed_moment, classical_moment))
    return Step(
        "One length for each direction again",
        r"The squared coefficient of variation is $e^{L_\ell}-1$ in both forms. For $s_\ell\to1$ it vanishes and "
        r"every moment becomes a power of $\ell_{50}$: the density is a Dirac delta.",
        (r"s_\ell\to1:\quad \frac{\langle\ell^2\rangle}{\langle\ell\rangle^2}-1 = e^{L_\ell}-1\to0,\qquad "
         r"\langle\ell^k\rangle\to\ell_{50}^k",),
        (*(Claim(sp.simplify(variation(form)), sp.exp(branch_log_variance)) for form in (printed, classical)),
         *(Claim(sp.limit(form, branch_log_variance, 0), mean_branch_length**k) for form in (printed, classical))))


def _spread_step() -> Step:
    exponent = sp.Symbol("kappa_s", real=True)
    by_direction = mean_variance * (1 + spread_fabric * P2)
    factor = 4 * mean_variance * spread_fabric
    return Step(
        "A spread with a fabric of its own",
        r"With $L_\ell(n) = L_e(1+D_sP_2)$ the direction enters as $e^{\kappa_sP_2}$, $\kappa_s = 4L_eD_s$ in the form "
        r"of eq. (18) and $2L_eD_s$ in the classical one, which is $e^{\zeta x^2}$ times a constant, "
        r"$\zeta = \tfrac32\kappa_s$.",
        (r"\langle\ell^2\rangle(n) = \ell_{50}^2(n)\,e^{4L_e}\,e^{\kappa_sP_2},\qquad "
         r"e^{\kappa_sP_2} = e^{-\zeta/3}\,e^{\zeta x^2}",),
        (Claim(sp.exp(4 * by_direction).simplify(),
               (sp.exp(4 * mean_variance) * sp.exp(exponent * P2)).subs(exponent, factor).simplify()),
         Claim(sp.expand(exponent * P2),
               sp.expand((-zeta / 3 + zeta * x**2).subs(zeta, 3 * HALF * exponent)))), result=True)


def _kummer_step() -> Step:
    term = zeta**n / sp.factorial(n) / (2 * k + 2 * n + 1)
    rising = sp.rf(k + HALF, n) / sp.rf(k + 3 * HALF, n)
    return Step(
        "Moments of the exponential",
        "Integrated term by term the moments are Kummer functions; by parts each follows from the one before.",
        (r"\int_0^1 x^{2k}e^{\zeta x^2}\,\mathrm{d}x = \frac{1}{2k+1}\,M\!\left(k+\tfrac12,\,k+\tfrac32,\,\zeta\right)",
         r"J_k = \int_0^1 x^{2k}e^{\zeta x^2}\,\mathrm{d}x:\qquad 2\zeta J_{k+1} = e^\zeta - (2k+1)J_k"),
        (Claim(sp.integrate(x ** (2 * k + 2 * n), (x, 0, 1)), 1 / (2 * k + 2 * n + 1)),
         Claim(sp.cancel(sp.expand_func(rising.rewrite(sp.gamma))), (2 * k + 1) / (2 * k + 2 * n + 1)),
         Claim(sp.simplify(term / (rising.rewrite(sp.gamma) / (2 * k + 1) * zeta**n / sp.factorial(n))), sp.Integer(1)),
         Claim(sp.expand(sp.diff(x ** (2 * k + 1) * sp.exp(zeta * x**2), x) * sp.exp(-zeta * x**2)).powsimp(),
               sp.expand((2 * k + 1) * x ** (2 * k) + 2 * zeta * x ** (2 * k + 2)).powsimp())), result=True)


def _transformation_step() -> Step:
    def term(index: sp.Expr) -> sp.Expr:
        return (-zeta) ** index / sp.rf(k + 3 * HALF, index).rewrite(sp.gamma)

    here, ahead = sp.symbols("J_k J_ahead", positive=True)
    step_down = sp.solve(2 * zeta * ahead - sp.exp(zeta) + (2 * k + 1) * here, here)[0]
    return Step(
        "No cancellation for either sign",
        r"For $\zeta<0$ the terms of the series alternate. The same recurrence from high orders down, where the "
        "moments vanish, adds up to a series of positive terms instead, which is Kummer's transformation. Directions "
        r"near the pole prevail for $\zeta>0$, near the equator for $\zeta<0$.",
        (r"M\!\left(k+\tfrac12,\,k+\tfrac32,\,\zeta\right) = e^{\zeta}\,M\!\left(1,\,k+\tfrac32,\,-\zeta\right)",),
        (Claim(step_down, sp.expand((sp.exp(zeta) - 2 * zeta * ahead) / (2 * k + 1))),
         Claim(sp.simplify(sp.expand_func(term(n + 1) / term(n))), -2 * zeta / (2 * (k + n + 1) + 1))))
