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
  const corners = node => {
    const { x, y, width, height } = node.getBBox(), place = node.getScreenCTM();
    return [[x, y], [x + width, y], [x + width, y + height], [x, y + height]]
      .map(([left, top]) => new DOMPoint(left, top).matrixTransform(place));
  };
  // Glyph by glyph: the box around a slanted text is much larger than the text.
  const texts = [...document.querySelectorAll('g[id^="text_"]')].map(node => ({
    whole: node.getBoundingClientRect(), words: said(node),
    glyphs: [...node.querySelectorAll("use, path")].filter(one => !one.closest("defs"))
      .filter(one => real(one.getBoundingClientRect())).map(corners),
  })).filter(({ glyphs }) => glyphs.length);
  const boxes = (a, b) => Math.min(a.right, b.right) - Math.max(a.left, b.left) > SLACK
    && Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > SLACK;
  // Two slanted boxes meet unless a side of one of them parts them.
  const parted = (a, b) => [0, 1].some(k => {
    const along = [a[k + 1].x - a[k].x, a[k + 1].y - a[k].y], length = Math.hypot(...along) || 1;
    const [of, other] = [a, b].map(box => box.map(({ x, y }) => (x * along[0] + y * along[1]) / length));
    return Math.min(Math.max(...of), Math.max(...other)) - Math.max(Math.min(...of), Math.min(...other)) <= SLACK;
  });
  const meet = (a, b) => !parted(a, b) && !parted(b, a);
  const found = [];
  texts.forEach((one, index) => {
    if (one.glyphs.flat().some(({ x, y }) => x < frame.left - SLACK || x > frame.right + SLACK
        || y < frame.top - SLACK || y > frame.bottom + SLACK)) found.push(`"${one.words}" leaves the figure`);
    for (const other of texts.slice(index + 1)) {
      if (boxes(one.whole, other.whole) && one.glyphs.some(a => other.glyphs.some(b => meet(a, b)))
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
