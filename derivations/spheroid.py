"""Aligned spheroids: branch vectors off the contact normals, the deviation tensor, and what is emitted.

Grains are x M^-2 x = 1 with M = diag(a1, a1, a3), the axis of revolution along axis 3; chi = a3/a1, varrho = chi^2. All
components are over (M/V) (2 a1)^2, where M counts the contacts.
"""

from __future__ import annotations

from functools import cache
from itertools import product

import sympy as sp

from derivations.forces import N, same
from derivations.kinematic import LAM, ONE_MINUS_LAM
from derivations.kinetic_components import BULK, SHEAR, delta, positive_compliance, positive_stiffness, shear_sum
from derivations.record import Claim, Derivation, Function, Output, Step
from derivations.spheroid_components import (
    STRETCH,
    component_steps,
    constant_components,
    positive_components,
    positive_relaxed,
    spin_steps,
)
from derivations.spheroid_limits import limit_steps, sphere_steps
from derivations.spheroid_moments import moment_function, moment_steps
from derivations.spheroid_static import static_steps
from derivations.symbols import (
    COMPLIANCE,
    N11,
    N33,
    NORMAL_FLEXIBILITIES,
    POSITIVE_MOMENTS,
    STIFFNESS,
    TANGENTIAL_FLEXIBILITIES,
    TANGENTIAL_MOMENTS,
    aspect_ratio,
    d0,
    d1,
    g0,
    g1,
    lam,
    nu,
    one_minus_lam,
    q0,
    q1,
    q2,
    relaxed_C2323,
    varrho,
)

difference, equator, pole, half = sp.symbols("difference equator pole half", real=True)


def surface_point(shape: sp.Matrix) -> sp.Matrix:
    """The point of x M^-2 x = 1 whose outward normal has the direction of N."""
    n = sp.Matrix(N)
    return shape**2 * n / sp.sqrt((n.T * shape**2 * n)[0])


def _branch_steps() -> tuple[Step, ...]:
    n, point = sp.Matrix(N), sp.Matrix(sp.symbols("x1:4", real=True))
    first, third = sp.symbols("a1 a3", positive=True)
    shape = sp.diag(first, first, third)
    found = surface_point(shape)
    turned = found.subs({c: -c for c in N}, simultaneous=True)
    gradient = shape.inv() ** 2 * found
    upper, lower = shape * n, shape.inv() * point
    squared = (n.T * STRETCH * n)[0]
    branch = STRETCH * n / sp.sqrt(squared)
    of_shape = {third: first * sp.sqrt(varrho)}
    return (
        Step("The point of a spheroid with a given normal",
             r"A grain is $x^{\mathsf T}\mathbf M^{-2}x = 1$ with $\mathbf M = \operatorname{diag}(a_1, a_1, a_3)$. "
             r"The point where $n\cdot x$ is largest is the one whose tangent plane has the normal $n$; by Cauchy and "
             r"Schwarz $n\cdot x = (\mathbf Mn)\cdot(\mathbf M^{-1}x)$ is at most $|\mathbf Mn|$, and is that where "
             "both vectors are parallel.",
             (r"x = \frac{\mathbf M^2n}{|\mathbf Mn|},\qquad n\cdot x = |\mathbf Mn|",),
             (Claim((found.T * shape.inv() ** 2 * found)[0], sp.Integer(1)),
              same(gradient.cross(n), sp.zeros(3, 1)),
              Claim(n.dot(found), sp.sqrt((n.T * shape**2 * n)[0])),
              Claim(n.dot(point), upper.dot(lower)),
              Claim(upper.dot(upper) * lower.dot(lower) - upper.dot(lower) ** 2,
                    upper.cross(lower).dot(upper.cross(lower))))),
        Step("Branch vector",
             "Two such grains that touch with the normal $n$ do so at this point of the one and at the opposite point "
             r"of the other. With $\mathbf T = \mathbf M^2/a_1^2 = \operatorname{diag}(1, 1, \varrho)$, "
             r"$\chi = a_3/a_1$ and $\varrho = \chi^2$ the branch vector is exact:",
             (r"\ell_i = \frac{2(\mathbf M^2n)_i}{|\mathbf Mn|} = 2a_1\frac{(\mathbf Tn)_i}{\sqrt Q},\qquad "
              r"Q = \frac{|\mathbf Mn|^2}{a_1^2} = s + \varrho y,\qquad "
              r"|\ell|^2 = (2a_1)^2\,\frac{s + \varrho^2y}{s + \varrho y}",),
             (same(found - turned, 2 * found),
              same((found / first - branch).subs(of_shape).applyfunc(sp.simplify), sp.zeros(3, 1)),
              Claim(branch.dot(branch) * squared, N[0] ** 2 + N[1] ** 2 + varrho**2 * N[2] ** 2)), result=True),
        _deviation_step(branch),
    )


