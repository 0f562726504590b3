"""Identities and limits of the closed forms, proved symbolically from the emitted arithmetic."""

from __future__ import annotations

from collections.abc import Callable

import pytest
import sympy as sp

from derivations.engineering import engineering_function, isotropic_values
from derivations.kinematic import closed_moments, kinematic_constant, kinematic_three, positive_components
from derivations.record import Derivation, Function
from derivations.static import positive_compliance, static_constant, static_three
from derivations.static_moments import elementary, elementary_integral, ratio, series
from derivations.symbols import (
    C1111,
    C1122,
    C1133,
    C1212,
    C2323,
    C3333,
    D33,
    D3333,
    N11,
    N33,
    POSITIVE_MOMENTS,
    STIFFNESS,
    Dr33,
    kn,
    kr,
    ks,
    kt,
    lam,
    nu,
    one_minus_lam,
    p0,
    p1,
    p2,
    v,
)

L = sp.Symbol("l")

# Coefficients of D + 2 Dr, 2 D Dr + Dr^2 and D Dr^2, and the isotropic value, for each component over k_n.
EXPANSION = {
    C3333: ((2 * L + 3) / 15, 2 * (L + 6) / 105, (2 * L + 9) / 105, 2 * (5 * L + 39) / 1155),
    C1111: ((2 * L + 3) / 15, -(L + 6) / 105, (2 * L + 3) / 105, (L - 12) / 1155),
    C1133: ((1 - L) / 15, (1 - L) / 105, (1 - L) / 105, (1 - L) / 231),
    C1122: ((1 - L) / 15, -2 * (1 - L) / 105, (1 - L) / 105, -4 * (1 - L) / 1155),
    C2323: ((3 * L + 2) / 30, (3 * L + 4) / 420, (3 * L + 1) / 105, (57 * L + 20) / 4620),
    C1212: ((3 * L + 2) / 30, -(3 * L + 4) / 210, (3 * L + 2) / 210, -(3 * L + 8) / 2310),
}


def composed(derivation: Derivation, last: int = 2) -> dict[sp.Symbol, sp.Expr]:
    """Put the emitted functions of a derivation back together."""
    known: dict[sp.Symbol, sp.Expr] = {}
    for function in derivation.functions[:last]:
        known = {symbol: expression.xreplace(known) for symbol, expression in function.substituted().items()}
    return known


def explicit(expression: sp.Expr) -> sp.Expr:
    """Insert lambda for Poisson's ratio: nu = 2 (1 - l)/(2 - l)."""
    return sp.cancel(expression.subs(nu, 2 * (1 - L) / (2 - L)))


@pytest.mark.parametrize("component", STIFFNESS, ids=str)
def test_polynomial_in_the_fabric(component: sp.Symbol) -> None:
    """C = c0 + (D + 2 Dr) c1 + (2 D Dr + Dr^2) c2 + D Dr^2 c3; to first order D and Dr cannot be told apart."""
    c0, c1, c2, c3 = EXPANSION[component]
    expected = c0 + (D33 + 2 * Dr33) * c1 + (2 * D33 * Dr33 + Dr33**2) * c2 + D33 * Dr33**2 * c3
    emitted = explicit(composed(kinematic_constant())[component].subs(D3333, 0))
    assert sp.expand(emitted - expected) == 0


@pytest.mark.parametrize("build", [kinematic_constant, kinematic_three])
def test_kinematic_functions_are_the_outputs(build: Callable[[], Derivation]) -> None:
    """The hand-ordered arithmetic must be the derived closed form, term by term."""
    derivation = build()
    emitted = composed(derivation)
    for output in derivation.outputs:
        assert sp.cancel(sp.together(emitted[output.symbol] - output.expression)) == 0


def _assembly(function: Function) -> dict[sp.Symbol, sp.Expr]:
    return function.substituted()


def test_static_functions_are_the_outputs() -> None:
    """The positive forms that are emitted must be the compliance and the stiffness as derived."""
    derivation = static_constant()
    emitted = _assembly(derivation.functions[1]) | _assembly(derivation.functions[2])
    for output in derivation.outputs:
        assert sp.cancel(sp.together(emitted[output.symbol] - output.expression)) == 0


def test_three_stiffnesses_reduce_to_two() -> None:
    """With k_s = k_t = lambda k_n the general stiffness and compliance must become the special ones."""
    equal = {kn: 1, ks: L, kt: L}
    kinematic = kinematic_three().functions[0].substituted()
    for symbol, expected in zip(STIFFNESS, positive_components(), strict=True):
        assert sp.expand(kinematic[symbol].subs(equal) - expected.subs({lam: L, one_minus_lam: 1 - L})) == 0
    compliance = static_three().functions[0].substituted()
    special = positive_compliance()
    tensors = {N11: sp.Rational(1, 3) - D33 / 15, N33: sp.Rational(1, 3) + 2 * D33 / 15}
    for value, expected in zip(compliance.values(), special, strict=True):
        difference = value.subs(equal) - expected.subs(tensors).subs({lam: L, one_minus_lam: 1 - L})
        assert sp.cancel(sp.together(difference)) == 0


