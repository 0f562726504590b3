"""The gate on the printed book: ``python pdf_check.py BUILD/html BOOK.pdf``; exit code 1 on any problem.

How a page looks was asked when it was printed (pdf_layout.js); this reads the file. Each chapter of the built pages
begins on a page of its own that says its title, stands in the outline and in the contents with the number of that page;
links lead inside or to the web; letters are in the file; nothing in it tells when or where it was made.
"""

from __future__ import annotations

import argparse
import re
import sys
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path
from typing import Any

from pdf_chapters import Heading
from pdf_document import assemble
from pdf_outline import page_numbers, places_of
from pypdf import PdfReader
from pypdf.generic import Destination

MOST_PAGES = 80  # of a chapter; formulas with their code to copy are the longest
FEW_MARKS = 3000  # bytes of drawing on a page; its number and running head alone take about half of it
NUMBER_AND_HEAD = 2  # lines of text
WORD = re.compile(r"[A-Za-z]{4,}")
LIGATURES = str.maketrans({"ﬀ": "ff", "ﬁ": "fi", "ﬂ": "fl", "ﬃ": "ffi", "ﬄ": "ffl"})
DATES = ("/CreationDate", "/ModDate")


def words(text: str) -> set[str]:
    """Longer words of a text, without formulas and as they are written without ligatures."""
    return set(WORD.findall(text.translate(LIGATURES)))


def problems(reader: PdfReader, headings: list[Heading]) -> Iterator[str]:
    """Everything wrong with a printed book that ought to have these headings."""
    yield from _about_chapters(reader, headings)
    yield from _about_outline(reader, headings)
    for number, page in enumerate(reader.pages, start=1):
        yield from (f"page {number}: {problem}" for problem in _about_page(page))
    told = [date for date in DATES if date in (reader.metadata or {})]
    if told or reader.xmp_metadata is not None:
        yield f"says when it was made: {', '.join(told) or 'XMP'}"


def _about_chapters(reader: PdfReader, headings: list[Heading]) -> Iterator[str]:
    places, numbers = places_of(reader), page_numbers(reader)
    upper = [heading for heading in headings if heading.depth < 2]
    lost = [heading.title for heading in upper if heading.anchor not in places]
    if lost:
        yield f"not in the file: {', '.join(lost)}"
        return
    first = [numbers[places[heading.anchor].page.idnum] for heading in upper]
    contents = "\n".join(reader.pages[number].extract_text() for number in range(first[0]))
    for heading, number in zip(upper, first, strict=True):
        text = reader.pages[number].extract_text()
        if not words(heading.title) <= words(text):
            yield f"page {number + 1}: does not say “{heading.title}”"
        if "Math input error" in text:
            yield f"page {number + 1}: a formula with an error"
        if not re.search(_contents_line(heading, number + 1), contents.translate(LIGATURES)):
            yield f"contents: “{heading.title}” without its page {number + 1}"
    for heading, (number, following) in zip(upper, pairwise([*first, len(reader.pages)]), strict=True):
        if not 1 <= following - number <= MOST_PAGES:
            yield f"page {number + 1}: {following - number} pages for “{heading.title}”"


def _contents_line(heading: Heading, number: int) -> str:
    """The last long word of a title, then nothing but short ones, signs and the number of its page."""
    last = WORD.findall(heading.title)[-1:]
    return rf"{re.escape(last[0]) if last else ''}[^\n]{{0,40}}\n?[^\n]{{0,20}}\b{number}\b"


def _about_outline(reader: PdfReader, headings: list[Heading]) -> Iterator[str]:
    listed = [str(one.title) for one in _flat(reader.outline)]
    if listed != [heading.title for heading in headings]:
        yield f"outline: {len(listed)} entries for {len(headings)} headings, or others than these"


def _flat(outline: list[Any]) -> Iterator[Destination]:
    for entry in outline:
        if isinstance(entry, list):
            yield from _flat(entry)
        else:
            yield entry


def _about_page(page: Any) -> Iterator[str]:
    contents = page.get_contents()
    if contents is None or (len(contents.get_data()) < FEW_MARKS
                            and len(page.extract_text().strip().splitlines()) <= NUMBER_AND_HEAD):
        yield "is empty"
    for link in page.get("/Annots", ()):
        address = str(link.get_object().get("/A", {}).get("/URI", ""))
        if address and not address.startswith(("https://", "http://", "mailto:")):
            yield f"links to {address}, which no reader has"
    for name, font in page.get("/Resources", {}).get("/Font", {}).items():
        if not _is_embedded(font.get_object()):
            yield f"letters of {font.get_object().get('/BaseFont', name)} are not in the file"


def _is_embedded(font: Any) -> bool:
    """Whether the shapes of the letters are in the file; type 3 draws them in place."""
    if font["/Subtype"] == "/Type3":
        return True
    inner = font["/DescendantFonts"][0].get_object() if "/DescendantFonts" in font else font
    described = inner.get("/FontDescriptor", {})
    return any(key in described.get_object() for key in ("/FontFile", "/FontFile2", "/FontFile3"))


def main() -> int:
    """Check the printed book named on the command line against the pages from which it was printed."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("root", type=Path, help="the folder with the built pages")
    parser.add_argument("pdf", type=Path, help="the printed book")
    options = parser.parse_args()
    headings = assemble(options.root.resolve(), title="", author="", version="").headings
    reader = PdfReader(options.pdf)
    found = list(dict.fromkeys(problems(reader, headings)))
    print(*found, f"{len(reader.pages)} pages printed, {len(found)} problems", sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
