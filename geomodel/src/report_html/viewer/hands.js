// SPDX-License-Identifier: MIT
// Mouse, fingers and keys.
function turn(dx, dy) { view.turn += dx; view.tilt = limit(view.tilt + dy, -1.57, 1.57); schedule(); }
function shift(dx, dy) {
  view.shift[0] += 2 * dx / canvas.clientWidth; view.shift[1] -= 2 * dy / canvas.clientHeight;
  schedule();
}
function zoom(by) { view.zoom = limit(view.zoom * by, 0.2, 200); schedule(); }
function moveCut(by) {
  const slider = {corner: "at1", x: "at1", y: "at2", z: "at3", line: "at1"}[mode()];
  if (slider) { control(slider).value = limit(Number(control(slider).value) + by, 0, 1); cutChanged(); }
}
let lineFrom = null;
function drawLine(on) {
  canvas.classList.toggle("drawing", on);
  control("draw").setAttribute("aria-pressed", on);
  lineFrom = null;
  if (on) tell("Click two places on the model: the cut goes through both.");
}
function clicked(x, y) {
  const hit = pick(x, y);
  if (!canvas.classList.contains("drawing")) return choose(hit ? hit.region || hit.surface : null, hit);
  if (!hit) return tell("That is beside the model: click two places on it.");
  if (!lineFrom) { lineFrom = hit.at; return tell("From " + placeWords(hit.at) + ": now click the other end."); }
  cutAlong(lineFrom, hit.at); drawLine(false); turnToCut(); cutChanged();
}
/** The place under the pointer comes to the middle, and the model turns about it. */
function turnAbout(x, y) {
  const hit = pick(x, y);
  if (!hit) return;
  const moved = hit.at.map((v, k) => v - view.focus[k]), depth = moved[0] * eye.back[0] + moved[1] * eye.back[1] + moved[2] * eye.back[2] * stretch();
  view.zoom = view.fitted / Math.max(distance() - depth, 1e-9);
  Object.assign(view, {focus: hit.at, shift: view.base.map(x => -x)});
  schedule();
}
const fingers = new Map();
let pressed = null;  // where a click began
function place(e) { const box = canvas.getBoundingClientRect(); return [e.clientX - box.left, e.clientY - box.top]; }
function moved(e, before) {
  const dx = e.clientX - before[0], dy = e.clientY - before[1];
  if (pressed && Math.hypot(e.clientX - pressed[0], e.clientY - pressed[1]) > 4) pressed = null;
  const gap = () => { const [p, q] = [...fingers.values()]; return Math.hypot(p[0] - q[0], p[1] - q[1]) || 1; };
  const wide = fingers.size === 2 ? gap() : 0;
  fingers.set(e.pointerId, [e.clientX, e.clientY]);
  if (fingers.size === 2) { pressed = null; shift(dx / 2, dy / 2); zoom(gap() / wide); }
  else if (pressed) return;
  else if (e.altKey) moveCut((Math.abs(dx) > Math.abs(dy) ? dx : -dy) / canvas.clientHeight);
  else if (e.shiftKey || e.buttons > 1) shift(dx, dy);
  else turn(dx * 0.008, dy * 0.008);
}
function setUpPointer() {
  canvas.addEventListener("pointerdown", e => {
    canvas.setPointerCapture(e.pointerId);
    fingers.set(e.pointerId, [e.clientX, e.clientY]);
    pressed = fingers.size === 1 && e.button === 0 ? [e.clientX, e.clientY] : null;
  });
  canvas.addEventListener("pointermove", e => { const before = fingers.get(e.pointerId); if (before) moved(e, before); });
  canvas.addEventListener("pointerup", e => { fingers.delete(e.pointerId); if (pressed) clicked(...place(e)); pressed = null; });
  canvas.addEventListener("pointercancel", e => { fingers.delete(e.pointerId); pressed = null; });
  canvas.addEventListener("dblclick", e => turnAbout(...place(e)));
  canvas.addEventListener("contextmenu", e => e.preventDefault());
  canvas.addEventListener("wheel", e => {
    if (!e.ctrlKey && document.activeElement !== canvas && !document.fullscreenElement) return;  // the page scrolls until the picture is clicked
    e.preventDefault(); zoom(Math.exp(-e.deltaY * 0.001));
  }, {passive: false});
}
function setUpKeys() {
  canvas.addEventListener("keydown", e => {
    const arrow = {ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[e.key], cuts = {c: "corner", x: "x", y: "y", z: "z"};
    if (e.ctrlKey || e.metaKey) return;
    if (arrow && e.shiftKey) shift(-20 * arrow[0], -20 * arrow[1]);
    else if (arrow) turn(0.1 * arrow[0], 0.1 * arrow[1]);
    else if (e.key === "+" || e.key === "=") zoom(1.2);
    else if (e.key === "-") zoom(1 / 1.2);
    else if (e.key === "[" || e.key === "]") moveCut(e.key === "[" ? -0.02 : 0.02);
    else if (cuts[e.key]) cutBy(mode() === cuts[e.key] ? "" : cuts[e.key]);
    else if (e.key === "f") fullScreen();
    else if (e.key === "0") resetView();
    else if (e.key === "Escape") { drawLine(false); choose(null); }
    else return;
    e.preventDefault();
    if (arrow) tell("Turned " + Math.round(view.turn * 180 / Math.PI) % 360 + ", tilted " + Math.round(view.tilt * 180 / Math.PI) + " degrees.");
  });
}
