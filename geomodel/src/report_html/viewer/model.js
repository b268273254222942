// SPDX-License-Identifier: MIT
// The model as the page brings it, and what of it is shown.
const root = document.getElementById("viewer"), model = JSON.parse(document.getElementById("model").textContent);
const find = selector => root.querySelector(selector);
function bytes(text) {
  const plain = atob(text), out = new Uint8Array(plain.length);
  for (let i = 0; i < out.length; ++i) out[i] = plain.charCodeAt(i);
  return out.buffer;
}
const points = new Float32Array(bytes(model.points)), corners = new Uint32Array(bytes(model.corners)), sides = new Int32Array(bytes(model.sides));
const cells = new Uint32Array(bytes(model.cells)), cellRegion = new Int32Array(bytes(model.cell_regions));
const edges = new Uint32Array(bytes(model.edges)), edgeCurve = new Int32Array(bytes(model.edge_curves));
for (const q of model.quantities) for (const part of ["faces", "cells", "points"]) if (q[part]) q[part] = new Uint8Array(bytes(q[part]));
const regionOf = new Map(model.regions.map(r => [r.id, r])), surfaceOf = new Map(model.surfaces.map(s => [s.id, s])), curveOf = new Map(model.curves.map(c => [c.id, c]));

const state = {
  regions: new Set(regionOf.keys()), surfaces: new Set(), worst: new Set(),
  curves: new Set(model.curves.filter(c => c.kind === "well").map(c => c.id)),
  opacity: new Map(),  // of regions that are not opaque
  chosen: null,        // a region or surface
};
const opacityOf = region => state.opacity.has(region) ? state.opacity.get(region) : 1;

/** Rows of faces by region: each face at both of its sides, as 2 * row + (0 on the minus side, 1 on the plus side). */
const facesOf = new Map(model.regions.map(r => [r.id, []]));
for (let f = 0; f < sides.length / 3; ++f) {
  const minus = sides[3 * f + 1], plus = sides[3 * f + 2];
  if (minus === plus) continue;  // a surface that ends inside the unit
  if (facesOf.has(minus)) facesOf.get(minus).push(2 * f);
  if (facesOf.has(plus)) facesOf.get(plus).push(2 * f + 1);
}
/** The middle of each region's faces: what is drawn behind, and what is moved up first. */
for (const r of model.regions) {
  const sum = [0, 0, 0], rows = facesOf.get(r.id);
  for (const row of rows) for (let i = 0; i < 3; ++i) for (let k = 0; k < 3; ++k) sum[k] += points[3 * corners[3 * (row >> 1) + i] + k];
  r.middle = sum.map(x => x / (3 * rows.length || 1));
}
/** A coordinate with the digits that its range needs, never an exponent. */
function plainly(value, range) {
  const digits = Math.max(0, Math.min(12, Math.ceil(-Math.log10((range || 1) / 2000))));
  const text = value.toFixed(digits);
  return Number(text) === 0 ? (0).toFixed(digits) : text;
}
/** Four significant digits, thousands parted. */
function measure(value) {
  if (!Number.isFinite(value)) return "unknown";
  const rounded = Number(value.toPrecision(4));
  return Math.abs(rounded) >= 1e-4 || rounded === 0 ? rounded.toLocaleString("en", {maximumFractionDigits: 8}) : value.toPrecision(3);
}
function volumeWords(volume) {
  return model.unit === "m" && volume >= 1e8 ? measure(volume / 1e9) + " km3" : measure(volume) + " " + model.unit + "3";
}
