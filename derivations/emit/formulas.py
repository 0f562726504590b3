"""Print the results of a derivation as a page fragment: LaTeX formulas for the book's formula sheet."""

from __future__ import annotations

from derivations.record import Derivation


def formula_fragment(derivation: Derivation) -> str:
    """Return the text of ``book/_formulas/NAME.md``: the formulas of the steps that state results."""
    lines = [f"<!-- Emitted by `derivations write` from the derivation `{derivation.name}`; do not edit. -->", ""]
    for step in derivation.steps:
        if not step.result:
            continue
        lines += [f"**{step.title}.** {step.because}", ""]
        for formula in step.shown:
            lines += ["$$", formula, "$$", ""]
    return "\n".join(lines)
