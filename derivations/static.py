"""Compliance of an assembly with constant contact stiffness under the static hypothesis, and its inverse."""

from __future__ import annotations

import math
from functools import cache

import sympy as sp

from derivations import batch_static, contact
from derivations.axial_components import six_components
from derivations.fabric import DENSITY, fabric_tensor
from derivations.kinematic import DISTINCT_TANGENTS, EQUAL_TANGENTS, LAM, ONE_MINUS_LAM
from derivations.record import Claim, Derivation, Function, Output, Step
from derivations.sphere import sphere_mean
from derivations.static_moments import moment_function, moment_steps
from derivations.symbols import (
    COMPLIANCE,
    D33,
    D3333,
    N11,
    N33,
    S1111,
    S1122,
    S1133,
    S1212,
    S2323,
    S3333,
    STIFFNESS,
    Dr33,
    kn,
    kr,
    ks,
    kt,
    lam,
    latex,
    nu,
    one_minus_lam,
    p0,
    p1,
    p2,
    x,
)

fifteen_N11, fifteen_N33, A11, A33 = sp.symbols("fifteen_N11 fifteen_N33 A11 A33", positive=True)
delta, shear_sum, determinant = sp.symbols("delta shear_sum determinant", positive=True)


def components() -> tuple[sp.Expr, ...]:
    """Six compliance components times (M/V) l_e^2 in the positive moments of E/W^2, for k_n, k_s, k_t distinct."""
    n, compliance = contact.NORMAL, contact.compliance()
    inverse = (1 / N11, 1 / N11, 1 / N33)
    return six_components(lambda p, j, q, m: inverse[p] * n[p] * compliance[j, m] * inverse[q] * n[q])


def positive_compliance() -> tuple[sp.Expr, ...]:
    """The same times k_n for k_s = k_t = lambda k_n, with 1 - lambda as a quantity of its own."""
    return (
        (3 * p0 / 8 + (p0 / 8 + p1 / 2) / lam) / N11**2,
        (p2 + p1 / lam) / N33**2,
        -one_minus_lam * p0 / (8 * lam * N11**2),
        -one_minus_lam * p1 / (2 * lam * N11 * N33),
        ((p1 + p0 / lam) / N11**2 + (p1 + (2 * p2 + p1) / lam) / N33**2
         - 2 * one_minus_lam * p1 / (lam * N11 * N33)) / 8,
        (p0 / 4 + (p0 / 4 + p1 / 2) / lam) / (2 * N11**2),
    )


def inverse(compliance: tuple[sp.Expr, ...]) -> tuple[sp.Expr, ...]:
    """Invert a transversely isotropic compliance: a 2 x 2 block for stretching, two shears."""
    s11, s33, s12, s13, s44, s66 = compliance
    block = (s11 + s12) * s33 - 2 * s13**2
    sum_, difference = s33 / block, 1 / (s11 - s12)
    return ((sum_ + difference) / 2, (s11 + s12) / block, (sum_ - difference) / 2, -s13 / block,
            1 / (4 * s44), 1 / (4 * s66))


BULK = lam * p0 * p2 + p1 * (p0 + p1 + p2) + one_minus_lam * p1**2
SHEAR = (1 + lam) * p0 + 2 * p1


def positive_stiffness(bulk: sp.Expr = BULK, shear: sp.Expr = SHEAR) -> tuple[sp.Expr, ...]:
    """The inverse over k_n with no subtraction outside the vertical shear."""
    c1212 = 2 * lam * N11**2 / shear
    c1122 = N11**2 * one_minus_lam * (lam * p0 * (p1 + p2) + one_minus_lam * p1 * (p0 + 2 * p1)) / (bulk * shear)
    return (c1122 + 2 * c1212, N33**2 * (lam * p0 + p1) / bulk, c1122, N11 * N33 * one_minus_lam * p1 / bulk,
            1 / (4 * positive_compliance()[4]), c1212)


