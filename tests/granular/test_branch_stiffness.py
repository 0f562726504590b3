"""Branches as any function of direction: what is known in closed form, and functions that no contacts can have."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.special import hyp1f1

from granular.branch_products import (
    along_normals,
    deviating,
    lognormal_lengths,
    spheroid_branches,
    spheroid_deviation,
)
from granular.branch_stiffness import stiffness_by_direction
from granular.directions import branch_weight
from granular.errors import BranchesUnusable, RouteOutOfDomain
from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.loading import Loading
from granular.routes import axial
from granular.routes.direction_sums import axial_components, mandel_matrix, symmetrised
from granular.spheroid import branch_vectors

Array = NDArray[np.float64]

NU, LAM = 0.21, 2 * (1 - 0.21) / (2 - 0.21)
EYE = np.eye(3)
COLLINEAR = np.einsum("ip,kq->pqik", EYE, EYE)
patient = settings(deadline=None, max_examples=25)  # a time limit would be a verdict on a busy machine


def by_meridian(fabric: AxialFabric, loading: Loading | None = None) -> tuple[float, ...]:
    """Six kinematic components by the rule along the meridian."""
    return axial.evaluate(fabric, poisson_ratio=NU, hypothesis=Hypothesis.KINEMATIC, loading=loading).components


@patient
@given(st.floats(-1, 2), st.floats(-0.9, 1.9))
def test_lengths_along_the_normals_are_eq_7(d33: float, dr33: float) -> None:
    """<l^2> does not multiply n_i n_k, or the contact normals do not enter."""
    fabric = AxialFabric(D33=d33, Dr33=dr33)
    found = stiffness_by_direction(along_normals(lambda n: branch_weight(fabric, n[2]) ** 2),
                                   fabric=AxialFabric(D33=d33), poisson_ratio=NU)
    # the estimate of the error is relative to the largest component; a polynomial is integrated to rounding
    assert axial_components(found.mandel) == pytest.approx(by_meridian(fabric), rel=1e-12, abs=1e-14)


def test_no_deviation_is_eq_7() -> None:
    """r_pqik = delta_ip delta_kq is another stiffness than branches along the normals, or its indices are exchanged."""
    fabric = AxialFabric(D33=0.3, D3333=0.2)
    for mean_square in (1.0, lambda n: 1 + n[2] ** 2):
        one, other = (stiffness_by_direction(products, fabric=fabric, poisson_ratio=NU).mandel
                      for products in (deviating(COLLINEAR, mean_square), along_normals(mean_square)))
        assert one == pytest.approx(other, rel=1e-14, abs=1e-15)


@pytest.mark.parametrize("free_spin", [False, True])
@pytest.mark.parametrize("shape", [0.5, 0.9, 1.0, 1.6])
def test_the_deviation_of_spheroids(shape: float, free_spin: bool) -> None:
    """The deviation tensor of eq. (5), the branch vector and the route of spheroids are three different stiffnesses."""
    fabric = AxialFabric(D33=-0.4, D3333=0.2)
    known = by_meridian(AxialFabric(D33=-0.4, D3333=0.2, aspect_ratio=shape, free_spin=free_spin))

    def square(n: Array) -> Array:
        return np.asarray(np.sum(branch_vectors(shape, n) ** 2, axis=0))

    for products in (spheroid_branches(shape), deviating(spheroid_deviation(shape), square)):
        found = stiffness_by_direction(products, fabric=fabric, poisson_ratio=NU, free_spin=free_spin, rtol=1e-11)
        assert axial_components(found.mandel) == pytest.approx(known, rel=1e-9)


def test_contact_forces_between_spheroids() -> None:
    """Contact stiffness by direction does not enter: without slip the integrand is smooth."""
    loading = Loading.of_ratio(1.5)
    found = stiffness_by_direction(spheroid_branches(0.8), fabric=AxialFabric(D33=0.3), poisson_ratio=NU,
                                   loading=loading, rtol=1e-10)
    known = by_meridian(AxialFabric(D33=0.3, aspect_ratio=0.8), loading)
    assert axial_components(found.mandel) == pytest.approx(known, rel=1e-9)


def kummer(slope: float, power: int) -> float:
    """Mean of exp(slope x^2) x^(2 power) over the sphere, by Kummer's function."""
    return float(hyp1f1(power + 0.5, power + 1.5, slope)) / (2 * power + 1)


