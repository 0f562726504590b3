"""Figures of scenes without an axis: the numbers of the library, in the right place of the sphere, legible."""

import sys
from pathlib import Path

import numpy as np
import pytest

import granular
from granular import figures
from granular.contact_distribution import normal_force, shear_force
from granular.directions import relative_density
from granular.elasticity import Stiffness
from granular.errors import FigureNotKnown, MissingKey
from granular.fabric import AxialFabric
from granular.figures import files
from granular.figures.general_scene import (
    contacts_picture,
    extremes,
    fabric_picture,
    forces_picture,
    stiffness_picture,
)
from granular.figures.general_waves import general_waves_figure, splitting_of, waves_picture
from granular.figures.hemisphere import half_sphere, principal, projected
from granular.figures.over_sphere import PLANES, sphere_figure
from granular.figures.over_sphere_interactive import sphere_interactive
from granular.figures.surfaces import TO_TURN
from granular.figures.without_axis import FIGURES
from granular.general import GeneralFabric, GeneralLoading, general_waves
from granular.general.engineering import along
from granular.general.fabric import spread_directions
from granular.general.loading import contact_stiffness
from granular.loading import Loading
from granular.waves import phase_velocities

sys.path.insert(0, str(Path(__file__).parents[1]))
from general_fabrics import general_fabric, rotation, traceless
from general_solids import solid
from legible import require_large_words, require_more_than_colour, require_units, require_words_apart

FABRIC = general_fabric(3, branches=0.3)
SHEARED = GeneralLoading([[1.0, 0.25, 0.1], [0.25, 1.2, 0.2], [0.1, 0.2, 2.0]], 0.3)
PULLED = GeneralLoading([[-0.3, 0.25, 0.1], [0.25, 1.2, 0.2], [0.1, 0.2, 2.0]], 0.3)
SOLID = solid(4).scaled(1e8)
WAVES = general_waves(SOLID, density=1600.0)
ISOTROPIC = Stiffness.transversely_isotropic(3e8, 3e8, 1e8, 1e8, 1e8, 1e8)
DRAWN = {
    "fabric": lambda: sphere_figure(fabric_picture(FABRIC)),
    "isotropic fabric": lambda: sphere_figure(fabric_picture(GeneralFabric())),
    "opened forces": lambda: sphere_figure(forces_picture(FABRIC, PULLED)),
    "sliding contacts": lambda: sphere_figure(contacts_picture(FABRIC, SHEARED, poisson_ratio=0.2)),
    "stiffness": lambda: sphere_figure(stiffness_picture(SOLID)),
    "waves": lambda: general_waves_figure(WAVES),
}
TILTED = {
    "grains": {"shear_modulus": "31 GPa", "poisson_ratio": 0.21, "density": "2650 kg/m^3", "friction_coefficient": 0.3},
    "packing": {"void_ratio": 0.5744, "contact_normals": {
        "tensor": [[0.2, 0.0, 0.1], [0.0, -0.1, 0.0], [0.1, 0.0, -0.1]]}},
    "stress": {"tensor": [["20 kPa", "0 kPa", "0 kPa"], ["0 kPa", "25 kPa", "0 kPa"], ["0 kPa", "0 kPa", "39 kPa"]]},
    "model": {"effects": ["packing"]}}


@pytest.fixture(scope="module", params=DRAWN)
def drawn(request):
    figure = DRAWN[request.param]()
    figure.draw_without_rendering()
    return figure


def test_every_word_is_legible(drawn):
    # text too small, cut or covered, or a number without its unit
    require_large_words(drawn)


def test_curves_differ_by_more_than_colour(drawn):
    # curves that are one in grey print, or to a reader who sees no red
    require_more_than_colour(drawn)
    require_words_apart(drawn)
    require_units(drawn)


def test_a_figure_drawn_twice_is_the_same_file():
    # a hatch or a name that differs from run to run
    first, second = (files.static_bytes(sphere_figure(forces_picture(FABRIC, PULLED)), "svg") for _ in range(2))
    assert first == second


