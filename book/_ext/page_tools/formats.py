"""Numbers as they stand in sentences and tables."""

from __future__ import annotations

import math
from collections.abc import Sequence


def number(value: float | None, form: str = ".2f", factor: float = 1.0, after: str = "") -> str:
    """A number with a true minus sign, a dash where there is none."""
    return "–" if value is None else format(value * factor, form).replace("-", "−") + after


def ends(values: Sequence[float], factor: float = 1.0, form: str = ".2f") -> str:
    """The least and the largest of some numbers."""
    return f"{number(min(values), form, factor)} to {number(max(values), form, factor)}"


def at_most(value: float, digits: int) -> str:
    """A number that nothing behind the word "within" exceeds: rounded upwards."""
    return f"{math.ceil(value * 10**digits) / 10**digits:.{digits}f}"


def signed(value: float) -> str:
    """A number with its sign."""
    return f"{value:+.3f}".replace("-", "−")
