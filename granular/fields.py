"""The kinds of value that a scene holds: bounded numbers and quantities, words out of a list.

Each kind is one annotation. It reads the value, refuses it with its name, bound and remedy, and describes
itself in the published JSON schema, so that the three can never differ.
"""

from __future__ import annotations

import difflib
from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from pydantic import GetJsonSchemaHandler, ValidationInfo
from pydantic_core import CoreSchema, core_schema

from granular.errors import UnknownChoice, ValueOutOfRange, WrongType
from granular.units import Dimension, finite_number, in_si, shown

_QUANTITY_PATTERN = r"^\s*[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?\s*\S.*$"


@dataclass(frozen=True, slots=True, kw_only=True)
class Kind(ABC):
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

    @abstractmethod
    def read(self, value: object, name: str) -> object:
        """Read a value that was given under a name, or refuse it."""

    @abstractmethod
    def json_schema(self) -> dict[str, Any]:
        """JSON schema of the values that ``read`` takes."""


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
