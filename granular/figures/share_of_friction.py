"""How a contact softens in shear as it uses up its friction, and how much of it contacts use by direction."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from granular.contact_law import stiffness_ratio
from granular.figures.look import BLUE, GREEN, INK, SOFT_INK, VERMILION, blank, house_style, readable
from granular.figures.mohr_circle import FRICTION_ANGLE, onset_ratio

if TYPE_CHECKING:
    from matplotlib.figure import Figure

STRESS_RATIOS = (1.25, onset_ratio(FRICTION_ANGLE), 2.0)
"""Below the onset of sliding, at it, and beyond it [-]."""

COLOURS = (GREEN, BLUE, VERMILION)


@house_style
def share_of_friction(*, poisson_ratio: float = 0.21) -> Figure:
    """Draw the shear stiffness of a contact against its share of friction, and that share against the direction.

    Parameters
    ----------
    poisson_ratio : float
        Of the grain material [-].

    Returns
    -------
    matplotlib.figure.Figure
        Two panels; the share of the right one is the horizontal axis of the left one.

    Notes
    -----
    Source: eqs (21) and (23), isotropic packing.
    """
    import numpy as np

    from granular.contact_distribution import normal_force, shear_force
    from granular.fabric import AxialFabric
    from granular.loading import Loading

    share = 1.0 - np.linspace(1.0, 0.0, 201) ** 3
    kept = np.cbrt(1.0 - share)
    figure = blank(height=3.0)
    left, right = figure.subplots(1, 2)
    left.plot(share, stiffness_ratio(poisson_ratio) * kept, color=INK)
    left.plot([1.0, 1.15], [0.0, 0.0], color=INK)
    half = 0.5 * stiffness_ratio(poisson_ratio)
    left.plot([7 / 8], [half], color=INK, marker="o", markersize=5)
    left.text(0.83, half, "half, at 7/8", ha="right", va="center", color=INK)
    left.set(xlim=(0.0, 1.15), ylim=(0.0, 1.0), xlabel="share of friction $f_r/(\\mu f_n)$ [–]",
             ylabel="$k_r/k_n$ [–]", xticks=[0, 0.25, 0.5, 0.75, 1])
    degrees = np.linspace(0.0, 90.0, 181)
    cosine, packing = np.cos(np.radians(degrees)), AxialFabric()
    friction = math.tan(math.radians(FRICTION_ANGLE))
    for ratio, colour in zip(STRESS_RATIOS, COLOURS, strict=True):
        loading = Loading.of_ratio(ratio, friction=friction)
        used = shear_force(packing, loading, cosine) / (friction * normal_force(packing, loading, cosine))
        right.plot(degrees, used, color=colour)
        top = int(used.argmax())
        words = "stress ratio " if ratio == max(STRESS_RATIOS) else ""
        right.text(degrees[top], used[top] + 0.03, f"{words}{ratio:.4g}", color=readable(colour), ha="center",
                   va="bottom")
    right.axhline(1.0, color=SOFT_INK, linewidth=1.0, linestyle=":", zorder=1)
    right.set(xlim=(0, 90), ylim=(0.0, 2.0), xticks=range(0, 91, 15), xlabel="angle from axis 3, $\\beta$ [°]",
              ylabel="share of friction [–]")
    return figure
