"""Tables II to V of the paper: exact, by the paper's own quadrature, as printed, and how these differ."""

from __future__ import annotations

import math
import tomllib
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

from granular import Evaluation, Scene, evaluate
from granular.figures.page import Static
from granular.figures.printed_tables import ratios as draw_ratios
from page_tools.markup import Markup, boxed, table
from page_tools.paper import PANELS, RATIOS, SCENE, by_midpoint, cases, percent, typeset, verdict

TABLES = {"II": "_data/table_ii.csv", "III": "_data/table_iii.csv", "IV": "_data/table_iv.csv",
          "V": "_data/table_v.csv"}
"""Data files of the printed tables."""

MEANING = {
    "II": {"1": "branches", "2": "packing", "3": "both"},
    "III": {"1": "equal contacts", "2": "forces", "3": "forces and slip"}}
"""What the numbered cases stand for."""

VARIED = {"II": "case", "III": "case", "IV": "$D_{33}$", "V": r"$\sigma_{33}/\sigma_{11}$"}
"""Head of the first column: what the cases of Tables IV and V vary."""

GROSS = 0.1
"""No quadrature of these integrands with dozens of panels is off by so much: such a printed value is a misprint."""

BY_SYMMETRY = 1e-12
"""A ratio this close to 1 is 1 because the assembly is isotropic."""

WORDS = {"rounded": "rule, rounded", "cut": "rule, cut", "no": "not explained", "symmetry": "by symmetry"}
"""Verdicts as a table shows them."""


@dataclass(frozen=True, slots=True)
class Printed:
    """One printed ratio with what it should be."""

    table: str
    case: dict[str, str]
    name: str
    exact: float
    error: float
    panels: float
    printed: str

    @property
    def isotropic(self) -> bool:
        """Whether the ratio is 1 whatever the quadrature should say."""
        return abs(self.exact - 1) < BY_SYMMETRY

    @property
    def misprint(self) -> bool:
        """Whether no quadrature error can explain the printed value."""
        return abs(float(self.printed) - self.exact) > GROSS

    @property
    def meant(self) -> str:
        """The printed value, or for a misprint what the paper's quadrature gives in its place."""
        return f"{self.panels:.3f}" if self.misprint else self.printed

    @property
    def kind(self) -> str:
        """How the printed value came about: rounded, cut, no, symmetry or misprint."""
        if self.isotropic:
            return "symmetry"
        return "misprint" if self.misprint else verdict(self.panels, self.printed)

    @property
    def ruling(self) -> str:
        """The same in words."""
        return f"misprint for {self.meant}" if self.misprint else WORDS[self.kind]

    @property
    def off(self) -> str:
        """By how much the printed value differs from the exact one."""
        return "–" if self.misprint or self.isotropic else percent(float(self.printed) / self.exact - 1)

    @property
    def label(self) -> str:
        """The case by its number, or by the value that is varied."""
        return self.case["case"].rpartition(" = ")[2]


def scene_of(case: dict[str, str]) -> Scene:
    """Take the scene of Table II, case 3, with the fabric, stress, friction and effects of a case."""
    content = tomllib.loads(SCENE.read_text(encoding="utf-8"))
    content["packing"]["contact_normals"] = {"D33": float(case["D33"])}
    content["branches"]["anisotropy"] = {"D33": float(case["Dr33"])}
    content["model"]["effects"] = case.get("effects", "packing branches").split()
    if "stress_ratio" in case:
        content["stress"]["ratio"] = float(case["stress_ratio"])
        content["grains"]["friction_angle"] = case["friction_angle"]
    return Scene.model_validate(content)


def evaluated(case: dict[str, str], *, route: str = "auto") -> Evaluation:
    """Evaluate one case by a route."""
    return evaluate(scene_of(case), route=route)


@lru_cache(maxsize=8)
def printed_ratios(name: str) -> tuple[Printed, ...]:
    """Both ratios of every case of a table."""
    found = []
    for case in cases(TABLES[name]):
        result = evaluated(case, route="certified")
        panels = by_midpoint(result, PANELS)
        found += [Printed(name, case, ratio.name, ratio.value, 2 * result.relative_error, panels[ratio.name],
                          case[column])
                  for ratio, (_, column) in zip(result.ratios, RATIOS, strict=True)]
    return tuple(found)


