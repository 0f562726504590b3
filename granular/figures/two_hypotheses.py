"""The kinematic hypothesis against the static one: how far apart the two estimates of the stiffness are."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

from granular.figures.look import (
    COMPONENT_COLOURS,
    SOFT_INK,
    blank,
    house_style,
    label_curves,
    named,
)
from granular.routes.result import COMPONENTS

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SHOWN = ("C1111", "C3333", "C2323", "C1212")
"""C1122 and C1133 are too small beside these to be read."""


@house_style
def hypotheses(against: Literal["Dr33", "D33"] = "Dr33", *, poisson_ratio: float = 0.21) -> Figure:
    """Draw four normalised components by both hypotheses against one coefficient, the other one being zero.

    Parameters
    ----------
    against : "Dr33" or "D33"
        Coefficient along the horizontal axis: of the branch lengths or of the contact normals.
    poisson_ratio : float
        Of the grain material [-].

    Returns
    -------
    matplotlib.figure.Figure
        Full lines kinematic, dashed static.

    Notes
    -----
    Source: Figure 1, upper bound and lower estimate.
    """
    import numpy as np

    import granular

    reach, title = {"Dr33": ((-0.9, 0.9), "branch anisotropy $D^{r}_{33}$ [–]"),
                    "D33": ((-1.0, 2.0), "contact-normal anisotropy $D_{33}$ [–]")}[against]
    coefficient = np.linspace(*reach, 121)
    normals, branches = (coefficient, 0.0) if against == "D33" else (0.0, coefficient)
    upper, lower = (granular.axial_stiffness(normals, branches, poisson_ratio=poisson_ratio, kinetic=False,
                                             hypothesis=name) for name in ("kinematic", "static"))

    figure = blank(height=3.4)
    axes = figure.add_subplot()
    for name in SHOWN:
        column = COMPONENTS.index(name)
        axes.plot(coefficient, upper[:, column], color=COMPONENT_COLOURS[name])
        axes.plot(coefficient, lower[:, column], color=COMPONENT_COLOURS[name], linestyle=(0, (3, 1.6)))
    top = 1.06 * float(upper[:, [COMPONENTS.index(name) for name in SHOWN]].max())
    axes.set(xlim=reach, ylim=(0, top), xlabel=title,
             ylabel="stiffness over $(M/V)\\,\\ell_e^2\\,k_n$ [–]")
    label_curves(axes, reach[1] + 0.02 * (reach[1] - reach[0]),
                 [float(upper[-1, COMPONENTS.index(name)]) for name in SHOWN], [named(name) for name in SHOWN],
                 [COMPONENT_COLOURS[name] for name in SHOWN], gap=0.07 * top)
    for label, style in (("kinematic", "-"), ("static", (0, (3, 1.6)))):
        axes.plot([], [], color=SOFT_INK, linestyle=style, label=label)
    axes.legend(frameon=False, loc="upper center", ncols=2)
    return figure
