"""How the six components follow the stress ratio when contacts follow their forces, with slip and without."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from granular.figures.look import COMPONENT_COLOURS, INK, SOFT_INK, blank, house_style, label_curves, named
from granular.figures.mohr_circle import FRICTION_ANGLE, onset_ratio
from granular.routes.result import COMPONENTS

if TYPE_CHECKING:
    from matplotlib.figure import Figure

PANELS = (("C3333", "C1111"), ("C1212", "C2323"), ("C1133", "C1122"))
"""Compression, shear, and the components that couple two axes."""

LAST = 3.0
"""Largest stress ratio shown [-]."""

DASHED = (0, (3, 1.6))


@house_style
def along_stress(*, poisson_ratio: float = 0.21) -> Figure:
    """Draw six components of an isotropic packing against the stress ratio, the mean stress being the same.

    Parameters
    ----------
    poisson_ratio : float
        Of the grain material [-].

    Returns
    -------
    matplotlib.figure.Figure
        Three panels; full lines with slip, dashed ones without, dotted where contacts begin to slide.

    Notes
    -----
    Source: eqs (7) and (20)-(23), kinematic hypothesis.
    """
    import numpy as np

    import granular

    onset = onset_ratio(FRICTION_ANGLE)
    ratio = np.unique(np.concatenate([np.linspace(1.0, LAST, 101), onset + np.geomspace(1e-5, 0.1, 12),
                                      onset - np.geomspace(1e-5, 0.1, 12)]))
    friction = math.tan(math.radians(FRICTION_ANGLE))
    slipping, sticking = (granular.axial_stiffness(0.0, 0.0, ratio, mu, poisson_ratio) for mu in (friction, None))
    figure = blank(height=5.4)
    panels = figure.subplots(3, 1, sharex=True, height_ratios=(1, 1.15, 1))
    for axes, names in zip(panels, PANELS, strict=True):
        ends = []
        for name in names:
            column = COMPONENTS.index(name)
            axes.plot(ratio, slipping[:, column], color=COMPONENT_COLOURS[name])
            axes.plot(ratio, sticking[:, column], color=COMPONENT_COLOURS[name], linestyle=DASHED, linewidth=1.2)
            ends.append(float(slipping[-1, column]))
        both = [COMPONENTS.index(name) for name in names]
        low = float(min(slipping[:, both].min(), sticking[:, both].min()))
        high = float(max(slipping[:, both].max(), sticking[:, both].max()))
        margin = 0.12 * (high - low)
        axes.set(xlim=(1.0, LAST), ylim=(low - margin, high + margin), ylabel="stiffness [–]")
        axes.axvline(onset, color=INK, linewidth=1.0, linestyle=":", zorder=1)
        label_curves(axes, LAST + 0.03, ends, [named(name) for name in names],
                     [COMPONENT_COLOURS[name] for name in names], gap=0.16 * (high - low + 2 * margin))
    for label, style in (("with slip", "-"), ("without", DASHED)):
        panels[1].plot([], [], color=SOFT_INK, linestyle=style, label=label)
    panels[1].legend(frameon=False, loc="lower left")
    panels[2].set_xlabel("stress ratio $\\sigma_{33}/\\sigma_{11}$ [–]")
    panels[0].text(onset + 0.03, panels[0].get_ylim()[1], "contacts slide", va="top", ha="left", color=INK)
    figure.align_ylabels()
    return figure
