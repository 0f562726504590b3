// Where a hand can reach the parts of an interactive figure, and what the figure shows now.
(() => {
  const centre = node => {
    const { left, top, width, height } = node.getBoundingClientRect();
    return [left + width / 2, top + height / 2];
  };
  // A place on a drawn line: half of its length along it, on the screen.
  const onLine = path => {
    const along = path.getPointAtLength(path.getTotalLength() / 2);
    const { x, y } = new DOMPoint(along.x, along.y).matrixTransform(path.getScreenCTM());
    return [x, y];
  };
  const inside = ([x, y], node) => {
    const { left, top, right, bottom } = node.getBoundingClientRect();
    return x > left && x < right && y > top && y < bottom;
  };
  window.figureParts = id => {
    const figure = document.getElementById(id);
    figure.scrollIntoView({ block: "center" });
    const all = selector => [...figure.querySelectorAll(selector)].filter(node => node.getBoundingClientRect().width > 0);
    window.told = [];
    if (!figure.watched) {
      figure.watched = true;
      for (const what of ["plotly_click", "plotly_hover"]) figure.on(what, () => window.told.push(what));
    }
    return {
      sliders: all(".slider-rail-touch-rect").map(node => {
        const { left, top, width, height } = node.getBoundingClientRect();
        return [0.8, 0.3].map(part => [left + part * width, top + height / 2]);
      }),
      legend: all(".legend .traces").filter(node => node.querySelector(".legendtoggle")).map(centre),
      buttons: all(".updatemenu-button").map(centre),
      menus: all(".updatemenu-header").map(centre),
      scenes: all(".gl-container canvas").length ? all(".gl-container > div").map(centre) : [],
      marks: [...all(".points path, .barlayer path").slice(0, 40).map(centre), ...all("path.js-line").map(onLine)]
        .filter(place => inside(place, figure)),
    };
  };
  // What is drawn, without the positions of sliders and menus: these follow the hand whether or not the drawing does.
  window.figureState = id => {
    const { data, layout } = document.getElementById(id);
    const { sliders, updatemenus, ...drawn } = layout;
    const text = JSON.stringify([data, drawn], (_, value) => ArrayBuffer.isView(value) ? [...value] : value);
    let hash = 7;
    for (let k = 0; k < text.length; k++) hash = (hash * 31 + text.charCodeAt(k)) | 0;
    return hash;
  };
  // Everything that a page says and draws, for controls that stand outside a figure.
  window.pageState = () => [document.querySelector(".bd-article").innerText,
    ...[...document.querySelectorAll(".plotly-graph-div")].map(one => window.figureState(one.id))].join();
  window.controls = () => [...document.querySelectorAll(".bd-article :is(select, input[type=range])")]
    .filter(node => node.checkVisibility());
  window.reach = node => { node.scrollIntoView({ block: "center" }); return centre(node); };
  window.pictures = () => [...document.querySelectorAll(".bd-article :is(.cell_output img, figure img)")]
    .filter(node => node.checkVisibility());
})()
