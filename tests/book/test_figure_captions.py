"""Every figure of a page has a caption for those who see it and words for those who do not."""

from __future__ import annotations

import ast
import importlib
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import yaml

BOOK = Path(__file__).resolve().parents[2] / "book"
PAGES = sorted(BOOK.glob("*.md"))
CELL = re.compile(r"^```\{code-cell\}[^\n]*\n(.*?)^```", flags=re.MULTILINE | re.DOTALL)
STILL, MOVING = "Static", ("Interactive", "Described")
SHORTEST = 40
"""Letters below which words say less than a figure shows."""


def cells(page: Path) -> Iterator[tuple[dict[str, Any], str, dict[str, Any]]]:
    """Settings and source of each cell, and the objects that its names stand for."""
    names: dict[str, Any] = {}
    for cell in CELL.findall(page.read_text(encoding="utf-8")):
        lines = cell.splitlines(keepends=True)
        start = next(place for place, line in enumerate([*lines, ""]) if not line.startswith(":"))
        source = "".join(lines[start:])
        for node in ast.walk(ast.parse(source)):
            if isinstance(node, ast.ImportFrom) and node.module:
                names |= {alias.asname or alias.name: _imported(node.module, alias.name) for alias in node.names}
        yield _settings(lines[:start]), source, names


def _settings(lines: list[str]) -> dict[str, Any]:
    """The mystnb block of a cell: lines that begin with a second colon hold indented settings."""
    text = "".join(line.removeprefix(":  ") for line in lines if line.startswith(":  "))
    return yaml.safe_load(re.sub(r"^( *)(caption|alt): (.*)$", _quoted, text, flags=re.MULTILINE)) or {}


def _quoted(match: re.Match[str]) -> str:
    words = match[3].replace("\\", "\\\\").replace('"', '\\"')
    return f'{match[1]}{match[2]}: "{words}"'


def _imported(module: str, name: str) -> Any:
    found = importlib.import_module(module)
    return getattr(found, name) if hasattr(found, name) else importlib.import_module(f"{module}.{name}")


def shown_kind(source: str, names: dict[str, Any]) -> str:
    """What the last line of a cell returns, by the annotation of the function that it calls."""
    last = ast.parse(source).body[-1]
    if not (isinstance(last, ast.Expr) and isinstance(last.value, ast.Call)):
        return ""
    called = ast.unparse(last.value.func).split(".")
    found = names.get(called[0])
    for part in called[1:]:
        found = getattr(found, part, None)
    return str(getattr(found, "__annotations__", {}).get("return", ""))


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_figures_have_captions_and_words(page: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Breaks when a figure has no name, caption or alternative text, or the same text for both."""
    monkeypatch.syspath_prepend(str(BOOK / "_ext"))
    for settings, source, names in cells(page):
        kind = shown_kind(source, names)
        assert not kind.endswith("Interactive") or settings, f"{source}: wrap it in Described, with words"
        if not kind.endswith(STILL):
            continue
        figure, image = settings.get("figure", {}), settings.get("image", {})
        assert str(figure.get("name", "")).startswith("fig-"), source
        caption, alt = str(figure.get("caption", "")).strip(), str(image.get("alt", "")).strip()
        assert len(caption) >= SHORTEST, f"{source}: a caption that states the finding"
        assert caption.endswith("."), caption
        assert len(alt) >= SHORTEST, f"{source}: alternative text that says what is seen"
        assert alt.rstrip(".").casefold() not in caption.casefold(), "alternative text that repeats the caption"
        assert "$" not in alt, f"a formula is read out sign by sign: {alt}"


def test_names_of_figures_are_used_once() -> None:
    """Breaks when two figures share a name: a reference would go to either."""
    found = [name for page in PAGES for name in re.findall(r"^:    name: (fig-\S+)$", page.read_text(encoding="utf-8"),
                                                            flags=re.MULTILINE)]
    assert sorted(found) == sorted(set(found))


def test_the_check_knows_figures() -> None:
    """Breaks when figures are not recognised any more, and the check above passes on nothing."""
    assert len([1 for page in PAGES if re.search(r"^:    name: fig-", page.read_text(encoding="utf-8"), re.MULTILINE)]
               ) > 15
