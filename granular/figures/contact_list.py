"""A contact list drawn: where its normals point, and what contacts carry against their angle, with the scatter."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

from granular.contacts.estimate import estimated_forces
from granular.contacts.prediction import fitted_fabric
from granular.directions import relative_density
from granular.errors import FabricOutOfRange, FigureNotKnown
from granular.figures.files import STATIC_SUFFIXES, static_bytes, target, write
from granular.figures.look import BLUE, GREEN, ORANGE, SOFT_INK, VERMILION, blank, house_style, readable

if TYPE_CHECKING:
    import numpy as np
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from granular.contacts.summary import ContactSummary

    Array = NDArray[np.float64]


def save_contact_list(summary: ContactSummary, out: str | os.PathLike[str]) -> Path:
    """Draw a list and write the figure.

    Parameters
    ----------
    summary : ContactSummary
        A list.
    out : str or path-like
        File name; .svg, .png or .pdf.

    Returns
    -------
    Path
        The file.

    Raises
    ------
    FigureNotKnown
        Another suffix.
    FigureNotWritten
        The file cannot be written.

    Notes
    -----
    Source: the interface of ``granular contacts``.
    """
    path = target(out)
    if path.suffix.lower() not in STATIC_SUFFIXES:
        raise FigureNotKnown(f"out = {str(path)!r}", allowed=f"allowed suffixes: {', '.join(STATIC_SUFFIXES)}",
                             remedy="This figure is not interactive; end its name with one of them.")
    write(path, lambda: static_bytes(contact_list_figure(summary), path.suffix.lower()[1:]))
    return path


@house_style
def contact_list_figure(summary: ContactSummary) -> Figure:
    """Draw a rose of the normals, and where the list has them, forces and stiffnesses against the angle.

    Parameters
    ----------
    summary : ContactSummary
        A list.

    Returns
    -------
    matplotlib.figure.Figure
        One to three panels.

    Notes
    -----
    Source: eqs (14), (20), (21) and (23).
    """
    panels = ["rose", *(["forces"] if summary.stress is not None else []),
              *(["stiffness"] if summary.mean_kn is not None else [])]
    figure = blank(height=2.6, layout=None)
    draw_rose(figure.add_axes((0.06, 0.17, 0.21, 0.6), projection="polar"), summary)
    for place, panel in enumerate(panels[1:]):
        axes = figure.add_axes((0.405 + 0.355 * place, 0.17, 0.215, 0.72))
        (_draw_forces if panel == "forces" else _draw_stiffness)(axes, summary)
    return figure


def draw_rose(axes: Axes, summary: ContactSummary) -> None:
    """Draw the density of normals in classes of five degrees, and the fitted one, over a quarter circle.

    Parameters
    ----------
    axes : Axes
        With polar coordinates.
    summary : ContactSummary
        A list.

    Notes
    -----
    A class is drawn as its mean density over the sphere, over that of an isotropic list: a circle of radius one.
    Source: eq. (14).
    """
    import numpy as np

    edges = np.radians(summary.by_angle.degrees)
    density = summary.by_angle.relative_density()
    axes.bar(edges[:-1], density, width=np.diff(edges), align="edge", facecolor=BLUE, alpha=0.35, edgecolor="white",
             linewidth=0.5)
    angles = np.linspace(0, np.pi / 2, 181)
    axes.plot(angles, np.ones_like(angles), color=SOFT_INK, linestyle=":", linewidth=1.2)
    title = "contacts over isotropic"
    try:
        fabric = fitted_fabric(summary)
        axes.plot(angles, relative_density(fabric.axial, np.cos(angles)), color=VERMILION)
        title += f"\nline: $D_{{33}} = {fabric.D33:.3f}$"
    except FabricOutOfRange:
        title += "\n(no admissible $D_{33}$)"
    # theta_offset puts axis 3 upwards, and angles run from there to the horizontal
    axes.set(theta_offset=np.pi / 2, theta_direction=-1, thetamin=0, thetamax=90,
             xticks=np.radians([0, 30, 60, 90]), yticks=[0.5, 1.0], ylim=(0, 1.1 * max(1.0, float(density.max()))))
    axes.set_title(title, fontsize=8.5)
    axes.tick_params(axis="y", labelsize=7.5)


def _draw_forces(axes: Axes, summary: ContactSummary) -> None:
    estimate = estimated_forces(summary)
    curves = (("normal_force", "$f_n$", BLUE), ("meridian_force", "$f_s$ up", VERMILION))
    for place, (name, text, colour) in enumerate(curves):
        mean, scatter = summary.by_angle.mean(name), summary.by_angle.scatter(name)
        if mean is None or scatter is None:
            continue
        _mean_with_scatter(axes, summary, mean, scatter, colour, text, place)
        if estimate is not None:
            axes.plot(_middle(summary), estimate[place], color=colour, linestyle=(0, (3, 1.6)), linewidth=1.3)
    _frame(axes, "contact force [N]", "dashed: eq. (23)")


def _draw_stiffness(axes: Axes, summary: ContactSummary) -> None:
    for place, (name, text, colour) in enumerate((("kn", "$k_n$", GREEN), ("ks", "$k_s$", ORANGE))):
        mean, scatter = summary.by_angle.mean(name), summary.by_angle.scatter(name)
        assert mean is not None  # there is a stiffness
        assert scatter is not None
        _mean_with_scatter(axes, summary, mean / 1e3, scatter / 1e3, colour, text, place)
    _frame(axes, "contact stiffness [kN/m]", "band: scatter")


def _mean_with_scatter(axes: Axes, summary: ContactSummary, mean: Array, scatter: Array, colour: str, text: str,
                       place: int) -> None:
    angles = _middle(summary)
    axes.fill_between(angles, mean - scatter, mean + scatter, color=colour, alpha=0.15, linewidth=0)
    axes.plot(angles, mean, color=colour, marker="o", markersize=2.5, linewidth=1.2)
    axes.text(0.97 - 0.24 * place, 0.97, text, color=readable(colour), transform=axes.transAxes, ha="right", va="top")


def _middle(summary: ContactSummary) -> Array:
    edges = summary.by_angle.degrees
    return (edges[1:] + edges[:-1]) / 2


def _frame(axes: Axes, label: str, note: str) -> None:
    axes.set(xlim=(0, 90), xticks=range(0, 91, 30), xlabel="angle from axis 3 [deg]", ylabel=label)
    axes.set_ylim(bottom=min(0.0, axes.get_ylim()[0]))
    axes.set_title(note, fontsize=8.5, color=SOFT_INK)
