"""Claims of the paper: each has a ruling that the library bears out, and a section that shows it."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from page_tools import claims_record
from page_tools.claims_record import CLAIMS, Ruling, counted, holding, summary
from page_tools.ledger_record import ENTRIES, Verdict


@pytest.fixture(autouse=True)
def _in_the_book(book: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(book)


def test_every_claim_has_its_section(book: Path) -> None:
    """Breaks when a claim leads nowhere, or a section of the page belongs to no claim."""
    text = (book / "claims.md").read_text(encoding="utf-8")
    labels = re.findall(r"^\((sec-[a-z-]+)\)=\n## ", text, flags=re.MULTILINE)
    assert {claim.label for claim in CLAIMS} == set(labels)


def test_claims_that_hold_are_computed() -> None:
    """Breaks when one of them fails, which raises, or one is listed and not computed."""
    text = holding().text
    assert text.count("\n| ") == 2 + sum(claim.label == "sec-claims-that-hold" for claim in CLAIMS)


def test_a_claim_that_fails_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    """Breaks when the page would go on saying that a claim holds."""
    monkeypatch.setattr(claims_record, "_farther", lambda _: False)
    with pytest.raises(AssertionError, match="no longer hold"):
        holding()


def test_box_counts_the_table() -> None:
    """Breaks when the box and the table of claims disagree."""
    rows = summary().text
    for ruling in Ruling:
        assert rows.count(f"`{ruling.value} <") == sum(claim.ruling is ruling for claim in CLAIMS) > 0
    assert f"Of {len(CLAIMS)} conclusions" in counted().text


def test_claims_and_ledger_agree() -> None:
    """Breaks when the page of claims and the ledger judge one place of the paper in opposite ways."""
    of_place = {entry.place: {verdict for verdict, _ in entry.rulings} for entry in ENTRIES}
    for claim in CLAIMS:
        against = of_place[claim.place] & {Verdict.REFUTED, Verdict.MISPRINT}
        if claim.ruling in (Ruling.FAILS, Ruling.PART):
            assert against, claim.place
        if claim.ruling is Ruling.HOLDS:
            assert Verdict.REFUTED not in of_place[claim.place], claim.place
    refuted = {place for place, verdicts in of_place.items() if Verdict.REFUTED in verdicts}
    assert refuted <= {claim.place for claim in CLAIMS if claim.ruling in (Ruling.FAILS, Ruling.PART)}
