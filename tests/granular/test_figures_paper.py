"""Pictures of the printed tables, Figures 7 to 9 around a circle: the right numbers, and the rules of all figures."""

import importlib.util
from pathlib import Path

import numpy as np
import pytest
from matplotlib.colors import to_hex

from granular.figures import files
from granular.figures.look import BLUE, INK, VERMILION
from granular.figures.paper_figure_7_9 import CASES, data
from granular.figures.paper_roses import around, roses
from granular.figures.printed_tables import differences, matches, ratios

spec = importlib.util.spec_from_file_location("figure_rules", Path(__file__).with_name("test_figures.py"))
rules = importlib.util.module_from_spec(spec)
spec.loader.exec_module(rules)
test_no_text_is_small = rules.test_no_text_is_small
test_no_text_is_cut_or_overlaps = rules.test_no_text_is_cut_or_overlaps
test_every_axis_names_its_unit = rules.test_every_axis_names_its_unit

CASE_NAMES = ["case 1", "case 2", "case 3"]
EXACT = {"C1111/C3333": [1.0, 0.86, 0.78], "C2323/C1212": [1.0, 1.09, 1.16]}
PRINTED = {"C1111/C3333": [1.0, 1.857, 1.744], "C2323/C1212": [1.0, 1.091, 1.160]}
DRAWN = {
    "ratios": lambda: ratios(CASE_NAMES, EXACT, PRINTED),
    "differences": lambda: differences(["II, 1", "II, 1", "V, 2"], ["C1111/C3333", "C2323/C1212", "C1111/C3333"],
                                       [-2.5e-3, 0.5e-3, 2e-3], [-2e-3, 0.4e-3, 2e-3]),
    "matches": lambda: matches(dict(zip(range(6, 61), [*range(18), 18, *range(17, 0, -1), *[0] * 19], strict=True)),
                               of=18, marked=24),
    **{f"roses {number}": (lambda number=number: roses(number)) for number in CASES},
}


@pytest.fixture(scope="module", params=DRAWN)
def drawn(request):
    figure = DRAWN[request.param]()
    files.static_bytes(figure, "svg")  # settles the layout
    figure.draw_without_rendering()
    return figure


def test_rings_stand_at_the_printed_values_and_dots_at_the_exact_ones():
    # rings and dots exchanged, or a case on the line of another
    for axes, name in zip(DRAWN["ratios"]().axes, EXACT, strict=True):
        dots, rings = (line for line in axes.lines if line.get_marker() == "o")
        assert list(dots.get_xdata()) == EXACT[name]
        assert list(rings.get_xdata()) == PRINTED[name]
        assert to_hex(rings.get_markeredgecolor()) == INK
        assert axes.yaxis_inverted()
        assert [text.get_text() for text in axes.get_yticklabels()] in (CASE_NAMES, [])


def test_differences_are_in_units_of_the_third_decimal():
    # a ratio under the colour of the other, or another unit than the axis names
    axes = DRAWN["differences"]().axes[0]
    (dots,) = [line for line in axes.lines if to_hex(line.get_color()) == BLUE]
    assert list(dots.get_xdata()) == [0, 2]
    assert dots.get_ydata() == pytest.approx([-2.0, 2.0])


def test_one_bar_is_marked():
    # the mark on a neighbour of the number of panels that gives all
    axes = DRAWN["matches"]().axes[0]
    (bar,) = [bar for bar in axes.patches if to_hex(bar.get_facecolor()) == VERMILION]
    assert bar.get_x() + bar.get_width() / 2 == pytest.approx(24)
    assert bar.get_height() == 18


@pytest.mark.parametrize("number", CASES)
def test_roses_keep_the_distance_from_the_centre(number):
    # a curve turned by a right angle, or one that is not carried around
    columns = data(number)
    first = roses(number).axes[0]
    shown = [case for case in CASES[number] if "normal" in case.panels]
    for line, case in zip(first.lines, shown, strict=False):  # the circle of 1 comes last
        across, upright = line.get_data()
        column = columns[f"f_n {case.key}"]
        assert upright[0] == pytest.approx(column[0])
        assert across[len(column) - 1] == pytest.approx(column[-1])
        assert np.hypot(across, upright)[:len(column)] == pytest.approx(column)


def test_around_closes():
    # a gap, or a half that is not the mirror image of the other
    across, upright = around(np.linspace(0.0, 90.0, 7), np.arange(1.0, 8.0))
    assert len(across) == 4 * 7 - 3
    assert (across[0], upright[0]) == pytest.approx((across[-1], upright[-1]), abs=1e-12)
    assert across == pytest.approx(-across[::-1], abs=1e-12)
