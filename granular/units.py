"""Quantities as they are written in a scene: SI numbers, or strings with a unit such as "28 kPa".

pint is the authority on units. Importing it costs more than everything else a single run does, so the field's
common units are answered from the explicit table below, every entry of which a test holds against pint; any
other unit goes to pint.
"""

from __future__ import annotations

import math
import re
import sys
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cache
from numbers import Real
from typing import Any, NoReturn

from granular.errors import NotFinite, QuantityUnreadable, UnitOfOtherDimension, UnitUnknown, WrongType

_LONGEST = 100
"""No number and no unit is longer than this; keeps hostile text from costing time."""

_SHOWN = 60
"""Longer values are cut in messages."""


@dataclass(frozen=True, slots=True)
class Dimension:
    """What a quantity measures, and the units of it that need no pint.

    Attributes
    ----------
    name : str
        Name in messages, e.g. ``"pressure"``.
    si : str
        The SI unit, as pint reads it.
    example : str
        A value as a user would write it.
    units : dict
        Unit as written -> size in SI units, as an exact decimal or ratio where it has one [SI].
    """

    name: str
    si: str
    example: str
    units: dict[str, Fraction | float] = field(repr=False)


_PSI = Fraction("4.4482216152605") / Fraction("0.0254") ** 2

PRESSURE = Dimension("pressure", "Pa", "28 kPa", {
    "Pa": Fraction(1), "N/m^2": Fraction(1), "hPa": Fraction(10**2), "mbar": Fraction(10**2),
    "kPa": Fraction(10**3), "kN/m^2": Fraction(10**3), "bar": Fraction(10**5), "atm": Fraction(101325),
    "MPa": Fraction(10**6), "N/mm^2": Fraction(10**6), "MN/m^2": Fraction(10**6),
    "GPa": Fraction(10**9), "kN/mm^2": Fraction(10**9),
    "psi": _PSI, "ksi": 1000 * _PSI,
})
ANGLE = Dimension("angle", "rad", "12 deg", {
    "rad": Fraction(1), "radian": Fraction(1), "radians": Fraction(1),
    "deg": math.pi / 180, "degree": math.pi / 180, "degrees": math.pi / 180, "°": math.pi / 180,
})
DENSITY = Dimension("density", "kg/m^3", "2650 kg/m^3", {
    "kg/m^3": Fraction(1), "kg/m**3": Fraction(1), "kg/m³": Fraction(1), "g/l": Fraction(1),
    "g/cm^3": Fraction(10**3), "g/cm**3": Fraction(10**3), "g/cm³": Fraction(10**3),
    "Mg/m^3": Fraction(10**3), "t/m^3": Fraction(10**3), "kg/l": Fraction(10**3),
})
LENGTH = Dimension("length", "m", "5 mm", {
    "m": Fraction(1), "dm": Fraction(1, 10), "cm": Fraction(1, 10**2), "mm": Fraction(1, 10**3),
    "um": Fraction(1, 10**6), "µm": Fraction(1, 10**6), "μm": Fraction(1, 10**6),
    "micron": Fraction(1, 10**6), "nm": Fraction(1, 10**9), "km": Fraction(10**3),
    "in": Fraction(254, 10**4), "inch": Fraction(254, 10**4), "ft": Fraction(3048, 10**4),
})
DIMENSIONS = (PRESSURE, ANGLE, DENSITY, LENGTH)
"""Every dimension that a scene knows."""

_QUANTITY = re.compile(r"([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(.*)")
_FACTOR = r"[^\W\d_]\w*(?:\s*(?:\^|\*\*)\s*-?\d{1,2}|[²³])?"
_UNIT = re.compile(rf"(?:°|{_FACTOR}(?:\s*[*/·]\s*{_FACTOR}|\s+{_FACTOR})*)")


