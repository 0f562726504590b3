"""Numbers on the pages of the model: what is said of a limit holds, and values to check against are certified."""

from __future__ import annotations

import re

import pytest
from page_tools import model_numbers
from page_tools.model_numbers import TABLES, carried, check_values, hypotheses_apart, limit_table, slip_counts

import granular


@pytest.mark.parametrize("kind", TABLES)
def test_values_to_check_against_are_those_of_the_library(kind: str) -> None:
    """Breaks when a column belongs to another fabric or stress than its head says."""
    wanted, text = TABLES[kind], check_values(kind).text
    for place, (normals, branches, ratio) in enumerate(wanted.cases):
        found = granular.axial_stiffness(normals, branches, ratio, wanted.friction, model_numbers.NU,
                                         kinetic=wanted.kinetic, hypothesis=wanted.hypothesis.value)
        shown = [row.split("|")[2 + place].strip() for row in text.splitlines() if row.startswith("| $C_")]
        assert [float(value) for value in shown] == pytest.approx(found.tolist(), abs=1e-12)  # printed to 12 places


def test_a_value_that_the_library_does_not_give_stops_the_page(monkeypatch: pytest.MonkeyPatch) -> None:
    """Breaks when certified and compiled values may drift apart unseen."""
    monkeypatch.setattr(model_numbers, "APART", 0.0)
    monkeypatch.setattr(model_numbers, "_certified", lambda wanted, case: [1.0] * 6)
    with pytest.raises(AssertionError, match="is not what the library computes"):
        check_values("constant")


def test_sentences_hold() -> None:
    """Breaks when the order that the words state is not that of the numbers."""
    lower = [int(number) for number in re.findall(r"(?:by|and) (\d+) ", slip_counts().text)]
    assert lower == sorted(lower), "slip costs more at higher stress ratios"
    share = re.search(r"carry the stress ratio ([\d.]+)", carried(2.0).text)
    assert share is not None
    assert 1 < float(share[1]) < 2
    assert re.search(r"is 0\.\d+ % lower", hypotheses_apart().text)


def test_changes_fall_towards_every_limit() -> None:
    """Breaks when a limit is approached from the wrong side, or the columns are exchanged."""
    rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in limit_table().text.splitlines()
            if line.startswith("| ")][2:]
    assert len(rows) == 4
    for row in rows:
        changes = [float(cell) for cell in row[2:]]
        assert changes == sorted(changes, reverse=True)
