"""Exact arithmetic with emitted code, which is typed for floats but uses nothing except + - * / and whole numbers."""

from __future__ import annotations

import math
import sys
from collections.abc import Iterable
from fractions import Fraction
from typing import Any

from granular.errors import ResultOutOfRange
from granular.routes.result import COMPONENTS, Six


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

    Raises
    ------
    ResultOutOfRange
        A component is so small that a double holds only some of its digits; a component that is zero is zero.
    """
    c1111, c3333, c1122, c1133, c2323, c1212 = (_nearest(name, exact)
                                                for name, exact in zip(COMPONENTS, components, strict=True))
    return c1111, c3333, c1122, c1133, c2323, c1212


def _nearest(name: str, exact: float | Fraction) -> float:
    if exact != 0 and abs(Fraction(exact)) < sys.float_info.min:
        raise ResultOutOfRange(f"{name} = {float(exact):.3g} over (M/V) l_e^2 k_n,ref",
                               allowed=f"allowed 0, or {sys.float_info.min:.3g} and more",
                               remedy="Give poisson_ratio = 0 if it was meant to be none, or directions all alike.")
    return float(exact)


def accurate_sum(terms: list[float]) -> Fraction:
    """Add without loss: half a unit here would grow sixfold where the terms of a rank-four density cancel.

    Parameters
    ----------
    terms : list of float
        Numbers of any unit [-].

    Returns
    -------
    Fraction
        Their sum to twice the digits of a double [-].
    """
    nearest = math.fsum(terms)
    return Fraction(nearest) + Fraction(math.fsum([*terms, -nearest]))
