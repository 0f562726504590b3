"""The book on paper: what a page becomes, and what the gate on the printed file finds."""

from __future__ import annotations

import io
import subprocess
import sys
from pathlib import Path

import pytest
from bs4 import BeautifulSoup
from pdf_chapters import Heading, chapter, plain
from pdf_check import problems
from pdf_compare import differences
from pdf_document import assemble
from pdf_outline import finish
from pypdf import PdfReader, PdfWriter

NAVIGATION = """\
<html><head><link rel="stylesheet" href="_static/print.css"></head><body>
<nav class="bd-links"><div class="bd-toc-item">
<p class="caption"><span class="caption-text">I. First</span></p>
<ul><li class="toctree-l1"><a class="reference internal" href="one.html">1. Number one</a></li>
<li class="toctree-l1"><a class="reference internal" href="two.html">2. Number two</a></li></ul>
</div></nav><article class="bd-article">{text}</article></body></html>
"""
FOLDED = """\
<details class="hide above-input"><summary>Show code</summary><pre>import secret</pre></details>
<details class="hide above-output"><summary>Show output</summary><p>an answer</p></details>
"""
MOVING = """\
<div class="cell"><div class="cell_output"><div class="output text_html"><div style="height: 400px">
<div class="plotly-graph-div" id="plotly-x"></div></div></div></div></div>
"""


def page(root: Path, name: str, title: str, text: str = "<p>Some text to read.</p>") -> None:
    section = (f'<section id="{name}-title"><h1>{title}<a class="headerlink" href="#x">#</a></h1>{text}'
               f'<section id="inner"><h2>Inner heading</h2><p>More.</p></section></section>')
    (root / f"{name}.html").write_text(NAVIGATION.format(text=section), encoding="utf-8")


@pytest.fixture
def pages(tmp_path: Path) -> Path:
    """A book of three pages, two of them in a part, that link to each other."""
    root = tmp_path / "html"
    root.mkdir()
    page(root, "index", "Book of pages")
    page(root, "one", "1. Number one", '<p><a href="two.html#inner">there</a> <a href="two.html">whole</a> '
         '<a href="#inner">here</a> <a href="https://x.org">web</a> <a href="_downloads/x.csv">file</a></p>')
    page(root, "two", "2. Number two")
    return root


def text_of(root: Path, name: str) -> BeautifulSoup:
    return BeautifulSoup(str(chapter(root, name, pages={"index", "one", "two"}).section), "html.parser")


def test_links_lead_inside(pages: Path) -> None:
    """Breaks when a link leads to a file that a reader of the PDF does not have, or two pages share an id."""
    found = {link.get_text(): link.get("href") for link in text_of(pages, "one").find_all("a")}
    assert found == {"there": "#two--inner", "whole": "#two", "here": "#one--inner", "web": "https://x.org",
                     "file": None}
    text = assemble(pages, title="T", author="A", version="1").text
    for wanted in ('id="two--inner"', 'id="two"', 'id="one--inner"'):
        assert text.count(wanted) == 1


def test_folds(pages: Path) -> None:
    """Breaks when code that is folded is printed, or an output that is folded is lost."""
    page(pages, "one", "One", FOLDED)
    found = text_of(pages, "one")
    assert "secret" not in found.get_text()
    [fold] = found.select("details")
    assert "an answer" in fold.get_text()
    assert fold.has_attr("open")


def test_long_folds_are_named_and_left_out(pages: Path) -> None:
    """Breaks when measurements fill page after page, or vanish without a word."""
    rows = "<tr><td>7.25</td></tr>" * 100
    page(pages, "one", "One", f"<details><summary>All measurements</summary><table>{rows}</table></details>")
    said = text_of(pages, "one").get_text()
    assert "7.25" not in said
    assert "All measurements: folded on the page" in said


@pytest.mark.parametrize("twin", ["", '<img src="_images/twin.svg" alt="twin">'])
def test_figures_that_move_stand_still(pages: Path, twin: str) -> None:
    """Breaks when a moving figure leaves a blank space, or takes its twin in the same place along."""
    page(pages, "one", "One", MOVING.replace('<div style="height', f'{twin}<div style="height'))
    found = text_of(pages, "one")
    assert not found.select(".plotly-graph-div")
    assert bool(found.select('img[src="../html/_images/twin.svg"]')) is bool(twin)
    assert ("This figure moves" in found.get_text()) is not bool(twin)


def test_headings_and_contents(pages: Path) -> None:
    """Breaks when a part, chapter or section is not listed, or stands at another depth."""
    document = assemble(pages, title="T", author="A", version="1")
    assert [(one.title, one.depth) for one in document.headings] == [
        ("Book of pages", 1), ("Inner heading", 2), ("I. First", 0), ("1\u2002Number one", 1), ("Inner heading", 2),
        ("2\u2002Number two", 1), ("Inner heading", 2)]
    contents = BeautifulSoup(document.text, "html.parser").select("#contents li .page-number")
    assert [place["data-of"] for place in contents] == ["index", "part-1", "one", "two"]


def test_formulas_in_titles_are_words() -> None:
    """Breaks when the outline shows TeX."""
    heading = BeautifulSoup(r'<h2>2.1. Why <span class="math">\(\mathrm{SR}\)</span> counts</h2>', "html.parser")
    assert plain(heading) == "2.1\u2002Why SR counts"


