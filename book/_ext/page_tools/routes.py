"""Routes on a page: what each one serves and promises, what an accuracy buys, and how one is chosen."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path

from granular import Scene, evaluate, plan
from granular.checks.bought_accuracy import bought
from granular.checks.effect_examples import EXAMPLES, FORCES, scene_with
from granular.errors import GranularError
from granular.figures import bought_accuracy
from granular.figures.page import Static
from granular.routes.catalogue import AUTO, CATALOGUE, Price
from granular.routes.choice import Considered
from page_tools.effects import bound, power
from page_tools.markup import Markup, numbers_to_take_away, plain, table

SLIDING = "sliding"
"""Scene of the cost study whose contacts slide: the dearest kind."""

LOOSE, TIGHT = 1e-3, 1e-12
"""Accuracies that are compared in words."""

FABRIC = EXAMPLES["packing"], EXAMPLES["branches"]
SCENES: dict[str, Callable[[], Scene]] = {
    "equal contacts": lambda: scene_with(*FABRIC, effects=("packing", "branches")),
    "contact forces": lambda: scene_with(*FABRIC, FORCES),
    "partial slip": lambda: scene_with(EXAMPLES["slip"]),
    "flat grains": lambda: scene_with(EXAMPLES["deviation"]),
}
"""Scenes for which choices and routes by hand are shown."""

WANTED = (1e-6, None)
"""Wanted accuracies at which choices are shown; None for none."""


def routes_table() -> Markup:
    """List the records: what each route serves, where its promise comes from, and its price."""
    rows = [[f"`{route.name}`<br>{plain(route.title)}<br>*price* {_price(route.price)}", plain(route.domain),
             _units(route.error_model)] for route in CATALOGUE]
    return table(["route", "serves", "promise from"], rows, label="tab-route-list", take_away="routes.csv",
                 taken=[["route", "title", "serves", "promise from", "call", "fractions", "operation", "direction"],
                        *([route.name, route.title, route.domain, route.error_model, repr(route.price.call),
                           repr(route.price.fractions), repr(route.price.operation), repr(route.price.evaluation)]
                          for route in CATALOGUE)],
                 caption="The routes. Prices are in units of one operation of the rule along the meridian: for a call, "
                         "and besides where floats are not enough, for each operation, or for each direction.")


def bought_figure() -> Static:
    """Draw directions and errors against the wanted accuracy."""
    return Static(bought_accuracy.bought_accuracy())


def bought_numbers() -> Markup:
    """Offer the numbers of that figure."""
    columns: dict[str, list[float]] = {}
    for name, hypothesis, label, _, _ in bought_accuracy.DRAWN:
        found = bought(name, hypothesis)
        columns |= {"rtol": [one.rtol for one in found],
                    f"{label}: directions": [one.evaluations for one in found],
                    f"{label}: promised": [one.promised for one in found],
                    f"{label}: error": [one.error for one in found]}
    return numbers_to_take_away("bought_accuracy.csv", columns)


def bought_words() -> Markup:
    """Say what the dearest scene takes for a loose and a tight accuracy, and what was promised."""
    found = {one.rtol: one for one in bought(SLIDING)}
    loose, tight = (found[min(found, key=lambda rtol: abs(rtol / wanted - 1))] for wanted in (LOOSE, TIGHT))
    worst = max(one.error / one.promised for name, hypothesis, *_ in bought_accuracy.DRAWN
                for one in bought(name, hypothesis))
    return Markup(f"With sliding contacts {power(LOOSE)} takes {loose.evaluations} directions and {loose.operations} "
                  f"operations, {power(TIGHT)} takes {tight.evaluations} and {tight.operations}. No error in the "
                  f"picture is above {power(worst)} of what was promised.")


def prediction_table() -> Markup:
    """Hold the cost that a plan predicts against what the evaluation counts."""
    rows = []
    for title, scene in SCENES.items():
        for rtol in (LOOSE, TIGHT):
            decided, result = plan(scene(), rtol=rtol), evaluate(scene(), rtol=rtol)
            if (decided.evaluations, decided.work) != (result.evaluations, result.work):
                raise AssertionError(f"{title}: the plan predicted another cost than was counted")
            work = result.work
            assert work is not None
            rows.append([title, power(rtol), f"`{result.route}`", bound(result.relative_error),
                         str(result.evaluations), f"{work.operations} + {work.functions}"])
    return table(["scene", "rtol", "route", "error stated", "directions", "work"], rows,
                 label="tab-predicted", align="lrlrrr", take_away="predicted.csv",
                 caption="What scenes cost at two wanted accuracies, with the work in operations + functions. Plans "
                         "predicted every number of the last two columns, and the evaluations counted the same.")


def choice_table() -> Markup:
    """Show the routes that a plan looks at for some scenes, with promise and price."""
    heads = [f"{name}: {what}" for name in AUTO for what in ("price", "promise")]
    rows, taken = [], [["scene", "rtol", *heads, "chosen"]]
    for title, scene in SCENES.items():
        for rtol in WANTED:
            decided = plan(scene(), rtol=rtol)
            looked_at = decided.choice.considered
            rows.append([title, "–" if rtol is None else power(rtol), *map(_considered, looked_at),
                         f"`{decided.route}`"])
            taken.append([title, repr(rtol), *(text for one in looked_at for text in _in_full(one)), decided.route])
    return table(["scene", "rtol", *(f"`{name}`" for name in AUTO), "chosen"], rows, label="tab-choice", align="lrrrl",
                 take_away="choice.csv", taken=taken,
                 caption="Price of each route that a plan looks at, and below it the error that it promises; a dash "
                         "where it does not serve the scene. Without rtol everything that doubles hold is wanted.")


def by_hand_table() -> Markup:
    """Evaluate some scenes by every route by its name."""
    rows = []
    for route in CATALOGUE:
        rows.append([f"`{route.name}`", *(_by_hand(scene(), route.name) for scene in SCENES.values())])
    return table(["route", *SCENES], rows, label="tab-by-hand", align="lrrrr", take_away="by_hand.csv",
                 caption="Error stated by each route when it is named, none where it promises nothing, and the number "
                         "of directions. No accuracy was asked for; a dash stands for a refusal.")


def by_route(name: str, scene: str, rtol: float | None = None) -> Callable[[], object]:
    """Prepare the evaluation of one of the scenes by a route's name."""
    return lambda: evaluate(SCENES[scene](), route=name, rtol=rtol)


