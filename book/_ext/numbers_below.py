"""Put the link to the numbers behind a figure below it.

A figure comes out of a cell as an image, and its numbers as a remark on that image; MyST-NB shows the image and passes
the remark over. Here it becomes a link below the figure and its caption, named like the figure. A page that offers
the numbers right below by itself keeps its own link.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from docutils import nodes
from myst_nb.core import render

from granular.figures.page import NUMBERS

if TYPE_CHECKING:
    from myst_nb.core.render import MimeData, NbElementRenderer
    from sphinx.application import Sphinx

OWN_LINK = "the numbers behind the figure"


class ImageWithNumbers:
    """Shows an image as MyST-NB does, and its numbers after it."""

    mime_priority_overrides = ()

    @staticmethod
    def handle_mime(renderer: NbElementRenderer, data: MimeData, inline: bool) -> list[nodes.Element] | None:
        """Take images that carry numbers, and leave all other output alone."""
        link = data.output_metadata.get(data.mime_type, {}).get(NUMBERS, "")
        if not link or inline:
            return None
        return [*renderer.render_image(data), nodes.raw("", link, format="html", numbers=True)]


def below_the_figure(_app: Sphinx | None, doctree: nodes.Element, page: str) -> None:
    """Move each link behind the figure it stands in, give it the figure's name, or drop it for the page's own."""
    for number, link in enumerate(list(doctree.findall(_is_link)), start=1):
        figure = link.parent if isinstance(link.parent, nodes.figure) else None
        name = figure["ids"][0] if figure is not None and figure["ids"] else f"{page}-{number}"
        output = link
        while not (isinstance(output, nodes.container) and output.get("nb_element") == "cell_code"):
            output = output.parent
        link.parent.remove(link)
        if _offers_numbers(output.next_node(descend=False, siblings=True)):
            continue
        named = nodes.raw("", link.astext().replace("NAME", name), format="html")
        if figure is not None:
            figure.parent.insert(figure.parent.index(figure) + 1, named)
        else:
            output[-1].append(named)


def _is_link(node: nodes.Node) -> bool:
    return isinstance(node, nodes.raw) and bool(node.get("numbers"))


def _offers_numbers(following: nodes.Node | None) -> bool:
    return isinstance(following, nodes.container) and any(
        OWN_LINK in raw.astext() for raw in following.findall(nodes.raw) if not raw.get("numbers"))


def setup(app: Sphinx) -> dict[str, Any]:
    # MyST-NB looks for renderers among installed packages only; the book is none
    render.load_mime_renders = lambda: [ImageWithNumbers]
    app.connect("doctree-resolved", below_the_figure)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
