"""Figure 5 of the paper: branch lengths and contact normals as surfaces over the directions."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any

from granular.directions import branch_weight, relative_density
from granular.fabric import AxialFabric
from granular.figures.look import blank, house_style, plotly_layout
from granular.figures.surfaces import (
    IN_PRINT,
    TO_TURN,
    draw_surface,
    plotly_axes,
    plotly_bar,
    plotly_space,
    plotly_surface,
    surface,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure

BRANCHES = (0.0, -0.3, -0.6, -0.9)
"""Dr33 of panels (a) to (d)."""

NORMALS = 0.3
"""D33 of panel (e)."""

SLIDER = (0.0, -0.15, -0.3, -0.45, -0.6, -0.75, -0.9)
"""Dr33 of the states of the interactive figure."""

REACH, LOW, HIGH = 1.5, 0.0, 1.5


@house_style
def figure_5() -> Figure:
    """Draw the five panels with one scale of length and of colour.

    Returns
    -------
    matplotlib.figure.Figure
        Panels (a) to (e).

    Notes
    -----
    Source: Figure 5.
    """
    figure = blank(height=4.5)
    panels = [(f"({letter})  $W$,  $D^{{r}}_{{33}} = {_signed(value)}$",
               partial(branch_weight, AxialFabric(Dr33=value))) for letter, value in zip("abcd", BRANCHES, strict=True)]
    panels.append((f"(e)  $4\\pi E$,  $D_{{33}} = {NORMALS}$", partial(relative_density, AxialFabric(D33=NORMALS))))
    for place, (title, radius) in enumerate(panels):
        axes = figure.add_subplot(2, 3, place + 1, projection="3d")
        colours = draw_surface(axes, surface(radius, IN_PRINT), reach=REACH, low=LOW, high=HIGH)
        axes.set_title(title, y=-0.06)
    bar = figure.add_subplot(2, 3, 6)
    bar.set_axis_off()
    inset = bar.inset_axes((0.12, 0.52, 0.76, 0.08))
    figure.colorbar(colours, cax=inset, orientation="horizontal", label="distance from the centre [–]",
                    ticks=[0, 0.5, 1, 1.5])
    return figure


def figure_5_interactive() -> Any:
    """Make the surface of W with a slider over Dr33, and a button for the surface of 4 pi E.

    Returns
    -------
    plotly.graph_objects.Figure
        One three-dimensional scene.

    Notes
    -----
    Source: Figure 5.
    """
    from plotly import graph_objects

    start = SLIDER.index(-0.3)
    bar = plotly_bar("distance from the centre [–]", tickvals=[0, 0.5, 1, 1.5])
    shown = [(partial(branch_weight, AxialFabric(Dr33=value)), "W") for value in SLIDER]
    shown.append((partial(relative_density, AxialFabric(D33=NORMALS)), "4πE"))
    surfaces = [plotly_surface(surface(radius, TO_TURN), low=LOW, high=HIGH, name=name, visible=state == start,
                               colorbar=bar) for state, (radius, name) in enumerate(shown)]

    def only(state: int, **layout: Any) -> dict[str, Any]:
        visible = [other == state for other in range(len(surfaces))]
        return {"method": "update", "args": [{"visible": visible}, layout, list(range(len(surfaces)))]}

    steps = [{"label": _minus(value), **only(state)} for state, value in enumerate(SLIDER)]
    buttons = [{"label": "W", **only(start, **{"sliders[0].visible": True, "sliders[0].active": start})},
               {"label": f"4πE, D₃₃ = {NORMALS}", **only(len(SLIDER), **{"sliders[0].visible": False})}]
    figure = graph_objects.Figure([*surfaces, *plotly_axes(REACH * 1.15)])
    figure.update_layout(**plotly_layout(
        scene=plotly_space(REACH * 1.15), height=560,
        sliders=[{"active": start, "steps": steps, "currentvalue": {"prefix": "Dʳ₃₃ = "}, "pad": {"t": 10, "b": 10}}],
        updatemenus=[{"type": "buttons", "direction": "right", "buttons": buttons, "x": 0.0, "xanchor": "left",
                      "y": 1.08, "yanchor": "top", "showactive": True}]))
    return figure


def _signed(value: float) -> str:
    return f"{value:g}"


def _minus(value: float) -> str:
    return f"{value:g}".replace("-", "−")
