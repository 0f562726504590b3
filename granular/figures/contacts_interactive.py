"""The contacts of a scene to be read with the pointer: curves on the left, the distribution in space on the right."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, Any

from granular.contact_distribution import normal_force, normal_stiffness, shear_stiffness
from granular.contact_law import stiffness_ratio
from granular.figures.by_direction import by_direction
from granular.figures.cones import plotly_band
from granular.figures.look import BLUE, INK, ORANGE, SKY, SOFT_INK, VERMILION, plotly_layout, readable
from granular.figures.surfaces import TO_TURN, at_pointer, plotly_axes, plotly_space, surface

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from granular.fabric import AxialFabric
    from granular.figures.by_direction import ByDirection, Limits
    from granular.loading import Loading

    Array = NDArray[np.float64]
    Radius = Callable[[Array], Array]

HOVER = ("β = %{x:.1f}°<br>f<sub>n</sub> = %{customdata[0]:.4f}<br>f<sub>r</sub> = %{customdata[1]:.4f}<br>"
         "k<sub>n</sub> = %{customdata[2]:.4f}<br>k<sub>r</sub> = %{customdata[3]:.4f}<extra></extra>")
"""All four values at any curve."""


def forces_interactive(fabric: AxialFabric, loading: Loading, *, poisson_ratio: float) -> Any:
    """Make curves of both forces and of the friction, and the normal force as a surface.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branch lengths about axis 3.
    loading : Loading
        Stress and friction.
    poisson_ratio : float
        Of the grain material [-], for the stiffnesses that the pointer shows.

    Returns
    -------
    plotly.graph_objects.Figure
        Two subplots.

    Notes
    -----
    Source: eq. (23).
    """
    import numpy as np

    contacts = by_direction(fabric, loading, poisson_ratio=poisson_ratio)
    curves = [("f<sub>n</sub>", contacts.normal, BLUE, "solid"), ("f<sub>r</sub>", contacts.shear, VERMILION, "solid")]
    if contacts.limit is not None:
        curves.append(("μ f<sub>n</sub>", contacts.limit, INK, "dash"))
    figure = _two_panels(contacts, curves, "force over that of the isotropic assembly [–]", constants=())
    _add_surfaces(figure, contacts.limits, [
        ("normal force", "f<sub>n</sub>", lambda cosine: np.maximum(
            normal_force(fabric, loading, cosine), 0.0), SKY)])
    return figure


def contacts_interactive(fabric: AxialFabric, loading: Loading, *, poisson_ratio: float) -> Any:
    """Make curves of both stiffnesses, and each of them as a surface, with a button for each.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branch lengths about axis 3.
    loading : Loading
        Stress and friction.
    poisson_ratio : float
        Of the grain material [-].

    Returns
    -------
    plotly.graph_objects.Figure
        Two subplots.

    Notes
    -----
    Source: eqs (20) and (21), corrected.
    """
    contacts = by_direction(fabric, loading, poisson_ratio=poisson_ratio)
    curves = [("k<sub>n</sub>", contacts.k_normal, BLUE, "solid"),
              ("k<sub>r</sub>", contacts.k_shear, VERMILION, "solid")]
    figure = _two_panels(contacts, curves, "stiffness over k<sub>n,ref</sub> [–]",
                         constants=((1.0, BLUE), (stiffness_ratio(poisson_ratio), VERMILION)))
    _add_surfaces(figure, contacts.limits, [
        ("shear stiffness", "k<sub>r</sub>", partial(shear_stiffness, fabric, loading, poisson_ratio=poisson_ratio),
         VERMILION),
        ("normal stiffness", "k<sub>n</sub>", partial(normal_stiffness, fabric, loading), SKY)])
    return figure


def _two_panels(contacts: ByDirection, curves: list[tuple[str, Array, str, str]], title: str,
                constants: tuple[tuple[float, str], ...]) -> Any:
    """Curves against the angle on the left, room for a scene on the right."""
    import numpy as np
    from plotly import graph_objects

    four = np.round(np.stack([contacts.normal, contacts.shear, contacts.k_normal, contacts.k_shear], axis=1), 4) + 0.0
    figure = graph_objects.Figure([graph_objects.Scatter(
        x=np.round(contacts.degrees, 6).tolist(), y=(np.round(curve, 5) + 0.0).tolist(), customdata=four.tolist(),
        name=name, mode="lines", line={"color": colour, "width": 2.5, "dash": dash, "simplify": False},
        hovertemplate=HOVER, showlegend=False) for name, curve, colour, dash in curves])
    top = 1.15 * max(1.0, *(float(curve.max()) for _, curve, _, _ in curves))
    bottom = min(0.0, 1.1 * min(float(curve.min()) for _, curve, _, _ in curves))
    names = [_word(90, float(curve[-1]), name, readable(colour), xanchor="left", xshift=5)
             for name, curve, colour, _ in curves]
    shapes = [{"type": "line", "x0": 0, "x1": 90, "y0": level, "y1": level,
               "line": {"color": colour, "width": 1.3, "dash": "dot"}} for level, colour in constants]
    words, tints = _tints(contacts.limits)
    figure.update_layout(**plotly_layout(
        height=470, margin={"l": 10, "r": 10, "t": 50, "b": 10}, annotations=[*names, *words],
        shapes=[*shapes, *tints],
        xaxis={"title": {"text": "angle from axis 3, β [°]"}, "range": [0, 90], "dtick": 15, "domain": [0.0, 0.52]},
        yaxis={"title": {"text": title}, "range": [bottom, top]}))
    return figure


def _tints(limits: Limits) -> tuple[list[dict[str, Any]], list[dict[str, Any]]]:
    """Words above, and tints of, the directions in which contacts slide or have opened."""
    words, tints = [], []
    for pair, word, tint, colour in ((limits.sliding, "sliding", ORANGE, readable(ORANGE)),
                                     (limits.opened, "opened", SOFT_INK, SOFT_INK)):
        if pair is None:
            continue
        tints.append({"type": "rect", "yref": "paper", "x0": pair[0], "x1": pair[1], "y0": 0, "y1": 1,
                      "fillcolor": tint, "opacity": 0.2, "line": {"width": 0}, "layer": "below"})
        words.append(_word(sum(pair) / 2, 1.0, f"<b>{word}</b>", colour, yref="paper", yanchor="top"))
    return words, tints


def _word(x: float, y: float, text: str, colour: str, **more: Any) -> dict[str, Any]:
    return {"x": x, "y": y, "text": text, "showarrow": False, "font": {"color": colour}, **more}


def _add_surfaces(figure: Any, limits: Limits, shown: list[tuple[str, str, Radius, str]]) -> None:
    """Surfaces whose distance from the centre is the value; directions that slide are tinted on the unit sphere."""
    import numpy as np
    from plotly import graph_objects

    reach = 1.0
    first = len(figure.data)
    for number, (_, symbol, radius, colour) in enumerate(shown):
        points = surface(radius, TO_TURN)
        reach = max(reach, float(points.radius.max()))
        x, y, z, distance = (array.astype(np.float32) for array in (
            points.x, points.y, points.z, at_pointer(points.radius)))
        figure.add_trace(graph_objects.Surface(
            x=x, y=y, z=z, customdata=distance, showscale=False, colorscale=[[0, colour], [1, colour]],
            visible=number == 0, lighting={"ambient": 0.65, "diffuse": 0.6, "specular": 0.05},
            lightposition={"x": 1500, "y": 700, "z": 1500},
            hovertemplate=f"{symbol} = %{{customdata:.3f}}<extra></extra>"))
    for pair, word, colour in ((limits.sliding, "sliding", ORANGE), (limits.opened, "opened", SOFT_INK)):
        if pair is not None:
            figure.add_trace(plotly_band(pair, radius=1.02 * reach, colour=colour, name=word, opacity=0.45))
    for axis in plotly_axes(1.3 * reach):
        figure.add_trace(axis)
    figure.update_layout(scene={**plotly_space(1.3 * reach), "domain": {"x": [0.58, 1.0], "y": [0.0, 1.0]}})
    if len(shown) > 1:
        traces = list(range(first, first + len(shown)))
        buttons = [{"method": "restyle", "label": title, "args": [{"visible": [k == j for k in range(len(shown))]},
                                                                 traces]} for j, (title, *_) in enumerate(shown)]
        figure.update_layout(updatemenus=[{"type": "buttons", "direction": "right", "buttons": buttons, "x": 0.79,
                                           "xanchor": "center", "y": 0.0, "yanchor": "bottom", "showactive": True}])
    else:
        figure.add_annotation(**_word(0.79, 1.03, f"distance from the centre: {shown[0][1]}", INK, xref="paper",
                                      yref="paper"))
