"""Everything that can be refused, each with a code, the value, the bound and the remedy.

An error reads ``FabricOutOfRange [G-FAB-01]: D33 = 2.3, allowed -1 <= D33 <= 2 (E(n) would be negative).
Give a smaller D33.`` The catalogue at the end names every class once; the book has a section for each code.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
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
    more : int
        How many further mistakes the same input has [-].
    """

    code: ClassVar[str] = "G-000"
    title: ClassVar[str] = "Refused"

    def __init__(self, found: str, *, allowed: str, remedy: str, more: int = 0) -> None:
        """Compose the one sentence that the user reads."""
        self.found, self.allowed, self.remedy, self.more = found, allowed, remedy, more
        others = f" ({more} more {'mistake' if more == 1 else 'mistakes'} in the same input)" if more else ""
        super().__init__(f"{type(self).__name__} [{self.code}]: {found}, {allowed}. {remedy}{others}")

    def __reduce__(self) -> tuple[Callable[..., GranularError], tuple[object, ...]]:
        """Survive the way back from a worker process, which rebuilds an exception from its arguments."""
        return _rebuilt, (type(self), self.found, self.allowed, self.remedy, self.more)


def _rebuilt(kind: type[GranularError], found: str, allowed: str, remedy: str, more: int) -> GranularError:
    return kind(found, allowed=allowed, remedy=remedy, more=more)


@contextmanager
def found_at(place: str) -> Iterator[None]:
    """Say where something was found that is refused; what is allowed and the remedy stay as they are.

    Parameters
    ----------
    place : str
        Put before what was found, with its separator, e.g. ``"line 3: "``.

    Raises
    ------
    GranularError
        In place of each one raised inside, with the place.

    Notes
    -----
    Source: the error format of this package.

    Examples
    --------
    >>> with found_at("line 3: "):
    ...     raise FileTooLarge("size = 0", allowed="allowed size > 0", remedy="Give one.")
    Traceback (most recent call last):
    granular.errors.FileTooLarge: FileTooLarge [G-INP-03]: line 3: size = 0, allowed size > 0. Give one.
    """
    try:
        yield
    except GranularError as refusal:
        raise type(refusal)(f"{place}{refusal.found}", allowed=refusal.allowed, remedy=refusal.remedy,
                            more=refusal.more) from None


class FileUnreadable(GranularError):
    """The file is missing, is a folder, or may not be read."""

    code = "G-INP-01"
    title = "The file cannot be read"


class NotToml(GranularError):
    """The file is not UTF-8 text in TOML."""

    code = "G-INP-02"
    title = "The file is not TOML"


class FileTooLarge(GranularError):
    """The file is larger than any scene."""

    code = "G-INP-03"
    title = "The file is too large"


class BadOption(GranularError):
    """An option of the command line, or its value, is not known."""

    code = "G-INP-04"
    title = "A command-line option that is not known"


class OutputUnwritable(GranularError):
    """Standard output cannot take the result, for instance because the disk is full."""

    code = "G-INP-05"
    title = "The output cannot be written"


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


class UnknownKey(GranularError):
    """The scene has a key that does not exist."""

    code = "G-SCN-01"
    title = "A key that does not exist"


class MissingKey(GranularError):
    """The scene lacks a key that it needs."""

    code = "G-SCN-02"
    title = "A key is missing"


class WrongType(GranularError):
    """A string, list, table or truth value stands where something else belongs."""

    code = "G-SCN-03"
    title = "A value of the wrong type"


class ValueOutOfRange(GranularError):
    """A number outside the interval in which it means something."""

    code = "G-SCN-04"
    title = "A value outside its range"


class UnknownChoice(GranularError):
    """A word that is not among the choices."""

    code = "G-SCN-05"
    title = "A word that is not among the choices"


class ConflictingKeys(GranularError):
    """Keys that exclude each other, or that need each other."""

    code = "G-SCN-06"
    title = "Keys that do not go together"


class TensorUnusable(GranularError):
    """A fabric or stress tensor that is not 3 x 3, not symmetric, or not traceless where it must be."""

    code = "G-SCN-07"
    title = "A tensor that is not symmetric or not traceless"


