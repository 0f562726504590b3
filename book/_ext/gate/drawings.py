"""Words of the drawn figures: none over another one, none cut by the edge of its figure.

Matplotlib writes each text of a drawing as one group of glyphs, so the browser knows where it is to a fraction
of a pixel, and the check sees the very files that readers see.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING

from gate.exceptions import WORDS_MAY_MEET

if TYPE_CHECKING:
    from chromium import Chromium

WORDS = """
(() => {
  const SLACK = 0.5; // [px]
  const allowed = ALLOWED;
  const frame = document.documentElement.getBoundingClientRect();
  const said = node => document.createTreeWalker(node, NodeFilter.SHOW_COMMENT).nextNode()?.data.trim() ?? node.id;
  const real = ({ width, height }) => width > 0 && height > 0;
  // Glyph by glyph: the box around a slanted text is much larger than the text.
  const texts = [...document.querySelectorAll('g[id^="text_"]')].map(node => ({
    whole: node.getBoundingClientRect(), words: said(node),
    glyphs: [...node.querySelectorAll("use, path")].filter(one => !one.closest("defs"))
      .map(one => one.getBoundingClientRect()).filter(real),
  })).filter(({ glyphs }) => glyphs.length);
  const meet = (a, b) => Math.min(a.right, b.right) - Math.max(a.left, b.left) > SLACK
    && Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > SLACK;
  const found = [];
  texts.forEach((one, index) => {
    if (one.glyphs.some(({ left, right, top, bottom }) => left < frame.left - SLACK || right > frame.right + SLACK
        || top < frame.top - SLACK || bottom > frame.bottom + SLACK)) found.push(`"${one.words}" leaves the figure`);
    for (const other of texts.slice(index + 1)) {
      if (meet(one.whole, other.whole) && one.glyphs.some(a => other.glyphs.some(b => meet(a, b)))
          && !allowed.some(pair => pair.includes(one.words) && pair.includes(other.words))) {
        found.push(`"${one.words}" over "${other.words}"`);
      }
    }
  });
  return { found, count: texts.length };
})()
""".replace("ALLOWED", json.dumps(list(WORDS_MAY_MEET)))


def problems_of_drawing(browser: Chromium, drawing: Path) -> list[str]:
    """Everything wrong with the words of one SVG file."""
    browser.open(drawing, width=1280)
    state = browser.ask(WORDS)
    return list(state["found"]) if state["count"] else ["has no words that the gate can see"]
