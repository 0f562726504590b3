"""What the page on general fabrics says in words holds in the numbers that it shows."""

from __future__ import annotations

import base64
import csv
import io
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from page_tools import general_fabric
from page_tools.markup import Markup

from granular.figures.general_fabric import TILTS, by_tilt, tilted, tilted_fabric
from granular.general import GeneralLoading, Symmetry, general_stiffness
from granular.general.engineering import along
from granular.general.routes import GENERAL_ROUTES
from granular.general.symmetry import axial_part, orthotropic_part
from granular.mandel import symmetric_rows, turned
from granular.scene import Scene

VISIBLE = re.compile(r"^```\{code-cell\} python\n(?!:)(.*?)^```", flags=re.MULTILINE | re.DOTALL)
"""Cells that readers see unfolded: the two examples."""


@pytest.fixture(scope="module")
def shown(book: Path) -> dict[str, Any]:
    """What the two examples of the page leave behind."""
    names: dict[str, Any] = {}
    for source in VISIBLE.findall((book / "general_fabric.md").read_text(encoding="utf-8")):
        exec(source, names)
    return names


@pytest.fixture(scope="module")
def symmetries(shown: dict[str, Any]) -> tuple[Symmetry, ...]:
    return by_tilt(general_fabric.D33, shown["loading"], poisson_ratio=general_fabric.NU)


def rows(shown: Markup) -> list[list[str]]:
    """Rows of a table, below its heads."""
    lines = [line for line in shown.text.splitlines() if line.startswith("|")]
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in lines[2:]]


def taken(shown: Markup) -> list[list[str]]:
    """Rows of the CSV file of a table."""
    data = re.search(r"base64,([A-Za-z0-9+/=]+)", shown.text)
    assert data is not None
    return list(csv.reader(io.StringIO(base64.b64decode(data[1]).decode())))


def test_the_page_and_its_tools_show_one_scene(shown: dict[str, Any]) -> None:
    """Breaks when the visible example and the one behind table and figure drift apart."""
    assert shown["fabric"].D == pytest.approx(np.array(tilted(general_fabric.D33, general_fabric.TILT).D), abs=1e-15)
    assert shown["loading"] == general_fabric.example(friction=shown["loading"].friction)


def test_the_file_holds_the_scene_of_the_page(shown: dict[str, Any], book: Path) -> None:
    """Breaks when the file that the page offers is another scene than the one it shows."""
    scene = Scene.from_toml(book / "_data/tilted_fabric.toml")
    assert scene.general_fabric == shown["fabric"]
    assert scene.grains.friction == shown["loading"].friction
    stress, given = (np.array(loading.stress) for loading in (scene.general_loading(None), shown["loading"]))
    assert np.abs(stress / stress[0, 0] - given / given[0, 0]).max() == 0.0
    assert "differs from the result above by" in general_fabric.same_scene(
        str(book / "_data/tilted_fabric.toml"), shown["found"]).text


def test_the_page_lists_every_route_without_an_axis() -> None:
    """Breaks when a route is added and the table of the page is not made of the records."""
    text = general_fabric.general_routes().text
    assert all(f"`{name}`" in text for name in GENERAL_ROUTES)


def test_thirteen_numbers_are_left(shown: dict[str, Any]) -> None:
    """Breaks when the plane of symmetry is lost: a component with one or three indices 2 that is not zero."""
    found = rows(general_fabric.matrix(shown["found"]))
    upper = [found[i][j + 1] for i in range(6) for j in range(i, 6)]
    assert len(upper) - upper.count("0") == 13
    whole = taken(general_fabric.matrix(shown["found"]))
    assert [[float(cell) for cell in row[1:]] for row in whole[1:]] == [list(row) for row in shown["found"].rows]


def test_distances_are_those_of_a_search_in_the_plane(shown: dict[str, Any]) -> None:
    """Breaks when a frame about axis 2 is nearer to a class than the one found; half a degree off costs under 1e-4."""
    plain = symmetric_rows(shown["found"].rows, "stiffness")
    size = np.linalg.norm(plain)
    axial, orthotropic = [], []
    for turn in np.radians(np.arange(0.0, 180.0)):
        one, zero = np.cos(turn), np.sin(turn)
        seen = np.array(turned(plain, [[one, 0, -zero], [0, 1, 0], [zero, 0, one]], "stiffness"))
        axial.append(np.linalg.norm(seen - axial_part(seen)) / size)
        orthotropic.append(np.linalg.norm(seen - orthotropic_part(seen)) / size)
    text = {row[0]: float(row[1].removesuffix(" %")) / 100 for row in rows(general_fabric.distances(shown["found"]))}
    assert text["transversely isotropic"] == pytest.approx(min(axial), abs=1e-4)
    assert text["orthotropic"] == pytest.approx(min(orthotropic), abs=1e-4)


