"""Accuracy against time from the stored measurements of ``granular cost``; a page that is built measures nothing."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from granular.figures.look import BLUE, GREEN, ORANGE, PURPLE, SKY, VERMILION, blank, house_style
from granular.figures.page import Static
from page_tools.markup import Markup, plain, table

LOOKS = {"closed_form": ("*", BLUE), "exact": ("P", SKY), "axial": ("o", VERMILION), "sphere": ("s", GREEN),
         "midpoint": ("v", ORANGE), "certified": ("D", PURPLE)}
"""Marker and colour of each route."""

LEAST_SHOWN = 1e-17
"""Errors below this are drawn at the lower edge: they are far below a unit of the last place."""


def measured(data: str) -> dict[str, Any]:
    """Read the stored measurements."""
    content: dict[str, Any] = json.loads(Path(data).read_text(encoding="utf-8"))
    return content


SCENES = ("equal-contacts", "unequal-branches")
"""Scenes of the figure."""


def _costs(data: str) -> list[dict[str, Any]]:
    """Settings of the routes of this package that gave a result."""
    return [cost for cost in measured(data)["costs"]
            if cost["scene"] in SCENES and cost["route"] in LOOKS and cost["error"] is not None]


@house_style
def cost_figure(data: str) -> Static:
    """Draw error against time, a panel for each scene and hypothesis."""
    costs = _costs(data)
    panels = list(dict.fromkeys((cost["scene"], cost["hypothesis"]) for cost in costs))
    figure = blank(height=5.6)
    axes = figure.subplots(2, 2, sharex=True, sharey=True)
    for axis, panel in zip(axes.flat, panels, strict=True):
        for route, (marker, colour) in LOOKS.items():
            points = [(cost["time_ratio"], max(cost["error"], LEAST_SHOWN)) for cost in costs
                      if (cost["scene"], cost["hypothesis"]) == panel and cost["route"] == route]
            if points:
                axis.loglog(*zip(*points, strict=True), marker, color=colour, markersize=6, label=route,
                            linestyle="-" if len(points) > 2 else "none", linewidth=0.8)
        axis.set_title(f"{panel[0]}, {panel[1]}")
    figure.supylabel("relative error of the worst component", fontsize="medium")
    figure.supxlabel("time over the closed form in floats", fontsize="medium")
    handles, names = axes.flat[0].get_legend_handles_labels()
    figure.legend(handles, names, loc="outside upper center", ncols=6, frameon=False, handletextpad=0.3,
                  columnspacing=1.0)
    return Static(figure)


def cost_table(data: str, scene: str, hypothesis: str) -> Markup:
    """List the measurements of one scene and hypothesis."""
    rows = [[f"`{cost['route']}`", plain(cost["setting"]), str(cost["evaluations"] or "–"), f"{cost['error']:.1e}",
             f"{cost['time_ratio']:.3g}", f"{100 * cost['spread']:.0f} %"]
            for cost in _costs(data) if (cost["scene"], cost["hypothesis"]) == (scene, hypothesis)]
    title = next(one["title"] for one in measured(data)["scenes"] if one["name"] == scene)
    return table(["route", "setting", "directions", "error", "time ratio", "spread"], rows, align="llrrrr",
                 label="tab-cost", caption=f"{title}; {hypothesis} hypothesis.", take_away="cost.csv")


def machine(data: str) -> Markup:
    """Say where, with which versions and how often it was measured."""
    content = measured(data)
    about = content["machine"]
    packages = ", ".join(f"{name} {about[name]}" for name in ("python", "numpy", "scipy", "python-flint"))
    return Markup(f"Measured on {about['processor']}, {about['cores']} cores, {about['system']}, with {packages}; "
                  f"{content['rounds']} rounds, in each of which every setting was timed once, in random order.")
