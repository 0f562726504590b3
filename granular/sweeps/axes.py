"""One field and the values that it takes: a list, or a range that is written down by its ends."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal, localcontext
from fractions import Fraction
from typing import Any

from granular.errors import (
    ConflictingKeys,
    MissingKey,
    SweepEmpty,
    SweepTooLarge,
    UnknownKey,
    ValueOutOfRange,
    WrongType,
)
from granular.fields import chosen, nearest
from granular.sweeps.scene_fields import SceneField, scene_field
from granular.units import shown

MOST_VALUES = 1_000_000
"""Most values of one field."""

SPACINGS = ("linear", "log")
"""How the values of a range are spread."""

RANGE_KEYS = ("start", "stop", "num", "spacing")
"""The keys of a range."""

_DIGITS = 40
"""Digits of the arithmetic behind a logarithmic range; what it gives is rounded once."""


@dataclass(frozen=True, slots=True)
class Axis:
    """A field of the scene with its values.

    Attributes
    ----------
    field : SceneField
        What varies.
    values : tuple
        As a scene takes them, in SI units.
    labels : tuple
        What stands on the coordinate: numbers in SI units, or text.
    """

    field: SceneField
    values: tuple[object, ...]
    labels: tuple[float, ...] | tuple[str, ...]

    @property
    def name(self) -> str:
        """Name of the field."""
        return self.field.name

    @property
    def size(self) -> int:
        """Number of values."""
        return len(self.values)


def read_axis(field_name: str, given: object, *, place: str, distinct: bool) -> Axis:
    """Read the values of a field.

    Parameters
    ----------
    field_name : str
        Name of the field, such as ``stress.ratio``.
    given : sequence, mapping or array
        Values as in a scene file [SI]; or a range with ``start``, ``stop``, ``num`` and, unless it is linear,
        ``spacing``.
    place : str
        Where they stand, for messages.
    distinct : bool
        Whether a value may stand only once.

    Returns
    -------
    Axis
        The field with its values in SI units.

    Raises
    ------
    UnknownKey
        There is no such field, or a range has a key that none has.
    SweepEmpty, SweepTooLarge
        There is no value, or there are more than a million.
    GranularError
        A value that the field could never take, or that stands there twice.

    Notes
    -----
    Accuracy: both ends of a range are exact. Between them, values are rounded once: those of a linear range from the
    decimals that the ends are written with, so that 0.1 to 0.5 in five passes through 0.3 itself.
    Source: a policy of this package.

    Examples
    --------
    >>> read_axis("stress.mean", {"start": "1 kPa", "stop": "1 MPa", "num": 4, "spacing": "log"},
    ...           place="grid", distinct=True).values
    (1000.0, 10000.0, 100000.0, 1000000.0)
    """
    field = scene_field(field_name)
    name = f"{place} {field.name}"
    values: Sequence[object]
    if isinstance(given, Mapping):
        values = _range(field, given, name)
    else:
        values = [field.read(value, f"{name}[{index}]") for index, value in enumerate(_listed(given, name))]
    labels = [_label(value) for value in values]
    if distinct:
        _require_distinct(labels, name)
    return Axis(field, tuple(values), tuple(labels))


def _listed(given: object, name: str) -> Sequence[object]:
    """The values as a list; an array of numbers is one too."""
    to_list = getattr(given, "tolist", None)
    listed = to_list() if to_list is not None else given
    if not isinstance(listed, list | tuple):
        raise WrongType(f"{name} = {shown(given)}", allowed="allowed a list of values, or a range",
                        remedy="Write it like [1.0, 1.5], or like { start = 1.0, stop = 2.0, num = 11 }.")
    if not listed:
        raise SweepEmpty(f"{name} = []", allowed="needed: at least one value", remedy="Give it a value, or delete it.")
    if len(listed) > MOST_VALUES:
        raise _too_many(len(listed), name)
    return listed


def _range(field: SceneField, given: Mapping[str, object], name: str) -> list[float]:
    for key in given:
        if key not in RANGE_KEYS:
            raise UnknownKey(f"{name} has the key {shown(key)}", allowed=f"allowed {', '.join(RANGE_KEYS)}",
                             remedy=f"Write {nearest(str(key), RANGE_KEYS, cutoff=0.0)}, or delete it.")
    for key in RANGE_KEYS[:3]:
        if key not in given:
            raise MissingKey(f"{name} has no {key}", allowed="a range needs start, stop and num", remedy=f"Add {key}.")
    if not field.is_number:
        raise WrongType(f"{name} is a range", allowed="allowed a list, for its values are no numbers",
                        remedy='Write it like ["kinematic", "static"].')
    spacing = chosen(given.get("spacing", "linear"), SPACINGS, name=f"{name} spacing")
    start, stop = (_number(field.read(given[end], f"{name} {end}")) for end in ("start", "stop"))
    count = _count(given["num"], name)
    if spacing == "linear":
        return _linear(start, stop, count)
    if start * stop <= 0:
        raise ValueOutOfRange(f"{name} from {start!r} to {stop!r}",
                              allowed="allowed ends of the same sign, neither of them zero, where the spacing is log",
                              remedy="Take another end, or a linear spacing.")
    return _logarithmic(start, stop, count)


def _number(value: object) -> float:
    assert isinstance(value, float)  # the kind of the field has read it
    return value


def _count(given: object, name: str) -> int:
    if isinstance(given, bool) or not isinstance(given, int):
        raise WrongType(f"{name} num = {shown(given)}", allowed="allowed a whole number",
                        remedy="Give the number of values, both ends among them.")
    if given < 1:
        raise SweepEmpty(f"{name} num = {given}", allowed="needed: at least one value",
                         remedy="Give the number of values, both ends among them.")
    if given > MOST_VALUES:
        raise _too_many(given, name)
    if given == 1:
        raise ValueOutOfRange(f"{name} num = 1", allowed="allowed 2 and more, for a range has two ends",
                              remedy="Write a single value as a list of one.")
    return given


def _too_many(count: int, name: str) -> SweepTooLarge:
    return SweepTooLarge(f"{name} has {count} values", allowed=f"allowed up to {MOST_VALUES} for one field",
                         remedy="Give fewer, or make several sweeps.")


def _linear(start: float, stop: float, count: int) -> list[float]:
    first, last = Fraction(repr(start)), Fraction(repr(stop))
    return [float(first + (last - first) * Fraction(place, count - 1)) for place in range(count)]


def _logarithmic(start: float, stop: float, count: int) -> list[float]:
    with localcontext() as context:
        context.prec = _DIGITS
        first, growth = Decimal(repr(start)), (Decimal(repr(stop)) / Decimal(repr(start))).ln()
        inner = [float(first * (growth * place / (count - 1)).exp()) for place in range(1, count - 1)]
    return [start, *inner, stop]


def _label(value: object) -> Any:
    """A number or a word as it is; a list or a tensor as text."""
    return value if isinstance(value, float) else str(value) if isinstance(value, str) else json.dumps(value)


def _require_distinct(labels: Sequence[float | str], name: str) -> None:
    seen: dict[float | str, int] = {}
    for place, label in enumerate(labels):
        if label in seen:
            raise ConflictingKeys(f"{name}[{place}] = {shown(label)} stands there already, as [{seen[label]}]",
                                  allowed="allowed each value once in a grid", remedy="Delete one of the two.")
        seen[label] = place