def _by_fabric(compliance: sp.Expr) -> str:
    """Typeset a compliance as one bracket for each product of fabric components in the denominator."""
    a11, a33 = sp.symbols("a11 a33", positive=True)
    groups = sp.Poly(sp.expand(compliance.subs({N11: 1 / a11, N33: 1 / a33})), a11, a33).terms()
    text = ""
    for (of_11, of_33), coefficient in groups:
        eightfold = sp.expand(8 * coefficient)
        whole = [int(term.as_coeff_Mul()[0]) for term in sp.Add.make_args(eightfold)]
        divisor = math.gcd(*whole) * (-1 if max(whole) < 0 else 1)
        inner = sp.collect(sp.expand(eightfold / divisor), (1 / kt, 1 / lam))
        head = latex(sp.Rational(abs(divisor), 8) / (N11**of_11 * N33**of_33))
        sign = "-" if divisor < 0 else "+" if text else ""
        bracket = latex(inner) if inner.is_Mul else rf"\left({latex(inner)}\right)"
        text += f" {sign} {head}{bracket}"
    return text.strip()


def _abbreviated() -> tuple[sp.Expr, ...]:
    """The inverse with symbols for its two denominators, as it is shown."""
    *stretching, _, horizontal = positive_stiffness(sp.Symbol("Delta"), sp.Symbol("Sigma"))
    return (*stretching, 1 / (4 * S2323), horizontal)


def _explicit(expression: sp.Expr) -> sp.Expr:
    return expression.subs(one_minus_lam, 1 - lam)


def _balance() -> Claim:
    """Average l_i f_j over the contacts for an arbitrary stress: it must be that stress."""
    n = sp.symbols("n1:4", real=True)
    stress = sp.Matrix(3, 3, lambda i, j: sp.Symbol(f"sigma{min(i, j) + 1}{max(i, j) + 1}"))
    n11, n33 = fabric_tensor()
    inverse_fabric = sp.diag(1 / n11, 1 / n11, 1 / n33)
    force = stress.T * inverse_fabric * sp.Matrix(n)
    density = DENSITY.subs(x, n[2])
    mean = sp.Matrix(3, 3, lambda i, j: sphere_mean(n[i] * force[j] * density, n)).applyfunc(sp.cancel)
    return Claim(sum(sp.Symbol(f"c{i}{j}") * mean[i, j] for i in range(3) for j in range(3)),
                 sum(sp.Symbol(f"c{i}{j}") * stress[i, j] for i in range(3) for j in range(3)))


def _vanishes(expression: sp.Expr) -> Claim:
    return Claim(sp.cancel(sp.together(expression)), sp.Integer(0))


def compliance_function() -> Function:
    """Emit the six compliance components from the moments, D33 and Poisson's ratio."""
    tensors = {N11: 1 / A11, N33: 1 / A33}
    return Function(
        "compliance_from_moments",
        "Six compliance components times (M/V) l_e^2 k_n from the positive moments of E/W^2.",
        (p0, p1, p2, D33, nu),
        (*_tensor_assignments(), *_inverse_assignments(), (lam, LAM), (one_minus_lam, ONE_MINUS_LAM),
         *((c, e.xreplace(tensors)) for c, e in zip(COMPLIANCE, positive_compliance(), strict=True))), COMPLIANCE,
        unit="-")


