"""Contact forces: what the static hypothesis promises, held against averages and limits that share no formula."""

from __future__ import annotations

import pytest
import sympy as sp

from derivations import contact_law, forces, forces_rank_four
from derivations.fabric import DENSITY
from derivations.sphere import sphere_mean
from derivations.symbols import D33, D3333, SR, mu, p0, p1, p2, s, x

FABRICS = [sp.Integer(-1), sp.Rational(3, 10), sp.Integer(2)]


def test_fabric_tensor_without_symmetry() -> None:
    """A fabric turned out of its axes gives the same tensor turned: 1/3 + 2/15 in every component."""
    fabric = forces.general_fabric_tensor()
    assert fabric == (sp.eye(3) / 3 + sp.Rational(2, 15) * forces.deviator()).applyfunc(sp.expand)
    assert len(forces.rank_four_part().free_symbols - set(forces.N)) == 9


def test_printed_fabric_tensor_fails() -> None:
    """Were the printed factors right, the printed tensor would have the trace one."""
    printed = 2 * sp.eye(3) / 15 + forces.deviator() / 3
    assert printed.trace() == sp.Rational(2, 5)
    assert forces.general_fabric_tensor().trace() == 1


@pytest.mark.parametrize("fabric", FABRICS)
def test_axial_forces_return_the_stress(fabric: sp.Rational) -> None:
    """Forces that do not balance the stress break this: averages of n f over the sphere, D3333 included."""
    n = forces.N
    density = DENSITY.subs({D33: fabric, D3333: sp.Rational(1, 5)}).subs(x, n[2])
    equator, pole = (e.subs({D33: fabric, SR: sp.Rational(3, 2)}) for e in (
        forces.EQUATOR_OF_RATIO, forces.POLE_OF_RATIO))
    mean = [3 * sphere_mean(n[i] * (pole if i == 2 else equator) * n[i] * density, n) for i in range(3)]
    assert mean == [sp.Rational(6, 7), sp.Rational(6, 7), sp.Rational(9, 7)]


@pytest.mark.parametrize("fabric", FABRICS)
@pytest.mark.parametrize("ratio", [sp.Rational(1, 2), sp.Integer(1), sp.Integer(3)])
def test_difference_without_cancellation(fabric: sp.Rational, ratio: sp.Rational) -> None:
    """A sign in the cancelled numerator breaks this; D33 = -1 with 1/2 and D33 = 2 with 3 carry no shear at all."""
    at = {D33: fabric, SR: ratio}
    difference = forces.DIFFERENCE.subs(at)
    assert difference == (forces.POLE_OF_RATIO - forces.EQUATOR_OF_RATIO).subs(at)
    assert (difference == 0) == ((fabric, ratio) in {(-1, sp.Rational(1, 2)), (2, sp.Integer(3))})


def test_rank_four_balances() -> None:
    """A wrong multiplicity in the contraction breaks the constraint: averaged over the sphere, no index counted."""
    n = forces.N
    means = {p: e.subs({D33: sp.Rational(4, 5), D3333: sp.Rational(-1, 5)})
             for p, e in forces_rank_four.closed_means().items()}
    density = DENSITY.subs({D33: sp.Rational(4, 5), D3333: sp.Rational(-1, 5)}).subs(x, n[2])
    on_sphere = {s: n[0] ** 2 + n[1] ** 2, x: n[2]}
    along = (n[2] * forces_rank_four.AXIAL_3.subs(means)).subs(on_sphere)
    across = (n[0] * forces_rank_four.AXIAL_1.subs(means)).subs(on_sphere)
    assert sphere_mean(sp.expand(n[2] * along * density), n) == 1
    assert sphere_mean(sp.expand(n[0] * across * density), n) == 1


def test_rank_four_has_the_least_norm() -> None:
    """A solution that is not the least is beaten by the rank-two one, written as a cubic: A_pk n_k (n_i n_i)."""
    fabric = sp.Rational(3, 2)
    means = {p: e.subs({D33: fabric, D3333: 0}) for p, e in forces_rank_four.closed_means().items()}
    weights = forces_rank_four.MULTIPLICITY
    least = forces_rank_four.least_norm().subs(means)
    n = forces.N
    pole = (1 / (sp.Rational(1, 3) + 2 * fabric / 15)) * n[2] * (n[0] ** 2 + n[1] ** 2 + n[2] ** 2)
    as_poly = sp.Poly(pole, *n)
    row = sp.Matrix([[as_poly.coeff_monomial(sp.prod(v**k for v, k in zip(n, powers, strict=True)))
                      for powers in forces_rank_four.CUBIC]]) * weights.inv()
    contraction = row * weights * forces_rank_four.fabric_tensor_4().subs(means).T
    assert contraction == sp.Matrix([[0, 0, 1]])
    assert (row * weights * row.T)[0] > (least[2, :] * weights * least[2, :].T)[0]


def test_ranks_agree_only_without_anisotropy() -> None:
    """For an isotropic fabric the two estimates coincide; for any other they must not, or rank four would be idle."""
    isotropic = {p0: sp.Rational(8, 15), p1: sp.Rational(2, 15), p2: sp.Rational(1, 5)}
    assert sp.expand(forces_rank_four.AXIAL_3.subs(isotropic).subs(s, 1 - x**2)) == 3
    other = {p: e.subs({D33: sp.Rational(1, 2), D3333: 0}) for p, e in forces_rank_four.closed_means().items()}
    assert sp.diff(forces_rank_four.AXIAL_3.subs(other).subs(s, 1 - x**2), x) != 0


def test_shear_stiffness_falls_from_full_to_none() -> None:
    """The printed form rises from none to full, the right one falls; at half the friction it is (1/2)^(1/3)."""
    half = contact_law.shear_share(mu / 2, sp.Integer(1))
    assert half == sp.Integer(2) ** sp.Rational(-1, 3)
    assert contact_law.shear_share(sp.Integer(0), sp.Integer(1)) == 1
    assert contact_law.printed_shear_share(sp.Integer(0), sp.Integer(1)) == 0


def test_printed_factor_of_hertz() -> None:
    """1.4423 must be the cube root of three to the digits printed, within one unit of the last."""
    assert abs(sp.cbrt(3) - sp.Rational(14423, 10000)) < sp.Rational(1, 10000)
