"""The gate on the built book: ``python inspect_book.py BUILD/html [--browser chromium]``.

Always: a page loads nothing from another machine, every link and anchor leads somewhere, no id is used
twice, every picture says in words what it shows. With a browser: every page, opened from file:// without a
network at phone width, typesets all its formulas, reports no error, loads every file it asks for and fits its
screen. Exit code 1 on any problem.
"""

from __future__ import annotations

import argparse
import html.parser
import re
import sys
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urlsplit

from chromium import Chromium

LOADING_ATTRIBUTES = {
    "script": "src", "img": "src", "link": "href", "iframe": "src", "source": "src", "video": "src",
    "audio": "src", "embed": "src", "object": "data",
}
OTHER_MACHINE = re.compile(r"(?:https?:)?//")
STYLE_LOADS = re.compile(r"""(?:url\(|@import)\s*["']?((?:https?:)?//[^"')\s]+)""")
LOCAL = ("file:", "data:", "blob:")
PHONE_WIDTH = 390
HARMLESS_MESSAGES = (
    "invalid theme mode",  # the theme, on a first visit: no mode is stored yet
    "unhandled promise rejection: NetworkError",
)
QUESTIONS = """
(() => {
  const all = selector => [...document.querySelectorAll(selector)];
  const outside = all('.bd-article *').filter(node =>
    node.getBoundingClientRect().right > innerWidth + 1 && !node.closest('pre, mjx-container, svg'));
  return {
    mathErrors: all('mjx-merror, [data-mjx-error]').length,
    rawFormulas: all('.math').filter(node => !node.querySelector('mjx-container')).length,
    scrollWidth: document.documentElement.scrollWidth,
    width: innerWidth,
    widest: outside.slice(0, 3).map(node => node.tagName.toLowerCase() + '.' + node.className),
  };
})()
"""


@dataclass
class Page(html.parser.HTMLParser):
    """What a page loads, links to, names and pictures."""

    path: Path
    loads: list[str] = field(default_factory=list)
    links: list[str] = field(default_factory=list)
    ids: list[str] = field(default_factory=list)
    unnamed_pictures: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        super().__init__()
        self._in_words = False  # whether the element around the next one says in words what it shows
        text = self.path.read_text(encoding="utf-8")
        self.loads += STYLE_LOADS.findall(text)
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = {name: value or "" for name, value in attrs}
        if given.get("id"):
            self.ids.append(given["id"])
        if tag in LOADING_ATTRIBUTES and given.get(LOADING_ATTRIBUTES[tag]):
            self.loads.append(given[LOADING_ATTRIBUTES[tag]])
        if tag == "a" and given.get("href"):
            self.links.append(given["href"])
        if "plotly-graph-div" in given.get("class", "") and not self._in_words:
            self.unnamed_pictures.append(given.get("id", "?"))
        self._in_words = bool(given.get("aria-label")) or (tag == "div" and not given.get("class") and self._in_words)
        # Sphinx writes the file name where an author gave no words.
        if tag == "img" and (not given.get("alt") or "_images/" in given["alt"]):
            self.unnamed_pictures.append(given.get("src", "?"))


def problems_of_text(root: Path, pages: dict[Path, Page]) -> list[str]:
    """Everything wrong that the files alone show."""
    found = []
    for page in pages.values():
        name = page.path.relative_to(root).as_posix()
        found += [f"{name}: id {twice} is used more than once"
                  for twice in sorted({one for one in page.ids if page.ids.count(one) > 1})]
        found += [f"{name}: picture {picture} has no description" for picture in page.unnamed_pictures]
        found += [f"{name}: loads {url} from another machine"
                  for url in page.loads if OTHER_MACHINE.match(url)]
        local = [url for url in page.loads + page.links
                 if not OTHER_MACHINE.match(url) and not url.startswith(("mailto:", "data:"))]
        found += [f"{name}: {problem}" for url in local if (problem := _problem_of_link(page, url, pages))]
    for style in sorted(root.rglob("*.css")):
        found += [f"{style.relative_to(root).as_posix()}: loads {url} from another machine"
                  for url in STYLE_LOADS.findall(style.read_text(encoding="utf-8", errors="replace"))]
    return found


def _problem_of_link(page: Page, url: str, pages: dict[Path, Page]) -> str:
    parts = urlsplit(url)
    if parts.scheme:
        return f"{url} does not lead to a file of the book"
    target = (page.path.parent / unquote(parts.path)).resolve() if parts.path else page.path
    if not target.exists():
        return f"{url} leads to a file that is missing"
    if parts.fragment and target in pages and unquote(parts.fragment) not in pages[target].ids:
        return f"{url} leads to an anchor that is missing"
    return ""


def problems_in_browser(root: Path, pages: dict[Path, Page], executable: str) -> list[str]:
    """Everything wrong that shows when a page is opened."""
    found = []
    with Chromium(executable) as browser:
        for path in pages:
            browser.open(path, width=PHONE_WIDTH)
            state = browser.ask(QUESTIONS)
            told = [problem for event in browser.events if (problem := _problem_of_event(event))]
            if state["mathErrors"]:
                told.append(f"{state['mathErrors']} formulas with errors")
            if state["rawFormulas"]:
                told.append(f"{state['rawFormulas']} formulas not typeset")
            if state["scrollWidth"] > state["width"]:
                told.append(f"is {state['scrollWidth']} px wide on a screen of {state['width']} px; "
                            f"look at {', '.join(state['widest'])}")
            found += [f"{path.relative_to(root).as_posix()}: {problem}" for problem in dict.fromkeys(told)]
    return found


def _problem_of_event(event: dict[str, Any]) -> str:
    about = event.get("params", {})
    match event.get("method"):
        case "Runtime.exceptionThrown":
            details = about["exceptionDetails"]
            text = details.get("exception", {}).get("description", details["text"])
        case "Runtime.consoleAPICalled" if about["type"] == "error":
            text = " ".join(str(value.get("value", value.get("description", ""))) for value in about["args"])
        case "Log.entryAdded" if about["entry"]["level"] == "error":
            text = f"{about['entry']['text']} {about['entry'].get('url', '')}"
        case "Network.loadingFailed" if not about.get("canceled"):
            text = f"a request failed: {about['errorText']}"
        case "Network.requestWillBeSent" if not about["request"]["url"].startswith(LOCAL):
            text = f"asks another machine for {about['request']['url']}"
        case _:
            return ""
    return "" if any(harmless in text for harmless in HARMLESS_MESSAGES) else text


def main() -> int:
    """Inspect the built book named on the command line."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("root", type=Path, help="the folder with the built pages")
    parser.add_argument("--browser", help="also open every page in this Chromium")
    options = parser.parse_args()
    root = options.root.resolve()
    pages = {path: Page(path) for path in sorted(root.rglob("*.html")) if "_static" not in path.parts}
    if not pages:
        print(f"no pages in {options.root}; build the book first: make book", file=sys.stderr)
        return 2
    found = problems_of_text(root, pages)
    if options.browser:
        found += problems_in_browser(root, pages, options.browser)
    opened = "opened in a browser" if options.browser else "read"
    print(*found, f"{len(pages)} pages {opened}, {len(found)} problems", sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
