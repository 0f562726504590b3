"""The look that every figure shares: size, type, colours that colour-blind readers can tell apart, labels at curves."""

from __future__ import annotations

import functools
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, Literal, ParamSpec, TypeVar

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Drawn = ParamSpec("Drawn")
Result = TypeVar("Result")

WIDTH = 5.8
"""Width of a figure [in]: the text column of the book, so that 9 pt in the figure is 9 pt on the page."""

INK, SOFT_INK, GRID = "#1a1a1a", "#5f5f5f", "#dcdcdc"
BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY = "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"
"""Okabe and Ito's palette, without its yellow, which is too light for lines on white."""

MAP = "viridis"
"""Colour map of surfaces: even in lightness, and the same for colour-blind readers."""

COMPONENT_COLOURS = {"C1111": BLUE, "C3333": VERMILION, "C1212": SKY, "C2323": ORANGE, "C1122": GREEN,
                     "C1133": PURPLE}
WAVE_COLOURS = {"P": BLUE, "SV": VERMILION, "SH": GREEN}

VOIGT = {"C1111": ("11", "11"), "C3333": ("33", "33"), "C1122": ("12", "12"), "C1133": ("13", "13"),
         "C2323": ("44", "66"), "C1212": ("66", "44")}
"""Index pairs of each component in the standard and in the paper's Voigt order."""

RC = {
    "font.family": "DejaVu Sans",  # comes with matplotlib, so that every machine draws the same outlines
    "mathtext.fontset": "dejavusans",
    "font.size": 9.5,
    "axes.labelsize": 9.5,
    "axes.titlesize": 9.5,
    "axes.titleweight": "normal",
    "xtick.labelsize": 9,
    "ytick.labelsize": 9,
    "text.color": INK,
    "axes.labelcolor": INK,
    "axes.edgecolor": SOFT_INK,
    "xtick.color": SOFT_INK,
    "ytick.color": SOFT_INK,
    "xtick.labelcolor": INK,
    "ytick.labelcolor": INK,
    "axes.linewidth": 0.7,
    "xtick.major.width": 0.7,
    "ytick.major.width": 0.7,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": GRID,
    "grid.linewidth": 0.5,
    "lines.linewidth": 1.7,
    "lines.solid_capstyle": "round",
    "figure.dpi": 100,
    "figure.facecolor": "white",
    "savefig.facecolor": "white",
    "savefig.dpi": 200,
    "svg.fonttype": "path",
    "svg.hashsalt": "granular",  # fixed element names: the same figure gives the same bytes
}


def house_style(draw: Callable[Drawn, Result]) -> Callable[Drawn, Result]:
    """Run a function with matplotlib's defaults and this look, whatever the reader's own settings are.

    Parameters
    ----------
    draw : callable
        Builds or writes a matplotlib figure.

    Returns
    -------
    callable
        The same function; the settings before are restored after it.

    Notes
    -----
    Source: the look of this package.
    """

    @functools.wraps(draw)
    def styled(*arguments: Drawn.args, **options: Drawn.kwargs) -> Result:
        from matplotlib import style

        with style.context(["default", RC]):
            return draw(*arguments, **options)

    return styled


def blank(height: float, width: float = WIDTH, *, layout: Literal["constrained"] | None = "constrained") -> Figure:
    """Make an empty figure that belongs to no window and no global state.

    Parameters
    ----------
    height, width : float
        Size [in].
    layout : "constrained" or None
        Constrained, so that no label is cut; None where the places are given by hand.

    Returns
    -------
    matplotlib.figure.Figure
        Without axes.

    Notes
    -----
    Source: the look of this package.
    """
    from matplotlib.figure import Figure

    return Figure(figsize=(width, height), layout=layout)


def named(component: str) -> str:
    """Typeset a component by its tensor indices.

    Parameters
    ----------
    component : str
        E.g. ``"C2323"``.

    Returns
    -------
    str
        TeX for matplotlib, e.g. ``$C_{2323}$``.

    Notes
    -----
    Source: the naming rule of this package.
    """
    return f"${component[0]}_{{{component[1:]}}}$"


def named_with_voigt(component: str) -> str:
    """Typeset a component by its tensor indices and by its index pair in the paper's order.

    Parameters
    ----------
    component : str
        One of the six.

    Returns
    -------
    str
        TeX for matplotlib; the paper's name stands in brackets.

    Notes
    -----
    Source: the paper's order of index pairs, 11 22 33 12 13 23.
    """
    return f"{named(component)}  ($C_{{{VOIGT[component][1]}}}$)"


