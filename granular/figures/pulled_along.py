"""Young's modulus against the direction of the pull, for the assemblies of Table II."""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.figures.look import BLUE, GREEN, SOFT_INK, VERMILION, blank, house_style, label_curves

if TYPE_CHECKING:
    from matplotlib.figure import Figure

ASSEMBLIES = ((1, 0.0, -0.3, VERMILION), (2, 0.3, 0.0, BLUE), (3, 0.3, -0.3, GREEN))
"""Case of Table II, D33, Dr33 and colour."""


@house_style
def pulled_along(*, poisson_ratio: float = 0.21) -> Figure:
    """Draw Young's modulus of the three cases of Table II over that of the isotropic assembly.

    Parameters
    ----------
    poisson_ratio : float
        Of the grain material [-].

    Returns
    -------
    matplotlib.figure.Figure
        One panel over the angle of the pull from axis 3.

    Notes
    -----
    Source: 1/E = S_ijkl n_i n_j n_k n_l of eq. (7).
    """
    import granular
    from granular.elasticity import Stiffness
    from granular.engineering import young_modulus

    def modulus(normals: float, branches: float, degrees: float) -> float:
        six = granular.axial_stiffness(normals, branches, poisson_ratio=poisson_ratio, kinetic=False)
        return young_modulus(Stiffness.transversely_isotropic(*six.tolist()), degrees=degrees)

    angles = range(0, 91, 2)
    isotropic = modulus(0.0, 0.0, 0.0)
    figure = blank(height=3.2)
    axes = figure.add_subplot()
    ends = []
    for _, normals, branches, colour in ASSEMBLIES:
        curve = [modulus(normals, branches, float(degrees)) / isotropic for degrees in angles]
        axes.plot(angles, curve, color=colour)
        ends.append(curve[-1])
    axes.axhline(1.0, color=SOFT_INK, linewidth=1.2, linestyle=":", zorder=1)
    axes.set(xlim=(0, 90), xticks=range(0, 91, 15), xlabel="angle of the pull from axis 3 [°]",
             ylabel="$E$ over isotropic [–]")
    low, high = axes.get_ylim()
    label_curves(axes, 91.5, [*ends, 1.0], [*(f"case {case}" for case, *_ in ASSEMBLIES), "isotropic"],
                 [*(colour for *_, colour in ASSEMBLIES), SOFT_INK], gap=0.075 * (high - low))
    return figure
