"""Figures 7, 8 and 9 as the paper draws them: each quantity around a circle, axis 3 upright."""

from __future__ import annotations

from typing import TYPE_CHECKING

from granular.figures.look import SOFT_INK, blank, house_style
from granular.figures.paper_figure_7_9 import CASES, PANELS, data
from granular.figures.surfaces import frame_section

if TYPE_CHECKING:
    import numpy as np
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from granular.figures.paper_figure_7_9 import Number

    Array = NDArray[np.float64]


@house_style
def roses(number: Number) -> Figure:
    """Draw forces and stiffnesses of the contacts around a circle.

    Parameters
    ----------
    number : 7, 8 or 9
        The figure.

    Returns
    -------
    matplotlib.figure.Figure
        Panels (a) to (d); the distance from the centre is the value. A thin circle is 1, where the panel reaches it.

    Notes
    -----
    Accuracy: the columns of ``granular.figures.paper_figure_7_9.data``. Source: Figures 7, 8 and 9.
    """
    import numpy as np

    columns = data(number)
    turn = np.linspace(0.0, 2.0 * np.pi, 361)
    figure = blank(height=6.6)
    for axes, (panel, (name, title)) in zip(figure.subplots(2, 2).flat, PANELS.items(), strict=True):
        reach = 0.0
        for case in CASES[number]:
            if panel in case.panels:
                across, upright = around(columns["beta"], columns[f"{name} {case.key}"])
                reach = max(reach, float(np.hypot(across, upright).max()))
                axes.plot(across, upright, color=case.colour, linestyle=case.line, label=case.text)
        if reach >= 1.0:
            axes.plot(np.cos(turn), np.sin(turn), color=SOFT_INK, linewidth=0.7)
        frame_section(axes, 1.08 * reach, across=f"horizontal, ${name}$ [–]", upward=f"axis 3, ${name}$ [–]", ticks=7)
        axes.set_title(title, loc="left")
        handles, texts = axes.get_legend_handles_labels()
    figure.legend(handles, texts, loc="outside upper center", ncols=3 if len(texts) <= 3 else 2, frameon=False,
                  handlelength=2.6)
    return figure


def around(degrees: Array, values: Array) -> tuple[Array, Array]:
    """Carry a function of the angle from axis 3 around the whole circle.

    Parameters
    ----------
    degrees : (n,) array
        Angles from 0 to 90 [degrees], rising.
    values : (n,) array
        The function there [any unit].

    Returns
    -------
    tuple of (4 n - 3,) array
        Across and along axis 3 [same unit], from axis 3 upwards back to it.

    Notes
    -----
    Source: symmetry about axis 3 and of n and -n.

    Examples
    --------
    >>> import numpy as np
    >>> across, upright = around(np.array([0.0, 90.0]), np.array([2.0, 1.0]))
    >>> np.round(upright, 12).tolist()
    [2.0, 0.0, -2.0, -0.0, 2.0]
    """
    import numpy as np

    quarter = np.radians(degrees)
    half = np.concatenate([quarter, np.pi - quarter[-2::-1]])
    angle = np.concatenate([half, 2.0 * np.pi - half[-2::-1]])
    once = np.concatenate([values, values[-2::-1]])
    radius = np.concatenate([once, once[-2::-1]])
    return radius * np.sin(angle), radius * np.cos(angle)
