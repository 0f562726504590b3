"""Picture every page for a look by eye: ``python picture_pages.py BUILD/html OUT [PAGE ...]``.

Each page is taken whole, at desktop and phone width, light and dark: ``OUT/page-1280-light.png`` and so on.
"""

from __future__ import annotations

import argparse
from pathlib import Path

from chromium import Chromium

WIDTHS = (1280, 390)
TALLEST = 16000  # Chromium does not paint taller pictures
SETTLED = "new Promise(resolve => setTimeout(resolve, 600))"  # the theme slides its sidebars in


def main() -> None:
    """Picture the pages named on the command line, or all of them."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("root", type=Path)
    parser.add_argument("out", type=Path)
    parser.add_argument("pages", nargs="*", help="names without .html; default: all")
    parser.add_argument("--browser", default="chromium")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    names = options.pages or sorted(path.stem for path in options.root.glob("*.html"))
    with Chromium(options.browser) as browser:
        for name in names:
            for width in WIDTHS:
                for mode in ("light", "dark"):
                    page = options.root / f"{name}.html"
                    browser.open(page, width=width, dark=mode == "dark")
                    tall = min(TALLEST, int(browser.ask("document.documentElement.scrollHeight")))
                    browser.open(page, width=width, height=tall, dark=mode == "dark")
                    browser.ask(SETTLED)
                    browser.picture(options.out / f"{name}-{width}-{mode}.png", width=width, height=tall)


if __name__ == "__main__":
    main()
