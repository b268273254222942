// SPDX-License-Identifier: MIT
// The turnable picture of a geomesh report. This script may be used, copied, changed and passed on under the MIT licence; it comes
// without any warranty.
"use strict";
(function () {
  const root = document.getElementById("viewer"), model = JSON.parse(document.getElementById("model").textContent);
  const find = selector => root.querySelector(selector);
  const bytes = text => Uint8Array.from(atob(text), c => c.charCodeAt(0)).buffer;
  const points = new Float32Array(bytes(model.points)), corners = new Uint32Array(bytes(model.corners)), sides = new Int32Array(bytes(model.sides));
  const angles = new Uint8Array(bytes(model.angles)), cells = new Uint32Array(bytes(model.cells)), cellRegion = new Int32Array(bytes(model.cell_regions));
  const cellAngle = new Uint8Array(bytes(model.cell_angles)), edges = new Uint32Array(bytes(model.edges)), edgeCurve = new Int32Array(bytes(model.edge_curves));
  const canvas = find("canvas.model"), overlay = find("canvas.axes"), list = find(".list"), stretch = find("input[name=stretch]"), says = find(".says");
  const cut = {axis: find("select[name=cut]"), at: find("input[name=at]")}, lines = find("input[name=lines]"), colours = find("select[name=colours]");
  const gl = canvas.getContext("webgl2", {antialias: true, preserveDrawingBuffer: true});
  if (!gl) { find(".hint").textContent = "This browser has no WebGL 2: the turnable picture cannot be drawn."; return; }

  // Triangles and lines: a place and a colour for each vertex.
  const shader = (type, text) => {
    const s = gl.createShader(type);
    gl.shaderSource(s, text); gl.compileShader(s);
    if (!gl.getShaderParameter(s, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(s));
    return s;
  };
  const program = gl.createProgram();
  gl.attachShader(program, shader(gl.VERTEX_SHADER, `#version 300 es
    in vec3 at; in vec3 ink; uniform mat4 view; uniform vec3 undo; uniform float nearer; out vec3 tint, place, corner;
    void main() {
      gl_Position = view * vec4(at, 1.0); place = gl_Position.xyz * undo; tint = ink; gl_Position.z -= nearer;
      int k = gl_VertexID % 3; corner = vec3(k == 0, k == 1, k == 2);
    }`));
  gl.attachShader(program, shader(gl.FRAGMENT_SHADER, `#version 300 es
    precision highp float; in vec3 tint, place, corner; out vec4 colour; uniform float lines, shaded;
    void main() {
      vec3 n = normalize(cross(dFdx(place), dFdy(place)));
      vec3 w = fwidth(corner), e = smoothstep(vec3(0.0), 1.2 * w, corner);
      float edge = mix(1.0, min(min(e.x, e.y), e.z), lines);
      colour = vec4(tint * mix(1.0, 0.45 + 0.55 * abs(n.z), shaded) * mix(0.55, 1.0, edge), 1.0);
    }`));
  gl.linkProgram(program);
  gl.useProgram(program);
  gl.enable(gl.DEPTH_TEST);
  const uniform = name => gl.getUniformLocation(program, name);
  class Batch {
    constructor(mode) { this.mode = mode; this.place = gl.createBuffer(); this.ink = gl.createBuffer(); this.begin(); }
    begin() { this.at = []; this.tints = []; }
    add(x, y, z, tint) { this.at.push(x, y, z); this.tints.push(tint[0], tint[1], tint[2]); }
    point(v, tint) { this.add(points[3 * v], points[3 * v + 1], points[3 * v + 2], tint); }
    end() {
      this.count = this.at.length / 3;
      gl.bindBuffer(gl.ARRAY_BUFFER, this.place); gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(this.at), gl.STATIC_DRAW);
      gl.bindBuffer(gl.ARRAY_BUFFER, this.ink); gl.bufferData(gl.ARRAY_BUFFER, new Uint8Array(this.tints), gl.STATIC_DRAW);
      this.begin();
    }
    draw(nearer, lined, shaded) {
      for (const [name, buffer, type, normalised] of [["at", this.place, gl.FLOAT, false], ["ink", this.ink, gl.UNSIGNED_BYTE, true]]) {
        const where = gl.getAttribLocation(program, name);
        gl.bindBuffer(gl.ARRAY_BUFFER, buffer); gl.enableVertexAttribArray(where); gl.vertexAttribPointer(where, 3, type, normalised, 0, 0);
      }
      gl.uniform1f(uniform("nearer"), nearer); gl.uniform1f(uniform("lines"), lined ? 1 : 0); gl.uniform1f(uniform("shaded"), shaded ? 1 : 0);
      gl.drawArrays(this.mode, 0, this.count);
    }
  }
  const faces = new Batch(gl.TRIANGLES), section = new Batch(gl.TRIANGLES), wires = new Batch(gl.LINES), worst = new Batch(gl.TRIANGLES);

  // What is shown, and in which colour.
  const rgb = text => [1, 3, 5].map(i => parseInt(text.slice(i, i + 2), 16));
  const shownRegions = new Set(model.regions.map(r => r.id)), shownSurfaces = new Set();
  const shownCurves = new Set(model.curves.filter(c => c.kind !== "intersection").map(c => c.id)), shownWorst = new Set(model.worst.length ? [0] : []);
  const colourOf = new Map(model.regions.concat(model.surfaces, model.curves).map(x => [x.id, rgb(x.colour)]));
  /** Least dihedral angle in degrees: red below 8, yellow at 25, blue from 50. */
  function angleColour(a) {
    const mix = (p, q, t) => p.map((x, i) => Math.round(x + (q[i] - x) * Math.max(0, Math.min(1, t))));
    return a < 25 ? mix([190, 20, 30], [245, 215, 90], (a - 8) / 17) : mix([245, 215, 90], [40, 95, 170], (a - 25) / 25);
  }
  const byAngle = () => colours.value === "angle";
  const axis = () => ["x", "y", "z"].indexOf(cut.axis.value);
  const plane = () => (Number(cut.at.value) - 0.5) * model.size[axis()];

  /** The part of a polygon that is kept: below the plane. */
  function clipped(polygon, k, at) {
    const kept = [];
    polygon.forEach((p, i) => {
      const q = polygon[(i + 1) % polygon.length], a = p[k] - at, b = q[k] - at;
      if (a <= 0) kept.push(p);
      if ((a < 0 && b > 0) || (a > 0 && b < 0)) kept.push(p.map((x, j) => x + (q[j] - x) * a / (a - b)));
    });
    return kept;
  }
  const place = v => [points[3 * v], points[3 * v + 1], points[3 * v + 2]];
  function fan(batch, polygon, tint) {
    for (let i = 2; i < polygon.length; ++i) for (const p of [polygon[0], polygon[i - 1], polygon[i]]) batch.add(p[0], p[1], p[2], tint);
  }
  function buildFaces() {
    const k = axis(), at = k < 0 ? 0 : plane();
    for (let f = 0; f < corners.length / 3; ++f) {
      const surface = sides[3 * f], minus = sides[3 * f + 1], plus = sides[3 * f + 2], a = shownRegions.has(minus), b = shownRegions.has(plus);
      let tint = null;
      if (shownSurfaces.has(surface)) tint = colourOf.get(surface);
      else if (a !== b) tint = byAngle() ? angleColour(angles[2 * f + (a ? 0 : 1)]) : colourOf.get(a ? minus : plus);
      if (!tint) continue;
      const v = corners.subarray(3 * f, 3 * f + 3);
      if (k < 0 || Math.max(points[3 * v[0] + k], points[3 * v[1] + k], points[3 * v[2] + k]) <= at) for (const p of v) faces.point(p, tint);
      else fan(faces, clipped([...v].map(place), k, at), tint);
    }
    faces.end();
  }
  /** The plane's polygon in each element that it cuts. */
  function buildSection() {
    const k = axis(), at = k < 0 ? 0 : plane();
    for (let c = 0; k >= 0 && c < cellRegion.length; ++c) {
      if (!shownRegions.has(cellRegion[c])) continue;
      const v = cells.subarray(4 * c, 4 * c + 4), above = [], below = [];
      for (const p of v) (points[3 * p + k] > at ? above : below).push(place(p));
      if (!above.length || !below.length) continue;
      const between = (p, q) => p.map((x, j) => x + (q[j] - x) * (at - p[k]) / (q[k] - p[k]));
      const polygon = above.length === 2 ? [[0, 0], [0, 1], [1, 1], [1, 0]].map(([i, j]) => between(above[i], below[j]))
        : above.length === 1 ? below.map(q => between(above[0], q)) : above.map(p => between(p, below[0]));
      fan(section, polygon, byAngle() ? angleColour(cellAngle[c]) : colourOf.get(cellRegion[c]));
    }
    section.end();
  }
  function buildLines() {
    const k = axis(), at = k < 0 ? Infinity : plane();
    for (let e = 0; e < edgeCurve.length; ++e) {
      if (!shownCurves.has(edgeCurve[e])) continue;
      if (k >= 0 && points[3 * edges[2 * e] + k] > at && points[3 * edges[2 * e + 1] + k] > at) continue;
      wires.point(edges[2 * e], colourOf.get(edgeCurve[e])); wires.point(edges[2 * e + 1], colourOf.get(edgeCurve[e]));
    }
    wires.end();
    if (shownWorst.size) for (const w of model.worst) {
      const p = [0, 1, 2, 3].map(i => w.corners.slice(3 * i, 3 * i + 3));
      for (const [a, b, c] of [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]]) fan(worst, [p[a], p[b], p[c]], [220, 0, 120]);
    }
    worst.end();
  }
  function build() { buildFaces(); buildSection(); buildLines(); draw(); }

  // The view: turn about the vertical, tilt, zoom, and a shift in units of half the picture's height.
  const start = {turn: -0.6, tilt: 0.45, zoom: 1, right: 0, up: 0}, view = Object.assign({}, start);
  const limit = (x, low, high) => Math.max(low, Math.min(high, x));
  let matrix = null;
  function project() {
    const up = Number(stretch.value), s = model.size, across = canvas.clientHeight / canvas.clientWidth;
    const f = view.zoom / (0.5 * Math.hypot(s[0], s[1], s[2] * up) || 1);
    const c = Math.cos(view.turn), d = Math.sin(view.turn), e = Math.cos(view.tilt), g = Math.sin(view.tilt);
    matrix = {f, across, rows: [[f * across * c, -f * across * d, 0], [f * d * g, f * c * g, f * e * up], [f * 0.2 * d * e, f * 0.2 * c * e, -f * 0.2 * g * up]]};
    return [0, 1, 2].flatMap(col => [...matrix.rows.map(row => row[col]), 0]).concat([view.right * across, view.up, 0, 1]);
  }
  function draw() {
    const dense = window.devicePixelRatio || 1;
    canvas.width = canvas.clientWidth * dense; canvas.height = canvas.clientHeight * dense;
    gl.viewport(0, 0, canvas.width, canvas.height);
    const back = rgbOf(getComputedStyle(canvas).backgroundColor);
    gl.clearColor(back[0] / 255, back[1] / 255, back[2] / 255, 1); gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.uniformMatrix4fv(uniform("view"), false, project());
    gl.uniform3f(uniform("undo"), 1 / matrix.across, 1, 5);
    faces.draw(0, lines.checked, true); section.draw(0.0005, lines.checked, false); worst.draw(0.5, false, false); wires.draw(0.001, false, false);
    drawAxes(dense);
  }
  const rgbOf = text => (text.match(/[\d.]+/g) || [255, 255, 255]).slice(0, 3).map(Number);
  /** East, north and up as arrows; a bar of a round length. */
  function drawAxes(dense) {
    const pen = overlay.getContext("2d"), w = canvas.clientWidth, h = canvas.clientHeight;
    overlay.width = w * dense; overlay.height = h * dense; pen.scale(dense, dense);
    pen.strokeStyle = pen.fillStyle = getComputedStyle(canvas).color; pen.lineWidth = 1.5; pen.font = "12px system-ui, sans-serif";
    const c = Math.cos(view.turn), d = Math.sin(view.turn), e = Math.cos(view.tilt), g = Math.sin(view.tilt), x0 = 48, y0 = h - 44;
    for (const [name, x, y] of [["E", c, d * g], ["N", -d, c * g], ["up", 0, e]]) {
      pen.beginPath(); pen.moveTo(x0, y0); pen.lineTo(x0 + 30 * x, y0 - 30 * y); pen.stroke();
      pen.fillText(name, x0 + 38 * x - 4, y0 - 38 * y + 4);
    }
    const perUnit = matrix.f * h / 2, raw = 0.25 * w / perUnit, ten = Math.pow(10, Math.floor(Math.log10(raw)));
    const length = ten * (raw / ten >= 5 ? 5 : raw / ten >= 2 ? 2 : 1), px = length * perUnit;
    pen.fillRect(w - 16 - px, h - 20, px, 3); pen.fillText(length + " " + model.unit, w - 16 - px, h - 26);
  }
  const tell = text => { says.textContent = text; };
  function tellView() { tell("Turned " + Math.round(view.turn * 180 / Math.PI) + ", tilted " + Math.round(view.tilt * 180 / Math.PI) + " degrees, zoom " + view.zoom.toFixed(2) + "."); }
  function tellCut() {
    const k = axis();
    cut.at.disabled = k < 0;
    tell(k < 0 ? "Nothing is cut away." : "Cut at " + cut.axis.value + " = " + (plane() + model.middle[k]).toPrecision(6) + " " + model.unit + ".");
  }
  function turn(dx, dy) { view.turn -= dx; view.tilt = limit(view.tilt + dy, -1.57, 1.57); draw(); }
  function shift(dx, dy) { view.right += 2 * dx / canvas.clientHeight; view.up -= 2 * dy / canvas.clientHeight; draw(); }
  function zoom(by) { view.zoom = limit(view.zoom * by, 0.05, 500); draw(); }
  function moveCut(by) { if (axis() >= 0) { cut.at.value = limit(Number(cut.at.value) + by, 0, 1); tellCut(); build(); } }

  // Mouse and fingers: one turns, two move and zoom; with shift or another button the mouse moves, with alt it drags the cut.
  const fingers = new Map();
  canvas.addEventListener("pointerdown", e => { canvas.setPointerCapture(e.pointerId); fingers.set(e.pointerId, [e.clientX, e.clientY]); });
  for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, e => fingers.delete(e.pointerId));
  canvas.addEventListener("pointermove", e => {
    const before = fingers.get(e.pointerId);
    if (!before) return;
    const all = [...fingers.values()], dx = e.clientX - before[0], dy = e.clientY - before[1];
    const spread = () => { const [p, q] = [...fingers.values()]; return Math.hypot(p[0] - q[0], p[1] - q[1]) || 1; };
    const wide = all.length === 2 ? spread() : 0;
    fingers.set(e.pointerId, [e.clientX, e.clientY]);
    if (all.length === 2) { shift(dx / 2, dy / 2); zoom(spread() / wide); }
    else if (e.altKey) moveCut((Math.abs(dx) > Math.abs(dy) ? dx : -dy) / canvas.clientHeight);
    else if (e.shiftKey || e.buttons > 1) shift(dx, dy);
    else turn(dx * 0.01, dy * 0.01);
  });
  canvas.addEventListener("contextmenu", e => e.preventDefault());
  canvas.addEventListener("wheel", e => { e.preventDefault(); zoom(Math.exp(-e.deltaY * 0.001)); }, {passive: false});
  canvas.addEventListener("keydown", e => {
    const arrow = {ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[e.key];
    if (arrow && e.shiftKey) shift(-20 * arrow[0], -20 * arrow[1]);
    else if (arrow) turn(0.1 * arrow[0], 0.1 * arrow[1]);
    else if (e.key === "+" || e.key === "=") zoom(1.2);
    else if (e.key === "-") zoom(1 / 1.2);
    else if (e.key === "[" || e.key === "]") return moveCut(e.key === "[" ? -0.02 : 0.02);
    else if ("xyz".includes(e.key)) { cut.axis.value = cut.axis.value === e.key ? "" : e.key; tellCut(); build(); return; }
    else if (e.key === "0") { Object.assign(view, start); draw(); }
    else return;
    e.preventDefault(); tellView();
  });

  // The list of what can be shown.
  function group(text, items, shown) {
    if (!items.length) return;
    const box = document.createElement("fieldset"), legend = document.createElement("legend");
    legend.textContent = text; box.append(legend);
    for (const item of items) {
      const label = document.createElement("label"), check = document.createElement("input"), swatch = document.createElement("i");
      check.type = "checkbox"; check.checked = shown.has(item.id); swatch.style.background = item.colour;
      check.onchange = () => { if (check.checked) shown.add(item.id); else shown.delete(item.id); build(); };
      label.append(check, swatch, item.name); box.append(label);
    }
    list.append(box);
  }
  group("Units", model.regions, shownRegions);
  group("Surfaces", model.surfaces, shownSurfaces);
  group("Wells and curves", model.curves, shownCurves);
  group("Elements", model.worst.length ? [{id: 0, name: model.worst.length + " worst elements", colour: "#dc0078"}] : [], shownWorst);
  stretch.value = model.stretch; stretch.max = Math.max(10, 2 * model.stretch);
  stretch.oninput = draw; lines.onchange = draw; colours.onchange = build;
  cut.axis.onchange = () => { tellCut(); build(); };
  cut.at.oninput = () => { tellCut(); build(); };
  window.addEventListener("resize", draw);
  if (window.matchMedia) window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw);
  tellCut(); build();
})();
