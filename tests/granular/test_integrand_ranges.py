"""The two halves of a bound, each where it is sharp: ranges of integrands, and what they do to the six components.

Ranges are held against the integrands themselves, direction by direction. What follows from ranges is held against
components of a few contacts whose stiffness is changed at will within them.
"""

from __future__ import annotations

import importlib
import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from granular.contact_distribution import normal_stiffness, shear_stiffness
from granular.effects import CATALOGUE
from granular.effects.bound import Change, Simulated, largest_change
from granular.effects.ranges import UNCHANGED, Range
from granular.fabric import AxialFabric
from granular.hypothesis import Hypothesis
from granular.loading import Loading
from granular.routes.direction_sums import axial_components, contact_tensor, fourth_rank, mandel_matrix, symmetrised

X = np.sqrt(np.concatenate([[0.0, 1.0], np.geomspace(1e-6, 0.5, 40), 1 - np.geomspace(1e-6, 0.5, 40)]))
"""Cosines of directions, both ends among them."""

S, Y = (1 - X) * (1 + X), X * X


# ---- ranges of integrands

def model(fabric, loading=None, *, nu=0.21, static=False):
    return Simulated(fabric=fabric, loading=loading, sizes=None, poisson_ratio=nu,
                     hypothesis=Hypothesis.STATIC if static else Hypothesis.KINEMATIC)


def density(fabric):
    squared = X * X
    return (1 + fabric.D33 * (3 * squared - 1) / 2
            + fabric.D3333 * ((35 * squared - 30) * squared + 3) / 8)


def products(fabric, *, static):
    """Products of branch components over those of the normal (kinematic), or the inverse square of the length."""
    if fabric.aspect_ratio == 1.0:
        squared = (1 + fabric.Dr33 * (3 * X * X - 1) / 2) ** 2
        return [1 / squared] if static else [squared]
    r = fabric.aspect_ratio
    equator, pole = r ** (-1 / 3), r ** (2 / 3)  # l = 2 M^2 n/|M n|, det M = 1
    height = equator**2 * S + pole**2 * Y
    if static:
        return [height / (equator**4 * S + pole**4 * Y)]
    return [equator**4 / height, equator**2 * pole**2 / height, pole**4 / height]


def stiffness(given):
    """k_n, k_r/k_n and 1 - k_r/k_n in every direction."""
    share = 2 * (1 - given.poisson_ratio) / (2 - given.poisson_ratio)
    if given.loading is None:
        return np.ones_like(X), np.full_like(X, share), np.full_like(X, 1 - share)
    normal = normal_stiffness(given.fabric, given.loading, X)
    shear = shear_stiffness(given.fabric, given.loading, X, poisson_ratio=given.poisson_ratio)
    return normal, shear / normal, 1 - shear / normal


def within(bounds, ratio):
    """Whether ratios lie in a range, but for the rounding of the integrands."""
    return np.all(np.log(ratio) >= bounds.low - 1e-9) and np.all(np.log(ratio) <= bounds.high + 1e-9)


def captured(monkeypatch, name, given):
    """The change of the integrands from which an effect makes its bound."""
    kept = []
    module = importlib.import_module(f"granular.effects.{name}")
    monkeypatch.setattr(module, "largest_change", lambda change, simulated: kept.append(change) or 0.0)
    effect = next(effect for effect in CATALOGUE if effect.name == name)
    effect.bound(given)
    return kept[0]


