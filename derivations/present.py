"""Show a derivation: as text for the terminal, as LaTeX, as the emitted source, or as page objects for the book."""

from __future__ import annotations

from dataclasses import dataclass

from derivations.catalogue import derivation
from derivations.emit.scalar import scalar_module
from derivations.record import Derivation, Step
from derivations.symbols import GLOSSARY, describe, latex

LONGEST = 2000
"""Characters of an output that is still shown as text [-]."""


def text(record: Derivation) -> str:
    """Return a derivation as plain text, every step checked."""
    lines = [record.title, "=" * len(record.title), ""]
    if record.sources:
        lines.append(f"Equations    {', '.join(record.sources)}")
    lines += [f"Assumption   {assumption}" for assumption in record.assumptions]
    lines += [f"Domain       {condition}" for condition in record.domain]
    known = {quantity.symbol for quantity in GLOSSARY}
    for symbol in record.inputs:
        meaning = f"{describe(symbol).meaning} [{describe(symbol).unit}]" if symbol in known else ""
        lines.append(f"Input        {symbol.name}: {meaning}".rstrip(": "))
    for number, step in enumerate(record.steps, start=1):
        lines += ["", f"{number}. {step.title}   [{verdict(step)}]", f"   {step.because.replace('$', '')}"]
        lines += [f"     {formula}" for formula in step.shown]
    lines += ["", "Outputs"]
    lines += [f"  {output.name} [{output.unit}] = {_readable(str(output.expression))}" for output in record.outputs]
    return "\n".join(lines)


def _readable(expression: str) -> str:
    """An expression that a person can read; one of many lines is left to the other formats."""
    if len(expression) <= LONGEST:
        return expression
    return f"... ({len(expression):,} characters; --format python shows how it is computed)"


def latex_lines(record: Derivation) -> str:
    """Return the outputs of a derivation as LaTeX, one formula a line."""
    return "\n".join(output.latex() for output in record.outputs)


def python_source(record: Derivation) -> str:
    """Return the emitted scalar source of a derivation, or its outputs when nothing is emitted."""
    if record.functions:
        return scalar_module(record)
    return "\n".join(f"{output.name} = {output.expression}" for output in record.outputs)


def verdict(step: Step) -> str:
    """Say what the machine found: checked, how many equalities, or which one fails."""
    if not step.claims:
        return "a definition, nothing to check"
    failed = [claim for claim in step.claims if not claim.holds()]
    if failed:
        return f"FAILS: {failed[0].left} = {failed[0].right} leaves {failed[0].residual()}"
    return f"checked, {len(step.claims)} {'equality' if len(step.claims) == 1 else 'equalities'}"


@dataclass(frozen=True)
class Page:
    """A piece of a page: MyST text that a notebook cell shows."""

    markdown: str

    def _repr_markdown_(self) -> str:
        return self.markdown


def steps(name: str, *, first: int = 1, last: int | None = None, numbered: bool = True) -> Page:
    """Show the steps of a derivation on a page, every equality checked as the page is built.

    Parameters
    ----------
    name : str
        Name of the derivation.
    first, last : int
        Numbers of the first and last step shown, counting from 1; all by default.
    numbered : bool
        Whether formulas carry an equation number and a label, see :func:`label`.

    Raises
    ------
    AssertionError
        A step does not hold; the page must not be built.
    """
    record = derivation(name)
    lines = []
    for number, step in enumerate(record.steps, start=1):
        if number < first or (last is not None and number > last):
            continue
        if not step.holds():
            raise AssertionError(f"{name}, step {number}: {verdict(step)}")
        lines += [f"**{number}. {step.title}.** {step.because} *({verdict(step)})*", ""]
        for position, formula in enumerate(step.shown, start=1):
            lines += ["$$", formula, f"$$ ({label(name, number, position)})" if numbered else "$$", ""]
    return Page("\n".join(lines))


def label(name: str, step: int, position: int) -> str:
    """Label of a formula on a page: the derivation, the step, the place in the step."""
    return f"eq-{name.replace('_', '-')}-{step}-{position}"


def facts(name: str) -> Page:
    """Show what a derivation starts from: equations, assumptions, domain, operation counts."""
    record = derivation(name)
    rows = [("Equations", ", ".join(record.sources) or "none"),
            *(("Assumption", assumption) for assumption in record.assumptions),
            *(("Domain", f"`{condition}`") for condition in record.domain)]
    table = "\n".join(f"| {key} | {value} |" for key, value in rows)
    return Page(f"| {record.title} | |\n|:---|:---|\n{table}\n")


def symbols() -> Page:
    """Show the table of symbols."""
    rows = "\n".join(f"| ${quantity.latex}$ | `{quantity.symbol.name}` | {quantity.unit} | {quantity.meaning} |"
                     for quantity in GLOSSARY)
    return Page(f"| symbol | name in code | unit | meaning |\n|:---|:---|:---|:---|\n{rows}\n")


def outputs(name: str) -> Page:
    """Show the closed forms of a derivation."""
    blocks = [f"$$\n{latex(output.symbol)} = {latex(output.expression)}\n$$\n" for output in derivation(name).outputs]
    return Page("\n".join(blocks))
