"""The figures of the built book: drawn ones can be read, interactive ones answer.

A file of its own, so that it runs beside the test that opens every page.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from gate.files import pages_of
from inspect_book import problems_in_browser

pytestmark = pytest.mark.book


def test_words_of_drawn_figures(built: Path, chromium: str) -> None:
    """Breaks when words of a figure lie over each other or leave it."""
    assert problems_in_browser(built, pages_of(built), chromium, kinds=("drawings",)) == []


def test_figures_answer(built: Path, chromium: str) -> None:
    """Breaks when a slider, button, legend, point or surface does not answer a click, or a picture does not grow."""
    assert problems_in_browser(built, pages_of(built), chromium, kinds=("answers",)) == []
