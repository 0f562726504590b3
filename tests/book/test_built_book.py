"""The built book passes its gate: its files always, its pages on a screen where there is a Chromium."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.book


def inspect(book: Path, built: Path, *options: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, str(book / "_ext" / "inspect_book.py"), str(built), *options],
                          capture_output=True, text=True, check=False)


def test_files_of_the_book(book: Path, built: Path) -> None:
    """Breaks on a load from another machine, a dead link, a repeated id, a picture without words."""
    outcome = inspect(book, built)
    assert outcome.returncode == 0, outcome.stdout + outcome.stderr


def test_every_page_opens(book: Path, built: Path, chromium: str) -> None:
    """Breaks on a formula that is not typeset, a script error, a lost file, a page wider than a phone."""
    outcome = inspect(book, built, "--browser", chromium)
    assert outcome.returncode == 0, outcome.stdout + outcome.stderr
