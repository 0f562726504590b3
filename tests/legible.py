"""What makes a static figure legible, for tests: large words that nothing cuts or covers, and a unit at every axis."""

from __future__ import annotations

import itertools
import re

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from matplotlib.text import Text
from matplotlib.transforms import Bbox
from mpl_toolkits.mplot3d.art3d import Text3D
from mpl_toolkits.mplot3d.proj3d import proj_transform

from granular.figures import look


def words(figure: Figure) -> list[tuple[Text, Bbox]]:
    """Every text that a reader sees, with its box in pixels."""
    renderer = FigureCanvasAgg(figure).get_renderer()
    unseen = set()
    for axes in figure.axes:
        for axis in (axes.xaxis, axes.yaxis):
            low, high = sorted(axis.get_view_interval())
            drawn = [tick for tick in axis.get_major_ticks() if low <= tick.get_loc() <= high]
            unseen |= {label for tick in set(axis.majorTicks) - set(drawn) for label in (tick.label1, tick.label2)}
    return [(text, _box(text, renderer)) for text in figure.findobj(Text)
            if text.get_visible() and text.get_text().strip() and text not in unseen
            and (text.axes is None or text.axes.axison or text in (*text.axes.texts, text.axes.title))]


def _box(text: Text, renderer: object) -> Bbox:
    box = text.get_window_extent(renderer)
    if isinstance(text, Text3D):  # its own answer knows nothing of the projection
        x, y, _ = proj_transform(*text.get_position_3d(), text.axes.get_proj())
        centre = text.axes.transData.transform((x, y))
        box = Bbox.from_bounds(centre[0] - box.width / 2, centre[1] - box.height / 2, box.width, box.height)
    return box


def require_large_words(figure: Figure) -> None:
    """Text can be read on the page, at the width of the book's column."""
    assert figure.get_size_inches()[0] == look.WIDTH
    assert min(text.get_fontsize() for text, _ in words(figure)) >= 9


def require_words_apart(figure: Figure) -> None:
    """No label leaves the figure or covers another one."""
    frame = figure.bbox
    seen = words(figure)
    for text, box in seen:
        assert frame.x0 <= box.x0 + 1, text
        assert box.x1 <= frame.x1 + 1, text
        assert frame.y0 <= box.y0 + 1, text
        assert box.y1 <= frame.y1 + 1, text
    for (one, first), (two, second) in itertools.combinations(seen, 2):
        # a pixel of each box is air
        apart = (first.x1 - 1 <= second.x0 + 1 or second.x1 - 1 <= first.x0 + 1
                 or first.y1 - 1 <= second.y0 + 1 or second.y1 - 1 <= first.y0 + 1)
        assert apart, (one.get_text(), two.get_text())


def require_units(figure: Figure) -> None:
    """No number stands without its unit."""
    for axes in figure.axes:
        if axes.name == "rectilinear" and axes.axison and axes.get_xticklabels():
            for label, ticks in ((axes.get_xlabel(), axes.get_xticklabels()),
                                 (axes.get_ylabel(), axes.get_yticklabels())):
                if any(tick.get_text() for tick in ticks):
                    assert re.search(r"\[.+\]", label), axes


def require_more_than_colour(figure: Figure) -> None:
    """Curves of one panel that share dashes, marker and width are named in their colour beside them, not in a key."""
    for axes in figure.axes:
        if axes.name == "3d":
            continue
        texts = [text for text in (*axes.texts, *figure.texts) if text.get_text().strip()]
        named = {to_hex(text.get_color()) for text in texts}
        groups: dict[object, set[str]] = {}
        for line in axes.lines:
            if line.get_visible() and len(line.get_xdata()) > 2:
                style = (vars(line)["_dash_pattern"], line.get_marker(), round(line.get_linewidth(), 1))
                groups.setdefault(str(style), set()).add(to_hex(line.get_color()))
        for colours in groups.values():
            silent = {colour for colour in colours if not {colour, look.readable(colour)} & named}
            assert len(colours) < 2 or len(silent) < 2, (axes.get_title(), axes.get_ylabel(), sorted(silent))
