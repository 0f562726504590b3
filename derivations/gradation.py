"""Gradation, eqs (8)-(19): what the sizes of the grains add to the stiffness, and what they do not."""

from __future__ import annotations

from functools import cache

import sympy as sp

from derivations.branch_directions import branch_direction_steps
from derivations.branch_lengths import (
    MEAN_GROWTH,
    MODE_RATIO,
    NUMBER_MEDIAN,
    THIRD,
    TOTAL_LOG_VARIANCE,
    branch_length_steps,
    branch_parameters,
    power,
    power_moment,
    sum_moment,
)
from derivations.contact_law import MODULUS, normal_stiffness
from derivations.lognormal import classical_moment, lognormal_steps, printed_moment
from derivations.narrow_gradation import narrow_step
from derivations.record import Claim, Derivation, Function, Output, Step
from derivations.symbols import (
    branch_length,
    branch_log_variance,
    coordination,
    kinematic_factor,
    latex,
    log_variance,
    mean_cube,
    mean_stress,
    median,
    mode_ratio,
    nu,
    order,
    r50,
    radius,
    shear_modulus,
    static_factor,
    total_log_variance,
    void_ratio,
)

CONTACTS_PER_VOLUME = 3 * coordination / (8 * sp.pi * (1 + void_ratio) * mean_cube)

MEAN_CUBE_ROOT_SQUARED = sp.exp(-log_variance)
"""<r^3>_p^(2/3) over r50^2 for eq. (18)."""

KINEMATIC = sp.exp(-2 * log_variance) * MEAN_GROWTH**9
"""<l^2>_g/<r^3>_p^(2/3) over 4, with the parameters of eq. (19)."""

STATIC = sp.exp(-2 * log_variance) * MEAN_GROWTH**-3
"""1/(<l^-2>_g <r^3>_p^(2/3)) over 4, with the parameters of eq. (19)."""

TABLE_I = (sp.Rational(6, 5), sp.Rational(3, 2), sp.Integer(2))
"""Spreads of the paper's six gradations."""

mean_square = sp.Symbol("mean_square", positive=True)
scale = sp.Symbol("c", positive=True)
printed_mean, classical_mean = sp.symbols("printed_moment classical_moment", positive=True)


def kinematic_number(exponent: sp.Expr) -> sp.Expr:
    """<l^2>_g/<r^3>_p^(2/3) with any exponent in eq. (17), the sum of two radii taken for lognormal."""
    return 4 * sp.exp(-2 * log_variance) * MEAN_GROWTH ** (4 / exponent - 3)


def stiffness_scale(factor: sp.Expr) -> sp.Expr:
    """(M/V) <l^2> k_n of the isotropic assembly with the gradation's factor in it."""
    packing = 3 * coordination / (8 * sp.pi * (1 + void_ratio))
    return (4 * factor * packing ** (2 * THIRD) * sp.cbrt(3) * MODULUS ** (2 * THIRD)
            * sp.cbrt(3 * mean_stress / 2))


def isotropic_normal_stiffness(contacts: sp.Expr, length: sp.Expr) -> sp.Expr:
    """k_n under the force of the isotropic assembly with R_e = l/4, eqs (20) and (22)."""
    return normal_stiffness(3 * mean_stress / (contacts * length), length / 4)