class SymmetryNotBuilt(GranularError):
    """A fabric or stress tensor that is not axially symmetric about axis 3."""

    code = "G-SCN-08"
    title = "A tensor that is not axially symmetric about axis 3"


class StressNotCompressive(GranularError):
    """A stress that does not press the grains together: its mean is not a compression."""

    code = "G-SCN-09"
    title = "A stress without compression"


class FabricOutOfRange(GranularError):
    """A contact-normal density that is negative somewhere, or a branch length that is not positive."""

    code = "G-FAB-01"
    title = "The fabric is outside its admissible region"


class CurveMalformed(GranularError):
    """A gradation curve that is no table of at least two sizes with the fraction finer than each."""

    code = "G-GRD-01"
    title = "A gradation curve that is no table of two columns"


class CurveInPercent(GranularError):
    """A gradation curve whose second column is in percent."""

    code = "G-GRD-02"
    title = "A gradation curve in percent"


class CurveNotMonotone(GranularError):
    """A gradation curve on which less is finer than a larger size, or that gives one size twice."""

    code = "G-GRD-03"
    title = "A gradation curve that is not monotone"


class CurveIncomplete(GranularError):
    """A gradation curve that does not begin at 0 or does not end at 1."""

    code = "G-GRD-04"
    title = "A gradation curve that does not reach 0 and 1"


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


class ContactFileUnusable(GranularError):
    """A contact file that is damaged, cut off, empty, not what its name says, or Parquet without its library."""

    code = "G-CON-01"
    title = "A contact file that cannot be used"


class ContactColumnsMissing(GranularError):
    """A contact list without a column that is needed, or with a part only of columns that belong together."""

    code = "G-CON-02"
    title = "A contact list without its columns"


class ContactValuesMissing(GranularError):
    """Contacts with a number that is missing or not finite, or a list without contacts."""

    code = "G-CON-03"
    title = "Contacts with missing values"


class ContactImpossible(GranularError):
    """A contact that two grains cannot have: no branch, no unit normal, tension, a negative stiffness."""

    code = "G-CON-04"
    title = "Contacts that cannot be"


class ContactTwice(GranularError):
    """The same two bodies touch more than once in a list."""

    code = "G-CON-05"
    title = "The same contact twice"


class ComplianceInfinite(GranularError):
    """Contacts slide or have opened in some directions, so that the static compliance is infinite."""

    code = "G-STA-01"
    title = "An infinite compliance"


class RouteOutOfDomain(GranularError):
    """A route was named that does not cover the scene, or cannot keep the wanted accuracy."""

    code = "G-RTE-01"
    title = "A route outside its domain"


class CertifiedArithmeticMissing(GranularError):
    """The route in ball arithmetic was named, and the library that does it is not installed."""

    code = "G-RTE-02"
    title = "Ball arithmetic is not installed"


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


class NotFinite(GranularError):
    """A number that is NaN, infinite, or too large for double precision."""

    code = "G-NUM-01"
    title = "A number that is not finite"


class ResultOutOfRange(GranularError):
    """A result that double precision cannot hold with all its digits."""

    code = "G-NUM-02"
    title = "A result outside double precision"


CATALOGUE: tuple[type[GranularError], ...] = (
    FileUnreadable, NotToml, FileTooLarge, BadOption, OutputUnwritable,
    UnitUnknown, UnitOfOtherDimension, QuantityUnreadable,
    UnknownKey, MissingKey, WrongType, ValueOutOfRange, UnknownChoice, ConflictingKeys, TensorUnusable,
    SymmetryNotBuilt, StressNotCompressive,
    FabricOutOfRange, BranchesUnusable, DirectionNotUnit, TooFewDirections,
    CurveMalformed, CurveInPercent, CurveNotMonotone, CurveIncomplete,
    ContactFileUnusable, ContactColumnsMissing, ContactValuesMissing, ContactImpossible, ContactTwice,
    ComplianceInfinite,
    RouteOutOfDomain, CertifiedArithmeticMissing,
    IndexNotKnown, TensorNotElastic, TensorNotInvertible, TensorNotPositive, DirectionNotValid,
    DensityOutOfRange, ArrayNotUsable, FigureNotKnown, FigureNotWritten,
    NotFinite, ResultOutOfRange,
)
