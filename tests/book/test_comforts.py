"""What makes the book comfortable works from the file system: previews, copying, enlarging, turning pages, numbers."""

from __future__ import annotations

import base64
import contextlib
import csv
import io
import json
import re
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from bs4 import BeautifulSoup, Tag
from chromium import BrowserError, Chromium

from granular import figures
from granular.figures.drawn_data import drawn_data

pytestmark = pytest.mark.book

TWINS = {
    "plotly-anisotropy": "fig-anisotropy",
    "plotly-cost-chooser": "fig-cost-sliding",
    "plotly-figure-5": "fig-five",
    "plotly-figure-8": "fig-eight-round",
    "plotly-figure-9": "fig-nine-round",
    "plotly-mohr": "fig-mohr",
    "plotly-speed-scaling": "fig-speed-scaling",
}
"""Interactive figures, and the still figure of the same page that says the same on paper and without WebGL."""

DRAWINGS = {
    "fig-coordinates": "explains axes and angles",
    "fig-effect-choice": "explains in which order questions are asked; the tables beside it have the numbers",
}
"""Figures that show no numbers, and why."""

KEYS = {"Enter": 13, "Escape": 27, "ArrowLeft": 37, "ArrowRight": 39, "Tab": 9}


class Reader(Chromium):
    """A browser with hands: pointer, finger and keyboard."""

    def until(self, condition: str) -> None:
        """Wait for something in the page, which may be replaced by another one meanwhile."""
        for _ in range(600):
            with contextlib.suppress(BrowserError):
                if self.ask(f"Boolean({condition})"):
                    return
            time.sleep(0.02)
        pytest.fail(f"never came true: {condition}")

    def place(self, selector: str) -> tuple[float, float]:
        """Bring an element into view and say where it is."""
        self.ask(f"document.querySelector({selector!r}).scrollIntoView({{block: 'center', behavior: 'instant'}})")
        self.ask("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
        x, y = self.ask(f"(() => {{ const box = document.querySelector({selector!r}).getClientRects()[0];"
                        "return [box.x + box.width / 2, box.y + box.height / 2]; })()")
        return x, y

    def point(self, selector: str) -> None:
        x, y = self.place(selector)
        self.call("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y)

    def click(self, selector: str) -> None:
        x, y = self.place(selector)
        for kind in ("mousePressed", "mouseReleased"):
            self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1)

    def tap(self, selector: str) -> None:
        x, y = self.place(selector)
        self.call("Input.dispatchTouchEvent", type="touchStart", touchPoints=[{"x": x, "y": y}])
        self.call("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])

    def press(self, key: str) -> None:
        what = {"key": key, "code": key, "windowsVirtualKeyCode": KEYS[key]}
        text = {"text": "\r"} if key == "Enter" else {}
        self.call("Input.dispatchKeyEvent", type="keyDown" if text else "rawKeyDown", **what, **text)
        self.call("Input.dispatchKeyEvent", type="keyUp", **what)

    def focus(self, selector: str) -> None:
        """Reach an element by the keyboard."""
        self.press("Tab")
        self.place(selector)
        self.ask(f"document.querySelector({selector!r}).focus({{preventScroll: true}})")


@pytest.fixture(scope="module")
def reader(chromium: str) -> Iterator[Reader]:
    with Reader(chromium) as browser:
        yield browser


@pytest.fixture(scope="module")
def pages(built: Path) -> dict[str, Tag]:
    """The articles of the book by name; what scripts hold is left out, since it takes long to read."""
    articles = {}
    for path in sorted(built.glob("*.html")):
        text = re.sub(r"<script\b.*?</script>", "", path.read_text(encoding="utf-8"), flags=re.DOTALL)
        article = BeautifulSoup(text, "html.parser").find("article")
        if isinstance(article, Tag):
            articles[path.stem] = article
    return articles


def rows_of(link: Tag) -> list[list[str]]:
    content = base64.b64decode(str(link["href"]).partition("base64,")[2]).decode()
    return list(csv.reader(io.StringIO(content)))


def classes(node: Tag) -> list[str]:
    return [str(one) for one in node.get_attribute_list("class")]


SHOWN = "document.querySelector('.preview.shown')"


@pytest.mark.parametrize("page, link, wanted, dark", [
    ("kinematic", 'a.reference[href^="#equation-"]', "mjx-container", True),
    ("forces", 'a.reference[href="#fig-forces"]', "img", False),
    ("sliding", 'a.reference[href="forces.html#tab-forces"]', "table tbody tr", False),
    ("sliding", 'a.reference[href^="bibliography.html#"]', "div.citation", True),
])
def test_pointing_at_a_reference_shows_it(reader: Reader, built: Path, page: str, link: str, wanted: str, dark: bool,
                                          ) -> None:
    """Breaks if no preview comes, if it lacks what is referred to, lies outside the screen or stays."""
    reader.open(built / f"{page}.html", width=1280, dark=dark)
    reader.point(f"article {link}")
    reader.until(SHOWN)
    assert reader.ask(f"{SHOWN}.querySelectorAll({wanted!r}).length") > 0
    left, top, right, bottom = reader.ask(f"(box => [box.left, box.top, box.right, box.bottom])"
                                          f"({SHOWN}.getBoundingClientRect())")
    assert left >= 0 and top >= 0 and right <= 1280 and bottom <= 900
    assert not re.search(r"\\\(|\\\[", reader.ask(f"{SHOWN}.innerText"))
    paper = reader.ask(f"getComputedStyle({SHOWN}).backgroundColor")
    light = min(int(part) for part in re.findall(r"\d+", paper)[:3]) > 128
    assert light is not dark
    reader.call("Input.dispatchMouseEvent", type="mouseMoved", x=2, y=890)
    reader.until("!document.querySelector('.preview')")


def test_the_keyboard_shows_a_reference_and_escape_hides_it(reader: Reader, built: Path) -> None:
    """Breaks if previews are for the pointer only, or are not told to readers who listen."""
    reader.open(built / "kinematic.html", width=1280)
    link = 'article a.reference[href^="#equation-"]'
    reader.focus(link)
    reader.until(SHOWN)
    assert reader.ask(f"document.querySelector({link!r}).getAttribute('aria-describedby')") == reader.ask(f"{SHOWN}.id")
    reader.press("Escape")
    reader.until("!document.querySelector('.preview')")


def test_a_finger_follows_the_link(reader: Reader, built: Path) -> None:
    """Breaks if a preview takes the tap."""
    reader.open(built / "forces.html", width=390)
    reader.call("Emulation.setTouchEmulationEnabled", enabled=True)
    try:
        reader.tap('article a.reference[href="#fig-forces"]')
        reader.until("location.hash === '#fig-forces'")
        assert reader.ask("document.querySelectorAll('.preview').length") == 0
    finally:
        reader.call("Emulation.setTouchEmulationEnabled", enabled=False)


def test_every_reference_has_a_preview(built: Path, pages: dict[str, Tag]) -> None:
    """Breaks if a formula, figure, table, section or publication that a page refers to has none."""
    kept = {}
    for path in sorted((built / "_static" / "previews").glob("*.js")):
        content = path.read_text(encoding="utf-8").removeprefix("showPreviews(").removesuffix(");\n")
        kept[path.stem] = json.loads(f"[{content}]")[1]
    missing = set()
    for name, article in pages.items():
        for link in article.select("a.reference.internal[href*='#']"):
            target, _, anchor = str(link["href"]).partition("#")
            page = target.removesuffix(".html") or name
            if page in pages and anchor not in kept.get(page, {}):
                missing.add(f"{name}: {link['href']}")
    assert sorted(missing) == []


@pytest.mark.parametrize("clipboard", [True, False])
def test_a_formula_is_copied_as_latex(reader: Reader, built: Path, clipboard: bool) -> None:
    """Breaks if the button copies something else than the source, or fails where pages may not use the clipboard."""
    reader.open(built / "kinematic.html", width=390)
    keep = "{writeText: async text => { window.copied = text; }}" if clipboard else "undefined"
    reader.ask(f"Object.defineProperty(navigator, 'clipboard', {{value: {keep}}});"
               "document.addEventListener('copy', event => { window.copied = event.target.value; })")
    reader.click("#equation-eq-kinematic-ratios .copy-tex")
    reader.until("window.copied")
    source = BeautifulSoup((built / "kinematic.html").read_text(encoding="utf-8"), "html.parser").select_one(
        "#equation-eq-kinematic-ratios")
    assert source is not None
    tex = source.get_text().partition("\\[")[2].rpartition("\\]")[0]
    assert reader.ask("window.copied").split() == tex.split()


@pytest.mark.parametrize("width", [1280, 390])
def test_buttons_of_formulas_cover_nothing(reader: Reader, built: Path, width: int) -> None:
    """Breaks if a button lies over its formula or number, or has no name."""
    reader.open(built / "kinematic.html", width=width)
    covered = """[...document.querySelectorAll('article div.math')].filter(formula => {
        const box = formula.querySelector('.copy-tex').getBoundingClientRect();
        return [...formula.querySelectorAll('mjx-math')].some(part => {
            const own = part.getBoundingClientRect();
            return own.left < box.right && box.left < own.right && own.top < box.bottom - 3 && box.top < own.bottom - 3;
        });
    }).map(formula => formula.id)"""
    assert reader.ask(covered) == []
    assert reader.ask("[...document.querySelectorAll('.copy-tex')].every(one => one.getAttribute('aria-label'))")


@pytest.mark.parametrize("width", [1280, 390])
def test_a_figure_is_enlarged_from_the_keyboard(reader: Reader, built: Path, width: int) -> None:
    """Breaks if Enter does nothing, it is not larger, arrows turn the page behind it, or Esc does not close it."""
    reader.open(built / "forces.html", width=width)
    picture = "article figure img"
    before = reader.ask(f"document.querySelector({picture!r}).getBoundingClientRect().width")
    reader.focus(picture)
    reader.press("Enter")
    reader.until("document.querySelector('dialog.zoom[open] img')?.complete")
    assert reader.ask("document.querySelector('dialog.zoom img').getBoundingClientRect().width") > 1.2 * before
    reader.press("ArrowRight")
    reader.press("Escape")
    reader.until("!document.querySelector('dialog.zoom')")
    assert reader.ask("location.pathname").endswith("/forces.html")
    assert reader.ask(f"document.activeElement === document.querySelector({picture!r})")


def test_arrow_keys_turn_pages(reader: Reader, built: Path) -> None:
    """Breaks if they do nothing from the file system, or turn the page away from under a slider."""
    reader.open(built / "forces.html", width=1280)
    following = reader.ask("document.querySelector('link[rel=next]').href")
    reader.press("ArrowRight")
    reader.until(f"location.href === {following!r}")
    reader.open(built / "cost.html", width=1280)
    reader.focus(".cost-chooser input[type=range]")
    before = reader.ask("document.querySelector('.cost-chooser input').value")
    reader.press("ArrowRight")
    reader.until(f"document.querySelector('.cost-chooser input').value !== {before!r}")
    assert reader.ask("location.pathname").endswith("/cost.html")


def test_search_finds_from_the_file_system(reader: Reader, built: Path) -> None:
    """Breaks if the index is not read from file://."""
    reader.open(built / "search.html", width=1280)
    reader.ask("setTimeout(() => { location.search = '?q=stiffness'; }, 0)")
    reader.until("document.querySelectorAll('#search-results li a').length > 3")


def test_every_figure_offers_its_numbers(pages: dict[str, Tag]) -> None:
    """Breaks if a figure of a cell has no file, or two."""
    wrong = []
    for name, article in pages.items():
        for figure in article.select(".cell_output figure:has(img), .cell_output figure:has(.plotly-graph-div)"):
            if figure.get("id") in DRAWINGS:
                continue
            output = figure.find_parent(class_="cell")
            after = output.find_next_sibling() if isinstance(output, Tag) else None
            own = figure.find_next_sibling(class_="take-away")
            by_hand = after.select(".take-away") if isinstance(after, Tag) and "cell" in classes(after) else []
            offered = [link for link in [own, *by_hand]
                       if isinstance(link, Tag) and "numbers behind the figure" in link.get_text()]
            if not offered or (own in offered and len(offered) > 1):
                wrong.append(f"{name}: {figure.get('id')} has {len(offered)}")
    assert wrong == []


def test_every_table_with_numbers_offers_them(pages: dict[str, Tag]) -> None:
    """Breaks if a table of numbers cannot be taken away."""
    wrong = []
    for name, article in pages.items():
        for table in article.select(".cell_output table[id]"):
            numeric = any(re.match(r"[+\-−]?\d", cell.get_text().strip()) for cell in table.select("td"))
            box = table.find_parent(class_="pst-scrollable-table-container") or table
            after = box.find_next_sibling()
            if numeric and not (isinstance(after, Tag) and "take-away" in classes(after)):
                wrong.append(f"{name}: {table['id']}")
    assert wrong == []


def test_files_of_numbers_are_whole(pages: dict[str, Tag]) -> None:
    """Breaks if a file is no table: rows of unequal length, a head without names, markup in the head."""
    links = [(name, link) for name, article in pages.items()
             for link in article.select(".take-away a[href^='data:text/csv']")]
    assert links
    for name, link in links:
        head, *rows = rows_of(link)
        assert rows and {len(row) for row in rows} == {len(head)}, (name, link["download"])


def test_the_file_of_a_figure_holds_what_it_draws(pages: dict[str, Tag]) -> None:
    """Breaks if the file comes from another figure than the one above it."""
    link = pages["waves"].select_one("#fig-waves + .take-away a")
    assert link is not None and link["download"] == "fig-waves.csv"
    data = drawn_data(figures.table_ii_waves().figure)
    assert rows_of(link) == [list(data.header), *map(list, data.rows)]


def test_interactive_figures_have_a_still_twin(reader: Reader, built: Path, pages: dict[str, Tag]) -> None:
    """Breaks if an interactive figure is added without a still one, or paper shows the wrong one of the two."""
    found = {str(plot["id"]): (name, article) for name, article in pages.items()
             for plot in article.select(".plotly-graph-div")}
    assert set(found) == set(TWINS)
    for plot, (name, article) in found.items():
        assert article.select_one(f"figure#{TWINS[plot]} img") is not None, plot
        reader.open(built / f"{name}.html", width=700)
        reader.call("Emulation.setEmulatedMedia", media="print")
        assert reader.ask(f"document.getElementById({plot!r}).getClientRects().length") == 0, plot
        assert reader.ask(f"document.querySelector('#{TWINS[plot]} img').getBoundingClientRect().width") > 100, plot
        reader.call("Emulation.setEmulatedMedia", media="")