def _contact_number_step() -> Step:
    grains, solids = sp.symbols("P V_s", positive=True)
    volume = (1 + void_ratio) * solids
    one = sp.Rational(4, 3) * sp.pi
    variable = sp.Symbol("rho", positive=True)
    delta = sp.DiracDelta(variable - radius)
    return Step(
        "Contacts in a volume, eqs (8)-(11)",
        r"Each grain of a volume has $\bar N$ contacts on average, and each contact belongs to two grains. The solids "
        r"fill $V/(1+e)$, so that the mean volume of a grain gives the number of grains. For equal spheres the mean "
        "cube is the cube of their radius.",
        (rf"\frac{{M}}{{V}} = \frac{{\delta^v\bar N}}{{2}} = {latex(CONTACTS_PER_VOLUME)},\qquad "
         r"\delta^v = \frac{1}{(1+e)\,\frac43\pi\,\langle r^3\rangle_p}",),
        (Claim((grains / volume * coordination / 2).subs(solids, one * mean_cube * grains), CONTACTS_PER_VOLUME),
         Claim(CONTACTS_PER_VOLUME.subs(mean_cube, radius**3),
               3 * coordination / (8 * sp.pi * (1 + void_ratio) * radius**3)),
         Claim(sp.integrate(delta * variable**3, (variable, 0, sp.oo)), radius**3)), result=True)


def _number_density_step() -> Step:
    total, variable = sp.symbols("Z rho", positive=True)
    density = sp.Function("f", positive=True)(variable)
    by_number = density / variable**3 / total
    return Step(
        "Grains by number, eq. (12)",
        r"A gradation curve weighs grains. Divided by the volume of a grain the density by volume becomes one by "
        r"number. Its mean cube is the harmonic one of the density by volume: small grains count, for there are many.",
        (r"f^p(r) = \frac{f^v(r)/r^3}{\int f^v/r^3\,\mathrm{d}r},\qquad "
         r"\langle r^3\rangle_p = \frac{1}{\langle r^{-3}\rangle_v}",),
        (Claim(by_number * variable**3, density / total),
         Claim(by_number * variable**order, density * variable ** (order - 3) / total)), result=True)


def _lognormal_number_step() -> Step:
    moved = sp.exp(-3 * log_variance)
    by_number = printed_moment(r50 * moved, log_variance, order)
    by_volume = [printed_moment(r50, log_variance, k) for k in (order - 3, sp.Integer(-3))]
    classical = [classical_moment(median, log_variance, k) for k in (order - 3, sp.Integer(-3))]
    cube = printed_moment(r50 * moved, log_variance, sp.Integer(3))
    return Step(
        "Lognormal sizes by number",
        r"The factor $r^{-3}$ of eq. (12) moves a lognormal density, in either form, by $e^{-3L}$ and leaves its "
        r"spread. The median by number is $r_{50}e^{-2L}$.",
        (r"f^v:\ r_{50}\quad\to\quad f^p:\ r_{50}\,e^{-3L}",
         rf"\langle r^3\rangle_p = {latex(sp.powsimp(cube))}"),
        (Claim(_log(by_volume[0] / by_volume[1]), _log(by_number)),
         Claim(_log(classical[0] / classical[1]), _log(classical_moment(median * moved, log_variance, order))),
         Claim(cube, 1 / by_volume[1]), Claim(cube, r50**3 * sp.exp(-3 * log_variance / 2)),
         Claim(sp.cbrt(cube) ** 2 / r50**2, MEAN_CUBE_ROOT_SQUARED),
         Claim(r50 * moved * sp.exp(log_variance), NUMBER_MEDIAN)), result=True)


