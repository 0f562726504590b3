"""The picture of hard cases and the stiffness through the onset of sliding: every mark where its number says."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from granular import figures
from granular.figures.hard_case_plot import EDGE, LEAST, hard_cases, place
from granular.figures.look import BLUE, VERMILION
from granular.figures.mohr_circle import onset_ratio
from granular.figures.slip_stiffness import slip_data


def case(name, naive, stable):
    return SimpleNamespace(name=name, naive_label="textbook", naive_error=naive, stable_error=stable)


@pytest.mark.parametrize(("error", "drawn"), [
    (0.0, LEAST), (1e-30, LEAST), (1e-9, 1e-9), (-1e-9, 1e-9), (1.0, 1.0), (1.5, EDGE), (math.inf, EDGE),
    (math.nan, EDGE)])  # fmt: skip
def test_every_error_has_a_place_on_the_axis(error, drawn):
    # an exact result or a failure that vanishes from a logarithmic axis
    assert place(error) == drawn


def test_marks_stand_at_their_errors_and_the_worst_on_top():
    # naive and stable exchanged, or a row under the name of another
    axes = hard_cases([case("small", 1e-13, 1e-16), case("none", math.nan, 2e-16), case("large", 1e-3, 0.0)]).axes[0]
    marks = {colour: [(line.get_ydata()[0], line.get_xdata()[0]) for line in axes.lines
                      if line.get_color() == colour] for colour in (BLUE, VERMILION)}
    assert [x for _, x in sorted(marks[VERMILION])] == [EDGE, 1e-3, 1e-13]
    assert [x for _, x in sorted(marks[BLUE])] == [2e-16, LEAST, 1e-16]
    names = {text.get_text(): text.xy[1] for text in axes.texts if hasattr(text, "xy")}
    assert names["none"] < names["large"] < names["small"]
    assert axes.yaxis_inverted()


@pytest.mark.parametrize(("error", "words"), [(math.inf, "no bound"), (math.nan, "no number"), (40.0, "40 times"),
                                              (4e7, "$10^{7}$ times")])
def test_a_result_that_is_no_number_says_why(error, words):
    # an overflow that looks like an error of 30
    assert words in [text.get_text() for text in hard_cases([case("a", error, 0.0)]).axes[0].texts]


def test_a_page_can_bring_its_own_cases():
    # a page that must compute the corpus to show a few cases
    assert figures.hard_cases([case("a", 1e-3, 0.0)])._repr_svg_().startswith("<?xml")


def test_the_stiffness_falls_steeply_at_the_onset():
    # a curve of another component, another friction, or points too far apart to show the slope
    columns = slip_data()
    ratio, onset = columns["stress ratio"], onset_ratio(12.0)
    middle = int(np.searchsorted(ratio, onset))
    assert ratio[middle] == onset
    assert (np.diff(ratio) > 0).all()
    for name in ("C2323", "C1212"):
        assert columns[name][0] == 1.0
        assert (np.diff(columns[name]) < 0).all()
        slope = columns[f"d{name}"]
        assert math.isnan(slope[middle])
        for outwards in (-1, 1):
            # the slope goes like the distance to the power -1/6 plus a constant, which is a tenth of that power here
            near, far = (slope[middle + outwards * steps] for steps in (1, 41))
            distances = (ratio[middle + outwards * steps] - onset for steps in (1, 41))
            power = math.log(near / far) / math.log(abs(next(distances) / next(distances)))
            assert power == pytest.approx(-1 / 6, rel=0.1)


def test_the_stiffness_at_ratio_two_against_table_v():
    # shear components exchanged: table V has 1.1918 for their ratio
    columns = slip_data()
    two = {name: np.interp(2.0, columns["stress ratio"], columns[name]) for name in ("C2323", "C1212")}
    assert two["C2323"] / two["C1212"] == pytest.approx(1.1918, abs=1e-3)  # straight lines between points
