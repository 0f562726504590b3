"""Every step of every derivation is proved, and a wrong one is caught."""

from __future__ import annotations

import pytest
import sympy as sp

from derivations import catalogue
from derivations.record import Claim
from derivations.symbols import GLOSSARY, p0, p1


@pytest.mark.parametrize("name", catalogue.names())
def test_steps_hold(name: str) -> None:
    """A sign or a coefficient changed anywhere in a step leaves a residual."""
    wrong = [(number, step.title, str(claim.residual()))
             for number, step in enumerate(catalogue.derivation(name).steps, start=1)
             for claim in step.claims if not claim.holds()]
    assert wrong == []


@pytest.mark.parametrize(("left", "right"), [
    (p0 + p1, p0 - p1),
    (sp.Rational(1, 3) * p0, sp.Rational(2, 15) * p0),
    (sp.Interval(-1, 2), sp.Interval.open(-1, 2)),
    (sp.sqrt(p0) ** 2, p0 + sp.Rational(1, 10**30)),
])
def test_a_wrong_claim_fails(left: sp.Basic, right: sp.Basic) -> None:
    """A claim that cannot fail would prove nothing."""
    assert not Claim(left, right).holds()


def test_almost_every_step_has_a_claim() -> None:
    """Only definitions may stand unchecked; a derivation of unchecked steps would break this."""
    unchecked = [(build.__name__, step.title) for build in catalogue.CATALOGUE for step in build().steps
                 if not step.claims]
    assert unchecked == [("equations", "Energy of a strained assembly, eq. (1)"),
                         ("static_constant", "Strain from the contact displacements"),
                         ("static_three", "Strain from the contact displacements")]


@pytest.mark.parametrize("name", catalogue.names())
def test_record_is_complete(name: str) -> None:
    """A record without sources, assumptions, domain or declared inputs breaks this."""
    record = catalogue.derivation(name)
    assert record.name == name
    assert record.title and record.assumptions and record.domain and record.outputs and record.steps
    if record.functions:
        declared = {quantity.symbol for quantity in GLOSSARY}
        assert set(record.inputs) <= declared
        free = set().union(*(output.expression.free_symbols for output in record.outputs))
        moments = set(sp.symbols("p0 p1 p2", positive=True))
        assert free <= set(record.inputs) | moments


def test_symbols_are_declared_once() -> None:
    """Two declarations of one name or one LaTeX would let two meanings share a letter."""
    names = [quantity.symbol.name for quantity in GLOSSARY]
    typeset = [quantity.latex for quantity in GLOSSARY]
    assert len(set(names)) == len(names)
    assert len(set(typeset)) == len(typeset)
