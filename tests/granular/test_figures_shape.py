"""Figures of grain shape: true branches in scenes of spheroids, geometry of a contact, and the rules of all figures."""

import importlib.util
import math
import re
from pathlib import Path

import numpy as np
import pytest
from matplotlib.colors import to_hex
from matplotlib.patches import Ellipse

import granular
from granular import figures
from granular.collinear import collinear_error, collinear_ratios, true_ratios
from granular.fabric import AxialFabric
from granular.figures import files
from granular.figures.by_direction import by_direction
from granular.figures.collinear_curves import STYLES, collinear_anisotropy, collinear_errors, spin_and_shear
from granular.figures.contacts_interactive import forces_interactive
from granular.figures.fabric import fabric_figure, fabric_interactive
from granular.figures.look import BLUE, INK, VERMILION
from granular.figures.spheroid_contact import ANGLE, ASPECT_RATIO, touching_spheroids
from granular.figures.spheroid_surfaces import branch_surfaces
from granular.figures.waves import waves_figure
from granular.hypothesis import Hypothesis
from granular.loading import Loading
from granular.spheroid import branch_vectors

spec = importlib.util.spec_from_file_location("figure_rules", Path(__file__).with_name("test_figures.py"))
rules = importlib.util.module_from_spec(spec)
spec.loader.exec_module(rules)
test_no_text_is_small = rules.test_no_text_is_small
test_no_text_is_cut_or_overlaps = rules.test_no_text_is_cut_or_overlaps
test_every_axis_names_its_unit = rules.test_every_axis_names_its_unit

PAGE = {draw.__name__: draw for draw in (branch_surfaces, touching_spheroids, collinear_anisotropy, collinear_errors,
                                         spin_and_shear)}
DRAWN = {**PAGE, "flat grains": lambda: fabric_figure(AxialFabric(0.3, aspect_ratio=0.5)),
         "long grains": lambda: fabric_figure(AxialFabric(-0.3, aspect_ratio=4.0)),
         "discs": lambda: fabric_figure(AxialFabric(aspect_ratio=1e-4))}

SCENES = {name: granular.Scene.model_validate({
    "grains": {"shear_modulus": "31 GPa", "poisson_ratio": 0.21, "friction_angle": "12 deg", "density": "2650 kg/m^3"},
    "packing": {"void_ratio": 0.5744, "contact_normals": {"D33": 0.3}}, "stress": {"mean": "28 kPa", "ratio": 2.0},
    **more}) for name, more in {
        "flat": {"shape": {"aspect_ratio": 0.6}},
        "long, free and graded": {
            "shape": {"aspect_ratio": 3.0, "spin": "relaxed"},
            "gradation": {"distribution": "lognormal", "median": "5 mm", "spread": 1.5}}}.items()}


@pytest.fixture(scope="module", autouse=True)
def coarse_surfaces():
    # fewer faces, the same outlines: drawing those of a printed surface takes seconds, and no test looks at them
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("granular.figures.spheroid_surfaces.IN_PRINT", (19, 13))
        yield


@pytest.fixture(scope="module", params=DRAWN)
def drawn(request, coarse_surfaces):
    figure = DRAWN[request.param]()
    files.static_bytes(figure, "svg")  # settles the layout
    figure.draw_without_rendering()
    return figure


def curve(axes, colour):
    return next(line for line in axes.lines if to_hex(line.get_color()) == colour and len(line.get_xdata()) > 2)


@pytest.mark.parametrize("suffix", [".svg", ".png", ".html"])
@pytest.mark.parametrize("what", figures.SCENE_FIGURES)
@pytest.mark.parametrize("name", SCENES)
def test_scenes_with_shape_and_gradation_have_every_figure(name, what, suffix, tmp_path):
    # a figure that knows nothing of a table of the scene
    assert figures.save(SCENES[name], what=what, out=tmp_path / f"a{suffix}").stat().st_size > 5000


@pytest.mark.parametrize("shape", [0.5, 3.0])
def test_the_fabric_of_spheroids_is_that_of_their_branches(shape):
    # a circle of W = 1, or lengths over the direction of the branch in place of the normal
    figure = fabric_figure(AxialFabric(0.3, aspect_ratio=shape))
    x, z = curve(figure.axes[0], VERMILION).get_data()
    across, along = np.abs(x).max(), np.abs(z)[0]
    assert along == pytest.approx(shape ** (2 / 3), rel=1e-12)  # b/r_e
    if shape < 1:  # otherwise the section is widest elsewhere
        assert across == pytest.approx(shape ** (-1 / 3), rel=1e-12)  # a/r_e
    angle = np.arctan2(x, z)
    length = np.linalg.norm(branch_vectors(shape, np.stack([np.sin(angle), 0 * angle, np.cos(angle)])), axis=0)
    np.testing.assert_allclose(np.hypot(x, z), length, rtol=1e-12)


