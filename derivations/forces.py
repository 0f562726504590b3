"""Contact forces from the mean stress, eqs (20)-(28): the static hypothesis, its uniqueness, the axial assembly."""

from __future__ import annotations

from functools import cache

import sympy as sp

from derivations import contact
from derivations.contact_law import contact_law_steps
from derivations.fabric import DENSITY, fabric_tensor
from derivations.forces_rank_four import rank_four_steps
from derivations.record import Claim, Derivation, Output, Step
from derivations.sphere import sphere_mean
from derivations.symbols import (
    D33,
    N11,
    N33,
    SR,
    M,
    V,
    W,
    a,
    branch_length,
    c,
    cos_alpha,
    d,
    f_ref,
    fn,
    fr,
    latex,
    mean_branch_length,
    mean_stress,
    s,
    sigma11,
    sigma33,
    sin_alpha,
    sin_beta,
    x,
)

N = sp.symbols("n1:4", real=True)
"""Components of a direction."""

STRESS = sp.Matrix(3, 3, lambda i, j: sp.Symbol(f"sigma{min(i, j) + 1}{max(i, j) + 1}", real=True))
"""An arbitrary stress."""

EQUATOR_FORCE = 5 * sigma11 / (mean_stress * (5 - D33))
POLE_FORCE = 5 * sigma33 / (mean_stress * (5 + 2 * D33))
"""Normal force at the equator and at the pole for W = 1, over that of the isotropic assembly."""

OF_RATIO = {sigma11: 3 * mean_stress / (2 + SR), sigma33: 3 * mean_stress * SR / (2 + SR)}
"""Principal stresses from their mean and their ratio."""

EQUATOR_OF_RATIO = 15 / ((2 + SR) * (5 - D33))
POLE_OF_RATIO = 15 * SR / ((2 + SR) * (5 + 2 * D33))
"""The same in the stress ratio."""

DIFFERENCE = 15 * (5 * (SR - 1) - D33 * (SR + 2)) / ((2 + SR) * (5 - D33) * (5 + 2 * D33))
"""c - a with the cancellation carried out."""

BALANCED_RATIO = (5 + 2 * D33) / (5 - D33)
"""Stress ratio that the fabric carries without shear forces."""


def deviator() -> sp.Matrix:
    """D_ij of a fabric without any symmetry: symmetric and traceless, five coefficients."""
    d11, d22, d12, d13, d23 = sp.symbols("D11 D22 D12 D13 D23", real=True)
    return sp.Matrix([[d11, d12, d13], [d12, d22, d23], [d13, d23, -d11 - d22]])


@cache
def rank_four_part() -> sp.Expr:
    """D_ijkl n_i n_j n_k n_l without any symmetry: a quartic whose Laplacian vanishes, nine coefficients."""
    monomials = sorted(sp.itermonomials(N, 4, 4), key=sp.default_sort_key)
    coefficients = sp.symbols(f"q1:{len(monomials) + 1}", real=True)
    quartic = sum(q * m for q, m in zip(coefficients, monomials, strict=True))
    laplacian = sp.Poly(sum(sp.diff(quartic, n, 2) for n in N), *N)
    return sp.expand(quartic.subs(sp.solve(laplacian.coeffs(), coefficients, dict=True)[0]))


def general_density() -> sp.Expr:
    """4 pi E of a fabric of rank two and four without any symmetry."""
    n = sp.Matrix(N)
    return 1 + sp.expand((n.T * deviator() * n)[0]) + rank_four_part()


@cache
def general_fabric_tensor() -> sp.ImmutableMatrix:
    """Mean of n_i n_j over the contacts of that fabric, by averaging over the sphere."""
    density = general_density()
    return sp.ImmutableMatrix(3, 3, lambda i, j: sphere_mean(N[i] * N[j] * density, N))


def same(left: sp.Matrix, right: sp.Matrix) -> Claim:
    """Two matrices agree: their contractions with an arbitrary matrix do."""
    rows, columns = left.shape
    weight = sp.Matrix(rows, columns, lambda i, j: sp.Symbol(f"c{i}{j}"))
    return Claim(sum(weight.multiply_elementwise(left)), sum(weight.multiply_elementwise(right)))


