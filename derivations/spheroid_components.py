"""Components of aligned spheroids: azimuth averages before and after symmetrisation, and with grains free to spin."""

from __future__ import annotations

from functools import cache
from itertools import product

import sympy as sp

from derivations import contact
from derivations.axial_components import six_components
from derivations.kinetic_components import NORMAL_LESS_TANGENTIAL, averaged_apart
from derivations.kinetic_components import components as collinear_components
from derivations.record import Claim, Step
from derivations.sphere import azimuth_mean, homogeneous, meridian_form
from derivations.symbols import (
    POSITIVE_MOMENTS,
    STIFFNESS,
    TANGENTIAL_MOMENTS,
    d0,
    d1,
    kn,
    kr,
    lam,
    latex,
    one_minus_lam,
    p0,
    p1,
    p2,
    q0,
    q1,
    q2,
    relaxed_C2323,
    varrho,
)

STRETCH = sp.diag(1, 1, varrho)
"""T = (M/a1)^2, which turns a contact normal towards its branch vector."""

SHEARS = (2323, 2332, 3232)
"""The vertical shears that differ before symmetrisation."""

HAT = dict(zip(SHEARS, sp.symbols(r"\hat{C}_{2323} \hat{C}_{2332} \hat{C}_{3232}", positive=True), strict=True))
"""Their symbols."""


def entry(i: int, j: int, k: int, m: int) -> sp.Expr:
    """l_i k_jl l_k of one direction, over (2 a1)^2/Q."""
    n, stiffness = contact.NORMAL, contact.stiffness().subs(contact.TO_EQUAL_TANGENTS)
    return STRETCH[i, i] * n[i] * stiffness[j, m] * STRETCH[k, k] * n[k]


def unsymmetrised(component: int) -> sp.Expr:
    """One component, averaged over the azimuth as it stands, in the moments p of k_n and q of k_r."""
    i, j, k, m = (int(digit) - 1 for digit in str(component))
    weights = homogeneous(meridian_form(azimuth_mean(entry(i, j, k, m))), 2)
    linear = sum(a * p for a, p in zip(weights, POSITIVE_MOMENTS, strict=True))
    return averaged_apart(linear, kn, kr, POSITIVE_MOMENTS, TANGENTIAL_MOMENTS)


@cache
def components() -> tuple[sp.Expr, ...]:
    """Six components with minor symmetry, in the moments p and q."""
    return tuple(averaged_apart(c, kn, kr, POSITIVE_MOMENTS, TANGENTIAL_MOMENTS) for c in six_components(entry))


def positive_shears() -> dict[int, sp.Expr]:
    """The three vertical shears before symmetrisation, with moments d of k_n - k_r in place of the subtraction."""
    return {2323: d1 / 2 + (q0 + q1) / 2, 2332: varrho * d1 / 2, 3232: varrho**2 * (d1 / 2 + q1 + q2)}


def positive_components() -> tuple[sp.Expr, ...]:
    """Six components with minor symmetry and no subtraction."""
    return (
        3 * p0 / 8 + (q0 / 8 + q1 / 2),
        varrho**2 * (p2 + q1),
        d0 / 8,
        varrho * d1 / 2,
        ((1 + varrho) ** 2 * d1 + (q0 + q1) + 2 * varrho**2 * (q1 + q2)) / 8,
        d0 / 8 + (q0 + q1) / 4,
    )


def constant_components() -> tuple[sp.Expr, ...]:
    """The same over k_n for k_r = lambda k_n."""
    q = (lam * p0, lam * p1, lam * p2)
    constant = dict(zip((*TANGENTIAL_MOMENTS, d0, d1), (*q, one_minus_lam * p0, one_minus_lam * p1), strict=True))
    return tuple(c.xreplace(constant) for c in positive_components())


def relaxed(shears: dict[int, sp.Expr]) -> sp.Expr:
    """Vertical shear when grains are free to spin, from the three shears before symmetrisation."""
    one, mixed, other = (shears[number] for number in SHEARS)
    return (one * other - mixed**2) / (one + other - 2 * mixed)


def positive_relaxed() -> sp.Expr:
    """The same with no subtraction but that of the aspect ratio from one."""
    along, across = q1 + q2, (q0 + q1) / 2
    return varrho**2 * (d1 / 2 * (across + along) + across * along) / (
        (1 - varrho) ** 2 * d1 / 2 + across + varrho**2 * along)


