"""Figures: the right numbers, legible, inside their frame, the same bytes every time, and safe to write."""

import errno
import itertools
import json
import re
import subprocess
import sys
from functools import partial
from pathlib import Path
from types import SimpleNamespace

import matplotlib as mpl
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import granular
from granular import figures
from granular.directions import branch_weight
from granular.elasticity import Stiffness
from granular.errors import FigureNotKnown, FigureNotWritten, MissingKey
from granular.fabric import AxialFabric
from granular.figures import files, look
from granular.figures.by_direction import by_direction
from granular.figures.contacts import contacts_figure, forces_figure
from granular.figures.fabric import fabric_figure
from granular.figures.hard_case_plot import hard_cases
from granular.figures.mohr_circle import mohr
from granular.figures.page import Interactive, Static
from granular.figures.paper_figure_5 import SLIDER, figure_5, figure_5_interactive
from granular.figures.paper_figure_6 import figure_6
from granular.figures.paper_figure_7_9 import draw as figure_7_to_9
from granular.figures.region import admissible_region
from granular.figures.slip_stiffness import slip_onset
from granular.figures.stiffness import stiffness_figure
from granular.figures.surfaces import TO_TURN, plotly_surface, surface
from granular.figures.two_hypotheses import hypotheses
from granular.figures.waves import table_ii_waves, waves_figure
from granular.loading import Loading
from granular.waves import waves

sys.path.insert(0, str(Path(__file__).parents[1]))
from legible import require_large_words, require_more_than_colour, require_units, require_words_apart

patient = settings(deadline=None)  # a time limit would be a verdict on a busy machine
SCENE = granular.Scene.model_validate({
    "grains": {"shear_modulus": "31 GPa", "poisson_ratio": 0.21, "density": "2650 kg/m^3"},
    "packing": {"void_ratio": 0.5744, "contact_normals": {"D33": 0.3}},
    "branches": {"anisotropy": {"D33": -0.3}}, "stress": {"mean": "28 kPa"},
    "model": {"effects": ["packing", "branches"]}})
ISOTROPIC = Stiffness.transversely_isotropic(3e8, 3e8, 1e8, 1e8, 1e8, 1e8)
MAGIC = {".svg": b"<?xml", ".png": b"\x89PNG", ".pdf": b"%PDF", ".html": b"<!doctype html>"}
STICKING, SLIDING, OPENED = (by_direction(AxialFabric(0.3, 0.0, -0.3), loading, poisson_ratio=0.21) for loading in (
    Loading.of_ratio(1.0), Loading.of_ratio(2.5, friction=0.2), Loading.of_ratio(-0.3, friction=0.2)))
HARD = [SimpleNamespace(name=name, naive_label="a formula of the textbook", naive_error=naive, stable_error=stable)
        for name, naive, stable in (("a case with a name so long that it has to be broken", np.inf, 2e-16),
                                    ("no number", np.nan, 0.0), ("far off", 4e7, 1e-16), ("lost", 1e-3, 1.0))]
DRAWN = {
    "figure 5": figure_5, "figure 6": figure_6, "region": admissible_region, "table II waves": table_ii_waves,
    "against Dr33": hypotheses, "against D33": lambda: hypotheses("D33"),
    **{f"figure {number}": partial(figure_7_to_9, number) for number in (7, 8, 9)}, "mohr": mohr,
    "slip onset": slip_onset, "hard cases": lambda: hard_cases(HARD),
    "fabric": lambda: fabric_figure(AxialFabric(0.3, 0.1, -0.6)),
    "tall fabric": lambda: fabric_figure(AxialFabric(2.0, 0.0, 1.9)),
    "flat fabric": lambda: fabric_figure(AxialFabric(-1.0, 0.0, -0.99)),
    "stiffness": lambda: stiffness_figure(granular.evaluate(SCENE).stiffness),
    "isotropic stiffness": lambda: stiffness_figure(ISOTROPIC),
    **{f"{kind} forces": partial(forces_figure, contacts) for kind, contacts in (
        ("sticking", STICKING), ("sliding", SLIDING), ("opened", OPENED))},
    **{f"{kind} contacts": partial(contacts_figure, contacts, poisson_ratio=0.21) for kind, contacts in (
        ("sticking", STICKING), ("sliding", SLIDING), ("opened", OPENED))},
    "isotropic waves": lambda: waves_figure(waves(ISOTROPIC, density=1600.0)),
}


