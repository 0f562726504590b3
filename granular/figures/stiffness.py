"""The stiffness of a solid direction by direction: Young's modulus as a section and as a surface."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from granular.engineering import normal_stiffness, young_modulus
from granular.figures.look import BLUE, VERMILION, blank, house_style, plotly_layout, readable
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
    from collections.abc import Callable

    from matplotlib.figure import Figure

    from granular.elasticity import Stiffness
    from granular.figures.surfaces import Array, Radius

UNITS = ((1e9, "GPa"), (1e6, "MPa"), (1e3, "kPa"), (1.0, "Pa"))


@house_style
def stiffness_figure(stiffness: Stiffness) -> Figure:
    """Draw Young's modulus and the confined stiffness in a vertical section, and Young's modulus as a surface.

    Parameters
    ----------
    stiffness : Stiffness
        Transversely isotropic about axis 3 and positive definite [Pa].

    Returns
    -------
    matplotlib.figure.Figure
        Two panels; the confined stiffness is dashed.

    Notes
    -----
    Source: E(n) = 1/S_nnnn and C_nnnn.
    """
    young, confined, greatest, unit = _radii(stiffness)
    figure = blank(height=2.9, layout=None)
    section = figure.add_axes((0.11, 0.17, 0.44, 0.74))
    draw_section(section, young, BLUE)
    draw_section(section, confined, VERMILION, line="--")
    frame_section(section, 1.1 * greatest, across=f"horizontal [{unit}]", upward=f"along axis 3 [{unit}]")
    for place, text, colour, anchor in ((0.0, "Young's modulus", BLUE, "left"),
                                        (1.0, "$C_{nnnn}$", VERMILION, "right")):
        section.text(place, 1.02, text, color=readable(colour), transform=section.transAxes, va="bottom", ha=anchor)
    space = figure.add_axes((0.58, 0.19, 0.38, 0.81), projection="3d")
    shown = surface(young, IN_PRINT)
    colours = draw_surface(space, shown, reach=greatest, zoom=1.2, **_ends(shown.radius))
    figure.colorbar(colours, cax=figure.add_axes((0.63, 0.17, 0.3, 0.03)), orientation="horizontal",
                    label=f"Young's modulus [{unit}]").ax.locator_params(nbins=4)
    return figure


def stiffness_interactive(stiffness: Stiffness) -> Any:
    """Make the surface of Young's modulus to turn.

    Parameters
    ----------
    stiffness : Stiffness
        Transversely isotropic about axis 3 and positive definite [Pa].

    Returns
    -------
    plotly.graph_objects.Figure
        One three-dimensional scene.

    Notes
    -----
    Source: E(n) = 1/S_nnnn.
    """
    from plotly import graph_objects

    young, _, greatest, unit = _radii(stiffness)
    shown = surface(young, TO_TURN)
    bar = plotly_bar(f"Young's modulus [{unit}]")
    figure = graph_objects.Figure([
        plotly_surface(shown, name=f"Young's modulus [{unit}]", colorbar=bar, **_ends(shown.radius)),
        *plotly_axes(1.2 * greatest)])
    figure.update_layout(**plotly_layout(scene=plotly_space(1.2 * greatest), height=480))
    return figure


def unit_of(greatest: float) -> tuple[float, str]:
    """Choose the unit in which a modulus is read best.

    Parameters
    ----------
    greatest : float
        The greatest value shown [Pa].

    Returns
    -------
    tuple of float and str
        The unit [Pa], and its name.

    Notes
    -----
    Source: SI prefixes.

    Examples
    --------
    >>> unit_of(5.5e8)
    (1000000.0, 'MPa')
    """
    return next((pair for pair in UNITS if greatest >= pair[0]), UNITS[-1])


def _radii(stiffness: Stiffness) -> tuple[Radius, Radius, float, str]:
    """Young's modulus and C_nnnn as functions of the cosine, the greatest of both, and their unit."""
    import numpy as np

    across, along = young_modulus(stiffness, degrees=90.0), young_modulus(stiffness, degrees=0.0)
    scale, unit = unit_of(max(across, along))

    def of_cosine(modulus: Callable[..., float]) -> Radius:
        def radius(cosine: Array) -> Array:
            angles = np.degrees(np.arccos(np.clip(np.abs(cosine), 0.0, 1.0)))
            values = [modulus(stiffness, degrees=float(angle)) / scale for angle in np.ravel(angles)]
            return np.reshape(values, np.shape(cosine))

        return radius

    young, confined = of_cosine(young_modulus), of_cosine(normal_stiffness)
    quarter = np.linspace(0.0, 1.0, 91)
    greatest = float(max(young(quarter).max(), confined(quarter).max()))
    return young, confined, greatest, unit


def _ends(values: Array) -> dict[str, float]:
    """Ends of the colour scale; an isotropic solid gets 1 % on either side, so that rounding shows no colours."""
    low, high = float(values.min()), float(values.max())
    room = max(0.0, 0.01 * high - (high - low) / 2)
    return {"low": low - room, "high": high + room}
