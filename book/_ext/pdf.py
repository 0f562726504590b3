"""Print the built book as one PDF: ``python pdf.py BUILD/html OUT.pdf``.

Chromium typesets and prints; the pages of the chapters, which are known then, are written into the lists of contents,
and these are printed once more. The outline is added afterwards and dates are left out, so that the same pages give the
same bytes.
"""

from __future__ import annotations

import argparse
import base64
import shutil
import sys
import tempfile
import time
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from typing import Any

import yaml
from chromium import Chromium
from pdf_document import Document, assemble
from pdf_outline import finish, pages_of, pages_of_lists

# A4 without the margins that print.css gives, at 96 pixels an inch: formulas are broken for the width of the paper.
PAPER_WIDTH, PAPER_HEIGHT = 672, 979
TIMEOUT = 900.0  # for the load of all pages at once, and for printing them; a machine at work on other things is slow
MISSING = ("The PDF is printed by Chromium, which is not installed: apt install chromium, or name the program with "
           "make pdf CHROMIUM=...")
FIT = (Path(__file__).parent / "pdf_fit.js").read_text(encoding="utf-8")
LAYOUT = (Path(__file__).parent / "pdf_layout.js").read_text(encoding="utf-8")
WRITE_NUMBERS = """
(numbers => {
  for (const place of document.querySelectorAll('.page-number')) place.textContent = numbers[place.dataset.of] ?? '';
})(%s)
"""


def printed(browser: Chromium, pages: str = "") -> bytes:
    """Print what the browser shows, whole or some pages of it."""
    answer = browser.call("Page.printToPDF", preferCSSPageSize=True, printBackground=True, generateTaggedPDF=False,
                          transferMode="ReturnAsStream", pageRanges=pages)
    chunks, handle = [], answer["stream"]
    while True:
        part: dict[str, Any] = browser.call("IO.read", handle=handle, size=1 << 20)
        chunks.append(base64.b64decode(part["data"]) if part.get("base64Encoded") else part["data"].encode("latin-1"))
        if part["eof"]:
            return b"".join(chunks)


@dataclass(frozen=True)
class Print:
    """What Chromium printed: the document, its lists of contents with page numbers, and what is wrong on paper."""

    whole: bytes
    lists: bytes
    problems: list[str]


def print_book(document: Document, executable: str, folder: Path) -> Print:
    """Print the document from a folder beside the built pages; then its lists of contents with their numbers."""
    page = folder / "book.html"
    page.write_text(document.text, encoding="utf-8")
    with Chromium(executable, timeout=TIMEOUT) as browser:
        browser.open(page, width=PAPER_WIDTH, height=PAPER_HEIGHT, media="print")
        browser.ask(FIT)
        problems = browser.ask(LAYOUT)
        whole = printed(browser)
        places = pages_of(whole)
        browser.ask(WRITE_NUMBERS % {name: number + 1 for name, number in places.items()})
        lists = printed(browser, ",".join(str(number + 1) for number in pages_of_lists(document.headings, places)))
    return Print(whole, lists, problems)


def main() -> int:
    """Print the book named on the command line."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("root", type=Path, nargs="?", help="folder with the built pages; if none, look for Chromium")
    parser.add_argument("out", type=Path, nargs="?", help="the PDF to write", default=Path("granular.pdf"))
    parser.add_argument("--browser", default="chromium", help="the Chromium that prints")
    options = parser.parse_args()
    executable = shutil.which(options.browser)
    if executable is None:
        print(MISSING, file=sys.stderr)
        return 2
    if options.root is None:
        return 0
    begun = time.monotonic()
    root = options.root.resolve()
    settings = yaml.safe_load((Path(__file__).parents[1] / "_config.yml").read_text(encoding="utf-8"))
    document = assemble(root, title=settings["title"], author=settings["author"], version=version("granular"))
    with tempfile.TemporaryDirectory(dir=root.parent, prefix=".paper-") as folder:
        raw = print_book(document, executable, Path(folder))
    made = finish(raw.whole, raw.lists, document.headings, title=settings["title"], author=settings["author"])
    options.out.write_bytes(made.data)
    print(f"{options.out}: {made.pages} pages, {len(made.data) / 1e6:.1f} MB, in {time.monotonic() - begun:.0f} s")
    print(*raw.problems, sep="\n", end="\n" if raw.problems else "", file=sys.stderr)
    return 1 if raw.problems else 0


if __name__ == "__main__":
    sys.exit(main())
