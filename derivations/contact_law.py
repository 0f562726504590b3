"""The stiffness of one contact under its force, eqs (20) and (21): Hertz across, Mindlin along the contact."""

from __future__ import annotations

import sympy as sp

from derivations.kinematic import LAM
from derivations.record import Claim, Step
from derivations.symbols import (
    M,
    V,
    W,
    a,
    branch_length,
    c,
    f_ref,
    fn,
    fr,
    kn,
    kn_ref,
    kr,
    lam,
    latex,
    mean_branch_length,
    mean_stress,
    mu,
    nu,
    relative_radius,
    s,
    shear_modulus,
    x,
)

THIRD = sp.Rational(1, 3)

MODULUS = shear_modulus / (1 - nu)
"""Hertz's modulus of two equal materials."""

approach = sp.Symbol("delta_n", positive=True)
contact_radius = sp.Symbol("r_c", positive=True)


def normal_stiffness(force: sp.Expr, radius: sp.Expr) -> sp.Expr:
    """k_n of eq. (20)."""
    return sp.cbrt(3) * MODULUS ** (2 * THIRD) * sp.cbrt(2 * radius) * sp.cbrt(force)


def shear_share(shear: sp.Expr, normal: sp.Expr) -> sp.Expr:
    """k_r/(lambda k_n) of a contact that is sheared at constant normal force."""
    return sp.cbrt(1 - shear / (mu * normal))


def printed_shear_share(shear: sp.Expr, normal: sp.Expr) -> sp.Expr:
    """The same as printed in eq. (21)."""
    return sp.sqrt(shear / (mu * normal))


def _hertz_step() -> Step:
    force = sp.Rational(4, 3) * MODULUS * sp.sqrt(relative_radius) * approach ** sp.Rational(3, 2)
    stiffness = sp.diff(force, approach)
    return Step(
        "Hertz's normal stiffness, eq. (20)",
        r"Two spheres of one material that are pressed together approach by $\delta_n$ under a force that grows like "
        r"$\delta_n^{3/2}$. Its slope, written in the force, is eq. (20). The printed factor 1.4423 is the cube root "
        "of three, 1.44224 and more, rounded up.",
        (rf"{latex(fn)} = \frac43\,{latex(MODULUS)}\,{latex(sp.sqrt(relative_radius))}\,\delta_n^{{3/2}}",
         rf"{latex(kn)} = \frac{{\mathrm{{d}}f_n}}{{\mathrm{{d}}\delta_n}} = \sqrt[3]{{3}}"
         rf"\left({latex(MODULUS)}\right)^{{2/3}}(2{latex(relative_radius)})^{{1/3}}f_n^{{1/3}}"),
        (Claim(sp.powdenest(stiffness**3, force=True),
               sp.powdenest(normal_stiffness(force, relative_radius) ** 3, force=True)),
         Claim(sp.floor(sp.cbrt(3) * 10**5), sp.Integer(144224))), result=True)


def _length_step() -> Step:
    share = a * s + c * x**2
    reference = 3 * mean_stress * V / (M * mean_branch_length)
    force = reference * share / W
    at_contact = normal_stiffness(force, branch_length / 4).subs(branch_length, mean_branch_length * W)
    isotropic = normal_stiffness(reference, mean_branch_length / 4)
    return Step(
        "The normal stiffness does not depend on the branch length",
        r"With $R_e = \ell/4$ and a force inversely proportional to $\ell$ the product $R_ef_n$ is free of $\ell$, "
        "exactly: the shape of the grains acts on the stiffness through $W^2$ alone. The paper calls it hardly "
        "influenced. Over its value in the isotropic assembly the normal stiffness is the cube root of the normal "
        "force.",
        (rf"2R_e\,f_n = \frac{{\ell}}{{2}}\,\frac{{3pV}}{{M\ell}}\,({latex(a * s + c * x**2)})",
         rf"{latex(kn)} = {latex(kn_ref)}\,({latex(a * s + c * x**2)})^{{1/3}},\qquad "
         rf"{latex(kn_ref)} = \sqrt[3]{{3}}\left({latex(MODULUS)}\right)^{{2/3}}"
         rf"\left(\frac{{3pV}}{{2M}}\right)^{{1/3}}"),
        (Claim(sp.diff(2 * branch_length / 4 * 3 * mean_stress * V / (M * branch_length) * share, branch_length),
               sp.Integer(0)),
         Claim(at_contact**3, isotropic**3 * share),
         Claim(isotropic**3, 3 * MODULUS**2 * 3 * mean_stress * V / (2 * M))), result=True)


