"""Figures as a page of the book shows them: text that is the same on every build, and no request to any machine."""

from __future__ import annotations

import base64
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from granular.figures.drawn_data import DrawnData, drawn_data
from granular.figures.files import PLOTLY_OPTIONS, static_bytes

if TYPE_CHECKING:
    from matplotlib.figure import Figure


NUMBERS = "numbers"
"""Key, in what Jupyter keeps about an image, of the numbers behind it: the file and the words of its link."""


WITHOUT_SCRIPTS = ("<noscript><p>Moving this figure takes scripts. The still figure on this page shows the same, "
                   "and the numbers are offered below.</p></noscript>")
"""What stands in the place of an interactive figure where the browser runs no scripts."""


def numbers_link(name: str, data: DrawnData) -> str:
    """Link to the numbers behind a figure, which the page itself holds.

    Parameters
    ----------
    name : str
        Name of the file without ``.csv``.
    data : DrawnData
        The numbers.

    Returns
    -------
    str
        HTML; nothing where there are no numbers.

    Notes
    -----
    Source: a data URI, which works from the file system too.

    Examples
    --------
    >>> numbers_link("fig-x", DrawnData(("panel", "series", "x"), (("1", "a", "2"),)))
    '<p class="take-away"><a download="fig-x.csv" href="data:text/csv;base64,cGFuZWwsc2VyaWVzLHgKMSxhLDIK">the numbers \
behind the figure as fig-x.csv</a></p>'
    """
    if not data:
        return ""
    content = base64.b64encode(data.csv.encode()).decode()
    thinned = f", at most {data.most} points of each series" if data.most else ""
    return (f'<p class="take-away"><a download="{name}.csv" href="data:text/csv;base64,{content}">'
            f"the numbers behind the figure as {name}.csv{thinned}</a></p>")


@dataclass(frozen=True, slots=True, repr=False)
class Static:
    """A matplotlib figure that shows itself in a page as SVG, with the numbers behind it.

    Parameters
    ----------
    figure : matplotlib.figure.Figure
        The figure.
    data : bool
        False for a drawing that explains and shows no numbers.

    Notes
    -----
    Source: Jupyter asks the last value of a cell for what it shows. The page stores the image as a file and puts the
    link to the numbers, which come along as a remark on the image, below it.
    """

    figure: Figure
    data: bool = True

    def __repr__(self) -> str:
        """Name the figure, for readers without images."""
        return "<static figure>"

    def _repr_svg_(self) -> str:
        return static_bytes(self.figure, "svg").decode()

    def _repr_mimebundle_(self, **_wanted: Any) -> tuple[dict[str, str], dict[str, dict[str, str]]]:
        shown = {"image/svg+xml": self._repr_svg_(), "text/plain": repr(self)}
        link = numbers_link("NAME", drawn_data(self.figure)) if self.data else ""
        return shown, {"image/svg+xml": {NUMBERS: link}}


@dataclass(frozen=True, slots=True, repr=False)
class Interactive:
    """A plotly figure that shows itself in a page that has loaded plotly.js, with the numbers behind it.

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

    def element(self) -> str:
        """The figure alone."""
        page: str = self.figure.to_html(full_html=False, include_plotlyjs=False, include_mathjax=False,
                                        div_id=f"plotly-{self.name}", config=PLOTLY_OPTIONS)
        return page + WITHOUT_SCRIPTS

    def _repr_html_(self) -> str:
        return self.element() + numbers_link(self.name, drawn_data(self.figure))
