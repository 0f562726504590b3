"""Reading measured curves: every way to write the same curve, and one clear sentence for everything that is wrong."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from granular import errors
from granular.errors import GranularError
from granular.gradation import MeasuredCurve, read_curve
from granular.reading import LARGEST

SIEVES = MeasuredCurve(["0.5 mm", "1 mm", "2 mm"], [0.0, 0.4, 1.0])


def written(folder, text):
    path = folder / "curve.csv"
    path.write_bytes(text if isinstance(text, bytes) else text.encode("utf-8"))
    return path


@pytest.mark.parametrize("text", [
    "size [mm], fraction finer\n0.5, 0\n1, 0.4\n2, 1\n",
    "size (mm);finer\n2;1\n1;0.4\n0.5;0\n",
    "size_mm\tfiner\n0.5\t0\n1\t.4\n2\t1",
    "0.0005,0\n0.001,0.4\n0.002,1\n",
    "0.5 mm, 0\n1000 um, 0.4\n0.2 cm, 1\n",
    "size [cm], finer\n0.5 mm, 0\n0.1, 0.4\n0.2, 1.0\n",
    "size, finer\n5e-4, 0\n1e-3, 4e-1\n2e-3, 1\n",
    "# a sieve report\n\n  # of two lines\nsize [mm], finer\n0.5, 0\n1, 0.4\n\n2, 1\n",
    "\ufeff\"size [mm]\",\"finer\",,\r\n\"0.5\",\"0\",,\r\n1,0.4,,\r\n2,1,,\r\n",
    "size [mm], finer\n1, 0.4\n2, 1\n0.5, 0\n",
], ids=["commas", "semicolons, descending", "tabs, underscore", "metres", "units in cells", "unit in a cell first",
        "header without unit", "comments", "spreadsheet", "unsorted"])
def test_the_same_curve_in_other_writings(tmp_path, text):
    # Breaks when a separator, an order of rows, or a place of the unit is misread; sizes are rounded once, so equal.
    assert read_curve(written(tmp_path, text)) == SIEVES


WRONG = [
    ("empty", "", "CurveMalformed", ["no points", "two points or more"]),
    ("only a header", "size [mm], finer\n", "CurveMalformed", ["no points"]),
    ("one row", "1, 1\n", "CurveMalformed", ["1 point,"]),
    ("one column", "size\n1\n2\n", "CurveMalformed", ["line 1 has 1 column,"]),
    ("three columns", "1, 0\n2, 1, 5\n", "CurveMalformed", ["line 2 has 3 columns"]),
    ("decimal commas", "0,5;0\n1,0;1\n", "CurveMalformed", ["line 1", '"0,5"']),
    ("no size", "1, 0\nbig, 1\n", "CurveMalformed", ["line 2: size", '"big"']),
    ("no fraction", "1, 0\n2, all\n", "CurveMalformed", ["line 2: fraction", '"all"']),
    ("NaN", "1, 0\n2, nan\n", "CurveMalformed", ["line 2: fraction", "nan"]),
    ("not UTF-8", b"1, 0\n\xff, 1\n", "CurveMalformed", ["byte at position 5"]),
    ("negative size", "-1, 0\n2, 1\n", "ValueOutOfRange", ["line 1: size", '"-1 m"']),
    ("size of zero", "size [mm], finer\n0, 0\n2, 1\n", "ValueOutOfRange", ["line 2: size", '"0 mm"']),
    ("infinite size", "1, 0\n1e999, 1\n", "NotFinite", ["line 2: size", "1e999"]),
    ("infinite fraction", "1, 0\n2, 1e999\n", "NotFinite", ["line 2: fraction"]),
    ("unknown unit in the header", "size [mmm], finer\n1, 0\n2, 1\n", "UnitUnknown", ["line 1", "mmm"]),
    ("unit of mass in the header", "size [kg], finer\n1, 0\n2, 1\n", "UnitOfOtherDimension", ["line 1", "kg"]),
    ("unknown unit in a cell", "1 mmm, 0\n2 mm, 1\n", "UnitUnknown", ["line 1: size", "mmm"]),
    ("unit of mass in a cell", "1 mm, 0\n2 kg, 1\n", "UnitOfOtherDimension", ["line 2: size", "kg"]),
    ("percent", "1, 0\n2, 40\n3, 100\n", "CurveInPercent", ["100.0", "Divide the second column by 100"]),
    ("percent with rounding", "1, 0\n2, 40\n3, 100.2\n", "CurveInPercent", ["100.2"]),
    ("fine end of percent", "1, 0\n2, 1.6\n", "CurveInPercent", ["1.6"]),
    ("percent signs", "1, 0%\n2, 100 %\n", "CurveInPercent", ["line 1: fraction", "0%"]),
    ("fraction above one", "1, 0\n2, 1.2\n", "ValueOutOfRange", ["line 2 is 1.2", "0 <= fraction <= 1"]),
    ("fraction far above", "1, 0\n2, 1000\n", "ValueOutOfRange", ["line 2 is 1000"]),
    ("negative fraction", "1, -0.1\n2, 1\n", "ValueOutOfRange", ["line 1 is -0.1"]),
    ("falls", "1, 0\n2, 0.6\n3, 0.4\n4, 1\n", "CurveNotMonotone", ["0.6 (line 2, 2.0 m)", "0.4 (line 3, 3.0 m)"]),
    ("fraction coarser", "1, 1\n2, 0\n", "CurveNotMonotone", ["fraction coarser"]),
    ("one size twice", "1, 0\n2, 0.5\n2, 1\n", "CurveNotMonotone", ["line 2 and line 3", "same size 2.0 m"]),
    ("sizes too close", "1, 0\n2, 0.5\n2.000001, 1\n", "CurveNotMonotone", ["2.0 m and 2.000001 m", "millionth"]),
    ("does not begin at 0", "1, 0.1\n2, 1\n", "CurveIncomplete", ["from 0.1 at 1.0 m to 1.0 at 2.0 m"]),
    ("does not reach 1", "1, 0\n2, 0.97\n", "CurveIncomplete", ["to 0.97 at 2.0 m"]),
    ("a thousand times too wide", "1 nm, 0\n1000000 km, 1\n", "ValueOutOfRange", ["sizes run from", "1e+12"]),
]


@pytest.mark.parametrize(("text", "kind", "parts"), [case[1:] for case in WRONG], ids=[case[0] for case in WRONG])
def test_everything_wrong_gets_one_sentence(tmp_path, monkeypatch, text, kind, parts):
    # Breaks when a mistake passes, or is told without its file, line and value.
    monkeypatch.chdir(tmp_path)
    with pytest.raises(GranularError) as refused:
        read_curve(written(Path(), text))
    message = str(refused.value)
    assert type(refused.value) is getattr(errors, kind), message
    assert all(part in message for part in (*parts, "curve.csv")), message
    assert message.isprintable()
    assert len(message) < 500


def test_files_that_cannot_be_read(tmp_path):
    # Breaks when a missing or huge file ends in a traceback.
    with pytest.raises(errors.FileUnreadable, match="a gradation curve is needed"):
        read_curve(tmp_path / "none.csv")
    with pytest.raises(errors.FileUnreadable, match="is a folder"):
        read_curve(tmp_path)
    with pytest.raises(errors.FileTooLarge):
        read_curve(written(tmp_path, b"1" * (LARGEST + 1)))


@given(st.text(alphabet="0123456789.,;\t e-+%m[]()#\"\n\x00", max_size=60))
def test_no_file_brings_a_traceback(tmp_path_factory, text):
    # Breaks when some text raises anything but a GranularError of one line.
    try:
        read_curve(written(tmp_path_factory.getbasetemp(), text))
    except GranularError as refused:
        assert len(str(refused).splitlines()) == 1
