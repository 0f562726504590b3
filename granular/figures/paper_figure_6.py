"""Figure 6 of the paper: the six stiffness components against the anisotropy of branch lengths."""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.figures.look import COMPONENT_COLOURS, SOFT_INK, blank, house_style, label_curves, named_with_voigt
from granular.routes.result import COMPONENTS

if TYPE_CHECKING:
    from matplotlib.figure import Figure

FLATTEST = -0.9
"""Dr33 at the end of the figure."""

SCENE = {"grains": {"shear_modulus": "31 GPa", "poisson_ratio": 0.21}, "packing": {"void_ratio": 0.5744},
         "stress": {"mean": "28 kPa"}}
"""Material, packing and stress of the parametric study; its coordination number follows from the void ratio."""


@house_style
def figure_6() -> Figure:
    """Draw the components in MPa with isotropic packing under 28 kPa, kinematic hypothesis.

    Returns
    -------
    matplotlib.figure.Figure
        Six curves; the index pair of the paper stands in brackets.

    Notes
    -----
    The branch lengths change at a fixed equivalent length, so that only Dr33 varies.
    Source: Figure 6.
    """
    import numpy as np

    import granular

    reference = granular.evaluate(granular.Scene.model_validate(SCENE)).reference_stiffness
    anisotropy = np.linspace(0.0, FLATTEST, 91)
    megapascals = granular.axial_stiffness(0.0, anisotropy, kinetic=False) * reference / 1e6

    figure = blank(height=3.6)
    axes = figure.add_subplot()
    for name, curve in zip(COMPONENTS, megapascals.T, strict=True):
        axes.plot(anisotropy, curve, color=COMPONENT_COLOURS[name])
    axes.set(xlim=(0, FLATTEST), ylim=(0, 900), xlabel="branch anisotropy $D^{r}_{33}$ [–]", ylabel="stiffness [MPa]")
    axes.text(-0.03, 850, "in brackets: the paper's Voigt names", va="center", ha="left", color=SOFT_INK)
    label_curves(axes, FLATTEST * 1.015, list(megapascals[-1]), [named_with_voigt(name) for name in COMPONENTS],
                 [COMPONENT_COLOURS[name] for name in COMPONENTS], gap=52)
    return figure