def stiffness_function() -> Function:
    """Emit the six stiffness components in positive form, the inverse of the compliance."""
    c1111, c3333, c1122, c1133, c2323, c1212 = STIFFNESS
    vertical = sp.Symbol("eight_S2323", positive=True)
    return Function(
        "stiffness_from_moments", "Six stiffness components over (M/V) l_e^2 k_n from the positive moments of E/W^2.",
        (p0, p1, p2, D33, nu),
        (*_tensor_assignments(), (lam, LAM), (one_minus_lam, ONE_MINUS_LAM),
         (delta, BULK), (shear_sum, SHEAR),
         (vertical, (lam * p1 + p0) / fifteen_N11**2 + (lam * p1 + 2 * p2 + p1) / fifteen_N33**2
          - 2 * one_minus_lam * p1 / (fifteen_N11 * fifteen_N33)),
         (c1212, 2 * lam * fifteen_N11**2 / (225 * shear_sum)),
         (c1122, fifteen_N11**2 * one_minus_lam
          * (lam * p0 * (p1 + p2) + one_minus_lam * p1 * (p0 + 2 * p1)) / (225 * delta * shear_sum)),
         (c1111, c1122 + 2 * c1212),
         (c3333, fifteen_N33**2 * (lam * p0 + p1) / (225 * delta)),
         (c1133, fifteen_N11 * fifteen_N33 * one_minus_lam * p1 / (225 * delta)),
         (c2323, 2 * lam / (225 * vertical))), STIFFNESS, unit="-")


def _tensor_assignments() -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
    n11, n33 = fabric_tensor()
    return (fifteen_N11, sp.expand(15 * n11)), (fifteen_N33, sp.expand(15 * n33))


def _inverse_assignments() -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
    return (A11, 15 / fifteen_N11), (A33, 15 / fifteen_N33)


def three_functions() -> tuple[Function, ...]:
    """Emit compliance and stiffness for three different contact stiffnesses."""
    tensors = {N11: 1 / A11, N33: 1 / A33}
    collected = tuple(sp.collect(c.xreplace(tensors), (kn, ks, kt)) for c in components())
    arguments = (p0, p1, p2, D33, kn, ks, kt)
    c1111, c3333, c1122, c1133, c2323, c1212 = STIFFNESS
    compliance = Function(
        "compliance_from_moments", "Six compliance components times (M/V) l_e^2 from the positive moments of E/W^2.",
        arguments,
        (*_tensor_assignments(), *_inverse_assignments(), *zip(COMPLIANCE, collected, strict=True)),
        COMPLIANCE, unit="m/N")
    stiffness = Function(
        "stiffness_from_compliance", "Six stiffness components, the inverse of a transversely isotropic compliance.",
        COMPLIANCE,
        ((determinant, (S1111 + S1122) * S3333 - 2 * S1133**2),
         (c1212, 1 / (4 * S1212)), (c2323, 1 / (4 * S2323)),
         (c3333, (S1111 + S1122) / determinant), (c1133, -S1133 / determinant),
         (c1111, S3333 / (2 * determinant) + 1 / (2 * (S1111 - S1122))),
         (c1122, S3333 / (2 * determinant) - 1 / (2 * (S1111 - S1122)))), STIFFNESS, unit="N/m")
    return compliance, stiffness


def _compliance_steps() -> tuple[Step, ...]:
    equal = tuple(c.subs(contact.TO_EQUAL_TANGENTS) for c in components())
    return (
        Step("Contact forces from the mean stress, eq. (23)",
             r"Under the static hypothesis every contact carries its share of the mean stress, with $A$ the "
             r"inverse of the "
             r"fabric tensor $N$. Averaging $\ell_i f_j$ over the contacts returns that stress, whatever it is.",
             (r"f_j = \frac{V}{M\,\ell}\,\sigma_{pj}A_{pk}n_k,\qquad A = N^{-1}",),
             (_balance(),)),
        Step("Strain from the contact displacements",
             "Each contact gives way by its compliance times its force. By the work of the mean stress the compliance "
             "of the assembly is a sum with the branch length in the denominator, so the weight is $E/W^2$.",
             (r"S_{pjql} = \frac{V}{M\,\ell_e^2}\int_\Omega A_{pk}n_k\,s_{jl}\,A_{qm}n_m\,"
              r"\frac{E}{W^2}\,\mathrm{d}\Omega",)),
        Step("Six compliances, each linear in three moments",
             "The average over the azimuth leaves quadratic forms in $s$ and $y$, as for the stiffness.",
             tuple(f"{latex(c)} = {_by_fabric(e)}" for c, e in zip(COMPLIANCE, components(), strict=True)),
             (Claim(components()[5], (components()[0] - components()[2]) / 2),), result=True),
        Step("Equal tangential stiffness",
             r"For $k_s = k_t = \lambda k_n$ the components times $k_n$ become",
             tuple(f"{latex(c)} = {_by_fabric(e)}" for c, e in zip(COMPLIANCE, positive_compliance(), strict=True)),
             tuple(Claim(kn * e.subs(kr, lam * kn), _explicit(f))
                   for e, f in zip(equal, positive_compliance(), strict=True))),
    )


