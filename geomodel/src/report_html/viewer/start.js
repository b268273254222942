// SPDX-License-Identifier: MIT
// From the picture to the model that turns, where the browser can draw it.
function begin() {
  if (!gl) { tell("This browser has no WebGL 2, so the model is a picture here; the sections below show its inside."); return; }
  setUpPaint();
  find(".poster").hidden = true; canvas.hidden = false; find(".bar").hidden = false;
  setUpControls(); fillList(); setUpPointer(); setUpKeys();
  fit(); build(); tell(cutWords());
  new ResizeObserver(() => { fit(); schedule(); }).observe(canvas);
  window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", schedule);
}
begin();
