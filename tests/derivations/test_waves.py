"""Christoffel closed forms against the matrix, and the paper's claim about the fastest shear wave."""

from __future__ import annotations

import sympy as sp

from derivations.kinematic import kinematic_constant
from derivations.symbols import (
    C1111,
    C1133,
    C1212,
    C2323,
    C3333,
    D33,
    D3333,
    Dr33,
    cos_squared,
    density,
    nu,
    sin_squared,
    v_P,
    v_SH,
    v_SV,
)
from derivations.waves import christoffel, squared_speeds, velocity_function

SAMPLE = {C1111: 7, C3333: 5, C1133: 1, C2323: 2, C1212: 3, density: 1}
THIRD = {sin_squared: sp.Rational(2, 3), cos_squared: sp.Rational(1, 3)}


def test_emitted_speeds_are_the_eigenvalues() -> None:
    """The rearranged in-plane speeds must be roots of the characteristic polynomial, at an exact angle."""
    emitted = velocity_function().substituted()
    squares = [sp.nsimplify(sp.expand(emitted[name] ** 2).subs({**SAMPLE, **THIRD}))
               for name in (v_P, v_SV, v_SH)]
    matrix = christoffel().subs({sp.Symbol("s", nonnegative=True): sp.Rational(2, 3),
                                 sp.Symbol("y", nonnegative=True): sp.Rational(1, 3)}).subs(SAMPLE)
    unknown = sp.Symbol("unknown")
    polynomial = (matrix - unknown * sp.eye(3)).det()
    assert all(sp.simplify(polynomial.subs(unknown, square)) == 0 for square in squares)
    assert sp.simplify(sum(squares) - matrix.trace()) == 0


def test_horizontal_shear_waves_of_the_table() -> None:
    """Along the horizontal the SH wave of Table II case 3 is faster than any vertical shear wave: C1212 > C2323."""
    derivation = kinematic_constant()
    case = {D33: sp.Rational(3, 10), D3333: 0, Dr33: -sp.Rational(3, 10), nu: sp.Rational(21, 100)}
    ratio = derivation.output("C2323").expression.subs(case) / derivation.output("C1212").expression.subs(case)
    assert ratio == sp.Rational(60977471, 67115858)  # 0.9085, printed .909
    assert ratio < 1


def test_the_claim_is_not_general() -> None:
    """With D33 = 0.3 and equal branch lengths C2323 > C1212: the fastest shear wave is polarised vertically."""
    derivation = kinematic_constant()
    case = {D33: sp.Rational(3, 10), D3333: 0, Dr33: 0, nu: sp.Rational(21, 100)}
    assert derivation.output("C2323").expression.subs(case) > derivation.output("C1212").expression.subs(case)


def test_squared_speeds_of_an_isotropic_solid() -> None:
    """Isotropic components give K + 4G/3 and G at every angle."""
    bulk, shear = sp.symbols("K G", positive=True)
    stretch = bulk + 4 * shear / 3
    isotropic = {C1111: stretch, C3333: stretch, C1133: bulk - 2 * shear / 3, C2323: shear, C1212: shear}
    s, y = sp.symbols("s y", nonnegative=True)
    fast, slow, horizontal = (sp.simplify(e.xreplace(isotropic).subs(s, 1 - y)) for e in squared_speeds())
    gap = sp.simplify(((fast - slow) ** 2 - (stretch - shear) ** 2).expand())
    assert gap == 0
    assert sp.simplify(fast + slow - stretch - shear) == 0
    assert sp.simplify(horizontal - shear) == 0
