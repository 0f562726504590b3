"""Findings of the cost study in words: every number in them is computed from the stored data."""

from __future__ import annotations

import statistics
from collections.abc import Callable, Iterable, Sequence

from granular.cost.records import Cost
from granular.figures.cost_data import CostData, MeasuredScene
from granular.figures.cost_pareto import size
from granular.figures.cost_selection import (
    WANTED,
    as_good_as_paper,
    error_of,
    front,
    in_hindsight,
    outside_asked_for,
    promised_for,
    time_of,
)
from page_tools.markup import plain

MIDDLE = 1e-6
"""The wanted accuracy of captions [-]."""

EVEN = 1.5
"""Times within this factor of each other are said to be the same for every accuracy."""


def caption(scenes: Sequence[MeasuredScene]) -> str:
    """State in a line what the picture of a scene shows."""
    each = []
    for scene in scenes:
        found = promised_for(scene, MIDDLE)
        under = f"{scene.hypothesis}: " if len(scenes) > 1 else ""
        each.append(f"{under}{decade(MIDDLE)} by {route(found)}, {size(time_of(found))} times the unit" if found else
                    f"{under}no route states {decade(MIDDLE)}")
    return f"{plain(capital(scenes[0].title))}. Stated beforehand, {'; '.join(each)}.{_papers(scenes)}"


def _papers(scenes: Sequence[MeasuredScene]) -> str:
    errors = [percent(error_of(scene.paper)) for scene in scenes if scene.paper]
    return f" The paper's rule (ringed) is off by {' and '.join(errors)}." if errors else ""


def alt(scenes: Sequence[MeasuredScene]) -> str:
    """Describe the picture of a scene to readers who cannot see it."""
    each = []
    for scene in scenes:
        passed = list(dict.fromkeys(cost.route for cost in front(scene)))
        each.append(f"{scene.hypothesis}: from fast to accurate the front passes {', '.join(passed)}")
    return f"Error against time of one evaluation, both on logarithmic axes, {'; '.join(each)}"


def finding(scene: MeasuredScene) -> str:
    """Say what accuracy costs on a scene, what the cheapest others cost, and how the printed rule fares."""
    return (f"**{capital(str(scene.hypothesis))} hypothesis.** {_own(scene)} {_outside_ways(scene)} "
            f"{_paper(scene)}")


def _own(scene: MeasuredScene) -> str:
    found = [(wanted, promised_for(scene, wanted)) for wanted in WANTED]
    stated = [(wanted, cost) for wanted, cost in found if cost is not None]
    if not stated:
        return "No route of the library states an error for this scene."
    times = [time_of(cost) for _, cost in stated]
    routes = {cost.route for _, cost in stated}
    missing = "" if len(stated) == len(found) else (
        f" No route states {_listed(decade(wanted) for wanted, cost in found if cost is None)}.")
    same_work = len({cost.evaluations for _, cost in stated}) == 1
    if len(routes) == 1 and (same_work or max(times) <= EVEN * min(times)):
        return (f"{route(stated[0][1])} states every accuracy from {decade(stated[0][0])} to {decade(stated[-1][0])} "
                f"for {_range(times)} times the unit.{missing}")
    each = _listed(f"{decade(wanted)} costs {size(time_of(cost))}" + ("" if len(routes) == 1 else f" ({route(cost)})")
                   for wanted, cost in stated)
    by = f", by {route(stated[0][1])}" if len(routes) == 1 else ""
    return (f"Stated beforehand, {each}{by}; {decade(stated[-1][0])} takes {size(times[-1] / times[0], 2)} times as "
            f"long as {decade(stated[0][0])}.{missing}")


def _outside_ways(scene: MeasuredScene) -> str:
    """How the cheapest ways from outside compare: chosen in hindsight, and asked for the accuracy."""
    hindsight, asked = _compared(scene, in_hindsight), _compared(scene, outside_asked_for)
    if not hindsight:
        return "Nothing from outside is accurate enough to compare."
    first = f"From outside the cheapest takes {hindsight} in hindsight"
    return f"{first}, and {asked} when asked for the accuracy." if asked else f"{first}; none keeps to a tolerance."


