"""Figures as a page of the book shows them: text that is the same on every build, and no request to any machine."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from granular.figures.files import PLOTLY_OPTIONS, static_bytes

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True, slots=True, repr=False)
class Static:
    """A matplotlib figure that shows itself in a page as SVG.

    Parameters
    ----------
    figure : matplotlib.figure.Figure
        The figure.

    Notes
    -----
    Source: Jupyter asks the last value of a cell for ``_repr_svg_``; the page tool stores it as an image file.
    """

    figure: Figure

    def __repr__(self) -> str:
        """Name the figure, for readers without images."""
        return "<static figure>"

    def _repr_svg_(self) -> str:
        return static_bytes(self.figure, "svg").decode()


@dataclass(frozen=True, slots=True, repr=False)
class Interactive:
    """A plotly figure that shows itself in a page that has loaded plotly.js.

    Parameters
    ----------
    figure : plotly.graph_objects.Figure
        The figure.
    name : str
        Fixed name of the element; ``plotly-`` is put before it, since a heading of the page may own the bare name.

    Notes
    -----
    Source: Jupyter asks the last value of a cell for ``_repr_html_``.
    """

    figure: Any
    name: str

    def __repr__(self) -> str:
        """Name the figure, for readers without scripts."""
        return f"<interactive figure {self.name}>"

    def _repr_html_(self) -> str:
        page: str = self.figure.to_html(full_html=False, include_plotlyjs=False, include_mathjax=False,
                                        div_id=f"plotly-{self.name}", config=PLOTLY_OPTIONS)
        return page
