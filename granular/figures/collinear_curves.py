"""Aligned spheroids by aspect ratio: what the collinear assumption costs, and what spin and hypothesis do."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from granular.collinear import ASSUMPTIONS, collinear_error, collinear_ratios, true_ratios
from granular.figures.look import BLUE, GREEN, INK, ORANGE, SOFT_INK, VERMILION, blank, house_style, readable
from granular.hypothesis import Hypothesis

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

REACH = (0.3, 3.0)
"""Aspect ratios that are shown [-]."""

STYLES = {"length": (VERMILION, (0, (5, 1.6)), "$|\\boldsymbol{\\ell}|\\,\\mathbf{n}$"),
          "weight": (GREEN, (0, (1, 1.2)), "$W\\,\\mathbf{n}$"),
          "projection": (ORANGE, (0, (3, 1.4, 1, 1.4)), "$2|\\mathbf{Mn}|\\,\\mathbf{n}$")}
"""Colour, line and name of each assumption."""

TITLES = ("$C_{1111}/C_{3333}$", "$C_{2323}/C_{1212}$")
TICKS = (0.3, 0.5, 0.7, 1, 1.5, 2, 3)


@house_style
def collinear_anisotropy(*, poisson_ratio: float = 0.21) -> Figure:
    """Draw both ratios of spheroids, and of the same with their branches laid along the contact normals.

    Parameters
    ----------
    poisson_ratio : float
        Of the grain material [-].

    Returns
    -------
    matplotlib.figure.Figure
        Two panels with two logarithmic axes.

    Notes
    -----
    Source: eq. (6) and eq. (7).
    """
    shapes = _shapes()
    true = [true_ratios(shape, poisson_ratio=poisson_ratio) for shape in shapes]
    figure = blank(height=3.6)
    for place, axes in enumerate(figure.subplots(1, 2)):
        axes.loglog(shapes, [one[place] for one in true], color=BLUE, label="true $\\boldsymbol{\\ell}$")
        for name in ASSUMPTIONS:
            colour, line, label = STYLES[name]
            axes.plot(shapes, [collinear_ratios(name, shape, poisson_ratio=poisson_ratio)[place] for shape in shapes],
                      color=colour, linestyle=line, label=label)
        _frame(axes, TITLES[place])
        _plain(axes, "y")
        axes.set_ylabel(f"{TITLES[place]} [–]")
    figure.axes[0].legend(frameon=False, loc="lower left", handlelength=2.4, borderaxespad=0.2)
    return figure


@house_style
def collinear_errors(*, poisson_ratio: float = 0.21) -> Figure:
    """Draw the error of both ratios when branches are laid along the contact normals.

    Parameters
    ----------
    poisson_ratio : float
        Of the grain material [-].

    Returns
    -------
    matplotlib.figure.Figure
        Two panels; the vertical axis is linear within 10 % and logarithmic beyond.

    Notes
    -----
    Source: eq. (7) against eq. (6).
    """
    from matplotlib.ticker import FuncFormatter, NullLocator

    shapes = _shapes()
    figure = blank(height=3.6)
    panels = figure.subplots(1, 2, sharey=True)
    for place, axes in enumerate(panels):
        axes.set_yscale("symlog", linthresh=10.0, linscale=0.6)
        for name in ASSUMPTIONS:
            colour, line, label = STYLES[name]
            axes.plot(shapes, [collinear_error(name, shape, poisson_ratio=poisson_ratio)[place] for shape in shapes],
                      color=colour, linestyle=line, label=label)
        axes.axhline(0.0, color=SOFT_INK, linewidth=0.9, zorder=1)
        axes.set_xscale("log")
        _frame(axes, f"error of {TITLES[place]}")
        axes.set(ylim=(-120, 2500), yticks=(-100, -30, -10, 0, 10, 30, 100, 300, 1000))
        axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: _signed(value)))
        axes.yaxis.set_minor_locator(NullLocator())
    panels[0].set_ylabel("error [%]")
    panels[1].legend(frameon=False, loc="upper right", handlelength=2.6)
    return figure


@house_style
def spin_and_shear(*, poisson_ratio: float = 0.21) -> Figure:
    """Draw the shear ratio of spheroids that turn with the mean, that spin freely, and by the static hypothesis.

    Parameters
    ----------
    poisson_ratio : float
        Of the grain material [-].

    Returns
    -------
    matplotlib.figure.Figure
        One panel with two logarithmic axes.

    Notes
    -----
    Source: eq. (6) with and without spin, and Figure 1(b).
    """
    shapes = _shapes()
    figure = blank(height=3.4)
    axes = figure.add_subplot()
    curves: Sequence[tuple[str, list[float], str, object]] = (
        ("grains turn\nwith the mean", [true_ratios(r, poisson_ratio=poisson_ratio).shear for r in shapes], BLUE, "-"),
        ("free spin", [true_ratios(r, poisson_ratio=poisson_ratio, free_spin=True).shear for r in shapes], VERMILION,
         "-"),
        ("static", [true_ratios(r, poisson_ratio=poisson_ratio, hypothesis=Hypothesis.STATIC).shear for r in shapes],
         INK, (0, (1, 1.6))))
    for _, values, colour, line in curves:
        axes.loglog(shapes, values, color=colour, linestyle=line)
    _frame(axes, "")
    _plain(axes, "y")
    axes.set(ylabel=f"{TITLES[1]} [–]", ylim=(0.03, 25))
    for (name, _, colour, _), height in zip(curves, (curves[0][1][-1], 2.35, 1.45), strict=True):
        axes.text(1.03 * REACH[1], height, name, color=readable(colour), ha="left", va="center", linespacing=1.05)
    return figure


def _shapes() -> list[float]:
    import numpy as np

    found: list[float] = np.geomspace(*REACH, 61).tolist()
    return found


def _signed(value: float) -> str:
    return f"{value:+g}".replace("-", "−") if value else "0"


def _frame(axes: Axes, title: str) -> None:
    axes.set(xlim=REACH, xlabel="aspect ratio $b/a$ [–]", xticks=TICKS, title=title)
    _plain(axes, "x")
    axes.axvline(1.0, color=SOFT_INK, linestyle=":", linewidth=1.0, zorder=1)


def _plain(axes: Axes, which: str) -> None:
    """Plain numbers on a logarithmic axis."""
    from matplotlib.ticker import FuncFormatter, NullFormatter

    axis = axes.xaxis if which == "x" else axes.yaxis
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axis.set_minor_formatter(NullFormatter())
