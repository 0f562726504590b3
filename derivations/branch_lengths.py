"""Branch lengths of graded spheres, eqs (16), (17), (19): the sum of two radii, its cube root, the lognormal for it.

Lengths are those of spheres in contact, l = r + r'. The median of the radii is that of their numbers, eq. (12).
"""

from __future__ import annotations

import sympy as sp
from sympy.codegen.cfunctions import expm1, log1p

from derivations.lognormal import HALF, classical_density, classical_moment, log_of, printed_density, printed_moment
from derivations.record import Claim, Step
from derivations.symbols import (
    branch_length,
    branch_log_variance,
    latex,
    log_variance,
    mode_ratio,
    r50,
    total_log_variance,
)

THIRD = sp.Rational(1, 3)

MEAN_GROWTH = (1 + sp.exp(log_variance)) / 2
"""Mean square over squared mean of the sum of two equal lognormals."""

TOTAL_LOG_VARIANCE = sp.log(MEAN_GROWTH)
"""Log variance of the lognormal that stands for the sum."""

NUMBER_MEDIAN = r50 * sp.exp(-2 * log_variance)
"""Median radius by number, in terms of the mode of eq. (18) by volume."""

TOTAL_MEDIAN = 2 * sp.exp(log_variance / 2) / sp.sqrt(MEAN_GROWTH)
"""Median of that lognormal over the median radius by number."""

MODE_RATIO = 2 * (sp.exp(log_variance) * MEAN_GROWTH) ** (-3 * HALF)
"""Mode of eq. (19) over the mode of eq. (18)."""

power = sp.Symbol("p", positive=True)
w = sp.Symbol("w", real=True)
q = sp.Symbol("q", real=True)
tau = sp.Symbol("tau", positive=True)


def sum_moment(number: int) -> sp.Expr:
    """Moment of the sum of two independent radii with median one, from the binomial theorem."""
    one = [classical_moment(sp.Integer(1), log_variance, sp.Integer(k)) for k in range(number + 1)]
    return sp.expand(sum(sp.binomial(number, k) * one[k] * one[number - k] for k in range(number + 1)))


def power_moment(number: sp.Expr, exponent: sp.Expr = THIRD) -> sp.Expr:
    """Moment of the branch length over r50 when eq. (17) has this exponent and the sum is taken for lognormal."""
    return printed_moment(MODE_RATIO, TOTAL_LOG_VARIANCE / exponent, number)


def branch_length_steps() -> tuple[Step, ...]:
    """All branches, one integral for them, their moments, eqs (17) and (19), and what (19) neglects."""
    return (_convolution_step(), _one_integral_step(), _moment_step(), _cube_root_step(), _parameter_step(),
            _neglected_step(), _tail_step())


def _convolution_step() -> Step:
    first, second, ell = sp.symbols("r_1 r_2 l", positive=True)
    change = sp.Matrix([first, first + second]).jacobian(sp.Matrix([first, second]))
    density = sp.Function("f", positive=True)
    return Step(
        "All branches, eq. (16)",
        r"Two spheres in contact are taken for two independent draws from the grains by number, and their branch is "
        r"the sum of two radii. With $\ell = r_1+r_2$ the double integral in the denominator is a product of two "
        r"integrals of $f^p$, each of them 1: the denominator of eq. (16) is 1.",
        (r"g_{\mathrm{total}}(\ell) = \int_0^{\ell} f^p(r)\,f^p(\ell-r)\,\mathrm{d}r,\qquad "
         r"\int g_{\mathrm{total}}\,\mathrm{d}\ell = \int f^p\,\mathrm{d}r_1\int f^p\,\mathrm{d}r_2 = 1",),
        (Claim(change.det(), sp.Integer(1)),
         Claim((density(first) * density(ell - first)).subs(ell, first + second), density(first) * density(second))),
        result=True)


