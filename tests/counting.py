"""Numbers that count what is done with them, so that declared costs can be held against what code really does."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any


@dataclass
class Tally:
    """What has been done so far: + - * / and powers, and calls of roots and other functions."""

    operations: int = 0
    functions: int = 0


TALLY = Tally()


def _counted(name: str) -> Callable[..., Any]:
    plain = getattr(float, name)

    def operate(self: float, *others: Any) -> Any:
        result = plain(float(self), *(float(other) for other in others))
        if result is NotImplemented:
            return result
        TALLY.operations += 1
        return Number(result)

    return operate


class Number(float):
    """A double that counts."""

    for _name in ("add", "sub", "mul", "truediv", "pow"):
        locals()[f"__{_name}__"] = _counted(f"__{_name}__")
        locals()[f"__r{_name}__"] = _counted(f"__r{_name}__")

    def __neg__(self) -> Number:
        return Number(-float(self))

    def __abs__(self) -> Number:
        return Number(abs(float(self)))


def counting(function: Callable[..., float]) -> Callable[..., Number]:
    """Make a function of one double count its calls."""
    def call(value: float) -> Number:
        TALLY.functions += 1
        return Number(function(value))

    return call


def total(terms: list[float]) -> Number:
    """Add doubles, counting."""
    TALLY.operations += len(terms) - 1
    return Number(math.fsum(terms))
