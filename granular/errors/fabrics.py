"""Fabrics, directions and branches that cannot be right."""

from __future__ import annotations

from granular.errors.refusal import GranularError


class FabricOutOfRange(GranularError):
    """A contact-normal density that is negative somewhere, or a branch length that is not positive."""

    code = "G-FAB-01"
    title = "The fabric is outside its admissible region"


class BranchesUnusable(GranularError):
    """Branch vectors given as a function of direction that no contacts can have."""

    code = "G-FAB-02"
    title = "Branch vectors that cannot be"


class DirectionNotUnit(GranularError):
    """A direction of length zero, or one that should have the length 1 and has another."""

    code = "G-FAB-03"
    title = "A direction that is no unit vector"


class TooFewDirections(GranularError):
    """A list of directions too short for what is asked of it."""

    code = "G-FAB-04"
    title = "Too few directions"
