"""The coverage ledger names everything the paper numbers, and nothing that is not there."""

from __future__ import annotations

import base64
import csv
import inspect
import io
import pkgutil
import re
from dataclasses import replace
from pathlib import Path

import pytest
from page_tools import contents, ledger, ledger_record
from page_tools.citations import citing, documented
from page_tools.errata_record import SLIPS
from page_tools.ledger_record import ENTRIES, Entry, Verdict

from derivations.catalogue import names
from derivations.citations import equations_cited

BY_PLACE = {entry.place: entry for entry in ENTRIES}


@pytest.fixture(autouse=True)
def _in_the_book(book: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(book)


def test_nothing_of_the_paper_is_missing() -> None:
    """Breaks when an equation, a table or a figure is left out, entered twice, or out of order."""
    assert [entry.place for entry in ledger_record.EQUATIONS] == [f"({number})" for number in range(1, 29)]
    assert [entry.place for entry in ledger_record.TABLES] == [f"Table {n}" for n in ("I", "II", "III", "IV", "V")]
    assert [entry.place for entry in ledger_record.FIGURES] == [f"Figure {number}" for number in range(1, 10)]
    assert len(BY_PLACE) == len(ENTRIES)


def test_everything_named_exists() -> None:
    """Breaks when a function, a test, a page or a section of the ledger was renamed or removed."""
    assert ledger.faults() == []


@pytest.mark.parametrize(("place", "change", "fault"), [
    ("(7)", {"computed": ("granular.no_such.function",)}, "there is no granular.no_such.function"),
    ("(7)", {"computed": ("granular.contact_law.stiffness_ratio",)}, "does not cite it"),
    ("(7)", {"computed": ()}, "it is computed by"),
    ("(7)", {"tested": "granular/test_bounds.py::test_of_nothing"}, "there is no test"),
    ("(7)", {"tested": "granular/test_of_nothing.py::test_order_of_the_bounds"}, "there is no test"),
    ("(19)", {"rulings": ((Verdict.NEARLY, "sec-erratum-of-nothing"),)}, "no page has a section"),
    ("Table II", {"shown": ""}, "no page shows it"),
    ("Figure 5", {"shown": "no_such_page:fig-five"}, "there is no page"),
    ("Figure 5", {"shown": "figure_5:fig-six"}, "shows no fig-six"),
])
def test_what_is_stale_is_noticed_and_stops_the_page(
    place: str, change: dict[str, object], fault: str, monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Breaks when a wrong entry would be shown as if it were right."""
    spoiled: Entry = replace(BY_PLACE[place], **change)  # type-checked by the record itself
    monkeypatch.setattr(ledger, "ENTRIES", (spoiled,))
    assert any(fault in found for found in ledger.faults())
    with pytest.raises(AssertionError, match=re.escape(place)):
        ledger.ledger()


def test_every_erratum_is_in_the_ledger() -> None:
    """Breaks when a slip is added to the errata and no place of the ledger leads to it, or the reverse."""
    ruled = {label for entry in ENTRIES for _, label in entry.rulings if label.startswith("sec-erratum")}
    assert ruled == {slip.label for slip in SLIPS}


def test_every_cited_equation_is_in_the_ledger() -> None:
    """Breaks when derivations or docstrings cite an equation that the paper does not have."""
    sources = {source for record in contents.records().values() for source in record["sources"]}
    equations = {place for place in {*citing(), *sources} if re.fullmatch(r"\(\d+\)", place)}
    assert equations == {entry.place for entry in ledger_record.EQUATIONS}


def test_equations_lead_to_the_step_that_names_them() -> None:
    """Breaks when a link goes to a derivation that only uses the equation, or to a step that no page shows."""
    expected = {"(1)": ("equations", 1, "kinematic"), "(16)": ("gradation", 9, "branch_lengths"),
                "(21)": ("contact_forces", 18, "sliding")}
    for place, (record, step, page) in expected.items():
        assert ledger.derived(place) == (record, (record, step, page))
    shown = [found for number in range(1, 29) if (found := ledger.derived(f"({number})"))]
    assert len(shown) == 28
    assert [name for name, step in shown if step is None] == ["gradation", "gradation"]  # the definitions (13) and (15)


def test_rows_of_the_table() -> None:
    """Breaks when a place is lost on the way to the page, or the file beside it has other places."""
    text = ledger.ledger().text
    data = re.search(r"base64,([A-Za-z0-9+/=]+)", text)
    assert data is not None
    rows = list(csv.DictReader(io.StringIO(base64.b64decode(data[1]).decode())))
    assert [row["place"] for row in rows] == [entry.place for entry in ENTRIES]
    assert text.count("\n| ") == len(ENTRIES) + 2  # a head and a rule
    assert "{eq}`eq-equations-1` [Kinematic hypothesis](kinematic.md)" in text
    assert "{ref}`misprint <sec-erratum-shear-stiffness>`" in text
    assert "granular.contact_law.stiffness_ratio" in {row["place"]: row for row in rows}["(21)"]["all that cite it"]


def test_verdicts_are_counted() -> None:
    """Breaks when the summary does not add up to what the places have."""
    counts = [int(found) for found in re.findall(r"\| (\d+) \|$", ledger.verdicts().text, flags=re.MULTILINE)]
    assert sum(counts) == sum(len(entry.rulings) for entry in ENTRIES)
    assert min(counts) > 0


def test_the_box_counts_the_table() -> None:
    """Breaks when the box above the ledger and its rows disagree."""
    said = ledger.counted().text
    against = {Verdict.MISPRINT, Verdict.REFUTED}
    wrong = sum(bool(against & {verdict for verdict, _ in entry.rulings}) for entry in ENTRIES)
    assert "All 28 equations, 5 tables and 9 figures" in said
    assert f"At {wrong} of these {len(ENTRIES)} places" in said


@pytest.mark.parametrize(("text", "numbers"), [
    ("Source: eq. (7).", [7]),
    ("Source: eqs (4), (7), and Figure 1(b).", [4, 7]),
    ("eqs (8)-(11)", [8, 9, 10, 11]),
    ("Eqs (12), (16), (17) as they stand", [12, 16, 17]),
    ("eqs (16) and (17), eq. (2)", [2, 16, 17]),
    ("eqs (10) - (12), (16)", [10, 11, 12, 16]),
    ("the number (7), Table II, f(3)", []),
])
def test_citations_are_read_as_they_are_written(text: str, numbers: list[int]) -> None:
    """Breaks when a range is not filled, a list ends early, or any number in brackets counts."""
    assert equations_cited(text) == numbers


def test_the_notes_on_steps_cover_the_catalogue() -> None:
    """Breaks when a derivation is added without ``derivations write``."""
    assert tuple(contents.records()) == names()


def test_documented_names_exist() -> None:
    """Breaks when names are put together wrongly: those used here can be imported, and have that docstring."""
    for name in {name for entry in ENTRIES for name in entry.computed}:
        assert inspect.getdoc(pkgutil.resolve_name(name)) == documented()[name]
