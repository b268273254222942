// SPDX-License-Identifier: MIT
// What is written over the picture: coordinates along the box, the directions, names of wells and places, the scale of colours.
function roundStep(range, most) {
  const rough = range / most, ten = Math.pow(10, Math.floor(Math.log10(rough)));
  return ten * (rough / ten <= 1 ? 1 : rough / ten <= 2 ? 2 : rough / ten <= 5 ? 5 : 10);
}
function write(pen, text, x, y, align = "center") {
  pen.textAlign = align; pen.textBaseline = "middle"; pen.lineJoin = "round"; pen.lineWidth = 3;
  pen.strokeStyle = getComputedStyle(stage).backgroundColor; pen.strokeText(text, x, y);
  pen.fillText(text, x, y);
}
/** The edges of the box that carry numbers: two below in front, and the one farthest to the left. */
function numberedEdges() {
  const h = model.size.map(x => x / 2), front = [0, 1, 2].map(k => (eye.back[k] > 0 ? 1 : -1) * h[k]), low = eye.back[2] < 0 ? h[2] : -h[2];
  const upright = [[1, 1], [1, -1], [-1, 1], [-1, -1]].map(([i, j]) => [i * h[0], j * h[1]]).sort((a, b) => seen([...a, low])[0] - seen([...b, low])[0])[0];
  return [{k: 0, at: x => [x, front[1], low]}, {k: 1, at: y => [front[0], y, low]}, {k: 2, at: z => [upright[0], upright[1], z]}];
}
function drawNumbers(pen) {
  if (apart() > 0) return;
  const middle = seen([0, 0, 0]), most = canvas.clientWidth < 520 ? 2 : 4;
  for (const {k, at} of numberedEdges()) {
    const h = model.size[k] / 2, a = seen(at(-h)), b = seen(at(h)), long = Math.hypot(b[0] - a[0], b[1] - a[1]);
    if (long < 30) continue;
    pen.globalAlpha = 0.5; pen.lineWidth = 1; pen.strokeStyle = pen.fillStyle; pen.beginPath(); pen.moveTo(...a); pen.lineTo(...b); pen.stroke(); pen.globalAlpha = 1;
    let out = [(b[1] - a[1]) / long, (a[0] - b[0]) / long];
    if (out[0] * ((a[0] + b[0]) / 2 - middle[0]) + out[1] * ((a[1] + b[1]) / 2 - middle[1]) < 0) out = out.map(x => -x);
    const align = out[0] < -0.3 ? "right" : out[0] > 0.3 ? "left" : "center", step = roundStep(model.size[k], Math.max(1, Math.min(most, long / 55)));
    const label = (p, text, far) => write(pen, text, p[0] + far * out[0], p[1] + far * out[1], align);
    let widest = 0;
    for (let n = Math.ceil((model.middle[k] - h) / step - 1e-6); n * step <= model.middle[k] + h * (1 + 1e-6); ++n) {
      const p = seen(at(n * step - model.middle[k]));
      pen.beginPath(); pen.lineWidth = 1; pen.strokeStyle = pen.fillStyle; pen.moveTo(...p); pen.lineTo(p[0] + 4 * out[0], p[1] + 4 * out[1]); pen.stroke();
      widest = Math.max(widest, pen.measureText(plainly(n * step, step * 1000)).width);
      label(p, plainly(n * step, step * 1000), 9);
    }
    label([(a[0] + b[0]) / 2, (a[1] + b[1]) / 2], "xyz"[k] + ", " + model.unit, align === "center" ? 30 : widest + 16);
  }
}
/** East, north and up as arrows. */
function drawDirections(pen) {
  const isNarrow = canvas.clientWidth < 520, x0 = 34, y0 = isNarrow ? 44 : canvas.clientHeight - 34;
  if (isNarrow && quantity()) return;
  pen.lineWidth = 1.5;
  for (const [name, k] of [["E", 0], ["N", 1], ["up", 2]]) {
    const x = eye.right[k], y = eye.up[k];
    pen.strokeStyle = pen.fillStyle; pen.lineWidth = 1.5; pen.beginPath(); pen.moveTo(x0, y0); pen.lineTo(x0 + 18 * x, y0 - 18 * y); pen.stroke();
    if (Math.hypot(x, y) > 0.25) write(pen, name, x0 + 26 * x, y0 - 26 * y);
  }
}
function drawNames(pen) {
  const tops = new Map();
  for (let e = 0; e < edges.length; ++e) {
    const c = curveOf.get(edgeCurve[e >> 1]);
    if (!c || c.kind !== "well" || !state.curves.has(c.id)) continue;
    if (!tops.has(c.name) || points[3 * edges[e] + 2] > tops.get(c.name)[2]) tops.set(c.name, [0, 1, 2].map(k => points[3 * edges[e] + k]));
  }
  const cutting = facingPlanes().map(c => Object.assign({}, c, {at: c.at + lineSlack()})), shown = p => !isCutAway(p, cutting);
  for (const [name, p] of tops) if (shown(p)) { const s = seen(p); pen.beginPath(); pen.arc(s[0], s[1], 3, 0, 7); pen.fill(); write(pen, name, s[0], s[1] - 11); }
  for (const place of model.places) if (shown(place.at)) { const s = seen(place.at); pen.beginPath(); pen.arc(s[0], s[1], 3, 0, 7); pen.fill(); write(pen, place.name, s[0] + 7, s[1], "left"); }
}
function drawScale(pen) {
  const q = quantity(), left = 14, high = 12, wide = Math.min(220, canvas.clientWidth - 60);
  if (!q) return;
  write(pen, q.name + (q.unit ? ", " + q.unit : ""), left, 16, "left");
  const scale = scaleOf(q);
  for (let x = 0; x < wide; ++x) { pen.save(); pen.fillStyle = "rgb(" + scale[Math.floor(254 * x / wide)] + ")"; pen.fillRect(left + x, 26, 1.5, high); pen.restore(); }
  [0, 0.5, 1].forEach((s, i) => write(pen, measure(q.low + s * (q.high - q.low)), left + s * wide, 48, ["left", "center", "right"][i]));
}
function drawOverlay(dense) {
  const pen = overlay.getContext("2d");
  overlay.width = canvas.width; overlay.height = canvas.height;
  pen.scale(dense, dense);
  pen.fillStyle = getComputedStyle(stage).color; pen.font = "12px system-ui, sans-serif";
  drawNumbers(pen); drawDirections(pen); drawNames(pen); drawScale(pen);
  if (stretch() !== 1) write(pen, "heights " + timesWords(), canvas.clientWidth - 12, 16, "right");
}
/** The picture as it is, with the names of units, as a file. */
function savePicture() {
  draw();
  const out = document.createElement("canvas"), pen = out.getContext("2d"), dense = window.devicePixelRatio || 1;
  out.width = canvas.width; out.height = canvas.height;
  pen.drawImage(canvas, 0, 0); pen.drawImage(overlay, 0, 0); pen.scale(dense, dense);
  pen.font = "12px system-ui, sans-serif";
  const shown = model.regions.filter(r => state.regions.has(r.id)), most = Math.floor((canvas.clientHeight - 90) / 18);
  if (!quantity()) shown.slice(0, most).forEach((r, i) => {
    pen.fillStyle = r.colour; pen.fillRect(14, 14 + 18 * i, 12, 12);
    pen.fillStyle = getComputedStyle(stage).color; write(pen, r.name, 32, 20 + 18 * i, "left");
  });
  out.toBlob(blob => {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(blob); link.download = (model.name || "model") + ".png"; link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
    tell("Saved as " + link.download + ".");
  });
}
