"""The kinds of value that a scene holds: bounded numbers and quantities, words out of a list, tensors.

Each kind is one annotation. It reads the value, refuses it with its name, bound and remedy, and describes
itself in the published JSON schema, so that the three can never differ.
"""

from __future__ import annotations

import difflib
import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from pydantic import GetJsonSchemaHandler, ValidationInfo
from pydantic_core import CoreSchema, core_schema

from granular.errors import TensorUnusable, UnknownChoice, ValueOutOfRange, WrongType
from granular.units import Dimension, finite_number, in_si, shown

Tensor = tuple[tuple[float, float, float], tuple[float, float, float], tuple[float, float, float]]
"""A second-rank tensor, row by row."""

_QUANTITY_PATTERN = r"^\s*[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?\s*\S.*$"
_NEAR = 1e-12
"""Two entries of a tensor typed as decimals are the same when they agree to this, relative to the largest."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Kind:
    """What all kinds share: an optional value may be None, and the reading is done by ``read``."""

    optional: bool = False

    def __get_pydantic_core_schema__(self, _source: object, _handler: object) -> CoreSchema:
        """Tell pydantic to read the value with ``read`` and nothing else."""
        return core_schema.with_info_plain_validator_function(self._read_optional)

    def __get_pydantic_json_schema__(self, _core: CoreSchema,
                                     _handler: GetJsonSchemaHandler) -> dict[str, Any]:
        """Describe the value in the published schema."""
        return self.json_schema()

    def _read_optional(self, value: object, info: ValidationInfo) -> object:
        return None if value is None and self.optional else self.read(value, info.field_name or "value")

    def read(self, value: object, name: str) -> object:
        """Read a value that was given under a name, or refuse it."""
        raise NotImplementedError

    def json_schema(self) -> dict[str, Any]:
        """JSON schema of the values that ``read`` takes."""
        raise NotImplementedError


@dataclass(frozen=True, slots=True, kw_only=True)
class Number(Kind):
    """A finite real number, with a unit when it has a dimension, inside an interval.

    Attributes
    ----------
    dimension : Dimension or None
        What it measures; None for a pure number.
    above, at_least, at_most, below : float or None
        Ends of the interval [SI]; ``above`` and ``below`` do not belong to it.
    why : str
        What would go wrong outside, shown in parentheses.
    remedy : str
        What to do about a value outside.
    """

    dimension: Dimension | None = None
    above: float | None = None
    at_least: float | None = None
    at_most: float | None = None
    below: float | None = None
    why: str = ""
    remedy: str = "Give a value inside the interval."

    def read(self, value: object, name: str) -> float:
        """Read the number in SI units, or refuse it; the zero that comes out has no sign."""
        number = 0.0 + (finite_number(value, name=name) if self.dimension is None
                        else in_si(value, self.dimension, name=name))
        inside = ((self.above is None or number > self.above)
                  and (self.at_least is None or number >= self.at_least)
                  and (self.at_most is None or number <= self.at_most)
                  and (self.below is None or number < self.below))
        if not inside:
            raise ValueOutOfRange(f"{name} = {shown(value)}", allowed=f"allowed {self._interval(name)}",
                                  remedy=self.remedy)
        return number

    def _interval(self, name: str) -> str:
        left = (f"{self.above:g} < " if self.above is not None
                else f"{self.at_least:g} <= " if self.at_least is not None else "")
        right = (f" < {self.below:g}" if self.below is not None
                 else f" <= {self.at_most:g}" if self.at_most is not None else "")
        if left and not right:  # one-sided intervals read better with the name first
            left, right = "", left.replace(" < ", "").replace(" <= ", "")
            right = f" > {right}" if self.above is not None else f" >= {right}"
        unit = f" {self.dimension.si}" if self.dimension is not None else ""
        return f"{left}{name}{right}{unit}" + (f" ({self.why})" if self.why else "")

    def json_schema(self) -> dict[str, Any]:
        """Number with its bounds; a quantity also as a string with a unit."""
        ends = {"exclusiveMinimum": self.above, "minimum": self.at_least, "maximum": self.at_most,
                "exclusiveMaximum": self.below}
        number = {"type": "number"} | {key: end for key, end in ends.items() if end is not None}
        if self.dimension is None:
            return number
        text = {"type": "string", "pattern": _QUANTITY_PATTERN, "examples": [self.dimension.example]}
        return {"anyOf": [number | {"description": f"in {self.dimension.si}"}, text]}


@dataclass(frozen=True, slots=True, kw_only=True)
class Word(Kind):
    """One word out of a list.

    Attributes
    ----------
    words : tuple of str
        The list.
    kind : callable
        What the word becomes, e.g. an enumeration.
    """

    words: tuple[str, ...]
    kind: Callable[[str], object] = str

    def read(self, value: object, name: str) -> object:
        """Read the word, or refuse it and name the nearest one."""
        return self.kind(chosen(value, self.words, name=name))

    def json_schema(self) -> dict[str, Any]:
        """Enumeration of the words."""
        return {"type": "string", "enum": list(self.words)}


@dataclass(frozen=True, slots=True, kw_only=True)
class WordsOrAuto(Kind):
    """The word "auto", or a list of words, none of them twice.

    Attributes
    ----------
    words : tuple of str
        What the list may hold.
    """

    words: tuple[str, ...]

    def read(self, value: object, name: str) -> str | tuple[str, ...]:
        """Read "auto" or the list, or refuse it."""
        if value == "auto":
            return "auto"
        if not isinstance(value, (list, tuple)):
            raise WrongType(f"{name} = {shown(value)}",
                            allowed=f'allowed "auto" or a list out of {", ".join(self.words)}',
                            remedy='Write "auto", or a list such as ["packing", "branches"].')
        listed = tuple(chosen(item, self.words, name=f"{name}[{place}]") for place, item in enumerate(value))
        for place, word in enumerate(listed):
            if word in listed[:place]:
                raise UnknownChoice(f"{name}[{place}] = {shown(word)}", allowed="allowed each word once",
                                    remedy="Delete the second one.")
        return listed

    def json_schema(self) -> dict[str, Any]:
        """The constant, or an array of the words."""
        return {"anyOf": [{"const": "auto"}, {"type": "array", "uniqueItems": True,
                                              "items": {"type": "string", "enum": list(self.words)}}]}


def chosen(value: object, words: Sequence[str], *, name: str) -> str:
    """Return the value when it is one of the words; refuse it with the nearest one otherwise.

    Parameters
    ----------
    value : object
        What was given.
    words : sequence of str
        The choices.
    name : str
        Name for messages.

    Returns
    -------
    str
        The word.

    Raises
    ------
    UnknownChoice, WrongType
        It is not among the choices, or no string.

    Notes
    -----
    Source: the scene file's interface.

    Examples
    --------
    >>> chosen("static", ("kinematic", "static"), name="hypothesis")
    'static'
    """
    choices = f"allowed {', '.join(words)}"
    if not isinstance(value, str):
        raise WrongType(f"{name} = {shown(value)}", allowed=choices, remedy="Write one of these words.")
    if value in words:
        return words[words.index(value)]
    near = nearest(value, words)
    raise UnknownChoice(f"{name} = {shown(value)}", allowed=choices,
                        remedy=f"Did you mean {near}?" if near else "Write one of these words.")


def nearest(word: str, known: Sequence[str], *, cutoff: float = 0.6) -> str | None:
    """Return the known word that looks most like another one, if any does.

    Parameters
    ----------
    word : str
        What was written.
    known : sequence of str
        What exists.
    cutoff : float
        Least similarity, 0 to 1 [-].

    Returns
    -------
    str or None
        The nearest known word.

    Notes
    -----
    Source: ``difflib``, letter case ignored.

    Examples
    --------
    >>> nearest("void_ration", ["void_ratio", "coordination_number"])
    'void_ratio'
    """
    by_lower = {name.lower(): name for name in known}
    found = difflib.get_close_matches(word[:200].lower(), list(by_lower), n=1, cutoff=cutoff)
    return by_lower[found[0]] if found else None


@dataclass(frozen=True, slots=True, kw_only=True)
class Text(Kind):
    """A string that is not empty."""

    def read(self, value: object, name: str) -> str:
        """Read the string, or refuse it."""
        if not isinstance(value, str) or not value.strip():
            raise WrongType(f"{name} = {shown(value)}", allowed="allowed a text that is not empty",
                            remedy="Write it between quotation marks.")
        return value

    def json_schema(self) -> dict[str, Any]:
        """String with at least one character."""
        return {"type": "string", "minLength": 1}


@dataclass(frozen=True, slots=True, kw_only=True)
class SymmetricTensor(Kind):
    """A symmetric 3 x 3 tensor, traceless or not.

    Attributes
    ----------
    dimension : Dimension or None
        What each entry measures; None for a pure number.
    traceless : bool
        Whether the three diagonal entries must sum to zero.
    """

    dimension: Dimension | None = None
    traceless: bool = False

    def read(self, value: object, name: str) -> Tensor:
        """Read three rows of three numbers, or say what is wrong with them."""
        rows = list(_rows(value, name))
        entries = [[self._entry(item, f"{name} t{i + 1}{j + 1}") for j, item in enumerate(row)]
                   for i, row in enumerate(rows)]
        (a, b, c), (d, e, f), (g, h, i) = entries
        for this, that, place in ((b, d, "12"), (c, g, "13"), (f, h, "23")):
            if not nearly_equal(this, that, entries):
                raise TensorUnusable(f"{name} has t{place} = {this!r} and t{place[::-1]} = {that!r}",
                                     allowed="allowed only symmetric tensors",
                                     remedy="Make the two entries equal.")
        quarter = math.fsum((a / 4, e / 4, i / 4))  # the trace itself may overflow
        if self.traceless and not nearly_equal(quarter, 0.0, entries):
            raise TensorUnusable(f"{name} has the trace {4 * quarter!r}", allowed="allowed only traceless tensors",
                                 remedy="Subtract a third of the trace from every diagonal entry.")
        return (a, b, c), (d, e, f), (g, h, i)

    def _entry(self, value: object, name: str) -> float:
        return Number(dimension=self.dimension).read(value, name)

    def json_schema(self) -> dict[str, Any]:
        """Three rows of three entries."""
        three = {"type": "array", "minItems": 3, "maxItems": 3}
        return three | {"items": three | {"items": Number(dimension=self.dimension).json_schema()}}


def _rows(value: object, name: str) -> Iterator[Sequence[object]]:
    """The three rows of a nested list; an array of NumPy is taken as its list."""
    value = value.tolist() if hasattr(value, "tolist") else value
    rows = value if isinstance(value, (list, tuple)) else ()
    if len(rows) != 3 or any(not isinstance(row, (list, tuple)) or len(row) != 3 for row in rows):
        raise TensorUnusable(f"{name} = {shown(value)}", allowed="allowed three rows of three numbers",
                             remedy="Write [[t11, t12, t13], [t21, t22, t23], [t31, t32, t33]].")
    yield from rows


def nearly_equal(this: float, that: float, entries: Sequence[Sequence[float]]) -> bool:
    """Whether two numbers agree to the rounding of typed decimals, relative to the largest entry of a tensor.

    Parameters
    ----------
    this, that : float
        The numbers [any unit].
    entries : rows of float
        The tensor that they belong to [same unit].

    Returns
    -------
    bool
        True when they differ by less than 1e-12 of the largest entry.

    Notes
    -----
    Source: a choice; 1e-12 is above the rounding of a dozen typed digits and below any measured fabric.

    Examples
    --------
    >>> nearly_equal(0.1 + 0.2, 0.3, [[0.3]])
    True
    """
    largest = max(abs(entry) for row in entries for entry in row)
    return abs(this / 4 - that / 4) <= _NEAR * (largest / 4)


def is_axial(tensor: Tensor) -> bool:
    """Whether a symmetric tensor is axially symmetric about axis 3.

    Parameters
    ----------
    tensor : (3, 3) tuple of float
        The tensor [any unit].

    Returns
    -------
    bool
        True for diag(t11, t11, t33).

    Notes
    -----
    Source: invariance under rotation about axis 3.

    Examples
    --------
    >>> is_axial(((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 2.0)))
    True
    """
    (a, b, c), (_, e, f), _ = tensor
    return nearly_equal(a, e, tensor) and all(nearly_equal(off, 0.0, tensor) for off in (b, c, f))
