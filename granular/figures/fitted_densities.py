"""Eq. (19) against eq. (17): a lognormal density of branch lengths, and the cube root of a self-convolution."""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.figures.look import BLUE, VERMILION, blank, house_style, readable

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SPREADS = (1.2, 1.5, 2.0)
LEAST = 1e-8
"""Densities below this are not drawn [-]."""

REACH = {1.2: (0.4, 10.0), 1.5: (0.05, 100.0), 2.0: (0.005, 3000.0)}
TICKS = {1.2: (0.5, 1, 2, 5), 1.5: (0.1, 1, 10), 2.0: (0.01, 1, 100)}
"""Branch lengths over the mode of the radius, about where densities are above the least one [-]."""


@house_style
def lengths_by_reading() -> Figure:
    """Draw both densities for three spreads of grain sizes.

    Returns
    -------
    matplotlib.figure.Figure
        Three panels with two logarithmic axes: eq. (17) full, eq. (19) dashed.

    Notes
    -----
    Source: eqs (16), (17), (19).
    """
    import numpy as np
    from matplotlib.ticker import FuncFormatter, NullFormatter, NullLocator

    from granular.gradation import Lognormal, branch_lengths
    from granular.gradation.fitted_lengths import fitted_density

    figure = blank(height=2.9)
    for place, spread in enumerate(SPREADS):
        sizes = Lognormal(2.0, spread)  # so that the mode of the radius is 1
        length = np.geomspace(*REACH[spread], 161)
        axes = figure.add_subplot(1, len(SPREADS), place + 1)
        axes.loglog(length, length * branch_lengths(sizes).density(length), color=BLUE)
        axes.loglog(length, length * fitted_density(sizes, length), color=VERMILION, linestyle=(0, (3, 1.6)))
        axes.set(xlim=REACH[spread], ylim=(LEAST, 5), title=f"$s_r = {spread}$", xticks=TICKS[spread])
        axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
        axes.xaxis.set_minor_formatter(NullFormatter())
        axes.yaxis.set_minor_locator(NullLocator())
        axes.tick_params(axis="y", labelleft=place == 0)
        axes.set_xlabel("$\\ell/r_{50}$ [–]")
        if place == 0:
            axes.set_ylabel("$\\ell\\,g$ [–]")
        if spread == SPREADS[-1]:
            for height, text, colour in ((0.24, "eq. (17)", BLUE), (0.12, "eq. (19)", VERMILION)):
                axes.text(0.46, height, text, transform=axes.transAxes, ha="center", color=readable(colour))
    return figure
