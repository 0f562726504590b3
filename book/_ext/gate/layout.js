// What a reader cannot read on this screen: text over other text, text that is cut, text outside its box or the screen.
// The gate puts `ignored` (selectors of what may overlap, each with its reason in exceptions.py) before this.
(() => {
  const SLACK = 2; // [px]; neighbours share a pixel where the browser rounds
  const AIR = 0.18; // of the height of a line of text above and below its letters
  const LEAVES = new Set(["IMG", "CANVAS", "BUTTON", "INPUT", "SELECT", "VIDEO", "SVG"]);
  const SILENT = new Set(["SCRIPT", "STYLE", "NOSCRIPT", "TEMPLATE", "TITLE", "MJX-ASSISTIVE-MML", "OPTION"]);
  const INLINE = /^(inline|contents|ruby)/;

  const shown = node => node.checkVisibility({ opacityProperty: true, visibilityProperty: true });
  const styles = new Map();
  const style = node => styles.get(node) ?? styles.set(node, getComputedStyle(node)).get(node);
  const frames = new Map();
  const frameOf = node => frames.get(node) ?? frames.set(node, node.getBoundingClientRect()).get(node);
  const plain = ({ left, top, right, bottom }) => ({ left, top, right, bottom });
  const lower = rect => {
    const air = AIR * (rect.bottom - rect.top);
    return { ...plain(rect), top: rect.top + air, bottom: rect.bottom - air };
  };
  const name = node => node.tagName.toLowerCase() + [...node.classList].slice(0, 2).map(one => "." + one).join("");

  const items = [];
  const add = (node, rects, words) => {
    const real = rects.filter(({ left, right, top, bottom }) => right - left > 1 && bottom - top > 1);
    if (real.length) items.push({ node, rects: real, words: words.trim().replace(/\s+/g, " ").slice(0, 40) });
  };
  const walk = node => {
    if (SILENT.has(node.tagName.toUpperCase()) || !shown(node) || (ignored.length && node.matches(ignored.join()))) return;
    if (node.tagName === "MJX-CONTAINER") {
      const glyphs = [...node.querySelectorAll("mjx-c")].map(one => plain(one.getBoundingClientRect()));
      return add(node, glyphs, "formula");
    }
    if (node.classList.contains("plotly-graph-div")) {
      for (const text of node.querySelectorAll("svg text")) {
        if (shown(text) && text.textContent.trim()) add(text, [lower(text.getBoundingClientRect())], text.textContent);
      }
      return;
    }
    if (LEAVES.has(node.tagName.toUpperCase())) return add(node, [plain(node.getBoundingClientRect())], node.alt ?? name(node));
    for (const child of node.childNodes) {
      if (child.nodeType === Node.ELEMENT_NODE) walk(child);
      if (child.nodeType !== Node.TEXT_NODE || !child.data.trim()) continue;
      const range = document.createRange();
      range.selectNodeContents(child);
      add(node, [...range.getClientRects()].map(lower), child.data);
    }
  };
  walk(document.body);

  // Boxes around an item that cut it or let a reader scroll to it, from the inside out.
  const found = new Set();
  const told = (what, item, more = "") => found.add(`${what}: "${item.words}" in ${name(item.node)}${more}`);
  const isCut = (how) => how === "hidden" || how === "clip";
  const scrolls = (how) => how === "auto" || how === "scroll";
  for (const item of items) {
    let box = null;
    for (let node = item.node; node && node !== document.body; node = node.parentElement) {
      const { overflowX, overflowY, display, position } = style(node);
      const frame = frameOf(node);
      const drawn = LEAVES.has(item.node.tagName.toUpperCase()) && node === item.node;
      if (!drawn && !(node instanceof SVGElement)) {
        if (!box && !INLINE.test(display)) {
          box = node;
          const hang = Math.min(0, parseFloat(style(node).textIndent)); // an indent to the left is meant to leave the box
          const { left, right, top, bottom } = frameOf(node.closest("td, th") ?? node); // a cell has room around its text
          const outside = item.rects.find(rect => rect.left < left + hang - SLACK || rect.right > right + SLACK
            || rect.top < top - 3 * SLACK || rect.bottom > bottom + 3 * SLACK);
          if (outside && !scrolls(overflowX) && !isCut(overflowX)) told("outside its box", item, `, ${name(node)}`);
        }
        const cut = rect => (isCut(overflowX) && (rect.left < frame.left - SLACK || rect.right > frame.right + SLACK))
          || (isCut(overflowY) && (rect.top < frame.top - SLACK || rect.bottom > frame.bottom + SLACK));
        if (item.rects.some(cut)) told("cut", item, `, by ${name(node)}`);
        if (overflowX !== "visible" || overflowY !== "visible") {
          item.rects = item.rects.map(rect => ({ left: Math.max(rect.left, frame.left), right: Math.min(rect.right, frame.right),
            top: Math.max(rect.top, frame.top), bottom: Math.min(rect.bottom, frame.bottom) }))
            .filter(({ left, right, top, bottom }) => right > left && bottom > top);
        }
      }
      if (position === "fixed" || position === "sticky") item.floats = true;
    }
    if (item.rects.some(({ left, right }) => left < -1 || right > innerWidth + 1)) told("beyond the screen", item);
  }

  // Rectangles are compared within bands of the page, so that a long page takes no longer a line than a short one.
  const BAND = 60;
  const bands = new Map();
  items.forEach((item, index) => item.rects.forEach(rect => {
    for (let band = Math.floor(rect.top / BAND); band <= Math.floor(rect.bottom / BAND); band++) {
      if (!bands.has(band)) bands.set(band, []);
      bands.get(band).push([index, rect]);
    }
  }));
  const met = new Set();
  for (const here of bands.values()) {
    for (let i = 0; i < here.length; i++) for (let j = i + 1; j < here.length; j++) {
      const [one, a] = here[i], [two, b] = here[j];
      if (one === two || met.has(one * items.length + two)) continue;
      if (Math.min(a.right, b.right) - Math.max(a.left, b.left) <= SLACK) continue;
      if (Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) <= SLACK) continue;
      if (items[one].floats !== items[two].floats) continue; // what stays while a page is scrolled lies over the page
      met.add(one * items.length + two);
      told("over each other", items[one], ` and "${items[two].words}" in ${name(items[two].node)}`);
    }
  }
  return [...found];
})()
