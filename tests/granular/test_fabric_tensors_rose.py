"""Rose diagrams: bins that add up, curves that are means of the density, and the rules that all figures keep."""

from __future__ import annotations

import importlib.util
from pathlib import Path

import numpy as np
import pytest
from matplotlib.colors import to_hex

from granular.errors import DirectionNotUnit
from granular.fabric_tensors import density, directions_of, fabric_of
from granular.fabric_tensors.frames import frame_about
from granular.fabric_tensors.rose import by_angle, by_azimuth, mean_by_angle, mean_by_azimuth
from granular.fabric_tensors.sampling import axial_tensors, isotropic, tensors_of
from granular.figures import files
from granular.figures.fabric_rose import rose
from granular.figures.look import VERMILION

spec = importlib.util.spec_from_file_location("figure_rules", Path(__file__).with_name("test_figures.py"))
rules = importlib.util.module_from_spec(spec)
spec.loader.exec_module(rules)
test_no_text_is_small = rules.test_no_text_is_small
test_no_text_is_cut_or_overlaps = rules.test_no_text_is_cut_or_overlaps
test_every_axis_names_its_unit = rules.test_every_axis_names_its_unit

TILTED = tensors_of(np.diag([-0.5, 0.1, 0.4]), axial_tensors(0.0, 0.3, axis=(1, 2, 2)).D4)
AXIS = (1.0, -1.0, 0.5)
DRAWN = {"few": lambda: rose(directions_of(isotropic(), 40)),
         "many": lambda: rose(directions_of(axial_tensors(1.2, 0.5), 5000)),
         "about another axis": lambda: rose(directions_of(TILTED, 300), np.linspace(0, 1, 300), axis=AXIS),
         "one direction": lambda: rose([[0, 0, 1]])}


@pytest.fixture(scope="module", params=DRAWN)
def drawn(request):
    figure = DRAWN[request.param]()
    files.static_bytes(figure, "svg")  # settles the layout
    figure.draw_without_rendering()
    return figure


@pytest.mark.parametrize("axis", [(0.0, 0.0, 1.0), AXIS])
def test_bins_hold_every_direction(axis):
    # a direction on an edge that is lost, or bins of the wrong solid angle
    n = np.concatenate([directions_of(TILTED, 300), np.eye(3), frame_about(np.array(axis) / np.linalg.norm(axis))])
    angle, azimuth = by_angle(n, axis=axis), by_azimuth(n, axis=axis)
    assert angle.density @ -np.diff(np.cos(angle.edges)) == pytest.approx(1, rel=1e-13)
    assert azimuth.density.mean() == pytest.approx(1, rel=1e-13)


@pytest.mark.parametrize("axis", [(0.0, 0.0, 1.0), AXIS])
@pytest.mark.parametrize("bins", [by_angle, by_azimuth])
def test_bins_scatter_about_the_curves(bins, axis):
    # a curve about another axis, counted from another azimuth, or errors of another size
    found = bins(directions_of(TILTED, 100_000, seed=2), axis=axis)
    fine = found.edges[:-1, None] + np.diff(found.edges)[:, None] * (np.arange(20) + 0.5) / 20
    if bins is by_angle:
        share = np.sin(fine) / np.sin(fine).sum(axis=1, keepdims=True)
        curve = (mean_by_angle(TILTED, np.cos(fine.ravel()), axis=axis).reshape(fine.shape) * share).sum(axis=1)
    else:
        curve = mean_by_azimuth(TILTED, fine.ravel(), axis=axis).reshape(fine.shape).mean(axis=1)
    deviation = (found.density - curve) / found.error
    # a dozen normal numbers; 3.5 standard deviations are passed by one such list in 200
    assert abs(deviation).max() < 3.5
    assert 0.4 < np.sqrt(np.mean(deviation**2)) < 1.6


def test_curves_are_means_of_the_density():
    # quadrature that is not exact: plain means over fine grids, second order in their step
    frame = frame_about(np.array(AXIS) / np.linalg.norm(AXIS))
    turn, cosine = 2 * np.pi * np.arange(16) / 16, (np.arange(2000) + 0.5) / 1000 - 1
    for rank in (0, 2, 4):
        for x in (0.0, 0.3, 1.0):
            ring = np.stack([np.sqrt(1 - x**2) * np.cos(turn), np.sqrt(1 - x**2) * np.sin(turn), x + 0 * turn], axis=1)
            assert mean_by_angle(TILTED, np.array([x]), axis=AXIS, rank=rank)[0] == pytest.approx(
                density(TILTED, ring @ frame, rank=rank).mean(), abs=1e-12)
        for angle in (0.0, 1.0, 2.5):
            across = np.sqrt(1 - cosine**2)
            arc = np.stack([across * np.cos(angle), across * np.sin(angle), cosine], axis=1)
            assert mean_by_azimuth(TILTED, np.array([angle]), axis=AXIS, rank=rank)[0] == pytest.approx(
                density(TILTED, arc @ frame, rank=rank).mean(), abs=1e-5)


def test_weights_enter_bins_and_errors():
    # weights left out of either
    n = directions_of(TILTED, 200)
    doubled, weighted = by_angle(np.repeat(n, 2, axis=0)), by_angle(n, np.full(200, 2.0))
    assert weighted.density == pytest.approx(doubled.density, rel=1e-13)
    assert weighted.error == pytest.approx(np.sqrt(2) * doubled.error, rel=1e-12)


def test_the_curve_in_the_figure_is_the_implied_density():
    # horizontal and vertical exchanged: the density along axis 3 stands at the top of the left panel
    n = directions_of(axial_tensors(1.0), 2000)
    figure = rose(n)
    curve = next(line for line in figure.axes[0].lines if to_hex(line.get_color()) == VERMILION)
    top = curve.get_ydata().max()
    assert top == pytest.approx(mean_by_angle(fabric_of(n), np.array([1.0]))[0], rel=1e-12)
    assert curve.get_xdata()[np.argmax(curve.get_ydata())] == pytest.approx(0, abs=1e-12)


def test_bad_lists_are_refused():
    # a rose of lengths
    with pytest.raises(DirectionNotUnit):
        rose([[0, 0, 2]])
