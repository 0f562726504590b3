"""Bands of the sphere of contact normals between two cones about axis 3, such as the directions that slide."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

AROUND = 49
"""Points once around a cone."""


def band(between: tuple[float, float], radius: float, *, down: int = 7, around: int = AROUND) -> tuple[Array, ...]:
    """Points of the band between two cones, above and below the equator.

    Parameters
    ----------
    between : tuple of 2 float
        Angles of the two cones from axis 3, 0 to 90 [degrees].
    radius : float
        Of the sphere [any unit].
    down, around : int
        Points from cone to cone, and once around [-].

    Returns
    -------
    tuple of 3 (2 down + 1, around) array
        x, y and z, same unit; a row of nan parts the two halves. Rounded to three decimals.

    Notes
    -----
    Source: spherical coordinates; the opposite side of a contact is a contact too.
    """
    import numpy as np

    upper = np.radians(np.linspace(*between, down))
    beta = np.concatenate([upper, [np.nan], np.pi - upper[::-1]])[:, None]
    turn = np.linspace(0.0, 2 * np.pi, around)[None, :]
    return tuple(np.round(radius * part, 3) + 0.0 for part in (
        np.sin(beta) * np.cos(turn), np.sin(beta) * np.sin(turn), np.cos(beta) + 0 * turn))


def plotly_band(between: tuple[float, float], *, radius: float, colour: str, name: str, opacity: float = 1.0) -> Any:
    """Make the band between two cones for plotly.

    Parameters
    ----------
    between : tuple of 2 float
        Angles of the two cones from axis 3 [degrees].
    radius : float
        Of the sphere [any unit].
    colour : str
        ``#rrggbb``.
    name : str
        What the pointer says.
    opacity : float
        0 to 1 [-].

    Returns
    -------
    plotly.graph_objects.Surface
        Both halves in one trace.

    Notes
    -----
    Source: spherical coordinates.
    """
    import numpy as np
    from plotly import graph_objects

    x, y, z = (part.astype(np.float32) for part in band(between, radius))
    return graph_objects.Surface(
        x=x, y=y, z=z, showscale=False, colorscale=[[0, colour], [1, colour]], opacity=opacity, name=name,
        surfacecolor=np.zeros(x.shape, dtype=np.float32), hovertemplate=f"{name}<extra></extra>",
        lighting={"ambient": 0.8, "diffuse": 0.3, "specular": 0.0})