@pytest.fixture(scope="module", autouse=True)
def coarse_surfaces():
    # fewer faces, the same outlines: drawing those of a printed surface takes seconds, and no test looks at them
    with pytest.MonkeyPatch.context() as patch:
        for module in ("fabric", "paper_figure_5", "stiffness"):
            patch.setattr(f"granular.figures.{module}.IN_PRINT", (19, 13))
        yield


@pytest.fixture(scope="module", params=DRAWN)
def drawn(request, coarse_surfaces):
    figure = DRAWN[request.param]()
    figure.first_svg = files.static_bytes(figure, "svg")  # settles the layout
    figure.draw_without_rendering()  # places the labels for the resolution that boxes are measured in
    return figure


def test_no_text_is_small(drawn):
    # text that cannot be read on the page, at the width of the book's column
    require_large_words(drawn)


def test_curves_differ_by_more_than_colour(drawn):
    # curves that are one in grey print, or to a reader who sees no red
    require_more_than_colour(drawn)


def test_no_text_is_cut_or_overlaps(drawn):
    # a label that leaves the figure or covers another one
    require_words_apart(drawn)


def test_every_axis_names_its_unit(drawn):
    # a number without its unit
    require_units(drawn)


def test_a_figure_drawn_twice_is_the_same_file(drawn, request):
    # a date, a random name or a layout that moves: the book would differ from build to build
    again = DRAWN[request.node.callspec.params["drawn"]]()
    assert files.static_bytes(again, "svg") == drawn.first_svg


def test_the_readers_settings_neither_show_nor_change():
    # a figure in the look of someone's matplotlibrc, or settings left behind in their session
    plain = figures.table_ii_waves()._repr_svg_()
    with mpl.rc_context({"font.size": 30, "lines.linewidth": 9, "svg.hashsalt": "other"}):
        before = dict(mpl.rcParams)
        assert figures.table_ii_waves()._repr_svg_() == plain
        assert dict(mpl.rcParams) == before


@pytest.mark.parametrize("suffix", MAGIC)
@pytest.mark.parametrize("what", figures.SCENE_FIGURES)
def test_save_writes_every_figure_in_every_format(what, suffix, tmp_path):
    # a format under the wrong name, a second run that differs, or a leftover beside the file
    first, second = tmp_path / f"a{suffix}", tmp_path / f"b{suffix.upper()}"
    assert figures.save(SCENE, what=what, out=first) == first
    assert first.read_bytes().startswith(MAGIC[suffix])
    assert list(tmp_path.iterdir()) == [first]
    if what == "waves" or suffix == ".html":  # the others are drawn twice above, and drawing a surface takes a second
        figures.save(SCENE, what=what, out=str(second))
        assert first.read_bytes() == second.read_bytes()


@pytest.mark.parametrize("what", figures.SCENE_FIGURES)
def test_an_interactive_file_needs_no_network(what, tmp_path):
    # a page that is empty without the internet, or has a button that sends the data away
    text = figures.save(SCENE, what=what, out=tmp_path / "page.html").read_text(encoding="utf-8")
    assert not re.search(r"<(?:script|link|img)[^>]+(?:src|href)=", text)
    assert "plotly.js v" in text
    assert f'id="plotly-{what}"' in text
    options = text[text.rindex('"displaylogo"'):]
    assert '"sendChartToCloud"' in options[options.index("modeBarButtonsToRemove"):]


