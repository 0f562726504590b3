// Arrow keys turn pages, except where they move something: in a dialog, in an interactive figure, in a box that scrolls.
(() => {
  const MOVED = "dialog, .plotly-graph-div, .cost-chooser, [role=slider], [role=tab], [contenteditable]";
  const scrolls = node => node !== document.body && node.scrollWidth > node.clientWidth + 1
    && ["auto", "scroll"].includes(getComputedStyle(node).overflowX);

  document.documentElement.addEventListener("keydown", event => {
    if (!["ArrowLeft", "ArrowRight"].includes(event.key)) return;
    if (event.target.closest(MOVED) || scrolls(event.target)) event.stopPropagation();  // the theme listens farther out
  });
})();
