// A button beside each displayed formula copies its LaTeX: what MathJax was given.
(() => {
  const source = formula => MathJax.startup.document.getMathItemsWithin(formula).map(item => item.math.trim()).join("\n");

  const byHand = text => {  // browsers that keep the clipboard from pages of the file system
    const held = document.createElement("textarea");
    held.value = text;
    held.style.cssText = "position: fixed; top: 0; opacity: 0";
    document.body.append(held);
    held.select();
    const done = document.execCommand("copy");
    held.remove();
    return done;
  };

  const copy = async text => {
    try {
      await navigator.clipboard.writeText(text);
      return true;
    } catch {
      return byHand(text);
    }
  };

  const told = (button, words) => {
    const before = button.textContent;
    button.textContent = words;
    button.disabled = true;
    setTimeout(() => { button.textContent = before; button.disabled = false; }, 1200);
  };

  const ready = () => document.querySelectorAll(".bd-article div.math").forEach(formula => {
    const number = formula.querySelector(".eqno")?.firstChild.textContent ?? "";
    const button = document.createElement("button");
    button.type = "button";
    button.className = "copy-tex";
    button.textContent = "TeX";
    button.title = "Copy LaTeX";
    button.setAttribute("aria-label", `Copy LaTeX of formula ${number}`.trim());
    button.addEventListener("click", async () => told(button, await copy(source(formula)) ? "✓" : "–"));
    const tools = document.createElement("span");
    tools.className = "tools";
    tools.append(...formula.querySelectorAll(".eqno .headerlink"), button);
    (formula.querySelector(".eqno") ?? formula).append(tools);
  });
  document.readyState === "loading" ? document.addEventListener("DOMContentLoaded", ready) : ready();
})();
