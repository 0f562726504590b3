"""The index of symbols holds every declared symbol once, in order, and says where a reader meets it."""

from __future__ import annotations

import base64
import csv
import io
import re
from itertools import pairwise
from pathlib import Path

import pytest
from page_tools import contents, symbols_index

from derivations.symbols import GLOSSARY
from derivations.written import is_defined, is_name, stands_in

BY_NAME = {quantity.symbol.name: quantity for quantity in GLOSSARY}


@pytest.fixture(autouse=True)
def _in_the_book(book: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(book)


def test_every_symbol_has_one_row() -> None:
    """Breaks when a symbol is lost among the components of a tensor, or stands in two rows."""
    members = [quantity.symbol.name for _, _, row in symbols_index.families() for quantity in row]
    assert sorted(members) == sorted(BY_NAME)
    rows = {latex: row for latex, _, row in symbols_index.families()}
    assert len(rows["C_{ijkl}"]) == 21
    assert len(rows["D_{ij}"]) == 5  # D33 has a meaning of its own
    assert len(rows["k_n"]) == 1


def test_the_file_holds_the_declarations() -> None:
    """Breaks when the CSV beside the table is not the glossary."""
    data = re.search(r"base64,([A-Za-z0-9+/=]+)", symbols_index.symbol_index().text)
    assert data is not None
    rows = list(csv.reader(io.StringIO(base64.b64decode(data[1]).decode())))[1:]
    assert rows == [[q.symbol.name, q.latex, q.unit, q.domain, q.meaning] for q in GLOSSARY]


def test_order_of_the_alphabet() -> None:
    """Breaks when accents or commands decide the place of a letter, or Greek letters mix with Latin ones."""
    latex = [r"a", r"\cos\alpha", r"e_0", r"\ell", r"L_t", r"M", r"\bar N", r"\tilde r", r"r_{50}", r"\mathrm{SR}",
             r"x", r"\beta", r"\Gamma_{\mathrm{kin}}", r"\bar\lambda", r"\mu", r"\psi_s", r"\varrho"]
    keys = [symbols_index.alphabetical(one)[:2] for one in latex]
    assert all(one <= other for one, other in pairwise(keys)), keys


@pytest.mark.parametrize(("name", "page"), [
    ("x", "conventions"), ("aspect_ratio", "conventions"), ("D33", "conventions"), ("e0", "fabric"),
    ("kt", "kinematic"),
    ("eta", "kinetic"),
    ("void_ratio", "gradation"), ("mu", "sliding"), ("v_SH", "waves"), ("E1", "engineering"),
    ("psi", "sliding"), ("m", "sliding"),
])
def test_pages_on_which_symbols_are_met(name: str, page: str) -> None:
    """Breaks when an index or a differential is taken for the symbol, or a page before is overlooked."""
    found = symbols_index.first_met(BY_NAME[name])
    assert found is not None
    assert found[0] == page


def test_every_symbol_is_used() -> None:
    """Breaks when a symbol is declared and neither a page nor a derivation needs it."""
    for quantity in GLOSSARY:
        assert symbols_index.first_met(quantity) or symbols_index.only_in(quantity)


def test_steps_are_shown_by_the_pages_that_are_named(book: Path) -> None:
    """Breaks when a page no longer calls for the steps to which the index leads."""
    for place in contents.steps_shown().values():
        assert f'steps("{place.record}"' in (book / f"{place.page}.md").read_text(encoding="utf-8")


@pytest.mark.parametrize(("latex", "formula", "stands"), [
    ("k_n", r"k_n p_0", True),
    ("k_n", r"k_n^{\circ}", False),
    (r"k_n^{\circ}", r"k_n^\circ = 1", True),
    ("D_{33}", r"1 + D_{33} P_2", True),
    ("D_{33}", r"D^{r}_{33}", False),
    ("D^{r}_{33}", r"D^r_{33}", True),
    ("C_{2323}", r"\tilde C_{2323}", False),
    (r"\lambda", r"\bar\lambda p_0", False),
    (r"\delta", r"\delta_{ij}", False),
    ("d", r"\int\mathrm dx\,\mathrm d", False),
    ("e", r"\mathrm{free}", False),
    ("a", r"\frac{1}{\tan\psi}", False),
])
def test_a_symbol_stands_by_itself(latex: str, formula: str, stands: bool) -> None:
    """Breaks when a part of a command, an accent or another index makes a different symbol of it."""
    assert stands_in(latex, formula) is stands


def test_definitions_and_names() -> None:
    """Breaks when a single letter counts as more, or an index on the left as a definition."""
    assert is_defined("K", r"G = 1,\qquad K = 2")
    assert not is_defined("K", r"G = K")
    assert is_name("k_n") and is_name(r"\bar\lambda")
    assert not is_name("K") and not is_name(r"\lambda")
