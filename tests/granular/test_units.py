"""Quantities: the table of common units against pint, and every way of writing one wrongly."""

from __future__ import annotations

import contextlib
import math
import pickle
import subprocess
import sys
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from granular.errors import (
    GranularError,
    NotFinite,
    QuantityUnreadable,
    UnitOfOtherDimension,
    UnitUnknown,
    WrongType,
)
from granular.units import ANGLE, DENSITY, DIMENSIONS, LENGTH, PRESSURE, finite_number, in_si, shown

pint = pytest.importorskip("pint")
REGISTRY = pint.UnitRegistry()

TABLE = [(dimension, unit) for dimension in DIMENSIONS for unit in dimension.units]


@pytest.mark.parametrize(("dimension", "unit"), TABLE, ids=[unit for _, unit in TABLE])
def test_every_entry_of_the_table_agrees_with_pint(dimension, unit):
    # Breaks when a size is mistyped. pint multiplies floats, so 4 ulp (psi goes through pounds and inches).
    by_pint = REGISTRY.Quantity(1.0, unit).to(dimension.si).magnitude
    assert float(dimension.units[unit]) == pytest.approx(by_pint, rel=4 * 2.0**-52, abs=0.0)


@pytest.mark.parametrize(("text", "dimension", "value"), [
    ("28 kPa", PRESSURE, 28e3), ("28kPa", PRESSURE, 28e3), ("  28   kPa ", PRESSURE, 28e3),
    ("31 GPa", PRESSURE, 31e9), ("+.5e1 bar", PRESSURE, 5e5), ("2. MPa", PRESSURE, 2e6), ("-28 kPa", PRESSURE, -28e3),
    ("2650 kg/m^3", DENSITY, 2650.0), ("2.65 g/cm^3", DENSITY, 2650.0), ("2.65 Mg/m^3", DENSITY, 2650.0),
    ("5 mm", LENGTH, 0.005), ("5.1 mm", LENGTH, 0.0051), ("0.3 mm", LENGTH, 0.0003), ("75 um", LENGTH, 75e-6),
    ("180 deg", ANGLE, math.pi), ("0.5 rad", ANGLE, 0.5), ("12°", ANGLE, math.radians(12)),
    ("1 kgf/cm^2", PRESSURE, 98066.5), ("1 furlong", LENGTH, 201.168), ("1 turn", ANGLE, 2 * math.pi),
    ("3 N m^-2", PRESSURE, 3.0), ("1 kN / m^2", PRESSURE, 1e3), ("7 torr", PRESSURE, 7 * 101325 / 760),
])
def test_reads_a_number_and_a_unit(text, dimension, value):
    # Breaks when a way of writing is dropped. Units of the table are rounded once; pint's survey furlong differs
    # from the international one by 2e-6.
    assert in_si(text, dimension) == pytest.approx(value, rel=3e-6 if "furlong" in text else 2.0**-51)


@given(st.decimals(min_value="1e-30", max_value="1e30", allow_nan=False, allow_infinity=False, places=12),
       st.sampled_from([(d, u) for d, u in TABLE if isinstance(d.units[u], Fraction)]))
def test_a_string_is_rounded_once(number, entry):
    # Breaks when a size is multiplied as a float: "5.1 mm" must be the very double that 0.0051 is.
    dimension, unit = entry
    assert in_si(f"{number} {unit}", dimension) == float(Fraction(str(number)) * dimension.units[unit])


@given(st.floats(allow_nan=False, allow_infinity=False) | st.integers(-10**300, 10**300))
def test_bare_numbers_are_si(number):
    # Breaks when a number without a unit is scaled.
    assert all(in_si(number, dimension) == float(number) for dimension in DIMENSIONS)