def _deviation_step(branch: sp.Matrix) -> Step:
    n = sp.Matrix(N)
    stretched = STRETCH * n
    length = stretched.dot(stretched)
    tensor = {(p, q, i, k): STRETCH[i, p] * STRETCH[k, q] / length for p, q, i, k in product(range(3), repeat=4)}
    contracted = sp.Matrix(3, 3, lambda i, k: sum(tensor[p, q, i, k] * N[p] * N[q]
                                                  for p in range(3) for q in range(3)))
    identity = sum(sp.Symbol(f"c{p}{q}{i}{k}") * (value.subs(varrho, 1) - int(p == i) * int(q == k) / n.dot(n))
                   for (p, q, i, k), value in tensor.items())
    share = contracted[2, 2]
    at_axes = sum(share.subs(dict(zip(N, axis, strict=True))) for axis in ((1, 0, 0), (0, 0, 1)))
    between = sum(share.subs(dict(zip(N, (1, 0, sign), strict=True))) for sign in (1, -1))
    return Step(
        "Deviation tensor of eq. (5)",
        r"It is to give $\ell_i\ell_k = |\ell|^2\,r_{pqik}n_pn_q$. The tensor below does; for spheres it is the "
        "identity. It depends on the direction, through its norm alone, and a tensor of constants does not exist: "
        "the values of a quadratic form at two orthogonal directions add up to those at their two bisectors, which "
        "here holds for spheres only.",
        (r"r_{pqik}(n) = \frac{T_{pi}\,T_{qk}}{|\mathbf Tn|^2},\qquad |\mathbf Tn|^2 = s + \varrho^2y,\qquad "
         r"\varrho = 1:\ r_{pqik} = \delta_{pi}\delta_{qk}",
         r"i = k = 3:\quad 1 - \frac{2\varrho^2}{1 + \varrho^2} = \frac{1 - \varrho^2}{1 + \varrho^2}"),
        (same(contracted * branch.dot(branch), branch * branch.T),
         Claim(contracted.trace(), sp.Integer(1)),
         Claim(sp.cancel(sp.expand(identity)), sp.Integer(0)),
         Claim(at_axes - between, (1 - varrho**2) / (1 + varrho**2))), result=True)


def functions() -> tuple[Function, ...]:
    """Emit components and moments; + - * / only in the components, so that exact fractions give exact components."""
    c1111, c3333, c1122, c1133, c2323, c1212 = STIFFNESS
    six = positive_stiffness(delta, shear_sum)
    tangential = (*TANGENTIAL_MOMENTS, d0, d1)
    return (
        Function(
            "stiffness_from_moments",
            "Six components over (M/V) (2a)^2 k_n from the moments of E/Q for contacts of equal stiffness.",
            (*POSITIVE_MOMENTS, varrho, nu),
            ((lam, LAM), (one_minus_lam, ONE_MINUS_LAM), *zip(STIFFNESS, constant_components(), strict=True)),
            STIFFNESS, unit="-", notes="Grains turn with the mean deformation."),
        Function(
            "stiffness_from_weights",
            "Six components over (M/V) (2a)^2 k_n,ref from moments of E k_n/Q, E k_r/Q and E (k_n - k_r)/Q.",
            (*POSITIVE_MOMENTS, *tangential, varrho),
            tuple(zip(STIFFNESS, positive_components(), strict=True)), STIFFNESS, unit="-",
            notes="All contact stiffnesses over k_n,ref. Grains turn with the mean deformation."),
        Function(
            "relaxed_shear",
            "Vertical shear component over (M/V) (2a)^2 k_n,ref when grains are free to spin.",
            (*TANGENTIAL_MOMENTS, d1, varrho),
            ((difference, 1 - varrho), (equator, (q0 + q1) / 2), (pole, q1 + q2), (half, d1 / 2),
             (relaxed_C2323, varrho**2 * (half * (equator + pole) + equator * pole)
              / (half * difference**2 + equator + varrho**2 * pole))),
            (relaxed_C2323,), unit="-",
            notes="The other five components are those of grains that do not spin. Some contacts must have k_r > 0."),
        Function(
            "stiffness_from_flexibilities",
            "Six components over (M/V) (2a)^2 k_n,ref by the static hypothesis, with l in units of 2a.",
            (*NORMAL_FLEXIBILITIES, *TANGENTIAL_FLEXIBILITIES, g0, g1, N11, N33),
            ((delta, BULK), (shear_sum, SHEAR), (c1212, six[5]), (c1122, six[2]), (c1111, c1122 + 2 * c1212),
             (c3333, six[1]), (c1133, six[3]), (c2323, six[4])),
            STIFFNESS, unit="-",
            notes="Moments of E l^-2/k_n, E l^-2/k_r and their difference, all contact flexibilities times k_n,ref; "
                  "N11 and N33 are means of the branch direction times the contact normal."),
        moment_function(),
    )


@cache
def spheroid() -> Derivation:
    """Derive the stiffness of aligned spheroids with their exact branch vectors."""
    return Derivation(
        name="spheroid",
        title="Stiffness of aligned spheroids",
        sources=("(5)", "(6)", "(24)", "(28)", "Figure 1(b)"),
        assumptions=(
            "Grains are identical spheroids with parallel axes of revolution, along axis 3.",
            "Every contact displaces with the mean strain (kinematic), or carries its share of the mean stress "
            "(static).",
            "Grains turn with the mean deformation; or, where it says so, each is free to spin (kinematic).",
            "Contact stiffness depends on the direction alone; tangentially it is the same in all directions.",
        ),
        domain=("aspect_ratio > 0; the emitted series: 1/3 <= aspect_ratio <= 3", "E nowhere negative",
                "0 <= nu <= 1/2", "free spin: k_r > 0 in some directions", "flexibilities: k_r > 0 in every direction"),
        inputs=(*POSITIVE_MOMENTS, *TANGENTIAL_MOMENTS, d0, d1, *NORMAL_FLEXIBILITIES, *TANGENTIAL_FLEXIBILITIES,
                g0, g1, N11, N33, aspect_ratio, varrho, nu),
        outputs=(*(Output(symbol, e) for symbol, e in zip(STIFFNESS, positive_components(), strict=True)),
                 Output(relaxed_C2323, positive_relaxed()),
                 *(Output(symbol, e) for symbol, e in zip(COMPLIANCE, positive_compliance(), strict=True))),
        steps=(*_branch_steps(), *component_steps(), *spin_steps(), *moment_steps(), *sphere_steps(),
               *limit_steps(), *static_steps()),
        functions=functions(),
    )
