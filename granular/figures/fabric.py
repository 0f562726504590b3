"""The fabric of a scene: where contacts point and how long branches are, as sections and as surfaces."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any

from granular.directions import branch_weight, relative_density
from granular.figures.look import BLUE, SOFT_INK, VERMILION, blank, house_style, plotly_layout, readable
from granular.figures.surfaces import (
    IN_PRINT,
    TO_TURN,
    draw_section,
    draw_surface,
    frame_section,
    plotly_axes,
    plotly_bar,
    plotly_space,
    plotly_surface,
    surface,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from granular.fabric import AxialFabric
    from granular.figures.surfaces import Radius


@house_style
def fabric_figure(fabric: AxialFabric) -> Figure:
    """Draw the density of contact normals and the branch length: a section of both, a surface of each.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branches about axis 3. Those of spheroids are shown by their length, over the direction of
        the contact normal.

    Returns
    -------
    matplotlib.figure.Figure
        Three panels: contacts full, branches dashed, and a dotted circle for an isotropic assembly.

    Notes
    -----
    Source: eq. (14) and Figure 5, and l = 2 M^2 n/\\|M n\\| for spheroids.
    """
    figure = blank(height=2.5, layout=None)
    density, weight, greatest = _radii(fabric)
    branches = "$W$" if fabric.aspect_ratio == 1.0 else "$|\\boldsymbol{\\ell}|/2r_e$"

    section = figure.add_axes((0.09, 0.19, 0.36, 0.73))
    draw_section(section, lambda cosine: 1 + 0 * cosine, SOFT_INK, line=":")
    draw_section(section, density, BLUE)
    draw_section(section, weight, VERMILION, line="--")
    frame_section(section, 1.12 * greatest, across="horizontal [–]", upward="along axis 3 [–]")
    for place, text, colour in ((0.0, "$4\\pi E$", BLUE), (0.5, "isotropic", SOFT_INK), (1.0, branches, VERMILION)):
        section.text(place, 1.02, text, color=readable(colour), transform=section.transAxes, va="bottom",
                     ha={0.0: "left", 0.5: "center", 1.0: "right"}[place])

    for left, radius, title in ((0.46, density, "$4\\pi E$"), (0.735, weight, branches)):
        axes = figure.add_axes((left, 0.2, 0.265, 0.8), projection="3d")
        colours = draw_surface(axes, surface(radius, IN_PRINT), reach=greatest, low=0, high=greatest, zoom=1.35)
        axes.set_title(title, y=-0.02)
    figure.colorbar(colours, cax=figure.add_axes((0.58, 0.2, 0.31, 0.035)), orientation="horizontal",
                    label="distance from the centre [–]")
    return figure


def fabric_interactive(fabric: AxialFabric) -> Any:
    """Make both surfaces to turn, with a button for each.

    Parameters
    ----------
    fabric : AxialFabric
        Contact normals and branches about axis 3, as in :func:`fabric_figure`.

    Returns
    -------
    plotly.graph_objects.Figure
        One three-dimensional scene.

    Notes
    -----
    Source: eq. (14) and Figure 5.
    """
    from plotly import graph_objects

    density, weight, greatest = _radii(fabric)
    branches = "W" if fabric.aspect_ratio == 1.0 else "|ℓ|/2rₑ"
    bar = plotly_bar("distance from the centre [–]")
    surfaces = [plotly_surface(surface(radius, TO_TURN), low=0, high=greatest, name=name, visible=shown, colorbar=bar)
                for radius, name, shown in ((density, "4πE", True), (weight, branches, False))]
    figure = graph_objects.Figure([*surfaces, *plotly_axes(1.2 * greatest)])
    buttons = [{"method": "restyle", "label": label, "args": [{"visible": [first, not first]}, [0, 1]]}
               for label, first in (("4πE (contacts)", True), (f"{branches} (branches)", False))]
    figure.update_layout(**plotly_layout(
        scene=plotly_space(1.2 * greatest), height=480,
        updatemenus=[{"type": "buttons", "direction": "right", "buttons": buttons, "x": 0.0, "xanchor": "left",
                      "y": 1.06, "yanchor": "top", "showactive": True}]))
    return figure


def _radii(fabric: AxialFabric) -> tuple[Radius, Radius, float]:
    """4 pi E and the length of branches as functions of the cosine, and the greatest value of either."""
    import numpy as np

    density = partial(relative_density, fabric)
    weight = partial(branch_weight, fabric)
    cosines = np.linspace(0.0, 1.0, 201)
    return density, weight, float(max(density(cosines).max(), weight(cosines).max()))
