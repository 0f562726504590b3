"""Print what the steps of all derivations are about, for indexes of the book that must not derive anything again."""

from __future__ import annotations

import sympy as sp

from derivations.citations import equations_cited
from derivations.record import Derivation, Step
from derivations.symbols import GLOSSARY
from derivations.written import is_defined, is_name, stands_in


def steps_entry(record: Derivation) -> dict[str, object]:
    """What a derivation starts from and uses; of each step its title, the equations cited and the symbols shown."""
    used = _symbols(*record.inputs, *(side for output in record.outputs for side in (output.symbol, output.expression)),
                    *(side for step in record.steps for side in _sides(step)))
    return {"sources": list(record.sources),
            "symbols": [quantity.symbol.name for quantity in GLOSSARY if quantity.symbol in used],
            "steps": [{"title": step.title, "named": equations_cited(step.title),
                       "cited": equations_cited(step.because), "symbols": symbols_shown(step, used)}
                      for step in record.steps]}


def symbols_shown(step: Step, used: set[sp.Basic]) -> list[str]:
    """Names of the declared symbols that the formulas of a step show, in the order of the glossary.

    A single letter counts where the claims behind the formulas hold its symbol, or where it is defined and the
    derivation uses it; elsewhere it may be an index or a differential.
    """
    claimed = _symbols(*_sides(step))
    return [symbol.name for symbol, latex in ((quantity.symbol, quantity.latex) for quantity in GLOSSARY)
            if any(stands_in(latex, formula)
                   and (is_name(latex) or symbol in claimed or (symbol in used and is_defined(latex, formula)))
                   for formula in step.shown)]


def _sides(step: Step) -> list[sp.Basic]:
    return [side for claim in step.claims for side in (claim.left, claim.right)]


def _symbols(*expressions: sp.Basic) -> set[sp.Basic]:
    return set().union(*(expression.free_symbols for expression in expressions))
