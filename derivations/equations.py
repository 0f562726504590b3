"""Equations (1) to (4) and (7): from a sum over contacts to an average over directions."""

from __future__ import annotations

from functools import cache

import sympy as sp

from derivations import contact
from derivations.record import Claim, Derivation, Output, Step
from derivations.symbols import M, V, W, branch_length, cos_alpha, mean_branch_length, radius, sin_alpha, sin_beta, x


def _one_contact(i: int, j: int, k: int, m: int, branch: sp.Matrix) -> sp.Expr:
    return branch[i] * contact.stiffness()[j, m] * branch[k]


def _reversed(expression: sp.Expr) -> sp.Expr:
    """The same contact seen from its other grain: n -> -n, s -> s, t -> -t."""
    alpha_turn = {cos_alpha: -cos_alpha, sin_alpha: -sin_alpha}
    return expression.subs(alpha_turn, simultaneous=True).subs(x, -x)


@cache
def equations() -> Derivation:
    """Show how each of the stiffness equations follows from the one before."""
    n = contact.NORMAL
    entry = (0, 1, 2, 2)
    general = _one_contact(*entry, branch_length * n)
    ideal = _one_contact(*entry, 2 * radius * n)
    delta = sp.DiracDelta(branch_length - mean_branch_length * W)
    steps = (
        Step("Energy of a strained assembly, eq. (1)",
             r"Under uniform strain the two grains of a contact part by $\varepsilon_{ij}$ times the branch vector. "
             "Equating the work of the mean stress in $V$ with the work of the $M$ contact forces gives a sum over "
             "contacts; the branch vector enters once from the displacement and once from the stress.",
             (r"C_{ijkl} = \frac{1}{V}\sum_{c=1}^{M} \ell^c_i\,k^c_{jl}\,\ell^c_k",), result=True),
        Step("One contact, eq. (2)",
             "The contact is elastic along its normal and along two tangents. Since $n$, $s$, $t$ are orthonormal, the "
             "inverse has the same dyads with reciprocal coefficients.",
             (r"k_{jl} = k_n n_jn_l + k_s s_js_l + k_t t_jt_l",),
             tuple(Claim(sp.simplify(entry_), sp.Integer(int(i == j)))
                   for i in range(3) for j in range(3)
                   for entry_ in [_unit(contact.stiffness() * contact.compliance())[i, j]]), result=True),
        Step("Equal spheres, eq. (3)",
             "In an ideal assembly the branch vector is the contact normal times twice the radius.",
             (r"C_{ijkl} = \frac{4r^2}{V}\sum_{c=1}^{M} n^c_i\,k^c_{jl}\,n^c_k",),
             (Claim(ideal, 4 * radius**2 * _one_contact(*entry, n)),), result=True),
        Step("Many contacts, eq. (4)",
             "With many contacts the sum becomes $2M$ times an average over directions, where $E$ counts every contact "
             "twice, once along $n$ and once along $-n$; hence the factor 1/2. The summand does not change when $n$ is "
             "reversed, so counting both ends is harmless.",
             (r"C_{ijkl} = \frac12\,\frac{4r^2}{V}\,(2M)\int_\Omega n_i\,k_{jl}\,n_k\,E(n)\,\mathrm{d}\Omega",),
             (Claim(_reversed(_one_contact(*entry, n)), _one_contact(*entry, n)),), result=True),
        Step("Branch lengths, eq. (7)",
             r"When lengths vary, the contacts of one direction are split by length with density $g(\ell)$. For branch "
             "vectors along the contact normals the deviation tensor is the identity and drops out, and the length "
             "enters through its mean square alone.",
             (r"C_{ijkl} = \frac{M}{V}\int_\Omega\left[\int g(\ell)\,\ell^2\,\mathrm{d}\ell\right] "
              r"n_i\,k_{jl}\,n_k\,E(n)\,\mathrm{d}\Omega",),
             (Claim(general, branch_length**2 * _one_contact(*entry, n)),), result=True),
        Step("One length for each direction",
             r"For a mono-sized assembly $g$ is a Dirac delta at $\ell_e W(n)$, which leaves the weight $E W^2$.",
             (r"C_{ijkl} = \frac{M}{V}\,\ell_e^2\int_\Omega W^2(n)\,n_i\,k_{jl}\,n_k\,E(n)\,\mathrm{d}\Omega",),
             (Claim(sp.integrate(delta * branch_length**2, (branch_length, 0, sp.oo)), mean_branch_length**2 * W**2),)),
        Step("Back to eq. (4)",
             r"With $W = 1$ and $\ell_e = 2r$ the assembly is ideal again.",
             (r"W = 1,\ \ell_e = 2r:\quad \frac{M}{V}\,\ell_e^2 = \frac12\,\frac{4r^2}{V}\,(2M)",),
             (Claim((M / V * mean_branch_length**2 * W**2).subs({W: 1, mean_branch_length: 2 * radius}),
                    4 * radius**2 / V * 2 * M / 2),)),
    )
    prefactor = sp.Symbol("prefactor", positive=True)
    return Derivation(
        name="equations",
        title="From a sum over contacts to an average over directions",
        sources=("(1)", "(2)", "(3)", "(4)", "(5)", "(6)", "(7)"),
        assumptions=("Every contact displaces with the mean strain (kinematic hypothesis).",
                     "Branch vectors are parallel to contact normals.",
                     "The strain is small enough for the microstructure to stay as it is."),
        domain=("any fabric",),
        inputs=(M, V, mean_branch_length),
        outputs=(Output(prefactor, M / V * mean_branch_length**2, "1/m"),),
        steps=steps,
    )


def _unit(matrix: sp.Matrix) -> sp.Matrix:
    """Use sin^2 = 1 - cos^2 for both angles."""
    pythagoras = {sin_beta: sp.sqrt(1 - x**2), sin_alpha: sp.sqrt(1 - cos_alpha**2)}
    return matrix.subs(pythagoras).applyfunc(sp.expand)