def axial_force() -> sp.Matrix:
    """f_j M l/V of an axially symmetric stress and fabric, with N11 and N33 as symbols."""
    return sp.diag(sigma11 / N11, sigma11 / N11, sigma33 / N33) * contact.NORMAL


def _on_sphere(expression: sp.Expr) -> sp.Expr:
    """Use sin^2 + cos^2 = 1 for the azimuth and write sin(beta)^2 as s."""
    reduced = sp.expand(sp.expand(expression).subs(sin_alpha**2, 1 - cos_alpha**2))
    return sp.expand(reduced.subs(sin_beta, sp.sqrt(s)))


def _average_steps() -> tuple[Step, ...]:
    fabric = general_fabric_tensor()
    coefficients = sp.Matrix(3, 3, lambda p, k: sp.Symbol(f"A{p + 1}{k + 1}", real=True))
    force = V / (M * branch_length) * STRESS.T * coefficients * sp.Matrix(N)
    turned = force.subs({n: -n for n in N}, simultaneous=True)
    dyad = M / V * branch_length * sp.Matrix(N) * force.T
    dirac = sp.DiracDelta(branch_length - mean_branch_length * W)
    one_length = sp.integrate(dirac, (branch_length, 0, sp.oo))
    pull = STRESS[:, 0].T * coefficients  # the second index of the stress only passes through
    axial = DENSITY.subs(x, N[2])
    mean = sp.Matrix(1, 3, lambda _, i: sphere_mean(sp.expand(N[i] * pull.dot(N) * axial), N))
    n11, n33 = fabric_tensor()
    return (
        Step("Mean stress as a sum over contacts, eqs (24) and (25)",
             r"In equilibrium the mean stress is the sum of branch vector times contact force over the $M$ contacts "
             "in the volume. With many contacts it becomes an average over directions and lengths, in which $E$ counts "
             "every contact from both of its grains, hence $2M/2$. Seen from the other grain both vectors turn round, "
             "so the summand is the same.",
             (r"\sigma_{ij} = \frac1V\sum_{c=1}^{M}\ell^c_i f^c_j = \frac{2M}{2V}\int_\Omega\int g(\ell)\,"
              r"\ell_i f_j\,\mathrm{d}\ell\;E(n)\,\mathrm{d}\Omega",),
             (same((-sp.Matrix(N)) * turned.T, sp.Matrix(N) * force.T),)),
        Step("Insert the estimate, eqs (26) and (27)",
             "The estimate is inversely proportional to the branch length. For branch vectors along the contact "
             r"normals the length cancels in $\ell_i f_j$, and $\int g\,\mathrm{d}\ell = 1$ for whatever gradation.",
             (r"f_j = \frac{V}{M\,\ell}\,\sigma_{pj}A_{pk}n_k\quad\Longrightarrow\quad "
              r"\frac MV\,\ell_i f_j = \sigma_{pj}A_{pk}n_kn_i",),
             (same(dyad, sp.Matrix(N) * (STRESS.T * coefficients * sp.Matrix(N)).T),
              same(sp.diff(dyad, branch_length), sp.zeros(3, 3)), Claim(one_length, sp.Integer(1)))),
        Step("Fabric tensor of any fabric",
             "The average of $n_in_k$ for a density of rank two and four without any symmetry. The rank-four part "
             "averages to zero.",
             (r"N_{ij} = \int_\Omega n_in_j\,E\,\mathrm{d}\Omega = \tfrac13\delta_{ij} + \tfrac{2}{15}D_{ij}",),
             (same(fabric, sp.eye(3) / 3 + sp.Rational(2, 15) * deviator()),), result=True),
        Step("The printed fabric tensor",
             "Below eq. (23) the two factors are exchanged. As $n_in_i = 1$ the trace must be one; the printed form "
             "has two fifths.",
             (r"\operatorname{tr}\left(\tfrac{2}{15}\delta_{ij} + \tfrac13D_{ij}\right) = \tfrac25",),
             (Claim((2 * sp.eye(3) / 15 + deviator() / 3).trace(), sp.Rational(2, 5)),
              Claim(fabric.trace(), sp.Integer(1)))),
        Step("The mean stress comes back, eq. (28)",
             "What is left of the average is the fabric tensor. With $A = N^{-1}$ the forces add up to the "
             "stress that they were made from, whatever the stress and whatever the fabric.",
             (r"\sigma_{pj}A_{pk}\int_\Omega n_kn_i\,E\,\mathrm{d}\Omega = \sigma_{pj}A_{pk}N_{ki} = \sigma_{ij}",),
             (same(mean, pull * sp.diag(n11, n11, n33)),
              same((STRESS.T * fabric.adjugate() * fabric).applyfunc(sp.expand),
                   (fabric.det(method="berkowitz") * STRESS.T).applyfunc(sp.expand))), result=True),
    )


