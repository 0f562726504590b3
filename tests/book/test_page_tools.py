"""What pages show of a record is what the record says: nothing taken for markup, nothing lost on the way to CSV."""

from __future__ import annotations

import base64
import csv
import io
import re
from pathlib import Path

import pytest
from page_tools.emitted import PAGE_OF, SHEET
from page_tools.formulas import of_steps
from page_tools.markup import boxed, numbers_to_take_away, plain, table
from page_tools.provenance import DATA_FILES
from page_tools.refusals import refused
from page_tools.steps import assumptions, display, parts, steps

from derivations.catalogue import derivation, names
from granular import AxialFabric


def test_plain_text_is_not_markup() -> None:
    """Breaks when a record's text could open a tag, a formula, a table cell or an emphasis."""
    assert plain("k_n <rho> | 2*x >= $1") == "k\\_n \\<rho\\> \\| 2\\*x ≥ \\$1"


def test_table_can_be_taken_away() -> None:
    """Breaks when the CSV beside a table holds other rows than the table."""
    rows = [["1", "a, b"], ["2", 'c "d"']]
    text = table(["case", "what"], rows, label="tab-x", caption="Two rows.", take_away="x.csv").text
    assert ":name: tab-x" in text
    data = re.search(r"base64,([A-Za-z0-9+/=]+)", text)
    assert data is not None
    assert list(csv.reader(io.StringIO(base64.b64decode(data[1]).decode()))) == [["case", "what"], *rows]


def test_box_holds_its_parts() -> None:
    """Breaks when a part of a result is lost, or the box closes before its end."""
    inner = table(["a"], [["1"]], label="tab-y", caption="One.")
    text = boxed("Result", inner, inner).text
    assert text.count(":name: tab-y") == 2
    assert text.startswith("::::::{admonition} Result\n:class: result")
    assert text.rstrip().endswith("\n::::::")


@pytest.mark.parametrize("name", names())
def test_steps_are_numbered_once(name: str) -> None:
    """Breaks when two steps share a label, or a step is shown without the verdict of the machine."""
    text = steps(name).text
    labels = re.findall(r"^\$\$ \((eq-[a-z0-9-]+)\)$", text, flags=re.MULTILINE)
    assert len(labels) == len(set(labels))
    assert text.count("{.verdict}") == len(derivation(name).steps)
    assert assumptions(name).text.startswith("- ")


def test_a_refusal_that_does_not_happen_is_noticed() -> None:
    """Breaks when the page of errors would go on quoting a refusal that the library has dropped or renamed."""
    with pytest.raises(AssertionError, match="nothing was refused"):
        refused("G-FAB-01", lambda: AxialFabric(D33=0.3))
    with pytest.raises(AssertionError, match="expected G-FAB-02"):
        refused("G-FAB-02", lambda: AxialFabric(D33=2.3))


def taken_away(text: str) -> list[list[str]]:
    """Rows of the CSV file that a table or figure offers."""
    data = re.search(r"base64,([A-Za-z0-9+/=]+)", text)
    assert data is not None
    return list(csv.reader(io.StringIO(base64.b64decode(data[1]).decode())))


def test_numbers_of_a_figure_can_be_taken_away() -> None:
    """Breaks when the CSV beside a figure loses a column, or digits that were asked for."""
    text = numbers_to_take_away("x.csv", {"beta": (0.0, 90.0), "f": (1 / 3, 2e-9)}, digits=4).text
    assert taken_away(text) == [["beta", "f"], ["0", "0.3333"], ["90", "2e-09"]]


def test_a_table_can_offer_other_cells_than_it_shows() -> None:
    """Breaks when a cell that holds two values on the page is not taken apart in the file."""
    text = table(["a"], [["1<br>2"]], label="tab-z", caption="One.", take_away="z.csv",
                 taken=[["a", "b"], ["1", "2"]]).text
    assert taken_away(text) == [["a", "b"], ["1", "2"]]
    assert "1<br>2" in text


def test_wide_formulas_are_set_below_one_another() -> None:
    """Breaks when formulas side by side run over the line, or short ones are torn apart."""
    short = r"a = b,\qquad c = d"
    wide = r"a = b + c + d + e + f + g + h + i + j,\qquad k = l + m + n + o + p + q + r + s"
    assert parts(short) == [short]
    assert parts(wide) == ["a = b + c + d + e + f + g + h + i + j,", "k = l + m + n + o + p + q + r + s"]


def test_an_index_is_no_definition() -> None:
    """Breaks when a formula is aligned at the equality sign of an index, which TeX cannot set."""
    text = display([r"H\big|_{\delta=0} \to K", "a = b"], "eq-x")
    assert "&" not in text
    assert r"\begin{gathered}" in text


def test_a_box_shows_formulas_of_the_record() -> None:
    """Breaks when the result in a box is not what the derivation gives."""
    step = derivation("contact_forces").steps[16]
    assert step.shown[0] in of_steps("contact_forces", (17, 1), label="eq-y").text


def test_every_derivation_has_its_page(book: Path) -> None:
    """Breaks when a derivation is added and the formula sheet or the list of pages does not know it."""
    assert sorted(name for listed in SHEET.values() for name in listed) == sorted(names())
    sheets = {name: (book / f"{page}.md").read_text(encoding="utf-8") for page, listed in SHEET.items()
              for name in listed}
    for name in names():
        page = (book / f"{PAGE_OF[name]}.md").read_text(encoding="utf-8")
        assert name in page, name
        assert f"_formulas/{name}.md" in sheets[name], name


def test_every_data_file_is_listed(book: Path) -> None:
    """Breaks when the book uses data that its list of data with digests does not name."""
    present = {path.relative_to(book).as_posix() for path in (book / "_data").rglob("*") if path.is_file()}
    assert present == set(DATA_FILES)
