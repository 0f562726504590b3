"""Numbers of a plotly figure, with all the states that its sliders and buttons show."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from granular.figures.drawn_data import Cell, Series, plain_title


def plotly_series(figure: Any) -> Iterator[Series]:
    """Read all traces of a plotly figure.

    Parameters
    ----------
    figure : plotly.graph_objects.Figure
        What is drawn.

    Yields
    ------
    Series
        Traces first, then the curves that each stop of a slider puts in their place; the panel names the stop.

    Notes
    -----
    Source: the figure itself. Surfaces that a slider moves are drawn from its curves and are left out.
    """
    names = [plain_title(trace.name or f"trace {number}") for number, trace in enumerate(figure.data, start=1)]
    shown = _states_of_traces(figure)
    for number, (trace, name) in enumerate(zip(figure.data, names, strict=True)):
        if (columns := _columns(figure, trace)) is not None:
            yield Series(shown.get(number, ""), name, columns)
    for state, change in _steps(figure):
        for name, trace, x, y in _moved(figure, names, change):
            first, second = _axis_titles(figure, trace)
            yield Series(state, name, {first: _values(x), second: _values(y)})


def _states_of_traces(figure: Any) -> dict[int, str]:
    """For figures whose sliders switch traces on and off: the stop at which each trace is seen."""
    found: dict[int, str] = {}
    for slider in figure.layout.sliders:
        prefix = (slider.currentvalue.prefix or "") if slider.currentvalue else ""
        for step in slider.steps:
            visible = step.args[0].get("visible") if step.args and isinstance(step.args[0], Mapping) else None
            if visible and "x" not in step.args[0]:
                found |= {number: plain_title(f"{prefix}{step.label}") for number, on in enumerate(visible)
                          if on and visible.count(True) == 1}
    return found


def _steps(figure: Any) -> Iterator[tuple[str, tuple[Mapping[str, Any], Sequence[int]]]]:
    """Stops of sliders that put other numbers in place, named by the slider, its number and the stop."""
    several = len(figure.layout.sliders) > 1
    buttons = [plain_title(button.label) for menu in figure.layout.updatemenus for button in menu.buttons]
    for number, slider in enumerate(figure.layout.sliders):
        owner = f"{buttons[number] if number < len(buttons) else number + 1}, " if several else ""
        prefix = (slider.currentvalue.prefix or "") if slider.currentvalue else ""
        for step in slider.steps:
            if step.args and isinstance(step.args[0], Mapping) and "x" in step.args[0]:
                places = step.args[2] if len(step.args) > 2 else range(len(figure.data))
                yield plain_title(f"{owner}{prefix}{step.label}"), (step.args[0], list(places))


def _moved(figure: Any, names: Sequence[str], change: tuple[Mapping[str, Any], Sequence[int]],
           ) -> Iterator[tuple[str, Any, Any, Any]]:
    values, places = change
    visible = values.get("visible") or [True] * len(places)
    for order, place in enumerate(places):
        trace = figure.data[place]
        x, y = values["x"][order], values["y"][order]
        if visible[order] and trace.type == "scatter" and x is not None and y is not None:
            yield names[place], trace, x, y


def _columns(figure: Any, trace: Any) -> dict[str, Sequence[Cell]] | None:
    if trace.x is None or trace.y is None or (trace.type == "scatter3d" and trace.hoverinfo == "skip"):
        return None  # nothing to read, or an axis in space
    if trace.type in ("scatter", "scattergl", "bar"):
        first, second = _axis_titles(figure, trace)
        return {first: _values(trace.x), second: _values(trace.y)}
    if trace.type == "scatter3d":
        return dict(zip("xyz", map(_values, (trace.x, trace.y, trace.z)), strict=True))
    if trace.type in ("surface", "heatmap", "contour"):
        return _grid(figure, trace)
    return None


def _grid(figure: Any, trace: Any) -> dict[str, Sequence[Cell]]:
    import numpy as np

    x, y, z = (np.asarray(values) for values in (trace.x, trace.y, trace.z))
    if x.ndim == 1:
        x, y = np.meshgrid(x, y)
    titles = ("x", "y", "z") if trace.type == "surface" else (*_axis_titles(figure, trace), "value")
    columns: dict[str, Sequence[Cell]] = dict(zip(titles, map(_values, (x, y, z)), strict=True))
    colour = getattr(trace, "surfacecolor", None)
    return columns if colour is None else {**columns, "value": _values(colour)}


def _axis_titles(figure: Any, trace: Any) -> tuple[str, str]:
    found = []
    for letter in "xy":
        axis = getattr(figure.layout, f"{letter}axis{(getattr(trace, f'{letter}axis') or letter)[1:]}")
        found.append(plain_title(axis.title.text or letter))
    return found[0], found[1] if found[1] != found[0] else f"{found[1]} (y)"


def _values(several: Any) -> list[Cell]:
    import numpy as np

    flat = np.asarray(several).ravel().tolist()
    return [value if isinstance(value, str) or value is None else float(value) for value in flat]