FABRIC = AxialFabric(D33=0.4, D3333=-0.3)
STICKING = Loading.of_ratio(1.3, friction=0.6)
CASES = [
    ("packing", FABRIC, None, {"D33": 0.0, "D3333": 0.0}, False),
    ("packing", AxialFabric(D33=0.2, D3333=0.5), Loading.of_ratio(0.7), {"D33": 0.0, "D3333": 0.0}, False),
    ("packing", AxialFabric(D33=-0.8), STICKING, {"D33": 0.0}, False),
    ("packing", AxialFabric(D33=0.05), STICKING, {"D33": 0.0}, True),
    ("packing", AxialFabric(D33=1.5), Loading.of_ratio(2.0), {"D33": 0.0}, True),
    ("packing", AxialFabric(D33=0.3, aspect_ratio=0.5), None, {"D33": 0.0}, True),
    ("branches", AxialFabric(D33=0.4, Dr33=-0.6), STICKING, {"Dr33": 0.0}, False),
    ("branches", AxialFabric(Dr33=1.2), None, {"Dr33": 0.0}, True),
    ("deviation", AxialFabric(D33=0.4, aspect_ratio=0.3), None, {"aspect_ratio": 1.0}, False),
    ("deviation", AxialFabric(aspect_ratio=4.0), STICKING, {"aspect_ratio": 1.0}, False),
    ("deviation", AxialFabric(D33=0.4, aspect_ratio=0.3), None, {"aspect_ratio": 1.0}, True),
    ("deviation", AxialFabric(aspect_ratio=4.0), None, {"aspect_ratio": 1.0}, True),
    ("kinetic", AxialFabric(D33=0.4), Loading.of_ratio(3.0), None, False),
    ("kinetic", AxialFabric(D33=-0.4), Loading.of_ratio(0.2), None, True),
    ("slip", AxialFabric(D33=0.4), Loading.of_ratio(1.5, friction=0.3), Loading.of_ratio(1.5), False),
    ("slip", AxialFabric(), Loading.of_ratio(0.6, friction=0.5), Loading.of_ratio(0.6), True),
]


@pytest.mark.parametrize("nu", [0.01, 0.21, 0.5])
@pytest.mark.parametrize(("name", "fabric", "loading", "without", "static"), CASES)
def test_integrands_stay_in_their_ranges(monkeypatch, name, fabric, loading, without, static, nu):
    # Breaks when one factor of one integrand leaves its range in one direction, which averages may hide.
    full = model(fabric, loading, nu=nu, static=static)
    less = replace(full, fabric=replace(fabric, **without)) if isinstance(without, dict) else replace(
        full, loading=without)
    change = captured(monkeypatch, name, full)
    assert all(within(change.share, density(less.fabric) / density(full.fabric) * other / one)
               for one, other in zip(*spread(full, less, static=static), strict=True))
    springs = change.normal, change.chi, change.apart
    for kept, one, other in zip(springs, stiffness(full), stiffness(less), strict=True):
        assert within(kept, other / one)
    if static:
        for kept, one, other in zip((change.across, change.along), balance(full.fabric), balance(less.fabric),
                                    strict=True):
            assert within(kept, np.array([other / one]))


def spread(full, less, *, static):
    one, other = products(full.fabric, static=static), products(less.fabric, static=static)
    most = max(len(one), len(other))
    return (each * (most if len(each) < most else 1) for each in (one, other))


def balance(fabric):
    """N_11 and N_33 of contacts whose forces balance the stress along their branches, by Gauss points in x."""
    x, weight = np.polynomial.legendre.leggauss(400)
    y = ((x + 1) / 2) ** 2
    r2 = fabric.aspect_ratio**2
    share = weight / 2 * (1 + fabric.D33 * (3 * y - 1) / 2) / np.sqrt(1 - y + r2**2 * y)
    return float(np.sum(share * (1 - y))) / 2, float(np.sum(share * r2 * y))


# ---- what ranges do to components

AZIMUTHS = 2 * np.pi * np.arange(8) / 8
"""Enough for products of four components of a normal."""


