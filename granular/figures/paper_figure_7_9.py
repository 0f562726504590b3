"""Figures 7, 8 and 9 of the paper: forces and stiffnesses of the contacts by direction, and the numbers behind them."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Literal

from granular.fabric import AxialFabric
from granular.figures.by_direction import angles, by_direction, limits
from granular.figures.contacts import SHADE
from granular.figures.look import BLUE, GREEN, ORANGE, PURPLE, SOFT_INK, VERMILION, blank, house_style, readable
from granular.loading import Loading

if TYPE_CHECKING:
    import numpy as np
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from granular.figures.by_direction import ByDirection

    Array = NDArray[np.float64]

Number = Literal[7, 8, 9]
Line = str | tuple[int, tuple[float, ...]]

POISSON_RATIO, FRICTION = 0.21, math.tan(math.radians(12))
"""Of the grains in the parametric study [-]."""

PANELS = {"normal": ("f_n", "(a) normal force"), "shear": ("f_r", "(b) shear force"),
          "k_normal": ("k_n", "(c) normal stiffness"), "k_shear": ("k_r", "(d) shear stiffness")}
"""Name of the column and title of each panel."""

SOLID, DASHED, DOTTED, DASH_DOTTED = "-", (0, (4, 2)), (0, (1, 1.5)), (0, (6, 1.5, 1, 1.5))
LONG_DASHED = (0, (9, 2.5))
"""Line styles, so that curves that coincide, or lose their colour in print, are told apart."""


@dataclass(frozen=True, slots=True)
class Case:
    """One assembly of a figure.

    Attributes
    ----------
    key : str
        Its name in the names of columns.
    text : str
        Its name in the figure.
    colour, line : str
        Of its curves.
    fabric : AxialFabric
        Contact normals and branch lengths.
    stress_ratio : float
        sigma33/sigma11 [-].
    slips : bool
        Whether friction lowers the shear stiffness; a case without slip is shown in panel (d) alone.
    """

    key: str
    text: str
    colour: str
    line: Line
    fabric: AxialFabric = field(default_factory=AxialFabric)
    stress_ratio: float = 1.0
    slips: bool = True

    @property
    def loading(self) -> Loading:
        """Stress and friction."""
        return Loading.of_ratio(self.stress_ratio, friction=FRICTION if self.slips else None)

    @property
    def panels(self) -> tuple[str, ...]:
        """Where it is shown."""
        return tuple(PANELS) if self.slips else ("k_shear",)


def _microstructure(D33: float, Dr33: float, colour: str, line: Line) -> Case:
    return Case(f"D33={D33:g} Dr33={Dr33:g}", f"$D_{{33}} = {D33:g}$,  $D^{{r}}_{{33}} = {Dr33:g}$", colour, line,
                AxialFabric(D33=D33, Dr33=Dr33))


CASES: dict[Number, tuple[Case, ...]] = {
    7: (_microstructure(0.0, 0.0, SOFT_INK, DOTTED), _microstructure(0.0, -0.3, BLUE, DASHED),
        _microstructure(0.3, 0.0, GREEN, SOLID), _microstructure(0.3, -0.3, VERMILION, DASH_DOTTED),
        Case("D33=0.3 without slip", "$D_{33} = 0.3$, without slip", PURPLE, LONG_DASHED, AxialFabric(D33=0.3),
             slips=False)),
    8: tuple(Case(f"D33={D33:g}", f"$D_{{33}} = {D33:g}$", colour, line, AxialFabric(D33=D33))
             for D33, colour, line in ((0.0, SOFT_INK, DOTTED), (0.3, BLUE, DASHED), (0.5, VERMILION, SOLID))),
    9: tuple(Case(f"SR={ratio:g}", f"$\\sigma_{{33}}/\\sigma_{{11}} = {ratio:g}$", colour, line, stress_ratio=ratio)
             for ratio, colour, line in ((1.0, SOFT_INK, DOTTED), (1.5, BLUE, DASHED), (2.0, VERMILION, SOLID))),
}
"""Assemblies of each figure."""


def data(number: Number) -> dict[str, Array]:
    """Numbers behind a figure, column by column.

    Parameters
    ----------
    number : 7, 8 or 9
        The figure.

    Returns
    -------
    dict of (n,) array
        ``beta`` [degrees], then columns such as ``f_n SR=2`` [-]: forces over that of the isotropic assembly under
        the same mean stress, stiffnesses over k_n,ref.

    Notes
    -----
    Accuracy: that of ``granular.contact_distribution``. Source: Figures 7, 8 and 9.

    Examples
    --------
    >>> columns = data(9)
    >>> float(columns["beta"][0]), float(columns["f_n SR=2"][0])
    (0.0, 1.5)
    """
    beta, found = _evaluate(number)
    columns = {"beta": beta}
    for panel, (name, _) in PANELS.items():
        columns |= {f"{name} {case.key}": getattr(contacts, panel) for case, contacts in found if panel in case.panels}
    return columns


@house_style
def draw(number: Number) -> Figure:
    """Draw one of the three figures.

    Parameters
    ----------
    number : 7, 8 or 9
        The figure.

    Returns
    -------
    matplotlib.figure.Figure
        Panels (a) to (d); directions in which contacts slide are tinted in (d).

    Notes
    -----
    Curves against the angle, where the paper draws them around a circle: a normal stiffness that changes by four
    percent is a circle to the eye. Source: Figures 7, 8 and 9.
    """
    beta, found = _evaluate(number)
    figure = blank(height=5.2)
    panels = dict(zip(PANELS, figure.subplots(2, 2, sharex=True).flat, strict=True))
    for case, contacts in found:
        for panel in case.panels:
            panels[panel].plot(beta, getattr(contacts, panel), color=case.colour, linestyle=case.line,
                               label=case.text)
    for panel, axes in panels.items():
        axes.set_title(PANELS[panel][1], loc="left")
        axes.set(xlim=(0, 90), xticks=range(0, 91, 15), ylabel=f"${PANELS[panel][0]}$ [–]")
        if panel in {"k_normal", "k_shear"}:
            axes.set_xlabel("angle from axis 3, $\\beta$ [°]")
    panels["shear"].set_ylim(bottom=0)
    for case, contacts in found:
        if contacts.limits.sliding:
            _mark_sliding(panels["k_shear"], case, contacts.limits.sliding)
    handles, texts = panels["k_shear"].get_legend_handles_labels()
    figure.legend(handles, texts, loc="outside upper center", ncols=3 if len(texts) <= 3 else 2, frameon=False,
                  handlelength=2.6)
    return figure


def _mark_sliding(axes: Axes, case: Case, sliding: tuple[float, float]) -> None:
    axes.axvspan(*sliding, facecolor=ORANGE, alpha=SHADE, edgecolor="none", zorder=0)
    low, high = sliding
    axes.annotate(f"{low:.1f}° to {high:.1f}°\nslide at ratio {case.stress_ratio:g}", ((low + high) / 2, 0),
                  xytext=(0, 4), textcoords="offset points", ha="center", va="bottom", color=readable(ORANGE))


def _evaluate(number: Number) -> tuple[Array, list[tuple[Case, ByDirection]]]:
    """All assemblies of a figure at the same angles."""
    import numpy as np

    cases = CASES[number]
    beta = np.unique(np.concatenate([angles(limits(case.fabric.D33, case.loading)) for case in cases]))
    return beta, [(case, by_direction(case.fabric, case.loading, poisson_ratio=POISSON_RATIO, degrees=beta))
                  for case in cases]
