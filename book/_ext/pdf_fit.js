// What is wider than the paper is made to fit it, in place: first tables, then formulas that cannot be broken.
(async () => {
  await document.fonts.ready;
  await Promise.all([...document.images].map(image => image.decode().catch(() => null)));
  // Everything is laid out anew from nothing: what was laid out before a face of type or a style sheet was there keeps
  // traces of it, a quarter of a pixel here and there, and two prints would differ.
  document.body.style.display = 'none';
  document.body.getBoundingClientRect();
  document.body.style.display = '';
  document.body.getBoundingClientRect();
  await document.fonts.ready;
  const LEAST = 0.5;
  const room = box => {
    const style = getComputedStyle(box);
    return box.clientWidth - parseFloat(style.paddingLeft) - parseFloat(style.paddingRight);
  };
  for (const table of document.querySelectorAll('article table')) {
    let scale = 1;
    for (let step = 0; step < 4; step++) {
      const free = room(table.parentElement);
      const wide = table.getBoundingClientRect().width;
      if (wide <= free + 0.5) break;
      scale = Math.max(LEAST, scale * free / wide * 0.995);
      table.style.zoom = scale;
    }
    if (scale < 1) table.dataset.scale = scale.toFixed(2);
  }
  for (const formula of document.querySelectorAll('article mjx-container')) {
    const inner = formula.querySelector('mjx-math');
    if (!inner) continue;
    const box = formula.getAttribute('display') ? formula.parentElement : formula.closest('p, td, th, li, dd, figcaption, div');
    const free = box.getBoundingClientRect().left + parseFloat(getComputedStyle(box).paddingLeft) + room(box)
      - inner.getBoundingClientRect().left;
    const wide = inner.getBoundingClientRect().width;
    if (wide > free + 1 && formula.getAttribute('display')) {
      const scale = Math.max(LEAST, free / wide * 0.99);
      formula.style.setProperty('font-size', `${100 * scale}%`, 'important');
      formula.dataset.scale = scale.toFixed(2);
    }
  }
})()
