"""The built book passes its gate: its files always, its pages on a screen where there is a Chromium."""

from __future__ import annotations

from pathlib import Path

import pytest
from gate.files import pages_of, problems_of_text
from inspect_book import problems_in_browser

pytestmark = pytest.mark.book


def test_files_of_the_book(built: Path) -> None:
    """Breaks on a load from another machine, a dead link, a repeated id, a picture without words."""
    assert problems_of_text(built, pages_of(built)) == []


def test_every_page_opens(built: Path, chromium: str) -> None:
    """Breaks on a formula that is not typeset, a script error, a lost file, text covered, cut or beyond the screen."""
    assert problems_in_browser(built, pages_of(built), chromium, kinds=("screen",)) == []
