// What would be lost or look wrong on paper, asked of the document as it is printed: one line for each problem.
(() => {
  const TOLERANCE = 1; // pixels; positions are rounded
  const RAW_TEX = /\\[a-zA-Z]+\s*[{(\\]|\\[([\])]|\$\$/;
  const found = [];
  const say = (node, problem) => {
    const where = node.closest('.chapter-pages')?.id ?? 'contents';
    found.push(`${where}: ${problem}: ${node.tagName.toLowerCase()} ${node.textContent.trim().slice(0, 50)}`);
  };
  const paper = document.querySelector('article').getBoundingClientRect();
  for (const node of document.querySelectorAll('article *')) {
    if (node.matches('mjx-container *, svg *')) continue;
    const inner = node.matches('mjx-container') ? node.querySelector('mjx-math') ?? node : node;
    const box = inner.getBoundingClientRect();
    if (!box.width || !box.height) continue;
    if (box.right > paper.right + TOLERANCE || box.left < paper.left - TOLERANCE) say(node, 'reaches over the page');
    const style = getComputedStyle(node);
    const wide = node.scrollWidth > node.clientWidth + TOLERANCE && style.overflowX !== 'visible';
    const tall = node.scrollHeight > node.clientHeight + TOLERANCE && style.overflowY !== 'visible';
    if (style.display !== 'inline' && (wide || tall)) say(node, 'is cut or scrolls');
    if (node.matches('img') && !node.naturalWidth) say(node, `picture not found, ${node.getAttribute('src').slice(0, 80)}`);
    if (node.matches('.math') && !node.querySelector('mjx-container')) say(node, 'formula not typeset');
    if (node.matches('mjx-container') && node.querySelector('mjx-merror, [data-mjx-error]')) say(node, 'formula with an error');
  }
  const texts = document.createTreeWalker(document.querySelector('article'), NodeFilter.SHOW_TEXT);
  while (texts.nextNode()) {
    const parent = texts.currentNode.parentElement;
    if (parent.closest('pre, code, mjx-container, script, style')) continue;
    if (RAW_TEX.test(texts.currentNode.data)) say(parent, 'shows TeX');
  }
  return [...new Set(found)];
})()