def test_the_plain_sum_and_the_other_frame_agree(shown: dict[str, Any]) -> None:
    """Breaks when the page would be built with a check that fails."""
    scene = shown["fabric"], shown["loading"], shown["found"]
    assert "differs by" in general_fabric.plain_sum(*scene).text
    assert "differs by" in general_fabric.in_another_frame(*scene).text


def test_stated_errors_are_above_those_found(shown: dict[str, Any]) -> None:
    """Breaks when an estimate is too low or not half of what was wanted, or a finer wish takes fewer directions."""
    found = rows(general_fabric.accuracy(shown["fabric"], shown["loading"]))
    assert all(100 * float(row[2]) < float(row[1]) == pytest.approx(float(row[0]) / 2) for row in found)
    assert [int(row[3]) for row in found] == sorted(int(row[3]) for row in found)


def test_the_axial_scene_is_recognised(shown: dict[str, Any]) -> None:
    """Breaks when the page's second example is no longer sent to the axial route; "three orders" are 1000 times."""
    assert rows(general_fabric.axial_scene(shown["axial"], stress_ratio=2.0, friction=shown["coaxial"].friction))
    assert shown["found"].evaluations > 1000 * shown["axial"].evaluations > 0
    assert shown["axial"].error_is == "bound"


def test_words_on_the_scenes(shown: dict[str, Any]) -> None:
    """Breaks when a class or route differs from what the page says, or sliding is not what takes symmetry away."""
    found = taken(general_fabric.scenes(shown["loading"].friction))[1:]
    assert [row[1] for row in found] == ["transversely isotropic"] * 2 + ["orthotropic"] * 2 + ["general"] * 3
    assert [row[4] for row in found] == ["axial: closed_form", "axial: axial", "closed_form", "product",
                                         "closed_form", "product", "product"]
    sticking, sliding = (float(row[2].removesuffix(" %")) for row in found[-2:])
    assert sliding > 3 * sticking


def test_words_on_the_tilt(symmetries: tuple[Symmetry, ...]) -> None:
    """Breaks when the figure's caption or the paragraph below it no longer says what the curves show."""
    assert (symmetries[0].name, symmetries[-1].name) == ("transversely isotropic", "orthotropic")
    assert {one.name for one in symmetries[1:-1]} == {"general"}
    assert all(one.transversely_isotropic > 0.05 for one in symmetries[2:])
    middle = symmetries[TILTS.index(45.0)]
    assert 0.4 < middle.orthotropic / middle.transversely_isotropic < 0.65


def test_stiffness_follows_the_fabric(shown: dict[str, Any]) -> None:
    """Breaks when the stiffest direction of the map is not nearer to the fabric's axis than to that of the stress."""
    turn = np.radians(np.arange(91.0))
    best = int(along(shown["found"].stiffness(), np.stack([np.sin(turn), 0 * turn, np.cos(turn)])).argmax())
    assert abs(best - general_fabric.TILT) < abs(best)


def test_stiffness_along_an_axis_is_a_component() -> None:
    """Breaks when the product with the strain takes a wrong factor: C_ijkl n_i n_j n_k n_l by the whole tensor."""
    found = general_stiffness(tilted(0.5, 30.0), poisson_ratio=0.3, hypothesis="kinematic")
    n = np.array([2.0, -1.0, 2.0]) / 3
    expected = np.einsum("ijkl,i,j,k,l", found.stiffness().tensor(), n, n, n, n)
    assert along(found.stiffness(), n[:, None])[0] == pytest.approx(expected, rel=1e-14)


@pytest.mark.parametrize("friction", [None, 0.2126])
def test_the_figure_is_drawn(symmetries: tuple[Symmetry, ...], friction: float | None) -> None:
    """Breaks when a mark or a curve is missing, or a scene without friction stops the drawing."""
    loading = GeneralLoading(general_fabric.example(friction=None).stress, friction=friction)
    figure = tilted_fabric(0.5, loading, symmetries, degrees=45.0, poisson_ratio=0.21)
    sphere, _, curves = figure.axes
    texts = {text.get_text() for text in sphere.texts}
    assert {"stress", "fabric", "nearest axis", "1", "2"} <= texts
    assert ("slide" in texts) == (friction is not None)
    assert len(curves.lines) == 2