def _unique_step() -> Step:
    n11, n33 = fabric_tensor()
    least = sp.Rational(1, 3) + sp.Rational(2, 15) * -1
    ends = ((n11, 2), (n33, -1))  # both are linear in D33: the least is at an end of [-1, 2]
    return Step(
        "Of rank two there is one solution",
        r"$A_{pk}N_{ki} = \delta_{ip}$ is solved by the inverse alone, and $N$ always has one: a density that is "
        r"nowhere negative has no principal value of $D_{ij}$ below $-1$, so none of $N_{ij}$ is below one fifth.",
        (rf"{latex(N11)} = {latex(n11)} \ge \tfrac15,\quad {latex(N33)} = {latex(n33)} \ge \tfrac15"
         rf"\quad\text{{for}}\quad -1 \le {latex(D33)} \le 2",),
        (Claim(least, sp.Rational(1, 5)),
         *(Claim(component.subs(D33, end), sp.Rational(1, 5)) for component, end in ends),
         Claim(sp.diff(n11, D33), -sp.Rational(1, 15)), Claim(sp.diff(n33, D33), sp.Rational(2, 15))))


def _axial_steps() -> tuple[Step, ...]:
    n11, n33 = fabric_tensor()
    force = axial_force()
    normal, meridian, parallel = (_on_sphere(force.dot(axis)) for axis in (
        contact.NORMAL, contact.MERIDIAN, contact.PARALLEL))
    scale = 3 * mean_stress
    equator, pole = EQUATOR_OF_RATIO, POLE_OF_RATIO
    plain = sp.Mul(5, SR - 1, evaluate=False) - D33 * (SR + 2)
    to_fabric = {N11: n11, N33: n33}
    return (
        Step("Normal and shear force of an axial assembly",
             "Stress and fabric share axis 3. Projection on the contact normal and on the two tangents leaves no shear "
             "force along the parallel.",
             (rf"\frac{{M\ell}}{{V}}\,{latex(fn)} = \frac{{{latex(sigma11)}}}{{{latex(N11)}}}\,s"
              rf" + \frac{{{latex(sigma33)}}}{{{latex(N33)}}}\,x^2",
              rf"\frac{{M\ell}}{{V}}\,{latex(fr)} = \left|\frac{{{latex(sigma33)}}}{{{latex(N33)}}}"
              rf" - \frac{{{latex(sigma11)}}}{{{latex(N11)}}}\right| x\sqrt{{s}}"),
             (Claim(normal, sigma11 / N11 * s + sigma33 / N33 * x**2),
              Claim(meridian, (sigma11 / N11 - sigma33 / N33) * x * sp.sqrt(s)), Claim(parallel, sp.Integer(0)))),
        Step("Over the force of the isotropic assembly",
             rf"Under the mean stress $p$ an isotropic assembly has the force ${latex(f_ref)}$ in all its contacts. "
             r"Divided by it, with $\ell = \ell_eW$, two numbers are left: the normal force at the equator and at the "
             "pole. Both are 1 when stress and fabric are isotropic.",
             (rf"{latex(f_ref)} = {latex(3 * mean_stress * V / (M * mean_branch_length))}",
              rf"{latex(fn)} = {latex(f_ref)}\,\frac{{{latex(a * s + c * x**2)}}}{{W}},\qquad "
              rf"{latex(fr)} = {latex(f_ref)}\,\frac{{|{latex(c)} - {latex(a)}|\,x\sqrt{{s}}}}{{W}}",
              rf"{latex(a)} = {latex(EQUATOR_FORCE)},\qquad {latex(c)} = {latex(POLE_FORCE)}"),
             (Claim(sp.cancel((sigma11 / N11 / scale).subs(to_fabric)), sp.cancel(EQUATOR_FORCE)),
              Claim(sp.cancel((sigma33 / N33 / scale).subs(to_fabric)), sp.cancel(POLE_FORCE)),
              Claim(equator.subs({SR: 1, D33: 0}), sp.Integer(1)), Claim(pole.subs({SR: 1, D33: 0}), sp.Integer(1))),
             result=True),
        Step("From mean stress and stress ratio",
             r"With $\mathrm{SR} = \sigma_{33}/\sigma_{11}$ at constant mean stress both are rational in the fabric "
             "and the ratio. The difference decides the shear force; its cancellation is carried out here, so that "
             "nearly equal forces lose no digit.",
             (rf"{latex(a)} = {latex(equator)},\qquad {latex(c)} = {latex(pole)}",
              rf"{latex(d)} = {latex(c)} - {latex(a)} = "
              rf"{latex(sp.Mul(15, plain, 1 / (2 + SR), 1 / (5 - D33), 1 / (5 + 2 * D33), evaluate=False))}"),
             (Claim(sp.cancel(EQUATOR_FORCE.subs(OF_RATIO)), sp.cancel(equator)),
              Claim(sp.cancel(POLE_FORCE.subs(OF_RATIO)), sp.cancel(pole)),
              Claim(sp.cancel(15 * plain / ((2 + SR) * (5 - D33) * (5 + 2 * D33))), sp.cancel(DIFFERENCE)),
              Claim((2 * sigma11 + sigma33).subs(OF_RATIO) / 3, mean_stress),
              Claim((sigma33 / sigma11).subs(OF_RATIO), SR),
              Claim(sp.cancel(sp.together(pole - equator)), sp.cancel(DIFFERENCE))), result=True),
        Step("A fabric that carries its stress without shear",
             "The shear force vanishes in all directions where stress and fabric tensor are proportional.",
             (rf"{latex(d)} = 0 \iff \mathrm{{SR}} = \frac{{N_{{33}}}}{{N_{{11}}}} = "
              rf"{latex(BALANCED_RATIO)}",),
             (Claim(sp.cancel(DIFFERENCE.subs(SR, BALANCED_RATIO)), sp.Integer(0)),
              Claim(sp.cancel(n33 / n11), sp.cancel(BALANCED_RATIO)))),
    )


@cache
def contact_forces() -> Derivation:
    """Derive the contact forces from the mean stress, and the contact stiffness from the forces."""
    return Derivation(
        name="contact_forces",
        title="Contact forces from the mean stress",
        sources=("(20)", "(21)", "(22)", "(23)", "(24)", "(25)", "(26)", "(27)", "(28)"),
        assumptions=("Every contact carries its share of the mean stress (static hypothesis): an estimate.",
                     "Branch vectors are parallel to contact normals.",
                     "The force of a direction is inversely proportional to the branch length.",
                     "Contacts follow Hertz across and Mindlin along the contact, sheared from zero at constant "
                     "normal force."),
        domain=("E nowhere negative", "W > 0", "SR > 0: no contact opens"),
        inputs=(D33, SR),
        outputs=(Output(a, EQUATOR_OF_RATIO), Output(c, POLE_OF_RATIO), Output(d, DIFFERENCE)),
        steps=(*_average_steps(), _unique_step(), *_axial_steps(), *rank_four_steps(), *contact_law_steps()),
    )
