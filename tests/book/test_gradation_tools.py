"""Pages on gradation: what their tables say is what the paper prints and what the library computes."""

from __future__ import annotations

from pathlib import Path

import pytest
from page_tools import branch_lengths, claims, errata_gradation, gradation
from page_tools.steps import parts

TABLE_I = "_data/table_i.csv"


@pytest.fixture(autouse=True)
def _in_the_book(book: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(book)


def cells(text: str) -> list[list[str]]:
    """Rows of the table in a text, without its head."""
    lines = [line for line in text.splitlines() if line.startswith("| ")]
    return [[cell.strip() for cell in line.strip("| ").split(" | ")] for line in lines[2:]]


def test_form_changes_contacts_and_no_stiffness() -> None:
    """Breaks when the form of the density changes the stiffness, or the sizes are no longer those of its form."""
    paper, classical = cells(gradation.two_forms().text)
    assert paper[-1] == classical[-1]
    assert paper[-2] != classical[-2]
    assert classical[2] == "10"  # the key is a true median there


def test_every_unsound_curve_is_refused() -> None:
    """Breaks when a curve is accepted that the page says is refused."""
    assert len(cells(gradation.curve_refusals().text)) == len(gradation.UNSOUND)


def test_refusal_that_does_not_happen_is_noticed() -> None:
    """Breaks when the page would go on listing a refusal that the library has dropped."""
    with pytest.raises(AssertionError, match="nothing was refused"):
        gradation._refusal((gradation.HEAD, "1, 0", "2, 1"))


def test_finest_grains_decide_the_number_of_grains() -> None:
    """Breaks when the text below the table is no longer true: D50 stays, the number of grains does not."""
    rows = cells(gradation.finest_grains("_data/sand.toml").text)
    assert len({row[2] for row in rows}) == 1
    assert float(rows[-1][4]) > 10 * float(rows[0][4])


def test_steps_of_the_library_reach_rounding() -> None:
    """Breaks when the text on digits and nodes is no longer what the table shows."""
    rows = {row[0]: row for row in cells(branch_lengths.rule_table().text)}
    errors = [float(cell.replace("−", "-")) for cell in rows["1"][2::2]]
    assert max(errors) < 5e-15
    assert max(float(cell.replace("−", "-")) for cell in rows["2"][2::2]) < 2e-9
    assert float(rows["1"][5]) / float(rows["1"][1]) == pytest.approx(4 / 3, rel=0.02)  # "a third more nodes"


def test_two_ways_over_the_directions_agree() -> None:
    """Breaks when Kummer functions and the rule over the sphere differ in a digit that is shown."""
    for row in cells(branch_lengths.spread_by_direction().text):
        assert row[2] == row[3]


def test_mean_size_does_not_matter() -> None:
    """Breaks when two assemblies that differ in their size alone differ in a digit that is shown."""
    rows = cells(claims.mean_size_table(TABLE_I).text)
    assert len({tuple(row[-2:]) for row in rows}) == 1
    assert len({row[2] for row in rows}) == len(rows) == 3


def test_uniformity_matters() -> None:
    """Breaks when the numbers that contradict the paper change, or those of the earlier count."""
    rows = cells(claims.uniformity_table().text)
    assert [row[2] for row in rows] == ["4.3556", "6.5509", "33.155"]
    assert [float(row[3]) for row in rows] == pytest.approx([4.355, 6.50, 29.0], abs=0.05)  # printed digits of it
    for row in cells(errata_gradation.uniformity_check(TABLE_I).text):
        assert row[1] == row[2]  # the same, written twice


def test_printed_stiffness_is_that_of_equal_spheres_times_gravity() -> None:
    """Breaks when the factor between printed and computed stiffness is explained with a number that does not fit."""
    for row in cells(claims.printed_number_table("_data/isotropic_28kpa.csv").text):
        assert float(row[4]) == pytest.approx(4, rel=5e-3)  # the third component is printed with three digits


def test_tests_speak_against_the_cube_root() -> None:
    """Breaks when the predicted change over the tested range is no longer one that tests would see."""
    change = cells(claims.tests_table().text)[-1]
    assert float(change[2].rstrip(" %")) > 30
    assert float(change[3].rstrip(" %").replace("−", "-")) < -30


def test_relations_other_than_equality_are_set_below_one_another() -> None:
    """Breaks when asymptotic forms side by side are torn apart at a place that TeX chooses."""
    wide = r"a \sim b + c + d + e + f + g + h + i + j,\qquad k \le l + m + n + o + p + q + r + s"
    assert parts(wide) == [r"a \sim b + c + d + e + f + g + h + i + j,", r"k \le l + m + n + o + p + q + r + s"]
