// Show what a reference points to while the pointer or the keyboard rests on it. Previews of a page are a script that is
// loaded when one of them is first wanted, so pages load as fast as without, also from file://. Fingers follow links.
(() => {
  const REFERENCES = "article.bd-article a[href]:not(.headerlink, [download], .btn)";
  const BEFORE = 250, AFTER = 200;  // milliseconds
  const home = () => new URL(document.documentElement.dataset.content_root || "./", location.href);
  const pages = new Map();
  let tip = null, owner = null, waiting = 0;

  window.showPreviews = (page, previews) => pages.get(page)?.found(previews);

  const load = page => {
    if (!pages.has(page)) {
      const entry = {};
      entry.previews = new Promise(found => { entry.found = found; });
      pages.set(page, entry);
      const script = document.createElement("script");
      script.src = new URL(`_static/previews/${page}.js`, home()).href;
      script.onerror = () => entry.found({});
      document.head.append(script);
    }
    return pages.get(page).previews;
  };

  const place = link => {  // page and anchor that a link of the book leads to
    const url = new URL(link.href), base = home().pathname;
    if (url.protocol !== location.protocol || !url.pathname.startsWith(base) || !url.pathname.endsWith(".html")) return null;
    return [url.pathname.slice(base.length, -5), decodeURIComponent(url.hash.slice(1))];
  };

  const hide = () => {
    clearTimeout(waiting);
    if (tip) {
      window.MathJax?.typesetClear?.([tip]);
      tip.remove();
      owner.removeAttribute("aria-describedby");
    }
    tip = owner = null;
  };

  const put = () => {
    const at = owner.getClientRects()[0] ?? owner.getBoundingClientRect(), own = tip.getBoundingClientRect();
    const below = at.bottom + 6 + own.height <= innerHeight || at.top < own.height + 6;
    tip.style.left = `${Math.max(8, Math.min(at.left, document.documentElement.clientWidth - own.width - 8))}px`;
    tip.style.top = `${below ? Math.min(at.bottom + 6, Math.max(8, innerHeight - own.height - 8)) : at.top - own.height - 6}px`;
  };

  const show = async link => {
    const target = place(link);
    if (!target) return;
    const wanted = owner = link;
    const content = (await load(target[0]))[target[1]];
    if (owner !== wanted || !content) return;
    tip = document.createElement("div");
    tip.id = "reference-preview";
    tip.className = "preview";
    tip.setAttribute("role", "tooltip");
    tip.innerHTML = content;
    tip.querySelectorAll("img").forEach(image => { image.src = new URL(image.getAttribute("src"), home()).href; });
    tip.addEventListener("pointerenter", () => clearTimeout(waiting));
    tip.addEventListener("pointerleave", leave);
    document.body.append(tip);
    link.setAttribute("aria-describedby", tip.id);
    link.removeAttribute("title");  // it would say the same once more
    const images = [...tip.querySelectorAll("img")].map(image => image.decode().catch(() => {}));
    await Promise.all([window.MathJax?.typesetPromise?.([tip]), ...images]);
    if (owner !== wanted) return;
    put();
    tip.classList.add("shown");
  };

  const leave = () => { clearTimeout(waiting); waiting = setTimeout(hide, AFTER); };
  const enter = (link, delay) => {
    clearTimeout(waiting);
    if (link === owner) return;
    waiting = setTimeout(() => { hide(); show(link); }, delay);
  };
  const reference = node => node.closest?.(REFERENCES);

  document.addEventListener("pointerover", event => {
    const link = event.pointerType !== "touch" && reference(event.target);
    if (link) enter(link, BEFORE);
  });
  document.addEventListener("pointerout", event => { if (owner ?? reference(event.target)) leave(); });
  document.addEventListener("focusin", event => {
    const link = event.target.matches?.(":focus-visible") && reference(event.target);
    if (link) enter(link, 0);
  });
  document.addEventListener("focusout", hide);
  document.addEventListener("keydown", event => { if (event.key === "Escape") hide(); });
  document.addEventListener("scroll", event => { if (event.target === document) hide(); }, true);
})();
