"""Accuracy against time from the stored measurements of ``granular cost``; a page that is built measures nothing."""

from __future__ import annotations

from functools import lru_cache

from granular.cost import timing
from granular.cost.records import OUTSIDE, PRODUCT
from granular.figures.cost_chooser import CostChooser
from granular.figures.cost_data import CostData, MeasuredScene, read_cost_data
from granular.figures.cost_pareto import pareto
from page_tools.cost_tables import (
    STYLE,
    failures,
    prices,
    rows_table,
    wanted_table,
    without_result,
    worst_spread,
)
from page_tools.cost_words import alt, caption, finding, kept, overall
from page_tools.markup import Markup
from page_tools.pictures import pictured

DATA = "_data/cost.json"


@lru_cache(maxsize=1)
def measured(data: str = DATA) -> CostData:
    """Read the stored measurements once for the page; a file that was left unfinished stops the build."""
    content = read_cost_data(data)
    if not content.complete:
        raise AssertionError(f"{data} is not complete: granular cost --resume --out {data}")
    return content


def chooser() -> CostChooser:
    """Show the picture in which a reader picks scene and accuracy."""
    return CostChooser(measured())


def price_table() -> Markup:
    """List what accuracies cost on every scene, and say what it comes to."""
    data = measured()
    return Markup(f"{STYLE}\n\n{overall(data)} {kept(data)}\n\n{prices(data).text}")


def of_scene(name: str) -> Markup:
    """Show a scene: picture, finding, cheapest ways, every measurement, and the command that measures them again."""
    scenes = measured().of_name(name)
    if not scenes:
        raise AssertionError(f"no measurement of {name}")
    gave_nothing = without_result(scenes)
    return Markup("\n\n".join([
        _figure(scenes), *(finding(scene) for scene in scenes), *([gave_nothing] if gave_nothing else []),
        wanted_table(scenes).text, _folded(scenes), f"```console\n$ granular cost --scene {name}\n```", ""]))


def _figure(scenes: tuple[MeasuredScene, ...]) -> str:
    """Put the picture into the page itself, so that caption and description can be computed with it."""
    return pictured(pareto(scenes), name=f"fig-cost-{scenes[0].name}", alt=alt(scenes), caption=caption(scenes)).text


def _folded(scenes: tuple[MeasuredScene, ...]) -> str:
    count = sum(len(scene.costs) for scene in scenes)
    tables = "\n\n".join(rows_table(scene).text for scene in scenes)
    reasons = "\n".join(failures(scenes))
    return f"::::{{dropdown}} All {count} measurements\n\n{tables}\n\n{reasons}\n::::"


def machine() -> Markup:
    """Say where, with which versions, how often and over which unit it was measured."""
    data = measured()
    about = data.machine
    packages = ", ".join(f"{name} {version}" for name, version in about.items()
                         if name not in ("processor", "cores", "system", "unit_seconds"))
    middle, most = worst_spread(data)
    return Markup(f"Measured on {about['processor']}, {about['cores']} cores, {about['system']}, with {packages}, in "
                  f"{data.rounds} rounds. The unit is {data.unit}; it takes {1e6 * data.unit_seconds:.3g} µs there. "
                  f"The spread is {100 * middle:.0f} % in the median and {100 * most:.0f} % at most.")


def how() -> Markup:
    """Describe the measurement by the constants that it runs with."""
    data = measured()
    routes = {kind: len({cost.route for scene in data.scenes for cost in scene.costs if cost.kind == kind})
              for kind in (PRODUCT, OUTSIDE)}
    settings = sum(len(scene.costs) for scene in data.scenes)
    digits = min(scene.digits for scene in data.scenes)
    return Markup(f"""- **What.** {len(data.scenes)} scenes (each hypothesis counted), {routes[PRODUCT]} routes of the
  library and {routes[OUTSIDE]} ways from outside, {settings} settings in all.
- **Error.** Of the worst of six components, against ball arithmetic or, where that ends, stored values of many digits;
  {digits} of them are right or more.
- **Time.** Of one evaluation, over that of the unit, which is timed right before it. What else the machine does acts on
  both.
- **Rounds.** In each round every setting is timed once, all of them in random order. The time is the median of the
  rounds, the spread half the distance of the quartiles over it. A short call is repeated for
  {1e3 * timing.SHORTEST:g} ms; a setting that would take more than {timing.LONGEST:g} s in all takes part in fewer
  rounds, but in {timing.FEWEST} at least.
- **Failures.** A setting that fails is a row with its reason. One that warns has its error, and counts as no answer.
""")
