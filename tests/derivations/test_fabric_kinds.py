"""Fabric tensors of three kinds, held against directions and densities that share no step with the derivation."""

from __future__ import annotations

from typing import Any

import pytest
import sympy as sp

from derivations import fabric_kinds as kinds
from derivations import forces
from derivations.emit.scalar import scalar_module
from derivations.fabric import fabric_tensor
from derivations.symbols import D33, D3333

CUBE = [(sp.Integer(1), sp.Integer(0), sp.Integer(0)), (sp.Integer(0), sp.Integer(1), sp.Integer(0)),
        (sp.Integer(0), sp.Integer(0), sp.Integer(1))]
PYTHAGOREAN = [(sp.Rational(3, 5), sp.Rational(4, 5), sp.Integer(0)),
               (sp.Rational(2, 7), sp.Rational(3, 7), sp.Rational(6, 7)),
               (sp.Rational(1, 9), sp.Rational(-4, 9), sp.Rational(8, 9))]
"""Unit vectors with rational components."""


def sums(directions: list[tuple[sp.Rational, ...]]) -> tuple[sp.Rational, ...]:
    """Moments of rank four of a few directions, by adding them up."""
    return tuple(sp.Rational(sum(sp.prod(n[axis - 1] for axis in index) for n in directions), len(directions))
                 for index in kinds.QUADRUPLES)


@pytest.fixture(scope="module")
def emitted() -> dict[str, Any]:
    """The emitted functions, run on exact numbers."""
    namespace: dict[str, Any] = {}
    exec(compile(scalar_module(kinds.fabric_kinds()), "fabric_kinds", "exec"), namespace)
    return namespace


def test_rank_four_is_the_harmonic_quartic() -> None:
    """A trace condition that is wrong or missing breaks this: the Laplacian of the form must vanish, by calculus."""
    fourth = kinds.form(kinds.general_third()[1], kinds.QUADRUPLES)
    assert sp.expand(sum(sp.diff(fourth, n, 2) for n in kinds.N)) == 0
    assert len(fourth.free_symbols - set(kinds.N)) == len(forces.rank_four_part().free_symbols - set(forces.N)) == 9


def test_axial_case_agrees_with_the_axial_derivation() -> None:
    """Were 2/15 or the third kind's components off, N11 and N33 of the axial record would differ."""
    second, _ = kinds.axial_third()
    first = kinds.first_kind_2(second)
    assert tuple(sp.expand(first(i, i) - n) for i, n in zip((1, 3), fabric_tensor(), strict=True)) == (0, 0)


def test_mutually_perpendicular_directions(emitted: dict[str, Any]) -> None:
    """Contacts along three axes have no part of rank two; that of rank four is 105/8 (x^4 + y^4 + z^4 - 3/5)."""
    third = dict(zip((*kinds.PAIRS, *kinds.QUADRUPLES), emitted["third_kind"](*sums(CUBE)), strict=True))
    assert all(third[pair] == 0 for pair in kinds.PAIRS)
    form = kinds.form(kinds.looked_up({i: third[i] for i in kinds.QUADRUPLES}), kinds.QUADRUPLES)
    square = sum(n**2 for n in kinds.N)
    expected = sp.Rational(105, 8) * (sum(n**4 for n in kinds.N) - sp.Rational(3, 5) * square**2)
    assert sp.expand(form - expected) == 0


def test_one_direction_is_a_legendre_series(emitted: dict[str, Any]) -> None:
    """Contacts of one direction a have the density 1 + 5 P2(a.n) + 9 P4(a.n) to rank four, whatever the axes."""
    for a in PYTHAGOREAN:
        third = dict(zip((*kinds.PAIRS, *kinds.QUADRUPLES), emitted["third_kind"](*sums([a])), strict=True))
        for n in PYTHAGOREAN:
            cosine = sum(p * q for p, q in zip(a, n, strict=True))
            at = dict(zip(kinds.N, n, strict=True))
            two = kinds.form(kinds.looked_up({i: third[i] for i in kinds.PAIRS}), kinds.PAIRS).subs(at)
            four = kinds.form(kinds.looked_up({i: third[i] for i in kinds.QUADRUPLES}), kinds.QUADRUPLES).subs(at)
            assert two == 5 * sp.legendre(2, cosine)
            assert four == 9 * sp.legendre(4, cosine)


def test_second_kind_is_the_whole_density(emitted: dict[str, Any]) -> None:
    """The form of the second kind and 1 + the forms of the third are one function on the sphere, in any direction."""
    moments = sums(PYTHAGOREAN)
    third = dict(zip((*kinds.PAIRS, *kinds.QUADRUPLES), emitted["third_kind"](*moments), strict=True))
    second = dict(zip((*kinds.PAIRS, *kinds.QUADRUPLES), emitted["second_kind"](*moments), strict=True))

    def value(table: dict[Any, Any], indices: Any, at: Any) -> sp.Expr:
        return kinds.form(kinds.looked_up({i: table[i] for i in indices}), indices).subs(at)

    for n in (*PYTHAGOREAN, *CUBE):
        at = dict(zip(kinds.N, n, strict=True))
        two = 1 + value(third, kinds.PAIRS, at)
        assert value(second, kinds.PAIRS, at) == two
        assert value(second, kinds.QUADRUPLES, at) == two + value(third, kinds.QUADRUPLES, at)


def test_there_and_back(emitted: dict[str, Any]) -> None:
    """A factor of one direction that is not the inverse of the other leaves a difference in some component."""
    moments = sums([*PYTHAGOREAN, (sp.Integer(0), sp.Rational(5, 13), sp.Rational(-12, 13))])
    *third, = emitted["third_kind"](*moments)
    given = [value for value, index in zip(third, (*kinds.PAIRS, *kinds.QUADRUPLES), strict=True) if index != (3, 3)]
    assert emitted["first_kind"](*given) == moments


def test_the_outputs_are_what_the_functions_return() -> None:
    """An assignment by hand that departs from the derived relation breaks this."""
    record = kinds.fabric_kinds()
    n2, n4 = kinds.trace(kinds.looked_up(kinds.FIRST)), kinds.looked_up(kinds.FIRST)
    expected = kinds.third_kind_4(n2, n4)
    for index in kinds.QUADRUPLES:
        assert sp.expand(record.output(kinds.THIRD[index].name).expression - expected(*index)) == 0
    back = record.functions[2].substituted()
    axial = {symbol: value(*index) for table, value, indices in (
        (kinds.THIRD_2, kinds.axial_third()[0], kinds.PAIRS), (kinds.THIRD, kinds.axial_third()[1], kinds.QUADRUPLES))
        for index, symbol in table.items() if index in indices}
    n3333 = back[kinds.FIRST[3, 3, 3, 3]].subs(axial, simultaneous=True)
    assert sp.expand(n3333 - (sp.Rational(1, 5) + 4 * D33 / 35 + 8 * D3333 / 315)) == 0
