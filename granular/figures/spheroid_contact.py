"""Two flat spheroids in contact: why the branch vector does not follow the contact normal."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from granular.collinear import deviation_angle
from granular.figures.look import BLUE, INK, SKY, SOFT_INK, VERMILION, blank, house_style, readable
from granular.spheroid import branch_vectors, squared_equator

if TYPE_CHECKING:
    import numpy as np
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

ASPECT_RATIO = 0.5
"""b/a of the example [-]."""

ANGLE = 45.0
"""Angle of the contact normal from axis 3 [degrees]."""

FURTHER = (0.3, 0.5, 0.7, 0.9)
"""Aspect ratios of the curves on the right [-]."""

SHADES = ("#00436b", "#0072b2", "#4c9ecb", "#8cc3e0")


@house_style
def touching_spheroids() -> Figure:
    """Draw a meridian section of two grains in contact, and the deviation against the angle of the normal.

    Returns
    -------
    matplotlib.figure.Figure
        Two panels.

    Notes
    -----
    Source: l = 2 M^2 n/\\|M n\\|.
    """
    figure = blank(height=3.1, layout=None)
    _section(figure.add_axes((0.01, 0.02, 0.5, 0.96)))
    _deviations(figure.add_axes((0.62, 0.17, 0.33, 0.73)))
    return figure


def _section(axes: Axes) -> None:
    import numpy as np
    from matplotlib.patches import Arc, Ellipse

    a = float(squared_equator(ASPECT_RATIO)) ** 0.5
    b = ASPECT_RATIO * a
    beta = math.radians(ANGLE)
    normal = np.array([math.sin(beta), math.cos(beta)])
    branch = 2.0 * branch_vectors(ASPECT_RATIO, [normal[0], 0.0, normal[1]])[[0, 2]]
    contact, along = branch / 2.0, np.array([normal[1], -normal[0]])

    for centre in (np.zeros(2), branch):
        axes.add_patch(Ellipse(_pair(centre), 2 * a, 2 * b, facecolor=SKY, alpha=0.18, edgecolor="none"))
        axes.add_patch(Ellipse(_pair(centre), 2 * a, 2 * b, facecolor="none", edgecolor=SOFT_INK, linewidth=1.2))
        axes.plot(*centre, "o", color=INK, markersize=3.5)
    axes.plot(*zip(contact - 1.1 * along, contact + 1.1 * along, strict=True), color=SOFT_INK, linestyle=":",
              linewidth=1.1)
    _arrow(axes, np.zeros(2), branch, BLUE)
    _arrow(axes, contact, contact + 1.55 * normal, VERMILION)
    # the same normal through the centre, as long as the part of the branch along it
    part = float(branch @ normal) * normal
    axes.plot(*zip(np.zeros(2), part, strict=True), color=VERMILION, linestyle="--", linewidth=1.0)
    axes.plot(*zip(part, branch, strict=True), color=SOFT_INK, linestyle=":", linewidth=1.1)
    axes.plot(*contact, "o", color=INK, markersize=3.5)

    lean = math.degrees(math.atan2(branch[1], branch[0]))
    axes.add_patch(Arc(_pair(contact), 1.0, 1.0, theta1=lean, theta2=90.0 - ANGLE, color=INK, linewidth=1.0))
    middle = math.radians((lean + 90.0 - ANGLE) / 2)
    degrees = float(deviation_angle(ASPECT_RATIO, normal[1]))
    beside = contact + 0.62 * np.array([math.cos(middle), math.sin(middle)])
    for place, text, colour, ha, va in (
            (beside, f"{degrees:.0f}°", INK, "left", "center"),
            (contact + 1.6 * normal, "$\\mathbf{n}$", readable(VERMILION), "left", "bottom"),
            (0.27 * branch + np.array([0.03, -0.07]), "$\\boldsymbol{\\ell}$", readable(BLUE), "left", "top"),
            (part + np.array([-0.04, 0.06]), "$2|\\mathbf{Mn}|$", readable(VERMILION), "right", "bottom"),
            (np.array([-0.5 * a, 0.04]), "$a$", SOFT_INK, "center", "bottom"),
            (np.array([-0.05, -0.55 * b]), "$b$", SOFT_INK, "right", "center")):
        axes.text(*_pair(place), text, color=colour, ha=ha, va=va)
    for end in ((-a, 0.0), (0.0, -b)):
        axes.plot((0.0, end[0]), (0.0, end[1]), color=SOFT_INK, linewidth=0.9)
    axes.set(aspect="equal", xlim=(-1.06 * a, branch[0] + 1.06 * a), ylim=(-1.4 * b, branch[1] + 1.7 * b))
    axes.set_axis_off()


def _arrow(axes: Axes, start: Array, end: Array, colour: str) -> None:
    axes.annotate("", _pair(end), _pair(start), arrowprops={
        "arrowstyle": "-|>", "color": colour, "linewidth": 1.6, "shrinkA": 0, "shrinkB": 0, "mutation_scale": 11})


def _pair(point: Array) -> tuple[float, float]:
    return float(point[0]), float(point[1])


def _deviations(axes: Axes) -> None:
    import numpy as np

    degrees = np.linspace(0.0, 90.0, 181)
    for shape, colour in zip(FURTHER, SHADES, strict=True):
        angle = deviation_angle(shape, np.sin(np.radians(90.0 - degrees)))
        axes.plot(degrees, angle, color=colour)
        top = int(np.argmax(angle))
        axes.text(degrees[top], angle[top] + 0.8, f"{shape:g}", color=readable(colour), ha="center", va="bottom")
    axes.plot(ANGLE, float(deviation_angle(ASPECT_RATIO, math.cos(math.radians(ANGLE)))), "o", color=INK, markersize=4)
    axes.text(0.98, 0.98, "$b/a$", transform=axes.transAxes, ha="right", va="top", color=readable(BLUE))
    axes.set(xlim=(0, 90), xticks=range(0, 91, 30), ylim=(0, 65), yticks=range(0, 61, 15),
             xlabel="angle of $\\mathbf{n}$ from axis 3 [°]",
             ylabel="angle between $\\boldsymbol{\\ell}$ and $\\mathbf{n}$ [°]")
