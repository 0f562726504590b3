"""The contacts of a scene against the angle from axis 3: their forces, and the stiffness that follows from them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.contact_law import stiffness_ratio
from granular.figures.by_direction import by_direction
from granular.figures.look import BLUE, INK, ORANGE, SOFT_INK, VERMILION, blank, house_style, label_curves, readable

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from granular.figures.by_direction import ByDirection, Limits
    from granular.loading import Loading
    from granular.scene import Scene

SHADE = 0.22
"""How strongly the sliding range is tinted."""

HATCH = "#b5b5b5"
"""Colour of the lines over directions in which contacts have opened."""

ANGLE = "angle from axis 3, $\\beta$ [°]"


def loading_of(scene: Scene) -> Loading:
    """Take what the scene says about stress and friction, simulated or not.

    Parameters
    ----------
    scene : Scene
        The assembly and the stress on it.

    Returns
    -------
    Loading
        Principal stresses and friction coefficient.

    Notes
    -----
    Source: the scene file's interface.
    """
    return scene.stress.loading(scene.grains.friction)


def contacts_of(scene: Scene) -> ByDirection:
    """Evaluate the contacts of a scene by direction, whatever effects its model asks for.

    Parameters
    ----------
    scene : Scene
        The assembly and the stress on it.

    Returns
    -------
    ByDirection
        Forces and stiffnesses over those of the isotropic assembly under the same mean stress.

    Notes
    -----
    Source: eqs (20), (21) and (23).
    """
    return by_direction(scene.fabric, loading_of(scene), poisson_ratio=scene.grains.poisson_ratio)


@house_style
def forces_figure(contacts: ByDirection) -> Figure:
    """Draw the normal force above, and below it the shear force against the friction that limits it.

    Parameters
    ----------
    contacts : ByDirection
        Contacts of an assembly.

    Returns
    -------
    matplotlib.figure.Figure
        Two panels over one axis of angles.

    Notes
    -----
    Source: eq. (23).
    """
    figure = blank(height=4.0)
    above, below = figure.subplots(2, 1, sharex=True, height_ratios=(1, 1.25))
    above.plot(contacts.degrees, contacts.normal, color=BLUE)
    above.axhline(1.0, color=SOFT_INK, linestyle=":", linewidth=1.2, zorder=1)
    top = 1.3 * max(1.0, float(contacts.normal.max()))
    bottom = min(0.0, 1.12 * float(contacts.normal.min()))
    above.set(ylim=(bottom, top), ylabel="normal force [–]")
    label_curves(above, 91.5, [float(contacts.normal[-1]), 1.0], ["$f_n$", "isotropic"], [BLUE, SOFT_INK],
                 gap=0.12 * (top - bottom))

    curves = [(contacts.shear, "$f_r$", VERMILION)]
    below.plot(contacts.degrees, contacts.shear, color=VERMILION)
    if contacts.limit is not None:
        below.plot(contacts.degrees, contacts.limit, color=INK, linestyle="--", linewidth=1.3)
        curves.append((contacts.limit, "$\\mu f_n$", INK))
    top = 1.12 * max(0.1, *(float(curve.max()) for curve, _, _ in curves))
    below.set(ylim=(0, top), ylabel="shear force [–]", xlabel=ANGLE)
    label_curves(below, 91.5, [float(curve[-1]) for curve, _, _ in curves], [name for _, name, _ in curves],
                 [colour for _, _, colour in curves], gap=0.1 * top)
    figure.align_ylabels()
    for axes in (above, below):
        mark_limits(axes, contacts.limits, named=axes is above)
    return figure


@house_style
def contacts_figure(contacts: ByDirection, *, poisson_ratio: float) -> Figure:
    """Draw both stiffnesses of the contacts, and dotted what they are when all contacts carry the same.

    Parameters
    ----------
    contacts : ByDirection
        Contacts of an assembly.
    poisson_ratio : float
        Of the grain material [-].

    Returns
    -------
    matplotlib.figure.Figure
        One panel.

    Notes
    -----
    Source: eqs (20) and (21), corrected.
    """
    figure = blank(height=3.3)
    axes = figure.add_subplot()
    ends: list[tuple[float, str, str]] = []
    for curve, constant, name, colour in ((contacts.k_normal, 1.0, "$k_n$", BLUE),
                                          (contacts.k_shear, stiffness_ratio(poisson_ratio), "$k_r$", VERMILION)):
        axes.axhline(constant, color=colour, linestyle=":", linewidth=1.3, zorder=1.5)
        axes.plot(contacts.degrees, curve, color=colour)
        ends.append((float(curve[-1]), name, colour))
    top = 1.13 * max(1.0, float(contacts.k_normal.max()))
    axes.set(ylim=(0, top), xlabel=ANGLE, ylabel="contact stiffness over $k_{n,\\mathrm{ref}}$ [–]")
    label_curves(axes, 91.5, [end for end, _, _ in ends], [name for _, name, _ in ends],
                 [colour for _, _, colour in ends], gap=0.08 * top)
    axes.text(0.0, 1.02, "dotted: equal contacts", transform=axes.transAxes, ha="left", va="bottom", color=SOFT_INK)
    mark_limits(axes, contacts.limits, named=True)
    return figure


def mark_limits(axes: Axes, limits: Limits, *, named: bool) -> None:
    """Tint the directions in which contacts slide, hatch those in which they have opened.

    Parameters
    ----------
    axes : Axes
        Its horizontal axis is the angle from axis 3 [degrees]; its vertical limits must be final.
    limits : Limits
        The directions.
    named : bool
        Whether the words stand above the panel.

    Notes
    -----
    Source: the look of this package.
    """
    axes.set(xlim=(0, 90), xticks=range(0, 91, 15))
    shown: list[tuple[float, str, str]] = []
    if limits.sliding:
        axes.axvspan(*limits.sliding, facecolor=ORANGE, alpha=SHADE, edgecolor="none", zorder=0)
        shown.append((sum(limits.sliding) / 2, "sliding", readable(ORANGE)))
    if limits.opened:
        axes.axvspan(*limits.opened, facecolor="none", edgecolor=HATCH, hatch="////", linewidth=0, zorder=0)
        shown.append((sum(limits.opened) / 2, "opened", SOFT_INK))
    if not named:
        return
    for place, word, colour in shown:
        axes.text(place, 0.985, word, transform=axes.get_xaxis_transform(), ha="center", va="top", color=colour,
                  fontweight="bold", bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.8, "pad": 1})
