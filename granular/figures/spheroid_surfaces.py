"""The weights of Figure 5 beside the true branches of spheroids with the same lengths at pole and equator."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from granular.collinear import deviation_angle, shape_of_weight
from granular.directions import branch_weight
from granular.fabric import AxialFabric
from granular.figures.look import MAP, blank, house_style
from granular.figures.paper_figure_5 import BRANCHES
from granular.figures.surfaces import IN_PRINT, draw_faces, surface

if TYPE_CHECKING:
    import numpy as np
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

REACH = 1.3
"""Half the side of each cube, in lengths at the equator [-]."""


@house_style
def branch_surfaces() -> Figure:
    """Draw lengths of branches over the contact normals, coloured by the angle between the two.

    Returns
    -------
    matplotlib.figure.Figure
        Four weights above, four spheroids below, all over their length at the equator.

    Notes
    -----
    Source: Figure 5 (a) to (d), and l = 2 M^2 n/\\|M n\\|.
    """
    import matplotlib as mpl
    import numpy as np
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import Normalize

    # light where branches do not deviate, so that the shape can be seen
    colours = ScalarMappable(Normalize(0, 90), mpl.colormaps[f"{MAP}_r"])
    beta = np.linspace(0.0, np.pi, IN_PRINT[0])
    middle = np.cos((beta[:-1] + beta[1:]) / 2)
    figure = blank(height=4.4, layout=None)
    width = 1 / len(BRANCHES)
    for place, Dr33 in enumerate(BRANCHES):
        shape = shape_of_weight(Dr33)
        weight, true = (partial(branch_weight, fabric)
                        for fabric in (AxialFabric(Dr33=Dr33), AxialFabric(aspect_ratio=shape)))
        for row, (radius, angle, title) in enumerate((
                (weight, 0.0 * middle, f"$D^{{r}}_{{33}} = {Dr33:g}$"),
                (true, deviation_angle(shape, middle), f"$b/a = {shape:.3g}$"))):
            axes = figure.add_axes((place * width, 0.6 - 0.44 * row, width, 0.33), projection="3d")
            shown = surface(partial(_over_equator, radius), IN_PRINT)
            faces = colours.to_rgba(np.broadcast_to(angle[:, None], (IN_PRINT[0] - 1, IN_PRINT[1] - 1)))
            draw_faces(axes, shown, np.asarray(faces), reach=REACH, zoom=1.45)
            axes.set_title(title, y=-0.06)
    for height, text in ((0.99, "weight $W$ of Figure 5, laid along the normal"),
                         (0.55, "true length of the branches of spheroids, over the normal")):
        figure.text(0.5, height, text, ha="center", va="top")
    figure.colorbar(colours, cax=figure.add_axes((0.2, 0.1, 0.6, 0.022)), orientation="horizontal",
                    ticks=range(0, 91, 15), label="angle between branch and normal [°]")
    return figure


def _over_equator(radius: partial[Array], cosine: Array) -> Array:
    found: Array = radius(cosine) / float(radius(0.0))
    return found
