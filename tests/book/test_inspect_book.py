"""The gate on the built book sees each kind of fault, and passes a page without one."""

from __future__ import annotations

from pathlib import Path

import pytest
from inspect_book import Page, problems_in_browser, problems_of_text

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


def one_page_book(root: Path, body: str) -> dict[Path, Page]:
    (root / "a.png").write_bytes(b"\x89PNG")
    path = root / "index.html"
    path.write_text(SOUND.replace("</body>", body + "</body>"), encoding="utf-8")
    return {path: Page(path)}


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
    found = problems_in_browser(tmp_path, pages, chromium)
    for number, (_, expected) in enumerate(SHOWN_FAULTS.values()):
        of_page = [problem for problem in found if problem.startswith(f"{number}/")]
        assert [problem for problem in of_page if expected in problem], expected