@pytest.mark.parametrize(("form", "factor"), [("paper", 4.0), ("classical", 2.0)])
def test_lognormal_lengths_that_follow_the_direction(form: str, factor: float) -> None:
    """<l^2> of eq. (19) is another power of the spread, or median and spread do not follow the direction.

    With ln^2 s = x^2/10 and a median exp(x^2/5) the mean square is exp(slope x^2), with Kummer functions as moments.
    """
    slope = 0.4 + factor / 10
    lengths = lognormal_lengths(lambda n: np.exp(n[2] ** 2 / 5), lambda n: np.exp(abs(n[2]) / math.sqrt(10)), form=form)
    found = stiffness_by_direction(along_normals(lengths), poisson_ratio=NU, rtol=1e-11)
    m0, m1, m2 = (kummer(slope, power) for power in range(3))
    across, between = m0 - 2 * m1 + m2, m1 - m2  # <s^2>, <s x^2>
    known = (3 * (1 - LAM) * across / 8 + LAM * (m0 - m1) / 2, (1 - LAM) * m2 + LAM * m1, (1 - LAM) * across / 8,
             (1 - LAM) * between / 2, (1 - LAM) * between / 2 + LAM * (m1 + (m0 - m1) / 2) / 4,
             (1 - LAM) * across / 8 + LAM * (m0 - m1) / 4)
    assert axial_components(found.mandel) == pytest.approx(known, rel=1e-11)


def test_a_spread_of_one_is_the_dirac_delta() -> None:
    """Branches of one length in each direction are spread out."""
    n = np.array([[0.6, 0.0], [0.0, 0.8], [0.8, 0.6]])
    for form in ("paper", "classical"):
        assert lognormal_lengths(lambda n: 1 + n[2], 1.0, form=form)(n) == pytest.approx((1 + n[2]) ** 2, rel=1e-15)
        near = lognormal_lengths(2.0, 1 + 1e-9, form=form)(n)
        assert near == pytest.approx([4.0, 4.0], rel=1e-15)


def rotation(axis: int, angle: float) -> Array:
    """A turn about one axis."""
    one, other = [index for index in range(3) if index != axis]
    turn = np.eye(3)
    turn[[one, other, one, other], [one, other, other, one]] = (
        math.cos(angle), math.cos(angle), -math.sin(angle), math.sin(angle))
    return turn


@patient
@given(st.integers(0, 2), st.floats(-math.pi, math.pi), st.integers(0, 2), st.floats(-math.pi, math.pi))
def test_branches_that_are_all_turned_alike(first: int, angle: float, second: int, other: float) -> None:
    """r_pqik = R_ip R_kq is not <(R n)_i k_jl (R n)_k>, which is a polynomial in R when contacts are isotropic."""
    turn = rotation(first, angle) @ rotation(second, other)
    deviation = np.einsum("ip,kq->pqik", turn, turn)
    found = stiffness_by_direction(deviating(deviation), poisson_ratio=NU)
    raw = (1 - LAM) / 15 * (np.einsum("ij,kl->ijkl", turn, turn) + np.einsum("il,kj->ijkl", turn, turn)
                            + np.einsum("ik,jl->ijkl", EYE, EYE)) + LAM / 3 * np.einsum("ik,jl->ijkl", EYE, EYE)
    assert found.mandel == pytest.approx(mandel_matrix(symmetrised(raw)), rel=1e-12, abs=1e-13)
    assert found.mandel == pytest.approx(found.mandel.T, abs=1e-14)