def _mindlin_step() -> Step:
    without_slip = 4 * shear_modulus * contact_radius / (2 - nu)
    displacement = 3 * mu * fn / (2 * without_slip) * (1 - (1 - fr / (mu * fn)) ** (2 * THIRD))
    compliance = sp.diff(displacement, fr)
    normal = 2 * MODULUS * contact_radius
    return Step(
        "Mindlin's shear stiffness, eq. (21)",
        r"Sheared at constant normal force, a contact of radius $r_c$ slips from its rim inwards. The displacement "
        r"$\delta_r$ then has the slope that gives the shear stiffness; without shear force it is $\lambda k_n$, and "
        "it vanishes where the whole contact slides.",
        (r"\delta_r = \frac{3\mu f_n}{2\lambda k_n}\left[1 - \left(1 - \frac{f_r}{\mu f_n}\right)^{2/3}\right]",
         rf"{latex(kr)} = {latex(lam)}\left(1 - \frac{{{latex(fr)}}}{{\mu {latex(fn)}}}\right)^{{1/3}}{latex(kn)},"
         rf"\qquad {latex(lam)} = {latex(LAM)}"),
        (Claim(sp.powsimp(1 / compliance), without_slip * shear_share(fr, fn)),
         Claim(sp.cancel(without_slip / normal), sp.cancel(LAM)),
         Claim(shear_share(sp.Integer(0), fn), sp.Integer(1)), Claim(shear_share(mu * fn, fn), sp.Integer(0))),
        result=True)


def _printed_step() -> Step:
    return Step(
        "The printed shear stiffness",
        r"Eq. (21) has $(f_r/(\mu f_n))^{1/2}$ in place of $(1 - f_r/(\mu f_n))^{1/3}$. Without any shear force that "
        r"makes the contact free to slide, where it must have $\lambda k_n$, and at the limit of friction it keeps "
        "full stiffness, where the contact slides.",
        (r"f_r = 0:\quad \left(\tfrac{f_r}{\mu f_n}\right)^{1/2} = 0,\qquad "
         r"f_r = \mu f_n:\quad \left(\tfrac{f_r}{\mu f_n}\right)^{1/2} = 1",),
        (Claim(printed_shear_share(sp.Integer(0), fn), sp.Integer(0)),
         Claim(printed_shear_share(mu * fn, fn), sp.Integer(1)),
         Claim(shear_share(sp.Integer(0), fn) - printed_shear_share(sp.Integer(0), fn), sp.Integer(1))))


def _reference_force_step() -> Step:
    equal = 3 * mean_stress * V / (M * mean_branch_length)
    radius = sp.Symbol("r", positive=True)
    return Step(
        "Equal spheres",
        r"For spheres of radius $r$ the branch length is $2r$, the relative radius $r/2$, and the force of the "
        "isotropic assembly the one by which the paper's figures are normalised.",
        (rf"{latex(f_ref)} = \frac{{3pV}}{{2rM}},\qquad R_e = \frac{{\ell}}{{4}} = \frac r2",),
        (Claim(equal.subs(mean_branch_length, 2 * radius), 3 * mean_stress * V / (2 * radius * M)),
         Claim((branch_length / 4).subs(branch_length, 2 * radius), 1 / (1 / radius + 1 / radius))))


def contact_law_steps() -> tuple[Step, ...]:
    """Hertz, the branch length that drops out, Mindlin, and what is wrong with the printed form."""
    return _hertz_step(), _reference_force_step(), _length_step(), _mindlin_step(), _printed_step()
