"""Functions of direction without an axis as surfaces to turn, with a button for each and lines along what is marked."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from granular.figures.look import INK, plotly_layout
from granular.figures.surfaces import (
    TO_TURN,
    Surface,
    at_pointer,
    plotly_axes,
    plotly_bar,
    plotly_space,
    plotly_surface,
)

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from granular.figures.over_sphere import Map, Picture, Quantity

    Array = NDArray[np.float64]

REACH = 1.3
"""Half the side of the cube that is shown, in units of the largest distance of a surface [-]."""

BEYOND = 1.12
"""Ends of the lines along marked directions, in the same units [-]."""


def sphere_interactive(picture: Picture) -> Any:
    """Make surfaces of the quantities of a picture, one at a time.

    Parameters
    ----------
    picture : Picture
        What to show.

    Returns
    -------
    plotly.graph_objects.Figure
        One three-dimensional scene: distance from the centre is the value over the greatest, colour the value.

    Notes
    -----
    Source: distance as value, as in Figure 5.
    """
    from plotly import graph_objects

    shown = picture.turned or picture.maps
    figure, owners = graph_objects.Figure(), list[int]()
    for number, one in enumerate(shown):
        for trace in (_surface(one.quantity, visible=number == 0), *_lines(one, visible=number == 0)):
            figure.add_trace(trace)
            owners.append(number)
    for line in plotly_axes(REACH):
        figure.add_trace(line)
    buttons = [{"method": "restyle", "label": one.quantity.plain,
                "args": [{"visible": [owner == number for owner in owners]}, list(range(len(owners)))]}
               for number, one in enumerate(shown)]
    figure.update_layout(**plotly_layout(
        scene=plotly_space(REACH), height=500,
        updatemenus=[{"type": "buttons", "direction": "right", "buttons": buttons, "x": 0.0, "xanchor": "left",
                      "y": 1.06, "yanchor": "top", "showactive": True}]))
    return figure


def _surface(quantity: Quantity, *, visible: bool) -> Any:
    """A surface at a distance of the value over the greatest one."""
    import numpy as np

    beta, around = np.meshgrid(np.linspace(0.0, np.pi, TO_TURN[0]), np.linspace(0.0, 2 * np.pi, TO_TURN[1]),
                               indexing="ij")
    n = np.stack([np.sin(beta) * np.cos(around), np.sin(beta) * np.sin(around), np.cos(beta)])
    values = quantity.values(n.reshape(3, -1)).reshape(beta.shape)
    distance = values / max(float(values.max()), 1e-300)
    x, y, z = (np.round(distance * part, 4) + 0.0 for part in n)
    low, high = _ends(values)
    plain = quantity.plain
    title = quantity.title if quantity.title.endswith(plain) else f"{quantity.title}, {plain}"
    trace = plotly_surface(Surface(x, y, z, np.round(distance, 4)), low=low, high=high, name=plain, visible=visible,
                           colorbar=plotly_bar(f"{title} [{quantity.unit}]"))
    unit = "" if quantity.unit == "–" else f" {quantity.unit}"
    told = np.stack([values.round(4), np.degrees(beta).round(2), np.degrees(around).round(1)], axis=-1)
    return trace.update(surfacecolor=values.astype(np.float32), customdata=at_pointer(told).tolist(), hovertemplate=(
        f"{plain} = %{{customdata[0]:.4~g}}{unit}<br>%{{customdata[1]}}° from axis 3,<br>"
        "azimuth %{customdata[2]}° from axis 1<extra></extra>"))


def _ends(values: Array) -> tuple[float, float]:
    """Ends of the colour scale, apart from each other where the values are not."""
    low, high = float(values.min()), float(values.max())
    room = max(0.0, 0.01 * abs(high) - (high - low) / 2)
    return low - room, high + room


def _lines(shown: Map, *, visible: bool) -> list[Any]:
    """Lines along marked directions, named at the end that is nearer to the reader at first."""
    import numpy as np
    from plotly import graph_objects

    found = []
    for mark in shown.marks:
        towards = np.array(mark.direction) * (-1.0 if sum(mark.direction) < 0 else 1.0)
        x, y, z = (np.outer(towards, [-1.0, 1.0]) * BEYOND).round(4).tolist()
        found.append(graph_objects.Scatter3d(
            x=x, y=y, z=z, mode="lines+text", text=["", mark.rank], textfont={"size": 12, "color": INK},
            textposition="middle right", line={"color": INK, "width": 4}, showlegend=False, visible=visible,
            hovertemplate=f"{mark.rank} {shown.meaning}<extra></extra>"))
    return found
