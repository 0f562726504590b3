"""Everything that can be refused, each with a code, the value, the bound and the remedy.

A file holds the classes of one subject; the catalogue names every class once, in the order of the book, which has a
section for each code.
"""

from __future__ import annotations

from granular.errors.computations import (
    ArrayNotUsable,
    CertifiedArithmeticMissing,
    ComplianceInfinite,
    NotFinite,
    ResultOutOfRange,
    RouteOutOfDomain,
)
from granular.errors.contact_lists import (
    ContactColumnsMissing,
    ContactFileUnusable,
    ContactImpossible,
    ContactTwice,
    ContactValuesMissing,
)
from granular.errors.derivatives import MeasurementsTooFew, SlopeInfinite, SlopesNotBuilt
from granular.errors.fabrics import BranchesUnusable, DirectionNotUnit, FabricOutOfRange, TooFewDirections
from granular.errors.figures import FigureNotKnown, FigureNotWritten
from granular.errors.files import BadOption, FileTooLarge, FileUnreadable, NotToml, OutputUnwritable
from granular.errors.gradations import CurveIncomplete, CurveInPercent, CurveMalformed, CurveNotMonotone
from granular.errors.quantities import QuantityUnreadable, UnitOfOtherDimension, UnitUnknown
from granular.errors.refusal import GranularError, found_at
from granular.errors.scenes import (
    AxisNeeded,
    ConflictingKeys,
    MissingKey,
    StressNotCompressive,
    TensorUnusable,
    UnknownChoice,
    UnknownKey,
    ValueOutOfRange,
    WrongType,
)
from granular.errors.sweeps import (
    SchedulerUnreachable,
    SweepEmpty,
    SweepFolderTaken,
    SweepLibraryMissing,
    SweepTooLarge,
    WorkersUnusable,
)
from granular.errors.tensors import (
    DensityOutOfRange,
    DirectionNotValid,
    IndexNotKnown,
    TensorNotElastic,
    TensorNotInvertible,
    TensorNotPositive,
)

__all__ = [
    "CATALOGUE",
    "ArrayNotUsable",
    "AxisNeeded",
    "BadOption",
    "BranchesUnusable",
    "CertifiedArithmeticMissing",
    "ComplianceInfinite",
    "ConflictingKeys",
    "ContactColumnsMissing",
    "ContactFileUnusable",
    "ContactImpossible",
    "ContactTwice",
    "ContactValuesMissing",
    "CurveInPercent",
    "CurveIncomplete",
    "CurveMalformed",
    "CurveNotMonotone",
    "DensityOutOfRange",
    "DirectionNotUnit",
    "DirectionNotValid",
    "FabricOutOfRange",
    "FigureNotKnown",
    "FigureNotWritten",
    "FileTooLarge",
    "FileUnreadable",
    "GranularError",
    "IndexNotKnown",
    "MeasurementsTooFew",
    "MissingKey",
    "NotFinite",
    "NotToml",
    "OutputUnwritable",
    "QuantityUnreadable",
    "ResultOutOfRange",
    "RouteOutOfDomain",
    "SchedulerUnreachable",
    "SlopeInfinite",
    "SlopesNotBuilt",
    "StressNotCompressive",
    "SweepEmpty",
    "SweepFolderTaken",
    "SweepLibraryMissing",
    "SweepTooLarge",
    "TensorNotElastic",
    "TensorNotInvertible",
    "TensorNotPositive",
    "TensorUnusable",
    "TooFewDirections",
    "UnitOfOtherDimension",
    "UnitUnknown",
    "UnknownChoice",
    "UnknownKey",
    "ValueOutOfRange",
    "WorkersUnusable",
    "WrongType",
    "found_at",
]

CATALOGUE: tuple[type[GranularError], ...] = (
    FileUnreadable, NotToml, FileTooLarge, BadOption, OutputUnwritable,
    UnitUnknown, UnitOfOtherDimension, QuantityUnreadable,
    UnknownKey, MissingKey, WrongType, ValueOutOfRange, UnknownChoice, ConflictingKeys, TensorUnusable,
    AxisNeeded, StressNotCompressive,
    FabricOutOfRange, BranchesUnusable, DirectionNotUnit, TooFewDirections,
    CurveMalformed, CurveInPercent, CurveNotMonotone, CurveIncomplete,
    ContactFileUnusable, ContactColumnsMissing, ContactValuesMissing, ContactImpossible, ContactTwice,
    ComplianceInfinite, SlopeInfinite, SlopesNotBuilt, MeasurementsTooFew,
    RouteOutOfDomain, CertifiedArithmeticMissing,
    SweepEmpty, SweepTooLarge, SweepFolderTaken, SchedulerUnreachable, WorkersUnusable, SweepLibraryMissing,
    IndexNotKnown, TensorNotElastic, TensorNotInvertible, TensorNotPositive, DirectionNotValid,
    DensityOutOfRange, ArrayNotUsable, FigureNotKnown, FigureNotWritten,
    NotFinite, ResultOutOfRange,
)

for _kind in (GranularError, *CATALOGUE):
    _kind.__module__ = __name__  # messages and tracebacks name the package, wherever a class stands
