"""The product rule with edges: other poles, forces that vanish somewhere, edges that barely exist, and its promise."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

from granular.elasticity import Stiffness
from granular.errors import RouteOutOfDomain
from granular.general import GeneralFabric, GeneralLoading, general_stiffness, product
from granular.general.loading import most_mobilised
from granular.general.meridians import Integrand, Meridians, directions, panels, special_angles

sys.path.insert(0, str(Path(__file__).parents[1]))
from general_fabrics import apart, general_fabric, rotation

STRESS = np.array([[1.5, 0.4, 0.1], [0.4, 1.0, 0.2], [0.1, 0.2, 0.6]])
FABRIC = GeneralFabric(np.diag([0.1, 0.2, -0.3]))


def stiffness(fabric: GeneralFabric, stress: np.ndarray, friction: float | None, rtol: float) -> np.ndarray:
    """By the product rule."""
    found = general_stiffness(fabric, poisson_ratio=0.21, hypothesis="kinematic", rtol=rtol, route="product",
                              loading=GeneralLoading(stress, friction=friction))
    assert found.relative_error <= rtol
    return found.mandel()


CASES = {
    "slides in islands": (general_fabric(1), STRESS, 0.25),
    "slides nearly everywhere": (general_fabric(2), STRESS, 0.01),
    "sticks": (general_fabric(3), STRESS, 0.9),
    "one tension": (FABRIC, np.diag([1.0, 1.5, -0.2]) + 0.1 * (1 - np.eye(3)), 0.4),
    "two tensions": (FABRIC, np.array([[2, 0.2, 0], [0.2, -0.5, 0], [0, 0, -0.3]]), None),
    "nearly axial": (GeneralFabric(), np.diag([1, 1 + 1e-5, 1.6]), 0.15),
    "no stress along one axis": (FABRIC, np.diag([1.0, 1.5, 0.0]), 0.3),
}


@pytest.mark.parametrize("name", CASES)
def test_another_pole_gives_the_same(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Meridians from another corner meet other edges in other places; what they leave out would differ."""
    fabric, stress, friction = CASES[name]
    usual = stiffness(fabric, stress, friction, 1e-8)
    corners = product.corners

    def other(integrand: Integrand) -> tuple[np.ndarray, int]:
        return corners(integrand)[0], 1

    monkeypatch.setattr(product, "corners", other)
    assert apart(usual, stiffness(fabric, stress, friction, 1e-8)) < 1e-9


@pytest.mark.parametrize("rtol", [1e-3, 1e-6])
@pytest.mark.parametrize("name", ["slides in islands", "one tension"])
def test_the_estimate_is_above_the_error(name: str, rtol: float) -> None:
    """Coarse rules are off by less than they say."""
    fabric, stress, friction = CASES[name]
    assert apart(stiffness(fabric, stress, friction, rtol), stiffness(fabric, stress, friction, 1e-10)) < rtol


def test_one_island_closes_smoothly() -> None:
    """Just before and after the last contact stops sliding: an island missed, or one that is not there, would jump.

    The stiffness moves smoothly but for a power 4/3 of the distance; 1e-5 of friction moves it by 1e-4 at most.
    """
    limit, _ = most_mobilised(GeneralLoading(STRESS).force_tensor(FABRIC))
    below, above = (stiffness(FABRIC, STRESS, limit * (1 + step), 1e-8) for step in (-1e-5, 1e-5))
    assert apart(below, above) < 1e-4


@pytest.mark.parametrize("stress", [np.array([[1.0, 0.2, 0.0], [0.2, 1.5, 0.0], [0.0, 0.0, 0.0]]),
                                    np.diag([0.0, 0.0, 1.0])], ids=["one", "two"])
def test_principal_stresses_of_zero(stress: np.ndarray) -> None:
    """The force vanishes like the square of the distance at a corner, a double root that rounding splits at will."""
    turn = rotation(4)
    plain = stiffness(FABRIC, stress, None, 1e-12)
    turned = stiffness(GeneralFabric(turn @ np.array(FABRIC.D) @ turn.T), turn @ stress @ turn.T, None, 1e-12)
    assert apart(turned, np.array(Stiffness.from_mandel(plain).rotated(turn).rows)) < 1e-12


def test_edges_are_where_sliding_begins() -> None:
    """At every real root inside the pressed range, shear is friction times pressure, or the shear force vanishes."""
    forces = GeneralLoading(STRESS).force_tensor(general_fabric(1))
    integrand = Integrand(forces, 0.25, None)
    cut = product.triangles(integrand)
    meridians = cut.meridians(np.repeat(np.arange(4), 5), (cut.width[:, None] * np.linspace(0.1, 0.9, 5)).ravel())
    roots = special_angles(integrand, meridians)[:, 2:6]
    row, column = np.nonzero(np.abs(roots.imag) < 1e-12)
    assert row.size > 10
    n = directions(meridians, row, roots.real[row, column])
    force = forces @ n
    pressing = np.sum(force * n, axis=0)
    aside = np.linalg.norm(force - pressing * n, axis=0)
    assert np.abs(aside - 0.25 * np.abs(pressing)).max() < 1e-12


def test_triangles_cover_half_the_sphere() -> None:
    """A weight of one must average to one, whatever the corners: a triangle missing or twice shows."""
    for seed in range(3):
        forces = GeneralLoading(STRESS).force_tensor(general_fabric(seed))
        integrand = Integrand(forces, 0.3, None)
        cut = product.triangles(integrand)
        found = product.integrated(lambda n: (np.ones(n.shape[1]), np.ones(n.shape[1])),
                                   lambda moments: np.diag(moments[15:]), integrand, rtol=1e-6)
        assert np.all(cut.width > 0)
        # moments of one: n1 n1, n1 n2, n1 n3, n2 n2, n2 n3, n3 n3
        assert found.mandel.diagonal() == pytest.approx([1 / 3, 0, 0, 1 / 3, 0, 1 / 3], abs=1e-12)


def test_panels_fill_the_meridian_once() -> None:
    """Gaps or overlaps between panels: their lengths add up to the meridian where no contact has opened."""
    forces = GeneralLoading(STRESS).force_tensor(general_fabric(1))
    integrand = Integrand(forces, 0.25, None)
    cut = product.triangles(integrand)
    meridians: Meridians = cut.meridians(np.repeat(np.arange(4), 7),
                                         (cut.width[:, None] * np.linspace(0.05, 0.95, 7)).ravel())
    found = panels(integrand, meridians, finest=1e-6)
    total = np.bincount(found.which, weights=np.abs(found.far - found.near))
    assert np.abs(total - meridians.ends()).max() < 1e-13


def test_what_cannot_be_reached_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    """A rule that runs out of directions says how far it came, and gives no number."""
    monkeypatch.setattr(product, "MOST", 1000)
    monkeypatch.setattr(product, "ALONG", (2,))
    with pytest.raises(RouteOutOfDomain, match=r"G-RTE-01.*rtol = 1e-10 by the route product.*allowed about"):
        stiffness(general_fabric(1), STRESS, 0.25, 1e-10)
