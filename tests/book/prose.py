"""The prose of a page's source: what its author typed for readers, without code, formulas, names and addresses."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

FENCE = re.compile(r"^(`{3,}|~{3,})")
SAID_IN_OPTIONS = re.compile(r"^:\s+(?:caption|alt): ?(.*)$")
"""A caption and the words for those who cannot see a figure stand among the options of a cell."""
DIRECTIVE = re.compile(r"^:{3,}\{[a-z-]+\} ?(.*)$")
OPTION = re.compile(r"^:[a-z-]+:|^:{3,}$|^\([a-z0-9-]+\)=$")
HIDDEN = re.compile(
    r"\{[a-z:]+\}`[^`<]*(?:<[^>`]*>)?`"  # roles: references, citations, downloads
    r"|`[^`]*`"  # code
    r"|\]\([^)]*\)"  # the address of a link
    r"|<[^>]*>"  # markup
    r"|https?://\S+")
FORMULA = re.compile(r"\$\$.*?\$\$|\$[^$]*\$", flags=re.DOTALL)


@dataclass(frozen=True)
class Line:
    """One line of prose: where it stands, its words, and the formulas within it."""

    page: str
    number: int
    words: str
    formulas: tuple[str, ...]


def lines(page: Path) -> Iterator[Line]:
    """Every line of prose of a page, captions and alternative texts among them."""
    text = page.read_text(encoding="utf-8")
    start = text.index("\n---\n", 3) + 5 if text.startswith("---\n") else 0
    body = re.sub(r"\$\$.*?\$\$", lambda found: "\n" * found[0].count("\n"), text[start:], flags=re.DOTALL)
    offset = text[:start].count("\n")
    fence = ""
    paragraphs: list[list[tuple[int, str]]] = [[]]
    for number, line in enumerate(body.splitlines(), offset + 1):
        found = FENCE.match(line)
        if found and not fence:
            fence = found[1]
        elif found and found[1] == fence:
            fence = ""
        elif fence:
            if option := SAID_IN_OPTIONS.match(line):
                paragraphs += [[(number, option[1])], []]
        elif directive := DIRECTIVE.match(line):
            paragraphs += [[(number, directive[1])], []]
        elif not OPTION.match(line):
            paragraphs[-1].append((number, line))
            if not line.strip():
                paragraphs.append([])
    for paragraph in filter(None, paragraphs):  # a formula or a link may go on in the next line
        whole = "\n".join(line for _, line in paragraph)
        bare = HIDDEN.sub(_kept_breaks, FORMULA.sub(_marked, whole))
        formulas = [(whole[:found.start()].count("\n"), found[0]) for found in FORMULA.finditer(whole)]
        for at, ((number, _), words) in enumerate(zip(paragraph, bare.split("\n"), strict=True)):
            if words.strip():
                yield Line(page.stem, number, words, tuple(formula for line, formula in formulas if line == at))


def _kept_breaks(found: re.Match[str]) -> str:
    return "\n" * found[0].count("\n") or " "


def _marked(found: re.Match[str]) -> str:
    return "¤" + "\n" * found[0].count("\n")
