"""Figures of the model's pages: what each claims holds for what it draws, and the rules that all figures keep."""

import importlib.util
import itertools
import math
from pathlib import Path

import numpy as np
import pytest
from matplotlib.colors import to_hex

from granular.figures import files
from granular.figures.along_stress import along_stress
from granular.figures.approach_to_limits import LIMITS, approach_to_limits, distances
from granular.figures.look import BLUE, COMPONENT_COLOURS, GREEN, INK, VERMILION
from granular.figures.mohr_circle import FRICTION_ANGLE, onset_ratio
from granular.figures.pulled_along import pulled_along
from granular.figures.ratios_by_fabric import ratios_by_fabric
from granular.figures.share_of_friction import share_of_friction
from granular.figures.sizes_by_number import sizes_by_number
from granular.gradation import MeasuredCurve

spec = importlib.util.spec_from_file_location("figure_rules", Path(__file__).with_name("test_figures.py"))
rules = importlib.util.module_from_spec(spec)
spec.loader.exec_module(rules)
test_no_text_is_small = rules.test_no_text_is_small
test_no_text_is_cut_or_overlaps = rules.test_no_text_is_cut_or_overlaps
test_every_axis_names_its_unit = rules.test_every_axis_names_its_unit

CURVE = MeasuredCurve([1e-4, 2e-4, 4e-4], [0.0, 0.5, 1.0])
DRAWN = {draw.__name__: draw for draw in (ratios_by_fabric, along_stress, share_of_friction, approach_to_limits,
                                          pulled_along)}
DRAWN["sizes_by_number"] = lambda: sizes_by_number(CURVE)


@pytest.fixture(scope="module", params=DRAWN)
def drawn(request):
    figure = DRAWN[request.param]()
    files.static_bytes(figure, "svg")  # settles the layout
    figure.draw_without_rendering()
    return figure


def curves(axes, colour):
    return [line for line in axes.lines if to_hex(line.get_color()) == colour and len(line.get_xdata()) > 2]


def test_isotropic_fabric_has_ratio_one():
    # curves of another component, or of branches that do not vanish
    for axes in ratios_by_fabric().axes:
        (curve,) = curves(axes, BLUE)
        assert np.interp(0.0, curve.get_xdata(), curve.get_ydata()) == pytest.approx(1.0, abs=1e-12)


def test_more_vertical_contacts_stiffen_the_vertical():
    # ratios turned upside down
    compression, shear = ratios_by_fabric().axes
    for colour in (VERMILION, BLUE, GREEN):
        assert np.all(np.diff(curves(compression, colour)[0].get_ydata()) < 0)
        assert np.all(np.diff(curves(shear, colour)[0].get_ydata()) > 0)


def test_slip_lowers_shear_and_raises_coupling():
    # full and dashed exchanged; without slip the lateral components hardly move
    for axes, names, sign in zip(along_stress().axes[1:], (("C1212", "C2323"), ("C1133", "C1122")), (-1, 1),
                                 strict=True):
        for name in names:
            slipping, sticking = curves(axes, COMPONENT_COLOURS[name])
            gap = sign * (slipping.get_ydata() - sticking.get_ydata())
            assert gap[0] == pytest.approx(0.0, abs=1e-12)
            assert np.all(gap[1:] > 0)


def test_half_of_the_shear_stiffness_is_left_at_seven_eighths():
    # the square root that the paper prints, under which half is left at three quarters
    left = share_of_friction().axes[0]
    curve = curves(left, INK)[0]
    share, kept = curve.get_xdata(), curve.get_ydata() / curve.get_ydata()[0]
    assert np.interp(0.5, kept[::-1], share[::-1]) == pytest.approx(7 / 8, abs=1e-3)  # between 201 points


def test_the_share_of_friction_is_one_at_the_onset():
    # a friction coefficient taken for its angle
    right = share_of_friction().axes[1]
    (curve,) = curves(right, BLUE)
    assert curve.get_ydata().max() == pytest.approx(1.0, abs=1e-4)  # on a grid of half a degree
    assert onset_ratio(FRICTION_ANGLE) == pytest.approx(math.tan(math.radians(51)) ** 2, rel=1e-12)


@pytest.mark.parametrize("limit", LIMITS, ids=lambda limit: limit.name)
def test_distances_fall_with_the_derived_power(limit):
    # 5/6 at the onset of sliding; a limit that is not the limit leaves a distance that stays
    assert all(later < earlier for earlier, later in itertools.pairwise(distances(limit)))
    close = (2.0**-36, 2.0**-42)
    far, near = distances(limit, close)
    power = math.log(far / near) / math.log(close[0] / close[1])
    assert power == pytest.approx(limit.power, abs=0.01)  # at the onset the next order is 1, 1/6 beside the first


def test_small_grains_are_many():
    # densities exchanged, or not divided by the volume of a grain
    axes = sizes_by_number(CURVE).axes[0]
    (weighed,), (counted,) = curves(axes, BLUE), curves(axes, VERMILION)
    assert np.all(counted.get_ydata()[1:-1] >= weighed.get_ydata()[1:-1])
    share = np.interp(0.2, counted.get_xdata(), counted.get_ydata())
    # by the definition (12): the integral of f/d^3 below a size over the whole one
    assert share == pytest.approx(100 * expected_share(2e-4), abs=0.5)  # sums over 800 strips


def expected_share(size):
    fine, coarse = (np.linspace(low, high, 20001) for low, high in ((1e-4, size), (size, 4e-4)))
    below, above = (np.trapezoid(CURVE.density_by_volume(part) / part**3, part) for part in (fine, coarse))
    return below / (below + above)


def test_young_modulus_is_that_of_table_ii():
    # a case drawn under another number: case 2 alone has one length of branches and is stiffest along axis 3
    axes = pulled_along().axes[0]
    (second,) = curves(axes, BLUE)
    assert second.get_ydata()[0] > 1 > second.get_ydata()[-1]
    for colour in (VERMILION, GREEN):
        (curve,) = curves(axes, colour)
        assert curve.get_ydata()[0] < 1 < curve.get_ydata()[-1]