def _mean_size_step() -> Step:
    density = sp.Function("f", positive=True)
    u, m, root = sp.symbols("u m I", positive=True)
    contacts = CONTACTS_PER_VOLUME.subs(mean_cube, scale**3 * mean_cube)
    kn_scaled = isotropic_normal_stiffness(contacts, scale * branch_length)
    kinematic = contacts * scale**2 * mean_square * kn_scaled
    one = sp.Function("g", positive=True)(m)
    return Step(
        "The stiffness does not depend on the mean size",
        r"Let every radius grow by a factor $c$ and the shape of the curve stay. Moments by number, the sum of two "
        r"radii and its cube root scale with $c$, so that $M/V$ falls with $c^{-3}$ and $\langle\ell^2\rangle$ grows "
        r"with $c^2$. The normal stiffness is free of $\ell$; as $(M/V)^{-1/3}$ it grows with $c$. The product does "
        "not change, exactly, for any gradation and for both hypotheses.",
        (r"\frac MV\to c^{-3}\frac MV,\quad \langle\ell^{\pm2}\rangle\to c^{\pm2}\langle\ell^{\pm2}\rangle,\quad "
         r"k_n\to c\,k_n:\qquad \frac MV\,\langle\ell^2\rangle\,k_n\to \frac MV\,\langle\ell^2\rangle\,k_n",),
        (Claim((density(radius / scale) / scale * radius**order * scale).subs(radius, scale * u),
               sp.expand_power_base(scale**order * density(u) * u**order)),
         Claim((density(radius / scale) * density(m - radius / scale) / scale**2 * scale).subs(radius, scale * u),
               density(u) * density(m - u) / scale),
         Claim(sp.cbrt(one / scale) / (scale * root / sp.cbrt(scale)), sp.cbrt(one) / (scale * root)),
         Claim(sp.diff(kn_scaled, branch_length).simplify(), sp.Integer(0)),
         Claim((kn_scaled**3 * contacts).simplify(), (kn_scaled**3 * contacts).subs(scale, 1).simplify()),
         Claim(((kn_scaled / scale) ** 3).simplify(), (kn_scaled**3).subs(scale, 1).simplify()),
         Claim(sp.diff((kinematic**3).simplify(), scale), sp.Integer(0)),
         Claim(sp.diff(((contacts * kn_scaled / (mean_square / scale**2)) ** 3).simplify(), scale), sp.Integer(0))),
        result=True)


def _carrier_step() -> Step:
    number = mean_square / mean_cube ** (2 * THIRD)
    stiffness = CONTACTS_PER_VOLUME * mean_square * isotropic_normal_stiffness(CONTACTS_PER_VOLUME, branch_length)
    return Step(
        "The number that carries gradation",
        r"With $M/V$ from above and Hertz's $k_n$ the sizes enter the isotropic stiffness as one pure number beside "
        r"void ratio, coordination number, mean stress and the material of the grains. For equal spheres it is 4. The "
        r"static hypothesis has $1/\langle\ell^{-2}\rangle$ for $\langle\ell^2\rangle$.",
        (r"\frac MV\langle\ell^2\rangle k_n = \frac{\langle\ell^2\rangle}{\langle r^3\rangle_p^{2/3}}"
         r"\left(\frac{3\bar N}{8\pi(1+e)}\right)^{2/3}\sqrt[3]{3}\left(\frac{G_s}{1-\nu}\right)^{2/3}"
         r"\left(\frac{3p}{2}\right)^{1/3}",),
        (Claim((stiffness**3 / stiffness_scale(number / 4) ** 3).simplify(), sp.Integer(1)),
         Claim(number.subs({mean_square: (2 * radius) ** 2, mean_cube: radius**3}), sp.Integer(4))), result=True)


def _closed_form_step() -> Step:
    moment = power_moment(sp.Integer(2)) / MEAN_CUBE_ROOT_SQUARED
    inverse = 1 / power_moment(sp.Integer(-2)) / MEAN_CUBE_ROOT_SQUARED
    half = sp.tanh(log_variance / 2).rewrite(sp.exp)
    orders = [sp.series(factor, log_variance, 0, 2).removeO() for factor in (KINEMATIC, STATIC)]
    values = [rf"s_r = {float(spread):g}:\ {sp.N(4 * KINEMATIC.subs(log_variance, sp.log(spread) ** 2), 4)}"
              for spread in TABLE_I]
    return Step(
        "The number in closed form, by eq. (19)",
        "Both are 4 for equal spheres. The kinematic number grows with every widening of the gradation, the static "
        r"one falls, and for narrow gradations both do so in proportion to $L$. Last are the kinematic ones for the "
        "spreads of Table I.",
        (rf"\frac{{\langle\ell^2\rangle}}{{\langle r^3\rangle_p^{{2/3}}}} = 4\,{latex(kinematic_factor)} = "
         r"4\,e^{-2L}\left(\frac{1+e^L}{2}\right)^{9} = 4\left(1+\tfrac52L+\dots\right)",
         rf"\frac{{1}}{{\langle\ell^{{-2}}\rangle\langle r^3\rangle_p^{{2/3}}}} = 4\,{latex(static_factor)} = "
         r"4\,e^{-2L}\left(\frac{2}{1+e^L}\right)^{3} = 4\left(1-\tfrac72L+\dots\right)",
         r",\quad ".join(values)),
        (Claim(_log(moment), _log(4 * KINEMATIC)), Claim(_log(inverse), _log(4 * STATIC)),
         Claim(orders[0], 1 + sp.Rational(5, 2) * log_variance), Claim(orders[1], 1 - sp.Rational(7, 2) * log_variance),
         Claim(sp.cancel(sp.diff(KINEMATIC, log_variance) / KINEMATIC), sp.cancel((5 + 9 * half) / 2)),
         Claim(sp.cancel(sp.diff(STATIC, log_variance) / STATIC), sp.cancel(-(7 + 3 * half) / 2))), result=True)


