"""The greatest value of a function of direction over the whole sphere, and where it is."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

Direction = tuple[float, float, float]

SPREAD = 3000
"""Directions over the half sphere from which the search starts, 2.6 degrees from each other [-]."""

STARTS = 8
"""The highest of them that are followed [-]."""

BETWEEN_STARTS = 0.97
"""Cosine of the least angle between two starts [-], 14 degrees: each hill is climbed once."""

FIRST_STEP, LAST_STEP = 0.05, 1e-13
"""Half the side of the patch that is searched around each start, at first and at last [rad]."""

RISE = 1e-3
"""A rise by a smaller part of the differences within a patch is none [-]: search would stray along a level ridge."""

LEVEL = 1e-14
"""A patch whose heights differ by less than this, relatively, is the top of a round hill [-]."""

STEPS = 120
"""At most as many patches for each start [-]: each shrinks to half unless the best point lies on its edge."""

TIED = 1e-13
"""Heights that differ by less than this, relatively, tie; a coordinate axis goes before other directions then [-]."""

MANY = 6
"""So many ties or more are a ring, or the whole sphere [-]: isolated extremes of a form of degree four are fewer."""

SAME = 1 - 1e-8
"""Cosine above which two directions are the same top [-]."""


@dataclass(frozen=True, slots=True)
class Extreme:
    """An extreme value over all directions.

    Attributes
    ----------
    value : float
        The value [unit of the function].
    direction : tuple of 3 float
        Where it is taken [-], a unit vector whose largest component is positive; a coordinate axis where one of them
        ties with it.
    ties : tuple of Direction
        Other directions found with the same value [-]: its images by symmetry, or ``MANY`` or more of a ring.
    """

    value: float
    direction: Direction
    ties: tuple[Direction, ...] = field(default=(), repr=False)


def greatest(height: Callable[[Array], Array]) -> Extreme:
    """Find the greatest value of an even function of direction.

    Parameters
    ----------
    height : callable
        Takes unit vectors, a (3, q) array [-], gives a (q,) array [any unit] with the same values at n and -n.

    Returns
    -------
    Extreme
        The greatest value and its direction.

    Notes
    -----
    Accuracy: of a continuous function, edges included, the value to about 1e-13 of it on the hill that was climbed, the
    direction to about 1e-7 where the hill is round. Hills narrower than the 2.6 degrees between directions could be
    missed; forms of degree four, and speeds that come from them, have none unless nearly singular. No derivative is
    used: eigenvalues have edges where they cross. Source: repeated refinement of a patch of directions.

    Examples
    --------
    >>> import numpy as np
    >>> greatest(lambda n: 1 + n[1] ** 2)
    Extreme(value=2.0, direction=(0.0, 1.0, 0.0))
    """
    import numpy as np

    from granular.general.fabric import spread_directions

    n = np.concatenate([np.eye(3), spread_directions(SPREAD)], axis=1)
    values = height(n)
    tops, climbed = _climbed(height, n[:, _apart(n, values)])
    best = int(tops.argmax())
    top, where = float(tops[best]), climbed[:, best]
    for axis in range(3):
        if values[axis] >= top - TIED * abs(top):
            top, where = float(values[axis]), n[:, axis]
            break
    places = [where]
    for place in climbed[:, tops >= top - TIED * abs(top)].T:
        if all(abs(place @ other) < SAME for other in places):
            places.append(place)
    return Extreme(top, signed(where), tuple(signed(place) for place in places[1:]))


def signed(vector: Array) -> Direction:
    """Write an axis as a vector, with the sign that makes its largest component positive.

    Parameters
    ----------
    vector : (3,) array
        Not zero [-].

    Returns
    -------
    tuple of 3 float
        The vector or its opposite [-].

    Notes
    -----
    Source: n and -n are the same axis.

    Examples
    --------
    >>> import numpy as np
    >>> signed(np.array([0.6, -0.8, 0.0]))
    (-0.6, 0.8, 0.0)
    """
    sign = -1.0 if vector[abs(vector).argmax()] < 0 else 1.0
    one, two, three = (sign * float(value) + 0.0 for value in vector)
    return one, two, three


def _apart(n: Array, values: Array) -> list[int]:
    """Places of the highest directions, none of which lies near a higher one."""
    import numpy as np

    left, chosen = values.astype(float), list[int]()
    while len(chosen) < STARTS and np.isfinite(left.max()):
        chosen.append(int(left.argmax()))
        left[np.abs(n[:, chosen[-1]] @ n) > BETWEEN_STARTS] = -np.inf
    return chosen


def _climbed(height: Callable[[Array], Array], starts: Array) -> tuple[Array, Array]:
    """Heights (s,) and directions (3, s) that patches around the starts lead to."""
    import numpy as np

    n = starts
    ticks = np.array([0.0, -1.0, -0.5, 0.5, 1.0])  # the centre first: ties stay where they are
    across, along = (grid.ravel() for grid in np.meshgrid(ticks, ticks))
    edge = np.maximum(np.abs(across), np.abs(along)) == 1.0
    step = np.full(n.shape[1], FIRST_STEP)
    for _ in range(STEPS):
        frames = np.linalg.svd(n.T[:, None, :])[2][:, 1:]  # two directions across each, (s, 2, 3)
        tried = n[:, :, None] + step[:, None] * (
            frames[:, 0].T[:, :, None] * across + frames[:, 1].T[:, :, None] * along)
        tried /= np.linalg.norm(tried, axis=0)
        values = height(tried.reshape(3, -1)).reshape(n.shape[1], -1)
        best = values.argmax(axis=1)
        rise, differences = values.max(axis=1) - values[:, 0], np.ptp(values, axis=1)
        n = tried[:, np.arange(n.shape[1]), best]
        step = np.where(edge[best] & (rise > RISE * differences), step, step / 2)
        level = differences <= LEVEL * np.abs(values).max()
        if bool(np.all(level | (step < LAST_STEP))):
            break
    return height(n), n
