// SPDX-License-Identifier: MIT
// The camera: perspective, turned about a place of the model, heights stretched.
const canvas = find("canvas.model"), overlay = find("canvas.axes"), stage = find(".stage");
const control = name => find("[name=" + name + "]");
const stretch = () => Number(control("stretch").value), apart = () => Number(control("apart").value);
const timesWords = () => stretch() === 1 ? "true" : stretch() + " times";
const start = {turn: 215 * Math.PI / 180, tilt: 28 * Math.PI / 180, zoom: 1};
const view = Object.assign({focus: [0, 0, 0], shift: [0, 0], base: [0, 0], fitted: 1}, start);  // shifts in halves of the picture
const tall = Math.tan(12.5 * Math.PI / 180);  // of half the angle of view
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const limit = (x, low, high) => Math.max(low, Math.min(high, x));

function axesOf(turn, tilt) {
  const s = Math.sin(turn), c = Math.cos(turn), e = Math.cos(tilt), g = Math.sin(tilt);
  return {back: [s * e, c * e, g], right: [-c, s, 0], up: [-s * g, -c * g, e]};
}
let eye = axesOf(view.turn, view.tilt);

/** How far units are moved up when the model is drawn apart: the lowest stays lowest, the parts of one stay together. */
const unitOf = name => name.lastIndexOf("__") > 0 ? name.slice(0, name.lastIndexOf("__")) : name;
const unitHeights = new Map();
for (const r of model.regions) { const u = unitOf(r.name); unitHeights.set(u, (unitHeights.get(u) || []).concat(r.middle[2])); }
const mean = list => list.reduce((sum, x) => sum + x, 0) / list.length;
const order = [...unitHeights.keys()].sort((a, b) => mean(unitHeights.get(a)) - mean(unitHeights.get(b)));
const liftStep = () => apart() * 0.35 * Math.max(model.size[2], 0.3 * model.size[0] / stretch());
const spread = () => liftStep() * (order.length - 1);
function setLifts() { for (const r of model.regions) r.lift = order.indexOf(unitOf(r.name)) * liftStep() - spread() / 2; }

/** The distance from which the whole box is seen, with room for the numbers at its edges. */
function fit() {
  setLifts();
  const h = [model.size[0] / 2, model.size[1] / 2, (model.size[2] + spread()) / 2 * stretch()];
  const wide = canvas.clientWidth, high = canvas.clientHeight, room = [limit(1 - 90 / wide, 0.6, 1), limit(1 - 60 / high, 0.6, 1)];
  const across = tall * wide / (high || 1);
  function need(turn) {
    const a = axesOf(turn, view.tilt);
    let far = 0;
    for (let k = 0; k < 8; ++k) {
      const p = [k & 1 ? h[0] : -h[0], k & 2 ? h[1] : -h[1], k & 4 ? h[2] : -h[2]];
      far = Math.max(far, dot(p, a.back) + Math.max(Math.abs(dot(p, a.right)) / across / room[0], Math.abs(dot(p, a.up)) / tall / room[1]));
    }
    return far;
  }
  view.base = [0, 0];
  view.fitted = need(view.turn) || 1;
  const seenCorners = Array.from({length: 8}, (_, k) => seen([k & 1 ? h[0] : -h[0], k & 2 ? h[1] : -h[1], (k & 4 ? h[2] : -h[2]) / stretch()], 0, true));
  const ends = [0, 1].map(i => [Math.min(...seenCorners.map(p => p[i])), Math.max(...seenCorners.map(p => p[i]))]);
  view.base = [1 - (ends[0][0] + ends[0][1]) / wide, (ends[1][0] + ends[1][1]) / high - 1];
  view.fitted *= Math.max((ends[0][1] - ends[0][0]) / (wide * room[0]), (ends[1][1] - ends[1][0]) / (high * room[1])) || 1;
}
const shifted = () => [view.base[0] + view.shift[0], view.base[1] + view.shift[1]];
const distance = () => view.fitted / view.zoom;

/** Columns of the matrix from places (from the focus, stretched) to the picture. */
function matrix() {
  eye = axesOf(view.turn, view.tilt);
  const d = distance(), up = stretch(), size = Math.hypot(model.size[0], model.size[1], (model.size[2] + spread()) * up), off = Math.hypot(...view.focus.map((x, k) => k === 2 ? x * up : x));
  const far = d + size + off, near = Math.max(d - size - off, d * 0.01), fy = 1 / tall, fx = fy * canvas.clientHeight / canvas.clientWidth;
  const s = shifted(), a = (far + near) / (far - near), b = -2 * far * near / (far - near), out = [];
  for (let k = 0; k < 3; ++k) {
    const w = -eye.back[k];
    out.push(fx * eye.right[k] + s[0] * w, fy * eye.up[k] + s[1] * w, a * w, w);
  }
  return out.concat([s[0] * d, s[1] * d, a * d + b, d]);
}
/** Pixels from the left and top of the picture. */
function seen(p, lift = 0, fitting = false) {
  if (fitting) eye = axesOf(view.turn, view.tilt);
  const s = shifted(), up = stretch(), f = fitting ? [0, 0, 0] : view.focus, q = [p[0] - f[0], p[1] - f[1], (p[2] + lift - f[2]) * up], w = Math.max((fitting ? view.fitted : distance()) - dot(q, eye.back), 1e-9);
  const high = canvas.clientHeight, wide = canvas.clientWidth;
  return [wide / 2 + (dot(q, eye.right) / w / tall * high + s[0] * wide) / 2, high / 2 - (dot(q, eye.up) / w / tall + s[1]) * high / 2];
}
/** The ray through a pixel: origin and direction in the model's coordinates. */
function rayAt(x, y) {
  const wide = canvas.clientWidth, high = canvas.clientHeight, up = stretch(), d = distance(), s = shifted();
  const r = (2 * x / wide - 1 - s[0]) * tall * wide / high, u = (1 - 2 * y / high - s[1]) * tall;
  const true_ = k => 1 / (k === 2 ? up : 1);
  return {from: [0, 1, 2].map(k => view.focus[k] + d * eye.back[k] * true_(k)), along: [0, 1, 2].map(k => (r * eye.right[k] + u * eye.up[k] - eye.back[k]) * true_(k))};
}
