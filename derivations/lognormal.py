"""Lognormal size densities, eq. (18): one density in two forms, its moments, its powers, its uniformity."""

from __future__ import annotations

import sympy as sp

from derivations.record import Claim, Step
from derivations.symbols import latex, log_variance, median, order, r50

HALF = sp.Rational(1, 2)

size = sp.Symbol("size", positive=True)
u = sp.Symbol("u", real=True)
"""Logarithm of a size over the one that the density is centred on."""

b = sp.Symbol("b", positive=True)
shift = sp.Symbol("k", real=True)


def printed_density(radius: sp.Expr, mode: sp.Expr, variance: sp.Expr) -> sp.Expr:
    """Density of eq. (18), without 1/r, with the constant that normalises it."""
    constant = sp.exp(-variance / 2) / mode
    return constant / sp.sqrt(2 * sp.pi * variance) * sp.exp(-((sp.log(radius) - sp.log(mode)) ** 2) / (2 * variance))


def classical_density(radius: sp.Expr, center: sp.Expr, variance: sp.Expr) -> sp.Expr:
    """Density of a size whose logarithm is normal about that of its median."""
    return sp.exp(-((sp.log(radius) - sp.log(center)) ** 2) / (2 * variance)) / (
        radius * sp.sqrt(2 * sp.pi * variance))


def printed_moment(mode: sp.Expr, variance: sp.Expr, power: sp.Expr) -> sp.Expr:
    """Mean of the size to a power under :func:`printed_density`."""
    return mode**power * sp.exp(power * (power + 2) * variance / 2)


def classical_moment(center: sp.Expr, variance: sp.Expr, power: sp.Expr) -> sp.Expr:
    """Mean of the size to a power under :func:`classical_density`."""
    return center**power * sp.exp(power**2 * variance / 2)


def log_of(expression: sp.Expr) -> sp.Expr:
    """Logarithm of a product, term by term: two densities are the same when these agree."""
    return sp.expand(sp.expand_log(sp.log(expression), force=True))


def quantile_number(percent: int) -> sp.Expr:
    """Number of standard deviations with this percentage of a normal distribution below it."""
    return sp.sqrt(2) * sp.erfinv(2 * sp.Rational(percent, 100) - 1)


def uniformity(spread: sp.Expr) -> sp.Expr:
    """Coefficient of uniformity, D60 over D10."""
    return spread ** (quantile_number(60) - quantile_number(10))


def curvature(spread: sp.Expr) -> sp.Expr:
    """Coefficient of curvature, D30 squared over D10 and D60."""
    return spread ** (2 * quantile_number(30) - quantile_number(10) - quantile_number(60))


UNIFORMITIES = {sp.Rational(6, 5): 1323, sp.Rational(3, 2): 1863, sp.Integer(2): 2898}
"""A thousand times the coefficient of uniformity at the spreads of Table I, rounded."""


def weighted_exponent(power: sp.Expr) -> sp.Expr:
    """Exponent of r^power f dr in u = ln(r/r50), up to a constant, for eq. (18); dr adds one to the power."""
    return (power + 1) * u - u**2 / (2 * log_variance)


def lognormal_steps() -> tuple[Step, ...]:
    """Normalisation, moments, the classical form, powers and percentiles of eq. (18)."""
    return _density_step(), _moment_step(), _classical_step(), _power_step(), _uniformity_step()


def _density_step() -> Step:
    at_size = printed_density(size, r50, log_variance)
    base = sp.Symbol("b_0", positive=True)
    in_base = (sp.log(size) / sp.log(base) - sp.log(r50) / sp.log(base)) ** 2 / (sp.log(b) / sp.log(base)) ** 2
    gauss = sp.integrate(sp.exp(-(u**2)), (u, -sp.oo, sp.oo))
    return Step(
        "The size density of eq. (18)",
        r"Its exponent is a ratio of logarithms and the same for every base, so that the base changes nothing but "
        r"$A$; with natural logarithms and $L = \ln^2 s_r$ the constant that normalises it is below. There is no "
        r"$1/r$ before the exponential. Hence $r_{50}$ is where the density is largest, and neither its mean, as the "
        "paper has it, nor its median.",
        (r"f^v(r) = \frac{A}{\sqrt{2\pi L}}\exp\left(-\frac{(\ln r-\ln r_{50})^2}{2L}\right),\qquad "
         r"A = \frac{e^{-L/2}}{r_{50}}",),
        (Claim(in_base, (sp.log(size) - sp.log(r50)) ** 2 / sp.log(b) ** 2),
         Claim(sp.expand(weighted_exponent(sp.Integer(0))),
               sp.expand(log_variance / 2 - (u - log_variance) ** 2 / (2 * log_variance))),
         Claim(gauss, sp.sqrt(sp.pi)),
         Claim(log_of(at_size.subs(size, r50 * sp.exp(u)) * r50 * sp.exp(u)),
               sp.expand(weighted_exponent(sp.Integer(0)) - log_variance / 2) - log_of(sp.sqrt(2 * sp.pi
                                                                                              * log_variance))),
         Claim(sp.diff(log_of(at_size), size).subs(size, r50), sp.Integer(0)),
         Claim(sp.diff(log_of(at_size), size, 2).subs(size, r50), -1 / (r50**2 * log_variance))), result=True)


