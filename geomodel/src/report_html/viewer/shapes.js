// SPDX-License-Identifier: MIT
// Triangles and lines of what is shown. They change with what is shown and how it is coloured; not with the camera.
const faces = new Batch(gl && gl.TRIANGLES), sheets = new Batch(gl && gl.TRIANGLES), worst = new Batch(gl && gl.TRIANGLES), wires = new Batch(gl && gl.LINES);
const walls = [new Batch(gl && gl.TRIANGLES), new Batch(gl && gl.TRIANGLES)];
const about = r => ({region: r.id, lift: r.lift || 0, opacity: opacityOf(r.id), glow: state.chosen === r.id});
const isSeenThrough = id => !state.regions.has(id) || opacityOf(id) < 1;

/** The outsides of units: all of their faces where units are apart or seen through, else those that another unit does not hide. */
function buildFaces() {
  const q = quantity(), scale = q && scaleOf(q), loose = apart() > 0;
  faces.begin();
  for (const r of model.regions) {
    if (!state.regions.has(r.id)) continue;
    faces.range(about(r));
    const plain = colourOf.get(r.id), whole = loose || opacityOf(r.id) < 1;
    for (const row of facesOf.get(r.id)) {
      const f = row >> 1, beyond = sides[3 * f + (row & 1 ? 1 : 2)];
      if (!whole && beyond !== 0 && !isSeenThrough(beyond)) continue;
      if (state.surfaces.has(sides[3 * f])) continue;
      const tint = !q ? plain : q.faces ? scale[q.faces[row]] : null;
      for (let i = 0; i < 3; ++i) { const v = corners[3 * f + i]; faces.point(v, tint || scale[q.points[v]], row); }
    }
  }
  faces.end();
}
function buildSheets() {
  sheets.begin();
  for (const s of model.surfaces) {
    if (!state.surfaces.has(s.id)) continue;
    sheets.range({surface: s.id, glow: state.chosen === s.id});
    for (let f = 0; f < sides.length / 3; ++f)
      if (sides[3 * f] === s.id) for (let i = 0; i < 3; ++i) sheets.point(corners[3 * f + i], colourOf.get(s.id), f);
  }
  sheets.end();
}
/** The plane's polygon in each element that it cuts, by unit. */
function buildWall(batch, plane) {
  batch.begin();
  const q = quantity(), scale = q && scaleOf(q), [a, b, c] = plane ? plane.n : [0, 0, 0], hit = new Map();
  const height = v => a * points[3 * v] + b * points[3 * v + 1] + c * points[3 * v + 2] - plane.at;
  for (let t = 0; plane && t < cellRegion.length; ++t) {
    const s = height(cells[4 * t]) > 0;
    if (s === height(cells[4 * t + 1]) > 0 && s === height(cells[4 * t + 2]) > 0 && s === height(cells[4 * t + 3]) > 0) continue;
    if (state.regions.has(cellRegion[t])) hit.has(cellRegion[t]) ? hit.get(cellRegion[t]).push(t) : hit.set(cellRegion[t], [t]);
  }
  for (const r of model.regions) {
    if (!hit.has(r.id)) continue;
    batch.range(about(r));
    for (const t of hit.get(r.id)) addCut(batch, t, height, !q ? colourOf.get(r.id) : q.cells ? scale[q.cells[t]] : null, q, scale);
  }
  batch.end();
}
function addCut(batch, t, height, tint, q, scale) {
  const above = [], below = [];
  for (let i = 0; i < 4; ++i) { const v = cells[4 * t + i]; (height(v) > 0 ? above : below).push(v); }
  const between = (p, r) => {
    const h = height(p), s = h / (h - height(r)), x = [0, 1, 2].map(k => points[3 * p + k] + s * (points[3 * r + k] - points[3 * p + k]));
    const known = q && q.points && q.points[p] !== notKnown && q.points[r] !== notKnown;
    return {x, ink: tint || scale[known ? Math.round(q.points[p] + s * (q.points[r] - q.points[p])) : notKnown]};
  };
  const ring = above.length === 2 ? [[0, 0], [0, 1], [1, 1], [1, 0]].map(([i, j]) => between(above[i], below[j]))
    : above.length === 1 ? below.map(v => between(above[0], v)) : above.map(v => between(v, below[0]));
  for (let i = 2; i < ring.length; ++i) {
    const hide = (i + 1 < ring.length ? 2 : 0) + (i > 2 ? 4 : 0);  // the diagonals of the fan are no edges
    for (const p of [ring[0], ring[i - 1], ring[i]]) batch.add(p.x[0], p.x[1], p.x[2], p.ink, hide, t);
  }
}
function buildLines() {
  wires.begin();
  for (const isWell of [true, false]) {
    wires.range({isWell});
    for (let e = 0; e < edgeCurve.length; ++e)
      if (state.curves.has(edgeCurve[e]) && (curveOf.get(edgeCurve[e]).kind === "well") === isWell) for (let i = 0; i < 2; ++i) wires.point(edges[2 * e + i], colourOf.get(edgeCurve[e]), e);
  }
  wires.end();
  worst.begin(); worst.range({});
  if (state.worst.size) for (const w of model.worst)
    for (const side of [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]]) for (const i of side) worst.add(w.corners[3 * i], w.corners[3 * i + 1], w.corners[3 * i + 2], [220, 0, 120], 0, 0);
  worst.end();
}
function buildWalls() { const cutting = planes(); walls.forEach((wall, i) => buildWall(wall, cutting[i])); schedule(); }
function build() { setLifts(); buildFaces(); buildSheets(); buildLines(); buildWalls(); }
