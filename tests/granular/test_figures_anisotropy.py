"""Maps of anisotropy, lines of isotropic values, the interactive map and the triangle of fabrics."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import numpy as np
import pytest

import granular
from granular.figures import anisotropy_interactive as interactive
from granular.figures import anisotropy_maps, files, isotropic_lines, ternary
from granular.figures.anisotropy_maps import Place
from granular.figures.contour_names import on_path
from granular.general import GeneralFabric, general_stiffness
from granular.measures import MEASURES, measure

sys.path.insert(0, str(Path(__file__).parents[1]))
from legible import require_large_words, require_more_than_colour, require_units, require_words_apart

PLACES = (Place("one", 0.3, -0.3), Place("two", 0.0, 0.0, "^"))
DRAWN = {
    "constant": lambda: anisotropy_maps.constant_maps(PLACES),
    "stress": lambda: anisotropy_maps.stress_maps(PLACES),
    "lines": isotropic_lines.isotropic_lines,
    "triangle": lambda: ternary.fabric_triangle((ternary.Fabric3("one", (-0.9, 0.0, 0.9)),)),
}


@pytest.fixture(scope="module", params=DRAWN)
def drawn(request):
    figure = DRAWN[request.param]()
    files.static_bytes(figure, "png")  # settles the layout
    figure.draw_without_rendering()
    return request.param, figure


def test_words_can_be_read(drawn):
    """Breaks when text is small, cut or over other text, curves differ by colour alone, or an axis has no unit."""
    name, figure = drawn
    require_large_words(figure)
    require_more_than_colour(figure)
    if name in ("lines", "triangle"):
        require_words_apart(figure)
    if name != "triangle":
        require_units(figure)


def test_the_thick_line_is_where_the_measure_is_isotropic():
    """Breaks when maps are transposed: the thick line would leave the fabrics that it joins."""
    D33, Dr33 = anisotropy_maps.grid()
    values = measure(anisotropy_maps.stiffness_over(None), "C1111/C3333")
    assert values.shape == (len(Dr33), len(D33))
    place = (5, 40)
    alone = granular.axial_stiffness(D33[place[1]], Dr33[place[0]], kinetic=False)
    assert values[place] == pytest.approx(float(measure(alone, "C1111/C3333")), rel=1e-14)
    assert all(MEASURES[name].isotropic is None or MEASURES[name].isotropic in anisotropy_maps.LEVELS[name]
               for name in anisotropy_maps.CONSTANT)


def test_sliding_begins_where_the_map_says():
    """Breaks when the dash-dotted line stands at another fabric, or its arrow points away from sliding."""
    for ratio in anisotropy_maps.RATIOS:
        for onset, outside in ((anisotropy_maps.ONSET, -1), (1 / anisotropy_maps.ONSET, 1)):
            D33 = 5 * (ratio - onset) / (ratio + 2 * onset)
            for step in (-0.01, 0.01):
                slides = _slides(D33 + step, ratio)
                assert slides == (step * outside > 0), (ratio, onset, step)


def _slides(D33: float, ratio: float) -> bool:
    """Whether the largest shear force over normal force exceeds friction, on a fine set of directions."""
    x = np.linspace(0, 1, 20001)
    horizontal, vertical = 1 / (1 / 3 - D33 / 15), ratio / (1 / 3 + 2 * D33 / 15)
    normal = horizontal * (1 - x**2) + vertical * x**2
    shear = abs(vertical - horizontal) * x * np.sqrt(1 - x**2)
    return bool((shear > anisotropy_maps.FRICTION * normal).any())


def test_names_of_lines_stand_on_their_lines():
    """Breaks when a number stands at a line of another value."""
    D33, Dr33 = anisotropy_maps.grid()
    levels = [0.3, 0.7, 1.2]
    found = on_path(D33, Dr33, np.add.outer(2 * Dr33, D33) + 1, [*levels, 99.0], anisotropy_maps.ALONG)
    # 1e-2: half a step along the path
    assert [d + 2 * dr + 1 for d, dr in found] == pytest.approx(levels, abs=1e-2)


def test_slider_and_buttons_show_what_they_name():
    """Breaks when a step shows another stress ratio, a button other values, or the pointer another point."""
    figure = interactive.anisotropy_interactive(PLACES)
    steps = figure.layout.sliders[0].steps
    for place, state in enumerate(interactive.STATES):
        change, traces = steps[place].args
        assert list(change["visible"]) == [other == place for other in range(len(interactive.STATES))]
        assert list(traces) == list(range(len(interactive.STATES)))
        assert steps[place].label == ("equal contacts" if state is None else f"{state:g}")
    row, column, at = 20, 8, interactive.STATES.index(2.0)
    one = granular.axial_stiffness(figure.data[at].x[column], figure.data[at].y[row], 2.0, interactive.FRICTION,
                                   interactive.POISSON_RATIO)
    expected = [float(measure(one, name)) for name in interactive.SHOWN]
    # 1e-4: values in the page have four decimals
    assert figure.data[at].customdata[row][column] == pytest.approx(expected, abs=1e-4)
    for button, name in zip(figure.layout.updatemenus[0].buttons, interactive.BUTTONS, strict=True):
        assert button.args[0]["z"][at][row][column] == pytest.approx(float(measure(one, name)), abs=1e-4)
    assert len(json.dumps(json.loads(figure.to_json()))) < 700_000  # the page must open on a phone


@pytest.mark.parametrize("D", [(-0.15, -0.15, 0.3), (0.9, -0.7, -0.2), (2.0, -1.0, -1.0)])
def test_the_triangle_shows_the_general_model(D):
    """Breaks when the shortcut through axial assemblies is not the stiffness of a fabric without an axis."""
    found = general_stiffness(GeneralFabric(np.diag(D).tolist()), poisson_ratio=ternary.POISSON_RATIO,
                              hypothesis="kinematic")
    along = [found.rows[axis][axis] for axis in range(3)]
    assert float(ternary.anisotropy_of(np.array(D))) == pytest.approx(max(along) / min(along), rel=1e-12)


def test_corners_of_the_triangle():
    """Breaks when axes are exchanged or the isotropic fabric leaves the middle."""
    x, y = ternary.in_triangle(np.array([[2.0, -1, -1], [-1, 2, -1], [-1, -1, 2], [0, 0, 0]]))
    assert x.tolist() == pytest.approx([0, 1, 0.5, 0.5])
    assert y.tolist() == pytest.approx([0, 0, ternary.UP, ternary.UP / 3])
