"""Turn a built page into a chapter for paper, as it was built: its numbers, references and figures stay.

What only a screen can do is left out or opened: an interactive figure has a static twin beside it, code that is folded
stays in the source of its page, tabs and other folds are shown. Ids get the name of their page before them, so that
links between pages become links inside one document.
"""

from __future__ import annotations

import posixpath
import re
from dataclasses import dataclass
from pathlib import Path
from urllib.parse import unquote, urlsplit

from bs4 import BeautifulSoup, Tag

LEFT_OUT = (
    "details.hide.above-input, details.hide.above-cell, script, template, .headerlink, .copybtn, "
    "p.take-away, .only-dark, .only-screen, .toctree-wrapper"
)
LONGEST_FOLD = 60  # rows; the tables of measurements behind longer folds fill page after page, and are data of the book
INTERACTIVE = ".plotly-graph-div"
ON_A_SCREEN = "This figure moves in the book on a screen."
FIRST_NUMBER = re.compile(r"^([\d.]*\d)\.?\s+")
OTHER_MACHINE = re.compile(r"https?://|mailto:")


@dataclass(frozen=True)
class Heading:
    """A part, chapter or section: what is read, where it is, how deep it stands (0 for parts, 1 for chapters)."""

    title: str
    anchor: str
    depth: int


@dataclass(frozen=True)
class Chapter:
    """A page as a section of the document, with its headings, its own first."""

    page: str
    section: Tag
    headings: list[Heading]


def read(path: Path) -> BeautifulSoup:
    """Read a page."""
    return BeautifulSoup(path.read_text(encoding="utf-8"), "html.parser")


def anchor(page: str, name: str = "") -> str:
    """Id in the document of an element of a page, or of the page itself."""
    return f"{page}--{name}" if name else page


def chapter(root: Path, page: str, *, pages: set[str]) -> Chapter:
    """Make a chapter of a page below ``root``; links to the other ``pages`` lead to their chapters."""
    section = read(root / f"{page}.html").select_one("article.bd-article > section")
    if section is None:
        raise ValueError(f"{page}.html has no text; build the book first: make book")
    _leave_out(section)
    _unfold(section)
    for name in ("id", "for"):
        for element in section.find_all(attrs={name: True}):
            element[name] = anchor(page, str(element[name]))
    for picture in section.find_all("img"):
        picture["src"] = _from_document(str(picture["src"]))
    _lead_inside(section, page, pages)
    for heading in section.find_all(re.compile(r"^h[1-5]$")):
        heading.name = f"h{int(heading.name[1]) + 1}"  # parts are headings of the first level
    section["class"] = "chapter"
    return Chapter(page, section, _headings(section, page))


def _leave_out(section: Tag) -> None:
    for figure in section.select(INTERACTIVE):
        shown = figure.find_parent(class_="output") or figure
        if shown.select("img"):  # the twin stands in the same place
            figure.decompose()
        else:
            shown.replace_with(_note(ON_A_SCREEN))
    for element in section.select(LEFT_OUT):
        element.decompose()
    for cell in section.select("div.cell"):
        if not cell.get_text(strip=True) and not cell.select("img, svg"):
            cell.decompose()


def _unfold(section: Tag) -> None:
    """Show what is folded, save for tables of more rows than anybody reads on paper."""
    for fold in section.select("details"):
        summary = fold.find("summary")
        if len(fold.find_all("tr")) > LONGEST_FOLD and summary is not None:
            said = summary.get_text(" ", strip=True)
            fold.replace_with(_note(f"{said}: folded on the page of the book on a screen."))
        else:
            fold["open"] = ""


def _note(text: str) -> BeautifulSoup:
    return BeautifulSoup(f'<p class="elsewhere">{text}</p>', "html.parser")


def _lead_inside(section: Tag, page: str, pages: set[str]) -> None:
    """Links lead into the document or to other machines; the files that others led to are not in it."""
    for link in section.find_all("a", href=True):
        address = str(link["href"])
        if OTHER_MACHINE.match(address):
            continue
        parts = urlsplit(address)
        target = posixpath.splitext(unquote(parts.path))[0] or page
        if target in pages:
            link["href"] = "#" + anchor(target, unquote(parts.fragment))
        else:
            del link["href"]


def _from_document(address: str) -> str:
    """Address of a file of the built pages, seen from the folder beside theirs in which the document lies."""
    return address if address.startswith("data:") else f"../html/{address}"


def _headings(section: Tag, page: str) -> list[Heading]:
    found = []
    for heading in section.find_all(re.compile(r"^h[2-4]$")):
        home = heading.find_parent("section")
        if home is not None and heading.parent is home:
            depth = int(heading.name[1]) - 1
            found.append(Heading(plain(heading), anchor(page) if depth == 1 else str(home["id"]), depth))
    return found


def plain(heading: Tag) -> str:
    """What a heading says on one line, a formula in it without the signs of TeX."""
    text = re.sub(r"\s+", " ", heading.get_text()).strip()
    text = re.sub(r"\\\((.*?)\\\)", lambda found: re.sub(r"\\(?:mathrm|text)|[\\{}]", "", found[1]), text)
    return FIRST_NUMBER.sub("\\1\u2002", text)
