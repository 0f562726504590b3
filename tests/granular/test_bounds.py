"""What every stiffness of the model must satisfy, whatever the fabric: symmetry, positivity, order of the bounds."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt
import pytest
from hypothesis import assume, example, given
from hypothesis import strategies as st

from granular.elasticity import Stiffness
from granular.errors import FabricOutOfRange
from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.routes import axial, closed_form

DR_LOWEST, DR_HIGHEST = math.nextafter(-1.0, 0.0), math.nextafter(2.0, 0.0)

d33 = st.one_of(st.floats(-1, 2), st.sampled_from([-1.0, 2.0, 0.0, 1e-300, -1e-16]))
dr33 = st.one_of(st.floats(-1, 2, exclude_min=True, exclude_max=True),
                 st.sampled_from([DR_LOWEST, DR_HIGHEST, 0.0, 1e-16]))
# Below 1e-200 a lateral component may be smaller than the smallest normal double, and is then refused.
poisson = st.one_of(st.floats(1e-200, 0.5), st.sampled_from([0.0, 0.5]))


@st.composite
def rank_four(draw: st.DrawFn) -> AxialFabric:
    """Draw a density that is a non-negative quadratic form in s and x^2, its zeros inside included."""
    equator, pole = draw(st.floats(0, 3)), draw(st.floats(0, 3))
    weight = draw(st.floats(-1, 1))
    middle = 2 * weight * math.sqrt(equator * pole) if weight < 0 else 4 * weight
    mean = 8 * equator / 15 + 2 * middle / 15 + pole / 5
    assume(mean > 1e-3)
    e0, e2 = equator / mean, pole / mean
    # Solve e0 = 1 - D/2 + 3Q/8 and e2 = 1 + D + Q.
    q = (e2 - 1 + 2 * (e0 - 1)) * 4 / 7
    try:
        return AxialFabric(D33=e2 - 1 - q, D3333=q, Dr33=draw(st.floats(-0.9, 1.5)))
    except FabricOutOfRange:  # rounding has moved a double zero below the axis
        assume(False)
        raise


def both(fabric: AxialFabric, nu: float) -> tuple[Stiffness, Stiffness]:
    """Kinematic and static stiffness, normalised."""
    kinematic = closed_form.evaluate(fabric, poisson_ratio=nu, hypothesis=Hypothesis.KINEMATIC)
    route = closed_form if closed_form.covers(fabric, Hypothesis.STATIC) else axial
    static = route.evaluate(fabric, poisson_ratio=nu, hypothesis=Hypothesis.STATIC)
    return (Stiffness.transversely_isotropic(*kinematic.components),
            Stiffness.transversely_isotropic(*static.components))


def require_order(fabric: AxialFabric, nu: float) -> None:
    """Both positive definite, and their difference positive semidefinite."""
    kinematic, static = both(fabric, nu)
    assert kinematic.is_positive_definite()
    assert static.is_positive_definite()
    upper, lower = kinematic.mandel(), static.mandel()
    # Compare in the frame in which the upper bound is the identity: lower must have eigenvalues <= 1 there.
    root = np.linalg.inv(np.linalg.cholesky(upper))
    largest = float(np.linalg.eigvalsh(root @ lower @ root.T)[-1])
    condition = float(np.linalg.cond(upper))
    # Both are equal when nu = 0 and the weight is uniform; rounding then decides, amplified by the condition number.
    assert largest <= 1 + 1e-15 * (30 + condition)


@given(D33=d33, Dr33=dr33, nu=poisson)
@example(D33=0.0, Dr33=0.0, nu=0.0)
@example(D33=2.0, Dr33=DR_HIGHEST, nu=0.5)
@example(D33=-1.0, Dr33=DR_LOWEST, nu=0.0)
@example(D33=-1.0, Dr33=DR_HIGHEST, nu=0.5)
def test_order_of_the_bounds(D33: float, Dr33: float, nu: float) -> None:
    """Cauchy-Schwarz orders the two estimates; a wrong weight in either breaks it."""
    require_order(AxialFabric(D33=D33, Dr33=Dr33), nu)


@given(fabric=rank_four(), nu=poisson)
def test_order_of_the_bounds_with_rank_four(fabric: AxialFabric, nu: float) -> None:
    """The same for densities of rank four up to those that vanish on a cone."""
    require_order(fabric, nu)


@given(D33=d33, Dr33=dr33, nu=poisson, angle=st.floats(0, 2 * math.pi))
def test_turning_about_the_axis_changes_nothing(D33: float, Dr33: float, nu: float, angle: float) -> None:
    """A C1212 that does not fit C1111 and C1122 would change when the assembly is turned."""
    cosine, sine = math.cos(angle), math.sin(angle)
    turn = np.array([[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]])
    for stiffness in both(AxialFabric(D33=D33, Dr33=Dr33), nu):
        before, after = stiffness.mandel(), stiffness.rotated(turn).mandel()
        assert np.abs(after - before).max() <= 1e-14 * np.abs(before).max()  # a rotation is some fifty roundings


@given(D33=d33, Dr33=dr33, nu=poisson)
def test_symmetry_of_the_tensor(D33: float, Dr33: float, nu: float) -> None:
    """Major and minor symmetry of the full tensor."""
    for stiffness in both(AxialFabric(D33=D33, Dr33=Dr33), nu):
        tensor: npt.NDArray[np.float64] = stiffness.tensor()
        for order in ((2, 3, 0, 1), (1, 0, 2, 3), (0, 1, 3, 2)):
            assert np.array_equal(tensor, tensor.transpose(order))


@pytest.mark.parametrize("nu", [0.0, 0.21, 0.5])
def test_isotropic_assembly(nu: float) -> None:
    """K is the same by both hypotheses; G lies between, (2 + 3 lambda)/30 and 5 lambda/(6 (3 + 2 lambda))."""
    lam = 2 * (1 - nu) / (2 - nu)
    kinematic, static = both(AxialFabric(), nu)
    for stiffness, shear in ((kinematic, (2 + 3 * lam) / 30), (static, 5 * lam / (6 * (3 + 2 * lam)))):
        assert stiffness.C2323 == pytest.approx(shear, rel=4e-15)  # the formulas here are rounded six times
        assert stiffness.C1111 + 2 * stiffness.C1122 == pytest.approx(1 / 3, rel=4e-15)
