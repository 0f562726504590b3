"""Figures as bytes that do not change from run to run, and as files that are never left half written."""

from __future__ import annotations

import contextlib
import io
import os
from collections.abc import Callable
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

from granular.errors import FigureNotKnown, FigureNotWritten
from granular.figures.look import house_style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

STATIC_SUFFIXES = (".svg", ".png", ".pdf")
INTERACTIVE_SUFFIX = ".html"
SUFFIXES = (*STATIC_SUFFIXES, INTERACTIVE_SUFFIX)

_WITHOUT_DATES = {"svg": {"Date": None, "Creator": None}, "png": {"Software": None},
                  "pdf": {"CreationDate": None, "Creator": None, "Producer": None}}

PLOTLY_OPTIONS = {"displaylogo": False, "responsive": True,
                  "modeBarButtonsToRemove": ["sendChartToCloud", "zoom3d", "pan3d", "orbitRotation", "tableRotation",
                                             "resetCameraLastSave3d", "select2d", "lasso2d", "autoScale2d"]}
"""No logo, the width of the page, no button that would send the data to a server, and few others."""


@house_style
def static_bytes(figure: Figure, kind: str) -> bytes:
    """Render a matplotlib figure.

    Parameters
    ----------
    figure : matplotlib.figure.Figure
        The figure.
    kind : str
        ``"svg"``, ``"png"`` or ``"pdf"``.

    Returns
    -------
    bytes
        The file; the same figure gives the same bytes.

    Notes
    -----
    Source: dates, program versions and random element names are left out.
    """
    if figure.get_layout_engine() is not None:
        # the layout moves a little each time it is solved; solved once, it gives the same bytes ever after
        figure.draw_without_rendering()
        figure.set_layout_engine("none")
    buffer = io.BytesIO()
    figure.savefig(buffer, format=kind, metadata=_WITHOUT_DATES[kind])
    return buffer.getvalue()


def whole_page(figure: Any, name: str, title: str) -> bytes:
    """Render a plotly figure as a page that needs no network.

    Parameters
    ----------
    figure : plotly.graph_objects.Figure
        The figure.
    name : str
        Fixed name of the element, so that the same figure gives the same bytes.
    title : str
        Of the page, plain text.

    Returns
    -------
    bytes
        The file, some 5 MB: plotly.js stands inside it.

    Notes
    -----
    Source: plotly's own export.
    """
    body = figure.to_html(full_html=False, include_plotlyjs=True, include_mathjax=False,
                          div_id=f"plotly-{name}", config=PLOTLY_OPTIONS)
    return ('<!doctype html>\n<html lang="en">\n<head><meta charset="utf-8">'
            '<meta name="viewport" content="width=device-width, initial-scale=1">'
            f"<title>{escape(title)}</title></head>\n<body>\n{body}\n</body>\n</html>\n").encode()


def target(out: str | os.PathLike[str]) -> Path:
    """Check where a figure is to go, before any work is done for it.

    Parameters
    ----------
    out : str or path-like
        File name; its suffix says the format.

    Returns
    -------
    Path
        The same place.

    Raises
    ------
    FigureNotKnown
        A suffix that names no format.
    FigureNotWritten
        The folder does not exist, the name is that of a folder, or the file may not be written.

    Notes
    -----
    Source: the interface of ``granular plot``.
    """
    path = Path(out)
    if path.suffix.lower() not in SUFFIXES:
        raise FigureNotKnown(f"out = {str(path)!r}", allowed=f"allowed suffixes: {', '.join(SUFFIXES)}",
                             remedy="End the file name with one of them; .html is the interactive one.")
    if not path.parent.is_dir():
        raise FigureNotWritten(f"folder {str(path.parent)!r} of the figure", allowed="needed: an existing folder",
                               remedy="Create the folder, or name another file.")
    if path.is_dir():
        raise FigureNotWritten(f"out = {str(path)!r}", allowed="needed: the name of a file, and this is a folder",
                               remedy="Name another file.")
    if path.exists() and not os.access(path, os.W_OK):
        raise FigureNotWritten(f"out = {str(path)!r}", allowed="needed: a file that may be overwritten",
                               remedy="Change its permissions, or name another file.")
    return path


def write(path: Path, render: Callable[[], bytes]) -> None:
    """Render into a neighbour of the file and move it into place, so that the file is whole or untouched.

    Parameters
    ----------
    path : Path
        Where to, from ``target``.
    render : callable
        Gives the bytes.

    Raises
    ------
    FigureNotWritten
        The system refuses: no permission, no room.

    Notes
    -----
    Source: a rename within one folder is atomic.
    """
    content = render()
    beside = path.with_name(f".{path.name}.{os.getpid()}.part")
    try:
        with beside.open("xb") as file:
            file.write(content)
        beside.replace(path)
    except OSError as error:
        raise FigureNotWritten(f"out = {str(path)!r}: {error.strerror or error}",
                               allowed="needed: a folder in which files may be created",
                               remedy="Change its permissions or make room, or name another file.") from None
    finally:
        with contextlib.suppress(OSError):
            beside.unlink(missing_ok=True)