def in_si(value: object, dimension: Dimension, *, name: str = "value") -> float:
    """Read a quantity and return it in SI units.

    Parameters
    ----------
    value : number, str or pint.Quantity
        A bare number is in SI units; a string is a decimal number and a unit.
    dimension : Dimension
        What the quantity must measure.
    name : str
        Name used in messages.

    Returns
    -------
    float
        The value [SI].

    Accuracy
    --------
    A string whose unit is in the table and has an exact size is rounded once: ``"5.1 mm"`` is the double
    nearest to 0.0051. Degrees, and units read by pint, are good to 2 units of the last place.

    Raises
    ------
    UnitUnknown, UnitOfOtherDimension, QuantityUnreadable, NotFinite, WrongType
        The value is no quantity of this dimension.

    Notes
    -----
    Source: the SI; unit definitions as in pint.

    Examples
    --------
    >>> in_si("28 kPa", PRESSURE), in_si(28e3, PRESSURE)
    (28000.0, 28000.0)
    """
    if isinstance(value, str):
        return _from_text(value, dimension, name)
    if (quantity := _pint_quantity(value)) is not None:
        return _from_pint(quantity, dimension, name)
    return finite_number(value, name=name, wanted=f'a number in {dimension.si} or a string such as '
                                                  f'"{dimension.example}"')


def finite_number(value: object, *, name: str = "value", wanted: str = "a number") -> float:
    """Read a finite real number; a truth value or a string is none.

    Parameters
    ----------
    value : object
        What was given.
    name, wanted : str
        Name of the value and description of what belongs there, for messages.

    Returns
    -------
    float
        The number [as given].

    Raises
    ------
    WrongType, NotFinite
        It is no real number, is NaN or infinite, or does not fit into double precision.

    Notes
    -----
    Source: IEEE 754 double precision.

    Examples
    --------
    >>> finite_number(3)
    3.0
    """
    if isinstance(value, bool) or not isinstance(value, Real):
        raise WrongType(f"{name} = {shown(value)}", allowed=f"allowed {wanted}", remedy=_number_remedy(value))
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
    if not math.isfinite(number):
        raise NotFinite(f"{name} = {shown(value)}",
                        allowed=f"allowed finite numbers up to {sys.float_info.max:.3g} in size",
                        remedy="Give a finite number.")
    return number


def _number_remedy(value: object) -> str:
    if isinstance(value, bool):
        return "Give a number; true and false are not numbers."
    if isinstance(value, str):
        try:
            float(value)
        except ValueError:
            return "Give a number."
        return f"Write the number without quotation marks: {shown(value)[1:-1]}."
    return "Give one number."


def shown(value: object) -> str:
    """Show a value in a message: as TOML would write it, on one line, cut when it is long.

    Parameters
    ----------
    value : object
        Anything.

    Returns
    -------
    str
        One line of at most some 60 characters.

    Notes
    -----
    Source: the error format of this package.

    Examples
    --------
    >>> shown("28 kg"), shown(True), shown([1, [2]])
    ('"28 kg"', 'true', '[1, [2]]')
    """
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        text = _cut(value).translate({34: '\\"'})
        return '"' + "".join(c if c.isprintable() else repr(c)[1:-1] for c in text) + '"'
    if isinstance(value, dict):
        return "a table" if value else "an empty table"
    if isinstance(value, int) and value.bit_length() > 200:
        return f"{'-' if value < 0 else ''}an integer of {int(value.bit_length() * 0.30103) + 1} digits"
    if isinstance(value, (list, tuple)):
        return _cut("[" + ", ".join(_cut(shown(item)) for item in value[:_SHOWN]) + "]")
    return _cut(" ".join(repr(value).split()))


def shown_path(path: str) -> str:
    """Show a path in a message: on one line, and when it is long without its beginning, for the name is at the end.

    Parameters
    ----------
    path : str
        Any path.

    Returns
    -------
    str
        One line of at most some 60 characters.

    Notes
    -----
    Source: the error format of this package.

    Examples
    --------
    >>> shown_path("curve.csv"), shown_path("/data/" + 60 * "x" + "/curve.csv")[-14:]
    ('"curve.csv"', 'xxx/curve.csv"')
    """
    return shown(path if len(path) <= _SHOWN else "..." + path[3 - _SHOWN:])


def _cut(text: str) -> str:
    return text if len(text) <= _SHOWN else text[:_SHOWN] + "..."


