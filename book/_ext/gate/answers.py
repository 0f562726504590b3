"""Every interactive figure answers a hand: sliders, buttons, legends, points, surfaces, pictures that grow."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from gate import mouse

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from chromium import Chromium

DESKTOP = 1280
PARTS = (Path(__file__).parent / "answers.js").read_text(encoding="utf-8")
FIGURES = "[...document.querySelectorAll('.plotly-graph-div')].filter(one => one.checkVisibility()).map(one => one.id)"
# plotly waits 300 ms for a second click before it hides a curve, and a slider's change takes some frames
CALM = "new Promise(done => setTimeout(done, %d))"
HASTE = (50, 100, 250)
PATIENCE = (*HASTE, 500, 1000, 3000)
"""Milliseconds to wait, one after the other, until a change shows; only what never changes takes all of them."""
MOST_MARKS = 12
"""Drawn points and lines that are tried until one answers: some lie below others."""


def problems_of_answers(browser: Chromium, page: Path) -> list[str]:
    """Name every part of the interactive figures and pictures of a page that does not answer."""
    browser.open(page, width=DESKTOP)
    browser.ask(PARTS)
    names = list(browser.ask(FIGURES))
    found = [f"{name}: {problem}" for name in names for problem in _silent_parts(browser, name)]
    return found + list(_silent_controls(browser)) + list(_silent_pictures(browser))


def _silent_parts(browser: Chromium, name: str) -> Iterator[str]:
    """Every kind of part is asked by a real click or drag; a figure without any part answers nothing."""
    def parts() -> dict[str, Any]:
        answer: dict[str, Any] = browser.ask(f"figureParts('{name}')")
        return answer

    state = f"figureState('{name}')"
    here = parts()
    if not any(here.values()):
        yield "has nothing to click"
    for number, (first, second) in enumerate(here["sliders"], 1):
        # the slider may stand at the first place already
        if not any(_changes(browser, state, lambda place=place: mouse.click(browser, *place), waits)
                   for place, waits in ((first, HASTE), (second, HASTE), (first, PATIENCE))):
            yield f"slider {number} changes nothing"
    if here["buttons"] and not any(
            _changes(browser, state, lambda place=place: mouse.click(browser, *place)) for place in here["buttons"]):
        yield "its buttons change nothing"
    for number, place in enumerate(here["menus"], 1):
        mouse.click(browser, *place)
        browser.ask(CALM % 400)
        if not any(_changes(browser, state, lambda place=place: mouse.click(browser, *place))
                   for place in reversed(parts()["buttons"])):
            yield f"menu {number} changes nothing"
    if here["legend"]:
        hidden = _changes(browser, state, lambda: mouse.click(browser, *here["legend"][0]))
        if not hidden:
            yield "its legend hides nothing"
        browser.ask(CALM % 400)
        mouse.click(browser, *here["legend"][0])
        browser.ask(CALM % 400)
    for number, place in enumerate(here["scenes"], 1):
        if not _changes(browser, state, lambda place=place: mouse.drag(browser, *place, by=60)):
            yield f"scene {number} does not turn"
    marks = parts()["marks"]
    if marks and not any(_answers(browser, place) for place in marks[:: max(1, len(marks) // MOST_MARKS)]):
        yield "no point or curve of it answers a click"


def _silent_controls(browser: Chromium) -> Iterator[str]:
    """Sliders and lists of the page itself."""
    for number in range(browser.ask("controls().length")):
        control = f"controls()[{number}]"
        kind, width = browser.ask(f"[{control}.type, {control}.getBoundingClientRect().width]")
        x, y = browser.ask(f"reach({control})")
        if kind == "range":
            acted = any(_changes(browser, "pageState()", lambda at=at, y=y: mouse.click(browser, at, y))
                        for at in (x + 0.4 * width, x - 0.3 * width))
        else:
            browser.ask(f"{control}.focus()")
            acted = _changes(browser, "pageState()", lambda: mouse.press(browser, "ArrowDown"))
        if not acted:
            yield f"control {number + 1} ({kind}) changes nothing"


def _silent_pictures(browser: Chromium) -> Iterator[str]:
    """A picture grows when it is clicked, and goes away on a second click."""
    opened = "document.querySelectorAll('dialog[open]').length"
    for number in range(browser.ask("pictures().length")):
        x, y = browser.ask(f"reach(pictures()[{number}])")
        if not _changes(browser, opened, lambda x=x, y=y: mouse.click(browser, x, y)):
            yield f"picture {number + 1} does not grow when clicked"
        elif not _changes(browser, opened, lambda x=x, y=y: mouse.click(browser, x, y)):
            yield f"picture {number + 1} does not go away on a second click"


def _changes(browser: Chromium, question: str, act: Callable[[], None], waits: tuple[int, ...] = PATIENCE) -> bool:
    before = browser.ask(question)
    act()
    for wait in waits:
        browser.ask(CALM % wait)
        if browser.ask(question) != before:
            return True
    return False


def _answers(browser: Chromium, place: list[float]) -> bool:
    x, y = place
    mouse.move(browser, x - 3, y - 3)
    mouse.move(browser, x, y)
    browser.ask(CALM % 80)
    mouse.click(browser, x, y)
    browser.ask(CALM % 20)
    return bool(browser.ask("told.includes('plotly_click')"))
