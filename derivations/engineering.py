"""Engineering constants of a transversely isotropic solid from its stiffness, and the isotropic limits."""

from __future__ import annotations

from functools import cache

import sympy as sp

from derivations.kinematic import isotropic_moments, positive_components
from derivations.record import Claim, Derivation, Function, Output, Step
from derivations.static import positive_stiffness
from derivations.symbols import (
    C1111,
    C1122,
    C1133,
    C1212,
    C2323,
    C3333,
    E1,
    E3,
    G12,
    G23,
    N11,
    N33,
    STIFFNESS,
    K,
    kn,
    kr,
    lam,
    latex,
    nu12,
    nu13,
    nu31,
    one_minus_lam,
)

block, sum_of_in_plane = sp.symbols("block sum_of_in_plane", positive=True)
CONSTANTS = (E1, E3, nu12, nu13, nu31, G23, G12, K)


def stretching() -> sp.Matrix:
    """Stiffness of the three axial strains."""
    return sp.Matrix([[C1111, C1122, C1133], [C1122, C1111, C1133], [C1133, C1133, C3333]])


def constants() -> tuple[sp.Expr, ...]:
    """The eight constants by inverting the stretching block."""
    compliance = stretching().inv().applyfunc(sp.factor)
    axial, vertical = compliance[0, 0], compliance[2, 2]
    pressure = sp.factor(sum(compliance))
    return tuple(sp.factor(c) for c in (
        1 / axial, 1 / vertical, -compliance[1, 0] / axial, -compliance[2, 0] / axial, -compliance[0, 2] / vertical,
        C2323, C1212, 1 / pressure))


def engineering_function() -> Function:
    """Emit the constants from one determinant."""
    in_plane = sum_of_in_plane
    return Function(
        "engineering_constants", "Young's moduli, Poisson's ratios, shear moduli and bulk modulus.", STIFFNESS,
        ((in_plane, C1111 + C1122),
         (block, in_plane * C3333 - 2 * C1133 * C1133),
         (E3, block / in_plane),
         (E1, (C1111 - C1122) * block / (C1111 * C3333 - C1133 * C1133)),
         (nu12, (C1122 * C3333 - C1133 * C1133) / (C1111 * C3333 - C1133 * C1133)),
         (nu13, C1133 * (C1111 - C1122) / (C1111 * C3333 - C1133 * C1133)),
         (nu31, C1133 / in_plane),
         (G23, C2323), (G12, C1212),
         (K, block / (in_plane + 2 * C3333 - 4 * C1133))),
        CONSTANTS,
        notes="nu13 is the contraction along axis 3 under a pull along axis 1; nu31 the other way round.")


def isotropic_values() -> dict[str, tuple[sp.Expr, sp.Expr]]:
    """Bulk and shear modulus of the isotropic assembly, over a = M l_e^2/V, by both hypotheses."""
    tangents = {lam: kr / kn, one_minus_lam: 1 - kr / kn}
    moments = isotropic_moments()
    weights = {N11: sp.Rational(1, 3), N33: sp.Rational(1, 3)}
    values = {}
    for name, components in (("kinematic", positive_components()), ("static", positive_stiffness())):
        c1111, _, c1122, _, _, c1212 = (sp.factor(kn * c.xreplace(weights).subs(tangents).subs(moments))
                                        for c in components)
        values[name] = sp.factor((c1111 + 2 * c1122) / 3), c1212
    return values


def isotropic_engineering() -> dict[str, tuple[sp.Expr, sp.Expr]]:
    """Young's modulus over a and Poisson's ratio of the isotropic assembly, by both hypotheses."""
    return {name: (sp.factor(9 * bulk * shear / (3 * bulk + shear)),
                   sp.factor((3 * bulk - 2 * shear) / (2 * (3 * bulk + shear))))
            for name, (bulk, shear) in isotropic_values().items()}


def _moduli(stiffness: tuple[sp.Expr, sp.Expr], young: tuple[sp.Expr, sp.Expr]) -> tuple[str, ...]:
    """Formulas of K, G, E over a = M l_e^2/V and of Poisson's ratio."""
    names = (r"\frac{K}{a}", r"\frac{G}{a}", r"\frac{E}{a}", r"\nu_{\mathrm{assembly}}")
    return tuple(f"{name} = {latex(value)}" for name, value in zip(names, (*stiffness, *young), strict=True))


