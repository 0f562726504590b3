"""Whether the plan keeps its word and chooses well, from the stored outcomes of two checks on random scenes."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from page_tools.cost_words import decade, short
from page_tools.markup import Markup, plain, table

PROMISES, CHOICES = "_data/promises.json", "_data/choices.json"


def promise_table(data: str = PROMISES) -> Markup:
    """List for each kind of scene and each accuracy the worst true error over the wanted one; say how many broke it."""
    content = _read(data)
    rtols = content["rtols"]
    kinds = list(dict.fromkeys(group["kind"] for group in content["by_kind"]))
    found = {(group["kind"], group["rtol"]): group for group in content["by_kind"]}
    rows = [[plain(kind), str(max(found[kind, rtol]["count"] for rtol in rtols if (kind, rtol) in found)),
             *(_worst(found.get((kind, rtol))) for rtol in rtols)] for kind in kinds]
    taken = [list(content["by_kind"][0]),
             *([_taken(value) for value in group.values()] for group in content["by_kind"])]
    worst = max((group["worst_error_over_rtol"] for group in content["by_kind"]
                 if group["worst_error_over_rtol"] is not None), default=0.0)
    broken = "none was broken" if content["broken"] == 0 else f"**{content['broken']} were broken**"
    grid = table(["scenes", "number", *(decade(rtol) for rtol in rtols)], rows, label="tab-cost-promises",
                 align="lr" + "r" * len(rtols), take_away="promises.csv", taken=taken,
                 caption="Worst true error over the wanted one, by kind of scene and wanted accuracy; in brackets how "
                         "many of the scenes were refused.")
    return Markup(f"On {content['scenes']} random scenes the plan was asked for {content['promises']} results of a "
                  f"wanted accuracy. It refused {content['refused']} of them; of the others {broken}. The largest true "
                  f"error is {worst:.2g} of what was wanted.\n\n{grid.text}\n{_again(content)}")


def choice_table(data: str = CHOICES) -> Markup:
    """List how long the plan's route takes over the cheapest that would have done, by kind of scene and by accuracy."""
    content = _read(data)
    near, whole = content["near"], content["all"]
    groups = [("**all**", "all", whole),
              *((decade(group["rtol"]), f"rtol {group['rtol']:g}", group) for group in content["by_rtol"]),
              *((plain(group["kind"]), group["kind"], group) for group in content["by_kind"])]
    rows = [_choice(shown, group) for shown, _, group in groups]
    taken = [["choices", *whole], *([name, *(_taken(group[key]) for key in whole)] for _, name, group in groups)]
    grid = table(["choices", "number", f"within {near:g}", "median", "worst", "with the plan"], rows,
                 label="tab-cost-choices", align="lrrrrr", take_away="choices.csv", taken=taken,
                 caption="Time of the plan's route over that of the cheapest route that is accurate enough: share "
                         f"within {near:g} times, median and worst. Last column: median time of planning and "
                         "evaluating over that of the route alone.")
    about = content["machine"]
    return Markup(f"Of {whole['choices']} choices on {content['scenes']} random scenes, {_share(whole['share'])} take "
                  f"at most {near:g} times as long as the cheapest route whose true error is small enough; the "
                  f"median is {whole['median']:.2f}, the worst {whole['worst']:.2f}.\n\n{grid.text}\n{_again(content)} "
                  f"Times of the processor on {about['processor']}, the best of {content['rounds']} rounds or more.")


def _choice(name: str, group: dict[str, Any]) -> list[str]:
    return [name, str(group["choices"]), _share(group["share"]), f"{group['median']:.2f}", f"{group['worst']:.2f}",
            f"{group['planned_over_chosen']:.2f}"]


def _share(share: float) -> str:
    """Percent, rounded down, so that one poor choice in ten thousand is not a hundred."""
    return f"{int(1000 * share) / 10:g} %"


def _worst(group: dict[str, Any] | None) -> str:
    if group is None:
        return "–"
    over = group["worst_error_over_rtol"]
    refused = f" ({group['refused']})" if group["refused"] else ""
    if group["refused"] == group["count"]:
        return f"refused{refused}"
    text = "no number" if over is None else short(over) if over < 0.001 else f"{over:#.2g}"
    return f"**{text}**{refused}" if group["misses"] else f"{text}{refused}"


def _taken(value: object) -> str:
    return "" if value is None else f"{value:g}" if isinstance(value, float) else str(value)


def _again(content: dict[str, Any]) -> str:
    return f"`{content['command']}` checks it again."


def _read(data: str) -> dict[str, Any]:
    content: dict[str, Any] = json.loads(Path(data).read_text(encoding="utf-8"))
    return content
