"""Entries of the reference: every name with its signature and its docstring, as objects that pages can refer to."""

from __future__ import annotations

import inspect
from collections.abc import Iterable, Iterator
from enum import Enum
from types import FunctionType
from typing import Any, cast

from page_tools.markup import Markup, plain, table
from page_tools.reference_names import GROUPS, explained
from page_tools.reference_text import items, prose, refusals, role, sections, typed

LONGEST = 24
"""Characters of a default value that is still shown in a signature."""


def entries(group: str) -> Markup:
    """Everything that the reference says about the names of a group."""
    about = GROUPS[group]
    return Markup("\n\n".join([*(entry(name) for name in about.names),
                               *(entry(name, built=False) for name in about.returned)]))


def index(*pages: str) -> Markup:
    """Every name of some pages with the first sentence about it, by what it is for."""
    rows = []
    for about in GROUPS.values():
        if about.page in pages:
            rows.append([f"**{plain(about.title)}**", ""])
            rows += [[role(name, name.removeprefix("granular.")), prose(_first_sentence(name))]
                     for name in (*about.names, *about.returned)]
    what = "derivations" if pages == ("python_derivations",) else "granular"
    return table(["name", "what it is"], rows, label=f"tab-python-{what}", look="reference",
                 caption=f"Names of `{what}`, by what they are for.")


def _first_sentence(name: str) -> str:
    return sections(inspect.getdoc(explained()[name]) or "")[""].partition("\n\n")[0]


def entry(name: str, *, built: bool = True) -> str:
    """A function or a class, as an object of the Python domain of Sphinx."""
    thing = explained()[name]
    kind = "class" if isinstance(thing, type) else "function"
    canonical = f"{getattr(thing, '__module__', '')}.{getattr(thing, '__qualname__', '')}"
    options = f":canonical: {canonical}\n" if canonical != name else ""
    call = signature(thing) if built and not _is_enumeration(thing) else ""
    body = [*_body(inspect.getdoc(thing) or ""), *(_members(thing) if isinstance(thing, type) else [])]
    text = "\n\n".join(body)
    return f"::::::{{py:{kind}}} {name}{call}\n{options}\n{text}\n\n::::::"


def _is_enumeration(thing: object) -> bool:
    return isinstance(thing, type) and issubclass(thing, Enum)


def signature(thing: Any) -> str:
    """Arguments with their defaults; types stand below, with shapes and units."""
    found = inspect.signature(thing)
    kept = [_bare(argument) for argument in found.parameters.values() if argument.name not in ("self", "cls")]
    return str(inspect.Signature(kept))


class _Text:
    """A default value as it is shown."""

    def __init__(self, value: object) -> None:
        text = repr(value.value) if isinstance(value, Enum) else repr(value)
        self.text = text if len(text) <= LONGEST and "<" not in text else "..."

    def __repr__(self) -> str:
        return self.text


def _bare(argument: inspect.Parameter) -> inspect.Parameter:
    default = argument.default
    return argument.replace(annotation=argument.empty,
                            default=default if default is argument.empty else _Text(default))


def _body(doc: str) -> Iterator[str]:
    """Sections of a docstring in the order of the house: meaning, arguments, returns, accuracy, raises, source."""
    found = sections(doc)
    yield prose(found.get("", ""))
    for title in ("Parameters", "Attributes", "Returns", "Yields"):
        if title in found:
            yield f"**{title}**\n\n" + "\n\n".join(
                f"{_head(head, title)}\n: {prose(body) or '&nbsp;'}" for head, body in items(found[title]))
    for title in found:
        if title.startswith(("Accuracy", "Cost")):
            yield f"**{title}:** {prose(found[title])}"
    if "Raises" in found:
        yield "**Raises**\n\n" + "\n\n".join(f"{refusals(head)}\n: {prose(body) or '&nbsp;'}"
                                             for head, body in items(_joined(found["Raises"])))
    if "Notes" in found:
        yield f"**Notes:** {prose(found['Notes'])}"
    if "Source" in found:
        yield f"**Source:** {prose(found['Source'])}"
    if "Examples" in found:
        yield f"```pycon\n{inspect.cleandoc(found['Examples'])}\n```"


def _head(head: str, title: str) -> str:
    name, colon, kind = head.partition(" : ")
    if title in ("Returns", "Yields") and not colon:
        return typed(head)
    names = ", ".join(f"`{one.strip()}`" for one in name.split(","))
    return f"{names}: {typed(kind)}" if colon else names


def _joined(text: str) -> str:
    """Names of exceptions that run over the end of a line, on one line."""
    return text.replace(",\n", ", ")


def _members(kind: type) -> Iterator[str]:
    """Public members of a class that its docstring does not list already, in the order of their definition."""
    if _is_enumeration(kind):
        for value in cast("Iterable[Enum]", kind):
            yield f":::::{{py:attribute}} {value.name}\n:value: {value.value!r}\n\n:::::"
        return
    found = sections(inspect.getdoc(kind) or "")
    told = {one.strip() for title in ("Parameters", "Attributes") for head, _ in items(found.get(title, ""))
            for one in head.partition(" : ")[0].split(",")}
    for name, member in members(kind).items():
        if name not in told:
            yield _member(name, member)


def members(kind: type) -> dict[str, Any]:
    """Methods and properties of a class and of those that it is made from, within this project."""
    found: dict[str, Any] = {}
    for owner in reversed(kind.__mro__):
        if owner.__module__.split(".")[0] in ("granular", "derivations"):
            found |= {name: member for name, member in vars(owner).items()
                      if not name.startswith("_")
                      and isinstance(member, FunctionType | classmethod | staticmethod | property)}
    return found


def _member(name: str, member: Any) -> str:
    if isinstance(member, property):
        return _object("property", name, "", inspect.getdoc(member) or "")
    function = member.__func__ if isinstance(member, classmethod | staticmethod) else member
    option = (":classmethod:\n" if isinstance(member, classmethod)
              else ":staticmethod:\n" if isinstance(member, staticmethod) else "")
    return _object("method", name + signature(function), option, inspect.getdoc(function) or "")


def _object(kind: str, head: str, options: str, doc: str) -> str:
    text = "\n\n".join(_body(doc))
    return f":::::{{py:{kind}}} {head}\n{options}\n{text}\n\n:::::"
