"""Anisotropy of an assembly with contacts of one stiffness against the fabric, over its whole admissible range."""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.figures.look import BLUE, GREEN, SOFT_INK, VERMILION, blank, house_style, named, readable
from granular.routes.result import COMPONENTS

if TYPE_CHECKING:
    from matplotlib.figure import Figure

BRANCHES = (-0.3, 0.0, 0.3)
"""Anisotropies of the branch lengths, one curve each [-]; the first is that of the paper's tables."""

COLOURS = (VERMILION, BLUE, GREEN)

RATIOS = (("C1111", "C3333"), ("C2323", "C1212"))
"""In compression, horizontal over vertical; in shear, on vertical planes over the horizontal one."""


@house_style
def ratios_by_fabric(*, poisson_ratio: float = 0.21) -> Figure:
    """Draw both stiffness ratios against D33 for some Dr33.

    Parameters
    ----------
    poisson_ratio : float
        Of the grain material [-].

    Returns
    -------
    matplotlib.figure.Figure
        Two panels; dots are isotropic assemblies and the ends of the admissible range.

    Notes
    -----
    Source: eq. (7), kinematic hypothesis.
    """
    import numpy as np

    import granular

    normals = np.linspace(-1.0, 2.0, 121)
    figure = blank(height=4.6)
    panels = figure.subplots(2, 1, sharex=True)
    for axes, (above, below) in zip(panels, RATIOS, strict=True):
        ends = []
        for branches, colour in zip(BRANCHES, COLOURS, strict=True):
            six = granular.axial_stiffness(normals, branches, poisson_ratio=poisson_ratio, kinetic=False)
            ratio = six[:, COMPONENTS.index(above)] / six[:, COMPONENTS.index(below)]
            axes.plot(normals, ratio, color=colour)
            axes.plot(normals[[0, -1]], ratio[[0, -1]], color=colour, marker="o", markersize=4, linestyle="none",
                      clip_on=False)
            ends.append(float(ratio[-1]))
        axes.set_yscale("log")
        axes.axhline(1.0, color=SOFT_INK, linewidth=1.0, linestyle=":", zorder=1)
        axes.set(xlim=(-1.0, 2.0), ylabel=f"{named(above)}/{named(below)} [–]")
        ticks, reach = ([0.25, 0.5, 1, 2], (0.22, 3.0)) if above == "C1111" else ([0.75, 1, 1.5, 2], (0.62, 2.7))
        axes.set_ylim(*reach)
        axes.set_yticks(ticks, [f"{tick:g}" for tick in ticks])
        axes.minorticks_off()
        for branches, colour, end in zip(BRANCHES, COLOURS, ends, strict=True):
            axes.text(2.05, end, f"$D^{{r}}_{{33}} = {branches:g}$", color=readable(colour), va="center", ha="left")
    panels[-1].set_xlabel("contact-normal anisotropy $D_{33}$ [–]")
    figure.align_ylabels()
    return figure
