"""A fabric without an axis: emitted arithmetic against averages over the sphere, covariance, traces, axial limit."""

from __future__ import annotations

from fractions import Fraction
from itertools import combinations_with_replacement
from random import Random

import pytest
import sympy as sp

from derivations.general_constant import (
    INDICES,
    MOMENT,
    axial_substitution,
    closed_tensor_moments,
    component,
    general_constant,
    powers_of,
)
from derivations.harmonics import PRODUCT, N, harmonic, harmonic_part, laplacian, of_direction, product_parts
from derivations.kinematic import LAM, kinematic_constant
from derivations.sphere import sphere_mean
from derivations.symbols import (
    BRANCHES_2,
    D33,
    D3333,
    FOURS,
    NORMALS_2,
    NORMALS_4,
    PAIRS,
    STIFFNESS,
    TENSOR_MOMENTS,
    TWENTY_ONE,
    Dr33,
    lam,
    nu,
    one_minus_lam,
)
from granular.generated import general_constant as emitted

SYMBOLS = (*NORMALS_2, *NORMALS_4, *BRANCHES_2)
ROTATION = sp.Matrix([[2, -1, 2], [2, 2, -1], [-1, 2, 2]]) / 3
"""A rational rotation, so that covariance is exact."""


def numbers(seed: int) -> list[Fraction]:
    """Any symmetric tensors; positivity is no matter for an identity, and neither are traces."""
    draw = Random(seed)
    return [Fraction(draw.randint(-9, 9), draw.randint(2, 9)) for _ in SYMBOLS]


def tensor(values: list[Fraction], indices: tuple[tuple[int, ...], ...]) -> dict[tuple[int, ...], Fraction]:
    """Components by sorted indices."""
    return {tuple(sorted(index)): value for index, value in zip(indices, values, strict=True)}


