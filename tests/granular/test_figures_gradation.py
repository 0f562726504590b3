"""Figures of gradation: the numbers of Table I, curves under their own names, and the rules that all figures keep."""

import importlib.util
import math
from pathlib import Path

import numpy as np
import pytest
from matplotlib.colors import to_hex

from granular import figures
from granular.figures import files
from granular.figures.fitted_densities import lengths_by_reading
from granular.figures.gradation_numbers import COLOURS as READING_COLOURS
from granular.figures.gradation_numbers import CUTS, HANDED_DOWN, number_by_cut, number_by_reading
from granular.figures.look import BLUE, VERMILION
from granular.figures.paper_figures_3_4 import COLOURS, figure_3, figure_4, table_i
from granular.gradation import branch_lengths
from granular.gradation.cut_sizes import cut
from granular.gradation.readings import READINGS, literal

spec = importlib.util.spec_from_file_location("figure_rules", Path(__file__).with_name("test_figures.py"))
rules = importlib.util.module_from_spec(spec)
spec.loader.exec_module(rules)
test_no_text_is_small = rules.test_no_text_is_small
test_no_text_is_cut_or_overlaps = rules.test_no_text_is_cut_or_overlaps
test_every_axis_names_its_unit = rules.test_every_axis_names_its_unit

DRAWN = {draw.__name__: draw for draw in (figure_3, figure_4, number_by_reading, number_by_cut, lengths_by_reading)}


@pytest.fixture(scope="module", params=DRAWN)
def drawn(request):
    figure = DRAWN[request.param]()
    files.static_bytes(figure, "svg")  # settles the layout
    figure.draw_without_rendering()
    return figure


def curve(axes, colour):
    return next(line for line in axes.lines if to_hex(line.get_color()) == colour and len(line.get_xdata()) > 2)


def test_printed_coefficients_of_uniformity_follow_from_the_spreads():
    # a spread of log10 in place of the natural logarithm; all six are printed with one decimal
    assert [round(row.uniformity, 1) for row in table_i()] == [row.printed_uniformity for row in table_i()]


def test_table_i_by_hand():
    # r_50 taken for a diameter, or for a median: under eq. (18) the median is exp(L^2) farther up
    first = table_i()[0]
    square = math.log(1.5) ** 2
    assert first.D50 == pytest.approx(0.020 * math.exp(square), rel=1e-14)
    # deviates of 10 % and 60 % from a table of the normal distribution
    low, high = -1.2815515655446004, 0.2533471031357997
    assert first.D10 == pytest.approx(first.D50 * 1.5**low, rel=1e-13)
    assert first.D60 == pytest.approx(first.D50 * 1.5**high, rel=1e-13)
    assert first.uniformity == pytest.approx(1.5 ** (high - low), rel=1e-13)


def test_uniformity_depends_on_the_spread_alone():
    # a mean size that enters: curves 1 to 3 and 5 have one spread
    rows = table_i()
    assert len({round(rows[k].uniformity, 12) for k in (0, 1, 2, 4)}) == 1


def test_figure_3_draws_diameters():
    # curves of radii, or numbers of curves exchanged
    axes = figure_3().axes[0]
    for row, colour in zip(table_i(), COLOURS, strict=True):
        diameter, percent = curve(axes, colour).get_data()
        # 0.2 %: the curve is read off between two of 401 points
        assert float(np.interp(50.0, percent, diameter)) == pytest.approx(1e3 * row.D50, rel=2e-3)
        number = next(text for text in axes.texts if text.get_text() == str(row.curve))
        x, y = number.get_position()
        assert float(np.interp(x, diameter, percent)) == pytest.approx(y, abs=0.2)


def test_densities_of_figure_4_have_area_one():
    # densities of diameters on an axis of radii, or per millimetre on one of metres
    panels = figure_4().axes
    for axes in panels:
        for line in axes.lines:
            size, density = line.get_data()
            # 1e-3: curve 4 of g has that much beyond the frame
            assert np.trapezoid(density, np.log(size)) == pytest.approx(1, abs=1e-3)
    # lengths are sums of two radii: the peak of all branches of curve 6 lies near twice that of its radii
    peaks = [axes.lines[2].get_xdata()[np.argmax(axes.lines[2].get_ydata())] for axes in (panels[1], panels[3])]
    assert peaks[1] / peaks[0] == pytest.approx(2, rel=0.05)


def test_curves_1_to_3_are_one_curve_shifted():
    # a mean size that changes the shape of g
    row, other = table_i()[0], table_i()[2]
    for name in ("total_density", "density"):
        one, two = (getattr(branch_lengths(each.sizes), name) for each in (row, other))
        assert 0.03 * one(0.03) == pytest.approx(0.003 * two(0.003), rel=1e-12)


def test_readings_stand_under_their_colours():
    # names at curves exchanged
    axes = number_by_reading().axes[0]
    for reading, colour in zip(READINGS, READING_COLOURS, strict=True):
        spread, numbers = curve(axes, colour).get_data()
        assert numbers[0] == 4
        assert numbers[-1] == reading.numbers(float(spread[-1])).kinematic


def test_the_cut_is_marked_where_it_is():
    # a number that stands beside another curve
    axes = number_by_cut().axes[0]
    shown = " ".join(text.get_text() for text in axes.texts)
    for spread, _ in CUTS:
        value = cut(spread, HANDED_DOWN, about="printed").kinematic
        assert f"{value:#.4g} of {literal(spread).kinematic:#.4g}" in shown


def test_the_fit_is_the_dashed_curve():
    # eq. (17) and eq. (19) exchanged: beyond the peak the fit lies below
    for axes in lengths_by_reading().axes:
        true, fit = (curve(axes, colour).get_ydata() for colour in (BLUE, VERMILION))
        assert curve(axes, VERMILION).is_dashed()
        assert fit[-20] < true[-20]


def test_pages_show_them():
    # a page object that shows another figure
    for name in DRAWN:
        assert getattr(figures, name)()._repr_svg_().startswith("<?xml")
