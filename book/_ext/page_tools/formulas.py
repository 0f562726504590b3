"""The results of the derivations as numbered equations, in the positive form in which they are computed."""

from __future__ import annotations

from collections.abc import Sequence

from derivations import engineering, kinematic, static
from derivations.symbols import STIFFNESS, lam, latex, one_minus_lam
from page_tools.markup import Markup

POSITIVE_FORMS = {"kinematic": kinematic.positive_components, "static": static.positive_stiffness}
MOMENTS = {
    "kinematic": r"p_k = \bigl\langle 4\pi E\,W^{2} s^{2-k} x^{2k}\bigr\rangle",
    "static": r"p_k = \bigl\langle 4\pi E\,W^{-2} s^{2-k} x^{2k}\bigr\rangle",
}
SCALE = r"(M/V)\,\ell_e^2 k_n"


def stiffness_formulas(hypothesis: str, *, label: str = "") -> Markup:
    """Typeset the six components over (M/V) l_e^2 k_n, their moments and the stiffness ratio; numbered if labelled."""
    components = _aligned([(latex(symbol), latex(expression)) for symbol, expression
                           in zip(STIFFNESS, POSITIVE_FORMS[hypothesis](), strict=True)])
    ratios = (rf"{latex(lam)} = {latex(kinematic.LAM)},\qquad "
              rf"{latex(one_minus_lam)} = 1 - {latex(lam)} = {latex(kinematic.ONE_MINUS_LAM)}")
    return Markup(f"In units of ${SCALE}$,\n\n"
                  f"$$\n{components}\n$${_number(label)}\n\n"
                  "with the moments and ratios\n\n"
                  f"$$\n{MOMENTS[hypothesis]},\\quad k = 0, 1, 2,\n$${_number(label, '-moments')}\n\n"
                  f"$$\n{ratios}.\n$${_number(label, '-ratios')}\n")


def engineering_formulas(*, label: str) -> Markup:
    """Typeset the eight engineering constants."""
    lines = zip(engineering.CONSTANTS, engineering.constants(), strict=True)
    return Markup(f"$$\n{_aligned([(latex(symbol), latex(value)) for symbol, value in lines])}\n$$ ({label})\n")


def _aligned(lines: Sequence[tuple[str, str]]) -> str:
    body = " \\\\[2pt]\n".join(f"{left} &= {right}" for left, right in lines)
    return f"\\begin{{aligned}}\n{body}\n\\end{{aligned}}"


def _number(label: str, part: str = "") -> str:
    return f" ({label}{part})" if label else ""
