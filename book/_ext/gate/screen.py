"""What shows when a page is opened: formulas that are not typeset, a page wider than its screen, text over text."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING

from gate.console import problems_of_events
from gate.exceptions import MAY_OVERLAP

if TYPE_CHECKING:
    from chromium import Chromium

WIDTHS = (1280, 390)
"""A desktop and a phone [px]."""
MOST_TOLD = 8
"""Of one kind of fault on one page; a fault of the style sheet shows in every table."""
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
    tabs: Math.max(0, ...all('.sd-tab-set').map(set => set.querySelectorAll(':scope > label').length)),
  };
})()
"""
UNFOLD = "document.querySelectorAll('details').forEach(one => { one.open = true; })"
SHOW_TAB = """
document.querySelectorAll('.sd-tab-set').forEach(set => set.querySelectorAll(':scope > label')[NUMBER]?.click())
"""
_SCRIPT = (Path(__file__).parent / "layout.js").read_text(encoding="utf-8")
LAYOUT = f"{{ const ignored = {json.dumps(list(MAY_OVERLAP))};\n{_SCRIPT} }}"


def problems_on_screen(browser: Chromium, page: Path, width: int) -> list[str]:
    """Everything wrong with a page on a screen of some width [px], folded and unfolded."""
    browser.open(page, width=width)
    state = browser.ask(QUESTIONS)
    told = []
    if state["mathErrors"]:
        told.append(f"{state['mathErrors']} formulas with errors")
    if state["rawFormulas"]:
        told.append(f"{state['rawFormulas']} formulas not typeset")
    if state["scrollWidth"] > state["width"]:
        told.append(f"is {state['scrollWidth']} px wide on a screen of {state['width']} px; "
                    f"look at {', '.join(state['widest'])}")
    layout = list(browser.ask(LAYOUT))
    browser.ask(UNFOLD)
    for tab in range(max(1, state["tabs"])):
        browser.ask(SHOW_TAB.replace("NUMBER", str(tab)))
        layout += browser.ask(LAYOUT)
    layout = list(dict.fromkeys(layout))
    told += layout[:MOST_TOLD]
    if len(layout) > MOST_TOLD:
        told.append(f"and {len(layout) - MOST_TOLD} more of these")
    return list(dict.fromkeys(told + problems_of_events(browser.events)))
