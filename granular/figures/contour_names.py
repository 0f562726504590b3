"""Where the names of lines of equal value stand: on a path across the map, so that none is cut at an edge."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

STEPS = 401
"""Points on the path."""


def on_path(across: Array, up: Array, values: Array, levels: Sequence[float],
            path: Sequence[tuple[float, float]], apart: float = 0.0) -> list[tuple[float, float]]:
    """Find where lines first cross a path.

    Parameters
    ----------
    across, up : (n,) array, (m,) array
        Coordinates of the grid, in rising order [any unit].
    values : (m, n) array
        What is drawn [any unit]; nan where there is nothing.
    levels : sequence of float
        Values of the lines [same unit].
    path : sequence of tuple of 2 float
        Corners of the path, inside the grid [units of the coordinates].
    apart : float
        A line that crosses nearer than this to an earlier one has no name: its share of the path, each side of which
        counts alike [-].

    Returns
    -------
    list of tuple of 2 float
        Across and up [units of the coordinates] for each line that crosses the path; for ``manual`` of matplotlib's
        ``clabel``.

    Notes
    -----
    Accuracy: a step of the path, for bilinear interpolation.
    Source: names at fixed places stay where they are when numbers change a little.

    Examples
    --------
    >>> import numpy as np
    >>> grid = np.linspace(0, 1, 5)
    >>> on_path(grid, grid, np.add.outer(0 * grid, grid), [0.5, 2.0], [(0, 0.5), (1, 0.5)])
    [(0.4975, 0.5)]
    """
    import numpy as np
    from scipy.interpolate import RegularGridInterpolator

    corners = np.arange(len(path))
    steps = np.linspace(0, corners[-1], STEPS)
    points = np.stack([np.interp(steps, corners, part) for part in zip(*path, strict=True)], axis=1)
    along = RegularGridInterpolator((up, across), values)(points[:, ::-1])
    crossed = [np.flatnonzero(np.abs(np.diff(np.sign(along - level))) > 0) for level in levels]
    kept: list[int] = []
    for first in (int(found[0]) for found in crossed if found.size):
        if all(abs(first - other) >= apart * STEPS for other in kept):
            kept.append(first)
    return [(float(points[step, 0]), float(points[step, 1])) for step in kept]