@pytest.mark.parametrize(("value", "dimension", "kind"), [
    ("28 kg", PRESSURE, UnitOfOtherDimension), ("28 mm", PRESSURE, UnitOfOtherDimension),
    ("28 kPa kPa", PRESSURE, UnitOfOtherDimension), ("28 m^99", LENGTH, UnitOfOtherDimension),
    ("28 degC", PRESSURE, UnitOfOtherDimension), ("28 degC", ANGLE, UnitOfOtherDimension),
    ("12 percent", ANGLE, UnitOfOtherDimension), ("12 dB", ANGLE, UnitOfOtherDimension),
    ("0.2 m/m", ANGLE, UnitOfOtherDimension), ("2650 kg", DENSITY, UnitOfOtherDimension),
    ("28 kPs", PRESSURE, UnitUnknown), ("28 kpa", PRESSURE, UnitUnknown), ("0x10 Pa", PRESSURE, UnitUnknown),
    ("28", PRESSURE, QuantityUnreadable), ("kPa", PRESSURE, QuantityUnreadable),
    ("", PRESSURE, QuantityUnreadable), ("   ", PRESSURE, QuantityUnreadable),
    ("about 28 kPa", PRESSURE, QuantityUnreadable), ("−28 kPa", PRESSURE, QuantityUnreadable),
    ("28,5 kPa", PRESSURE, QuantityUnreadable), ("1_000 Pa", PRESSURE, QuantityUnreadable),
    ("nan Pa", PRESSURE, QuantityUnreadable), ("inf Pa", PRESSURE, QuantityUnreadable),
    ("28 kPa; import os", PRESSURE, QuantityUnreadable), ("28 __import__('os')", PRESSURE, QuantityUnreadable),
    ("9 m**9**9**9", LENGTH, QuantityUnreadable), ("9 m^999999999", LENGTH, QuantityUnreadable),
    ("1" * 101 + " Pa", PRESSURE, QuantityUnreadable), ("1 " + "m" * 5000, LENGTH, QuantityUnreadable),
    ("1e400 Pa", PRESSURE, NotFinite), ("1e999999999 Pa", PRESSURE, NotFinite), ("1e308 GPa", PRESSURE, NotFinite),
    (math.nan, PRESSURE, NotFinite), (math.inf, PRESSURE, NotFinite), (-math.inf, PRESSURE, NotFinite),
    (10**400, PRESSURE, NotFinite), (-(10**5000), PRESSURE, NotFinite),
    (True, PRESSURE, WrongType), (None, PRESSURE, WrongType), ([28.0], PRESSURE, WrongType),
    ({"a": 1}, PRESSURE, WrongType), (1j, PRESSURE, WrongType), (b"28 kPa", PRESSURE, WrongType),
    (np.array([1.0, 2.0]), PRESSURE, WrongType), (REGISTRY.Quantity(28, "kg"), PRESSURE, UnitOfOtherDimension),
    (REGISTRY.Quantity(math.nan, "Pa"), PRESSURE, NotFinite),
], ids=lambda item: shown(item)[:30])
def test_refuses_what_is_no_quantity(value, dimension, kind):
    # Breaks when a wrong quantity passes, or is refused without its name, on several lines, or as the wrong kind.
    with pytest.raises(kind) as refused:
        in_si(value, dimension, name="mean")
    message = str(refused.value)
    assert "mean" in message
    assert "\n" not in message
    assert len(message) < 400
    assert pickle.loads(pickle.dumps(refused.value)).args == refused.value.args


def test_suggests_the_right_capitals():
    # Breaks when "28 kpa" is refused without saying what was meant.
    with pytest.raises(UnitUnknown, match=r"Did you mean kPa\?"):
        in_si("28 kpa", PRESSURE)


def test_takes_pint_quantities_and_numpy_scalars():
    # Breaks when values that Python users have at hand are refused.
    assert in_si(REGISTRY.Quantity(3, "MPa"), PRESSURE) == 3e6
    assert in_si(np.float32(2.5), PRESSURE) == 2.5
    assert in_si(np.int64(3), PRESSURE) == 3.0
    assert in_si(Fraction(1, 4), PRESSURE) == 0.25


@given(st.text(max_size=40))
def test_any_text_is_read_or_refused_in_one_line(text):
    # Breaks when some text gets a traceback of pint or of the number parser.
    try:
        value = in_si(text, LENGTH)
    except GranularError as refused:
        assert len(str(refused).splitlines()) == 1
    else:
        assert math.isfinite(value)


@given(st.from_regex(r"\A[0-9]{1,3} [A-Za-z]{1,6}([*/ ][a-zA-Z]{1,6}){0,2}(\^-?[0-9]{1,2})?\Z"))
def test_any_product_of_names_is_read_or_refused(text):
    # Breaks when pint raises something that is not foreseen.
    with contextlib.suppress(GranularError):
        assert math.isfinite(in_si(text, PRESSURE))


def test_zero_needs_no_care_and_underflow_is_zero():
    # Breaks when the exact product is attempted with a huge negative exponent.
    assert in_si("0 Pa", PRESSURE) == 0.0
    assert in_si("1e-999999999 Pa", PRESSURE) == 0.0


def test_common_units_need_no_pint():
    # Breaks when the table is bypassed: pint costs as much as everything else in a run.
    code = ("import sys; from granular.units import in_si, DIMENSIONS\n"
            "for d in DIMENSIONS:\n    for u in d.units: in_si(f'1 {u}', d)\n"
            "try: in_si('28 mm', DIMENSIONS[0])\nexcept ValueError: pass\n"
            "sys.exit('pint' in sys.modules)")
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


@pytest.mark.parametrize(("value", "text"), [
    ("28 kg", '"28 kg"'), (True, "true"), ("a\nb\x07", '"a\\nb\\x07"'), ("x" * 100, '"' + "x" * 60 + '..."'),
    (10**400, "an integer of 401 digits"), (-(10**400), "-an integer of 401 digits"), ({}, "an empty table"),
    ({"a": 1}, "a table"), ([1, [True]], "[1, [true]]"), ('say "x"', '"say \\"x\\""'), (0.1, "0.1"),
])
def test_shows_values_on_one_line(value, text):
    # Breaks when a hostile value can fill the screen or move its cursor.
    assert shown(value) == text


@pytest.mark.parametrize("value", ["0.21", " 0.21 ", "1e-3"])
def test_a_number_in_quotation_marks_is_told_to_lose_them(value):
    # Breaks when the remedy for a quoted number is anything but deleting the quotation marks.
    with pytest.raises(WrongType, match="without quotation marks"):
        finite_number(value)
