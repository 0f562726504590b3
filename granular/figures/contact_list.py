"""A contact list drawn: where normals and branches point, and what contacts carry against their angle, with scatter."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from granular.contacts.estimate import estimated_forces
from granular.contacts.moments import DIRECTIONS, NORMALS
from granular.contacts.prediction import fitted_fabric
from granular.directions import relative_density
from granular.errors import FabricOutOfRange, FigureNotKnown
from granular.figures.files import INTERACTIVE_SUFFIX, SUFFIXES, static_bytes, target, whole_page, write
from granular.figures.look import BLUE, GREEN, ORANGE, SOFT_INK, VERMILION, blank, house_style, readable

if TYPE_CHECKING:
    import numpy as np
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from granular.contacts.summary import ContactSummary

    Array = NDArray[np.float64]

ROSES, FORCES, STIFFNESS, ALL = LIST_FIGURES = ("roses", "forces", "stiffness", "all")
"""Figures of a contact list by name."""

ANGLE = "angle from axis 3, $\\beta$ [°]"
UNITS = {FORCES: ("contact force [N]", 1.0), STIFFNESS: ("contact stiffness [kN/m]", 1e-3)}
"""What stands at the axis, and what one SI unit is in it."""

NOTES = {FORCES: "dashed: eq. (23)", STIFFNESS: "band: scatter"}
LONG_NOTES = {FORCES: "bands: scatter of single contacts; dashed: eq. (23)",
              STIFFNESS: "bands: scatter of single contacts"}
"""What stands over a small panel, and over a large one."""


_SHOWN = {FORCES: (("normal_force", "$f_n$", "normal force", BLUE),
                   ("meridian_force", "$f_s$", "shear force towards axis 3", VERMILION)),
          STIFFNESS: (("kn", "$k_n$", "normal stiffness", GREEN), ("ks", "$k_s$", "shear stiffness", ORANGE))}


@dataclass(frozen=True, slots=True)
class Curve:
    """A mean of contacts in classes of angle.

    Attributes
    ----------
    symbol : str
        Its name in TeX.
    name : str
        Its name in plain words.
    colour : str
        Its colour.
    mean, scatter : (k,) array
        Mean and standard deviation over the contacts of a class [N or kN/m].
    estimate : (k,) array or None
        What eq. (23) says [N].
    """

    symbol: str
    name: str
    colour: str
    mean: Array
    scatter: Array
    estimate: Array | None


def save_contact_list(summary: ContactSummary, out: str | os.PathLike[str], what: str = ALL) -> Path:
    """Draw a list and write the figure.

    Parameters
    ----------
    summary : ContactSummary
        A list.
    out : str or path-like
        File name; its suffix says the format: .svg, .png, .pdf, or .html to read with the pointer, offline.
    what : str
        "roses", "forces", "stiffness" or "all".

    Returns
    -------
    Path
        The file.

    Raises
    ------
    FigureNotKnown
        Another name or suffix, or a figure of what the list does not have.
    FigureNotWritten
        The file cannot be written.

    Notes
    -----
    Source: the interface of ``granular contacts``.
    """
    path = checked_target(what, out)
    suffix = path.suffix.lower()
    panels_of(summary, what)  # a refusal comes before any drawing
    if suffix == INTERACTIVE_SUFFIX:
        from granular.figures.contact_list_interactive import contact_list_interactive

        write(path, lambda: whole_page(contact_list_interactive(summary, what), "contacts", summary.name.strip('"')))
    else:
        write(path, lambda: static_bytes(contact_list_figure(summary, what), suffix[1:]))
    return path


def checked_target(what: str, out: str | os.PathLike[str]) -> Path:
    """Check name and place of a figure, before a list is read for it.

    Parameters
    ----------
    what : str
        Name of the figure.
    out : str or path-like
        File name.

    Returns
    -------
    Path
        The same place.

    Raises
    ------
    FigureNotKnown
        Another name or suffix.
    FigureNotWritten
        The file cannot be written.

    Notes
    -----
    Source: the interface of ``granular contacts``.
    """
    if what not in LIST_FIGURES:
        file = Path(what).suffix.lower() in SUFFIXES
        raise FigureNotKnown(f"figure = {what!r}", allowed=f"allowed: {', '.join(LIST_FIGURES)}",
                             remedy=f"Write it like --plot {ALL} --out {what}." if file else "Name one of these.")
    return target(out)


def panels_of(summary: ContactSummary, what: str) -> tuple[str, ...]:
    """Which panels a figure has.

    Parameters
    ----------
    summary : ContactSummary
        A list.
    what : str
        Name of the figure.

    Returns
    -------
    tuple of str
        Out of "roses", "forces" and "stiffness".

    Raises
    ------
    FigureNotKnown
        The list does not have what the figure is of.

    Notes
    -----
    Source: the interface of ``granular contacts``.
    """
    there = (ROSES, *([FORCES] if summary.stress is not None else []),
             *([STIFFNESS] if summary.mean_kn is not None else []))
    if what == ALL:
        return there
    if what not in there:
        lacks = "contact forces" if what == FORCES else "contact stiffnesses, nor forces with elastic constants"
        raise FigureNotKnown(f"figure = {what!r} of a list without {lacks}", allowed=f"allowed: {', '.join(there)}",
                             remedy="Name one of these, or export the columns that are missing.")
    return (what,)


def curves_of(summary: ContactSummary, panel: str) -> list[Curve]:
    """What a panel shows against the angle.

    Parameters
    ----------
    summary : ContactSummary
        A list.
    panel : str
        "forces" or "stiffness".

    Returns
    -------
    list of Curve
        Without those that the list does not give.

    Notes
    -----
    Source: eqs (20), (21) and (23).
    """
    estimate = estimated_forces(summary) if panel == FORCES else None
    curves = []
    for place, (key, symbol, name, colour) in enumerate(_SHOWN[panel]):
        mean, scatter = summary.by_angle.mean(key), summary.by_angle.scatter(key)
        if mean is not None and scatter is not None:
            unit = UNITS[panel][1]
            curves.append(Curve(symbol, name, colour, unit * mean, unit * scatter,
                                None if estimate is None else unit * estimate[place]))
    return curves


def fitted_density(summary: ContactSummary, directions: str, cosine: Array) -> tuple[float, Array] | None:
    """The density of the model that fits normals or branches.

    Parameters
    ----------
    summary : ContactSummary
        A list.
    directions : str
        "normals" or "branches".
    cosine : (k,) array
        Of the angle from axis 3 [-].

    Returns
    -------
    (float, (k,) array) or None
        D33, and the density over that of an isotropic fabric [-]; None where it would be negative somewhere.

    Notes
    -----
    Source: eq. (14).
    """
    try:
        fabric = fitted_fabric(summary, directions)
        return fabric.D33, relative_density(fabric.axial, cosine)
    except FabricOutOfRange:
        return None


@house_style
def contact_list_figure(summary: ContactSummary, what: str = ALL) -> Figure:
    """Draw roses of normals and branches, and where the list has them, forces and stiffnesses against the angle.

    Parameters
    ----------
    summary : ContactSummary
        A list.
    what : str
        "roses", "forces", "stiffness", or "all" that the list has, with the rose of the normals alone.

    Returns
    -------
    matplotlib.figure.Figure
        One to three panels.

    Raises
    ------
    FigureNotKnown
        The list does not have what the figure is of.

    Notes
    -----
    Source: eqs (14), (20), (21) and (23).
    """
    panels = panels_of(summary, what)
    if what in (FORCES, STIFFNESS):
        figure = blank(height=3.3)
        _draw_curves(figure.add_subplot(), summary, what, large=True)
        return figure
    figure = blank(height=2.6, layout=None)
    if what == ROSES:
        for place, directions in enumerate(DIRECTIONS):
            draw_rose(figure.add_axes((0.11 + 0.5 * place, 0.14, 0.32, 0.62), projection="polar"), summary, directions)
        return figure
    draw_rose(figure.add_axes((0.06, 0.17, 0.21, 0.6), projection="polar"), summary)
    for place, panel in enumerate(panels[1:]):
        _draw_curves(figure.add_axes((0.405 + 0.355 * place, 0.17, 0.215, 0.72)), summary, panel)
    return figure


def draw_rose(axes: Axes, summary: ContactSummary, directions: str = NORMALS) -> None:
    """Draw the density in classes of five degrees, and the fitted one, over a quarter circle.

    Parameters
    ----------
    axes : Axes
        With polar coordinates.
    summary : ContactSummary
        A list.
    directions : str
        "normals" or "branches".

    Notes
    -----
    A class is drawn as its mean density over the sphere, over that of an isotropic list: a circle of radius one.
    Source: eq. (14).
    """
    import numpy as np

    edges = np.radians(summary.by_angle.degrees)
    density = summary.by_angle.relative_density(directions)
    axes.bar(edges[:-1], density, width=np.diff(edges), align="edge", facecolor=BLUE, alpha=0.35, edgecolor="white",
             linewidth=0.5)
    angles = np.linspace(0, np.pi / 2, 181)
    axes.plot(angles, np.ones_like(angles), color=SOFT_INK, linestyle=":", linewidth=1.2)
    title = f"{'contacts' if directions == NORMALS else directions} over isotropic"
    if (fitted := fitted_density(summary, directions, np.cos(angles))) is None:
        title += "\n(no admissible $D_{33}$)"
    else:
        axes.plot(angles, fitted[1], color=VERMILION)
        title += f"\nline: $D_{{33}} = {fitted[0]:.3f}$"
    # theta_offset puts axis 3 upwards, and angles run from there to the horizontal
    axes.set(theta_offset=np.pi / 2, theta_direction=-1, thetamin=0, thetamax=90,
             xticks=np.radians([0, 30, 60, 90]), yticks=[0.5, 1.0], ylim=(0, 1.1 * max(1.0, float(density.max()))))
    axes.set_title(title, fontsize=9)
    axes.tick_params(axis="y", labelsize=9)


def _draw_curves(axes: Axes, summary: ContactSummary, panel: str, *, large: bool = False) -> None:
    edges = summary.by_angle.degrees
    angles = (edges[1:] + edges[:-1]) / 2
    for place, curve in enumerate(curves_of(summary, panel)):
        axes.fill_between(angles, curve.mean - curve.scatter, curve.mean + curve.scatter, color=curve.colour,
                          alpha=0.15, linewidth=0)
        axes.plot(angles, curve.mean, color=curve.colour, marker="os"[place], markersize=3, linewidth=1.2)
        if curve.estimate is not None:
            axes.plot(angles, curve.estimate, color=curve.colour, linestyle=(0, (3, 1.6)), linewidth=1.3)
        at, text = ((0.97, 0.97 - 0.08 * place), curve.name) if large else ((0.97 - 0.34 * place, 0.97), curve.symbol)
        axes.text(*at, f"{'●■'[place]} {text}", color=readable(curve.colour), transform=axes.transAxes,
                  ha="right", va="top")
    axes.set(xlim=(0, 90), xticks=range(0, 91, 15 if large else 30),
             xlabel=ANGLE if large else "angle $\\beta$ [°]", ylabel=UNITS[panel][0])
    axes.set_ylim(bottom=min(0.0, axes.get_ylim()[0]))
    axes.set_title((LONG_NOTES if large else NOTES)[panel], fontsize=9, color=SOFT_INK)
