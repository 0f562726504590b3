"""What an evaluation does: counted, so that an effect that is left out can be shown to cost nothing."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Work:
    """Arithmetic of one evaluation, from the numbers of the scene to six components.

    Left out is what a process does once and keeps (nodes and weights of rules, exponentials of the trapezoidal rule)
    and the exact arithmetic on a handful of fractions that decides which contacts slide.

    Attributes
    ----------
    operations : int
        Additions, subtractions, multiplications, divisions and whole powers [-].
    functions : int
        Roots, exponentials and other functions [-].
    """

    operations: int = 0
    functions: int = 0

    def __add__(self, other: Work) -> Work:
        """Both together."""
        return Work(self.operations + other.operations, self.functions + other.functions)

    def __mul__(self, times: int) -> Work:
        """The same several times."""
        return Work(self.operations * times, self.functions * times)


NOTHING = Work()
"""No arithmetic at all."""
