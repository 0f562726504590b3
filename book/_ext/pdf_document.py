"""Join the built pages into one document for paper, in the order of their navigation."""

from __future__ import annotations

import json
from dataclasses import dataclass
from html import escape
from pathlib import Path

import matplotlib
from bs4 import BeautifulSoup, Tag
from pdf_chapters import Chapter, Heading, chapter, read

NOTE = """\
This is the book on paper, printed by <code>make pdf</code> from its pages. The code that made a number or a figure
stands in the file named below the title of its chapter. On the pages, which <code>make book</code> builds, it unfolds
beside its result, figures move, and tables and figures can be taken away as files."""
DOCUMENT = """\
<!DOCTYPE html>
<html lang="en" class="paper" data-theme="light" data-mode="light">
<head>
<meta charset="utf-8">
<title>{title}</title>
{head}
<style>
{fonts}
{styles}
</style>
</head>
<body>
<main class="bd-content"><article class="bd-article">
{front}
{body}
<nav hidden>{targets}</nav>
</article></main>
</body>
</html>
"""
FRONT = """\
<section class="title-page"><p class="book-title">{title}</p><p class="book-author">{author}</p>
<p class="book-version">Version {version}</p></section>
<section class="contents-pages" id="contents"><h2>Contents</h2><p class="paper-note">{note}</p>
<ol class="contents">{contents}</ol></section>"""


@dataclass(frozen=True)
class Part:
    """A part of the book with the names of its pages; the first page belongs to none."""

    title: str
    pages: list[str]


@dataclass(frozen=True)
class Document:
    """The one page that is printed, and its headings in their order."""

    text: str
    headings: list[Heading]


def parts_of(index: BeautifulSoup) -> list[Part]:
    """List the parts with their pages as the navigation of the first page shows them."""
    found = [Part("", ["index"])]
    for child in index.select("nav.bd-links .bd-toc-item > *"):
        if child.name == "p":
            found.append(Part(child.get_text().strip(), []))
        else:
            names = [str(link["href"]).removesuffix(".html") for link in child.select("li > a.reference")]
            found[-1].pages.extend(name for name in names if "#" not in name)
    return [part for part in found if part.pages]


def assemble(root: Path, *, title: str, author: str, version: str) -> Document:
    """Make the document of the pages below ``root``; it belongs into a folder beside ``root``."""
    index = read(root / "index.html")
    parts = parts_of(index)
    pages = {page for part in parts for page in part.pages}
    headings: list[Heading] = []
    body, contents, styles = [], [], []
    for number, part in enumerate(parts):
        chapters = [chapter(root, page, pages=pages) for page in part.pages]
        rows = "".join(_row(one.headings[0]) for one in chapters)
        if part.title:
            first = Heading(part.title, f"part-{number}", 0)
            headings.append(first)
            body.append(f'<section class="part" id="{first.anchor}"><h1>{escape(part.title)}</h1>'
                        f'<ol class="contents">{rows}</ol></section>')
            rows = _row(first) + rows
        contents.append(rows)
        for one in chapters:
            headings += one.headings
            styles.append(_running_heads(one, part.title))
            body.append(_text(one))
    front = FRONT.format(title=escape(title), author=escape(author), version=escape(version), note=NOTE,
                         contents="".join(contents))
    targets = "".join(f'<a href="#{escape(heading.anchor)}"></a>' for heading in headings)
    text = DOCUMENT.format(title=escape(title), head=_head(index), fonts=_fonts(), styles="\n".join(styles),
                           front=front, body="\n".join(body), targets=targets)
    return Document(text, headings)


def _row(heading: Heading) -> str:
    kind = ("of-part", "of-chapter")[heading.depth]
    return (f'<li class="{kind}"><a href="#{escape(heading.anchor)}"><span class="what">{escape(heading.title)}</span>'
            f'<span class="page-number" data-of="{escape(heading.anchor)}"></span></a></li>')


def _text(one: Chapter) -> str:
    title = one.section.find("h2")
    if isinstance(title, Tag):
        title.insert_after(BeautifulSoup(f'<p class="paper-source">Source: book/{one.page}.md</p>', "html.parser"))
    return f'<div class="chapter-pages" id="{one.page}" style="page: {_page_name(one)}">{one.section}</div>'


def _page_name(one: Chapter) -> str:
    return "chapter-" + one.page.replace("_", "-")


def _running_heads(one: Chapter, part: str) -> str:
    return (f"@page {_page_name(one)} {{ @top-left {{ content: {json.dumps(part, ensure_ascii=False)}; }} "
            f"@top-right {{ content: {json.dumps(one.headings[0].title, ensure_ascii=False)}; }} }}")


def _fonts() -> str:
    """The letters of the figures, which come with matplotlib, for the text: no machine has others."""
    folder = Path(matplotlib.get_data_path(), "fonts", "ttf")
    return "\n".join(
        f'@font-face {{ font-family: "Book {family}"; font-weight: {weight}; font-style: {style}; '
        f'src: url("{(folder / f"DejaVu{family}{suffix}.ttf").as_uri()}"); }}'
        for family in ("Sans", "SansMono")
        for suffix, weight, style in (("", 400, "normal"), ("-Bold", 700, "normal"), ("-Oblique", 400, "italic"),
                                      ("-BoldOblique", 700, "italic")))


def _head(index: BeautifulSoup) -> str:
    """Style sheets and MathJax of the pages, seen from the folder of the document."""
    kept = []
    for sheet in index.head.select("link[rel=stylesheet]") if index.head else []:
        kept.append(f'<link rel="stylesheet" href="../html/{sheet["href"]}">')
    for script in index.head.select("script") if index.head else []:
        if "mathjax" in str(script.get("src", "")):
            kept.append(f'<script defer src="../html/{script["src"]}"></script>')
        elif "window.MathJax" in script.get_text():
            kept.append(str(script))
    return "\n".join(kept)
