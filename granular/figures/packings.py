"""Packings of known stiffness: how far sums, model and partly relaxed packings lie above the relaxed stiffness."""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.contacts.comparison import FROM_LIST, FROM_SCENE, KINEMATIC, STATIC
from granular.figures.look import BLUE, GREEN, ORANGE, SKY, SOFT_INK, VERMILION, blank, house_style, named
from granular.hypothesis import Hypothesis

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from granular.contacts.comparison import ComparedPacking

COMPONENTS = ("C3333", "C2323")
"""Compression and shear; what the others show is in the table."""

MARKS = {
    KINEMATIC: ("o", BLUE, "eq. (1)"), STATIC: ("D", VERMILION, "eq. (5)"),
    FROM_LIST[Hypothesis.KINEMATIC]: ("x", SKY, "model, mean $k_n$"),
    FROM_SCENE[Hypothesis.KINEMATIC]: ("+", GREEN, "model alone"),
    "rotations only": ("^", ORANGE, "spins relaxed only"),
}
"""Marker, colour and name of each; the affine probe is left out, for it lies on eq. (1)."""


@house_style
def packings_figure(packings: Sequence[ComparedPacking]) -> Figure:
    """Draw everything over the relaxed stiffness, one line a packing.

    Parameters
    ----------
    packings : sequence of ComparedPacking
        Compared packings.

    Returns
    -------
    matplotlib.figure.Figure
        Two panels, one for compression and one for shear along axis 3.

    Notes
    -----
    Source: eqs (1) and (5), and probes of the packings.
    """
    figure = blank(height=0.9 + 0.36 * len(packings))
    panels = figure.subplots(1, len(COMPONENTS), sharey=True)
    for axes, component in zip(panels, COMPONENTS, strict=True):
        _draw(axes, packings, component)
    panels[0].set_yticks(range(len(packings)), [packing.name for packing in packings])
    panels[0].invert_yaxis()
    handles, names = panels[0].get_legend_handles_labels()
    figure.legend(handles, names, loc="outside upper center", ncols=len(MARKS), frameon=False, fontsize=9,
                  handletextpad=0.2, columnspacing=0.7)
    return figure


def _draw(axes: Axes, packings: Sequence[ComparedPacking], component: str) -> None:
    axes.axvline(1.0, color=SOFT_INK, linewidth=1.2)
    for key, (marker, colour, name) in MARKS.items():
        places, ratios = [], []
        for place, packing in enumerate(packings):
            value, relaxed = (_of(packing, one).get(component) for one in (key, "relaxed"))
            if value is not None and relaxed is not None:
                places.append(place)
                ratios.append(value / relaxed)
        axes.plot(ratios, places, linestyle="none", marker=marker, color=colour, markersize=6, label=name,
                  markerfacecolor="none", markeredgewidth=1.4)
    axes.set(xlabel=f"{named(component)} over the relaxed one [–]", ylim=(-0.5, len(packings) - 0.5))


def _of(packing: ComparedPacking, key: str) -> dict[str, float | None]:
    """One row of a packing; where branches deviate, the model's row of the fabric of normals."""
    return packing.stiffness.get(key) or packing.stiffness.get(f"{key}, fabric of normals") or {}