def test_the_projection_keeps_areas():
    # the stereographic net, or axes 1 and 2 exchanged: a cap to n_3 = z has the share 1 - z of the half sphere, and
    # must have that share of the disc
    n = half_sphere()
    x, y = projected(n)
    np.testing.assert_allclose(x**2 + y**2, 1 - n[2], atol=1e-15)
    np.testing.assert_allclose(np.arctan2(y, x)[:, 1:], np.arctan2(n[1], n[0])[:, 1:], atol=1e-14)


@pytest.mark.parametrize("seed", range(3))
def test_principal_directions(seed):
    # the least direction marked as the greatest, or a mark where every direction of a plane would do
    turn = rotation(seed)
    three = principal(turn @ np.diag([3.0, 1.0, 2.0]) @ turn.T)
    assert [mark.rank for mark in three] == ["greatest", "middle", "least"]
    for mark, axis in zip(three, turn.T[[0, 2, 1]], strict=True):
        assert abs(axis @ mark.direction) == pytest.approx(1, rel=1e-14)
    assert [mark.rank for mark in principal(turn @ np.diag([1.0, 1.0, 2.0]) @ turn.T)] == ["greatest"]
    assert [mark.rank for mark in principal(turn @ np.diag([2.0, 1.0, 2.0]) @ turn.T)] == ["least"]
    assert principal(np.eye(3)) == ()
    assert extremes(lambda n: np.ones(n.shape[1])) == ()


def test_marks_stand_at_the_extremes_of_the_colours():
    # a mark mirrored through the centre of the map, or in another frame: without rank four the density is greatest
    # along the principal direction of the greatest value
    picture = fabric_picture(GeneralFabric(traceless(0.5, 5)))
    n = spread_directions(3000)
    best = {mark.rank: mark.direction for mark in picture.maps[0].marks}
    values = picture.maps[0].quantity.values(n)
    for rank, place in (("greatest", values.argmax()), ("least", values.argmin())):
        assert abs(n[:, place] @ best[rank]) > 0.998  # 3000 directions are 2.6 degrees apart
    young = stiffness_picture(SOLID).maps[0]
    for mark, place in zip(young.marks, (young.quantity.values(n).argmax(), young.quantity.values(n).argmin()),
                           strict=True):
        assert abs(n[:, place] @ mark.direction) > 0.998


def test_roses_lie_in_their_planes():
    # planes exchanged, or the second axis drawn to the right
    figure = sphere_figure(fabric_picture(FABRIC))
    D, panels = np.array(FABRIC.D), [axes for axes in figure.axes if axes.get_xlabel().startswith("axis")]
    assert [(axes.get_xlabel()[:6], axes.get_ylabel()[:6]) for axes in panels] == [
        ("axis 1", "axis 2"), ("axis 1", "axis 3"), ("axis 2", "axis 3")]
    for axes, plane in zip(panels, PLANES, strict=True):
        x, y = axes.lines[1].get_data()
        for place, component in ((0, x[0]), (1, y[180])):  # along the first axis, and a quarter turn later
            n = np.eye(3)[:, [plane[place]]]
            assert component == pytest.approx(FABRIC.relative_density(n)[0], rel=1e-14)
    without = sphere_figure(fabric_picture(GeneralFabric(FABRIC.D)))
    x, _ = next(axes for axes in without.axes if axes.get_xlabel().startswith("axis 2")).lines[1].get_data()
    assert x[0] == pytest.approx(1 + D[1, 1], rel=1e-14)


