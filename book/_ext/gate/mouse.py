"""A hand on the mouse and the keyboard: what the browser gets is what a reader would send."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from chromium import Chromium


def move(browser: Chromium, x: float, y: float) -> None:
    """Move the pointer to a place of the window [px]."""
    browser.call("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y)


def click(browser: Chromium, x: float, y: float) -> None:
    """Move to a place of the window [px], press and let go."""
    move(browser, x, y)
    for what in ("mousePressed", "mouseReleased"):
        browser.call("Input.dispatchMouseEvent", type=what, x=x, y=y, button="left", clickCount=1)


def drag(browser: Chromium, x: float, y: float, by: float) -> None:
    """Press at a place of the window, move along both axes by some pixels in a few steps, let go."""
    move(browser, x, y)
    browser.call("Input.dispatchMouseEvent", type="mousePressed", x=x, y=y, button="left", buttons=1, clickCount=1)
    for part in (0.25, 0.5, 0.75, 1.0):
        browser.call("Input.dispatchMouseEvent", type="mouseMoved", x=x + part * by, y=y + part * by / 2, button="left",
                     buttons=1)
    browser.call("Input.dispatchMouseEvent", type="mouseReleased", x=x + by, y=y + by / 2, button="left", clickCount=1)


def press(browser: Chromium, key: str) -> None:
    """Press a key and let go, by its DOM name such as ArrowDown."""
    codes = {"ArrowDown": 40, "ArrowRight": 39}
    for what in ("rawKeyDown", "keyUp"):
        browser.call("Input.dispatchKeyEvent", type=what, key=key, code=key, windowsVirtualKeyCode=codes[key])
