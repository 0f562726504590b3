"""Figures of contact forces: the right numbers at points that can be computed by hand."""

import math
from fractions import Fraction

import numpy as np
import pytest

import granular
from granular import figures
from granular.fabric import AxialFabric
from granular.figures.by_direction import by_direction, limits
from granular.figures.cones import band
from granular.figures.contacts import contacts_figure, contacts_of, forces_figure, loading_of
from granular.figures.contacts_interactive import contacts_interactive, forces_interactive
from granular.figures.look import BLUE, VERMILION
from granular.loading import Loading

MU = math.tan(math.radians(12))
TWO = Loading.of_ratio(2.0, friction=MU)


def scene(stress, **grains):
    return granular.Scene.model_validate({
        "grains": {"shear_modulus": "31 GPa", "poisson_ratio": 0.21, **grains},
        "packing": {"void_ratio": 0.5744}, "stress": stress})


def curve(axes, colour):
    return next(line for line in axes.lines if line.get_color() == colour and len(line.get_xdata()) > 2)


def test_the_sliding_range_at_stress_ratio_two():
    # the range published with the model, 0.22996 < x < 0.90412: a wrong root or angles from the horizontal
    low, high = limits(0.0, TWO).sliding
    assert math.cos(math.radians(low)) == pytest.approx(0.90412, abs=5e-6)
    assert math.cos(math.radians(high)) == pytest.approx(0.22996, abs=5e-6)


@pytest.mark.parametrize(("loading", "sliding", "opened"), [
    (Loading.of_ratio(4.0, friction=0.75), None, None),  # exact tangency: 3^2 = 4 * 4 * 0.75^2
    (Loading.of_ratio(9.0), None, None),
    (Loading.of_ratio(1.5, friction=0.0), (0, 90), None),
    (Loading.of_ratio(0.0, friction=1.0), (0, 45), None),
    (Loading(sigma11=Fraction(0), sigma33=Fraction(1), friction=1.0), (45, 90), None),
    (Loading.of_ratio(-1.0, friction=1.0), (45, 67.5), (0, 45)),
    (Loading(sigma11=Fraction(-1), sigma33=Fraction(3), friction=0.0), (0, 60), (60, 90)),
    (Loading(sigma11=Fraction(-1), sigma33=Fraction(3)), None, (60, 90)),
])  # fmt: skip
def test_where_contacts_slide_and_open(loading, sliding, opened):
    # pole and equator exchanged, tension taken for sliding, or tangency for a range
    found = limits(0.0, loading)
    for pair, wanted in ((found.sliding, sliding), (found.opened, opened)):
        # 1e-12 degrees: a few roundings of an angle below 90
        assert pair == wanted if wanted is None else pair == pytest.approx(wanted, abs=1e-12)


def test_shear_stiffness_vanishes_exactly_where_the_range_says():
    # a shaded range that does not fit its curve
    contacts = by_direction(AxialFabric(0.3, 0.0, -0.3), TWO, poisson_ratio=0.21)
    low, high = contacts.limits.sliding
    assert {low, high} <= set(contacts.degrees)
    inside = (contacts.degrees > low + 1e-6) & (contacts.degrees < high - 1e-6)
    outside = (contacts.degrees < low - 1e-6) | (contacts.degrees > high + 1e-6)
    assert (contacts.k_shear[inside] == 0).all()
    assert (contacts.k_shear[outside] > 0).all()
    # closely enough spaced: no step of the curve is taller than a tenth of it
    assert np.abs(np.diff(contacts.k_shear)).max() < 0.1


def test_a_scene_gives_its_loading():
    # friction lost, an angle taken for a coefficient, or mean and ratio exchanged with the tensor
    by_angle = loading_of(scene({"mean": "28 kPa", "ratio": 2}, friction_angle="12 deg"))
    assert by_angle.friction == pytest.approx(MU, rel=1e-15)
    assert by_angle.sigma33 == 2 * by_angle.sigma11
    assert loading_of(scene({"mean": "28 kPa"}, friction_coefficient=0.5)).friction == 0.5
    assert loading_of(scene({"mean": "28 kPa"})).friction is None
    tensor = loading_of(scene({"tensor": [[1e5, 0, 0], [0, 1e5, 0], [0, 0, 3e5]]}))
    assert tensor.sigma33 / tensor.sigma11 == 3


def test_curves_of_forces_and_stiffnesses():
    # curves exchanged, the sliding limit forgotten, or another unit
    contacts = contacts_of(scene({"mean": "28 kPa", "ratio": 2}, friction_angle="12 deg"))
    above, below = forces_figure(contacts).axes
    assert curve(above, BLUE).get_ydata()[[0, -1]].tolist() == pytest.approx([1.5, 0.75])
    assert curve(below, VERMILION).get_ydata().max() == pytest.approx(0.375)
    assert any(line.get_ydata()[0] == pytest.approx(1.5 * MU) for line in below.lines)
    axes = contacts_figure(contacts, poisson_ratio=0.21).axes[0]
    assert curve(axes, BLUE).get_ydata()[[0, -1]].tolist() == pytest.approx([1.5 ** (1 / 3), 0.75 ** (1 / 3)])
    assert curve(axes, VERMILION).get_ydata()[[0, -1]].tolist() == pytest.approx(
        [158 / 179 * 1.5 ** (1 / 3), 158 / 179 * 0.75 ** (1 / 3)])
    assert {line.get_ydata()[0] for line in axes.lines if line.get_linestyle() == ":"} == {1.0, 2 * 0.79 / 1.79}


def test_equal_contacts_give_flat_curves(tmp_path):
    # a figure that fails, or shows rounding, when all contacts carry the same
    contacts = contacts_of(scene({"mean": "28 kPa"}))
    assert set(contacts.normal) == {1.0}
    assert set(contacts.shear) == {0.0}
    assert contacts.limit is None
    for what in ("forces", "contacts"):
        assert figures.save(scene({"mean": "28 kPa"}), what=what, out=tmp_path / f"{what}.svg").exists()


@pytest.mark.parametrize("make", [forces_interactive, contacts_interactive])
def test_the_pointer_reads_all_four_values(make):
    # values under a wrong name, or the band of sliding missing from the sphere
    figure = make(AxialFabric(), TWO, poisson_ratio=0.21)
    assert figure.data[0].x[0] == 0
    wanted = [1.5, 0, round(1.5 ** (1 / 3), 4), round(158 / 179 * 1.5 ** (1 / 3), 4)]
    assert list(figure.data[0].customdata[0]) == wanted
    (sliding,) = [trace for trace in figure.data if trace.name == "sliding"]
    radius = np.linalg.norm([sliding.x[0][0], sliding.y[0][0], sliding.z[0][0]])
    assert sliding.z[0][0] / radius == pytest.approx(0.90412, abs=2e-3)  # coordinates have three decimals


def test_a_band_lies_on_the_sphere_between_its_cones_on_both_sides():
    # one half missing, or a band that leaves the sphere
    x, y, z = band((25.0, 76.0), 2.0)
    assert np.isnan(z).all(axis=1).sum() == 1
    radius = np.sqrt(x**2 + y**2 + z**2)
    np.testing.assert_allclose(radius[~np.isnan(radius)], 2.0, atol=1e-3)
    assert np.nanmax(z) == pytest.approx(2 * math.cos(math.radians(25)), abs=5e-4)
    assert np.nanmin(np.abs(z)) == pytest.approx(2 * math.cos(math.radians(76)), abs=5e-4)
    assert np.nanmin(z) == -np.nanmax(z)
