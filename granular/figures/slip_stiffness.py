"""Shear stiffness of the assembly through the onset of sliding, where its slope is infinite."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from granular.figures.look import COMPONENT_COLOURS, INK, SOFT_INK, blank, house_style, label_curves, named
from granular.figures.mohr_circle import FRICTION_ANGLE, onset_ratio
from granular.routes.result import COMPONENTS

if TYPE_CHECKING:
    import numpy as np
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

SHOWN = ("C2323", "C1212")

FIRST, LAST = 1.0, 2.5
"""Ends of the axis of stress ratios [-]."""

STEEPEST = -1.2
"""Lower end of the axis of slopes [-]; they go on below it."""


def slip_data() -> dict[str, Array]:
    """Numbers behind the figure, column by column.

    Returns
    -------
    dict of (n,) array
        ``stress ratio`` [-], then ``C2323`` and ``C1212`` over their value under isotropic stress [-], then the slopes
        ``dC2323`` and ``dC1212`` against the stress ratio [-], nan at the onset itself. Near the onset the points
        come closer, down to 1e-8.

    Notes
    -----
    Accuracy: the stiffness as ``granular.axial_stiffness``; the slope to about 1e-3 of itself, by differences.
    Source: eqs (20)-(23), kinematic hypothesis, isotropic packing.

    Examples
    --------
    >>> columns = slip_data()
    >>> float(columns["C2323"][0])
    1.0
    """
    import numpy as np

    import granular

    friction, onset = math.tan(math.radians(FRICTION_ANGLE)), onset_ratio(FRICTION_ANGLE)
    steps = np.geomspace(1e-8, 1.0, 161)
    ratio = np.concatenate([onset - (onset - FIRST) * steps[::-1], [onset], onset + (LAST - onset) * steps])
    ratio[0] = FIRST
    six = granular.axial_stiffness(0.0, 0.0, ratio, friction, kinetic=True)
    columns = {"stress ratio": ratio}
    columns |= {name: six[:, COMPONENTS.index(name)] / six[0, COMPONENTS.index(name)] for name in SHOWN}
    before, after = slice(None, steps.size), slice(steps.size + 1, None)
    for name in SHOWN:
        slopes = [np.gradient(columns[name][side], ratio[side], edge_order=2) for side in (before, after)]
        columns[f"d{name}"] = np.concatenate([slopes[0], [np.nan], slopes[1]])
    return columns


@house_style
def slip_onset() -> Figure:
    """Draw both shear components above, and their slopes below, against the stress ratio.

    Returns
    -------
    matplotlib.figure.Figure
        Two panels over one axis of stress ratios.

    Notes
    -----
    Source: eqs (20)-(23); the slope grows like the inverse sixth root of the distance from the onset.
    """
    columns, onset = slip_data(), onset_ratio(FRICTION_ANGLE)
    ratio = columns["stress ratio"]
    figure = blank(height=4.4)
    above, below = figure.subplots(2, 1, sharex=True, height_ratios=(1.25, 1))
    for name in SHOWN:
        above.plot(ratio, columns[name], color=COMPONENT_COLOURS[name])
        below.plot(ratio, columns[f"d{name}"], color=COMPONENT_COLOURS[name])
    above.set(xlim=(FIRST, LAST), ylim=(0.3, 1.08), ylabel="stiffness over isotropic [–]")
    below.set(ylim=(STEEPEST, 0), yticks=[-1.2, -0.8, -0.4, 0.0], ylabel="slope [–]",
              xlabel="stress ratio $\\sigma_{33}/\\sigma_{11}$ [–]")
    for axes, gap, key in ((above, 0.06, ""), (below, 0.12, "d")):
        axes.axvline(onset, color=INK, linewidth=1.0, linestyle=":", zorder=1)
        label_curves(axes, LAST + 0.02, [float(columns[key + name][-1]) for name in SHOWN],
                     [named(name) for name in SHOWN], [COMPONENT_COLOURS[name] for name in SHOWN], gap=gap)
    above.text(onset + 0.03, 1.03, f"the first contacts slide at {onset:.4g}", ha="left", va="center", color=INK)
    below.text(onset + 0.07, STEEPEST + 0.08, "infinite slope", ha="left", va="bottom", color=SOFT_INK)
    return figure