def test_the_fabric_names_what_it_shows():
    # W over a surface that is no weight
    words = {text.get_text() for text in fabric_figure(AxialFabric(aspect_ratio=0.5)).axes[0].texts}
    assert any("ell" in word for word in words)
    assert "$W$" not in words
    assert [trace.name for trace in fabric_interactive(AxialFabric(aspect_ratio=0.5)).data[:2]] == ["4πE", "|ℓ|/2rₑ"]
    assert fabric_interactive(AxialFabric(Dr33=0.5)).data[1].name == "W"


@pytest.mark.parametrize("shape", [0.5, 3.0])
def test_forces_of_spheroids_fall_with_the_length_of_their_branches(shape):
    # forces as if all branches were of one length: under isotropic stress on isotropic normals f |l| is the same
    fabric, loading = AxialFabric(aspect_ratio=shape), Loading.of_ratio(1.0)
    contacts = by_direction(fabric, loading, poisson_ratio=0.21)
    assert contacts.normal[0] == pytest.approx(shape ** (-2 / 3), rel=1e-12)
    assert contacts.normal[-1] == pytest.approx(shape ** (1 / 3), rel=1e-12)
    np.testing.assert_allclose(contacts.k_normal, 1, rtol=1e-12)
    surface = next(trace for trace in forces_interactive(fabric, loading, poisson_ratio=0.21).data
                   if trace.type == "surface")
    assert float(np.max(surface.z)) == pytest.approx(shape ** (-2 / 3), abs=1e-4)


def test_no_wave_has_a_negative_speed():
    # an axis below zero where P spans much and S little
    figure = waves_figure(granular.evaluate(SCENES["long, free and graded"]).waves)
    for axes in figure.axes:
        assert axes.get_ylim()[0] >= 0


def test_the_two_grains_touch_once_with_the_normal_that_is_drawn():
    # outlines that overlap or leave a gap, or an arrow that is not normal to them
    section = touching_spheroids().axes[0]
    outlines = [patch for patch in section.patches if isinstance(patch, Ellipse) and type(patch) is Ellipse]
    first, second = (next(patch for patch in outlines if np.allclose(patch.center, centre))
                     for centre in {tuple(np.round(patch.center, 12)) for patch in outlines})
    assert first.width / first.height == pytest.approx(1 / ASPECT_RATIO)
    apart = np.subtract(second.center, first.center) / [first.width, first.height]
    assert np.hypot(*apart) == pytest.approx(1, rel=1e-12)  # stretched to circles, centres lie one diameter apart
    gradient = apart / [first.width, first.height]  # of the outline where they touch
    assert abs(math.degrees(math.atan2(abs(gradient[0]), abs(gradient[1])))) == pytest.approx(ANGLE, rel=1e-12)
    assert any(re.fullmatch(r"31°", text.get_text()) for text in section.texts)  # atan(1/4) from the horizontal


def test_curves_of_anisotropy_stand_under_their_colours():
    # an assumption under the name of another
    above, below = collinear_anisotropy(), collinear_errors()
    for place in (0, 1):
        shapes, true = curve(above.axes[place], BLUE).get_data()
        assert true[0] == true_ratios(float(shapes[0]))[place]
        for name, (colour, _, _) in STYLES.items():
            assert curve(above.axes[place], colour).get_ydata()[-1] == collinear_ratios(name, float(shapes[-1]))[place]
            assert curve(below.axes[place], colour).get_ydata()[-1] == collinear_error(name, float(shapes[-1]))[place]


def test_static_shear_is_drawn_over_free_spin():
    # the static curve under the name of another
    axes = spin_and_shear().axes[0]
    shapes = curve(axes, BLUE).get_xdata()
    for colour, options in ((BLUE, {}), (VERMILION, {"free_spin": True}), (INK, {"hypothesis": Hypothesis.STATIC})):
        assert curve(axes, colour).get_ydata()[0] == true_ratios(float(shapes[0]), **options).shear


def test_pages_show_them():
    # a page object that shows another figure
    for name in PAGE:
        if name != "branch_surfaces":  # drawn above, and drawing a surface takes a second
            assert getattr(figures, name)()._repr_svg_().startswith("<?xml")
