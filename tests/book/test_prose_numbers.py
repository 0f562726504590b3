"""Numbers in prose come from cells: a typed one names something, is exact, or is listed with its reason."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import pytest
from prose import Line, lines

BOOK = Path(__file__).resolve().parents[2] / "book"
PAGES = sorted(BOOK.glob("*.md"))
LIST = Path(__file__).parent / "typed_numbers.toml"

_SEVERAL = r"\d+[a-z]?(?:(?:, | and | to | or |–)\d+)*"
NAMES = {
    "equation": r"\(\d+\)",
    "part of the paper or of the page": (
        r"\b(?:[Tt]ables?|[Ff]igures?|[Cc]urves?|[Cc]ases?|[Ss]teps?|[Aa]x[ie]s|indices|index|atom|grain) " + _SEVERAL),
    "heading of a step": r"^#+ \d+\.",
    "code of a refusal": r"\bG-[A-Z]{3}-\d\d\b",
    "name that holds a digit": r"\b[A-Z][A-Za-z]*\d\w*",
    "pairs of indices": r"\b[1-3]{2}(?:, [1-3]{2})+",
    "exit code": r"\b[Ee]xit code \d\b",
    "the paper's rule": r"\b24[ -]panels?\b",
    "components of an elastic tensor": r"\b(?:21|81)\b(?=[,.]| components)",
    "shape of a matrix": r"\b\d × \d\b",
    "nought and one": r"(?<![\d.,])[-−]?[01](?![\d.]*\d|[/e])",
    "right angle and its half": r"\b(?:45|90|180)(?:°| degrees)",
    "share of an interval": r"\b(?:68|95) %",
}
"""Numbers that name something, or are what they are by definition."""
NUMBER = re.compile(r"\d[\d.,/]*(?:e[-−+]?\d+)?")
MEASURED_IN_FORMULA = re.compile(r"\d\.\d|10\^|(?<![_{\d])\d{4,}")
"""Integers and fractions in a formula belong to it; decimals and powers of ten are results or settings."""
_COUNT = "(?:two|three|four|five|six|seven|eight|nine|ten|twelve|twenty|thirty|fifty|a hundred|a thousand|a million)"
IN_WORDS = re.compile(
    r"\b(?:an?|one|two|three|nine) (?:quarter|fifth|sixth|seventh|eighth|ninth|tenth|twentieth|\w*hundredth"
    rf"|\w*thousandth|\w*millionth)s?\b|\bfactor of (?:about |nearly )?{_COUNT}\b"
    rf"|\b{_COUNT} times (?:as|more|the|larger|smaller)\b"
    rf"|\b(?:{_COUNT}|half a|a) per ?cent\b|\b{_COUNT} (?:digits|orders of magnitude)\b")
"""Sizes that are said in words were measured, too."""


def allowed() -> dict[str, dict[str, str]]:
    """Reason of each phrase by page; the page ``everywhere`` holds for all."""
    return tomllib.loads(LIST.read_text(encoding="utf-8"))


def typed_numbers(line: Line, phrases: dict[str, str]) -> list[str]:
    """Every number of a line that nothing excuses."""
    words = line.words
    for excused in phrases:
        words = words.replace(excused, "")
    for name in NAMES.values():
        words = re.sub(name, "", words)
    formulas = [formula for formula in line.formulas
                if MEASURED_IN_FORMULA.search(formula) and not any(excused in formula for excused in phrases)]
    return NUMBER.findall(words) + IN_WORDS.findall(words) + formulas


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_numbers_come_from_cells(page: Path) -> None:
    """Breaks when a measured number is typed into a page, where nothing would ever correct it."""
    listed = allowed()
    phrases = listed.get("everywhere", {}) | listed.get(page.stem, {})
    found = [f"{line.page}.md:{line.number}: {number}"
             for line in lines(page) for number in typed_numbers(line, phrases)]
    assert not found, f"compute these in a cell, or list them in {LIST.name} with a reason"


def test_listed_numbers_are_still_there() -> None:
    """Breaks when an entry of the list excuses what no page says any more, or gives no reason."""
    by_page = {page.stem: [text for line in lines(page) for text in (line.words, *line.formulas)] for page in PAGES}
    everything = [text for texts in by_page.values() for text in texts]
    listed = allowed()
    assert all(len(reason) > 10 for phrases in listed.values() for reason in phrases.values())
    stale = [f"{page}: {phrase}" for page, phrases in listed.items() for phrase in phrases
             if not any(phrase in text for text in (everything if page == "everywhere" else by_page[page]))]
    assert not stale


@pytest.mark.parametrize(("text", "numbers"), [
    ("By eq. (17) and Table 5, D33 is 0 for 21 components; see axis 3, curves 4 and 5 at 45°.", []),
    ("The bulk modulus is 1.08 times too large.", ["1.08"]),
    ("Errors are $2.3\\times10^{-9}$ at most.", ["$2.3\\times10^{-9}$"]),
    ("Errors are `1e-9`, with $P_2 = \\tfrac12(3x^2-1)$, in [](table_2.md) and {cite:t}`pan1999`.", []),
    ("```{code-cell} python\n:mystnb:\n:  figure:\n:    caption: Off by 7 %.\nfigure(12)\n```", ["7"]),
    ("A formula [goes\non](x_1.md): $a +\n0.25$ and 3 more.", ["$a +\n0.25$", "3"]),
    ("It is a factor of nine larger, a tenth of it, six times as wide, and good to nine digits.",
     ["factor of nine", "a tenth", "six times as", "nine digits"]),
    ("Two hypotheses and three routes of six components: a third way, and half of the sphere.", []),
])
def test_what_counts_as_typed(tmp_path: Path, text: str, numbers: list[str]) -> None:
    """Breaks when the scan no longer sees a number in prose, or takes a name for one."""
    page = tmp_path / "page.md"
    page.write_text("---\nfile_format: mystnb\n---\n\n" + text + "\n", encoding="utf-8")
    found = [number for line in lines(page) for number in typed_numbers(line, {})]
    assert [number.rstrip(".,") for number in found] == numbers
