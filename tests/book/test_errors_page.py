"""The page of refusals and the catalogue of refusals name the same codes, titles and classes."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from granular.errors import CATALOGUE, GranularError

SECTION = re.compile(r"^\(error-(g-[a-z]+-\d+)\)=\n#+ (.+)$", flags=re.MULTILINE)


@pytest.fixture(scope="module")
def sections(book: Path) -> dict[str, str]:
    """Heading of each labelled section by its code."""
    found = SECTION.findall((book / "errors.md").read_text(encoding="utf-8"))
    assert len(found) == len(dict(found)), "a code has two sections"
    return {code.upper(): heading for code, heading in found}


def test_every_code_has_a_section_and_every_section_a_code(sections: dict[str, str]) -> None:
    """Breaks when a refusal is added without telling readers about it, or removed and still explained."""
    assert set(sections) == {error.code for error in CATALOGUE}


@pytest.mark.parametrize("error", CATALOGUE, ids=lambda error: error.code)
def test_heading_says_code_and_title(error: type[GranularError], sections: dict[str, str]) -> None:
    """Breaks when a title changes in the library and the page goes on with the old one."""
    assert sections[error.code] == f"{error.code}: {error.title}"
