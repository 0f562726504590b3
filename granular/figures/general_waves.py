"""Plane waves in an assembly without an axis: maps of qP and of shear-wave splitting, and speeds in three planes."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from granular.figures.hemisphere import extreme_marks, projected
from granular.figures.look import BLUE, GREEN, INK, VERMILION, WIDTH, blank, house_style, key_of
from granular.figures.over_sphere import MAPS, PLANES, Map, Picture, Quantity, draw_maps, line_of

if TYPE_CHECKING:
    import numpy as np
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from granular.general import GeneralWaves

    Array = NDArray[np.float64]

HEIGHT = 6.1
"""Of the figure [in]."""

BARS = 90
"""Polarisations that a map shows [-]."""

BAR = 0.055
"""Half the length of one of them [-], in radii of the sphere."""

SPLIT = 1e-4
"""Splitting below this shows no polarisation [-]: any would do."""

ROUNDING = 1e-12
"""Splitting below this is drawn as none [-]."""

WAVES = (("qP", 0, BLUE, "-"), ("qS1", 1, VERMILION, "-"), ("qS2", 2, GREEN, "--"))
"""Name, place among the speeds, colour and line."""


def waves_picture(waves: GeneralWaves) -> Picture:
    """Speeds of the three waves and the splitting of shear waves by direction.

    Parameters
    ----------
    waves : GeneralWaves
        Speeds of the assembly.

    Returns
    -------
    Picture
        Maps of qP and of splitting with their extremes; surfaces of all four.

    Notes
    -----
    Source: the Christoffel equation.
    """
    fast, slow, split = waves.fastest_qP, waves.slowest_qP, waves.largest_splitting
    anisotropic = fast.value - slow.value > SPLIT * fast.value
    of_speed = (*extreme_marks(fast, "greatest"), *extreme_marks(slow, "least")) if anisotropic else ()
    of_splitting = extreme_marks(split, "greatest") if split.value > SPLIT else ()
    qP, qS1, qS2 = (Quantity(f"phase speed of {name}", name, name, "m/s", partial(_speed, waves, place), colour, line)
                    for name, place, colour, line in WAVES)
    splitting = Quantity("splitting of shear waves", "$2\\,$(qS1 $-$ qS2)$\\,/\\,$(qS1 $+$ qS2)", "splitting", "%",
                         partial(splitting_of, waves), INK)
    meaning = "value over all directions"
    maps = Map(qP, of_speed, meaning), Map(splitting, of_splitting, meaning)
    return Picture(maps, ((qP, qS1, qS2),), turned=(maps[0], Map(qS1), Map(qS2), maps[1]),
                   note="bars: polarisation of qS1")


def _speed(waves: GeneralWaves, place: int, directions: Array) -> Array:
    return waves.at(directions.T).speeds[:, place]


def splitting_of(waves: GeneralWaves, directions: Array) -> Array:
    """Difference of the speeds of qS1 and qS2 over their mean.

    Parameters
    ----------
    waves : GeneralWaves
        Speeds of the assembly.
    directions : (3, q) array
        Unit vectors [-].

    Returns
    -------
    (q,) array
        2 (qS1 - qS2)/(qS1 + qS2) [%].

    Notes
    -----
    Accuracy: rounding of the speeds over their mean; less than ``ROUNDING`` is zero. Source: the usual measure of
    splitting.
    """
    import numpy as np

    _, one, two = waves.at(directions.T).speeds.T
    split = 200 * (one - two) / (one + two)
    return np.where(split < 100 * ROUNDING, 0.0, split)


@house_style
def general_waves_figure(waves: GeneralWaves) -> Figure:
    """Draw both maps, and the speeds in the three coordinate planes on one scale of metres per second.

    Parameters
    ----------
    waves : GeneralWaves
        Speeds of the assembly.

    Returns
    -------
    matplotlib.figure.Figure
        Two maps, and six panels of curves: qP above, qS1 and qS2 below.

    Notes
    -----
    Source: the Christoffel equation.
    """
    import numpy as np

    figure = blank(height=HEIGHT, layout=None)
    _, split = draw_maps(figure, waves_picture(waves))
    _bars(split, waves)
    key_of(figure, [(name, line_of(colour, line)) for name, _, colour, line in WAVES],
           height=1 - (MAPS + 0.03) / HEIGHT)
    degrees = np.linspace(0.0, 180.0, 181)
    planes = [waves.at(np.outer(np.cos(np.radians(degrees)), np.eye(3)[first])
                       + np.outer(np.sin(np.radians(degrees)), np.eye(3)[second])).speeds for first, second in PLANES]
    rows = (WAVES[:1], WAVES[1:])
    parts = [np.concatenate([plane[:, [place for _, place, _, _ in row]] for plane in planes]) for row in rows]
    ends = [(float(part.min()), float(part.max())) for part in parts]
    span = 1.25 * max(max(high - low, 0.02 * high) for low, high in ends)
    for row, (shown, (low, high)) in enumerate(zip(rows, ends, strict=True)):
        bottom = max(0.0, (low + high - span) / 2)  # no speed is negative, however wide the span
        for column, ((first, second), plane) in enumerate(zip(PLANES, planes, strict=True)):
            axes = figure.add_axes(((0.6 + 1.78 * column) / WIDTH, (1.47 - 0.98 * row) / HEIGHT, 1.5 / WIDTH,
                                    0.86 / HEIGHT))
            for _, place, colour, line in shown:
                axes.plot(degrees, plane[:, place], **line_of(colour, line))
            axes.set(xlim=(0, 180), xticks=(0, 45, 90, 135, 180), ylim=(bottom, bottom + span))
            axes.tick_params(labelleft=column == 0, labelbottom=row == 1)
            if row == 1:
                axes.set_xlabel(f"from axis {first + 1} to {second + 1} [°]")
            if column == 0:
                axes.set_ylabel("speed [m/s]")
    figure.align_ylabels()
    return figure


def _bars(axes: Axes, waves: GeneralWaves) -> None:
    """Polarisation of the faster shear wave as short lines, as they are seen along axis 3."""
    import numpy as np

    from granular.general.fabric import spread_directions

    n = spread_directions(BARS)
    found = waves.at(n.T)
    a = found.polarisations[:, 1].T
    across = BAR * (a - (a * n).sum(axis=0) * n)
    ends = np.stack([n - across, n + across])
    ends /= np.linalg.norm(ends, axis=1)[:, None]
    ends[:, 2] = np.maximum(ends[:, 2], 0.0)
    x, y = projected(np.swapaxes(ends, 0, 1))
    shown = splitting_of(waves, n) > 100 * SPLIT
    axes.plot(x[:, shown], y[:, shown], color="white", linewidth=0.9, alpha=0.9)
