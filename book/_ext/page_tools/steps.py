"""A derivation on a page: what it assumes, then its steps, each checked by the machine while the page is built."""

from __future__ import annotations

import re
from collections.abc import Sequence

from derivations.catalogue import derivation
from derivations.present import verdict
from derivations.record import Derivation, Step
from page_tools.markup import Markup

_DEFINITION = re.compile(r"([^=<>,]{1,40}?)=(?!\s*0:)")
_WIDE_GAP, _ANY_GAP = re.compile(r"(?<=[,;:])\s*\\qquad"), re.compile(r"(?<=[,;:])\s*\\qquad|(?<=,)\s*\\quad")
"""What stands between formulas side by side."""
_RELATION = re.compile(r"=|\\(?:sim|le|ge|to|propto)(?![a-zA-Z])")
"""What makes a formula out of what stands between two gaps."""
LONGEST_ALIGNED = 66
"""Formulas up to this many visible signs are set below one another; longer ones stand alone and can be broken."""


WIDEST_ROW = 39
"""Formulas side by side stay so up to about this many signs and spaces in a line."""

_FUNCTIONS = ("tan", "sin", "cos", "sinh", "cosh", "arctan", "ln", "exp", "max", "min", "iff", "dots", "dim")
_WITHOUT_WIDTH = re.compile(r"\\(?:t?frac|left|right|mathrm|text|operatorname|sqrt|[bB]ig[lr]?|[,!;: ])")


def assumptions(name: str) -> Markup:
    """List what a derivation assumes, where its result holds, and the equations of the paper it starts from."""
    record = derivation(name)
    lines = [*record.assumptions, "Holds for " + ", ".join(f"`{condition}`" for condition in record.domain) + "."]
    if record.sources:
        lines.append(f"Equations of the paper: {', '.join(record.sources)}.")
    return Markup("\n".join(f"- {line}" for line in lines) + "\n")


def steps(name: str, *, first: int = 1, last: int | None = None) -> Markup:
    """Show steps of a derivation; one that does not hold stops the build.

    Parameters
    ----------
    name : str
        Name of the derivation.
    first, last : int
        Numbers of the first and the last step shown, counting from 1; all by default.
    """
    return steps_of(derivation(name), first=first, last=last)


def steps_of(record: Derivation, *, first: int = 1, last: int | None = None) -> Markup:
    """Show steps of a derivation that is given itself, as one that is not in the catalogue."""
    shown = [(number, step) for number, step in enumerate(record.steps, start=1)
             if first <= number <= (last or len(record.steps))]
    return Markup("\n".join(_step(record, number, step) for number, step in shown))


def _step(record: Derivation, number: int, step: Step) -> str:
    found = verdict(step)
    if found.startswith("FAILS"):
        raise AssertionError(f"{record.name}, step {number}: {found}")
    label = f"eq-{record.name.replace('_', '-')}-{number}"
    mark = f"✓ {found}" if step.claims else found
    return (f"{{.step}}\n[{number}]{{.step-number}} **{step.title}** [{mark}]{{.verdict}}\n\n"
            f"{step.because}\n\n{display(step.shown, label)}")


def display(formulas: Sequence[str], label: str) -> str:
    """Set formulas under one number where they are short; else each alone, the last one numbered.

    Formulas side by side that would not fit are set below one another.
    """
    if not formulas:
        return ""
    formulas = [part for formula in formulas for part in parts(formula)]
    if len(formulas) > 1 and max(map(_signs, formulas)) <= LONGEST_ALIGNED:
        environment, rows = _rows(formulas)
        below = " \\\\[3pt]\n".join(rows)
        return f"$$\n\\begin{{{environment}}}\n{below}\n\\end{{{environment}}}\n$$ ({label})\n"
    *before, final = formulas
    return "\n".join(f"$$\n{formula}\n$$\n" for formula in before) + f"\n$$\n{final}\n$$ ({label})\n"


def parts(formula: str) -> list[str]:
    """Take apart what stands side by side where it is too wide for a line."""
    for gap in (_ANY_GAP, _WIDE_GAP):
        found = [part.strip() for part in gap.split(formula)]
        sound = all(_RELATION.search(part) or part.endswith(":") for part in found)
        if sound:
            break
    return found if sound and _width(formula) > WIDEST_ROW else [formula]


def _width(formula: str) -> int:
    """Estimate how wide a formula is in signs, spaces between formulas among them."""
    spaced = _WITHOUT_WIDTH.sub(" ", formula).replace(r"\qquad", "####").replace(r"\quad", "##")
    named = re.sub(r"\\([a-zA-Z]+)", lambda found: "#" * (len(found[1]) if found[1] in _FUNCTIONS else 1), spaced)
    return len(re.sub(r"[\\{}_^\s]", "", named))


def _signs(formula: str) -> int:
    """Count about how many signs a reader sees in a formula."""
    return len(re.sub(r"\\[a-zA-Z]+|[\\{}_^\s]", " ", formula).replace(" ", ""))


def _rows(formulas: Sequence[str]) -> tuple[str, Sequence[str]]:
    """Align definitions at their equality signs; centre what is not all definitions."""
    if all(map(_is_definition, formulas)):
        return "aligned", [_DEFINITION.sub(r"\1&=", formula, count=1) for formula in formulas]
    return "gathered", formulas


def _is_definition(formula: str) -> bool:
    """Whether something stands left of an equality sign that is not part of an index."""
    found = _DEFINITION.match(formula)
    return found is not None and found[1].count("{") == found[1].count("}")
