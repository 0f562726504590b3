"""Maps of a sweep over two of its fields: lines of equal value, and which effects are simulated where."""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.errors import FigureNotKnown
from granular.figures.contour_names import on_path
from granular.figures.look import (
    BLUE,
    GREEN,
    GRID,
    INK,
    MAP,
    ORANGE,
    PURPLE,
    SKY,
    SOFT_INK,
    VERMILION,
    blank,
    house_style,
)

if TYPE_CHECKING:
    import numpy as np
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

SYMBOLS = {"packing.contact_normals.D33": "contact normals, $D_{33}$",
           "branches.anisotropy.D33": "branches, $D^r_{33}$",
           "stress.ratio": "stress ratio, $\\sigma_{33}/\\sigma_{11}$", "model.rtol": "wanted accuracy, rtol"}
"""How fields that every reader knows are written at an axis; others keep their names."""

LETTERS = tuple(f"{second}{first}".strip() for second in " abcd" for first in "abcdefghijklmnopqrstuvwxyz")
"""Names of sets of effects on a map, which colours alone would not tell apart in grey print."""

LEVELS = 12
"""About how many lines of equal value a map has."""

KINDS = (GRID, SKY, BLUE, GREEN, ORANGE, VERMILION, PURPLE, SOFT_INK)
"""Colours of sets of effects, in the order in which a map meets them."""


@house_style
def sweep_maps(dataset: xr.Dataset, variable: str, *, x: str, y: str, panels: str) -> Figure:
    """Draw lines of equal value over two fields, one panel for each value of a third; refused points are grey.

    Parameters
    ----------
    dataset : xarray.Dataset
        A sweep over the three fields.
    variable : str
        What is drawn; its unit stands in its attributes.
    x, y : str
        Fields along the axes.
    panels : str
        Field with a panel for each of its values.

    Returns
    -------
    matplotlib.figure.Figure
        Panels side by side, with the same lines.

    Raises
    ------
    FigureNotKnown
        The dataset is no sweep over these three fields, or has no such variable.

    Notes
    -----
    Source: the dataset.
    """
    from matplotlib.ticker import MaxNLocator

    _require(dataset, (variable,), (x, y, panels))
    values = dataset[variable]
    levels = MaxNLocator(LEVELS).tick_values(float(values.min()), float(values.max()))
    places = dataset[panels].values.tolist()
    figure = blank(height=3.4)
    for axes, place in zip(figure.subplots(1, len(places), sharey=True, squeeze=False)[0], places, strict=True):
        panel = dataset.sel({panels: place}).transpose(y, x, ...)
        across, up, heights = (panel[name].values for name in (x, y, variable))
        axes.set_facecolor(GRID)
        axes.grid(False)
        axes.contourf(across, up, heights, levels=levels, cmap=MAP, alpha=0.75)
        lines = axes.contour(across, up, heights, levels=levels, colors=INK, linewidths=0.7)
        axes.clabel(lines, fontsize=9, fmt="%g", manual=on_path(across, up, heights, levels, _diagonal(across, up)))
        axes.xaxis.set_major_locator(MaxNLocator(4))
        axes.set(title=str(place), xlabel=_label(dataset, x))
        if axes.get_subplotspec().is_first_col():
            axes.set_ylabel(_label(dataset, y))
    return figure


@house_style
def effects_map(dataset: xr.Dataset, *, x: str, y: str) -> Figure:
    """Draw which effects are simulated where, over two fields on logarithmic axes.

    Parameters
    ----------
    dataset : xarray.Dataset
        A sweep over the two fields that has kept the effects.
    x, y : str
        Fields along the axes.

    Returns
    -------
    matplotlib.figure.Figure
        One cell for each point, and the sets of effects beside it.

    Raises
    ------
    FigureNotKnown
        The dataset is no sweep over these two fields, or has not kept the effects.

    Notes
    -----
    Source: the dataset.
    """
    from matplotlib import colormaps
    from matplotlib.colors import ListedColormap
    from matplotlib.patches import Patch

    _require(dataset, ("simulated",), (x, y))
    names, kinds = _sets_of_effects(dataset, x, y)
    colours = ListedColormap(KINDS[:len(names)]) if len(names) <= len(KINDS) else colormaps[MAP].resampled(len(names))
    figure = blank(height=4.2)
    axes: Axes = figure.add_subplot()
    axes.grid(False)
    axes.pcolormesh(dataset[x].values, dataset[y].values, kinds, cmap=colours, vmin=-0.5, vmax=len(names) - 0.5,
                    shading="nearest", edgecolors="white", linewidth=0.5)
    axes.set(xscale="log", yscale="log", xlabel=_label(dataset, x), ylabel=_label(dataset, y))
    for kind in range(len(names)):
        row, column = _cell_of(kinds == kind)
        axes.text(dataset[x].values[column], dataset[y].values[row], LETTERS[kind], ha="center", va="center",
                  bbox={"boxstyle": "round,pad=0.12", "facecolor": "white", "edgecolor": "none"})
    handles = [Patch(color=colours(kind), label=f"{LETTERS[kind]}  {name}") for kind, name in enumerate(names)]
    figure.legend(handles=handles, loc="outside lower center", ncols=2, frameon=False, fontsize=9)
    return figure


def _diagonal(across: NDArray[np.float64], up: NDArray[np.float64]) -> list[tuple[float, float]]:
    """From near the lower left corner of a map to near the upper right one."""
    ends = ((part[0] + share * (part[-1] - part[0]) for part in (across, up)) for share in (0.06, 0.94))
    return [(float(x), float(y)) for x, y in ends]


def _cell_of(inside: NDArray[np.bool_]) -> tuple[int, int]:
    """The cell of a region that is nearest to its middle."""
    import numpy as np

    cells = np.argwhere(inside)[::-1]
    row, column = cells[np.abs(cells - cells.mean(axis=0)).sum(axis=1).argmin()]
    return int(row), int(column)


def _sets_of_effects(dataset: xr.Dataset, x: str, y: str) -> tuple[list[str], NDArray[np.int64]]:
    """The sets that occur, smallest first, and which of them each point has."""
    import numpy as np

    simulated = dataset.simulated.transpose(y, x, "effect").values
    effects = dataset.effect.values.tolist()
    rows = simulated.reshape(-1, len(effects))
    sets = sorted({tuple(row) for row in rows.tolist()}, key=lambda row: (sum(row), row))
    names = [", ".join(name for name, there in zip(effects, row, strict=True) if there) or "none" for row in sets]
    kinds = np.array([sets.index(tuple(row)) for row in rows.tolist()], dtype=np.int64)
    return names, kinds.reshape(simulated.shape[:2])


def _require(dataset: xr.Dataset, variables: tuple[str, ...], fields: tuple[str, ...]) -> None:
    for variable in variables:
        if variable not in dataset.data_vars:
            known = ", ".join(map(str, dataset.data_vars))
            raise FigureNotKnown(f"variable {variable}", allowed=f"the sweep has {known}",
                                 remedy="Name one of them, or keep it in the sweep.")
    varied = sorted(map(str, dataset.refusal.dims))
    if sorted(fields) != varied:
        raise FigureNotKnown(f"a map over {', '.join(fields)}", allowed=f"the sweep is over {', '.join(varied)}",
                             remedy="Select single values of the others first, with .sel().")


def _label(dataset: xr.Dataset, field: str) -> str:
    """Name of a field with its unit."""
    unit = dataset[field].attrs.get("units", "1")
    return f"{SYMBOLS.get(field, field)} [{'–' if unit == '1' else unit}]"
