"""Tables III to V of the paper, with contact forces and slip: exact, by the paper's quadrature, and as printed."""

from __future__ import annotations

import tomllib
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache

from granular import Evaluation, Scene, evaluate
from page_tools.markup import Markup, table
from page_tools.paper import PANELS, RATIOS, SCENE, by_midpoint, cases, percent, typeset, verdict

TABLES = {"II": "_data/table_ii.csv", "III": "_data/table_iii.csv", "IV": "_data/table_iv.csv",
          "V": "_data/table_v.csv"}
"""Data files of the printed tables."""

EFFECTS = {"packing branches": "equal contacts", "packing branches kinetic": "forces",
           "packing branches kinetic slip": "forces and slip"}
"""What the effects of a case amount to."""

VARIED = {"III": "case", "IV": "$D_{33}$", "V": r"$\sigma_{33}/\sigma_{11}$"}
"""Head of the first column: what the cases of Tables IV and V vary."""

GROSS = 0.1
"""No quadrature of these integrands with dozens of panels is off by so much: such a printed value is a misprint."""

BY_SYMMETRY = 1e-12
"""A ratio this close to 1 is 1 because the assembly is isotropic."""


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

    def verdict(self) -> str:
        """How the printed value came about."""
        if self.isotropic:
            return "symmetry"
        return f"for {self.meant}" if self.misprint else verdict(self.panels, self.printed)


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


def table_of(name: str) -> Markup:
    """Compare exact, 24-panel and printed ratios of one table."""
    found = printed_ratios(name)
    rows = [[_named(ratio, explained=True), *_row(ratio)] for ratio in found]
    return table([VARIED[name], *_HEADER], rows, label=f"tab-table-{name.lower()}", align="llrrrrl",
                 take_away=f"table_{name.lower()}_compared.csv",
                 caption=f"Table {name} of the paper. Exact values are certified; their relative error is below "
                         f"{_tenfold(max(ratio.error for ratio in found))}.")


def verdicts() -> Markup:
    """List all printed ratios of Tables II to V in one table."""
    found = list(_independent())
    rows = [[f"{ratio.table}, {_named(ratio)}", *_row(ratio)] for ratio in found]
    counts = Counter("misprint" if ratio.misprint else ratio.verdict() for ratio in found)
    return table(["table, case", *_HEADER], rows, label="tab-verdicts", align="llrrrrl",
                 take_away="tables_ii_to_v_compared.csv",
                 caption=f"The {len(found)} printed ratios of Tables II to V: "
                         f"{', '.join(f'{count} {kind}' for kind, count in counts.most_common())}. Cases of "
                         "Table IV are values of $D_{33}$, those of Table V stress ratios. Left out are isotropic "
                         "rows, and case 1 of Table III, which repeats case 3 of Table II.")


def panel_counts(first: int, last: int) -> Markup:
    """Count, for each number of panels, how many of the printed ratios the midpoint rule gives."""
    rows = []
    for panels in range(first, last + 1):
        kinds = Counter(kind for _, kind in _verdicts(panels))
        rows.append([str(panels), *(str(kinds[kind]) for kind in ("rounded", "cut", "no")),
                     str(sum(kind != "no" for ratio, kind in _verdicts(panels) if not ratio.misprint))])
    whole, legible = len(list(_independent())), sum(not ratio.misprint for ratio in _independent())
    return table(["panels", "rounded", "cut", "not at all", "without misprints"], rows, label="tab-all-panels",
                 align="lrrrr", take_away="panel_counts.csv",
                 caption=f"How many of the {whole} ratios a midpoint rule gives, by its number of panels. The two "
                         f"misprints count as corrected; the last column leaves them out, of {legible}.")


def which_panels(first: int, last: int) -> Markup:
    """Say which numbers of panels give every printed ratio, and how near the others come."""
    matches = {panels: sum(kind != "no" for _, kind in _verdicts(panels)) for panels in range(first, last + 1)}
    legible = {panels: sum(kind != "no" for ratio, kind in _verdicts(panels) if not ratio.misprint)
               for panels in matches}
    whole, readable = len(list(_independent())), sum(not ratio.misprint for ratio in _independent())
    all_of_them = [panels for panels, count in matches.items() if count == whole]
    all_readable = [panels for panels, count in legible.items() if count == readable]
    if all_of_them != [PANELS] or all_readable != [PANELS]:
        raise AssertionError(f"{all_of_them} and {all_readable} reproduce the tables")
    runner_up = max((panels for panels in matches if panels != PANELS), key=lambda panels: (matches[panels], -panels))
    return Markup(f"Of all numbers of panels from {first} to {last}, {PANELS} alone gives all {whole} ratios, and it "
                  f"alone gives the {readable} that are printed without misprint. The next best, {runner_up} panels, "
                  f"gives {matches[runner_up]}.")


def isotropic_by_panels() -> Markup:
    """Say what the paper's quadrature would give for the rows that are 1 by symmetry."""
    found = [ratio for ratio in printed_ratios("IV") if ratio.isotropic]
    values = " and ".join(f"{ratio.panels:.3f}" for ratio in found)
    return Markup(f"One thing does not fit: {PANELS} panels would give {values} for the isotropic rows of Tables IV "
                  "and V, where 1.000 is printed. Those rows need no computation, and were probably not computed.")


_HEADER = ["ratio", "exact", f"{PANELS} panels", "printed", "off by", "verdict"]


def _row(ratio: Printed) -> list[str]:
    return [typeset(ratio.name), f"{ratio.exact:.6f}", f"{ratio.panels:.6f}", ratio.printed,
            "misprint" if ratio.misprint else percent(float(ratio.printed) / ratio.exact - 1), ratio.verdict()]


def _named(ratio: Printed, *, explained: bool = False) -> str:
    """Set the name of a case: a number, or the value that is varied."""
    name = ratio.case["case"].rpartition(" = ")[2]
    return f"{name}, {EFFECTS[ratio.case['effects']]}" if explained and ratio.table == "III" else name


def _independent() -> Iterator[Printed]:
    """All printed ratios but those that are 1 by symmetry and those that repeat another table."""
    for name in TABLES:
        for ratio in printed_ratios(name):
            repeated = name == "III" and ratio.case["effects"] == "packing branches"
            if not (ratio.isotropic or repeated):
                yield ratio


@lru_cache(maxsize=128)
def _verdicts(panels: int) -> tuple[tuple[Printed, str], ...]:
    return tuple((ratio, verdict(_by_panels(ratio, panels)[ratio.name], ratio.meant)) for ratio in _independent())


def _by_panels(ratio: Printed, panels: int) -> dict[str, float]:
    return _cached(ratio.table, ratio.case["case"], panels)


@lru_cache(maxsize=4096)
def _cached(name: str, which: str, panels: int) -> dict[str, float]:
    case = next(case for case in cases(TABLES[name]) if case["case"] == which)
    return by_midpoint(evaluated(case), panels)


def _tenfold(error: float) -> str:
    """A bound as a power of ten, rounded up."""
    digits, exponent = f"{error:.0e}".split("e")
    return rf"${int(digits) + 1}\times10^{{{int(exponent)}}}$"
