"use strict";
// A section that has both pictures gets a slider and a flip. Without this script the pictures stand side by side.
for (const three of document.querySelectorAll(".three.both")) {
  const [reference, actual] = three.querySelectorAll("img");
  const element = (name, properties) => Object.assign(document.createElement(name), properties);
  const pair = element("div", { className: "pair" });
  const above = actual.cloneNode();
  pair.append(reference.cloneNode(), above);
  const slider = element("input", { type: "range", min: 0, max: 1000, value: 500 });
  slider.setAttribute("aria-label", "share of the reference, from the left");
  const note = element("p", {});
  const one = element("div", { className: "one", hidden: true });
  one.append(pair, slider, note);
  three.after(one);
  let mode = "side by side";
  let showsActual = true;
  const draw = () => {
    three.hidden = mode !== "side by side";
    one.hidden = !three.hidden;
    slider.hidden = mode !== "slider";
    above.style.clipPath = mode === "slider" ? `inset(0 0 0 ${slider.value / 10}%)` : "none";
    above.style.visibility = mode === "slider" || showsActual ? "visible" : "hidden";
    note.textContent = mode === "slider" ? "left: reference, right: actual" : (showsActual ? "actual" : "reference") + " (press flip again, or the picture)";
    for (const button of bar.children) button.setAttribute("aria-pressed", button.textContent === mode);
  };
  const bar = element("div", { className: "bar" });
  for (const name of ["side by side", "slider", "flip"]) {
    const button = element("button", { type: "button", textContent: name });
    button.onclick = () => {
      showsActual = name === "flip" && mode === "flip" ? !showsActual : true;
      mode = name;
      draw();
    };
    bar.append(button);
  }
  slider.oninput = draw;
  pair.onclick = () => {
    if (mode === "flip") showsActual = !showsActual;
    draw();
  };
  three.before(bar);
  draw();
}