def test_three_stiffness_inverse() -> None:
    """Stiffness from compliance must invert the tensor: stretching block times its inverse is the identity."""
    function = static_three().functions[1]
    s11, s33, s12, s13, s44, s66 = function.arguments
    c = function.substituted()
    compliance = sp.Matrix([[s11, s12, s13], [s12, s11, s13], [s13, s13, s33]])
    stiffness = sp.Matrix([[c[C1111], c[C1122], c[C1133]], [c[C1122], c[C1111], c[C1133]],
                           [c[C1133], c[C1133], c[C3333]]])
    assert (stiffness * compliance).applyfunc(lambda e: sp.cancel(sp.together(e))) == sp.eye(3)
    assert sp.simplify(4 * c[C2323] * s44) == 1
    assert sp.simplify(4 * c[C1212] * s66) == 1


def test_compression_does_not_shear() -> None:
    """C3333 + 2 C1111 + 2 C1122 + 4 C1133 is free of the tangential stiffness."""
    c = composed(kinematic_constant())
    total = explicit(c[C3333] + 2 * c[C1111] + 2 * c[C1122] + 4 * c[C1133])
    assert sp.diff(sp.expand(total), L) == 0


def test_without_tangential_stiffness() -> None:
    """Lambda = 0: central forces give the Cauchy relations C1133 = C2323 and C1122 = C1212."""
    c = {symbol: e.subs({lam: 0, one_minus_lam: 1})
         for symbol, e in zip(STIFFNESS, positive_components(), strict=True)}
    assert c[C1133] == c[C2323]
    assert c[C1122] == c[C1212]


def test_zero_poisson_ratio() -> None:
    """Nu = 0: k_r = k_n, and the lateral components vanish identically, not just to rounding."""
    for derivation in (kinematic_constant(), static_constant()):
        c = derivation.functions[1].substituted()
        assert c[C1122].subs(nu, 0) == 0
        assert c[C1133].subs(nu, 0) == 0


def test_transverse_isotropy() -> None:
    """C1212 = (C1111 - C1122)/2, by the symmetry about axis 3, for both hypotheses."""
    for derivation in (kinematic_constant(), static_constant()):
        c = derivation.functions[1].substituted()
        assert sp.cancel(sp.together(c[C1212] - (c[C1111] - c[C1122]) / 2)) == 0


def test_isotropic_limits() -> None:
    """Voigt and Reuss: K = a kn/9 both; G = a (2 kn + 3 kr)/30 and (5a/6) kn kr/(3 kn + 2 kr)."""
    bulk, shear = isotropic_values()["kinematic"]
    assert sp.expand(bulk - kn / 9) == 0
    assert sp.expand(shear - (2 * kn + 3 * kr) / 30) == 0
    bulk, shear = isotropic_values()["static"]
    assert sp.cancel(bulk - kn / 9) == 0
    assert sp.cancel(shear - sp.Rational(5, 6) * kn * kr / (3 * kn + 2 * kr)) == 0


def test_engineering_constants_of_an_isotropic_solid() -> None:
    """With isotropic components every pair of constants must coincide and obey E = 9KG/(3K + G)."""
    bulk, shear = sp.symbols("K G", positive=True)
    isotropic = {C1111: bulk + 4 * shear / 3, C3333: bulk + 4 * shear / 3, C1122: bulk - 2 * shear / 3,
                 C1133: bulk - 2 * shear / 3, C2323: shear, C1212: shear}
    values = [sp.factor(e.xreplace(isotropic)) for e in engineering_function().substituted().values()]
    young, poisson = 9 * bulk * shear / (3 * bulk + shear), (3 * bulk - 2 * shear) / (6 * bulk + 2 * shear)
    expected = (young, young, poisson, poisson, poisson, shear, shear, bulk)
    assert all(sp.cancel(a - b) == 0 for a, b in zip(values, expected, strict=True))


@pytest.mark.parametrize("k", range(5))
def test_series_against_the_elementary_form(k: int) -> None:
    """Series and arc tangent are two ways to one integral; they must agree to 17 digits where both are good."""
    table = series(k)
    factors = ((1 - v) ** 3, (1 - v) ** 2, 1, 1 + v, (1 + v) ** 2)
    for contrast in (sp.Rational(-1, 2), sp.Rational(-1, 3), sp.Rational(1, 7), sp.Rational(1, 2)):
        rho = ((1 + contrast) / (1 - contrast)) ** 2
        arc = sp.atan(sp.sqrt(rho - 1)) / sp.sqrt(rho - 1) if rho > 1 else sp.atanh(sp.sqrt(1 - rho)) / sp.sqrt(1 - rho)
        exact = sp.N(elementary_integral(k).subs({ratio: rho, elementary: arc}), 40) / (1 - contrast) ** 4
        total = sum(sp.N(c, 40) * contrast**n for n, c in enumerate(table.coefficients))
        value = total / sp.sympify(factors[k]).subs(v, contrast)
        assert abs(value / exact - 1) < sp.Rational(1, 2**56)


def test_series_bound_is_kept() -> None:
    """What the cut leaves out is computed, not guessed; a shorter table would break this."""
    assert all(series(k).left_out < sp.Rational(1, 2**57) for k in range(5))


def test_moments_of_an_isotropic_fabric() -> None:
    """Closed moments at D = Dr = 0 are 8/15, 2/15, 1/5."""
    values = [m.subs({D33: 0, D3333: 0, Dr33: 0}) for m in closed_moments()]
    assert dict(zip(POSITIVE_MOMENTS, values, strict=True)) == {
        p0: sp.Rational(8, 15), p1: sp.Rational(2, 15), p2: sp.Rational(1, 5)}
