"""Phase speeds of the three plane waves against the angle from axis 3."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from granular.errors import MissingKey
from granular.figures.look import WAVE_COLOURS, blank, house_style, label_curves, plotly_layout, readable

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from granular.waves import Waves

TABLE_II_CASE_3 = {
    "grains": {"shear_modulus": "31 GPa", "poisson_ratio": 0.21, "density": "2650 kg/m^3"},
    "packing": {"void_ratio": 0.5744, "contact_normals": {"D33": 0.3}}, "branches": {"anisotropy": {"D33": -0.3}},
    "stress": {"mean": "28 kPa"}, "model": {"effects": ["packing", "branches"]}}
"""Both anisotropies together, with a density for the grains, which the paper does not give."""


@house_style
def waves_figure(waves: Waves) -> Figure:
    """Draw P above, SV and SH below, on the same scale of metres per second.

    Parameters
    ----------
    waves : Waves
        Speeds of the assembly.

    Returns
    -------
    matplotlib.figure.Figure
        Two panels over one axis of angles.

    Notes
    -----
    Source: the Christoffel equation.
    """
    angles, speeds = _speeds(waves)
    figure = blank(height=3.6)
    pressure, shear = figure.subplots(2, 1, sharex=True)
    panels = ((pressure, ("P",)), (shear, ("SV", "SH")))
    span = 1.25 * max(_span(speeds, names) for _, names in panels)
    for axes, names in panels:
        bottom = max(0.0, (sum(_ends(speeds, names)) - span) / 2)  # no speed is negative, however wide the span
        axes.set(xlim=(0, 90), ylim=(bottom, bottom + span), ylabel="speed [m/s]")
        for name in names:
            axes.plot(angles, speeds[name], color=WAVE_COLOURS[name])
        label_curves(axes, 91.5, [speeds[name][-1] for name in names], list(names),
                     [WAVE_COLOURS[name] for name in names], gap=span / 9)
    shear.set_xticks(range(0, 91, 15))
    shear.set_xlabel("angle of propagation from axis 3 [°]")
    return figure


def waves_interactive(waves: Waves) -> Any:
    """Make the three curves to be read with the pointer.

    Parameters
    ----------
    waves : Waves
        Speeds of the assembly.

    Returns
    -------
    plotly.graph_objects.Figure
        One panel.

    Notes
    -----
    Source: the Christoffel equation.
    """
    from plotly import graph_objects

    angles, speeds = _speeds(waves)
    figure = graph_objects.Figure([
        graph_objects.Scatter(x=angles, y=[round(speed, 2) for speed in curve], name=name, mode="lines",
                              line={"color": WAVE_COLOURS[name], "width": 2.5, "simplify": False},
                              hovertemplate=f"{name}: %{{y:.1f}} m/s at %{{x}}°<extra></extra>")
        for name, curve in speeds.items()])
    figure.update_layout(**plotly_layout(
        xaxis={"title": {"text": "angle of propagation from axis 3 [°]"}, "range": [0, 90], "dtick": 15},
        yaxis={"title": {"text": "phase speed [m/s]"}}, showlegend=False,
        margin={"l": 10, "r": 45, "t": 30, "b": 10},
        annotations=[{"x": 90, "y": curve[-1], "text": name, "showarrow": False, "xanchor": "left", "xshift": 6,
                      "font": {"color": readable(WAVE_COLOURS[name])}} for name, curve in speeds.items()]))
    return figure


def required_density(density: float | None) -> float:
    """Refuse to draw the waves of grains without a density.

    Parameters
    ----------
    density : float or None
        Of the grains [kg/m^3].

    Returns
    -------
    float
        The same [kg/m^3].

    Raises
    ------
    MissingKey
        There is none.

    Notes
    -----
    Source: the scene file's interface.
    """
    if density is None:
        raise MissingKey("grains.density is missing", allowed="needed: a density, for wave speeds",
                         remedy='Give it, for example density = "2650 kg/m^3", or draw another figure.')
    return density


def table_ii_waves() -> Figure:
    """Draw the waves of case 3 of Table II under 28 kPa, in grains of 2650 kg/m^3.

    Returns
    -------
    matplotlib.figure.Figure
        Two panels over one axis of angles.

    Notes
    -----
    Source: Table II, case 3, and the claim that follows it.
    """
    import granular

    waves = granular.evaluate(granular.Scene.model_validate(TABLE_II_CASE_3)).waves
    if waves is None:
        raise AssertionError("the scene of this figure gives a density")
    return waves_figure(waves)


def _speeds(waves: Waves) -> tuple[list[float], dict[str, list[float]]]:
    angles = [float(degrees) for degrees in range(91)]
    directions = [waves.at(degrees) for degrees in angles]
    return angles, {"P": [speed.P for speed in directions], "SV": [speed.SV for speed in directions],
                    "SH": [speed.SH for speed in directions]}


def _ends(speeds: dict[str, list[float]], names: tuple[str, ...]) -> tuple[float, float]:
    together = [speed for name in names for speed in speeds[name]]
    return min(together), max(together)


def _span(speeds: dict[str, list[float]], names: tuple[str, ...]) -> float:
    """Range of some curves, not less than 2 % of the speed, so that an isotropic solid shows a level line."""
    low, high = _ends(speeds, names)
    return max(high - low, 0.02 * high)
