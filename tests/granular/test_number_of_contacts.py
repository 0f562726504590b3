"""Number of contacts per volume: eqs (8)-(9) by counting spheres, and the coordination line."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from granular.number_of_contacts import DEFAULT_RELATION, CoordinationRelation, contacts_per_volume

VOID_RATIOS = st.floats(1e-6, 1e6)
NUMBERS = st.floats(1e-6, 1e6)


@pytest.mark.parametrize(("edge", "spheres", "neighbours"), [
    (2.0, 1, 6), (4 / math.sqrt(3), 2, 8), (2 * math.sqrt(2), 4, 12),
], ids=["simple cubic", "body-centred", "face-centred"])
def test_crystals_by_counting(edge, spheres, neighbours):
    # Breaks when (8) or (9) loses a factor: unit cells of touching unit spheres have spheres * neighbours / 2 contacts.
    volume, solid = edge**3, spheres * 4 / 3 * math.pi
    counted = spheres * neighbours / 2 / volume
    # rounding of a handful of operations on either side
    assert contacts_per_volume(volume / solid - 1, neighbours, grain_diameter=2.0) == pytest.approx(counted, rel=4e-15)


@given(VOID_RATIOS, NUMBERS, st.floats(1e-9, 1e3))
def test_scales_with_the_cube_of_the_grain_size(void_ratio, coordination, diameter):
    # Breaks when the unit of length of the dimensionless number is anything but one diameter. 4 roundings.
    assert contacts_per_volume(void_ratio, coordination, grain_diameter=diameter) * diameter**3 == pytest.approx(
        contacts_per_volume(void_ratio, coordination), rel=8 * 2.0**-53)


@given(VOID_RATIOS, NUMBERS)
def test_is_three_N_over_pi_times_one_plus_e(void_ratio, coordination):
    # Breaks when a rounding is added: 40 digits of pi as a fraction, 4 units of the last place as declared.
    pi = Fraction(31415926535897932384626433832795028841971, 10**40)
    exact = 3 * Fraction(coordination) / (pi * (1 + Fraction(void_ratio)))
    assert contacts_per_volume(void_ratio, coordination) == pytest.approx(float(exact), rel=4 * 2.0**-52)


def test_the_default_line_gives_the_papers_number():
    # Breaks when the line e = 1.66 - 0.125 N is mistyped.
    assert DEFAULT_RELATION.coordination_number(0.5744) == 8.6848
    assert DEFAULT_RELATION.coordination_number(1.66) == 0.0


def test_another_relation_is_one_record():
    # Breaks when the relation stops being replaceable data.
    assert CoordinationRelation(intercept=2.0, slope=0.5, source="test").coordination_number(1.0) == 2.0
