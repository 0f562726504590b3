"""One figure that any scene of a kind has."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from granular.scene import Scene


@dataclass(frozen=True, slots=True)
class SceneFigure:
    """One figure that any scene of a kind has.

    Attributes
    ----------
    title : str
        What it shows, one line.
    static : callable
        Takes a scene, gives a matplotlib figure.
    interactive : callable
        Takes a scene, gives a plotly figure.
    """

    title: str
    static: Callable[[Scene], Figure]
    interactive: Callable[[Scene], Any]
