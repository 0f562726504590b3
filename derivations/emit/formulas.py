"""Print the results of a derivation for the book's formula sheet: typeset, as LaTeX and as Python, from one record."""

from __future__ import annotations

from derivations.emit.module import operations_before
from derivations.emit.snippets import Snippet, snippets
from derivations.record import Derivation, Step

LONGEST_OPEN = 45
"""Lines of code that are shown at once; longer pieces are folded."""

LONGEST_LATEX = 400
"""Signs of an output that is still offered as LaTeX [-]."""


def formula_fragment(derivation: Derivation) -> str:
    """Return the text of ``book/_formulas/NAME.md``: what it is for, then three tabs with the same results."""
    results = [step for step in derivation.steps if step.result]
    pieces = snippets(derivation)
    return "\n".join([
        f"<!-- Emitted by `derivations write` from the derivation `{derivation.name}`; do not edit. -->", "",
        *_about(derivation, pieces), "",
        ":::::::{tab-set}", "",
        "::::::{tab-item} Formula", "", *[line for step in results for line in _typeset(step)], "::::::", "",
        *_on_screen("LaTeX", [*[line for step in results for line in _latex(step)], *_outputs(derivation)]),
        *_on_screen("Python", [line for piece in pieces for line in _python(piece)]),
        ":::::::", ""])


def _on_screen(title: str, lines: list[str]) -> list[str]:
    """A tab with something to copy, which nobody needs on paper."""
    return [f"::::::{{tab-item}} {title}", ":class-label: only-screen", "",
            ":::::{container} only-screen", "", *lines, ":::::", "", "::::::", ""]


def _about(derivation: Derivation, pieces: tuple[Snippet, ...]) -> list[str]:
    """Source, domain and cost, one line each."""
    costs = ", ".join(f"`{piece.name}` {piece.operations}" for piece in pieces)
    sources = f"From {', '.join(derivation.sources)} of the paper. " if derivation.sources else ""
    return [f"- {sources}Steps: `derivations show {derivation.name}`.",
            f"- Holds for {', '.join(f'`{condition}`' for condition in derivation.domain)}.",
            f"- Operations: {operations_before(derivation)} in the outputs as derived; in the code {costs}."]


def _typeset(step: Step) -> list[str]:
    lines = [f"**{step.title}.** {step.because}", ""]
    for formula in step.shown:
        lines += ["$$", formula, "$$", ""]
    return lines


def _latex(step: Step) -> list[str]:
    return [f"**{step.title}**", "", "```latex", *step.shown, "```", ""]


def _outputs(derivation: Derivation) -> list[str]:
    """Outputs as the machine prints them, where they are short enough to be read."""
    short = [text for text in (output.latex() for output in derivation.outputs) if len(text) <= LONGEST_LATEX]
    if len(short) < len(derivation.outputs):
        return []
    return ["::::{dropdown} All outputs of the derivation, as LaTeX", "", "```latex", *short, "```", "", "::::", ""]


def _python(piece: Snippet) -> list[str]:
    lines = piece.code.splitlines()
    head = [f"::::{{dropdown}} `{piece.name}`, {piece.operations} operations"]
    return [*head, *([":open:"] if len(lines) <= LONGEST_OPEN else []), "", piece.summary, "",
            "```python", *lines, "```", "", "::::", ""]
