"""The script of the interactive picture of costs: it puts stored points and words in their place."""

from __future__ import annotations

SCRIPT = """
(() => {
  const box = document.getElementById("NAME");
  const [scene, accuracy] = box.querySelectorAll("select, input");
  const { states, accuracies } = JSON.parse(box.querySelector("script[type='application/json']").textContent);
  const show = () => {
    const plot = document.getElementById("plotly-NAME");
    const state = states[scene.value], answer = state.answers[accuracy.value];
    const traces = [...state.traces, ...answer.marks];
    const change = key => traces.map(trace => trace[key] ?? []);
    box.querySelector(".wanted").innerHTML = accuracies[accuracy.value];
    box.querySelector(".answer").innerHTML = answer.words;
    accuracy.setAttribute("aria-valuetext", box.querySelector(".wanted").textContent);
    Plotly.restyle(plot, { x: change("x"), y: change("y"), customdata: change("customdata") }, traces.map((_, k) => k));
  };
  scene.addEventListener("change", show);
  accuracy.addEventListener("input", show);
})();
"""
"""``NAME`` stands for the name of the elements in the page."""
