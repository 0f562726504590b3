"""Aligned spheroids under the static hypothesis: forces that balance the stress although branches leave the normals."""

from __future__ import annotations

from itertools import product

import sympy as sp

from derivations import contact
from derivations.axial_components import six_components
from derivations.fabric import density_form, fabric_tensor
from derivations.forces import STRESS, same
from derivations.kinetic_components import TANGENTIAL_LESS_NORMAL, averaged_apart, positive_compliance
from derivations.record import Claim, Step
from derivations.sphere import axial_mean, azimuth_mean, meridian_form
from derivations.spheroid_components import STRETCH
from derivations.spheroid_moments import FABRIC
from derivations.symbols import (
    COMPLIANCE,
    N11,
    N33,
    NORMAL_FLEXIBILITIES,
    TANGENTIAL_FLEXIBILITIES,
    M,
    V,
    branch_length,
    kn,
    kr,
    latex,
    s,
    varrho,
    y,
)

norm = sp.Symbol("T", positive=True)
"""|Tn| of a direction."""


def static_steps() -> tuple[Step, ...]:
    """Show the forces, the tensor N and the compliance."""
    n = contact.NORMAL
    direction = STRETCH * n / norm
    mean = sp.Matrix(3, 3, lambda i, k: azimuth_mean(direction[i] * n[k]))
    tensor = sp.diag(N11, N11, N33)
    force = V / (M * branch_length) * STRESS.T * tensor.inv() * n
    unit = sp.Matrix(sp.symbols("l1:4", real=True))
    dyad = M / V * branch_length * unit * force.T
    average = {(i, k): sp.Symbol(f"N{i}{k}") for i, k in product(range(3), repeat=2)}
    contracted = sp.Matrix(3, 3, lambda i, j: sum(
        STRESS[p, j] * tensor.inv()[p, k] * average[i, k] for p in range(3) for k in range(3)))
    settled = {symbol: tensor[i, k] for (i, k), symbol in average.items()}
    as_sum = sp.Matrix(3, 3, lambda i, j: sum(unit[i] * n[k] * STRESS[p, j] * tensor.inv()[p, k]
                                              for p in range(3) for k in range(3)))
    n11, n33 = fabric_tensor()
    inverse, give = (1 / N11, 1 / N11, 1 / N33), contact.compliance().subs(contact.TO_EQUAL_TANGENTS)
    six = six_components(lambda p, j, q, m: inverse[p] * n[p] * give[j, m] * inverse[q] * n[q])
    return (
        Step("Contact forces off the normals",
             "The estimate of eq. (23) balances the stress if $A$ is the inverse of the mean of branch direction times "
             r"contact normal, $N_{ik} = \langle n^\ell_in_k\rangle$ with $n^\ell = \ell/|\ell|$. The length "
             "cancels in the sum over contacts, eqs (24) to (27), and the stress comes back whatever it is, eq. (28).",
             (r"f_j = \frac{V}{M|\ell|}\,\sigma_{pj}A_{pk}n_k,\qquad A = N^{-1},\qquad "
              r"\frac MV\int_\Omega\ell_if_j\,E\,\mathrm d\Omega = \sigma_{pj}A_{pk}N_{ik} = \sigma_{ij}",),
             (same(dyad, as_sum), same(contracted.subs(settled), STRESS.applyfunc(sp.expand))), result=True),
        Step("Mean of branch direction times contact normal",
             r"Along a meridian $n^\ell = \mathbf Tn/|\mathbf Tn|$ with $|\mathbf Tn| = \sqrt{s + \varrho^2y}$. The "
             "azimuth leaves two components. For spheres they are those of the fabric tensor.",
             (r"N_{11} = \Bigl\langle\frac{E\,s}{2\sqrt{s + \varrho^2y}}\Bigr\rangle,\qquad "
              r"N_{33} = \Bigl\langle\frac{\varrho\,E\,y}{\sqrt{s + \varrho^2y}}\Bigr\rangle",),
             (same(mean.applyfunc(meridian_form), sp.diag(s / 2, s / 2, varrho * y) / norm),
              *(Claim(axial_mean((density_form() * part).subs(FABRIC)), of_spheres)
                for part, of_spheres in ((s / 2, n11), (y, n33)))), result=True),
        Step("Compliance off the normals",
             "Contacts give way by their compliance times these forces, so the compliance of the assembly is that of "
             r"branches along the normals with two changes: $N_{11}$ and $N_{33}$ are the ones above, and the weight "
             r"is $E/|\ell|^2$. A symmetric stress meets its symmetrised part, whatever the spin of the grains.",
             (r"\frac{(2a_1)^2}{|\ell|^2} = \frac{s + \varrho y}{s + \varrho^2y},\qquad "
              r"u_j = \Bigl\langle\frac{E\,Q\,s^{2-j}y^j}{(s + \varrho^2y)\,k_n}\Bigr\rangle,\qquad "
              r"v_j = \Bigl\langle\frac{E\,Q\,s^{2-j}y^j}{(s + \varrho^2y)\,k_r}\Bigr\rangle",
              *(f"{latex(c)} = {latex(e)}" for c, e in zip(COMPLIANCE, positive_compliance(), strict=True))),
             (Claim(meridian_form(azimuth_mean((n.T * STRETCH**2 * n)[0])) * (s + varrho * y),
                    meridian_form(azimuth_mean((n.T * STRETCH * n)[0])) * (s + varrho**2 * y)),
              *(Claim(e.xreplace(TANGENTIAL_LESS_NORMAL),
                      averaged_apart(c, 1 / kn, 1 / kr, NORMAL_FLEXIBILITIES, TANGENTIAL_FLEXIBILITIES))
                for e, c in zip(positive_compliance(), six, strict=True))), result=True),
    )
