"""Mohr's circle and Figures 7 to 9: the right numbers at points that can be computed by hand."""

import json
import math

import numpy as np
import pytest

from granular import figures
from granular.figures.look import VERMILION
from granular.figures.mohr_circle import FRICTION_ANGLE, Circle, mohr, onset_ratio
from granular.figures.mohr_sliders import FRICTION_ANGLES, MOVING, START, STRESS_RATIOS, mohr_interactive
from granular.figures.paper_figure_7_9 import data, draw

MU = math.tan(math.radians(12))


def test_the_onset_touches_the_line_at_45_degrees_plus_half_the_friction_angle():
    # a circle of wrong size, or an angle counted from the other end
    circle = Circle.of(onset_ratio(12.0), MU)
    normal, shear = circle.at(51.0)
    assert shear == pytest.approx(MU * normal, rel=1e-14)
    for degrees in (50.0, 52.0):
        normal, shear = circle.at(degrees)
        assert shear < MU * normal
    # on the other side of isotropy the angle is 45 degrees less half of it
    normal, shear = Circle.of(1 / onset_ratio(12.0), MU).at(39.0)
    assert shear == pytest.approx(MU * normal, rel=1e-14)


def test_the_tinted_arc_is_the_part_above_the_line():
    # sticking contacts in the colour of sliding ones
    axes = mohr().axes[0]
    (arc,) = [line for line in axes.lines if line.get_color() == VERMILION]
    normal, shear = arc.get_data()
    assert (shear >= MU * normal - 1e-12).all()
    assert shear[[0, -1]] == pytest.approx(MU * normal[[0, -1]], rel=1e-12)
    assert shear.max() == pytest.approx(0.375, abs=1e-4)
    assert FRICTION_ANGLE == 12


def test_sliders_and_buttons_show_the_state_that_they_name():
    # steps shifted against the states, a button that shows another slider, or a band that outlives sliding
    figure = mohr_interactive()
    assert [button.label for button in figure.layout.updatemenus[0].buttons] == [f"φ = {x}°" for x in FRICTION_ANGLES]
    for place, (angle, slider) in enumerate(zip(FRICTION_ANGLES, figure.layout.sliders, strict=True)):
        assert slider.visible == (angle == START[0])
        assert [float(step.label) for step in slider.steps] == list(STRESS_RATIOS)
        button = figure.layout.updatemenus[0].buttons[place].args
        assert [button[1][f"sliders[{k}].visible"] for k in range(len(FRICTION_ANGLES))] == [
            k == place for k in range(len(FRICTION_ANGLES))]
        assert button[0] == slider.steps[button[1][f"sliders[{place}].active"]].args[0]
        for ratio, step in zip(STRESS_RATIOS, slider.steps, strict=True):
            change, words, traces = step.args
            assert tuple(traces) == MOVING
            assert change["y"][0][1] / change["x"][0][1] == pytest.approx(math.tan(math.radians(angle)), abs=1e-4)
            assert change["x"][2][0] / change["x"][2][1] == pytest.approx(ratio, rel=1e-3)  # four decimals
            slides = max(ratio, 1 / ratio) > onset_ratio(angle)
            assert list(change["visible"]) == [True, True, True, slides, slides, slides]
            assert ("every contact sticks" in words["annotations[0].text"]) != slides


def test_the_interactive_page_is_small_and_the_same_each_time():
    # a page too heavy for a phone, or one that changes between builds
    html = figures.mohr_interactive()._repr_html_()
    assert len(html) < 1_500_000
    assert html == figures.mohr_interactive()._repr_html_()
    assert "NaN" not in json.dumps(json.loads(mohr_interactive().to_json())["layout"])


@pytest.mark.parametrize("number", [7, 8, 9])
def test_the_numbers_behind_a_figure_are_what_it_draws(number):
    # a file for download that differs from the picture beside it
    columns = data(number)
    assert next(iter(columns)) == "beta"
    assert columns["beta"][[0, -1]].tolist() == [0, 90]
    drawn = [line.get_ydata() for axes in draw(number).axes for line in axes.lines]
    for name, column in columns.items():
        assert name == "beta" or any(np.array_equal(column, curve) for curve in drawn), name
    assert len(drawn) == len(columns) - 1


def test_forces_and_stiffnesses_of_the_papers_assemblies():
    # another normalisation, poles and equator exchanged, or branch lengths where they cancel
    seven, eight, nine = data(7), data(8), data(9)
    assert seven["f_n D33=0 Dr33=-0.3"][[0, -1]] == pytest.approx([1 / 0.7, 1 / 1.15])
    assert seven["f_n D33=0.3 Dr33=0"][[0, -1]] == pytest.approx([5 / 5.6, 5 / 4.7])
    assert (seven["f_r D33=0 Dr33=-0.3"] == 0).all()
    # 1e-15: the branch length cancels but for a rounding
    assert seven["k_n D33=0.3 Dr33=0"] == pytest.approx(seven["k_n D33=0.3 Dr33=-0.3"], abs=1e-15)
    assert seven["k_r D33=0.3 without slip"] == pytest.approx(158 / 179 * seven["k_n D33=0.3 Dr33=0"])
    assert (seven["k_r D33=0.3 Dr33=0"][1:-1] < seven["k_r D33=0.3 without slip"][1:-1]).all()
    assert eight["f_n D33=0.5"][[0, -1]] == pytest.approx([5 / 6, 5 / 4.5])
    assert nine["f_n SR=1.5"][[0, -1]] == pytest.approx([9 / 7, 6 / 7])
    assert nine["f_r SR=2"].max() == pytest.approx(0.375)
    slides = nine["k_r SR=2"] == 0
    cosine = np.cos(np.radians(nine["beta"][slides]))
    assert [cosine.max(), cosine.min()] == pytest.approx([0.90412, 0.22996], abs=1e-5)
    assert (nine["k_r SR=1.5"] > 0).all()
