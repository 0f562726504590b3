"""The corpus of hard cases on a page: naive against certified against what the library gives."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from functools import lru_cache

from granular import figures
from granular.checks.hard_cases import HardComparison, comparison
from granular.figures.page import Static
from granular.routes.result import COMPONENTS
from page_tools.markup import Markup, plain, table

SYMBOLS = {"k_r/k_n": "k_r/k_n", "k_n": "k_n", "k_r": "k_r", "mu": r"\mu", "nu": r"\nu", "lambda_0": r"\lambda_0",
           "sigma33/sigma11": r"\sigma_{33}/\sigma_{11}", "D33": "D_{33}", "G_s": "G_s"}
"""Symbols in the words of the cases, as formulas."""

_SYMBOL = re.compile(rf"\b(?:({'|'.join(map(re.escape, SYMBOLS))})|1e(-?\d+)|C(\d{{4}}))\b")


@dataclass(frozen=True, slots=True)
class Drawn:
    """What the figure shows of a case."""

    name: str
    naive_label: str
    naive_error: float
    stable_error: float


@lru_cache(maxsize=1)
def compared() -> tuple[HardComparison, ...]:
    """Compute the corpus once for the page; a case that is not as stated stops the build."""
    found = comparison()
    missed = [case.name for case in found if not case.as_stated]
    if missed:
        raise AssertionError(f"hard cases that are not as stated: {missed}")
    return found


def hard_case_figure() -> Static:
    """Draw one row for each naive way, the case on which it does worst."""
    worst: dict[str, HardComparison] = {}
    for case in compared():
        if case.certified != 0:
            kept = worst.setdefault(case.naive_label, case)
            worst[case.naive_label] = max(kept, case, key=_badness)
    return figures.hard_cases([Drawn(case.name, case.naive_label, _error(case), case.stable_error)
                               for case in worst.values()])


def hard_case_table() -> Markup:
    """List every case: why it is hard, its certified value, what a naive way gives, what the library gives."""
    rows = [[f"**{_set(case.name[0].upper() + case.name[1:])}.** {_set(case.why)}",
             f"{_component(case.component)}<br>{_number(float(case.certified))}",
             f"{_set(case.naive_label)}<br>{_number(case.naive)}", _size(_error(case)), _size(case.stable_error)]
            for case in compared()]
    taken = [["case", "why it is hard", "component", "certified", "naive way", "naive value", "its error",
              "error here"],
             *([case.name, case.why, case.component, repr(float(case.certified)), case.naive_label, repr(case.naive),
                f"{_error(case):.1e}", f"{case.stable_error:.1e}"] for case in compared())]
    return table(["case, and why it is hard", "certified", "naive", "error", "error here"], rows,
                 label="tab-hard-cases", align="lllrr", take_away="hard_cases.csv", taken=taken, look="words-first",
                 caption="Hard cases, with the component in question and its certified value, a naive way of computing "
                         "and what it gives, and the relative errors of both. Values over "
                         "$(M/V)\\,\\ell_e^2 k_n^{\\circ}$, except where this unit itself is in question, in Pa.")


def hard_case_summary() -> Markup:
    """Say how many cases there are and how the two sides fare."""
    found = compared()
    useless = sum(not case.naive_error < 1 for case in found)
    return Markup(f"{len(found)} cases. The naive ways miss {useless} of them by more than the value itself or give no "
                  f"number at all; the library's worst relative error is "
                  f"{_size(max(case.stable_error for case in found))}.")


def cube_root_trap() -> Markup:
    """Show the ratio that a cube root of negative numbers gives under the stress ratio 2 of Table V."""
    from granular.checks import naive
    from granular.routes import axial

    case = next(one.case for one in compared() if one.name == "Table V, sliding")
    across, along = COMPONENTS.index("C2323"), COMPONENTS.index("C1212")
    wrong = naive.unguarded_cube_root(case.fabric, case.loading, case.poisson_ratio, case.hypothesis)
    right = axial.evaluate(case.fabric, poisson_ratio=case.poisson_ratio, hypothesis=case.hypothesis,
                           loading=case.loading).components
    return Markup(f"$C_{{2323}}/C_{{1212}} = {wrong[across] / wrong[along]:.3f}$ instead of "
                  f"${right[across] / right[along]:.3f}$.")


def _badness(case: HardComparison) -> float:
    """Order naive results; one that is no number is worst."""
    return math.inf if math.isnan(case.naive) else case.naive_error


def _error(case: HardComparison) -> float:
    return math.nan if math.isnan(case.naive) else case.naive_error


def _set(text: str) -> str:
    """Set symbols and powers of ten in the words of a case as formulas."""
    pieces, last = [], 0
    for found in _SYMBOL.finditer(text):
        symbol, power, index = found.groups()
        formula = SYMBOLS[symbol] if symbol else f"10^{{{int(power)}}}" if power else f"C_{{{index}}}"
        pieces += [plain(text[last:found.start()]), f"${formula}$"]
        last = found.end()
    return "".join([*pieces, plain(text[last:])])


def _component(name: str) -> str:
    return f"$C_{{{name[1:]}}}$" if name in COMPONENTS else r"$(M/V)\,\ell_e^2 k_n^{\circ}$"


def _number(value: float) -> str:
    if math.isnan(value):
        return "no number"
    return "overflow" if math.isinf(value) else f"{value:.7g}".replace("-", "−")


def _size(error: float) -> str:
    if math.isnan(error):
        return "no number"
    if math.isinf(error):
        return "–"
    return (f"{error:.2g}" if error == 0 or 0.01 <= error < 100 else f"{error:.1e}").replace("-", "−")
