"""The pages on the paper's tables and figures say what the library computes, and stop where it no longer does."""

from __future__ import annotations

import base64
import csv
import io
import re
import tomllib
from pathlib import Path

import pytest
from page_tools import paper_figures, paper_gradation, paper_panels, paper_readings, paper_statements, paper_tables
from page_tools.paper import cases
from page_tools.paper_scenes import gradation_files, gradation_text, scene_files, scene_text

from granular import Scene, evaluate

NUMBERS = range(3, 10)


@pytest.fixture(autouse=True)
def _in_the_book(book: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(book)


def taken_away(text: str) -> list[list[str]]:
    """Rows of the CSV file that a table or figure offers."""
    data = re.search(r"base64,([A-Za-z0-9+/=]+)", text)
    assert data is not None
    return list(csv.reader(io.StringIO(base64.b64decode(data[1]).decode())))


def test_printed_tables_are_explained() -> None:
    """Breaks when a printed ratio is no longer what 24 panels give, rounded or cut, or a misprint."""
    found = [ratio for name in paper_tables.TABLES for ratio in paper_tables.printed_ratios(name)]
    assert {ratio.ruling for ratio in found} == {
        "rule, rounded", "rule, cut", "by symmetry", "misprint for 0.857", "misprint for 0.774"}
    assert len(taken_away(paper_panels.verdicts().text)) == 1 + 18
    assert "it alone does" in paper_panels.which_panels().text
    assert "of Table V, 2" in paper_panels.what_separates(22, 30).text
    assert taken_away(paper_panels.panel_counts(24, 24).text)[1] == ["24", "16", "2", "0", "16"]


def test_only_one_number_of_panels_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    """Breaks when the page would name 24 panels although the rule with another number gives the tables as well."""
    monkeypatch.setattr(paper_panels, "_given", lambda panels: 18 if panels in (24, 25) else 0)
    with pytest.raises(AssertionError, match="reproduce the tables"):
        paper_panels.which_panels()


def test_a_value_that_nothing_explains_stops_the_page(monkeypatch: pytest.MonkeyPatch) -> None:
    """Breaks when a printed value that the rule does not give would pass as explained."""
    first, *others = paper_tables.printed_ratios("II")
    spoiled = paper_tables.Printed(first.table, first.case, first.name, first.exact, first.error, first.panels, "1.460")
    monkeypatch.setattr(paper_tables, "printed_ratios", lambda _: (spoiled, *others))
    with pytest.raises(AssertionError, match="nothing explains"):
        paper_tables.finding("II")


@pytest.mark.parametrize("name", paper_tables.TABLES)
def test_box_counts_what_the_table_shows(name: str) -> None:
    """Breaks when the box of a page and the verdicts of its table disagree."""
    rows = taken_away(paper_tables.table_of(name).text)[1:]
    ruled = sum(row[-1].startswith("rule") for row in rows)
    said = paper_tables.finding(name).text
    assert (f"All {ruled} printed" if ruled == len(rows) else f"Of the {len(rows)} printed ratios {ruled} ") in said
    assert ("misprint" in said) == any("misprint" in row[-1] for row in rows)


@pytest.mark.parametrize("name", paper_tables.TABLES)
def test_scene_files_give_the_table(name: str) -> None:
    """Breaks when a scene that a reader downloads is not the case of the table."""
    for case in cases(paper_tables.TABLES[name]):
        scene = Scene.model_validate(tomllib.loads(scene_text(name, case)))
        for own, other in zip(evaluate(scene).ratios, paper_tables.evaluated(case).ratios, strict=True):
            # both are promised to a few units in the last place
            assert own.value == pytest.approx(other.value, rel=1e-13)
    assert scene_files(name).text.count("download=") == len(cases(paper_tables.TABLES[name]))


def test_scene_files_of_gradations_have_the_printed_sizes() -> None:
    """Breaks when a radius is offered as a diameter, or the spread is lost."""
    for case in cases("_data/table_i.csv"):
        scene = Scene.model_validate(tomllib.loads(gradation_text(case)))
        assert scene.gradation is not None
        # the printed size is in millimetres, and the text of the file is decimal
        assert scene.gradation.sizes.uniformity == pytest.approx(float(case["uniformity"]), abs=0.05)
        assert f'median = "{2 * float(case["r50_mm"]):g} mm"' in gradation_text(case)
    assert gradation_files("_data/table_i.csv").text.count("download=") == 6


def test_printed_uniformity_is_the_computed_one_rounded() -> None:
    """Breaks when Table I is read with other sizes than the paper's, or C_u is computed otherwise."""
    rows = taken_away(paper_gradation.table_one("_data/table_i.csv").text)[1:]
    assert [f"{float(row[4]):.1f}" for row in rows] == [row[3] for row in rows]
    assert [row[6] for row in rows] == ["confirmed"] * 6


def test_readings_hold() -> None:
    """Breaks when a sentence on a page of a table is no longer true; each raises then."""
    assert "+0.3" in paper_readings.felt_to_first_order().text
    assert paper_readings.stages().text.count("%") == 4
    for name in ("IV", "V"):
        assert "falls, from 1 to 0." in paper_readings.growing(name).text
    assert "D_{33} = 0.5" in paper_readings.forces_take_back("IV").text
    # the edges at stress ratio 2 by tan(beta), to the decimal that is shown
    assert "25.3° and 76.7°" in paper_readings.what_slides().text


@pytest.mark.parametrize("number", NUMBERS)
def test_statements_on_figures_hold(number: int) -> None:
    """Breaks when a statement of the paper on a figure is no longer borne out by what is drawn."""
    rows = taken_away(getattr(paper_statements, f"figure_{number}_said")().text)[1:]
    assert len(rows) >= 2
    assert not [row for row in rows if row[2] == paper_figures.FAILS]
    assert ":class: result" in getattr(paper_statements, f"figure_{number}_shows")().text


@pytest.mark.parametrize("number", NUMBERS)
def test_numbers_behind_figures_are_offered(number: int) -> None:
    """Breaks when the file beside a figure loses its columns."""
    header, *rows = taken_away(paper_figures.figure_numbers(number).text)
    assert len(rows) > 50
    assert len(header) == {3: 7, 4: 19, 5: 6, 6: 7, 7: 18, 8: 13, 9: 13}[number]


def test_each_page_has_its_parts(book: Path) -> None:
    """Breaks when a page of a table or figure loses its comparison, its assumptions or limits, or where to go next."""
    for number in NUMBERS:
        text = (book / f"figure_{number}.md").read_text(encoding="utf-8")
        for part in ("_shows()", "_said()", f"figure_numbers({number})", "## Limits of the comparison", "## Next"):
            assert part in text, (number, part)
    for name in ("i", "ii", "iii", "iv", "v"):
        text = (book / f"table_{name}.md").read_text(encoding="utf-8")
        for part in ("## Reading the table", "## What was assumed", "_files(", "## Next"):
            assert part in text, (name, part)
