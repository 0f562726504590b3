"""The two ways of passing from contacts to the assembly: uniform strain or uniform stress."""

from __future__ import annotations

from enum import StrEnum


class Hypothesis(StrEnum):
    """How the motion of one contact follows from the state of the assembly.

    ``KINEMATIC``: every contact displaces with the mean strain; an upper bound of the stiffness, eqs (1)-(7).
    ``STATIC``: every contact carries its share of the mean stress, eq. (23); a lower estimate.
    """

    KINEMATIC = "kinematic"
    STATIC = "static"
