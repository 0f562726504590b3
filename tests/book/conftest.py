"""Give the book's tests its folders and its extensions."""

from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path
from typing import NoReturn

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "book" / "_ext"), str(Path(__file__).parent)]


@pytest.fixture(scope="session")
def root() -> Path:
    return ROOT


@pytest.fixture(scope="session")
def book(root: Path) -> Path:
    return root / "book"


def missing(what: str) -> NoReturn:
    """Skip where something is not there; fail where CI asked for it to be there."""
    if os.environ.get("GRANULAR_REQUIRE_BROWSER") == "1":
        pytest.fail(what)
    pytest.skip(what)


@pytest.fixture(scope="session")
def chromium() -> str:
    return shutil.which("chromium") or missing("Chromium is not installed, so no page was opened in a browser")


@pytest.fixture(scope="session")
def built(book: Path) -> Path:
    pages = book / "_build" / "html"
    return pages if (pages / "index.html").exists() else missing("the book is not built; run `make book` first")
