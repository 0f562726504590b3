"""Pick a scene and a wanted accuracy, and see what it costs: every answer is in the page, nothing is computed there."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from html import escape
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from granular.cost.records import PRODUCT
from granular.figures.cost_chooser_script import SCRIPT
from granular.figures.cost_data import series
from granular.figures.cost_pareto import LEAST, LOOKS, OTHER_LOOK, PALE, by_family, places, size
from granular.figures.cost_selection import error_of, front, in_hindsight, promised_for, time_of
from granular.figures.drawn_data import Series, as_rows
from granular.figures.look import INK, VERMILION, plotly_layout
from granular.figures.page import Interactive, numbers_link

if TYPE_CHECKING:
    from granular.cost.records import Cost
    from granular.figures.cost_data import CostData, MeasuredScene

ACCURACIES = (*(float(f"1e-{digits}") for digits in range(2, 16)), 1e-30)
"""Stops of the slider [-]: down to a unit of the last place, then one that only more digits reach."""

START = ("sliding", 1e-6)
"""Scene and accuracy shown at first [-]; the first scene where that one was not measured."""

PLOTLY_MARKERS = {"D": "diamond", "o": "circle", "s": "square", "P": "cross", "^": "triangle-up", "v": "triangle-down",
                  "X": "x", "*": "star", "x": "x-thin-open", "+": "cross-thin-open"}
"""The same markers by the names that plotly has for them; open ones are made by adding ``-open``."""

DESCRIPTION = ("Error against time of all routes on the scene that is picked above, with a mark for the cheapest that "
               "is accurate enough; the answer stands below in words")
"""For readers who cannot see the picture."""

FULL = {"D": "◆", "o": "●", "s": "■", "P": "✚", "^": "▲", "v": "▼", "X": "✖"}
OPEN = {"D": "◇", "o": "○", "s": "□", "^": "△", "x": "×", "+": "+", "*": "☆"}
"""The same markers as letters."""


@dataclass(frozen=True, slots=True)
class Answer:
    """What a scene and a wanted accuracy give.

    Attributes
    ----------
    wanted : float
        Relative error of the worst component [-].
    promised : Cost or None
        Cheapest way of this package that states such an error beforehand.
    outside : Cost or None
        Cheapest way from outside whose error turned out small enough.
    """

    wanted: float
    promised: Cost | None
    outside: Cost | None


def answer(scene: MeasuredScene, wanted: float) -> Answer:
    """Look up what an accuracy costs on a scene.

    Parameters
    ----------
    scene : MeasuredScene
        A scene.
    wanted : float
        Relative error of the worst component [-].

    Returns
    -------
    Answer
        With the measurements themselves.

    Notes
    -----
    Source: :mod:`granular.figures.cost_selection`.
    """
    return Answer(wanted, promised_for(scene, wanted), in_hindsight(scene, wanted))


def words(scene: MeasuredScene, found: Answer, unit_seconds: float) -> str:
    """Say it in HTML.

    Parameters
    ----------
    scene : MeasuredScene
        A scene.
    found : Answer
        What was found for it.
    unit_seconds : float
        Median time of the unit [s].

    Returns
    -------
    str
        Two sentences.

    Notes
    -----
    Source: the records.
    """
    head = f"<strong>{escape(scene.label)}, {power(found.wanted)} wanted.</strong> "
    if found.promised is None:
        first = "No route of this package states so small an error here. "
    else:
        first = (f"{_route(found.promised)} states {power(found.promised.promised or 0.0)} beforehand; its error is "
                 f"<b>{power(error_of(found.promised))}</b> with {_directions(found.promised)}, in "
                 f"<b>{size(time_of(found.promised))}</b> times the unit ({_seconds(found.promised, unit_seconds)}; "
                 f"timed {found.promised.count} times, spread {_percent(found.promised.spread)}). ")
    if found.outside is None:
        return head + first + "Nothing from outside is as accurate."
    return (f"{head}{first}From outside, with the right answer known, {_route(found.outside)} would do: error "
            f"{power(error_of(found.outside))}, {size(time_of(found.outside))} times the unit.")


def power(value: float) -> str:
    """Write a small number as print does, in HTML.

    Parameters
    ----------
    value : float
        An error [-], >= 0.

    Returns
    -------
    str
        Two digits and a power of ten; the power alone where the digits say nothing.

    Notes
    -----
    Source: the numbers of this figure.

    Examples
    --------
    >>> power(3.93e-10), power(1e-6), power(0.0)
    ('3.9·10<sup>−10</sup>', '10<sup>−6</sup>', '0')
    """
    if value == 0:
        return "0"
    digits, exponent = f"{value:.1e}".split("e")
    front_part = "" if digits == "1.0" else f"{digits}·"
    return f"{front_part}10<sup>{'−' if int(exponent) < 0 else ''}{abs(int(exponent))}</sup>"


def _route(cost: Cost) -> str:
    return f"<code>{escape(cost.route)}</code>, {escape(cost.setting.replace('e-0', 'e-'))},"


def _directions(cost: Cost) -> str:
    return f"{cost.evaluations} directions" if cost.evaluations else "no integration"


def _seconds(cost: Cost, unit_seconds: float) -> str:
    seconds = time_of(cost) * unit_seconds
    return f"{1e3 * seconds:.3g} ms" if seconds >= 1e-4 else f"{1e6 * seconds:.3g} µs"


def _percent(share: float | None) -> str:
    return "unknown" if share is None else f"{100 * share:.0f} %"


@dataclass(frozen=True, slots=True, repr=False)
class CostChooser:
    """The picture with a list of scenes and a slider of accuracies above it and a line of words below.

    Parameters
    ----------
    data : CostData
        What was measured.
    name : str
        Fixed name of the elements in the page.
    """

    data: CostData
    name: str = "cost-chooser"

    def __repr__(self) -> str:
        """Name the figure, for readers without scripts."""
        return f"<interactive figure {self.name}>"

    @property
    def start(self) -> tuple[int, int]:
        """Number of the scene and of the accuracy that are shown at first."""
        names = [scene.name for scene in self.data.scenes]
        return names.index(START[0]) if START[0] in names else 0, ACCURACIES.index(START[1])

    def states(self) -> list[dict[str, Any]]:
        """What the page shows for each scene: points of every trace, and marks and words for each accuracy."""
        own, families = self._names()
        return [{"traces": _traces(scene, own, families), "answers": [_state(scene, wanted, self.data.unit_seconds)
                                                       for wanted in ACCURACIES]} for scene in self.data.scenes]

    def figure(self) -> Any:
        """The plotly figure in its first state."""
        from plotly import graph_objects

        place, wanted = self.start
        state = self.states()[place]
        figure = graph_objects.Figure([graph_objects.Scatter(**trace, **look) for trace, look in
                                       zip([*state["traces"], *state["answers"][wanted]["marks"]],
                                           [*_looks(*self._names()), *_mark_looks()], strict=True)])
        figure.update_layout(**plotly_layout(
            height=440, margin={"l": 10, "r": 10, "t": 10, "b": 10}, hovermode="closest", showlegend=False,
            xaxis={"title": {"text": "time over that of the unit [–]"}, "type": "log", "range": list(self._decades()),
                   "exponentformat": "power", "dtick": 1, "zeroline": False},
            yaxis={"title": {"text": "relative error of worst component [–]"}, "type": "log", "range": [-17.3, 1],
                   "exponentformat": "power", "dtick": 4, "tick0": -16, "zeroline": False}))
        return figure

    def _names(self) -> tuple[list[str], dict[str, str]]:
        """Routes of the package, and families from outside with their markers, of all scenes together."""
        own = dict.fromkeys(name for scene in self.data.scenes for name, _ in scene.routes(PRODUCT))
        families = {family: marker for scene in self.data.scenes for family, (marker, _) in by_family(scene).items()}
        return list(own), families

    def _decades(self) -> tuple[float, float]:
        """Range of the axis of time, the same for all scenes, so that they compare [decades]."""
        times = [time_of(cost) for scene in self.data.scenes for cost in scene.results]
        return math.floor(math.log10(min(times))), math.ceil(math.log10(max(times)))

    def _legend(self) -> str:
        """What marks stand for, as words that wrap on a narrow page."""
        own, families = self._names()
        looks = [(*LOOKS.get(name, OTHER_LOOK), name) for name in own]
        marks = [*((FULL.get(marker, "●"), colour, name) for marker, colour, name in looks),
                 *((OPEN.get(marker, "○"), PALE, family) for family, marker in families.items()),
                 ("◯", INK, "the paper's rule"), ("⌐", INK, "front"), ("★", INK, "stated beforehand"),
                 ("☆", INK, "outside, in hindsight")]
        return '<p class="legend">' + " ".join(
            f'<span><span aria-hidden="true" style="color:{colour}">{glyph}</span> {escape(text)}</span>'
            for glyph, colour, text in marks) + "</p>"

    def _repr_html_(self) -> str:
        place, wanted = self.start
        states = self.states()
        options = "".join(f'<option value="{number}"{" selected" if number == place else ""}>{escape(scene.label)}: '
                          f"{escape(scene.title)}</option>" for number, scene in enumerate(self.data.scenes))
        content = json.dumps({"states": states, "accuracies": [power(one) for one in ACCURACIES]},
                             separators=(",", ":"), ensure_ascii=False).replace("</", "<\\/")
        return (f'<div class="cost-chooser" id="{self.name}"><style>{_STYLE}</style>'
                f'<div class="controls"><label>Scene <select>{options}</select></label>'
                f'<label>Accuracy <input type="range" min="0" max="{len(ACCURACIES) - 1}" step="1" value="{wanted}" '
                f'aria-label="wanted accuracy"/> <output class="wanted">{power(ACCURACIES[wanted])}</output></label>'
                f'</div><div role="figure" aria-label="{DESCRIPTION}">'
                f"{Interactive(self.figure(), self.name).element()}</div>{self._legend()}"
                f'<p class="answer" aria-live="polite">{states[place]["answers"][wanted]["words"]}</p>'
                f'<script type="application/json">{content}</script>'
                f"<script>{SCRIPT.replace('NAME', self.name)}</script></div>"
                f"{numbers_link(self.name, as_rows(self._series()))}")

    def _series(self) -> list[Series]:
        """The points of all scenes, a panel each."""
        names = [look["name"] for look in _looks(*self._names())]
        return [Series(scene.label, name, {"time over that of the unit [-]": trace["x"],
                                           "relative error of worst component [-]": trace["y"]})
                for scene, state in zip(self.data.scenes, self.states(), strict=True)
                for name, trace in zip(names, state["traces"], strict=True) if trace["x"]]


_STYLE = """
.cost-chooser .controls { display: flex; flex-wrap: wrap; gap: .4rem 1.4rem; padding: .4rem 0; font-size: .9rem; }
.cost-chooser label { display: flex; align-items: center; gap: .5rem; margin: 0; min-width: 0; max-width: 100%; }
.cost-chooser select { min-width: 0; max-width: 25rem; flex: 1 1 auto; font: inherit; padding: .15rem .3rem; }
.cost-chooser .legend { display: flex; flex-wrap: wrap; gap: .1rem 1.1rem; margin: .2rem 0; font-size: .82rem; }
.cost-chooser .legend > span { white-space: nowrap; }
.cost-chooser output { min-width: 3.2rem; } .cost-chooser .answer { min-height: 6.5rem; margin: .6rem 0 0; }
html[data-theme="dark"] .cell_output .text_html .cost-chooser :is(.controls, .legend, .answer, .answer strong) {
  color: #1a1a1a; } .cost-chooser .answer :is(b, strong, code) { color: inherit; }
@media print { .cost-chooser { display: none; } }
""".replace("\n", " ")


def _points(costs: Sequence[Cost]) -> dict[str, Any]:
    """Places of measurements, and what the pointer shows at each."""
    times, errors = places(costs)
    return {"x": times, "y": errors, "customdata": [
        f"{cost.route}, {cost.setting}<br>error {error_of(cost):.1e}, {_directions(cost)}<br>{size(time_of(cost))} "
        f"times the unit{'<br>' + escape(cost.failure) if cost.failure else ''}" for cost in costs]}


def _traces(scene: MeasuredScene, names: Iterable[str], families: Iterable[str]) -> list[dict[str, Any]]:
    """Points of the traces that every scene has, in the order of the looks."""
    own = dict(scene.routes(PRODUCT))
    outside = by_family(scene)
    step_x, step_y = _steps(front(scene))
    return [*(_broken([_points(members) for members in series(own.get(name, []))]) for name in names),
            *(_points(outside[family][1] if family in outside else []) for family in families),
            {"x": step_x, "y": step_y}, _points([scene.paper] if scene.paper else [])]


def _broken(parts: list[dict[str, Any]]) -> dict[str, Any]:
    """One trace of several lines: a gap between two of them."""
    joined: dict[str, Any] = {"x": [], "y": [], "customdata": []}
    for number, part in enumerate(parts):
        for key, values in joined.items():
            values.extend([None] if number else [])
            values.extend(part[key])
    return joined


def _steps(costs: list[Cost]) -> tuple[list[float], list[float]]:
    """Corners of the front."""
    x, y = places(costs)
    return ([time for pair in pairwise(x) for time in pair] + x[-1:],
            [error for one in y[:-1] for error in (one, one)] + y[-1:])


def _state(scene: MeasuredScene, wanted: float, unit_seconds: float) -> dict[str, Any]:
    found = answer(scene, wanted)
    marks = [_points([cost] if cost else []) for cost in (found.promised, found.outside)]
    level = max(wanted, LEAST)
    return {"marks": [*marks, {"x": [1e-3, 1e9], "y": [level, level]}], "words": words(scene, found, unit_seconds)}


def _looks(own: Iterable[str], families: Mapping[str, str]) -> list[dict[str, Any]]:
    hover = {"hovertemplate": "%{customdata}<extra></extra>"}
    return [
        *({"name": name, "mode": "lines+markers", "line": {"color": colour, "width": 1.5},
           "marker": {"symbol": PLOTLY_MARKERS[marker], "size": 8}, **hover}
          for name, (marker, colour) in ((name, LOOKS.get(name, OTHER_LOOK)) for name in own)),
        *({"name": family, "mode": "markers",
           "marker": {"symbol": _open(PLOTLY_MARKERS[marker]), "size": 7, "color": PALE, "line": {
               "width": 1.2, "color": PALE}}, **hover} for family, marker in families.items()),
        {"name": "front", "mode": "lines", "line": {"color": INK, "width": 1}, "hoverinfo": "skip"},
        {"name": "the paper's rule", "mode": "markers", "marker": {"symbol": "circle-open", "size": 15, "color": INK,
                                                                  "line": {"width": 2}}, **hover}]


def _open(symbol: str) -> str:
    return symbol if symbol.endswith("-open") else f"{symbol}-open"


def _mark_looks() -> list[dict[str, Any]]:
    hover = {"hovertemplate": "%{customdata}<extra></extra>"}
    return [{"name": "stated beforehand", "mode": "markers", "marker": {"symbol": "star", "size": 19, "color": INK,
                                                               "line": {"width": 1, "color": "white"}}, **hover},
            {"name": "outside, in hindsight", "mode": "markers",
             "marker": {"symbol": "star-open", "size": 17, "color": INK, "line": {"width": 1.5}}, **hover},
            {"name": "wanted", "mode": "lines", "line": {"color": VERMILION, "width": 1.2, "dash": "dash"},
             "hoverinfo": "skip"}]
