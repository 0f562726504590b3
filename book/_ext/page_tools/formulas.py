"""The results of the derivations as numbered equations, in the positive form in which they are computed."""

from __future__ import annotations

import sympy as sp

from derivations import kinematic, static
from derivations.catalogue import derivation
from derivations.fabric import fabric_tensor
from derivations.symbols import (
    C1111,
    C1122,
    C1133,
    C1212,
    C2323,
    C3333,
    N11,
    N33,
    S2323,
    STIFFNESS,
    lam,
    latex,
    one_minus_lam,
    p0,
    p1,
    p2,
)
from page_tools.markup import Markup
from page_tools.steps import display, parts

SCALE = r"(M/V)\,\ell_e^2 k_n"
MOMENTS = r"p_k = \bigl\langle 4\pi E\,W^{%s} s^{2-k} x^{2k}\bigr\rangle,\quad k = 0, 1, 2,"
DELTA, SIGMA = sp.symbols("Delta Sigma", positive=True)
SHORTHAND = {
    DELTA: lam * p0 * p2 + p1 * (p0 + p1 + p2) + one_minus_lam * p1**2,
    SIGMA: (1 + lam) * p0 + 2 * p1,
}
"""Sums that occur more than once in the static stiffness."""

Line = tuple[sp.Symbol, sp.Expr]


def kinematic_formulas(*, label: str = "") -> Markup:
    """Typeset the six components over (M/V) l_e^2 k_n, their moments and the stiffness ratio."""
    lines = list(zip(STIFFNESS, kinematic.positive_components(), strict=True))
    return _in_parts(label, power="2", components=lines, further=())


def static_formulas(*, label: str = "") -> Markup:
    """Typeset the same for the static hypothesis, with shorthand for what would stand there twice.

    Raises
    ------
    AssertionError
        The short form is not the derived one; the page must not be built.
    """
    derived = dict(zip(STIFFNESS, static.positive_stiffness(), strict=True))
    short = {symbol: derived[symbol].subs({whole: name for name, whole in SHORTHAND.items()})
             for symbol in (C3333, C1122, C1133, C1212)}
    short |= {C1111: C1122 + 2 * C1212, C2323: 1 / (4 * S2323)}
    further = {**SHORTHAND, S2323: static.positive_compliance()[4],
               **dict(zip((N11, N33), fabric_tensor(), strict=True))}
    _require_same(derived, short, further)
    return _in_parts(label, power="-2", components=[(symbol, short[symbol]) for symbol in STIFFNESS],
                     further=tuple(further.items()))


def of_steps(name: str, *places: int | tuple[int, int], label: str = "") -> Markup:
    """Typeset formulas of a derivation after the machine has checked their steps; the last one carries the label.

    Parameters
    ----------
    name : str
        Name of the derivation.
    places : int or tuple of int
        Steps, counted from 1, of which all formulas are shown; or a step and one of its formulas.
    label : str
        Name to refer to.

    Raises
    ------
    AssertionError
        A step does not hold; the page must not be built.
    """
    record, formulas = derivation(name), []
    for place in places:
        number, *position = (place,) if isinstance(place, int) else place
        step = record.steps[number - 1]
        if not step.holds():
            raise AssertionError(f"{name}: {step.title} does not hold")
        formulas += [step.shown[position[0] - 1]] if position else list(step.shown)
    if label:
        return Markup(display(formulas, label))
    return Markup("\n".join(_display(part, "") for formula in formulas for part in parts(formula)) + "\n")


def _in_parts(label: str, *, power: str, components: list[Line], further: tuple[Line, ...]) -> Markup:
    """Components first, then what they contain: moments, shorthand, ratios."""
    ratios = (rf"\begin{{aligned}}{latex(lam)} &= {latex(kinematic.LAM)}, \\[3pt] {latex(one_minus_lam)} &= "
              rf"1 - {latex(lam)} = {latex(kinematic.ONE_MINUS_LAM)}.\end{{aligned}}")
    parts = [f"In units of ${SCALE}$,", _display(_aligned(components), label), "with",
             _display(MOMENTS % power, label and f"{label}-moments"),
             *([_display(_aligned(list(further)), label and f"{label}-shorthand")] if further else []),
             _display(ratios, label and f"{label}-ratios")]
    return Markup("\n\n".join(parts) + "\n")


def _require_same(derived: dict[sp.Symbol, sp.Expr], short: dict[sp.Symbol, sp.Expr],
                  further: dict[sp.Symbol, sp.Expr]) -> None:
    tensor = {N11, N33}
    whole = {name: value for name, value in further.items() if name not in tensor}
    for symbol in STIFFNESS:
        gap = short[symbol].subs(short).subs(whole) - derived[symbol]
        assert sp.cancel(gap.subs(one_minus_lam, 1 - lam)) == 0, f"{symbol}: short form differs"


def _display(formula: str, label: str) -> str:
    return f"$$\n{formula}\n$$" + (f" ({label})" if label else "")


def _aligned(lines: list[Line]) -> str:
    body = " \\\\[3pt]\n".join(f"{latex(left)} &= {latex(right)}" for left, right in lines)
    return f"\\begin{{aligned}}\n{body}\n\\end{{aligned}}"