@pytest.mark.parametrize(("what", "out", "error", "message"), [
    ("force", "a.svg", FigureNotKnown, "fabric, stiffness, waves, forces, contacts."),
    ("fabric", "a.jpeg", FigureNotKnown, ".svg, .png, .pdf, .html"),
    ("fabric", "a", FigureNotKnown, ".svg"),
    ("fabric", "missing/a.svg", FigureNotWritten, "existing folder"),
    ("fabric", "folder.svg", FigureNotWritten, "this is a folder"),
    ("waves", "a.svg", MissingKey, "density"),
])  # fmt: skip
def test_bad_requests_write_nothing(what, out, error, message, tmp_path):
    # a wrong format written under the wanted name, or an empty file left behind
    (tmp_path / "folder.svg").mkdir()
    scene = SCENE.model_copy(update={"grains": SCENE.grains.model_copy(update={"density": None})})
    with pytest.raises(error) as refusal:
        figures.save(scene, what=what, out=tmp_path / out)
    assert message in str(refusal.value)
    assert [path.name for path in tmp_path.iterdir()] == ["folder.svg"]


def test_a_failing_disk_leaves_the_old_file_whole(tmp_path, monkeypatch):
    # half a figure in place of a good one
    out = tmp_path / "a.svg"
    out.write_text("old")

    def full(*_):
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(Path, "replace", full)
    with pytest.raises(FigureNotWritten, match="No space left"):
        figures.save(SCENE, what="waves", out=out)
    assert out.read_text() == "old"
    assert list(tmp_path.iterdir()) == [out]


def test_a_file_of_ones_own_permissions(tmp_path):
    # a figure that only its writer can read, as temporary files are by default
    plain = tmp_path / "plain"
    plain.touch()
    out = figures.save(SCENE, what="waves", out=tmp_path / "a.svg")
    assert out.stat().st_mode == plain.stat().st_mode


def test_nothing_heavy_is_loaded_early_and_pyplot_never(tmp_path):
    # a command line that pays for figures it does not draw; a window system that pyplot would look for
    code = ("import sys; from granular import figures; "
            "early = {'matplotlib', 'plotly', 'numpy'} & set(sys.modules); "
            "figures.table_ii_waves()._repr_svg_(); print(sorted(early), 'matplotlib.pyplot' in sys.modules)")
    answer = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert answer.stdout == "[] False\n"


def test_pages_show_what_is_drawn():
    # a page object that shows another figure, or whose text changes between builds
    still, moving = figures.figure_6(), figures.figure_5_interactive()
    assert isinstance(still, Static)
    assert isinstance(moving, Interactive)
    assert still._repr_svg_().startswith("<?xml")
    html = moving._repr_html_()
    assert html == figures.figure_5_interactive()._repr_html_()
    assert 'id="plotly-figure-5"' in html
    assert "<script src" not in html
    assert len(html) < 1_250_000  # the page must open on a phone: the figure, and at most 400 kB of its numbers