def test_an_axial_scene_keeps_its_numbers():
    # another unit or another sign than in the figures about axis 3
    axial, loading = AxialFabric(D33=0.4), Loading.of_ratio(2.0, friction=0.4)
    fabric = GeneralFabric(np.diag([-0.2, -0.2, 0.4]))
    general = GeneralLoading(np.diag([1.0, 1.0, 2.0]), 0.4)
    n = spread_directions(50)
    density = fabric_picture(fabric).maps[0].quantity.values(n)
    np.testing.assert_allclose(density, relative_density(axial, n[2]), rtol=1e-14)
    normal, shear = (one.quantity.values(n) for one in forces_picture(fabric, general).maps)
    # forces are of order 1, and the shear force a difference of them
    np.testing.assert_allclose(normal, normal_force(axial, loading, n[2]), rtol=1e-14)
    np.testing.assert_allclose(shear, shear_force(axial, loading, n[2]), atol=1e-14)
    body = Stiffness.transversely_isotropic(9e8, 7e8, 3e8, 2e8, 2.5e8, 3e8)
    found = waves_picture(general_waves(body, density=1600.0)).roses[0][0].values(n)
    expected = [phase_velocities(body, density=1600.0, degrees=float(np.degrees(np.arccos(z)))).P for z in n[2]]
    np.testing.assert_allclose(found, expected, rtol=1e-13)


def test_what_slides_is_what_has_no_shear_stiffness():
    # a tint over contacts that stick
    n = spread_directions(2000)
    for loading in (SHEARED, PULLED):
        picture = forces_picture(FABRIC, loading)
        _, shear, _ = contact_stiffness(loading.force_tensor(FABRIC), 0.3, n, 0.2)
        sticks = picture.margin(n) > 0
        np.testing.assert_array_equal(sticks, shear > 0)
        assert 0 < sticks.sum() < n.shape[1]
        used = picture.turned[-1].quantity.values(n)
        assert used.max() == 1
        np.testing.assert_array_equal(used < 1, sticks)
    assert (PULLED.force_tensor(FABRIC) @ n * n).sum(axis=0).min() < 0
    free = forces_picture(FABRIC, GeneralLoading(SHEARED.stress))
    assert free.margin is None
    assert len(free.turned) == 2
    frictionless = forces_picture(FABRIC, GeneralLoading(SHEARED.stress, 0.0))
    assert (frictionless.margin(n) < 0).all()
    assert len(frictionless.turned) == 2


def test_splitting_and_stiffness_in_their_units():
    # a share drawn as per cent, or Pa as MPa
    n = np.array(WAVES.largest_splitting.direction)[:, None]
    assert splitting_of(WAVES, n)[0] == pytest.approx(100 * WAVES.largest_splitting.value, rel=1e-12)
    young, confined = (shown.quantity for shown in stiffness_picture(SOLID).maps)
    assert young.unit == "MPa"
    assert confined.values(np.eye(3)) == pytest.approx(along(SOLID, np.eye(3)) / 1e6, rel=1e-14)
    assert young.values(np.eye(3)) == pytest.approx(1e-6 / along(SOLID.compliance(), np.eye(3)), rel=1e-14)


def test_a_ring_of_extremes_is_not_marked_as_one_direction():
    # the first of a ring that a search meets, shown as if it were the only one
    axial = Stiffness.transversely_isotropic(9e8, 4e8, 3e8, 1e8, 1e8, 3e8).rotated(rotation(4))
    assert [mark.rank for mark in stiffness_picture(axial).maps[1].marks] == []
    upright = Stiffness.transversely_isotropic(4e8, 9e8, 1e8, 1e8, 1.5e8, 1.5e8)
    (mark,) = stiffness_picture(upright).maps[1].marks
    assert (mark.rank, mark.direction) == ("greatest", (0.0, 0.0, 1.0))


def test_equal_speeds_mark_nothing():
    # a direction, or a polarisation, made of rounding
    picture = waves_picture(general_waves(ISOTROPIC, density=1600.0))
    assert [shown.marks for shown in picture.maps] == [(), ()]
    n = spread_directions(500)
    assert not picture.maps[1].quantity.values(n).any()
    equal = forces_picture(GeneralFabric(), GeneralLoading(np.diag([0.3, 0.3, 0.3]), 0.3))
    assert not equal.maps[1].quantity.values(n).any()
    figure = general_waves_figure(general_waves(ISOTROPIC, density=1600.0))
    figure.draw_without_rendering()
    require_words_apart(figure)


