"""Docstrings as pages show them: sections, and prose with links to what it names."""

from __future__ import annotations

import importlib
import re
from functools import cache
from types import ModuleType

from granular import errors
from granular.sweeps.scene_fields import table_types
from page_tools.contents import page_link
from page_tools.emitted import PAGE_OF
from page_tools.ledger import derived
from page_tools.markup import plain
from page_tools.reference_names import explained, name_of

_TITLE = re.compile(r"^(\S[^\n]*)\n-{3,}\n", flags=re.MULTILINE)
_OWN = re.compile(r"(?:^|(?<=[.;] ))(Accuracy|Source|Cost[^:.]{0,60}): ")
_LOWERED = re.compile(r"\b([A-Za-z])\\_([A-Za-z0-9]{1,4}(?:,[a-z]+)?)(?![A-Za-z0-9])")
_RAISED = re.compile(r"(?<=\w)\^(?:(-?\d+|[a-z]+(?![\w\\]))|\(([-+/\w]+)\))")
_NUMBER = re.compile(r"\((\d+)\)")
_CITED = r"\b[Ee]qs?\.? \(\d+\)(?:(?:, and |, | and |-)\(\d+\))*"
_LINKED = re.compile(rf":\w+:`~?[^`]+`|``[^`]+``|{_CITED}")
_CLASS = re.compile(r"\b[A-Z]\w+\b")
_QUOTED = re.compile(r'"([^"\s`]+(?: [^"\s`]+)?)"')


def sections(doc: str) -> dict[str, str]:
    """Text of each section of a docstring by its title; what stands before the first one has the title ''.

    ``Accuracy`` and ``Source`` have sections of their own, whether the docstring gives them one or begins a sentence
    of its notes with the word.
    """
    parts = _TITLE.split(doc)
    found = {"": parts[0], **dict(zip(parts[1::2], parts[2::2], strict=True))}
    kept, *own = _OWN.split(" ".join(found.pop("Notes", "").split()))
    for title, text in (("Notes", kept), *zip(own[::2], own[1::2], strict=True)):
        found[title] = f"{found.get(title, '')} {text}"
    return {title: text.strip("\n ") for title, text in found.items() if text.strip()}


def items(text: str) -> list[tuple[str, str]]:
    """Heads of a section such as ``Parameters``, each with the indented text below it."""
    found: list[tuple[str, list[str]]] = []
    for line in text.splitlines():
        if line.strip() and not line.startswith(" "):
            found.append((line.strip(), []))
        elif found:
            found[-1][1].append(line.strip())
    return [(head, " ".join(body).strip()) for head, body in found]


def prose(text: str) -> str:
    """Text of a docstring as MyST: paragraphs, code, links to what is named and to the equations."""
    paragraphs = re.split(r"\n\s*\n", text.replace("\\|", "|"))
    return "\n\n".join(_inline(" ".join(paragraph.split())) for paragraph in paragraphs)


def _inline(text: str) -> str:
    shown, end = [], 0
    for mark in _LINKED.finditer(text):
        shown.append(_typeset(text[end:mark.start()]))
        shown.append(_cited(mark[0]) if not mark[0].endswith("`") else _code(mark[0]))
        end = mark.end()
    return "".join([*shown, _typeset(text[end:])])


def _typeset(text: str) -> str:
    """Plain text with its powers raised and the indices of single letters lowered."""
    lowered = _LOWERED.sub(r"\1{sub}`\2`", quoted(text))
    return _RAISED.sub(lambda power: f"{{sup}}`{(power[1] or power[2]).replace('-', '−')}`", lowered)


def quoted(text: str) -> str:
    """Plain text; values between quotation marks are code."""
    shown, end = [], 0
    for value in _QUOTED.finditer(text):
        shown += [plain(text[end:value.start()]), f"`{value[0]}`"]
        end = value.end()
    return "".join([*shown, plain(text[end:])])


def _cited(text: str) -> str:
    """Numbers of equations as links to the pages on which they are derived."""
    return _NUMBER.sub(lambda number: _equation(number[0]), text.replace("-(", "–("))


@cache
def _equation(place: str) -> str:
    found = derived(place)
    if found is None:
        return place
    page = found[1].page if found[1] else PAGE_OF.get(found[0], "ledger")
    return f"[{place}]({page}.md)"


def _code(marked: str) -> str:
    """A name in code, as a link where the reference or another page explains it."""
    name = marked.strip("`").partition(":`")[2] if marked.startswith(":") else marked.strip("`")
    name = name.lstrip("~")
    target = _target(name)
    if target is not None:
        return role(target, name)
    package, _, derivation = name.partition(".")
    if package == "derivations" and derivation in PAGE_OF:
        return f"`{name}` ({page_link(PAGE_OF[derivation])})"
    return f"`{name}`"


@cache
def _target(name: str) -> str | None:
    """The explained name behind a dotted one, however it is imported."""
    if name in explained():
        return name
    parts = name.split(".")
    if len(parts) < 2 or parts[0] not in ("granular", "derivations"):
        return None
    try:
        thing = importlib.import_module(parts[0])
        for place, part in enumerate(parts[1:], start=2):
            thing = getattr(thing, part, None) or importlib.import_module(".".join(parts[:place]))
    except ImportError:
        return None
    return None if isinstance(thing, ModuleType) else name_of(id(thing))


def role(target: str, shown: str = "") -> str:
    """A link to the entry of an explained name."""
    kind = "class" if isinstance(explained()[target], type) else "func"
    return f"{{py:{kind}}}`{shown or target} <{target}>`"


@cache
def _classes() -> dict[str, str]:
    return {name.rpartition(".")[2]: name for name, thing in explained().items() if isinstance(thing, type)}


@cache
def _of_type(name: str) -> str | None:
    """Link to a class, or to a table of the scene file; None for any other word."""
    if name in _classes():
        return role(_classes()[name], name)
    tables = {kind.__name__: table for table, kind in table_types().items()}
    return f"{{ref}}`{name} <sec-scene-table-{tables[name]}>`" if name in tables else None


def typed(text: str) -> str:
    """What a value is: its type, linked where the reference explains it."""
    shown, end = [], 0
    for word in _CLASS.finditer(text):
        if (link := _of_type(word[0])) is not None:
            shown += [quoted(text[end:word.start()]), link]
            end = word.end()
    return "".join([*shown, quoted(text[end:])])


def refusals(text: str) -> str:
    """Names of exceptions, each a link to its section of the page of refusals."""
    return ", ".join(_refusal(name) for name in re.split(r",\s*", text.strip().rstrip(",")))


def _refusal(name: str) -> str:
    kind = getattr(errors, name, None)
    if kind is errors.GranularError:
        return role("granular.GranularError", name)
    return f"{{ref}}`{name} <error-{kind.code.lower()}>`" if kind is not None else f"`{name}`"