HEADER = ("ratio", "exact", f"{PANELS} panels", "printed", "printed − exact", "verdict")


def row(ratio: Printed) -> list[str]:
    """The columns of HEADER for one ratio."""
    return [typeset(ratio.name), f"{ratio.exact:.6f}", f"{ratio.panels:.6f}", ratio.printed, ratio.off, ratio.ruling]


def taken(found: Sequence[Printed]) -> list[list[str]]:
    """Header and rows of the file beside a table: names without markup, all digits."""
    return [["table", "case", "ratio", "exact", f"{PANELS} panels", "printed", "verdict"],
            *([ratio.table, ratio.case["case"], ratio.name, f"{ratio.exact:.15g}", f"{ratio.panels:.15g}",
               ratio.printed, ratio.ruling] for ratio in found)]


def table_of(name: str) -> Markup:
    """Compare exact, 24-panel and printed ratios of one table."""
    found = printed_ratios(name)
    meaning = MEANING.get(name, {})
    first = [(f"{ratio.label}, {meaning[ratio.label]}" if meaning else ratio.label) if number % 2 == 0 else ""
             for number, ratio in enumerate(found)]
    rows = [[words, *row(ratio)] for words, ratio in zip(first, found, strict=True)]
    return table([VARIED[name], *HEADER], rows, label=f"tab-table-{name.lower()}", align="llrrrrl",
                 take_away=f"table_{name.lower()}_compared.csv", taken=taken(found),
                 caption=f"Table {name} of the paper: the exact ratio, the ratio by the paper's own rule, and what is "
                         "printed. Exact values are certified; their relative error is below "
                         f"{_tenfold(max(ratio.error for ratio in found))}.")


def picture_of(name: str) -> Static:
    """Draw both ratios of every case, exact and printed."""
    found = printed_ratios(name)
    named = [ratio.case["case"].replace("D33", "$D_{33}$").replace("SR", "ratio") for ratio in found[::2]]
    labels = [name if "=" in name else f"case {name}" for name in named]
    of_name = {ratio: [one for one in found if one.name == ratio] for ratio, _ in RATIOS}
    return Static(draw_ratios(
        labels, {ratio: [one.exact for one in ones] for ratio, ones in of_name.items()},
        {ratio: [float(one.printed) for one in ones] for ratio, ones in of_name.items()}))


def finding(name: str, *more: Markup) -> Markup:
    """Box what the comparison says of one table; a printed value without an explanation stops the build."""
    found = printed_ratios(name)
    kinds = Counter(ratio.kind for ratio in found)
    assert not kinds["no"], f"Table {name} has printed values that nothing explains"
    ruled = kinds["rounded"] + kinds["cut"]
    said = [f"{'All' if ruled == len(found) else 'Of the'} {len(found)} printed ratios"
            + ("" if ruled == len(found) else f" {ruled}") + " are those of the paper's own rule, "
            + ("after rounding" if not kinds["cut"] else f"{kinds['rounded']} after rounding and {kinds['cut']} after "
               "cutting the further digits") + "."]
    if kinds["symmetry"]:
        said.append(f"{_number(kinds['symmetry'])} are 1 by symmetry.")
    if kinds["misprint"]:
        said.append(f"{_number(kinds['misprint'])} are misprints.")
    said.append(f"From the exact values the sound ones differ by up to {worst(found)}.")
    return boxed(f"What Table {name} holds", Markup(" ".join(said)), *more)


def worst(found: Sequence[Printed]) -> str:
    """The largest difference between a printed ratio and its exact value, misprints aside."""
    largest = max(abs(float(ratio.printed) / ratio.exact - 1) for ratio in found if not ratio.misprint)
    return f"{100 * largest:.2f} %"


def _number(count: int) -> str:
    return {1: "One", 2: "Two", 3: "Three", 4: "Four"}[count]


def _tenfold(error: float) -> str:
    """A bound as a power of ten, rounded up."""
    exponent = str(math.ceil(math.log10(error))).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
    return f"10{exponent}"
