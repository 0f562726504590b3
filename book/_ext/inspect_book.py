"""The gate on the built book: ``python inspect_book.py BUILD/html [--browser chromium] [--only screen ...]``.

Always: a page loads nothing from another machine, every link and anchor leads somewhere, no id is used
twice, every picture says in words what it shows. With a browser, opened from file:// without a network:
``screen``, every page on a desktop and a phone typesets all its formulas, reports no error, loads every file it
asks for, fits its screen, and shows no text over another or cut; ``drawings``, the words of every figure stand
apart and inside it; ``answers``, every interactive figure answers a click. Exit code 1 on any problem.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from chromium import Chromium
from gate.answers import problems_of_answers
from gate.drawings import problems_of_drawing
from gate.files import Page, pages_of, problems_of_text
from gate.screen import WIDTHS, problems_on_screen

KINDS = ("screen", "drawings", "answers")


def problems_in_browser(root: Path, pages: dict[Path, Page], executable: str, *,
                        kinds: tuple[str, ...] = KINDS) -> list[str]:
    """Everything wrong that shows when a page is opened."""
    found = []
    with Chromium(executable) as browser:
        for path, page in pages.items():
            name = path.relative_to(root).as_posix()
            if "screen" in kinds:
                found += [f"{name} at {width} px: {problem}" for width in WIDTHS
                          for problem in problems_on_screen(browser, path, width)]
            if "answers" in kinds and page.has_pictures:
                found += [f"{name}: {problem}" for problem in problems_of_answers(browser, path)]
        if "drawings" in kinds:
            found += [f"{drawing.relative_to(root).as_posix()} on {', '.join(shown)}: {problem}"
                      for drawing, shown in _drawings(root, pages).items()
                      for problem in problems_of_drawing(browser, drawing)]
    return found


def _drawings(root: Path, pages: dict[Path, Page]) -> dict[Path, list[str]]:
    """Every drawn figure with the pages that show it."""
    drawings: dict[Path, list[str]] = {}
    for page in pages.values():
        for url in page.loads:
            drawing = (page.path.parent / url).resolve()
            if drawing.suffix == ".svg" and drawing.parent == root / "_images" and drawing.exists():
                drawings.setdefault(drawing, []).append(page.path.name)
    return drawings


def main() -> int:
    """Inspect the built book named on the command line."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("root", type=Path, help="the folder with the built pages")
    parser.add_argument("--browser", help="also open every page in this Chromium")
    parser.add_argument("--only", nargs="+", choices=KINDS, default=KINDS, help="what to look at in the browser")
    parser.add_argument("--pages", nargs="+", help="names without .html that are opened; default: all")
    options = parser.parse_args()
    root = options.root.resolve()
    pages = pages_of(root)
    if not pages:
        print(f"no pages in {options.root}; build the book first: make book", file=sys.stderr)
        return 2
    found = problems_of_text(root, pages)
    if options.browser:
        chosen = {path: page for path, page in pages.items() if not options.pages or path.stem in options.pages}
        found += problems_in_browser(root, chosen, options.browser, kinds=tuple(options.only))
    opened = "opened in a browser" if options.browser else "read"
    print(*found, f"{len(pages)} pages {opened}, {len(found)} problems", sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
