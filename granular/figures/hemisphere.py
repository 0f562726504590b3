"""Maps of the upper half sphere: a function of direction in equal-area projection, seen along axis 3."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

from granular.figures.look import INK, MAP, SOFT_INK

if TYPE_CHECKING:
    import numpy as np
    from matplotlib.axes import Axes
    from matplotlib.contour import QuadContourSet
    from numpy.typing import NDArray

    from granular.general.extremes import Extreme

    Array = NDArray[np.float64]
    Values = Callable[[Array], Array]

Rank = Literal["greatest", "middle", "least"]

SIGNS: dict[Rank, str] = {"greatest": "s", "middle": "^", "least": "o"}
"""Markers of principal directions, as usual for fabrics."""

GLYPHS: dict[Rank, str] = {"greatest": "■", "middle": "▲", "least": "●"}
"""The same in text."""

RINGS, MERIDIANS = 61, 145
"""Points of a map from the centre to its edge and around [-]: 1.5 and 2.5 degrees."""

CONTOURS = 10
"""About as many steps of colour, at round numbers [-]."""

EQUAL = 1e-9
"""Values that differ by less than this, relatively, are drawn, and their directions taken, as equal [-]."""


@dataclass(frozen=True, slots=True)
class Mark:
    """A direction that a map marks.

    Attributes
    ----------
    direction : tuple of 3 float
        Unit vector of either sign [-].
    rank : str
        Whose it is: of the "greatest", "middle" or "least" value.
    """

    direction: tuple[float, float, float]
    rank: Rank


def principal(tensor: Sequence[Sequence[float]] | Array) -> tuple[Mark, ...]:
    """Principal directions of a tensor of rank two, but for those that are not unique.

    Parameters
    ----------
    tensor : (3, 3) array
        Symmetric [any unit].

    Returns
    -------
    tuple of Mark
        Three, or one where two principal values are equal, or none where all are.

    Notes
    -----
    Source: eigenvectors.

    Examples
    --------
    >>> [(mark.rank, mark.direction) for mark in principal([[1, 0, 0], [0, 1, 0], [0, 0, 2]])]
    [('greatest', (0.0, 0.0, 1.0))]
    """
    import numpy as np

    from granular.general.extremes import signed

    values, vectors = np.linalg.eigh(np.asarray(tensor, dtype=float))
    near = np.diff(values) <= EQUAL * max(float(np.abs(values).max()), 1.0)
    unique = (not near[0], not near.any(), not near[1])
    ranks: tuple[Rank, Rank, Rank] = ("least", "middle", "greatest")
    return tuple(Mark(signed(vectors[:, place]), rank)
                 for place, rank in reversed(list(enumerate(ranks))) if unique[place])


def extreme_marks(extreme: Extreme, rank: Rank) -> tuple[Mark, ...]:
    """Mark where an extreme value is taken, its images by symmetry too.

    Parameters
    ----------
    extreme : Extreme
        What was found.
    rank : str
        "greatest" or "least".

    Returns
    -------
    tuple of Mark
        None where the value is taken all along a ring, which the colours show.

    Notes
    -----
    Source: ``granular.general.extremes``.
    """
    from granular.general.extremes import MANY

    directions = () if len(extreme.ties) >= MANY else (extreme.direction, *extreme.ties)
    return tuple(Mark(direction, rank) for direction in directions)


def projected(directions: Array) -> tuple[Array, Array]:
    """Equal-area projection of the half sphere above axis 3 on the unit disc.

    Parameters
    ----------
    directions : (3, ...) array
        Unit vectors with n_3 >= 0 [-].

    Returns
    -------
    x, y : (...) array
        Along axis 1 and axis 2 [-]; the edge of the half sphere is the unit circle.

    Notes
    -----
    Source: Lambert's azimuthal projection, Schmidt's net.

    Examples
    --------
    >>> import numpy as np
    >>> [float(value) for value in projected(np.array([1.0, 0.0, 0.0]))]
    [1.0, 0.0]
    """
    import numpy as np

    stretch = 1 / np.sqrt(1 + np.abs(directions[2]))
    return directions[0] * stretch, directions[1] * stretch


def half_sphere() -> Array:
    """Directions of a map, ring by ring along each meridian.

    Returns
    -------
    (3, MERIDIANS, RINGS) array
        Unit vectors with n_3 >= 0 [-].

    Notes
    -----
    Source: spherical coordinates.

    Examples
    --------
    >>> half_sphere().shape
    (3, 145, 61)
    """
    import numpy as np

    beta, azimuth = np.meshgrid(np.linspace(0, np.pi / 2, RINGS), np.linspace(0, 2 * np.pi, MERIDIANS))
    return np.stack([np.sin(beta) * np.cos(azimuth), np.sin(beta) * np.sin(azimuth), np.cos(beta)])


def on_half_sphere(values: Values) -> Array:
    """A function of direction at the points of a map.

    Parameters
    ----------
    values : callable
        Takes unit vectors (3, q) [-], gives (q,) values [any unit].

    Returns
    -------
    (MERIDIANS, RINGS) array
        The values [same unit].

    Notes
    -----
    Source: ``half_sphere``.
    """
    shown: Array = values(half_sphere().reshape(3, -1)).reshape(MERIDIANS, RINGS)
    return shown


def draw_map(axes: Axes, values: Values) -> QuadContourSet:
    """Draw a function of direction as steps of colour at round numbers, with the frame and the axes.

    Parameters
    ----------
    axes : Axes
        Empty.
    values : callable
        Takes unit vectors (3, q) [-], gives (q,) values [any unit].

    Returns
    -------
    QuadContourSet
        For a colour bar.

    Notes
    -----
    Source: ``projected``.
    """
    import numpy as np
    from matplotlib.ticker import MaxNLocator

    shown = on_half_sphere(values)
    low, high = float(shown.min()), float(shown.max())
    if high - low <= EQUAL * max(abs(high), abs(low)):
        room = 0.01 * abs(high) or 1.0
        shown = np.full_like(shown, high)
        low, high = high - room, high + room
    levels = MaxNLocator(CONTOURS).tick_values(low, high)
    shades = axes.contourf(*projected(half_sphere()), shown, levels=levels, cmap=MAP)
    shades.set_edgecolor("face")  # or white seams show between the steps
    axes.plot(0, 0, "+", color="white", markersize=6, markeredgewidth=0.9)
    frame_map(axes)
    return shades


def frame_map(axes: Axes) -> None:
    """Draw the edge of a map with the names of axes 1 and 2, at equal scales.

    Parameters
    ----------
    axes : Axes
        Holds a map.

    Notes
    -----
    Source: the look of this package.
    """
    import numpy as np

    turn = np.linspace(0, 2 * np.pi, 361)
    axes.plot(np.cos(turn), np.sin(turn), color=INK, linewidth=0.8)
    for right, top, name in ((1.08, 0.0, "1"), (0.0, 1.06, "2")):
        axes.text(right, top, name, ha="left" if right else "center", va="center" if right else "bottom")
    axes.set(aspect="equal", xlim=(-1.05, 1.19), ylim=(-1.05, 1.19))
    axes.axis("off")


def draw_marks(axes: Axes, marks: Sequence[Mark]) -> None:
    """Mark directions on a map; one in the plane of axes 1 and 2 has two ends.

    Parameters
    ----------
    axes : Axes
        Holds a map.
    marks : sequence of Mark
        What to mark.

    Notes
    -----
    Source: ``projected``.
    """
    import numpy as np

    for mark in marks:
        n = np.array(mark.direction)
        ends = [n, -n] if abs(n[2]) < 1e-6 else [n if n[2] > 0 else -n]
        for end in ends:
            axes.plot(*projected(end), SIGNS[mark.rank], color="white", markeredgecolor=INK, markersize=6,
                      clip_on=False, zorder=5)


def draw_edge(axes: Axes, margin: Values) -> bool:
    """Draw dashed where contacts begin to slide.

    Parameters
    ----------
    axes : Axes
        Holds a map.
    margin : callable
        Takes unit vectors (3, q) [-], gives (q,) values that are negative where contacts slide [any unit].

    Returns
    -------
    bool
        Whether there is an edge.

    Notes
    -----
    Source: eq. (21).
    """
    shown = on_half_sphere(margin)
    if not shown.min() < 0 < shown.max():
        return False
    axes.contour(*projected(half_sphere()), shown, levels=[0.0], colors="white", linestyles="--", linewidths=1.2)
    return True


def hatch_opened(axes: Axes, force: Values) -> bool:
    """Hatch where contacts have opened.

    Parameters
    ----------
    axes : Axes
        Holds a map.
    force : callable
        Takes unit vectors (3, q) [-], gives (q,) normal forces [any unit].

    Returns
    -------
    bool
        Whether some have.

    Notes
    -----
    Source: contacts carry no tension.
    """
    shown = on_half_sphere(force)
    if not shown.min() < 0:
        return False
    hatched = axes.contourf(*projected(half_sphere()), shown, levels=[float(shown.min()) - 1.0, 0.0], colors="none",
                            hatches=["////"])
    hatched.set_edgecolor(SOFT_INK)
    hatched.set_linewidth(0.0)
    return True
