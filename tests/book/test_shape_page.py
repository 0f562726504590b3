"""What the page on shape says in words holds in the numbers that it shows."""

from __future__ import annotations

import base64
import csv
import io
import math
import re
from itertools import pairwise
from pathlib import Path

import pytest
from page_tools import collinear, shape, shape_forces
from page_tools.commands import WIDTH, answer
from page_tools.markup import Markup


@pytest.fixture(autouse=True)
def _in_the_book(book: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(book)


def rows(shown: Markup) -> list[dict[str, str]]:
    """Rows of the CSV file of a table, by column."""
    data = re.search(r"base64,([A-Za-z0-9+/=]+)", shown.text)
    assert data is not None
    return list(csv.DictReader(io.StringIO(base64.b64decode(data[1]).decode())))


def number(text: str) -> float:
    return float(text.replace("−", "-").removesuffix("°").removesuffix(" %"))


def test_elementary_form_has_no_digit_left_where_the_page_says_so() -> None:
    """Breaks when the naive column is no longer naive, or the series loses digits."""
    found = rows(shape.near_sphere_table())
    assert found[-1]["D_33 = 0.3"] == "no number"
    assert number(found[-3]["D_33 = 0.3"]) > 1
    assert all(number(row["series, D_33 = 0.3"]) < 1e-15 for row in found)


def test_routes_keep_their_promise() -> None:
    """Breaks when a shape costs digits, or the closed form is planned outside its domain."""
    found = rows(shape.shape_routes())
    assert all(number(row["error"]) <= number(row["promised error"]) for row in found)
    assert {row["route"] for row in found} == {"closed_form", "axial"}


def test_static_is_below_free_and_free_below_fixed() -> None:
    """Breaks when the order that the page proves is not that of its tables."""
    for shown in (shape.spin_table(), shape.sphere_spin_table()):
        for row in rows(shown):
            assert number(row["static"]) <= number(row["free"]) <= number(row["fixed"])
            assert -5 < number(row["static/free - 1"]) < 0  # "nearly the second" column


def test_deviation_is_as_derived() -> None:
    """Breaks when the largest deviation is looked for in another direction: tan of it is (r - 1/r)/2."""
    found = rows(shape.surfaces_table())
    for row in found:
        ratio = number(row["b/a"])
        expected = math.degrees(math.atan(abs(ratio - 1 / ratio) / 2))
        assert number(row["largest deviation"]) == pytest.approx(expected, abs=0.06)  # both are rounded in the table
    assert found[0]["at the angle beta"] == "-"


def test_most_of_the_anisotropy_comes_from_the_angle() -> None:
    """Breaks when length and angle are exchanged in the table."""
    for row in rows(collinear.angle_or_length()):
        length, angle, both = (abs(number(row[name]) - 1) for name in ("length alone", "angle alone", "both"))
        assert length < angle < both


def test_words_on_the_collinear_assumption_come_from_the_library() -> None:
    """Breaks when a sentence of the page is cut off from the numbers: 22 % at 0.9, a quarter of the slope."""
    assert "1.398" in collinear.headline(0.9).text
    assert "keeps 26.0 %" in collinear.kept_slopes().text
    errors = {row["b/a"]: row for row in rows(collinear.compression_table())}
    assert errors["0.9"]["error with the weight"] == "-22.1 %"
    assert errors["1"]["error with the weight"] == "0"


def test_more_directions_are_better_until_rounding() -> None:
    """Breaks when the table of degrees is out of order or compares with something else."""
    found = rows(collinear.degree_table())
    for column in (name for name in found[0] if name.startswith("$b/a")):
        errors = [number(row[column]) for row in found]
        assert errors[-1] < 1e-14
        assert all(later < max(earlier, 1e-14) for earlier, later in pairwise(errors))


def test_spheres_need_no_other_stress() -> None:
    """Breaks when the correction of the forces touches spheres, or leaves spheroids alone."""
    for row in rows(shape_forces.balanced_table()):
        assert (row["b/a"] == "1") == (row["change of C2323/C1212"] == "0")
    carried = {row["b/a"]: row["factor on the stress ratio"] for row in rows(shape_forces.carried_table())}
    assert carried["1"] == "1.000"
    assert number(carried["0.8"]) > 1 > number(carried["1.25"])


def test_a_command_is_shown_as_in_a_shell(monkeypatch: pytest.MonkeyPatch) -> None:
    """Breaks when an answer runs over the page, brings the signs of colours, or a failure is shown as an answer."""
    monkeypatch.setenv("FORCE_COLOR", "1")
    text = answer("run", "_data/spheroids.toml").text
    assert text.startswith("```console\n$ granular run spheroids.toml\nStiffness by the kinematic hypothesis")
    assert max(map(len, text.splitlines())) <= WIDTH
    assert "\x1b" not in text
    with pytest.raises(Exception, match="returned non-zero exit status 2"):
        answer("run", "_data/no_such_file.toml")
