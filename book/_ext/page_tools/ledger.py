"""Coverage ledger: where each place of the paper is derived, shown, computed and tested, and what became of it."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cache

from page_tools.citations import citing, computing, documented
from page_tools.contents import BOOK, Place, page_link, pages, records, source, steps_shown
from page_tools.ledger_record import ENTRIES, EQUATIONS, FIGURES, TABLES, TEXT, Entry, Verdict
from page_tools.markup import Markup, boxed, table

TESTS = BOOK.parent / "tests"
HEADER = ("place", "says", "derived and shown", "computed", "tested", "verdict")


def derived(place: str) -> tuple[str, Place | None] | None:
    """The derivation behind a place of the paper, and the step to refer to where a page shows one.

    A step that names the place in its title goes before one that cites it in its reason, and either before a
    derivation that only lists it among its sources.
    """
    number = int(place[1:-1]) if place.startswith("(") else 0
    sourced = {name: entry for name, entry in records().items()
               if any(source.startswith(place) for source in entry["sources"])}
    for named in (True, False):
        for name, entry in sourced.items():
            for step, about in enumerate(entry["steps"], start=1):
                cites = about["named"] if named else about["cited"]
                if number in cites and (name, step) in steps_shown():
                    return name, steps_shown()[name, step]
    first = next(iter(sourced), None)
    return (first, None) if first else None


def ledger() -> Markup:
    """Every place of the paper in one table.

    Raises
    ------
    AssertionError
        Something that the record names does not exist; the page must not be built.
    """
    found = faults()
    assert not found, "; ".join(found)
    rows = [[_place(entry), entry.says, _shown(entry), _computed(entry), f"`{_file(entry)}`", _rulings(entry)]
            for entry in ENTRIES]
    taken = [["place", "says", "derivation", "computed", "all that cite it", "tested", "verdict"],
             *([entry.place, entry.says, (derived(entry.place) or ("", None))[0], " ".join(entry.computed),
                " ".join(sorted(citing().get(entry.place, ()))), f"tests/{entry.tested}",
                ", ".join(verdict.words for verdict, _ in entry.rulings)] for entry in ENTRIES)]
    return table(HEADER, rows, label="tab-ledger", look="ledger", take_away="ledger.csv", taken=taken,
                 caption="Equations, tables and figures of the paper, and what its text claims.")


def counted() -> Markup:
    """Box what the ledger covers, and how many places are judged against the print."""
    against = {Verdict.MISPRINT, Verdict.REFUTED}
    places = sum(any(verdict in against for verdict, _ in entry.rulings) for entry in ENTRIES)
    return boxed("What the ledger covers", Markup(
        f"All {len(EQUATIONS)} equations, {len(TABLES)} tables and {len(FIGURES)} figures of the paper, and "
        f"{len(TEXT)} statements of its text. At {places} of these {len(ENTRIES)} places the print is wrong, or a "
        "claim does not follow. The others stand, some of them with a remark."))


def verdicts() -> Markup:
    """What the verdicts mean, and how many places have each."""
    rows = [[verdict.words, verdict.meaning,
             str(sum(verdict in [given for given, _ in entry.rulings] for entry in ENTRIES))] for verdict in Verdict]
    return table(["verdict", "meaning", "places"], rows, label="tab-ledger-verdicts", align="llr",
                 caption="Verdicts of the ledger. A place can have two.")


def faults() -> list[str]:
    """What the record names and is not there, in words; nothing if all is well."""
    return [f"{entry.place}: {fault}" for entry in ENTRIES for fault in _faults(entry)]


def _faults(entry: Entry) -> Iterator[str]:
    if not entry.shown and derived(entry.place) is None:
        yield "no derivation has it among its sources, and no page shows it"
    for name in entry.computed:
        if name not in documented():
            yield f"there is no {name}"
        elif entry.place.startswith("(") and name not in citing()[entry.place]:
            yield f"the docstring of {name} does not cite it"
    if not entry.computed and computing(entry.place):
        yield f"it is computed by {', '.join(sorted(computing(entry.place)))}"
    if not _is_tested(entry):
        yield f"there is no test {entry.tested}"
    page, _, label = entry.shown.partition(":")
    if page and page not in pages():
        yield f"there is no page {page}"
    elif label.startswith("fig-") and f"name: {label}\n" not in source(page):
        yield f"{page}.md shows no {label}"
    for _, label in entry.rulings:
        if label and page_of_section(label) is None:
            yield f"no page has a section {label}"


@cache
def page_of_section(label: str) -> str | None:
    """The page that has a section of that label."""
    return next((page for page in pages() if f"({label})=\n" in source(page)), None)


def _is_tested(entry: Entry) -> bool:
    file, _, function = entry.tested.partition("::")
    path = TESTS / file
    if not path.is_file():
        return False
    return any(isinstance(node, ast.FunctionDef) and node.name == function
               for node in ast.parse(path.read_text(encoding="utf-8")).body)


def _file(entry: Entry) -> str:
    return entry.tested.partition("::")[0].removeprefix("granular/").removesuffix(".py")


def _place(entry: Entry) -> str:
    return "below (23)" if entry.place.startswith("N_ij") else entry.place


def _shown(entry: Entry) -> str:
    page, _, label = entry.shown.partition(":")
    if page:
        return f"{{numref}}`{label}` {page_link(page)}" if label else page_link(page)
    found = derived(entry.place)
    assert found is not None
    name, place = found
    first = place or next(place for (record, _), place in steps_shown().items() if record == name)
    return first.link() if place else page_link(first.page)


def _computed(entry: Entry) -> str:
    """Module and name of each function, without what stands before them, and how many more cite the place."""
    names = [f"`{'.'.join(name.split('.')[-2:])}`" for name in entry.computed]
    others = len(computing(entry.place) - set(entry.computed))
    return " ".join([*names, f"and {others} more"] if names and others else names) or "–"


def _rulings(entry: Entry) -> str:
    return "<br>".join(f"{{ref}}`{verdict.words} <{label}>`" if label else verdict.words
                       for verdict, label in entry.rulings)