def _compared(scene: MeasuredScene, find: Callable[[MeasuredScene, float], Cost | None]) -> str:
    """Factors on the time of the library over all accuracies, with the ways; empty when there are none."""
    pairs = [(promised_for(scene, wanted), find(scene, wanted)) for wanted in WANTED]
    both = [(own, other) for own, other in pairs if own and other]
    if not both:
        return ""
    factors = [time_of(other) / time_of(own) for own, other in both]
    names = ", ".join(dict.fromkeys(route(other) for _, other in both))
    return f"{_range(factors, digits=2)} times as long ({names})"


def _paper(scene: MeasuredScene) -> str:
    paper, better = scene.paper, as_good_as_paper(scene)
    if paper is None:
        return "The paper's rule was not measured."
    first = (f"The paper's {paper.setting} are off by {percent(error_of(paper))} and take {size(time_of(paper))} times "
             f"the unit")
    if better is None:
        return f"{first}; nothing else in the library is as accurate."
    return (f"{first}; {route(better)}, {setting(better)}, has an error of {short(error_of(better))} and is "
            f"{size(time_of(paper) / time_of(better), 2)} times as fast.")


def overall(data: CostData) -> str:
    """Say what three and twelve digits cost over all scenes, and how often outside ways are faster."""
    ends = [(scene, low, high) for scene in data.scenes
            if (low := promised_for(scene, WANTED[0])) and (high := promised_for(scene, WANTED[-1]))]
    if not ends:
        return "No route states an error for any of these scenes."
    factors = [time_of(high) / time_of(low) for _, low, high in ends]
    steepest = max(ends, key=lambda one: time_of(one[2]) / time_of(one[1]))[0]
    middle, most = size(statistics.median(factors), 2), size(max(factors), 2)
    return (f"On {len(ends)} scenes, stated beforehand, {decade(WANTED[-1])} takes {middle} times as long as "
            f"{decade(WANTED[0])} in the median, and {most} times at most "
            f"({steepest.label}). {_outside(data)}")


def _outside(data: CostData) -> str:
    """How many times outside ways are faster, chosen in hindsight and asked for the accuracy."""
    own = [(scene, cost) for scene in data.scenes if (cost := promised_for(scene, MIDDLE))]
    pairs = [(time_of(cost), in_hindsight(scene, MIDDLE), outside_asked_for(scene, MIDDLE)) for scene, cost in own]
    faster = sum(other is not None and time_of(other) < time for time, other, _ in pairs)
    asked = [time_of(other) / time for time, _, other in pairs if other is not None]
    first = (f"At {decade(MIDDLE)} a way from outside is faster on {faster} of {len(pairs)} scenes if the right answer "
             f"tells which one to take")
    if not asked:
        return f"{first}; none that must be asked for the accuracy keeps to it."
    quick = sum(factor < 1 for factor in asked)
    return (f"{first}, and on {quick} if it must be asked for the accuracy and keep to it; such a way takes "
            f"{size(statistics.median(asked), 2)} times as long in the median.")


def kept(data: CostData) -> str:
    """Say how many settings state an error beforehand and how many of them keep it."""
    stated = [cost for scene in data.scenes for cost in scene.results if cost.promised is not None]
    broken = [cost for cost in stated if error_of(cost) > (cost.promised or 0.0)]
    return (f"{len(stated)} of the measured settings state an error beforehand; "
            f"{'every one of them keeps it' if not broken else f'{len(broken)} of them break it'}.")


def route(cost: Cost) -> str:
    """Name of a route as a page writes it."""
    return f"`{cost.route}`"


def setting(cost: Cost) -> str:
    """Setting of a route, exponents without a leading zero."""
    return cost.setting.replace("e-0", "e-").replace("-", "−")


def short(value: float | None) -> str:
    """Write an error in two digits; a dash for none."""
    if value is None:
        return "–"
    return f"{value:.1e}".replace("e-0", "e-").replace("-", "−") if value else "0"


def percent(value: float) -> str:
    """Write an error of the size of a percent."""
    return f"{100 * value:.2g} %" if 1e-5 <= value < 10 else short(value)


def decade(value: float) -> str:
    """Write a power of ten as a formula."""
    return f"$10^{{{int(f'{value:e}'.split('e')[1])}}}$"


def capital(text: str) -> str:
    """Begin a sentence with it."""
    return text[0].upper() + text[1:]


def _range(values: Sequence[float], *, digits: int = 3) -> str:
    low, high = size(min(values), digits), size(max(values), digits)
    return low if low == high else f"{low} to {high}"


def _listed(parts: Iterable[str]) -> str:
    *others, last = parts
    return f"{', '.join(others)} and {last}" if others else last
