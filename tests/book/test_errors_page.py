"""The page of refusals and the catalogue of refusals name the same codes, titles and classes."""

from __future__ import annotations

import inspect
import re
from pathlib import Path

import pytest

from granular.errors import CATALOGUE, GranularError

SECTION = re.compile(r"^\(error-(g-[a-z]+-\d+)\)=\n#+ (.+)$", flags=re.MULTILINE)
CELL = re.compile(r"^```\{code-cell\}.*?^```$", flags=re.MULTILINE | re.DOTALL)
FEWEST_WORDS = 10
"""What can be said of a refusal in one sentence."""


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


@pytest.fixture(scope="module")
def bodies(book: Path) -> dict[str, str]:
    """Text of each labelled section by its code, up to the next section or part."""
    _, *parts = re.split(r"^\(error-(g-[a-z]+-\d+)\)=\n#+ .+$", (book / "errors.md").read_text(encoding="utf-8"),
                         flags=re.MULTILINE)
    return {code.upper(): body.split("\n## ")[0] for code, body in zip(parts[::2], parts[1::2], strict=True)}


@pytest.mark.parametrize("error", CATALOGUE, ids=lambda error: error.code)
def test_section_explains_and_shows(error: type[GranularError], bodies: dict[str, str]) -> None:
    """Breaks when a section has no words of its own, or no message of its refusal that a cell provokes."""
    assert f'refused("{error.code}", ' in "".join(CELL.findall(bodies[error.code]))
    assert len(CELL.sub("", bodies[error.code]).split()) >= FEWEST_WORDS


@pytest.mark.parametrize("error", CATALOGUE, ids=lambda error: error.code)
def test_remedy_is_part_of_every_message(error: type[GranularError]) -> None:
    """Breaks when a refusal can be raised without telling what to do."""
    assert inspect.signature(error.__init__).parameters["remedy"].default is inspect.Parameter.empty
