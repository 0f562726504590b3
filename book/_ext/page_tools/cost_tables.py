"""Tables of the cost study: a wanted accuracy and its price, and every measurement of a scene."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from granular.cost.records import OUTSIDE, Cost
from granular.figures.cost_data import CostData, MeasuredScene
from granular.figures.cost_pareto import size
from granular.figures.cost_selection import (
    WANTED,
    in_hindsight,
    outside_asked_for,
    promised_for,
    time_of,
)
from page_tools.cost_words import decade, route, setting, short
from page_tools.markup import Markup, plain, table

COLUMNS: tuple[tuple[str, Callable[[MeasuredScene, float], Cost | None]], ...] = (
    ("the library, stated beforehand", promised_for), ("outside, in hindsight", in_hindsight),
    ("outside, asked for it", outside_asked_for))

PRICES = (WANTED[0], WANTED[1], WANTED[-1])
"""Accuracies in the table of all scenes [-]."""

NO_BREAK = "\N{NO-BREAK SPACE}"

STYLE = """<style>
.bd-article table.dense { font-size: 0.82rem; }
.bd-article table.dense :is(th, td) { padding: 0.15rem 0.4rem; }
.bd-article details.sd-dropdown table caption { max-width: min(calc(100vw - 5rem), 36rem); }
</style>"""
"""Look of the long tables, which stand in a box that opens: the page shows it once."""


def prices(data: CostData) -> Markup:
    """List what three accuracies cost on every scene, and the cheapest outside way at the second of them."""
    rows, middle = [], PRICES[1]
    taken = [["scene", "hypothesis", *(f"{wanted:g}: {what}" for wanted in PRICES for what in ("route", "time ratio")),
              f"{middle:g}: outside in hindsight over it", f"{middle:g}: outside asked for it over it"]]
    for scene in data.scenes:
        found = [promised_for(scene, wanted) for wanted in PRICES]
        own = found[1]
        others = [find(scene, middle) for _, find in COLUMNS[1:]]
        factors = [f"{time_of(other) / time_of(own):.4g}" if own and other else "" for other in others]
        rows.append([f"{scene.name}, {scene.hypothesis}", *(_cell(cost) for cost in found),
                     *(size(float(factor)) if factor else "–" for factor in factors)])
        taken.append([scene.name, str(scene.hypothesis), *(text for cost in found for text in (
            (cost.route, f"{cost.time_ratio:g}") if cost else ("", ""))), *factors])
    return table(["scene", *(decade(wanted) for wanted in PRICES), "in hindsight", "asked for it"], rows,
                 label="tab-cost-prices", align="lrrrrr", take_away="prices.csv", taken=taken,
                 caption="Time, over that of the unit, of the cheapest route of the library that states the accuracy "
                         "beforehand. The last two columns: how many times as long the cheapest way from outside takes "
                         f"for {decade(middle)}, chosen with the right answer known, and among those that were asked "
                         "for it and kept to it.")


def _cell(cost: Cost | None) -> str:
    return f"{size(time_of(cost))}<br>`{cost.route}`" if cost else "–"


def wanted_table(scenes: Sequence[MeasuredScene]) -> Markup:
    """List for each accuracy the cheapest way of the library and from outside."""
    several = len(scenes) > 1
    rows = [[f"{scene.hypothesis}<br>{decade(wanted)}" if several else decade(wanted),
             *(_way(find(scene, wanted)) for _, find in COLUMNS)] for scene in scenes for wanted in WANTED]
    heads = ["wanted", *(name for name, _ in COLUMNS)]
    taken = [["hypothesis", "wanted", *(f"{name}: {what}" for name, _ in COLUMNS
                                        for what in ("route", "setting", "time ratio", "error"))],
             *([str(scene.hypothesis), f"{wanted:g}", *(text for _, find in COLUMNS
                                                        for text in _four(find(scene, wanted)))]
               for scene in scenes for wanted in WANTED)]
    return table(heads, rows, label=f"tab-cost-wanted-{scenes[0].name}", align="l" * len(heads), taken=taken,
                 take_away=f"{scenes[0].name}-wanted.csv",
                 caption="Cheapest way for each wanted accuracy, its setting, its time over that of the unit and its "
                         "error.")


def _way(cost: Cost | None) -> str:
    if cost is None:
        return "–"
    name = setting(cost).replace(" ", NO_BREAK)
    return f"{route(cost)}, {name}<br>{size(time_of(cost))}{NO_BREAK}· {short(cost.error)}"


def _four(cost: Cost | None) -> list[str]:
    return [cost.route, cost.setting, f"{cost.time_ratio:g}", f"{cost.error:g}"] if cost else [""] * 4


def rows_table(scene: MeasuredScene) -> Markup:
    """List every measurement of a scene under one hypothesis."""
    rows = [[f"{route(cost)}{NO_BREAK}°" if cost.kind == OUTSIDE else route(cost),
             setting(cost).replace(" ", NO_BREAK) + " (paper)" * cost.paper + f"{NO_BREAK}†" * bool(cost.failure),
             short(cost.error), short(cost.promised), str(cost.evaluations or "–"),
             f"{size(time_of(cost))} ± {_spread(cost)}", str(cost.count)] for cost in scene.results]
    taken = [["route", "kind", "setting", "paper", "error", "stated", "directions", "time ratio", "spread", "count",
              "failure"], *(_everything(cost) for cost in scene.costs)]
    return table(["route", "setting", "error", "stated", "directions", "time", "count"], rows, look="dense",
                 label=f"tab-cost-{scene.name}-{scene.hypothesis}", align="llrrrrr", taken=taken,
                 take_away=f"cost-{scene.name}-{scene.hypothesis}.csv",
                 caption=f"Every measurement of `{scene.name}`, {scene.hypothesis} hypothesis; times with their "
                         "spread. From outside: °. With a warning: †. A dash for an error that is not stated, or a "
                         "formula that needs no directions. The file has those without a result, too.")


def failures(scenes: Sequence[MeasuredScene]) -> Iterator[str]:
    """Say of each route that failed or warned in which settings and why, as items of a list."""
    found: dict[tuple[str, str], list[str]] = {}
    for scene in scenes:
        for cost in scene.costs:
            if cost.failure:
                under = f" ({scene.hypothesis})" if len(scenes) > 1 else ""
                found.setdefault((cost.route, cost.failure), []).append(setting(cost) + under)
    for (name, reason), settings in found.items():
        yield f"- `{name}`, {'; '.join(settings)}: {plain(reason)}"


def without_result(scenes: Sequence[MeasuredScene]) -> str:
    """Name the routes that gave nothing in any setting, for the line under a picture."""
    routes = dict.fromkeys(cost.route for scene in scenes for cost in scene.costs)
    absent = [name for name in routes
              if not any(cost.route == name for scene in scenes for cost in scene.results)]
    some = [name for name in routes if name not in absent
            and any(cost.route == name and cost.error is None for scene in scenes for cost in scene.costs)]
    parts = [f"No result by {', '.join(f'`{name}`' for name in absent)}." if absent else "",
             f"Not in every setting: {', '.join(f'`{name}`' for name in some)}." if some else ""]
    return " ".join(part for part in parts if part)


def _spread(cost: Cost) -> str:
    return "–" if cost.spread is None else f"{100 * cost.spread:.0f} %"


def _everything(cost: Cost) -> list[str]:
    values = (cost.error, cost.promised, cost.evaluations, cost.time_ratio, cost.spread)
    return [cost.route, cost.kind, cost.setting, "yes" if cost.paper else "",
            *("" if value is None else f"{value:g}" for value in values), str(cost.count), cost.failure or ""]


def worst_spread(data: CostData) -> tuple[float, float]:
    """Median and largest spread of all times [-]."""
    spreads = sorted(cost.spread for scene in data.scenes for cost in scene.results if cost.spread is not None)
    return (spreads[len(spreads) // 2], spreads[-1]) if spreads else (0.0, 0.0)