def _moment_step() -> Step:
    peak = (order + 1) * log_variance
    return Step(
        "Moments of eq. (18)",
        r"In $u = \ln(r/r_{50})$ the integrand of $\langle r^k\rangle$ is a Gauss curve; completing the square gives "
        r"the moment, and the one of order zero normalises. The mean is $r_{50}e^{3L/2}$.",
        (r"(k+1)u - \frac{u^2}{2L} = \frac{(k+1)^2L}{2} - \frac{(u-(k+1)L)^2}{2L}",
         rf"\langle r^k\rangle = {latex(printed_moment(r50, log_variance, order))}",),
        (Claim(sp.expand(weighted_exponent(order)),
               sp.expand((order + 1) ** 2 * log_variance / 2 - (u - peak) ** 2 / (2 * log_variance))),
         Claim(sp.expand(((order + 1) ** 2 - 1) * log_variance / 2),
               sp.expand(log_of(printed_moment(r50, log_variance, order) / r50**order))),
         Claim(printed_moment(r50, log_variance, sp.Integer(1)), r50 * sp.exp(3 * log_variance / 2))), result=True)


def _classical_step() -> Step:
    moved = r50 * sp.exp(log_variance)
    return Step(
        "The classical form of the same density",
        r"A size whose logarithm is normal has $1/r$ before the exponential. The factor $1/r$ only moves the centre "
        r"of the Gauss curve: eq. (18) is a classical lognormal density of the same spread, with the median "
        r"$\tilde r = r_{50}e^L$ and not $r_{50}$.",
        (r"f(r) = \frac{1}{r\sqrt{2\pi L}}\exp\left(-\frac{(\ln r-\ln\tilde r)^2}{2L}\right),\qquad "
         r"\tilde r = r_{50}\,e^{L}",
         rf"\langle r^k\rangle = {latex(classical_moment(median, log_variance, order))}"),
        (Claim(log_of(printed_density(size, r50, log_variance)), log_of(classical_density(size, moved, log_variance))),
         Claim(sp.expand(order * u - u**2 / (2 * log_variance)),
               sp.expand(order**2 * log_variance / 2 - (u - order * log_variance) ** 2 / (2 * log_variance))),
         Claim(log_of(printed_moment(r50, log_variance, order)), log_of(classical_moment(moved, log_variance, order)))),
        result=True)


def _power_step() -> Step:
    exponent = sp.Symbol("p", positive=True)
    printed = printed_density(size, r50, log_variance)
    classical = classical_density(size, median, log_variance)
    moved = r50 * sp.exp(shift * log_variance)
    return Step(
        "Powers of the size, powers of the density",
        r"Two operations keep either form and are all that eqs (12) and (17) need. A factor $r^k$ moves $r_{50}$ or "
        r"$\tilde r$ by $e^{kL}$. A power $p$ of a density of eq. (18) keeps its mode and divides the log variance by "
        r"$p$; $p$ = 1/3 multiplies it by three.",
        (r"r^k f(r;\, r_{50}, L) \propto f(r;\, r_{50}e^{kL}, L),\qquad [f(r;\, r_{50}, L)]^p \propto "
         r"f(r;\, r_{50}, L/p)",),
        tuple(Claim(sp.simplify(sp.diff(log_of(left) - log_of(right), size)), sp.Integer(0)) for left, right in (
            (size**shift * printed, printed_density(size, moved, log_variance)),
            (size**shift * classical, classical_density(size, median * sp.exp(shift * log_variance), log_variance)),
            (printed**exponent, printed_density(size, r50, log_variance / exponent)),
            (sp.cbrt(printed), printed_density(size, r50, 3 * log_variance)))), result=True)


def _uniformity_step() -> Step:
    deviation = sp.Symbol("sigma_0", positive=True)
    number = sp.Symbol("z", real=True)
    share = (1 + sp.erf((sp.log(size) - sp.log(median)) / (sp.sqrt(2) * deviation))) / 2
    finer = share.subs(size, median * sp.exp(deviation * number))
    names = tuple(rf"C_u({float(spread):g}) = {sp.N(uniformity(spread), 4)}" for spread in UNIFORMITIES)
    return Step(
        "Coefficients of uniformity and curvature",
        r"The share finer than $\tilde r s_r^{z}$ is that of a normal distribution below $z$. Ratios of sizes do not "
        r"depend on $\tilde r$, so that $C_u$ and $C_c$ are the same for both forms. They are those of Table I, which "
        "prints 1.3, 1.9 and 2.9.",
        (r"C_u = \frac{D_{60}}{D_{10}} = s_r^{\,z_{60}-z_{10}},\qquad "
         r"C_c = \frac{D_{30}^2}{D_{10}D_{60}} = s_r^{\,2z_{30}-z_{10}-z_{60}}",
         r",\quad ".join(names)),
        (Claim(sp.simplify(sp.diff(share, size) - classical_density(size, median, deviation**2)), sp.Integer(0)),
         Claim(sp.expand_log(finer, force=True), (1 + sp.erf(number / sp.sqrt(2))) / 2),
         *(Claim(((1 + sp.erf(number / sp.sqrt(2))) / 2).subs(number, quantile_number(percent)),
                 sp.Rational(percent, 100)) for percent in (10, 30, 60)),
         *(Claim(sp.floor(1000 * uniformity(spread) + HALF), sp.Integer(rounded))
           for spread, rounded in UNIFORMITIES.items())), result=True)