def test_surfaces_to_turn():
    # a button that shows another surface or leaves its lines behind, or a pointer that names another direction
    picture = waves_picture(WAVES)
    figure = sphere_interactive(picture)
    surfaces = [trace for trace in figure.data if trace.type == "surface"]
    buttons = figure.layout.updatemenus[0].buttons
    assert [button.label for button in buttons] == ["qP", "qS1", "qS2", "splitting"]
    for number, button in enumerate(buttons):
        change, traces = button.args
        shown = [figure.data[trace] for trace, visible in zip(traces, change["visible"], strict=True) if visible]
        assert [trace.type for trace in shown] == ["surface", *["scatter3d"] * len(picture.turned[number].marks)]
        assert shown[0] is surfaces[number]
    row, column = 11, 8  # of the grid; plotly looks up what the pointer shows as customdata[column][row]
    beta, around = np.pi * row / (TO_TURN[0] - 1), 2 * np.pi * column / (TO_TURN[1] - 1)
    n = np.array([np.sin(beta) * np.cos(around), np.sin(beta) * np.sin(around), np.cos(beta)])
    for surface, shown in zip(surfaces, picture.turned, strict=True):
        value = shown.quantity.values(n[:, None])[0]
        # rounded to four decimals, and colours to single precision
        told = np.array(surface.customdata[column][row])
        np.testing.assert_allclose(told, [value, np.degrees(beta), np.degrees(around)], atol=6e-5)
        assert surface.surfacecolor[row][column] == pytest.approx(value, rel=1e-6)
        point = np.array([surface.x[row][column], surface.y[row][column], surface.z[row][column]])
        np.testing.assert_allclose(point, n * value / np.max(surface.surfacecolor), atol=1e-4)


@pytest.mark.parametrize(("what", "suffix"), [("fabric", ".pdf"), ("forces", ".svg"), ("contacts", ".html"),
                                              ("stiffness", ".html"), ("waves", ".png")])
def test_scenes_without_an_axis_are_drawn(what, suffix, tmp_path):
    # a figure about axis 3, or a refusal, of a scene whose tensors have another frame
    scene = granular.Scene.model_validate(TILTED)
    out = figures.save(scene, what=what, out=tmp_path / f"a{suffix}")
    content = out.read_bytes()
    assert content.startswith({".svg": b"<?xml", ".png": b"\x89PNG", ".pdf": b"%PDF", ".html": b"<!doctype"}[suffix])
    if suffix == ".html":
        assert f'id="plotly-{what}"'.encode() in content
        assert b"azimuth %{customdata[2]}" in content


def test_scenes_with_an_axis_elsewhere_are_drawn_in_their_own_frame():
    # the axis of a lying fabric drawn upright
    along_1 = TILTED | {"packing": {"void_ratio": 0.5744, "contact_normals": {
        "tensor": [[0.4, 0, 0], [0, -0.2, 0], [0, 0, -0.2]]}}, "stress": {"mean": "28 kPa"}}
    scene = granular.Scene.model_validate(along_1)
    assert not scene.axial
    (mark,) = fabric_picture(scene.general_fabric).maps[0].marks
    assert (mark.rank, mark.direction) == ("greatest", (1.0, 0.0, 0.0))


def test_bad_requests_are_refused(tmp_path):
    # a name of one kind of scene that the other does not know, or waves without a mass
    assert FIGURES.keys() == figures.SCENE_FIGURES.keys()
    scene = granular.Scene.model_validate(TILTED)
    with pytest.raises(FigureNotKnown, match="fabric, stiffness, waves, forces, contacts"):
        figures.save(scene, what="force", out=tmp_path / "a.svg")
    light = scene.model_copy(update={"grains": scene.grains.model_copy(update={"density": None})})
    with pytest.raises(MissingKey, match="density"):
        figures.save(light, what="waves", out=tmp_path / "a.svg")
    assert list(tmp_path.iterdir()) == []