def test_a_turn_of_everything_leaves_a_turned_stiffness() -> None:
    """Branches of spheroids that lie on their side are not those of upright ones with the axes renamed."""
    swap = np.array([[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]])
    upright = spheroid_branches(0.7)

    def lying(n: Array) -> Array:
        return np.einsum("ia,kb,abn->ikn", swap, swap, np.asarray(upright(swap @ n)))

    one, other = (stiffness_by_direction(products, poisson_ratio=NU, rtol=1e-11).mandel
                  for products in (upright, lying))
    order = [2, 1, 0, 5, 4, 3]
    assert other == pytest.approx(one[np.ix_(order, order)], rel=1e-10, abs=1e-12)


def test_the_stated_error_holds_and_is_asked_for() -> None:
    """A wanted accuracy is not reached, or more directions are taken than it needs."""
    known = by_meridian(AxialFabric(aspect_ratio=0.6))
    used = []
    for rtol in (1e-3, 1e-6, 1e-10):
        found = stiffness_by_direction(spheroid_branches(0.6), poisson_ratio=NU, rtol=rtol)
        apart = max(abs(value - true) for value, true in zip(axial_components(found.mandel), known, strict=True))
        assert apart / max(known) <= found.relative_error <= rtol
        used.append(found.evaluations)
    assert used == sorted(set(used))


def test_what_no_rule_reaches_is_refused() -> None:
    """A function that jumps is given with an accuracy that nothing supports."""
    with pytest.raises(RouteOutOfDomain, match="smoother"):
        stiffness_by_direction(along_normals(lambda n: np.where(abs(n[2]) > 0.3, 1.0, 2.0)), poisson_ratio=NU)
    for rtol in (1e-14, 0.5, math.nan):
        with pytest.raises(RouteOutOfDomain, match="rtol"):
            stiffness_by_direction(along_normals(), poisson_ratio=NU, rtol=rtol)


def holed(n: Array) -> Array:
    """Products that are no number at the pole."""
    return np.where(abs(n[2]) > 0.99, np.nan, 1.0) * n[:, None] * n[None, :]


@pytest.mark.parametrize(("products", "words"), [
    (lambda n: n, "shape"), (lambda n: np.ones((3, 3)), "shape"), (holed, "shape"),
    (lambda n: (2 + n[2]) * n[:, None] * n[None, :], "between n and -n"),
    (along_normals(-1.0), "mean square"), (along_normals(math.inf), "mean square"), (along_normals(math.nan), "mean"),
    (along_normals(lambda n: np.ones(3)), r"has the shape \(3,\)"),
    (along_normals(lambda n: n[2] ** 2), "mean square branch length = 0.0"),
    (along_normals(lognormal_lengths(0.0, 1.5)), "median"),
    (along_normals(lognormal_lengths(1.0, 0.9)), "spread"),
    (along_normals(lognormal_lengths(1.0, lambda n: 1 - n[0] ** 2 / 2)), "spread"),
    (deviating(2 * COLLINEAR), "r_pqii n_p n_q"),
    (deviating(lambda n: COLLINEAR), "deviation with the shape"),
    (deviating(lambda n: math.nan * np.ones((3, 3, 3, 3, n.shape[1]))), "deviation with the shape"),
    (deviating(COLLINEAR + np.einsum("p,qik->pqik", EYE[2], np.array(
        [[[float((q, i, k) == (2, 0, 1)) for k in range(3)] for i in range(3)] for q in range(3)]))),
     "not symmetric"),
])
def test_functions_that_no_contacts_can_have(products: Callable[[Array], Any], words: str) -> None:
    """Branches that depend on the side from which a contact is seen, that have no length, or no number, are taken."""
    with pytest.raises(BranchesUnusable, match=words):
        stiffness_by_direction(products, poisson_ratio=NU)


@pytest.mark.parametrize("deviation", [np.eye(3), np.ones((3, 3, 3)), np.full((3, 3, 3, 3), math.inf)])
def test_a_tensor_of_another_shape(deviation: Array) -> None:
    """A wrong tensor is refused only when it is first used."""
    with pytest.raises(BranchesUnusable, match="indices in this order"):
        deviating(deviation)


def test_a_form_that_does_not_exist() -> None:
    """A misspelt form of the lognormal density is taken for another."""
    with pytest.raises(BranchesUnusable, match="paper and classical"):
        lognormal_lengths(1.0, 1.5, form="printed")