def turned(values: list[Fraction]) -> list[Fraction]:
    """The three tensors in axes turned by the rational rotation, through their forms."""
    found: list[Fraction] = []
    for part, indices in ((values[:6], PAIRS), (values[6:21], FOURS), (values[21:], PAIRS)):
        rank = len(indices[0])
        old = tensor(part, indices)
        for new in indices:
            total = sp.Integer(0)
            for place in range(3**rank):
                index = tuple(place // 3**k % 3 for k in range(rank))
                factor = sp.prod(ROTATION[n - 1, o] for n, o in zip(new, index, strict=True))
                total += factor * sp.Rational(old[tuple(sorted(o + 1 for o in index))])
            found.append(Fraction(int(total.p), int(total.q)))
    return found


def full(values: tuple[Fraction, ...]) -> dict[tuple[int, ...], Fraction]:
    """All 81 components of a stiffness."""
    table = {}
    for (i, j, k, m), value in zip(INDICES, values, strict=True):
        for a, b in ((i, j), (j, i)):
            for c, d in ((k, m), (m, k)):
                table[a, b, c, d] = table[c, d, a, b] = value
    return table


@pytest.mark.parametrize("seed", [1, 2])
def test_emitted_moments_are_averages_over_the_sphere(seed: int) -> None:
    """A wrong multiplicity or a lost cross term: the weight is built from n directly and averaged by SymPy."""
    values = numbers(seed)
    second, fourth, branch = (tensor(part, indices) for part, indices in (
        (values[:6], PAIRS), (values[6:21], FOURS), (values[21:], PAIRS)))
    density = sp.Integer(1) + sum(sp.Rational(second[tuple(sorted((i, j)))]) * N[i - 1] * N[j - 1]
                                  for i in (1, 2, 3) for j in (1, 2, 3))
    density += sum(sp.Rational(fourth[tuple(sorted((i, j, k, m)))]) * N[i - 1] * N[j - 1] * N[k - 1] * N[m - 1]
                   for i in (1, 2, 3) for j in (1, 2, 3) for k in (1, 2, 3) for m in (1, 2, 3))
    length = 1 + sum(sp.Rational(branch[tuple(sorted((i, j)))]) * N[i - 1] * N[j - 1]
                     for i in (1, 2, 3) for j in (1, 2, 3))
    weight = sp.Poly(density, *N) * sp.Poly(length, *N) ** 2
    found = emitted.tensor_moments(*values)
    for four, value in zip(FOURS, found, strict=True):
        a, b, c = powers_of(four)
        expected = sphere_mean((weight * sp.Poly(N[0]**a * N[1]**b * N[2]**c, *N)).as_expr(), N)
        assert sp.Rational(value.numerator, value.denominator) == expected


@pytest.mark.parametrize("seed", [3, 4])
def test_turned_fabric_gives_the_turned_stiffness(seed: int) -> None:
    """Exact in fractions: a component with the indices of another one breaks covariance."""
    values, ratio = numbers(seed), Fraction(21, 100)
    before, after = (full(emitted.general_constant(*fabric, ratio)) for fabric in (values, turned(values)))
    for i, j, k, m in ((1, 1, 1, 1), (1, 1, 2, 3), (2, 3, 1, 2), (1, 3, 1, 3), (2, 2, 3, 3)):
        expected = sum(ROTATION[i - 1, a - 1] * ROTATION[j - 1, b - 1] * ROTATION[k - 1, c - 1]
                       * ROTATION[m - 1, d - 1] * sp.Rational(value) for (a, b, c, d), value in before.items())
        assert sp.Rational(after[i, j, k, m]) == expected


def test_functions_are_the_outputs() -> None:
    """The emitted arithmetic put together is what the derivation states."""
    record = general_constant()
    moments, stiffness = record.functions
    assert moments.returns == TENSOR_MOMENTS
    for output, expression in zip(record.outputs, stiffness.substituted().values(), strict=True):
        assert sp.cancel(output.expression - expression) == 0


def test_axial_limit() -> None:
    """All tensors about axis 3: the six components of the axial closed form, and zeros elsewhere."""
    closed = closed_tensor_moments(axial_substitution())
    axial = {str(output.symbol): output.expression for output in kinematic_constant().outputs}
    at = {D33: sp.Rational(3, 10), D3333: sp.Rational(1, 7), Dr33: sp.Rational(-2, 5), nu: sp.Rational(1, 5)}
    six = {str(c) for c in STIFFNESS}
    twins = {"C2222": "C1111", "C2233": "C1133", "C1313": "C2323"}
    for symbol, indices in zip(TWENTY_ONE, INDICES, strict=True):
        value = component(indices).xreplace(closed).subs({one_minus_lam: 1 - lam}).subs(lam, LAM).subs(at)
        name = twins.get(symbol.name, symbol.name)
        assert sp.simplify(value - (axial[name].subs(at) if name in six else 0)) == 0


def test_traces_do_not_know_the_shear_stiffness() -> None:
    """Compression shears nothing: C_iikk is the mean weight; C_ikik holds (1 - lam) + 2 lam of it."""
    mean = sum(MOMENT[tuple(sorted((i, i, k, k)))] for i in (1, 2, 3) for k in (1, 2, 3))
    pairs = [(i, k) for i in (1, 2, 3) for k in (1, 2, 3)]
    unit = {one_minus_lam: 1 - lam}
    assert sp.expand(sum(component((i, i, k, k)) for i, k in pairs).subs(unit) - mean) == 0
    assert sp.expand(sum(component((i, k, i, k)) for i, k in pairs).subs(unit) - (1 + lam) * mean) == 0


@pytest.mark.parametrize("degree", [2, 3, 4, 6])
def test_harmonic_part_is_harmonic_and_idempotent(degree: int) -> None:
    """A wrong coefficient of the projection leaves a trace."""
    form = sp.Poly((N[0] + 2 * N[1] - 3 * N[2]) ** degree + N[0] ** degree, *N)
    once = harmonic(form, degree)
    assert laplacian(once).is_zero
    assert harmonic(once, degree) == once


def test_harmonic_parts_add_up_on_the_sphere() -> None:
    """A part left out, or with a wrong factor, shows at any direction of length one."""
    form = sp.Poly((N[0] + 2 * N[1] - 3 * N[2]) ** 6, *N)
    at = dict(zip(N, (sp.Rational(2, 7), sp.Rational(3, 7), sp.Rational(6, 7)), strict=True))
    total = sum(harmonic_part(form, 6, order).as_expr() for order in (0, 2, 4, 6))
    assert total.subs(at) == form.as_expr().subs(at)


@pytest.mark.parametrize("orders", PRODUCT, ids=str)
def test_product_of_tensors_in_other_planes(orders: tuple[int, int, int]) -> None:
    """The two directions of the proof lie in a plane with axis 3; here neither does."""
    from derivations.harmonics import contracted

    first, second, order = orders
    one = of_direction((sp.Integer(1), sp.Integer(2), sp.Integer(-1)), first)
    other = of_direction((sp.Integer(3), sp.Integer(-1), sp.Integer(1)), second)
    part = harmonic_part(one * other, first + second, order)
    assert part == PRODUCT[orders] * harmonic(contracted(one, other, (first + second - order) // 2), order)
    left, right = product_parts(*orders)
    assert sp.expand(left - right) == 0


def test_twenty_one_names() -> None:
    """A component missing or twice."""
    names = [symbol.name for symbol in TWENTY_ONE]
    assert len(set(names)) == 21
    assert names == [f"C{i}{j}{k}{m}" for (i, j), (k, m) in combinations_with_replacement(PAIRS, 2)]
