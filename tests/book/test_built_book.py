"""The built book passes its gate: its files always, its pages on a screen where there is a Chromium."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.book
REQUIRED = os.environ.get("GRANULAR_REQUIRE_BROWSER") == "1"


@pytest.fixture(scope="module")
def built(book: Path) -> Path:
    pages = book / "_build" / "html"
    if not (pages / "index.html").exists():
        why = "the book is not built; run `make book` first"
        pytest.fail(why) if REQUIRED else pytest.skip(why)
    return pages


def inspect(book: Path, built: Path, *options: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, str(book / "_ext" / "inspect_book.py"), str(built), *options],
                          capture_output=True, text=True, check=False)


def test_files_of_the_book(book: Path, built: Path) -> None:
    """Breaks on a load from another machine, a dead link, a repeated id, a picture without words."""
    outcome = inspect(book, built)
    assert outcome.returncode == 0, outcome.stdout + outcome.stderr


def test_every_page_opens(book: Path, built: Path) -> None:
    """Breaks on a formula that is not typeset, a script error, a lost file, a page wider than a phone."""
    browser = shutil.which("chromium")
    if browser is None:
        why = "Chromium is not installed, so the pages were not opened in a browser"
        pytest.fail(why) if REQUIRED else pytest.skip(why)
    outcome = inspect(book, built, "--browser", browser)
    assert outcome.returncode == 0, outcome.stdout + outcome.stderr
