"""Numbers of the paper's equations that a text cites: ``eq. (2)``, ``eqs (8)-(11)``, ``eqs (12), (16) and (17)``."""

from __future__ import annotations

import re

_CITED = re.compile(r"\b[Ee]qs?\.?\s+((?:\(\d+\)(?:\s*-\s*|,\s+and\s+|,\s+|\s+and\s+)?)+)")
_NUMBER = re.compile(r"(-?)\s*\((\d+)\)")


def equations_cited(text: str) -> list[int]:
    """Numbers of all equations that a text cites, those between the ends of a range among them, in rising order."""
    found: set[int] = set()
    for cited in _CITED.finditer(text):
        before = 0
        for dash, digits in _NUMBER.findall(cited[1]):
            number = int(digits)
            found.update(range(before if dash else number, number + 1))
            before = number
    return sorted(found)
