"""Index of the symbols: what each stands for, and where a reader meets it first."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from itertools import cycle, groupby

from derivations.symbols import GLOSSARY, Quantity
from derivations.written import is_defined, is_name, stands_in
from page_tools.contents import Place, page_link, pages, records, source, steps_shown
from page_tools.markup import Markup, plain, table

REFERENCE = ("index", "first_use", "ledger", "symbols", "formulas", "python_interface", "python_scenes", "python_many",
             "python_fabric", "python_measured", "python_derivations", "scene_file", "command_line", "errors", "rerun",
             "bibliography")
"""Pages that introduce nothing: the overview, a first walk, and what is looked up."""
CONVENTIONS = "conventions"
"""The page that defines letters for the whole book."""
FAMILY = 4
"""So many components of one tensor share a row."""

_MATH = re.compile(r"\$\$(.+?)\$\$|(?<!\$)\$([^$\n]+)\$(?!\$)", flags=re.DOTALL)
_ACCENTS = re.compile(r"\\(?:tilde|bar|mathrm|langle)\b|[{} ]")
_LETTERS = "ijkl"


def symbol_index() -> Markup:
    """Every declared symbol in the order of the alphabet, components of one tensor in one row."""
    rows = [[f"${latex}$", plain(meaning), plain(members[0].unit), plain(members[0].domain), _place(members)]
            for latex, meaning, members in sorted(families(), key=lambda family: alphabetical(family[0]))]
    return table(["symbol", "meaning", "unit", "values", "first met"], rows, label="tab-symbols", look="symbols",
                 caption="Symbols of the derivations.", take_away="symbols.csv",
                 taken=[["name in programs", "LaTeX", "unit", "values", "meaning"],
                        *([q.symbol.name, q.latex, q.unit, q.domain, q.meaning] for q in GLOSSARY)])


def families() -> list[tuple[str, str, Sequence[Quantity]]]:
    """LaTeX, meaning and members of each row; components that differ by their indices alone are one row."""
    found = []
    for key, group in groupby(sorted(GLOSSARY, key=_family), key=_family):
        members = tuple(group)
        if len(members) >= FAMILY:
            latex, meaning = key[0], key[1]
            found.append((latex, f"{meaning}; {len(members)} components", members))
        else:
            found += [(quantity.latex, quantity.meaning, (quantity,)) for quantity in members]
    return found


def _family(quantity: Quantity) -> tuple[str, str, str, str]:
    latex, meaning = (_without_digits(text) for text in (quantity.latex, quantity.meaning))
    return latex, meaning, quantity.unit, quantity.domain


def _without_digits(text: str) -> str:
    """Put letters for digits: components of one tensor then read alike."""
    letters = cycle(_LETTERS)
    return re.sub(r"\d", lambda _: next(letters), text)


def alphabetical(latex: str) -> tuple[bool, str, str]:
    """Sort Latin before Greek letters, and either by letter, whatever accents they carry."""
    bare = _ACCENTS.sub("", latex).replace(r"\ell", "l")
    greek = re.match(r"\\var(?=rho)|\\(?!sin|cos)", bare) is not None
    return greek, bare.lstrip("\\").removeprefix("var").casefold(), latex


def _place(members: Sequence[Quantity]) -> str:
    """The page on which a reader meets a symbol first, and the first numbered step there that shows it."""
    found = [place for quantity in members if (place := first_met(quantity))]
    if not found:
        return f"`{only_in(members[0])}`"
    page, step = min(found, key=lambda place: (pages().index(place[0]), place[1] is None))
    return step.link() if step else page_link(page)


def only_in(quantity: Quantity) -> str:
    """The derivation that uses a symbol which no page shows.

    Raises
    ------
    AssertionError
        No derivation uses it either; the page must not be built.
    """
    name = quantity.symbol.name
    users = [record for record, entry in records().items()
             if name in entry["symbols"] or any(name in step["symbols"] for step in entry["steps"])]
    assert users, f"{name} is declared, and no derivation uses it"
    return users[0]


def first_met(quantity: Quantity) -> tuple[str, Place | None] | None:
    """The first page, in the order of reading, whose text or steps show a symbol; else one whose derivation uses it."""
    name = quantity.symbol.name
    showing = [place for (record, step), place in steps_shown().items()
               if name in records()[record]["steps"][step - 1]["symbols"]]
    for page in pages():
        if page not in REFERENCE:
            steps = sorted(place.step for place in showing if place.page == page)
            if steps:
                return page, next(place for place in showing if place.page == page and place.step == steps[0])
            if _in_prose(quantity.latex, page):
                return page, None
    return _used(name)


def _in_prose(latex: str, page: str) -> bool:
    """Whether the text of a page shows a symbol in a formula; a single letter counts where conventions define it."""
    if is_name(latex):
        return any(stands_in(latex, formula) for formula in _formulas(page))
    return page == CONVENTIONS and any(is_defined(latex, formula) for formula in _formulas(page))


def _formulas(page: str) -> Iterable[str]:
    return (displayed or inline for displayed, inline in _MATH.findall(source(page)))


def _used(name: str) -> tuple[str, None] | None:
    places = [place.page for (record, _), place in steps_shown().items() if name in records()[record]["symbols"]]
    return (min(places, key=pages().index), None) if places else None
