"""A tilted fabric under a vertical stress: stiffness over all directions, and how far it is from each class."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from granular.figures.hemisphere import MERIDIANS, frame_map, half_sphere, on_half_sphere, projected
from granular.figures.look import BLUE, INK, MAP, VERMILION, blank, house_style, readable

if TYPE_CHECKING:
    import numpy as np
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from granular.general import GeneralFabric, GeneralLoading
    from granular.general.symmetry import Symmetry

    Array = NDArray[np.float64]

SHOWN = 1e-5
"""Accuracy of the stiffness behind a curve [-]: finer than a line is wide."""

TILTS = tuple(7.5 * step for step in range(13))
"""Angles between fabric and stress [degrees]."""

NO_SHEAR = 0.02
"""The edge of sliding is drawn where k_r/k_n falls below this [-]: a cube root, so 1e-5 of the force from the edge."""

NAMED_AT = 135
"""Meridian on which the region of sliding is named [degrees]."""


def tilted(D33: float, degrees: float) -> GeneralFabric:
    """A fabric about an axis in the plane of axes 1 and 3.

    Parameters
    ----------
    D33 : float
        P2 coefficient of the contact normals about that axis [-].
    degrees : float
        Angle of the axis from axis 3, towards axis 1 [degrees].

    Returns
    -------
    GeneralFabric
        In the frame of the stress.

    Notes
    -----
    Source: eq. (14).

    Examples
    --------
    >>> round(tilted(0.5, 90.0).D[0][0], 12)
    0.5
    """
    import math

    from granular.fabric_tensors.sampling import axial_tensors
    from granular.general import GeneralFabric

    turn = math.radians(degrees)
    one, two, three = axial_tensors(D33, axis=(math.sin(turn), 0.0, math.cos(turn))).D2.tolist()
    return GeneralFabric((tuple(one), tuple(two), tuple(three)))


def by_tilt(D33: float, loading: GeneralLoading, *, poisson_ratio: float) -> tuple[Symmetry, ...]:
    """Distances to the classes of symmetry for every angle between fabric and stress.

    Parameters
    ----------
    D33 : float
        P2 coefficient about the axis of the fabric [-].
    loading : GeneralLoading
        Stress and friction.
    poisson_ratio : float
        Poisson's ratio of the grain material [-].

    Returns
    -------
    tuple of Symmetry
        One for each of ``TILTS``.

    Notes
    -----
    Accuracy: ``SHOWN``. Source: ``granular.general``.
    """
    from granular.general import classify, general_stiffness

    return tuple(classify(general_stiffness(tilted(D33, tilt), poisson_ratio=poisson_ratio, hypothesis="kinematic",
                                            loading=loading, rtol=SHOWN).rows, tolerance=SHOWN) for tilt in TILTS)


@house_style
def tilted_fabric(D33: float, loading: GeneralLoading, symmetries: tuple[Symmetry, ...], *, degrees: float,
                  poisson_ratio: float) -> Figure:
    """Draw the stiffness by direction at one tilt, and the distance to symmetry at all tilts.

    Parameters
    ----------
    D33 : float
        P2 coefficient about the axis of the fabric [-].
    loading : GeneralLoading
        Stress and friction.
    symmetries : tuple of Symmetry
        What ``by_tilt`` gives.
    degrees : float
        Tilt of the fabric in the first panel, towards axis 1 [degrees].
    poisson_ratio : float
        Poisson's ratio of the grain material [-].

    Returns
    -------
    matplotlib.figure.Figure
        An equal-area projection seen along axis 3, with the edge of sliding dashed; two curves.

    Notes
    -----
    Source: ``granular.general``.
    """
    figure = blank(height=3.3, layout=None)
    sphere = figure.add_axes((0.015, 0.03, 0.43, 0.76))
    bar = figure.add_axes((0.455, 0.16, 0.017, 0.5))
    _sphere(sphere, bar, tilted(D33, degrees), loading, degrees, poisson_ratio)
    _distances(figure.add_axes((0.675, 0.175, 0.305, 0.575)), symmetries)
    figure.text(0.23, 0.985, f"stiffness $C_{{nnnn}}$ by direction,\nfabric tilted by {degrees:g}°", ha="center",
                va="top")
    figure.text(0.8, 0.985, "distance of the stiffness\nto each class", ha="center", va="top")
    return figure


def _sphere(axes: Axes, bar: Axes, fabric: GeneralFabric, loading: GeneralLoading, degrees: float,
            poisson_ratio: float) -> None:
    import numpy as np
    from matplotlib.ticker import MaxNLocator

    from granular.general import classify, general_stiffness
    from granular.general.engineering import along
    from granular.general.loading import contact_stiffness

    found = general_stiffness(fabric, poisson_ratio=poisson_ratio, hypothesis="kinematic", loading=loading, rtol=SHOWN)
    across, up = projected(half_sphere())
    shades = axes.contourf(across, up, on_half_sphere(partial(along, found.stiffness())), levels=12, cmap=MAP)
    bar.figure.colorbar(shades, cax=bar, format="%.3g", ticks=MaxNLocator(5)).outline.set_visible(False)
    forces = loading.force_tensor(fabric)

    def sticking(n: Array) -> Array:
        normal, shear, _ = contact_stiffness(forces, loading.friction, n, poisson_ratio)
        return shear - NO_SHEAR * normal

    sticks = on_half_sphere(sticking)
    axes.contour(across, up, sticks, levels=[0.0], colors="white", linestyles="--", linewidths=1.2)
    meridian = NAMED_AT * (MERIDIANS - 1) // 360
    if (sticks[meridian] < 0).any():
        middle = int(np.flatnonzero(sticks[meridian] < 0).mean())
        axes.text(float(across[meridian, middle]), float(up[meridian, middle]), "slide",
                  color="white", ha="center", va="center")
    turn = np.radians(degrees)
    symmetry = classify(found.rows, tolerance=SHOWN)
    for direction, sign, text in (((0.0, 0.0, 1.0), "o", "stress"),
                                  ((np.sin(turn), 0.0, np.cos(turn)), "s", "fabric"),
                                  (symmetry.axis, "D", "nearest axis")):
        x, y = projected(np.array(direction))
        axes.plot(x, y, sign, color="white", markeredgecolor=INK, markersize=6)
        below = text == "nearest axis"
        axes.annotate(text, (x, y), (0, -8 if below else 8), textcoords="offset points", color=INK, fontsize=9,
                      ha="center", va="top" if below else "bottom",
                      bbox={"boxstyle": "round,pad=0.15", "facecolor": "white", "edgecolor": "none", "alpha": 0.75})
    frame_map(axes)


def _distances(axes: Axes, symmetries: tuple[Symmetry, ...]) -> None:
    for values, colour, text, sign in (
            ([100 * one.transversely_isotropic for one in symmetries], BLUE, "transversely\nisotropic", "o"),
            ([100 * one.orthotropic for one in symmetries], VERMILION, "orthotropic", "s")):
        axes.plot(TILTS, values, sign + "-", color=colour, markersize=3.5)
        place = values.index(max(values))
        above = sign == "o"
        axes.annotate(text, (55 if above else 50, values[place] if above else 0.35), (0, 6 if above else 0),
                      textcoords="offset points", color=readable(colour), ha="center", va="bottom")
    axes.set(xlabel="tilt of the fabric [°]", ylabel="distance over the norm [%]", xlim=(0, 90),
             xticks=range(0, 91, 30))
    axes.set_ylim(0, None)