def _one_integral_step() -> Step:
    radius = branch_length / (1 + sp.exp(w))
    other = branch_length - radius
    c = sp.Symbol("c", real=True)
    first, second = sp.symbols("r_1 r_2", positive=True)
    product = (classical_density(first, sp.Integer(1), log_variance)
               * classical_density(second, sp.Integer(1), log_variance) * first * second / branch_length)
    logs = {sp.log(first): q - w / 2 - c, sp.log(second): q + w / 2 - c}
    wanted = -((q - c) ** 2 + w**2 / 4) / log_variance - log_of(2 * sp.pi * log_variance * branch_length)
    shape = 2 * sp.cosh(w / 2)
    over_q, over_w = (sp.integrate(sp.exp(-(u**2) / scale), (u, -sp.oo, sp.oo))
                      for u, scale in ((q, log_variance), (w, 4 * log_variance)))
    return Step(
        "One integral for lognormal sizes",
        r"With $q = \ln\ell$ and the logarithm $w$ of the ratio of both radii, $r = \ell/(1+e^w)$, the two Gauss "
        r"curves of the convolution become one exponent, free of cancellation for every spread. Radii are in units of "
        r"their median by number. Over $q$ first and $w$ after it the integral is 1 again.",
        (r"g_{\mathrm{total}}(\ell) = \frac{1}{2\pi L\,\ell}\int_{-\infty}^{\infty}"
         r"\exp\left(-\frac{[q-c(w)]^2 + w^2/4}{L}\right)\mathrm{d}w,\qquad c(w) = \ln\left(2\cosh\frac w2\right)",),
        (Claim(sp.simplify(sp.diff(radius, w) + radius * other / branch_length), sp.Integer(0)),
         Claim(sp.simplify((radius / branch_length - sp.exp(-w / 2) / shape).rewrite(sp.exp)), sp.Integer(0)),
         Claim(sp.simplify((other / branch_length - sp.exp(w / 2) / shape).rewrite(sp.exp)), sp.Integer(0)),
         Claim(sp.expand(log_of(product).subs(logs)), sp.expand(wanted)),
         Claim(over_q * over_w / (2 * sp.pi * log_variance), sp.Integer(1))), result=True)


def _moment_step() -> Step:
    # over q the k-th moment is exp(k c + k^2 L/4); exp(k c) = (e^(w/2) + e^(-w/2))^k, and w has the variance 2 L
    moments = [sum(sp.binomial(k, j) * sp.exp(sp.Rational(2 * j - k, 2) ** 2 * log_variance) for j in range(k + 1))
               * sp.exp(sp.Rational(k * k, 4) * log_variance) for k in (1, 2, 3)]
    slope = sp.Symbol("a", real=True)
    return Step(
        "Moments of the sum",
        r"The radii are independent, so that the moments of their sum follow from the binomial theorem; the integral "
        r"over $w$ gives the same. By number the median is $r_{50}e^{-2L}$.",
        tuple(rf"\langle\ell^{{{k}}}\rangle_{{\mathrm{{total}}}} = {latex(sp.factor(sum_moment(k)))}"
              for k in (1, 2)),
        (*(Claim(sp.expand(moments[k - 1]), sum_moment(k)) for k in (1, 2, 3)),
         Claim(sp.expand(slope * w - w**2 / (4 * log_variance)),
               sp.expand(slope**2 * log_variance - (w - 2 * slope * log_variance) ** 2 / (4 * log_variance))),
         Claim(log_of(NUMBER_MEDIAN), log_of(r50 * sp.exp(log_variance) * sp.exp(-3 * log_variance)))), result=True)


def _cube_root_step() -> Step:
    total = printed_density(branch_length, r50, total_log_variance)
    along = printed_density(branch_length, r50, 3 * total_log_variance)
    return Step(
        "Branches of one direction, eq. (17)",
        "The paper approximates the density along one direction by the cube root of that of all branches. A cube "
        "root flattens a density. It leaves the mode of a lognormal density in the form of eq. (18) in place and "
        "makes its log variance three times as large, so that eq. (19) has the same form.",
        (r"g(\ell) = \frac{g_{\mathrm{total}}^{1/3}(\ell)}{\int g_{\mathrm{total}}^{1/3}\,\mathrm{d}\ell},\qquad "
         r"L_\ell = 3L_t",),
        (Claim(sp.simplify(sp.diff(log_of(sp.cbrt(total)) - log_of(along), branch_length)), sp.Integer(0)),),
        result=True)