def component_steps() -> tuple[Step, ...]:
    """Show the azimuth averages, their symmetry, and the symmetrised components."""
    raw = {number: unsymmetrised(number) for number in (3333, 1111, 1122, 1133, 1212, *SHEARS)}
    shears = positive_shears()
    major = sum(sp.Symbol(f"c{i}{j}{k}{m}") * (entry(i, j, k, m) - entry(k, m, i, j))
                for i, j, k, m in product(range(3), repeat=4))
    apart = sp.expand(shears[2323] - shears[3232])
    return (
        Step("Azimuth averages of eq. (6)",
             r"Inserting the branch vector, eq. (6) has the weight $E/Q$, and every component is linear in three "
             r"moments of $k_n$, $p_j = \langle E\,k_n s^{2-j}y^j/Q\rangle$, and three of $k_r$, "
             r"$q_j = \langle E\,k_r s^{2-j}y^j/Q\rangle$. Before anything is symmetrised:",
             (r"\hat C_{ijkl} = \frac MV(2a_1)^2\int_\Omega T_{ip}n_p\,k_{jl}\,T_{kq}n_q\,\frac EQ\,\mathrm d\Omega",
              *(rf"\hat C_{{{number}}} = {latex(e)}" for number, e in raw.items())),
             tuple(Claim(e.subs(varrho, 1), e_collinear) for e, e_collinear in zip(
                 (raw[1111], raw[3333], raw[1122], raw[1133]), collinear_components()[:4], strict=True))),
        Step("Major symmetry holds, minor symmetry does not",
             r"Exchanging the pairs leaves $\ell_ik_{jl}\ell_k$ as it is, since $k_{jl}$ is symmetric. Exchanging the "
             "indices of a pair does not: turning the grains and straining the assembly are two things. The two "
             "vertical shears differ; for spheres they do so only as far as the fabric is anisotropic.",
             (rf"{latex(HAT[2323])} - {latex(HAT[3232])} = "
              rf"\tfrac12(1 - \varrho^2)\,d_1 + \tfrac12(q_0 + q_1) - \varrho^2(q_1 + q_2),\qquad d_1 = p_1 - q_1",),
             (Claim(sp.expand(major), sp.Integer(0)),
              Claim(raw[2323] - raw[3232], apart.xreplace(NORMAL_LESS_TANGENTIAL)),
              Claim(apart, (1 - varrho**2) * d1 / 2 + (q0 + q1) / 2 - varrho**2 * (q1 + q2)),
              *(Claim(raw[number], shears[number].xreplace(NORMAL_LESS_TANGENTIAL)) for number in SHEARS))),
        Step("Symmetrised stiffness",
             "Grains that turn with the mean deformation meet a symmetric strain, which sees the average over both "
             r"orders in each pair. With $d_j = \langle E(k_n - k_r)s^{2-j}y^j/Q\rangle$ every component is a sum of "
             "terms that are not negative.",
             (rf"C_{{2323}} = \tfrac14\bigl({latex(HAT[2323])} + 2{latex(HAT[2332])} + {latex(HAT[3232])}\bigr)",
              *(f"{latex(c)} = {latex(e)}" for c, e in zip(STIFFNESS, positive_components(), strict=True))),
             (*(Claim(e.xreplace(NORMAL_LESS_TANGENTIAL), whole)
                for e, whole in zip(positive_components(), components(), strict=True)),
              Claim((shears[2323] + 2 * shears[2332] + shears[3232]) / 4, positive_components()[4]),
              *(Claim(e.subs(varrho, 1), whole)
                for e, whole in zip(components(), collinear_components(), strict=True))), result=True),
    )


def spin_steps() -> tuple[Step, ...]:
    """Show what changes when every grain is free to spin."""
    strain, spin = sp.symbols("varepsilon omega", real=True)
    one, mixed, other = (HAT[number] for number in SHEARS)
    energy = (one * (strain + spin) ** 2 + 2 * mixed * (strain + spin) * (strain - spin) + other * (strain - spin) ** 2)
    free = -strain * (one - other) / (one + other - 2 * mixed)
    symmetrised = (one + 2 * mixed + other) / 4
    horizontal = unsymmetrised(1212)
    shears = positive_shears()
    product_, sum_ = (shears[2323] * shears[3232] - shears[2332] ** 2, shears[2323] + shears[3232] - 2 * shears[2332])
    across, along = (q0 + q1) / 2, q1 + q2
    stretching = sum(sp.Symbol(f"c{i}{j}{k}") * azimuth_mean(entry(i, i, j, k))
                     for i, j, k in product(range(3), repeat=3) if j != k)
    return (
        Step("Grains that are free to spin",
             r"Let all grains spin by $\omega$ about a horizontal axis besides following the mean shear "
             r"$\varepsilon_{23} = \varepsilon$. The energy is a parabola in $\omega$; it is least where the contact "
             "forces leave no couple on a grain. The shear modulus of that state is never above the symmetrised one, "
             "and is the same where the two vertical shears agree.",
             (rf"2U = {latex(one)}(\varepsilon + \omega)^2 + 2{latex(mixed)}(\varepsilon^2 - \omega^2)"
              rf" + {latex(other)}(\varepsilon - \omega)^2",
              rf"{latex(relaxed_C2323)} = {latex(relaxed(dict(HAT)))},\qquad "
              rf"C_{{2323}} - {latex(relaxed_C2323)} = {latex((one - other) ** 2 / (4 * (one + other - 2 * mixed)))}"),
             (Claim(sp.expand(energy), one * (strain + spin) ** 2 + 2 * mixed * (strain**2 - spin**2)
                    + other * (strain - spin) ** 2),
              Claim(sp.diff(energy, spin).subs(spin, free), sp.Integer(0)),
              Claim(energy.subs(spin, free), 4 * relaxed(dict(HAT)) * strain**2),
              Claim(energy.subs(spin, 0), 4 * symmetrised * strain**2),
              Claim(symmetrised - relaxed(dict(HAT)), (one - other) ** 2 / (4 * (one + other - 2 * mixed)))),
             result=True),
        Step("Free spin in positive form",
             "Both the numerator and the denominator can be written with no difference but that of the shape from a "
             "sphere, which is squared.",
             (rf"{latex(relaxed_C2323)} = {latex(positive_relaxed())}",),
             (Claim(product_, varrho**2 * (d1 / 2 * (across + along) + across * along)),
              Claim(sum_, (1 - varrho) ** 2 * d1 / 2 + across + varrho**2 * along)), result=True),
        Step("What free spin leaves alone",
             "In horizontal shear the two orders agree by the symmetry about axis 3, so that no couple arises; "
             "stretching does not couple to any spin.",
             (r"\hat C_{1212} = \hat C_{2121},\qquad \hat C_{1112} = \hat C_{1123} = \dots = 0",),
             (Claim(horizontal, unsymmetrised(2121)), Claim(stretching, sp.Integer(0)))),
    )