def _inverse_step() -> Step:
    exact = inverse(tuple(_explicit(c) for c in positive_compliance()))
    return Step(
        "Stiffness in positive form",
        "Inverting in general subtracts nearly equal numbers. Here the subtractions can be carried out beforehand: "
        r"over $k_n$, and with $\Delta$ and $\Sigma$ as below, five components are sums of non-negative terms only.",
        (rf"\Delta = {latex(BULK)},\quad \Sigma = {latex(SHEAR)}",
         *(f"{latex(c)} = {latex(e)}" for c, e in zip(STIFFNESS, _abbreviated(), strict=True))),
        tuple(_vanishes(_explicit(e) - f) for e, f in zip(positive_stiffness(), exact, strict=True)), result=True)


ASSUMPTIONS = (
    "Every contact carries its share of the mean stress (static hypothesis): a lower estimate.",
    "Forces follow from the fabric tensor of rank two; a rank-four part of the density changes the weight only.",
    "Branch vectors are parallel to contact normals.",
    "All contacts have the same stiffness.",
)


@cache
def static_constant() -> Derivation:
    """Derive the compliance and the stiffness for k_s = k_t = lambda k_n."""
    n11, n33 = fabric_tensor()
    closed = {N11: n11, N33: n33, lam: LAM, one_minus_lam: ONE_MINUS_LAM}
    return Derivation(
        name="static_constant",
        title="Stiffness with constant contact stiffness, static hypothesis",
        sources=("(2)", "(23)", "(24)", "Figure 1(b)"),
        assumptions=(*ASSUMPTIONS, EQUAL_TANGENTS),
        domain=("E nowhere negative", "-1 < Dr33 < 2; the emitted series: 1/9 <= w1/w0 <= 9", "0 <= nu <= 1/2"),
        inputs=(D33, D3333, Dr33, nu),
        outputs=(*(Output(c, e.xreplace(closed)) for c, e in zip(STIFFNESS, positive_stiffness(), strict=True)),
                 *(Output(c, e.xreplace(closed)) for c, e in zip(COMPLIANCE, positive_compliance(), strict=True))),
        steps=(*_compliance_steps(), _inverse_step(), *moment_steps(),
               *batch_static.steps(tuple(c.xreplace(closed) for c in positive_stiffness()))),
        functions=(moment_function(), stiffness_function(), compliance_function()),
        batch=batch_static.batch(),
    )


@cache
def static_three() -> Derivation:
    """Derive the compliance for k_n, k_s, k_t distinct, and its inverse."""
    n11, n33 = fabric_tensor()
    return Derivation(
        name="static_three",
        title="Stiffness with three contact stiffnesses, static hypothesis",
        sources=("(2)", "(23)", "(24)", "Figure 1(b)"),
        assumptions=(*ASSUMPTIONS, DISTINCT_TANGENTS),
        domain=("p0, p1, p2 from static_constant.static_moments", "-1 <= D33 <= 2", "kn, ks, kt > 0"),
        inputs=(p0, p1, p2, D33, kn, ks, kt),
        outputs=tuple(Output(c, e.xreplace({N11: n11, N33: n33}))
                      for c, e in zip(COMPLIANCE, components(), strict=True)),
        steps=_compliance_steps()[:3],
        functions=three_functions(),
    )
