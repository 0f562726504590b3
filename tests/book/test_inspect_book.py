"""The gate on the built book sees each kind of fault, and passes a page without one."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import plotly
import plotly.graph_objects as go
import pytest
from chromium import Chromium
from gate.answers import problems_of_answers
from gate.drawings import problems_of_drawing
from gate.files import Page, problems_of_text
from gate.screen import problems_on_screen
from inspect_book import problems_in_browser

SOUND = (
    '<!doctype html><html lang="en"><body id="top">'
    '<a href="#top">up</a><img src="a.png" alt="a dot"></body></html>'
)
FAULTS = {
    "script from a CDN": ('<script src="https://cdn.example/m.js"></script>', "from another machine"),
    "picture without a scheme": ('<img src="//img.example/a.png" alt="a dot">', "from another machine"),
    "style that loads": ('<p style="background: url(https://x.example/b.png)">x</p>', "another machine"),
    "missing file": ('<a href="gone.html">gone</a>', "a file that is missing"),
    "missing anchor": ('<a href="#gone">gone</a>', "an anchor that is missing"),
    "absolute path": ('<a href="file:///etc/hosts">here only</a>', "does not lead to a file of the book"),
    "id used twice": ('<p id="top">again</p>', "more than once"),
    "picture without words": ('<img src="a.png">', "no description"),
    "interactive figure without words": ('<div><div class="plotly-graph-div"></div></div>', "no description"),
    "picture named by its file": ('<img src="a.png" alt="_images/a.png">', "no description"),
}
SHOWN_FAULTS = {
    "script that fails": ("<script>undefinedName.call()</script>", "undefinedName"),
    "wide block": ('<div style="width: 900px">wide</div>', "px wide"),
    "raw formula": ('<span class="math">\\(x\\)</span>', "not typeset"),
    "wrong formula": (
        "<b class=\"math\"><mjx-container><mjx-merror>?</mjx-merror></mjx-container></b>", "with errors"),
    "request at run time": ("<script>fetch('https://img.example/a')</script>", "asks another machine"),
    "lost file": ("<script>new Image().src = 'gone.png'</script>", "ERR_FILE_NOT_FOUND"),
}
LINE = "font: 16px/24px sans-serif; margin: 0;"
LAYOUT_FAULTS = {
    "text over text": (f'<p style="{LINE}">below</p><p style="{LINE} margin-top: -16px">above</p>', "over each other"),
    "text over its child": (
        f'<p style="{LINE} position: relative">x = y <b style="position: absolute; left: 0">(1)</b></p>', "over each"),
    "picture over text": (
        f'<p style="{LINE}">words</p><img src="a.svg" alt="dot" style="margin-top: -20px">', "over each"),
    "cells over each other": (
        '<table style="table-layout: fixed; width: 6rem"><tr><td style="white-space: nowrap">a long one</td>'
        "<td>next</td></tr></table>", "over each other"),
    "text cut by its box": (
        f'<p style="{LINE} width: 5rem; overflow: hidden; white-space: nowrap">far too long for it</p>', "cut"),
    "line cut in height": (f'<p style="{LINE} height: 10px; overflow: hidden">half a line</p>', "cut"),
    "text outside its box": (
        f'<p style="{LINE} width: 4rem; white-space: nowrap">outside of its paragraph</p>', "outside its box"),
    "text left of the screen": (
        f'<p style="{LINE} position: absolute; left: -40px">half outside</p>', "beyond the screen"),
    "fault in a folded part": (
        f'<details><summary>more</summary><p style="{LINE} width: 4rem; white-space: nowrap">outside of it</p>'
        "</details>", "outside its box"),
}
SOUND_LAYOUTS = {
    "two lines with words set apart":
        f'<p style="{LINE} width: 5rem">one <em>two</em> three <code>four</code> five six</p>',
    "wide table in a box that scrolls":
        '<div style="overflow-x: auto"><table><tr><td style="min-width: 900px">a</td><td>b</td></tr></table></div>',
    "first line further left": f'<p style="{LINE} padding-left: 2rem; text-indent: -1.5rem">author, title, year</p>',
    "hidden text below text":
        f'<p style="{LINE}">seen</p><p style="{LINE} margin-top: -20px; visibility: hidden">not</p>',
}
TEXT = '<g id="text_{0}"><!-- {1} --><path d="M {2} 10 h 30 v 12 h -30 z"/></g>'


def one_page_book(root: Path, body: str) -> dict[Path, Page]:
    (root / "a.png").write_bytes(b"\x89PNG")
    (root / "a.svg").write_text('<svg xmlns="http://www.w3.org/2000/svg" width="30" height="30"/>', encoding="utf-8")
    path = root / "index.html"
    path.write_text(SOUND.replace("</body>", body + "</body>"), encoding="utf-8")
    return {path: Page(path)}


@pytest.fixture(scope="module")
def browser(chromium: str) -> Iterator[Chromium]:
    with Chromium(chromium) as one:
        yield one


@pytest.mark.parametrize("body", ["", '<div aria-label="it"><div><div class="plotly-graph-div"></div></div></div>'])
def test_sound_page_passes(tmp_path: Path, body: str) -> None:
    """Breaks when the gate cries wolf."""
    assert problems_of_text(tmp_path, one_page_book(tmp_path, body)) == []


@pytest.mark.parametrize("fault", FAULTS)
def test_fault_in_the_text_is_found(tmp_path: Path, fault: str) -> None:
    """Breaks when the gate no longer sees this kind of fault in a file."""
    body, expected = FAULTS[fault]
    found = problems_of_text(tmp_path, one_page_book(tmp_path, body))
    assert len(found) == 1
    assert expected in found[0]


def test_faults_on_the_screen_are_found(tmp_path: Path, chromium: str) -> None:
    """Breaks when the browser half of the gate no longer sees one of these kinds of fault."""
    pages = {}
    for number, (body, _) in enumerate(SHOWN_FAULTS.values()):
        folder = tmp_path / str(number)
        folder.mkdir()
        pages |= one_page_book(folder, body)
    found = problems_in_browser(tmp_path, pages, chromium, kinds=("screen",))
    for number, (_, expected) in enumerate(SHOWN_FAULTS.values()):
        of_page = [problem for problem in found if problem.startswith(f"{number}/")]
        assert [problem for problem in of_page if expected in problem], expected


@pytest.mark.parametrize("fault", LAYOUT_FAULTS)
def test_text_that_cannot_be_read_is_found(tmp_path: Path, browser: Chromium, fault: str) -> None:
    """Breaks when the gate no longer sees text that is covered, cut or outside its box."""
    body, expected = LAYOUT_FAULTS[fault]
    (page,) = one_page_book(tmp_path, body)
    assert [problem for problem in problems_on_screen(browser, page, 390) if problem.startswith(expected)]


@pytest.mark.parametrize("layout", SOUND_LAYOUTS)
def test_text_that_can_be_read_passes(tmp_path: Path, browser: Chromium, layout: str) -> None:
    """Breaks when the gate cries wolf over boxes that meet and letters that do not."""
    (page,) = one_page_book(tmp_path, SOUND_LAYOUTS[layout])
    assert [problem for problem in problems_on_screen(browser, page, 390) if "a.png" not in problem] == []


@pytest.mark.parametrize(("left", "right", "expected"), [
    (10, 50, []), (10, 30, ['"one" over "two"']), (10, 90, ['"two" leaves the figure'])])
def test_words_of_a_drawing(tmp_path: Path, browser: Chromium, left: int, right: int, expected: list[str]) -> None:
    """Breaks when words over each other or over the edge of a figure pass, or words apart do not."""
    drawing = tmp_path / "a.svg"
    texts = TEXT.format(1, "one", left) + TEXT.format(2, "two", right)
    drawing.write_text(
        f'<svg xmlns="http://www.w3.org/2000/svg" width="100" height="40">{texts}</svg>', encoding="utf-8")
    assert problems_of_drawing(browser, drawing) == expected


def figure_page(folder: Path, figure: go.Figure, script: str = "") -> Path:
    """Write a page with one interactive figure and a script that may spoil it."""
    shown = figure.to_html(full_html=False, include_plotlyjs=False, div_id="plotly-it")
    library = (Path(plotly.__file__).parent / "package_data" / "plotly.min.js").as_uri()
    page = folder / "index.html"
    page.write_text(f'<!doctype html><html lang="en"><body class="bd-article"><script src="{library}"></script>{shown}'
                    f"<script>{script}</script></body></html>", encoding="utf-8")
    return page


def with_slider(answers: bool) -> go.Figure:
    """Make two curves, a legend, and a slider that shows the one or the other, or does nothing."""
    steps = [{"method": "restyle" if answers else "skip", "args": [{"y": [[1, k], [2, 3]]}], "label": str(k)}
             for k in range(5)]
    return go.Figure([go.Scatter(x=[0, 1], y=[1, 2]), go.Scatter(x=[0, 1], y=[2, 3])], {"sliders": [{"steps": steps}]})


@pytest.mark.parametrize("answers", [True, False])
def test_slider_legend_and_points(tmp_path: Path, browser: Chromium, answers: bool) -> None:
    """Breaks when a slider that changes nothing passes, or a figure that answers does not."""
    found = problems_of_answers(browser, figure_page(tmp_path, with_slider(answers)))
    assert found == ([] if answers else ["plotly-it: slider 1 changes nothing"])


def test_figure_below_something_is_found(tmp_path: Path, browser: Chromium) -> None:
    """Breaks when a figure passes although something transparent over it takes every click."""
    cover = ("const one = document.createElement('div'); one.style = 'position: fixed; inset: 0; z-index: 9999';"
             "document.body.append(one)")
    found = problems_of_answers(browser, figure_page(tmp_path, with_slider(True), cover))
    assert any("slider" in problem for problem in found)
    assert any("legend" in problem for problem in found)
    assert any("point" in problem for problem in found)
