"""Numbers of a matplotlib figure, artist by artist."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from granular.figures.drawn_data import Cell, Series, plain_title
from granular.figures.look import GRID, INK, SOFT_INK, readable

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SAME = 0.02
"""Edges of two panels that are no farther apart are in line [share of the figure]."""


def matplotlib_series(figure: Figure) -> Iterator[Series]:
    """Read all panels of a matplotlib figure.

    Parameters
    ----------
    figure : matplotlib.figure.Figure
        What is drawn.

    Yields
    ------
    Series
        In the order of the panels and of what was drawn in each.

    Notes
    -----
    Source: the artists of the figure; grid lines and colour bars are no data.
    """
    panels = [axes for axes in _panels(figure.axes) if not hasattr(axes, "_colorbar")]
    for number, axes in enumerate(panels, start=1):
        title = plain_title(axes.get_title() or axes.get_title(loc="left") or axes.get_title(loc="right"))
        panel = f"{number} {title}".strip()
        for name, columns in _artists(axes):
            yield Series(panel, name, columns)


def _panels(several: Sequence[Any]) -> Iterator[Any]:
    for axes in several:
        yield axes
        yield from _panels(axes.child_axes)


def _artists(axes: Any) -> Iterator[tuple[str, dict[str, Sequence[Cell]]]]:
    import numpy as np

    lines = [line for line in axes.lines if line.get_visible() and not _decorates(line)]
    for line, name in zip(lines, _line_names(axes, lines), strict=True):
        if (columns := _of_line(axes, line)) is not None:
            yield name, columns
    for number, collection in enumerate(axes.collections, start=1):
        if collection.get_visible():
            kind = "surface" if hasattr(collection, "_faces") else f"marks {number}"
            yield from _of_collection(axes, collection, _label(collection) or kind)
    bars = [patch for container in axes.containers if hasattr(container, "patches") for patch in container.patches]
    if bars:
        yield "bars", _of_bars(axes, bars)
    others = [patch for patch in axes.patches if patch not in bars and patch.get_visible()
              and patch.get_transform().contains_branch(axes.transData) and not hasattr(patch, "get_arrowstyle")]
    for number, patch in enumerate(others, start=1):
        vertices = axes.transData.inverted().transform(np.reshape(patch.get_verts(), (-1, 2)))
        yield _label(patch) or f"area {number}", _plane(axes, vertices[:, 0], vertices[:, 1])
    for number, image in enumerate(axes.images, start=1):
        yield f"image {number}", _of_image(axes, image)


def _decorates(line: Any) -> bool:
    """Whether a line is part of a grid, or an axis in space."""
    return _colour(line.get_color()) == GRID or (hasattr(line, "get_data_3d") and len(line.get_xdata()) == 2)


def _label(artist: Any) -> str:
    label = str(artist.get_label() or "")
    return "" if label.startswith("_") else plain_title(label)


def _colour(colour: Any) -> str:
    from matplotlib.colors import to_hex

    return to_hex(colour)


def _line_names(axes: Any, lines: Sequence[Any]) -> list[str]:
    """Names from labels, else from the words in the colour of a curve next to it, else by number, colour and stroke."""
    words = [(text, _colour(text.get_color()), axes.transData.transform(_at(text))) for text in axes.texts
             if text.get_text().strip() and text.get_transform().contains_branch(axes.transData)]
    names: list[str] = []
    for number, line in enumerate(lines, start=1):
        colour = _colour(line.get_color())
        near = [(_distance(line, place), text.get_text()) for text, ink, place in words
                if ink in (colour, readable(colour))
                and (colour not in (INK, SOFT_INK) or line is _nearest(lines, colour, place))]
        name = _label(line) or plain_title(min(near)[1] if near else "")
        if not name or name in names:
            name = f"{name or 'curve'} ({number}, {colour}, {line.get_linestyle()})"
        names.append(name)
    return names


def _nearest(lines: Sequence[Any], colour: str, place: Any) -> Any:
    return min((line for line in lines if _colour(line.get_color()) == colour), key=lambda line: _distance(line, place))


def _distance(line: Any, place: Any) -> float:
    """From a place on the canvas to the closest point of a line [pixels]."""
    import numpy as np

    points = line.get_transform().transform(line.get_xydata())
    return float(np.nanmin(np.hypot(*(points - place).T), initial=np.inf))


def _at(text: Any) -> tuple[float, float]:
    """Where a word stands, in units of the axes that it was given."""
    x, y = text.get_position()
    return float(x), float(y)


def _of_line(axes: Any, line: Any) -> dict[str, Sequence[Cell]] | None:
    if hasattr(line, "get_data_3d"):
        return _space(axes, *line.get_data_3d())
    x, y = line.get_xdata(), line.get_ydata()
    along, up = line.get_transform().contains_branch_seperately(axes.transData)
    if not (along or up):
        return None
    columns = _plane(axes, x if along else [float("nan")] * len(x), y if up else [float("nan")] * len(y))
    if along != up:  # a line from edge to edge: its place says all
        columns = {title: values[:1] for title, values in columns.items()}
    return columns


def _of_collection(axes: Any, collection: Any, name: str) -> Iterator[tuple[str, dict[str, Sequence[Cell]]]]:
    import numpy as np

    shades = collection.get_array()
    if hasattr(collection, "_faces"):  # a surface in space: each face starts at its own point of the grid
        corners = np.asarray(collection._faces)[:, 0]
        yield name, _space(axes, *corners.T)
    elif hasattr(collection, "_segments3d"):
        for number, segment in enumerate(collection._segments3d, start=1):
            yield f"{name}, {number}", _space(axes, *np.asarray(segment).T)
    elif hasattr(collection, "_offsets3d"):
        yield name, _space(axes, *collection._offsets3d)
    elif hasattr(collection, "get_coordinates"):  # a map of rectangles
        corners = np.asarray(collection.get_coordinates())
        if corners.shape[:2] != np.shape(shades):
            corners = (corners[:-1, :-1] + corners[1:, 1:]) / 2
        yield name, _plane(axes, corners[..., 0].ravel(), corners[..., 1].ravel(), np.ravel(shades))
    elif hasattr(collection, "levels"):
        yield from _of_levels(axes, collection, name)
    elif len(offsets := _offsets(axes, collection)):
        yield name, _plane(axes, offsets[:, 0], offsets[:, 1], shades)
    elif collection.get_transform().contains_branch(axes.transData):
        for number, path in enumerate(collection.get_paths(), start=1):
            yield f"{name}, {number}", _plane(axes, path.vertices[:, 0], path.vertices[:, 1])


def _of_levels(axes: Any, collection: Any, name: str) -> Iterator[tuple[str, dict[str, Sequence[Cell]]]]:
    """Level curves, or the outlines of the areas between two levels, each with its level or the lower of the two."""
    import numpy as np

    for level, path in zip(collection.levels, collection.get_paths(), strict=False):
        if len(path.vertices):
            kind = "from level" if collection.filled else "level"
            yield (f"{name}, {kind} {float(level):.6g}",
                   _plane(axes, path.vertices[:, 0], path.vertices[:, 1], np.full(len(path.vertices), level)))


def _offsets(axes: Any, collection: Any) -> Any:
    import numpy as np

    placed = collection.get_offset_transform().contains_branch(axes.transData)
    return np.ma.filled(np.ma.asarray(collection.get_offsets(), float), np.nan) if placed else np.empty((0, 2))


def _of_bars(axes: Any, bars: Sequence[Any]) -> dict[str, Sequence[Cell]]:
    """The two ends of each bar: where it stands and how far it reaches."""
    lying = any(getattr(one, "orientation", "") == "horizontal" for one in axes.containers)
    if lying:
        return _plane(axes, [bar.get_x() + bar.get_width() for bar in bars],
                      [bar.get_y() + bar.get_height() / 2 for bar in bars])
    return _plane(axes, [bar.get_x() + bar.get_width() / 2 for bar in bars],
                  [bar.get_y() + bar.get_height() for bar in bars])


def _of_image(axes: Any, image: Any) -> dict[str, Sequence[Cell]]:
    import numpy as np

    values = np.asarray(image.get_array(), float)
    values = values.mean(axis=2) if values.ndim == 3 else values
    left, right, bottom, top = image.get_extent()
    rows, columns = values.shape
    x = left + (right - left) * (np.arange(columns) + 0.5) / columns
    y = bottom + (top - bottom) * (np.arange(rows) + 0.5) / rows
    across, up = np.meshgrid(x, y if image.origin == "lower" else y[::-1])
    return _plane(axes, across.ravel(), up.ravel(), values.ravel())


def _plane(axes: Any, x: Any, y: Any, value: Any = None) -> dict[str, Sequence[Cell]]:
    import numpy as np

    if axes.name == "polar":
        columns: dict[str, Sequence[Cell]] = {"angle [deg]": _values(np.degrees(np.asarray(x, float))),
                                              "radius": _values(y)}
    else:
        first, second = _titles(axes, "x", "y")
        columns = {first: _words(axes.xaxis, x), second: _words(axes.yaxis, y)}
    return columns if value is None else {**columns, "value": _values(value)}


def _space(axes: Any, x: Any, y: Any, z: Any) -> dict[str, Sequence[Cell]]:
    return dict(zip(_titles(axes, "x", "y", "z"), map(_values, (x, y, z)), strict=True))


def _titles(axes: Any, *letters: str) -> list[str]:
    """Titles of the axes of a panel; one without a title has that of a panel in its row, or in its column."""
    found = []
    for letter in letters:
        asked = [axes, *(other for other in axes.figure.axes if _in_line(axes, other, letter))]
        titles = [getattr(one, f"get_{letter}label", str)() for one in asked]
        found.append(next((plain_title(title) for title in titles if title), letter))
    return [title if found.index(title) == place else f"{title} ({letters[place]})"
            for place, title in enumerate(found)]


def _in_line(axes: Any, other: Any, letter: str) -> bool:
    """Whether another panel covers the same height of the figure (for ``y``) or the same width (for ``x``)."""
    if other is axes or other.name != axes.name or hasattr(other, "_colorbar"):
        return False
    own, their = axes.get_position(), other.get_position()
    apart = (own.y0 - their.y0, own.y1 - their.y1) if letter == "y" else (own.x0 - their.x0, own.x1 - their.x1)
    return letter != "z" and max(map(abs, apart)) < SAME


def _words(axis: Any, places: Any) -> list[Cell]:
    """Numbers, or the words that stand at them where an axis has words."""
    values = _values(places)
    ticks = {float(place): plain_title(tick.get_text())
             for place, tick in zip(axis.get_ticklocs(), axis.get_ticklabels(), strict=False)}
    if type(axis.get_major_locator()).__name__ != "FixedLocator" or all(map(_is_number, ticks.values())):
        return list(values)
    return [ticks.get(float(value)) or value for value in values]


def _is_number(text: str) -> bool:
    return not any(letter.isalpha() for letter in text.replace("mathdefault", ""))


def _values(several: Any) -> list[float]:
    import numpy as np

    values: Any = np.ma.filled(np.ma.asarray(several, float), np.nan)
    return [float(value) for value in np.ravel(values)]
