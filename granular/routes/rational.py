"""Exact arithmetic with emitted code, which is typed for floats but uses nothing except + - * / and whole numbers."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from typing import Any

from granular.routes.result import Six


def fractions_of(*numbers: float | Fraction) -> Any:
    """Doubles as the fractions that they are, to be handed to emitted functions, which are exact on them.

    Parameters
    ----------
    numbers : float or Fraction
        Finite numbers of any unit [-].

    Returns
    -------
    tuple of Fraction
        The same numbers; typed ``Any`` because emitted functions are typed for floats.

    Examples
    --------
    >>> fractions_of(0.5, 0.1)[1] == Fraction(3602879701896397, 2**55)
    True
    """
    return tuple(Fraction(number) for number in numbers)


def rounded(components: Iterable[float | Fraction]) -> Six:
    """Round each of six components once, to the nearest double.

    Parameters
    ----------
    components : iterable of 6 Fraction
        C1111, C3333, C1122, C1133, C2323, C1212 in any unit [-].

    Returns
    -------
    tuple of 6 float
        The nearest doubles, same unit.
    """
    c1111, c3333, c1122, c1133, c2323, c1212 = components
    return float(c1111), float(c3333), float(c1122), float(c1133), float(c2323), float(c1212)
