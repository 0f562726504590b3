"""Finish a printed PDF: its outline, its title, and nothing that differs from one printing to the next."""

from __future__ import annotations

import io
import logging
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from pdf_chapters import Heading
from pypdf import PdfReader, PdfWriter
from pypdf.generic import Fit, NameObject

logging.getLogger("pypdf").setLevel(logging.ERROR)  # it warns of a count of objects that Chromium writes too low


@dataclass(frozen=True)
class Printed:
    """A finished PDF and the number of its pages."""

    data: bytes
    pages: int


def places_of(reader: PdfReader) -> dict[str, Any]:
    """Where each element lies to which something in the document leads."""
    return {name.removeprefix("/"): place for name, place in reader.named_destinations.items()}


def page_numbers(reader: PdfReader) -> dict[int, int]:
    """Number of each page, counted from zero, by the number of its object."""
    return {page.indirect_reference.idnum: number for number, page in enumerate(reader.pages)
            if page.indirect_reference is not None}


def pages_of(pdf: bytes) -> dict[str, int]:
    """On which page, counted from zero, each of these elements lies."""
    reader = PdfReader(io.BytesIO(pdf))
    numbers = page_numbers(reader)
    return {name: numbers[place.page.idnum] for name, place in places_of(reader).items()}


def pages_of_lists(headings: list[Heading], places: dict[str, int]) -> list[int]:
    """Pages with a list of contents, counted from zero: those before the first chapter, and those of the parts."""
    return [*range(places[headings[0].anchor]), *(places[one.anchor] for one in headings if one.depth == 0)]


def finish(whole: bytes, lists: bytes, headings: list[Heading], *, title: str, author: str) -> Printed:
    """Put in the lists of contents, add the outline and name the book; no date makes two printings differ."""
    reader, places = PdfReader(io.BytesIO(whole)), pages_of(whole)
    writer = PdfWriter(clone_from=reader)
    numbered = pages_of_lists(headings, places)
    with_numbers = PdfReader(io.BytesIO(lists)).pages
    if len(with_numbers) != len(numbered):
        raise ValueError("the numbers in the lists of contents moved the pages that they name")
    for number, page in zip(numbered, with_numbers, strict=True):
        for what in ("/Contents", "/Resources"):
            writer.pages[number][NameObject(what)] = page.raw_get(what).clone(writer)
    _outline(writer, headings, places_of(reader), places)
    writer.metadata = {"/Title": title, "/Author": author, "/Creator": "granular"}
    writer.root_object[NameObject("/PageMode")] = NameObject("/UseOutlines")
    out = io.BytesIO()
    writer.write(out)
    return Printed(out.getvalue(), len(reader.pages))


def _outline(writer: PdfWriter, headings: list[Heading], found: Mapping[str, Any], places: dict[str, int]) -> None:
    above: list[Any] = []
    for heading in headings:
        depth = min(heading.depth, len(above))
        place = found[heading.anchor]
        above[depth:] = [writer.add_outline_item(
            title=heading.title, page_number=places[heading.anchor], parent=above[depth - 1] if depth else None,
            fit=Fit.xyz(left=place.left, top=place.top), is_open=heading.depth == 0)]
