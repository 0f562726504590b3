"""What is done with the moments: in fractions, so that nothing is lost, or in floats, quicker and nearly as good.

Emitted functions use nothing but + - * / and whole numbers, and so serve both.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from granular.routes.rational import accurate_sum, rounded
from granular.routes.result import Six
from granular.routes.work import Work

QUICK = 1e-13
"""A wanted accuracy from here on is served in floats, with rules as coarse as it allows [-]."""

FLOAT_ERROR = 32 * 2.0**-52
"""Bound for what floats lose between the nodes and the components [-]. The worst found on 20,000 random and boundary
scenes is 1.4e-15, or 6.3 * 2**-52: components are sums of positive terms, but for the static shear."""


@dataclass(frozen=True, slots=True)
class Arithmetic:
    """A way of computing with moments.

    Attributes
    ----------
    name : str
        What numbers are, in words.
    number : callable
        From a double or a fraction to a number.
    total : callable
        Adds doubles.
    finished : callable
        From six numbers to six doubles; refuses what a double cannot hold.
    passes : int
        How often ``total`` goes over its terms [-].
    """

    name: str
    number: Callable[[Any], Any]
    total: Callable[[list[float]], Any]
    finished: Callable[[Sequence[Any]], Six]
    passes: int = 1

    def numbers(self, *values: Any) -> Any:
        """Several at once; typed ``Any`` because emitted functions are typed for floats."""
        return tuple(map(self.number, values))

    def additions(self, terms: int) -> Work:
        """What adding some terms takes: one less than there are, and in two passes the rest besides."""
        return Work(self.passes * terms - (1 if self.passes == 1 else 0))


def within_range(components: Sequence[float]) -> Six:
    """Six doubles as they are, once it is known that none has lost digits to underflow.

    Parameters
    ----------
    components : sequence of 6 float
        C1111, C3333, C1122, C1133, C2323, C1212 in any unit [-].

    Returns
    -------
    tuple of 6 float
        The same.

    Raises
    ------
    ResultOutOfRange
        A component is so small that a double holds only some of its digits; a component that is zero is zero.
    """
    smallest = sys.float_info.min
    if all(component == 0 or abs(component) >= smallest for component in components):
        c1111, c3333, c1122, c1133, c2323, c1212 = components
        return c1111, c3333, c1122, c1133, c2323, c1212
    return rounded(components)


FRACTIONS = Arithmetic(name="fractions", number=Fraction, total=accurate_sum, finished=rounded,
                       passes=2)
"""Nothing is lost; the components are rounded once."""

FLOATS = Arithmetic(name="floats", number=float, total=math.fsum, finished=within_range)
"""For a wanted accuracy of ``QUICK`` or looser."""


def arithmetic_for(rtol: float | None) -> Arithmetic:
    """Floats where they are good enough for a wanted accuracy [-], fractions where they are not or none is stated."""
    return FLOATS if rtol is not None and rtol >= QUICK else FRACTIONS
