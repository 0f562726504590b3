"""Compare two printings of the book: ``python pdf_compare.py A.pdf B.pdf``; exit code 1 where they do not say the same.

Chromium lays pages out in fractions of a pixel, and where it rounds can depend on what was loaded first. So the bytes
may differ where the pages do not: what is asked is that both have the same pages, each with the same words and links.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from pypdf import PdfReader


def differences(one: PdfReader, other: PdfReader) -> Iterator[str]:
    """Everything that one printing says and the other does not."""
    if len(one.pages) != len(other.pages):
        yield f"{len(one.pages)} pages and {len(other.pages)} pages"
        return
    for number, (here, there) in enumerate(zip(one.pages, other.pages, strict=True), start=1):
        if here.extract_text().split() != there.extract_text().split():
            yield f"page {number}: other words"
        if _links(here) != _links(there):
            yield f"page {number}: other links"


def _links(page: Any) -> list[str]:
    found = [link.get_object() for link in page.get("/Annots", ())]
    return [str(link.get("/Dest", link.get("/A", {}).get("/URI", ""))) for link in found]


def main() -> int:
    """Compare the two files named on the command line."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("one", type=Path, help="a printing")
    parser.add_argument("other", type=Path, help="another one, of pages built anew")
    options = parser.parse_args()
    if options.one.read_bytes() == options.other.read_bytes():
        print("Both printings are the same bytes")
        return 0
    found = list(differences(PdfReader(options.one), PdfReader(options.other)))
    print(*found, f"The bytes of the printings differ, {len(found)} differences in what they say", sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
