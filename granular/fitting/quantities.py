"""What can be measured: wave speeds, stiffness components, and ratios of either, as powers of the six components."""

from __future__ import annotations

import re
from dataclasses import dataclass
from fractions import Fraction

from granular.errors import MissingKey, UnknownChoice, ValueOutOfRange, WrongType
from granular.fields import nearest
from granular.routes.result import COMPONENTS
from granular.units import PRESSURE, Dimension, finite_number, in_si, shown

SPEED = Dimension("speed", "m/s", "412 m/s", {
    "m/s": Fraction(1), "km/s": Fraction(1000), "mm/us": Fraction(1000), "mm/µs": Fraction(1000),
    "ft/s": Fraction(3048, 10**4),
})

SPEEDS = {
    "Vp_vertical": "C3333", "Vp_horizontal": "C1111",
    "Vs_vertical": "C2323", "Vs_vh": "C2323", "Vs_hv": "C2323", "Vs_hh": "C1212",
}
"""Wave speeds and the component that density times their square is. In Vs_vh the wave travels vertically and is
polarised horizontally, in Vs_hv the other way round, in Vs_hh both are horizontal; Vs_vertical is Vs_vh."""

SHEAR = ("C2323", "C1212")
"""Components that a factor of the shear stiffness acts on; the other four go with compression."""

PURE = Dimension("pure number", "", "0.85", {})
"""Ratios: no unit."""


@dataclass(frozen=True, slots=True)
class Quantity:
    """Something measured, as a product of powers of the six components and of the density.

    Attributes
    ----------
    name : str
        As the file calls it.
    dimension : Dimension
        What it measures.
    powers : tuple of 6 float
        Power of C1111, C3333, C1122, C1133, C2323, C1212 in it [-].
    density_power : float
        Power of the bulk density [-].
    """

    name: str
    dimension: Dimension
    powers: tuple[float, ...]
    density_power: float = 0.0


def quantity(name: str) -> Quantity:
    """Look up what a name measures.

    Parameters
    ----------
    name : str
        A wave speed, a component such as C2323, or a ratio of two of one kind such as C1111/C3333.

    Returns
    -------
    Quantity
        Its powers.

    Raises
    ------
    UnknownChoice
        Another name, or a ratio of a speed and a component.

    Notes
    -----
    Source: density times the square of the speed is the component, for waves along and across the axis.

    Examples
    --------
    >>> quantity("Vs_hh/Vs_vh").powers
    (0.0, 0.0, 0.0, 0.0, -0.5, 0.5)
    """
    parts = name.split("/")
    if len(parts) == 2:
        above, below = (_single(part, name) for part in parts)
        if above.dimension is not below.dimension:
            raise UnknownChoice(f"measured quantity {shown(name)}",
                                allowed="allowed ratios of two speeds or of two components",
                                remedy="Write a ratio of two quantities of one kind, such as C1111/C3333.")
        powers = tuple(a - b for a, b in zip(above.powers, below.powers, strict=True))
        return Quantity(name, PURE, powers)
    return _single(name, name)


def _single(name: str, whole: str) -> Quantity:
    if name in COMPONENTS:
        return Quantity(name, PRESSURE, tuple(float(name == one) for one in COMPONENTS))
    if name in SPEEDS:
        return Quantity(name, SPEED, tuple(0.5 * (SPEEDS[name] == one) for one in COMPONENTS), -0.5)
    known = (*SPEEDS, *COMPONENTS)
    near = nearest(name, known)
    raise UnknownChoice(f"measured quantity {shown(whole)}",
                        allowed=f"allowed {', '.join(known)}, and ratios such as C1111/C3333",
                        remedy=f"Did you mean {near}?" if near else "Write one of these names.")


_PLUS_MINUS = re.compile(r"\+-|\+/-|±")


def reading(value: object, kind: Quantity) -> tuple[float, float]:
    """Read a measured value with its uncertainty, one standard deviation.

    Parameters
    ----------
    value : str or dict
        Such as "412 m/s +- 4 m/s", "412 +- 4 m/s", "412 m/s +- 1 %", or {value = ..., uncertainty = ...}.
    kind : Quantity
        What was measured.

    Returns
    -------
    tuple of 2 float
        Value and standard uncertainty, both above zero [SI].

    Raises
    ------
    MissingKey
        No uncertainty.
    ValueOutOfRange
        A value or an uncertainty that is not above zero.
    WrongType, UnitUnknown, UnitOfOtherDimension, QuantityUnreadable, NotFinite
        No such quantity.

    Notes
    -----
    Accuracy: one rounding each. Source: the format of the data file.

    Examples
    --------
    >>> reading("412 +- 4 m/s", quantity("Vs_vh"))
    (412.0, 4.0)
    >>> reading({"value": 0.5, "uncertainty": "50 %"}, quantity("C1111/C3333"))
    (0.5, 0.25)
    """
    given, uncertain = _parts(value, kind.name)
    size = _size(given, kind, kind.name, unit_of=uncertain)
    if isinstance(uncertain, str) and uncertain.rstrip().endswith("%"):
        share = _plain(uncertain.rstrip()[:-1], f"uncertainty of {kind.name}") / 100
        spread = share * size
    else:
        spread = _size(uncertain, kind, f"uncertainty of {kind.name}")
    for name, number in ((kind.name, size), (f"uncertainty of {kind.name}", spread)):
        if not number > 0:
            raise ValueOutOfRange(f"{name} = {number!r}", allowed=f"allowed {name} > 0",
                                  remedy="Give one standard deviation, as large as repeated measurements scatter.")
    return size, spread


def _parts(value: object, name: str) -> tuple[object, object]:
    """The value and its uncertainty as they are written."""
    if isinstance(value, dict):
        unknown = [key for key in value if key not in ("value", "uncertainty")]
        if unknown:
            raise UnknownChoice(f"{name}.{unknown[0]}", allowed="allowed value and uncertainty",
                                remedy=f"Delete {unknown[0]}.")
        for key in ("value", "uncertainty"):
            if key not in value:
                raise MissingKey(f"{key} of {name} is not given", allowed="needed: value and uncertainty",
                                 remedy=f"Add {key}.")
        return value["value"], value["uncertainty"]
    if isinstance(value, str):
        parts = _PLUS_MINUS.split(value)
        if len(parts) == 2:
            return parts[0].strip(), parts[1].strip()
        if len(parts) > 2:
            raise WrongType(f"{name} = {shown(value)}", allowed="allowed one value and one uncertainty",
                            remedy='Write it like "412 m/s +- 4 m/s".')
    raise MissingKey(f"uncertainty of {name} is not given", allowed="needed: every measured value with its uncertainty",
                     remedy='Write it like "412 m/s +- 4 m/s", or {value = "412 m/s", uncertainty = "1 %"}.')


def _size(value: object, kind: Quantity, name: str, *, unit_of: object = None) -> float:
    """A number with its unit; a value may leave the unit to its uncertainty, as in 412 +- 4 m/s."""
    if kind.dimension is PURE:
        return _plain(value, name)
    if isinstance(value, str) and isinstance(unit_of, str) and _is_number(value):
        unit = unit_of.lstrip("+-.0123456789eE ")
        if unit and not unit.startswith("%"):
            return in_si(f"{value} {unit}", kind.dimension, name=name)
    return in_si(value, kind.dimension, name=name)


def _plain(value: object, name: str) -> float:
    if isinstance(value, str) and _is_number(value):
        return finite_number(float(value), name=name)
    return finite_number(value, name=name)


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True
