"""Words that readers see are spelt as in Britain: pages, captions, docstrings, messages, help and the front page."""

from __future__ import annotations

from pathlib import Path

import pytest
from prose import lines
from spelling import OWN_WORDS, is_word, misspelt, own_words, said_in_code, words

ROOT = Path(__file__).resolve().parents[2]
PAGES = sorted((ROOT / "book").glob("*.md"))
FOLDERS = ("granular", "derivations", "book/_ext")
"""Generated files say nothing of their own: what they quote stands in the derivations."""


def programs(folder: str) -> list[Path]:
    """Every Python file of a folder that somebody wrote."""
    return sorted(path for path in (ROOT / folder).rglob("*.py") if "generated" not in path.parts)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_pages(page: Path) -> None:
    """Breaks on a misspelt word in a page, a caption or the words for those who cannot see a figure."""
    assert misspelt(line.words for line in lines(page)) == []


def test_front_page() -> None:
    """Breaks on a misspelt word in the README."""
    assert misspelt([(ROOT / "README.md").read_text(encoding="utf-8")]) == []


@pytest.mark.parametrize("folder", FOLDERS)
def test_docstrings_messages_and_help(folder: str) -> None:
    """Breaks on a misspelt word in what a program says: reference, refusals, help, captions and sentences of cells."""
    found = {path.relative_to(ROOT).as_posix(): wrong
             for path in programs(folder) if (wrong := misspelt(said_in_code(path)))}
    assert found == {}


def test_own_words_are_sorted_and_needed() -> None:
    """Breaks when the list of the project's words is out of order, or holds what nobody says any more."""
    listed = OWN_WORDS.read_text(encoding="utf-8").split()
    assert listed == sorted(set(listed), key=lambda word: (word.lower(), word))
    texts = [(ROOT / "README.md").read_text(encoding="utf-8")]
    texts += [line.words for page in PAGES for line in lines(page)]
    texts += [text for folder in FOLDERS for path in programs(folder) for text in said_in_code(path)]
    stems = {word.replace("’", "'").removesuffix("'s") for text in texts for word in words(text)}
    assert own_words() <= stems | {word.lower() for word in stems}, "nobody says it any more"


@pytest.mark.parametrize("wrong", [
    "stifness", "recieved", "colour's center", "normalize", "behavior", "modeling", "fulfill", "anisotrpy", "the teh"])
def test_misspellings_are_found(wrong: str) -> None:
    """Breaks when a slip of the keys or an American form passes."""
    assert misspelt([wrong])


@pytest.mark.parametrize("right", [
    "colour of the centre", "normalise", "modelling behaviour", "analyse", "the packing's fabric tensors are traceless",
    "`centr` and $\\mathrm{frct}$ are no words, and neither is --rtol nor C1111", "28 kPa and 3 GPa"])
def test_british_prose_passes(right: str) -> None:
    """Breaks when the check takes code, formulas, units or British forms for mistakes."""
    assert misspelt([right]) == []


def test_symbols_are_not_checked() -> None:
    """Breaks when one or two letters are taken for a word."""
    assert is_word("dx")