def test_surfaces_show_value_as_distance():
    # a surface stretched along an axis, or with its pole on the side
    shown = surface(lambda cosine: branch_weight(AxialFabric(Dr33=-0.6), cosine), TO_TURN)
    assert shown.x.shape == TO_TURN
    # 2e-4: coordinates are rounded to four decimals
    np.testing.assert_allclose(np.sqrt(shown.x**2 + shown.y**2 + shown.z**2), shown.radius, atol=2e-4)
    np.testing.assert_allclose(shown.z[0], 0.4, atol=1e-4)
    np.testing.assert_allclose(np.hypot(shown.x, shown.y)[TO_TURN[0] // 2], 1.3, atol=1e-4)
    # plotly looks up what the pointer shows by column and row: the value of another point would be named
    np.testing.assert_allclose(plotly_surface(shown, low=0, high=2, name="W").customdata, shown.radius.T, atol=1e-6)


def test_the_slider_shows_the_state_that_it_names():
    # slider steps shifted against the surfaces, or axes switched off with them
    figure = figure_5_interactive()
    steps = figure.layout.sliders[0].steps
    assert [step.label.replace("−", "-") for step in steps] == [f"{value:g}" for value in SLIDER]
    for position, (step, value) in enumerate(zip(steps, SLIDER, strict=True)):
        (change, _, traces) = step.args
        assert list(change["visible"]) == [other == position for other in range(len(SLIDER) + 1)]
        assert list(traces) == list(range(len(SLIDER) + 1))
        assert figure.data[position].surfacecolor[0][0] == pytest.approx(1 + value, abs=1e-4)
    assert json.loads(figure.to_json())["layout"]["sliders"][0]["active"] == SLIDER.index(-0.3)


def test_figure_6_against_the_expansion_in_dr():
    # wrong component under a name, wrong unit, or a scale other than the paper's ideal assembly times 1/9.81
    axes = figure_6().axes[0]
    curves = {line.get_color(): line.get_ydata() for line in axes.lines}
    lam, unit = 158 / 179, None
    coefficients = {  # constant, linear and quadratic term of the kinematic stiffness in Dr33 for D33 = 0
        "C3333": ((2 * lam + 3) / 15, 4 * (lam + 6) / 105, (2 * lam + 9) / 105),
        "C1111": ((2 * lam + 3) / 15, -2 * (lam + 6) / 105, (2 * lam + 3) / 105),
        "C1133": ((1 - lam) / 15, 2 * (1 - lam) / 105, (1 - lam) / 105),
        "C1122": ((1 - lam) / 15, -4 * (1 - lam) / 105, (1 - lam) / 105),
        "C2323": ((3 * lam + 2) / 30, (3 * lam + 4) / 210, (3 * lam + 1) / 105),
        "C1212": ((3 * lam + 2) / 30, -(3 * lam + 4) / 105, (3 * lam + 2) / 210)}
    for name, (c0, c1, c2) in coefficients.items():
        curve = curves[look.COMPONENT_COLOURS[name]]
        unit = unit or curve[0] / c0
        assert curve[0] == pytest.approx(unit * c0, rel=1e-13)
        assert curve[-1] == pytest.approx(unit * (c0 - 0.9 * c1 + 0.81 * c2), rel=1e-13)
    # the corrected values of the text for the isotropic assembly under 28 kPa, printed to four digits
    assert [round(float(curves[look.COMPONENT_COLOURS[name]][0]), 1) for name in ("C3333", "C1212")] == [556.8, 271.5]
    assert float(curves[look.COMPONENT_COLOURS["C1122"]][0]) == pytest.approx(13.71, abs=0.005)


def test_curves_of_waves_end_at_the_speeds_of_the_record():
    # curves exchanged, or angles counted from the horizontal
    result = granular.evaluate(SCENE).waves
    curves = {line.get_color(): line.get_ydata() for axes in waves_figure(result).axes for line in axes.lines}
    for name, colour in look.WAVE_COLOURS.items():
        assert curves[colour][0] == getattr(result.vertical, name)
        assert curves[colour][-1] == getattr(result.horizontal, name)


def test_kinematic_curves_lie_above_static_ones():
    # full and dashed lines exchanged
    lines = hypotheses().axes[0].lines[:8]
    for upper, lower in itertools.batched(lines, 2) if sys.version_info >= (3, 12) else zip(
            lines[::2], lines[1::2], strict=True):
        assert (upper.get_ydata() >= lower.get_ydata() * (1 - 1e-12)).all()


@patient
@given(st.lists(st.floats(-10, 10), max_size=8), st.floats(0.01, 3))
def test_labels_are_spread_as_little_as_needed(heights, gap):
    # names that overlap, change their order or drift away
    before = sorted(heights)
    after = look.spread(before, gap)
    assert all(second - first >= gap - 1e-9 for first, second in itertools.pairwise(after))
    assert sum(after) == pytest.approx(sum(before), abs=1e-9)
    if all(second - first >= gap for first, second in itertools.pairwise(before)):
        assert after == pytest.approx(before)


def test_names_at_curves_can_be_read():
    # light blue on white
    for colour in [*look.COMPONENT_COLOURS.values(), *look.WAVE_COLOURS.values()]:
        parts = np.array([int(look.readable(colour)[k:k + 2], 16) for k in (1, 3, 5)]) / 255
        linear = np.where(parts <= 0.04045, parts / 12.92, ((parts + 0.055) / 1.055) ** 2.4)
        assert 1.05 / (0.05 + linear @ [0.2126, 0.7152, 0.0722]) >= 4.49
