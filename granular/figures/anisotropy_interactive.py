"""The map of anisotropy with values under the pointer, a slider over the stress ratio and a button for each measure."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from granular.figures.anisotropy_maps import (
    D33_RANGE,
    DR33_RANGE,
    FRICTION,
    POISSON_RATIO,
    Place,
)
from granular.figures.look import INK, plotly_layout
from granular.figures.surfaces import plotly_bar
from granular.measures import measure

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

POINTS = (33, 25)
"""Values of D33 and of Dr33: steps of a sixteenth and of a twentieth."""

STATES = (None, 0.5, 0.7, 1.0, 1.4, 2.0, 2.8)
"""Stress ratios of the slider; None stands for contacts of one stiffness."""

START = 0
"""State at first."""

BUTTONS = ("C1111/C3333", "C2323/C1212", "delta")
"""Measures that can be drawn: as many as a phone has room for; E1/E3 is nearly the first."""

SHOWN: dict[str, tuple[str, tuple[float, float, float, float]]] = {
    "C1111/C3333": ("C<sub>1111</sub>/C<sub>3333</sub>", (0.2, 4.0, 0.1, 2.4)),
    "C2323/C1212": ("C<sub>2323</sub>/C<sub>1212</sub>", (0.2, 4.0, 0.1, 2.4)),
    "E1/E3": ("E<sub>1</sub>/E<sub>3</sub>", (0.2, 4.0, 0.1, 2.4)),
    "delta": ("δ", (-0.5, 2.0, 0.1, 1.0)),
    "nu31": ("ν<sub>31</sub>", (-0.05, 0.3, 0.01, 0.12)),
}
"""Measures under the pointer: name as plotly sets it; first and last line, their step, end of the colours [-]."""

MARKERS = {"o": "circle-open", "^": "triangle-up-open", "s": "square-open", "D": "diamond-open"}


def anisotropy_interactive(places: Sequence[Place] = ()) -> Any:
    """Make the map with its slider and its buttons.

    Parameters
    ----------
    places : sequence of Place
        Assemblies to mark.

    Returns
    -------
    plotly.graph_objects.Figure
        One map for each state of the slider; the buttons change what all of them show.

    Notes
    -----
    Accuracy: four decimals. Source: eqs (4) and (20) to (23).
    """
    import numpy as np
    from plotly import graph_objects

    D33, Dr33 = np.linspace(*D33_RANGE, POINTS[0]), np.linspace(*DR33_RANGE, POINTS[1])
    values = {name: [_rounded(measure(_stiffness(D33, Dr33, state), name)) for state in STATES] for name in SHOWN}
    first = next(iter(SHOWN))
    hover = "<br>".join(["D<sub>33</sub> = %{x:.2f}, D<sup>r</sup><sub>33</sub> = %{y:.2f}",
                         *(f"{text} = %{{customdata[{place}]:.3f}}" for place, (text, _) in enumerate(SHOWN.values()))])
    maps = [graph_objects.Contour(
        x=np.round(D33, 4), y=np.round(Dr33, 4), z=values[first][place], visible=place == START,
        customdata=np.stack([values[name][place] for name in SHOWN], axis=-1).astype(np.float32),
        hovertemplate=hover + "<extra></extra>", line={"color": INK, "width": 1.0}, **_lines(first))
        for place in range(len(STATES))]
    figure = graph_objects.Figure([*maps, graph_objects.Scatter(
        x=D33_RANGE, y=[-end / 2 for end in D33_RANGE], mode="lines", hoverinfo="skip",
        line={"color": INK, "dash": "dot", "width": 1.5}), *_marks(places)])
    figure.update_layout(**plotly_layout(
        height=670, showlegend=False, margin={"l": 10, "r": 10, "t": 80, "b": 10},
        xaxis={"title": {"text": "contact normals, D<sub>33</sub> [–]"}, "range": D33_RANGE, "dtick": 0.5, "tick0": 0},
        yaxis={"title": {"text": "branches, D<sup>r</sup><sub>33</sub> [–]"}, "range": DR33_RANGE, "dtick": 0.25,
               "tick0": 0},
        sliders=[{"active": START, "currentvalue": {"prefix": "σ₃₃/σ₁₁ = "}, "pad": {"t": 150, "b": 10},
                  "steps": [_step(place, state) for place, state in enumerate(STATES)]}],
        updatemenus=[{"type": "buttons", "direction": "right", "x": 0.0, "xanchor": "left", "y": 1.02,
                      "yanchor": "bottom", "active": 0, "showactive": True, "pad": {"t": 0, "b": 0},
                      "buttons": [_button(name, values[name]) for name in BUTTONS]}]))
    return figure


def _stiffness(D33: Array, Dr33: Array, ratio: float | None) -> Array:
    from granular.array_stiffness import axial_stiffness

    if ratio is None:
        return axial_stiffness(D33, Dr33[:, None], poisson_ratio=POISSON_RATIO, kinetic=False)
    return axial_stiffness(D33, Dr33[:, None], ratio, FRICTION, POISSON_RATIO, rtol=1e-12)


def _rounded(values: Array) -> Array:
    return values.round(4) + 0.0


def _lines(name: str) -> dict[str, Any]:
    """Colours and lines of a measure."""
    text, (low, high, step, bright) = SHOWN[name]
    return {"zmin": low, "zmax": bright, "colorscale": "Viridis", "opacity": 0.8,
            "contours": {"start": low, "end": high, "size": step, "showlabels": True, "coloring": "heatmap",
                         "labelfont": {"size": 11, "color": INK}},
            "colorbar": plotly_bar(f"{text} [–]", y=-0.2, yanchor="top")}


def _button(name: str, values: Sequence[Array]) -> dict[str, Any]:
    text, (low, high, step, bright) = SHOWN[name]
    change = {"z": [each.tolist() for each in values], "zmin": low, "zmax": bright, "contours.start": low,
              "contours.end": high, "contours.size": step, "colorbar.title.text": f"{text} [–]"}
    return {"label": text, "method": "restyle", "args": [change, list(range(len(STATES)))]}


def _step(place: int, state: float | None) -> dict[str, Any]:
    return {"label": "equal contacts" if state is None else f"{state:g}", "method": "restyle",
            "args": [{"visible": [other == place for other in range(len(STATES))]}, list(range(len(STATES)))]}


def _marks(places: Sequence[Place]) -> list[Any]:
    from plotly import graph_objects

    return [graph_objects.Scatter(
        x=[round(place.D33, 4)], y=[round(place.Dr33, 4)], mode="markers", hovertext=place.text,
        hovertemplate="%{hovertext}<br>D<sub>33</sub> = %{x:.2f}, D<sup>r</sup><sub>33</sub> = %{y:.2f}<extra></extra>",
        marker={"symbol": MARKERS[place.marker], "size": 10, "color": INK, "line": {"width": 2}}) for place in places]
