"""Which quadrature the paper used: all printed ratios by rules of every number of panels."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from functools import lru_cache

from granular.figures.page import Static
from granular.figures.printed_tables import differences as draw_differences
from granular.figures.printed_tables import matches as draw_matches
from granular.routes.midpoint import PRINTED_PANELS as PANELS
from page_tools.markup import Markup, boxed, numbers_to_take_away, table
from page_tools.paper import by_midpoint, cases, typeset, verdict
from page_tools.paper_tables import HEADER, TABLES, Printed, evaluated, printed_ratios, row, taken, worst

TRIED = range(6, 61)
"""Numbers of panels that are tried."""


def verdicts() -> Markup:
    """List all printed ratios of Tables II to V in one table."""
    found = independent()
    rows = [[f"{ratio.table}, {ratio.label}", *row(ratio)] for ratio in found]
    return table(["table, case", *HEADER], rows, label="tab-verdicts", align="llrrrrl",
                 take_away="tables_ii_to_v_compared.csv", taken=taken(found),
                 caption=f"The {len(found)} printed ratios of Tables II to V. Cases of Table IV are values of "
                         "$D_{33}$, those of Table V stress ratios. Left out are isotropic rows, and case 1 of Table "
                         "III, which repeats case 3 of Table II.")


def verdict_counts() -> Markup:
    """Count the verdicts of each table."""
    names = ("rounded", "cut", "misprint", "symmetry")
    rows = []
    for name in TABLES:
        kinds = Counter(ratio.kind for ratio in printed_ratios(name))
        rows.append([f"[{name}](table_{name.lower()}.md)", *(str(kinds[kind]) for kind in names),
                     worst(printed_ratios(name))])
    return table(["table", "rounded", "cut", "misprint", "symmetry", "farthest"],
                 rows, label="tab-verdict-counts", align="lrrrrr", take_away="verdict_counts.csv",
                 caption="How many printed ratios of each table have which verdict: the rule's "
                         "value rounded or cut, a misprint, or 1 by symmetry. Last, the largest difference between a "
                         "sound printed ratio and its exact value.")


def panel_counts(first: int, last: int) -> Markup:
    """Count, for each number of panels, how many of the printed ratios the midpoint rule gives."""
    whole, sound = len(independent()), sum(not ratio.misprint for ratio in independent())
    rows = []
    for panels in range(first, last + 1):
        kinds = Counter(kind for _, kind in _verdicts(panels))
        rows.append([str(panels), *(str(kinds[kind]) for kind in ("rounded", "cut", "no")), str(_sound(panels))])
    return table(["panels", "rounded", "cut", "not at all", "without misprints"], rows, label="tab-all-panels",
                 align="lrrrr", take_away="panel_counts.csv",
                 caption=f"How many of the {whole} ratios a midpoint rule gives, by its number of panels. The two "
                         f"misprints count as corrected; the last column leaves them out, of {sound}.")


def which_panels() -> Markup:
    """Box which number of panels gives every printed ratio, and how near the others come."""
    whole, sound = len(independent()), sum(not ratio.misprint for ratio in independent())
    given = {panels: _given(panels) for panels in TRIED}
    if ([panels for panels in TRIED if given[panels] == whole] != [PANELS]
            or [panels for panels in TRIED if _sound(panels) == sound] != [PANELS]):
        raise AssertionError(f"{given} reproduce the tables")
    runner_up = max((panels for panels in TRIED if panels != PANELS), key=lambda panels: (given[panels], -panels))
    return boxed("The paper's quadrature", Markup(
        f"A midpoint rule in $\\beta$ over $[0, \\pi]$ with {PANELS} panels and the weight $\\sin\\beta$ gives all "
        f"{whole} printed ratios of Tables II to V, two misprints corrected. Of all numbers of panels from {TRIED[0]} "
        f"to {TRIED[-1]} it alone does, and it alone gives the {sound} that are printed without misprint. The next "
        f"best, {runner_up} panels, gives {given[runner_up]}."))


def what_separates(first: int, last: int) -> Markup:
    """Say which ratios no other number of panels gives; there must be some."""
    others = [panels for panels in range(first, last + 1) if panels != PANELS]
    missed = [[kind == "no" for _, kind in _verdicts(panels)] for panels in others]
    always = [ratio for ratio, *misses in zip(independent(), *missed, strict=True) if all(misses)]
    assert always, "no ratio tells the numbers of panels apart by itself"
    named = " and ".join(f"{typeset(ratio.name)} of Table {ratio.table}, {ratio.label}" for ratio in always)
    return Markup(f"No other number of panels from {first} to {last} gives {named}.\n")


def matches() -> Static:
    """Draw how many printed ratios each number of panels gives."""
    return Static(draw_matches({panels: _given(panels) for panels in TRIED}, of=len(independent()), marked=PANELS))


def match_numbers() -> Markup:
    """Offer the numbers behind that figure."""
    return numbers_to_take_away("matches.csv", {
        "panels": TRIED, "ratios given": [_given(panels) for panels in TRIED],
        "without misprints": [_sound(panels) for panels in TRIED]})


def differences() -> Static:
    """Draw how far printed ratios and those of the rule are from the exact ones."""
    found = [ratio for ratio in independent() if not ratio.misprint]
    return Static(draw_differences([f"{ratio.table}, {ratio.label}" for ratio in found],
                                   [ratio.name for ratio in found],
                                   [float(ratio.printed) - ratio.exact for ratio in found],
                                   [ratio.panels - ratio.exact for ratio in found]))


def outside_rounding() -> Markup:
    """Say how many printed ratios cannot be the exact one rounded to three decimals."""
    found = [ratio for ratio in independent() if not ratio.misprint]
    sound = sum(f"{ratio.exact:.3f}" == ratio.printed for ratio in found)
    return Markup(f"Of the {len(found)} ratios that are printed without misprint, {sound} are the exact ones rounded "
                  f"to three decimals; {len(found) - sound} are not.")


def isotropic_by_panels() -> Markup:
    """Say what the paper's quadrature would give for the rows that are 1 by symmetry."""
    found = [ratio for ratio in printed_ratios("IV") if ratio.isotropic]
    values = " and ".join(f"{ratio.panels:.3f}" for ratio in found)
    return Markup(f"One thing does not fit: {PANELS} panels would give {values} for the isotropic rows of Tables IV "
                  "and V, where 1.000 is printed. Those rows need no computation, and were probably not computed.")


@lru_cache(maxsize=1)
def independent() -> tuple[Printed, ...]:
    """All printed ratios but those that are 1 by symmetry and those that repeat another table."""
    return tuple(_independent())


def _independent() -> Iterator[Printed]:
    for name in TABLES:
        for ratio in printed_ratios(name):
            repeated = name == "III" and ratio.case["effects"] == "packing branches"
            if not (ratio.isotropic or repeated):
                yield ratio


def _given(panels: int) -> int:
    """How many ratios a rule gives, rounded or cut."""
    return sum(kind != "no" for _, kind in _verdicts(panels))


def _sound(panels: int) -> int:
    """The same without misprints."""
    return sum(kind != "no" for ratio, kind in _verdicts(panels) if not ratio.misprint)


@lru_cache(maxsize=128)
def _verdicts(panels: int) -> tuple[tuple[Printed, str], ...]:
    return tuple((ratio, verdict(_by_panels(ratio.table, ratio.case["case"], panels)[ratio.name], ratio.meant))
                 for ratio in independent())


@lru_cache(maxsize=4096)
def _by_panels(name: str, which: str, panels: int) -> dict[str, float]:
    case = next(case for case in cases(TABLES[name]) if case["case"] == which)
    return by_midpoint(evaluated(case), panels)