def components(rings, N11, N33, *, static):
    """Six components of contacts on rings (y, weight, k_n, k_r/k_n) about axis 3, by tensors."""
    y, weight, normal, share = (np.repeat(column, 8) / (8 if k == 1 else 1) for k, column in enumerate(rings))
    phi = np.tile(AZIMUTHS, len(rings[0]))
    n = np.stack([np.sqrt(1 - y) * np.cos(phi), np.sqrt(1 - y) * np.sin(phi), np.sqrt(y)])
    shear = normal * share
    if not static:
        raw = fourth_rank(weight * n[:, None] * n[None, :], contact_tensor(n, normal - shear, shear))
        return axial_components(mandel_matrix(symmetrised(raw)))
    carried = n / np.array([[N11], [N11], [N33]])
    raw = fourth_rank(weight * carried[:, None] * carried[None, :],
                      contact_tensor(n, 1 / normal - 1 / shear, 1 / shear))
    return axial_components(np.linalg.inv(mandel_matrix(symmetrised(raw))))


RINGS = st.lists(st.tuples(st.floats(0.05, 0.95), st.floats(0.1, 1.0), st.floats(0.2, 5.0), st.floats(0.05, 0.9)),
                 min_size=2, max_size=4)
ENDS = st.lists(st.sampled_from([-1.0, 0.0, 1.0]), min_size=18, max_size=18)


@settings(max_examples=200, deadline=None)
@given(RINGS, ENDS, st.sampled_from([0.01, 0.1, 0.4]), st.booleans())
def test_components_of_any_contacts_change_within_the_bound(rings, ends, width, static):
    # Breaks when a power, or a part of the static compliance, is forgotten on the way from integrands to components.
    columns = [np.array(column) for column in zip(*rings, strict=True)]
    moves = np.exp(width * np.array(ends).reshape(3, 6)[:, : len(rings)])
    N11, N33 = math.exp(width * ends[16]), math.exp(width * ends[17])
    y, weight, normal, share = columns
    moved = [y, weight * moves[0], normal * moves[1], share * np.minimum(moves[2], 1.0)]
    change = Change(
        share=Range.of(*moves[0]), normal=Range.of(*moves[1]), chi=Range.of(*(moved[3] / share)),
        apart=Range.of(*((1 - moved[3]) / (1 - share))), across=Range.of(N11) if static else UNCHANGED,
        along=Range.of(N33) if static else UNCHANGED)
    before = np.array(components(columns, 1.0, 1.0, static=static))
    after = np.array(components(moved, N11, N33, static=static))
    bound = largest_change(change, model(AxialFabric(), static=static))
    # the compliance of contacts on two rings is inverted with a condition of up to 1e4
    assert np.all(np.abs(after / before - 1) <= bound + 1e-9)


@pytest.mark.parametrize(("part", "component", "power"), [("across", 0, 2), ("along", 1, 2), ("across", 5, 2)])
def test_the_balance_of_forces_enters_squared(part, component, power):
    # Breaks when N_11 or N_33 is left out of the static components, or enters once.
    rings = [np.array(column) for column in ((0.2, 0.7), (0.5, 0.5), (1.0, 2.0), (0.5, 0.3))]
    N = {"across": (1.1, 1.0), "along": (1.0, 1.1)}[part]
    ratio = components(rings, *N, static=True)[component] / components(rings, 1.0, 1.0, static=True)[component]
    bound = largest_change(Change(**{part: Range.of(1.1)}), model(AxialFabric(), static=True))
    assert ratio == pytest.approx(1.1**power, rel=1e-12)
    assert bound >= ratio - 1


def test_turning_the_forces_moves_vertical_shear_more_than_each_balance_does():
    # Breaks when C2323 is bounded by the changes of N_11 and N_33 alone: here the shear forces nearly cancel.
    rings = [np.array([0.2, 0.7]), np.array([1e-9, 1.0]), np.array([1.0, 1.0]), np.array([1e-6, 1e-6])]
    h = 0.02
    before = components(rings, 1.0, 1.0, static=True)[4]
    after = components(rings, math.exp(h / 2), math.exp(-h / 2), static=True)[4]
    bound = largest_change(Change(across=Range.of(math.exp(h / 2)), along=Range.of(math.exp(-h / 2))),
                           model(AxialFabric(), static=True))
    assert math.expm1(h) < abs(after / before - 1) <= bound
