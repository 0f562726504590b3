"""Components from separate moments of both contact stiffnesses: against the special case, against a tensor inverse."""

from __future__ import annotations

from fractions import Fraction

import pytest
import sympy as sp

from derivations import kinematic, static
from derivations.kinetic_components import compliance, components, functions, positive_compliance, positive_stiffness
from derivations.symbols import (
    D33,
    N11,
    N33,
    NORMAL_FLEXIBILITIES,
    POSITIVE_MOMENTS,
    STIFFNESS,
    TANGENTIAL_FLEXIBILITIES,
    TANGENTIAL_MOMENTS,
    d0,
    d1,
    g0,
    g1,
    lam,
    one_minus_lam,
)

TENSORS = {N11: sp.Rational(1, 3) - D33 / 15, N33: sp.Rational(1, 3) + 2 * D33 / 15}


def constant(moments: tuple[sp.Symbol, ...], factor: sp.Expr) -> dict[sp.Symbol, sp.Expr]:
    """Moments of one contact stiffness that is the same in all directions."""
    return {own: factor * p for own, p in zip(moments, POSITIVE_MOMENTS, strict=True)}


def test_constant_stiffness_is_a_special_case() -> None:
    """A moment of the wrong stiffness in one place would not reduce to the components with k_r = lambda k_n."""
    p0, p1, _ = POSITIVE_MOMENTS
    special = {**constant(TANGENTIAL_MOMENTS, lam), d0: one_minus_lam * p0, d1: one_minus_lam * p1}
    emitted = functions()[0].substituted()
    for symbol, expected in zip(STIFFNESS, kinematic.positive_components(), strict=True):
        assert sp.expand(emitted[symbol].xreplace(special) - expected) == 0
    soft = {**constant(NORMAL_FLEXIBILITIES, sp.Integer(1)), **constant(TANGENTIAL_FLEXIBILITIES, 1 / lam),
            g0: one_minus_lam * p0 / lam, g1: one_minus_lam * p1 / lam}
    for found, expected in zip((*positive_compliance(), *positive_stiffness()),
                               (*static.positive_compliance(), *static.positive_stiffness()), strict=True):
        assert sp.cancel(sp.together((found.xreplace(soft) - expected).subs(one_minus_lam, 1 - lam))) == 0


@pytest.mark.parametrize(("number", "expected"), [(0, components), (1, compliance), (2, compliance)])
def test_emitted_arithmetic_is_the_derived_tensor(number: int, expected: object) -> None:
    """The ordered assignments put back together must be what the average over the azimuth gives, or its inverse."""
    assert callable(expected)
    function = functions()[number]
    apart = dict(zip((d0, d1, g0, g1),
                     (a - b for own, other in ((POSITIVE_MOMENTS, TANGENTIAL_MOMENTS),
                                               (TANGENTIAL_FLEXIBILITIES, NORMAL_FLEXIBILITIES))
                      for a, b in zip(own[:2], other[:2], strict=True)), strict=True))
    derived = static.inverse(expected()) if number == 2 else expected()
    for found, wanted in zip(function.substituted().values(), derived, strict=True):
        assert sp.cancel(sp.together(found.xreplace(apart) - wanted.subs(TENSORS))) == 0


def test_fractions_stay_exact() -> None:
    """A root or a float in the emitted scalar code would turn exact moments into rounded components."""
    from derivations.emit.scalar import scalar_module
    from derivations.kinetic_components import kinetic_components

    namespace: dict[str, object] = {}
    exec(compile(scalar_module(kinetic_components()), "kinetic_components", "exec"), namespace)
    for function in functions():
        run = namespace[function.name]
        assert callable(run)
        found = run(*(Fraction(k + 3, 7) for k in range(len(function.arguments))))
        assert all(type(value) is Fraction for value in found)