def promises_kept(data: str = "_data/promises.json") -> Markup:
    """Say what the stored run on random scenes found of promises; where there is none, name the command."""
    if not Path(data).is_file():
        return Markup("`granular check --promises` holds plans to their promises on random scenes.")
    found = json.loads(Path(data).read_text(encoding="utf-8"))
    return Markup(f"On {found['scenes']:,} random scenes at {len(found['rtols'])} accuracies {found['broken']} "
                  f"promises of {found['promises']:,} were broken and {found['refused']} refused "
                  f"(`{found['command']}`).")


def choices_made(data: str = "_data/choices.json") -> Markup:
    """Say how good choices were in the stored run on random scenes; where there is none, name the command."""
    if not Path(data).is_file():
        return Markup("`granular check --choices` times them on random scenes.")
    found = json.loads(Path(data).read_text(encoding="utf-8"))
    every = found["all"]
    return Markup(f"Of {every['choices']:,} choices on {found['scenes']:,} random scenes {100 * every['share']:.1f} % "
                  f"took at most {found['near']:g} times the time of the cheapest route that was accurate enough; the "
                  f"median is {every['median']:.2f} (`{found['command']}`).")


def _price(price: Price) -> str:
    parts = ((price.call, f"{price.call:,.0f}"), (price.fractions, f"{price.fractions:,.0f} in fractions"),
             (price.operation, f"{price.operation:g} an operation"),
             (price.evaluation, f"{price.evaluation:g} a direction"))
    return " + ".join(text for part, text in parts if part)


def _units(text: str) -> str:
    """Set powers of two in the words of a record as formulas."""
    return re.sub(r"2\^-(\d+)", r"$2^{-\1}$", plain(text))


def _considered(one: Considered) -> str:
    return "–" if one.promise is None else f"{one.price:,.0f}<br>{bound(one.promise.relative_error)}"


def _in_full(one: Considered) -> tuple[str, str]:
    return ("", "") if one.promise is None else (repr(one.price), repr(one.promise.relative_error))


def _by_hand(scene: Scene, route: str) -> str:
    try:
        result = evaluate(scene, route=route)
    except GranularError:
        return "–"
    error = bound(result.relative_error).replace("no bound", "none")
    return error + (f"; {result.evaluations}" if result.evaluations else "")
