"""The table of ``granular check`` on a page: groups of cases down, ways of computing across."""

from __future__ import annotations

from functools import lru_cache

from granular.checks import Comparison, rows, table
from granular.checks.voices import ALL, voices
from granular.hypothesis import Hypothesis
from granular.routes import midpoint
from page_tools import markup

WHAT_THEY_ARE = {
    "closed_form": "the emitted formulas in rational arithmetic, rounded once at the end; with contact forces and no "
                   "slip, emitted series",
    "exact": "the same formulas fed with fractions: rational numbers, equal contacts, kinematic hypothesis only",
    "axial": "rule along the meridian, in positive moments: Gauss–Legendre for equal contacts, trapezoidal in "
             "$\\ln\\tan\\beta$ with contact forces",
    "sphere": "rules on the whole sphere with all 21 components, no symmetry used",
    "certified": "ball arithmetic with a rigorous error bound carried through every operation",
    "midpoint": "the midpoint rule that the printed tables carry, for reproducing them",
}
"""One line each on how a route differs from the others."""


def routes_table() -> markup.Markup:
    """List the ways of computing that are compared."""
    names = [voice.NAME for voice in (*ALL, midpoint)]
    lines = [[f"`{name}`", WHAT_THEY_ARE[name]] for name in names]
    return markup.table(["route", "how it computes"], lines, label="tab-routes", caption="Ways of computing.")


@lru_cache(maxsize=1)
def compared() -> list[Comparison]:
    """Run all comparisons once for the page."""
    return table()


def check_table(hypothesis: Hypothesis) -> markup.Markup:
    """Show the worst error of each route in each group of cases; a miss stops the build."""
    comparisons = compared()
    missed = [comparison for comparison in comparisons if not comparison.agrees]
    if missed:
        raise AssertionError(f"granular check misses: {missed}")
    routes = [voice.NAME for voice in voices()]
    groups: dict[tuple[str, int], dict[str, str]] = {}
    for row in rows(comparisons):
        if hypothesis in row.worst and row.route in routes:
            groups.setdefault((row.group, row.cases), {})[row.route] = _cell(row.worst[hypothesis])
    lines = [[f"{markup.plain(group)} ({members})", *(found.get(route, "–") for route in routes)]
             for (group, members), found in groups.items()]
    return markup.table(
        ["cases", *(f"`{route}`" for route in routes)], lines, label=f"tab-checks-{hypothesis}",
        align="l" + "r" * len(routes), take_away=f"checks_{hypothesis}.csv",
        caption=f"Worst error of six components in units of the last place, {hypothesis} hypothesis. In brackets the "
                "number of cases; – where a route does not serve them.")


def sizes_and_samples() -> markup.Markup:
    """Show what is no route: the moments of branch lengths, and contacts drawn at random for eq. (1)."""
    routes = {voice.NAME for voice in voices()}
    lines = [[markup.plain(f"{row.group} ({row.cases})"), str(hypothesis),
              f"{worst.error:.2f}", f"{worst.allowed:.3g}", f"{worst.unit}", markup.plain(worst.case)]
             for row in rows(compared()) if row.route not in routes for hypothesis, worst in row.worst.items()]
    return markup.table(
        ["cases", "hypothesis", "worst error", "allowed", "in", "where"], lines, label="tab-checks-samples",
        align="llrrll", take_away="checks_samples.csv",
        caption="Moments of the branch lengths of graded grains against certified ones, in units of the last place "
                "(what the library states is allowed), scenes in other frames and without an axis against themselves, "
                "in units of the largest entry, and the stiffness of evaluated scenes against eq. (1) "
                "summed over a million contacts drawn at random, in standard errors.")


def summary() -> markup.Markup:
    """Say how many comparisons there are and how they came out."""
    comparisons = compared()
    misses = sum(not comparison.agrees for comparison in comparisons)
    chosen = [comparison for comparison in comparisons if comparison.route in ("closed_form", "axial")]
    worst = max(chosen, key=lambda comparison: comparison.error)
    return markup.Markup(
        f"{len(comparisons)} comparisons, {misses} misses. The two routes that a plan chooses are off by at most "
        f"{worst.error:.2f} units of the last place ({markup.plain(worst.group)}, `{worst.route}`, "
        f"${worst.component[0]}_{{{worst.component[1:]}}}$).")


def _cell(comparison: Comparison) -> str:
    return f"{comparison.error:.2f}"
