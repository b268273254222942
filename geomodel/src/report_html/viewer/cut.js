// SPDX-License-Identifier: MIT
// What is cut away: the part beyond one plane, or beyond two, always on the camera's side.
const mode = () => control("cut").value;
const positions = {x: "at1", y: "at2", z: "at3"};
const strike = () => Number(control("strike").value) * Math.PI / 180;
const side = {x: -1, y: -1, z: 1, line: -1};
let flipped = false;

/** The normal of the plane along a line, and how far planes of that normal go. */
const lineNormal = () => [Math.cos(strike()), -Math.sin(strike()), 0];
const lineReach = n => Math.abs(n[0]) * model.size[0] + Math.abs(n[1]) * model.size[1];
function planeOf(name) {
  if (name === "line") {
    const n = lineNormal();
    return {name, n, at: (Number(control("at1").value) - 0.5) * lineReach(n)};
  }
  const k = "xyz".indexOf(name), n = [0, 0, 0];
  n[k] = 1;
  return {name, n, at: (Number(control(positions[name]).value) - 0.5) * model.size[k]};
}
const planes = () => (mode() === "corner" ? ["x", "y"] : mode() ? [mode()] : []).map(planeOf);

/** The planes with normals into what is cut away: towards the camera, and there until the camera is well beyond. */
function facingPlanes() {
  return planes().map(p => {
    const towards = dot(p.n, eye.back);
    if (Math.abs(towards) > 0.08) side[p.name] = Math.sign(towards);
    const s = side[p.name] * (flipped ? -1 : 1);
    return {name: p.name, n: p.n.map(x => s * x), at: s * p.at};
  });
}
/** Whether a place is cut away; of the walls of a corner, each has the other's side alone. */
function isCutAway(p, cutting, wall = -1) {
  if (!cutting.length) return false;
  if (wall >= 0) return !cutting.every((c, i) => i === wall || dot(c.n, p) > c.at);
  return cutting.every(c => dot(c.n, p) > c.at);
}
/** Lines in the plane itself are not cut away. */
const lineSlack = () => 2e-3 * Math.hypot(...model.size);
/** A plane along the line through two places, in the map. */
function cutAlong(a, b) {
  control("cut").value = "line";
  const degrees = Math.atan2(b[0] - a[0], b[1] - a[1]) * 180 / Math.PI;
  control("strike").value = (degrees + 360) % 180;
  const n = lineNormal();
  control("at1").value = 0.5 + dot(n, [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, 0]) / lineReach(n);
}
/** Along a well: in the direction in which it deviates, or along the strike where it is upright. */
function cutThroughWell(id) {
  let top = null, end = null;
  for (let e = 0; e < edges.length; ++e) {
    if (edgeCurve[e >> 1] !== id) continue;
    const p = [0, 1, 2].map(k => points[3 * edges[e] + k]);
    if (!top || p[2] > top[2]) top = p;
    if (!end || p[2] < end[2]) end = p;
  }
  if (!top) return;
  const away = Math.hypot(end[0] - top[0], end[1] - top[1]), deviates = away > 0.02 * (top[2] - end[2]);
  const ahead = [Math.sin(strike()), Math.cos(strike())];
  cutAlong(top, deviates ? end : [top[0] + ahead[0], top[1] + ahead[1]]);
}
/** Turns the camera where it would see an upright cut from the side alone. */
function turnToCut() {
  const cutting = planes(), n = cutting.length === 1 && cutting[0].n;
  if (!n || n[2] !== 0) return;
  const towards = Math.sign(dot(n, eye.back)) || 1, slanted = 0.5;  // radians off the straight view
  if (Math.abs(dot(n, eye.back)) >= 0.45) return;
  view.turn = Math.atan2(towards * n[0], towards * n[1]) + slanted;
  fit();
}
function cutWords() {
  const words = planes().map(p => p.name === "line" ? "along a line striking " + Math.round(control("strike").value) + " degrees"
    : "at " + p.name + " = " + plainly(p.at + model.middle["xyz".indexOf(p.name)], model.size["xyz".indexOf(p.name)]) + " " + model.unit);
  return words.length ? "Cut " + words.join(" and ") + "." : "Nothing is cut away.";
}
