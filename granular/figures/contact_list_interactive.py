"""A contact list to be read with the pointer: roses, forces and stiffnesses by angle, each class with its numbers."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from granular.contacts.moments import DIRECTIONS
from granular.figures.contact_list import (
    ALL,
    FORCES,
    LONG_NOTES,
    ROSES,
    UNITS,
    Curve,
    curves_of,
    fitted_density,
    panels_of,
)
from granular.figures.look import SKY, SOFT_INK, VERMILION, plotly_layout, readable

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from granular.contacts.summary import ContactSummary

    Array = NDArray[np.float64]

HEIGHTS = {ROSES: 330, FORCES: 380}
"""Of a panel [pixels]; the last one for all others, too."""

DIGITS = 5
"""Of a number in the file."""


def contact_list_interactive(summary: ContactSummary, what: str = ALL) -> Any:
    """Make roses of normals and branches, and curves of forces and stiffnesses with their scatter.

    Parameters
    ----------
    summary : ContactSummary
        A list.
    what : str
        "roses", "forces", "stiffness" or "all".

    Returns
    -------
    plotly.graph_objects.Figure
        Panels below each other, the two roses beside each other.

    Raises
    ------
    FigureNotKnown
        The list does not have what the figure is of.

    Notes
    -----
    Source: eqs (14), (20), (21) and (23).
    """
    from plotly.subplots import make_subplots

    panels = panels_of(summary, what)
    heights = [HEIGHTS.get(panel, HEIGHTS[FORCES]) for panel in panels]
    figure = make_subplots(
        rows=len(panels), cols=2, row_heights=heights, vertical_spacing=0.0 if len(panels) == 1 else 110 / sum(heights),
        specs=[[{"type": "polar"}, {"type": "polar"}] if panel == ROSES else [{"type": "xy", "colspan": 2}, None]
               for panel in panels])
    figure.update_layout(**plotly_layout(height=sum(heights) + 60, margin={"l": 10, "r": 10, "t": 85, "b": 10},
                                         showlegend=False))
    for row, panel in enumerate(panels, start=1):
        if panel == ROSES:
            for column, directions in enumerate(DIRECTIONS, start=1):
                _add_rose(figure, summary, directions, row, column)
        else:
            curves = curves_of(summary, panel)
            for curve in curves:
                _add_curve(figure, summary, curve, row)
            names = [f'<b style="color:{readable(curve.colour)}">{curve.name}</b>' for curve in curves]
            _add_title(figure, row, 1, "<br>".join([", ".join(names), LONG_NOTES[panel]]), shift=4)
            figure.update_xaxes(title={"text": "angle from axis 3, β [°]"}, range=[0, 90], dtick=15, row=row, col=1)
            figure.update_yaxes(title={"text": UNITS[panel][0]}, rangemode="tozero", row=row, col=1)
    return figure


def _add_rose(figure: Any, summary: ContactSummary, directions: str, row: int, column: int) -> None:
    """Bars of the classes, the fitted density, and the circle of an isotropic list."""
    import numpy as np
    from plotly import graph_objects

    edges, density = summary.by_angle.degrees, summary.by_angle.relative_density(directions)
    counted = summary.by_angle.counted(directions)
    figure.add_trace(graph_objects.Barpolar(
        theta=_middles(edges), r=_rounded(density), width=np.diff(edges).tolist(), opacity=0.6,
        marker={"color": SKY, "line": {"color": "white", "width": 1}},
        hovertext=[f"{low:.0f}–{high:.0f}° from axis 3<br>{number:.0f} {directions}<br>{over:.3f} of isotropic"
                   for low, high, number, over in zip(edges, edges[1:], counted, density, strict=False)],
        hoverinfo="text"), row=row, col=column)
    angles = np.linspace(0.0, 90.0, 91)
    figure.add_trace(graph_objects.Scatterpolar(
        theta=angles.tolist(), r=[1.0] * angles.size, mode="lines", hoverinfo="skip",
        line={"color": SOFT_INK, "width": 1.5, "dash": "dot"}), row=row, col=column)
    title, reach = f"<b>{directions}</b>", max(1.0, float(density.max()))
    if (fitted := fitted_density(summary, directions, np.cos(np.radians(angles)))) is None:
        title += "<br>no admissible D<sub>33</sub>"
    else:
        title += f"<br>line: D<sub>33</sub> = {fitted[0]:.3f}"
        reach = max(reach, float(fitted[1].max()))
        figure.add_trace(graph_objects.Scatterpolar(
            theta=angles.tolist(), r=_rounded(fitted[1]), mode="lines", line={"color": VERMILION, "width": 2.5},
            hovertemplate="%{theta:.0f}°: fitted %{r:.3f}<extra></extra>"), row=row, col=column)
    figure.update_polars(sector=[0, 90], radialaxis={"range": [0, 1.08 * reach], "tickvals": [0.5, 1.0], "angle": 0,
                                                     "tickfont": {"size": 11}},
                         angularaxis={"rotation": 90, "direction": "clockwise", "tickvals": [0, 30, 60, 90]},
                         row=row, col=column)
    _add_title(figure, row, column, title, shift=16)


def _add_title(figure: Any, row: int, column: int, text: str, *, shift: int) -> None:
    """Words above a panel."""
    place = figure.get_subplot(row, column)
    x, y = (place.domain.x, place.domain.y) if hasattr(place, "domain") else (place.xaxis.domain, place.yaxis.domain)
    figure.add_annotation(text=text, x=sum(x) / 2, y=y[1], xref="paper", yref="paper", xanchor="center",
                          yanchor="bottom", yshift=shift, showarrow=False)


def _add_curve(figure: Any, summary: ContactSummary, curve: Curve, row: int) -> None:
    """A band of the scatter, the mean with its numbers, and the estimate."""
    from plotly import graph_objects

    edges, contacts = summary.by_angle.degrees, summary.by_angle.contacts
    angles = _middles(edges)
    for values, fill in ((curve.mean - curve.scatter, None), (curve.mean + curve.scatter, "tonexty")):
        figure.add_trace(graph_objects.Scatter(
            x=angles, y=_rounded(values), mode="lines", line={"width": 0, "color": curve.colour}, fill=fill,
            fillcolor=_faint(curve.colour), hoverinfo="skip"), row=row, col=1)
    estimates = [math.nan] * contacts.size if curve.estimate is None else curve.estimate.tolist()
    texts = [f"{low:.0f}–{high:.0f}°, {number:.0f} contacts<br><b>{curve.name}</b> {mean:.4g} ± {scatter:.3g}"
             + ("" if math.isnan(estimate) else f"<br>eq. (23): {estimate:.4g}")
             for low, high, number, mean, scatter, estimate in zip(
                 edges, edges[1:], contacts, curve.mean, curve.scatter, estimates, strict=False)]
    figure.add_trace(graph_objects.Scatter(
        x=angles, y=_rounded(curve.mean), mode="lines+markers", line={"color": curve.colour, "width": 2.5},
        hovertext=texts, hoverinfo="text"), row=row, col=1)
    if curve.estimate is not None:
        figure.add_trace(graph_objects.Scatter(
            x=angles, y=_rounded(curve.estimate), mode="lines", hoverinfo="skip",
            line={"color": curve.colour, "width": 2, "dash": "dash"}), row=row, col=1)


def _middles(edges: Array) -> list[float]:
    return [float(angle) for angle in (edges[1:] + edges[:-1]) / 2]


def _rounded(values: Array) -> list[float | None]:
    """Few digits, so that the file is the same on every machine; a class without contacts has none."""
    return [None if math.isnan(value) else float(f"{value:.{DIGITS}g}") for value in values]


def _faint(colour: str) -> str:
    red, green, blue = (int(colour[place:place + 2], 16) for place in (1, 3, 5))
    return f"rgba({red},{green},{blue},0.15)"
