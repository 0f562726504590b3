"""Numbers that a figure offers are those that it draws."""

from __future__ import annotations

import csv
import io

import numpy as np
import pytest

from granular.figures.drawn_data import Series, as_rows, drawn_data, plain_title
from granular.figures.look import BLUE, GRID, blank, readable
from granular.figures.page import Interactive, Static


def read(figure, **options):
    data = drawn_data(figure, **options)
    header, *rows = csv.reader(io.StringIO(data.csv))
    return header, rows


@pytest.fixture
def plot():
    figure = blank(2.0)
    return figure, figure.subplots()


def test_a_line_gives_its_points_under_the_titles_of_its_axes(plot):
    """Breaks if units are lost, a number is cut or a point is left out."""
    figure, axes = plot
    axes.plot([0.0, 90.0], [1 / 3, 2e-12], label=r"$f_n$")
    axes.set(xlabel=r"angle $\beta$ [°]", ylabel="force [–]")
    header, rows = read(figure)
    assert header == ["panel", "series", "angle beta [°]", "force [-]"]
    assert rows == [["1", "f_n", "0", "0.33333333"], ["1", "f_n", "90", "2e-12"]]


def test_a_curve_is_called_by_the_word_in_its_colour(plot):
    """Breaks if curves that are labelled beside their end are numbered only."""
    figure, axes = plot
    axes.plot([0, 1], [0, 1], color=BLUE)
    axes.plot([0, 1], [1, 1], color=GRID)
    axes.text(1, 1, "$C_{1111}$", color=readable(BLUE))
    assert {row[1] for row in read(figure)[1]} == {"C_1111"}


def test_panels_in_line_share_their_titles():
    """Breaks if the second panel of a row, which repeats no title, gets a column of its own."""
    figure = blank(2.0)
    for axes, title in zip(figure.subplots(1, 2, sharey=True), ("left", "right"), strict=True):
        axes.plot([1.0], [2.0], "o")
        axes.set_title(title)
    figure.axes[0].set(ylabel="speed [m/s]", xlabel="angle [°]")
    figure.axes[1].set(xlabel="angle [°]")
    header, rows = read(figure)
    assert header[2:] == ["angle [°]", "speed [m/s]"]
    assert [row[0] for row in rows] == ["1 left", "2 right"]


def test_points_areas_maps_and_level_curves(plot):
    """Breaks if one of these kinds of marks is passed over."""
    figure, axes = plot
    axes.scatter([1.0], [2.0], c=[3.0], label="points")
    axes.fill_between([0.0, 1.0], [0.0, 0.0], [1.0, 1.0], label="area")
    x, y = np.meshgrid(np.arange(3.0), np.arange(3.0))
    axes.contour(x, y, x, levels=[0.5])
    axes.pcolormesh([0.0, 1.0], [0.0, 1.0], [[7.0, 8.0], [9.0, 10.0]])
    _, rows = read(figure)
    assert ["1", "points", "1", "2", "3"] in rows
    assert sum(row[1].startswith("area") for row in rows) >= 4
    assert {row[2] for row in rows if "level 0.5" in row[1]} == {"0.5"}
    assert [row[4] for row in rows if row[4] in {"7", "8", "9", "10"}] == ["7", "8", "9", "10"]


def test_bars_keep_their_words(plot):
    """Breaks if a bar is only numbered where the axis names it."""
    figure, axes = plot
    axes.barh([0, 1], [5.0, 6.0])
    axes.set_yticks([0, 1], ["slip", "no slip"])
    assert [row[2:] for row in read(figure)[1]] == [["5", "slip"], ["6", "no slip"]]


def test_a_surface_gives_points_in_space():
    """Breaks if the way in which matplotlib keeps a surface changes."""
    figure = blank(2.0)
    axes = figure.add_subplot(projection="3d")
    x, y = np.meshgrid(np.arange(3.0), np.arange(3.0))
    axes.plot_surface(x, y, x * y, rstride=1, cstride=1)
    _, rows = read(figure)
    assert [tuple(map(float, row[2:])) for row in rows] == [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 1)]


def test_long_series_are_thinned_and_short_ones_are_whole(plot):
    """Breaks if a file grows beyond its limit, loses an end of a curve, or a short curve pays for a long one."""
    figure, axes = plot
    axes.plot(np.arange(10_000.0), np.arange(10_000.0), label="long")
    axes.plot(np.arange(20.0), np.arange(20.0), label="short")
    data = drawn_data(figure, limit=5_000)
    assert len(data.csv.encode()) <= 5_000
    kept = [row[2] for row in data.rows if row[1] == "long"]
    assert (kept[0], kept[-1]) == ("0", "9999")
    assert len(kept) == data.most
    assert sum(row[1] == "short" for row in data.rows) == 20


def test_states_of_an_interactive_figure_are_named():
    """Breaks if what a slider shows is missing, or is not told from the first state."""
    from plotly import graph_objects

    figure = graph_objects.Figure([graph_objects.Scatter(x=[0], y=[1], name="a"),
                                   graph_objects.Scatter(x=[0], y=[2], name="b", visible=False)])
    figure.update_layout(sliders=[{"currentvalue": {"prefix": "D = "}, "steps": [
        {"label": "0", "method": "update", "args": [{"visible": [True, False]}]},
        {"label": "1", "method": "update", "args": [{"visible": [False, True]}]},
        {"label": "2", "method": "update", "args": [{"x": [[5]], "y": [[6]]}, {}, [0]]}]}],
        xaxis_title="t [s]")
    header, rows = read(figure)
    assert header == ["panel", "series", "t [s]", "y"]
    assert rows == [["D = 0", "a", "0", "1"], ["D = 1", "b", "0", "2"], ["D = 2", "a", "5", "6"]]


def test_gaps_are_empty_cells():
    """Breaks if a gap in a curve becomes a word that other programs cannot read."""
    assert as_rows([Series("", "s", {"x": (None, float("nan"), 1.0)})]).csv.splitlines()[1:] == [",s,", ",s,", ",s,1"]


def test_titles_lose_their_markup():
    """Breaks if signs of TeX or HTML reach the head of a file."""
    assert plain_title(r"$\sigma_{33}/\sigma_{11}$") == "sigma_33/sigma_11"
    assert plain_title(r"$\ell\,g$ [–]") == "ell g [-]"


def test_figures_of_pages_bring_their_numbers(plot):
    """Breaks if a figure shows itself without the link, or the link differs between two builds."""
    figure, axes = plot
    axes.plot([0, 1], [2, 3])
    bundles = [Static(figure)._repr_mimebundle_() for _ in range(2)]
    assert bundles[0] == bundles[1]
    assert 'download="NAME.csv"' in bundles[0][1]["image/svg+xml"]["numbers"]

    from plotly import graph_objects
    shown = Interactive(graph_objects.Figure(graph_objects.Scatter(x=[0], y=[1])), "some")._repr_html_()
    assert 'download="some.csv"' in shown
