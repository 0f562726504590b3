"""Keep what a reference may point to as small previews beside the pages: a script for each page, loaded when needed.

A page of the file system may load scripts but no data, so the previews of ``kinetic.html`` stand in
``_static/previews/kinetic.js``. ``previews.js`` shows them while the pointer or the keyboard rests on a reference.
Sources of formulas are kept, and typeset when shown.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

from bs4 import BeautifulSoup, Tag

if TYPE_CHECKING:
    from docutils import nodes
    from sphinx.application import Sphinx

ROWS = 8
"""Rows of a table that a preview shows."""

HEAVY = re.compile(r'<script\b.*?</script>|<style\b.*?</style>|(?<=")data:[^"]*', flags=re.DOTALL)
"""What no preview shows and would only take time to read: numbers of figures, mostly."""

LEFT_OUT = ".headerlink, .take-away, details, button, dialog, .plotly-graph-div, .above-input, .cell_input"
HEADINGS = ("h1", "h2", "h3", "h4", "h5", "h6")


def previews_of(body: str) -> dict[str, str]:
    """Find the previews of a page by the id of what they show; the page itself stands under the empty id."""
    soup = BeautifulSoup(HEAVY.sub("", body), "html.parser")
    found: dict[str, str] = {}
    for node in soup.find_all(id=True):
        if (shown := _preview(node)) is not None:
            found[str(node["id"])] = shown
    first = soup.find("section")
    if isinstance(first, Tag):
        found[""] = _of_section(first)
    return found


def _preview(node: Tag) -> str | None:
    kinds = node.get_attribute_list("class")
    if node.name == "section":
        return _of_section(node)
    if node.name == "span" and isinstance(node.parent, Tag) and node.parent.name == "section":
        return _of_section(node.parent)  # a label before a heading
    if node.name == "figure" or not {"math", "citation", "literal-block-wrapper"}.isdisjoint(kinds):
        return _kept(node)
    if node.name == "table":
        return _kept(node, rows=ROWS)
    if node.name == "dt":
        meaning = node.find_next_sibling("dd")
        first = meaning.find("p") if isinstance(meaning, Tag) else None
        return _kept(node) + (_kept(first) if isinstance(first, Tag) else "")
    return None


def _of_section(section: Tag) -> str:
    """Its heading, and the result it states or else its first paragraph."""
    heading = section.find(HEADINGS)
    parts = [part for part in _parts(section) if part.name == "p" or "result" in part.get_attribute_list("class")]
    shown = [heading] if isinstance(heading, Tag) else []
    return "".join(_kept(part) for part in [*shown, *parts[:1]])


def _parts(section: Tag) -> Iterator[Tag]:
    """What stands in a section before its first subsection, cells opened."""
    for part in section.find_all(True, recursive=False):
        if part.name == "section":
            return
        if part.name == "div" and "result" not in part.get_attribute_list("class"):
            yield from _parts(part)
        else:
            yield part


def _kept(node: Tag, *, rows: int = 0) -> str:
    """The node without ids, links and what belongs to the page only."""
    copy = BeautifulSoup(str(node), "html.parser")
    for part in copy.select(LEFT_OUT):
        part.decompose()
    for image in copy.find_all("img"):
        if not image.get("src"):
            image.decompose()
    for link in copy.find_all("a"):
        link.unwrap()
    for part in copy.find_all(True):
        for name in ("id", "href", "tabindex"):
            part.attrs.pop(name, None)
    lines = copy.select("tbody tr")
    if rows and len(lines) > rows:
        for line in lines[rows:]:
            line.decompose()
        copy.append(BeautifulSoup(f"<p>and {len(lines) - rows} more rows</p>", "html.parser"))
    return str(copy).strip()


def write_previews(app: Sphinx, page: str, _template: str, context: dict[str, Any], doctree: nodes.document | None,
                   ) -> None:
    """Write the previews of a page that is being written."""
    if app.builder.name != "html" or doctree is None:
        return
    target = Path(app.outdir, "_static", "previews", f"{page}.js")
    target.parent.mkdir(parents=True, exist_ok=True)
    content = json.dumps(previews_of(context["body"]), ensure_ascii=False, sort_keys=True, indent=0)
    target.write_text(f"showPreviews({json.dumps(page)}, {content});\n", encoding="utf-8")


def setup(app: Sphinx) -> dict[str, Any]:
    app.connect("html-page-context", write_previews)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