def label_curves(axes: Axes, x: float, heights: Sequence[float], texts: Sequence[str], colours: Sequence[str],
                 *, gap: float) -> None:
    """Write the name of each curve at its end, moved apart where two would overlap.

    Parameters
    ----------
    axes : Axes
        Where the curves are; its limits must be final.
    x : float
        Where the curves end [data units].
    heights : sequence of float
        Where each curve ends [data units].
    texts, colours : sequence of str
        Name and colour of each curve.
    gap : float
        Least distance of two names [data units of the vertical axis].

    Notes
    -----
    Source: names at curves are found faster than in a box.
    """
    order = sorted(range(len(heights)), key=lambda k: heights[k])
    places = spread([heights[k] for k in order], gap)
    for k, place in zip(order, places, strict=True):
        axes.text(x, place, texts[k], color=readable(colours[k]), va="center", ha="left")


def key_of(figure: Figure, entries: Sequence[tuple[str, dict[str, Any]]], *, height: float,
           columns: int | None = None) -> None:
    """Write what lines, marks and shades mean in a row: each name beside a piece of what it names.

    Parameters
    ----------
    figure : Figure
        Placed by hand.
    entries : sequence of (str, dict)
        Name, and settings of matplotlib's line; or of its patch, where there is a ``facecolor``.
    height : float
        Where the row stands, over the height of the figure [-].
    columns : int, optional
        How many names stand in a row [-]; all by default.

    Notes
    -----
    Source: a name in a colour alone says nothing in grey print.
    """
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

    handles = [Patch(label=name, **look) if "facecolor" in look else Line2D([], [], label=name, **look)
               for name, look in entries]
    figure.legend(handles=handles, loc="lower center", bbox_to_anchor=(0.5, height), ncols=columns or len(handles),
                  frameon=False, borderpad=0, borderaxespad=0, handlelength=1.7, columnspacing=1.6, handletextpad=0.5)


def readable(colour: str) -> str:
    """Darken a colour until text in it can be read on white.

    Parameters
    ----------
    colour : str
        ``#rrggbb``.

    Returns
    -------
    str
        The same hue, with a contrast of at least 4.5 to 1 against white.

    Notes
    -----
    Source: relative luminance and contrast of the web content accessibility guidelines.

    Examples
    --------
    >>> readable("#0072b2"), readable("#e69f00")
    ('#0072b2', '#9c6c00')
    """
    parts = [int(colour[k:k + 2], 16) for k in (1, 3, 5)]
    darker = next(shade for percent in range(100, 0, -2)
                  if _contrast(shade := [part * percent // 100 for part in parts]) >= 4.5)
    return "#" + "".join(f"{part:02x}" for part in darker)


def _contrast(parts: Sequence[int]) -> float:
    """Contrast of a colour against white, from 1 to 21."""
    linear = [part / 255 / 12.92 if part <= 10 else ((part / 255 + 0.055) / 1.055) ** 2.4 for part in parts]
    return 1.05 / (0.05 + sum(weight * light for weight, light in zip((0.2126, 0.7152, 0.0722), linear, strict=True)))


def spread(heights: Sequence[float], gap: float) -> list[float]:
    """Move sorted numbers apart to a least distance, each as little as possible.

    Parameters
    ----------
    heights : sequence of float
        In rising order [any unit].
    gap : float
        Least distance [same unit].

    Returns
    -------
    list of float
        In rising order [same unit]; groups stay centred on where they came from.

    Notes
    -----
    Source: neighbours that come too close are merged into groups until none do.

    Examples
    --------
    >>> spread([0.0, 1.0, 1.0, 5.0], gap=1.0)
    [-0.33333333333333337, 0.6666666666666666, 1.6666666666666665, 5.0]
    """
    groups: list[list[float]] = []  # each holds the places that its members would have if alone at offset 0
    for height in heights:
        groups.append([height])
        while len(groups) > 1 and _bottom(groups[-1], gap) - _top(groups[-2], gap) < gap:
            last = groups.pop()
            groups[-1] = groups[-1] + last
    return [_bottom(group, gap) + k * gap for group in groups for k in range(len(group))]


def _bottom(group: Sequence[float], gap: float) -> float:
    return sum(group) / len(group) - gap * (len(group) - 1) / 2


def _top(group: Sequence[float], gap: float) -> float:
    return _bottom(group, gap) + gap * (len(group) - 1)


def plotly_layout(**more: Any) -> dict[str, Any]:
    """Layout of interactive figures in the same look.

    Parameters
    ----------
    **more
        Anything that plotly's layout takes; it overrides the common settings.

    Returns
    -------
    dict
        For ``Figure.update_layout``.

    Notes
    -----
    Source: the look of this package.
    """
    return {"template": "plotly_white", "paper_bgcolor": "white", "plot_bgcolor": "white",
            "font": {"family": "DejaVu Sans, Verdana, sans-serif", "size": 13, "color": INK},
            "margin": {"l": 10, "r": 10, "t": 30, "b": 10}, "height": 460, **more}