def printed(*, dated: bool = False, titles: tuple[str, ...] = ("Number one", "Number two")) -> PdfReader:
    """A file of empty pages with the outline of chapters, as no printer makes it."""
    writer = PdfWriter()
    for number, title in enumerate(titles):
        writer.add_blank_page(width=100, height=100)
        writer.add_outline_item(title=title, page_number=number)
        writer.add_named_destination(f"page-{number}", number)
    if dated:
        writer.add_metadata({"/CreationDate": "D:20260101000000"})
    out = io.BytesIO()
    writer.write(out)
    return PdfReader(out)


def test_what_is_wrong_with_a_file_is_found() -> None:
    """Breaks when a lost chapter, an empty page, an outline of another book or a date passes."""
    headings = [Heading("Number one", "page-0", 1), Heading("Third chapter", "page-2", 1)]
    found = "\n".join(problems(printed(dated=True), headings))
    assert "not in the file: Third chapter" in found
    assert "outline: 2 entries for 2 headings" in found
    assert "page 1: is empty" in found
    assert "says when it was made: /CreationDate" in found


def test_titles_are_looked_for_on_their_pages() -> None:
    """Breaks when a chapter may begin anywhere, or the contents name no page."""
    headings = [Heading("Number one", "page-0", 1), Heading("Number two", "page-1", 1)]
    found = "\n".join(problems(printed(), headings))
    assert "page 2: does not say “Number two”" in found
    assert "contents: “Number two” without its page 2" in found


def test_finished_files_are_equal(pages: Path, tmp_path: Path, book: Path, chromium: str) -> None:
    """Breaks when two printings differ, a good book is refused, or a clipped box passes."""
    (pages / "_static").mkdir()
    (pages / "_static" / "print.css").write_bytes((book / "_static" / "print.css").read_bytes())

    def print_pages(name: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run([sys.executable, str(book / "_ext" / "pdf.py"), str(pages), str(tmp_path / name),
                               "--browser", chromium], capture_output=True, text=True, check=False)

    for name in ("a.pdf", "b.pdf"):
        outcome = print_pages(name)
        assert outcome.returncode == 0, outcome.stdout + outcome.stderr
    assert (tmp_path / "a.pdf").read_bytes() == (tmp_path / "b.pdf").read_bytes()
    headings = assemble(pages, title="", author="", version="").headings
    assert list(problems(PdfReader(tmp_path / "a.pdf"), headings)) == []

    page(pages, "one", "1. Number one", '<p style="width: 900px">too wide</p><p>\\(x^2\\) and \\frac{1}{2}</p>'
         '<div style="height: 20px; overflow: auto"><p style="height: 90px">cut</p></div>')
    outcome = print_pages("c.pdf")
    assert outcome.returncode == 1
    for problem in ("one: reaches over the page: p too wide", "one: shows TeX: p", "one: is cut or scrolls: div cut"):
        assert problem in outcome.stderr


def test_printings_that_say_something_else_are_told_apart(pages: Path, tmp_path: Path, book: Path,
                                                          chromium: str) -> None:
    """Breaks when a word, a link or a page may change from one printing to the next."""
    (pages / "_static").mkdir()
    (pages / "_static" / "print.css").write_bytes((book / "_static" / "print.css").read_bytes())
    readers = []
    for target, word in (("two", "link"), ("two", "links"), ("index", "link")):
        page(pages, "one", "1. Number one", f'<p>one <a href="{target}.html">a <em>mixed</em> {word}</a></p>')
        out = tmp_path / f"{len(readers)}.pdf"
        subprocess.run([sys.executable, str(book / "_ext" / "pdf.py"), str(pages), str(out), "--browser", chromium],
                       check=True)
        readers.append(PdfReader(out))
    first, other_word, other_link = readers
    assert list(differences(first, first)) == []
    assert [problem.split(": ")[1] for problem in differences(first, other_word)] == ["other words"]
    assert [problem.split(": ")[1] for problem in differences(first, other_link)] == ["other links"]
    assert list(differences(first, printed())) == [f"{len(first.pages)} pages and 2 pages"]
    leading = [link.get_object()["/Dest"] for sheet in first.pages for link in sheet.get("/Annots", ())]
    assert leading.count("/two") == 3  # its lines in two lists of contents, and one area for a link with two faces


def test_missing_chromium_is_said(book: Path) -> None:
    """Breaks when somebody without Chromium is not told what to do."""
    outcome = subprocess.run([sys.executable, str(book / "_ext" / "pdf.py"), "--browser", "no-such-browser"],
                             capture_output=True, text=True, check=False)
    assert outcome.returncode == 2
    assert "apt install chromium" in outcome.stderr


def test_finishing_keeps_every_page() -> None:
    """Breaks when the lists of contents are not as many pages as they were."""
    reader = printed()
    out = io.BytesIO()
    PdfWriter(clone_from=reader).write(out)
    with pytest.raises(ValueError, match="moved the pages"):
        finish(out.getvalue(), out.getvalue(), [Heading("Number one", "page-0", 1)], title="T", author="A")
