// Click a figure to see it large (Esc or a second click closes it). No library; works from file://.
document.addEventListener("click", (event) => {
  const picture = event.target.closest(".cell_output img, figure img");
  if (!picture) return;
  event.preventDefault();
  const dialog = document.createElement("dialog");
  dialog.className = "zoom";
  dialog.append(picture.cloneNode());
  dialog.addEventListener("click", () => dialog.close());
  dialog.addEventListener("close", () => dialog.remove());
  document.body.append(dialog);
  dialog.showModal();
});
