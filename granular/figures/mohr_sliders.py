"""Mohr's circle of the contact forces with sliders: the stress moves the circle, the friction turns the line."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from granular.figures.cones import band
from granular.figures.look import BLUE, INK, VERMILION, plotly_layout
from granular.figures.mohr_circle import Circle, onset_ratio
from granular.figures.surfaces import plotly_axes, plotly_space, surface

if TYPE_CHECKING:
    from granular.figures.by_direction import Range

STRESS_RATIOS = (0.4, 0.6, 0.8, 1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0)
"""States of each slider."""

FRICTION_ANGLES = (8, 12, 20, 30)
"""Buttons [degrees]."""

STEEP = 25
"""Friction angle [degrees] beyond which the line leaves no room on its right for a word."""

START = (12, 2.0)
"""Friction angle [degrees] and stress ratio at first; a button goes back to this stress ratio."""

MOVING = (0, 1, 2, 3, 4, 5)
"""Line, circle, its ends, part of it that slides, ends of that part, band on the sphere; the rest stands still."""

NAMES = ("line of friction", "contacts", "pole and equator", "contacts that slide", "onset of sliding", "sliding band")
"""Of the moving traces, for the numbers that the page offers."""


def mohr_interactive() -> Any:
    """Make the circle and the sphere with a slider over the stress ratio and buttons for the friction angle.

    Returns
    -------
    plotly.graph_objects.Figure
        Two subplots; every state is in the page.

    Notes
    -----
    Source: eqs (21) and (23).
    """
    from plotly import graph_objects

    angle, ratio = START
    change, words = _state(angle, ratio)
    first = [{key: values[place] for key, values in change.items() if values[place] is not None}
             for place in range(len(MOVING))]
    line, circle, poles, arc, ends, cone = ({**one, "name": name} for one, name in zip(first, NAMES, strict=True))
    hover = {"hovertemplate": "β = %{customdata}°<br>f<sub>n</sub> = %{x:.3f}<br>f<sub>r</sub> = %{y:.3f}"
                              "<extra></extra>"}
    figure = graph_objects.Figure([
        graph_objects.Scatter(**line, mode="lines", line={"color": INK, "width": 2}, hoverinfo="skip"),
        graph_objects.Scatter(**circle, mode="lines", line={"color": BLUE, "width": 3, "simplify": False}, **hover),
        graph_objects.Scatter(**poles, mode="markers+text", marker={"color": BLUE, "size": 7}, hoverinfo="skip",
                              cliponaxis=False),
        graph_objects.Scatter(**arc, mode="lines", line={"color": VERMILION, "width": 5, "simplify": False}, **hover),
        graph_objects.Scatter(**ends, mode="markers+text", marker={"color": INK, "size": 8}, hoverinfo="skip",
                              cliponaxis=False),
        graph_objects.Surface(**cone, **_even(VERMILION), hovertemplate="sliding<extra></extra>"), _ball(),
        *plotly_axes(1.3)])
    figure.update_layout(**plotly_layout(
        height=540, showlegend=False, margin={"l": 10, "r": 10, "t": 45, "b": 10},
        xaxis={"title": {"text": "normal force f<sub>n</sub> [–]"}, "range": [0, 2.1], "domain": [0, 0.55],
               "constrain": "domain", "zeroline": False},
        yaxis={"title": {"text": "shear force f<sub>r</sub> [–]"}, "tick0": 0, "dtick": 0.2, "range": [-0.15, 1.0],
               "domain": [0, 0.82], "scaleanchor": "x", "zeroline": False, "constrain": "domain",
               "constraintoward": "bottom"},
        scene={**plotly_space(1.4), "domain": {"x": [0.58, 1.0], "y": [0.0, 1.0]}},
        annotations=[{"x": 0.0, "y": 0.97, "xref": "paper", "yref": "paper", "xanchor": "left", "yanchor": "top",
                      "align": "left", "showarrow": False, "text": words}],
        sliders=[_slider(each, visible=each == angle) for each in FRICTION_ANGLES],
        updatemenus=[{"type": "buttons", "direction": "right", "buttons": [_button(each) for each in FRICTION_ANGLES],
                      "active": FRICTION_ANGLES.index(angle), "x": 0.0, "xanchor": "left", "y": 1.1, "yanchor": "top",
                      "showactive": True}]))
    return figure


def _state(friction_angle: float, stress_ratio: float) -> tuple[dict[str, list[Any]], str]:
    """What the moving traces show, attribute by attribute, and what the words say."""
    import numpy as np

    friction = math.tan(math.radians(friction_angle))
    circle = Circle.of(stress_ratio, friction)
    sliding = circle.limits.sliding
    low, high = sliding or (45.0, 45.0)
    whole, arc = np.linspace(0.0, 90.0, 61), np.linspace(low, high, 31)
    curves = [(np.array([0.0, 2.1]), friction * np.array([0.0, 2.1])), circle.at(whole), circle.at([0.0, 90.0]),
              circle.at(arc), circle.at([low, high])]
    outwards = 1 if stress_ratio >= 1 else -1  # the pole lies to the right when axis 3 carries more
    x, y, z = band((low, high), 1.01, down=10, around=37)
    shown = sliding is not None
    return {
        "x": [*(_short(curve[0]) for curve in curves), _rows(x)],
        "y": [*(_short(curve[1]) for curve in curves), _rows(y)],
        "z": [None] * 5 + [_rows(z)],
        "customdata": [None, np.round(whole, 1).tolist(), None, np.round(arc, 1).tolist(), None, None],
        "text": [None, None, ["β = 0°", "90°"], None, [f"{low:.1f}°", f"{high:.1f}°"], None],
        "textposition": [None, None, ["bottom right", "bottom left"][::outwards], None,
                         ["top right" if friction_angle < STEEP else "top center", "top left"][::outwards], None],
        "visible": [True, True, True, shown, shown, shown],
    }, _words(friction_angle, stress_ratio, sliding)


def _words(friction_angle: float, stress_ratio: float, sliding: Range | None) -> str:
    onset = onset_ratio(friction_angle)
    first = (f"φ = {friction_angle}°: first slide β = {45 + friction_angle / 2:g}° at σ₃₃/σ₁₁ = {onset:.3f},<br>"
             f"or β = {45 - friction_angle / 2:g}° at σ₃₃/σ₁₁ = {1 / onset:.3f}")
    now = "every contact sticks" if sliding is None else f"contacts slide from {sliding[0]:.1f}° to {sliding[1]:.1f}°"
    return f"{first}<br><b>now σ₃₃/σ₁₁ = {stress_ratio:g}: {now}</b>"


def _short(values: Any) -> list[float]:
    return [round(float(value), 4) + 0.0 for value in values]


def _rows(values: Any) -> list[list[float | None]]:
    return [[None if math.isnan(part) else part for part in row] for row in values.tolist()]


def _update(friction_angle: int, stress_ratio: float, **layout: Any) -> dict[str, Any]:
    change, words = _state(friction_angle, stress_ratio)
    return {"method": "update", "args": [change, {"annotations[0].text": words, **layout}, list(MOVING)]}


def _slider(friction_angle: int, *, visible: bool) -> dict[str, Any]:
    return {"active": STRESS_RATIOS.index(START[1]), "visible": visible, "currentvalue": {"prefix": "σ₃₃/σ₁₁ = "},
            "pad": {"t": 25, "b": 10},
            "steps": [{"label": f"{ratio:g}", **_update(friction_angle, ratio)} for ratio in STRESS_RATIOS]}


def _button(friction_angle: int) -> dict[str, Any]:
    layout = {f"sliders[{place}].{key}": value for place, each in enumerate(FRICTION_ANGLES)
              for key, value in (("visible", each == friction_angle), ("active", STRESS_RATIOS.index(START[1])))}
    return {"label": f"φ = {friction_angle}°", **_update(friction_angle, START[1], **layout)}


def _ball() -> Any:
    """The sphere of contact normals."""
    import numpy as np
    from plotly import graph_objects

    points = surface(np.ones_like, (31, 37))
    x, y, z = (part.astype(np.float32) for part in (points.x, points.y, points.z))
    return graph_objects.Surface(x=x, y=y, z=z, name="all directions", **_even("#dfe6ec"), hoverinfo="skip")


def _even(colour: str) -> dict[str, Any]:
    """Settings of a surface of one colour."""
    return {"colorscale": [[0, colour], [1, colour]], "showscale": False,
            "lighting": {"ambient": 0.75, "diffuse": 0.35, "specular": 0.02},
            "lightposition": {"x": 1500, "y": 700, "z": 1500}}
