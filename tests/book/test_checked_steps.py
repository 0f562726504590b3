"""Steps on the pages are checked when the book is built: a wrong one stops the build, and none is left out."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
import sympy as sp
import yaml
from page_tools import formulas
from page_tools import steps as tool
from page_tools.contents import records, steps_shown
from page_tools.formulas import of_steps
from page_tools.steps import steps

from derivations.catalogue import derivation, names
from derivations.record import Claim, Derivation, Step


def spoiled(name: str) -> Derivation:
    """A derivation with one claim of its last checked step made wrong by a part in 10^12."""
    record = derivation(name)
    place = max(number for number, step in enumerate(record.steps) if any(_numeric(claim) for claim in step.claims))
    step = record.steps[place]
    wrong = next(claim for claim in step.claims if _numeric(claim))
    claims = (*(claim for claim in step.claims if claim is not wrong),
              Claim(wrong.left, wrong.right + sp.Rational(1, 10**12)))
    changed: list[Step] = list(record.steps)
    changed[place] = replace(step, claims=claims)
    return replace(record, steps=tuple(changed))


def _numeric(claim: Claim) -> bool:
    return isinstance(claim.left, sp.Expr) and isinstance(claim.right, sp.Expr)


@pytest.mark.parametrize("name", ["fabric", "kinematic_constant", "kinetic_limits"])
def test_a_wrong_step_stops_the_page(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Breaks when a page would show a step that does not hold, or show it as checked."""
    wrong = spoiled(name)
    number = next(k for k, (one, two) in enumerate(zip(wrong.steps, derivation(name).steps, strict=True), start=1)
                  if one != two)
    monkeypatch.setattr(tool, "derivation", lambda _: wrong)
    monkeypatch.setattr(formulas, "derivation", lambda _: wrong)
    with pytest.raises(AssertionError, match=rf"{name}, step {number}: FAILS"):
        steps(name)
    with pytest.raises(AssertionError, match="does not hold"):
        of_steps(name, number)


def test_every_step_stands_on_a_page() -> None:
    """Breaks when a step of a derivation is left out of the book, so that a result seems to come from nowhere."""
    missing = {(name, step) for name, record in records().items() for step in range(1, len(record["steps"]) + 1)
               if (name, step) not in steps_shown()}
    assert missing == set()


def test_every_shown_step_says_that_it_is_checked() -> None:
    """Breaks when a step with claims is shown without the mark and the number of equalities behind it."""
    for name in names():
        text, claimed = steps(name).text, [step for step in derivation(name).steps if step.claims]
        assert text.count("✓ checked, ") == len(claimed), name


def test_a_failing_cell_fails_the_build(book: Path) -> None:
    """Breaks when the book is configured to go on after an error in a cell, which would leave half a page."""
    settings = yaml.safe_load((book / "_config.yml").read_text(encoding="utf-8"))
    assert settings["execute"]["allow_errors"] is False
    assert settings["sphinx"]["config"]["nb_execution_raise_on_error"] is True