def _exponent_step() -> Step:
    general = power_moment(sp.Integer(2), power) / MEAN_CUBE_ROOT_SQUARED
    slope = sp.diff(kinematic_number(power) / 4, log_variance).subs(log_variance, 0)
    exact = sum_moment(2) * sp.exp(-4 * log_variance) / MEAN_CUBE_ROOT_SQUARED
    balanced = kinematic_number(sp.Rational(4, 7))
    inverse = 1 / power_moment(sp.Integer(-2), power) / MEAN_CUBE_ROOT_SQUARED
    return Step(
        "Other exponents than 1/3",
        r"With an exponent $p$ in eq. (17) the kinematic number changes with $L$ by the exponent of its last factor. "
        r"Without a root, $p = 1$, it is exact and falls below 4; with $p = 4/7$ the change of first order vanishes "
        r"and $4\cosh^4(L/2)$ is left. In this approximation no exponent makes the number constant, and the static one "
        r"does not depend on $p$ at all.",
        (r"\frac{\langle\ell^2\rangle}{\langle r^3\rangle_p^{2/3}} = 4\,e^{-2L}"
         r"\left(\frac{1+e^L}{2}\right)^{4/p-3} = 4\left(1+\left(\tfrac2p-\tfrac72\right)L+\dots\right)",
         r"p = 1:\ 2\left(e^{-L}+e^{-2L}\right),\qquad p = \tfrac47:\ 4\cosh^4\frac L2"),
        (Claim(_log(general), _log(kinematic_number(power))),
         Claim(sp.expand(slope), 2 / power - sp.Rational(7, 2)),
         Claim(kinematic_number(THIRD), 4 * KINEMATIC),
         Claim(sp.expand(exact), 2 * (sp.exp(-log_variance) + sp.exp(-2 * log_variance))),
         Claim(sp.expand(kinematic_number(sp.Integer(1))), sp.expand(exact)),
         Claim(sp.solve(2 / power - sp.Rational(7, 2), power)[0], sp.Rational(4, 7)),
         Claim(sp.expand(balanced), sp.expand(4 * sp.cosh(log_variance / 2).rewrite(sp.exp) ** 4)),
         Claim(_log(inverse), _log(4 * STATIC))), result=True)


def _one_length_step() -> Step:
    one_length = 2 * sp.cbrt(mean_cube)
    return Step(
        "When uniformity would not matter",
        r"That the stiffness is independent of uniformity does not follow from eqs (11), (12), (16) and (17). It is "
        r"exact when one length serves for the number of contacts and for the branches, "
        r"$\ell = 2\langle r^3\rangle_p^{1/3}$, the diameter of the grain of mean volume: then the number is 4 for "
        "every gradation and both hypotheses.",
        (r"\ell = 2\langle r^3\rangle_p^{1/3}:\quad \frac{\langle\ell^2\rangle}{\langle r^3\rangle_p^{2/3}} = "
         r"\frac{1}{\langle\ell^{-2}\rangle\langle r^3\rangle_p^{2/3}} = 4",),
        (Claim(one_length**2 / mean_cube ** (2 * THIRD), sp.Integer(4)),
         Claim(1 / (one_length**-2 * mean_cube ** (2 * THIRD)), sp.Integer(4))), result=True)


