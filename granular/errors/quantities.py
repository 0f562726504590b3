"""Units and quantities that cannot be read."""

from __future__ import annotations

from granular.errors.refusal import GranularError


class UnitUnknown(GranularError):
    """A unit that neither the table of common units nor pint knows."""

    code = "G-UNI-01"
    title = "A unit that is not known"


class UnitOfOtherDimension(GranularError):
    """A unit that measures something else, e.g. kg for a pressure."""

    code = "G-UNI-02"
    title = "A unit of another dimension"


class QuantityUnreadable(GranularError):
    """A string that is not a number followed by a unit."""

    code = "G-UNI-03"
    title = "Not a number with a unit"