@cache
def isotropic() -> Derivation:
    """Derive K, G, E and nu of an isotropic assembly by both hypotheses."""
    values, further = isotropic_values(), isotropic_engineering()
    printed_kinematic = (kn / 9, (2 * kn + 3 * kr) / 30)
    printed_static = (kn / 9, sp.Rational(5, 6) * kn * kr / (3 * kn + 2 * kr))
    c1111, c3333, c1122, c1133, c2323, c1212 = (c.subs({lam: kr / kn, one_minus_lam: 1 - kr / kn})
                                                .subs(isotropic_moments()) for c in positive_components())
    symbols = sp.symbols("K_kinematic G_kinematic E_kinematic nu_kinematic K_static G_static E_static nu_static",
                         real=True)
    moduli = (*values["kinematic"], *further["kinematic"], *values["static"], *further["static"])
    steps = (
        Step("Kinematic hypothesis",
             "With the isotropic moments the six components satisfy the three conditions of isotropy.",
             _moduli(values["kinematic"], further["kinematic"]),
             (*(Claim(a, b) for a, b in zip(values["kinematic"], printed_kinematic, strict=True)),
              Claim(c1111, c3333), Claim(c1122, c1133), Claim(c2323, c1212)), result=True),
        Step("Static hypothesis",
             "The inverse of the static compliance gives the same bulk modulus and a smaller shear modulus.",
             _moduli(values["static"], further["static"]),
             tuple(Claim(sp.cancel(a - b), sp.Integer(0))
                   for a, b in zip(values["static"], printed_static, strict=True)), result=True),
        Step("Distance between the two",
             "The difference of the shear moduli is a square: both agree only when $k_r = k_n$.",
             (rf"\frac{{G_{{kin}} - G_{{sta}}}}{{a}} = "
              rf"{latex(sp.factor(values['kinematic'][1] - values['static'][1]))}",),
             (Claim(sp.cancel((values["kinematic"][1] - values["static"][1]) * 5 * (3 * kn + 2 * kr)
                              - (kn - kr) ** 2), sp.Integer(0)),)),
    )
    return Derivation(
        name="isotropic",
        title="Isotropic limits",
        sources=("Figure 1",),
        assumptions=("The fabric is isotropic.", "All contacts have the same stiffness."),
        domain=("k_n, k_r > 0",),
        inputs=(kn, kr),
        outputs=tuple(Output(n, e) for n, e in zip(symbols, moduli, strict=True)),
        steps=steps,
    )


@cache
def engineering() -> Derivation:
    """Derive Young's moduli, Poisson's ratios, shear moduli and the bulk modulus of a transversely isotropic solid."""
    values = constants()
    emitted = engineering_function().substituted()
    steps = (
        Step("Pull along one axis, press on all",
             "Inverting the stretching block gives the strains under a pull along axis 1 or 3 and under pressure.",
             tuple(f"{latex(n)} = {latex(e)}" for n, e in zip(CONSTANTS, values, strict=True)),
             tuple(Claim(sp.cancel(emitted[n] - e), sp.Integer(0)) for n, e in zip(CONSTANTS, values, strict=True)),
             result=True),
        Step("Symmetry of the compliance",
             "The two Poisson's ratios that couple axes 1 and 3 are not independent.",
             (r"\nu_{13}/E_1 = \nu_{31}/E_3",),
             (Claim(sp.cancel(values[3] / values[0] - values[4] / values[1]), sp.Integer(0)),)),
    )
    return Derivation(
        name="engineering",
        title="Engineering constants of a transversely isotropic solid",
        sources=(),
        assumptions=("Axis 3 is the axis of symmetry.",),
        domain=("positive definite stiffness",),
        inputs=STIFFNESS,
        outputs=tuple(Output(n, e, "Pa" if n in (E1, E3, G23, G12, K) else "-")
                      for n, e in zip(CONSTANTS, values, strict=True)),
        steps=steps,
        functions=(engineering_function(),),
    )
