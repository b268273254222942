// SPDX-License-Identifier: MIT
// One picture: what is opaque, then what is seen through, the farthest first.
let isScheduled = false;
function schedule() {
  if (isScheduled) return;
  isScheduled = true;
  requestAnimationFrame(() => { isScheduled = false; draw(); });
}
function draw() {
  const dense = window.devicePixelRatio || 1, wide = Math.round(canvas.clientWidth * dense), high = Math.round(canvas.clientHeight * dense);
  if (!wide || !high) return;
  if (canvas.width !== wide || canvas.height !== high) { canvas.width = wide; canvas.height = high; }
  gl.viewport(0, 0, wide, high);
  const back = rgbOf(getComputedStyle(stage).backgroundColor);
  gl.clearColor(back[0] / 255, back[1] / 255, back[2] / 255, 1); gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  gl.uniformMatrix4fv(uniform("view"), false, matrix());
  gl.uniform3fv(uniform("focus"), view.focus); gl.uniform3fv(uniform("right"), eye.right); gl.uniform3fv(uniform("back"), eye.back);
  gl.uniform1f(uniform("up"), stretch()); gl.uniform1f(uniform("dense"), dense);
  const cutting = facingPlanes();
  gl.uniform1i(uniform("planes"), cutting.length);
  if (cutting.length) gl.uniform4fv(uniform("plane"), [0, 1].flatMap(i => cutting[i] ? [...cutting[i].n, cutting[i].at] : [0, 0, 0, 0]));
  paint();
  drawOverlay(dense);
}
function paint() {
  const shaded = quantity() ? 0.45 : 1, lines = control("lines").checked ? 1 : 0, opaque = r => r.opacity === undefined || r.opacity === 1, through = r => !opaque(r) && r.opacity > 0;
  gl.disable(gl.BLEND); gl.depthMask(true);
  faces.draw(faces.ranges.filter(opaque), {lines, shaded});
  walls.forEach((w, wall) => w.draw(w.ranges.filter(opaque), {lines, shaded, wall, nearer: 1e-6}));
  sheets.draw(sheets.ranges, {lines, shaded: 1, nearer: 2e-6});
  wires.draw(wires.ranges, {nearer: 2e-4, slack: lineSlack()});
  worst.draw(worst.ranges, {nearer: 0.2});
  gl.enable(gl.BLEND); gl.depthMask(false);
  const depth = r => dot(regionOf.get(r.region).middle, eye.back);
  for (const r of faces.ranges.filter(through).sort((a, b) => depth(a) - depth(b))) faces.draw([r], {lines: 0.5 * lines, shaded: 1});
  walls.forEach((w, wall) => w.draw(w.ranges.filter(through), {lines, shaded: 1, wall}));
  gl.disable(gl.DEPTH_TEST);  // wells shine through
  wires.draw(wires.ranges.filter(r => r.isWell).map(r => Object.assign({}, r, {opacity: 0.35})), {slack: lineSlack()});
  gl.enable(gl.DEPTH_TEST);
  gl.disable(gl.BLEND); gl.depthMask(true);
}
