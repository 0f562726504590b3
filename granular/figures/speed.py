"""Time against number of assemblies, and what each effect costs, from the stored measurements of ``granular speed``."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from granular.figures.cost_pareto import size
from granular.figures.look import (
    BLUE,
    GREEN,
    INK,
    PURPLE,
    SKY,
    SOFT_INK,
    VERMILION,
    blank,
    house_style,
    plotly_layout,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from granular.speed.store import Row, Study

COLOURS = {"constant": BLUE, "kinetic": VERMILION, "slip": GREEN}
"""Of the comparisons that are made for every number of assemblies."""

MARKERS = {"compiled": "o", "numpy": "s"}
"""Of the engines."""

ONE_A_CALL = {"closed form, one a call": PURPLE, "scipy.integrate.quad, one a call": SKY}
"""Ways that do one assembly after the other, however many there are."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Curve:
    """Time of an assembly against how many there are.

    Attributes
    ----------
    name, colour, marker : str
        For the legend; no marker for a way that does one after the other.
    sizes : list of int
        How many assemblies are done in one call [-].
    nanoseconds : list of float
        Time of each of them [ns].
    dashed : bool
        For limits, and for the slower engine.
    """

    name: str
    colour: str
    marker: str
    sizes: list[int]
    nanoseconds: list[float]
    dashed: bool


def curves(study: Study) -> Iterator[Curve]:
    """Curves of the picture, from the slowest way to the limit of the machine.

    Parameters
    ----------
    study : Study
        What was measured.

    Returns
    -------
    iterator of Curve
        Those that were measured.

    Notes
    -----
    Source: the rows of the study.
    """
    ends = [row.size for name in COLOURS for row in study.of(name)]
    for row in study.of("per-item"):
        for way in row.ways:
            if way.name in ONE_A_CALL:
                yield Curve(name=way.name, colour=ONE_A_CALL[way.name], marker="", sizes=[min(ends), max(ends)],
                            nanoseconds=[way.nanoseconds] * 2, dashed=False)
    for name in reversed(COLOURS):
        for engine in reversed(MARKERS):
            found = [(way.elements, way.nanoseconds) for row in study.of(name) for way in row.ways
                     if way.name == f"{name}, {engine}"]
            if found:
                yield Curve(name=f"{name}, {engine}", colour=COLOURS[name], marker=MARKERS[engine],
                            sizes=[size for size, _ in found], nanoseconds=[time for _, time in found],
                            dashed=engine == "numpy")
    moved = [(row.size, row.ways[0].nanoseconds) for row in study.of("kinetic")]
    if moved:
        yield Curve(name="moving the same arrays", colour=INK, marker="", sizes=[size for size, _ in moved],
                    nanoseconds=[time for _, time in moved], dashed=True)


@house_style
def scaling(study: Study) -> Figure:
    """Draw the time of an assembly against how many are computed in one call.

    Parameters
    ----------
    study : Study
        What was measured.

    Returns
    -------
    matplotlib.figure.Figure
        Both axes logarithmic; the legend stands above.

    Notes
    -----
    Source: :func:`curves`.
    """
    figure = blank(height=4.4)
    axes = figure.add_subplot()
    for curve in curves(study):
        axes.plot(curve.sizes, curve.nanoseconds, color=curve.colour, marker=curve.marker or None, markersize=4.5,
                  linestyle="--" if curve.dashed else "-", linewidth=1.2, label=curve.name,
                  markerfacecolor="white" if curve.dashed else curve.colour, markeredgewidth=1.0)
    axes.set(xscale="log", yscale="log", xlabel="assemblies in one call [–]", ylabel="time of one assembly [ns]")
    axes.minorticks_off()
    figure.legend(loc="outside upper center", ncols=2, frameon=False, handlelength=2.6, columnspacing=1.4)
    return figure


def scaling_interactive(study: Study) -> Any:
    """Make the same picture with values for the pointer, and curves that can be switched off.

    Parameters
    ----------
    study : Study
        What was measured.

    Returns
    -------
    plotly.graph_objects.Figure
        The same curves.

    Notes
    -----
    Source: :func:`curves`.
    """
    import plotly.graph_objects as go

    figure = go.Figure()
    symbols = {"o": "circle", "s": "square-open"}
    for curve in curves(study):
        figure.add_scatter(
            x=curve.sizes, y=curve.nanoseconds, name=curve.name, mode="lines+markers" if curve.marker else "lines",
            line={"color": curve.colour, "dash": "dash" if curve.dashed else "solid", "width": 2},
            marker={"symbol": symbols.get(curve.marker, "circle"), "size": 8},
            hovertemplate="%{y:.3g} ns each, %{x:,} in a call<extra>%{fullData.name}</extra>")
    logarithmic = {"type": "log", "dtick": 1, "exponentformat": "power"}
    figure.update_layout(plotly_layout(
        height=560, legend={"orientation": "h", "y": -0.2, "yanchor": "top"},
        xaxis={"title": "assemblies in one call [–]", **logarithmic},
        yaxis={"title": "time of one assembly [ns]", **logarithmic}))
    return figure


@house_style
def effect_costs(row: Row) -> Figure:
    """Draw what each effect costs, with its error.

    Parameters
    ----------
    row : Row
        The comparison of effects, of arrays or of scenes.

    Returns
    -------
    matplotlib.figure.Figure
        A bar for each, the axis logarithmic; the error stands at its end.

    Notes
    -----
    Source: the row.
    """
    figure = blank(height=0.75 + 0.3 * len(row.ways))
    axes = figure.add_subplot()
    times = [way.nanoseconds for way in row.ways]
    places = list(range(len(times)))
    kinds = [GREEN if way.name.startswith("static") else BLUE for way in row.ways]
    unit = 1e-3 if min(times) > 1e4 else 1.0  # of the axis, in nanoseconds
    axes.barh(places, [time * unit for time in times], color=kinds, height=0.62)
    for place, way in zip(places, row.ways, strict=True):
        error = "" if way.error is None else f"   error {way.error:.0e}".replace("e-0", "e-").replace("-", "−")
        axes.annotate(f"{size(way.nanoseconds * unit)}{error}", (way.nanoseconds * unit, place), xytext=(4, 0),
                      textcoords="offset points", va="center", fontsize=9, color=INK)
    axes.set(yticks=places, yticklabels=[way.name for way in row.ways], xscale="log",
             xlim=(min(times) * unit / 3, max(times) * unit * 200),
             xlabel=f"time of one {row.each} [{'ns' if unit == 1 else 'µs'}]")
    axes.invert_yaxis()
    axes.grid(visible=False, axis="y")
    axes.tick_params(axis="y", length=0, colors=SOFT_INK, labelcolor=INK)
    axes.minorticks_off()
    return figure