def _log(expression: sp.Expr) -> sp.Expr:
    return sp.expand(sp.expand_log(sp.log(expression), force=True))


def moment_functions() -> tuple[Function, ...]:
    """Emit the moments of both forms of a lognormal density."""
    return (
        Function("printed_lognormal_moment", "Mean of a size to a power under the density of eq. (18), without 1/r.",
                 (r50, log_variance, order), ((printed_mean, printed_moment(r50, log_variance, order)),),
                 (printed_mean,)),
        Function("classical_lognormal_moment", "Mean of a size to a power under the classical lognormal density.",
                 (median, log_variance, order), ((classical_mean, classical_moment(median, log_variance, order)),),
                 (classical_mean,)),
    )


def parameter_function() -> Function:
    """Emit the parameters of eq. (19); with L instead of e^L - 1 formed by subtraction they would lose digits."""
    return Function("branch_parameters", "Parameters of eq. (19) from the log variance of the grain sizes.",
                    (log_variance,), branch_parameters(), (branch_log_variance, mode_ratio),
                    notes="The mode of the branch length is mode_ratio times the mode of the radius in eq. (18).")


def factor_function() -> Function:
    """Emit what gradation does to the stiffness by eq. (19), for both hypotheses."""
    first, *_ = branch_parameters()
    return Function("gradation_factor", "Factors of the stiffness by gradation with eq. (19), 1 for equal spheres.",
                    (log_variance,),
                    (first, (kinematic_factor, sp.exp(9 * total_log_variance - 2 * log_variance)),
                     (static_factor, sp.exp(-3 * total_log_variance - 2 * log_variance))),
                    (kinematic_factor, static_factor),
                    notes="Void ratio, coordination number and mean stress are those of the equal spheres.")


@cache
def gradation() -> Derivation:
    """Derive how gradation enters the stiffness: contacts per volume, branch lengths, the number that carries it."""
    return Derivation(
        name="gradation",
        title="Gradation and branch lengths",
        sources=tuple(f"({number})" for number in range(8, 20)),
        assumptions=("Grains are spheres, or stand for spheres of the same volume.",
                     "Grains in contact are independent draws from the grains by number.",
                     "Void ratio and coordination number do not change with gradation.",
                     "Eq. (19): the sum of two lognormal radii is a lognormal with its mean and mean square."),
        domain=("L = ln^2 s_r >= 0", "sizes > 0"),
        inputs=(r50, median, log_variance, order, coordination, void_ratio, mean_cube, mean_stress, shear_modulus, nu),
        outputs=(Output(sp.Symbol("contacts_per_volume"), CONTACTS_PER_VOLUME, "1/m^3"),
                 Output(printed_mean, printed_moment(r50, log_variance, order), "m^order"),
                 Output(classical_mean, classical_moment(median, log_variance, order), "m^order"),
                 Output(branch_log_variance, 3 * TOTAL_LOG_VARIANCE), Output(mode_ratio, MODE_RATIO),
                 Output(kinematic_factor, KINEMATIC), Output(static_factor, STATIC),
                 Output(sp.Symbol("stiffness_scale"), stiffness_scale(KINEMATIC), "Pa")),
        steps=(_contact_number_step(), _number_density_step(), *lognormal_steps(), _lognormal_number_step(),
               *branch_length_steps(), _mean_size_step(), _carrier_step(), _closed_form_step(), narrow_step(),
               _exponent_step(), _one_length_step(), *branch_direction_steps()),
        functions=(*moment_functions(), parameter_function(), factor_function()),
    )
