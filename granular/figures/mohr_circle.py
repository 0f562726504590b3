"""Mohr's circle of the contact forces against the line of friction, and the directions that slide on the sphere."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from granular.figures.by_direction import Limits, limits
from granular.figures.look import BLUE, INK, SKY, SOFT_INK, VERMILION, blank, house_style, readable
from granular.figures.surfaces import Surface, draw_faces
from granular.loading import Loading

if TYPE_CHECKING:
    import numpy as np
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

FRICTION_ANGLE = 12
"""Friction angle of the parametric study [degrees]."""

CONE = 1.6
"""Width at which the one cone of directions at the onset is drawn [degrees]."""

STICKING, SLIDING = 1.3, 2.0
"""Stress ratios on either side of the onset."""


@dataclass(frozen=True, slots=True)
class Circle:
    """Half a circle: the states of the contacts of an isotropic packing under one stress.

    Attributes
    ----------
    equator, pole : float
        Normal force at 90 and at 0 degrees over that under isotropic stress [-].
    limits : Limits
        Which contacts slide.
    """

    equator: float
    pole: float
    limits: Limits

    @classmethod
    def of(cls, stress_ratio: float, friction: float) -> Circle:
        """The circle of a stress ratio sigma33/sigma11 [-] and a friction coefficient [-]."""
        loading = Loading.of_ratio(stress_ratio, friction=friction)
        a, c = loading.coefficients(0.0)
        return cls(float(a), float(c), limits(0.0, loading))

    def at(self, degrees: Any) -> tuple[Array, Array]:
        """Normal and shear force [-] of contacts at angles from axis 3 [degrees]."""
        import numpy as np

        twice = np.radians(2 * np.asarray(degrees, dtype=float))
        half = (self.pole - self.equator) / 2
        return (self.pole + self.equator) / 2 + half * np.cos(twice), abs(half) * np.sin(twice)


def onset_ratio(friction_angle: float) -> float:
    """Stress ratio at which the first contacts of an isotropic packing slide.

    Parameters
    ----------
    friction_angle : float
        Between grains [degrees], 0 to 90.

    Returns
    -------
    float
        tan(45 deg + phi/2)^2 [-].

    Notes
    -----
    Accuracy: a few units in the last place. Source: 4 a c mu^2 = (c - a)^2 with a : c = sigma11 : sigma33.

    Examples
    --------
    >>> round(onset_ratio(12.0), 4)
    1.525
    """
    return math.tan(math.radians(45 + friction_angle / 2)) ** 2


@house_style
def mohr() -> Figure:
    """Draw three circles against one line of friction, and the sphere of contact normals of each.

    Returns
    -------
    matplotlib.figure.Figure
        Circles above: sticking, at the onset, and partly sliding; below them three spheres.

    Notes
    -----
    Source: eqs (21) and (23).
    """
    import numpy as np

    friction = math.tan(math.radians(FRICTION_ANGLE))
    sticking, onset, sliding = (Circle.of(ratio, friction)
                                for ratio in (STICKING, onset_ratio(FRICTION_ANGLE), SLIDING))
    first = 45 + FRICTION_ANGLE / 2

    figure = blank(height=4.15, layout=None)
    axes = figure.add_axes((0.095, 0.6, 0.895, 0.37))
    line = np.array([0.0, 2.0])
    axes.plot(line, friction * line, color=INK, linewidth=1.3)
    even = np.linspace(0.0, 90.0, 181)
    shown = ((sticking, STICKING, "all stick", SOFT_INK, (1.045, 0.05)),
             (onset, onset_ratio(FRICTION_ANGLE), "onset", BLUE, (1.385, 0.09)),
             (sliding, SLIDING, "some slide", VERMILION, (1.52, 0.13)))
    for circle, ratio, _, colour, (right, up) in shown:
        axes.plot(*circle.at(even), color=SKY if circle is sliding else colour)
        axes.text(right, up, f"{ratio:.4g}", color=readable(colour), ha="center", va="center")
    low, high = _between(sliding)
    axes.plot(*sliding.at(np.linspace(low, high, 121)), color=VERMILION, linewidth=2.8)
    for circle, degrees, text, to in (
            (onset, first, f"$\\beta^* = 45° + \\varphi/2 = {first:g}°$", (0.77, 0.36)),
            (sliding, low, f"$\\beta = {low:.1f}°$", (1.46, 0.24)),
            (sliding, high, f"$\\beta = {high:.1f}°$", (0.65, 0.215))):
        normal, shear = (float(part) for part in circle.at(degrees))
        axes.plot(normal, shear, marker="o", markersize=4.5, color=INK, zorder=4)
        axes.plot([normal, to[0]], [shear, to[1]], color=SOFT_INK, linewidth=0.8, zorder=1)
        side = "left" if to[0] > normal else "right"
        axes.annotate(text, to, xytext=(3 if side == "left" else -3, 0), textcoords="offset points", ha=side,
                      va="center")
    for end, text, side in ((0.735, "$\\beta = 90°$", "right"), (1.515, "$\\beta = 0°$", "left")):
        axes.text(end, 0.035, text, ha=side, va="center")
    axes.text(1.56, 0.39, "$f_r = \\mu f_n$", ha="center", va="center")
    axes.set(aspect="equal", xlim=(0, 1.75), ylim=(0, 0.45), xlabel="normal force $f_n$ [–]",
             ylabel="shear force $f_r$ [–]")

    for place, (circle, ratio, words, colour, _) in enumerate(shown):
        space = figure.add_axes((0.02 + 0.33 * place, 0.06, 0.3, 0.4), projection="3d")
        _draw_sphere(space, circle.limits.sliding or ((first, first) if circle is onset else None))
        space.set_title(f"$\\sigma_{{33}}/\\sigma_{{11}} = {ratio:.4g}$: {words}", y=-0.12, color=readable(colour))
    return figure


def _between(circle: Circle) -> tuple[float, float]:
    if circle.limits.sliding is None:
        raise ValueError("every contact of this circle sticks")
    return circle.limits.sliding


def _draw_sphere(axes: Any, sliding: tuple[float, float] | None) -> None:
    """Draw the sphere of contact normals, the directions that slide in another colour; one cone when just one does."""
    import numpy as np
    from matplotlib.colors import to_rgba

    low, high = sliding or (0.0, 0.0)
    if sliding and high - low < CONE:
        low, high = low - CONE / 2, high + CONE / 2
    quarter = np.unique(np.concatenate([np.linspace(0.0, 90.0, 46), [low, high]]))
    beta = np.radians(np.concatenate([quarter, 180.0 - quarter[-2::-1]]))[:, None]
    around = np.linspace(0.0, 2 * np.pi, 73)[None, :]
    ones = np.ones_like(beta * around)
    shown = Surface(np.sin(beta) * np.cos(around), np.sin(beta) * np.sin(around), np.cos(beta) * ones, ones)
    middle = np.degrees((beta[1:, 0] + beta[:-1, 0]) / 2)
    slides = (np.minimum(middle, 180.0 - middle) > low) & (np.minimum(middle, 180.0 - middle) < high)
    faces = np.where(slides[:, None, None], to_rgba(VERMILION), to_rgba("#dfe6ec"))
    draw_faces(axes, shown, np.repeat(faces, around.size - 1, axis=1), reach=1.0, zoom=1.35)
