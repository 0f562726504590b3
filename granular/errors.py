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


class IndexNotKnown(GranularError):
    """A component name, or an order of index pairs, that does not exist."""

    code = "G-ELA-01"
    title = "A component or an index order that does not exist"


class TensorNotElastic(GranularError):
    """Numbers that are no stiffness or compliance: not finite, of a wrong shape, or without its symmetry."""

    code = "G-ELA-02"
    title = "Not an elastic tensor"


class TensorNotInvertible(GranularError):
    """A stiffness or compliance that is singular to rounding, so that its inverse means nothing."""

    code = "G-ELA-03"
    title = "A singular elastic tensor"


class TensorNotPositive(GranularError):
    """A stiffness that stores no energy in some strain, where a stable solid is needed."""

    code = "G-ELA-04"
    title = "A stiffness that is not positive definite"


class DirectionNotValid(GranularError):
    """A rotation that is not orthogonal, or an angle that is not a finite number."""

    code = "G-ELA-05"
    title = "A direction that does not exist"


class DensityOutOfRange(GranularError):
    """A mass density that is not positive, or a void ratio that is negative."""

    code = "G-WAV-01"
    title = "A density outside its range"


class ArrayNotUsable(GranularError):
    """An array argument that is not numeric, or whose shape does not broadcast with the others."""

    code = "G-ARR-01"
    title = "An array argument that cannot be used"


class FigureNotKnown(GranularError):
    """A figure, or a file format for it, that does not exist."""

    code = "G-FIG-01"
    title = "A figure or format that does not exist"


class FigureNotWritten(GranularError):
    """A figure file that could not be written; nothing is left half done."""

    code = "G-FIG-02"
    title = "A figure that could not be written"


CATALOGUE: tuple[type[GranularError], ...] = (
    FabricOutOfRange, EffectNotBuilt, RouteOutOfDomain,
    IndexNotKnown, TensorNotElastic, TensorNotInvertible, TensorNotPositive, DirectionNotValid,
    DensityOutOfRange, ArrayNotUsable, FigureNotKnown, FigureNotWritten,
)