def _from_text(text: str, dimension: Dimension, name: str) -> float:
    match = _QUANTITY.fullmatch(text.strip()) if len(text) <= 2 * _LONGEST else None
    if match is None or len(match[1]) > _LONGEST:
        _unreadable(text, dimension, name)
    number, unit = match[1], " ".join(match[2].split())
    if not math.isfinite(float(number)):
        raise NotFinite(f"{name} = {shown(text)}",
                        allowed=f"allowed finite numbers up to {sys.float_info.max:.3g} in size",
                        remedy="Give a finite number.")
    if not unit:
        raise QuantityUnreadable(f"{name} = {shown(text)}", allowed="a string needs a unit",
                                 remedy=f'Write "{number} {dimension.si}", or the bare number {number}.')
    size = dimension.units.get(unit)
    if size is None:
        size = _size_by_pint(unit, text, dimension, name)
    return _scaled(number, size, text, name)


def _scaled(number: str, size: Fraction | float, text: str, name: str) -> float:
    """Multiply exactly where the unit has an exact size, so that the result is rounded once."""
    if float(number) == 0.0:
        return float(number)
    try:
        value = float(Fraction(number) * size)
    except OverflowError:
        value = math.inf
    if not math.isfinite(value):
        raise NotFinite(f"{name} = {shown(text)}",
                        allowed=f"allowed finite numbers up to {sys.float_info.max:.3g} in size",
                        remedy="Give a finite number.")
    return value


def _unreadable(text: str, dimension: Dimension, name: str) -> NoReturn:
    raise QuantityUnreadable(f"{name} = {shown(text)}",
                             allowed="a string must be a decimal number followed by a unit",
                             remedy=f'Write it like "{dimension.example}", or as a number in {dimension.si}.')


@cache
def _registry() -> Any:
    import pint  # 0.2 s, and only for units that the table lacks

    return pint.UnitRegistry()


def _size_by_pint(unit: str, text: str, dimension: Dimension, name: str) -> float:
    """Size of a unit by pint. Only names, small powers, products and quotients get there: pint evaluates."""
    for other in DIMENSIONS:
        if unit in other.units:
            _other_dimension(text, dimension, name, f"{unit} is a unit of {other.name}")
    if len(unit) > _LONGEST or not _UNIT.fullmatch(unit):
        _unreadable(text, dimension, name)
    registry = _registry()
    try:
        size, base = registry.get_base_units(unit)
    except (AttributeError, ArithmeticError, AssertionError, LookupError, SyntaxError, TypeError, ValueError):
        # pint's UndefinedUnitError is an AttributeError, its OffsetUnitCalculusError a TypeError
        raise UnitUnknown(f"{name} = {shown(text)}", allowed=f"the unit {shown(unit)} is not known",
                          remedy=f"{_nearest(unit, dimension)}Use a unit of {dimension.name} such as "
                                 f"{_common(dimension)}.") from None
    if base != registry.get_base_units(dimension.si)[1]:
        dimensionality = str(registry.get_dimensionality(unit))
        measured = dimensionality.translate({91: None, 93: None}).replace(" ** ", "^")
        none = measured == "dimensionless"
        _other_dimension(text, dimension, name,
                         f"{unit} has no dimension" if none else f"{unit} is a unit of {measured}")
    return float(size)


def _other_dimension(text: str, dimension: Dimension, name: str, measured: str) -> NoReturn:
    raise UnitOfOtherDimension(f"{name} = {shown(text)}",
                               allowed=f"allowed units of {dimension.name} ({measured})",
                               remedy=f"Use a unit such as {_common(dimension)}.")


def _common(dimension: Dimension) -> str:
    return ", ".join(list(dimension.units)[:7])


def _nearest(unit: str, dimension: Dimension) -> str:
    """Suggest the unit that differs in capitals only: kpa is no unit, and MPa and mPa are both."""
    same = [known for known in dimension.units if known.lower() == unit.lower()]
    return f"Did you mean {' or '.join(same)}? " if same else ""


def _pint_quantity(value: object) -> Any:
    """Return the value when it is a pint quantity; pint need not be loaded to know that it is none."""
    pint = sys.modules.get("pint")
    return value if pint is not None and isinstance(value, pint.Quantity) else None


def _from_pint(quantity: Any, dimension: Dimension, name: str) -> float:
    import pint

    try:
        magnitude = quantity.to(dimension.si).magnitude
    except pint.PintError:
        _other_dimension(str(quantity), dimension, name, f"this is {quantity.dimensionality}")
    return finite_number(magnitude, name=name)
