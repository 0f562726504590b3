"""Pages are prose around thin cells: no loop, no physics, nothing from another machine."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest
import yaml

BOOK = Path(__file__).resolve().parents[2] / "book"
PAGES = sorted(BOOK.glob("*.md"))
CELL = re.compile(r"^```\{code-cell\}[^\n]*\n(.*?)^```", flags=re.MULTILINE | re.DOTALL)
MOST_LINES = 6
MAY_IMPORT = {"granular", "derivations", "IPython", "matplotlib", "page_tools"}
COMPUTING = (ast.For, ast.While, ast.FunctionDef, ast.ClassDef, ast.ListComp, ast.DictComp, ast.SetComp,
             ast.GeneratorExp)
OPTIONS = re.compile(r"\A(?:^:[^\n]*\n)*", flags=re.MULTILINE)

pytestmark = pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)


def cells(page: Path) -> list[str]:
    """Python source of each code cell of a page, without its options."""
    return [OPTIONS.sub("", cell) for cell in CELL.findall(page.read_text(encoding="utf-8"))]


def test_cells_are_thin(page: Path) -> None:
    """Breaks when a cell computes instead of calling: seven lines, a loop or a definition."""
    for source in cells(page):
        lines = [line for line in source.splitlines() if line.strip()]
        assert len(lines) <= MOST_LINES, source
        assert not [node for node in ast.walk(ast.parse(source)) if isinstance(node, COMPUTING)], source


def test_cells_import_the_library_only(page: Path) -> None:
    """Breaks when a page imports NumPy, SymPy or anything else that would bring physics into a cell."""
    for source in cells(page):
        for node in ast.walk(ast.parse(source)):
            names = [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
            names += [node.module or ""] if isinstance(node, ast.ImportFrom) else []
            assert {name.partition(".")[0] for name in names} <= MAY_IMPORT, source


def test_folded_never_absent(page: Path) -> None:
    """Breaks when a cell is hidden for good: a reader must be able to see what made every number."""
    assert not re.search(r"remove-(input|cell)", page.read_text(encoding="utf-8"))


def test_nothing_comes_from_another_machine(page: Path) -> None:
    """Breaks when a page shows a picture, frame or script by its web address."""
    text = page.read_text(encoding="utf-8")
    assert not re.search(r"(?:!\[[^\]]*\]\(|src=[\"']?|\{(?:image|figure|iframe)\}\s*)(?:https?:)?//", text)


def test_page_is_in_the_contents(page: Path) -> None:
    """Breaks when a page is written and never listed in _toc.yml, where it would not be built."""
    contents = yaml.safe_load((BOOK / "_toc.yml").read_text(encoding="utf-8"))
    chapters = [chapter["file"] for part in contents["parts"] for chapter in part["chapters"]]
    assert page.stem in [contents["root"], *chapters]
