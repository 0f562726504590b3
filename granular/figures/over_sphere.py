"""Functions of direction without an axis: two maps of the half sphere above, roses in the coordinate planes below."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from granular.figures.contacts import HATCH
from granular.figures.hemisphere import GLYPHS, Mark, draw_edge, draw_map, draw_marks, hatch_opened
from granular.figures.look import INK, ORANGE, WIDTH, blank, house_style, key_of
from granular.figures.surfaces import frame_section

if TYPE_CHECKING:
    import numpy as np
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    Array = NDArray[np.float64]
    Values = Callable[[Array], Array]

PLANES = ((0, 1), (0, 2), (1, 2))
"""Coordinate planes by their axes, to the right and upwards, counted from 0."""

AROUND = 721
"""Points of a rose [-], half a degree apart: the shear stiffness ends like a cube root."""

LOOK: dict[str, dict[str, Any]] = {
    "sliding": {"facecolor": ORANGE, "alpha": 0.22, "edgecolor": "none"},
    "opened": {"facecolor": "none", "edgecolor": HATCH, "hatch": "////", "linewidth": 0}}
"""Of directions in which contacts do not stick, in a rose."""

MAPS = 3.66
"""From the top of a figure to the names of the first row of curves [in]."""

ROW, LAST_ROW = 2.04, 1.84
"""From the names of one row of roses to those of the next, and to the end of the figure [in]."""

ROSE = 1.3
"""Side of a rose [in]."""

SIDE = 2.2
"""Side of a map [in]."""


@dataclass(frozen=True, slots=True)
class Quantity:
    """A function of direction and how it is drawn.

    Attributes
    ----------
    title : str
        In words.
    symbol, plain : str
        For matplotlib, with TeX, and for a page, with HTML.
    unit : str
        In which the values are given.
    values : callable
        Takes unit vectors (3, q) [-], gives (q,) values [unit], the same for n and -n.
    colour, line : str
        Of its rose.
    """

    title: str
    symbol: str
    plain: str
    unit: str
    values: Values
    colour: str
    line: str = "-"


@dataclass(frozen=True, slots=True)
class Map:
    """A quantity on the half sphere with the directions that are marked there.

    Attributes
    ----------
    quantity : Quantity
        What the colours say.
    marks : tuple of Mark
        Directions.
    meaning : str
        What they are directions of.
    """

    quantity: Quantity
    marks: tuple[Mark, ...] = ()
    meaning: str = ""


@dataclass(frozen=True, slots=True)
class Picture:
    """What a figure of a scene without an axis shows.

    Attributes
    ----------
    maps : tuple of 2 Map
        The upper half spheres.
    roses : tuple of tuples of Quantity
        Rows of roses: drawn in each coordinate plane as distance from the centre, each row on its own scale.
    margin : callable or None
        Negative where contacts slide: takes unit vectors (3, q) [-], gives (q,) [any unit]; None where none can.
    force : callable or None
        Normal force, negative where contacts have opened, likewise; None where it is not asked.
    turned : tuple of Map
        Surfaces of the interactive figure; by default those of the maps.
    note : str
        What else is drawn on the maps.
    """

    maps: tuple[Map, Map]
    roses: tuple[tuple[Quantity, ...], ...]
    margin: Values | None = None
    force: Values | None = None
    turned: tuple[Map, ...] = ()
    note: str = ""


@house_style
def sphere_figure(picture: Picture) -> Figure:
    """Draw the maps, and below them the roses.

    Parameters
    ----------
    picture : Picture
        What to show.

    Returns
    -------
    matplotlib.figure.Figure
        Two maps with their colour bars, and three panels for each row of roses.

    Notes
    -----
    Source: the equal-area projection; distance as value.
    """
    height = MAPS + ROW * (len(picture.roses) - 1) + LAST_ROW
    figure = blank(height=height, layout=None)
    draw_maps(figure, picture)
    limits = _limits(picture)
    for row, roses in enumerate(picture.roses):
        named = [(curve.symbol, line_of(curve.colour, curve.line)) for curve in roses if curve.symbol]
        if row == len(picture.roses) - 1:
            named += [(word, LOOK[word]) for word, _ in limits]
        key_of(figure, named, height=1 - (MAPS + ROW * row + 0.03) / height)
        side = 1.1 * max(float(curve.values(_circle(*plane)[0]).max()) for curve in roses for plane in PLANES) or 1.0
        for column, plane in enumerate(PLANES):
            axes = figure.add_axes(((0.56 + 1.87 * column) / WIDTH, 1 - (MAPS + ROW * row + 0.08 + ROSE) / height,
                                    ROSE / WIDTH, ROSE / height))
            _rose(axes, roses, plane, side, limits)
    return figure


def _rose(axes: Axes, roses: tuple[Quantity, ...], plane: tuple[int, int], side: float,
          limits: list[tuple[str, Values]]) -> None:
    """Curves in one coordinate plane, over the directions that slide or have opened."""
    n, x, y = _circle(*plane)
    for word, inside in limits:
        reach = 1.5 * side * inside(n)  # a polygon that returns to the centre wherever contacts stick
        axes.fill(reach * x, reach * y, zorder=0, **LOOK[word])
    for curve in roses:
        radius = curve.values(n)
        axes.plot(radius * x, radius * y, **line_of(curve.colour, curve.line))
    across, upward = (f"axis {axis + 1} [{roses[0].unit}]" for axis in plane)
    frame_section(axes, side, across=across, upward=upward, ticks=5)
    axes.yaxis.labelpad = 1.5


def line_of(colour: str, line: str) -> dict[str, Any]:
    """Settings of the curve of a quantity.

    Parameters
    ----------
    colour, line : str
        As in ``Quantity``.

    Returns
    -------
    dict
        For matplotlib's line.

    Notes
    -----
    Source: the look of this package.
    """
    return {"color": colour, "linestyle": line, "linewidth": 1.5}


def draw_maps(figure: Figure, picture: Picture) -> list[Axes]:
    """Draw both maps of a picture with titles, colour bars and what marks mean, in the upper 3.45 in of a figure.

    Parameters
    ----------
    figure : Figure
        Placed by hand, as wide as the column.
    picture : Picture
        What to show.

    Returns
    -------
    list of 2 Axes
        The maps.

    Notes
    -----
    Source: ``granular.figures.hemisphere``.
    """
    from matplotlib.ticker import MaxNLocator

    height = figure.get_figheight()
    edge = opened = False
    panels: list[Axes] = []
    for place, shown in enumerate(picture.maps):
        middle = (0.26 + 0.48 * place) * WIDTH
        figure.text(middle / WIDTH, 1 - 0.05 / height, shown.quantity.title, ha="center", va="top")
        axes = figure.add_axes(((middle - SIDE / 2) / WIDTH, 1 - (0.22 + SIDE) / height, SIDE / WIDTH, SIDE / height))
        panels.append(axes)
        shades = draw_map(axes, shown.quantity.values)
        if picture.margin is not None:
            edge = draw_edge(axes, picture.margin)
        if picture.force is not None:
            opened = hatch_opened(axes, picture.force)
        draw_marks(axes, shown.marks)
        bar = figure.add_axes(((middle - 0.95) / WIDTH, 1 - 2.54 / height, 1.9 / WIDTH, 0.09 / height))
        figure.colorbar(shades, cax=bar, orientation="horizontal", format="{x:.4g}", ticks=MaxNLocator(4),
                        label=f"{shown.quantity.symbol} [{shown.quantity.unit}]").outline.set_visible(False)
    below = ", ".join(["equal area, upper half seen along axis 3 (+)", *["dashed: edge of sliding"] * edge,
                       *["hatched: opened"] * opened, *[picture.note] * bool(picture.note)])
    figure.text(0.5, 1 - 3.05 / height, "\n".join(line for line in (legend(picture.maps), below) if line),
                ha="center", va="top", fontsize=9, color=INK)
    return panels


def legend(maps: Sequence[Map]) -> str:
    """Words for the marks of some maps, each meaning once.

    Parameters
    ----------
    maps : sequence of Map
        The maps.

    Returns
    -------
    str
        Such as "■ greatest, ● least principal stress".

    Notes
    -----
    Source: the look of this package.
    """
    meanings: dict[str, dict[str, None]] = {}
    for shown in maps:
        for mark in shown.marks:
            meanings.setdefault(shown.meaning, {})[f"{GLYPHS[mark.rank]} {mark.rank}"] = None
    return ";  ".join(f"{', '.join(ranks)} {meaning}" for meaning, ranks in meanings.items())


def _circle(first: int, second: int) -> tuple[Array, Array, Array]:
    """Directions (3, q) around a coordinate plane, and their two components in it."""
    import numpy as np

    angle = np.linspace(0.0, 2 * np.pi, AROUND)
    x, y = np.cos(angle), np.sin(angle)
    n = np.zeros((3, AROUND))
    n[first], n[second] = x, y
    return n, x, y


def _limits(picture: Picture) -> list[tuple[str, Values]]:
    """Words and shares, zero or one, of directions that slide or have opened, where some in the planes do."""
    found: list[tuple[str, Values]] = []
    margin, force = picture.margin, picture.force
    if margin is not None:
        found.append(("sliding", lambda n: ((margin(n) < 0) & (True if force is None else force(n) > 0)).astype(float)))
    if force is not None:
        found.append(("opened", lambda n: (force(n) <= 0).astype(float)))
    return [(word, inside) for word, inside in found
            if any(inside(_circle(*plane)[0]).any() for plane in PLANES)]
