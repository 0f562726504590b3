// See a figure large: click it, or press Enter on it. Esc, a click or the button closes it; what is wider than the
// screen can be moved with a finger or the arrow keys. No library; works from file://.
(() => {
  const FIGURES = ".bd-article .cell_output img, .bd-article figure img";

  const open = picture => {
    const dialog = document.createElement("dialog");
    dialog.className = "zoom";
    dialog.setAttribute("aria-label", picture.alt);
    const space = document.createElement("div");
    space.className = "space";
    space.tabIndex = 0;
    const large = picture.cloneNode();
    for (const name of ["tabindex", "role", "aria-label", "style", "width", "height", "title"]) large.removeAttribute(name);
    space.append(large);
    const close = document.createElement("button");
    close.type = "button";
    close.textContent = "Close";
    dialog.append(close, space);
    dialog.addEventListener("click", () => dialog.close());
    dialog.addEventListener("keydown", event => { if (event.key === "Escape") dialog.close(); });
    dialog.addEventListener("close", () => { dialog.remove(); picture.focus({ preventScroll: true }); });
    document.body.append(dialog);
    dialog.showModal();
    space.focus();
  };

  const ready = () => document.querySelectorAll(FIGURES).forEach(picture => {
    picture.tabIndex = 0;
    picture.setAttribute("role", "button");
    picture.setAttribute("aria-label", `${picture.alt} (show large)`);
    picture.setAttribute("aria-haspopup", "dialog");
  });

  document.addEventListener("click", event => {
    const picture = event.target.closest(FIGURES);
    if (!picture) return;
    event.preventDefault();
    open(picture);
  });
  document.addEventListener("keydown", event => {
    if (!["Enter", " "].includes(event.key) || !event.target.matches(FIGURES)) return;
    event.preventDefault();
    open(event.target);
  });
  document.readyState === "loading" ? document.addEventListener("DOMContentLoaded", ready) : ready();
})();
