"""Index orders: every name lands where the printed table says, and nowhere else."""

import itertools
import math

import pytest

from granular.errors import IndexNotKnown
from granular.notation import MANDEL_PAIRS, ORDERS, component_place, mandel_factor, row_of, voigt_rows


@pytest.mark.parametrize("order", sorted(ORDERS))
def test_an_order_names_each_pair_once(order):
    # a pair listed twice would hide another, as in yz/xz swaps of other packages
    assert sorted(ORDERS[order]) == [(1, 1), (1, 2), (1, 3), (2, 2), (2, 3), (3, 3)]
    assert sorted(voigt_rows(order)) == list(range(6))


def test_the_two_orders_differ_exactly_in_12_and_23():
    # the paper's C44 is the standard C66: a quiet swap of "paper" and "standard" breaks this
    assert ORDERS["standard"][3:] == ((2, 3), (1, 3), (1, 2))
    assert ORDERS["paper"][3:] == ((1, 2), (1, 3), (2, 3))
    assert voigt_rows("standard") == (0, 1, 2, 3, 4, 5)


@pytest.mark.parametrize(("i", "j"), list(itertools.product((1, 2, 3), repeat=2)))
def test_a_row_holds_its_pair_in_either_order(i, j):
    # an asymmetric table would give C2323 and C3223 different values
    assert MANDEL_PAIRS[row_of(i, j)] == (min(i, j), max(i, j))


def test_mandel_factors():
    # the shear diagonal must be exactly 2, not sqrt(2) squared, or C2323 would not survive a round trip
    places = ((0, 1), (2, 3), (4, 2), (5, 5))
    assert [mandel_factor(p, q) for p, q in places] == [1, math.sqrt(2), math.sqrt(2), 2]


@pytest.mark.parametrize("name", ["C44", "C2324x", "c2323", "S2323", "C2340", "C", "", "C23233", "C²323"])
def test_names_without_four_indices_are_refused(name):
    # two-index names mean different components in different orders
    with pytest.raises(IndexNotKnown, match="four indices"):
        component_place(name, "C")


def test_an_unknown_order_is_refused_with_the_known_ones():
    # a typing slip must not fall back to a default order
    with pytest.raises(IndexNotKnown, match="standard, paper"):
        voigt_rows("abaqus")
