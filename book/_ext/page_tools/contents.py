"""What stands where in the book: pages in order, their titles, and the page that shows each step of a derivation."""

from __future__ import annotations

import ast
import json
import re
from functools import cache
from pathlib import Path
from typing import NamedTuple, TypedDict, cast

import yaml

BOOK = Path(__file__).resolve().parents[2]

_CELL = re.compile(r"^```\{code-cell\}[^\n]*\n(.*?)^```", flags=re.MULTILINE | re.DOTALL)
_OPTIONS = re.compile(r"\A(?:^:[^\n]*\n)*", flags=re.MULTILINE)


class StepEntry(TypedDict):
    """A step as ``derivations write`` notes it."""

    title: str
    named: list[int]
    cited: list[int]
    symbols: list[str]


class RecordEntry(TypedDict):
    """A derivation as ``derivations write`` notes it."""

    sources: list[str]
    symbols: list[str]
    steps: list[StepEntry]


class Place(NamedTuple):
    """A step of a derivation, counted from 1, and the page that shows it."""

    record: str
    step: int
    page: str

    def link(self) -> str:
        """Its equation and its page, as markup."""
        return f"{{eq}}`eq-{self.record.replace('_', '-')}-{self.step}` {page_link(self.page)}"


@cache
def pages() -> tuple[str, ...]:
    """Names of all pages in the order in which they are read."""
    contents = yaml.safe_load((BOOK / "_toc.yml").read_text(encoding="utf-8"))
    return contents["root"], *(chapter["file"] for part in contents["parts"] for chapter in part["chapters"])


@cache
def source(page: str) -> str:
    """Text of a page as it is written."""
    return (BOOK / f"{page}.md").read_text(encoding="utf-8")


def page_link(page: str) -> str:
    """Link to a page by its title, which is cut where it begins to explain itself."""
    found = re.search(r"^# (.+)$", source(page), flags=re.MULTILINE)
    assert found is not None, f"{page}.md has no title"
    return f"[{found[1].partition(':')[0]}]({page}.md)"


@cache
def records() -> dict[str, RecordEntry]:
    """All derivations in the order in which they build on one another, from what ``derivations write`` notes."""
    text = (BOOK / "_formulas" / "steps.json").read_text(encoding="utf-8")
    return cast("dict[str, RecordEntry]", json.loads(text))


@cache
def steps_shown() -> dict[tuple[str, int], Place]:
    """The first page that shows a step with a number to refer to, by derivation and step."""
    shown: dict[tuple[str, int], Place] = {}
    for page in pages():
        for cell in _CELL.findall(source(page)):
            for node in ast.walk(ast.parse(_OPTIONS.sub("", cell))):
                if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "steps":
                    name, first, last = _steps_called(node)
                    for step in range(first, last + 1):
                        shown.setdefault((name, step), Place(name, step, page))
    return shown


def _steps_called(call: ast.Call) -> tuple[str, int, int]:
    name = ast.literal_eval(call.args[0])
    given = {keyword.arg: ast.literal_eval(keyword.value) for keyword in call.keywords}
    return name, given.get("first", 1), given.get("last") or len(records()[name]["steps"])