def _parameter_step() -> Step:
    matched = [classical_moment(TOTAL_MEDIAN, TOTAL_LOG_VARIANCE, sp.Integer(k)) for k in (1, 2)]
    mode = TOTAL_MEDIAN * sp.exp(-TOTAL_LOG_VARIANCE) * NUMBER_MEDIAN
    return Step(
        "The parameters of eq. (19)",
        "The paper gives none. A lognormal with the mean and the mean square of the sum (Fenton and Wilkinson) has "
        r"the log variance $L_t$; eq. (17) makes it $L_\ell$ and keeps the mode. Both follow from $L$.",
        (r"L_t = \ln\frac{1+e^{L}}{2},\qquad L_\ell = \ln^2 s_\ell = 3L_t",
         r"\frac{\ell_{50}}{r_{50}} = 2\left(e^{L}\,\frac{1+e^{L}}{2}\right)^{-3/2}",
         r"\langle\ell^k\rangle_g = \ell_{50}^{k}\,e^{k(k+2)L_\ell/2},\qquad "
         r"\langle\ell^2\rangle_g = \ell_{50}^2\left(\frac{1+e^{L}}{2}\right)^{12}"),
        (*(Claim(sp.expand(sp.simplify(found)), sum_moment(k)) for k, found in enumerate(matched, start=1)),
         Claim(sp.expand(log_of(mode / (MODE_RATIO * r50))), sp.Integer(0)),
         Claim(log_of(printed_moment(sp.Integer(1), 3 * TOTAL_LOG_VARIANCE, sp.Integer(2))), 12 * log_of(MEAN_GROWTH)),
         Claim(sp.series(TOTAL_LOG_VARIANCE, log_variance, 0, 3).removeO(), log_variance / 2 + log_variance**2 / 8)),
        result=True)


def _neglected_step() -> Step:
    matched = sp.expand(sp.simplify(classical_moment(TOTAL_MEDIAN, TOTAL_LOG_VARIANCE, sp.Integer(3))))
    lost = sp.exp(3 * log_variance / 2) * (sp.exp(log_variance) - 1) ** 3
    tangent = sp.tanh(log_variance / 2).rewrite(sp.exp)
    return Step(
        "What eq. (19) neglects",
        "The sum of two lognormal sizes is not lognormal. With the first two moments matched the third is too small, "
        r"by a share that grows with the cube of $L$: the true density is more skew.",
        (r"\frac{\langle\ell^3\rangle_{\mathrm{total}}}{\langle\ell^3\rangle_{\mathrm{lognormal}}} = "
         r"1 + \tanh^3\frac{L}{2}",),
        (Claim(sum_moment(3) - matched, sp.expand(lost)),
         Claim(sp.factor(sp.expand(sum_moment(3) - matched * (1 + tangent**3)).simplify()), sp.Integer(0))),
        result=True)


def _tail_step() -> Step:
    least = sp.log(2)
    long_branch = (q - w / 2) ** 2 + w**2 / 4
    rise = sp.diff(sp.log(2 * sp.cosh(w / 2)), w)
    return Step(
        "Long and short branches",
        r"Far out on the side of long branches one grain is large and the other of no account: the least exponent, at "
        r"$w = q$, is that of a single radius, with the log variance $L$. On the side of short ones both radii are "
        r"small, $w = 0$, and the log variance is $L/2$. The lognormal of eq. (19) has $L_t$, which lies between, on "
        "both sides; long branches are too rare in it, and the more so the wider the gradation.",
        (r"\ell\to\infty:\ \ln g_{\mathrm{total}} \sim -\frac{\ln^2\ell}{2L},\qquad "
         r"\ell\to 0:\ \ln g_{\mathrm{total}} \sim -\frac{\ln^2\ell}{L},\qquad \frac L2 \le L_t \le L",),
        (Claim(sp.expand(long_branch), sp.expand((w - q) ** 2 / 2 + q**2 / 2)),
         Claim(sp.limit(sp.log(2 * sp.cosh(tau / 2)).rewrite(sp.exp) - tau / 2, tau, sp.oo), sp.Integer(0)),
         Claim(sp.simplify(rise - sp.tanh(w / 2) / 2), sp.Integer(0)),
         Claim(sp.log(2 * sp.cosh(w / 2)).subs(w, 0), least),
         Claim(sp.simplify((MEAN_GROWTH - sp.cosh(log_variance / 2) * sp.exp(log_variance / 2)).rewrite(sp.exp)),
               sp.Integer(0)),
         Claim(sp.exp(log_variance) - MEAN_GROWTH, (sp.exp(log_variance) - 1) / 2)))


def branch_parameters() -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
    """Assignments of eq. (19)'s parameters that lose no digit for nearly equal sizes."""
    return ((total_log_variance, log1p(expm1(log_variance) / 2)),
            (branch_log_variance, 3 * total_log_variance),
            (mode_ratio, 2 * sp.exp(-3 * HALF * (log_variance + total_log_variance))))
