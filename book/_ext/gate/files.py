"""What the files alone show: loads from another machine, dead links, repeated ids, pictures without words."""

from __future__ import annotations

import html.parser
import re
from dataclasses import dataclass, field
from pathlib import Path
from urllib.parse import unquote, urlsplit

LOADING_ATTRIBUTES = {
    "script": "src", "img": "src", "link": "href", "iframe": "src", "source": "src", "video": "src",
    "audio": "src", "embed": "src", "object": "data",
}
OTHER_MACHINE = re.compile(r"(?:https?:)?//")
STYLE_LOADS = re.compile(r"""(?:url\(|@import)\s*["']?((?:https?:)?//[^"')\s]+)""")


@dataclass
class Page(html.parser.HTMLParser):
    """What a page loads, links to, names and pictures; whether it has anything to click besides links."""

    path: Path
    loads: list[str] = field(default_factory=list)
    links: list[str] = field(default_factory=list)
    ids: list[str] = field(default_factory=list)
    unnamed_pictures: list[str] = field(default_factory=list)
    has_pictures: bool = False

    def __post_init__(self) -> None:
        super().__init__()
        self._in_words = False  # whether the element around the next one says in words what it shows
        text = self.path.read_text(encoding="utf-8")
        self.loads += STYLE_LOADS.findall(text)
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = {name: value or "" for name, value in attrs}
        if given.get("id"):
            self.ids.append(given["id"])
        if tag in LOADING_ATTRIBUTES and given.get(LOADING_ATTRIBUTES[tag]):
            self.loads.append(given[LOADING_ATTRIBUTES[tag]])
        if tag == "a" and given.get("href"):
            self.links.append(given["href"])
        if "plotly-graph-div" in given.get("class", "") and not self._in_words:
            self.unnamed_pictures.append(given.get("id", "?"))
        self._in_words = bool(given.get("aria-label")) or (tag == "div" and not given.get("class") and self._in_words)
        self.has_pictures |= (tag in {"img", "select"} or given.get("type") == "range"
                              or "plotly-graph-div" in given.get("class", ""))
        # Sphinx writes the file name where an author gave no words.
        if tag == "img" and (not given.get("alt") or "_images/" in given["alt"]):
            self.unnamed_pictures.append(given.get("src", "?"))


def pages_of(root: Path) -> dict[Path, Page]:
    """Every page of the book by its path."""
    return {path: Page(path) for path in sorted(root.rglob("*.html")) if "_static" not in path.parts}


def problems_of_text(root: Path, pages: dict[Path, Page]) -> list[str]:
    """Everything wrong that the files alone show."""
    found = []
    for page in pages.values():
        name = page.path.relative_to(root).as_posix()
        found += [f"{name}: id {twice} is used more than once"
                  for twice in sorted({one for one in page.ids if page.ids.count(one) > 1})]
        found += [f"{name}: picture {picture} has no description" for picture in page.unnamed_pictures]
        found += [f"{name}: loads {url} from another machine"
                  for url in page.loads if OTHER_MACHINE.match(url)]
        local = [url for url in page.loads + page.links
                 if not OTHER_MACHINE.match(url) and not url.startswith(("mailto:", "data:"))]
        found += [f"{name}: {problem}" for url in local if (problem := _problem_of_link(page, url, pages))]
    for style in sorted(root.rglob("*.css")):
        found += [f"{style.relative_to(root).as_posix()}: loads {url} from another machine"
                  for url in STYLE_LOADS.findall(style.read_text(encoding="utf-8", errors="replace"))]
    return found


def _problem_of_link(page: Page, url: str, pages: dict[Path, Page]) -> str:
    parts = urlsplit(url)
    if parts.scheme:
        return f"{url} does not lead to a file of the book"
    target = (page.path.parent / unquote(parts.path)).resolve() if parts.path else page.path
    if not target.exists():
        return f"{url} leads to a file that is missing"
    if parts.fragment and target in pages and unquote(parts.fragment) not in pages[target].ids:
        return f"{url} leads to an anchor that is missing"
    return ""
