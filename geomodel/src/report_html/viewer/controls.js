// SPDX-License-Identifier: MIT
// The bar above the picture.
function showControls() {
  for (const e of root.querySelectorAll("[data-for]")) e.hidden = !e.dataset.for.split(" ").includes(mode());
  find(".what").textContent = mode() === "line" ? "moved" : "x";
}
function cutChanged() { showControls(); buildWalls(); tell(cutWords()); }
function stretchChanged() { control("times").value = timesWords(); fit(); build(); }
function cutBy(name) { control("cut").value = name; flipped = false; cutChanged(); }
/** Straight onto the plane that cuts, without perspective's slant. */
function faceCut() {
  const cutting = facingPlanes();
  if (cutting.length !== 1) return;
  const n = cutting[0].n;
  if (Math.abs(n[2]) > 0.5) view.tilt = n[2] > 0 ? 1.57 : -1.57;
  else Object.assign(view, {tilt: 0, turn: Math.atan2(n[0], n[1])});
  Object.assign(view, {zoom: 1, focus: [0, 0, 0], shift: [0, 0]});
  fit(); schedule();
}
function resetView() {
  Object.assign(view, start, {focus: [0, 0, 0], shift: [0, 0]});
  fit(); schedule();
}
function fullScreen() { if (document.fullscreenElement) document.exitFullscreen(); else if (root.requestFullscreen) root.requestFullscreen(); }
function fillChoices() {
  const select = control("colours"), wells = model.curves.filter(c => c.kind === "well"), cut = control("cut");
  model.quantities.forEach((q, i) => select.append(element("option", "by " + q.name, {value: i})));
  for (const w of wells) cut.append(element("option", "through " + w.name, {value: "well " + w.id}));
}
function setUpControls() {
  fillChoices();
  control("stretch").max = Math.max(10, 2 * model.stretch); control("stretch").value = model.stretch;
  for (const k of [0, 1]) control(["at1", "at2"][k]).value = 0.5 + model.corner[k] / model.size[k];
  control("at3").value = 0.5;
  control("cut").onchange = () => {
    flipped = false;
    const well = mode().startsWith("well ") ? Number(mode().slice(5)) : 0;
    if (well) cutThroughWell(well);
    turnToCut(); cutChanged();
    if (well) tell("Cut through " + curveOf.get(well).name + ", " + cutWords().slice(4));
  };
  for (const name of ["at1", "at2", "at3", "strike"]) control(name).oninput = cutChanged;
  control("strike").onchange = () => { turnToCut(); schedule(); };  // once the slider is let go
  control("flip").onclick = () => { flipped = !flipped; schedule(); tell("The other side is cut away."); };
  control("face").onclick = faceCut;
  control("draw").onclick = () => { drawLine(!canvas.classList.contains("drawing")); };
  control("colours").onchange = build; control("stretch").oninput = stretchChanged; control("lines").onchange = schedule;
  control("apart").oninput = () => { fit(); build(); };
  control("reset").onclick = resetView; control("full").onclick = fullScreen; control("save").onclick = savePicture;
  showControls();
  control("times").value = timesWords();
}
