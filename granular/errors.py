"""Everything that can be refused, each with a code, the value, the bound and the remedy.

An error reads ``FabricOutOfRange [G-FAB-01]: D33 = 2.3, allowed -1 <= D33 <= 2 (E(n) would be negative).
Give a smaller D33.`` The catalogue at the end names every class once; the book has a section for each code.
"""

from __future__ import annotations

from typing import ClassVar


class GranularError(ValueError):
    """Base of all refusals.

    Parameters
    ----------
    found : str
        What was given, with its name and value, e.g. ``"D33 = 2.3"``.
    allowed : str
        The bound that it broke, e.g. ``"allowed -1 <= D33 <= 2"``.
    remedy : str
        What to do about it, one sentence.
    """

    code: ClassVar[str] = "G-000"
    title: ClassVar[str] = "Refused"

    def __init__(self, found: str, *, allowed: str, remedy: str) -> None:
        self.found, self.allowed, self.remedy = found, allowed, remedy
        super().__init__(f"{type(self).__name__} [{self.code}]: {found}, {allowed}. {remedy}")


class FabricOutOfRange(GranularError):
    """A contact-normal density that is negative somewhere, or a branch length that is not positive."""

    code = "G-FAB-01"
    title = "The fabric is outside its admissible region"


class EffectNotBuilt(GranularError):
    """The scene calls for an effect that this version does not simulate."""

    code = "G-EFF-01"
    title = "An effect that is not built yet"


class RouteOutOfDomain(GranularError):
    """A route was named that does not cover the scene, or cannot keep the wanted accuracy."""

    code = "G-RTE-01"
    title = "A route outside its domain"


CATALOGUE: tuple[type[GranularError], ...] = (FabricOutOfRange, EffectNotBuilt, RouteOutOfDomain)
